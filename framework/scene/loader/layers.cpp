#include "framework/scene/loader/blocks.h"

#include <fmt/format.h>

#include <algorithm>

namespace luch::loader {
namespace {

struct Unfolded {
    int waits_for = 0;  ///< layers whose own depth is not known yet
    int depth = 0;
    int shaders = 1;
};

const std::vector<Layered::Layer>& layers_of(const Material& material) {
    static const std::vector<Layered::Layer> none;
    const auto* layered = std::get_if<Layered>(&material);
    return layered ? layered->layers : none;
}

/// From a material that waits for ever, following layers that wait too, one comes into the ring.
MaterialId in_ring(MaterialId start, const std::vector<Material>& materials,
                   const std::vector<Unfolded>& unfolded) {
    MaterialId at = start;
    for (std::size_t step = 0; step < materials.size(); ++step) {
        const auto& layers = layers_of(materials[at]);
        const auto next = std::find_if(layers.begin(), layers.end(), [&](const auto& layer) {
            return unfolded[layer.material].waits_for > 0;
        });
        at = next->material;
    }
    return at;
}

}  // namespace

void check_layers(const Loading& loading) {
    constexpr int deepest = 256, most_shaders = 4096;
    const std::vector<Material>& materials = loading.scene.materials;
    std::vector<Unfolded> unfolded(materials.size());
    std::vector<std::vector<MaterialId>> users(materials.size());
    std::vector<MaterialId> ready;
    for (MaterialId id = 0; id < materials.size(); ++id) {
        for (const auto& layer : layers_of(materials[id])) users[layer.material].push_back(id);
        unfolded[id].waits_for = static_cast<int>(layers_of(materials[id]).size());
        if (unfolded[id].waits_for == 0) ready.push_back(id);
    }
    while (!ready.empty()) {
        const MaterialId id = ready.back();
        ready.pop_back();
        for (const MaterialId user : users[id]) {
            Unfolded& of_user = unfolded[user];
            of_user.depth = std::max(of_user.depth, unfolded[id].depth + 1);
            of_user.shaders += unfolded[id].shaders;
            if (of_user.depth > deepest || of_user.shaders > most_shaders) {
                loading.diagnostics.fail(
                    loading.material_lines[user],
                    fmt::format("the layers are nested deeper than {} or unfold to more than {} "
                                "shaders; use fewer",
                                deepest, most_shaders));
            }
            if (--of_user.waits_for == 0) ready.push_back(user);
        }
    }
    for (MaterialId id = 0; id < materials.size(); ++id) {
        if (unfolded[id].waits_for == 0) continue;
        const MaterialId guilty = in_ring(id, materials, unfolded);
        loading.diagnostics.fail(loading.material_lines[guilty],
                                 "the Layered shader contains itself; remove one of its layers");
    }
}

}  // namespace luch::loader
