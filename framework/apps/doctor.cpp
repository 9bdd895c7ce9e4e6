#include "framework/apps/built_with.h"
#include "framework/apps/hardware.h"
#include "framework/apps/packages.h"
#include "framework/apps/verbs.h"
#include "framework/base/json.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace luch {
namespace {

/// All that the doctor found out.
struct Diagnosis {
    std::vector<Package> packages;
    bool knows_packages = false;  ///< False where there is no dpkg-query.
    Hardware hardware;

    [[nodiscard]] std::vector<std::string> lacking(Need need) const {
        return knows_packages ? missing(packages, need) : std::vector<std::string>{};
    }
    [[nodiscard]] bool healthy() const { return lacking(Need::build).empty(); }
};

Diagnosis diagnosis() {
    Diagnosis result{parsed_packages(package_list()), false, this_hardware()};
    result.knows_packages = ask_dpkg(result.packages);
    return result;
}

std::string_view verdict(const Package& package, bool knows_packages) {
    if (!knows_packages) return "unknown";
    if (package.version) return "ok";
    return package.need == Need::option ? "-" : "missing";
}

void print_packages(const Diagnosis& found) {
    fmt::print("{:<8} {:<20} {:<7} {:<32} {}\n", "", "package", "need", "version", "for");
    for (const Package& package : found.packages) {
        fmt::print("{:<8} {:<20} {:<7} {:<32} {}\n", verdict(package, found.knows_packages),
                   package.name, to_string(package.need), package.version.value_or(""),
                   package.purpose);
    }
}

void print_build() {
    std::vector<std::string> names;
    for (const Library& library : libraries()) {
        names.push_back(library.version.empty()
                            ? fmt::format("no {}", library.name)
                            : fmt::format("{} {}", library.name, library.version));
    }
    fmt::print("\nbuilt by   {}\nbuilt with {}\n", compiler(), fmt::join(names, ", "));
}

void print_hardware(const Hardware& hardware) {
    fmt::print("cores      {}\nmemory     {} MB\n", hardware.cores, hardware.memory_mb);
    fmt::print("processor  {}\n", hardware.levels.empty()
                                      ? "no x86-64-v2"
                                      : fmt::format("{}", fmt::join(hardware.levels, ", ")));
    fmt::print("display    {}\n", hardware.display.empty()
                                      ? "none: luch view needs one, all else does not"
                                      : hardware.display);
}

/// How to get what is missing for `need`, when anything is.
void print_cure(const Diagnosis& found, Need need, std::string_view meaning) {
    const auto names = found.lacking(need);
    if (!names.empty()) fmt::print("\n{}:\n  {}\n", meaning, apt_line(names));
}

void print_cures(const Diagnosis& found) {
    print_cure(found, Need::build, "missing, and required");
    print_cure(found, Need::test, "missing for ./test, which installs it itself");
    print_cure(found, Need::option, "optional");
    if (!found.knows_packages) {
        fmt::print(
            "\nThere is no dpkg-query here, so packages cannot be checked. "
            "The names above are Debian's.\n");
    } else if (found.healthy()) {
        fmt::print("\nEverything required is here.\n");
    }
}

Json to_json(const Package& package) {
    auto json = Json::object()
                    .set("name", package.name)
                    .set("need", to_string(package.need))
                    .set("for", package.purpose)
                    .set("installed", package.version.has_value());
    if (package.version) json.set("version", *package.version);
    return json;
}

Json to_json(std::span<const std::string> words) {
    auto json = Json::array();
    for (const std::string& word : words) json.push(word);
    return json;
}

Json to_json(const Diagnosis& found) {
    auto packages = Json::array(), built_with = Json::object();
    for (const Package& package : found.packages) packages.push(to_json(package));
    for (const Library& library : libraries()) built_with.set(library.name, library.version);
    return Json::object()
        .set("healthy", found.healthy())
        .set("packages_known", found.knows_packages)
        .set("packages", packages)
        .set("missing", to_json(found.lacking(Need::build)))
        .set("compiler", compiler())
        .set("built_with", built_with)
        .set("cores", found.hardware.cores)
        .set("memory_mb", found.hardware.memory_mb)
        .set("processor", to_json(found.hardware.levels))
        .set("display", found.hardware.display);
}

class Doctor : public Verb {
 public:
    std::string_view name() const override { return "doctor"; }
    std::string_view summary() const override {
        return "what is installed here, what each thing is for, and how to get the rest";
    }
    std::string_view examples() const override {
        return "  luch doctor                    a table; exit status 1 when something required is "
               "missing\n"
               "  luch doctor --json doctor.json the same for a machine\n";
    }
    void declare(Arguments& arguments) override {
        arguments.option("--json", json_file_, "FILE", "also write the findings as JSON");
    }
    int run() override {
        const Diagnosis found = diagnosis();
        print_packages(found);
        print_build();
        print_hardware(found.hardware);
        print_cures(found);
        if (!json_file_.empty()) to_json(found).write(json_file_);
        return found.healthy() ? 0 : 1;
    }

 private:
    std::string json_file_;
};

}  // namespace

std::unique_ptr<Verb> make_doctor() {
    return std::make_unique<Doctor>();
}

}  // namespace luch
