#include "framework/technique/params.h"

#include "framework/base/error.h"
#include "framework/technique/technique.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace luch {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

class Tunable final : public Technique {
 public:
    int segments = 8;
    double radius = 0.5;
    bool soft = false;
    int mode = 0;

    void visit(ParamVisitor& visitor) override {
        static constexpr std::array<std::string_view, 2> words{"fast", "exact"};
        visitor.visit({"segments", "", "of a circle"}, segments, 4, 128);
        visitor.visit({"radius", "m", "of the search"}, radius, 0, 10);
        visitor.visit({"soft", "", "blurred"}, soft);
        visitor.visit({"mode", "", "how"}, mode, words);
    }
    Plan plan(const Scene&, const Shot&) const override { return {}; }
    void render(const Scene&, const Shot&, Frame&, Context&) override {}
};

TEST(Params, AreSetFromTextOfTheirKind) {
    Tunable technique;
    set_param(technique, "segments=16");
    set_param(technique, "radius = 2.5");
    set_param(technique, "soft=on");
    set_param(technique, "mode=exact");
    EXPECT_EQ(technique.segments, 16);
    EXPECT_EQ(technique.radius, 2.5);
    EXPECT_TRUE(technique.soft);
    EXPECT_EQ(technique.mode, 1);
}

TEST(Params, RefuseWhatIsWrongAndSayWhatIsRight) {
    Tunable technique;
    const auto setting = [&](std::string_view text) {
        return [&technique, text] { set_param(technique, text); };
    };
    EXPECT_THAT(setting("segments=3"), ThrowsMessage<Error>(HasSubstr("from 4 to 128")));
    EXPECT_THAT(setting("segments=8.5"), ThrowsMessage<Error>(HasSubstr("a whole number")));
    EXPECT_THAT(setting("radius=nan"), ThrowsMessage<Error>(HasSubstr("a number from 0 to 10")));
    EXPECT_THAT(setting("soft=maybe"), ThrowsMessage<Error>(HasSubstr("on or off")));
    EXPECT_THAT(setting("mode=slow"), ThrowsMessage<Error>(HasSubstr("fast or exact")));
    EXPECT_THAT(setting("segment=8"), ThrowsMessage<Error>(HasSubstr("did you mean segments")));
    EXPECT_THAT(setting("segments"), ThrowsMessage<Error>(HasSubstr("key=value")));
    EXPECT_EQ(technique.segments, 8);
}

TEST(Params, AreListedWithUnitAndRange) {
    Tunable technique;
    const auto params = params_of(technique);
    ASSERT_EQ(params.size(), 4u);
    EXPECT_EQ(params[0].range, "4…128");
    EXPECT_EQ(params[1].unit, "m");
    EXPECT_EQ(params[3].value, "fast");
}

}  // namespace
}  // namespace luch
