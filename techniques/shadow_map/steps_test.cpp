// The steps against closed forms.
#include "techniques/shadow_map/shadow_map.h"

#include <gtest/gtest.h>

namespace luch::techniques::shadow_map {
namespace {

const Steps steps = reference();

TEST(ShadowMapSteps, FindTheTexelOfEachDirectionThroughACentre) {
    for (const int n : {1, 2, 7, 64, 2048}) {
        for (int face = 0; face < faces_of_cube; ++face) {
            std::vector<Texel> texels;
            for (int i = 0; i < n; ++i) texels.push_back({face, i, (i * 7 + 3) % n});
            std::vector<Vec3> directions(texels.size());
            std::vector<Texel> again(texels.size());
            steps.direction_of(texels, n, directions);
            steps.texel_of(directions, n, again);
            EXPECT_EQ(again, texels) << n << " " << face;
        }
    }
}

}  // namespace
}  // namespace luch::techniques::shadow_map
