#include "framework/image/io.h"

#include "framework/base/error.h"
#include "framework/base/files.h"
#include "tests/testing/own_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>

namespace luch {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
    void SetUp() override { folder_ = own_folder(); }
    void TearDown() override { fs::remove_all(folder_); }
    fs::path folder_;
};

/// Every pixel different, all channels different, no symmetry, an odd width (BMP pads its rows).
Image<Rgb> picture() {
    Image<Rgb> image({5, 3});
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) {
            image(x, y) = srgb_decoded(Rgb(40 * x + 3, 70 * y + 9, 10 * x + 50 * y + 1) / 255.0f);
        }
    }
    return image;
}

TEST_F(Files, AreReadFromMemoryAsFromTheDisk) {
    for (const char* name : {"picture.png", "picture.jpg"}) {
        write_picture(folder_ / name, picture().view());
        const std::string bytes = read_text(folder_ / name);
        EXPECT_EQ(picture_size(bytes, "inside"), (Size{5, 3}));
        EXPECT_EQ(read_picture(bytes, "inside").pixels, read_picture(folder_ / name).pixels);
    }
}

std::string memory_answer(const std::string& bytes) {
    try {
        read_picture(bytes, "model.glb: images[0]");
        return "read";
    } catch (const Error& error) {
        return error.what();
    }
}

TEST_F(Files, InMemoryAreRefusedAsOnTheDisk) {
    write_picture(folder_ / "picture.png", picture().view());
    write_picture(folder_ / "picture.bmp", picture().view());
    std::string png = read_text(folder_ / "picture.png");
    EXPECT_EQ(memory_answer(read_text(folder_ / "picture.bmp")),
              "model.glb: images[0]: is neither PNG nor JPEG; save the picture as one of them");
    EXPECT_EQ(memory_answer(png.substr(0, png.size() / 2)),
              "model.glb: images[0]: ends too early; save or copy it again");
    png[18] = '\x3f';  // the third byte of the width: 16,133
    png[22] = '\x3f';
    EXPECT_EQ(memory_answer(png),
              "model.glb: images[0]: promises 16133 x 16131 pixels but holds "
              "only " +
                  std::to_string(png.size()) + " bytes; it is damaged");
}

class Lossless : public Files, public testing::WithParamInterface<const char*> {};

TEST_P(Lossless, GivesBackTheBytesThatWereWritten) {
    const fs::path file = folder_ / (std::string("picture") + GetParam());
    write_picture(file, picture().view());
    const Picture read = read_picture(file);
    EXPECT_EQ(read.encoding, Encoding::srgb);
    ASSERT_EQ(read.pixels.size(), (Size{5, 3}));
    for (int y = 0; y < 3; ++y) {
        for (int x = 0; x < 5; ++x) {
            const Rgb bytes = read.pixels(x, y) * 255.0f;
            EXPECT_EQ(bytes, Rgb(40 * x + 3, 70 * y + 9, 10 * x + 50 * y + 1)) << x << " " << y;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, Lossless, testing::Values(".png", ".bmp", ".tga", ".PNG"),
                         [](const auto& test) {
                             return std::string(test.param).substr(1) + std::to_string(test.index);
                         });

using Pictures = Files;

TEST_F(Pictures, InJpegComeBackNearlyTheSame) {
    for (const char* name : {"flat.jpg", "flat.jpeg"}) {
        write_picture(folder_ / name, Image<Rgb>({16, 16}, Rgb(0.2f, 0.5f, 0.8f)).view());
        const Image<Rgb> read = read_linear(folder_ / name);
        ASSERT_EQ(read.size(), (Size{16, 16}));
        EXPECT_LT(max_norm(read(7, 9) - Rgb(0.2f, 0.5f, 0.8f)), 0.02f);
    }
}

TEST_F(Pictures, InExrKeepHalfFloats) {
    Image<Rgb> image({5, 3}, Rgb(0.25f, -3, 1024));
    image(4, 2) = Rgb(0, 65504, 0.333f);
    write_picture(folder_ / "p.exr", image.view());
    const Picture read = read_picture(folder_ / "p.exr");
    EXPECT_EQ(read.encoding, Encoding::linear);
    EXPECT_EQ(read.pixels(0, 0), image(0, 0));
    EXPECT_EQ(read.pixels(4, 2).g, 65504);
    // A half float has 11 bits.
    EXPECT_NEAR(read.pixels(4, 2).b, 0.333f, 0.333f / 2048);
}

TEST_F(Pictures, InExrAreNeverMadeInfinite) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    write_picture(folder_ / "p.exr",
                  Image<Rgb>({1, 1}, Rgb(1e30f, infinity, std::nanf(""))).view());
    const Rgb read = read_picture(folder_ / "p.exr").pixels(0, 0);
    EXPECT_EQ(read.r, 65504);
    EXPECT_EQ(read.g, infinity);
    EXPECT_TRUE(std::isnan(read.b));
}

TEST_F(Pictures, InHdrKeepTheirRange) {
    Image<Rgb> image({9, 4}, Rgb(100, 50, 25));
    image(8, 3) = Rgb(0.01f, 0.02f, 0.015f);
    write_picture(folder_ / "p.hdr", image.view());
    const Image<Rgb> read = read_picture(folder_ / "p.hdr").pixels;
    ASSERT_EQ(read.size(), image.size());
    // Eight bits under a shared exponent.
    EXPECT_LT(max_norm(read(0, 0) - image(0, 0)), 100.0f / 128);
    EXPECT_LT(max_norm(read(8, 3) - image(8, 3)), 0.02f / 128);
}

TEST_F(Pictures, AreRoundedToTheNearestByteOfTheSrgbCurve) {
    // 0.2140411 is 127.5 / 255 decoded: just below it is byte 127, just above it 128.
    Image<Rgb> image({2, 1});
    image(0, 0) = Rgb(0.2139f);
    image(1, 0) = Rgb(0.2142f);
    write_picture(folder_ / "p.png", image.view());
    const Image<Rgb> read = read_picture(folder_ / "p.png").pixels;
    EXPECT_EQ(read(0, 0), Rgb(127 / 255.0f));
    EXPECT_EQ(read(1, 0), Rgb(128 / 255.0f));
}

TEST_F(Pictures, AreDecodedAndEncodedAsAskedFor) {
    write_picture(folder_ / "p.png", Image<Rgb>({1, 1}, Rgb(0.5f)).view());
    write_picture(folder_ / "p.exr", Image<Rgb>({1, 1}, Rgb(0.5f, 4, -1)).view());
    EXPECT_NEAR(read_linear(folder_ / "p.png")(0, 0).r, 0.5f, 0.003f);
    EXPECT_NEAR(read_displayed(folder_ / "p.png")(0, 0).r, 188 / 255.0f, 1e-6);
    EXPECT_EQ(read_linear(folder_ / "p.exr")(0, 0), Rgb(0.5f, 4, -1));
    EXPECT_LT(max_norm(read_displayed(folder_ / "p.exr")(0, 0) - Rgb(0.735357f, 1, 0)), 1e-5f);
}

TEST_F(Pictures, TellTheirSizeByTheHeader) {
    for (const char* name : {"p.png", "p.bmp", "p.tga", "p.jpg", "p.exr", "p.hdr"}) {
        write_picture(folder_ / name, picture().view());
        EXPECT_EQ(picture_size(folder_ / name), (Size{5, 3})) << name;
    }
}

TEST_F(Pictures, MakeTheirFolder) {
    write_picture(folder_ / "a" / "b.exr", picture().view());
    write_picture(folder_ / "c" / "d.png", picture().view());
    EXPECT_TRUE(fs::exists(folder_ / "a" / "b.exr"));
    EXPECT_TRUE(fs::exists(folder_ / "c" / "d.png"));
}

/// Little-endian bytes.
std::string bytes(std::uint32_t value, int count) {
    std::string text;
    for (int i = 0; i < count; ++i) text += static_cast<char>(value >> (8 * i) & 0xff);
    return text;
}

std::string bmp(int width, int height, int bits, const std::string& palette,
                const std::string& pixels) {
    const auto start = static_cast<std::uint32_t>(54 + palette.size());
    return "BM" + bytes(start + static_cast<std::uint32_t>(pixels.size()), 4) + bytes(0, 4) +
           bytes(start, 4) + bytes(40, 4) + bytes(width, 4) + bytes(height, 4) + bytes(1, 2) +
           bytes(bits, 2) + bytes(0, 4) + bytes(0, 4) + bytes(2835, 4) + bytes(2835, 4) +
           bytes(static_cast<std::uint32_t>(palette.size() / 4), 4) + bytes(0, 4) + palette +
           pixels;
}

TEST_F(Pictures, InBmpOf8And24And32BitsAreTheSame) {
    // One row: blue, green, red as the format stores them, bottom row first.
    const std::string palette = bytes(0x0a141e, 4) + bytes(0x28323c, 4);
    write_text(folder_ / "8.bmp", bmp(2, 1, 8, palette, std::string("\1\0\0\0", 4)));
    write_text(folder_ / "24.bmp", bmp(2, 1, 24, "", "\x3c\x32\x28\x1e\x14\x0a" + bytes(0, 2)));
    write_text(folder_ / "32.bmp", bmp(2, 1, 32, "", bytes(0xff28323c, 4) + bytes(0xff0a141e, 4)));
    for (const char* name : {"8.bmp", "24.bmp", "32.bmp"}) {
        const Image<Rgb> read = read_picture(folder_ / name).pixels;
        ASSERT_EQ(read.size(), (Size{2, 1})) << name;
        EXPECT_EQ(read(0, 0) * 255.0f, Rgb(40, 50, 60)) << name;
        EXPECT_EQ(read(1, 0) * 255.0f, Rgb(10, 20, 30)) << name;
    }
}

TEST_F(Pictures, StartAtTheTopWhateverTheirFormatDoes) {
    Image<Rgb> image({1, 2}, Rgb(0));
    image(0, 0) = Rgb(1);
    for (const char* name : {"p.png", "p.bmp", "p.tga", "p.exr", "p.hdr"}) {
        write_picture(folder_ / name, image.view());
        EXPECT_GT(read_picture(folder_ / name).pixels(0, 0).r, 0.9f) << name;
        EXPECT_LT(read_picture(folder_ / name).pixels(0, 1).r, 0.1f) << name;
    }
}

}  // namespace
}  // namespace luch
