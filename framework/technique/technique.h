#pragma once

#include "framework/scene/scene.h"
#include "framework/technique/frame.h"
#include "framework/technique/params.h"
#include "framework/technique/plan.h"

#include <cstdint>
#include <memory>
#include <optional>

namespace luch {

class Context;

/// Where a viewer looks, in pixels.
struct Gaze {
    Vec2d px{0};
};

/// One frame to be made.
struct Shot {
    Camera camera;
    Size size;
    int spp = 0;  ///< samples a pixel; 1: the pixel's centre; 0: as the scene says (adaptive)
    std::uint64_t seed = 0;
    int frame = 0;
    double time_s = 0;
    std::optional<Gaze> gaze = std::nullopt;
};

/// The frame that a scene itself asks for.
Shot shot_of(const Scene& scene);

/// One of the lecture's techniques. History lives in the instance, so two instances never meet.
class Technique {
 public:
    virtual ~Technique() = default;
    /// Shows every parameter: name, unit, range, value.
    virtual void visit(ParamVisitor&) {}
    /// Does it apply; which stages are needed, which are left out, why.
    [[nodiscard]] virtual Plan plan(const Scene& scene, const Shot& shot) const = 0;
    /// Work that outlives a frame: baking, light maps.
    virtual void prepare(const Scene&, const Shot&, Context&) {}
    /// Makes the frame. Called only when the plan applies.
    virtual void render(const Scene& scene, const Shot& shot, Frame& frame, Context& context) = 0;
};

}  // namespace luch
