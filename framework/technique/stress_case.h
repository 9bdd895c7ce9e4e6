#pragma once

#include <functional>
#include <string>

namespace luch {

/// What came of an extreme case. `not_written`: a homework's hole was filled by the reference, so
/// the case says nothing of the student's work. `does_not_apply`: the technique's plan says so.
enum class StressVerdict { pass, fail, not_written, does_not_apply };

struct StressResult {
    StressVerdict verdict = StressVerdict::pass;
    std::string got;  ///< what was seen, in a few words
};

/// An extreme case, of `luch stress`'s table or a technique's own.
struct StressCase {
    int row = 0;  ///< of the table; a technique's own: that of the row it belongs to
    std::string name, expected;
    std::function<StressResult()> run;
};

}  // namespace luch
