#include "scenes/generator/assets.h"

#include "scenes/generator/cornell.h"
#include "scenes/generator/dice.h"
#include "scenes/generator/forest.h"
#include "scenes/generator/island.h"
#include "scenes/generator/lathe.h"
#include "scenes/generator/many_lights.h"
#include "scenes/generator/masonry.h"
#include "scenes/generator/prints.h"
#include "scenes/generator/sixty_spheres.h"
#include "scenes/generator/sky.h"
#include "scenes/generator/stationery.h"
#include "scenes/generator/teapot.h"
#include "scenes/generator/textures.h"
#include "scenes/generator/toys.h"

namespace luch::assets {
namespace {

constexpr const char* about_teapot =
    "The Utah teapot from M. Newell's control points (1975). Written by luch_assets.";
constexpr const char* about_glass = "A surface of revolution. Written by luch_assets.";

void add_page(std::vector<Asset>& assets) {
    assets.push_back({"page/book.obj", obj_text(open_book(), "Both pages of an open book.")});
    assets.push_back({"page/pencil.obj", obj_text(pencil_body(), about_glass)});
    assets.push_back({"page/wood.obj", obj_text(pencil_wood(), about_glass)});
    assets.push_back({"page/lead.obj", obj_text(pencil_lead(), about_glass)});
    assets.push_back({"page/print.bmp", bmp_bytes(printed_pages({640, 448}))});
    assets.push_back({"page/desk.bmp", bmp_bytes(boards({192, 192}))});
}

void add_fisheye(std::vector<Asset>& assets) {
    assets.push_back({"fisheye/column.obj", obj_text(column(), about_glass)});
    assets.push_back({"fisheye/entablature.obj", obj_text(entablature(), about_glass)});
    assets.push_back({"fisheye/dome.obj", obj_text(dome(), about_glass)});
    assets.push_back({"fisheye/wall.obj", obj_text(wall(), about_glass)});
    assets.push_back({"fisheye/pavement.obj", obj_text(pavement(), about_glass)});
    assets.push_back({"fisheye/coffer.bmp", bmp_bytes(coffer({96, 96}))});
    assets.push_back({"fisheye/panel.bmp", bmp_bytes(panel({128, 128}))});
    assets.push_back({"fisheye/spirals.bmp", bmp_bytes(spirals({640, 160}))});
    assets.push_back({"fisheye/marble.bmp", bmp_bytes(marble({128, 128}))});
}

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
        {"many_lights/many_lights.scene", many_lights_scene()},
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
    add_page(assets);
    add_fisheye(assets);
    for (const auto& [side, image] : evening_sky(64)) {
        assets.push_back({"die/sky/" + side + ".bmp", bmp_bytes(image)});
    }
    for (const auto& [side, image] : fair_sky(128)) {
        assets.push_back({"island/sky/" + side + ".bmp", bmp_bytes(image)});
    }
    assets.push_back({"toys/toy_windmill.glb", glb_bytes(toy_windmill())});
    for (Asset& file : gltf_files(toy_train(), "toys/toy_train")) assets.push_back(std::move(file));
    for (Asset& file : forest_files()) assets.push_back(std::move(file));
    return assets;
}

}  // namespace luch::assets
