#include "framework/accel/embree.h"
#include "framework/base/error.h"

// In place of embree.cpp where the library is not installed.
namespace luch {

struct EmbreeScene::State {};

bool has_embree() {
    return false;
}

EmbreeScene::EmbreeScene(const Mesh&, float, bool, Isa) {
    throw Error("this build has no Embree; install libembree-dev and configure again");
}
EmbreeScene::~EmbreeScene() = default;

std::unique_ptr<EmbreeScene::Batch> EmbreeScene::batch(std::span<const Ray>, EmbreeMode,
                                                       bool) const {
    return nullptr;
}

}  // namespace luch
