#include "framework/base/files.h"
#include "framework/scene/loader/loader.h"
#include "scenes/generator/png.h"
#include "scenes/generator/textures.h"
#include "scenes/generator/toys.h"
#include "scenes/generator/trees.h"
#include "tests/testing/own_folder.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace luch::assets {
namespace {

class Models : public testing::Test {
 protected:
    void SetUp() override { folder_ = own_folder(); }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    /// A scene of one node that shows the model.
    Scene loaded(const std::string& file) const {
        write_text(folder_ / "m.scene", "Camera c {\npos 0 0 0\n}\nMesh m {\nfile " + file +
                                            "\n}\nNode n {\ngeometry m\n}\n");
        const Loaded result = load_scene(folder_ / "m.scene", {.root = {}, .strict = true});
        return result.scene;
    }
    static const Mesh& mesh_of(const Scene& scene) {
        return std::get<Mesh>(scene.geometries.at(0));
    }
    static Boxd box_of(const Mesh& mesh) { return mesh.from_frame.box(bounds_of(mesh)); }

    std::filesystem::path folder_;
};

TEST_F(Models, OfToysAreTheSameAsTextAndInBinary) {
    for (const Model& model : {toy_windmill(), toy_train()}) {
        write_text(folder_ / "m.glb", glb_bytes(model));
        for (const Asset& file : gltf_files(model, "m"))
            write_text(folder_ / file.path, file.bytes);
        const Scene binary = loaded("m.glb"), text = loaded("m.gltf");
        EXPECT_EQ(mesh_of(binary).positions, mesh_of(text).positions);
        EXPECT_EQ(mesh_of(binary).materials, mesh_of(text).materials);
        ASSERT_EQ(binary.textures.size(), text.textures.size());
        EXPECT_GE(binary.textures.size(), 2u);
        EXPECT_GE(mesh_of(binary).triangles.size(), 1000u);
    }
}

TEST_F(Models, StandWhereTheirNodesPutThem) {
    write_text(folder_ / "m.glb", glb_bytes(toy_windmill()));
    const Scene scene = loaded("m.glb");
    const Boxd box = box_of(mesh_of(scene));
    EXPECT_NEAR(box.lo.y, 0, 1e-5);
    // Sails of 2.38 around an axle at 4.35, which points to −z here.
    EXPECT_GT(box.hi.y, 6);
    EXPECT_LT(box.hi.y, 4.35 + 2.45);
    EXPECT_LT(box.lo.z, -1.6);
    EXPECT_LT(box.hi.z, 1.7);
}

TEST_F(Models, KeepTheirTexturesPixelForPixel) {
    write_text(folder_ / "m.glb", glb_bytes(toy_windmill()));
    const Scene scene = loaded("m.glb");
    const IndexedImage planks = boards({64, 64});
    const auto& bitmap = std::get<BitmapTexture>(scene.textures.at(1));
    ASSERT_EQ(bitmap.pixels.size(), (Size{64, 64}));
    for (std::size_t i = 0; i < planks.pixels.size(); ++i) {
        const Byte3 c = planks.palette[planks.pixels[i]];
        ASSERT_EQ(bitmap.pixels.pixels()[i], srgb_decoded(Rgb(c.red, c.green, c.blue) / 255.0f));
    }
}

TEST_F(Models, OfTreesKeepTheirSizeInSixteenBits) {
    const auto box_when = [&](bool compact) {
        write_text(folder_ / "m.glb", glb_bytes(fir(1), compact));
        return box_of(mesh_of(loaded("m.glb")));
    };
    const Boxd precise = box_when(false), rounded = box_when(true);
    EXPECT_GT(precise.hi.y, 9.9);
    EXPECT_LT(precise.hi.y, 12.6);
    EXPECT_LT(max_norm(precise.lo - rounded.lo), 1e-3);
    EXPECT_LT(max_norm(precise.hi - rounded.hi), 1e-3);
    EXPECT_LT(glb_bytes(fir(1), true).size(), glb_bytes(fir(1)).size());
}

TEST_F(Models, DifferByTheirSeedsOnly) {
    EXPECT_EQ(glb_bytes(bush(1)), glb_bytes(bush(1)));
    EXPECT_NE(glb_bytes(bush(1)), glb_bytes(bush(2)));
}

TEST(Rock, IsClosedAndTurnsItsTrianglesOutwards) {
    const Model model = rock(3);
    const Part& part = model.meshes.at(0).at(0);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    double volume = 0;
    for (const auto& t : part.triangles) {
        for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
        volume += glm::dot(part.points[t[0]], glm::cross(part.points[t[1]], part.points[t[2]])) / 6;
    }
    for (const auto& [edge, times] : edges) {
        EXPECT_EQ(times, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    EXPECT_GT(volume, 0.3);
}

}  // namespace
}  // namespace luch::assets
