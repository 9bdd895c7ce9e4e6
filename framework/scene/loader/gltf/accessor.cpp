#include "framework/scene/loader/gltf/accessor.h"

#include "framework/scene/loader/diagnostics.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace luch::loader::gltf {
namespace {

/// Numbers of a glTF component type, in bytes of any alignment (the format's byte order is ours).
struct Component {
    int size = 0;
    double (*value)(const char* bytes, bool normalized) = nullptr;
    bool is_index = false;
};

/// Normalised integers as the specification's section 3.11 has it.
template <class T>
double value_of(const char* bytes, bool normalized) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    if constexpr (std::is_floating_point_v<T>) return value;
    const auto number = static_cast<double>(value);
    return normalized ? std::max(number / static_cast<double>(std::numeric_limits<T>::max()), -1.0)
                      : number;
}

Component component_of(const Part& part) {
    switch (const auto type = part.required_whole("componentType")) {
        case 5120:
            return {1, value_of<std::int8_t>};
        case 5121:
            return {1, value_of<std::uint8_t>, true};
        case 5122:
            return {2, value_of<std::int16_t>};
        case 5123:
            return {2, value_of<std::uint16_t>, true};
        case 5125:
            return {4, value_of<std::uint32_t>, true};
        case 5126:
            return {4, value_of<float>};
        default:
            part.fail(
                fmt::format("has the component type {}, which glTF does not know; export the "
                            "model again",
                            type));
    }
}

/// Where the elements of an accessor, or of its sparse part, lie.
struct Stretch {
    const char* first = nullptr;
    std::size_t stride = 0;
};

/// Checked: all `count` ≥ 1 elements of `size` bytes lie in the bufferView.
Stretch stretch_of(Document& document, const Part& part, std::uint64_t count, std::size_t size) {
    const std::uint64_t number = part.required_whole("bufferView");
    const std::string_view bytes = document.view(number, part);
    const std::uint64_t offset = part.whole("byteOffset").value_or(0);
    const std::uint64_t stride =
        document.element("bufferViews", number, part).whole("byteStride").value_or(size);
    if (stride < size || stride > 252) {
        part.fail(fmt::format("bufferViews[{}] has a byteStride of {}; choose one from {} to 252",
                              number, stride, size));
    }
    // The offset is at most 2^53, the count 2^31, the stride 252: no overflow.
    const std::uint64_t needed = offset + (count - 1) * stride + size;
    if (needed > bytes.size()) {
        part.fail(fmt::format("reaches to byte {} of the {} in bufferViews[{}]; correct the file",
                              needed, bytes.size(), number));
    }
    return {bytes.data() + offset, stride};
}

std::uint64_t count_of(const Part& part, std::uint64_t most) {
    const std::uint64_t count = part.required_whole("count");
    if (count < 1 || count > most) {
        part.fail(fmt::format("has {} elements; choose 1 to {}", count, most));
    }
    return count;
}

/// The accessor's elements, `components` numbers each.
class Reader {
 public:
    Reader(Document& document, const Part& part, int components)
        : document_(document),
          part_(part),
          components_(components),
          component_(component_of(part)),
          normalized_(part.flag("normalized")) {}

    std::vector<double> read() {
        constexpr std::uint64_t most = (std::uint64_t{1} << 31) - 1, most_zeros = 1 << 20;
        const bool has_view = part_.has("bufferView");
        const std::uint64_t count = count_of(part_, has_view ? most : most_zeros);
        std::vector<double> values;
        if (has_view) {
            take(stretch_of(document_, part_, count, element_size()), count, values);
        } else {
            values.resize(count * components_, 0);
        }
        if (const auto sparse = part_.part("sparse")) replace(*sparse, count, values);
        return values;
    }

 private:
    [[nodiscard]] std::size_t element_size() const {
        return static_cast<std::size_t>(component_.size) * components_;
    }

    void take(Stretch stretch, std::uint64_t count, std::vector<double>& values) const {
        constexpr double most = 1e30;
        values.reserve(values.size() + count * components_);
        for (std::uint64_t i = 0; i < count; ++i) {
            for (std::size_t k = 0; k < components_; ++k) {
                const char* at = stretch.first + i * stretch.stride + k * component_.size;
                const double value = component_.value(at, normalized_);
                if (!(std::abs(value) <= most)) {
                    part_.fail(
                        fmt::format("its element {} is not a number from -1e30 to 1e30; "
                                    "correct the mesh",
                                    i));
                }
                values.push_back(value);
            }
        }
    }

    void replace(const Part& sparse, std::uint64_t count, std::vector<double>& values) const {
        const std::uint64_t replaced = count_of(sparse, count);
        const Part indices = sparse.required("indices");
        const Component index = component_of(indices);
        if (!index.is_index) indices.fail("is not of an unsigned type; export the model again");
        const Stretch where = stretch_of(document_, indices, replaced, index.size);
        std::vector<double> news;
        take(stretch_of(document_, sparse.required("values"), replaced, element_size()), replaced,
             news);
        for (std::uint64_t i = 0; i < replaced; ++i) {
            const double at = index.value(where.first + i * where.stride, false);
            if (at >= static_cast<double>(count)) {
                indices.fail(
                    fmt::format("refers to element {} of {}; correct the file", at, count));
            }
            for (std::size_t k = 0; k < components_; ++k) {
                values[static_cast<std::size_t>(at) * components_ + k] = news[i * components_ + k];
            }
        }
    }

    Document& document_;
    const Part& part_;
    std::size_t components_;
    Component component_;
    bool normalized_;
};

Part checked_accessor(const Document& document, std::uint64_t index, std::string_view type,
                      const Part& from) {
    Part part = document.element("accessors", index, from);
    const std::string_view found = part.text("type").value_or("");
    if (found != type) {
        part.fail(fmt::format("is of type {} where {} needs {}; correct the file", shown(found),
                              from.title(), type));
    }
    return part;
}

}  // namespace

std::vector<Vec3d> read_vectors(Document& document, std::uint64_t index, std::string_view type,
                                const Part& from) {
    const std::size_t components = type == "VEC2" ? 2 : 3;
    const Part part = checked_accessor(document, index, type, from);
    const std::vector<double> values = Reader(document, part, static_cast<int>(components)).read();
    std::vector<Vec3d> vectors(values.size() / components, Vec3d(0));
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        for (std::size_t k = 0; k < components; ++k) {
            vectors[i][static_cast<int>(k)] = values[i * components + k];
        }
    }
    return vectors;
}

std::vector<std::uint32_t> read_indices(Document& document, std::uint64_t index, const Part& from) {
    const Part part = checked_accessor(document, index, "SCALAR", from);
    if (!component_of(part).is_index) part.fail("is not of an unsigned type; correct the indices");
    const std::vector<double> values = Reader(document, part, 1).read();
    std::vector<std::uint32_t> indices(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        indices[i] = static_cast<std::uint32_t>(values[i]);
    }
    return indices;
}

}  // namespace luch::loader::gltf
