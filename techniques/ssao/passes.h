#pragma once

#include "framework/technique/context.h"
#include "framework/trace/parts.h"
#include "techniques/ssao/ssao.h"

namespace luch::techniques::ssao {

/// What the pixels' centres show, and the passes over it. Reused from frame to frame.
class Passes {
 public:
    explicit Passes(const Steps& steps) : steps_(steps) {}

    /// Finds what the centres show. `params` are settled(); the scene must outlive what follows.
    void look(const Scene& scene, const Shot& shot, const Params& params, const Needs& needs,
              Context& context);
    /// Finds how much of the ambient light arrives: visibility().
    void occlude(const Shot& shot, const Params& params, Context& context);
    /// Nothing is hidden.
    void all_visible();
    /// What arrives: light().
    void light(const Rgb& ambient, Context& context);

    [[nodiscard]] const Image<Hit>& hits() const { return hits_; }
    [[nodiscard]] const Image<float>& depth() const { return depth_; }
    [[nodiscard]] const Image<Vec3>& position() const { return position_; }
    [[nodiscard]] const Image<Vec3>& normal() const { return normal_; }
    [[nodiscard]] const Image<float>& raw() const { return raw_; }  ///< occlusion, at half size too
    [[nodiscard]] const Image<float>& blurred() const { return blurred_; }
    [[nodiscard]] const Image<float>& visibility() const { return visibility_; }
    [[nodiscard]] const Image<Rgb>& light() const { return light_; }

 private:
    void resize(Size size);
    void halve(Context& context);
    void find_occlusion(const GBuffer& seen, const Screen& screen, const Params& params, Key key,
                        Context& context);
    void smooth(const GBuffer& seen, const Params& params, Context& context);

    Steps steps_;
    Image<Hit> hits_;
    Image<float> depth_;
    Image<Vec3> position_, normal_, half_position_, half_normal_;
    Image<float> raw_, between_, blurred_, visibility_;
    Image<Rgb> light_;
};

/// How far from a pixel's plane others may lie that its occlusion is smoothed with.
float tolerance_of(const Params& params);

}  // namespace luch::techniques::ssao
