#include "framework/measure/metrics.h"
#include "framework/stress/made/everything.h"
#include "framework/stress/subject.h"
#include "framework/stress/things.h"

#include <fmt/format.h>

namespace luch::stress {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

Scene lit(float power, float colour) {
    Scene scene = one_thing(Thing::ball);
    auto& lamp = std::get<PointLight>(scene.lights[0]);
    lamp.power = power;
    lamp.color = Rgb(colour);
    return scene;
}

Scene lamp_with_face(float power) {
    Scene scene = one_thing(Thing::ball);
    scene.lights.clear();
    add_rect_light(scene, "lamp",
                   RectLight{.to_world = Transform::translation({0, 3, -1}), .power = power});
    return scene;
}

/// A floor and a ball in a room of that reflectance.
Scene room(const Rgb& albedo) {
    Scene scene = one_thing(Thing::ball);
    scene.materials[0] = Lambert{.color = albedo};
    scene.settings.background = Rgb(0);
    add(scene, Plane{.y = -1}, Lambert{.color = albedo});
    return scene;
}

/// A floor with a picture on it, one texel of which is `texel`; a mirror ball and a lamp above.
Scene with_texel(const Rgb& texel) {
    Scene scene = one_thing(Thing::ball);
    scene.settings.ambient_light = Rgb(0.125f);  // the texel is seen in shadows, too
    scene.materials[0] = Reflection{};
    Image<Rgb> picture({8, 8}, Rgb(0.5f));
    picture(3, 4) = texel;
    scene.textures.emplace_back(BitmapTexture{picture, 2});
    add(scene, Plane{.y = -1, .limit = 3},
        Lambert{.texture = static_cast<TextureId>(scene.textures.size() - 1)});
    return scene;
}

/// A picture of the sky, one texel of which is `texel`.
Scene with_sky_texel(const Rgb& texel) {
    Scene scene = one_thing(Thing::ball);
    CubemapEnvironment sky;
    for (Image<Rgb>& side : sky.sides) side = Image<Rgb>({8, 8}, Rgb(0.5f));
    sky.sides[CubemapEnvironment::pos_z](4, 4) = texel;
    scene.environment = sky;
    return scene;
}

/// As displayed every pixel lies in 0…1, or is marked as not finite.
StressResult shown_in_range(const Sight& sight) {
    const Image<Rgb> shown = displayed(sight.colour());
    std::size_t off = 0, at_limit = 0;
    for (const Rgb& pixel : shown.pixels()) {
        if (std::isnan(pixel.x)) continue;
        const float least = std::min({pixel.x, pixel.y, pixel.z}), most = max_norm(pixel);
        off += least >= 0 && most <= 1 ? 0 : 1;
        at_limit += most == 1 ? 1 : 0;
    }
    return judged(off == 0, fmt::format("{} pixels at white, {} not finite and counted", at_limit,
                                        sight.outcome.non_finite.count));
}

/// Pixels that show the wild texel are those that change when it is another sound one; all others
/// must be what they are with a sound one, bit for bit.
Check contained(std::function<Scene(const Rgb&)> scene_with) {
    return [scene_with = std::move(scene_with)](const Sight& sight) {
        const int spp = sight.shot.spp;
        // Colours that come in steps may not change where little of the texel is seen.
        const bool steps = sight.subject.info->resolution > 0;
        const Subject by{steps ? sight.subject.baseline : sight.subject.info,
                         sight.subject.baseline};
        const Outcome dark = picture(by, scene_with(Rgb(0.25f)), spp);
        const Outcome bright = picture(by, scene_with(Rgb(0.75f)), spp);
        const Outcome sound = picture(sight.subject, scene_with(Rgb(0.25f)), spp);
        std::size_t showing = 0, spoilt = 0;
        for (std::size_t i = 0; i < sight.shot.size.area(); ++i) {
            const Rgb& a = dark.frame.colour.pixels()[i];
            if (a != bright.frame.colour.pixels()[i]) {
                ++showing;
            } else if (sight.outcome.frame.colour.pixels()[i] != sound.frame.colour.pixels()[i]) {
                ++spoilt;
            }
        }
        return judged(spoilt == 0 && showing > 0 && showing < sight.shot.size.area(),
                      fmt::format("{} pixels show it, {} not finite, {} others spoilt", showing,
                                  sight.outcome.non_finite.count, spoilt));
    };
}

/// What may overflow, as long as it is counted and shown in range.
void add_bright(CaseList& list, const std::string& name, const std::function<Scene()>& scene) {
    list.look(
        18, name, "counted, shown in 0…1",
        [scene] {
            Look look(scene());
            look.may_overflow = true;
            return look;
        },
        shown_in_range);
}

void add_texels(CaseList& list) {
    for (const float number : {nan, inf, -inf, 1e30f, -1e30f}) {
        const auto wild = [number](Scene (*scene)(const Rgb&)) {
            return [number, scene] {
                Look look(scene(Rgb(number, 0.5f, 0.5f)));
                look.may_overflow = true;
                return look;
            };
        };
        list.look(18, fmt::format("a texel of {:g}", number), "no other pixel spoilt",
                  wild(with_texel), contained(with_texel));
        // A path tracer looks for light where the sky is bright, so there every pixel depends on
        // every texel.
        list.look(
            18, fmt::format("a texel of {:g} in the sky", number), "no other pixel spoilt",
            wild(with_sky_texel),
            list.subject.info->approximates ? contained(with_sky_texel) : Check(shown_in_range));
    }
}

}  // namespace

void add_numbers(CaseList& list) {
    add_bright(list, "a lamp of power 1e30", [] { return lit(1e30f, 1); });
    add_bright(list, "a lamp of power 3e38", [] { return lit(3e38f, 1); });
    add_bright(list, "a lamp with a face, power 1e30", [] { return lamp_with_face(1e30f); });
    add_bright(list, "a sky of 1e38", [] {
        Scene scene = one_thing(Thing::ball);
        scene.settings.background = Rgb(1e38f);
        return scene;
    });
    add_bright(list, "a lamp of power −1", [] { return lit(-1, 1); });
    list.look(18, "a lamp of colour 1e-30", "finite", [] { return lit(40, 1e-30f); });
    list.look(
        18, "a lamp of power 1e30 and colour 1e-30", "as power 1 and colour 1",
        [] { return lit(1e30f, 1e-30f); }, as_of([] { return lit(1, 1); }, 0));
    list.look(
        18, "reflectance 0", "black", [] { return room(Rgb(0)); }, all_of(Rgb(0)));
    for (const float albedo : {1.0f, 2.0f, 1e3f}) {
        add_bright(list, fmt::format("reflectance {:g}", albedo),
                   [albedo] { return room(Rgb(albedo)); });
    }
    add_texels(list);
}

}  // namespace luch::stress
