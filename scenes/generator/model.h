#pragma once

#include "framework/math/vec.h"
#include "scenes/generator/assets.h"
#include "scenes/generator/indexed_image.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace luch::assets {

/// Triangles of one paint, in glTF's coordinates: right-handed, y up, counter-clockwise as seen
/// from outside.
struct Part {
    using Triangle = std::array<std::uint32_t, 3>;

    std::vector<Vec3d> points{};
    std::vector<Vec3d> normals{};  ///< one a point, length 1; or none
    std::vector<Vec2d> uvs{};      ///< one a point, v downwards; or none
    std::vector<Triangle> triangles{};
    int paint = 0;
};

/// A base colour, linear, times a picture where there is one (an index into Model::pictures).
struct Paint {
    Vec3d colour{1};
    int picture = -1;
};

/// A node: its mesh and its children are scaled, then turned about an axis, then moved.
struct Joint {
    int mesh = -1;
    std::vector<int> children{};
    Vec3d translation{0};
    Vec3d scale{1};
    Vec3d axis{0, 1, 0};
    double angle = 0;  ///< radians
};

/// All that a glTF file of ours holds. The first joint is the root.
struct Model {
    struct Picture {
        std::string name;
        IndexedImage image;
    };
    std::vector<std::vector<Part>> meshes;
    std::vector<Paint> paints;
    std::vector<Picture> pictures;
    std::vector<Joint> joints;
};

/// A binary glTF 2.0 file, pictures included. `compact`: positions are 16 bits a coordinate
/// (KHR_mesh_quantization), scaled by the joint, of which there must be one only.
std::string glb_bytes(const Model& model, bool compact = false);

/// A glTF 2.0 file as text, below `path` without its ending: .gltf, .bin and the pictures as .png.
std::vector<Asset> gltf_files(const Model& model, const std::string& path);

}  // namespace luch::assets
