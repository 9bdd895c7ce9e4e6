#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace luch {

/// What a command printed (both streams) and its exit status; −1 when it did not end by itself.
struct Ran {
    int status = -1;
    std::string text;
};

/// Runs a command of the shell to its end.
inline Ran shell(const std::string& command) {
    Ran ran;
    std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return ran;
    std::array<char, 4096> buffer{};
    for (std::size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) {
        ran.text.append(buffer.data(), n);
    }
    const int status = pclose(pipe);
    if (WIFEXITED(status)) ran.status = WEXITSTATUS(status);
    return ran;
}

}  // namespace luch
