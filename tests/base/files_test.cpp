#include "framework/base/files.h"

#include "framework/base/error.h"
#include "tests/testing/own_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch {
namespace {

using testing::HasSubstr;

class Files : public testing::Test {
 protected:
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::string problem_of_reading(const std::filesystem::path& file, std::uintmax_t limit) {
        try {
            read_text(file, limit);
            return "none";
        } catch (const Error& error) {
            return error.what();
        }
    }
    std::filesystem::path folder_ = own_folder();
};

TEST_F(Files, GiveBackWhatWasWrittenByteForByte) {
    const std::string bytes("a\r\n\0b", 5);
    write_text(folder_ / "new" / "file", bytes);
    EXPECT_EQ(read_text(folder_ / "new" / "file"), bytes);
}

TEST_F(Files, OverTheLimitAreRefused) {
    write_text(folder_ / "file", "12345");
    EXPECT_EQ(problem_of_reading(folder_ / "file", 5), "none");
    EXPECT_EQ(problem_of_reading(folder_ / "file", 4),
              (folder_ / "file").string() + ": is 5 bytes, more than the limit of 4");
}

TEST_F(Files, ThatAreMissingAreNamed) {
    EXPECT_THAT(problem_of_reading(folder_ / "none", 5),
                HasSubstr((folder_ / "none").string() + ": cannot be read"));
}

TEST_F(Files, CannotBeWrittenIntoAFile) {
    write_text(folder_ / "file", "text");
    EXPECT_THROW(write_text(folder_ / "file" / "below", "text"), Error);
}

}  // namespace
}  // namespace luch
