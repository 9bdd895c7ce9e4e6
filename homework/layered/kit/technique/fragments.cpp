#include "techniques/layered/fragments.h"

#include "framework/technique/samples.h"
#include "framework/trace/surface.h"
#include "framework/trace/whitted.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>

namespace luch::techniques::layered {
namespace {

/// What a pixel's key is used for: as the baseline's.
constexpr std::uint64_t radiance = 1;

/// No more surfaces are looked for behind one another, and no more kept.
constexpr int most_crossings = 16, most_kept = 3;

/// Just beyond a hit, in t: more than its rounding.
constexpr float beyond_it = 1 + 0x1p-18f;

/// What rays through pixels meet, and its light.
struct Sight {
    const Shot* shot;
    Screen screen;
    std::vector<Ray> rays;
    std::vector<Hit> hits;
    std::vector<Key> keys;

    explicit Sight(const Shot& seen) : shot(&seen), screen(sharp(seen.camera), seen.size) {}

    static Camera sharp(Camera camera) {
        camera.depth_of_field = false;
        return camera;
    }
    [[nodiscard]] Ray ray(int x, int y) const { return screen.ray(x + 0.5, y + 0.5); }
    [[nodiscard]] float depth(std::size_t i) const {
        if (!hits[i]) return std::numeric_limits<float>::infinity();
        return static_cast<float>(hits[i].t * glm::dot(rays[i].direction, screen.forward()));
    }
    /// sample: 0 for what is in front, then counted from there.
    void keep(int x, int y, int sample, const Ray& ray, const Hit& hit) {
        rays.push_back(ray);
        hits.push_back(hit);
        keys.push_back(sample_key(*shot, x, y, sample).branch(radiance));
    }
    [[nodiscard]] std::vector<Rgb> light(const Whitted& whitted) const {
        std::vector<Rgb> colours(rays.size());
        whitted.shade(RayKind::primary, rays, hits, keys, colours);
        return colours;
    }
};

/// A ray that entered a solid does not keep its far wall, which is seen from inside only.
void cross(const Scene& scene, int x, int y, const Hit& front, Tracer& tracer, Sight& sight) {
    const Ray ray = sight.ray(x, y);
    std::vector<NodeId> inside;
    Hit hit = front;
    int kept = 0;
    for (int i = 0; i < most_crossings && hit && kept < most_kept; ++i) {
        if (surface_at(scene, ray, hit).front) inside.push_back(hit.node);
        Ray on = ray;
        on.t_min = hit.t * beyond_it;
        hit = tracer.closest(RayKind::primary, on);
        const auto entered = std::ranges::find(inside, hit.node);
        if (hit && entered != inside.end() && !surface_at(scene, ray, hit).front) {
            inside.erase(entered);
        } else {
            sight.keep(x, y, ++kept, ray, hit);
        }
    }
}

}  // namespace

void Fragments::see_front(const Shot& shot, const Needs& needs, Context& context) {
    hits_ = Image<Hit>(shot.size);
    colour_ = Image<Rgb>(shot.size);
    depth_ = Image<float>(shot.size);
    first_ = Image<std::uint32_t>(shot.size, none);
    hidden_.clear();
    context.for_each_tile(shot.size, [&](Tile tile, int worker) {
        Tracer& tracer = context.tracer(worker);
        Sight sight(shot);
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) sight.keep(x, y, 0, sight.ray(x, y), {});
        }
        tracer.closest(RayKind::primary, sight.rays, sight.hits);
        const std::vector<Rgb> light = sight.light(Whitted(*scene_, needs, tracer));
        for (std::size_t i = 0; i < light.size(); ++i) {
            const int width = tile.x1 - tile.x0, at = static_cast<int>(i);
            const int x = tile.x0 + at % width, y = tile.y0 + at / width;
            hits_(x, y) = sight.hits[i];
            colour_(x, y) = light[i];
            depth_(x, y) = sight.depth(i);
        }
    });
}

template <class Peel>
void Fragments::peel(const Shot& shot, const Needs& needs, Context& context,
                     const Peel& peel_pixel) {
    std::fill(first_.pixels().begin(), first_.pixels().end(), none);
    hidden_.clear();
    std::mutex one_at_a_time;
    context.for_each_tile(shot.size, [&](Tile tile, int worker) {
        Tracer& tracer = context.tracer(worker);
        Sight sight(shot);
        std::vector<std::size_t> ends;
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                peel_pixel(x, y, tracer, sight);
                ends.push_back(sight.rays.size());
            }
        }
        const std::vector<Rgb> light = sight.light(Whitted(*scene_, needs, tracer));
        const std::lock_guard lock(one_at_a_time);
        std::size_t i = 0, pixel = 0;
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                const std::size_t end = ends[pixel++];
                if (i < end) first_(x, y) = static_cast<std::uint32_t>(hidden_.size());
                for (; i < end; ++i) hidden_.push_back({light[i], sight.depth(i), i + 1 == end});
            }
        }
    });
}

void Fragments::see_behind(const Shot& shot, const Needs& needs, Context& context) {
    peel(shot, needs, context, [&](int x, int y, Tracer& tracer, Sight& sight) {
        cross(*scene_, x, y, hits_(x, y), tracer, sight);
    });
}

void Fragments::see_beyond(float depth, const Shot& shot, const Needs& needs, Context& context) {
    peel(shot, needs, context, [&](int x, int y, Tracer& tracer, Sight& sight) {
        if (!(depth_(x, y) < depth) || !std::isfinite(depth)) return;
        Ray ray = sight.ray(x, y);
        ray.t_min = static_cast<float>(depth / glm::dot(ray.direction, sight.screen.forward()));
        sight.keep(x, y, 1, ray, tracer.closest(RayKind::primary, ray));
    });
}

}  // namespace luch::techniques::layered
