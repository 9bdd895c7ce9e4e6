#include "homework/layered/check/samples.h"

#include "framework/scene/loader/loader.h"
#include "homework/layered/check/store.h"

namespace luch::homework::layered {

std::vector<std::string> sample_names() {
    return {"lamps", "posts", "row"};
}

std::vector<Sample> stored_samples(const std::filesystem::path& root) {
    const std::filesystem::path folder = root / "homework/layered";
    std::vector<Sample> samples;
    for (const std::string& name : sample_names()) {
        Sample sample;
        sample.name = name;
        sample.scene_file = "homework/layered/scenes/" + name + ".scene";
        sample.scene = std::make_shared<const Scene>(load_scene(root / sample.scene_file).scene);
        read_planes(folder / "reference" / name, sample);
        samples.push_back(std::move(sample));
    }
    return samples;
}

}  // namespace luch::homework::layered
