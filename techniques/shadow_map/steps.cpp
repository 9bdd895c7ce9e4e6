// The lecture's steps, in its order. Williams, "Casting Curved Shadows on Curved Surfaces",
// SIGGRAPH 1978; Reeves, Salesin and Cook, "Rendering Antialiased Shadows with Depth Maps",
// SIGGRAPH 1987.
#include "framework/baseline/tile_rays.h"
#include "techniques/shadow_map/cube.h"

#include <algorithm>
#include <cmath>

namespace luch::techniques::shadow_map {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

int cell_of(float u, int n) {
    const float place = (u + 1) / 2 * static_cast<float>(n);
    return std::clamp(static_cast<int>(std::floor(place)), 0, n - 1);
}

void texel_of(std::span<const Vec3> directions, int n, std::span<Texel> texels) {
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const Vec3& d = directions[i];
        texels[i] = {0, n / 2, n / 2};
        if (!all_finite(d) || d == Vec3(0)) continue;
        const int face = face_of(d);
        const float largest = std::abs(d[main_axis(face)]);
        texels[i] = {face, cell_of(d[x_axis(face)] / largest, n),
                     cell_of(d[y_axis(face)] / largest, n)};
    }
}

void direction_of(std::span<const Texel> texels, int n, std::span<Vec3> directions) {
    for (std::size_t i = 0; i < texels.size(); ++i) {
        const auto& [face, x, y] = texels[i];
        Vec3 d;
        d[main_axis(face)] = face % 2 == 1 ? -1.0f : 1.0f;
        d[x_axis(face)] = static_cast<float>(2 * x + 1) / static_cast<float>(n) - 1;
        d[y_axis(face)] = static_cast<float>(2 * y + 1) / static_cast<float>(n) - 1;
        directions[i] = glm::normalize(d);
    }
}

/// Directions have length 1, so a ray's t is a distance. Texels go in the order of packets: the
/// rays of neighbours are quick together.
void render_face(const Vec3d& light, int face, int n, Tile tile, Tracer& tracer,
                 ImageView<float> distance) {
    std::vector<Texel> texels;
    for_each_pixel(tile, [&](int x, int y) { texels.push_back({face, x, y}); });
    std::vector<Vec3> directions(texels.size());
    direction_of(texels, n, directions);
    std::vector<Ray> rays;
    for (const Vec3& d : directions) rays.push_back({light, Vec3d(d)});
    std::vector<Hit> hits(rays.size());
    tracer.closest(RayKind::shadow, rays, hits);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        distance(texels[i].x - tile.x0, texels[i].y - tile.y0) = hits[i] ? hits[i].t : infinite;
    }
}

/// On the plane n·x = n·p, the point along q = (u, v, 1) is at the distance D = (n·p)|q|/(n·q).
/// Where q points to p, ∂D/∂u = |p| (u/|q|² − n_u/(n·q)), and ∂D/∂v likewise. D curves upwards
/// (it is no less than its tangent at the receiver), so no centre of a texel falls shorter than
/// this says; a tangent at the centre would promise too little.
void bias(std::span<const Receiver> receivers, int n, std::span<float> biases) {
    const float half = 1 / static_cast<float>(n);  // of a texel
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const Vec3 &p = receivers[i].from_light, &normal = receivers[i].normal;
        const float distance = glm::length(p);
        biases[i] = 0;
        if (!(distance > 0)) continue;
        const int face = face_of(p);
        const Vec3 q = p / std::abs(p[main_axis(face)]);
        const float along = glm::dot(normal, q), squared = glm::dot(q, q);
        const auto slope = [&](int axis) {
            return std::abs(q[axis] / squared - normal[axis] / along);
        };
        const float steepness = along != 0 ? slope(x_axis(face)) + slope(y_axis(face)) : infinite;
        biases[i] = distance * (half * steepness + rounding_share);
    }
}

float lit(const CubeMap& map, const Texel& texel, float distance, float bias) {
    return distance <= map.at(texel) + bias ? 1.0f : 0.0f;
}

std::vector<Texel> texels_of(std::span<const Receiver> receivers, int n) {
    std::vector<Vec3> directions;
    for (const Receiver& receiver : receivers) directions.push_back(receiver.from_light);
    std::vector<Texel> texels(directions.size());
    texel_of(directions, n, texels);
    return texels;
}

void lit(const CubeMap& map, std::span<const Receiver> receivers, std::span<const float> biases,
         std::span<float> shares) {
    const std::vector<Texel> texels = texels_of(receivers, map.n);
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const float distance = glm::length(receivers[i].from_light);
        shares[i] = lit(map, texels[i], distance, biases[i]);
    }
}

/// Past an edge of the face, or of what is stored of it: texel by texel.
float pcf_at_rim(const CubeMap& map, const Texel& texel, float distance, float bias) {
    float sum = 0, count = 0;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const auto there = folded({texel.face, texel.x + dx, texel.y + dy}, map.n);
            if (!there) continue;
            sum += lit(map, *there, distance, bias);
            count += 1;
        }
    }
    return sum / count;
}

void pcf(const CubeMap& map, std::span<const Receiver> receivers, std::span<const float> biases,
         std::span<float> shares) {
    const std::vector<Texel> texels = texels_of(receivers, map.n);
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const float distance = glm::length(receivers[i].from_light);
        const auto& [window, stored] = map.faces[static_cast<std::size_t>(texels[i].face)];
        const int x = texels[i].x - window.x0, y = texels[i].y - window.y0;
        if (x < 1 || y < 1 || x + 1 >= stored.width() || y + 1 >= stored.height()) {
            shares[i] = pcf_at_rim(map, texels[i], distance, biases[i]);
            continue;
        }
        int sum = 0;
        const float* row = &stored(x - 1, y - 1);
        for (int dy = 0; dy < 3; ++dy, row += stored.width()) {
            for (int dx = 0; dx < 3; ++dx) sum += distance <= row[dx] + biases[i] ? 1 : 0;
        }
        shares[i] = static_cast<float>(sum) / 9;
    }
}

/// The largest divisor that is no larger than the root.
int rows_of(int n) {
    int rows = 1;
    for (int r = 2; r <= n / r; ++r) {
        if (n % r == 0) rows = r;
    }
    return rows;
}

void light_points(const RectLight& light, int n, Pattern pattern, Key key,
                  std::vector<LightPoint>& points) {
    points.clear();
    const int rows = rows_of(n), columns = n / rows;
    for (int i = 0; i < n; ++i) {
        const auto number = static_cast<std::uint64_t>(i);
        const Vec2d inside = pattern == Pattern::regular ? Vec2d(0.5) : key.square(number);
        const Vec2d corner =
            pattern == Pattern::random ? Vec2d(0) : Vec2d(i % columns, i / columns);
        const Vec2d cells = pattern == Pattern::random ? Vec2d(1) : Vec2d(columns, rows);
        const Vec2d place = (corner + inside) / cells - 0.5;
        points.push_back({lifted_off(light, place.x, place.y), 1.0f / static_cast<float>(n)});
    }
}

}  // namespace

Steps reference() {
    return {texel_of, direction_of, render_face, bias, lit, pcf, light_points};
}

Vec3d lifted_off(const RectLight& light, double x, double z) {
    const Vec3d place = light.to_world.point({x, 0, z});
    return place + 0x1p-44 * (max_norm(place) + max_norm(light.to_world.matrix)) * light.facing();
}

}  // namespace luch::techniques::shadow_map
