#include "framework/accel/embree.h"
#include "framework/base/files.h"
#include "framework/base/json_reader.h"
#include "tests/testing/own_folder.h"
#include "tests/testing/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Runs `luch bench` where pyramids.obj is: 200 pyramids in a row, some before others.
class Bench : public testing::Test {
 protected:
    Bench() {
        std::string text;
        for (int i = 0; i < 200; ++i) {
            const std::string x = std::to_string(i % 20), y = std::to_string(i / 20);
            text += "v " + x + " " + y + " 0\nv " + x + ".9 " + y + " 0\nv " + x + ".5 " + y +
                    ".8 0.1\nv " + x + ".4 " + y + ".3 1.5\n";
            text += "f -4 -3 -1\nf -3 -2 -1\nf -2 -4 -1\nf -4 -2 -3\n";
        }
        write_text(folder_ / "pyramids.obj", text);
    }
    ~Bench() override { fs::remove_all(folder_); }

    [[nodiscard]] Ran bench(const std::string& arguments) const {
        return shell("cd '" + folder_.string() + "' && '" LUCH_PROGRAM "' bench " + arguments);
    }
    [[nodiscard]] JsonDocument written() const {
        return {read_text(folder_ / "speeds.json"), "speeds.json"};
    }

    fs::path folder_ = own_folder();
};

double number_at(const JsonValue& object, const char* key) {
    return object.member(key).value().number().value();
}

std::string text_at(const JsonValue& object, const char* key) {
    return std::string(object.member(key).value().text().value());
}

constexpr const char* quick = " --side 64 --rounds 1 --json speeds.json";

TEST_F(Bench, WritesASpeedForEveryKindOfRay) {
    const Ran ran = bench(std::string("rays pyramids.obj") + quick);
    ASSERT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("pyramids.obj: 800 triangles; build luch "));
    const JsonDocument document = written();
    const JsonValue root = document.root();
    EXPECT_EQ(number_at(root, "side"), 64);
    EXPECT_EQ(number_at(root, "threads"), 1);
    ASSERT_EQ(root.member("meshes")->size(), 1u);
    const JsonValue mesh = root.member("meshes")->at(0);
    EXPECT_EQ(text_at(mesh, "mesh"), "pyramids.obj");
    EXPECT_EQ(number_at(mesh, "triangles"), 800);
    EXPECT_GE(number_at(mesh.member("build_cpu_ms").value(), "luch"), 0);
    const JsonValue kinds = mesh.member("kinds").value();
    ASSERT_EQ(kinds.size(), 3u);
    constexpr const char* names[] = {"primary", "shadow", "diffuse"};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(text_at(kinds.at(i), "kind"), names[i]);
        EXPECT_EQ(text_at(kinds.at(i), "backend"), "luch");
        EXPECT_GT(number_at(kinds.at(i), "mrays_per_s"), 0);
        EXPECT_EQ(number_at(kinds.at(i), "ratio"), 1);
        const JsonValue modes = kinds.at(i).member("modes").value();
        EXPECT_GT(number_at(modes, "single"), 0);
        EXPECT_EQ(modes.member("packet").has_value(), i < 2) << "bounces have no common origin";
    }
    EXPECT_EQ(number_at(kinds.at(0), "rays"), 64 * 64);
    EXPECT_GT(number_at(kinds.at(1), "rays"), 100);
}

TEST_F(Bench, MeetsTheTrianglesThatEmbreeMeets) {
    if (!has_embree()) GTEST_SKIP() << "this build has no Embree";
    for (const char* scale : {"0.0009765625", "1", "1024"}) {
        const Ran ran =
            bench("rays pyramids.obj --backend luch,embree --scale " + std::string(scale) + quick);
        ASSERT_EQ(ran.status, 0) << ran.text;
        EXPECT_THAT(ran.text, HasSubstr("primary  luch / embree: best "));
        const JsonDocument document = written();
        const JsonValue kinds = document.root().member("meshes")->at(0).member("kinds").value();
        ASSERT_EQ(kinds.size(), 6u);
        for (std::size_t i = 1; i < 6; i += 2) {
            EXPECT_EQ(text_at(kinds.at(i), "backend"), "embree");
            EXPECT_EQ(number_at(kinds.at(i), "hit_mismatches"), 0) << ran.text;
            EXPECT_LE(number_at(kinds.at(i), "hit_doubts"), 1) << ran.text;
            EXPECT_EQ(number_at(kinds.at(i), "prim_mismatches"), 0) << ran.text;
            EXPECT_GE(number_at(kinds.at(i), "prim_agreement"), 0.999) << ran.text;
            EXPECT_GT(number_at(kinds.at(i).member("modes").value(), "stream"), 0);
        }
    }
}

TEST_F(Bench, RunsWhatItIsAskedForAndNoMore) {
    const Ran ran =
        bench(std::string("rays pyramids.obj pyramids.obj --rays shadow --threads 2 --isa v2 "
                          "--view 9,5,30,9,5,0,0,40,40") +
              quick);
    if (ran.status == 2 && ran.text.find("this processor runs") != std::string::npos) {
        GTEST_SKIP() << "no x86-64-v2 here";
    }
    ASSERT_EQ(ran.status, 0) << ran.text;
    const JsonDocument document = written();
    EXPECT_EQ(text_at(document.root(), "isa"), "v2");
    EXPECT_EQ(number_at(document.root(), "threads"), 2);
    const JsonValue meshes = document.root().member("meshes").value();
    ASSERT_EQ(meshes.size(), 2u);
    ASSERT_EQ(meshes.at(1).member("kinds")->size(), 1u);
    EXPECT_EQ(text_at(meshes.at(1).member("kinds")->at(0), "kind"), "shadow");
}

TEST_F(Bench, MixesTwoFramesInEveryRepresentationWithinHalfALevel) {
    const Ran ran = bench("mix --width 130 --height 70 --rounds 1 --json speeds.json");
    ASSERT_EQ(ran.status, 0) << ran.text;
    const JsonDocument document = written();
    EXPECT_EQ(number_at(document.root(), "width"), 130);
    const JsonValue modes = document.root().member("modes").value();
    ASSERT_EQ(modes.size(), 13u);
    for (std::size_t i = 0; i < modes.size(); ++i) {
        const JsonValue mode = modes.at(i);
        const bool floats = text_at(mode, "mode").starts_with("float");
        const double bytes = number_at(mode, "bytes_per_pixel");
        EXPECT_GE(bytes, floats ? 36 : 12);
        EXPECT_TRUE(i >= 9 || bytes == (floats ? 36 : 12)) << bytes;
        EXPECT_GT(number_at(mode, "frame_ns_per_pixel"), 0);
        EXPECT_GT(number_at(mode, "again_ns_per_pixel"), 0);
        EXPECT_GT(number_at(mode, "tile_ns_per_pixel"), 0);
        // Half of the sums of two bytes are odd; a product's remainder is 127/255 at most; a texel
        // is the same either way.
        const bool texture = text_at(mode, "mode").ends_with("texture");
        const double expected = floats || texture ? 0 : i < 9 ? 0.5 : 0.498;
        EXPECT_NEAR(number_at(mode, "worst_error"), expected, 1e-3) << i;
    }
    EXPECT_EQ(number_at(modes.at(0), "frame_ratio"), 1);
}

TEST_F(Bench, RacesWholeFramesOfEveryBackEndOnOneThreadAndAll) {
    const Ran ran = bench("frame '" LUCH_SOURCE_DIR
                          "/scenes/spheres/spheres.scene' --width 80 --height 60 --rounds 1 "
                          "--json speeds.json");
    ASSERT_EQ(ran.status, 0) << ran.text;
    const JsonDocument document = written();
    const JsonValue scene = document.root().member("scenes")->at(0);
    EXPECT_EQ(number_at(scene, "width"), 80);
    EXPECT_EQ(number_at(scene, "height"), 60);
    const JsonValue frames = scene.member("frames").value();
    ASSERT_EQ(frames.size(), has_embree() ? 4u : 2u);
    const JsonValue rays = frames.at(0).member("rays").value();
    EXPECT_GE(number_at(rays, "primary"), 80 * 60);
    EXPECT_GT(number_at(rays, "shadow"), 0);
    EXPECT_GE(number_at(frames.at(0), "shades"), 1000);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const JsonValue frame = frames.at(i);
        EXPECT_EQ(text_at(frame, "backend"), i < 2 ? "luch" : "embree");
        if (i % 2 == 0) {
            EXPECT_EQ(number_at(frame, "threads"), 1);
        }
        EXPECT_GT(number_at(frame, "cpu_ms"), 0);
        EXPECT_EQ(number_at(frame, "different_pixels"), 0) << i;
        EXPECT_EQ(number_at(frame.member("rays").value(), "primary"), number_at(rays, "primary"));
    }
}

TEST_F(Bench, EndsWithTwoAndAWordForWhatItCannotDo) {
    const std::pair<const char*, const char*> mistakes[] = {
        {"arrays pyramids.obj", "bench arrays: "},
        {"rays nothing.obj", "nothing.obj: there is no such file; give an .obj, or bumpy"},
        {"rays pyramids.obj --backend embre", "--backend embre: did you mean embree or luch?"},
        {"rays pyramids.obj --rays shadows",
         "--rays shadows: did you mean shadow, primary or diffuse?"},
        {"rays pyramids.obj --isa v9", "--isa v9: this processor runs plain"},
        {"rays pyramids.obj --side 100", "--side 100: give a multiple of 16, to 8192"},
        {"rays pyramids.obj --side 0", "--side 0: give a multiple of 16"},
        {"rays pyramids.obj --rounds 0", "--rounds 0: give 1 to 1000"},
        {"rays pyramids.obj --threads 5000", "--threads 5000: give 0 to 1024"},
        {"rays pyramids.obj --scale 3", "--scale 3: give a power of two"},
        {"rays pyramids.obj --scale -1", "--scale -1: give a power of two"},
        {"rays", "bench rays: give meshes: .obj files, or bumpy"},
        {"raster pyramids.obj --width 0", "--width 0: give 1 to 8192"},
        {"mix pyramids.obj", "bench mix: it needs no pyramids.obj; leave that out"},
        {"frame", "bench frame: give scene files"},
        {"frame nothing.scene", "nothing.scene"},
        {"rays pyramids.obj --view 1,2,3", "--view 1,2,3: give nine numbers"},
    };
    for (const auto& [arguments, words] : mistakes) {
        const Ran ran = bench(arguments);
        EXPECT_EQ(ran.status, 2) << arguments;
        EXPECT_THAT(ran.text, HasSubstr(words)) << arguments;
    }
}

}  // namespace
}  // namespace luch
