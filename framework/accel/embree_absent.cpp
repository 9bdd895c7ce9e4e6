#include "framework/accel/embree.h"
#include "framework/accel/embree_mesh.h"
#include "framework/accel/embree_tree.h"
#include "framework/base/error.h"

// In place of embree.cpp, embree_mesh.cpp and embree_tree.cpp where the library is not installed.
// What cannot be built is never asked.
namespace luch {

bool has_embree() {
    return false;
}

EmbreeTree::EmbreeTree(const Mesh&, float, bool, Isa) {
    throw Error("this build has no Embree; install libembree-dev and configure again");
}
EmbreeTree::~EmbreeTree() = default;

EmbreeScene::EmbreeScene(const Mesh& mesh, float scale, bool robust, Isa isa)
    : tree_(std::make_unique<EmbreeTree>(mesh, scale, robust, isa)) {}
EmbreeScene::~EmbreeScene() = default;

std::unique_ptr<EmbreeScene::Batch> EmbreeScene::batch(std::span<const Ray>, EmbreeMode,
                                                       bool) const {
    return nullptr;
}

EmbreeMesh::EmbreeMesh(const Mesh& mesh, Isa isa)
    : mesh_(&mesh), own_(mesh, isa), tree_(std::make_unique<EmbreeTree>(mesh, 1.0f, true, isa)) {}
EmbreeMesh::EmbreeMesh(EmbreeMesh&&) noexcept = default;
EmbreeMesh::~EmbreeMesh() = default;

bool EmbreeMesh::closest(const ObjectRay&, NodeId, Hit&, WorkCounts&) const {
    return false;
}
bool EmbreeMesh::occluded(const ObjectRay&, WorkCounts&) const {
    return false;
}
void EmbreeMesh::closest(const RayPacket&, const Node&, NodeId, HitPacket&, WorkCounts&) const {}
void EmbreeMesh::occluded(const RayPacket&, const Node&, float*, WorkCounts&) const {}
std::uint64_t EmbreeMesh::bytes() const {
    return 0;
}

}  // namespace luch
