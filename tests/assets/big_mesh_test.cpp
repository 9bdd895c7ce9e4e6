#include "scenes/generator/big_mesh.h"

#include "framework/base/error.h"
#include "framework/base/files.h"
#include "framework/scene/loader/loader.h"
#include "tests/testing/own_folder.h"

#include <gtest/gtest.h>

#include <map>

namespace luch::assets {
namespace {

constexpr const char* kinds[] = {"terrain", "sphere", "tangle"};

TEST(BigMesh, HasTheNumberThatWasAskedForWithinAHundredth) {
    for (const char* kind : kinds) {
        for (const std::uint64_t wanted : {200u, 201u, 997u, 12345u, 1000000u, 99999989u}) {
            const auto found = static_cast<double>(big_mesh(kind, wanted).triangles);
            EXPECT_NEAR(found, double(wanted), 0.01 * double(wanted)) << kind;
        }
    }
}

TEST(BigMesh, NamesOnlyPointsThatItHas) {
    for (const char* kind : kinds) {
        const BigMesh mesh = big_mesh(kind, 3000);
        for (std::uint64_t i = 0; i < mesh.triangles; ++i) {
            for (const std::uint64_t corner : mesh.triangle(i)) ASSERT_LT(corner, mesh.points);
        }
        for (std::uint64_t i = 0; i < mesh.points; ++i) {
            ASSERT_LE(max_norm(mesh.point(i)), 1.1) << kind;
        }
    }
}

/// Edges that have no neighbour the other way round.
int open_edges(const BigMesh& mesh) {
    std::map<std::pair<std::uint64_t, std::uint64_t>, int> edges;
    for (std::uint64_t i = 0; i < mesh.triangles; ++i) {
        const auto t = mesh.triangle(i);
        for (int k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    }
    int open = 0;
    for (const auto& [edge, times] : edges) {
        EXPECT_EQ(times, 1);
        open += !edges.contains({edge.second, edge.first});
    }
    return open;
}

TEST(BigMesh, IsClosedWhereItIsABall) {
    const BigMesh ball = big_mesh("sphere", 2000);
    EXPECT_EQ(open_edges(ball), 0);
    double volume = 0;
    for (std::uint64_t i = 0; i < ball.triangles; ++i) {
        const auto [a, b, c] = ball.triangle(i);
        volume += glm::dot(ball.point(a), glm::cross(ball.point(b), ball.point(c))) / 6;
    }
    EXPECT_NEAR(volume, 4.19, 0.15);
    EXPECT_GT(open_edges(big_mesh("terrain", 2000)), 0);
}

TEST(BigMesh, IsLongThinAndOverlappingWhereItIsATangle) {
    const BigMesh mesh = big_mesh("tangle", 2000);
    int slender = 0;
    double boxes = 0;
    for (std::uint64_t i = 0; i < mesh.triangles; ++i) {
        const Vec3d a = mesh.point(3 * i), b = mesh.point(3 * i + 1), c = mesh.point(3 * i + 2);
        slender += glm::distance(a, b) < 0.1 * glm::distance(a, c);
        const Vec3d size = glm::max(glm::max(a, b), c) - glm::min(glm::min(a, b), c);
        boxes += size.x * size.y * size.z;
    }
    EXPECT_GT(slender, 1900);
    EXPECT_GT(boxes, 100) << "together the boxes fill the cube of 8 many times";
}

TEST(BigMesh, IsTheSameInBothFormats) {
    const auto folder = own_folder();
    const auto mesh_in = [&](const std::string& name) {
        write_big_mesh(big_mesh("terrain", 500), folder / name);
        write_text(folder / "m.scene",
                   "Camera c {\npos 0 0 0\n}\nMesh m {\nfile " + name + "\n}\n");
        return std::get<Mesh>(load_scene(folder / "m.scene").scene.geometries.at(0));
    };
    const Mesh obj = mesh_in("m.obj"), glb = mesh_in("m.glb");
    ASSERT_EQ(obj.triangles.size(), glb.triangles.size());
    double lowest = 0, highest = 0;
    for (std::uint32_t i = 0; i < obj.triangles.size(); ++i) {
        // Mirrored: z is −z, and the second and third corner change places.
        for (const auto& [k, other] : {std::pair{0, 0}, {1, 2}, {2, 1}}) {
            Vec3d p = glb.from_frame.point(Vec3d(glb.corner(i, other)));
            p.z = -p.z;
            EXPECT_LT(glm::distance(obj.from_frame.point(Vec3d(obj.corner(i, k))), p), 1e-6);
            lowest = std::min(lowest, p.x);
            highest = std::max(highest, p.x);
        }
    }
    EXPECT_NEAR(highest - lowest, 2, 1e-6);
    std::filesystem::remove_all(folder);
}

std::string answer(const std::string& kind, std::uint64_t triangles, const char* file) {
    try {
        write_big_mesh(big_mesh(kind, triangles), file);
        return "written";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST(BigMesh, SaysWhatItCannotMake) {
    EXPECT_EQ(answer("torus", 1000, "a.obj"),
              "--kind is \"torus\"; choose terrain, sphere or tangle");
    EXPECT_EQ(answer("tangle", 3, "a.obj"), "--triangles is 3; choose 200 to 2147483647");
    EXPECT_EQ(answer("tangle", 1000, "a.ply"),
              "a.ply: is neither .obj nor .glb; choose one of them");
}

}  // namespace
}  // namespace luch::assets
