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
using testing::Not;

Ran stress(const std::string& arguments) {
    return shell("'" LUCH_PROGRAM "' stress " + arguments);
}

TEST(StressVerb, ShowsATableAndWritesIt) {
    const fs::path folder = own_folder();
    const fs::path file = folder / "table.json";
    const Ran ran = stress("-t baseline --row 7 --json '" + file.string() + "'");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("7  two spheres, 4e-5 apart"));
    EXPECT_THAT(ran.text, HasSubstr("1 pass, 0 fail, 0 not written, 0 do not apply"));
    const JsonDocument table(read_text(file), file);
    EXPECT_EQ(table.root().member("pass")->number(), 1);
    const JsonValue only = table.root().member("cases")->at(0);
    EXPECT_EQ(only.member("row")->number(), 7);
    EXPECT_EQ(only.member("verdict")->text(), "pass");
    EXPECT_EQ(only.member("expected")->text(), "the outer one");
    fs::remove_all(folder);
}

TEST(StressVerb, CountsAHomeworksHolesApart) {
    const Ran ran = stress("-t homework/vista --row 7");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("NOT WRITTEN"));
    EXPECT_THAT(ran.text, HasSubstr("vista.t"));
    EXPECT_THAT(ran.text, HasSubstr("0 pass, 0 fail, 1 not written"));
}

TEST(StressVerb, NamesItsCasesAndRunsNone) {
    const Ran ran = stress("--list");
    EXPECT_EQ(ran.status, 0) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("2  rays at edges, plain"));
    EXPECT_THAT(ran.text, HasSubstr("21  two eyes"));
    EXPECT_THAT(ran.text, HasSubstr("continuous integration"));
    EXPECT_THAT(ran.text, Not(HasSubstr("pass")));
}

TEST(StressVerb, SaysWhatToDoAboutAnUnknownRowOrTechnique) {
    const Ran row = stress("--row 99");
    EXPECT_EQ(row.status, 2);
    EXPECT_THAT(row.text, HasSubstr("--row 99: there is no such row here; --list shows them"));
    const Ran technique = stress("-t vsta");
    EXPECT_EQ(technique.status, 2);
    EXPECT_THAT(technique.text, HasSubstr("did you mean vista"));
}

}  // namespace
}  // namespace luch
