#include "framework/scene/geometry.h"
#include "tests/scene/scene_file.h"

namespace luch {
namespace {

using Operation = Csg::Operation;

class CsgScene : public SceneFile {};

TEST_F(CsgScene, IsReadUnderAllItsNamesFromPartsThatComeLater) {
    const std::string names[] = {"CSGUnion", "CsgUnion", "CsgPlus", "CSGInter", "CsgInter",
                                 "CsgAnd",   "CSGDiff",  "CsgDiff", "CsgMinus"};
    for (std::size_t i = 0; i < std::size(names); ++i) {
        const Scene scene =
            loaded(names[i] + " both {\n left ball\n right box\n}\nSphere ball {\n}\nCube box {\n}")
                .scene;
        const auto& csg = std::get<Csg>(scene.geometries.at(0));
        EXPECT_EQ(csg.operation, static_cast<Operation>(i / 3)) << names[i];
        ASSERT_EQ(csg.parts.size(), 2u);
        EXPECT_EQ(csg.parts[0].geometry, 1u);
        EXPECT_EQ(csg.parts[1].geometry, 2u);
        EXPECT_EQ(csg.parts[1].flipped, i / 3 == 2) << names[i];
        EXPECT_EQ(csg.primitives, 7u);
    }
}

TEST_F(CsgScene, UnfoldsSolidsOfSolids) {
    // a − (b − c): c adds to a again, so its outward normal is the solid's.
    const Scene scene = loaded(
                            "CSGDiff outer {\n left a\n right inner\n}\n"
                            "CSGDiff inner {\n left b\n right c\n}\n"
                            "Cube a {\n side 3\n}\nSphere b {\n}\nCube c {\n}")
                            .scene;
    const auto& csg = std::get<Csg>(scene.geometries.at(0));
    ASSERT_EQ(csg.parts.size(), 3u);
    EXPECT_FALSE(csg.parts[0].flipped);
    EXPECT_TRUE(csg.parts[1].flipped);
    EXPECT_FALSE(csg.parts[2].flipped);
    EXPECT_EQ(csg.primitives, 13u);
    EXPECT_EQ(&csg.part_of(5), &csg.parts[0]);
    EXPECT_EQ(&csg.part_of(6), &csg.parts[1]);
    EXPECT_EQ(&csg.part_of(12), &csg.parts[2]);
}

/// Whether a point is inside a solid, when its parts are told.
bool inside(const Csg& csg, unsigned in_parts) {
    std::vector<bool> on(csg.wires());
    for (std::size_t i = 0; i < csg.parts.size(); ++i) on[i] = (in_parts >> i & 1) != 0;
    for (std::size_t j = 0; j < csg.gates.size(); ++j) {
        on[csg.parts.size() + j] =
            csg.gates[j].result(on[csg.gates[j].left], on[csg.gates[j].right]);
    }
    return on.back();
}

TEST(Csg, KeepsTheMeaningOfItsExpression) {
    // (a + b) − (c & (d − e))
    std::vector<Geometry> geometries(5, Sphere{});
    geometries.emplace_back(make_csg(Operation::join, 0, 1, geometries));
    geometries.emplace_back(make_csg(Operation::subtract, 3, 4, geometries));
    geometries.emplace_back(make_csg(Operation::intersect, 2, 6, geometries));
    const Csg csg = make_csg(Operation::subtract, 5, 7, geometries);
    ASSERT_EQ(csg.parts.size(), 5u);
    for (unsigned bits = 0; bits < 32; ++bits) {
        const bool a = bits & 1, b = bits & 2, c = bits & 4, d = bits & 8, e = bits & 16;
        EXPECT_EQ(inside(csg, bits), (a || b) && !(c && d && !e)) << bits;
    }
    for (std::size_t j = 0; j < csg.gates.size(); ++j) {
        EXPECT_EQ(csg.gate_of[csg.gates[j].left], 5 + j);
        EXPECT_EQ(csg.gate_of[csg.gates[j].right], 5 + j);
    }
}

Boxd bounds(Operation operation, const Geometry& a, const Geometry& b) {
    const std::vector<Geometry> geometries{a, b};
    return make_csg(operation, 0, 1, geometries).bounds;
}

TEST(Csg, LiesInTheLeastBoxThatItsPartsAllow) {
    const Geometry ball = Sphere{.centre = {1, 0, 0}, .radius = 2}, box = Cube{.side = 2};
    EXPECT_EQ(bounds(Operation::join, ball, box).lo, Vec3d(-1, -2, -2));
    EXPECT_EQ(bounds(Operation::join, ball, box).hi, Vec3d(3, 2, 2));
    EXPECT_EQ(bounds(Operation::intersect, ball, box).lo, Vec3d(-1, -1, -1));
    EXPECT_EQ(bounds(Operation::intersect, ball, box).hi, Vec3d(1, 1, 1));
    EXPECT_EQ(bounds(Operation::subtract, ball, box).hi, Vec3d(3, 2, 2));
    EXPECT_TRUE(bounds(Operation::intersect, Sphere{.centre = {9, 0, 0}}, box).empty());
    // A plane bounds nothing: what is "inside" of it reaches along the ray.
    const Geometry square = Plane{.limit = 5};
    EXPECT_EQ(bounds(Operation::intersect, square, box).hi, Vec3d(1, 1, 1));
    EXPECT_EQ(bounds(Operation::subtract, box, square).hi, Vec3d(1, 1, 1));
    EXPECT_EQ(bounds(Operation::subtract, square, box).hi, Vec3d(5, 1, 5));
}

TEST(Csg, RefusesMorePartsThanItCanKeep) {
    std::vector<Geometry> geometries{Sphere{}};
    for (GeometryId id = 0; id < 12; ++id) {
        geometries.emplace_back(make_csg(Operation::join, id, id, geometries));
    }
    EXPECT_EQ(std::get<Csg>(geometries.back()).parts.size(), Csg::most_parts);
    EXPECT_THROW(make_csg(Operation::join, 12, 0, geometries), std::length_error);
}

}  // namespace
}  // namespace luch
