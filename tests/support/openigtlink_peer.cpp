// SPDX-License-Identifier: Apache-2.0
#include "tests/support/openigtlink_peer.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "tests/support/built.h"

namespace fulcrum::test {
namespace {

std::string peer_path() {
    return fake_program("openigtlink_peer");
}

}  // namespace

bool OpenIgtlinkPeer::built() {
    return std::filesystem::exists(peer_path());
}

OpenIgtlinkPeer::OpenIgtlinkPeer(std::vector<std::string> words) {
    words.insert(words.begin(), peer_path());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe for " + words[0]);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    const int failed = posix_spawn(&process_, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    output_ = ends[0];
    if (failed == 0) return;
    close(output_);
    throw std::runtime_error("cannot be started: " + words[0]);
}

OpenIgtlinkPeer::~OpenIgtlinkPeer() {
    close(output_);
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
}

std::vector<std::string> OpenIgtlinkPeer::lines(int wait_ms) {
    pollfd one{output_, POLLIN, 0};
    char part[4096];
    while (poll(&one, 1, wait_ms) > 0) {
        const ssize_t got = read(output_, part, sizeof part);
        if (got <= 0) break;
        text_.append(part, static_cast<std::size_t>(got));
        wait_ms = 0;
    }
    std::vector<std::string> whole;
    std::size_t from = 0;
    for (std::size_t at = text_.find('\n'); at != std::string::npos; at = text_.find('\n', from)) {
        whole.push_back(text_.substr(from, at - from));
        from = at + 1;
    }
    text_.erase(0, from);
    return whole;
}

}  // namespace fulcrum::test
