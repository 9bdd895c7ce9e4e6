#include "framework/accel/accelerator.h"
#include "framework/scene/loader/loader.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace luch {
namespace {

const Scene& forest() {
    static const Scene scene = load_scene(LUCH_SOURCE_DIR "/scenes/forest/forest.scene").scene;
    return scene;
}

std::uint64_t triangles_of(const Geometry& geometry) {
    const auto* mesh = std::get_if<Mesh>(&geometry);
    return mesh ? mesh->triangles.size() : 0;
}

std::uint64_t unique_triangles() {
    std::uint64_t count = 0;
    for (const Geometry& geometry : forest().geometries) count += triangles_of(geometry);
    return count;
}

std::uint64_t instanced_triangles() {
    std::uint64_t count = 0;
    for (const Node& node : forest().nodes)
        count += triangles_of(forest().geometries[node.geometry]);
    return count;
}

TEST(Forest, ShowsAThousandTimesTheTrianglesThatItHolds) {
    RecordProperty("unique", static_cast<int>(unique_triangles()));
    RecordProperty("instanced", static_cast<int>(instanced_triangles()));
    EXPECT_GE(unique_triangles(), 100'000u);
    EXPECT_LE(unique_triangles(), 150'000u);
    EXPECT_GE(instanced_triangles(), 100'000'000u);
    EXPECT_GE(forest().nodes.size(), 5000u);
}

TEST(Forest, IsDrawnInTheColoursOfItsFiles) {
    for (const Node& node : forest().nodes) ASSERT_EQ(node.material, materials_of_file);
}

TEST(Forest, TakesMemoryForItsMeshesAndNotForItsTriangles) {
    const auto accelerator = build_accelerator(forest());
    // Three corners of 12 bytes are the least that a flattened triangle could take.
    const std::uint64_t flat = 36 * instanced_triangles();
    EXPECT_LT(accelerator->bytes(), flat / 100);
    EXPECT_GT(accelerator->bytes(), 36 * unique_triangles());
}

}  // namespace
}  // namespace luch
