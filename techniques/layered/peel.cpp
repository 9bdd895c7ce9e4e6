#include "techniques/layered/peel.h"

#include "framework/technique/samples.h"

#include <algorithm>

namespace luch::techniques::layered {
namespace {

constexpr int block = 8;

/// What a texel's key is used for: as the baseline's.
constexpr std::uint64_t radiance = 1;

/// No more surfaces are looked for behind one another, and no more kept.
constexpr int most_crossings = 16, most_kept = 3;

/// Just beyond a hit, in t: more than its rounding.
constexpr float beyond_it = 1 + 0x1p-18f;

}  // namespace

Openings::Openings(ImageView<const float> depth, const Lens& lens, int detail)
    : radius_(depth.size()),
      opens_({(depth.width() + block - 1) / block, (depth.height() + block - 1) / block}),
      seen_(opens_.size(), std::numeric_limits<float>::infinity()) {
    for (int y = 0; y < depth.height(); ++y) {
        for (int x = 0; x < depth.width(); ++x) {
            radius_(x, y) = static_cast<float>(signed_radius_px(depth(x, y), lens));
        }
    }
    find(radius_, detail);
    spread();
}

void Openings::find(const Image<float>& radius, int detail) {
    const auto edge = [&](int x, int y, float other) {
        const float here = radius(x, y);
        if (!(std::abs(here - other) > gap_px)) return;
        Opening& opening = opens_(x / block, y / block);
        opening.reach = std::max(opening.reach, std::abs(here - other) * float(detail));
        opening.farthest = std::min({opening.farthest, here, other});
    };
    for (int y = 0; y < radius.height(); ++y) {
        for (int x = 0; x < radius.width(); ++x) {
            if (x > 0) edge(x, y, radius(x - 1, y));
            if (y > 0) edge(x, y, radius(x, y - 1));
        }
    }
}

void Openings::spread() {
    for (int y = 0; y < opens_.height(); ++y) {
        for (int x = 0; x < opens_.width(); ++x) {
            const Opening& opening = opens_(x, y);
            if (!(opening.reach > 0)) continue;
            const int wide = opens_.width() + opens_.height();
            const int reach = std::min(1 + static_cast<int>(opening.reach / block), wide);
            for (int j = std::max(y - reach, 0); j <= std::min(y + reach, seen_.height() - 1);
                 ++j) {
                for (int i = std::max(x - reach, 0); i <= std::min(x + reach, seen_.width() - 1);
                     ++i) {
                    seen_(i, j) = std::min(seen_(i, j), opening.farthest);
                }
            }
        }
    }
}

std::optional<double> Openings::farthest(int x, int y) const {
    const float seen = seen_(x / block, y / block);
    if (!(seen < radius_(x, y) - gap_px)) return std::nullopt;
    return seen;
}

Peeler::Peeler(const Scene& scene, const Shot& fine, const Lens& lens, const Needs& needs,
               Tracer& tracer)
    : scene_(&scene),
      fine_(&fine),
      lens_(&lens),
      screen_(fine.camera, fine.size),
      whitted_(scene, needs, tracer),
      needs_(needs),
      tracer_(&tracer) {}

float Peeler::depth_of(const Ray& ray, const Hit& hit) const {
    if (!hit) return std::numeric_limits<float>::infinity();
    return static_cast<float>(hit.t * glm::dot(ray.direction, screen_.forward()));
}

void Peeler::keep(int x, int y, int index, const Ray& ray, const Hit& hit, Peeled& found) const {
    found.texels.emplace_back(x, y);
    found.hidden.push_back({.depth = depth_of(ray, hit)});
    found.rays.push_back(ray);
    found.hits.push_back(hit);
    found.keys.push_back(sample_key(*fine_, x, y, 1 + index).branch(radiance));
}

void Peeler::peel(int x, int y, const Hit& front, double deepest, Peeled& found) const {
    const Ray ray = screen_.ray(x + 0.5, y + 0.5);
    std::vector<NodeId> inside;
    Hit hit = front;
    double last = signed_radius_px(depth_of(ray, hit), *lens_);
    int kept = 0;
    for (int i = 0; i < most_crossings && hit && kept < most_kept; ++i) {
        // Not counted: which side of a surface was met is no shading.
        if (surface_at(*scene_, ray, hit).front) inside.push_back(hit.node);
        Ray on = ray;
        on.t_min = hit.t * beyond_it;
        hit = tracer_->closest(RayKind::primary, on);
        const double radius = signed_radius_px(depth_of(ray, hit), *lens_);
        const auto entered = std::ranges::find(inside, hit.node);
        if (hit && entered != inside.end() && !surface_at(*scene_, ray, hit).front) {
            inside.erase(entered);
            continue;
        }
        if (!(radius < last - Openings::gap_px)) continue;
        if (kept > 0) found.hidden.back().last = false;
        keep(x, y, kept, ray, hit, found);
        ++kept;
        last = radius;
        if (radius <= deepest + Openings::gap_px) return;
    }
}

void Peeler::beyond(int x, int y, float depth, Peeled& found) const {
    Ray ray = screen_.ray(x + 0.5, y + 0.5);
    ray.t_min = static_cast<float>(depth / glm::dot(ray.direction, screen_.forward()));
    keep(x, y, 0, ray, tracer_->closest(RayKind::primary, ray), found);
}

void Peeler::shade(Peeled& found) const {
    const std::size_t first = found.lit, count = found.rays.size() - first;
    if (count == 0) return;
    std::vector<Rgb> light(count);
    const auto rest = [&](const auto& all) { return std::span(all).subspan(first); };
    whitted_.shade(RayKind::primary, rest(found.rays), rest(found.hits), rest(found.keys), light);
    for (std::size_t i = 0; i < count; ++i) found.hidden[first + i].colour = light[i];
    found.lit = found.rays.size();
}

}  // namespace luch::techniques::layered
