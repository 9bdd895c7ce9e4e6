#include "framework/scene/loader/loader.h"
#include "framework/stress/raster/sights.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace luch {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scenes() {
    std::vector<fs::path> found;
    for (const auto& entry :
         fs::recursive_directory_iterator(fs::path(LUCH_SOURCE_DIR) / "scenes")) {
        if (entry.path().extension() == ".scene") found.push_back(entry.path());
    }
    std::sort(found.begin(), found.end());
    return found;
}

TEST(EveryScene, ShowsTheHitsOfRaysInItsItemBufferAtEveryLevel) {
    int drawn = 0;
    for (const fs::path& file : scenes()) {
        const Scene scene = load_scene(file).scene;
        const Size size{64, 48};
        if (!ItemBuffer::applies(scene.camera, size)) continue;
        const auto accelerator = build_accelerator(scene);
        WorkCounts work;
        for (const Isa isa : usable_isas()) {
            ItemBuffer buffer(scene, isa);
            const auto sights =
                stress::compared(buffer, scene.camera, size, Vec2d(0.5), Workers(2),
                                 [&](const Ray& ray) { return accelerator->closest(ray, work); });
            EXPECT_TRUE(sights.right()) << file << ' ' << to_string(isa);
            EXPECT_EQ(sights.ambiguous, buffer.ambiguous_count());
        }
        ++drawn;
    }
    EXPECT_GE(drawn, 10);
}

}  // namespace
}  // namespace luch
