#pragma once

#include "techniques/ssao/view.h"

#include <vector>

// Pictures of planes without a scene, for tests of single steps.
namespace luch::techniques::ssao {

/// A plane in camera space: the points p with normal·p = offset.
struct FlatThing {
    Vec3d normal;
    double offset = 0;
    /// Where it ends: only points with x ≥ least_x.
    double least_x = -std::numeric_limits<double>::infinity();
};

/// What a camera sees of planes, exact to a rounding.
struct Seen {
    Seen(Size size, const std::vector<FlatThing>& things, double fov_deg = 90)
        : screen({.fov_deg = fov_deg, .aspect = double(size.width) / size.height}, size),
          depth(size),
          position(size),
          normal(size) {
        each_pixel(depth.view().tile(), [&](int x, int y) { look(things, x, y); });
    }
    [[nodiscard]] GBuffer buffer() const { return {position.view(), normal.view()}; }

    Screen screen;
    Image<float> depth;
    Image<Vec3> position, normal;

 private:
    void look(const std::vector<FlatThing>& things, int x, int y) {
        const Vec3d ray(screen.across(x + 0.5), screen.upwards(y + 0.5), 1);
        double nearest = std::numeric_limits<double>::infinity();
        normal(x, y) = Vec3(0);
        for (const FlatThing& thing : things) {
            const Vec3d unit = glm::normalize(thing.normal);
            const double cosine = glm::dot(unit, ray);
            const double z = thing.offset / glm::length(thing.normal) / cosine;
            if (!(z > 0 && z < nearest) || z * ray.x < thing.least_x) continue;
            nearest = z;
            normal(x, y) = Vec3(cosine > 0 ? -unit : unit);
        }
        depth(x, y) = static_cast<float>(nearest);
        position(x, y) = nearest < std::numeric_limits<double>::infinity()
                             ? Vec3(nearest * ray)
                             : Vec3(0, 0, std::numeric_limits<float>::infinity());
    }
};

}  // namespace luch::techniques::ssao
