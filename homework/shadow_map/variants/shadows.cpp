#include "homework/shadow_map/variants/variants.h"

#include <cmath>

namespace luch::homework::shadow_map {
namespace {

using namespace techniques::shadow_map;

std::vector<Texel> texels_of(std::span<const Receiver> receivers, int n) {
    std::vector<Vec3> directions;
    for (const Receiver& receiver : receivers) directions.push_back(receiver.from_light);
    std::vector<Texel> texels(directions.size());
    reference().texel_of(directions, n, texels);
    return texels;
}

/// Squares are compared; receiver by receiver, the last first.
void lit_by_squares(const CubeMap& map, std::span<const Receiver> receivers,
                    std::span<const float> biases, std::span<float> shares) {
    for (std::size_t i = receivers.size(); i-- > 0;) {
        Texel texel;
        reference().texel_of({&receivers[i].from_light, 1}, map.n, {&texel, 1});
        const double reach = double(map.at(texel)) + biases[i];
        const Vec3d p(receivers[i].from_light);
        shares[i] = reach >= 0 && glm::dot(p, p) <= reach * reach ? 1.0f : 0.0f;
    }
}

/// The bias is taken from the distance, in double.
void lit_by_difference(const CubeMap& map, std::span<const Receiver> receivers,
                       std::span<const float> biases, std::span<float> shares) {
    const std::vector<Texel> texels = texels_of(receivers, map.n);
    std::ranges::fill(shares, 1.0f);
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const Vec3d p(receivers[i].from_light);
        const double distance = std::hypot(p.x, p.y, p.z);
        if (distance - biases[i] > map.at(texels[i])) shares[i] = 0;
    }
}

/// Face by face.
void lit_face_by_face(const CubeMap& map, std::span<const Receiver> receivers,
                      std::span<const float> biases, std::span<float> shares) {
    const std::vector<Texel> texels = texels_of(receivers, map.n);
    for (int face = faces_of_cube - 1; face >= 0; --face) {
        const auto& [window, image] = map.faces[static_cast<std::size_t>(face)];
        for (std::size_t i = 0; i < receivers.size(); ++i) {
            if (texels[i].face != face) continue;
            const Vec3& p = receivers[i].from_light;
            const float away = std::sqrt(std::fma(p.x, p.x, std::fma(p.y, p.y, p.z * p.z)));
            const int x = texels[i].x - window.x0, y = texels[i].y - window.y0;
            const bool stored = x >= 0 && y >= 0 && x < image.width() && y < image.height();
            const bool blocked = stored && away > image(x, y) + biases[i];
            shares[i] = blocked ? 0.0f : 1.0f;
        }
    }
}

/// Through the centres of neighbours, which may lie past the edge, as directions.
void pcf_by_directions(const CubeMap& map, std::span<const Receiver> receivers,
                       std::span<const float> biases, std::span<float> shares) {
    const int n = map.n;
    const std::vector<Texel> texels = texels_of(receivers, n);
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const auto& [face, x, y] = texels[i];
        std::vector<Vec3> directions;
        for (int v = y + 1; v >= y - 1; --v) {
            for (int u = x + 1; u >= x - 1; --u) {
                if ((u < 0 || u >= n) && (v < 0 || v >= n)) continue;
                Vec3 d;
                d[face / 2] = face % 2 == 0 ? 1.0f : -1.0f;
                d[(face / 2 + 1) % 3] = float(2 * u + 1) / float(n) - 1;
                d[(face / 2 + 2) % 3] = float(2 * v + 1) / float(n) - 1;
                directions.push_back(d);
            }
        }
        std::vector<Texel> around(directions.size());
        reference().texel_of(directions, n, around);
        const double distance = glm::length(Vec3d(receivers[i].from_light));
        int lit = 0;
        for (const Texel& texel : around) lit += distance <= double(map.at(texel)) + biases[i];
        shares[i] = float(lit) / float(around.size());
    }
}

/// A face with a rim of one texel, taken from its neighbours; NaN in its corners.
Image<float> with_rim(const CubeMap& map, int face) {
    const int n = map.n;
    Image<float> wide({n + 2, n + 2}, std::nanf(""));
    const auto put = [&](int x, int y) {
        // In thirds of texels a place just past the edge is still nearest to its own neighbour.
        Vec3d d;
        d[face / 2] = face % 2 == 0 ? n : -n;
        d[(face / 2 + 1) % 3] = x < 0 ? -n - 1 / 3.0 : x >= n ? n + 1 / 3.0 : 2 * x + 1 - n;
        d[(face / 2 + 2) % 3] = y < 0 ? -n - 1 / 3.0 : y >= n ? n + 1 / 3.0 : 2 * y + 1 - n;
        const Vec3 direction(d);
        Texel texel;
        reference().texel_of({&direction, 1}, n, {&texel, 1});
        wide(x + 1, y + 1) = map.at(texel);
    };
    for (int y = 0; y < n; ++y) {
        for (int x = -1; x <= n; ++x) put(x, y);
    }
    for (int x = 0; x < n; ++x) {
        put(x, -1);
        put(x, n);
    }
    return wide;
}

/// Two passes: faces get a rim, then nothing needs to be crossed.
void pcf_with_rims(const CubeMap& map, std::span<const Receiver> receivers,
                   std::span<const float> biases, std::span<float> shares) {
    std::vector<Image<float>> wide;
    for (int face = 0; face < faces_of_cube; ++face) wide.push_back(with_rim(map, face));
    const std::vector<Texel> texels = texels_of(receivers, map.n);
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const auto& [face, x, y] = texels[i];
        const float distance = glm::length(receivers[i].from_light);
        float mean = 0, count = 0;
        for (int u = 0; u < 3; ++u) {
            for (int v = 0; v < 3; ++v) {
                const float stored = wide[static_cast<std::size_t>(face)](x + u, y + v);
                if (std::isnan(stored)) continue;
                // A running mean.
                const float lit = distance > stored + biases[i] ? 0.0f : 1.0f;
                mean += (lit - mean) / ++count;
            }
        }
        shares[i] = mean;
    }
}

/// Nine passes over all receivers, a ninth or an eighth at a time.
void pcf_in_passes(const CubeMap& map, std::span<const Receiver> receivers,
                   std::span<const float> biases, std::span<float> shares) {
    const int n = map.n;
    std::vector<Image<float>> wide;
    for (int face = 0; face < faces_of_cube; ++face) wide.push_back(with_rim(map, face));
    const std::vector<Texel> texels = texels_of(receivers, n);
    std::vector<double> sums(receivers.size(), 0);
    for (int pass = 8; pass >= 0; --pass) {
        for (std::size_t i = 0; i < receivers.size(); ++i) {
            const auto& [face, x, y] = texels[i];
            const bool corner = (x == 0 || x == n - 1) && (y == 0 || y == n - 1);
            const float stored = wide[static_cast<std::size_t>(face)](x + pass % 3, y + pass / 3);
            const double distance = glm::length(Vec3d(receivers[i].from_light));
            const bool lit = distance <= double(stored) + biases[i];
            sums[i] += !std::isnan(stored) && lit ? 1.0 / (corner ? 8 : 9) : 0;
        }
    }
    for (std::size_t i = 0; i < sums.size(); ++i) shares[i] = static_cast<float>(sums[i]);
}

/// Cell by cell, column after column.
void points_by_columns(const RectLight& light, int n, Pattern pattern, Key key,
                       std::vector<LightPoint>& points) {
    int rows = static_cast<int>(std::sqrt(double(n)));
    while (n % rows != 0) --rows;
    const int columns = n / rows;
    points.assign(static_cast<std::size_t>(n), {Vec3d(0), float(1.0 / n)});
    for (int i = 0; i < n; ++i) {
        const auto number = static_cast<std::uint64_t>(i);
        const Vec2d drawn = key.square(number);
        double x = drawn.x, z = drawn.y;
        if (pattern != Pattern::random) {
            const bool regular = pattern == Pattern::regular;
            x = (i / rows + (regular ? 0.5 : x)) / columns;
            z = (i % rows + (regular ? 0.5 : z)) / rows;
        }
        points[number].position = lifted_off(light, x - 0.5, z - 0.5);
    }
}

/// Random numbers of its own, and lifted by its own hand.
void points_by_corners(const RectLight& light, int n, Pattern pattern, Key key,
                       std::vector<LightPoint>& points) {
    int rows = 1;
    for (int r = 1; r * r <= n; ++r) rows = n % r == 0 ? r : rows;
    const double columns = n / rows;
    const Vec3d corner = light.to_world.point({-0.5, 0, -0.5});
    const Vec3d across = light.to_world.direction({1, 0, 0});
    const Vec3d along = light.to_world.direction({0, 0, 1});
    points.clear();
    for (int row = 0; row < rows; ++row) {
        for (double column = 0; column < columns; ++column) {
            const Key own = key.branch(std::uint64_t(77 + row)).branch(std::uint64_t(column));
            double u = own.uniform(0), v = own.uniform(1);
            if (pattern == Pattern::regular) u = v = 0.5;
            if (pattern != Pattern::random) {
                u = (column + u) / columns;
                v = (row + v) / rows;
            }
            const double lift = 1e-12 * (glm::length(corner) + glm::length(across + along));
            points.push_back(
                {corner + u * across + v * along + lift * light.facing(), 1 / float(n)});
        }
    }
}

}  // namespace

std::vector<grading::Other> shadow_variants() {
    return {
        {"lit_by_squares", "shadow_map.t5", "squares compared, the last first",
         with(&Steps::lit, lit_by_squares)},
        {"lit_by_difference", "shadow_map.t5", "the bias taken from the distance, in double",
         with(&Steps::lit, lit_by_difference)},
        {"lit_face_by_face", "shadow_map.t5", "face by face, fused",
         with(&Steps::lit, lit_face_by_face)},
        {"pcf_by_directions", "shadow_map.t6", "neighbours found by their directions",
         with(&Steps::pcf, pcf_by_directions)},
        {"pcf_with_rims", "shadow_map.t6", "faces with rims first, a running mean",
         with(&Steps::pcf, pcf_with_rims)},
        {"pcf_in_passes", "shadow_map.t6", "nine passes, in double",
         with(&Steps::pcf, pcf_in_passes)},
        {"points_by_columns", "shadow_map.t7", "column by column",
         with(&Steps::light_points, points_by_columns)},
        {"points_by_corners", "shadow_map.t7", "other random numbers, another lift",
         with(&Steps::light_points, points_by_corners)},
    };
}

}  // namespace luch::homework::shadow_map
