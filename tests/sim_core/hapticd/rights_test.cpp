// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/rights.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <thread>

namespace fulcrum::hapticd {
namespace {

/// Runs in a process of its own, because rights do not come back; the number of what was wrong.
int without_rights() {
    std::atomic<int> go{0}, refused{0};
    std::thread older([&] {  // as a thread of a maker's library
        while (go == 0) usleep(100);
        refused = socket(AF_INET, SOCK_STREAM, 0) == -1 && errno == EPERM ? 1 : 0;
    });
    const bool filtered = give_up_rights();
    go = 1;
    older.join();
    if (!filtered) return 1;
    if (refused == 0) return 7;
    if (socket(AF_INET, SOCK_STREAM, 0) != -1 || errno != EPERM) return 2;
    if (socket(AF_UNIX, SOCK_STREAM, 0) != -1 || errno != EPERM) return 3;
    if (execl("/bin/true", "true", nullptr) != -1 || errno != EPERM) return 4;
    if (fork() != -1) return 5;
    int made = 0;
    std::thread([&made] { made = 1; }).join();
    return made == 1 ? 0 : 6;
}

TEST(Rights, NoSocketNoProgramNoProcessButThreads) {
    const pid_t child = fork();
    if (child == 0) _exit(without_rights());
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace fulcrum::hapticd
