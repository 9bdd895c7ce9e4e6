#include "homework/layered/check/store.h"

#include "framework/base/error.h"
#include "framework/image/planes.h"

namespace luch::homework::layered {
namespace {

/// Channel beside channel: equal neighbours take less room in a file.
Image<float> channels_of(const Image<Rgba>& image) {
    Image<float> plane({4 * image.width(), image.height()});
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            for (int k = 0; k < 4; ++k) plane(k * image.width() + x, y) = image(x, y)[k];
        }
    }
    return plane;
}

Image<Rgba> pixels_of(const Image<float>& plane) {
    Image<Rgba> image({plane.width() / 4, plane.height()});
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            for (int k = 0; k < 4; ++k) image(x, y)[k] = plane(k * image.width() + x, y);
        }
    }
    return image;
}

Image<float> column_of(const std::vector<float>& values) {
    Image<float> column({1, static_cast<int>(values.size())});
    column.pixels() = values;
    return column;
}

}  // namespace

std::vector<grading::StoredPlane> planes_of(const Sample& sample) {
    return {{"depth.exr", sample.depth},
            {"cuts.exr", column_of(sample.cuts)},
            {"coc.exr", sample.coc},
            {"near.exr", channels_of(sample.near)},
            {"far.exr", channels_of(sample.far)},
            {"along_x.exr", channels_of(sample.along_x)},
            {"along_y.exr", channels_of(sample.along_y)},
            {"spread.exr", channels_of(sample.spread)},
            {"composed.exr", channels_of(sample.composed)}};
}

void read_planes(const std::filesystem::path& folder, Sample& sample) {
    const Size size = sample.scene->settings.frame;
    const auto plane = [&](const char* name, int channels) {
        Image<float> read = read_float_plane(folder / name);
        if (read.size() != Size{channels * size.width, size.height}) {
            throw Error({(folder / name).string()},
                        "is not of its scene's size; luch check layered --regenerate makes it "
                        "again");
        }
        return read;
    };
    const auto pixels = [&](const char* name) { return pixels_of(plane(name, 4)); };
    sample.depth = plane("depth.exr", 1);
    sample.cuts = read_float_plane(folder / "cuts.exr").pixels();
    sample.coc = plane("coc.exr", 1);
    sample.near = pixels("near.exr");
    sample.far = pixels("far.exr");
    sample.along_x = pixels("along_x.exr");
    sample.along_y = pixels("along_y.exr");
    sample.spread = pixels("spread.exr");
    sample.composed = pixels("composed.exr");
}

}  // namespace luch::homework::layered
