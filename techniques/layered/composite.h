#pragma once

#include "framework/technique/context.h"
#include "techniques/layered/fragments.h"

#include <vector>

namespace luch::techniques::layered {

/// The modes that are made of the lecture's steps.
class Composite {
 public:
    explicit Composite(const Steps& steps) : steps_(steps) {}

    /// The depths between `layers` layers, by the step.
    std::vector<float> cuts(const Image<float>& depth, int layers, Context& context) const;

    /// Every layer is blurred by discs, and they are composited from back to front. What is left
    /// uncovered where a surface was cut in two is shared out among what covers the rest.
    void discs(const Fragments& fragments, const Lens& lens, std::span<const float> cuts,
               Context& context, ImageView<Rgb> colour);

    /// Two layers: the background with a gaussian blur, the foreground over it as it is.
    void classic(const Fragments& fragments, const Lens& lens, float cut, Context& context,
                 ImageView<Rgb> colour);

    /// Of the front of each pixel: diameters of circles of confusion, by the step.
    void confusion(const Fragments& fragments, const Lens& lens, Context& context,
                   ImageView<float> px) const;

 private:
    /// A layer, and the part of the frame that it may cover when it is blurred.
    struct Layer {
        float near, far;  ///< depths: near ≤ z < far
        Tile reach;
    };
    Layer collect(const Fragments& fragments, const Lens& lens, float near, float far,
                  Context& context);
    void resize(Size size);

    Steps steps_;
    Image<float> depth_, coc_;
    Image<Rgba> layer_, blurred_, result_;
};

}  // namespace luch::techniques::layered
