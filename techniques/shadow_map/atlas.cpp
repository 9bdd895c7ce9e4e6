#include "techniques/shadow_map/atlas.h"

#include "framework/baseline/tile_rays.h"

namespace luch::techniques::shadow_map {
namespace {

/// Around what receives light: what a filter may look at besides.
constexpr int margin = 4;
/// No side is longer, however far a light is: float directions still tell such texels apart.
constexpr int most_side = 1 << 17;

Boxd seen_from(const Boxd& box, const Vec3d& light) {
    return {box.lo - light, box.hi - light};
}

/// Whether some of a box lies where a light with an area shines to; others shine everywhere.
bool in_front(const Boxd& box, const Vec3d& light, const Vec3d& facing) {
    if (facing == Vec3d(0) || !all_finite(box.lo) || !all_finite(box.hi)) return true;
    double farthest = 0;
    for (int axis = 0; axis < 3; ++axis) {
        farthest += std::max(facing[axis] * (box.lo[axis] - light[axis]),
                             facing[axis] * (box.hi[axis] - light[axis]));
    }
    return farthest > 0;
}

/// The windows of all faces for what receives light.
std::array<Tile, faces_of_cube> windows_of(const Content& content, const Vec3d& light,
                                           const Vec3d& facing, const SpotLight* spot, int n) {
    std::array<Tile, faces_of_cube> windows;
    for (int face = 0; face < faces_of_cube; ++face) {
        Tile& window = windows[static_cast<std::size_t>(face)];
        for (const Content::Thing& thing : content.things()) {
            if (!thing.receives || thing.box.empty() || !in_front(thing.box, light, facing)) {
                continue;
            }
            window = around(window, window_of(seen_from(thing.box, light), face, n, margin));
        }
        if (spot != nullptr)
            window = common(window, window_of(directions_of(*spot), face, n, margin));
    }
    return windows;
}

int longest_side(const std::array<Tile, faces_of_cube>& windows) {
    int longest = 0;
    for (const Tile& window : windows) {
        longest = std::max({longest, window.width(), window.height()});
    }
    return longest;
}

/// The points of a light with an area share the texels of one map.
int side_of(const Params& params, const Light& light) {
    const bool many = std::holds_alternative<RectLight>(light) && Mode(params.mode) != Mode::pcss;
    const double side = params.side / std::sqrt(many ? params.points : 1);
    return std::max(static_cast<int>(side), 1);
}

/// The key of all that is seen in a window.
std::uint64_t seen_in(const Content& content, const Vec3d& light, int face, int n,
                      const Tile& window) {
    Key key = followed(Key(static_cast<std::uint64_t>(n)), light);
    for (const int edge : {window.x0, window.y0, window.x1, window.y1}) {
        key = key.branch(static_cast<std::uint64_t>(edge));
    }
    for (const Content::Thing& thing : content.things()) {
        if (thing.box.empty()) continue;
        const Tile seen = window_of(seen_from(thing.box, light), face, n, 1);
        if (common(seen, window) != Tile{}) key = key.branch(thing.key.bits(0));
    }
    return key.bits(0);
}

}  // namespace

std::uint64_t Lamp::bytes() const {
    std::uint64_t texels = sphere.distance.size().area();
    for (const Face& face : map.faces) texels += face.distance.size().area();
    return texels * sizeof(float) + moments.bytes() + items.bytes();
}

std::uint64_t Atlas::bytes() const {
    std::uint64_t bytes = 0;
    for (const Lights& lights : lights_) {
        for (const Lamp& lamp : lights.lamps) bytes += lamp.bytes();
    }
    return bytes;
}

void Atlas::update(const Scene& scene, const Shot& shot, const Params& params, Context& context) {
    filled_ = 0;
    content_ = Content(scene);
    // Maps of another kind are of no use.
    const bool other = params.mode != params_.mode || params.layout != params_.layout;
    params_ = params;
    if (other) lights_.clear();
    lights_.resize(scene.lights.size());
    place(scene, shot, context);
    std::uint64_t texels = 0;
    const std::uint64_t most = std::uint64_t(params_.memory) * (1 << 20) / sizeof(float);
    std::vector<Stale> stale;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        std::uint64_t of_light = 0;
        for (Lamp& lamp : lights_[i].lamps) {
            of_light += lay_out(scene.lights[i], lights_[i].facing, lamp, context.plan());
        }
        if (texels + of_light > most) {  // its shadows are left to rays
            lights_[i] = {};
            continue;
        }
        texels += of_light;
        for (Lamp& lamp : lights_[i].lamps) find_stale(lamp, stale);
    }
    fill(stale, scene, context);
}

/// Points and facing of every light; lamps that are there already are kept.
void Atlas::place(const Scene& scene, const Shot& shot, Context& context) {
    const bool maps = context.plan().needed(stage::maps);
    const bool convex = !context.plan().needed(stage::convex);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        std::vector<LightPoint> points;
        lights_[i].facing = Vec3d(0);
        if (const auto* point = std::get_if<PointLight>(&light)) points = {{point->position}};
        if (const auto* spot = std::get_if<SpotLight>(&light)) points = {{spot->position}};
        const auto* rect = std::get_if<RectLight>(&light);
        // Where rays of a light with an area start is random: no item buffer looks from there.
        if (rect != nullptr && Mode(params_.mode) != Mode::exact) {
            lights_[i].facing = rect->facing();
            const bool one = Mode(params_.mode) == Mode::pcss;
            const Key key = Key(shot.seed).branch(i);
            call_step(context, steps_.light_points, reference().light_points, *rect,
                      one ? 1 : params_.points, one ? Pattern::regular : Pattern(params_.pattern),
                      key, points);
        }
        lights_[i].convex = convex && !points.empty();
        if (!maps || lights_[i].convex) points.clear();
        lights_[i].lamps.resize(points.size());
        for (std::size_t k = 0; k < points.size(); ++k) lights_[i].lamps[k].point = points[k];
    }
}

/// Sides and windows; gives the texels that they have.
std::uint64_t Atlas::lay_out(const Light& light, const Vec3d& facing, Lamp& lamp,
                             const Plan& plan) {
    const int side = side_of(params_, light);
    if (Layout(params_.layout) == Layout::sphere && Mode(params_.mode) == Mode::classic) {
        lamp.sphere.n = side;
        return std::uint64_t{8} * side * side;
    }
    const auto* spot = std::get_if<SpotLight>(&light);
    const Vec3d& at = lamp.point.position;
    int n = side;
    if (params_.fit) {
        constexpr int probe = 1 << 12;
        const int longest = longest_side(windows_of(content_, at, facing, spot, probe));
        // One that fills more than half of a face has the face.
        if (longest > 0 && longest < probe / 2) {
            n = static_cast<int>(std::min(double(n) * probe / longest, double(most_side)));
        }
    }
    const auto windows = windows_of(content_, at, facing, spot, n);
    lamp.map.n = lamp.items.n = n;
    std::uint64_t texels = 0;
    for (std::size_t face = 0; face < faces_of_cube; ++face) {
        Tile& window = lamp.map.faces[face].window;
        window = windows[face];
        texels += window.area();
        if (window == Tile{} && plan.needed(stage::empty_faces)) {
            const int first = (n - side) / 2;
            window = {first, first, first + side, first + side};
        }
    }
    return texels;
}

/// Faces whose key is not what they were made from.
void Atlas::find_stale(Lamp& lamp, std::vector<Stale>& stale) const {
    const int faces = lamp.sphere.n > 0 ? 1 : faces_of_cube;
    for (int face = 0; face < faces; ++face) {
        const Tile& window = lamp.map.faces[static_cast<std::size_t>(face)].window;
        std::uint64_t key = 1;
        if (lamp.sphere.n > 0) {
            key = followed(Key(content_.digest()), lamp.point.position)
                      .bits(static_cast<std::uint64_t>(lamp.sphere.n));
        } else if (window != Tile{}) {
            key = seen_in(content_, lamp.point.position, face, lamp.map.n, window);
        }
        std::uint64_t& made_from = lamp.made_from[static_cast<std::size_t>(face)];
        if (made_from == key) continue;
        made_from = key;
        stale.push_back({&lamp, face});
    }
}

void Atlas::fill(std::span<const Stale> stale, const Scene& scene, Context& context) {
    const bool exact = Mode(params_.mode) == Mode::exact;
    if (exact) {
        context.for_each(static_cast<int>(stale.size()), [&](int i, int) {
            const auto& [lamp, face] = stale[static_cast<std::size_t>(i)];
            const auto f = static_cast<std::size_t>(face);
            lamp->items.faces[f] = items_of(scene, content_, lamp->point.position, face,
                                            lamp->map.n, lamp->map.faces[f].window);
        });
    }
    // A student's own step fills what it is asked for.
    std::optional<FaceRaster> raster;
    const bool own = steps_.render_face != reference().render_face;
    if (!stale.empty() && !own && context.plan().needed(stage::raster)) raster.emplace(scene);
    std::vector<Lamp*> changed;
    for (const auto& [lamp, face] : stale) {
        filled_ += lamp->sphere.n > 0
                       ? std::uint64_t{8} * lamp->sphere.n * lamp->sphere.n
                       : lamp->map.faces[static_cast<std::size_t>(face)].window.area();
        if (!exact) fill(*lamp, face, raster ? &*raster : nullptr, context);
        if (changed.empty() || changed.back() != lamp) changed.push_back(lamp);
    }
    const Mode mode = Mode(params_.mode);
    if (mode != Mode::vsm && mode != Mode::msm) return;
    for (Lamp* lamp : changed) lamp->moments = moments_of(lamp->map, context);
}

void Atlas::fill(Lamp& lamp, int face, FaceRaster* raster, Context& context) {
    const Vec3d& light = lamp.point.position;
    const bool on_sphere = lamp.sphere.n > 0;
    Face& to = lamp.map.faces[static_cast<std::size_t>(face)];
    const Tile window = on_sphere ? Tile{0, 0, 4 * lamp.sphere.n, 2 * lamp.sphere.n} : to.window;
    Image<float>& distance = on_sphere ? lamp.sphere.distance : to.distance;
    distance = Image<float>({window.width(), window.height()});
    if (raster != nullptr && window == Tile{0, 0, lamp.map.n, lamp.map.n} && !on_sphere) {
        context.did(stage::raster, window.area(), "texels");
        return raster->fill(light, face, context, distance.view());
    }
    context.for_each_tile(distance.size(), [&](Tile at, int worker) {
        const Tile tile{window.x0 + at.x0, window.y0 + at.y0, window.x0 + at.x1, window.y0 + at.y1};
        Image<float> part({tile.width(), tile.height()});
        Tracer& tracer = context.tracer(worker);
        if (on_sphere) {
            render_sphere(light, lamp.sphere.n, tile, tracer, part.view());
        } else {
            call_step(context, steps_.render_face, reference().render_face, light, face, lamp.map.n,
                      tile, tracer, part.view());
        }
        for_each_pixel(at, [&](int x, int y) { distance(x, y) = part(x - at.x0, y - at.y0); });
    });
}

}  // namespace luch::techniques::shadow_map
