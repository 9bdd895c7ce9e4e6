// The hemisphere in slices: half-planes through the view ray, in which what the picture shows
// closes angles. Jiménez, Wu, Pesce and Jarabo, "Practical Realtime Strategies for Accurate
// Indirect Occlusion", 2016; Therrien, Levesque and Gilet, "Screen Space Indirect Lighting with
// Visibility Bitmask", 2023.
#include "techniques/ssao/slices.h"

#include "techniques/ssao/view.h"

#include <bit>
#include <cmath>
#include <numbers>
#include <vector>

namespace luch::techniques::ssao {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr int sectors = 32;

/// For −π..π, to 1e-5 (Abramowitz and Stegun, "Handbook of Mathematical Functions", 4.4.49).
float angle_of(float y, float x) {
    const float a = std::abs(y), b = std::abs(x);
    const float more = std::max(a, b);
    if (!(more > 0)) return 0;
    const float q = std::min(a, b) / more, s = q * q;
    float angle = q * (0.9998660f +
                       s * (-0.3302995f + s * (0.1801410f + s * (-0.0851330f + s * 0.0208351f))));
    if (a > b) angle = pi / 2 - angle;
    if (x < 0) angle = pi - angle;
    return y < 0 ? -angle : angle;
}

/// One slice of a point's hemisphere: the plane of the view ray and of a direction of the screen.
/// Angles are taken from the view ray, towards `along` positive; the projected normal is at `turn`.
class Slice {
 public:
    Slice(const Vec3& to_eye, const Vec3& normal, const Vec3& across) : normal_(normal) {
        along_ = glm::normalize(across - glm::dot(across, to_eye) * to_eye);
        const float sine = glm::dot(normal, along_), cosine = glm::dot(normal, to_eye);
        length_ = std::sqrt(sine * sine + cosine * cosine);
        if (!(length_ > 0)) return;
        sin_turn_ = sine / length_;
        cos_turn_ = cosine / length_;
        turn_ = angle_of(sine, cosine);
        tangent_ = cos_turn_ * along_ - sin_turn_ * to_eye;
        whole_ = cos_turn_ + turn_ * sin_turn_;
    }

    /// ∫ cos(θ − turn)·|sin θ| over the half-circle around the projected normal, times its length:
    /// what the slice weighs.
    [[nodiscard]] float weight() const { return length_ * whole_; }

    /// The share of the weight that lies before a way's angle: 0..1 from one tangent to the other.
    /// The integral from the view ray to θ is ±¼(cos turn − cos(2θ − turn) + 2θ sin turn). The
    /// height of a way above the tangent plane is kept where a pixel's centre lies beside the
    /// slice, so that no plane closes itself.
    [[nodiscard]] float before(const Vec3& way) const {
        const float a = glm::dot(way, tangent_), h = glm::dot(way, normal_) / length_;
        if (h <= 0) return glm::dot(way, along_) < 0 ? 0 : 1;
        const float theta = turn_ + angle_of(a, h);
        const float squared = 1 / (a * a + h * h);
        const float cos_twice = (h * h - a * a) * squared, sin_twice = 2 * a * h * squared;
        const float part =
            (cos_turn_ - cos_turn_ * cos_twice + sin_turn_ * sin_twice + 2 * theta * sin_turn_) / 4;
        const float from_view = theta < 0 ? -part : part;
        const float first = (2 * cos_turn_ + (2 * turn_ - pi) * sin_turn_) / 4;
        return std::clamp((from_view + first) / whole_, 0.0f, 1.0f);
    }

 private:
    Vec3 normal_, along_, tangent_{0};
    float length_ = 0, turn_ = 0, sin_turn_ = 0, cos_turn_ = 1, whole_ = 1;
};

/// Sectors of equal weight; bit i stands for the place i + phase of 0..32.
std::uint32_t sectors_between(float from, float to, float phase) {
    // All bits whose places lie before a share of the weight.
    const auto before = [&](float share) {
        const float place = share * sectors - phase;
        const int whole = static_cast<int>(place);
        const int bits = whole + (static_cast<float>(whole) < place ? 1 : 0);
        return bits >= sectors ? ~std::uint32_t{0} : (std::uint32_t{1} << std::max(bits, 0)) - 1;
    };
    return before(to) & ~before(from);
}

/// What is published for the fading of far occluders (XeGTAO, after Jiménez et al.).
struct Fade {
    float reach, share;
};
constexpr Fade published{1.457f, 0.615f}, none{1, 0};

/// A pixel whose hemisphere is looked at.
struct Point {
    float x, y;  ///< its centre, in pixels
    Vec3 position, to_eye, normal;
};

/// How much of a way from a pixel's centre stays in the frame: 0..1.
float inside(Size frame, const Point& point, const Vec2& way_px) {
    const auto along = [](float at, float way, int end) {
        return way > 0 ? (static_cast<float>(end) - at) / way : way < 0 ? -at / way : 1.0f;
    };
    return std::min(
        {1.0f, along(point.x, way_px.x, frame.width), along(point.y, way_px.y, frame.height)});
}

/// What all pixels have in common.
struct Gather {
    const GBuffer& seen;
    float radius, thickness;
    Fade fade;
    bool bits;
    int steps;  ///< to either side

    [[nodiscard]] float faded(float distance) const {
        if (fade.share <= 0) return 1;
        return std::clamp((radius - distance) / (fade.share * radius), 0.0f, 1.0f);
    }

    /// Calls closes(way) for what is seen along a way on the screen and may close something.
    template <class Closes>
    void walk(const Point& point, const Vec2& way_px, float jitter, Closes&& closes) const {
        const Size frame = seen.position.size();
        const Vec2 way = inside(frame, point, way_px) * way_px;
        const float least = 1 / std::max(std::abs(way.x), std::abs(way.y));  // not the pixel itself
        for (int i = 0; i < steps; ++i) {
            const float even = (static_cast<float>(i) + jitter) / static_cast<float>(steps);
            const float share = std::max(even, least);
            const float u = point.x + share * way.x, v = point.y + share * way.y;
            if (!(u >= 0 && v >= 0 && u < float(frame.width) && v < float(frame.height))) continue;
            const Vec3 to =
                seen.position(static_cast<int>(u), static_cast<int>(v)) - point.position;
            const float squared = glm::dot(to, to);
            if (!(squared <= radius * radius)) continue;
            if (stands_out(glm::dot(to, point.normal), squared, point.position.z)) closes(to);
        }
    }

    /// The share of a slice that is closed.
    [[nodiscard]] float closed(const Slice& slice, const Point& point, const Vec2& way_px,
                               float jitter, float phase) const {
        if (!bits) {
            float low = 0, high = 0;  // from either tangent to the horizon
            walk(point, way_px, jitter, [&](const Vec3& to) {
                high = std::max(high, faded(glm::length(to)) * (1 - slice.before(to)));
            });
            walk(point, -way_px, jitter, [&](const Vec3& to) {
                low = std::max(low, faded(glm::length(to)) * slice.before(to));
            });
            return std::min(low + high, 1.0f);
        }
        std::uint32_t mask = 0;
        const auto closes = [&](const Vec3& to) {
            const Vec3 there = point.position + to;
            const float front = slice.before(to);
            const float back = slice.before(to + thickness / glm::length(there) * there);
            mask |= sectors_between(std::min(front, back), std::max(front, back), phase);
        };
        walk(point, way_px, jitter, closes);
        walk(point, -way_px, jitter, closes);
        return static_cast<float>(std::popcount(mask)) / sectors;
    }
};

/// The slices of one of the 16 turns: where they lie, and where their samples and sectors begin.
struct Turn {
    Vec3 across;
    float jitter, phase;
};

std::vector<Turn> turns_of(int count, Key key) {
    const double shift = key.uniform(0), other = key.uniform(1);
    std::vector<Turn> turns;
    for (int turn = 0; turn < 16; ++turn) {
        for (int i = 0; i < count; ++i) {
            const double place = i + (turn + shift) / 16;
            const double angle = std::numbers::pi * place / count;
            const double jitter = glm::fract((turn * 5 + i * 7) % 16 / 16.0 + other);
            // Apart from 0 and 1, so that rounding at a tangent closes nothing.
            const double phase = 0.02 + 0.96 * glm::fract(7 * jitter + 0.618034 * place);
            turns.push_back(
                {Vec3(std::cos(angle), std::sin(angle), 0), float(jitter), float(phase)});
        }
    }
    return turns;
}

}  // namespace

void slices(const GBuffer& seen, const Screen& screen, const Params& params, Key key, Tile tile,
            ImageView<float> occluded) {
    const Scale scale(screen);
    const Fade fade = params.fade && Mode(params.mode) == Mode::gtao ? published : none;
    const Gather gather{.seen = seen,
                        .radius = static_cast<float>(params.radius) * fade.reach,
                        .thickness = static_cast<float>(params.thickness * params.radius),
                        .fade = fade,
                        .bits = Mode(params.mode) != Mode::gtao,
                        .steps = std::clamp(params.samples, 2, samples_a_slice) / 2};
    const int count = std::max(1, params.samples / samples_a_slice);
    const std::vector<Turn> turns = turns_of(count, key);
    each_pixel(tile, [&](int x, int y) {
        occluded(x, y) = 0;
        Point point{static_cast<float>(x) + 0.5f,
                    static_cast<float>(y) + 0.5f,
                    seen.position(x, y),
                    {},
                    {}};
        if (!is_seen(point.position) || !(scale.px(gather.radius, point.position.z) >= 1)) return;
        point.to_eye = -glm::normalize(point.position);
        point.normal = towards(point.to_eye, seen.normal(x, y));
        if (point.normal == Vec3(0)) return;
        float closed = 0, whole = 0;
        for (int i = 0; i < count; ++i) {
            const Turn& turn = turns[static_cast<std::size_t>(turn_of(x, y) * count + i)];
            const Slice slice(point.to_eye, point.normal, turn.across);
            if (!(slice.weight() > 0)) continue;
            const Vec2 way_px = gather.radius / point.position.z *
                                Vec2(turn.across.x * scale.x, -turn.across.y * scale.y);
            closed += slice.weight() * gather.closed(slice, point, way_px, turn.jitter, turn.phase);
            whole += slice.weight();
        }
        if (whole > 0) occluded(x, y) = closed / whole;
    });
}

}  // namespace luch::techniques::ssao
