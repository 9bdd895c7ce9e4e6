#pragma once

#include "techniques/vista/vista.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

// What the tasks of this homework are tried on: a scene, for every step an input of its own, and
// the reference step's output for it. All numbers are float or integers, so that a file keeps them.
namespace luch::homework::vista {

using namespace techniques::vista;

/// Segments of every sphere: of the polyhedra in `shapes`, and of those in the later steps' inputs.
inline constexpr int shape_segments = 16, input_segments = 8;

struct Sample {
    std::string name;
    std::string scene_file;  ///< for a viewer; "" when there is none
    std::shared_ptr<const Scene> scene;

    /// tessellate: what the shapes of all nodes look like.
    Image<std::uint32_t> shape_ids;
    Image<float> shape_depth;
    /// clip: its input, in view space. What is seen of it shall be seen afterwards.
    std::vector<Tri> around;
    /// sort: its input, and the indices of that in painting order.
    std::vector<Tri> in_view;
    std::vector<std::uint32_t> order;
    /// project: its input is in_view in painting order; its output.
    std::vector<ScreenTri> on_screen;
    /// rasterise: its input is on_screen; its output either way.
    Image<std::uint32_t> painter_ids, nearest_ids;
    Image<float> nearest_depth;
    /// look_up: the nodes that are named (many of them wrong), and the output.
    Image<std::uint32_t> named, hit_nodes, fell_back;

    [[nodiscard]] Screen screen() const { return {scene->camera, scene->settings.frame}; }
    /// in_view in painting order.
    [[nodiscard]] std::vector<Tri> sorted() const;
};

/// Inputs of lod and the reference's answers to them: radii in pixels, of spheres.
struct LodSample {
    std::vector<float> radii;
    std::vector<int> segments;
};

/// The public ones: scenes from homework/vista/scenes, the rest from homework/vista/reference.
/// Throws Error when a file is missing or does not fit.
std::vector<Sample> stored_samples(const std::filesystem::path& root);
LodSample stored_lod(const std::filesystem::path& root);

/// A node's corners, from its own coordinates to view space.
void to_view(const Scene& scene, NodeId node, const Screen& screen, std::vector<Tri>& triangles);

}  // namespace luch::homework::vista
