#include "framework/window/status.h"

#include "framework/base/text.h"

#include <fmt/format.h>

namespace luch {
namespace {

double megarays(const Outcome& outcome) {
    return static_cast<double>(outcome.counts.all_rays()) / 1e6;
}

std::string left_out(const Plan& plan) {
    std::string text;
    for (const Stage& stage : plan.stages) {
        if (stage.needed) continue;
        text += fmt::format("{}{} ({})", text.empty() ? "left out: " : ", ", stage.name,
                            to_string(stage.kind));
    }
    return text;
}

}  // namespace

std::vector<std::string> help_lines() {
    return {
        "W A S D, arrows\tfly; with Shift faster",
        "E Q, PgUp PgDn\tup, down",
        "drag the mouse\tlook around",
        "wheel, + -\tfly faster, slower from now on",
        "R, Home\tback to the scene's camera",
        "Tab, Shift+Tab\tnext, previous technique",
        "C, Space\tcompare: the mouse moves the wiper",
        "P\tnext plane of the frame, then the colour again",
        "M\tmarks on and off",
        "F5\ttime the frame against the other technique",
        "F12\tsave a picture of the window",
        "I\tthe text along the bottom on and off",
        "H, F1\tthis help",
        "Esc\tquit",
    };
}

std::string camera_text(const Camera& camera) {
    const std::string place =
        fmt::format("{},{},{},{},{},{}", camera.position.x, camera.position.y, camera.position.z,
                    camera.yaw_deg, camera.pitch_deg, camera.roll_deg);
    const bool has_fov =
        camera.projection == Projection::perspective || camera.projection == Projection::fisheye;
    return has_fov ? fmt::format("{},{}", place, camera.fov_deg) : place;
}

std::string camera_line(const Camera& camera, double speed) {
    return fmt::format(
        "camera {:.5g} {:.5g} {:.5g}  yaw {:.5g}  pitch {:.5g}  fov {:.4g}  flying {:.3g}/s",
        camera.position.x, camera.position.y, camera.position.z, camera.yaw_deg, camera.pitch_deg,
        camera.fov_deg, speed);
}

std::vector<std::string> status_lines(const RenderResult& result, const std::string& fallback) {
    const std::string& name = result.request.techniques.front().name;
    const Rendered& rendered = result.rendered.front();
    const int divisor = result.request.divisor;
    const Outcome& outcome = rendered.outcome;
    const bool declined = !rendered.declined.empty();
    std::string first = fmt::format(
        "{}  {:.1f} ms  {:.3g} Mrays  {}x{}", declined ? fallback : name, median(outcome.frame_ms),
        megarays(outcome), outcome.frame.size().width, outcome.frame.size().height);
    if (outcome.prepare_ms >= 0.05)
        first += fmt::format("  prepared in {:.1f} ms", outcome.prepare_ms);
    if (divisor > 1) first += fmt::format("  (1/{})", divisor);
    std::vector<std::string> lines{first};
    if (declined) {
        lines.push_back(
            fmt::format("{} does not apply: {}; {} is shown", name, rendered.declined, fallback));
    }
    if (const std::string text = left_out(outcome.plan); !text.empty()) lines.push_back(text);
    if (!outcome.unwritten.empty()) {
        lines.push_back("not written yet, the reference is used: " +
                        listed(outcome.unwritten, "and"));
    }
    if (outcome.non_finite.count > 0) {
        lines.push_back(fmt::format("{} pixels are not finite, the first at ({}, {}): magenta",
                                    outcome.non_finite.count, outcome.non_finite.first_x,
                                    outcome.non_finite.first_y));
    }
    return lines;
}

std::vector<std::string> timing_lines(const RenderResult& result) {
    const std::vector<NamedTechnique>& by = result.request.techniques;
    const std::vector<Rendered>& rendered = result.rendered;
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < rendered.size(); ++i) {
        const Outcome& outcome = rendered[i].outcome;
        std::string line = fmt::format("timed: {}  {:.2f} ms (median of {})  {} rays", by[i].name,
                                       median(outcome.frame_ms), outcome.frame_ms.size(),
                                       outcome.counts.all_rays());
        if (!rendered[i].declined.empty()) {
            line = fmt::format("timed: {} does not apply: {}", by[i].name, rendered[i].declined);
        }
        lines.push_back(std::move(line));
    }
    if (rendered.size() < 2 || !rendered.front().declined.empty()) return lines;
    const double time = median(rendered.front().outcome.frame_ms);
    const double other = median(rendered.back().outcome.frame_ms);
    if (time > 0 && other > 0) {
        lines.push_back(fmt::format("timed: {} takes {:.2f} of the time of {} ({:.2f}x)",
                                    by.front().name, time / other, by.back().name, other / time));
    }
    return lines;
}

std::string plane_line(const Plane2d& plane) {
    std::string line = "plane " + plane.name;
    if (plane.kind == PlaneKind::scalar) {
        line += fmt::format(" [{:.4g}, {:.4g}]", plane.least, plane.most);
    }
    return plane.unit.empty() ? line : line + " " + plane.unit;
}

}  // namespace luch
