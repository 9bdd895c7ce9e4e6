#include "framework/technique/technique.h"

namespace luch {

Shot shot_of(const Scene& scene) {
    return {.camera = scene.camera, .size = scene.settings.frame};
}

}  // namespace luch
