#include "framework/window/viewer.h"

#include "framework/window/develop.h"
#include "framework/window/screenshot.h"
#include "framework/window/status.h"

#include <ostream>

namespace luch {
namespace {

/// After a pause (a minimised window, a suspended machine) the camera must not leap.
constexpr double longest_step_s = 0.25;
constexpr double wheel_factor = 1.25;
constexpr int busy_wait_ms = 4, idle_wait_ms = 50;

std::chrono::nanoseconds steady_now() {
    return std::chrono::steady_clock::now().time_since_epoch();
}

Size divided(Size size, int divisor) {
    return {std::max(1, size.width / divisor), std::max(1, size.height / divisor)};
}

}  // namespace

Viewer::Viewer(const Studio& studio, ViewerSetup setup, Window& window, std::ostream& out)
    : setup_(std::move(setup)),
      home_(setup_.shot.camera),
      window_(&window),
      out_(&out),
      speed_(flying_speed(studio.scene)),
      size_(window.size()),
      refinement_(setup_.frames == 0),
      renderer_(studio) {
    if (!setup_.clock) setup_.clock = steady_now;
    now_ = setup_.clock();
}

void Viewer::run() {
    while (!done_) turn(renderer_.busy() || moving_ ? busy_wait_ms : idle_wait_ms);
    renderer_.cancel();
    if (!setup_.screenshot.empty()) write_screenshot(setup_.screenshot, picture_);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Viewer::turn(int wait_ms) {
    const Input input = window_->poll(wait_ms);
    const double dt_s = elapsed_s();
    if (const Size size = window_->size(); size != size_ || input.exposed) {
        if (size != size_) restart();
        size_ = size;
        dirty_ = true;
    }
    for (const Command command : input.commands) obey(command);
    if (done_) return;
    fly(input, dt_s);
    collect();
    if (size_.area() == 0) return;
    render();
    draw();
}

double Viewer::elapsed_s() {
    const std::chrono::nanoseconds now = setup_.clock();
    const std::chrono::duration<double> passed = now - std::exchange(now_, now);
    return std::clamp(passed.count(), 0.0, longest_step_s);
}

void Viewer::obey(Command command) {
    dirty_ = true;
    switch (command) {
        case Command::quit:
            done_ = true;
            break;
        case Command::next_technique:
            cycle(1);
            break;
        case Command::previous_technique:
            cycle(setup_.techniques.size() - 1);
            break;
        case Command::compare:
            setup_.compare = !setup_.compare;
            restart();
            if (setup_.compare && setup_.shown == setup_.against) {
                notes_ = {other().name + " is compared with itself: Tab shows another technique"};
            }
            break;
        case Command::next_plane:
            next_plane();
            break;
        case Command::marks:
            marks_ = !marks_;
            develop_pictures();
            break;
        case Command::faster:
            speed_ *= wheel_factor;
            break;
        case Command::slower:
            speed_ /= wheel_factor;
            break;
        case Command::home:
            setup_.shot.camera = home_;
            refinement_.changed();
            break;
        case Command::info:
            info_ = !info_;
            break;
        case Command::help:
            help_ = !help_;
            break;
        case Command::screenshot:
            take_screenshot();
            break;
        case Command::time:
            start_timing();
            break;
    }
}

void Viewer::cycle(std::size_t by) {
    setup_.shown = (setup_.shown + by) % setup_.techniques.size();
    restart();
}

void Viewer::restart() {
    notes_.clear();
    trouble_.clear();
    refinement_.restart();
}

void Viewer::next_plane() {
    if (!result_) return;
    const auto& planes = result_->rendered.front().outcome.frame.planes();
    auto next = planes.begin();
    for (auto plane = planes.begin(); plane != planes.end(); ++plane) {
        if (plane->name == plane_) next = std::next(plane);
    }
    plane_ = next == planes.end() ? "" : next->name;
    if (planes.empty()) say("this frame has no planes beside its colour");
    develop_pictures();
}

void Viewer::say(std::string text) {
    notes_ = {std::move(text)};
    *out_ << notes_.front() << std::endl;
}

void Viewer::take_screenshot() {
    try {
        const auto file = free_screenshot_name(setup_.folder);
        write_screenshot(file, picture_);
        std::string text = "saved " + file.string();
        if (result_) {
            text += "; the same view: -t " + result_->request.techniques.front().name +
                    " --camera " + camera_text(result_->request.shot.camera);
        }
        say(std::move(text));
    } catch (const std::exception& problem) {
        trouble_ = problem.what();
        *out_ << trouble_ << std::endl;
    }
}

void Viewer::start_timing() {
    notes_ = {"timing " + entry().name + " and " + other().name + "..."};
    RenderRequest request;
    request.repeat = {1, 7};
    request.timing = true;
    start(std::move(request));
}

void Viewer::fly(const Input& input, double dt_s) {
    const double distance = speed_ * dt_s * (input.keys.fast ? fast_factor : 1);
    const Tile area = frame_area(size_, setup_.shot.size);
    const Camera before = camera();
    Camera after = turned(before, input.drag_px, degrees_per_px(before, area.width()));
    after = flown(after, input.keys, distance);
    moving_ = after.position != before.position || after.yaw_deg != before.yaw_deg ||
              after.pitch_deg != before.pitch_deg;
    if (moving_) {
        setup_.shot.camera = after;
        notes_.clear();
        trouble_.clear();
        refinement_.changed();
        dirty_ = true;
    }
    if (setup_.compare && input.mouse_x && area.width() > 0) {
        split_ = std::clamp((*input.mouse_x - area.x0) / area.width(), 0.0, 1.0);
        dirty_ = true;
    }
}

void Viewer::collect() {
    try {
        if (auto result = renderer_.take()) accept(std::move(*result));
    } catch (...) {
        report(std::current_exception());
    }
}

void Viewer::accept(RenderResult result) {
    if (result.request.timing) accept_timing(result);
    double prepare_ms = 0, render_ms = 0;
    for (const Rendered& rendered : result.rendered) {
        prepare_ms += rendered.outcome.prepare_ms;
        render_ms += median(rendered.outcome.frame_ms);
    }
    refinement_.finished(prepare_ms, render_ms);
    result_ = std::move(result);
    dirty_ = true;
    trouble_.clear();
    develop_pictures();
    if (setup_.frames > 0 && ++frames_ >= setup_.frames) {
        draw();
        done_ = true;
    } else if (setup_.frames > 0) {
        refinement_.changed();
    }
}

void Viewer::accept_timing(const RenderResult& result) {
    notes_ = timing_lines(result);
    for (const std::string& line : notes_) *out_ << line << '\n';
    *out_ << std::flush;
}

void Viewer::report(std::exception_ptr failure) {
    refinement_.failed();
    dirty_ = true;
    notes_.clear();
    if (!failure_) failure_ = failure;
    if (setup_.frames > 0) done_ = true;
    try {
        std::rethrow_exception(failure);
    } catch (const std::exception& problem) {
        trouble_ = entry().name + " failed: " + problem.what();
    } catch (...) {
        trouble_ = entry().name + " failed, and did not say why";
    }
    *out_ << trouble_ << std::endl;
}

void Viewer::render() {
    const std::chrono::duration<double, std::milli> running = now_ - started_;
    if (const auto divisor = refinement_.next(moving_, running.count())) {
        RenderRequest request;
        request.divisor = *divisor;
        start(std::move(request));
    }
}

void Viewer::start(RenderRequest request) {
    const Tile area = frame_area(size_, setup_.shot.size);
    if (area.area() == 0) return;
    started_ = now_;
    request.techniques = {{entry().name, entry().technique.get()}};
    if ((request.timing || setup_.compare) && setup_.against != setup_.shown) {
        request.techniques.push_back({other().name, other().technique.get()});
    }
    request.fallback = other().technique.get();
    request.budget = setup_.budget;
    request.shot = setup_.shot;
    request.shot.size = divided({area.width(), area.height()}, request.divisor);
    refinement_.started(request.divisor);
    renderer_.start(std::move(request));
}

void Viewer::develop_pictures() {
    shown_.clear();
    if (!result_) return;
    for (const Rendered& rendered : result_->rendered) {
        Image<Pixel> picture = rendered.picture;
        for (const Plane2d& plane : rendered.outcome.frame.planes()) {
            if (plane.name == plane_) picture = developed(plane);
        }
        if (marks_) draw_marks(picture.view(), rendered.outcome.frame.marks);
        shown_.push_back(std::move(picture));
    }
}

std::vector<std::string> Viewer::status() const {
    std::vector<std::string> lines;
    if (result_) lines = status_lines(*result_, other().name);
    const bool awaited = !result_ || result_->request.techniques.front().name != entry().name;
    if (awaited && trouble_.empty()) lines.push_back("rendering " + entry().name + "...");
    if (result_ && !plane_.empty()) {
        std::string line = "this frame has no plane " + plane_;
        for (const Plane2d& plane : result_->rendered.front().outcome.frame.planes()) {
            if (plane.name == plane_) line = plane_line(plane);
        }
        lines.push_back(line);
    }
    lines.push_back(camera_line(camera(), speed_));
    lines.insert(lines.end(), notes_.begin(), notes_.end());
    return lines;
}

void Viewer::draw() {
    if (!std::exchange(dirty_, false)) return;
    Composition composition;
    composition.window = size_;
    composition.frame = setup_.shot.size;
    if (!shown_.empty()) composition.left = &shown_.front();
    if (setup_.compare && shown_.size() > 1) {
        composition.right = &shown_.back();
        composition.split = split_;
        composition.left_label = result_->request.techniques.front().name;
        composition.right_label = result_->request.techniques.back().name;
    }
    if (info_) composition.status = status();
    composition.trouble = trouble_;
    if (help_) composition.help = help_lines();
    picture_ = composed(composition);
    window_->show(picture_.view());
}

}  // namespace luch
