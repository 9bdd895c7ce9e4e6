#include "framework/accel/embree_tree.h"

#include <embree3/rtcore.h>

#include <string>

namespace luch {
namespace {

std::string config_of(Isa isa) {
    const char* name = isa == Isa::v4 ? "avx512" : isa == Isa::v3 ? "avx2" : "sse4.2";
    return std::string("threads=1,isa=") + name;
}

bool count_bytes(void* sum, ssize_t bytes, bool) {
    *static_cast<std::atomic<std::int64_t>*>(sum) += bytes;
    return true;
}

RTCGeometry geometry_of(RTCDevice device, const Mesh& mesh, float scale) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.positions.size()));
    for (const Vec3& p : mesh.positions) {
        for (int axis = 0; axis < 3; ++axis) *positions++ = p[axis] * scale;
    }
    auto* corners = static_cast<unsigned*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(unsigned), mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles) {
        for (const unsigned corner : triangle.position) *corners++ = corner;
    }
    rtcCommitGeometry(geometry);
    return geometry;
}

}  // namespace

EmbreeTree::EmbreeTree(const Mesh& mesh, float scale, bool robust, Isa isa)
    : device_(rtcNewDevice(config_of(isa).c_str())) {
    rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, &bytes_);
    scene_ = rtcNewScene(device_);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
    if (robust) rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = geometry_of(device_, mesh, scale);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
}

EmbreeTree::~EmbreeTree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
}

}  // namespace luch
