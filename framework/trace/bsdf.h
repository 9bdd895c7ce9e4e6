#pragma once

#include "framework/math/spread.h"
#include "framework/trace/counts.h"
#include "framework/trace/surface.h"

#include <optional>
#include <vector>

namespace luch {

/// The random numbers of one vertex of a path: for each purpose a pair, spread evenly over the
/// samples of a pixel.
struct Draw {
    Key key;                  ///< of the vertex, the same for all samples that are spread together
    std::uint32_t index = 0;  ///< of the sample

    [[nodiscard]] Vec2d pair(std::uint64_t purpose) const {
        return spread(key.branch(purpose), index);
    }
};

/// How a path goes on from a surface point.
struct Bounce {
    Vec3d direction;  ///< unit length
    Vec3d weight;     ///< BSDF times cosine over the density
    /// Over solid angle, of all the lobes that light sampling serves; 0: of the others, which only
    /// the BSDF can sample.
    double pdf = 0;
    RayKind kind = RayKind::gi;
    const Refraction* medium = nullptr;  ///< what the path runs through from here on
};

/// What a material makes of light at one surface point, as a sum of lobes.
///
/// Lambert     albedo/π.
/// Phong       albedo/π + k·(n + 2)/2π·cosⁿγ, n the exponent, γ to the mirrored view direction
///             (Lafortune and Willems 1994). k = specular (0..1) · (1 − the largest channel of the
///             albedo): the highlight takes only what the diffuse part, which looks as in the
///             classic tracer, leaves over. So no more comes back than came, and specular 1 gives
///             it all (in its brightest channel, seen from straight above).
/// Reflection  a mirror; a glossy one jitters its normal as the classic tracer does. Its density is
///             not known: light is found by it, never for it.
/// Refraction  transmission only, as in the classic tracer: black where the reflection is total,
///             and radiance is not scaled by the index of refraction.
/// Layered     the sum of its layers' lobes, each times blend · Π (1 − blend) of those above it.
/// Const, Emission   send light of their own, and scatter none.
///
/// Lambert and Phong use the geometric normal where the shading normal points away from it, and
/// light never passes through them: what comes from below the true surface is lost.
class Bsdf {
 public:
    /// Of a point that `direction` (unit length) runs into. Replaces what was there before.
    /// `medium` is what the path came through.
    void set(const Scene& scene, const Surface& surface, const Vec3d& direction,
             const Material& material, const Refraction* medium);

    /// Light of its own towards the viewer.
    [[nodiscard]] const Vec3d& emitted() const { return emitted_; }
    /// Whether there are lobes that light sampling serves.
    [[nodiscard]] bool scatters() const { return scatters_; }
    /// The normal of those lobes.
    [[nodiscard]] const Vec3d& normal() const { return normal_; }

    struct Value {
        Vec3d reflected{0};  ///< BSDF times cosine
        double pdf = 0;      ///< with which sample() finds the direction
    };
    /// Of the lobes that light sampling serves.
    [[nodiscard]] Value evaluate(const Vec3d& to_light) const;

    /// Nothing: the path ends here.
    [[nodiscard]] std::optional<Bounce> sample(const Draw& draw) const;

 private:
    struct Lobe {
        enum Kind { diffuse, highlight, mirror, glossy, clear };
        Kind kind;
        Vec3d weight;
        double shape = 0;  ///< highlight: the exponent; glossy: the radius of the jitter
        const Refraction* clear_material = nullptr;
        double chance = 0;
    };
    void add(const Scene& scene, const Material& material, const Vec3d& weight);
    void add_layers(const Scene& scene, const Layered& material, const Vec3d& weight);
    void add_lobe(Lobe lobe);
    void share_chances();
    [[nodiscard]] Vec3d albedo(const Scene& scene, const Rgb& color, TextureId texture) const;
    [[nodiscard]] const Lobe& chosen(double random) const;
    [[nodiscard]] std::optional<Bounce> scattered(const Lobe& lobe, const Draw& draw) const;
    [[nodiscard]] std::optional<Bounce> passed(const Lobe& lobe, const Draw& draw) const;
    [[nodiscard]] Vec3d blurred(double radius, const Draw& draw) const;

    const Surface* surface_ = nullptr;
    const Refraction* medium_ = nullptr;
    Vec3d direction_{0};
    Vec3d normal_{0};
    Vec3d mirrored_{0};  ///< the view direction in that normal
    Vec3d emitted_{0};
    bool scatters_ = false;
    std::vector<Lobe> lobes_;
};

}  // namespace luch
