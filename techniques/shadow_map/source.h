#pragma once

#include "framework/trace/known_light.h"
#include "techniques/shadow_map/atlas.h"

namespace luch::techniques::shadow_map {

/// The steps that a frame asks for every point, with the reference's where there are holes: points
/// in mirrors are asked one by one, and a hole for each would take longer than the picture.
Steps asked_steps(const Steps& steps, bool filter, Context& context);

/// What the maps know of light; a tile's own, since it counts.
class MapSource final : public ShadowSource {
 public:
    /// `filter`: where Params::pcf has a say. All must outlive it.
    MapSource(const Steps& steps, const Params& params, bool filter, const Atlas& atlas,
              const Scene& scene, Context& context, Tracer& tracer)
        : steps_(&steps),
          params_(&params),
          filter_(filter),
          lights_(atlas.lights()),
          scene_(&scene),
          context_(&context),
          tracer_(&tracer) {}

    void shares(std::size_t light, std::span<const Surface> points,
                std::span<const std::uint32_t> which, std::span<float> shares) const override;
    [[nodiscard]] float share(std::size_t light, const Surface& surface) const override;

 private:
    struct Asked;
    void ask(const Lamp& lamp, double width, const Asked& asked, std::span<float> shares) const;
    void ask_map(const Lamp& lamp, double width, std::span<const Receiver> receivers,
                 std::span<const float> biases, std::span<float> shares) const;
    void ask_items(const Lamp& lamp, const Asked& asked, std::span<float> shares) const;
    void mix(const Lights& lights, double width, const Asked& asked, std::span<float> shares) const;

    const Steps* steps_;
    const Params* params_;
    bool filter_;
    std::span<const Lights> lights_;
    const Scene* scene_;
    Context* context_;
    Tracer* tracer_;
};

/// Receivers whose bias would grow without limit, at more than this angle to the light, are moved
/// along the normal instead.
inline constexpr float grazing_cosine = 0.035f;

/// Moves a receiver that is seen at a grazing angle along its normal, to the light's side, by what
/// its bias is worth there, and takes the bias away. On a plane at the distance K from the light a
/// point at height e is compared with what is e/cos θ behind it, so e = bias · cos θ, which stays
/// below a texel's width.
void offset_along_normal(Receiver& receiver, float& bias);

}  // namespace luch::techniques::shadow_map
