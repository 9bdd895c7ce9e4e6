#include "framework/apps/packages.h"

#include "framework/base/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr std::string_view list =
    "# a comment\n"
    "build   g++       the C++20 compiler\n"
    "\n"
    "build   mold      links quickly\n"
    "test    libgtest-dev  GoogleTest\n"
    "option  clang     another compiler\n";

TEST(Packages, AreReadWithTheirNeedAndPurpose) {
    const auto packages = parsed_packages(list);
    ASSERT_EQ(packages.size(), 4u);
    EXPECT_EQ(packages[0].name, "g++");
    EXPECT_EQ(packages[0].purpose, "the C++20 compiler");
    EXPECT_EQ(packages[2].need, Need::test);
    EXPECT_EQ(packages[3].need, Need::option);
}

TEST(Packages, AnUnknownNeedIsAnErrorWithItsLine) {
    EXPECT_THAT([] { parsed_packages("build g++ compiler\nbiuld mold links\n"); },
                ThrowsMessage<Error>(HasSubstr("packages.txt:2: unknown need 'biuld'")));
}

TEST(Packages, ALineWithoutAPurposeIsAnError) {
    EXPECT_THAT([] { parsed_packages("build g++\n"); },
                ThrowsMessage<Error>(HasSubstr("packages.txt:1: write a need, a package")));
}

TEST(Packages, WhatDpkgDoesNotNameIsMissing) {
    auto packages = parsed_packages(list);
    set_versions(packages, "g++\tinstalled\t4:12.2.0-3\n");
    EXPECT_EQ(packages[0].version, "4:12.2.0-3");
    EXPECT_THAT(missing(packages, Need::build), ElementsAre("mold"));
    EXPECT_THAT(missing(packages, Need::test), ElementsAre("libgtest-dev"));
    EXPECT_THAT(missing(packages, Need::option), ElementsAre("clang"));
}

TEST(Packages, ARemovedPackageWhoseSettingsRemainIsMissing) {
    auto packages = parsed_packages(list);
    set_versions(packages, "g++\tinstalled\t12\nmold\tconfig-files\t1.10\n");
    EXPECT_THAT(missing(packages, Need::build), ElementsAre("mold"));
}

TEST(Packages, TheAptLineNamesThemAll) {
    const std::vector<std::string> names = {"mold", "cmake"};
    EXPECT_EQ(apt_line(names), "sudo apt-get install -y --no-install-recommends mold cmake");
}

}  // namespace
}  // namespace luch
