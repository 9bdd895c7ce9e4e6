#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace luch {

/// What a verb reads from the command line. A thin face over CLI11, whose header is slow to compile
/// and is therefore named in arguments.cpp only. The variables must outlive the parsing; their
/// values at the time of the call are the defaults.
class Arguments {
 public:
    virtual ~Arguments() = default;
    virtual void positional(const std::string& name, std::string& value, const std::string& help,
                            bool required = true) = 0;
    virtual void positional(const std::string& name, std::vector<std::string>& values,
                            const std::string& help, bool required = true) = 0;
    /// `name` is "-o,--output" or "--size"; `placeholder` is shown in the help: WxH.
    virtual void option(const std::string& name, std::string& value, const std::string& placeholder,
                        const std::string& help) = 0;
    virtual void option(const std::string& name, int& value, const std::string& placeholder,
                        const std::string& help) = 0;
    virtual void option(const std::string& name, std::uint64_t& value,
                        const std::string& placeholder, const std::string& help) = 0;
    virtual void option(const std::string& name, double& value, const std::string& placeholder,
                        const std::string& help) = 0;
    /// May be given several times.
    virtual void option(const std::string& name, std::vector<std::string>& values,
                        const std::string& placeholder, const std::string& help) = 0;
    virtual void flag(const std::string& name, bool& value, const std::string& help) = 0;
};

/// One thing that the program can do. Exit status of run(): 0 fine, 1 a check failed; a user's
/// mistake is thrown as Error (2), anything else thrown is our fault (3).
class Verb {
 public:
    virtual ~Verb() = default;
    [[nodiscard]] virtual std::string_view name() const = 0;
    [[nodiscard]] virtual std::string_view summary() const = 0;
    /// Whole commands with a comment each, shown at the end of --help.
    [[nodiscard]] virtual std::string_view examples() const = 0;
    virtual void declare(Arguments& arguments) = 0;
    virtual int run() = 0;
};

/// Parses the command line, runs the verb it names and returns the exit status.
int dispatch(int argc, char** argv, std::span<const std::unique_ptr<Verb>> verbs);

}  // namespace luch
