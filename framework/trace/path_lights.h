#pragma once

#include "framework/trace/light_tree.h"
#include "framework/trace/rect_sampler.h"
#include "framework/trace/sky_sampler.h"

namespace luch {

/// A scene's lights, made ready for a path tracer. Refers to the scene, which must outlive it.
class PathLights {
 public:
    explicit PathLights(const Scene& scene);

    /// The lights that have a place.
    [[nodiscard]] const LightTree& placed() const { return tree_; }
    [[nodiscard]] const SkySampler& sky() const { return sky_; }
    /// Whether a ray can run into any of the lights.
    [[nodiscard]] bool can_be_met() const { return !rects_.empty() || !sky_.black(); }

    struct Distant {
        const DirectionalLight* light;
        double probability;
    };
    /// One of the directional lights, by their power; nothing when there are none.
    [[nodiscard]] std::optional<Distant> choose_distant(double random) const;

    /// The sampler of a RectLight.
    [[nodiscard]] const RectSampler& rect(std::uint32_t light) const {
        return rects_[rect_of_light_[light]];
    }
    static constexpr std::uint32_t no_light = ~std::uint32_t{0};
    /// The RectLight whose visible face a node is, as an index into the lights; else no_light.
    [[nodiscard]] std::uint32_t light_of(NodeId node) const { return light_of_node_[node]; }

 private:
    void match_faces(const Scene& scene);

    LightTree tree_;
    SkySampler sky_;
    std::vector<RectSampler> rects_;
    std::vector<std::uint32_t> rect_of_light_;
    std::vector<std::uint32_t> light_of_node_;
    std::vector<const DirectionalLight*> distant_;
    std::vector<double> distant_sums_;  ///< their powers, added up to 1
};

}  // namespace luch
