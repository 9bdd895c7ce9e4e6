#pragma once

#include "framework/measure/reference.h"
#include "framework/measure/report.h"

#include <functional>
#include <span>

namespace luch {

/// Something the lab is about to do, and how far it is.
struct LabStep {
    std::string what;  ///< "vista lod=4"
    double begun = 0;  ///< part of this scene's work that is done, 0..1
};

struct LabOptions {
    double most_spp = 32;  ///< sweeps by samples a pixel go no further
    /// Samples of a truth, in units of the largest number measured against it: the second is for
    /// when the first turns out not to be good enough.
    int truth_factor = 8, better_truth_factor = 32;
    int passes = 32;  ///< most independent frames that are averaged; 0: none
    Repeat repeat{};
    std::filesystem::path pictures;  ///< folder for PNG files; empty: none are written
    std::function<void(const LabStep&)> on_step;
    std::optional<Store> cache;    ///< of references
    std::optional<Store> journal;  ///< of what an interrupted run has measured
    /// What the journal's measurements hold for: the program's own bytes and the machine.
    std::string measured_by;

    /// Fewer samples and frames.
    static LabOptions quick();
};

/// A scene under test: what it is called in the report, and how a frame of it is made.
struct LabScene {
    std::string name;
    Studio studio;
    Shot shot;  ///< its spp is set by the lab
    Budget budget;
    /// A digest of all that scene and camera come from (files, not names): the key of references
    /// and journal. Empty: neither is used.
    std::string content;
};

/// Runs every technique along its sweep against the baseline's frame (those that show a whole lens
/// where there is one: against its converged picture), and the baseline and all others that go by
/// samples a pixel against converged pictures of their own. What cannot be run (a
/// plan that does not apply, an exception) becomes a row that says why; only a baseline that cannot
/// be run throws Error.
SceneReport run_lab(const LabScene& scene, const TechniqueInfo& baseline,
                    std::span<const TechniqueInfo* const> techniques,
                    const LabOptions& options = {});

}  // namespace luch
