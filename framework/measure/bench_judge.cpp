#include "framework/measure/bench_judge.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luch {
namespace {

/// What float arithmetic may do to an edge or a distance, as a shift of the ray by this times the
/// largest coordinate: sixteen roundings.
constexpr double rounding = 16 * 0x1p-24;

/// Signs of (a × b) · d for neighbours are opposite to the last bit.
double side_of(const Vec3d& a, const Vec3d& b, const Vec3d& d) {
    return glm::dot(glm::cross(a, b), d);
}

/// The t of a ray through the origin; NaN for a miss.
double t_of(const std::array<Vec3d, 3>& corner, const Vec3d& direction) {
    constexpr double miss = std::numeric_limits<double>::quiet_NaN();
    const double u = side_of(corner[1], corner[2], direction);
    const double v = side_of(corner[2], corner[0], direction);
    const double w = side_of(corner[0], corner[1], direction);
    if (std::min({u, v, w}) < 0 && std::max({u, v, w}) > 0) return miss;
    const Vec3d normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double along = glm::dot(normal, direction);
    return along != 0 ? glm::dot(normal, corner[0]) / along : miss;
}

struct Met {
    std::uint32_t triangle;
    double t;
};

/// The ray and eight about it.
class Bunch {
 public:
    Bunch(const Mesh& mesh, double scale, const Ray& ray) : ray_(ray) {
        double size = 0;
        for (const Vec3& p : mesh.positions) {
            size = std::max(size, max_norm(scale * Vec3d(p) - ray.origin));
        }
        for (int i = 0; i < 8; ++i) {
            const Vec3d side((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
            shift_[i] = rounding * size * side;
        }
    }

    void meet(std::uint32_t triangle, const std::array<Vec3d, 3>& corner) {
        for (std::size_t i = 0; i < shift_.size(); ++i) {
            std::array<Vec3d, 3> seen = corner;
            for (Vec3d& p : seen) p = p - ray_.origin - shift_[i];
            const double t = t_of(seen, ray_.direction);
            if (t > ray_.t_min && t < ray_.t_max) met_[i].push_back({triangle, t});
        }
    }

    [[nodiscard]] Judgement judgement() const {
        Judgement result;
        const auto hits = std::ranges::count_if(met_, [](const auto& m) { return !m.empty(); });
        if (hits > 0) result.verdict = hits == 9 ? Verdict::hit : Verdict::doubtful;
        for (const std::vector<Met>& met : met_) {
            double first = std::numeric_limits<double>::infinity();
            for (const Met& m : met) first = std::min(first, m.t);
            for (const Met& m : met) {
                if (m.t - first <= rounding * std::abs(m.t)) result.nearest.push_back(m.triangle);
            }
        }
        return result;
    }

 private:
    const Ray& ray_;
    std::array<Vec3d, 9> shift_{};  ///< the last one stays where it is
    std::array<std::vector<Met>, 9> met_;
};

}  // namespace

Judgement judged(const Mesh& mesh, double scale, const Ray& ray) {
    Bunch bunch(mesh, scale, ray);
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        std::array<Vec3d, 3> corner;
        for (int k = 0; k < 3; ++k) corner[k] = scale * Vec3d(mesh.corner(i, k));
        bunch.meet(i, corner);
    }
    return bunch.judgement();
}

}  // namespace luch
