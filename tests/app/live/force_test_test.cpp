// SPDX-License-Identifier: GPL-3.0-or-later
// The force test through the daemon, with its virtual device: gentle, along each axis, and over at once when
// it is stopped, its owner is gone or the device process is killed.
#include "app/live/force_test.h"

#include <gtest/gtest.h>
#include <signal.h>

#include <cmath>
#include <fstream>

#include "tests/app/program_path.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/allocation_count.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app::program_test {
namespace {

class ForceTestOfTheDaemon : public ::testing::Test {
  protected:
    ForceTestOfTheDaemon() {
        std::ofstream(script) << R"({"format": "fulcrum-device-script", "title": "two hands",
            "force": {"damping": 0.5, "peak": 3.3, "continuous": 0.88}, "repeat": true,
            "left": {"path": [{"t": 0, "position": [0, 0, 0]}], "hand": {"mass": 0.2}},
            "right": {"path": [{"t": 0, "position": [0, 0, 0]}], "hand": {"mass": 0.2}}})";
        const std::string program = program_path();
        client = std::make_shared<DaemonClient>(
            program.substr(0, program.find_last_of('/')) + "/fulcrum-hapticd", "virtual:" + script);
    }
    double rendered(int hand) const {
        ForceReport report;
        if (!client->state().report[hand].read(report)) return -1;
        return std::hypot(std::hypot(report.force[0], report.force[1]), report.force[2]);
    }
    fulcrum::test::OwnFolder own;
    std::string script = (own / "hands.json").string();
    std::shared_ptr<DaemonClient> client;
};

TEST(GentleForces, RiseFromNothingAlongEachAxisAndBack) {
    double before = 0;
    bool seen[3] = {};
    for (double time = 0; time < 3; time += 0.001) {
        const GentleForce now = gentle_force(time, 0.3);
        EXPECT_LE(now.size, 0.3);
        EXPECT_GE(now.size, 0);
        EXPECT_LT(std::abs(now.size - before), 0.001) << "no step, " << time;
        before = now.size;
        if (now.size > 0.29) seen[now.axis] = true;
    }
    EXPECT_TRUE(seen[0] && seen[1] && seen[2]);
}

TEST_F(ForceTestOfTheDaemon, RendersAGentleForceToEachHandAndEndsWithNone) {
    ForceTest test(client);
    bool hands[2] = {}, axes[3] = {};
    double largest = 0, first_round = 0;
    while (test.runs()) {
        usleep(2000);
        client->poll();
        test.keep();
        for (int h = 0; h < 2; ++h) {
            const double now = rendered(h);
            largest = std::max(largest, now);
            if (now > 0.05) hands[h] = true;
        }
        if (test.progress() < 0.2) first_round = std::max({first_round, rendered(0), rendered(1)});
        axes[test.axis()] = true;
        ASSERT_LE(test.progress(), 1);
    }
    EXPECT_TRUE(hands[0] && hands[1]);
    EXPECT_TRUE(axes[0] && axes[1] && axes[2]);
    EXPECT_GT(first_round, 0.05);
    EXPECT_LT(first_round, 0.101) << "it begins with less";
    EXPECT_GT(largest, 0.25);
    EXPECT_LT(largest, 0.301);
    EXPECT_NEAR(test.rendered(), largest, 0.03);
    EXPECT_EQ(test.asked(), 0);
    EXPECT_EQ(rendered(0), 0);
    EXPECT_EQ(rendered(1), 0);
}

TEST_F(ForceTestOfTheDaemon, IsOverWithin50MillisecondsOfBeingStopped) {
    double worst = 0;
    for (int i = 0; i < 5; ++i) {
        ForceTest test(client);
        ASSERT_TRUE(fulcrum::test::until([&] { return rendered(0) > 0.03 + 0.01 * i; }));
        const std::int64_t begin = monotonic_ns();
        test.stop();
        ASSERT_TRUE(fulcrum::test::until([&] { return rendered(0) == 0; }));
        worst = std::max(worst, 1e-6 * static_cast<double>(monotonic_ns() - begin));
        EXPECT_FALSE(test.runs());
    }
    EXPECT_LT(worst, 50);
    RecordProperty("force_0_after_ms", std::to_string(worst));
    std::printf("force 0 at most %.1f ms after the stop\n", worst);
}

TEST_F(ForceTestOfTheDaemon, AllocatesNothingWhileItRuns) {
    ForceTest test(client);
    ASSERT_TRUE(fulcrum::test::until([&] { return rendered(0) > 0.02; }));
    const std::size_t before = fulcrum::test::allocation_count();
    usleep(500000);
    EXPECT_EQ(fulcrum::test::allocation_count(), before);
    EXPECT_TRUE(test.runs());
}

TEST_F(ForceTestOfTheDaemon, IsOverWhenTheWindowDoesNotWork) {
    ForceTest test(client);
    const std::int64_t begin = monotonic_ns();
    ASSERT_TRUE(fulcrum::test::until([&] { return rendered(0) > 0.05; }));
    ASSERT_TRUE(fulcrum::test::until([&] { return !test.runs(); }));
    EXPECT_LT(monotonic_ns() - begin, 2'500'000'000);
    EXPECT_EQ(rendered(0), 0);
}

TEST_F(ForceTestOfTheDaemon, IsOverWhenTheDeviceProcessIsKilled) {
    ForceTest test(client);
    ASSERT_TRUE(fulcrum::test::until([&] { return rendered(0) > 0.05; }));
    kill(client->device_process(), SIGKILL);
    const std::int64_t begin = monotonic_ns();
    ASSERT_TRUE(fulcrum::test::until([&] { return rendered(0) == 0; }));
    EXPECT_LT(monotonic_ns() - begin, 50'000'000);
    test.stop();
    EXPECT_FALSE(test.runs());
}

}  // namespace
}  // namespace fulcrum::app::program_test
