#include "homework/vista/mutants/mutants.h"

namespace luch::homework::vista {
namespace {

using namespace techniques::vista;

struct LookUpRules {
    double centre = 0.5;
    bool falls_back = true, marks = true, always_traces = false, counts_sky = false;
};

template <LookUpRules rules>
void look_up(const Screen& screen, Tile tile, ImageView<const NodeId> ids, Tracer& tracer,
             ImageView<Hit> hits, ImageView<std::uint8_t> fell_back) {
    for (int y = tile.y0; y < tile.y1; ++y) {
        for (int x = tile.x0; x < tile.x1; ++x) {
            const Ray ray = screen.ray(x + rules.centre, y + rules.centre);
            const NodeId node = ids(x, y);
            Hit hit;
            tracer.test({&node, 1}, {&ray, 1}, {&hit, 1});
            const bool missed = !hit && (node != no_node || rules.counts_sky);
            if (rules.always_traces || (missed && rules.falls_back)) {
                hit = tracer.closest(RayKind::primary, ray);
            }
            hits(x, y) = hit;
            fell_back(x, y) = missed && rules.marks ? 1 : 0;
        }
    }
}

}  // namespace

std::vector<grading::Other> look_up_mutants() {
    return {
        {"no_fallback", "vista.t7", "a named node that is missed is not traced",
         with(&Steps::look_up, look_up<LookUpRules{.falls_back = false}>)},
        {"fallback_not_marked", "vista.t7", "fell_back stays 0",
         with(&Steps::look_up, look_up<LookUpRules{.marks = false}>)},
        {"every_ray_traced", "vista.t7", "every ray is traced, whatever the buffer says",
         with(&Steps::look_up, look_up<LookUpRules{.always_traces = true}>)},
        {"sky_traced", "vista.t7", "pixels without a node are traced",
         with(&Steps::look_up, look_up<LookUpRules{.counts_sky = true}>)},
        {"corner_rays", "vista.t7", "rays go through the pixels' corners: add ½ to x and y",
         with(&Steps::look_up, look_up<LookUpRules{.centre = 0}>)},
    };
}

}  // namespace luch::homework::vista
