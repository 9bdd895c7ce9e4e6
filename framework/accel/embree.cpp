#include "framework/accel/embree.h"

#include "framework/accel/embree_tree.h"

#include <embree3/rtcore.h>

namespace luch {

namespace {

RTCIntersectContext context_of(bool coherent) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags =
        coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    return context;
}

Hit hit_of(float t_far, unsigned primitive, bool occluded) {
    if (occluded) return {.t = t_far, .node = 0};
    if (primitive == RTC_INVALID_GEOMETRY_ID) return {};
    return {.t = t_far, .node = 0, .primitive = primitive};
}

constexpr float blocked = -std::numeric_limits<float>::infinity();

/// Rays one after another, shot alone or as a stream.
class Rows final : public EmbreeScene::Batch {
 public:
    Rows(RTCScene scene, std::span<const Ray> rays, bool stream, bool coherent)
        : scene_(scene), context_(context_of(coherent)), stream_(stream), rays_(rays.size()) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Vec3 o(rays[i].origin), d(rays[i].direction);
            rays_[i].ray = {o.x, o.y, o.z,           rays[i].t_min, d.x, d.y,
                            d.z, 0,   rays[i].t_max, ~0u,           0,   0};
            limits_.push_back(rays[i].t_max);
        }
    }
    void reset() override {
        for (std::size_t i = 0; i < rays_.size(); ++i) {
            rays_[i].ray.tfar = limits_[i];
            rays_[i].hit.geomID = rays_[i].hit.primID = RTC_INVALID_GEOMETRY_ID;
        }
    }
    void shoot(std::size_t first, std::size_t last, bool occlusion) override {
        RTCIntersectContext context = context_;
        if (stream_) {
            constexpr std::size_t stride = sizeof(RTCRayHit);
            const auto n = static_cast<unsigned>(last - first);
            if (occlusion) return rtcOccluded1M(scene_, &context, &rays_[first].ray, n, stride);
            return rtcIntersect1M(scene_, &context, &rays_[first], n, stride);
        }
        for (std::size_t i = first; i < last; ++i) {
            if (occlusion) {
                rtcOccluded1(scene_, &context, &rays_[i].ray);
            } else {
                rtcIntersect1(scene_, &context, &rays_[i]);
            }
        }
    }
    [[nodiscard]] Hit hit(std::size_t i) const override {
        return hit_of(rays_[i].ray.tfar, rays_[i].hit.primID, rays_[i].ray.tfar == blocked);
    }

 private:
    RTCScene scene_;
    RTCIntersectContext context_;
    bool stream_;
    std::vector<RTCRayHit> rays_;
    std::vector<float> limits_;
};

void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit8* rays) {
    rtcIntersect8(valid, scene, context, rays);
}
void intersect(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit16* rays) {
    rtcIntersect16(valid, scene, context, rays);
}
void occluded(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit8* rays) {
    rtcOccluded8(valid, scene, context, &rays->ray);
}
void occluded(const int* valid, RTCScene scene, RTCIntersectContext* context, RTCRayHit16* rays) {
    rtcOccluded16(valid, scene, context, &rays->ray);
}

/// Rays in packets of N.
template <class Packet, int N>
class Packets final : public EmbreeScene::Batch {
 public:
    Packets(RTCScene scene, std::span<const Ray> rays, bool coherent)
        : scene_(scene), context_(context_of(coherent)), packets_(rays.size() / N) {
        for (std::size_t i = 0; i < rays.size(); ++i) {
            auto& ray = packets_[i / N].ray;
            const std::size_t k = i % N;
            ray.org_x[k] = static_cast<float>(rays[i].origin.x);
            ray.org_y[k] = static_cast<float>(rays[i].origin.y);
            ray.org_z[k] = static_cast<float>(rays[i].origin.z);
            ray.dir_x[k] = static_cast<float>(rays[i].direction.x);
            ray.dir_y[k] = static_cast<float>(rays[i].direction.y);
            ray.dir_z[k] = static_cast<float>(rays[i].direction.z);
            ray.tnear[k] = rays[i].t_min;
            ray.mask[k] = ~0u;
            limits_.push_back(rays[i].t_max);
        }
    }
    void reset() override {
        for (std::size_t i = 0; i < limits_.size(); ++i) {
            packets_[i / N].ray.tfar[i % N] = limits_[i];
            packets_[i / N].hit.geomID[i % N] = RTC_INVALID_GEOMETRY_ID;
            packets_[i / N].hit.primID[i % N] = RTC_INVALID_GEOMETRY_ID;
        }
    }
    void shoot(std::size_t first, std::size_t last, bool occlusion) override {
        RTCIntersectContext context = context_;
        alignas(64) int valid[N];
        std::fill(valid, valid + N, -1);
        for (std::size_t i = first / N; i < last / N; ++i) {
            if (occlusion) {
                occluded(valid, scene_, &context, &packets_[i]);
            } else {
                intersect(valid, scene_, &context, &packets_[i]);
            }
        }
    }
    [[nodiscard]] Hit hit(std::size_t i) const override {
        const Packet& packet = packets_[i / N];
        const float t = packet.ray.tfar[i % N];
        return hit_of(t, packet.hit.primID[i % N], t == blocked);
    }

 private:
    RTCScene scene_;
    RTCIntersectContext context_;
    std::vector<Packet> packets_;
    std::vector<float> limits_;
};

}  // namespace

bool has_embree() {
    return true;
}

EmbreeScene::EmbreeScene(const Mesh& mesh, float scale, bool robust, Isa isa)
    : tree_(std::make_unique<EmbreeTree>(mesh, scale, robust, isa)) {}

EmbreeScene::~EmbreeScene() = default;

std::unique_ptr<EmbreeScene::Batch> EmbreeScene::batch(std::span<const Ray> rays, EmbreeMode mode,
                                                       bool coherent) const {
    if (mode == EmbreeMode::packet8) {
        return std::make_unique<Packets<RTCRayHit8, 8>>(tree_->scene(), rays, coherent);
    }
    if (mode == EmbreeMode::packet16) {
        return std::make_unique<Packets<RTCRayHit16, 16>>(tree_->scene(), rays, coherent);
    }
    return std::make_unique<Rows>(tree_->scene(), rays, mode == EmbreeMode::stream, coherent);
}

}  // namespace luch
