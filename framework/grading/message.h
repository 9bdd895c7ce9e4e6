#pragma once

#include "framework/grading/judge.h"

namespace luch::grading {

/// A case's result as text, which a child process sends to its parent; and back, but for its
/// pictures and with a signature, sorted, even where only wrong elements were named. What cannot be
/// read is a crash: the child's memory may have been damaged.
std::string text_of(const CaseResult& result);
CaseResult result_of(const std::string& text);

}  // namespace luch::grading
