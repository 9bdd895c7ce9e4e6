#include "framework/grading/child.h"

#include "framework/base/error.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>

namespace luch::grading {
namespace {

/// The last bytes of a whole answer: a child that ends in the middle has not sent them.
constexpr std::string_view mark = "\n.end\n";

[[noreturn]] void be_the_child(const std::function<std::string()>& work, int out) {
    // No core files of a student's crash, and no report but by the pipe.
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    dup2(STDERR_FILENO, STDOUT_FILENO);
    // exit() would wait for threads of the parent's, which are not here.
    std::atexit([] { std::_Exit(EXIT_FAILURE); });
    std::string text;
    try {
        text = work();
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "%s\n", problem.what());
        std::_Exit(EXIT_FAILURE);
    }
    text += mark;
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t n = write(out, text.data() + sent, text.size() - sent);
        if (n < 0) std::_Exit(EXIT_FAILURE);
        sent += static_cast<std::size_t>(n);
    }
    std::_Exit(EXIT_SUCCESS);
}

/// Reads until the pipe is closed. False when the time is over first.
bool read_until(int in, std::chrono::steady_clock::time_point deadline, std::string& text) {
    using namespace std::chrono;
    std::array<char, 65536> piece;
    while (true) {
        const auto left = duration_cast<milliseconds>(deadline - steady_clock::now()).count();
        if (left <= 0) return false;
        pollfd wait{in, POLLIN, 0};
        const int ready = poll(&wait, 1, static_cast<int>(left));
        if (ready < 0 && errno == EINTR) continue;
        if (ready <= 0) return false;
        const ssize_t n = read(in, piece.data(), piece.size());
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return true;
        text.append(piece.data(), static_cast<std::size_t>(n));
    }
}

/// Waits for the end of a child that has closed its pipe; one that lives on is stopped.
int end_of(pid_t child) {
    constexpr int patience = 100;
    int status = 0;
    for (int i = 0; i < patience; ++i) {
        if (waitpid(child, &status, WNOHANG) != 0) return status;
        usleep(2000);
    }
    kill(child, SIGKILL);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

std::string said(int status) {
    if (WIFSIGNALED(status)) return strsignal(WTERMSIG(status));
    return "it ended the program with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace

ChildEnd run_in_child(const std::function<std::string()>& work, double limit_s) {
    std::array<int, 2> ends;
    if (pipe(ends.data()) != 0) {
        throw Error(std::string("no pipe to a test's process: ") + std::strerror(errno));
    }
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) {
        close(ends[0]);
        close(ends[1]);
        throw Error(std::string("no process for a test: ") + std::strerror(errno));
    }
    if (child == 0) {
        close(ends[0]);
        be_the_child(work, ends[1]);
    }
    close(ends[1]);
    const auto limit = std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(limit_s));
    ChildEnd end;
    const bool in_time = read_until(ends[0], std::chrono::steady_clock::now() + limit, end.text);
    close(ends[0]);
    if (!in_time) kill(child, SIGKILL);
    const int status = end_of(child);
    if (!in_time) return {ChildEnd::How::timed_out, ""};
    if (!end.text.ends_with(mark)) return {ChildEnd::How::crashed, said(status)};
    end.text.resize(end.text.size() - mark.size());
    return end;
}

}  // namespace luch::grading
