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

/// What would be found by going round to the other side of the frame, or on along its border.
Finding beyond_the_frame(const Steps& steps, const Sample& sample) {
    // A side wall at the left only.
    const Made made({facing(12), {{1, 0, 0}, -6.5}});
    const Image<float> out = of_made(steps, made, sample, 4);
    Image<std::uint8_t> wrong(out.size());
    for (int y = 0; y < out.height(); ++y) {
        for (int x = 3 * out.width() / 4; x < out.width(); ++x) wrong(x, y) = out(x, y) != 0;
    }
    Finding finding = unless_marked(wrong, "the wall on the other side of the frame hides points",
                                    out, Image<float>(out.size(), 0));
    if (!finding.passed) return finding;
    return between(of_made(steps, made, sample, 1e9), 0, 1, "a huge radius: not in 0..1");
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

/// The 16 turns of a block even out: means of blocks vary less than a single pixel's mean of 16
/// keys would with one turn for all.
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
    if (of_blocks < 0.25 * of_pixels) return {};
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
             {"ssao.t4.nothing_to_see", 1, cases_of(samples, nothing_to_see)},
             {"ssao.t4.turns", 1, cases_of(samples, turns)}}};
}

}  // namespace luch::homework::ssao
