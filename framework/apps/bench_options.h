#pragma once

#include "framework/base/json.h"
#include "framework/measure/bench_rays.h"

#include <optional>
#include <string>
#include <vector>

// What the parts of `luch bench` share. Each part is a file of its own.
namespace luch {

/// What the user asked for, checked.
struct BenchOptions {
    std::vector<std::string> inputs;  ///< meshes, scenes
    RayBench rays;                    ///< back ends, threads, rounds… of every part
    bool any_threads = true;          ///< no number of threads was asked for
    bool any_backend = true;          ///< no back end was
    int width = 0, height = 0;        ///< 0: not given
    std::string view, json;

    /// The frame's size, where it is not given that of `usual`.
    [[nodiscard]] Size size(Size usual) const;
    /// Writes the speeds with this program's version, where that was asked for.
    void write(Json speeds) const;
};

// The exit status: 1 where what was raced gives different results.
int bench_rays(const BenchOptions& options);
int bench_raster(const BenchOptions& options);
int bench_mix(const BenchOptions& options);
int bench_frame(const BenchOptions& options);

/// Of an .obj file, or "bumpy": a generated one of 2²⁰ triangles. Throws Error for other names.
Mesh mesh_of(const std::string& name);

/// "x,y,z,x,y,z,x,y,z": eye, at and light in the file's coordinates; "": outside, for any mesh.
BenchView view_of(const std::string& text, const Mesh& mesh);

}  // namespace luch
