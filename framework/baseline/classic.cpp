#include "framework/baseline/classic.h"

#include <algorithm>

namespace luch {
namespace {

// What a sample's key is used for.
enum Purpose : std::uint64_t { position_in_pixel, radiance };

bool has_texture(const Material& material) {
    if (const auto* lambert = std::get_if<Lambert>(&material))
        return lambert->texture != no_texture;
    if (const auto* phong = std::get_if<Phong>(&material)) return phong->texture != no_texture;
    if (const auto* layered = std::get_if<Layered>(&material)) {
        return std::any_of(layered->layers.begin(), layered->layers.end(),
                           [](const auto& layer) { return layer.texture != no_texture; });
    }
    return false;
}

Stage stage(std::string name, bool needed, std::string because_needed, std::string because_not,
            Stage::Kind kind = Stage::exact) {
    return {std::move(name), needed, kind,
            needed ? std::move(because_needed) : std::move(because_not)};
}

/// Whether a pixel stands out from its four neighbours, or one of them does.
bool is_edge(ImageView<const Rgb> image, int x, int y) {
    const auto clamped = [&](int i, int j) {
        return glm::min(
            image(std::clamp(i, 0, image.width() - 1), std::clamp(j, 0, image.height() - 1)),
            Rgb(1));
    };
    const std::array cross{clamped(x, y), clamped(x - 1, y), clamped(x + 1, y), clamped(x, y - 1),
                           clamped(x, y + 1)};
    const Rgb mean = (cross[0] + cross[1] + cross[2] + cross[3] + cross[4]) / 5.0f;
    constexpr float threshold = 0.1f;
    return std::any_of(cross.begin(), cross.end(),
                       [&](const Rgb& colour) { return max_norm(colour - mean) > threshold; });
}

}  // namespace

std::vector<Stage> classic_stages(const Scene& scene, const Shot& shot) {
    const bool textures = std::any_of(scene.materials.begin(), scene.materials.end(), has_texture);
    const bool bumps = std::any_of(scene.nodes.begin(), scene.nodes.end(),
                                   [](const Node& node) { return node.bump != no_texture; });
    const bool adaptive = shot.spp == 0 && scene.settings.anti_aliasing;
    return {
        stage("texture coordinates", textures, "a material has a texture",
              "no material has a texture"),
        stage("bump", bumps, "a node has a bump", "no node has a bump"),
        stage("dark shadow rays", false, "",
              "where n·l ≤ 0 or a light is black, what is in between does not matter"),
        stage("anti-aliasing", adaptive, "the scene asks for it (wantAA)",
              shot.spp == 0 ? "the scene does not ask for it (wantAA)"
                            : "the number of samples is given (--spp)",
              Stage::heuristic),
    };
}

WhittedNeeds whitted_needs(const Plan& plan) {
    return {.surface = {.uv = plan.needed("texture coordinates"), .bump = plan.needed("bump")},
            .dark_shadow_rays = plan.needed("dark shadow rays")};
}

Key sample_key(const Shot& shot, int x, int y, int sample) {
    return Key(shot.seed)
        .branch(static_cast<std::uint64_t>(y) * static_cast<std::uint64_t>(shot.size.width) +
                static_cast<std::uint64_t>(x))
        .branch(static_cast<std::uint64_t>(sample));
}

Vec2d sample_position(const Shot& shot, int x, int y, int sample) {
    const Vec2d corner(x, y);
    if (shot.spp <= 1) return corner + 0.5;
    return corner + sample_key(shot, x, y, sample).square(position_in_pixel);
}

void trace_tile(const Scene& scene, const Shot& shot, const Tile& tile, const WhittedNeeds& needs,
                Tracer& tracer, ImageView<Rgb> colour) {
    const Screen screen(shot.camera, shot.size);
    const Whitted whitted(scene, needs, tracer);
    const int samples = std::max(1, shot.spp);
    std::vector<Ray> rays(tile.area());
    std::vector<Hit> hits(tile.area());
    for (int sample = 0; sample < samples; ++sample) {
        std::size_t i = 0;
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                const Vec2d p = sample_position(shot, x, y, sample);
                rays[i++] = screen.ray(p.x, p.y);
            }
        }
        tracer.closest(RayKind::primary, rays, hits);
        i = 0;
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x, ++i) {
                const Key key = sample_key(shot, x, y, sample).branch(radiance);
                const Rgb light = whitted.shade(RayKind::primary, rays[i], hits[i], key);
                colour(x, y) = sample == 0 ? light : colour(x, y) + light;
            }
        }
    }
    if (samples == 1) return;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) colour(x, y) /= static_cast<float>(samples);
    }
}

void shade_tile(const Scene& scene, const Shot& shot, const Tile& tile, const WhittedNeeds& needs,
                Tracer& tracer, ImageView<const Hit> hits, ImageView<Rgb> colour) {
    const Screen screen(shot.camera, shot.size);
    const Whitted whitted(scene, needs, tracer);
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const Key key = sample_key(shot, x, y, 0).branch(radiance);
            const Ray ray = screen.ray(x + 0.5, y + 0.5);
            colour(x, y) = whitted.shade(RayKind::primary, ray, hits(x, y), key);
        }
    }
}

void antialias(const Scene& scene, const Shot& shot, const WhittedNeeds& needs, Context& context,
               ImageView<Rgb> colour) {
    // The edges are found in the picture as it was, whatever the order of the tiles.
    Image<std::uint8_t> edges(colour.size());
    context.for_each_tile(colour.size(), [&](Tile tile, int) {
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) edges(x, y) = is_edge(colour, x, y) ? 1 : 0;
        }
    });
    const Screen screen(shot.camera, shot.size);
    constexpr std::array<Vec2d, 4> around{Vec2d{-0.3, -0.3}, {0.3, -0.3}, {-0.3, 0.3}, {0.3, 0.3}};
    context.for_each_tile(colour.size(), [&](Tile tile, int worker) {
        const Whitted whitted(scene, needs, context.tracer(worker));
        for (int y = tile.y0; y < tile.y1; ++y) {
            for (int x = tile.x0; x < tile.x1; ++x) {
                if (edges(x, y) == 0) continue;
                Rgb sum = colour(x, y);
                for (int i = 0; i < 4; ++i) {
                    const Ray ray = screen.ray(x + 0.5 + around[i].x, y + 0.5 + around[i].y);
                    const Key key = sample_key(shot, x, y, i + 1).branch(radiance);
                    sum += whitted.radiance(RayKind::primary, ray, key);
                }
                colour(x, y) = sum / 5.0f;
            }
        }
    });
}

}  // namespace luch
