#pragma once

#include "framework/apps/arguments.h"

namespace luch {

/// What `luch check` is told: it builds the homework's own checking program, which is told the
/// same.
struct CheckArguments {
    std::string topic, seed, json, task;
    bool mutants = false, variants = false, regenerate = false, yes = false, handout = false;

    void declare(Arguments& arguments);
    static std::string_view summary() {
        return "checks a homework and says what is wrong, and why";
    }
    static std::string_view examples();
};

}  // namespace luch
