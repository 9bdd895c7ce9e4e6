#pragma once

#include "framework/accel/isa.h"
#include "framework/math/ray.h"
#include "framework/scene/geometry.h"

#include <array>
#include <memory>
#include <span>
#include <string_view>

// Embree as a peer: what benchmarks race against and tests compare with, when it is installed.
namespace luch {

class EmbreeTree;

/// Whether this build has Embree; the class below throws Error when it does not.
bool has_embree();

/// How rays are given to Embree.
enum class EmbreeMode { single, packet8, packet16, stream };
inline constexpr std::array<std::string_view, 4> embree_mode_names{"single", "packet8", "packet16",
                                                                   "stream"};

/// One mesh in an Embree scene of medium build quality, built by the calling thread alone.
class EmbreeScene {
 public:
    /// Corners times `scale`. `robust`: Embree's RTC_SCENE_FLAG_ROBUST. It uses no instructions
    /// beyond `isa`.
    EmbreeScene(const Mesh& mesh, float scale, bool robust, Isa isa);
    ~EmbreeScene();

    /// Rays in Embree's own layout for a mode, and what they met.
    class Batch {
     public:
        virtual ~Batch() = default;
        /// Forgets the last run's hits.
        virtual void reset() = 0;
        /// Shoots rays [first, last), both multiples of 16; occlusion only, or the nearest hits.
        virtual void shoot(std::size_t first, std::size_t last, bool occlusion) = 0;
        /// What ray i met: t and primitive of the nearest hit, or any node but no_node for an
        /// occluded ray.
        [[nodiscard]] virtual Hit hit(std::size_t i) const = 0;
    };
    /// Rays with t_max < t_min are inactive. Their number must be a multiple of 16; `coherent` is
    /// passed on as a hint.
    [[nodiscard]] std::unique_ptr<Batch> batch(std::span<const Ray> rays, EmbreeMode mode,
                                               bool coherent) const;

 private:
    std::unique_ptr<EmbreeTree> tree_;
};

}  // namespace luch
