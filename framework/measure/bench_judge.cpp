#include "framework/measure/bench_judge.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luch {
namespace {

/// What float arithmetic may do to an edge or a distance, as a shift of the ray by this times the
/// largest coordinate: sixteen roundings.
constexpr double rounding = 16 * 0x1p-24;

/// Where a ray through the origin meets a triangle's plane, and on which side of its edges. Values
/// of neighbours are opposite to the last bit.
struct Seen {
    double t;  ///< NaN where the ray runs in the plane
    double least, most;
    std::array<double, 3> side;

    Seen(const std::array<Vec3d, 3>& corner, const Vec3d& direction) {
        for (int k = 0; k < 3; ++k) {
            side[k] = glm::dot(glm::cross(corner[k], corner[(k + 1) % 3]), direction);
        }
        least = std::min({side[0], side[1], side[2]});
        most = std::max({side[0], side[1], side[2]});
        const Vec3d normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        const double along = glm::dot(normal, direction);
        t = along != 0 ? glm::dot(normal, corner[0]) / along
                       : std::numeric_limits<double>::quiet_NaN();
    }
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
        first_.fill(infinity);
    }

    void meet(std::uint32_t triangle, const std::array<Vec3d, 3>& corner) {
        Candidate candidate{triangle, infinity};
        std::array<double, 3> least, most;
        least.fill(infinity);
        most.fill(-infinity);
        for (std::size_t i = 0; i < shift_.size(); ++i) {
            std::array<Vec3d, 3> moved = corner;
            for (Vec3d& p : moved) p = p - ray_.origin - shift_[i];
            const Seen seen(moved, ray_.direction);
            const bool in_time = seen.t > ray_.t_min && seen.t < ray_.t_max;
            if (in_time) candidate.t = std::min(candidate.t, seen.t);
            if (in_time && !(seen.least < 0 && seen.most > 0)) {
                first_[i] = std::min(first_[i], seen.t);
            }
            for (int k = 0; k < 3; ++k) {
                least[k] = std::min(least[k], seen.side[k]);
                most[k] = std::max(most[k], seen.side[k]);
            }
        }
        const bool possible =
            *std::ranges::min_element(most) >= 0 || *std::ranges::max_element(least) <= 0;
        if (possible && candidate.t < infinity) candidates_.push_back(candidate);
    }

    [[nodiscard]] Judgement judgement() const {
        Judgement result;
        const auto misses = std::ranges::count(first_, infinity);
        // None of nine may meet the tip of a sharp corner that rays between them meet.
        if (!candidates_.empty()) result.verdict = misses == 0 ? Verdict::hit : Verdict::doubtful;
        const double last = *std::ranges::max_element(first_);
        for (const Candidate& each : candidates_) {
            if (each.t <= last * (1 + rounding)) result.nearest.push_back(each.triangle);
        }
        return result;
    }

 private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    /// A triangle that one of the rays may meet, and the least t at which.
    struct Candidate {
        std::uint32_t triangle;
        double t;
    };

    const Ray& ray_;
    std::array<Vec3d, 9> shift_{};  ///< the last one stays where it is
    std::array<double, 9> first_;   ///< the nearest hit of each
    std::vector<Candidate> candidates_;
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
