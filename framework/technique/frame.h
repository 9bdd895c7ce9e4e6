#pragma once

#include "framework/image/image.h"
#include "framework/math/colour.h"

#include <cstdint>
#include <list>
#include <string>
#include <variant>
#include <vector>

namespace luch {

/// How a plane's numbers are meant, so that viewer and figures can draw it.
enum class PlaneKind { scalar, id, colour, normal, mask };

/// A named image beside the colour: depths, ids, masks…
struct Plane2d {
    std::string name;
    PlaneKind kind;
    std::string unit;
    float least = 0, most = 1;  ///< of a scalar, for false colours
    std::variant<Image<float>, Image<std::uint32_t>, Image<Rgb>, Image<std::uint8_t>> pixels;
};

/// Something to draw over a frame: a square or a line in pixel coordinates.
struct Mark {
    enum Shape { rectangle, line };
    Shape shape = rectangle;
    float x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    Rgb colour{1};
};

/// What a technique makes: linear colour, planes, marks. Reused from frame to frame.
class Frame {
 public:
    explicit Frame(Size size) : colour(size) {}

    Image<Rgb> colour;
    std::vector<Mark> marks;

    [[nodiscard]] Size size() const { return colour.size(); }

    /// The plane of that name, made (or, after a resize, made anew) when it is not there.
    /// References stay valid until the frame is resized.
    template <class T>
    Image<T>& plane(const std::string& name, PlaneKind kind, const std::string& unit = "",
                    float least = 0, float most = 1) {
        for (Plane2d& plane : planes_) {
            if (plane.name == name) return std::get<Image<T>>(plane.pixels);
        }
        planes_.push_back({name, kind, unit, least, most, Image<T>(size())});
        return std::get<Image<T>>(planes_.back().pixels);
    }
    [[nodiscard]] const std::list<Plane2d>& planes() const { return planes_; }

    /// Another size forgets all planes and marks.
    void resize(Size size);

 private:
    std::list<Plane2d> planes_;
};

}  // namespace luch
