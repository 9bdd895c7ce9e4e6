#pragma once

#include "framework/accel/isa.h"
#include "framework/scene/geometry.h"

#include <atomic>
#include <cstdint>

// The library's own types, without its header.
struct RTCDeviceTy;
struct RTCSceneTy;

namespace luch {

/// A mesh's triangles in an Embree scene of medium build quality, built by the calling thread
/// alone. It uses no instructions beyond `isa`.
class EmbreeTree {
 public:
    /// Corners times `scale`. `robust`: Embree's RTC_SCENE_FLAG_ROBUST.
    EmbreeTree(const Mesh& mesh, float scale, bool robust, Isa isa);
    EmbreeTree(const EmbreeTree&) = delete;
    EmbreeTree& operator=(const EmbreeTree&) = delete;
    ~EmbreeTree();

    [[nodiscard]] RTCSceneTy* scene() const { return scene_; }
    /// Memory that the library holds for it.
    [[nodiscard]] std::uint64_t bytes() const { return static_cast<std::uint64_t>(bytes_.load()); }

 private:
    std::atomic<std::int64_t> bytes_ = 0;
    [[maybe_unused]] RTCDeviceTy* device_ = nullptr;
    RTCSceneTy* scene_ = nullptr;
};

}  // namespace luch
