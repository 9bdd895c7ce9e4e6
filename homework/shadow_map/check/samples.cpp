#include "homework/shadow_map/check/samples.h"

#include "framework/scene/loader/loader.h"
#include "homework/shadow_map/check/store.h"

namespace luch::homework::shadow_map {

Vec3d Sample::light() const {
    return find_light<PointLight>(*scene)->position;
}

const RectLight& Sample::area() const {
    return *find_light<RectLight>(*scene);
}

int Sample::points() const {
    return area().x_samples * area().y_samples;
}

Face whole_face(int n, float distance) {
    return {{0, 0, n, n}, Image<float>({n, n}, distance)};
}

CubeMap speckled_map(int n) {
    CubeMap map{n, {}};
    std::uint64_t number = 0;
    for (Face& face : map.faces) {
        face = whole_face(n, 0);
        for (float& distance : face.distance.pixels()) {
            distance = Key(5).uniform(number++) < 0.5 ? 1.0f : 3.0f;
        }
    }
    return map;
}

std::vector<Public> public_samples() {
    return {{"columns", 20}, {"shelves", 17}, {"stack", 24}};
}

std::vector<Sample> stored_samples(const std::filesystem::path& root) {
    const std::filesystem::path folder = root / "homework/shadow_map";
    std::vector<Sample> samples;
    for (const auto& [name, n] : public_samples()) {
        Sample sample;
        sample.name = name;
        sample.scene_file = "homework/shadow_map/scenes/" + name + ".scene";
        sample.scene = std::make_shared<const Scene>(load_scene(root / sample.scene_file).scene);
        sample.map.n = n;
        read_planes(folder / "reference" / name, sample);
        samples.push_back(std::move(sample));
    }
    return samples;
}

}  // namespace luch::homework::shadow_map
