#include "framework/apps/check_options.h"
#include "framework/apps/verbs.h"
#include "framework/base/error.h"
#include "framework/base/text.h"
#include "framework/technique/catalogue.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace luch {
namespace {

namespace fs = std::filesystem;

std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> all;
    for (std::string& word : words) all.push_back(word.data());
    all.push_back(nullptr);
    return all;
}

/// Runs a program; what it says is returned. Its exit status is put into `status`.
std::string output_of(std::vector<std::string> words, int& status) {
    std::array<int, 2> ends;
    if (pipe(ends.data()) != 0) throw Error(std::string("no pipe: ") + std::strerror(errno));
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw Error(std::string("no process: ") + std::strerror(errno));
    if (child == 0) {
        dup2(ends[1], STDOUT_FILENO);
        dup2(ends[1], STDERR_FILENO);
        close(ends[0]);
        const std::vector<char*> arguments = pointers(words);
        execvp(arguments[0], arguments.data());
        std::_Exit(127);
    }
    close(ends[1]);
    std::string text;
    std::array<char, 4096> piece;
    for (ssize_t n; (n = read(ends[0], piece.data(), piece.size())) > 0;) {
        text.append(piece.data(), static_cast<std::size_t>(n));
    }
    close(ends[0]);
    waitpid(child, &status, 0);
    status = WIFEXITED(status) ? WEXITSTATUS(status) : 127;
    return text;
}

class Check final : public Verb {
 public:
    std::string_view name() const override { return "check"; }
    std::string_view summary() const override { return CheckArguments::summary(); }
    std::string_view examples() const override { return CheckArguments::examples(); }
    void declare(Arguments& arguments) override { arguments_.declare(arguments); }
    int run() override {
        check_topic();
        const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
        if (!build(folder)) return 1;
        const fs::path program = folder / "homework" / arguments_.topic / program_name();
        if (!fs::exists(program)) {
            throw Error({program.string()},
                        "is not there: this homework cannot be checked; "
                        "cmake --build builds what can be");
        }
        std::vector<std::string> words = passed_on(program.string());
        std::fflush(nullptr);
        execv(program.c_str(), pointers(words).data());
        throw Error({program.string()}, std::strerror(errno));
    }

 private:
    [[nodiscard]] std::string program_name() const { return "check_" + arguments_.topic; }

    void check_topic() const {
        constexpr std::string_view folder = "homework/";
        std::vector<std::string_view> topics;
        for (const TechniqueInfo& info : catalogue()) {
            if (info.name.starts_with(folder)) topics.push_back(info.name.substr(folder.size()));
        }
        for (const std::string_view topic : topics) {
            if (topic == arguments_.topic) return;
        }
        throw Error("there is no homework \"" + arguments_.topic + "\"; " +
                    did_you_mean(arguments_.topic, topics));
    }

    /// The student changed a line: what the compiler says is shown when it does not compile.
    [[nodiscard]] bool build(const fs::path& folder) const {
        if (!fs::exists(folder / "CMakeCache.txt")) return true;
        int status = 0;
        const std::string said =
            output_of({"cmake", "--build", folder.string(), "--target", program_name()}, status);
        if (status == 0) return true;
        fmt::print("{}\nhomework/{}/steps.cpp does not compile: the messages are above\n", said,
                   arguments_.topic);
        return false;
    }

    [[nodiscard]] std::vector<std::string> passed_on(std::string program) const {
        std::vector<std::string> words{std::move(program), "check", arguments_.topic};
        const auto option = [&](const char* name, const std::string& value) {
            if (!value.empty()) words.insert(words.end(), {name, value});
        };
        option("--task", arguments_.task);
        option("--seed", arguments_.seed);
        option("--json", arguments_.json);
        if (arguments_.mutants) words.emplace_back("--mutants");
        if (arguments_.variants) words.emplace_back("--variants");
        if (arguments_.regenerate) words.emplace_back("--regenerate");
        if (arguments_.handout) words.emplace_back("--handout");
        if (arguments_.yes) words.emplace_back("--yes");
        return words;
    }

    CheckArguments arguments_;
};

}  // namespace

std::unique_ptr<Verb> make_check() {
    return std::make_unique<Check>();
}

}  // namespace luch
