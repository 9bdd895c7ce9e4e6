#pragma once

#include "framework/measure/measurement.h"
#include "framework/measure/report.h"
#include "framework/measure/store.h"

namespace luch {

/// What noisy pictures are measured against: the mean of two renderings with seeds of their own,
/// whose difference tells how far the mean itself is off.
struct Reference {
    Image<Rgb> linear;
    int samples = 0;  ///< a pixel, of both halves together
    /// Standard error of the mean, as the root over all channels of the pixels that are finite, in
    /// linear light and as displayed: half of the RMSE between the halves.
    double linear_error = 0, displayed_error = 0;
    bool from_cache = false;
};

/// Keeps rendered pictures from run to run. The key is made of the content that the scene and the
/// camera come from, the settings, and the picture that the program now makes with two samples a
/// pixel: a change of the program that changes its pictures makes the references anew.
class ReferenceCache {
 public:
    /// Without a store, or without content, every picture is made anew.
    ReferenceCache(std::optional<Store> store, std::string content)
        : store_(std::move(store)), content_(std::move(content)) {}

    /// The mean of two halves of `samples / 2` each (samples ≥ 2), with the seeds seed + 1 and
    /// seed + 2. Throws as picture_of().
    [[nodiscard]] Reference reference(const Subject& subject, const Workbench& bench,
                                      int samples) const;

 private:
    [[nodiscard]] std::string key_of(const Subject& subject, const Workbench& bench,
                                     std::uint64_t seed) const;
    [[nodiscard]] Image<Rgb> picture(const Subject& subject, const Workbench& bench,
                                     std::uint64_t seed, bool& from_cache) const;

    std::optional<Store> store_;
    std::string content_;
};

/// √ mean (b − a)² over every channel of the pixels that are finite in both: what errors_between()
/// calls RMSE, without the other metrics, which take long. 0 when there are none.
double rmse_between(const Image<Rgb>& a, const Image<Rgb>& b);

/// The mean picture of two, and its standard error. Throws Error when they differ in size.
Reference reference_of_halves(const Image<Rgb>& a, const Image<Rgb>& b);

/// The RMSE of the mean of 1, 2, 4… independent frames of two samples a pixel each, up to `most`:
/// whatever the technique does within a frame, frames of different seeds must come closer to the
/// truth with the power −½ of their number. None of the seeds is the reference's.
LabPasses independent_passes(const Subject& subject, const Workbench& bench,
                             const Image<Rgb>& truth, int most);

/// As bytes for a file, and back; nothing when the bytes are no passes.
std::string bytes_of(const LabPasses& passes);
std::optional<LabPasses> passes_of(std::string_view bytes);

}  // namespace luch
