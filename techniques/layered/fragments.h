#pragma once

#include "framework/raster/item_buffer.h"
#include "framework/technique/context.h"
#include "framework/trace/parts.h"
#include "techniques/layered/layered.h"

#include <limits>
#include <optional>
#include <vector>

namespace luch::techniques::layered {

/// Something that is seen only when what is in front of it is not there.
struct Hidden {
    Rgb colour{0};
    float depth = 0;
    bool last = true;  ///< of its pixel; else the next one is farther
};

class Openings;
class Peeler;
struct Peeled;

/// How a sharp picture is to be made.
struct Wish {
    int detail = 1;       ///< texels a pixel along each axis
    int margin_px = 0;    ///< seen beyond each side of the frame
    bool raster = false;  ///< the front comes from the item buffer
    /// Pixels of one node that are blurred over more than this, in px of diameter, are lit once.
    float lit_once_px = std::numeric_limits<float>::infinity();
    bool edges = false;  ///< what the lens may see past edges is looked for
    float behind = 0;    ///< > 0: instead, behind all that is nearer, the first that is farther
};

/// A sharp picture with what is behind it: in each texel the surface that a pinhole in the middle
/// of the lens sees, and where it is asked for, the surfaces behind.
class Fragments {
 public:
    /// Once for a scene, which must outlive it.
    void prepare(const Scene& scene, bool raster);
    void look(const Shot& shot, const Wish& wish, const Needs& needs, Context& context);

    [[nodiscard]] Size size() const { return colour_.size(); }
    [[nodiscard]] const Wish& wish() const { return wish_; }
    [[nodiscard]] const Image<Rgb>& colour() const { return colour_; }
    [[nodiscard]] const Image<float>& depth() const { return depth_; }  ///< infinite: the sky
    /// What is behind pixels (it is blurred: one ray a pixel does), and where the part begins that
    /// belongs to a texel's pixel: `none` when nothing is known.
    [[nodiscard]] const std::vector<Hidden>& hidden() const { return hidden_; }
    [[nodiscard]] std::uint64_t lit() const { return lit_; }  ///< texels of the front
    [[nodiscard]] std::uint32_t behind(int x, int y) const {
        return first_(x / wish_.detail, y / wish_.detail);
    }
    static constexpr std::uint32_t none = ~std::uint32_t{0};

 private:
    void see_front(const Shot& fine, Context& context);
    void light_front(const Shot& fine, const Lens& lens, const Needs& needs, Context& context);
    [[nodiscard]] bool is_lit_once(int x, int y, const Lens& lens) const;
    void see_behind(const Shot& fine, const Lens& lens, const Needs& needs, Context& context);
    void see_behind(Tile pixels, const Openings& openings, const Peeler& peeler, Peeled& found);

    const Scene* scene_ = nullptr;
    std::optional<ItemBuffer> buffer_;
    Wish wish_;
    Image<Hit> hits_;
    Image<Rgb> colour_;
    Image<float> depth_;
    Image<std::uint32_t> first_;  ///< of pixels
    std::vector<Hidden> hidden_;
    std::uint64_t lit_ = 0;
};

/// As many texels a pixel as are asked for, or as a picture of that size can have.
int detail_for(Size frame, int asked);

/// How far beyond the frame lens rays go, from what a few rays see: pixels.
int margin_for(const Shot& shot, Tracer& tracer);

/// The camera without its lens, with the field of view that a margin around the frame needs; the
/// middle of the frame's pixels stay where they are.
Camera padded(const Camera& camera, Size size, int margin_px);

}  // namespace luch::techniques::layered
