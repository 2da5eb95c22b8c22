// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum igtl serve and record: a stored attempt that was sent and recorded gives the metrics of the
// attempt.
#include <gtest/gtest.h>

#include <QProcess>
#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "app/services/program.h"
#include "database/records/attempts.h"
#include "database/records/recorder.h"
#include "database/rows/packed_bytes.h"
#include "sim_core/numerics/input_error.h"
#include "tests/app/igtl/recorded_metrics.h"
#include "tests/app/program_path.h"
#include "tests/support/fake_tracker.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

using test::FakeTracker;

class IgtlCommands : public ::testing::Test {
  protected:
    nlohmann::json run_json(std::vector<std::string> words, int expected = 0) const {
        words.emplace_back("--json");
        std::ostringstream text;
        struct Redirected {
            explicit Redirected(std::ostream& to) : before(std::cout.rdbuf(to.rdbuf())) {}
            ~Redirected() { std::cout.rdbuf(before); }
            std::streambuf* before;
        } const redirected(text);
        EXPECT_EQ(run_command(words), expected) << words[0];
        return nlohmann::json::parse(text.str(), nullptr, false);
    }
    std::string error_of(const std::vector<std::string>& words) const {
        try {
            run_command(words);
        } catch (const InputError& error) {
            return error.what();
        }
        return "no error";
    }
    std::string path(const char* name) const { return (folder_ / name).string(); }
    /// Sends the attempt at this rate and so many times as fast as it was performed, and records it.
    nlohmann::json sent_and_recorded(const std::string& attempt, int rate, const std::string& trace,
                                     int speed, const std::string& events) const {
        QProcess serve;
        serve.setProcessChannelMode(QProcess::MergedChannels);
        serve.start(QString::fromStdString(program_path()),
                    {"igtl", "serve", QString::fromStdString(attempt), "--db",
                     QString::fromStdString(path("store.db")), "--address", "127.0.0.1:0", "--rate",
                     QString::number(rate), "--speed", QString::number(speed)});
        EXPECT_TRUE(serve.waitForStarted());
        QByteArray said;
        while (!said.contains(" as soon as") && serve.waitForReadyRead(20000)) said += serve.readAll();
        const int at = said.indexOf("127.0.0.1:");
        const std::string address = said.mid(at, said.indexOf(' ', at) - at).toStdString();
        nlohmann::json recorded =
            run_json({"igtl", "record", address, "-o", trace, "--events", events, "--seconds", "20"});
        EXPECT_TRUE(serve.waitForFinished(20000));
        EXPECT_EQ(serve.exitCode(), 0) << said.toStdString();
        return recorded;
    }
    std::size_t count_of_events(const std::string& attempt) const {
        const database::Store store = database::Store::open(path("store.db"));
        return database::Attempts(store).read_trace(store.station_session(), attempt).events.size();
    }
    /// Practice that was taken over from a stored attempt after this tick: a second of its movements.
    std::string taken_over(const std::string& source, std::uint32_t origin) const {
        const database::Store store = database::Store::open(path("store.db"));
        const database::Session station = store.station_session();
        const database::Attempts attempts(store);
        database::AttemptMeta meta = attempts.read(station, source).meta;
        meta.id.clear();
        meta.started = 0;
        meta.mode = AttemptMode::practice;
        meta.scene_text = attempts.scene_text(station, source);
        meta.origin.emplace();
        meta.origin->source_id = source;
        meta.origin->tick = origin;
        meta.origin->build = "another build";
        meta.origin->state = database::pack_bytes({1, 2, 3});
        const database::Trace record = attempts.read_trace(station, source);
        database::Recorder recorder(path("store.db"), station, meta);
        for (std::uint32_t i = 0; i < 1000; ++i) {
            RigSample input = record.inputs.at(i);
            TickSample sample = record.samples.at(i);
            input.tick = sample.tick = origin + 1 + i;
            recorder.append(input);
            recorder.append(sample);
        }
        database::AttemptResult result;
        result.state = AttemptState::abandoned;
        result.duration_s = result.wall_s = 1;
        result.state_hash = "00c0ffee00c0ffee";
        recorder.finish(result);
        return recorder.attempt_id();
    }

  private:
    test::OwnFolder folder_;
};

TEST_F(IgtlCommands, AnAttemptThatIsSentAndRecordedGivesTheMetricsOfTheAttempt) {
    const nlohmann::json attempt = run_json({"perform", "A2", "--seed", "7", "--db", path("store.db")});
    const std::string id = attempt["attempt"], trace = path("trace.csv"), events = path("events.csv");
    const auto values =
        static_cast<int>(std::count_if(attempt["metrics"].begin(), attempt["metrics"].end(),
                                       [](const nlohmann::json& row) { return !row["value"].is_null(); }));
    EXPECT_GE(values, 100);
    struct Case {
        int rate;
        double share, precisions;
        std::set<std::string> absent;
    };
    // docs/FORMATS.md, OpenIGTLink, says these.
    for (const Case& one : {Case{1000, 1e-6, 1e-3, {}}, Case{60, 0.06, 2, {"dfdt_max", "tremor"}}}) {
        SCOPED_TRACE(one.rate);
        const nlohmann::json recorded = sent_and_recorded(id, one.rate, trace, 1000, events);
        EXPECT_EQ(recorded["ended_because"], "attempt ended");
        EXPECT_EQ(recorded["left_out"], 0);
        EXPECT_EQ(recorded["wrong_checksums"], 0);
        EXPECT_EQ(recorded["events"], count_of_events(id));
        test::Recorded expected;
        expected.events = true;
        expected.rate = one.rate;
        expected.share = one.share;
        expected.precisions = one.precisions;
        const nlohmann::json read = run_json({"metrics", trace, "--events", events, "--task", "A2"});
        const test::Compared whole = test::compare_metrics(attempt["metrics"], read["metrics"], expected);
        EXPECT_EQ(whole.absent, one.absent);
        if (one.rate == 1000) {
            EXPECT_EQ(whole.values, values) << "every one";
            EXPECT_EQ(read["passed"], attempt["passed"]);
            ASSERT_EQ(read["gates"].size(), attempt["gates"].size());
            for (std::size_t i = 0; i < read["gates"].size(); ++i)
                EXPECT_EQ(read["gates"][i]["passed"], attempt["gates"][i]["passed"]) << i;
        }
        // Without the events: what needs them is absent and says so. These are measured from the first
        // movement on, which is an event.
        const std::set<std::string> from_first_movement = {"horizon_err", "idle", "off_screen"};
        expected.events = false;
        expected.comparable = [&](const MetricDescriptor& metric) {
            return from_first_movement.count(metric.id) == 0;
        };
        const nlohmann::json alone = run_json({"metrics", trace, "--task", "A2"})["metrics"];
        const test::Compared motion = test::compare_metrics(attempt["metrics"], alone, expected);
        for (const std::string& metric : motion.absent)
            EXPECT_TRUE(find_metric(metric)->needs_events || one.absent.count(metric) != 0) << metric;
        EXPECT_GE(motion.values, 60);
    }
}

TEST_F(IgtlCommands, PracticeFromALateMomentIsSentAtOnce) {
    const nlohmann::json attempt = run_json({"perform", "A2", "--seed", "7", "--db", path("store.db")});
    const std::string taken = taken_over(attempt["attempt"].get<std::string>(), 600000);
    const nlohmann::json recorded = sent_and_recorded(taken, 60, path("taken.csv"), 1, path("none.csv"));
    EXPECT_EQ(recorded["ended_because"], "attempt ended");
    EXPECT_TRUE(recorded["events"].is_null()) << "this record has none";
    EXPECT_FALSE(std::ifstream(path("none.csv")).good());
    EXPECT_GE(recorded["samples"], 50);
    EXPECT_NEAR(recorded["duration_s"].get<double>(), 1, 0.1);
    // What is imported lasts as long as it was recorded, whatever its first time.
    const nlohmann::json imported = run_json({"import", path("taken.csv"), "--exercise", "part", "--person",
                                              "external-robot", "--db", path("store.db")});
    const database::Store store = database::Store::open(path("store.db"));
    const database::AttemptSummary stored =
        database::Attempts(store).read(store.station_session(), imported["attempt"].get<std::string>());
    EXPECT_NEAR(stored.duration_s, recorded["duration_s"].get<double>(), 0.1);
}

TEST_F(IgtlCommands, WhatCannotBeRecordedSaysWhyAndWritesNothing) {
    const std::string file = path("t.csv");
    FakeTracker others({"Probe"});
    others.mode = FakeTracker::Mode::garbage;
    EXPECT_NE(error_of({"igtl", "record", others.address(), "-o", file})
                  .find("what it sends is not OpenIGTLink; check that this is the port"),
              std::string::npos);
    others.mode = FakeTracker::Mode::good;
    const std::string names = error_of({"igtl", "record", others.address(), "-o", file, "--seconds", "1"});
    EXPECT_NE(
        names.find("sent no pose of LeftTipToPatient, RightTipToPatient, CameraToPatient, only of Probe; "
                   "name its tools with --left"),
        std::string::npos)
        << names;
    EXPECT_NE(error_of({"igtl", "record", others.address()}).find("-o TRACE.csv"), std::string::npos);
    EXPECT_NE(error_of({"igtl", "record", others.address(), "-o", file, "--events", file})
                  .find("--events: is the file of the trace; name another file"),
              std::string::npos);
    EXPECT_NE(error_of({"igtl", "record", "a b", "-o", file}).find("is not HOST:PORT"), std::string::npos);
    EXPECT_NE(error_of({"igtl", "record", "127.0.0.1:1", "-o", file}).find("no OpenIGTLink server answers"),
              std::string::npos);
    EXPECT_FALSE(std::ifstream(file).good());
}

TEST_F(IgtlCommands, AServerThatGoesAwayLeavesWhatItSent) {
    const std::string file = path("cut.csv");
    auto tracker = std::make_unique<FakeTracker>(std::vector<std::string>{"Probe"}, 0, 200);
    const std::string address = tracker->address();
    std::thread ends([&] {
        while (tracker->frames < 30) std::this_thread::yield();
        tracker->mode = FakeTracker::Mode::wrong_checksum;
        while (tracker->frames < 60) std::this_thread::yield();
        tracker.reset();
    });
    const nlohmann::json recorded =
        run_json({"igtl", "record", address, "-o", file, "--events", path("events.csv"), "--right", "Probe"});
    ends.join();
    EXPECT_EQ(recorded["ended_because"], "the server closed the connection");
    EXPECT_GT(recorded["wrong_checksums"], 0);
    EXPECT_TRUE(recorded["events"].is_null());
    EXPECT_FALSE(std::ifstream(path("events.csv")).good());
    std::ifstream in(file);
    std::string header;
    std::getline(in, header);
    EXPECT_EQ(header, "t,right.px,right.py,right.pz,right.ax,right.ay,right.az");
}

}  // namespace
}  // namespace fulcrum::app
