#include "framework/scene/loader/parser.h"
#include "tests/scene/scene_file.h"

#include <gmock/gmock.h>

namespace luch {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

class Grammar : public SceneFile {
 protected:
    /// The colour of the scene's only material, a Lambert.
    Rgb color(const std::string& text) const {
        return std::get<Lambert>(loaded(text).scene.materials.at(0)).color;
    }
};

TEST_F(Grammar, TakesVectorsWithAndWithoutParenthesesAndCommas) {
    for (const char* vector : {"(1, 2, 3)", "1 2 3", "1,2,3", "( 1 2 3 )", "(1., 2., 3.)",
                               "\"1 2 3\"", "\t(1,\t2, 3)\r"}) {
        EXPECT_EQ(color(std::string("Lambert l {\ncolor ") + vector + "\n}"), Rgb(1, 2, 3))
            << vector;
    }
}

TEST_F(Grammar, EndsLinesAtComments) {
    EXPECT_EQ(color("Lambert l { // one\n# two\ncolor 1 2 3 # three\n} // four"), Rgb(1, 2, 3));
    EXPECT_EQ(color("Lambert l {\ncolor 1 2 3//four\n//color 4 5 6\n}"), Rgb(1, 2, 3));
}

TEST_F(Grammar, SkipsBlockComments) {
    EXPECT_EQ(color(" \t/* a\nLambert a {\n} }\n*/ b\nLambert l {\n/*\ncolor 4 5 6\n*/\n"
                    "color 1 2 3\n}"),
              Rgb(1, 2, 3));
}

TEST_F(Grammar, ClosesABlockCommentOnlyInTheFirstColumn) {
    EXPECT_EQ(answer("/*\n */\nLambert a {\n*/"),
              "t.scene:2: this */ does not close the comment; put it at the very beginning of a "
              "line\n");
    EXPECT_EQ(answer("/* one line */\n*/"),
              "t.scene:1: this */ does not close the comment; put it at the very beginning of a "
              "line\n");
}

TEST_F(Grammar, KeepsCommentSignsWithinQuotes) {
    EXPECT_EQ(answer("Mesh m {\nfile \"a#b//c.obj\"\n}"),
              "t.scene:2: a#b/c.obj: does not exist; check the name");
}

TEST_F(Grammar, KeepsBlanksWithinQuotes) {
    EXPECT_EQ(answer("Mesh m {\nfile \"a b.obj\"\n}"),
              "t.scene:2: a b.obj: does not exist; check the name");
}

TEST_F(Grammar, TakesBlocksWithoutAName) {
    EXPECT_EQ(color("Lambert {\ncolor 1 2 3\n}"), Rgb(1, 2, 3));
    EXPECT_EQ(color("Lambert{\ncolor 1 2 3\n  }  "), Rgb(1, 2, 3));
}

TEST_F(Grammar, TakesQuotedNames) {
    EXPECT_EQ(answer("Checker \"my tiles\" {\n}\nLambert {\ntexture \"my tiles\"\n}"), "");
}

TEST_F(Grammar, KnowsWhatIsFalse) {
    for (const char* word : {"off", "false", "0"}) {
        EXPECT_FALSE(loaded(std::string("GlobalSettings {\nwantAA ") + word + "\n}")
                         .scene.settings.anti_aliasing)
            << word;
    }
    for (const char* word : {"on", "true", "1", "yes", "anything"}) {
        EXPECT_TRUE(loaded(std::string("GlobalSettings {\ngi ") + word + "\n}")
                        .scene.settings.global_illumination)
            << word;
    }
}

TEST_F(Grammar, LetsTheFirstOfTwoValuesCount) {
    const std::string text = "Lambert l {\ncolor 1 2 3\ncolor 4 5 6\n}";
    EXPECT_EQ(color(text), Rgb(1, 2, 3));
    EXPECT_EQ(answer(text), "t.scene:3: color is given twice; the first one, in line 2, counts\n");
}

TEST_F(Grammar, LetsAnOldNameAndItsNewOneBeTheSame) {
    EXPECT_EQ(answer("Phong p {\nspecularExponent 7\nexponent 8\n}"),
              "t.scene:3: exponent is given twice; the first one, in line 2, counts\n");
}

TEST_F(Grammar, LetsBlocksReferToLaterOnes) {
    const Scene scene = loaded(
                            "Node n {\ngeometry g\nshader s\n}\nLambert s {\ntexture t\n}\n"
                            "Checker t {\n}\nPlane g {\n}")
                            .scene;
    ASSERT_EQ(scene.nodes.size(), 1u);
    EXPECT_EQ(std::get<Lambert>(scene.materials[0]).texture, 0u);
}

TEST_F(Grammar, KeepsNamesApartByKind) {
    EXPECT_EQ(answer("Plane x {\n}\nLambert x {\ntexture x\n}\nChecker x {\n}\n"
                     "Node x {\ngeometry x\nshader x\n}"),
              "");
}

TEST_F(Grammar, FindsTheFirstOfTwoOfAName) {
    const std::string text =
        "Plane g {\ny 1\n}\nSphere g {\n}\nLambert s {\n}\nNode n {\ngeometry g\nshader s\n}";
    EXPECT_EQ(loaded(text).scene.nodes[0].geometry, 0u);
    EXPECT_EQ(answer(text),
              "t.scene:4: line 1 has a geometry \"g\" already, and that one is "
              "found; rename one of the two\n");
}

TEST_F(Grammar, WarnsAboutUnknownPropertiesWithTheNearestNames) {
    EXPECT_EQ(answer("Sphere s {\nradius 3\n}"),
              "t.scene:2: Sphere has no property \"radius\"; did you mean R, O or uvscaling?\n");
    EXPECT_THROW(loaded("Sphere s {\nradius 3\n}", true), Error);
}

TEST_F(Grammar, TakesAFileWithAByteOrderMarkAndWindowsLines) {
    EXPECT_EQ(color("\xef\xbb\xbfLambert l {\r\ncolor 1 2 3\r\n}\r\n"), Rgb(1, 2, 3));
}

TEST_F(Grammar, RefusesWhatIsNoText) {
    EXPECT_EQ(answer("Lambert l {\n" + std::string(1, '\0') + "\n}"),
              "t.scene:2: holds a zero byte; a scene is a text file");
    EXPECT_EQ(answer(std::string(70000, 'x')),
              "t.scene:1: the line is longer than 65,536 characters; split it");
}

TEST_F(Grammar, ShortensWhatItQuotes) {
    EXPECT_THAT(answer(std::string(1000, 'x') + " {\n}"),
                StartsWith("t.scene:1: there is no class \"" + std::string(64, 'x') + "...\"; "));
}

TEST_F(Grammar, StopsAfterAThousandWarnings) {
    std::string text = "Plane p {\n";
    for (int i = 0; i < 3000; ++i) text += "nothing 1\n";
    EXPECT_EQ(loaded(text + "}").warnings.size(), 1001u);
}

double random_y(const std::vector<Geometry>& geometries, int i) {
    return std::get<Plane>(geometries.at(i)).y;
}

TEST_F(Grammar, DrawsRandomNumbersByTheirPlaceInTheFile) {
    const std::string text =
        "Plane {\ny randfloat(-2, 3)\n}\nPlane {\ny randfloat(-2, 3)\n}\nLambert {\n"
        "color randfloat(0,1) randfloat(0,1) 5\n}";
    const Scene scene = loaded(text).scene;
    const double first = random_y(scene.geometries, 0), second = random_y(scene.geometries, 1);
    EXPECT_TRUE(first >= -2 && first < 3);
    EXPECT_NE(first, second);
    EXPECT_EQ(random_y(loaded(text).scene.geometries, 0), first);
    EXPECT_EQ(random_y(loaded(text + "\nPlane {\n}").scene.geometries, 1), second);
    const Rgb color = std::get<Lambert>(scene.materials[0]).color;
    EXPECT_NE(color.r, color.g);
    EXPECT_EQ(color.b, 5);
}

TEST_F(Grammar, DrawsWholeNumbersBothEndsIncluded) {
    std::string text;
    for (int i = 0; i < 100; ++i) text += "Plane {\ny randint(3, 5)\n}\n";
    const Scene scene = loaded(text).scene;
    int seen[3] = {};
    for (int i = 0; i < 100; ++i) {
        const double y = random_y(scene.geometries, i);
        ASSERT_TRUE(y == 3 || y == 4 || y == 5) << y;
        ++seen[static_cast<int>(y) - 3];
    }
    for (const int count : seen) EXPECT_GT(count, 15);
}

TEST_F(Grammar, LeavesNamesThatOnlyBeginLikeRandomNumbers) {
    EXPECT_EQ(answer("Checker randint {\n}\nChecker myrandint {\n}\nLambert {\ntexture randint\n}\n"
                     "Lambert {\ntexture myrandint\n}"),
              "");
}

TEST(Words, ArePartedByBlanksCommasAndParentheses) {
    EXPECT_THAT(loader::words_of("grey (1, 2,3) \"my mask\" end"),
                ElementsAre("grey", "1", "2", "3", "my mask", "end"));
    EXPECT_THAT(loader::words_of(" ,()"), ElementsAre());
    EXPECT_THAT(loader::words_of("\"open"), ElementsAre("open"));
}

}  // namespace
}  // namespace luch
