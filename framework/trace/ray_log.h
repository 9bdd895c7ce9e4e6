#pragma once

#include "framework/base/json.h"
#include "framework/trace/counts.h"

#include <span>
#include <vector>

namespace luch {

/// A ray as it went: a branch of a tree.
struct LoggedRay {
    static constexpr int no_parent = -1;
    /// met: a surface. lit, blocked: of a shadow ray, which only asks whether anything is between.
    enum Fate { met, sky, lit, blocked };

    int parent = no_parent;  ///< index of the ray at whose end this one was thought of
    RayKind kind = RayKind::primary;
    int depth = 0;  ///< one more than the parent's; 0 without one
    Ray ray;
    Fate fate = sky;
    double t = 0;           ///< where it ends: ray.at(t). Infinite for the sky
    NodeId node = no_node;  ///< what it met, or what blocked it

    [[nodiscard]] Vec3d end() const { return ray.at(t); }
};

/// The tree of rays of one pixel, recorded by a Tracer that was told to. A ray's parent is whatever
/// Branch says when it is shot.
class RayLog {
 public:
    [[nodiscard]] const std::vector<LoggedRay>& rays() const { return rays_; }
    void clear() { *this = {}; }

    /// What the tracer shot and found. `blockers`: the nearest thing between, if any.
    void closest(RayKind kind, std::span<const Ray> rays, std::span<const Hit> hits);
    void occluded(RayKind kind, std::span<const Ray> rays, std::span<const Hit> blockers);

    /// Says whose children the next rays are, until it ends; then it is as before. A recursive
    /// tracer makes one at each surface point and calls follow() once; one that is a loop makes one
    /// for each path and calls follow() after each segment. With a null log it does nothing.
    class Branch {
     public:
        explicit Branch(RayLog* log) : log_(log), parent_(log ? log->parent_ : 0) {}
        ~Branch() {
            if (log_ != nullptr) log_->parent_ = parent_;
        }
        Branch(const Branch&) = delete;
        Branch& operator=(const Branch&) = delete;
        /// The ray whose closest hit was found last is the parent from now on.
        void follow() {
            if (log_ != nullptr) log_->parent_ = log_->latest_;
        }

     private:
        RayLog* log_;
        int parent_;
    };

 private:
    void add(LoggedRay ray);
    std::vector<LoggedRay> rays_;
    int parent_ = LoggedRay::no_parent;
    int latest_ = LoggedRay::no_parent;
};

/// All rays as an array of objects {id, parent, kind, depth, origin, direction, end, hit}. `parent`
/// is null for a camera ray, `end` for one to the sky; `hit` is a node's name, "sky", "lit" or
/// "blocked", and a blocked one has `by` too, a node's name.
Json ray_log_json(const RayLog& log, const Scene& scene);

}  // namespace luch
