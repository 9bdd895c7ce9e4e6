#include "techniques/shadow_map/raster.h"

#include "framework/technique/context.h"

namespace luch::techniques::shadow_map {
namespace {

static_assert(ItemBuffer::tile_side == Context::tile_side);

/// A square camera that sees one face: 45° to each side of its middle.
Camera looking_through(int face, const Vec3d& light) {
    Camera camera;
    camera.position = light;
    camera.aspect = 1;
    camera.fov_deg = 2 * std::atan(std::sqrt(2.0)) * 180 / std::acos(-1.0);
    const std::array<double, faces_of_cube> yaw{-90, 90, 0, 0, 0, 180};
    const std::array<double, faces_of_cube> pitch{0, 0, 90, -90, 0, 0};
    camera.yaw_deg = yaw[static_cast<std::size_t>(face)];
    camera.pitch_deg = pitch[static_cast<std::size_t>(face)];
    return camera;
}

/// Where a pixel of that camera's frame lies on the face: along x and y of the face, how it changes
/// with a step to the right and with one down.
struct Turn {
    std::array<int, 2> by_right, by_down;  ///< −1, 0 or 1

    Turn(const Screen& screen, int face) {
        const Vec3d middle = screen.forward();
        const double far = screen.size().width;
        const Vec3d right = screen.ray(far, far / 2).direction - middle;
        const Vec3d down = screen.ray(far / 2, far).direction - middle;
        const auto whole = [](double x) { return std::abs(x) < 0.5 ? 0 : x < 0 ? -1 : 1; };
        by_right = {whole(right[x_axis(face)]), whole(right[y_axis(face)])};
        by_down = {whole(down[x_axis(face)]), whole(down[y_axis(face)])};
    }

    [[nodiscard]] std::array<int, 2> texel(int x, int y, int n) const {
        const auto along = [&](std::size_t axis) {
            const int step = by_right[axis] * x + by_down[axis] * y;
            return by_right[axis] + by_down[axis] < 0 ? n - 1 + step : step;
        };
        return {along(0), along(1)};
    }
};

/// Texels of a tile that are left in doubt.
struct Doubts {
    std::vector<Ray> rays;
    std::vector<float*> texels;

    void trace(Tracer& tracer) const {
        if (rays.empty()) return;
        std::vector<Hit> hits(rays.size());
        tracer.closest(RayKind::shadow, rays, hits);
        for (std::size_t i = 0; i < hits.size(); ++i) *texels[i] = hits[i].t;
    }
};

}  // namespace

FaceRaster::FaceRaster(const Scene& scene) : buffer_(scene) {}

void FaceRaster::fill(const Vec3d& light, int face, Context& context, ImageView<float> distance) {
    const int n = distance.width();
    const Screen screen(looking_through(face, light), {n, n});
    const Turn turn(screen, face);
    buffer_.draw(screen, Vec2d(0.5), context.pool());
    context.for_each(buffer_.tile_count(), [&](int index, int worker) {
        const Tile tile = buffer_.tile(index);
        const RayPacket packet = buffer_.rays(index);
        HitPacket found;
        ItemPacket items;
        const bool doubts = buffer_.resolve(index, packet, found) > 0;
        if (doubts) buffer_.show(index, items);
        Doubts left;
        for (int k = 0; k < RayPacket::capacity; ++k) {
            const int x = tile.x0 + ItemBuffer::x_in_tile(k),
                      y = tile.y0 + ItemBuffer::y_in_tile(k);
            if (x >= tile.x1 || y >= tile.y1) continue;
            const auto [i, j] = turn.texel(x, y, n);
            distance(i, j) = found.hit(k).t;  // infinite where there is nothing
            if (!doubts || !items.ambiguous[k]) continue;
            left.rays.push_back(packet.ray(k));
            left.texels.push_back(&distance(i, j));
        }
        left.trace(context.tracer(worker));
    });
}

bool raster_pays(const Scene& scene, int side) {
    // What the item buffer takes to set up a triangle, in texels that packets trace in that time.
    constexpr double texels_a_triangle = 4;
    double triangles = 0;
    std::size_t meshes = 0;
    for (const Node& node : scene.nodes) {
        const auto* mesh = std::get_if<Mesh>(&scene.geometries[node.geometry]);
        if (mesh == nullptr) continue;
        ++meshes;
        triangles += static_cast<double>(mesh->triangles.size());
    }
    return 2 * meshes > scene.nodes.size() &&
           triangles * texels_a_triangle < static_cast<double>(side) * side;
}

}  // namespace luch::techniques::shadow_map
