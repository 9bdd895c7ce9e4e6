#include "framework/image/io.h"
#include "tests/scene/scene_file.h"

#include <gmock/gmock.h>

namespace luch {
namespace {

using SceneFiles = SceneFile;

TEST_F(SceneFiles, AreAllNamedThatAScenesPictureIsMadeOf) {
    const std::string triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    write_text(folder_ / "a.obj", triangle);
    write_picture(folder_ / "b.png", Image<Rgb>({2, 2}, Rgb(0.5f)).view());
    const Loaded scene =
        loaded("Mesh mesh {\nfile \"a.obj\"\n}\nBitmapTexture picture {\nfile \"b.png\"\n}\n");
    EXPECT_THAT(scene.files, ::testing::UnorderedElementsAre(folder_ / "t.scene", folder_ / "a.obj",
                                                             folder_ / "b.png"));
}

TEST_F(SceneFiles, AreOneWhenTheSceneNamesNoOther) {
    EXPECT_THAT(loaded("").files, ::testing::ElementsAre(folder_ / "t.scene"));
}

}  // namespace
}  // namespace luch
