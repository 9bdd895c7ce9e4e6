#pragma once

#include "framework/measure/report.h"
#include "framework/technique/catalogue.h"
#include "framework/technique/run.h"

#include <functional>
#include <span>

namespace luch {

/// Something the lab is about to do, and how far it is.
struct LabStep {
    std::string what;  ///< "vista lod=4"
    double begun = 0;  ///< part of this scene's work that is done, 0..1
};

struct LabOptions {
    std::vector<int> spp{1, 4, 16};  ///< of the baseline's own curve
    int truth_spp = 64;              ///< of that curve's truth, made with another seed
    Repeat repeat{};
    std::filesystem::path pictures;  ///< folder for PNG files; empty: none are written
    std::function<void(const LabStep&)> on_step;

    /// Fewer samples and frames.
    static LabOptions quick();
};

/// A scene under test: what it is called in the report, and how a frame of it is made.
struct LabScene {
    std::string name;
    Studio studio;
    Shot shot;  ///< its spp is set by the lab
    Budget budget;
};

/// Runs every technique along its sweep, and the baseline along samples per pixel. What cannot be
/// run (a plan that does not apply, an exception) becomes a row that says why; only a baseline that
/// cannot be run throws Error.
SceneReport run_lab(const LabScene& scene, const TechniqueInfo& baseline,
                    std::span<const TechniqueInfo* const> techniques,
                    const LabOptions& options = {});

}  // namespace luch
