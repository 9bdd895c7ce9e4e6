#include "framework/scene/loader/blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace luch::loader {
namespace {

void read_solid(Csg::Operation operation, Properties& block, Loading& loading) {
    Csg csg;
    csg.operation = operation;
    csg.left = loading.names.find(Kind::geometry, block, block.required("left"));
    csg.right = loading.names.find(Kind::geometry, block, block.required("right"));
    const auto id = static_cast<GeometryId>(loading.scene.geometries.size());
    loading.solids.push_back({id, block.block().line});
    loading.scene.geometries.emplace_back(std::move(csg));
}

/// A solid and the solids among its two sides, as indices into Loading::solids.
struct Unfolding {
    int waits_for = 0;  ///< sides that are not unfolded yet
    int depth = 1;
    std::vector<std::size_t> users;
};

class Unfolder {
 public:
    explicit Unfolder(Loading& loading)
        : loading_(loading),
          geometries_(loading.scene.geometries),
          unfoldings_(loading.solids.size()) {
        for (std::size_t i = 0; i < unfoldings_.size(); ++i) {
            for (const GeometryId side : sides(i)) {
                const std::size_t used = solid_at(side);
                if (used == unfoldings_.size()) continue;
                unfoldings_[used].users.push_back(i);
                ++unfoldings_[i].waits_for;
            }
        }
    }

    /// Every solid after those that it is made of.
    void unfold_all() {
        std::vector<std::size_t> ready;
        for (std::size_t i = 0; i < unfoldings_.size(); ++i) {
            if (unfoldings_[i].waits_for == 0) ready.push_back(i);
        }
        while (!ready.empty()) {
            const std::size_t i = ready.back();
            ready.pop_back();
            unfold(i);
            for (const std::size_t user : unfoldings_[i].users) {
                Unfolding& of_user = unfoldings_[user];
                of_user.depth = std::max(of_user.depth, unfoldings_[i].depth + 1);
                if (--of_user.waits_for == 0) ready.push_back(user);
            }
        }
        refuse_rings();
    }

 private:
    const Csg& solid(std::size_t i) const {
        return std::get<Csg>(geometries_[loading_.solids[i].geometry]);
    }
    std::array<GeometryId, 2> sides(std::size_t i) const { return {solid(i).left, solid(i).right}; }

    /// Solids stand in the order of their geometries. Their number when it is none of them.
    std::size_t solid_at(GeometryId id) const {
        const auto& solids = loading_.solids;
        const auto found =
            std::lower_bound(solids.begin(), solids.end(), id,
                             [](const auto& solid, GeometryId g) { return solid.geometry < g; });
        const bool is_one = found != solids.end() && found->geometry == id;
        return static_cast<std::size_t>((is_one ? found : solids.end()) - solids.begin());
    }

    void unfold(std::size_t i) {
        constexpr int deepest = 256;
        constexpr std::size_t most_parts_in_all = 1 << 20;
        const auto [id, line] = loading_.solids[i];
        if (unfoldings_[i].depth > deepest) {
            loading_.diagnostics.fail(
                line, fmt::format("the solids are nested deeper than {}; use fewer", deepest));
        }
        const auto [left, right] = sides(i);
        try {
            Csg unfolded = make_csg(solid(i).operation, left, right, geometries_);
            parts_ += unfolded.parts.size();
            geometries_[id] = std::move(unfolded);
        } catch (const std::length_error&) {
            loading_.diagnostics.fail(
                line, fmt::format("the solid unfolds to more than {} parts, or to more than 2^32 - "
                                  "1 primitives; use fewer",
                                  Csg::most_parts));
        }
        if (parts_ > most_parts_in_all) {
            loading_.diagnostics.fail(line, fmt::format("the scene's solids unfold to more than {} "
                                                        "parts in all; use fewer",
                                                        most_parts_in_all));
        }
    }

    /// From a solid that waits for ever, following sides that wait too, one comes into the ring.
    void refuse_rings() const {
        const auto waits = [&](std::size_t i) {
            return i < unfoldings_.size() && unfoldings_[i].waits_for > 0;
        };
        std::size_t at = 0;
        while (at < unfoldings_.size() && !waits(at)) ++at;
        if (at == unfoldings_.size()) return;
        for (std::size_t steps = 0; steps < unfoldings_.size(); ++steps) {
            const auto [left, right] = sides(at);
            at = waits(solid_at(left)) ? solid_at(left) : solid_at(right);
        }
        loading_.diagnostics.fail(loading_.solids[at].line,
                                  "the solid contains itself; change its left or its right");
    }

    Loading& loading_;
    std::vector<Geometry>& geometries_;
    std::vector<Unfolding> unfoldings_;
    std::size_t parts_ = 0;
};

}  // namespace

void read_union(Properties& block, Loading& loading) {
    read_solid(Csg::Operation::join, block, loading);
}
void read_intersection(Properties& block, Loading& loading) {
    read_solid(Csg::Operation::intersect, block, loading);
}
void read_difference(Properties& block, Loading& loading) {
    read_solid(Csg::Operation::subtract, block, loading);
}

void unfold_solids(Loading& loading) {
    Unfolder(loading).unfold_all();
}

}  // namespace luch::loader
