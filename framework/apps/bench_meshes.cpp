#include "framework/apps/bench_options.h"
#include "framework/base/error.h"
#include "framework/base/text.h"
#include "framework/scene/loader/mesh_builder.h"
#include "framework/scene/loader/obj.h"

#include <numbers>

namespace luch {
namespace {

/// A closed surface of 2²⁰ triangles with bumps of several sizes, for when no mesh of that size is
/// at hand.
Mesh bumpy_sphere() {
    constexpr int rings = 512, segments = 1024;
    std::vector<Vec3d> positions;
    for (int ring = 0; ring <= rings; ++ring) {
        for (int segment = 0; segment < segments; ++segment) {
            const double theta = std::numbers::pi * ring / rings;
            const double phi = 2 * std::numbers::pi * segment / segments;
            const double bumps = std::sin(7 * theta) * std::cos(5 * phi) +
                                 0.3 * std::sin(41 * theta + 3) * std::sin(37 * phi) +
                                 0.05 * std::sin(201 * theta) * std::cos(199 * phi);
            const double radius = 1 + 0.1 * bumps * std::sin(theta);
            positions.emplace_back(radius * std::sin(theta) * std::cos(phi),
                                   radius * std::cos(theta),
                                   radius * std::sin(theta) * std::sin(phi));
        }
    }
    Mesh mesh;
    set_positions(mesh, positions);
    for (std::uint32_t i = 0; i < rings * segments; ++i) {
        const std::uint32_t next = i / segments * segments + (i + 1) % segments;
        mesh.triangles.push_back({.position = {i, next, i + segments}, .normal = {}, .uv = {}});
        mesh.triangles.push_back(
            {.position = {next, next + segments, i + segments}, .normal = {}, .uv = {}});
    }
    return mesh;
}

}  // namespace

Mesh mesh_of(const std::string& name) {
    if (name == "bumpy") return bumpy_sphere();
    if (!std::filesystem::is_regular_file(name)) {
        throw Error(name + ": there is no such file; give an .obj, or bumpy for a generated mesh");
    }
    loader::Diagnostics diagnostics(name, false);
    return loader::mesh_of(loader::read_obj(name, diagnostics), {}, name);
}

BenchView view_of(const std::string& text, const Mesh& mesh) {
    if (text.empty()) {
        const Boxd box = bounds_of(mesh);
        const double radius = 0.5 * glm::length(box.size());
        return {box.centre() + 1.75 * radius * glm::normalize(Vec3d(0.5, 0.35, 1)), box.centre(),
                box.centre() + 2.5 * radius * glm::normalize(Vec3d(-0.8, 1, 0.8))};
    }
    std::vector<double> numbers;
    for (const std::string& word : split(text, ',')) {
        const auto number = parsed_number(word);
        if (number) numbers.push_back(*number);
    }
    if (numbers.size() != 9) {
        throw Error("--view " + text +
                    ": give nine numbers, x,y,z of the eye, of what it looks "
                    "at, and of the light");
    }
    const Transform to_frame = mesh.from_frame.inverse();
    const auto point = [&](int i) {
        return to_frame.point({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]});
    };
    return {point(0), point(1), point(2)};
}

}  // namespace luch
