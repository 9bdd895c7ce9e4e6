#include "techniques/sh_ambient/fingerprint.h"

#include <bit>
#include <cstring>

namespace luch::techniques::sh_ambient {
namespace {

/// Adds numbers up, in their order, to 64 bits that no two scenes are likely to share.
class Print {
 public:
    [[nodiscard]] std::uint64_t value() const { return state_; }

    void number(std::uint64_t bits) {
        state_ = (std::rotl(state_, 29) ^ bits) * 0x9e3779b97f4a7c15;
        state_ ^= state_ >> 32;
    }
    template <class T>
    requires std::is_integral_v<T> || std::is_enum_v<T>
    void add(T value) { number(static_cast<std::uint64_t>(value)); }
    void add(double value) { number(std::bit_cast<std::uint64_t>(value)); }
    template <int n, class T>
    void add(const glm::vec<n, T>& v) {
        for (int i = 0; i < n; ++i) add(v[i]);
    }
    template <class T>
    void add(const std::vector<T>& list) {
        add(list.size());
        for (const T& each : list) add(each);
    }
    template <class T>
    void add(const Image<T>& image) {
        add(image.width());
        add(image.pixels());
    }
    template <class... T>
    void add(const std::variant<T...>& any) {
        add(any.index());
        std::visit([&](const auto& one) { add(one); }, any);
    }

    void add(const Transform& t) {
        for (int i = 0; i < 3; ++i) add(t.matrix[i]);
        add(t.offset);
    }

    void add(const Plane& s) { all(s.y, s.limit); }
    void add(const Sphere& s) { all(s.centre, s.radius, s.uv_scaling); }
    void add(const Cube& s) { all(s.centre, s.side); }
    void add(const Mesh& s) {
        all(s.positions, s.normals, s.uvs, s.triangles, s.materials, s.from_frame, s.faceted,
            s.cull_backfaces);
    }
    void add(const Mesh::Triangle& t) {
        for (std::size_t i = 0; i < 3; ++i) all(t.position[i], t.normal[i], t.uv[i]);
    }
    void add(const Heightfield& s) {
        all(s.width(), s.height());
        for (int z = 0; z < s.height(); ++z) {
            for (int x = 0; x < s.width(); ++x) add(s.at(x, z));
        }
    }
    void add(const Csg& s) { all(s.parts, s.gates); }
    void add(const Csg::Part& p) { all(p.geometry, p.flipped, p.to_frame); }
    void add(const Csg::Gate& g) { all(g.operation, g.left, g.right); }

    void add(const CheckerTexture& t) { all(t.color1, t.color2, t.scaling); }
    void add(const BitmapTexture& t) { all(t.pixels, t.scaling, t.texel_centre); }
    void add(const BumpTexture& t) { all(t.slopes, t.strength, t.scaling); }
    void add(const Bumps& t) { add(t.strength); }
    void add(const Fresnel& t) { add(t.ior); }

    void add(const Lambert& m) { all(m.color, m.texture); }
    void add(const Phong& m) { all(m.color, m.texture, m.specular, m.exponent); }
    void add(const Reflection& m) { all(m.multiplier, m.glossiness, m.samples); }
    void add(const Refraction& m) { all(m.multiplier, m.ior, m.inside_color, m.absorption); }
    void add(const Layered& m) { add(m.layers); }
    void add(const Layered::Layer& l) { all(l.material, l.blend, l.texture); }
    void add(const Const& m) { add(m.color); }
    void add(const Emission& m) { add(m.radiance); }

    void add(const PointLight& l) { all(l.position, l.color, l.power); }
    void add(const RectLight& l) { all(l.to_world, l.color, l.power, l.x_samples, l.y_samples); }
    void add(const SpotLight& l) {
        all(l.position, l.direction, l.inner_cosine, l.outer_cosine, l.color, l.power);
    }
    void add(const DirectionalLight& l) { all(l.direction, l.color, l.power); }

    void add(const ConstantEnvironment& e) { add(e.color); }
    void add(const CubemapEnvironment& e) {
        for (const Image<Rgb>& side : e.sides) add(side);
    }
    void add(const Node& n) { all(n.geometry, n.material, n.bump, n.to_world); }

    template <class... T>
    void all(const T&... values) {
        (add(values), ...);
    }

 private:
    std::uint64_t state_ = 0x243f6a8885a308d3;
};

void add_sky(const Scene& scene, Print& print) {
    print.add(scene.settings.background);
    print.add(scene.environment.has_value());
    if (scene.environment) print.add(*scene.environment);
}

}  // namespace

std::uint64_t sky_fingerprint(const Scene& scene) {
    Print print;
    add_sky(scene, print);
    return print.value();
}

std::uint64_t scene_fingerprint(const Scene& scene) {
    Print print;
    add_sky(scene, print);
    print.all(scene.settings.max_depth, scene.geometries, scene.textures, scene.materials,
              scene.lights, scene.nodes);
    return print.value();
}

}  // namespace luch::techniques::sh_ambient
