// ./run, ./test and .ci/run on a machine made of fakes: every tool that they call is a script that
// notes how it was called, so nothing is installed and nothing is built.
#include "framework/base/files.h"
#include "tests/testing/own_folder.h"
#include "tests/testing/shell.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <regex>

namespace luch {
namespace {

namespace fs = std::filesystem;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Scripts : public testing::Test {
 protected:
    Scripts() {
        for (const char* folder : {".ci", "bin", "framework/cmake", "scenes/a", "scenes/b"}) {
            fs::create_directories(root_ / folder);
        }
        for (const char* file : {"run", "test", ".ci/run", "framework/cmake/phases.sh",
                                 "framework/cmake/packages.txt"}) {
            fs::copy_file(fs::path(LUCH_SOURCE_DIR) / file, root_ / file);
        }
        for (const char* scene : {"scenes/a/a.scene", "scenes/b/b.scene"}) {
            write_text(root_ / scene, "");
        }
        for (const char* tool :
             {"bash", "cat", "dirname", "env", "grep", "mkdir", "sed", "tail", "tee", "true"}) {
            fs::create_symlink(fs::path("/usr/bin") / tool, root_ / "bin" / tool);
        }
        fake("nproc", "echo 3");
        fake("apt-get", "");
        fake("id", "echo 0");
        fake("cmake", R"(case $1 in
            --preset) mkdir -p build/release
                echo "$3" | sed 's/^-D\([A-Z_]*\)=/\1:BOOL=/' >build/release/CMakeCache.txt
                echo >build/release/build.ninja ;;
            --build) cat bin/luch.fake >build/release/luch; /bin/chmod +x build/release/luch ;;
        esac)");
        fake("ctest", "echo 'Total Test time (real) = 1 sec'");
        write_text(root_ / "bin/luch.fake", "#!/bin/bash\necho \"luch $* in $PWD\"\n");
        installed_except("nothing");
    }
    ~Scripts() override { fs::remove_all(root_); }

    /// A program of this machine: notes its name and arguments, then does `body`.
    void fake(const std::string& name, const std::string& body) const {
        const fs::path file = root_ / "bin" / name;
        write_text(file, "#!/bin/bash\necho \"" + name + " $*\" >>" + (root_ / "calls").string() +
                             "\n" + body + "\n");
        fs::permissions(file, fs::perms::owner_all);
    }

    void installed_except(const std::string& missing) const {
        fake("dpkg-query",
             "shift 2\nfor p; do [ $p = " + missing + " ] || echo $p installed; done");
    }

    /// Runs a command in the tree's root; its output is out_, its exit status status_, and what it
    /// called calls_, one a line.
    void sh(const std::string& command) {
        fs::remove(root_ / "calls");
        const std::string line =
            "cd " + root_.string() + " && env -i PATH=" + root_.string() + "/bin " + command;
        const Ran ran = shell(line);
        out_ = ran.text;
        status_ = ran.status;
        calls_ = fs::exists(root_ / "calls") ? read_text(root_ / "calls") : "";
    }

    fs::path root_ = own_folder();
    std::string out_, calls_;
    int status_ = -1;
};

TEST_F(Scripts, CallNoAptWhenNothingIsMissing) {
    sh("./test");
    EXPECT_EQ(status_, 0) << out_;
    EXPECT_THAT(calls_, Not(HasSubstr("apt-get")));
}

TEST_F(Scripts, InstallOnlyWhatIsMissing) {
    installed_except("libtbb-dev");
    sh("./run list");
    EXPECT_EQ(status_, 0) << out_;
    EXPECT_THAT(calls_, HasSubstr("apt-get -q -o DPkg::Lock::Timeout=120 update\n"));
    EXPECT_THAT(calls_, HasSubstr("install -y --no-install-recommends libtbb-dev\n"));
}

TEST_F(Scripts, TryTheListsThatAreHereWhenUpdateFails) {
    installed_except("libtbb-dev");
    fake("apt-get", "case $* in *update) exit 100 ;; esac");
    sh("./run list");
    EXPECT_EQ(status_, 0) << out_;
    EXPECT_THAT(calls_, HasSubstr("install -y --no-install-recommends libtbb-dev\n"));
}

TEST_F(Scripts, LeaveTheTestsPackagesToTheTests) {
    installed_except("libgtest-dev");
    sh("./run list");
    EXPECT_THAT(calls_, Not(HasSubstr("apt-get")));
    sh("./test");
    EXPECT_THAT(calls_, HasSubstr("libgtest-dev\n"));
}

TEST_F(Scripts, SayTheLineToPasteWithoutTheSuperuser) {
    installed_except("libtbb-dev");
    fake("id", "echo 1000");
    sh("./run");
    EXPECT_EQ(status_, 1);
    EXPECT_THAT(out_, EndsWith("    sudo apt-get update && sudo apt-get install -y "
                               "--no-install-recommends libtbb-dev\n"));
    EXPECT_THAT(calls_, Not(HasSubstr("apt-get")));
}

TEST_F(Scripts, UseSudoThatAsksForNoPassword) {
    installed_except("libtbb-dev");
    fake("id", "echo 1000");
    fake("sudo", "shift; exec \"$@\"");
    sh("./run list");
    EXPECT_EQ(status_, 0) << out_;
    EXPECT_THAT(calls_, HasSubstr("sudo -n env DEBIAN_FRONTEND=noninteractive apt-get"));
    EXPECT_THAT(calls_, HasSubstr("\napt-get -q -o DPkg::Lock::Timeout=120 install"));
}

TEST_F(Scripts, NameThePackagesWhereThereIsNoApt) {
    fs::remove(root_ / "bin/apt-get");
    sh("./run list");
    EXPECT_EQ(status_, 0) << out_;
    EXPECT_THAT(out_, HasSubstr("not Debian"));
    EXPECT_THAT(out_, HasSubstr(" libopenimageio-dev "));
}

TEST_F(Scripts, ConfigureOnceAndAgainOnlyForTheTests) {
    sh("./run list");
    EXPECT_THAT(calls_, HasSubstr("cmake --preset release -DBUILD_TESTING=OFF\n"));
    sh("./run list");
    EXPECT_THAT(calls_, Not(HasSubstr("--preset release -D")));
    sh("./test");
    EXPECT_THAT(calls_, HasSubstr("cmake --preset release -DBUILD_TESTING=ON\n"));
    sh("./run list");
    EXPECT_THAT(calls_, Not(HasSubstr("--preset release -D")));
    EXPECT_THAT(calls_, HasSubstr("cmake --build --preset release --parallel 3 --target luch\n"));
}

TEST_F(Scripts, ShowTheEndOfTheLogWhenTheBuildFails) {
    fake("cmake", "[ $1 != --build ] || { echo 'error: expected ;'; exit 7; }");
    sh("./test");
    EXPECT_EQ(status_, 7);
    EXPECT_THAT(out_, HasSubstr("build failed after"));
    EXPECT_THAT(out_, EndsWith("build/log/build.log:\n  | error: expected ;\n"));
    EXPECT_THAT(calls_, Not(HasSubstr("ctest")));
}

TEST_F(Scripts, PassAVerbOnInTheCallersFolder) {
    sh("bash -c 'cd scenes && ../run plan a/a.scene'");
    EXPECT_EQ(status_, 0) << out_;
    EXPECT_THAT(out_, EndsWith("luch plan a/a.scene in " + root_.string() + "/scenes\n"));
}

TEST_F(Scripts, RunTheLabOnAFewScenes) {
    sh("./run");
    EXPECT_EQ(status_, 0) << out_;
    EXPECT_THAT(out_, EndsWith("luch lab scenes/clay/clay.scene scenes/mirrors/mirrors.scene "
                               "scenes/room/room.scene scenes/spheres/spheres.scene "
                               "-t baseline,vista --quick --size 160x120 --out out/lab in " +
                               root_.string() + "\n"));
}

TEST_F(Scripts, NameTheWindowWhereThereIsADisplay) {
    sh("DISPLAY=:0 ./run");
    EXPECT_THAT(out_, EndsWith("build/release/luch view scenes/clay/clay.scene -t vista\n"));
}

TEST_F(Scripts, FailWhenTheLabFails) {
    write_text(root_ / "bin/luch.fake", "#!/bin/bash\nexit 2\n");
    sh("DISPLAY=:0 ./run");
    EXPECT_EQ(status_, 2);
    EXPECT_THAT(out_, Not(HasSubstr("window:")));
}

TEST_F(Scripts, EndInCtestsSummaryWithItsExitStatus) {
    fake("ctest", "echo 'Total Test time (real) = 1 sec'; exit 8");
    sh("./test -R Vista");
    EXPECT_EQ(status_, 8);
    EXPECT_THAT(out_, EndsWith("Total Test time (real) = 1 sec\n"));
    EXPECT_THAT(calls_,
                EndsWith("ctest --preset release --parallel 3 --no-tests=error -R Vista\n"));
}

TEST_F(Scripts, LetTheIntegrationRunTheReadmesCommand) {
    sh("bash -c 'cd scenes && ../.ci/run'");
    EXPECT_EQ(status_, 0) << out_;
    EXPECT_THAT(calls_, HasSubstr("ctest --preset release"));
}

TEST_F(Scripts, HelpWithoutDoingAnything) {
    for (const char* command : {"./run --help", "./test -h"}) {
        sh(command);
        EXPECT_EQ(status_, 0);
        EXPECT_THAT(out_, StartsWith("usage: ./"));
        EXPECT_EQ(calls_, "");
    }
}

class Documents : public testing::TestWithParam<const char*> {};

TEST_P(Documents, NameOnlyScenesThatExist) {
    const fs::path root = LUCH_SOURCE_DIR;
    const std::string text = read_text(root / GetParam());
    const std::regex scene(R"(scenes/\w+/\w+\.scene)");
    const std::sregex_iterator first(text.begin(), text.end(), scene), none;
    EXPECT_NE(first, none);
    for (auto name = first; name != none; ++name) {
        EXPECT_TRUE(fs::exists(root / name->str())) << name->str();
    }
}

INSTANTIATE_TEST_SUITE_P(House, Documents,
                         testing::Values("README.md", "run", "homework/kit/run",
                                         "homework/vista/README.md"));

}  // namespace
}  // namespace luch
