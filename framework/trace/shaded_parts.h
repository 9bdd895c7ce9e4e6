#pragma once

#include "framework/scene/word_texture.h"

#include <cstdint>
#include <vector>

namespace luch {

/// What the light of some points is made of, before it is summed. Of a lit point (Lambert, Phong):
/// albedo · (ambient light + Σ diffuse) + Σ highlight, over the scene's lights. Of a layered one:
/// what its layers show, to be blended in turn; of layers nothing more is told. Of all others (sky,
/// mirrors, clear things…) nothing is.
class ShadedParts {
 public:
    /// A light's share at every point; empty planes where it adds nothing anywhere.
    struct Light {
        std::vector<Rgb> diffuse, highlight;
    };
    /// The k-th layer that was looked into, at every point: black under a blend of 0 where there is
    /// none.
    struct Layer {
        std::vector<Rgb> blend, light;
    };
    enum class Kind : std::uint8_t { other, lit, layered };

    /// Forgets all; room for so many points and lights.
    void reset(std::size_t points, std::size_t lights) {
        kinds_.assign(points, Kind::other);
        albedo_.assign(points, Rgb(0));
        depth_.assign(points, 0);
        lights_.resize(lights);
        for (Light& light : lights_) {
            light.diffuse.clear();
            light.highlight.clear();
        }
        layers_.clear();
    }

    [[nodiscard]] std::size_t points() const { return kinds_.size(); }
    [[nodiscard]] const std::vector<Kind>& kinds() const { return kinds_; }
    [[nodiscard]] const std::vector<Rgb>& albedo() const { return albedo_; }
    [[nodiscard]] const std::vector<Light>& lights() const { return lights_; }
    [[nodiscard]] const std::vector<Layer>& layers() const { return layers_; }

    /// Bitmaps in words that are to be looked at instead of the scene's; null: none. They outlive
    /// this.
    void use(const WordTextures* textures) { textures_ = textures; }

    // For the tracer.
    [[nodiscard]] bool has_words(TextureId texture) const {
        return textures_ != nullptr && (*textures_)[texture].has_value();
    }
    [[nodiscard]] Rgb from_words(TextureId texture, const Vec2d& uv) const {
        return (*textures_)[texture]->colour_at(uv);
    }
    void lit(std::size_t point, const Rgb& albedo) {
        kinds_[point] = Kind::lit;
        albedo_[point] = albedo;
    }
    /// More of a light, a sample of it.
    void light(std::size_t point, std::size_t light, const Rgb& diffuse, const Rgb& highlight) {
        add(lights_[light].diffuse, point, diffuse);
        add(lights_[light].highlight, point, highlight);
    }
    void layer(std::size_t point, const Rgb& blend, const Rgb& light) {
        kinds_[point] = Kind::layered;
        const std::size_t k = depth_[point]++;
        if (k == layers_.size()) {
            layers_.push_back({std::vector(points(), Rgb(0)), std::vector(points(), Rgb(0))});
        }
        layers_[k].blend[point] = blend;
        layers_[k].light[point] = light;
    }

 private:
    void add(std::vector<Rgb>& plane, std::size_t point, const Rgb& more) const {
        if (more == Rgb(0)) return;
        if (plane.empty()) plane.assign(points(), Rgb(0));
        plane[point] += more;
    }

    const WordTextures* textures_ = nullptr;
    std::vector<Kind> kinds_;
    std::vector<Rgb> albedo_;
    std::vector<std::size_t> depth_;  ///< layers so far, by point
    std::vector<Light> lights_;
    std::vector<Layer> layers_;
};

}  // namespace luch
