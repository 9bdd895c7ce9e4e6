#include "framework/scene/loader/classes.h"

#include "framework/base/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace luch::loader {
namespace {

constexpr BlockClass classes[] = {
    {"GlobalSettings", Kind::other, read_settings},
    {"Camera", Kind::other, read_camera},
    {"SphericalLensCamera", Kind::other, read_spherical_lens_camera},
    {"FisheyeCamera", Kind::other, read_fisheye_camera},
    {"SphericalCamera", Kind::other, read_spherical_camera},
    {"OrthographicCamera", Kind::other, read_orthographic_camera},
    {"PointLight", Kind::other, read_point_light},
    {"RectLight", Kind::other, read_rect_light},
    {"SpotLight", Kind::other, read_spot_light},
    {"DirectionalLight", Kind::other, read_directional_light},
    {"Plane", Kind::geometry, read_plane},
    {"Sphere", Kind::geometry, read_sphere},
    {"Cube", Kind::geometry, read_cube},
    {"Mesh", Kind::geometry, read_mesh},
    {"Heightfield", Kind::geometry, read_heightfield},
    {"CSGUnion", Kind::geometry, read_union},
    {"CSGInter", Kind::geometry, read_intersection},
    {"CSGDiff", Kind::geometry, read_difference},
    {"CsgUnion", Kind::geometry, read_union},
    {"CsgInter", Kind::geometry, read_intersection},
    {"CsgDiff", Kind::geometry, read_difference},
    {"CsgPlus", Kind::geometry, read_union},
    {"CsgAnd", Kind::geometry, read_intersection},
    {"CsgMinus", Kind::geometry, read_difference},
    {"Lambert", Kind::shader, read_lambert},
    {"Phong", Kind::shader, read_phong},
    {"Reflection", Kind::shader, read_reflection},
    {"Refl", Kind::shader, read_reflection},
    {"Refraction", Kind::shader, read_refraction},
    {"Refr", Kind::shader, read_refraction},
    {"Layered", Kind::shader, read_layered},
    {"Const", Kind::shader, read_const},
    {"CheckerTexture", Kind::texture, read_checker},
    {"Checker", Kind::texture, read_checker},
    {"BitmapTexture", Kind::texture, read_bitmap},
    {"BumpTexture", Kind::texture, read_bump},
    {"Bumps", Kind::texture, read_bumps},
    {"Fresnel", Kind::texture, read_fresnel},
    {"ConstantEnvironment", Kind::other, read_constant_environment},
    {"CubemapEnvironment", Kind::other, read_cubemap},
    {"Node", Kind::node, read_node},
};

}  // namespace

const BlockClass& class_of(const Block& block, const Diagnostics& diagnostics) {
    std::vector<std::string_view> names;
    for (const BlockClass& candidate : classes) {
        if (candidate.name == block.class_name) return candidate;
        names.push_back(candidate.name);
    }
    const auto wanted = std::string_view(block.class_name).substr(0, 64);
    diagnostics.fail(block.line, fmt::format("there is no class {}; {}", shown(block.class_name),
                                             did_you_mean(wanted, names)));
}

}  // namespace luch::loader
