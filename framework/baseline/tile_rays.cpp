#include "framework/baseline/tile_rays.h"

#include <array>
#include <limits>

namespace luch {
namespace {

/// What a sample's key is used for.
constexpr std::uint64_t radiance = 1;

/// Where a sample lies in each of a tile's pixels, as Screen::directions() wants it. Returns how
/// many there are.
std::size_t points_of(const Screen& screen, const Shot& shot, const Tile& tile, int sample,
                      int samples, double* sx, double* sy) {
    std::size_t count = 0;
    if (samples > 1) {
        for_each_pixel(tile, [&](int x, int y) {
            const Vec2d at = sample_position(shot, x, y, sample, samples);
            sx[count] = screen.across(at.x);
            sy[count++] = screen.upwards(at.y);
        });
        return count;
    }
    std::array<double, RayPacket::capacity> column, row;  // the centres are those of all others
    for (int i = 0; i < tile.width(); ++i) {
        column[static_cast<std::size_t>(i)] = screen.across(tile.x0 + i + 0.5);
    }
    for (int i = 0; i < tile.height(); ++i) {
        row[static_cast<std::size_t>(i)] = screen.upwards(tile.y0 + i + 0.5);
    }
    for_each_pixel(tile, [&](int x, int y) {
        sx[count] = column[static_cast<std::size_t>(x - tile.x0)];
        sy[count++] = row[static_cast<std::size_t>(y - tile.y0)];
    });
    return count;
}

/// The rays of a tile's pixels in a packet, for cameras that have one eye and see everywhere.
void aim(const Screen& screen, const Shot& shot, const Tile& tile, int sample, int samples,
         RayPacket& rays) {
    double sx[RayPacket::capacity], sy[RayPacket::capacity];
    const std::size_t count = points_of(screen, shot, tile, sample, samples, sx, sy);
    rays.origin = screen.eye();
    rays.count = static_cast<int>(count);
    std::fill_n(rays.t_max, count, std::numeric_limits<float>::infinity());
    screen.directions({sx, count}, {sy, count}, rays.x, rays.y, rays.z);
}

/// Whether aim() does for such a tile and camera.
bool goes_in_a_packet(const Screen& screen, const Tile& tile, bool lens) {
    return screen.projection() == Projection::perspective && !lens &&
           tile.area() <= std::size_t{RayPacket::capacity};
}

}  // namespace

Key radiance_key(const Shot& shot, int x, int y, int sample) {
    return sample_key(shot, x, y, sample).branch(radiance);
}

void TileRays::clear() {
    pixels.clear();
    rays.clear();
    keys.clear();
    hits.clear();
}

void TileRays::add(int x, int y, const Ray& ray, Key key) {
    if (nowhere(ray)) return;
    pixels.emplace_back(x, y);
    rays.push_back(ray);
    keys.push_back(key);
}

void TileRays::add(const Shot& shot, const Tile& tile, int sample, const RayPacket& packet,
                   const HitPacket& found) {
    int i = 0;
    for_each_pixel(tile, [&](int x, int y) {
        pixels.emplace_back(x, y);
        rays.push_back(packet.ray(i));
        keys.push_back(radiance_key(shot, x, y, sample));
        hits.push_back(found.hit(i++));
    });
}

void TileRays::shoot(const Screen& screen, const Shot& shot, const Tile& tile, int sample,
                     const Needs& needs, Tracer& tracer) {
    const int samples = sample_count(shot);
    const bool lens = needs[Part::lens];
    clear();
    if (goes_in_a_packet(screen, tile, lens)) {
        RayPacket packet;
        HitPacket found;
        aim(screen, shot, tile, sample, samples, packet);
        tracer.closest(RayKind::primary, packet, found);
        add(shot, tile, sample, packet, found);
        return;
    }
    for_each_pixel(tile, [&](int x, int y) {
        add(x, y, primary_ray(screen, shot, x, y, sample, samples, lens),
            radiance_key(shot, x, y, sample));
    });
    if (lens) tracer.counts().did(Part::lens, rays.size());
    trace(tracer);
}

void TileRays::trace(Tracer& tracer) {
    hits.resize(rays.size());
    tracer.closest(RayKind::primary, rays, hits);
}

}  // namespace luch
