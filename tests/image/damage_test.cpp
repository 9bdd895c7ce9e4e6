#include "framework/base/error.h"
#include "framework/base/files.h"
#include "framework/image/io.h"
#include "tests/testing/own_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace luch {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

class Damage : public testing::TestWithParam<const char*> {
 protected:
    void SetUp() override { folder_ = own_folder(); }
    void TearDown() override { fs::remove_all(folder_); }

    static std::string answer(const fs::path& file) {
        try {
            read_picture(file);
            return "read without an error";
        } catch (const Error& error) {
            return error.what();
        }
    }
    /// Noise does not compress, so that a file cut anywhere lacks pixels.
    static Image<Rgb> noise() {
        Image<Rgb> image({32, 24});
        std::uint32_t state = 1;
        for (Rgb& pixel : image.pixels()) {
            for (int k = 0; k < 3; ++k) {
                state = state * 1664525 + 1013904223;
                pixel[k] = static_cast<float>(state >> 8) * 0x1p-24f;
            }
        }
        return image;
    }
    fs::path folder_;
};

class Truncated : public Damage {};

TEST_P(Truncated, IsNeverReadAsFine) {
    const fs::path file = folder_ / (std::string("p") + GetParam());
    write_picture(file, noise().view());
    const std::string whole = read_text(file);
    ASSERT_EQ(answer(file), "read without an error");
    for (const double part : {0.0, 0.001, 0.01, 0.1, 0.5, 0.9, 0.97}) {
        write_text(file, whole.substr(0, static_cast<std::size_t>(part * whole.size())));
        EXPECT_THAT(answer(file), StartsWith(file.string() + ": ")) << part;
    }
}

class CutAtItsEnd : public Damage {};

TEST_P(CutAtItsEnd, IsNotReadAsFineEither) {
    const fs::path file = folder_ / (std::string("p") + GetParam());
    write_picture(file, noise().view());
    const std::string whole = read_text(file);
    write_text(file, whole.substr(0, whole.size() - 40));
    EXPECT_THAT(answer(file), StartsWith(file.string() + ": "));
}

INSTANTIATE_TEST_SUITE_P(Formats, Truncated,
                         testing::Values(".png", ".jpg", ".bmp", ".tga", ".exr", ".hdr"),
                         [](const auto& test) { return std::string(test.param).substr(1); });

INSTANTIATE_TEST_SUITE_P(Formats, CutAtItsEnd,
                         testing::Values(".png", ".bmp", ".tga", ".exr", ".hdr"),
                         [](const auto& test) { return std::string(test.param).substr(1); });

TEST_F(Damage, NamesAMissingFile) {
    EXPECT_EQ(answer(folder_ / "none.png"),
              (folder_ / "none.png").string() + ": does not exist; check the name");
}

TEST_F(Damage, TellsAFolderFromAPicture) {
    fs::create_directories(folder_ / "folder.png");
    EXPECT_EQ(answer(folder_ / "folder.png"),
              (folder_ / "folder.png").string() + ": is not a file; name a picture");
}

TEST_F(Damage, TellsAnEmptyFile) {
    write_text(folder_ / "empty.png", "");
    EXPECT_EQ(answer(folder_ / "empty.png"),
              (folder_ / "empty.png").string() + ": is empty; save the picture again");
}

TEST_F(Damage, ListsTheEndingsThatCanBeRead) {
    EXPECT_EQ(answer("p.webp"),
              "p.webp: the ending \".webp\" is not a picture's; use .png, .jpg, .jpeg, .bmp, .tga, "
              ".exr, .hdr, .tif or .tiff");
}

TEST_F(Damage, ListsTheEndingsThatCanBeWritten) {
    try {
        write_picture(folder_ / "p.tif", noise().view());
        FAIL() << "written";
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), (folder_ / "p.tif").string() +
                                    ": the ending \".tif\" is not a picture's; use .png, .jpg, "
                                    ".jpeg, .bmp, .tga, .exr or .hdr");
    }
}

TEST_F(Damage, TellsAFormatUnderTheWrongEnding) {
    write_picture(folder_ / "p.png", noise().view());
    fs::rename(folder_ / "p.png", folder_ / "p.jpg");
    EXPECT_EQ(answer(folder_ / "p.jpg"), (folder_ / "p.jpg").string() +
                                             ": is not jpeg but png; save it as what its ending "
                                             "says");
    fs::rename(folder_ / "p.jpg", folder_ / "p.exr");
    EXPECT_THAT(answer(folder_ / "p.exr"), HasSubstr("cannot be read as openexr"));
}

TEST_F(Damage, RefusesASideOverTheLimitByTheHeader) {
    // Width 40,000 and height 40,000 in an otherwise honest header of a PNG.
    write_picture(folder_ / "p.png", noise().view());
    std::string bytes = read_text(folder_ / "p.png");
    bytes.replace(16, 8, std::string("\x00\x00\x9c\x40\x00\x00\x9c\x40", 8));
    write_text(folder_ / "p.png", bytes);
    EXPECT_EQ(answer(folder_ / "p.png"), (folder_ / "p.png").string() +
                                             ": is 40000 x 40000 pixels; make no side longer than "
                                             "16384");
}

TEST_F(Damage, RefusesAHeaderThatPromisesMoreThanTheFileCanHold) {
    for (const auto& [name, header] :
         {std::pair{"p.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 16000 +X 16000\n"},
          std::pair{"q.hdr", "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 40000 +X 1\n"}}) {
        write_text(folder_ / name, header);
        EXPECT_THAT(answer(folder_ / name), testing::AnyOf(HasSubstr("promises 16000 x 16000"),
                                                           HasSubstr("is 1 x 40000 pixels")));
    }
}

/// An uncompressed TIFF of 2 × 64 pixels, 8 bits grey, in one strip.
std::string tiff() {
    const auto number = [](std::uint32_t value, int count) {
        std::string text;
        for (int i = 0; i < count; ++i) text += static_cast<char>(value >> (8 * i) & 0xff);
        return text;
    };
    const std::pair<int, int> tags[] = {{256, 2},   {257, 64}, {258, 8},  {259, 1},  {262, 1},
                                        {273, 122}, {277, 1},  {278, 64}, {279, 128}};
    std::string text = "II*" + std::string(1, '\0') + number(8, 4) + number(std::size(tags), 2);
    for (const auto& [tag, value] : tags) {
        text += number(tag, 2) + number(4, 2) + number(1, 4) + number(value, 4);
    }
    return text + number(0, 4) + std::string(128, '\x33');
}

TEST_F(Damage, OfATiffIsNoticedThoughItsLibraryReadsOn) {
    const fs::path file = folder_ / "p.tif";
    write_text(file, tiff());
    const Image<Rgb> read = read_picture(file).pixels;
    ASSERT_EQ(read.size(), (Size{2, 64}));
    EXPECT_FLOAT_EQ(read(1, 63).g, 0x33 / 255.0f);
    write_text(file, tiff().substr(0, tiff().size() - 20));
    EXPECT_THAT(answer(file), HasSubstr("ends too early or is damaged"));
}

TEST_F(Damage, OfAHuffmanTableIsFoundBeforeTheDecoderBelievesIt) {
    const fs::path file = folder_ / "p.jpg";
    write_picture(file, noise().view());
    std::string bytes = read_text(file);
    const std::size_t tables = bytes.find("\xff\xc4");
    ASSERT_NE(tables, std::string::npos);
    // Marker, length and class take five bytes; then come the counts of the codes of each length.
    bytes[tables + 5] = bytes[tables + 6] = static_cast<char>(200);
    write_text(file, bytes);
    EXPECT_EQ(answer(file), file.string() + ": is damaged (bad Huffman table); save it again");
}

TEST_F(Damage, OfAnExrHeaderIsFoundBeforeTheLibraryMakesRoomForIt) {
    const fs::path file = folder_ / "p.exr";
    write_picture(file, noise().view());
    std::string bytes = read_text(file);
    const std::string attribute("compression\0compression\0", 24);
    const std::size_t at = bytes.find(attribute);
    ASSERT_NE(at, std::string::npos);
    bytes[at + attribute.size() + 3] = 0x70;
    write_text(file, bytes);
    EXPECT_EQ(answer(file),
              file.string() + ": is damaged (an attribute is larger than the file); save it again");
}

TEST_F(Damage, SaysWhenAPictureCannotBeWritten) {
    write_text(folder_ / "file", "in the way");
    for (const char* name : {"p.png", "p.exr", "p.hdr"}) {
        try {
            write_picture(folder_ / "file" / name, noise().view());
            FAIL() << name << " was written";
        } catch (const Error& error) {
            EXPECT_THAT(error.what(), HasSubstr("cannot be written")) << name;
        }
    }
}

TEST_F(Damage, SaysWhenTheDiskIsFull) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    EXPECT_THROW(write_text("/dev/full", std::string(100000, 'x')), Error);
    fs::create_symlink("/dev/full", folder_ / "p.exr");
    EXPECT_THROW(write_picture(folder_ / "p.exr", noise().view()), Error);
    fs::create_symlink("/dev/full", folder_ / "p.png");
    EXPECT_THROW(write_picture(folder_ / "p.png", noise().view()), Error);
}

}  // namespace
}  // namespace luch
