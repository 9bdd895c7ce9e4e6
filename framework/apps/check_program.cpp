#include "framework/apps/check_program.h"

#include "framework/apps/check_options.h"
#include "framework/apps/progress.h"
#include "framework/base/error.h"
#include "framework/grading/check.h"
#include "framework/image/io.h"
#include "framework/measure/difference.h"
#include "framework/measure/flip.h"
#include "framework/measure/magma.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdio>

namespace luch {
namespace {

using namespace grading;

constexpr double rounding = 1e-9;

/// A reference picture as it was, as it would be, and what an eye would see between the two, in
/// out/regenerate/balls.named/{old,new,flip}.png.
void show_change(const std::filesystem::path& file, const Image<Rgb>& old, const Image<Rgb>& made) {
    const auto displayed = [](Image<Rgb> image) {
        for (Rgb& pixel : image.pixels()) pixel = srgb_encoded(pixel);
        return image;
    };
    const FlipResult flip = flip_ldr(displayed(old).view(), displayed(made).view());
    const std::filesystem::path folder =
        std::filesystem::path("out/regenerate") /
        (file.parent_path().filename().string() + "." + file.stem().string());
    std::filesystem::create_directories(folder);
    write_picture(folder / "old.png", old.view());
    write_picture(folder / "new.png", made.view());
    write_displayed(folder / "flip.png", in_magma(flip.map.view()).view());
    fmt::print("  FLIP {:.3g}: {}/{{old,new,flip}}.png\n", flip.mean, folder.string());
}

class CheckProgram final : public Verb {
 public:
    explicit CheckProgram(const Checker& checker) : checker_(checker) {}
    std::string_view name() const override { return "check"; }
    std::string_view summary() const override { return CheckArguments::summary(); }
    std::string_view examples() const override { return CheckArguments::examples(); }
    void declare(Arguments& arguments) override { arguments_.declare(arguments); }
    int run() override {
        if (arguments_.regenerate) return regenerate();
        if (arguments_.handout) return make_handout();
        const std::optional<std::uint64_t> seed = parsed_seed();
        Homework homework = checker_.make(LUCH_SOURCE_DIR, seed);
        keep_only(homework, arguments_.task);
        if (arguments_.mutants || arguments_.variants) return check_the_tests(homework);
        return check_the_student(homework, seed);
    }

 private:
    [[nodiscard]] std::optional<std::uint64_t> parsed_seed() const {
        const std::string& text = arguments_.seed;
        if (text.empty()) return std::nullopt;
        std::uint64_t seed = 0;
        const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), seed);
        if (problem == std::errc() && end == text.data() + text.size()) return seed;
        throw Error("--seed " + text + ": give a whole number, 0 or more");
    }

    int check_the_student(const Homework& homework, std::optional<std::uint64_t> seed) const {
        const Progress progress;
        CheckOptions options{
            .seed = seed, .json = arguments_.json, .judge = {}, .on_test = {}, .on_task = {}};
        options.judge.pictures = "out";
        options.on_test = [&](double done, const std::string& test) {
            if (progress.on_terminal()) Progress(progress).step(done, test);
        };
        options.on_task = [&](const Report& report, const Report::Task& task) {
            progress.clear();
            fmt::print("{}", task_text(report, task));
            std::fflush(stdout);
        };
        const Report report = check(homework, options);
        fmt::print("{}", sum_text(report));
        return report.points() >= report.max_points() - rounding ? 0 : 1;
    }

    int check_the_tests(const Homework& homework) const {
        bool fine = true;
        if ((arguments_.mutants && homework.mutants.empty()) ||
            (arguments_.variants && homework.variants.empty())) {
            throw Error(
                "--mutants, --variants: they are made from the reference steps, which are "
                "not part of this tree");
        }
        if (arguments_.mutants) {
            const Matrix matrix = kill_matrix(homework, {});
            fine = all_killed(matrix);
            fmt::print("{}{} mutants, {}\n", matrix_text(matrix), matrix.rows.size(),
                       fine ? "every one fails on two scenes or more and is known by it"
                            : "NOT every one fails on two scenes and is known by it");
        }
        if (arguments_.variants) {
            const Matrix matrix = variant_matrix(homework, {});
            const bool passed = all_passed(matrix);
            fmt::print("{}{} honest variants, {}\n", matrix_text(matrix), matrix.rows.size(),
                       passed ? "every one has all points" : "NOT every one has all points");
            fine = fine && passed;
        }
        return fine ? 0 : 1;
    }

    int regenerate() const {
        if (checker_.regenerate == nullptr) {
            throw Error("--regenerate: the reference steps are not part of this tree");
        }
        const int changed = checker_.regenerate(
            LUCH_SOURCE_DIR, {.consent = arguments_.yes,
                              .say = [](const std::string& line) { fmt::print("{}\n", line); },
                              .show = show_change});
        if (changed == 0) fmt::print("nothing has changed\n");
        if (changed == 0 || arguments_.yes) return 0;
        fmt::print("{} files would be written; add --yes to do so\n", changed);
        return 1;
    }

    int make_handout() const {
        if (checker_.handout == nullptr) {
            throw Error("--handout: the reference steps are not part of this tree");
        }
        const std::filesystem::path folder =
            std::filesystem::path(LUCH_SOURCE_DIR) / "homework" / checker_.topic / "pictures";
        std::filesystem::create_directories(folder);
        for (const NamedPicture& picture : checker_.handout(LUCH_SOURCE_DIR)) {
            write_picture(folder / (picture.name + ".png"), picture.pixels.view());
            fmt::print("{}\n", (folder / (picture.name + ".png")).string());
        }
        return 0;
    }

    Checker checker_;
    CheckArguments arguments_;
};

}  // namespace

int run_check_program(int argc, char** argv, const Checker& checker) {
    std::vector<std::unique_ptr<Verb>> verbs;
    verbs.push_back(std::make_unique<CheckProgram>(checker));
    return dispatch(argc, argv, verbs);
}

}  // namespace luch
