// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/daemon_client.h"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>

#include "sim_core/devices/device_table.h"
#include "sim_core/devices/packets.h"
#include "sim_core/devices/sentence_packet.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr std::int64_t start_limit = 6000LL * 1'000'000;  // ns
constexpr std::int64_t overseer_silence = 500'000'000;    // ns, for a message; the force was off long before
constexpr std::int64_t end_limit = 1000LL * 1'000'000;    // ns
/// "... Abandon the attempt and check the device's cable ..."
Sentence and_reconnect(const Sentence& what) {
    return {QT_TRANSLATE_NOOP("errors",
                              "%1 Abandon the attempt and check the device's cable and power; the device is "
                              "opened again when the next attempt begins."),
            what};
}

}  // namespace

std::string hapticd_program() {
    if (const char* const named = std::getenv("FULCRUM_HAPTICD")) return named;
    char path[PATH_MAX] = {};
    const ssize_t length = readlink("/proc/self/exe", path, sizeof path - 1);
    const std::string own(path, length > 0 ? static_cast<std::size_t>(length) : 0);
    return own.substr(0, own.find_last_of('/') + 1) + "fulcrum-hapticd";
}

DaemonClient::DaemonClient(const std::string& program, const std::string& specification) {
    try {
        start(program, specification);
    } catch (...) {
        end();
        throw;
    }
}

DaemonClient::~DaemonClient() {
    end();
}

void DaemonClient::start(const std::string& program, const std::string& specification) {
    if (access(program.c_str(), X_OK) != 0)
        throw InputError(
            program, "", {QT_TRANSLATE_NOOP("errors", "cannot be started: %1"), std::strerror(errno)},
            QT_TRANSLATE_NOOP("errors",
                              "install fulcrum-hapticd next to fulcrum, or name it in FULCRUM_HAPTICD"));
    int ends[2];
    make_socket_pair(ends);
    socket_ = ends[0];
    // In the new process the descriptor has the same number; a duplicate of it is not closed on exec.
    const int passed = fcntl(ends[1], F_DUPFD, 3);
    const std::string number = std::to_string(passed);
    std::string words[] = {program, "--control", number, specification};
    char* const arguments[] = {words[0].data(), words[1].data(), words[2].data(), words[3].data(), nullptr};
    const int failed =
        passed < 0 ? errno : posix_spawn(&overseer_, program.c_str(), nullptr, nullptr, arguments, environ);
    close(ends[1]);
    if (passed >= 0) close(passed);
    if (failed != 0) {
        overseer_ = 0;
        throw InputError(
            program, "", {QT_TRANSLATE_NOOP("errors", "cannot be started: %1"), std::strerror(failed)},
            QT_TRANSLATE_NOOP("errors", "check that the file belongs to this version of Fulcrum"));
    }
    const std::int64_t until = monotonic_ns() + start_limit;
    while (monotonic_ns() < until) {
        const std::optional<Packet> packet = receive_packet(socket_, 50);
        if (!packet) continue;
        std::vector<int> taken = packet->descriptors;
        auto line = nlohmann::json::parse(packet->text, nullptr, false);
        if (taken.size() == 2) {
            state_ = SharedPage<StatePage>::open(taken[0], false);
            command_ = SharedPage<CommandPage>::open(taken[1], true);
        } else {
            for (const int descriptor : taken) close(descriptor);
        }
        if (packet->ended || !line.is_object()) break;
        if (line.contains("error"))
            throw InputError(
                sentence_of(line["file"], QT_TRANSLATE_NOOP("errors", "device")),
                line.value("place", std::string()),
                sentence_of(line["error"], QT_TRANSLATE_NOOP("errors", "does not open")),
                sentence_of(line["hint"], QT_TRANSLATE_NOOP("errors", "correct that and try again")));
        if (!state_ || !command_ || line.value("format", 0) != 1) break;
        facts_ = facts_from_json(line.at("device"));
        notes_ = line.at("notes").get<std::vector<std::string>>();
        device_ = line.at("process").get<pid_t>();
        return;
    }
    throw InputError(
        program, "", QT_TRANSLATE_NOOP("errors", "did not open the device"),
        QT_TRANSLATE_NOOP(
            "errors",
            "check that the file belongs to this version of Fulcrum; its messages are on standard error"));
}

void DaemonClient::lose(Health health, const Sentence& what) {
    health_ = health;
    message_ = what;
}

void DaemonClient::take(const std::string& text) {
    auto line = nlohmann::json::parse(text, nullptr, false);
    if (!line.is_object()) return;
    const std::string event = line.value("event", "");
    if (event == "ended") {
        const Sentence what = sentence_of(line["what"], QT_TRANSLATE_NOOP("errors", "ended"));
        if (line.value("again", false))
            lose(Health::restarting,
                 {QT_TRANSLATE_NOOP("errors",
                                    "The program that drives the device %1; it is being started again."),
                  what});
        else
            lose(Health::ended,
                 and_reconnect(
                     {QT_TRANSLATE_NOOP("errors", "The program that drives the device %1 again and again."),
                      what}));
    } else if (event == "started") {
        device_ = line.value("process", device_);
        lose(Health::good, {});
    } else if (line.contains("error")) {
        const Sentence what(
            QT_TRANSLATE_NOOP("errors", "The device could not be opened again: %1; %2."),
            sentence_of(line["error"], QT_TRANSLATE_NOOP("errors", "unknown")),
            sentence_of(line["hint"], QT_TRANSLATE_NOOP("errors", "check its cable and power")));
        if (line.value("again", false))
            lose(Health::restarting, {QT_TRANSLATE_NOOP("errors", "%1 It is tried again."), what});
        else
            lose(Health::ended, and_reconnect(what));
    }
}

DaemonClient::Health DaemonClient::poll() {
    while (health_ != Health::ended) {
        const std::optional<Packet> packet = receive_packet(socket_, 0);
        if (!packet) break;
        for (const int descriptor : packet->descriptors) close(descriptor);
        if (packet->ended)
            lose(Health::ended, and_reconnect(QT_TRANSLATE_NOOP(
                                    "errors", "fulcrum-hapticd, which drives the device, ended.")));
        else
            take(packet->text);
    }
    const std::int64_t silent = monotonic_ns() - state_->overseer_time.load(std::memory_order_relaxed);
    if (health_ == Health::good && silent > overseer_silence)
        lose(Health::silent, and_reconnect(QT_TRANSLATE_NOOP(
                                 "errors", "fulcrum-hapticd, which drives the device, does not answer.")));
    else if (health_ == Health::silent && silent <= overseer_silence)
        lose(Health::good, {});
    FaultReport report;
    fault_ = state_->fault.read(report) ? words_of(static_cast<DeviceFault>(report.fault)) : "";
    return health_;
}

bool DaemonClient::wait_for_sign() const {
    const std::int64_t before = state_->overseer_time.load(), until = monotonic_ns() + overseer_silence;
    while (state_->overseer_time.load() == before) {
        if (monotonic_ns() > until) return false;
        ::poll(nullptr, 0, 1);
    }
    return true;
}

void DaemonClient::end() {
    if (socket_ >= 0) close(socket_);  // the daemon switches the force off and ends
    socket_ = -1;
    if (overseer_ == 0) return;
    kill(overseer_, SIGCONT);  // one that is stopped closes the device too, so that another can open it
    const std::int64_t until = monotonic_ns() + end_limit;
    int status = 0;
    while (waitpid(overseer_, &status, WNOHANG) == 0) {
        if (monotonic_ns() > until) {
            kill(overseer_, SIGKILL);
            while (waitpid(overseer_, &status, 0) < 0 && errno == EINTR) {
            }
            break;
        }
        ::poll(nullptr, 0, 2);
    }
    overseer_ = 0;
}

}  // namespace fulcrum
