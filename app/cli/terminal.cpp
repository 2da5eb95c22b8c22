// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/terminal.h"

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <iostream>

#include "app/cli/command.h"

namespace fulcrum::app {
namespace {

constexpr std::array<int, 5> caught = {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGTSTP};
constexpr std::size_t longest_password = 4096;

volatile std::sig_atomic_t signal_seen = 0;

void note_signal(int number) {
    signal_seen = number;
}

/// Switches the terminal's echo off and defers signals during its lifetime: they are blocked except
/// while wait() waits, so that none can arrive unnoticed between a check and a blocking read.
class SilentTerminal {
  public:
    SilentTerminal() {
        signal_seen = 0;
        struct sigaction note {};
        note.sa_handler = note_signal;
        sigemptyset(&note.sa_mask);
        sigset_t blocked;
        sigemptyset(&blocked);
        for (const int number : caught) sigaddset(&blocked, number);
        pthread_sigmask(SIG_BLOCK, &blocked, &mask_before_);
        for (std::size_t i = 0; i < caught.size(); ++i) sigaction(caught[i], &note, &actions_[i]);
        tcgetattr(STDIN_FILENO, &before_);
        termios silent = before_;
        silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
        tcsetattr(STDIN_FILENO, TCSAFLUSH, &silent);
    }
    SilentTerminal(const SilentTerminal&) = delete;
    SilentTerminal& operator=(const SilentTerminal&) = delete;
    ~SilentTerminal() {
        tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_);
        pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);  // a pending signal is noted here
        for (std::size_t i = 0; i < caught.size(); ++i) sigaction(caught[i], &actions_[i], nullptr);
    }
    /// Waits for input; false at a signal that was noted or at an error.
    bool wait() const {
        pollfd input{STDIN_FILENO, POLLIN, 0};
        while (signal_seen == 0) {
            if (ppoll(&input, 1, nullptr, &mask_before_) > 0) return true;
            if (errno != EINTR) return false;
        }
        return false;
    }

  private:
    termios before_{};
    sigset_t mask_before_{};
    std::array<struct sigaction, caught.size()> actions_{};
};

/// The line without its newline; ends early at a signal.
std::string read_line(const SilentTerminal& terminal) {
    std::string line;
    for (char c = 0; line.size() < longest_password && terminal.wait();) {
        if (read(STDIN_FILENO, &c, 1) <= 0 || c == '\n') break;
        line += c;
    }
    return line;
}

}  // namespace

std::string ask_password(const std::string& login) {
    if (isatty(STDIN_FILENO) == 0)
        throw UsageError("--as", QT_TRANSLATE_NOOP("errors", "there is no terminal to ask for a password"),
                         QT_TRANSLATE_NOOP("errors", "give --password-file FILE"));
    for (;;) {
        std::cerr << Sentence(QT_TRANSLATE_NOOP("commands", "Password of %1:"), login).words(help_words)
                  << ' ' << std::flush;
        std::string line;
        {
            const SilentTerminal silent;
            line = read_line(silent);
        }
        std::cerr << '\n';
        if (signal_seen == 0) {
            if (line.empty())
                throw UsageError("--as", QT_TRANSLATE_NOOP("errors", "no password was entered"),
                                 QT_TRANSLATE_NOOP("errors", "type it and press Enter"));
            return line;
        }
        std::raise(signal_seen);  // deliver it now; a program that was stopped asks again when resumed
    }
}

std::string read_password(const std::string& path) {
    const auto fail = [&](const char* problem) {
        return InputError(path, "", problem,
                          QT_TRANSLATE_NOOP("errors", "give a file with the password on its first line"));
    };
    // Without O_NONBLOCK a named pipe without a writer would block the program.
    const int file = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) throw fail(QT_TRANSLATE_NOOP("errors", "cannot be read"));
    std::string text;
    bool failed = false;
    while (text.size() < longest_password && text.find('\n') == std::string::npos) {
        std::array<char, 256> part{};
        const ssize_t count = read(file, part.data(), part.size());
        if (count > 0) {
            text.append(part.data(), static_cast<std::size_t>(count));
        } else if (count < 0 && errno == EAGAIN) {
            pollfd wait{file, POLLIN, 0};
            poll(&wait, 1, -1);
        } else if (count == 0 || errno != EINTR) {
            failed = count < 0;
            break;
        }
    }
    close(file);
    if (failed) throw fail(QT_TRANSLATE_NOOP("errors", "cannot be read"));
    const std::size_t end = text.find('\n');
    if (end != std::string::npos) {
        // Editors of other systems end lines with CR and LF.
        text.resize(end > 0 && text[end - 1] == '\r' ? end - 1 : end);
    }
    if (text.empty()) throw fail(QT_TRANSLATE_NOOP("errors", "its first line is empty"));
    return text;
}

}  // namespace fulcrum::app
