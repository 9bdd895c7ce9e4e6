#include "scenes/generator/trees.h"

#include "framework/math/rng.h"

#include <cmath>
#include <map>
#include <numbers>

namespace luch::assets {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;

/// In lo..hi.
double between(const Key& key, std::uint64_t purpose, double lo, double hi) {
    return lo + (hi - lo) * key.uniform(purpose);
}

std::uint32_t add_point(Part& part, const Vec3d& point) {
    part.points.push_back(point);
    return static_cast<std::uint32_t>(part.points.size() - 1);
}

/// One mesh of one joint.
Model model_of(std::vector<Part> parts, std::vector<Paint> paints) {
    for (std::size_t i = 0; i < parts.size(); ++i) parts[i].paint = static_cast<int>(i);
    return {.meshes = {std::move(parts)},
            .paints = std::move(paints),
            .pictures = {},
            .joints = {{.mesh = 0}}};
}

/// Two unit vectors that stand on `along` and on one another.
std::array<Vec3d, 2> across(const Vec3d& along) {
    const Vec3d other = std::abs(along.y) < 0.9 ? Vec3d(0, 1, 0) : Vec3d(1, 0, 0);
    const Vec3d u = glm::normalize(glm::cross(along, other));
    return {u, glm::cross(along, u)};
}

/// A tapering stick that ends in a point.
void add_stick(Part& part, const Vec3d& from, const Vec3d& to, double radius, int sides) {
    const auto [u, v] = across(glm::normalize(to - from));
    const auto first = static_cast<std::uint32_t>(part.points.size());
    for (int i = 0; i < sides; ++i) {
        const double turn = full_turn * i / sides;
        add_point(part, from + radius * (std::cos(turn) * u + std::sin(turn) * v));
    }
    const std::uint32_t tip = add_point(part, to);
    for (int i = 0; i < sides; ++i) {
        part.triangles.push_back({first + i, first + (i + 1) % sides, tip});
    }
}

/// A branch: a spine that droops, with three rows of needles: left, right and hanging.
void add_branch(Part& part, const Vec3d& from, double turn, double length, double droop,
                const Key& key) {
    constexpr int segments = 12;
    const Vec3d out(std::cos(turn), 0, std::sin(turn)), side(-out.z, 0, out.x), down(0, -1, 0);
    std::uint32_t before = 0;
    for (int i = 0; i <= segments; ++i) {
        const double t = static_cast<double>(i) / segments;
        const Vec3d spine = from + length * (t * out + droop * t * t * down);
        const std::uint32_t here = add_point(part, spine);
        if (i > 0) {
            const double reach = length * 0.3 * (1.15 - t) * between(key, i, 0.8, 1.2);
            const Vec3d forward = spine + 0.35 * reach * out + 0.25 * reach * down;
            for (const Vec3d& to : {side, -side, 0.7 * down}) {
                part.triangles.push_back({before, here, add_point(part, forward + reach * to)});
            }
        }
        before = here;
    }
}

/// A leaf: a square that is folded a little along its diagonal.
void add_leaf(Part& part, const Vec3d& at, const Vec3d& out, double size, const Key& key) {
    const Vec3d tilt(between(key, 0, -0.7, 0.7), between(key, 1, -0.7, 0.7),
                     between(key, 2, -0.7, 0.7));
    const Vec3d normal = glm::normalize(out + tilt);
    const auto [u, v] = across(normal);
    const std::uint32_t a = add_point(part, at), b = add_point(part, at + size * u);
    const std::uint32_t c = add_point(part, at + size * (u + v) - 0.3 * size * normal);
    const std::uint32_t d = add_point(part, at + size * v);
    part.triangles.push_back({a, b, d});
    part.triangles.push_back({b, c, d});
}

/// Leaves near the surface of an ellipsoid, shared among the parts.
void add_cluster(std::vector<Part>& parts, std::size_t first, const Vec3d& centre,
                 const Vec3d& radius, int leaves, double size, const Key& key) {
    for (int i = 0; i < leaves; ++i) {
        const Key leaf = key.branch(i);
        const double z = between(leaf, 10, -0.75, 1), turn = between(leaf, 11, 0, full_turn);
        const double ring = std::sqrt(1 - z * z);
        const Vec3d out(ring * std::cos(turn), z, ring * std::sin(turn));
        const double depth = std::sqrt(between(leaf, 12, 0.45, 1));
        const std::size_t which = first + leaf.bits(13) % (parts.size() - first);
        add_leaf(parts[which], centre + depth * radius * out, out,
                 size * between(leaf, 14, 0.7, 1.3), leaf);
    }
}

}  // namespace

Model fir(std::uint64_t seed) {
    const Key key = Key(seed).branch(1);
    constexpr int whorls = 34;
    const double height = between(key, 0, 10, 12.5), spread = between(key, 1, 2.3, 2.9);
    Part trunk, dark, light;
    add_stick(trunk, {0, -0.5, 0}, {0, height, 0}, 0.24, 8);
    for (int i = 0; i < whorls; ++i) {
        const double t = static_cast<double>(i) / whorls;
        const Key whorl = key.branch(100 + i);
        const int branches = static_cast<int>(17 - 11 * t);
        const double start = between(whorl, 0, 0, full_turn);
        for (int k = 0; k < branches; ++k) {
            const Key branch = whorl.branch(k);
            const double length =
                (0.2 + spread * std::pow(1 - t, 0.8)) * between(branch, 20, 0.75, 1.1);
            const Vec3d from(0, 0.9 + (height - 1.1) * (t + between(branch, 21, 0, 0.02)), 0);
            const double turn = start + full_turn * (k + between(branch, 22, -0.3, 0.3)) / branches;
            add_branch(k % 3 == 0 ? light : dark, from, turn, length, 0.5 - 0.45 * t, branch);
        }
    }
    return model_of({trunk, dark, light},
                    {{{0.16, 0.09, 0.05}}, {{0.035, 0.10, 0.045}}, {{0.06, 0.16, 0.06}}});
}

Model broadleaf(std::uint64_t seed) {
    const Key key = Key(seed).branch(2);
    constexpr int clusters = 16, leaves = 410;
    std::vector<Part> parts(4);
    const Vec3d fork(between(key, 0, -0.2, 0.2), 3, between(key, 1, -0.2, 0.2));
    add_stick(parts[0], {0, -0.5, 0}, fork + Vec3d(0, 1.5, 0), 0.3, 10);
    for (int i = 0; i < clusters; ++i) {
        const Key bough = key.branch(100 + i);
        const double turn = full_turn * (i + between(bough, 0, -0.3, 0.3)) * 0.382;
        const double level = static_cast<double>(i) / (clusters - 1);
        const double out = (1 - 0.75 * level) * between(bough, 1, 1.7, 2.5);
        const Vec3d centre(out * std::cos(turn), 3.2 + 4.2 * level + between(bough, 2, -0.3, 0.3),
                           out * std::sin(turn));
        add_stick(parts[0], fork + Vec3d(0, 0.4 * level, 0), centre, 0.12, 6);
        const double size = between(bough, 3, 1.0, 1.4);
        add_cluster(parts, 1, centre, Vec3d(size, 0.75 * size, size), leaves, 0.2, bough);
    }
    // One in two is a tree of autumn's first days.
    const bool turning = seed % 2 == 1;
    return model_of(parts, {{{0.17, 0.12, 0.08}},
                            {turning ? Vec3d(0.42, 0.25, 0.04) : Vec3d(0.12, 0.26, 0.04)},
                            {turning ? Vec3d(0.50, 0.33, 0.06) : Vec3d(0.17, 0.32, 0.06)},
                            {turning ? Vec3d(0.33, 0.27, 0.05) : Vec3d(0.09, 0.21, 0.04)}});
}

Model bush(std::uint64_t seed) {
    const Key key = Key(seed).branch(3);
    constexpr int clusters = 6, leaves = 480;
    std::vector<Part> parts(3);
    for (int i = 0; i < clusters; ++i) {
        const Key bough = key.branch(100 + i);
        const double turn = full_turn * i / clusters,
                     out = i == 0 ? 0 : between(bough, 1, 0.4, 0.9);
        const Vec3d centre(out * std::cos(turn), between(bough, 2, 0.4, 0.8), out * std::sin(turn));
        add_stick(parts[0], {0, -0.3, 0}, centre, 0.05, 5);
        add_cluster(parts, 1, centre, Vec3d(0.75, 0.6, 0.75), leaves, 0.11, bough);
    }
    return model_of(parts, {{{0.12, 0.09, 0.06}}, {{0.10, 0.22, 0.05}}, {{0.16, 0.28, 0.07}}});
}

Model rock(std::uint64_t seed) {
    const Key key = Key(seed).branch(4);
    Part part;
    // An octahedron whose triangles are cut in four, four times: 8 · 4⁴.
    for (const Vec3d& p : {Vec3d(1, 0, 0), Vec3d(-1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, -1, 0),
                           Vec3d(0, 0, 1), Vec3d(0, 0, -1)}) {
        add_point(part, p);
    }
    part.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                      {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (int round = 0; round < 4; ++round) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, is_new] = middles.try_emplace(std::minmax(a, b), 0);
            if (is_new) {
                found->second = add_point(part, glm::normalize(part.points[a] + part.points[b]));
            }
            return found->second;
        };
        std::vector<Part::Triangle> finer;
        for (const auto& [a, b, c] : part.triangles) {
            const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            for (const Part::Triangle& t :
                 {Part::Triangle{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) {
                finer.push_back(t);
            }
        }
        part.triangles = std::move(finer);
    }
    // Waves in random directions make it a rock.
    for (Vec3d& p : part.points) {
        double radius = 0.8;
        for (int i = 0; i < 12; ++i) {
            const Key wave = key.branch(i);
            const Vec3d direction(between(wave, 0, -1, 1), between(wave, 1, -1, 1),
                                  between(wave, 2, -1, 1));
            const double pitch = 1.5 + i;
            radius += 0.22 / (1 + 0.7 * i) *
                      std::sin(pitch * glm::dot(direction, p) * 2 + full_turn * wave.uniform(3));
        }
        p *= radius * Vec3d(1, 0.7, 1);
    }
    return model_of({part}, {{{0.30, 0.29, 0.27}}});
}

}  // namespace luch::assets
