// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/maker_library.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <nlohmann/json.hpp>

#include "sim_core/devices/device_table.h"
#include "sim_core/devices/packets.h"

namespace fulcrum {
namespace {

constexpr int look_limit_ms = 3000;

}  // namespace

const char* problem_of(LibraryState state) {
    switch (state) {
        case LibraryState::ready:
            return "";
        case LibraryState::missing:
            return QT_TRANSLATE_NOOP("errors", "the maker's library is not installed");
        case LibraryState::incomplete:
            return QT_TRANSLATE_NOOP("errors", "the maker's library needs another one that is missing");
        case LibraryState::outdated:
            return QT_TRANSLATE_NOOP("errors", "the maker's library lacks a function that Fulcrum needs");
        case LibraryState::unusable:
            return QT_TRANSLATE_NOOP("errors", "the maker's library cannot be loaded");
    }
    return "";
}

const char* hint_of(const DeviceRow& device, LibraryState state) {
    switch (state) {
        case LibraryState::ready:
            return "";
        case LibraryState::missing:
            return device.library.install;
        case LibraryState::incomplete:
            return device.library.needs;
        case LibraryState::outdated:
        case LibraryState::unusable:
            return QT_TRANSLATE_NOOP("errors", "install the newest version of the maker's driver");
    }
    return "";
}

LibraryLook look_at_library(const std::string& program, const std::string& kind) {
    LibraryLook look{LibraryState::unusable, {}};
    int ends[2];
    make_socket_pair(ends);
    const int passed = fcntl(ends[1], F_DUPFD, 3);  // not closed on exec
    std::string words[] = {program, "--look", std::to_string(passed), kind};
    char* const arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
    pid_t child = 0;
    const int failed =
        passed < 0 ? errno : posix_spawn(&child, program.c_str(), nullptr, nullptr, arguments, environ);
    close(ends[1]);
    if (passed >= 0) close(passed);
    if (failed != 0) {
        look.detail = program + ": " + std::strerror(failed);
        close(ends[0]);
        return look;
    }
    if (const std::optional<Packet> packet = receive_packet(ends[0], look_limit_ms)) {
        for (const int descriptor : packet->descriptors) close(descriptor);
        const auto line = nlohmann::json::parse(packet->text, nullptr, false);
        if (line.is_object()) {
            const int state = line.value("state", static_cast<int>(LibraryState::unusable));
            look.state =
                static_cast<LibraryState>(std::clamp(state, 0, static_cast<int>(LibraryState::unusable)));
            look.detail = line.value("detail", std::string());
        }
    }
    close(ends[0]);
    kill(child, SIGKILL);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(status) && WTERMSIG(status) != SIGKILL && look.state == LibraryState::unusable)
        look.detail = strsignal(WTERMSIG(status));
    return look;
}

}  // namespace fulcrum
