#include "framework/measure/lab_point.h"

#include "framework/measure/difference.h"
#include "framework/measure/flip.h"
#include "framework/measure/magma.h"
#include "framework/measure/reference.h"

#include <algorithm>

namespace luch {
namespace {

/// A file name without folders or blanks: "homework/vista lod=4" → "homework-vista-lod=4".
std::string file_name(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '/' || c == ' ' || c == '\\'; }, '-');
    return text;
}

}  // namespace

TruthPicture truth_picture(LabTruth facts, const Image<Rgb>& linear) {
    return {std::move(facts), linear, displayed(linear.view())};
}

LabPoint point_of(const Measurement& measurement, const TruthPicture& truth,
                  const TruthPicture* converged) {
    const Outcome& outcome = measurement.outcome;
    LabPoint point;
    point.plan = outcome.plan;
    point.not_run = measurement.not_run;
    if (!measurement.ran()) return point;
    point.prepare_ms = outcome.prepare_ms;
    point.frame_ms = median(outcome.frame_ms);
    point.cpu_ms = median(outcome.cpu_ms);
    point.beside_ms = median(measurement.beside_ms);
    point.frames = static_cast<int>(outcome.frame_ms.size());
    point.counts = outcome.counts;
    point.bytes = outcome.bytes;
    point.unwritten = outcome.unwritten;
    const Image<Rgb>& linear = outcome.frame.colour;
    const Image<Rgb> shown = displayed(linear.view());
    point.errors = errors_between(truth.shown.view(), shown.view());
    point.linear_rmse = rmse_between(truth.linear, linear);
    point.identical = linear == truth.linear;
    if (converged != nullptr) {
        point.converged = errors_between(converged->shown.view(), shown.view());
    }
    return point;
}

double rmse_within_white(const TruthPicture& truth, const Image<Rgb>& linear) {
    const auto within = [](Image<Rgb> image) {
        for (Rgb& pixel : image.pixels()) pixel = glm::min(pixel, Rgb(1));
        return image;
    };
    return rmse_between(within(truth.linear), within(linear));
}

std::filesystem::path Pictures::written(const std::string& name, ImageView<const Rgb> shown) const {
    if (folder_.empty()) return {};
    auto file = folder_ / (file_name(scene_ + " " + name) + ".png");
    write_displayed(file, shown);
    return file;
}

void Pictures::add_to(LabPoint& point, const std::string& name, const Image<Rgb>& linear,
                      const TruthPicture& truth) const {
    if (folder_.empty() || !point.ran()) return;
    const Image<Rgb> shown = displayed(linear.view());
    point.picture = written(name, shown.view());
    if (!point.identical) {
        point.difference =
            written(name + " difference", error_map(truth.shown.view(), shown.view()).view());
        const FlipResult flip = flip_ldr(truth.shown.view(), shown.view());
        point.flip_map = written(name + " flip", in_magma(flip.map.view()).view());
    }
}

void Pictures::add_to(LabTruth& truth, const std::string& name, const TruthPicture& picture) const {
    truth.picture = written(name, picture.shown.view());
}

}  // namespace luch
