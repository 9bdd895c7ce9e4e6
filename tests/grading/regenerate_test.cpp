#include "framework/apps/check_program.h"
#include "framework/grading/stored.h"
#include "framework/image/io.h"
#include "framework/image/planes.h"
#include "tests/grading/fake.h"
#include "tests/testing/own_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch::grading {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr Size frame{8, 6};

/// A folder with one stored plane, the working directory as long as a test runs.
class Regenerate : public ::testing::Test {
 protected:
    Regenerate() {
        fs::current_path(folder_);
        write_plane("ids.exr", Image<std::uint32_t>(frame, 1).view());
    }
    ~Regenerate() override {
        fs::current_path("/");
        fs::remove_all(folder_);
    }

    bool regenerated(const StoredPlane& plane, bool consent) {
        const Regeneration regeneration{
            .consent = consent,
            .say = [&](const std::string& line) { said_.push_back(line); },
            .show =
                [&](const fs::path& file, const Image<Rgb>& old, const Image<Rgb>& made) {
                    EXPECT_EQ(read_id_plane(file), Image<std::uint32_t>(frame, 1)) << "not yet";
                    EXPECT_NE(old, made);
                    shown_.push_back(file.string());
                }};
        return regenerate_plane(folder_, plane, frame, regeneration);
    }

    fs::path folder_ = own_folder();
    std::vector<std::string> said_, shown_;
};

Image<std::uint32_t> one_changed() {
    Image<std::uint32_t> ids(frame, 1);
    ids(3, 2) = 7;
    return ids;
}

TEST_F(Regenerate, IsSilentAboutWhatIsTheSame) {
    EXPECT_FALSE(regenerated({"ids.exr", Image<std::uint32_t>(frame, 1)}, true));
    EXPECT_THAT(said_, IsEmpty());
}

TEST_F(Regenerate, ShowsAPictureThatChangesAndWritesItWithConsentOnly) {
    const std::string file = (folder_ / "ids.exr").string();
    EXPECT_TRUE(regenerated({"ids.exr", one_changed()}, false));
    EXPECT_THAT(said_, ElementsAre(file + ": 1 numbers differ"));
    EXPECT_THAT(shown_, ElementsAre(file));
    EXPECT_EQ(read_id_plane(file), Image<std::uint32_t>(frame, 1));
    EXPECT_TRUE(regenerated({"ids.exr", one_changed()}, true));
    EXPECT_THAT(shown_, ElementsAre(file, file));
    EXPECT_EQ(read_id_plane(file), one_changed());
}

TEST_F(Regenerate, ShowsNoPictureOfAListNorOfANewFile) {
    EXPECT_TRUE(regenerated({"list.exr", Image<float>({3, 4}, 1)}, true));
    EXPECT_TRUE(regenerated({"list.exr", Image<float>({3, 5}, 1)}, true));
    EXPECT_THAT(shown_, IsEmpty());
    EXPECT_EQ(read_float_plane("list.exr").size(), Size(3, 5));
}

/// What `luch check` does with it: pictures in out/regenerate.
TEST_F(Regenerate, LeavesFlipMapsForTheUser) {
    const Checker checker{
        "fake", nullptr, [](const fs::path&, const Regeneration& regeneration) {
            return int(regenerate_plane(".", {"ids.exr", one_changed()}, frame, regeneration));
        }};
    const char* words[] = {"luch", "check", "fake", "--regenerate"};
    ::testing::internal::CaptureStdout();
    EXPECT_EQ(run_check_program(4, const_cast<char**>(words), checker), 1);
    const std::string said = ::testing::internal::GetCapturedStdout();
    EXPECT_THAT(said, HasSubstr("{old,new,flip}.png\n1 files would be written; add --yes"));
    for (const auto& each : fs::recursive_directory_iterator("out/regenerate")) {
        if (each.path().filename() != "flip.png") continue;
        const Image<Rgb> map = read_picture(each.path()).pixels;
        EXPECT_GT(map(3, 2).x, map(7, 5).x) << "the changed pixel stands out";
        return;
    }
    FAIL() << "no map";
}

TEST_F(Regenerate, IsAUsersMistakeWithoutTheReference) {
    const char* words[] = {"luch", "check", "fake", "--regenerate"};
    EXPECT_EQ(run_check_program(4, const_cast<char**>(words), {"fake", nullptr, nullptr}), 2);
}

TEST_F(Regenerate, AsksForNoMutantsWhereThereAreNone) {
    const Checker checker{"fake", [](const fs::path&, std::optional<std::uint64_t>) {
                              Homework homework = fake::homework(fake::right);
                              homework.mutants.clear();
                              return homework;
                          }};
    const char* words[] = {"luch", "check", "fake", "--mutants"};
    EXPECT_EQ(run_check_program(4, const_cast<char**>(words), checker), 2);
}

}  // namespace
}  // namespace luch::grading
