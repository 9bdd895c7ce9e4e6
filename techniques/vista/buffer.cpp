#include "techniques/vista/buffer.h"

#include "techniques/vista/plan.h"
#include "techniques/vista/repair.h"
#include "techniques/vista/stand_ins.h"

namespace luch::techniques::vista {
namespace {

/// Painting goes by tiles of this side: large, as a triangle is handled once for every tile it
/// touches.
constexpr int bin_side = 64;
/// Triangles that one call of project() gets.
constexpr int block = 4096;

int blocks(std::size_t count) {
    return static_cast<int>((count + block - 1) / block);
}

/// From a node's own coordinates to view space. Points are made relative to the eye before they are
/// turned, so that a scene far from the origin loses nothing.
class ToView {
 public:
    ToView(const Node& node, const Shot& shot, const Screen& screen)
        : node_(&node), turn_(shot.camera.to_world()), screen_(&screen) {}

    Corner operator()(const Corner& corner) const {
        if (corner.w > 0) {
            return {screen_->to_view(node_->to_world.point(corner.p / corner.w)), 1};
        }
        return {turn_.normal_back(node_->to_world.direction(corner.p)), 0};
    }

 private:
    const Node* node_;
    Transform turn_;
    const Screen* screen_;
};

/// Drops the triangles that no ray from the eye can hit, where a mesh hides its backs.
void drop_backs(const Geometry& geometry, const Vec3d& eye_object, std::vector<Tri>& triangles) {
    const auto* mesh = std::get_if<Mesh>(&geometry);
    if (mesh == nullptr || !mesh->cull_backfaces) return;
    std::erase_if(triangles, [&](const Tri& triangle) {
        const Vec3d a = triangle.corners[0].p;
        const Vec3d normal = glm::cross(triangle.corners[1].p - a, triangle.corners[2].p - a);
        return glm::dot(a - eye_object, normal) > 0;
    });
}

/// The bins that the pixels between two coordinates lie in: first ≤ i < last.
std::pair<int, int> bins_between(double least, double most, int pixels) {
    if (!(most >= least)) return {0, 0};  // not a number: a homework may make one
    const double first = std::clamp(std::floor(least), 0.0, double(pixels));
    const double last = std::clamp(std::ceil(most), first, double(pixels));
    return {static_cast<int>(first) / bin_side, (static_cast<int>(last) + bin_side - 1) / bin_side};
}

}  // namespace

/// lod, tessellate and clip for one node.
std::vector<Tri> ClassicBuffer::in_view(NodeId id, const Scene& scene, const Shot& shot,
                                        const Params& params, Context& context) const {
    const Screen screen(shot.camera, shot.size);
    const Node& node = scene.nodes[id];
    const Geometry& geometry = scene.geometries[node.geometry];
    int n = 0;
    if (context.plan().needed("lod")) {
        const float radius = radius_px(scene, node, screen);
        n = call_step(context, steps_.lod, reference_.lod, geometry, radius);
    }
    if (params.segments != 0) n = asked_segments(params);
    std::vector<Tri> triangles;
    const auto* sphere = std::get_if<Sphere>(&geometry);
    if (sphere != nullptr && Repair(params.repair) != Repair::none) {
        const Geometry larger =
            Sphere{sphere->centre, sphere->radius * circumscribed(std::max(n, least_segments))};
        call_step(context, steps_.tessellate, reference_.tessellate, larger, n, triangles);
    } else {
        call_step(context, steps_.tessellate, reference_.tessellate, geometry, n, triangles);
    }
    drop_backs(geometry, node.to_object.point(screen.eye()), triangles);
    const ToView to_view(node, shot, screen);
    for (Tri& triangle : triangles) {
        for (Corner& corner : triangle.corners) corner = to_view(corner);
        triangle.node = id;
    }
    if (!context.plan().needed("clip")) return triangles;
    std::vector<Tri> inside;
    call_step(context, steps_.clip, reference_.clip, triangles, frustum_of(screen), inside);
    return inside;
}

void ClassicBuffer::collect(const Scene& scene, const Shot& shot, const Params& params,
                            Context& context) {
    std::vector<std::vector<Tri>> of_node(scene.nodes.size());
    context.for_each(static_cast<int>(scene.nodes.size()), [&](int i, int) {
        of_node[static_cast<std::size_t>(i)] =
            in_view(static_cast<NodeId>(i), scene, shot, params, context);
    });
    triangles_.clear();
    for (const auto& some : of_node) triangles_.insert(triangles_.end(), some.begin(), some.end());
    context.pause("clip");
    if (context.plan().needed("lod")) context.did("lod", scene.nodes.size(), "nodes");
    if (context.plan().needed("clip")) context.did("clip", triangles_.size(), "triangles kept");
    if (!context.plan().needed("sort")) return;
    context.did("sort", triangles_.size(), "triangles");
    call_step(context, steps_.sort, reference_.sort, triangles_);
    context.pause("sort");
}

void ClassicBuffer::project(const Screen& screen, Context& context) {
    screen_triangles_.assign(triangles_.size(), {});
    context.for_each(blocks(triangles_.size()), [&](int i, int) {
        const std::size_t first = static_cast<std::size_t>(i) * block;
        const std::size_t count = std::min<std::size_t>(block, triangles_.size() - first);
        call_step(context, steps_.project, reference_.project,
                  std::span<const Tri>(triangles_).subspan(first, count), screen,
                  std::span(screen_triangles_).subspan(first, count));
    });
}

void ClassicBuffer::share_out(Size size) {
    const int across = (size.width + bin_side - 1) / bin_side;
    const int down = (size.height + bin_side - 1) / bin_side;
    bins_.resize(static_cast<std::size_t>(across) * static_cast<std::size_t>(down));
    for (auto& bin : bins_) bin.clear();
    for (std::uint32_t i = 0; i < screen_triangles_.size(); ++i) {
        const auto& [a, b, c] = screen_triangles_[i].px;
        const auto [x0, x1] =
            bins_between(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}), size.width);
        const auto [y0, y1] =
            bins_between(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}), size.height);
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x)
                bins_[static_cast<std::size_t>(y * across + x)].push_back(i);
        }
    }
}

void ClassicBuffer::paint(const Screen& screen, const Params& params, Context& context,
                          ImageView<NodeId> ids, ImageView<float> depth) {
    project(screen, context);
    share_out(screen.size());
    checked_ = Repair(params.repair) == Repair::both;
    if (checked_ && second_.size() != screen.size()) second_ = Image<float>(screen.size());
    const int across = (screen.size().width + bin_side - 1) / bin_side;
    std::vector<std::vector<ScreenTri>> batches(static_cast<std::size_t>(context.workers()));
    context.for_each_tile(
        screen.size(),
        [&](Tile tile, int worker) {
            std::vector<ScreenTri>& batch = batches[static_cast<std::size_t>(worker)];
            batch.clear();
            const int bin = tile.y0 / bin_side * across + tile.x0 / bin_side;
            for (const std::uint32_t i : bins_[static_cast<std::size_t>(bin)]) {
                batch.push_back(screen_triangles_[i]);
            }
            call_step(context, steps_.rasterise, reference_.rasterise,
                      std::span<const ScreenTri>(batch), tile, Hidden(params.hidden), ids, depth);
            if (checked_) second_depths(batch, tile, ids, second_.view());
        },
        bin_side);
    context.pause("rasterise");
}

std::uint64_t ClassicBuffer::look_up(const Screen& screen, Tile tile, int worker, Context& context,
                                     ImageView<const NodeId> ids, ImageView<Hit> hits,
                                     ImageView<std::uint8_t> fell_back) const {
    call_step(context, steps_.look_up, reference_.look_up, screen, tile, ids,
              context.tracer(worker), hits, fell_back);
    if (checked_) {
        trace_doubtful(screen, tile, second_.view(), context.tracer(worker), hits, fell_back);
    }
    std::uint64_t count = 0;
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) count += fell_back(x, y);
    }
    return count;
}

double ClassicBuffer::farthest_depth() const {
    double farthest = 0;
    for (const Tri& triangle : triangles_) {
        for (const auto& [p, w] : triangle.corners) {
            if (w > 0) farthest = std::max(farthest, p.z / w);
        }
    }
    return farthest;
}

}  // namespace luch::techniques::vista
