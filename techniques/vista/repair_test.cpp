#include "framework/technique/catalogue.h"
#include "techniques/vista/stand_ins.h"
#include "techniques/vista/vista.h"
#include "tests/testing/scenes.h"

#include <gtest/gtest.h>

namespace luch::baseline {
TechniqueInfo describe();
}

namespace luch::techniques::vista {
namespace {

using testing::OwnStudio;
using testing::plane_of;

const OwnStudio& spheres() {
    static const OwnStudio studio([] {
        Scene scene = testing::sixty_spheres();
        scene.settings.frame = {640, 480};
        return scene;
    }());
    return studio;
}

/// The nodes that the rays truly meet.
const Image<NodeId>& truth() {
    static const Image<NodeId> ids = [] {
        const auto technique = make(reference(), Mode::exact);
        return plane_of<NodeId>(spheres().render(*technique, Budget{.forced = {"item buffer"}}),
                                "ids");
    }();
    return ids;
}

/// The lecture's own form, and what of its holes is closed.
Outcome classic(int segments, const std::string& repair) {
    const auto technique = make(reference());
    set_param(*technique, "segments=" + std::to_string(segments));
    set_param(*technique, "hidden=depth");
    set_param(*technique, "repair=" + repair);
    return spheres().render(*technique);
}

std::size_t wrong_ids(const Outcome& outcome) {
    const auto& ids = plane_of<NodeId>(outcome, "ids").pixels();
    std::size_t count = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) count += ids[i] != truth().pixels()[i];
    return count;
}

std::size_t wrong_pixels(const Outcome& outcome) {
    static const Outcome frame = spheres().render(*baseline::describe().create());
    return testing::different_pixels(outcome, frame);
}

TEST(VistaRepair, HasWrongIdsThatFallWithTheSquareOfTheSegments) {
    double x = 0, y = 0, xx = 0, xy = 0;
    int n = 0;
    for (int segments = 4; segments <= 128; segments *= 2) {
        const std::size_t wrong = wrong_ids(classic(segments, "none"));
        RecordProperty("wrong_ids_" + std::to_string(segments), static_cast<int>(wrong));
        if (segments == 4) continue;  // an octahedron is no small error any more
        const double at = std::log2(segments), value = std::log2(static_cast<double>(wrong));
        x += at, y += value, xx += at * at, xy += at * value, ++n;
    }
    const double slope = (n * xy - x * y) / (n * xx - x * x);
    EXPECT_NEAR(slope, -2, 0.1);
}

TEST(VistaRepair, LosesNoSilhouetteWithPolyhedraAroundTheSpheres) {
    for (const int segments : {4, 8, 32}) {
        const Outcome outcome = classic(segments, "circumscribed");
        const auto& ids = plane_of<NodeId>(outcome, "ids").pixels();
        std::size_t lost = 0;
        for (std::size_t i = 0; i < ids.size(); ++i) {
            lost += ids[i] == no_node && truth().pixels()[i] != no_node;
        }
        EXPECT_EQ(lost, 0u) << segments;
        EXPECT_GT(wrong_pixels(outcome), 0u) << "a hit is no proof that it is the nearest";
        EXPECT_GT(outcome.counts.fallbacks, 100u);
    }
}

TEST(VistaRepair, LeavesNoWrongPixelWithTheSecondDepth) {
    for (const int segments : {4, 8, 32}) {
        const std::size_t wrong = wrong_pixels(classic(segments, "none"));
        RecordProperty("wrong_pixels_" + std::to_string(segments), static_cast<int>(wrong));
        EXPECT_GT(wrong, 500u);
        const Outcome repaired = classic(segments, "both");
        EXPECT_EQ(wrong_pixels(repaired), 0u) << segments;
        EXPECT_EQ(repaired.counts.of(RayKind::primary), repaired.counts.fallbacks);
        RecordProperty("fallbacks_" + std::to_string(segments),
                       static_cast<int>(repaired.counts.fallbacks));
        EXPECT_LT(repaired.counts.fallbacks, segments < 32 ? 640u * 480u : 640u * 480u / 10);
    }
}

TEST(VistaRepair, GrowsTheRadiusAsTheFacesAreInside) {
    EXPECT_NEAR(circumscribed(4), 2, 1e-12) << "an octahedron: cos²(45°)";
    EXPECT_NEAR(circumscribed(32), 1 / std::pow(std::cos(3.14159265358979 / 32), 2), 1e-12);
}

}  // namespace
}  // namespace luch::techniques::vista
