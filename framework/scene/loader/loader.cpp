#include "framework/scene/loader/loader.h"

#include "framework/base/files.h"
#include "framework/scene/loader/blocks.h"
#include "framework/scene/loader/classes.h"

#include <new>

namespace luch {
namespace {

using namespace loader;

/// What blocks may refer to is read before what refers to it, so that the order of the file is
/// free.
void read_blocks(const std::vector<Block>& blocks, Loading& loading) {
    std::vector<const BlockClass*> classes;
    for (const Block& block : blocks) {
        classes.push_back(&class_of(block, loading.diagnostics));
        loading.names.add(classes.back()->kind, block, loading.diagnostics);
    }
    const auto read_kind = [&](auto... kinds) {
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            if (!((classes[i]->kind == kinds) || ...)) continue;
            Properties properties(blocks[i], loading.diagnostics);
            classes[i]->read(properties, loading);
            properties.finish();
        }
    };
    read_kind(Kind::texture);
    read_kind(Kind::geometry);
    unfold_solids(loading);
    read_kind(Kind::shader);
    check_layers(loading);
    add_file_materials(loading);
    read_kind(Kind::node, Kind::other);
}

std::string scene_text(const std::filesystem::path& file) {
    constexpr std::uintmax_t most_bytes = 128 << 20;
    if (std::filesystem::is_directory(file)) {
        throw Error({file.string()}, "is a folder; name a scene in it");
    }
    return read_text(file, most_bytes);
}

}  // namespace

Loaded load_scene(const std::filesystem::path& file, const LoadOptions& options) {
    try {
        Diagnostics diagnostics(file.string(), options.strict);
        Loading loading{diagnostics, Assets(file, options), {}, {}, {}, {}, {}, {}, {}};
        read_blocks(parse_blocks(scene_text(file), diagnostics), loading);
        if (loading.camera_class.empty()) {
            diagnostics.fail(0, "has no Camera; add a block \"Camera camera {\" with a pos");
        }
        loading.scene.name = file.stem().string();
        std::vector<std::filesystem::path> files{file};
        files.insert(files.end(), loading.assets.named().begin(), loading.assets.named().end());
        return {std::move(loading.scene), std::move(diagnostics.warnings()), std::move(files)};
    } catch (const std::bad_alloc&) {
        throw Error({file.string()}, "needs more memory than there is; make its parts smaller");
    }
}

}  // namespace luch
