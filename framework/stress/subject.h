#pragma once

#include "framework/stress/made/scenes.h"
#include "framework/technique/catalogue.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

// A technique before the judge: its pictures, and what each of them owes.
namespace luch::stress {

struct Subject {
    const TechniqueInfo* info;
    const TechniqueInfo* baseline;
    bool full = false;  ///< at the table's stated size

    /// Pixel centres where the picture is meant to be the baseline's, else a few random ones.
    [[nodiscard]] int spp() const { return info->approximates ? 1 : 4; }
};

/// One picture by a technique of its own, on two threads; spp −1: the subject's.
Outcome picture(const Subject& subject, Scene scene, int spp = -1);

/// A picture that passed what every picture owes.
struct Sight {
    const Subject& subject;
    const Scene& scene;
    const Accelerator& accelerator;
    Shot shot;
    const Outcome& outcome;

    [[nodiscard]] ImageView<const Rgb> colour() const { return outcome.frame.colour.view(); }
};

/// What a case wants of a picture beyond that.
using Check = std::function<StressResult(const Sight&)>;

StressResult judged(bool right, std::string got);

/// The verdict on a picture that passed, if the steps that made it are written.
StressResult finished(const Outcome& outcome, StressResult result);

/// What a case shows to the technique.
struct Look {
    Look(Scene shown) : scene(std::move(shown)) {}

    Scene scene;
    int spp = -1;               ///< −1: the subject's; 0: as the scene says
    bool may_overflow = false;  ///< pixels may be NaN or infinite, as long as they are counted
};

/// What every picture owes: it has the right size, is finite, comes out the same from another
/// instance on one thread, and the same with all stages on that were left out as exact; pixels that
/// are not finite are counted. Then the check.
StressResult looked_at(const Subject& subject, Look look, const Check& check);

/// A list of cases in the making.
struct CaseList {
    Subject subject;
    std::vector<StressCase> cases;

    void add(int row, std::string name, std::string expected, std::function<StressResult()> run) {
        cases.push_back({row, std::move(name), std::move(expected), std::move(run)});
    }
    /// A case of looked_at(); without a check only what every picture owes.
    void look(int row, std::string name, std::string expected, std::function<Look()> look,
              Check check = {});
};

// Checks.

/// Every pixel has this colour, to 1e-5 of it.
Check all_of(const Rgb& colour);

/// The picture is the one of another scene, but for a share of the pixels (rims, where a rounding
/// decides) that are off by more than 1e-4 of their value or of the picture's mean.
Check as_of(std::function<Scene()> other, double share);

/// For pictures that are meant to be the baseline's; passes for the others.
Check if_approximates(Check check);

/// Pixels off by more than `tolerance` of the larger value or, where that is more, of the first
/// picture's mean; all of them when the sizes differ. `resolution`: of the technique, see
/// TechniqueInfo.
std::size_t unlike(ImageView<const Rgb> a, ImageView<const Rgb> b, double tolerance,
                   double resolution = 0);

// The rows.
void add_closed_things(CaseList& list);      // 1, 6, 7, 9
void add_small_and_far(CaseList& list);      // 8
void add_transforms(CaseList& list);         // 11
void add_frames_and_lights(CaseList& list);  // 12
void add_cameras(CaseList& list);            // 13
void add_ids(CaseList& list);                // 15
void add_materials(CaseList& list);          // 17
void add_numbers(CaseList& list);            // 18
void add_loop(CaseList& list);               // 20
void add_threads(CaseList& list);            // 21

}  // namespace luch::stress
