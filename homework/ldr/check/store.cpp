#include "homework/ldr/check/store.h"

#include "framework/base/error.h"
#include "framework/image/planes.h"

#include <bit>

namespace luch::homework::ldr {
namespace {

const std::size_t pixels = sample_size.area();

/// Planes of a picture's size, one below the other.
template <class T>
Image<T> stacked(const std::vector<T>& values) {
    Image<T> image({sample_size.width, static_cast<int>(values.size()) / sample_size.width});
    image.pixels() = values;
    return image;
}

/// The words of a sample in the order of their planes.
template <class SampleType>
auto word_planes(SampleType& sample) {
    return std::array{&sample.a,         &sample.b,     &sample.encoded, &sample.added,
                      &sample.modulated, &sample.mixed, &sample.lerped,  &sample.resolved};
}

std::vector<float> floats_of(const Sample& sample) {
    std::vector<float> values;
    for (const Rgb& light : sample.light) values.insert(values.end(), {light.r, light.g, light.b});
    // A last row of single numbers.
    std::vector<float> row(static_cast<std::size_t>(sample_size.width), 0);
    row[0] = sample.exposure;
    row[1] = static_cast<float>(sample.n);
    row[2] = static_cast<float>(sample.misfits.not_a_number);
    row[3] = static_cast<float>(sample.misfits.too_bright);
    values.insert(values.end(), row.begin(), row.end());
    return values;
}

std::vector<std::uint32_t> bits_of(const Sample& sample) {
    std::vector<std::uint32_t> bits;
    for (const auto* plane : word_planes(sample)) {
        for (const Word& word : *plane) bits.push_back(word.bits);
    }
    for (std::size_t i = 0; i < pixels; ++i) {
        bits.push_back(Word(0, sample.alpha[i], sample.up[i], sample.dither[i]).bits);
    }
    return bits;
}

std::vector<std::uint32_t> sums_of(const Sample& sample) {
    std::vector<std::uint32_t> values;
    for (const auto* sums : {&sample.sums, &sample.accumulated}) {
        for (const Wide& sum : *sums) values.insert(values.end(), sum.channel, sum.channel + 4);
    }
    return values;
}

template <class T>
const std::vector<T>& checked(const Image<T>& image, std::size_t count,
                              const std::filesystem::path& file) {
    if (image.pixels().size() == count) return image.pixels();
    throw Error({file.string()},
                "is not of a sample's size; luch check ldr --regenerate makes it again");
}

}  // namespace

std::vector<grading::StoredPlane> planes_of(const Sample& sample) {
    return {{"light.exr", stacked(floats_of(sample))},
            {"words.exr", stacked(bits_of(sample))},
            {"sums.exr", stacked(sums_of(sample))}};
}

Sample read_sample(const std::filesystem::path& folder, const std::string& name) {
    const std::size_t width = static_cast<std::size_t>(sample_size.width);
    const Image<float> light = read_float_plane(folder / "light.exr");
    const Image<std::uint32_t> words = read_id_plane(folder / "words.exr");
    const Image<std::uint32_t> sums = read_id_plane(folder / "sums.exr");
    const auto& floats = checked(light, 3 * pixels + width, folder / "light.exr");
    const auto& bits = checked(words, 9 * pixels, folder / "words.exr");
    const auto& wides = checked(sums, 8 * pixels, folder / "sums.exr");
    Sample sample;
    sample.name = name;
    for (std::size_t i = 0; i < pixels; ++i) {
        sample.light.emplace_back(floats[3 * i], floats[3 * i + 1], floats[3 * i + 2]);
        const Word bytes(bits[8 * pixels + i]);
        sample.alpha.push_back(static_cast<std::uint8_t>(bytes.channel(2)));
        sample.up.push_back(static_cast<std::uint8_t>(bytes.channel(1)));
        sample.dither.push_back(static_cast<std::uint8_t>(bytes.channel(0)));
    }
    const float* single = floats.data() + 3 * pixels;
    sample.exposure = single[0];
    sample.n = static_cast<int>(single[1]);
    sample.misfits = {static_cast<std::uint64_t>(single[2]), static_cast<std::uint64_t>(single[3])};
    std::size_t at = 0;
    for (auto* plane : word_planes(sample)) {
        for (std::size_t i = 0; i < pixels; ++i) plane->push_back(Word(bits[at++]));
    }
    at = 0;
    for (auto* plane : {&sample.sums, &sample.accumulated}) {
        for (std::size_t i = 0; i < pixels; ++i, at += 4) {
            plane->push_back(Wide{{wides[at], wides[at + 1], wides[at + 2], wides[at + 3]}});
        }
    }
    return sample;
}

}  // namespace luch::homework::ldr
