#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace luch {

/// Shown everywhere a parameter appears: command line, sliders, reports, errors.
struct ParamInfo {
    std::string_view name;
    std::string_view unit;  ///< "" for plain numbers
    std::string_view help;  ///< one sentence
};

/// Walks over a technique's parameters; each visit may read the value or change it within its
/// range.
class ParamVisitor {
 public:
    virtual ~ParamVisitor() = default;
    virtual void visit(const ParamInfo& info, int& value, int least, int most) = 0;
    virtual void visit(const ParamInfo& info, double& value, double least, double most) = 0;
    virtual void visit(const ParamInfo& info, bool& value) = 0;
    /// One of several words; `value` is an index into them.
    virtual void visit(const ParamInfo& info, int& value,
                       std::span<const std::string_view> words) = 0;
};

class Technique;

/// Sets "key=value". Throws Error on an unknown key (listing the valid ones), a value that is not
/// of the right kind, or one out of range.
void set_param(Technique& technique, std::string_view assignment);

/// One parameter as text, for lists and reports.
struct ParamText {
    std::string name, value, range, unit, help;
};
std::vector<ParamText> params_of(Technique& technique);

}  // namespace luch
