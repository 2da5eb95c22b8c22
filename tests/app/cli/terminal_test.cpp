// SPDX-License-Identifier: GPL-3.0-or-later
// The password prompt on a terminal of its own (a pty), and passwords from files.
#include "app/cli/terminal.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <pty.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <system_error>

#include "sim_core/numerics/input_error.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

/// A child process at the prompt, on its own terminal.
class Prompt {
  public:
    Prompt() {
        child_ = forkpty(&terminal_, nullptr, nullptr, nullptr);
        // A signal to -1 would go to every process of the machine.
        if (child_ < 0) throw std::system_error(errno, std::generic_category(), "forkpty");
        if (child_ == 0) {
            int status = 3;
            try {
                status = ask_password("ann") == "secret" ? 0 : 1;
            } catch (const InputError&) {
                status = 2;
            }
            _exit(status);
        }
        read_until("Password of ann: ");
    }
    Prompt(const Prompt&) = delete;
    Prompt& operator=(const Prompt&) = delete;
    ~Prompt() { close(terminal_); }
    bool echoes() const {
        termios state{};
        EXPECT_EQ(tcgetattr(terminal_, &state), 0);
        return (state.c_lflag & ECHO) != 0;
    }
    /// The prompt is printed before the echo is switched off, so this waits for that.
    void wait_until_silent() const {
        while (echoes()) usleep(1000);
    }
    void type(const std::string& text) const {
        EXPECT_EQ(write(terminal_, text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }
    int wait_for_end() const {
        int status = 0;
        EXPECT_EQ(waitpid(child_, &status, 0), child_);
        return status;
    }
    void send(int number) const { kill(child_, number); }

  private:
    void read_until(const std::string& text) const {
        std::string seen;
        for (char c = 0; seen.find(text) == std::string::npos && read(terminal_, &c, 1) == 1;) seen += c;
        EXPECT_NE(seen.find(text), std::string::npos) << seen;
    }
    int terminal_ = -1;
    pid_t child_ = -1;
};

class PasswordPrompt : public ::testing::Test {
  protected:
    void SetUp() override {
        const int terminal = posix_openpt(O_RDWR | O_NOCTTY);
        const bool usable = terminal >= 0 && grantpt(terminal) == 0 && ptsname(terminal) != nullptr &&
                            access(ptsname(terminal), R_OK | W_OK) == 0;
        if (terminal >= 0) close(terminal);
        if (!usable) GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    }
};

TEST_F(PasswordPrompt, ReadsALineWithoutShowingIt) {
    const Prompt prompt;
    prompt.wait_until_silent();
    prompt.type("secret\n");
    const int status = prompt.wait_for_end();
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    EXPECT_TRUE(prompt.echoes());
}

TEST_F(PasswordPrompt, ControlCRestoresTheTerminal) {
    const Prompt prompt;
    prompt.wait_until_silent();
    prompt.type("sec\x03");
    const int status = prompt.wait_for_end();
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT);
    EXPECT_TRUE(prompt.echoes());
}

TEST_F(PasswordPrompt, EverySignalThatEndsTheProgramRestoresTheTerminal) {
    for (const int number : {SIGTERM, SIGQUIT, SIGHUP}) {
        const Prompt prompt;
        prompt.wait_until_silent();
        prompt.send(number);
        const int status = prompt.wait_for_end();
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == number) << number;
        EXPECT_TRUE(prompt.echoes()) << number;
    }
}

TEST_F(PasswordPrompt, RefusesAnEmptyLine) {
    const Prompt prompt;
    prompt.wait_until_silent();
    prompt.type("\n");
    const int status = prompt.wait_for_end();
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 2);
}

TEST(PasswordFile, GivesItsFirstLine) {
    const test::OwnFolder folder;
    const std::string file = folder / "password";
    std::ofstream(file) << "secret\nsecond line\n";
    EXPECT_EQ(read_password(file), "secret");
    std::ofstream(file) << "no newline";
    EXPECT_EQ(read_password(file), "no newline");
    std::ofstream(file) << "secret\r\nsecond line\r\n";
    EXPECT_EQ(read_password(file), "secret");
    std::ofstream(file) << "\r\nsecond";
    EXPECT_THROW(read_password(file), InputError);
    std::ofstream(file) << "\nsecond";
    EXPECT_THROW(read_password(file), InputError);
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    for (const std::string& path :
         {(folder / "pipe").string(), folder.path().string(), (folder / "none").string()})
        EXPECT_THROW(read_password(path), InputError) << path;
}

}  // namespace
}  // namespace fulcrum::app
