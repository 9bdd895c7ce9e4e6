#include "framework/accel/embree.h"
#include "framework/apps/bench_options.h"
#include "framework/apps/verbs.h"
#include "framework/base/error.h"
#include "framework/base/text.h"

#include <fmt/format.h>

namespace luch {
namespace {

struct Part {
    std::string_view name;
    int (*run)(const BenchOptions&);
    std::string_view inputs;  ///< what it needs, "" when nothing
};
constexpr Part parts[] = {{"rays", bench_rays, "meshes: .obj files, or bumpy"},
#ifdef LUCH_ITEM_BUFFER
                          {"raster", bench_raster, "meshes: .obj files, or bumpy"},
#endif
#ifdef LUCH_WORDS
                          {"mix", bench_mix, ""},
#endif
                          {"frame", bench_frame, "scene files"}};

constexpr int not_given = std::numeric_limits<int>::min();

std::vector<std::string> checked(const std::string& text, const std::string& option,
                                 std::span<const std::string_view> known) {
    std::vector<std::string> words = split(text, ',');
    for (const std::string& word : words) {
        if (std::ranges::find(known, word) != known.end()) continue;
        throw Error(option + " " + word + ": " + did_you_mean(word, known));
    }
    return words;
}

class Bench final : public Verb {
 public:
    std::string_view name() const override { return "bench"; }
    std::string_view summary() const override { return "how fast rays and pixels are"; }
    std::string_view examples() const override {
        return "  luch bench rays scenes/room/teapot_hires.obj\n"
               "  luch bench rays bumpy --backend luch,embree --rays primary,shadow\n"
               "  luch bench raster bumpy --backend luch,embree --width 1280 --height 720\n"
               "  luch bench mix                               two frames, half and half\n"
               "  luch bench frame scenes/room/room.scene      a whole picture, on 1 core and "
               "all\n";
    }
    void declare(Arguments& arguments) override {
        RayBench& rays = options_.rays;
        arguments.positional("WHAT", what_, "rays, raster, mix or frame");
        arguments.positional("INPUT", options_.inputs,
                             "rays, raster: .obj files, or bumpy (generated); frame: scenes",
                             false);
        arguments.option("--backend", backends_, "NAMES",
                         "luch, or luch,embree to race them [luch; bench frame: all there are]");
        arguments.option("--rays", kinds_, "KINDS", "of primary, shadow and diffuse");
        arguments.option("--threads", threads_, "N",
                         "threads, 0: one a core [1; bench frame: 1 and one a core]");
        arguments.option("--isa", isa_, "LEVEL", "v2, v3 or v4, for all back ends [the best]");
        arguments.option("--side", rays.side, "N", "N x N rays of a kind [1024]");
        arguments.option("--width", width_, "N", "of a frame [1920; bench frame: the scene's]");
        arguments.option("--height", height_, "N", "of a frame [1080; bench frame: the scene's]");
        arguments.option("--rounds", rays.rounds, "N", "medians of so many runs [7]");
        arguments.option("--scale", rays.scale, "X", "size of the mesh, a power of two [1]");
        arguments.option("--view", options_.view, "NUMBERS", "eye, target, light: nine numbers");
        arguments.option("--json", options_.json, "FILE", "write the speeds as JSON");
    }
    int run() override {
        const Part& part = checked_part();
        check_words();
        check_numbers();
        return part.run(options_);
    }

 private:
    [[nodiscard]] const Part& checked_part() const {
        std::vector<std::string_view> names;
        for (const Part& part : parts) names.push_back(part.name);
        checked(what_, "bench", names);
        const Part& part = *std::ranges::find(parts, what_, &Part::name);
        if (part.inputs.empty() == options_.inputs.empty()) return part;
        if (part.inputs.empty()) {
            throw Error("bench " + what_ + ": it needs no " + options_.inputs[0] +
                        "; leave that out");
        }
        throw Error(fmt::format("bench {}: give {}", what_, part.inputs));
    }

    void check_words() {
        constexpr std::string_view backends[] = {"luch", "embree"},
                                   kinds[] = {"primary", "shadow", "diffuse"};
        RayBench& rays = options_.rays;
        options_.any_backend = backends_.empty();
        rays.backends = checked(backends_.empty() ? "luch" : backends_, "--backend", backends);
        rays.kinds = checked(kinds_, "--rays", kinds);
        rays.isa = parsed_isa(isa_);
        if (std::ranges::count(rays.backends, "embree") > 0 && !has_embree()) {
            throw Error("--backend embree: this build has no Embree; install libembree-dev");
        }
    }

    void check_numbers() {
        RayBench& rays = options_.rays;
        options_.any_threads = threads_ == not_given;
        rays.threads = options_.any_threads ? 1 : threads_;
        if (rays.threads < 0 || rays.threads > 1024) {
            throw Error(fmt::format("--threads {}: give 0 to 1024", rays.threads));
        }
        if (rays.side < 16 || rays.side > 8192 || rays.side % 16 != 0) {
            throw Error(fmt::format("--side {}: give a multiple of 16, to 8192", rays.side));
        }
        const auto checked_side = [](const char* option, int side) {
            if (side == not_given) return 0;
            if (side >= 1 && side <= 8192) return side;
            throw Error(fmt::format("{} {}: give 1 to 8192", option, side));
        };
        options_.width = checked_side("--width", width_);
        options_.height = checked_side("--height", height_);
        if (rays.rounds < 1 || rays.rounds > 1000) {
            throw Error(fmt::format("--rounds {}: give 1 to 1000", rays.rounds));
        }
        if (!(rays.scale > 0) || std::exp2(std::round(std::log2(rays.scale))) != rays.scale) {
            throw Error(fmt::format("--scale {}: give a power of two", rays.scale));
        }
    }

    std::string what_, isa_, backends_, kinds_ = "primary,shadow,diffuse";
    int threads_ = not_given, width_ = not_given, height_ = not_given;
    BenchOptions options_;
};

}  // namespace

Size BenchOptions::size(Size usual) const {
    return {width > 0 ? width : usual.width, height > 0 ? height : usual.height};
}

void BenchOptions::write(Json speeds) const {
    if (!json.empty()) speeds.set("version", LUCH_VERSION).write(json);
}

std::unique_ptr<Verb> make_bench() {
    return std::make_unique<Bench>();
}

}  // namespace luch
