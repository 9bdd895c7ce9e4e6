#pragma once

#include "framework/technique/context.h"
#include "framework/trace/parts.h"
#include "techniques/layered/layered.h"

#include <vector>

// The students' kit: what the layers are made of. The technique's own knows how far a lens sees
// past edges, which t2 asks for; here all that is behind something is looked for.
namespace luch::techniques::layered {

/// Something that is seen only when what is in front of it is not there.
struct Hidden {
    Rgb colour{0};
    float depth = 0;
    bool last = true;  ///< of its pixel; else the next one is farther
};

/// A sharp picture with what is behind it, all of it traced.
class Fragments {
 public:
    /// Once for a scene, which must outlive it.
    void prepare(const Scene& scene) { scene_ = &scene; }
    /// The surfaces that a pinhole sees in the pixels' middles.
    void see_front(const Shot& shot, const Needs& needs, Context& context);
    /// Behind each of them the next ones.
    void see_behind(const Shot& shot, const Needs& needs, Context& context);
    /// Behind all that is nearer than a depth the first that is farther.
    void see_beyond(float depth, const Shot& shot, const Needs& needs, Context& context);

    [[nodiscard]] Size size() const { return colour_.size(); }
    [[nodiscard]] const Image<Rgb>& colour() const { return colour_; }
    [[nodiscard]] const Image<float>& depth() const { return depth_; }  ///< infinite: the sky
    /// What is behind pixels, and where a pixel's part of it begins: `none` when there is nothing.
    [[nodiscard]] const std::vector<Hidden>& hidden() const { return hidden_; }
    [[nodiscard]] std::uint32_t behind(int x, int y) const { return first_(x, y); }
    static constexpr std::uint32_t none = ~std::uint32_t{0};

 private:
    template <class Peel>
    void peel(const Shot& shot, const Needs& needs, Context& context, const Peel& peel_pixel);

    const Scene* scene_ = nullptr;
    Image<Hit> hits_;
    Image<Rgb> colour_;
    Image<float> depth_;
    Image<std::uint32_t> first_;
    std::vector<Hidden> hidden_;
};

}  // namespace luch::techniques::layered
