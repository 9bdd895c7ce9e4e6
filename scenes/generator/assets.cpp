#include "scenes/generator/assets.h"

#include "scenes/generator/cornell.h"
#include "scenes/generator/dice.h"
#include "scenes/generator/island.h"
#include "scenes/generator/lathe.h"
#include "scenes/generator/sixty_spheres.h"
#include "scenes/generator/sky.h"
#include "scenes/generator/teapot.h"
#include "scenes/generator/textures.h"

namespace luch::assets {
namespace {

constexpr const char* about_teapot =
    "The Utah teapot from M. Newell's control points (1975). Written by luch_assets.";
constexpr const char* about_glass = "A surface of revolution. Written by luch_assets.";

}  // namespace

std::vector<Asset> all_assets() {
    std::vector<Asset> assets{
        {"room/teapot_hires.obj", obj_text(teapot(10), about_teapot)},
        {"room/teapot_lowres.obj", obj_text(teapot(4), about_teapot)},
        {"room/boards.bmp", bmp_bytes(boards({256, 256}))},
        {"room/marble.bmp", bmp_bytes(marble({256, 256}))},
        {"room/plaster.bmp", bmp_bytes(plaster({256, 256}))},
        {"room/landscape.bmp", bmp_bytes(landscape({160, 104}))},
        {"spheres/spheres.scene", sixty_spheres_scene()},
        {"mirrors/teapot.obj", obj_text(teapot(6), about_teapot)},
        {"glass/tumbler.obj", obj_text(tumbler(48), about_glass)},
        {"glass/drink.obj", obj_text(tumbler_drink(48), about_glass)},
        {"glass/wine_glass.obj", obj_text(wine_glass(48), about_glass)},
        {"glass/wine.obj", obj_text(wine(48), about_glass)},
        {"mirrors/hammered.bmp", bmp_bytes(hammered({128, 128}))},
        {"island/heights.bmp", bmp_bytes(island_heights({320, 320}))},
        {"island/colours.bmp", bmp_bytes(island_colours({320, 320}))},
        {"die/die.scene", dice_scene()},
        {"die/boards.bmp", bmp_bytes(boards({256, 256}))},
    };
    for (const auto& [name, obj] : cornell_parts()) {
        assets.push_back({"cornell/" + name + ".obj", obj});
    }
    for (const auto& [side, image] : evening_sky(64)) {
        assets.push_back({"mirrors/sky/" + side + ".bmp", bmp_bytes(image)});
    }
    for (const auto& [side, image] : evening_sky(64)) {
        assets.push_back({"die/sky/" + side + ".bmp", bmp_bytes(image)});
    }
    for (const auto& [side, image] : fair_sky(192)) {
        assets.push_back({"island/sky/" + side + ".bmp", bmp_bytes(image)});
    }
    return assets;
}

}  // namespace luch::assets
