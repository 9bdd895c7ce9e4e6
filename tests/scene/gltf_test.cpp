#include "framework/image/io.h"
#include "tests/scene/scene_file.h"

#include <gmock/gmock.h>

#include <cstring>

namespace luch {
namespace {

using testing::HasSubstr;

/// A glTF model of one buffer, put together from arrays; m.gltf, m.bin.
class GltfFile {
 public:
    /// Adds an accessor over new bytes; returns its index.
    template <class T>
    int accessor(const std::vector<T>& values, int component_type, const std::string& type,
                 int count, const std::string& more = "") {
        const std::size_t bytes = values.size() * sizeof(T);
        views_ += comma(views_) + R"({"buffer":0,"byteOffset":)" + std::to_string(buffer_.size()) +
                  R"(,"byteLength":)" + std::to_string(bytes) + "}";
        buffer_.append(reinterpret_cast<const char*>(values.data()), bytes);
        accessors_ += comma(accessors_) + R"({"bufferView":)" + std::to_string(count_) +
                      R"(,"componentType":)" + std::to_string(component_type) + R"(,"type":")" +
                      type + R"(","count":)" + std::to_string(count) + more + "}";
        return count_++;
    }
    int vectors(const std::vector<float>& values) {
        return accessor(values, 5126, "VEC3", static_cast<int>(values.size() / 3));
    }
    int pairs(const std::vector<float>& values) {
        return accessor(values, 5126, "VEC2", static_cast<int>(values.size() / 2));
    }
    int indices(const std::vector<std::uint16_t>& values) {
        return accessor(values, 5123, "SCALAR", static_cast<int>(values.size()));
    }

    /// `rest`: the other members of the JSON, with a comma before each.
    [[nodiscard]] std::string json(const std::string& rest, const std::string& uri) const {
        return R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" +
               std::to_string(buffer_.size()) + uri + R"(}],"bufferViews":[)" + views_ +
               R"(],"accessors":[)" + accessors_ + "]" + rest + "}";
    }
    [[nodiscard]] const std::string& buffer() const { return buffer_; }

    [[nodiscard]] std::string glb(const std::string& rest) const {
        std::string text = json(rest, "");
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string binary = buffer_;
        binary.resize((binary.size() + 3) / 4 * 4, '\0');
        return "glTF" + number(2) + number(28 + text.size() + binary.size()) + number(text.size()) +
               "JSON" + text + number(binary.size()) + std::string("BIN\0", 4) + binary;
    }

    static std::string number(std::size_t value) {
        const auto bytes = static_cast<std::uint32_t>(value);
        std::string text(4, '\0');
        std::memcpy(text.data(), &bytes, 4);
        return text;
    }

 private:
    static std::string comma(const std::string& list) { return list.empty() ? "" : ","; }

    std::string buffer_, views_, accessors_;
    int count_ = 0;
};

const std::vector<float> corners_of_triangle{1, 0, 0, 0, 1, 0, 0, 0, 1};
const std::string scene_of_node_0 = R"(,"scenes":[{"nodes":[0]}])";

std::string primitive(const std::string& attributes, const std::string& more = "") {
    return R"(,"meshes":[{"primitives":[{"attributes":{)" + attributes + "}" + more + "}]}]";
}
std::string node(const std::string& members) {
    return R"(,"nodes":[{"mesh":0)" + members + "}]";
}

class Gltf : public SceneFile {
 protected:
    /// The scene with the model as Mesh m, and a node without a shader.
    Loaded model(const GltfFile& file, const std::string& rest,
                 const std::string& more = "") const {
        write_text(folder_ / "m.gltf", file.json(rest, R"(,"uri":"m.bin")"));
        write_text(folder_ / "m.bin", file.buffer());
        return loaded(scene("m.gltf", more));
    }
    static std::string scene(const std::string& name, const std::string& more = "") {
        return "Mesh m {\nfile " + name + "\n" + more + "\n}\nNode n {\ngeometry m\n}";
    }
    std::string model_answer(const GltfFile& file, const std::string& rest) const {
        write_text(folder_ / "m.gltf", file.json(rest, R"(,"uri":"m.bin")"));
        write_text(folder_ / "m.bin", file.buffer());
        return answer(scene("m.gltf"));
    }
    static const Mesh& mesh_of(const Loaded& loaded) {
        return std::get<Mesh>(loaded.scene.geometries.at(0));
    }
    static Vec3d corner(const Mesh& mesh, int triangle, int which) {
        return mesh.from_frame.point(Vec3d(mesh.corner(triangle, which)));
    }
    static void expect_corners(const Mesh& mesh, int triangle, const std::vector<Vec3d>& corners) {
        for (int k = 0; k < 3; ++k) {
            const Vec3d found = corner(mesh, triangle, k);
            EXPECT_LT(glm::distance(found, corners[k]), 1e-6)
                << triangle << ' ' << k << ": " << found.x << ' ' << found.y << ' ' << found.z;
        }
    }
    static const Lambert& lambert(const Loaded& loaded, int triangle) {
        const Mesh& mesh = mesh_of(loaded);
        return std::get<Lambert>(loaded.scene.materials.at(mesh.materials.at(triangle)));
    }
};

TEST_F(Gltf, IsMirroredIntoTheLeftHandedWorldWithItsWinding) {
    GltfFile file;
    file.vectors(corners_of_triangle);
    const Loaded m = model(file, scene_of_node_0 + node("") + primitive(R"("POSITION":0)"));
    expect_corners(mesh_of(m), 0, {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}});
    EXPECT_TRUE(mesh_of(m).faceted);
    // Counter-clockwise from outside in glTF; (B−A)×(C−A) outward here.
    const Mesh& mesh = mesh_of(m);
    const Vec3d a = corner(mesh, 0, 0);
    const Vec3d n = glm::cross(corner(mesh, 0, 1) - a, corner(mesh, 0, 2) - a);
    EXPECT_GT(glm::dot(n, Vec3d(1, 1, -1)), 0);
}

TEST_F(Gltf, MovesByScaleThenRotationThenTranslation) {
    GltfFile file;
    file.vectors(corners_of_triangle);
    // A quarter turn about +z: x → y.
    const std::string trs =
        R"(,"scale":[2,1,1],"rotation":[0,0,0.70710678118,0.70710678118],"translation":[0,0,5])";
    const Loaded m = model(file, scene_of_node_0 + node(trs) + primitive(R"("POSITION":0)"));
    expect_corners(mesh_of(m), 0, {{0, 2, -5}, {0, 0, -6}, {-1, 0, -5}});
}

TEST_F(Gltf, ReadsAMatrixColumnByColumn) {
    GltfFile file;
    file.vectors(corners_of_triangle);
    const Loaded m = model(file, scene_of_node_0 + primitive(R"("POSITION":0)") +
                                     node(R"(,"matrix":[0,2,0,0, -1,0,0,0, 0,0,1,0, 7,8,9,1])"));
    expect_corners(mesh_of(m), 0, {{7, 10, -9}, {7, 8, -10}, {6, 8, -9}});
}

TEST_F(Gltf, MultipliesTheTransformsOfItsNodes) {
    GltfFile file;
    file.vectors(corners_of_triangle);
    const Loaded m =
        model(file, scene_of_node_0 + primitive(R"("POSITION":0)") +
                        R"(,"nodes":[{"children":[1,2],"scale":[2,2,2]},)"
                        R"({"mesh":0,"translation":[1,0,0]},{"mesh":0,"translation":[0,3,0]}])");
    ASSERT_EQ(mesh_of(m).triangles.size(), 2u);
    expect_corners(mesh_of(m), 0, {{4, 0, 0}, {2, 0, -2}, {2, 2, 0}});
    expect_corners(mesh_of(m), 1, {{2, 6, 0}, {0, 6, -2}, {0, 8, 0}});
}

TEST_F(Gltf, KeepsTheWindingOfAMirroredNode) {
    GltfFile file;
    file.vectors(corners_of_triangle);
    const Loaded m =
        model(file, scene_of_node_0 + node(R"(,"scale":[1,1,-1])") + primitive(R"("POSITION":0)"));
    expect_corners(mesh_of(m), 0, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
}

TEST_F(Gltf, ShowsTheSceneThatIsTheDefault) {
    GltfFile file;
    file.vectors(corners_of_triangle);
    const Loaded m = model(file, R"(,"scene":1,"scenes":[{"nodes":[0]},{"nodes":[1]}])"
                                 R"(,"nodes":[{"mesh":0},{"mesh":0,"translation":[9,0,0]}])" +
                                     primitive(R"("POSITION":0)"));
    expect_corners(mesh_of(m), 0, {{10, 0, 0}, {9, 0, -1}, {9, 1, 0}});
}

TEST_F(Gltf, UnfoldsStripsAndFans) {
    const std::vector<float> five{0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0};
    const auto corners = [&](int mode) {
        GltfFile file;
        file.vectors(five);
        const Loaded m =
            model(file, scene_of_node_0 + node("") +
                            primitive(R"("POSITION":0)", R"(,"mode":)" + std::to_string(mode)));
        std::string text;
        for (const auto& each : mesh_of(m).triangles) {
            for (const auto i : each.position) text += std::to_string(i);
            text += ' ';
        }
        return text;
    };
    // Each with its second and third corner swapped, for the mirrored world.
    EXPECT_EQ(corners(5), "021 123 243 ");
    EXPECT_EQ(corners(6), "102 203 304 ");
}

TEST_F(Gltf, ReadsIndicesNormalsAndTextureCoordinates) {
    GltfFile file;
    file.vectors({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
    file.vectors({0, 0, 2, 0, 0, 2, 0, 0, 2, 0, 2, 2});
    file.pairs({0, 0, 1, 0, 0, 0.25, 1, 0.75});
    file.indices({3, 2, 1});
    const Loaded m =
        model(file, scene_of_node_0 + node(R"(,"scale":[1,2,1])") +
                        primitive(R"("POSITION":0,"NORMAL":1,"TEXCOORD_0":2)", R"(,"indices":3)"));
    const Mesh& mesh = mesh_of(m);
    ASSERT_EQ(mesh.triangles.size(), 1u);
    expect_corners(mesh, 0, {{1, 2, 0}, {1, 0, 0}, {0, 2, 0}});
    EXPECT_FALSE(mesh.faceted);
    // By the inverse transpose, and mirrored: (0, 2, 2) → (0, 1, −2).
    const Vec3 n = mesh.normals[mesh.triangles[0].normal[0]];
    EXPECT_LT(glm::distance(n, glm::normalize(Vec3(0, 1, -2))), 1e-6f);
    EXPECT_EQ(mesh.uvs[mesh.triangles[0].uv[0]], Vec2(1, 0.75f));
    EXPECT_EQ(mesh.uvs[mesh.triangles[0].uv[2]], Vec2(0, 0.25f));
}

TEST_F(Gltf, NormalisesIntegersAndReplacesSparseElements) {
    GltfFile file;
    file.accessor(std::vector<std::int16_t>{32767, 0, 0, 0, 32767, 0, 0, 0, -32768}, 5122, "VEC3",
                  3,
                  R"(,"normalized":true,"sparse":{"count":1,"indices":{"bufferView":1,)"
                  R"("componentType":5121},"values":{"bufferView":2}})");
    file.accessor(std::vector<std::uint8_t>{1}, 5121, "SCALAR", 1);
    file.accessor(std::vector<std::int16_t>{-32767, 0, 0}, 5122, "VEC3", 1);
    const Loaded m = model(file, scene_of_node_0 + node("") + primitive(R"("POSITION":0)"));
    expect_corners(mesh_of(m), 0, {{1, 0, 0}, {0, 0, 1}, {-1, 0, 0}});
}

TEST_F(Gltf, ReadsABinaryFileAndDataUris) {
    GltfFile file;
    file.vectors(corners_of_triangle);
    const std::string rest = scene_of_node_0 + node("") + primitive(R"("POSITION":0)");
    write_text(folder_ / "m.glb", file.glb(rest));
    expect_corners(mesh_of(loaded(scene("m.glb"))), 0, {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}});
    // 1, 0, 0, 0, 1, 0, 0, 0, 1 in float.
    const std::string uri = R"(,"uri":"data:application/octet-stream;base64,)"
                            R"(AACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/")";
    write_text(folder_ / "m.gltf", file.json(rest, uri));
    expect_corners(mesh_of(loaded(scene("m.gltf"))), 0, {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}});
}

TEST_F(Gltf, RecentersAndFacetsAsObjDoes) {
    GltfFile file;
    file.vectors({3, 0, 0, 0, 3, 0, 0, 0, 3});
    file.vectors({0, 0, 1, 0, 0, 1, 0, 0, 1});
    const std::string rest = scene_of_node_0 + node("") + primitive(R"("POSITION":0,"NORMAL":1)");
    const Loaded m = model(file, rest, "recenter on\nfaceted on\nbackfaceCulling on");
    expect_corners(mesh_of(m), 0, {{2, -1, 1}, {-1, -1, -2}, {-1, 2, 1}});
    EXPECT_TRUE(mesh_of(m).faceted);
    EXPECT_TRUE(mesh_of(m).cull_backfaces);
}

const std::string two_materials =
    R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":1},)"
    R"({"attributes":{"POSITION":0},"material":0},{"attributes":{"POSITION":0}}]}])"
    R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0,1]}},{}])";

TEST_F(Gltf, ShowsItsOwnMaterialsWhereANodeNamesNoShader) {
    GltfFile file;
    file.vectors(corners_of_triangle);
    const Loaded m = model(file, scene_of_node_0 + node("") + two_materials);
    ASSERT_EQ(m.scene.nodes.size(), 1u);
    EXPECT_EQ(lambert(m, 0).color, Rgb(1));
    EXPECT_EQ(lambert(m, 1).color, Rgb(0.5f, 0.25f, 0));
    EXPECT_EQ(lambert(m, 2).color, Rgb(1));
    const Material& seen = material_of(m.scene, {.node = 0, .primitive = 1});
    EXPECT_EQ(std::get<Lambert>(seen).color, Rgb(0.5f, 0.25f, 0));
}

TEST_F(Gltf, LetsAShaderWinAndKeepsTheNamedOnesFirst) {
    GltfFile file;
    file.vectors(corners_of_triangle);
    write_text(folder_ / "m.gltf",
               file.json(scene_of_node_0 + node("") + two_materials, R"(,"uri":"m.bin")"));
    write_text(folder_ / "m.bin", file.buffer());
    const Loaded m = loaded(scene("m.gltf") +
                            "\nConst red {\ncolor 1 0 0\n}\nNode r {\ngeometry m\nshader red\n}"
                            "\nSphere s {\n}\nNode bare {\ngeometry s\n}");
    ASSERT_EQ(m.scene.nodes.size(), 2u) << "a sphere without a shader is drawn";
    const Hit hit{.node = 1, .primitive = 1};
    EXPECT_EQ(std::get<Const>(material_of(m.scene, hit)).color, Rgb(1, 0, 0));
    EXPECT_EQ(m.scene.nodes[1].material, 0u);
    EXPECT_EQ(lambert(m, 1).color, Rgb(0.5f, 0.25f, 0));
}

class GltfTexture : public Gltf {
 protected:
    /// A triangle with a picture of 2 × 1 pixels, white and black.
    Loaded textured(const std::string& material, const std::string& texture = R"({"source":0})",
                    const std::string& more = "") const {
        Image<Rgb> picture({2, 1});
        picture(0, 0) = Rgb(1);
        write_picture(folder_ / "two pixels.png", picture.view());
        GltfFile file;
        file.vectors(corners_of_triangle);
        return model(file, scene_of_node_0 + node("") +
                               primitive(R"("POSITION":0)", R"(,"material":0)") +
                               R"(,"materials":[{"pbrMetallicRoughness":{)" + material +
                               R"(}}],"textures":[)" + texture +
                               R"(],"images":[{"uri":"two%20pixels.png"}])" + more);
    }
    static const BitmapTexture& bitmap(const Loaded& loaded) {
        return std::get<BitmapTexture>(loaded.scene.textures.at(lambert(loaded, 0).texture));
    }
};

TEST_F(GltfTexture, RepeatsOnceAUnitWithTexelsInTheMiddleOfPixels) {
    const Loaded m = textured(R"("baseColorTexture":{"index":0})");
    EXPECT_EQ(colour_at(bitmap(m), {.uv = {0.25, 0.5}}), Rgb(1));
    EXPECT_EQ(colour_at(bitmap(m), {.uv = {0.75, 0.5}}), Rgb(0));
    EXPECT_EQ(colour_at(bitmap(m), {.uv = {0.5, 0.5}}), Rgb(0.5f));
    EXPECT_EQ(colour_at(bitmap(m), {.uv = {-1.75, 0.5}}), Rgb(1));
    EXPECT_TRUE(m.warnings.empty());
}

TEST_F(GltfTexture, IsMultipliedByTheFactor) {
    const Loaded m = textured(R"("baseColorTexture":{"index":0},"baseColorFactor":[0.5,0.25,1,1])");
    EXPECT_EQ(colour_at(bitmap(m), {.uv = {0.25, 0.5}}), Rgb(0.5f, 0.25f, 1));
}

TEST_F(GltfTexture, WarnsOfASamplerThatDoesNotRepeat) {
    const Loaded m = textured(R"("baseColorTexture":{"index":0})", R"({"source":0,"sampler":0})",
                              R"(,"samplers":[{"wrapS":33071}])");
    ASSERT_EQ(m.warnings.size(), 1u);
    EXPECT_THAT(m.warnings[0], HasSubstr("m.gltf: textures[0]: its sampler clamps or mirrors"));
}

TEST_F(Gltf, WarnsOfWhatItPassesOver) {
    GltfFile file;
    file.vectors(corners_of_triangle);
    const std::string two =
        R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":1},)"
        R"({"attributes":{"POSITION":0},"targets":[{}]}]}],"skins":[{}],"animations":[{}])";
    EXPECT_EQ(model_answer(file, scene_of_node_0 + node("") + two),
              "m.gltf: skins are passed over\n"
              "m.gltf: animations are passed over\n"
              "m.gltf: meshes[0].primitives[0]: points and lines are passed over\n"
              "m.gltf: meshes[0].primitives[1]: morph targets are passed over\n");
}

TEST_F(Gltf, RefusesWhatUnfoldsBeyondTheMemory) {
    GltfFile file;
    file.vectors(std::vector<float>(3 * 300000, 1));
    std::string nodes, children;
    for (int i = 1; i <= 100; ++i) {
        children += (i > 1 ? "," : "") + std::to_string(i);
        nodes += R"(,{"mesh":0})";
    }
    EXPECT_EQ(model_answer(file, scene_of_node_0 + R"(,"nodes":[{"children":[)" + children + "]}" +
                                     nodes + "]" + primitive(R"("POSITION":0)")),
              "m.gltf: meshes[0].primitives[0].attributes: brings the model to 16800000 vertices; "
              "place it by Nodes of the scene instead");
}

TEST_F(Gltf, RefusesNodesThatNestTooDeep) {
    GltfFile file;
    file.vectors(corners_of_triangle);
    std::string nodes = R"(,"nodes":[{"mesh":0})";
    for (int i = 0; i < 256; ++i) nodes += R"(,{"children":[)" + std::to_string(i) + "]}";
    const std::string rest = R"(,"scenes":[{"nodes":[256]}])" + primitive(R"("POSITION":0)");
    EXPECT_EQ(model_answer(file, rest + nodes + "]"),
              "m.gltf: nodes[0]: is nested deeper than 256; flatten the nodes");
}

TEST_F(Gltf, RefusesJsonThatNestsTooDeep) {
    write_text(folder_ / "m.gltf", R"({"asset":{"version":"2.0"},"extras":)" +
                                       std::string(200000, '[') + std::string(200000, ']') + "}");
    EXPECT_EQ(answer(scene("m.gltf")), "m.gltf: nests its JSON deeper than 256; flatten it");
}

}  // namespace
}  // namespace luch
