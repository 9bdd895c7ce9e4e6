#include "tests/scene/scene_file.h"

#include <gmock/gmock.h>

namespace luch {
namespace {

using testing::ElementsAre;

class Obj : public SceneFile {
 protected:
    Mesh mesh(const std::string& obj, const std::string& properties = "") const {
        write_text(folder_ / "m.obj", obj);
        Loaded result = loaded(scene(properties));
        return std::get<Mesh>(result.scene.geometries.at(0));
    }
    std::string mesh_answer(const std::string& obj) const {
        write_text(folder_ / "m.obj", obj);
        return answer(scene(""));
    }
    static std::string scene(const std::string& properties) {
        return "Mesh m {\nfile m.obj\n" + properties + "\n}";
    }
    /// A corner in the file's coordinates.
    static Vec3d corner(const Mesh& mesh, int triangle, int which) {
        return mesh.from_frame.point(Vec3d(mesh.corner(triangle, which)));
    }
};

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
/// Two triangles at a right angle that share the edge 1 2.
const std::string roof = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 2 1 4\n";

TEST_F(Obj, MakesPolygonsFansFromTheirFirstCorner) {
    const Mesh m = mesh("v 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\nf 2 3 4 5 1\n");
    ASSERT_EQ(m.triangles.size(), 3u);
    EXPECT_THAT(m.triangles[0].position, ElementsAre(1, 2, 3));
    EXPECT_THAT(m.triangles[1].position, ElementsAre(1, 3, 4));
    EXPECT_THAT(m.triangles[2].position, ElementsAre(1, 4, 0));
}

TEST_F(Obj, CountsNegativeIndicesBackFromTheLine) {
    const Mesh m = mesh(square + "f -4 -3 -2\nv 9 9 9\nf -5 -4 -1\n");
    EXPECT_THAT(m.triangles[0].position, ElementsAre(0, 1, 2));
    EXPECT_THAT(m.triangles[1].position, ElementsAre(0, 1, 4));
}

TEST_F(Obj, ReadsEveryFormOfACorner) {
    const Mesh m = mesh(square + "vt 0.25 0.5\nvn 0 0 2\nf 1/1/1 2/1 3//1\nf 1 2 4\n");
    EXPECT_EQ(m.uvs[m.triangles[0].uv[0]], Vec2(0.25f, 0.5f));
    EXPECT_EQ(m.uvs[m.triangles[0].uv[1]], Vec2(0.25f, 0.5f));
    EXPECT_EQ(m.uvs[m.triangles[0].uv[2]], Vec2(0));
    EXPECT_EQ(m.normals[m.triangles[0].normal[0]], Vec3(0, 0, 1));
    EXPECT_EQ(m.normals[m.triangles[0].normal[2]], Vec3(0, 0, 1));
    EXPECT_FALSE(m.faceted);
}

TEST_F(Obj, GivesCornersWithoutAUsableNormalTheirTriangles) {
    const Mesh m = mesh(square + "vn 1 0 0\nvn 0 0 0\nf 1//1 2//2 3\n");
    EXPECT_EQ(m.normals[m.triangles[0].normal[0]], Vec3(1, 0, 0));
    EXPECT_EQ(m.normals[m.triangles[0].normal[1]], Vec3(0, 0, 1));
    EXPECT_EQ(m.normals[m.triangles[0].normal[2]], Vec3(0, 0, 1));
}

TEST_F(Obj, AllowsIndicesOfLaterLines) {
    EXPECT_EQ(mesh("f 1 2 3\n" + square).triangles.size(), 1u);
}

TEST_F(Obj, RecentersByTheMeanOfAllVertices) {
    // The fifth vertex is in no face but counts.
    const Mesh m = mesh(square + "v 8 3 5\nf 1 2 3\n", "recenter on");
    EXPECT_LT(max_norm(corner(m, 0, 0) - Vec3d(-2, -1, -1)), 1e-6);
    const Mesh as_is = mesh(square + "v 8 3 5\nf 1 2 3\n");
    EXPECT_LT(max_norm(corner(as_is, 0, 0)), 1e-6);
}

TEST_F(Obj, IsFacetedWithoutNormals) {
    EXPECT_TRUE(mesh(roof).faceted);
    EXPECT_TRUE(mesh(roof).normals.empty());
}

TEST_F(Obj, SmoothsByTheUnweightedSumOfUnitNormals) {
    // A second, smaller triangle at vertex 1 weighs as much as the first: (0,0,1) + (0,1,0).
    const Mesh m =
        mesh("v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 0.1\nf 1 2 3\nf 1 4 2\n", "autoSmooth on");
    EXPECT_FALSE(m.faceted);
    const Vec3 shared = m.normals[m.triangles[0].normal[0]];
    EXPECT_LT(max_norm(shared - glm::normalize(Vec3(0, 1, 1))), 1e-6f);
    EXPECT_EQ(m.normals[m.triangles[0].normal[2]], Vec3(0, 0, 1));
}

TEST_F(Obj, LetsSmoothingBeatFaceted) {
    EXPECT_FALSE(mesh(roof, "autoSmooth on\nfaceted on").faceted);
}

TEST_F(Obj, SmoothsOnlyWhereTheFileHasNoNormals) {
    const std::string with_normals = square + "vn 1 0 0\nf 1//1 2//1 3//1\n";
    EXPECT_EQ(mesh(with_normals, "autoSmooth on").normals.at(0), Vec3(1, 0, 0));
    EXPECT_TRUE(mesh(with_normals, "autoSmooth on\nfaceted on").faceted);
}

TEST_F(Obj, CullsBackfacesWhenAsked) {
    EXPECT_TRUE(mesh(roof, "backfaceCulling on").cull_backfaces);
    EXPECT_FALSE(mesh(roof).cull_backfaces);
}

TEST_F(Obj, KeepsDetailFarFromTheOrigin) {
    // In single precision these two vertices would be one.
    const Mesh m = mesh(
        "v 148376.001 1234 -223423\nv 148376.002 1234 -223423\n"
        "v 148376.001 1234.001 -223423\nf 1 2 3\n");
    EXPECT_NEAR(corner(m, 0, 1).x - corner(m, 0, 0).x, 0.001, 1e-9);
}

TEST_F(Obj, HoldsItsRangeOfSizes) {
    const Mesh large = mesh("v 0 0 0\nv 1e29 0 0\nv 0 1e29 0\nf 1 2 3\n", "autoSmooth on");
    EXPECT_NEAR(corner(large, 0, 1).x, 1e29, 1e22);
    EXPECT_EQ(large.normals.at(0), Vec3(0, 0, 1));
    const Mesh small = mesh("v 0 0 0\nv 1e-50 0 0\nv 0 1e-50 0\nf 1 2 3\n", "autoSmooth on");
    EXPECT_NEAR(corner(small, 0, 1).x, 1e-50, 1e-56);
    EXPECT_EQ(small.normals.at(0), Vec3(0, 0, 1));
    EXPECT_EQ(mesh_answer("v 0 0 0\nv 1e-70 0 0\nv 0 1e-70 0\nf 1 2 3\n"),
              "m.obj: is only 1e-70 across; make it larger");
    EXPECT_EQ(mesh_answer("v 0 0 0\nv 1e31 0 0\nv 0 1 0\nf 1 2 3\n"),
              "m.obj:2: \"1e31\" is not a number from -1e30 to 1e30; correct the mesh");
}

TEST_F(Obj, PassesOverWhatIsNoPolygon) {
    EXPECT_EQ(mesh_answer("mtllib ../../x.mtl\no name\ng a b\ns 1\nusemtl m\n# f 7 8 9\n" + square +
                          "p 1\nl 1 2\nf 1 2 3 # f 7\n"),
              "");
}

TEST_F(Obj, WarnsOnceAboutWhatItDoesNotKnow) {
    EXPECT_EQ(mesh_answer(square + "hello 1\nhello 2\nf 1 2 3\n"),
              "m.obj:5: \"hello\" is no statement of OBJ; lines like this are passed over\n");
}

TEST_F(Obj, WarnsWhenItHasNoFaces) {
    EXPECT_EQ(mesh_answer(square), "m.obj: holds no faces; nothing of it will be drawn\n");
}

TEST_F(Obj, KeepsDegenerateTriangles) {
    const Mesh m = mesh("v 1 1 1\nf 1 1 1\n", "autoSmooth on");
    ASSERT_EQ(m.triangles.size(), 1u);
    EXPECT_NEAR(glm::length(m.normals[m.triangles[0].normal[0]]), 1, 1e-6);
}

TEST_F(Obj, RefusesCornersThatAreNoIndices) {
    for (const char* corner :
         {"x", "1/x", "1//x", "1/1/1/1", "1.5", "99999999999999999999", "/1"}) {
        EXPECT_EQ(mesh_answer(square + "f 1 2 " + corner + "\n"),
                  std::string("m.obj:5: the corner \"") + corner +
                      "\" is not of the form 1, 1/2, 1//3 or 1/2/3; correct the mesh");
    }
}

}  // namespace
}  // namespace luch
