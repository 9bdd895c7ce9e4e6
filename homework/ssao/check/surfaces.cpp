// Tasks t1 and t2: where surfaces are, and where they face.
#include "framework/grading/gates.h"
#include "homework/ssao/check/made.h"
#include "homework/ssao/check/same.h"
#include "homework/ssao/check/tests.h"

#include <fmt/format.h>

#include <cmath>

namespace luch::homework::ssao {
namespace {

using grading::Finding;

constexpr float infinite = std::numeric_limits<float>::infinity();

Image<Vec3> positions(const Steps& steps, const Image<float>& depth, const Screen& screen) {
    Image<Vec3> position(depth.size(), Vec3(-7));
    steps.positions(depth.view(), screen, depth.view().tile(), position.view());
    return position;
}

Finding camera_space(const Steps& steps, const Sample& sample) {
    return same_vectors(positions(steps, sample.depth, sample.screen()), sample.position,
                        "the position of pixel");
}

Finding nothing_seen(const Steps& steps, const Sample& sample) {
    Image<float> depth = sample.depth;
    Image<Vec3> expected = sample.position;
    const std::array odd{infinite, 0.0f, -3.0f, std::nanf(""), -infinite};
    for (int i = 0; i < 5; ++i) {
        depth(4 * i + 3, 20) = odd[static_cast<std::size_t>(i)];
        expected(4 * i + 3, 20) = {0, 0, infinite};
    }
    return same_vectors(positions(steps, depth, sample.screen()), expected,
                        "the position of pixel");
}

Finding in_tiles(const Steps& steps, const Sample& sample) {
    Image<Vec3> position(sample.depth.size(), Vec3(-1)), expected = position;
    const Tile tile{7, 5, 23, 21};
    steps.positions(sample.depth.view(), sample.screen(), tile, position.view());
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) expected(x, y) = sample.position(x, y);
    }
    return same_vectors(position, expected, "what was written of pixel");
}

Image<Vec3> normals(const Steps& steps, const Image<Vec3>& position) {
    Image<Vec3> normal(position.size(), Vec3(-7));
    steps.normals(position.view(), position.view().tile(), normal.view());
    return normal;
}

/// Holds normals where `counts` says against what they are, by their angle.
template <class Counts>
Finding same_normals(const Image<Vec3>& yours, const Image<Vec3>& reference, Counts&& counts) {
    Image<std::uint8_t> wrong(yours.size());
    Image<float> up(yours.size()), expected(yours.size());
    for (int y = 0; y < yours.height(); ++y) {
        for (int x = 0; x < yours.width(); ++x) {
            const Vec3 &a = yours(x, y), &b = reference(x, y);
            // The part that is worst off tells in the report.
            const Vec3 off = glm::abs(a - b);
            const int k = off.x > off.y && off.x > off.z ? 0 : off.y > off.z ? 1 : 2;
            up(x, y) = a[k];
            expected(x, y) = b[k];
            if (counts(x, y) && !(glm::length(a - b) < 0.03f)) wrong(x, y) = 1;
        }
    }
    return unless_marked(wrong, "the normal is off by more than 0.03", up, expected);
}

/// Whether a pixel and its neighbours in both directions are seen and lie on its tangent plane.
bool is_flat(const GBuffer& seen, int x, int y, int reach) {
    const Vec3 here = seen.position(x, y);
    for (int i = -reach; i <= reach; ++i) {
        for (const auto& [u, v] : {std::pair(x + i, y), {x, y + i}}) {
            if (u < 0 || v < 0 || u >= seen.position.width() || v >= seen.position.height()) {
                continue;
            }
            if (!is_seen(seen.position(u, v))) return false;
            const float off = std::abs(glm::dot(seen.normal(x, y), seen.position(u, v) - here));
            if (off > 2e-4f * here.z) return false;
        }
    }
    return true;
}

Finding of_flat_things(const Steps& steps, const Sample& sample) {
    return same_normals(normals(steps, sample.position), sample.normal, [&](int x, int y) {
        return is_seen(sample.position(x, y)) && is_flat(sample.seen(), x, y, 2);
    });
}

/// All are of unit length and face the eye; none where nothing is seen.
Finding facing_the_eye(const Steps& steps, const Sample& sample) {
    const Image<Vec3> normal = normals(steps, sample.position);
    Image<std::uint8_t> wrong(normal.size());
    Image<float> length(normal.size()), expected(normal.size());
    for (std::size_t i = 0; i < wrong.pixels().size(); ++i) {
        const Vec3 &n = normal.pixels()[i], &p = sample.position.pixels()[i];
        length.pixels()[i] = glm::length(n);
        expected.pixels()[i] = is_seen(p) ? 1 : 0;
        const bool fits = std::abs(length.pixels()[i] - expected.pixels()[i]) < 1e-3f;
        const bool away = is_seen(p) && !(glm::dot(n, p) <= 1e-3f * glm::length(p));
        if (!fits || away) wrong.pixels()[i] = 1;
    }
    return unless_marked(wrong, "the normal has no unit length, or faces away", length, expected);
}

/// A board before a tilted wall: beside its edge, the step to the other side is one of neither.
Finding beside_an_edge(const Steps& steps, const Sample& sample) {
    const double tilt = 20 + 4 * sample.position(20, 25).x;
    const Made made({tilted(tilt, 90), facing(3, 0.1)});
    return same_normals(normals(steps, made.position), made.normal, [](int, int) { return true; });
}

/// Alone among nothing there is nothing to tell but where the eye is.
Finding alone(const Steps& steps, const Sample& sample) {
    Image<Vec3> position({5, 5}, Vec3(0, 0, infinite)), expected({5, 5}, Vec3(0));
    position(2, 2) = sample.position(20, 25);
    expected(2, 2) = -glm::normalize(position(2, 2));
    return same_normals(normals(steps, position), expected, [](int, int) { return true; });
}

}  // namespace

std::vector<grading::Case> cases_of(const Samples& samples, SampleTest test) {
    std::vector<grading::Case> cases;
    for (const auto& sample : samples) {
        cases.push_back({sample->name, sample->scene_file, [sample, test](const std::any& steps) {
                             return test(*std::any_cast<Steps>(&steps), *sample);
                         }});
    }
    return cases;
}

grading::Task positions_task(const Samples& samples) {
    return {"ssao.t1",
            "positions: from depths",
            {{"ssao.t1.camera_space", 2, cases_of(samples, camera_space)},
             {"ssao.t1.nothing_seen", 1, cases_of(samples, nothing_seen)},
             {"ssao.t1.in_tiles", 1, cases_of(samples, in_tiles)}}};
}

grading::Task normals_task(const Samples& samples) {
    return {"ssao.t2",
            "normals: from positions",
            {{"ssao.t2.of_flat_things", 1, cases_of(samples, of_flat_things)},
             {"ssao.t2.facing_the_eye", 1, cases_of(samples, facing_the_eye)},
             {"ssao.t2.beside_an_edge", 1, cases_of(samples, beside_an_edge)},
             {"ssao.t2.alone", 1, cases_of(samples, alone)}}};
}

}  // namespace luch::homework::ssao
