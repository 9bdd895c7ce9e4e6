#include "framework/trace/ray_log.h"

#include <cassert>

namespace luch {
namespace {

Json vector_json(const Vec3d& v) {
    return Json::array().push(v.x).push(v.y).push(v.z);
}

Json optional_json(bool present, Json value) {
    return present ? std::move(value) : Json(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace

void RayLog::add(LoggedRay ray) {
    ray.parent = parent_;
    ray.depth =
        parent_ == LoggedRay::no_parent ? 0 : rays_[static_cast<std::size_t>(parent_)].depth + 1;
    rays_.push_back(ray);
}

void RayLog::closest(RayKind kind, std::span<const Ray> rays, std::span<const Hit> hits) {
    assert(rays.size() == hits.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        latest_ = static_cast<int>(rays_.size());
        add({.kind = kind,
             .ray = rays[i],
             .fate = hits[i] ? LoggedRay::met : LoggedRay::sky,
             .t = hits[i].t,
             .node = hits[i].node});
    }
}

void RayLog::occluded(RayKind kind, std::span<const Ray> rays, std::span<const Hit> blockers) {
    assert(rays.size() == blockers.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Hit& blocker = blockers[i];
        add({.kind = kind,
             .ray = rays[i],
             .fate = blocker ? LoggedRay::blocked : LoggedRay::lit,
             .t = blocker ? blocker.t : rays[i].t_max,
             .node = blocker.node});
    }
}

Json ray_log_json(const RayLog& log, const Scene& scene) {
    static constexpr std::string_view fates[] = {"", "sky", "lit", "blocked"};
    Json list = Json::array();
    int id = 0;
    for (const LoggedRay& ray : log.rays()) {
        const std::string name = ray.node == no_node ? "" : scene.nodes[ray.node].name;
        Json one = Json::object();
        one.set("id", id++)
            .set("parent", optional_json(ray.parent != LoggedRay::no_parent, ray.parent))
            .set("kind", ray_kind_names[static_cast<std::size_t>(ray.kind)])
            .set("depth", ray.depth)
            .set("origin", vector_json(ray.ray.origin))
            .set("direction", vector_json(ray.ray.direction))
            .set("end", optional_json(std::isfinite(ray.t), vector_json(ray.end())))
            .set("hit", ray.fate == LoggedRay::met ? name : fates[ray.fate]);
        if (ray.fate == LoggedRay::blocked) one.set("by", name);
        list.push(std::move(one));
    }
    return list;
}

}  // namespace luch
