#include "framework/base/files.h"
#include "tests/testing/own_folder.h"
#include "tests/testing/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace luch {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// Runs `luch doctor` with a PATH on which dpkg-query is a script of the test's.
class Doctor : public testing::Test {
 protected:
    ~Doctor() override { fs::remove_all(folder_); }

    /// dpkg-query shall call everything installed that it is asked for, except `missing`.
    void installed_except(const std::string& missing) const {
        const fs::path script = folder_ / "dpkg-query";
        write_text(script, "#!/bin/sh\nshift 2\nfor p; do [ \"$p\" = " + missing +
                               " ] || printf '%s\\tinstalled\\t1.2-3\\n' \"$p\"; done\n");
        fs::permissions(script, fs::perms::owner_all);
    }

    void examine(const std::string& arguments = "") {
        const std::string command = "PATH=" + folder_.string() +
                                    " DISPLAY=:7 WAYLAND_DISPLAY= " + LUCH_PROGRAM + " doctor " +
                                    arguments + " 2>&1";
        const Ran ran = shell(command);
        output_ = ran.text;
        status_ = ran.status;
    }

    fs::path folder_ = own_folder();
    std::string output_;
    int status_ = -1;
};

TEST_F(Doctor, IsContentWhenAllIsThere) {
    installed_except("nothing");
    examine();
    EXPECT_EQ(status_, 0) << output_;
    EXPECT_THAT(output_, HasSubstr("Everything required is here."));
    EXPECT_THAT(output_, HasSubstr("display    :7"));
    EXPECT_THAT(output_, Not(HasSubstr("apt-get")));
}

TEST_F(Doctor, FailsAndSaysHowToGetAMissingPackage) {
    installed_except("libtbb-dev");
    examine();
    EXPECT_EQ(status_, 1) << output_;
    EXPECT_THAT(output_, HasSubstr("sudo apt-get install -y --no-install-recommends libtbb-dev\n"));
    EXPECT_THAT(output_, Not(HasSubstr("Everything required")));
}

TEST_F(Doctor, DoesNotInsistOnWhatOnlyTheTestsNeed) {
    installed_except("libgtest-dev");
    examine();
    EXPECT_EQ(status_, 0) << output_;
    EXPECT_THAT(output_, HasSubstr("--no-install-recommends libgtest-dev\n"));
}

TEST_F(Doctor, SaysThatItCannotKnowWithoutDpkg) {
    examine();
    EXPECT_EQ(status_, 0) << output_;
    EXPECT_THAT(output_, HasSubstr("no dpkg-query here"));
    EXPECT_THAT(output_, Not(HasSubstr("Everything required")));
}

TEST_F(Doctor, WritesTheSameAsJson) {
    installed_except("libtbb-dev");
    const fs::path file = folder_ / "doctor.json";
    examine("--json " + file.string());
    const std::string json = read_text(file);
    EXPECT_THAT(json, HasSubstr("\"healthy\": false"));
    EXPECT_THAT(json, HasSubstr("\"missing\": [\n    \"libtbb-dev\"\n  ]"));
}

}  // namespace
}  // namespace luch
