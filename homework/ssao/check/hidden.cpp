// Task t4: the share of points that are hidden. Which turn a pixel takes is the solution's own
// affair, so means over many keys are held against the reference's.
#include "framework/grading/gates.h"
#include "homework/ssao/check/made.h"
#include "homework/ssao/check/same.h"
#include "homework/ssao/check/tests.h"

#include <fmt/format.h>

#include <cmath>

namespace luch::homework::ssao {
namespace {

using grading::Finding;

constexpr int keys = 16, block = 4;
/// Šidák's: 300 blocks that are right are all within this many standard errors but once in 10⁶
/// times.
constexpr double sigmas = 6;

Image<float> occlusion(const Steps& steps, const GBuffer& seen, const Screen& screen,
                       std::span<const Vec3> kernel, double radius, Key key) {
    Image<float> out(seen.position.size(), -7);
    steps.occlusion(seen, screen, kernel, {.radius = radius}, key, out.view().tile(), out.view());
    return out;
}

Image<float> occlusion(const Steps& steps, const Sample& sample, std::uint64_t key) {
    return occlusion(steps, sample.seen(), sample.screen(), sample.kernel, Sample::radius,
                     Key(key));
}

Image<float> mean_of(const Steps& steps, const Sample& sample) {
    Image<float> mean(sample.depth.size());
    for (std::uint64_t key = 0; key < keys; ++key) {
        const Image<float> one = occlusion(steps, sample, key);
        for (std::size_t i = 0; i < mean.pixels().size(); ++i) {
            mean.pixels()[i] += one.pixels()[i] / keys;
        }
    }
    return mean;
}

/// Sums over a tile of the frame.
struct Sums {
    double yours = 0, reference = 0, variance = 0;
    int pixels = 0;

    Sums(const Image<float>& mean, const Sample& sample, Tile tile) {
        for (int y = tile.y0; y < std::min(tile.y1, mean.height()); ++y) {
            for (int x = tile.x0; x < std::min(tile.x1, mean.width()); ++x) {
                yours += mean(x, y);
                reference += sample.mean(x, y);
                variance += sample.variance(x, y) * (1.0 / keys + 1.0 / turns_taken);
                ++pixels;
            }
        }
    }
    /// Besides chance there is rounding: a pixel in a hundred may see another surface.
    [[nodiscard]] bool agree(double rounding) const {
        return std::abs(yours - reference) <= sigmas * std::sqrt(variance) + rounding * pixels;
    }
};

/// Block by block, and all together: small mistakes that are made everywhere add up.
Finding as_much_as_the_reference(const Steps& steps, const Sample& sample) {
    const Image<float> mean = mean_of(steps, sample);
    Image<std::uint8_t> wrong(mean.size());
    for (int y = 0; y < mean.height(); y += block) {
        for (int x = 0; x < mean.width(); x += block) {
            const Sums sums(mean, sample, {x, y, x + block, y + block});
            if (!sums.agree(0.01)) wrong(x, y) = 1;
        }
    }
    Finding finding = unless_marked(wrong, "the mean of a block is another", mean, sample.mean);
    if (!finding.passed) return finding;
    const Sums sums(mean, sample, mean.view().tile());
    if (sums.agree(0.003)) return finding;
    finding = grading::failure("the mean of all pixels is another",
                               fmt::format("expected {:.4f}, got {:.4f}",
                                           sums.reference / sums.pixels, sums.yours / sums.pixels));
    finding.signature = {sums.yours > sums.reference ? 1u : 0u};
    return finding;
}

/// Fails where a pixel is not in between; `what` says why it should be.
Finding between(const Image<float>& yours, float least, float most, std::string_view what) {
    Image<std::uint8_t> wrong(yours.size());
    const Image<float> expected(yours.size(), most);
    for (std::size_t i = 0; i < wrong.pixels().size(); ++i) {
        if (!(yours.pixels()[i] >= least && yours.pixels()[i] <= most)) wrong.pixels()[i] = 1;
    }
    return unless_marked(wrong, what, yours, expected);
}

Image<float> of_made(const Steps& steps, const Made& made, const Sample& sample, double radius) {
    return occlusion(steps, made.seen(), made.screen, sample.kernel, radius, Key(5));
}

/// Nothing of a plane is hidden, however it is turned and wherever the camera looks.
Finding tilted_planes(const Steps& steps, const Sample& sample) {
    std::vector<Finding> findings;
    for (const double degrees : {0.0, 35.0, 60.0, 75.0}) {
        for (const double around : {0.0, 90.0, 200.0}) {
            findings.push_back(between(of_made(steps, Made({tilted(degrees, around)}), sample, 2),
                                       0, 0.01f, "a plane hides itself"));
        }
    }
    return grading::first_failure_of(std::move(findings));
}

/// A board far in front of a wall hides nothing of it: out of range.
Finding far_in_front(const Steps& steps, const Sample& sample) {
    return between(of_made(steps, Made({facing(110), facing(10, 0)}), sample, 5), 0, 0,
                   "a halo around what is far in front");
}

/// A wall whose left and right rims are nearer; seen from its middle, points are off the frame, or
/// on their way there. Who goes round to the other side finds a rim.
Finding beyond_the_frame(const Steps& steps, const Sample& sample) {
    Made made({facing(12)});
    for (int y = 0; y < 36; ++y) {
        for (int x = 0; x < 48; ++x) {
            if (x < 7 || x >= 41) made.position(x, y) *= 11.5f / 12;
        }
    }
    const double width = 48.0 * (made.position(24, 18).x - made.position(23, 18).x);
    const std::array points{Vec3(0.8f, 0, 0.04f)};
    double mean = 0;
    for (std::uint64_t key = 0; key < keys; ++key) {
        const Image<float> out =
            occlusion(steps, made.seen(), made.screen, points, 0.75 * width, Key(key));
        for (int k = 0; k < 16; ++k) mean += out(22 + k % 4, 16 + k / 4) / (16 * keys);
    }
    if (!(mean < 0.2)) {
        Finding finding = grading::failure("what is on the other side of the frame hides points",
                                           fmt::format("expected about 0.05, got {:.3f}", mean));
        finding.signature = {static_cast<std::uint32_t>(std::lround(10 * mean))};
        return finding;
    }
    return between(of_made(steps, made, sample, 1e9), 0, 1, "a huge radius: not in 0..1");
}

/// Points off the frame neither hide nor count. A board at the right; of two points that lie
/// opposite each other, one falls off the frame when the other one is behind the board.
Finding off_the_frame(const Steps& steps, const Sample&) {
    const Made wall({facing(12)});
    const double px = wall.position(1, 18).x - wall.position(0, 18).x;
    const Made made({facing(12), facing(11.5, (wall.position(4, 18).x - px / 2) * 11.5 / 12)});
    const std::array points{Vec3(0.8f, 0, 0.04f), Vec3(-0.8f, 0, 0.04f)};
    double mean = 0;
    for (std::uint64_t key = 0; key < keys; ++key) {
        const Image<float> out =
            occlusion(steps, made.seen(), made.screen, points, 6 * px, Key(key));
        for (int y = 10; y < 26; ++y) mean += out(1, y) / (16 * keys);
    }
    // Within some 50° of level all that counts is hidden.
    if (mean > 0.4 && mean < 0.72) return {};
    Finding finding = grading::failure("points off the frame are counted",
                                       fmt::format("expected about 0.56, got {:.3f}", mean));
    finding.signature = {static_cast<std::uint32_t>(std::lround(10 * mean))};
    return finding;
}

/// A corner is as dark on both sides.
Finding symmetric(const Steps& steps, const Sample& sample) {
    for (const double degrees : {0.0, 90.0}) {
        const Made made(corner(degrees));
        double first = 0, second = 0;
        for (std::uint64_t key = 0; key < keys; ++key) {
            const Image<float> out =
                occlusion(steps, made.seen(), made.screen, sample.kernel, 3, Key(key));
            for (int y = 8; y < 28; ++y) {
                for (int x = 14; x < 34; ++x) {
                    const bool one = degrees == 0 ? x < 24 : y < 18;
                    (one ? first : second) += out(x, y);
                }
            }
        }
        if (first > 0.9 * second && second > 0.9 * first && first > 0) continue;
        return grading::failure(
            "the two walls of a corner are not as dark as each other",
            fmt::format("{:.1f} and {:.1f} pixels are hidden", first / keys, second / keys));
    }
    return {};
}

Finding nothing_to_see(const Steps& steps, const Sample& sample) {
    const Made walls(corner(30));
    Made away = walls;
    for (Vec3& normal : away.normal.pixels()) normal = -normal;
    return grading::first_failure_of(
        {between(of_made(steps, Made(std::vector<FlatThing>{}), sample, 2), 0, 0, "in the sky"),
         between(of_made(steps, walls, sample, 1e-3), 0, 0, "the radius spans less than a pixel"),
         between(of_made(steps, walls, sample, 1e-30), 0, 0, "the radius spans less than a pixel"),
         between(of_made(steps, away, sample, 2), 0, 1, "normals face away: not in 0..1")});
}

/// The 16 turns of a block even out: its mean varies from key to key by 1/16 of a pixel's variance,
/// if they have nothing to do with one another, or less.
Finding turns(const Steps& steps, const Sample& sample) {
    const Size size = sample.depth.size();
    std::vector<Image<float>> all;
    for (std::uint64_t key = 0; key < keys; ++key) all.push_back(occlusion(steps, sample, key));
    double of_blocks = 0, of_pixels = 0;
    for (int y = 0; y + block <= size.height; y += block) {
        for (int x = 0; x + block <= size.width; x += block) {
            double sum = 0, squares = 0;
            for (const Image<float>& one : all) {
                double mean = 0;
                for (int k = 0; k < block * block; ++k) {
                    mean += one(x + k % block, y + k / block) / (block * block);
                }
                sum += mean;
                squares += mean * mean;
            }
            of_blocks += squares / keys - sum / keys * (sum / keys);
            for (int k = 0; k < block * block; ++k) {
                of_pixels += sample.variance(x + k % block, y + k / block) / (block * block);
            }
        }
    }
    if (of_blocks <= 0) return grading::failure("another key takes no other turns");
    if (of_blocks < 0.125 * of_pixels) return {};
    return grading::failure("the pixels of 4 × 4 take the same turn",
                            fmt::format("a block's mean varies by {:.2f} of a pixel's variance",
                                        of_blocks / of_pixels));
}

}  // namespace

grading::Task occlusion_task(const Samples& samples) {
    return {"ssao.t4",
            "occlusion: what hides what",
            {{"ssao.t4.as_much", 2, cases_of(samples, as_much_as_the_reference)},
             {"ssao.t4.tilted_planes", 1, cases_of(samples, tilted_planes)},
             {"ssao.t4.far_in_front", 1, cases_of(samples, far_in_front)},
             {"ssao.t4.beyond_the_frame", 1, cases_of(samples, beyond_the_frame)},
             {"ssao.t4.off_the_frame", 1, cases_of(samples, off_the_frame)},
             {"ssao.t4.symmetric", 1, cases_of(samples, symmetric)},
             {"ssao.t4.nothing_to_see", 1, cases_of(samples, nothing_to_see)},
             {"ssao.t4.turns", 1, cases_of(samples, turns)}}};
}

}  // namespace luch::homework::ssao
