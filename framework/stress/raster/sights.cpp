#include "framework/stress/raster/sights.h"

#include "framework/accel/accelerator.h"

namespace luch::stress {

Sights& Sights::operator+=(const Sights& other) {
    pixels += other.pixels;
    hits += other.hits;
    ambiguous += other.ambiguous;
    wrong_items += other.wrong_items;
    wrong_hits += other.wrong_hits;
    wrong_depths += other.wrong_depths;
    wrong_searches += other.wrong_searches;
    return *this;
}

namespace {

/// Holds a pixel that is certain against its ray.
void judge(const Item& item, const ItemDepths& depths, const Hit& resolved, const Hit& truth,
           double along_view, Sights& sights) {
    const Item expected =
        truth ? Item{truth.node, truth.primitive, false} : Item{no_node, 0, false};
    sights.wrong_items += item == expected ? 0 : 1;
    sights.wrong_hits += resolved == truth ? 0 : 1;
    if (!truth) return;
    const double inverse = 1 / (truth.t * along_view);
    const bool sound = inverse >= depths.nearest * (1 - 1e-6) && depths.second < depths.nearest;
    sights.wrong_depths += sound ? 0 : 1;
}

}  // namespace

Sights compared(ItemBuffer& buffer, const Camera& camera, Size size, const Vec2d& offset,
                const Workers& workers, const Truth& truth) {
    const Screen screen(camera, size);
    buffer.draw(screen, offset, workers, true);
    Sights sights;
    for (int i = 0; i < buffer.tile_count(); ++i) {
        const RayPacket rays = buffer.rays(i);
        HitPacket hits;
        buffer.resolve(i, rays, hits);
        const Tile tile = buffer.tile(i);
        for (int k = 0; k < RayPacket::capacity; ++k) {
            const int x = tile.x0 + ItemBuffer::x_in_tile(k);
            const int y = tile.y0 + ItemBuffer::y_in_tile(k);
            if (x >= tile.x1 || y >= tile.y1) continue;
            ++sights.pixels;
            const Item item = buffer.item(x, y);
            sights.ambiguous += item.ambiguous ? 1 : 0;
            const Hit hit = truth(rays.ray(k));
            sights.hits += hit ? 1 : 0;
            if (item.ambiguous) continue;
            judge(item, buffer.depths(x, y), hits.hit(k), hit,
                  glm::dot(rays.ray(k).direction, screen.forward()), sights);
        }
    }
    return sights;
}

Sights compared_with_brute(const Scene& scene, Size size, Isa isa) {
    ItemBuffer buffer(scene, isa);
    const auto brute = [&](const Ray& ray) { return closest_brute(scene, ray); };
    Sights sights = compared(buffer, scene.camera, size, Vec2d(0.5), Workers(1), brute);
    const auto accelerator = build_accelerator(scene, isa);
    for (int i = 0; i < buffer.tile_count(); ++i) {
        const RayPacket rays = buffer.rays(i);
        HitPacket hits;
        WorkCounts work;
        accelerator->closest(rays, hits, work);
        for (int k = 0; k < rays.count; ++k) {
            const Hit alone = accelerator->closest(rays.ray(k), work);
            const bool same = alone == brute(rays.ray(k)) && hits.hit(k) == alone;
            sights.wrong_searches += same ? 0 : 1;
        }
    }
    return sights;
}

Camera camera_at(const Vec3d& eye, double yaw_deg, double pitch_deg, double fov_deg) {
    Camera camera;
    camera.position = eye;
    camera.yaw_deg = yaw_deg;
    camera.pitch_deg = pitch_deg;
    camera.fov_deg = fov_deg;
    return camera;
}

}  // namespace luch::stress
