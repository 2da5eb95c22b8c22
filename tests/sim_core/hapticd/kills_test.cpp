// SPDX-License-Identifier: Apache-2.0
// The force at the motors after kill -9 and SIGSTOP of the program, of the overseer and of the device
// process. FULCRUM_HAPTICD_KILLS: how many (36).
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "sim_core/devices/daemon_client.h"
#include "sim_core/devices/packets.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/built.h"
#include "tests/support/own_folder.h"
#include "tests/support/process_rights.h"

namespace fulcrum {
namespace {

constexpr std::int64_t limit = 50'000'000;  // ns
constexpr const char* script_text = R"({"format": "fulcrum-device-script", "force": {"peak": 3.3},
    "left": {"path": [{"t": 0, "position": [0, 0, 0]}], "hand": {"mass": 0.2}},
    "right": {"path": [{"t": 0, "position": [0, 0, 0]}]}})";

void pause_ns(std::int64_t ns) {
    timespec time{0, ns};
    nanosleep(&time, nullptr);
}

/// What the child does with its commands once misbehave() was called; when it is called again, it is honest.
/// From `random_words` on it overwrites the whole page, version numbers included.
enum class Behaviour { honest, not_a_number, too_large, old_sequence, random_words, zeros, ones };

void overwrite(CommandPage& page, Behaviour with, std::mt19937_64& random) {
    auto* const words = reinterpret_cast<std::atomic<std::uint64_t>*>(&page);
    for (std::size_t i = 0; i < sizeof page / sizeof *words; ++i)
        words[i].store(with == Behaviour::random_words ? random() : with == Behaviour::zeros ? 0 : ~0ULL);
}

/// A program in a process of its own that sends 1 N to both hands every millisecond.
class Program {
  public:
    explicit Program(const std::string& script, Behaviour later = Behaviour::honest) {
        make_socket_pair(ends_);
        pid = fork();
        if (pid == 0) {
            close(ends_[0]);
            run(script, later);
        }
        close(ends_[1]);
        const std::int64_t until = monotonic_ns() + 8'000'000'000;
        std::optional<Packet> packet;
        while (!packet && monotonic_ns() < until) packet = receive_packet(ends_[0], 100);
        if (!packet || packet->descriptors.size() != 1) return;
        const auto line = nlohmann::json::parse(packet->text);
        overseer = line.at("overseer").get<pid_t>();
        device = line.at("device").get<pid_t>();
        state = SharedPage<StatePage>::open(packet->descriptors[0], false);
    }
    ~Program() {
        for (const pid_t one : {pid, overseer}) {
            if (one > 0) kill(one, SIGCONT);
        }
        if (pid > 0) kill(pid, SIGKILL);
        close(ends_[0]);
        // The test is the reaper of all of them: nothing may be left.
        const std::int64_t until = monotonic_ns() + 5'000'000'000;
        while (monotonic_ns() < until) {
            const pid_t reaped = waitpid(-1, nullptr, WNOHANG);
            if (reaped < 0) return;
            if (reaped == 0) pause_ns(1'000'000);
        }
        ADD_FAILURE() << "a process of the daemon did not end";
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    void misbehave() { send_packet(ends_[0], {{"do", "lie"}}); }
    double force() const {
        double most = 0;
        for (const auto& shared : state->report) {
            ForceReport report;
            if (!shared.read(report)) return std::numeric_limits<double>::infinity();
            for (const double f : report.force) most = std::max(most, std::abs(f));
        }
        return most;
    }
    bool wait_for_force() const {
        const std::int64_t until = monotonic_ns() + 5'000'000'000;
        while (monotonic_ns() < until) {
            const double now = force();
            if (now > 0.1 && now < 10) return true;
            pause_ns(1'000'000);
        }
        return false;
    }
    /// ns from `begin` until the motors of both hands got 0; the largest number if they did not.
    std::int64_t until_zero(std::int64_t begin, ForceReport* last = nullptr) const {
        while (monotonic_ns() < begin + 1'000'000'000) {
            if (force() == 0) {
                std::int64_t latest = 0;
                for (const auto& shared : state->report) {
                    ForceReport report;
                    while (!shared.read(report)) pause_ns(100'000);
                    // The first tick with 0 may be followed by others: a bound from above.
                    latest = std::max(latest, report.time);
                    if (last != nullptr) *last = report;
                }
                return latest - begin;
            }
            pause_ns(200'000);
        }
        return std::numeric_limits<std::int64_t>::max();
    }
    pid_t pid = 0, overseer = 0, device = 0;
    SharedPage<StatePage> state;

  private:
    [[noreturn]] void run(const std::string& script, Behaviour later) {
        try {
            DaemonClient client(test::hapticd_program(), "virtual:" + script);
            send_packet(ends_[1], {{"overseer", client.overseer()}, {"device", client.device_process()}},
                        {client.state_descriptor()});
            ForceCommand command;
            Behaviour now = Behaviour::honest;
            std::mt19937_64 random(7);
            while (true) {
                const auto packet = receive_packet(ends_[1], 0);
                if (packet && packet->ended) _exit(0);
                if (packet) now = now == Behaviour::honest ? later : Behaviour::honest;
                if (now >= Behaviour::random_words) {
                    overwrite(client.command(), now, random);
                    pause_ns(300'000);
                    continue;
                }
                command.sequence += 1;
                command.force[0] = now == Behaviour::not_a_number ? std::nan("")
                                   : now == Behaviour::too_large  ? 4
                                                                  : 1;
                ForceCommand sent = command;
                if (now == Behaviour::old_sequence) sent.sequence = 10 + command.sequence % 7;
                for (auto& hand : client.command().command) hand.write(sent);
                pause_ns(1'000'000);
            }
        } catch (const std::exception& error) {
            std::cerr << error.what() << '\n';
            _exit(1);
        }
    }
    int ends_[2] = {-1, -1};
};

class HapticdKills : public ::testing::Test {
  protected:
    HapticdKills() {
        prctl(PR_SET_CHILD_SUBREAPER, 1);
        std::ofstream(script) << script_text;
    }
    ~HapticdKills() override { prctl(PR_SET_CHILD_SUBREAPER, 0); }
    test::OwnFolder folder;
    std::string script = (folder / "script.json").string();
};

TEST_F(HapticdKills, ForceIsZeroWithin50MillisecondsWhicheverSideDiesOrStops) {
    const char* const wanted = std::getenv("FULCRUM_HAPTICD_KILLS");
    const int kills = wanted != nullptr ? std::max(1, std::atoi(wanted)) : 36;
    std::vector<std::int64_t> times[6];
    const char* const sides[] = {"program", "overseer", "device process"};
    for (int i = 0; i < kills; ++i) {
        const int side = i % 3, number = (i / 3) % 2 == 0 ? SIGKILL : SIGSTOP;
        Program program(script);
        ASSERT_TRUE(program.state) << "round " << i;
        ASSERT_TRUE(program.wait_for_force()) << "round " << i;
        const pid_t victim = side == 0 ? program.pid : side == 1 ? program.overseer : program.device;
        const std::int64_t begin = monotonic_ns();
        ASSERT_EQ(kill(victim, number), 0);
        const std::int64_t took = program.until_zero(begin);
        EXPECT_LE(took, limit) << strsignal(number) << " of the " << sides[side] << ", round " << i;
        times[i % 6].push_back(took);
    }
    for (int i = 0; i < 6 && i < kills; ++i) {
        std::sort(times[i].begin(), times[i].end());
        std::cout << (i < 3 ? "SIGKILL" : "SIGSTOP") << " of the " << sides[i % 3] << ": " << times[i].size()
                  << " times, force 0 after " << times[i][times[i].size() / 2] / 1000 << " us (median), "
                  << times[i].back() / 1000 << " us (worst)\n";
    }
}

TEST_F(HapticdKills, ForceIsZeroWithin50MillisecondsWhenTheProgramsStateIsFalse) {
    for (const auto& [lie, off] : {std::pair(Behaviour::not_a_number, ForceOff::not_finite),
                                   std::pair(Behaviour::too_large, ForceOff::too_large),
                                   std::pair(Behaviour::old_sequence, ForceOff::sequence_back)}) {
        Program program(script, lie);
        ASSERT_TRUE(program.state);
        ASSERT_TRUE(program.wait_for_force());
        const std::int64_t begin = monotonic_ns();
        program.misbehave();
        EXPECT_LE(program.until_zero(begin), limit) << words_of(off);
        EXPECT_GT(kill(program.device, 0), -1) << "the device process runs on";
    }
}

TEST_F(HapticdKills, ForceIsZeroWithin50MillisecondsWhenGarbageIsWrittenOverTheSharedPage) {
    for (const Behaviour garbage : {Behaviour::random_words, Behaviour::zeros, Behaviour::ones}) {
        Program program(script, garbage);
        ASSERT_TRUE(program.state);
        ASSERT_TRUE(program.wait_for_force());
        const std::int64_t begin = monotonic_ns();
        program.misbehave();
        EXPECT_LE(program.until_zero(begin), limit) << static_cast<int>(garbage);
        double most = 0;
        while (monotonic_ns() < begin + 400'000'000) {  // longer than good commands need to bring force back
            const double now = program.force();         // infinite: the device process waits inside a report
            if (std::isfinite(now)) most = std::max(most, now);
            pause_ns(200'000);
        }
        EXPECT_EQ(most, 0) << static_cast<int>(garbage);
        EXPECT_EQ(kill(program.device, 0), 0) << "the device process runs on";
        if (garbage != Behaviour::random_words) continue;
        program.misbehave();
        EXPECT_TRUE(program.wait_for_force()) << "honest commands again";
    }
}

TEST_F(HapticdKills, TheDeviceProcessIsStartedAgainAndForceComesBack) {
    Program program(script);
    ASSERT_TRUE(program.state);
    ASSERT_TRUE(program.wait_for_force());
    ASSERT_EQ(kill(program.device, SIGKILL), 0);
    ASSERT_LE(program.until_zero(monotonic_ns()), limit);
    EXPECT_TRUE(program.wait_for_force());
}

TEST_F(HapticdKills, AnErrorOfTheScriptIsReportedWithPlaceAndHint) {
    const auto error_of = [&](const std::string& text) -> std::string {
        std::ofstream(script) << text;
        try {
            DaemonClient client(test::hapticd_program(), "virtual:" + script);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_NE(error_of("{").find("is not JSON"), std::string::npos);
    EXPECT_NE(error_of(R"({"format": "fulcrum-device-script"})").find("has none of left"), std::string::npos);
    EXPECT_NE(
        error_of(
            R"({"format": "fulcrum-device-script", "left": {"path": [{"t": 0, "position": [0, 2, 0]}]}})")
            .find("/left/path/0/position"),
        std::string::npos);
    EXPECT_NE(error_of(R"({"format": "fulcrum-device-script", "lefd": {}})").find("/lefd"),
              std::string::npos);
    EXPECT_THROW(DaemonClient(test::hapticd_program(), "touch"), InputError);
    EXPECT_THROW(DaemonClient((folder / "none").string(), "virtual:" + script), InputError);
    EXPECT_THROW(DaemonClient("/bin/true", "virtual:" + script), InputError);
    EXPECT_THROW(DaemonClient(test::hapticd_program(), "virtual:" + folder.path().string()), InputError);
}

TEST_F(HapticdKills, TheClientReportsWhatHappenedToTheDaemon) {
    std::ofstream(script) << script_text;
    DaemonClient client(test::hapticd_program(), "virtual:" + script);
    EXPECT_EQ(client.poll(), DaemonClient::Health::good);
    const auto wait_for = [&client](DaemonClient::Health wanted) {
        const std::int64_t until = monotonic_ns() + 8'000'000'000;
        while (client.poll() != wanted && monotonic_ns() < until) pause_ns(2'000'000);
        return client.poll() == wanted;
    };
    kill(client.device_process(), SIGKILL);
    EXPECT_TRUE(wait_for(DaemonClient::Health::restarting));
    EXPECT_NE(client.message().words().find("signal 9"), std::string::npos) << client.message().words();
    EXPECT_TRUE(wait_for(DaemonClient::Health::good));
    kill(client.overseer(), SIGSTOP);
    EXPECT_TRUE(wait_for(DaemonClient::Health::silent));
    kill(client.overseer(), SIGCONT);
    EXPECT_TRUE(wait_for(DaemonClient::Health::good));
    kill(client.overseer(), SIGKILL);
    EXPECT_TRUE(wait_for(DaemonClient::Health::ended));
    EXPECT_NE(client.message().words().find("when the next attempt begins"), std::string::npos);
}

TEST_F(HapticdKills, TheDeviceProcessOpensNoSocketAndStartsNoProgram) {
    DaemonClient client(test::hapticd_program(), "virtual:" + script);
    EXPECT_TRUE(test::is_filtered(client.device_process()));
    EXPECT_FALSE(test::is_filtered(getpid())) << "what is not filtered is seen";
}

}  // namespace
}  // namespace fulcrum
