#include "techniques/sh_ambient/sky.h"

#include "techniques/sh_ambient/ringing.h"

namespace luch::techniques::sh_ambient {
namespace {

std::uint64_t texels_of(const Environment& sky) {
    const auto* cube = std::get_if<CubemapEnvironment>(&sky);
    if (cube == nullptr) return 1;
    std::uint64_t texels = 0;
    for (const Image<Rgb>& side : cube->sides) texels += side.size().area();
    return texels;
}

/// The largest channel's length of a degree's coefficients, times what the cosine makes of it.
double size_of(const Sh9& light, int degree) {
    Vec3d squares(0);
    for (int k = degree * degree; k < (degree + 1) * (degree + 1); ++k) {
        const Vec3d l(light.l[static_cast<std::size_t>(k)]);
        squares += l * l;
    }
    return max_norm(glm::sqrt(squares)) * std::sqrt((2 * degree + 1) / (4 * std::numbers::pi)) *
           cosine_lobe[static_cast<std::size_t>(degree)];
}

}  // namespace

SkyLight sky_light_of(const Scene& scene, const Steps& steps) {
    const Environment sky =
        scene.environment.value_or(ConstantEnvironment{scene.settings.background});
    SkyLight result;
    result.wild = steps.project(sky, result.light);
    result.texels = texels_of(sky);
    const double mean = size_of(result.light, 0);
    for (int degree = 0; degree < 3; ++degree) {
        const double size = size_of(result.light, degree);
        result.strength[static_cast<std::size_t>(degree)] = size == 0 ? 0 : size / mean;
    }
    return result;
}

Sh9 tamed(const Sh9& light, int degree, Ringing ringing) {
    Sh9 result = light;
    result.degree = degree;
    for (int k = (degree + 1) * (degree + 1); k < sh_terms; ++k) {
        result.l[static_cast<std::size_t>(k)] = Rgb(0);
    }
    if (ringing == Ringing::least) scale_linear_terms(result, least_scaling(result));
    if (ringing == Ringing::scaled) scale_linear_terms(result, ringing_scale);
    return result;
}

}  // namespace luch::techniques::sh_ambient
