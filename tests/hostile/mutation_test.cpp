#include "framework/base/files.h"
#include "framework/image/io.h"
#include "framework/math/rng.h"
#include "framework/scene/loader/loader.h"
#include "tests/testing/own_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace luch {
namespace {

namespace fs = std::filesystem;

/// How many broken files each test makes; LUCH_MUTATIONS asks for more, for a run under a
/// sanitizer.
int mutations() {
    const char* wanted = std::getenv("LUCH_MUTATIONS");
    return wanted ? std::atoi(wanted) : 300;
}

/// One to four edits: a bit flipped, a stretch removed or repeated, something awkward put in.
std::string mutated(std::string bytes, const Key& key) {
    static const std::string awkward[] = {"{",
                                          "}",
                                          "\n}\n",
                                          "\n/*\n",
                                          "\n*/\n",
                                          "\"",
                                          "nan",
                                          "-inf",
                                          "1e999",
                                          "-1",
                                          "0",
                                          "1e-45",
                                          "\nlayer both (1,1,1)\n",
                                          "randint(",
                                          "//",
                                          "#",
                                          "99999999999999999999",
                                          std::string(1, '\0'),
                                          "/",
                                          std::string(4, '\xff'),
                                          "both",
                                          "(,,)",
                                          "\r\n"};
    const int edits = 1 + static_cast<int>(key.bits(0) % 4);
    for (int i = 1; i <= edits && !bytes.empty(); ++i) {
        const Key edit = key.branch(i);
        const std::size_t at = edit.bits(1) % bytes.size();
        const std::size_t length = 1 + edit.bits(2) % 24;
        switch (edit.bits(3) % 4) {
            case 0:
                bytes[at] = static_cast<char>(bytes[at] ^ (1 << edit.bits(4) % 8));
                break;
            case 1:
                bytes.erase(at, length);
                break;
            case 2:
                bytes.insert(edit.bits(5) % bytes.size(), bytes.substr(at, length));
                break;
            default:
                bytes.insert(at, awkward[edit.bits(6) % std::size(awkward)]);
                break;
        }
    }
    return bytes;
}

class Mutated : public testing::Test {
 protected:
    void SetUp() override {
        folder_ = own_folder();
        fs::copy(LUCH_SOURCE_DIR "/tests/hostile/seeds", folder_, fs::copy_options::recursive);
        write_picture(folder_ / "picture.png", picture().view());
        for (const char* side : {"negx", "negy", "negz", "posx", "posy", "posz"}) {
            write_picture(folder_ / "sky" / (std::string(side) + ".bmp"), picture().view());
        }
    }
    void TearDown() override { fs::remove_all(folder_); }

    static Image<Rgb> picture() {
        Image<Rgb> image({17, 9});
        const Key key(1);
        for (std::size_t i = 0; i < image.pixels().size(); ++i) {
            image.pixels()[i] = Rgb(key.uniform(3 * i), key.uniform(3 * i + 1), 0.5);
        }
        return image;
    }

    /// Breaks the file again and again. `use` must answer each with a result or an Error; anything
    /// else that it throws, and any report of a sanitizer, is a failure.
    template <class Use>
    void expect_answers(const std::string& name, const Use& use) const {
        const std::string whole = read_text(folder_ / name);
        EXPECT_NO_THROW(use()) << "unbroken";
        int refused = 0;
        for (int i = 0; i < mutations(); ++i) {
            const std::string broken = mutated(whole, Key(static_cast<std::uint64_t>(i)));
            write_text(folder_ / name, broken);
            try {
                use();
            } catch (const Error& error) {
                ++refused;
                EXPECT_NE(std::string(error.what()).find(folder_.string()), std::string::npos)
                    << "names no file: " << error.what();
            } catch (const std::exception& other) {
                ADD_FAILURE() << "mutation " << i << " of " << name << ": " << other.what();
            }
        }
        EXPECT_GT(refused, mutations() / 20) << "the mutations hardly break anything";
    }

    void expect_picture_answers(const std::string& name) const {
        write_picture(folder_ / name, picture().view());
        expect_answers(name, [&] { read_picture(folder_ / name); });
    }

    fs::path folder_;
};

TEST_F(Mutated, ScenesLoadOrAreRefused) {
    expect_answers("whole.scene", [&] { load_scene(folder_ / "whole.scene"); });
}

TEST_F(Mutated, MeshesLoadOrAreRefused) {
    expect_answers("mesh.obj", [&] { load_scene(folder_ / "whole.scene"); });
}

TEST_F(Mutated, GltfLoadsOrIsRefused) {
    expect_answers("model.gltf", [&] { load_scene(folder_ / "whole.scene"); });
}

TEST_F(Mutated, BinaryGltfLoadsOrIsRefused) {
    expect_answers("model.glb", [&] { load_scene(folder_ / "whole.scene"); });
}

TEST_F(Mutated, PngIsReadOrRefused) {
    expect_picture_answers("broken.png");
}
TEST_F(Mutated, JpegIsReadOrRefused) {
    expect_picture_answers("broken.jpg");
}
TEST_F(Mutated, BmpIsReadOrRefused) {
    expect_picture_answers("broken.bmp");
}
TEST_F(Mutated, TgaIsReadOrRefused) {
    expect_picture_answers("broken.tga");
}
TEST_F(Mutated, ExrIsReadOrRefused) {
    expect_picture_answers("broken.exr");
}
TEST_F(Mutated, HdrIsReadOrRefused) {
    expect_picture_answers("broken.hdr");
}

}  // namespace
}  // namespace luch
