#pragma once

#include "framework/raster/item_buffer.h"
#include "techniques/shadow_map/cube.h"

#include <optional>

namespace luch::techniques::shadow_map {

/// Fills whole faces of maps by rasterising them: what each texel's centre sees, found by the item
/// buffer of a camera that stands in the light. The same surfaces as Steps::render_face finds, at
/// the same distances but for rounding.
class FaceRaster {
 public:
    explicit FaceRaster(const Scene& scene);

    /// `distance` is n × n. What the item buffer leaves in doubt is traced, as shadow rays.
    void fill(const Vec3d& light, int face, Context& context, ImageView<float> distance);

 private:
    ItemBuffer buffer_;
};

/// Whether rasterising a face is worth it: most nodes are meshes, of few triangles for its texels.
bool raster_pays(const Scene& scene, int side);

}  // namespace luch::techniques::shadow_map
