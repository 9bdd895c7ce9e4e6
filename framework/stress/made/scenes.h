#pragma once

#include "framework/technique/run.h"

#include <string_view>
#include <vector>

// Scenes made by hand, for tests: no file is read.
namespace luch::stress {

/// A black sky, one point light at (0, 10, −10), no anti-aliasing, 160 × 120 pixels; the camera
/// stands at the origin and looks along +z with a field of view of 90°.
Scene empty_scene();

/// Adds a node with a Lambert material of its own.
NodeId add_shape(Scene& scene, Geometry geometry, const Transform& to_world = {},
                 const Rgb& colour = Rgb(0.5f));

/// A mesh without normals and texture coordinates; three indices a triangle.
Mesh mesh_of(const std::vector<Vec3d>& positions, const std::vector<std::uint32_t>& indices);

/// empty_scene() with one triangle in front of the camera.
Scene one_triangle();

/// empty_scene() with sixty spheres of many sizes and colours in front of the camera; some hide
/// others.
Scene sixty_spheres();

/// empty_scene() with a shape of every kind: an infinite floor, a square, a cube, a sphere, a mesh.
Scene one_of_each();

/// A scene with all that is needed to render it. The scene lives in it and does not move.
class OwnStudio {
 public:
    explicit OwnStudio(Scene scene, int threads = 2);

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] Studio studio() const { return {scene_, *accelerator_, workers_}; }

    /// One frame of shot_of(scene) with one sample a pixel.
    Outcome render(Technique& technique, const Budget& budget = {}) const;
    Outcome render(Technique& technique, const Shot& shot, const Budget& budget = {}) const;

 private:
    const Scene scene_;
    std::unique_ptr<Accelerator> accelerator_;
    Workers workers_;
};

/// Pixels whose colours are not the same floats.
std::size_t different_pixels(const Outcome& a, const Outcome& b);

/// A plane of a frame, by name. Throws std::bad_variant_access or std::out_of_range when there is
/// none.
template <class T>
const Image<T>& plane_of(const Outcome& outcome, std::string_view name) {
    for (const Plane2d& plane : outcome.frame.planes()) {
        if (plane.name == name) return std::get<Image<T>>(plane.pixels);
    }
    throw std::out_of_range("no plane of that name");
}

}  // namespace luch::stress
