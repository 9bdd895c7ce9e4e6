#include "homework/vista/check/samples.h"

#include "framework/base/error.h"
#include "framework/scene/loader/loader.h"
#include "homework/vista/check/store.h"

#include <algorithm>

namespace luch::homework::vista {

std::vector<Tri> Sample::sorted() const {
    std::vector<Tri> triangles;
    for (const std::uint32_t index : order) triangles.push_back(in_view.at(index));
    return triangles;
}

std::vector<Sample> stored_samples(const std::filesystem::path& root) {
    const std::filesystem::path folder = root / "homework/vista";
    std::vector<Sample> samples;
    for (const char* name : {"balls", "boxes", "gems", "inside"}) {
        const std::string scene = std::string("homework/vista/scenes/") + name + ".scene";
        Sample sample;
        sample.name = name;
        sample.scene_file = scene;
        sample.scene = std::make_shared<const Scene>(load_scene(root / scene).scene);
        read_planes(folder / "reference" / name, sample);
        samples.push_back(std::move(sample));
    }
    return samples;
}

LodSample stored_lod(const std::filesystem::path& root) {
    return read_lod(root / "homework/vista/reference");
}

void to_view(const Scene& scene, NodeId node, const Screen& screen, std::vector<Tri>& triangles) {
    const Transform& to_world = scene.nodes[node].to_world;
    for (Tri& triangle : triangles) {
        triangle.node = node;
        for (Corner& corner : triangle.corners) {
            if (corner.w > 0) {
                corner = {screen.to_view(to_world.point(corner.p / corner.w)), 1};
            } else {
                // A direction is the way from the eye to a point.
                corner = {screen.to_view(screen.eye() + to_world.direction(corner.p)), 0};
            }
        }
    }
}

}  // namespace luch::homework::vista
