#pragma once

#include "framework/measure/measurement.h"
#include "framework/measure/report.h"

namespace luch {

/// A truth with its pixels.
struct TruthPicture {
    LabTruth facts;
    Image<Rgb> linear, shown;  ///< in linear light; as displayed
};

TruthPicture truth_picture(LabTruth facts, const Image<Rgb>& linear);

/// A measurement as a row of the report: times, counts, and errors against its truth and, unless
/// that is null, against the baseline's converged picture. Writes no pictures.
LabPoint point_of(const Measurement& measurement, const TruthPicture& truth,
                  const TruthPicture* converged);

/// RMSE in linear light, what is brighter than white being white: for techniques whose colours end
/// there (TechniqueInfo::resolution), or that part of the error would hide the rest.
double rmse_within_white(const TruthPicture& truth, const Image<Rgb>& linear);

/// Writes PNG files for the pages of one scene.
class Pictures {
 public:
    /// Files are called after the scene. An empty folder: nothing is written.
    Pictures(std::filesystem::path folder, std::string scene)
        : folder_(std::move(folder)), scene_(std::move(scene)) {}

    /// The point's picture and, unless it is bit for bit the truth's, where it differs.
    void add_to(LabPoint& point, const std::string& name, const Image<Rgb>& linear,
                const TruthPicture& truth) const;
    /// The truth's own.
    void add_to(LabTruth& truth, const std::string& name, const TruthPicture& picture) const;

 private:
    [[nodiscard]] std::filesystem::path written(const std::string& name,
                                                ImageView<const Rgb> shown) const;

    std::filesystem::path folder_;
    std::string scene_;
};

}  // namespace luch
