#include "framework/base/json.h"
#include "scenes/generator/model.h"
#include "scenes/generator/png.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>

namespace luch::assets {
namespace {

// Component types and targets of the format (glTF 2.0 specification, sections 3.6 and 3.11).
constexpr int signed_short = 5122, unsigned_short = 5123, unsigned_int = 5125, real = 5126;
constexpr int vertices = 34962, elements = 34963;

template <class T>
void put(std::string& bytes, T value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    bytes.append(raw, sizeof value);
}

template <class V>
Json array_of(const V& vector) {
    Json array = Json::array();
    for (int k = 0; k < V::length(); ++k) array.push(static_cast<double>(vector[k]));
    return array;
}

/// The buffer and the arrays that describe it.
class Writer {
 public:
    explicit Writer(bool compact) : compact_(compact) {}

    Json mesh(const std::vector<Part>& parts) {
        extent_ = 0;
        for (const Part& part : parts) {
            for (const Vec3d& p : part.points) extent_ = std::max(extent_, max_norm(p));
        }
        Json primitives = Json::array();
        for (const Part& part : parts) {
            Json attributes = Json::object();
            attributes.set("POSITION", compact_ ? short_points(part) : float_points(part));
            if (!part.normals.empty()) {
                attributes.set("NORMAL", floats<glm::vec3>(part.normals, "VEC3"));
            }
            if (!part.uvs.empty())
                attributes.set("TEXCOORD_0", floats<glm::vec2>(part.uvs, "VEC2"));
            primitives.push(Json::object()
                                .set("attributes", attributes)
                                .set("indices", indices(part))
                                .set("material", part.paint));
        }
        return Json::object().set("primitives", primitives);
    }

    /// Index of the new bufferView.
    int view(std::string_view bytes, int target = 0, int stride = 0) {
        Json view = Json::object()
                        .set("buffer", 0)
                        .set("byteOffset", std::uint64_t{buffer_.size()})
                        .set("byteLength", std::uint64_t{bytes.size()});
        if (stride > 0) view.set("byteStride", stride);
        if (target > 0) view.set("target", target);
        views_.push(view);
        buffer_.append(bytes);
        buffer_.resize((buffer_.size() + 3) / 4 * 4, '\0');
        return view_count_++;
    }

    [[nodiscard]] double extent() const { return extent_; }
    [[nodiscard]] const std::string& buffer() const { return buffer_; }
    [[nodiscard]] const Json& views() const { return views_; }
    [[nodiscard]] const Json& accessors() const { return accessors_; }

 private:
    Json& accessor(int view, int component, const char* type, std::size_t count) {
        accessor_ = Json::object()
                        .set("bufferView", view)
                        .set("componentType", component)
                        .set("type", type)
                        .set("count", std::uint64_t{count});
        return accessor_;
    }
    int add(const Json& accessor) {
        accessors_.push(accessor);
        return accessor_count_++;
    }

    int float_points(const Part& part) {
        std::string bytes;
        glm::vec3 least(std::numeric_limits<float>::max()), most(-least);
        for (const Vec3d& p : part.points) {
            const glm::vec3 point(p);
            put(bytes, point);
            least = glm::min(least, point);
            most = glm::max(most, point);
        }
        return add(accessor(view(bytes, vertices), real, "VEC3", part.points.size())
                       .set("min", array_of(least))
                       .set("max", array_of(most)));
    }

    int short_points(const Part& part) {
        constexpr double largest = 32767;
        std::string bytes;
        glm::vec3 least(largest), most(-largest);
        for (const Vec3d& p : part.points) {
            for (int k = 0; k < 3; ++k) {
                const auto value = static_cast<std::int16_t>(std::lround(p[k] / extent_ * largest));
                put(bytes, value);
                least[k] = std::min(least[k], static_cast<float>(value));
                most[k] = std::max(most[k], static_cast<float>(value));
            }
            put(bytes, std::int16_t{0});
        }
        return add(accessor(view(bytes, vertices, 8), signed_short, "VEC3", part.points.size())
                       .set("normalized", true)
                       .set("min", array_of(least))
                       .set("max", array_of(most)));
    }

    template <class F, class V>
    int floats(const std::vector<V>& vectors, const char* type) {
        std::string bytes;
        for (const V& v : vectors) put(bytes, F(v));
        return add(accessor(view(bytes, vertices), real, type, vectors.size()));
    }

    int indices(const Part& part) {
        const bool small = part.points.size() < 65535;
        std::string bytes;
        for (const Part::Triangle& triangle : part.triangles) {
            for (const std::uint32_t i : triangle) {
                if (small) {
                    put(bytes, static_cast<std::uint16_t>(i));
                } else {
                    put(bytes, i);
                }
            }
        }
        return add(accessor(view(bytes, elements), small ? unsigned_short : unsigned_int, "SCALAR",
                            3 * part.triangles.size()));
    }

    bool compact_;
    double extent_ = 0;
    std::string buffer_;
    Json views_ = Json::array(), accessors_ = Json::array(), accessor_ = Json::object();
    int view_count_ = 0, accessor_count_ = 0;
};

Json node_of(const Joint& joint, double extent) {
    Json node = Json::object();
    if (joint.mesh >= 0) node.set("mesh", joint.mesh);
    if (!joint.children.empty()) {
        Json children = Json::array();
        for (const int child : joint.children) children.push(child);
        node.set("children", children);
    }
    if (joint.translation != Vec3d(0)) node.set("translation", array_of(joint.translation));
    if (joint.angle != 0) {
        const Vec3d axis = glm::normalize(joint.axis) * std::sin(joint.angle / 2);
        Json rotation = array_of(axis);
        node.set("rotation", rotation.push(std::cos(joint.angle / 2)));
    }
    if (joint.scale * extent != Vec3d(1)) node.set("scale", array_of(joint.scale * extent));
    return node;
}

Json material_of(const Paint& paint) {
    Json shading = Json::object();
    if (paint.colour != Vec3d(1)) {
        Json colour = array_of(paint.colour);
        shading.set("baseColorFactor", colour.push(1));
    }
    if (paint.picture >= 0) {
        shading.set("baseColorTexture", Json::object().set("index", paint.picture));
    }
    shading.set("metallicFactor", 0);
    return Json::object().set("pbrMetallicRoughness", shading);
}

/// The JSON; `image(i)` says where picture i is, `uri` where the buffer is, if not in the file.
template <class ImageOf>
Json json_of(const Model& model, Writer& writer, bool compact, const std::string& uri,
             ImageOf&& image) {
    Json meshes = Json::array(), nodes = Json::array(), materials = Json::array();
    Json textures = Json::array(), images = Json::array();
    for (const auto& parts : model.meshes) meshes.push(writer.mesh(parts));
    for (const Joint& joint : model.joints) {
        nodes.push(node_of(joint, compact ? writer.extent() : 1));
    }
    for (const Paint& paint : model.paints) materials.push(material_of(paint));
    for (int i = 0; i < static_cast<int>(model.pictures.size()); ++i) {
        textures.push(Json::object().set("source", i));
        images.push(image(i));
    }
    Json json = Json::object().set(
        "asset", Json::object().set("version", "2.0").set("generator", "luch_assets"));
    if (compact) {
        const Json names = Json::array().push("KHR_mesh_quantization");
        json.set("extensionsUsed", names).set("extensionsRequired", names);
    }
    json.set("scene", 0)
        .set("scenes", Json::array().push(Json::object().set("nodes", Json::array().push(0))))
        .set("nodes", nodes)
        .set("meshes", meshes)
        .set("materials", materials);
    if (!model.pictures.empty()) json.set("textures", textures).set("images", images);
    Json buffer = Json::object().set("byteLength", std::uint64_t{writer.buffer().size()});
    if (!uri.empty()) buffer.set("uri", uri);
    return json.set("accessors", writer.accessors())
        .set("bufferViews", writer.views())
        .set("buffers", Json::array().push(buffer));
}

}  // namespace

std::string glb_bytes(const Model& model, bool compact) {
    Writer writer(compact);
    std::string json =
        json_of(model, writer, compact, "", [&](int i) {
            const int view = writer.view(png_bytes(model.pictures[i].image));
            return Json::object().set("bufferView", view).set("mimeType", "image/png");
        }).text();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const auto u32 = [](std::size_t value) { return static_cast<std::uint32_t>(value); };
    std::string bytes = "glTF";
    put(bytes, std::uint32_t{2});
    put(bytes, u32(12 + 8 + json.size() + 8 + writer.buffer().size()));
    put(bytes, u32(json.size()));
    bytes += "JSON" + json;
    put(bytes, u32(writer.buffer().size()));
    bytes.append("BIN\0", 4);
    return bytes + writer.buffer();
}

std::vector<Asset> gltf_files(const Model& model, const std::string& path) {
    const std::filesystem::path base(path);
    const std::string name = base.filename().string();
    Writer writer(false);
    const Json json = json_of(model, writer, false, name + ".bin", [&](int i) {
        return Json::object().set("uri", model.pictures[i].name + ".png");
    });
    std::vector<Asset> files{{path + ".gltf", json.text()}, {path + ".bin", writer.buffer()}};
    for (const auto& picture : model.pictures) {
        files.push_back({(base.parent_path() / (picture.name + ".png")).generic_string(),
                         png_bytes(picture.image)});
    }
    return files;
}

}  // namespace luch::assets
