#include "framework/base/error.h"
#include "framework/base/json.h"
#include "framework/base/json_reader.h"
#include "framework/base/text.h"
#include "framework/measure/measurement.h"
#include "framework/measure/reference.h"

#include <fmt/format.h>

#include <cstring>
#include <limits>

namespace luch {
namespace {

Json numbers_json(const std::vector<double>& values) {
    Json array = Json::array();
    for (const double value : values) array.push(value);
    return array;
}

Json plan_json(const Plan& plan) {
    Json stages = Json::array();
    for (const Stage& stage : plan.stages) {
        stages.push(Json::object()
                        .set("name", stage.name)
                        .set("needed", stage.needed)
                        .set("kind", static_cast<int>(stage.kind))
                        .set("why", stage.why)
                        .set("bound", static_cast<double>(stage.bound)));
    }
    return Json::object()
        .set("applies", plan.applies)
        .set("why", plan.why)
        .set("stages", std::move(stages));
}

Json counts_json(const Counts& counts) {
    Json array = Json::array();
    for (const std::uint64_t rays : counts.rays) array.push(rays);
    for (const std::uint64_t count :
         {counts.object_tests, counts.shades, counts.fallbacks, counts.cells}) {
        array.push(count);
    }
    return array;
}

Json texts_json(const std::vector<std::string>& texts) {
    Json array = Json::array();
    for (const std::string& text : texts) array.push(text);
    return array;
}

// Reading back. A member that is not there, or of another kind, reads as empty: files are checked
// by their checksum before, so that this happens to those of another version only.

double number(const JsonValue& object, std::string_view key) {
    const auto value = object.member(key);
    return value ? value->number().value_or(std::numeric_limits<double>::infinity()) : 0;
}

bool boolean(const JsonValue& object, std::string_view key) {
    const auto value = object.member(key);
    return value && value->boolean().value_or(false);
}

std::string text(const JsonValue& object, std::string_view key) {
    const auto value = object.member(key);
    return value ? std::string(value->text().value_or("")) : "";
}

template <class Take>
void for_each(const JsonValue& object, std::string_view key, const Take& take) {
    const auto array = object.member(key);
    for (std::size_t i = 0; array && i < array->size(); ++i) take(array->at(i));
}

std::vector<double> numbers(const JsonValue& object, std::string_view key) {
    std::vector<double> all;
    for_each(object, key, [&](const JsonValue& value) {
        all.push_back(value.number().value_or(std::numeric_limits<double>::quiet_NaN()));
    });
    return all;
}

Plan plan_of(const JsonValue& object) {
    Plan plan{boolean(object, "applies"), text(object, "why"), {}};
    for_each(object, "stages", [&](const JsonValue& stage) {
        Stage read;
        read.name = text(stage, "name");
        read.needed = boolean(stage, "needed");
        read.kind = static_cast<Stage::Kind>(static_cast<int>(number(stage, "kind")));
        read.why = text(stage, "why");
        read.bound = static_cast<float>(number(stage, "bound"));
        plan.stages.push_back(std::move(read));
    });
    return plan;
}

Counts counts_of(const std::vector<double>& values) {
    Counts counts;
    std::vector<std::uint64_t*> places;
    for (std::uint64_t& rays : counts.rays) places.push_back(&rays);
    places.insert(places.end(),
                  {&counts.object_tests, &counts.shades, &counts.fallbacks, &counts.cells});
    for (std::size_t i = 0; i < std::min(places.size(), values.size()); ++i) {
        *places[i] = static_cast<std::uint64_t>(values[i]);
    }
    return counts;
}

Measurement measurement_of(const JsonValue& json) {
    Measurement read;
    Outcome& outcome = read.outcome;
    read.not_run = text(json, "not_run");
    read.beside_ms = numbers(json, "beside_ms");
    if (const auto plan = json.member("plan")) outcome.plan = plan_of(*plan);
    outcome.prepare_ms = number(json, "prepare_ms");
    outcome.frame_ms = numbers(json, "frame_ms");
    outcome.cpu_ms = numbers(json, "cpu_ms");
    outcome.threads = static_cast<int>(number(json, "threads"));
    outcome.counts = counts_of(numbers(json, "counts"));
    outcome.bytes = static_cast<std::uint64_t>(number(json, "bytes"));
    for_each(json, "unwritten", [&](const JsonValue& task) {
        outcome.unwritten.emplace_back(task.text().value_or(""));
    });
    return read;
}

/// The text before the first newline, which is taken away with it.
std::string_view line_of(std::string_view& bytes) {
    const std::size_t end = bytes.find('\n');
    const std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
    return line;
}

}  // namespace

std::string bytes_of(const Image<Rgb>& image) {
    std::string bytes = fmt::format("{} {}\n", image.width(), image.height());
    const std::size_t at = bytes.size(), length = image.pixels().size() * sizeof(Rgb);
    bytes.resize(at + length);
    std::memcpy(bytes.data() + at, image.pixels().data(), length);
    return bytes;
}

std::optional<Image<Rgb>> image_of(std::string_view bytes) {
    const std::vector<std::string> sides = split(line_of(bytes), ' ');
    if (sides.size() != 2) return std::nullopt;
    const auto width = parsed_number(sides[0]), height = parsed_number(sides[1]);
    constexpr double longest = 1 << 16;
    if (!width || !height || *width < 0 || *height < 0 || *width > longest || *height > longest) {
        return std::nullopt;
    }
    const Size size{static_cast<int>(*width), static_cast<int>(*height)};
    if (bytes.size() != size.area() * sizeof(Rgb)) return std::nullopt;
    Image<Rgb> image(size);
    std::memcpy(image.pixels().data(), bytes.data(), bytes.size());
    return image;
}

std::string bytes_of(const Measurement& measurement) {
    const Outcome& outcome = measurement.outcome;
    const std::string json = Json::object()
                                 .set("not_run", measurement.not_run)
                                 .set("beside_ms", numbers_json(measurement.beside_ms))
                                 .set("plan", plan_json(outcome.plan))
                                 .set("prepare_ms", outcome.prepare_ms)
                                 .set("frame_ms", numbers_json(outcome.frame_ms))
                                 .set("cpu_ms", numbers_json(outcome.cpu_ms))
                                 .set("threads", outcome.threads)
                                 .set("counts", counts_json(outcome.counts))
                                 .set("bytes", outcome.bytes)
                                 .set("unwritten", texts_json(outcome.unwritten))
                                 .text();
    return fmt::format("{}\n", json.size()) + json + bytes_of(outcome.frame.colour);
}

std::optional<Measurement> measurement_of(std::string_view bytes) {
    const auto length = parsed_number(line_of(bytes));
    if (!length || *length < 0 || *length > static_cast<double>(bytes.size())) return std::nullopt;
    const std::string_view json = bytes.substr(0, static_cast<std::size_t>(*length));
    std::optional<Image<Rgb>> colour = image_of(bytes.substr(json.size()));
    if (!colour) return std::nullopt;
    try {
        const JsonDocument document(json, "measurement");
        Measurement read = measurement_of(document.root());
        read.outcome.frame = Frame(colour->size());
        read.outcome.frame.colour = std::move(*colour);
        read.outcome.non_finite = non_finite_pixels(read.outcome.frame.colour.view());
        return read;
    } catch (const Error&) {
        return std::nullopt;
    }
}

std::string bytes_of(const LabPasses& passes) {
    return Json::object()
        .set("count", numbers_json(passes.count))
        .set("linear_rmse", numbers_json(passes.linear_rmse))
        .text();
}

std::optional<LabPasses> passes_of(std::string_view bytes) {
    try {
        const JsonDocument document(bytes, "passes");
        LabPasses passes{numbers(document.root(), "count"),
                         numbers(document.root(), "linear_rmse")};
        if (passes.count.size() == passes.linear_rmse.size()) return passes;
    } catch (const Error&) {
        // Of another version: measured again.
    }
    return std::nullopt;
}

}  // namespace luch
