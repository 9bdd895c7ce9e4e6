#include "framework/window/renderer.h"

#include "framework/window/develop.h"

namespace luch {
namespace {

Rendered rendered_by(Technique& technique, const Studio& studio, const RenderRequest& request,
                     const CancelToken& cancelled) {
    const auto once = [&](Technique& which) {
        return run(which, studio, request.shot, request.budget, request.repeat, &cancelled);
    };
    Rendered rendered{once(technique), "", {}};
    if (!rendered.outcome.plan.applies) {
        rendered.declined = rendered.outcome.plan.why;
        if (rendered.declined.empty()) rendered.declined = "its plan gives no reason";
        if (request.fallback != nullptr) rendered.outcome = once(*request.fallback);
    }
    if (!cancelled.cancelled()) {
        rendered.picture = developed(rendered.outcome.frame, studio.workers);
    }
    return rendered;
}

RenderResult result_of(const RenderRequest& request, const Studio& studio,
                       const CancelToken& cancelled) {
    RenderResult result{request, {}};
    for (const NamedTechnique& wanted : request.techniques) {
        if (cancelled.cancelled()) break;
        result.rendered.push_back(rendered_by(*wanted.technique, studio, request, cancelled));
    }
    return result;
}

}  // namespace

Renderer::Renderer(const Studio& studio) : studio_(studio), thread_([this] { loop(); }) {}

Renderer::~Renderer() {
    {
        const std::lock_guard lock(mutex_);
        give_up();
        ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void Renderer::start(RenderRequest request) {
    {
        const std::lock_guard lock(mutex_);
        give_up();
        waiting_ = Job{std::move(request), std::make_shared<CancelToken>()};
    }
    changed_.notify_all();
}

void Renderer::cancel() {
    const std::lock_guard lock(mutex_);
    give_up();
}

bool Renderer::busy() const {
    const std::lock_guard lock(mutex_);
    return waiting_.has_value() || running_ != nullptr;
}

std::optional<RenderResult> Renderer::take() {
    const std::lock_guard lock(mutex_);
    if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
    return std::exchange(result_, std::nullopt);
}

bool Renderer::wait(std::chrono::milliseconds limit) const {
    std::unique_lock lock(mutex_);
    return changed_.wait_for(lock, limit, [this] { return !waiting_ && running_ == nullptr; });
}

void Renderer::give_up() {
    waiting_.reset();
    result_.reset();
    failure_ = nullptr;
    if (running_) running_->cancel();
}

void Renderer::loop() {
    for (;;) {
        Job job;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, [this] { return waiting_.has_value() || ending_; });
            if (ending_) return;
            job = std::move(*waiting_);
            waiting_.reset();
            running_ = job.cancelled;
        }
        std::optional<RenderResult> result;
        std::exception_ptr failure;
        try {
            result = result_of(job.request, studio_, *job.cancelled);
        } catch (...) {
            failure = std::current_exception();
        }
        finish(job, std::move(result), std::move(failure));
    }
}

void Renderer::finish(const Job& job, std::optional<RenderResult> result,
                      std::exception_ptr failure) {
    {
        const std::lock_guard lock(mutex_);
        running_.reset();
        // Nobody waits for what was given up, be it a picture or a failure.
        if (!job.cancelled->cancelled()) {
            result_ = std::move(result);
            failure_ = std::move(failure);
        }
    }
    changed_.notify_all();
}

}  // namespace luch
