#include "homework/ssao/check/made.h"

#include <cmath>
#include <numbers>

namespace luch::homework::ssao {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double depth = 10;

FlatThing through_middle(const Vec3d& normal) {
    return {normal, normal.z * depth};
}

}  // namespace

Made::Made(const std::vector<FlatThing>& things, Size size)
    : screen({.fov_deg = 70, .aspect = double(size.width) / size.height}, size),
      depth(size, std::numeric_limits<float>::infinity()),
      position(size, Vec3(0, 0, std::numeric_limits<float>::infinity())),
      normal(size, Vec3(0)) {
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const Vec3d ray(screen.across(x + 0.5), screen.upwards(y + 0.5), 1);
            for (const FlatThing& thing : things) {
                const double cosine = glm::dot(thing.normal, ray), z = thing.offset / cosine;
                if (!(z > 0 && z < depth(x, y)) || z * ray.x < thing.least_x) continue;
                depth(x, y) = static_cast<float>(z);
                position(x, y) = Vec3(z * ray);
                normal(x, y) = Vec3(cosine > 0 ? -thing.normal : thing.normal);
            }
        }
    }
}

FlatThing facing(double at, double least_x) {
    return {{0, 0, -1}, -at, least_x};
}

FlatThing tilted(double degrees, double around_degrees) {
    const double tilt = degrees * radians, around = around_degrees * radians;
    return through_middle(
        {std::sin(tilt) * std::cos(around), std::sin(tilt) * std::sin(around), -std::cos(tilt)});
}

std::vector<FlatThing> corner(double degrees) {
    return {tilted(45, degrees), tilted(45, degrees + 180)};
}

}  // namespace luch::homework::ssao
