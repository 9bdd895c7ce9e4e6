#include "framework/technique/params.h"

#include "framework/base/error.h"
#include "framework/base/text.h"
#include "framework/technique/technique.h"

#include <fmt/format.h>

#include <cmath>

namespace luch {
namespace {

/// Sets the one parameter of a given name from text.
class Setter final : public ParamVisitor {
 public:
    Setter(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {}

    void visit(const ParamInfo& info, int& value, int least, int most) override {
        if (!is_wanted(info)) return;
        const auto number = parsed_number(text_);
        if (!number || *number != std::floor(*number) || *number < least || *number > most) {
            refuse(fmt::format("a whole number from {} to {}", least, most));
        }
        value = static_cast<int>(*number);
    }
    void visit(const ParamInfo& info, double& value, double least, double most) override {
        if (!is_wanted(info)) return;
        const auto number = parsed_number(text_);
        if (!number || *number < least || *number > most) {
            refuse(fmt::format("a number from {} to {}", least, most));
        }
        value = *number;
    }
    void visit(const ParamInfo& info, bool& value) override {
        if (!is_wanted(info)) return;
        const std::string word = lower(text_);
        const bool on = word == "on" || word == "true" || word == "1" || word == "yes";
        const bool off = word == "off" || word == "false" || word == "0" || word == "no";
        if (!on && !off) refuse("on or off");
        value = on;
    }
    void visit(const ParamInfo& info, int& value,
               std::span<const std::string_view> words) override {
        if (!is_wanted(info)) return;
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (words[i] == text_) {
                value = static_cast<int>(i);
                return;
            }
        }
        const std::vector<std::string> choices(words.begin(), words.end());
        refuse(listed(choices));
    }

    /// Throws when no parameter of that name was met.
    void finish() const {
        if (found_) return;
        const std::vector<std::string_view> names(names_.begin(), names_.end());
        throw Error(names.empty()
                        ? fmt::format("parameter \"{}\": this technique has no parameters", name_)
                        : fmt::format("there is no parameter \"{}\"; {}", name_,
                                      did_you_mean(name_, names)));
    }

 private:
    bool is_wanted(const ParamInfo& info) {
        names_.emplace_back(info.name);
        if (info.name != name_) return false;
        found_ = true;
        return true;
    }
    [[noreturn]] void refuse(const std::string& expected) const {
        throw Error(fmt::format("parameter {}: \"{}\" is not {}; give {}", name_, text_, expected,
                                expected));
    }

    std::string name_, text_;
    std::vector<std::string> names_;
    bool found_ = false;
};

/// Writes every parameter down.
class Lister final : public ParamVisitor {
 public:
    std::vector<ParamText> texts;

    void visit(const ParamInfo& info, int& value, int least, int most) override {
        add(info, std::to_string(value), fmt::format("{}…{}", least, most));
    }
    void visit(const ParamInfo& info, double& value, double least, double most) override {
        add(info, fmt::format("{}", value), fmt::format("{}…{}", least, most));
    }
    void visit(const ParamInfo& info, bool& value) override {
        add(info, value ? "on" : "off", "on, off");
    }
    void visit(const ParamInfo& info, int& value,
               std::span<const std::string_view> words) override {
        const std::vector<std::string> choices(words.begin(), words.end());
        add(info, choices[static_cast<std::size_t>(value)], listed(choices));
    }

 private:
    void add(const ParamInfo& info, std::string value, std::string range) {
        texts.push_back({std::string(info.name), std::move(value), std::move(range),
                         std::string(info.unit), std::string(info.help)});
    }
};

}  // namespace

void set_param(Technique& technique, std::string_view assignment) {
    const std::size_t equals = assignment.find('=');
    if (equals == std::string_view::npos) {
        throw Error(fmt::format("parameter \"{}\": write it as key=value", assignment));
    }
    Setter setter(std::string(trimmed(assignment.substr(0, equals))),
                  std::string(trimmed(assignment.substr(equals + 1))));
    technique.visit(setter);
    setter.finish();
}

std::vector<ParamText> params_of(Technique& technique) {
    Lister lister;
    technique.visit(lister);
    return lister.texts;
}

}  // namespace luch
