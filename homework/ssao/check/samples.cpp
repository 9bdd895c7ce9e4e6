#include "homework/ssao/check/samples.h"

#include "framework/scene/loader/loader.h"
#include "homework/ssao/check/store.h"

namespace luch::homework::ssao {

std::vector<std::string> sample_names() {
    return {"balls", "crates", "stairs"};
}

std::vector<Sample> stored_samples(const std::filesystem::path& root) {
    const std::filesystem::path folder = root / "homework/ssao";
    std::vector<Sample> samples;
    for (const std::string& name : sample_names()) {
        Sample sample;
        sample.name = name;
        sample.scene_file = "homework/ssao/scenes/" + name + ".scene";
        sample.scene = std::make_shared<const Scene>(load_scene(root / sample.scene_file).scene);
        read_planes(folder / "reference" / name, sample);
        samples.push_back(std::move(sample));
    }
    return samples;
}

}  // namespace luch::homework::ssao
