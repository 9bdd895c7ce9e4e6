#include "framework/stress/subject.h"

#include <fmt/format.h>

#include <algorithm>

namespace luch::stress {
namespace {

Shot shot_for(const Subject& subject, const Scene& scene, int spp) {
    Shot shot = shot_of(scene);
    shot.spp = spp < 0 ? subject.spp() : spp;
    return shot;
}

/// Equal floats, and NaN wherever the other is NaN.
bool same_bits(const Image<Rgb>& a, const Image<Rgb>& b) {
    if (a.size() != b.size()) return false;
    const auto same = [](float x, float y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return std::equal(a.pixels().begin(), a.pixels().end(), b.pixels().begin(),
                      [&](const Rgb& p, const Rgb& q) {
                          return same(p.x, q.x) && same(p.y, q.y) && same(p.z, q.z);
                      });
}

/// Whether the plan promises the same bits with every stage on. With the samples given, the scene's
/// own anti-aliasing is off in any case.
bool promises_same_bits(const Plan& plan, int spp) {
    return std::all_of(plan.stages.begin(), plan.stages.end(), [&](const Stage& stage) {
        const bool moot = stage.name == "anti-aliasing" && spp > 0;
        return stage.needed || stage.kind == Stage::exact || moot;
    });
}

/// What a picture owes by itself; "" when it owes nothing.
std::string debt_of(const Outcome& outcome, Size size, bool may_overflow) {
    if (outcome.frame.size() != size) {
        const Size got = outcome.frame.size();
        return fmt::format("{} × {} pixels, not {} × {}", got.width, got.height, size.width,
                           size.height);
    }
    const auto& pixels = outcome.frame.colour.pixels();
    const auto wild = static_cast<std::uint64_t>(std::count_if(
        pixels.begin(), pixels.end(), [](const Rgb& pixel) { return !all_finite(pixel); }));
    if (wild != outcome.non_finite.count) {
        return fmt::format("{} pixels are not finite, {} are counted", wild,
                           outcome.non_finite.count);
    }
    if (wild == 0 || may_overflow) return "";
    return fmt::format("{} pixels are not finite, the first at ({}, {})", wild,
                       outcome.non_finite.first_x, outcome.non_finite.first_y);
}

/// What it owes beside other pictures of the same.
std::string debt_of(const Subject& subject, const Studio& studio, const Shot& shot,
                    const Outcome& outcome) {
    const auto again = [&](const Budget& budget) {
        return run(*subject.info->create(), studio, shot, budget, {.warm_up = 0, .frames = 1});
    };
    const Outcome alone = again({});
    if (!same_bits(alone.frame.colour, outcome.frame.colour)) {
        return "another picture on 1 thread than on 2";
    }
    if (alone.counts.rays != outcome.counts.rays) return "other rays on 1 thread than on 2";
    if (!promises_same_bits(outcome.plan, shot.spp)) return "";
    if (!same_bits(again({.skip = false}).frame.colour, outcome.frame.colour)) {
        return "another picture with the stages on that were left out as exact";
    }
    return "";
}

/// How far the picture is from the baseline's, for the record.
std::string beside_baseline(const Sight& sight, const Studio& studio) {
    const Subject& subject = sight.subject;
    if (!subject.info->approximates || subject.info->name == subject.baseline->name) return "";
    const Outcome truth =
        run(*subject.baseline->create(), studio, sight.shot, {}, {.warm_up = 0, .frames = 1});
    const std::size_t off =
        unlike(truth.frame.colour.view(), sight.colour(), 0, subject.info->resolution);
    if (off == 0) return ", as the baseline";
    return fmt::format(", {} of {} pixels unlike the baseline", off, sight.shot.size.area());
}

}  // namespace

StressResult judged(bool right, std::string got) {
    return {right ? StressVerdict::pass : StressVerdict::fail, std::move(got)};
}

StressResult finished(const Outcome& outcome, StressResult result) {
    if (result.verdict != StressVerdict::pass || outcome.unwritten.empty()) return result;
    return {StressVerdict::not_written, fmt::format("{}", fmt::join(outcome.unwritten, ", "))};
}

Outcome picture(const Subject& subject, Scene scene, int spp) {
    const OwnStudio studio(std::move(scene));
    return studio.render(*subject.info->create(), shot_for(subject, studio.scene(), spp));
}

StressResult looked_at(const Subject& subject, Look look, const Check& check) {
    const OwnStudio two(std::move(look.scene));
    const Workers one_worker(1);
    const Studio one{two.scene(), two.studio().accelerator, one_worker};
    const Shot shot = shot_for(subject, two.scene(), look.spp);
    const Outcome outcome = two.render(*subject.info->create(), shot);
    if (!outcome.plan.applies) {
        if (outcome.plan.why.empty()) return judged(false, "does not apply, and no word why");
        return {StressVerdict::does_not_apply, outcome.plan.why};
    }
    std::string debt = debt_of(outcome, shot.size, look.may_overflow);
    if (debt.empty()) debt = debt_of(subject, one, shot, outcome);
    if (!debt.empty()) return judged(false, debt);

    const Sight sight{subject, two.scene(), one.accelerator, shot, outcome};
    StressResult result =
        check ? check(sight) : judged(true, "finite, the same on 1 and 2 threads");
    if (result.verdict == StressVerdict::pass) result.got += beside_baseline(sight, one);
    return finished(outcome, std::move(result));
}

void CaseList::look(int row, std::string name, std::string expected, std::function<Look()> look,
                    Check check) {
    add(row, std::move(name), std::move(expected),
        [subject = subject, look = std::move(look), check = std::move(check)] {
            return looked_at(subject, look(), check);
        });
}

std::size_t unlike(ImageView<const Rgb> a, ImageView<const Rgb> b, double tolerance,
                   double resolution) {
    if (a.size() != b.size()) return std::max(a.size().area(), b.size().area());
    const std::size_t count = a.size().area();
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3d pixel(a.data()[i]);
        if (all_finite(pixel)) sum += max_norm(pixel);
    }
    const double mean = sum / static_cast<double>(std::max<std::size_t>(count, 1));
    std::size_t off = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto shown = [&](const Rgb& colour) {
            return resolution > 0 ? glm::min(Vec3d(colour), Vec3d(1)) : Vec3d(colour);
        };
        const Vec3d p = shown(a.data()[i]), q = shown(b.data()[i]);
        const double size = std::max({max_norm(p), max_norm(q), mean});
        off += max_norm(p - q) <= std::max(tolerance * size, resolution) ? 0 : 1;
    }
    return off;
}

Check all_of(const Rgb& colour) {
    return [colour](const Sight& sight) {
        const Image<Rgb> truth(sight.colour().size(), colour);
        const std::size_t off =
            unlike(truth.view(), sight.colour(), 1e-5, sight.subject.info->resolution);
        const std::size_t count = sight.shot.size.area();
        return judged(off == 0, off == 0 ? fmt::format("all {} pixels right", count)
                                         : fmt::format("{} of {} pixels wrong", off, count));
    };
}

Check as_of(std::function<Scene()> other, double share) {
    return [other = std::move(other), share](const Sight& sight) {
        const Outcome truth = picture(sight.subject, other(), sight.shot.spp);
        const std::size_t off =
            unlike(truth.frame.colour.view(), sight.colour(), 1e-4, sight.subject.info->resolution);
        const auto count = static_cast<double>(sight.shot.size.area());
        return judged(static_cast<double>(off) <= share * count,
                      fmt::format("{} of {} pixels differ", off, count));
    };
}

Check if_approximates(Check check) {
    return [check = std::move(check)](const Sight& sight) {
        if (sight.subject.info->approximates) return check(sight);
        return judged(true, "finite, the same on 1 and 2 threads");
    };
}

}  // namespace luch::stress
