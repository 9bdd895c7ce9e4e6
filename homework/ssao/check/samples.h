#pragma once

#include "techniques/ssao/ssao.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

// What the tasks of this homework are tried on: what a camera sees of a scene, for every step an
// input, and the reference step's output for it. All numbers are floats, so that a file keeps them.
namespace luch::homework::ssao {

using namespace techniques::ssao;

/// Points of the stored kernel, and turns that its occlusion is the mean of.
inline constexpr int kernel_points = 8, turns_taken = 256;

struct Sample {
    std::string name;
    std::string scene_file;  ///< for a viewer; "" when there is none
    std::shared_ptr<const Scene> scene;

    Image<float> depth;           ///< input of positions
    Image<Vec3> position;         ///< …its output, and input of normals
    Image<Vec3> normal;           ///< …its output
    std::vector<Vec3> kernel;     ///< input of occlusion: kernel_points
    Image<float> mean, variance;  ///< of occlusion, over turns_taken keys
    Image<float> raw;             ///< occlusion of one key, in steps: input of blur
    Image<float> along_x, along_y;
    Image<float> upsampled;  ///< of every second pixel of `raw`
    Image<Rgb> light;        ///< of 1 − raw

    [[nodiscard]] Screen screen() const { return {scene->camera, depth.size()}; }
    [[nodiscard]] GBuffer seen() const { return {position.view(), normal.view()}; }
    [[nodiscard]] Rgb ambient() const { return scene->settings.ambient_light; }
    /// Of the occlusion, in world units.
    static constexpr double radius = 1.2;
    /// Of blur and upsample, in world units.
    static constexpr float tolerance = 0.15f;
};

/// Every second pixel.
template <class T>
Image<T> halved(const Image<T>& image) {
    Image<T> half({(image.width() + 1) / 2, (image.height() + 1) / 2});
    for (int y = 0; y < half.height(); ++y) {
        for (int x = 0; x < half.width(); ++x) half(x, y) = image(2 * x, 2 * y);
    }
    return half;
}

/// The public ones: scenes from homework/ssao/scenes, the rest from homework/ssao/reference. Throws
/// Error when a file is missing or does not fit.
std::vector<Sample> stored_samples(const std::filesystem::path& root);

/// Names of the public scenes.
std::vector<std::string> sample_names();

}  // namespace luch::homework::ssao
