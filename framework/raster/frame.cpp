#include "framework/raster/frame.h"

#include "framework/base/error.h"
#include "framework/math/bounds.h"

#include <algorithm>

namespace luch::raster {
namespace {

/// How far from its world box a node's hit may lie, relative to the distance: see slack_of() in
/// accelerator.cpp; twice that.
double slack_of(const Node& node) {
    return 0x1p-18 * max_norm(node.to_world.matrix) * max_norm(node.to_object.matrix);
}

/// Whether a facet may have something in a bin.
bool may_touch(const Facet& facet, int left, int top) {
    const auto x = static_cast<float>(left - static_cast<int>(facet.x));
    const auto y = static_cast<float>(top - static_cast<int>(facet.y));
    bool outside = false, inside = false;
    for (const auto& edge : facet.edge) {
        const float at = edge[0] + (x * edge[1] + y * edge[2]);
        constexpr float side = bin_side - 1;
        const float hi = at + side * (std::max(edge[1], 0.0f) + std::max(edge[2], 0.0f));
        const float lo = at + side * (std::min(edge[1], 0.0f) + std::min(edge[2], 0.0f));
        outside |= hi < -far_outside;
        inside |= lo > far_outside;
    }
    return !(outside && (inside || facet.kind == Kind::regular));
}

Span relative(const Span& span, int x, int y) {
    const auto from = [](int a, int b) {
        return static_cast<std::int16_t>(std::clamp(a - b, -1, 2 * bin_side));
    };
    return {from(span.x0, x), from(span.y0, y), from(span.x1, x), from(span.y1, y)};
}

void add_mark(Batch& marks, const Extent& extent) {
    if (extent.span.empty()) return;
    Facet facet{};
    facet.kind = Kind::doubtful;
    facet.doubt = extent.nearest;
    facet.item = no_item;
    marks.facets.push_back(facet);
    marks.spans.push_back(extent.span);
}

Boxd relative_box(const Box& box, const View& view) {
    const Vec3 origin(view.origin[0], view.origin[1], view.origin[2]);
    return {Vec3d(box.lo) - Vec3d(origin), Vec3d(box.hi) - Vec3d(origin)};
}

}  // namespace

const Stock::Model& Stock::model_of(std::uint32_t item) const {
    const auto after = std::upper_bound(models.begin(), models.end(), item,
                                        [](std::uint32_t i, const Model& m) { return i < m.base; });
    return *std::prev(after);
}

std::uint64_t Stock::bytes() const {
    std::uint64_t sum = models.size() * sizeof(Model) + others.size() * sizeof(Other);
    for (const auto& soup : soups) sum += soup ? soup->bytes() : 0;
    return sum;
}

Stock stock_of(const Scene& scene, bool with_others) {
    Stock stock;
    stock.soups.resize(scene.geometries.size());
    std::uint64_t base = 0;
    for (NodeId id = 0; id < scene.nodes.size(); ++id) {
        const Node& node = scene.nodes[id];
        const auto* mesh = std::get_if<Mesh>(&scene.geometries[node.geometry]);
        if (mesh == nullptr) {
            if (!with_others) continue;
            stock.others.push_back(
                {node.to_world.box(bounds_of(scene.geometries[node.geometry])), slack_of(node)});
            continue;
        }
        auto& soup = stock.soups[node.geometry];
        if (!soup) soup = std::make_unique<Soup>(soup_of(*mesh));
        if (soup->triangles.empty()) continue;
        stock.models.push_back({id, soup.get(), static_cast<std::uint32_t>(base)});
        base += soup->triangles.size();
        if (base >= no_item) {
            throw Error(
                "the scene has more than 2^31 triangles, instances counted; an item "
                "buffer cannot number them");
        }
    }
    return stock;
}

void Frame::draw(const Scene& scene, const Stock& stock, const Kernels& kernels, const Sight& sight,
                 const Workers& workers, bool with_depths) {
    size_ = sight.screen->size();
    bins_across_ = (size_.width + bin_side - 1) / bin_side;
    bins_down_ = (size_.height + bin_side - 1) / bin_side;
    const std::size_t pixels = static_cast<std::size_t>(bins_across_) *
                               static_cast<std::size_t>(bins_down_) * pixels_of_bin;
    items.resize(pixels);
    near.resize(with_depths ? pixels : 0);
    second.resize(with_depths ? pixels : 0);
    look(scene, stock, sight);
    set_up(kernels, workers);
    bins_.resize(static_cast<std::size_t>(workers.count()));
    workers.for_each(bins_down_, [&](int row, int worker) {
        auto& own = bins_[static_cast<std::size_t>(worker)];
        own.resize(static_cast<std::size_t>(bins_across_));
        sort_into_row(row, own);
        draw_row(kernels, row, own);
    });
}

/// Which chunks may be seen, the nearest first, and the marks of all else.
void Frame::look(const Scene& scene, const Stock& stock, const Sight& sight) {
    marks_ = {};
    marks_.last_row = bins_down_ - 1;
    for (const Stock::Other& other : stock.others) {
        if (!other.box.empty()) add_mark(marks_, world_extent_of(sight, other.box, other.slack));
    }
    views_.clear();
    views_.reserve(stock.models.size());
    seen_ = 0;
    for (const Stock::Model& model : stock.models) {
        const Node& node = scene.nodes[model.node];
        View& view = views_.emplace_back(view_of(sight, node));
        view.base = model.base;
        view.cull_backfaces = model.soup->cull_backfaces;
        if (view.hopeless) {
            add_mark(marks_, everywhere(size_));
            continue;
        }
        for (std::uint32_t i = 0; i < model.soup->chunks.size(); ++i) {
            const Extent extent = extent_of(view, relative_box(model.soup->chunks[i].box, view));
            if (extent.span.empty()) continue;
            if (seen_ == batches_.size()) batches_.emplace_back();
            Batch& batch = batches_[seen_++];
            batch.view = &view;
            batch.soup = model.soup;
            batch.chunk = i;
            batch.nearest = extent.nearest;
        }
    }
    std::stable_sort(batches_.begin(), batches_.begin() + static_cast<std::ptrdiff_t>(seen_),
                     [](const Batch& a, const Batch& b) { return a.nearest > b.nearest; });
}

void Frame::set_up(const Kernels& kernels, const Workers& workers) {
    struct Room {
        std::vector<Facet> facets = std::vector<Facet>(chunk_width);
        std::vector<Span> spans = std::vector<Span>(chunk_width);
    };
    std::vector<Room> rooms(static_cast<std::size_t>(workers.count()));
    workers.for_each(static_cast<int>(seen_), [&](int i, int worker) {
        Batch& batch = batches_[static_cast<std::size_t>(i)];
        Room& room = rooms[static_cast<std::size_t>(worker)];
        const Chunk& chunk = batch.soup->chunks[batch.chunk];
        const int count =
            kernels.set_up(*batch.view, batch.soup->blocks.data() + chunk.first,
                           static_cast<int>(chunk.count), room.facets.data(), room.spans.data());
        batch.facets.assign(room.facets.begin(), room.facets.begin() + count);
        batch.spans.assign(room.spans.begin(), room.spans.begin() + count);
        batch.first_row = bins_down_;
        batch.last_row = -1;
        for (const Span& span : batch.spans) {
            batch.first_row = std::min(batch.first_row, span.y0 / bin_side);
            batch.last_row = std::max(batch.last_row, span.y1 / bin_side);
        }
    });
}

void Frame::sort_into_row(int row, std::vector<std::vector<Entry>>& bins) const {
    for (auto& bin : bins) bin.clear();
    const int y = row * bin_side;
    const auto sort = [&](const Batch& batch) {
        if (row < batch.first_row || row > batch.last_row) return;
        for (std::size_t i = 0; i < batch.spans.size(); ++i) {
            const Span& span = batch.spans[i];
            if (span.y1 < y || span.y0 >= y + bin_side) continue;
            const int first = span.x0 / bin_side, last = span.x1 / bin_side;
            const bool one = first == last && span.y1 - span.y0 < bin_side;
            for (int bin = first; bin <= last; ++bin) {
                const int x = bin * bin_side;
                const Facet& facet = batch.facets[i];
                if (!one && !may_touch(facet, x, y)) {
                    continue;
                }
                bins[static_cast<std::size_t>(bin)].push_back({&facet, relative(span, x, y)});
            }
        }
    };
    sort(marks_);
    for (std::size_t i = 0; i < seen_; ++i) sort(batches_[i]);
}

void Frame::draw_row(const Kernels& kernels, int row, std::vector<std::vector<Entry>>& bins) {
    for (int bin = 0; bin < bins_across_; ++bin) {
        const std::vector<Entry>& entries = bins[static_cast<std::size_t>(bin)];
        const std::size_t at =
            (static_cast<std::size_t>(row) * static_cast<std::size_t>(bins_across_) +
             static_cast<std::size_t>(bin)) *
            pixels_of_bin;
        kernels.draw(entries.data(), static_cast<int>(entries.size()), bin * bin_side,
                     row * bin_side, near.empty() ? nullptr : near.data() + at,
                     second.empty() ? nullptr : second.data() + at, items.data() + at);
    }
}

std::uint64_t Frame::bytes() const {
    std::uint64_t sum = items.capacity() * sizeof(std::uint32_t) +
                        (near.capacity() + second.capacity()) * sizeof(float);
    for (const Batch& batch : batches_) {
        sum += batch.facets.capacity() * sizeof(Facet) + batch.spans.capacity() * sizeof(Span);
    }
    for (const auto& row : bins_) {
        for (const auto& bin : row) sum += bin.capacity() * sizeof(Entry);
    }
    return sum;
}

}  // namespace luch::raster
