#include "homework/ssao/check/store.h"

#include "framework/base/error.h"
#include "framework/image/planes.h"

namespace luch::homework::ssao {
namespace {

/// Channel beside channel: equal neighbours take less room in a file.
Image<float> channels_of(const Image<Vec3>& image) {
    Image<float> plane({3 * image.width(), image.height()});
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            for (int k = 0; k < 3; ++k) plane(k * image.width() + x, y) = image(x, y)[k];
        }
    }
    return plane;
}

Image<Vec3> vectors_of(const Image<float>& plane) {
    Image<Vec3> image({plane.width() / 3, plane.height()});
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            for (int k = 0; k < 3; ++k) image(x, y)[k] = plane(k * image.width() + x, y);
        }
    }
    return image;
}

Image<Vec3> row_of(const std::vector<Vec3>& points) {
    Image<Vec3> row({static_cast<int>(points.size()), 1});
    row.pixels() = points;
    return row;
}

}  // namespace

std::vector<grading::StoredPlane> planes_of(const Sample& sample) {
    return {{"depth.exr", sample.depth},
            {"position.exr", channels_of(sample.position)},
            {"normal.exr", channels_of(sample.normal)},
            {"kernel.exr", channels_of(row_of(sample.kernel))},
            {"mean.exr", sample.mean},
            {"variance.exr", sample.variance},
            {"raw.exr", sample.raw},
            {"along_x.exr", sample.along_x},
            {"along_y.exr", sample.along_y},
            {"upsampled.exr", sample.upsampled},
            {"light.exr", channels_of(sample.light)}};
}

void read_planes(const std::filesystem::path& folder, Sample& sample) {
    const Size size = sample.scene->settings.frame;
    const auto plane = [&](const char* name, int channels = 1) {
        Image<float> read = read_float_plane(folder / name);
        if (read.size() != Size{channels * size.width, size.height}) {
            throw Error({(folder / name).string()},
                        "is not of its scene's size; luch check ssao --regenerate makes it again");
        }
        return read;
    };
    sample.depth = plane("depth.exr");
    sample.position = vectors_of(plane("position.exr", 3));
    sample.normal = vectors_of(plane("normal.exr", 3));
    sample.kernel = vectors_of(read_float_plane(folder / "kernel.exr")).pixels();
    sample.mean = plane("mean.exr");
    sample.variance = plane("variance.exr");
    sample.raw = plane("raw.exr");
    sample.along_x = plane("along_x.exr");
    sample.along_y = plane("along_y.exr");
    sample.upsampled = plane("upsampled.exr");
    sample.light = vectors_of(plane("light.exr", 3));
}

}  // namespace luch::homework::ssao
