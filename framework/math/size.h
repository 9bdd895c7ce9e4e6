#pragma once

#include <cstddef>

namespace luch {

/// Width and height in pixels.
struct Size {
    int width = 0;
    int height = 0;
    [[nodiscard]] std::size_t area() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    }
    bool operator==(const Size&) const = default;
};

/// The pixels x0 ≤ x < x1, y0 ≤ y < y1.
struct Tile {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    [[nodiscard]] int width() const { return x1 - x0; }
    [[nodiscard]] int height() const { return y1 - y0; }
    [[nodiscard]] std::size_t area() const { return Size{width(), height()}.area(); }
    bool operator==(const Tile&) const = default;
};

}  // namespace luch
