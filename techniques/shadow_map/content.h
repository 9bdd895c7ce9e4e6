#pragma once

#include "framework/math/rng.h"
#include "framework/scene/scene.h"

#include <vector>

namespace luch::techniques::shadow_map {

/// What of a scene shadows depend on: where each node's surface is, as a box and as a key that
/// changes when anything of it does. Materials do not count but for whether light falls on them.
class Content {
 public:
    struct Thing {
        Key key;
        Boxd box;  ///< in world space, padded for rounding; infinite sides stay infinite
        bool receives = false;
    };
    Content() = default;
    explicit Content(const Scene& scene);

    /// By NodeId.
    [[nodiscard]] const std::vector<Thing>& things() const { return things_; }
    /// Changes when anything does.
    [[nodiscard]] std::uint64_t digest() const { return digest_; }

 private:
    std::vector<Thing> things_;
    std::uint64_t digest_ = 0;
};

/// Follows a key with the bits of numbers.
Key followed(Key key, double number);
Key followed(Key key, const Vec3d& numbers);

}  // namespace luch::techniques::shadow_map
