#pragma once

#include "framework/baseline/stages.h"
#include "framework/technique/samples.h"
#include "framework/technique/technique.h"
#include "framework/trace/tracer.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace luch {

/// Calls work(x, y) for a tile's pixels in the order of packets: blocks of 4 × 4, row by row.
template <class Work>
void for_each_pixel(const Tile& tile, Work&& work) {
    constexpr int block = 4;
    for (int y0 = tile.y0; y0 < tile.y1; y0 += block) {
        for (int x0 = tile.x0; x0 < tile.x1; x0 += block) {
            for (int y = y0; y < std::min(y0 + block, tile.y1); ++y) {
                for (int x = x0; x < std::min(x0 + block, tile.x1); ++x) work(x, y);
            }
        }
    }
}

/// The key of all that a sample's light depends on at random.
Key radiance_key(const Shot& shot, int x, int y, int sample);

/// The primary rays of some of a tile's pixels, and what they meet. Reused from tile to tile.
struct TileRays {
    std::vector<std::pair<int, int>> pixels;
    std::vector<Ray> rays;
    std::vector<Key> keys;
    std::vector<Hit> hits;  ///< as many as rays, once they are found

    void clear();
    /// Adds a ray of a pixel, but one that leads nowhere (see nowhere()).
    void add(int x, int y, const Ray& ray, Key key);
    /// Adds one sample of a whole tile with its hits, in the order of for_each_pixel().
    void add(const Shot& shot, const Tile& tile, int sample, const RayPacket& packet,
             const HitPacket& found);
    /// One sample of every pixel of a tile, and nothing else; finds its hits. They go in a packet
    /// where the camera is a pinhole, with the same hits.
    void shoot(const Screen& screen, const Shot& shot, const Tile& tile, int sample,
               const Needs& needs, Tracer& tracer);
    /// Finds the hits of what was added.
    void trace(Tracer& tracer);
};

}  // namespace luch
