#include "framework/apps/arguments.h"

#include "framework/base/error.h"
#include "framework/base/text.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

namespace luch {
namespace {

class CliArguments final : public Arguments {
 public:
    explicit CliArguments(CLI::App& app) : app_(app) {}

    void positional(const std::string& name, std::string& value, const std::string& help,
                    bool required) override {
        app_.add_option(name, value, help)->required(required)->type_name("");
    }
    void positional(const std::string& name, std::vector<std::string>& values,
                    const std::string& help, bool required) override {
        app_.add_option(name, values, help)->required(required)->type_name("");
    }
    void option(const std::string& name, std::string& value, const std::string& placeholder,
                const std::string& help) override {
        add(name, value, placeholder, help);
    }
    void option(const std::string& name, int& value, const std::string& placeholder,
                const std::string& help) override {
        add(name, value, placeholder, help);
    }
    void option(const std::string& name, std::uint64_t& value, const std::string& placeholder,
                const std::string& help) override {
        add(name, value, placeholder, help);
    }
    void option(const std::string& name, double& value, const std::string& placeholder,
                const std::string& help) override {
        add(name, value, placeholder, help);
    }
    void option(const std::string& name, std::vector<std::string>& values,
                const std::string& placeholder, const std::string& help) override {
        app_.add_option(name, values, help)
            ->type_name(placeholder)
            ->expected(1)
            ->take_all()
            ->allow_extra_args(false);
    }
    void flag(const std::string& name, bool& value, const std::string& help) override {
        app_.add_flag(name, value, help);
    }

 private:
    template <class T>
    void add(const std::string& name, T& value, const std::string& placeholder,
             const std::string& help) {
        app_.add_option(name, value, help)->type_name(placeholder);
    }
    CLI::App& app_;
};

/// An unknown verb: "there is no verb "rnder"; did you mean render…?"
void check_verb(const std::string& word, std::span<const std::unique_ptr<Verb>> verbs) {
    std::vector<std::string_view> names;
    for (const auto& verb : verbs) {
        if (verb->name() == word) return;
        names.push_back(verb->name());
    }
    throw Error("there is no verb \"" + word + "\"; " + did_you_mean(word, names) +
                " `luch --help` shows all of them");
}

int parse_and_run(int argc, char** argv, std::span<const std::unique_ptr<Verb>> verbs) {
    CLI::App app{"luch: a teaching framework for real-time ray tracing", "luch"};
    app.set_version_flag("--version", LUCH_VERSION);
    app.require_subcommand(1);
    app.footer(
        "`luch VERB --help` explains a verb, with examples.\n"
        "Exit status: 0 fine; 1 a check or comparison failed; 2 bad input or usage; "
        "3 our fault.");
    Verb* chosen = nullptr;
    for (const auto& verb : verbs) {
        CLI::App* sub = app.add_subcommand(std::string(verb->name()), std::string(verb->summary()));
        sub->footer("Examples:\n" + std::string(verb->examples()));
        CliArguments arguments(*sub);
        verb->declare(arguments);
        sub->callback([&chosen, &verb] { chosen = verb.get(); });
    }
    if (argc > 1 && argv[1][0] != '-') check_verb(argv[1], verbs);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        return app.exit(problem) == 0 ? 0 : 2;
    }
    return chosen->run();
}

}  // namespace

int dispatch(int argc, char** argv, std::span<const std::unique_ptr<Verb>> verbs) {
    try {
        return parse_and_run(argc, argv, verbs);
    } catch (const Error& error) {
        std::fprintf(stderr, "luch: %s\n", error.what());
        return 2;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "luch: internal error: %s\n", error.what());
        return 3;
    }
}

}  // namespace luch
