#pragma once

#include "framework/technique/context.h"
#include "techniques/shadow_map/content.h"
#include "techniques/shadow_map/items.h"
#include "techniques/shadow_map/moments.h"
#include "techniques/shadow_map/plan.h"
#include "techniques/shadow_map/raster.h"
#include "techniques/shadow_map/shadow_map.h"
#include "techniques/shadow_map/sphere_map.h"

namespace luch::techniques::shadow_map {

/// A point light and what is known around it: by mode and layout, one of these.
struct Lamp {
    LightPoint point;
    CubeMap map;
    SphereMap sphere;
    Moments moments;
    Items items;
    /// What the faces were made from; a sphere map has but the first.
    std::array<std::uint64_t, faces_of_cube> made_from{};

    [[nodiscard]] std::uint64_t bytes() const;
};

/// A light of the scene, in one point or many.
struct Lights {
    std::vector<Lamp> lamps;  ///< none: shadow rays shall tell
    Vec3d facing{0};          ///< of a light with an area; else zero
    bool convex = false;      ///< there is but one convex thing: it needs no map
};

/// All maps of a scene. They outlive frames and scenes: a face is made anew only when its light or
/// something in its sight has changed.
class Atlas {
 public:
    explicit Atlas(const Steps& steps) : steps_(steps) {}

    /// Brings the maps up to the scene. What is made is counted by Context::did().
    void update(const Scene& scene, const Shot& shot, const Params& params, Context& context);

    [[nodiscard]] const std::vector<Lights>& lights() const { return lights_; }
    [[nodiscard]] std::uint64_t bytes() const;
    /// Texels that the last update filled.
    [[nodiscard]] std::uint64_t filled() const { return filled_; }

 private:
    struct Stale {
        Lamp* lamp;
        int face;
    };
    void place(const Scene& scene, const Shot& shot, Context& context);
    std::uint64_t lay_out(const Light& light, const Vec3d& facing, Lamp& lamp, const Plan& plan);
    void find_stale(Lamp& lamp, std::vector<Stale>& stale) const;
    void fill(std::span<const Stale> stale, const Scene& scene, Context& context);
    void fill(Lamp& lamp, int face, FaceRaster* raster, Context& context);

    Steps steps_;
    Params params_;
    Content content_;
    std::vector<Lights> lights_;
    std::uint64_t filled_ = 0;
};

}  // namespace luch::techniques::shadow_map
