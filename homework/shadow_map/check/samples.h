#pragma once

#include "techniques/shadow_map/shadow_map.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

// What the tasks of this homework are tried on: a scene with a point light and a light with an
// area, for every step an input, and the reference step's output for it. All numbers are floats or
// integers, so that a file keeps them.
namespace luch::homework::shadow_map {

using namespace techniques::shadow_map;

/// Receivers and what the steps answer. None is so near a border of a texel, or so nearly as far as
/// what is stored, that rounding could decide.
struct Receivers {
    std::vector<Receiver> points;
    std::vector<float> biases, lit, pcf;
};

/// Where the points of Sample::spots lie: so many inside faces, on rims, in corners.
inline constexpr std::size_t spots_inside = 60, spots_on_rims = 96, spots_in_corners = 24;

struct Sample {
    std::string name;
    std::string scene_file;  ///< for a viewer; "" when there is none
    std::shared_ptr<const Scene> scene;

    /// texel_of: directions of any length, the texels that they go through; direction_of: the
    /// directions through those texels' centres.
    std::vector<Vec3> directions, centres;
    std::vector<Texel> texels;
    /// render_face: the map around the point light, and what is seen in it.
    CubeMap map;
    std::array<Image<std::uint32_t>, faces_of_cube> nodes;
    /// bias, lit and pcf on the map: what the camera sees, and in which pixels.
    Receivers seen;
    std::vector<std::uint32_t> pixels;
    /// pcf on speckled_map().
    std::vector<Receiver> spots;
    std::vector<float> spot_shares;
    /// light_points: the regular ones.
    std::vector<Vec3> grid;

    [[nodiscard]] Vec3d light() const;
    [[nodiscard]] const RectLight& area() const;
    /// How many points stand for it: its samples.
    [[nodiscard]] int points() const;
};

/// The first light of a kind.
template <class Kind>
const Kind* find_light(const Scene& scene) {
    for (const Light& light : scene.lights) {
        if (const auto* found = std::get_if<Kind>(&light)) return found;
    }
    return nullptr;
}

/// All of a face, at one distance.
Face whole_face(int n, float distance);

/// A map whose texels are at 1 or at 3, as a die falls.
CubeMap speckled_map(int n);
/// How far spots are, and their bias: those texels at 3 let light through.
inline constexpr float spot_distance = 2, spot_bias = 0.25f;

/// The public ones: scenes from homework/shadow_map/scenes, the rest from
/// homework/shadow_map/reference. Throws Error when a file is missing or does not fit.
std::vector<Sample> stored_samples(const std::filesystem::path& root);

/// Names of the public scenes, and texels along an edge of a face of their maps.
struct Public {
    std::string name;
    int n;
};
std::vector<Public> public_samples();

}  // namespace luch::homework::shadow_map
