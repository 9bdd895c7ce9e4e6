#include "homework/vista/kit_frame.h"

#include "framework/math/rng.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace luch::techniques::vista {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

bool same_camera(const Camera& a, const Camera& b) {
    return a.projection == b.projection && a.position == b.position && a.yaw_deg == b.yaw_deg &&
           a.pitch_deg == b.pitch_deg && a.roll_deg == b.roll_deg && a.fov_deg == b.fov_deg &&
           a.aspect == b.aspect;
}

bool same_node(const Node& a, const Node& b) {
    return a.geometry == b.geometry && a.to_world.matrix == b.to_world.matrix &&
           a.to_world.offset == b.to_world.offset;
}

}  // namespace

Frustum frustum_of(const Screen& screen) {
    const double w = screen.half_width(), h = screen.half_height();
    return {{{{1, 0, w}, {-1, 0, w}, {0, 1, h}, {0, -1, h}}}};
}

double pixel_grid(Size size) {
    constexpr int bits = 26;
    const auto side = static_cast<unsigned>(std::max({size.width, size.height, 1}));
    return std::ldexp(1.0, static_cast<int>(std::bit_width(side - 1)) - bits);
}

float radius_px(const Scene& scene, const Node& node, const Screen& screen) {
    const Boxd box = bounds_of(scene.geometries[node.geometry]);
    if (box.empty()) return 0;
    if (!all_finite(box.lo) || !all_finite(box.hi)) return infinity;
    double longest_axis = 0;
    for (const Vec3d& axis : {Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)}) {
        longest_axis = std::max(longest_axis, glm::length(node.to_world.direction(axis)));
    }
    const double radius = max_norm(box.size()) / 2 * longest_axis;
    const Vec3d centre = screen.to_view(node.to_world.point(box.centre()));
    const double tangent_squared = glm::dot(centre, centre) - radius * radius;
    if (!(tangent_squared > 0)) return infinity;
    const double pixels_at_one = screen.size().width / (2 * screen.half_width());
    return static_cast<float>(radius / std::sqrt(tangent_squared) * pixels_at_one);
}

int stored_segments(const homework::vista::LodSample& stored, float radius_px) {
    for (std::size_t i = 0; i < stored.radii.size(); ++i) {
        if (stored.radii[i] >= radius_px) return stored.segments[i];
    }
    return most_segments;
}

void drop_backs(const Geometry& geometry, const Vec3d& eye_object, std::vector<Tri>& triangles) {
    const auto* mesh = std::get_if<Mesh>(&geometry);
    if (mesh == nullptr || !mesh->cull_backfaces) return;
    std::erase_if(triangles, [&](const Tri& triangle) {
        const Vec3d a = triangle.corners[0].p;
        const Vec3d normal = glm::cross(triangle.corners[1].p - a, triangle.corners[2].p - a);
        return glm::dot(a - eye_object, normal) > 0;
    });
}

bool touches(const ScreenTri& triangle, Tile tile) {
    const auto& [a, b, c] = triangle.px;
    return !(std::max({a.x, b.x, c.x}) < tile.x0 || std::min({a.x, b.x, c.x}) > tile.x1 ||
             std::max({a.y, b.y, c.y}) < tile.y0 || std::min({a.y, b.y, c.y}) > tile.y1);
}

bool shows(const homework::vista::Sample& sample, const Scene& scene, const Shot& shot) {
    return shot.size == sample.screen().size() && same_camera(shot.camera, sample.scene->camera) &&
           std::equal(scene.nodes.begin(), scene.nodes.end(), sample.scene->nodes.begin(),
                      sample.scene->nodes.end(), same_node);
}

void hatch(Tile tile, ImageView<const NodeId> ids, ImageView<Rgb> colour) {
    constexpr int stripe = 4;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const Key key(ids(x, y));
            const Rgb shown = ids(x, y) == no_node
                                  ? Rgb(0.2f)
                                  : Rgb(key.uniform(0), key.uniform(1), key.uniform(2));
            colour(x, y) = (x + y) / stripe % 2 == 0 ? shown : 0.4f * shown;
        }
    }
}

}  // namespace luch::techniques::vista
