#pragma once

#include "framework/technique/catalogue.h"
#include "framework/technique/run.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace luch {

/// A technique at one setting.
struct Subject {
    const TechniqueInfo* info = nullptr;
    std::string assignment = {};  ///< "lod=4"; "" as the technique is by itself
    int spp = 1;
    bool skip = true;  ///< false: every stage is run, needed or not
};

/// Where subjects are run.
struct Workbench {
    const Studio& studio;
    const Shot& shot;  ///< its spp is the subject's
    const Budget& budget;
};

/// What running a subject gave.
struct Measurement {
    std::string not_run;            ///< why there is nothing below; empty when it ran
    Outcome outcome;                ///< with the times of all frames
    std::vector<double> beside_ms;  ///< frames of another subject, made between this one's
    [[nodiscard]] bool ran() const { return not_run.empty(); }
    /// The median frame of the other subject; that of its own when there was no other.
    [[nodiscard]] double beside() const;
};

/// One frame without a clock: a reference, a pass. Throws what the technique throws, and Error when
/// its plan does not apply.
Image<Rgb> picture_of(const Subject& subject, const Workbench& bench, std::uint64_t seed);

/// Runs it in rounds and, in each round, the other one too, so that what slows the machine for a
/// minute slows both. A plan that does not apply and an exception are in not_run: one technique's
/// failure (a homework's, say) must not cost the hours of the others.
Measurement measured(const Subject& subject, const Subject* beside, const Workbench& bench,
                     Repeat repeat);

/// As bytes for a file, and back; planes, marks and work counts are left out. Nothing when the
/// bytes are no measurement.
std::string bytes_of(const Measurement& measurement);
std::optional<Measurement> measurement_of(std::string_view bytes);

/// A picture as bytes and back.
std::string bytes_of(const Image<Rgb>& image);
std::optional<Image<Rgb>> image_of(std::string_view bytes);

}  // namespace luch
