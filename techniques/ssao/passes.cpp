#include "techniques/ssao/passes.h"

#include "framework/baseline/tile_rays.h"
#include "framework/trace/surface.h"
#include "techniques/ssao/slices.h"
#include "techniques/ssao/view.h"

namespace luch::techniques::ssao {
namespace {

/// What a frame's key is used for.
enum Purpose : std::uint64_t { points = 0x55a1, turns = 0x55a2 };

/// World to camera space, for directions.
struct Turned {
    Vec3d right, up, forward;
    explicit Turned(const Camera& camera) {
        const Transform to_world = camera.to_world();
        right = to_world.direction({1, 0, 0});
        up = to_world.direction({0, 1, 0});
        forward = to_world.direction({0, 0, 1});
    }
    [[nodiscard]] Vec3 operator()(const Vec3d& world) const {
        return Vec3(glm::dot(world, right), glm::dot(world, up), glm::dot(world, forward));
    }
};

/// Of a surface's parts the passes need only where it stands.
Needs needs_of_normals(const Needs& needs) {
    Needs few(false);
    few[Part::transforms] = needs[Part::transforms];
    return few;
}

template <class T>
void fit(Image<T>& image, Size size) {
    if (image.size() != size) image = Image<T>(size);
}

}  // namespace

float tolerance_of(const Params& params) {
    if (Smoothing(params.smoothing) == Smoothing::gaussian) {
        return std::numeric_limits<float>::infinity();
    }
    constexpr double share = 0.06;
    return static_cast<float>(share * params.radius);
}

void Passes::resize(Size size) {
    fit(hits_, size);
    fit(depth_, size);
    fit(position_, size);
    fit(normal_, size);
    fit(visibility_, size);
    fit(light_, size);
}

void Passes::look(const Scene& scene, const Shot& shot, const Params& params, const Needs& needs,
                  Context& context) {
    resize(shot.size);
    Shot centres = shot;
    centres.spp = 1;
    const Screen screen(shot.camera, shot.size);
    const Turned turned(shot.camera);
    const bool of_surfaces = Normals(params.normals) == Normals::surface;
    context.for_each_tile(shot.size, [&](Tile tile, int worker) {
        TileRays rays;
        Tracer& tracer = context.tracer(worker);
        rays.shoot(screen, centres, tile, 0, needs, tracer);
        for (std::size_t i = 0; i < rays.rays.size(); ++i) {
            const auto& [x, y] = rays.pixels[i];
            const Hit& hit = hits_(x, y) = rays.hits[i];
            const double along = glm::dot(rays.rays[i].direction, screen.forward());
            depth_(x, y) =
                hit ? static_cast<float>(hit.t * along) : std::numeric_limits<float>::infinity();
            if (!of_surfaces) continue;
            Counts not_counted;
            normal_(x, y) = hit ? turned(surface_at(scene, rays.rays[i], hit,
                                                    needs_of_normals(needs), not_counted)
                                             .geometric_normal)
                                : Vec3(0);
        }
        call_step(context, steps_.positions, reference().positions, depth_.view(), screen, tile,
                  position_.view());
    });
    if (of_surfaces) return;
    context.for_each_tile(shot.size, [&](Tile tile, int) {
        call_step(context, steps_.normals, reference().normals, position_.view(), tile,
                  normal_.view());
    });
}

void Passes::halve(Context& context) {
    const Size half{(position_.width() + 1) / 2, (position_.height() + 1) / 2};
    fit(half_position_, half);
    fit(half_normal_, half);
    context.for_each_tile(half, [&](Tile tile, int) {
        each_pixel(tile, [&](int x, int y) {
            half_position_(x, y) = position_(2 * x, 2 * y);
            half_normal_(x, y) = normal_(2 * x, 2 * y);
        });
    });
}

void Passes::occlude(const Shot& shot, const Params& params, Context& context) {
    const GBuffer fine{position_.view(), normal_.view()};
    if (params.half) halve(context);
    const GBuffer seen = params.half ? GBuffer{half_position_.view(), half_normal_.view()} : fine;
    const Size size = seen.position.size();
    fit(raw_, size);
    fit(between_, size);
    fit(blurred_, size);
    const Key key = Key(shot.seed).branch(static_cast<std::uint64_t>(shot.frame));
    find_occlusion(seen, Screen(shot.camera, size), params, key, context);
    smooth(seen, params, context);
    context.for_each_tile(shot.size, [&](Tile tile, int) {
        const float tolerance = tolerance_of(params);
        if (params.half) {
            call_step(context, steps_.upsample, reference().upsample, blurred_.view(), seen, fine,
                      tolerance, tile, visibility_.view());
        }
        const Image<float>& from = params.half ? visibility_ : blurred_;
        each_pixel(tile, [&](int x, int y) { visibility_(x, y) = 1 - from(x, y); });
    });
}

void Passes::find_occlusion(const GBuffer& seen, const Screen& screen, const Params& params,
                            Key key, Context& context) {
    const bool classic = Mode(params.mode) == Mode::classic;
    std::vector<Vec3> kernel(classic ? static_cast<std::size_t>(params.samples) : 0);
    if (classic) {
        call_step(context, steps_.kernel, reference().kernel, key.branch(points),
                  std::span(kernel));
    }
    context.for_each_tile(raw_.size(), [&](Tile tile, int) {
        if (classic) {
            call_step(context, steps_.occlusion, reference().occlusion, seen, screen,
                      std::span<const Vec3>(kernel), params, key.branch(turns), tile, raw_.view());
        } else {
            slices(seen, screen, params, key.branch(turns), tile, raw_.view());
        }
    });
}

void Passes::smooth(const GBuffer& seen, const Params& params, Context& context) {
    if (Smoothing(params.smoothing) == Smoothing::off) {
        blurred_ = raw_;
        return;
    }
    const Blur blur{.tolerance = tolerance_of(params)};
    const auto along = [&](const Image<float>& from, Axis axis, Image<float>& to) {
        context.for_each_tile(raw_.size(), [&](Tile tile, int) {
            call_step(context, steps_.blur, reference().blur, from.view(), seen, blur, axis, tile,
                      to.view());
        });
    };
    along(raw_, Axis::x, between_);
    along(between_, Axis::y, blurred_);
}

void Passes::all_visible() {
    visibility_ = Image<float>(depth_.size(), 1);
    raw_ = blurred_ = Image<float>(depth_.size(), 0);
}

void Passes::light(const Rgb& ambient, Context& context) {
    context.for_each_tile(light_.size(), [&](Tile tile, int) {
        call_step(context, steps_.apply, reference().apply, visibility_.view(), ambient, tile,
                  light_.view());
    });
}

}  // namespace luch::techniques::ssao
