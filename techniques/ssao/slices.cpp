// The hemisphere in slices: half-planes through the view ray, in which what the picture shows
// closes angles. Jiménez, Wu, Pesce and Jarabo, "Practical Realtime Strategies for Accurate
// Indirect Occlusion", 2016; Therrien, Levesque and Gilet, "Screen Space Indirect Lighting with
// Visibility Bitmask", 2023.
#include "techniques/ssao/slices.h"

#include "techniques/ssao/view.h"

#include <bit>
#include <cmath>
#include <numbers>

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
        const Vec3 along = glm::normalize(across - glm::dot(across, to_eye) * to_eye);
        const float sine = glm::dot(normal, along), cosine = glm::dot(normal, to_eye);
        length_ = std::sqrt(sine * sine + cosine * cosine);
        if (!(length_ > 0)) return;
        sin_turn_ = sine / length_;
        cos_turn_ = cosine / length_;
        turn_ = angle_of(sine, cosine);
        tangent_ = cos_turn_ * along - sin_turn_ * to_eye;
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
        if (h <= 0) return a < 0 ? 0 : 1;
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
    Vec3 normal_, tangent_{0};
    float length_ = 0, turn_ = 0, sin_turn_ = 0, cos_turn_ = 1, whole_ = 1;
};

/// Sectors of equal weight; bit i stands for the place i + phase of 0..32.
std::uint32_t sectors_between(float from, float to, float phase) {
    const int first = static_cast<int>(std::ceil(from * sectors - phase));
    const int last = static_cast<int>(std::ceil(to * sectors - phase));
    const auto up_to = [](int i) {
        return i >= sectors ? ~std::uint32_t{0} : (std::uint32_t{1} << std::max(i, 0)) - 1;
    };
    return up_to(last) & ~up_to(first);
}

/// What is published for the fading of far occluders (XeGTAO, after Jiménez et al.).
struct Fade {
    float reach, share;
};
constexpr Fade published{1.457f, 0.615f}, none{1, 0};

/// What one pixel's slices have in common.
struct Gather {
    const GBuffer& seen;
    const Scale scale;
    const float radius, thickness;
    const Fade fade;
    const bool bits;

    /// The share of a slice that is closed. `step`: the screen's way of the radius, in pixels.
    float closed(const Slice& slice, int x, int y, const Vec2& step, float jitter,
                 float phase) const;
    [[nodiscard]] float faded(float distance) const {
        if (fade.share <= 0) return 1;
        return std::clamp((radius - distance) / (fade.share * radius), 0.0f, 1.0f);
    }
};

/// How much of a step from a pixel's centre stays in the frame: 0..1.
float inside(Size frame, int x, int y, const Vec2& step) {
    const auto along = [](float at, float way, float end) {
        return way > 0 ? (end - at) / way : way < 0 ? -at / way : 1.0f;
    };
    const float across = along(static_cast<float>(x) + 0.5f, step.x, float(frame.width));
    const float down = along(static_cast<float>(y) + 0.5f, step.y, float(frame.height));
    return std::min({1.0f, across, down});
}

float Gather::closed(const Slice& slice, int x, int y, const Vec2& step, float jitter,
                     float phase) const {
    constexpr int steps = samples_a_slice / 2;
    const Vec3 here = seen.position(x, y);
    const Vec3 normal = towards(-glm::normalize(here), seen.normal(x, y));
    std::uint32_t mask = 0;
    float low = 0, high = 0;  // closed from either tangent: gtao
    for (const float side : {1.0f, -1.0f}) {
        const Vec2 way_px = side * inside(seen.position.size(), x, y, side * step) * step;
        const float length_px = std::max(std::abs(way_px.x), std::abs(way_px.y));
        for (int i = 0; i < steps; ++i) {
            const float even = (static_cast<float>(i) + jitter) / steps;
            const float share = std::max(even * even, 1 / length_px);
            const int u =
                static_cast<int>(std::floor(static_cast<float>(x) + 0.5f + share * way_px.x));
            const int v =
                static_cast<int>(std::floor(static_cast<float>(y) + 0.5f + share * way_px.y));
            if (u < 0 || v < 0 || u >= seen.position.width() || v >= seen.position.height())
                continue;
            const Vec3 there = seen.position(u, v);
            if (!is_seen(there)) continue;
            const Vec3 way = there - here;
            const float squared = glm::dot(way, way), height = glm::dot(way, normal);
            if (squared > radius * radius || !stands_out(height, squared, here.z)) continue;
            const float front = slice.before(way);
            if (bits) {
                const float back = slice.before(way + (thickness / glm::length(there)) * there);
                mask |= sectors_between(std::min(front, back), std::max(front, back), phase);
            } else {
                const float weight = faded(std::sqrt(squared));
                float& side_closed = side > 0 ? high : low;
                side_closed = std::max(side_closed, weight * (side > 0 ? 1 - front : front));
            }
        }
    }
    return bits ? static_cast<float>(std::popcount(mask)) / sectors : std::min(low + high, 1.0f);
}

}  // namespace

void slices(const GBuffer& seen, const Screen& screen, const Params& params, Key key, Tile tile,
            ImageView<float> occluded) {
    const Fade fade = params.fade ? published : none;
    const Gather gather{seen,
                        Scale(screen),
                        static_cast<float>(params.radius) * fade.reach,
                        static_cast<float>(params.thickness * params.radius),
                        fade,
                        Mode(params.mode) != Mode::gtao};
    const int count = std::max(1, params.samples / samples_a_slice);
    const auto shift = static_cast<float>(key.uniform(0)),
               other = static_cast<float>(key.uniform(1));
    each_pixel(tile, [&](int x, int y) {
        occluded(x, y) = 0;
        const Vec3 here = seen.position(x, y);
        if (!is_seen(here) || !(gather.scale.px(gather.radius, here.z) >= 1)) return;
        const Vec3 to_eye = -glm::normalize(here);
        const Vec3 normal = towards(to_eye, seen.normal(x, y));
        if (normal == Vec3(0)) return;
        const int turn = turn_of(x, y);
        float closed = 0, whole = 0;
        for (int i = 0; i < count; ++i) {
            const float place = static_cast<float>(i) + (static_cast<float>(turn) + shift) / 16;
            const float angle = pi * place / static_cast<float>(count);
            const Vec3 across(std::cos(angle), std::sin(angle), 0);
            const Slice slice(to_eye, normal, across);
            if (!(slice.weight() > 0)) continue;
            const Vec2 step = gather.radius / here.z *
                              Vec2(across.x * gather.scale.x, -across.y * gather.scale.y);
            // Golden ratios lead a slice's samples, and its sectors, on from those of the last.
            const float jitter =
                glm::fract(static_cast<float>((turn * 5 + i * 7) % 16) / 16 + other);
            const float phase = 0.02f + 0.96f * glm::fract(jitter * 7 + 0.618034f * place);
            closed += slice.weight() * gather.closed(slice, x, y, step, jitter, phase);
            whole += slice.weight();
        }
        if (whole > 0) occluded(x, y) = closed / whole;
    });
}

}  // namespace luch::techniques::ssao
