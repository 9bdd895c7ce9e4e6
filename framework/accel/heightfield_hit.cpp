#include "framework/accel/heightfield_hit.h"

#include <array>
#include <cfloat>

namespace luch {
namespace {

/// The plane of a triangle: y = height + slope.x · (x − corner.x) + slope.y · (z − corner.y).
struct TrianglePlane {
    Vec2d corner;
    double height;
    Vec2d slope;

    TrianglePlane(const Heightfield& field, const Heightfield::Triangle& triangle) {
        const auto [x, z, k] = triangle;
        const double right = field.at(x + 1, z), below = field.at(x, z + 1);
        corner = Vec2d(x + k, z + k);
        height = field.at(x + k, z + k);
        slope =
            k == 0 ? Vec2d(right - height, below - height) : Vec2d(height - below, height - right);
    }
    [[nodiscard]] double at(const Vec2d& p) const {
        return height + slope.x * (p.x - corner.x) + slope.y * (p.y - corner.y);
    }
};

double between(double from, double to, double share) {
    const double value = from + std::clamp(share, 0.0, 1.0) * (to - from);
    return std::clamp(value, std::min(from, to), std::max(from, to));
}

/// Follows a ray over a heightfield, seen from above, cell by cell, and skips blocks of cells that
/// it passes wholly above or below, from coarse to fine (after Tevs, Ihrke, Seidel, "Maximum
/// Mipmaps for Fast, Accurate, and Scalable Dynamic Height Field Rendering", 2008).
///
/// Whether the ray is above the surface is asked once where it leaves a triangle, on the edge
/// itself, and the answer is carried on into the next one. A hit is where it changes, so none is
/// lost between two triangles. Skips change no answer: the ray's height y_at(t) and the time of a
/// grid line are one expression each, monotonic in floating point too, and the surface's height is
/// clamped to the ends of its edge; so what holds at both ends of a block holds at all within.
class Walk {
 public:
    Walk(const Heightfield& field, const Ray& ray, WorkCounts& work)
        : field_(field),
          ray_(ray),
          work_(work),
          from_(ray.origin.x, ray.origin.z),
          along_(ray.direction.x, ray.direction.z),
          size_{field.width(), field.height()} {}

    /// Calls found(t, primitive) from near to far until it answers true. A few hits outside of
    /// t_min..t_max may come, too.
    template <class Found>
    void run(Found&& found) {
        const auto [first, last] = time_over_field();
        if (!(first <= last)) return;
        cell_ = {cell_at(0, first), cell_at(1, first)};
        if (along_ == Vec2d(0)) {
            drop(found);
            return;
        }
        above_ = y_at(first) >= height_inside(at(first));
        double now = first;
        int level = field_.top_level();
        while (now <= last) {
            ++work_.boxes;
            const Leg leg = leg_from(now, level);
            const auto [lo, hi] = field_.range(level, cell_[0], cell_[1]);
            const double y0 = y_at(leg.begin), y1 = y_at(leg.end);
            const bool passes = std::min(y0, y1) > hi || std::max(y0, y1) < lo;
            if (!passes && level > 0) {
                --level;
                continue;
            }
            if (!passes && cross_cell(leg, found)) return;
            const std::array<int, 2> before = cell_;
            if (!leave(leg, level)) return;
            now = leg.end;
            const bool same_parent = before[0] >> (level + 1) == cell_[0] >> (level + 1) &&
                                     before[1] >> (level + 1) == cell_[1] >> (level + 1);
            if (!same_parent && level < field_.top_level()) ++level;
        }
    }

 private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    /// The way through a block, up to a grid line.
    struct Leg {
        double begin, end;
        int axis;  ///< of the line: 0 for x = line, 1 for z = line
        int line;
    };

    [[nodiscard]] double y_at(double t) const { return ray_.origin.y + t * ray_.direction.y; }
    [[nodiscard]] Vec2d at(double t) const { return from_ + t * along_; }
    [[nodiscard]] double time_of(int axis, int line) const {
        return along_[axis] == 0 ? infinity : (line - from_[axis]) / along_[axis];
    }

    /// Where the ray is over the field, within what it asks for and what a float can say.
    [[nodiscard]] std::array<double, 2> time_over_field() const {
        double first = std::max<double>(ray_.t_min, -FLT_MAX);
        double last = std::min<double>(ray_.t_max, FLT_MAX);
        for (int axis = 0; axis < 2; ++axis) {
            const int size = size_[axis];
            if (along_[axis] == 0) {
                if (!(from_[axis] >= 0 && from_[axis] <= size)) return {1, 0};
                continue;
            }
            first = std::max(first, time_of(axis, along_[axis] > 0 ? 0 : size));
            last = std::min(last, time_of(axis, along_[axis] > 0 ? size : 0));
        }
        return {first, last};
    }

    [[nodiscard]] int cell_at(int axis, double t) const {
        const double x = at(t)[axis];
        if (!(x > 0)) return 0;
        return x < size_[axis] ? static_cast<int>(x) : size_[axis] - 1;
    }

    [[nodiscard]] Leg leg_from(double begin, int level) const {
        std::array<int, 2> line;
        for (int axis = 0; axis < 2; ++axis) {
            const int block = cell_[axis] >> level;
            line[axis] =
                along_[axis] > 0 ? std::min((block + 1) << level, size_[axis]) : block << level;
        }
        const double x = time_of(0, line[0]), z = time_of(1, line[1]);
        const int axis = x < z ? 0 : 1;
        return {begin, std::max(begin, axis == 0 ? x : z), axis, line[axis]};
    }

    /// Into the next cell. Its other coordinate follows the ray, but never back, and never out of
    /// the block that the ray was in. False at the border of the field.
    bool leave(const Leg& leg, int level) {
        const int axis = leg.axis, other = 1 - axis;
        const int block = cell_[other] >> level;
        const int lo = along_[other] > 0 ? cell_[other] : block << level;
        const int hi =
            along_[other] > 0 ? std::min((block + 1) << level, size_[other]) - 1 : cell_[other];
        cell_[other] = std::clamp(cell_at(other, leg.end), lo, hi);
        cell_[axis] = along_[axis] > 0 ? leg.line : leg.line - 1;
        return cell_[axis] >= 0 && cell_[axis] < size_[axis];
    }

    [[nodiscard]] int triangle_under(const Vec2d& p) const {
        return p.x - cell_[0] + (p.y - cell_[1]) < 1 ? 0 : 1;
    }

    [[nodiscard]] double height_inside(const Vec2d& p) const {
        const TrianglePlane plane(field_, {cell_[0], cell_[1], triangle_under(p)});
        const auto [lo, hi] = field_.range(0, cell_[0], cell_[1]);
        return std::clamp<double>(plane.at(p), lo, hi);
    }

    [[nodiscard]] double height_at_end(const Leg& leg) const {
        const auto [x, z] = cell_;
        const Vec2d p = at(leg.end);
        if (leg.axis == 0) {
            return between(field_.at(leg.line, z), field_.at(leg.line, z + 1), p.y - z);
        }
        return between(field_.at(x, leg.line), field_.at(x + 1, leg.line), p.x - x);
    }

    [[nodiscard]] double height_on_diagonal(double t) const {
        const auto [x, z] = cell_;
        return between(field_.at(x, z + 1), field_.at(x + 1, z), at(t).x - x);
    }

    /// Through the two triangles of a cell, or one of them. The diagonal is the line x + z = a
    /// whole number.
    template <class Found>
    bool cross_cell(const Leg& leg, Found&& found) {
        ++work_.primitives;
        const double towards = along_.x + along_.y, sum = from_.x + from_.y;
        const int line = cell_[0] + cell_[1] + 1;
        const bool away = towards > 0 || (towards == 0 && sum < line);  // from the cell's corner
        const double diagonal = towards == 0 ? infinity : (line - sum) / towards;
        const double middle = std::clamp(diagonal, leg.begin, leg.end);
        const int first = away ? 0 : 1;
        if (middle > leg.begin && middle < leg.end) {
            const bool above = y_at(middle) >= height_on_diagonal(middle);
            if (piece(first, leg.begin, middle, above, found)) return true;
        }
        const int last = middle < leg.end ? 1 - first : first;
        const double begin = middle < leg.end ? middle : leg.begin;
        return piece(last, begin, leg.end, y_at(leg.end) >= height_at_end(leg), found);
    }

    template <class Found>
    bool piece(int k, double begin, double end, bool above, Found&& found) {
        if (above == above_) return false;
        above_ = above;
        const Heightfield::Triangle triangle{cell_[0], cell_[1], k};
        const double t = plane_t(field_, triangle, ray_);
        return found(!(t > begin) ? begin : std::min(t, end),
                     field_.primitive(cell_[0], cell_[1], k));
    }

    /// A ray straight up or down: one cell.
    template <class Found>
    void drop(Found&& found) {
        ++work_.primitives;
        if (ray_.direction.y == 0) return;
        const int k = triangle_under(from_);
        found((height_inside(from_) - ray_.origin.y) / ray_.direction.y,
              field_.primitive(cell_[0], cell_[1], k));
    }

    const Heightfield& field_;
    const Ray& ray_;
    WorkCounts& work_;
    Vec2d from_, along_;  ///< x and z
    std::array<int, 2> size_, cell_{};
    bool above_ = false;
};

}  // namespace

std::optional<ShapeHit> intersect(const Heightfield& field, const Ray& ray, WorkCounts& work) {
    std::optional<ShapeHit> hit;
    Walk(field, ray, work).run([&](double t, std::uint32_t primitive) {
        if (!within(t, ray)) return false;
        hit = {t, primitive};
        return true;
    });
    return hit;
}

void find_crossings(const Heightfield& field, const Ray& ray, Crossings& crossings,
                    WorkCounts& work) {
    Ray whole = ray;
    whole.t_max = std::numeric_limits<float>::infinity();
    Walk(field, whole, work).run([&](double t, std::uint32_t primitive) {
        crossings.add(t, primitive);
        return false;
    });
}

double height_of(const Heightfield& field, const Heightfield::Triangle& triangle, double x,
                 double z) {
    return TrianglePlane(field, triangle).at({x, z});
}

double plane_t(const Heightfield& field, const Heightfield::Triangle& triangle, const Ray& ray) {
    const TrianglePlane plane(field, triangle);
    const double rise =
        ray.direction.y - plane.slope.x * ray.direction.x - plane.slope.y * ray.direction.z;
    return (plane.at({ray.origin.x, ray.origin.z}) - ray.origin.y) / rise;
}

}  // namespace luch
