#pragma once

#include "framework/math/size.h"

#include <algorithm>

namespace luch {

/// Calls work(x, y) for every pixel of a tile in blocks of 4 × 4, the order in which packets of
/// primary rays are quick.
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

}  // namespace luch
