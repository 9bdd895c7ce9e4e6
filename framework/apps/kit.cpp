#include "framework/grading/kit.h"

#include "framework/apps/verbs.h"
#include "framework/base/error.h"

#include <fmt/format.h>

namespace luch {
namespace {

namespace fs = std::filesystem;

class KitVerb final : public Verb {
 public:
    std::string_view name() const override { return "kit"; }
    std::string_view summary() const override {
        return "writes the students' tree: this one without the solutions";
    }
    std::string_view examples() const override {
        return "  luch kit ../luch-kit           a new folder with a tree that builds alone\n"
               "  luch kit --list                what would be in it, and what would not\n"
               "What is in it is said in homework/kit.txt. Before it ends well, the kit is "
               "searched\n"
               "for lines of the solutions.\n";
    }
    void declare(Arguments& arguments) override {
        arguments.positional("DIR", folder_, "a new or empty folder", false);
        arguments.flag("--list", list_, "write nothing, list the files");
    }
    int run() override {
        const fs::path root = LUCH_SOURCE_DIR;
        if (folder_.empty() != list_) throw Error("luch kit: give a new folder, or --list");
        const grading::Kit kit = grading::kit_of(root);
        if (list_) return listed(kit);
        grading::write_kit(root, kit, folder_);
        const std::vector<std::string> found = grading::leaks(root, kit, folder_);
        for (const std::string& leak : found) fmt::print("{}\n", leak);
        fmt::print("{}: {} files, {:.1f} MB; {}\n", folder_, kit.files.size(), megabytes(),
                   found.empty() ? "no line of a solution is in it"
                                 : "it HOLDS LINES OF SOLUTIONS: do not hand it out");
        return found.empty() ? 0 : 1;
    }

 private:
    static int listed(const grading::Kit& kit) {
        for (const auto& [from, to] : kit.files) {
            fmt::print("{}{}\n", to.generic_string(),
                       from == to ? "" : "  from " + from.generic_string());
        }
        for (const fs::path& file : kit.solutions) {
            fmt::print("solution, left out: {}\n", file.generic_string());
        }
        return 0;
    }

    [[nodiscard]] double megabytes() const {
        std::uintmax_t bytes = 0;
        for (const auto& entry : fs::recursive_directory_iterator(folder_)) {
            if (entry.is_regular_file()) bytes += entry.file_size();
        }
        return static_cast<double>(bytes) * 1e-6;
    }

    std::string folder_;
    bool list_ = false;
};

}  // namespace

std::unique_ptr<Verb> make_kit() {
    return std::make_unique<KitVerb>();
}

}  // namespace luch
