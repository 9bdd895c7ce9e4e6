#pragma once

#include "techniques/layered/layered.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

// What the tasks of this homework are tried on: a scene seen by a pinhole, for every step an input,
// and the reference step's output for it. All numbers are floats, so that a file keeps them.
namespace luch::homework::layered {

using namespace techniques::layered;

/// Layers of cut's output, and σ in px of the gaussian's.
inline constexpr int cut_layers = 5;
inline constexpr float gaussian_sigma = 1.7f;

struct Sample {
    std::string name;
    std::string scene_file;  ///< for a viewer; "" when there is none
    std::shared_ptr<const Scene> scene;

    Image<float> depth;            ///< input of cut and coc
    std::vector<float> cuts;       ///< cut_layers − 1
    Image<float> coc;              ///< input of disc, too
    Image<Rgba> near, far;         ///< premultiplied: what is before and behind the middle cut
    Image<Rgba> along_x, along_y;  ///< `near`, blurred by the gaussian
    Image<Rgba> spread;            ///< `near`, blurred by the disc
    Image<Rgba> composed;          ///< `spread` over `far`

    [[nodiscard]] Lens lens() const { return lens_of(scene->camera, depth.size()); }
};

/// The public ones: scenes from homework/layered/scenes, the rest from homework/layered/reference.
/// Throws Error when a file is missing or does not fit.
std::vector<Sample> stored_samples(const std::filesystem::path& root);

/// Names of the public scenes.
std::vector<std::string> sample_names();

}  // namespace luch::homework::layered
