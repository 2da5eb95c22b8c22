// SPDX-License-Identifier: GPL-3.0-or-later
// An attempt of the window, in real time, that another program listens to; and instruments that another
// program tracks, in an attempt of the window.
#include <gtest/gtest.h>

#include <QProcess>
#include <QSettings>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/cli/attempt_document.h"
#include "app/igtl/wire_frame.h"
#include "app/services/application.h"
#include "assessment/operators/operator.h"
#include "database/scoring/loaded_task.h"
#include "sim_core/devices/device_page.h"
#include "tests/app/igtl/recorded_metrics.h"
#include "tests/app/program_path.h"
#include "tests/database/programme_fixture.h"
#include "tests/support/fake_tracker.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

struct SetVariable {
    SetVariable(const char* name_in, const std::string& value) : name(name_in) {
        setenv(name, value.c_str(), 1);
    }
    ~SetVariable() { unsetenv(name); }
    const char* name;
};

/// Waits at most 10 s, as the window does.
template <typename Holds>
bool attempt_until(ui::AttemptSession& attempt, Holds&& holds) {
    const std::int64_t last = monotonic_ns() + 10'000'000'000;
    while (!holds()) {
        if (monotonic_ns() > last) return false;
        attempt.update();
        usleep(2000);
    }
    return true;
}

TEST(LiveIgtl, AnAttemptIsSentWhileItRunsAndTheWindowShowsTheReceivers) {
    const test::OwnFolder folder;
    const SetVariable address("FULCRUM_OPENIGTLINK", "127.0.0.1:0");
    const auto services = make_services(folder.path().string());
    services->open_store(false);
    const ui::SendingState state = services->sending();
    ASSERT_TRUE(state.trouble.empty()) << state.trouble.words();
    EXPECT_TRUE(state.fixed);
    services->choose_sending(false);  // the variable decides
    EXPECT_TRUE(services->sending().wanted);
    igtl::Connection connection(igtl::parse_address(state.address, "test"), 2000);
    auto attempt = services->start_demonstration(services->store()->station_session(), "A2");
    ASSERT_TRUE(attempt_until(*attempt, [&] { return attempt->phase() == ui::AttemptPhase::ready; }));
    attempt->start();
    igtl::Decoder decoder;
    TraceRecording recording;
    bool ended = false;
    const auto listen = [&] {
        connection.read_into(decoder);
        igtl::Message message;
        while (decoder.next(message) == igtl::Decoder::Found::message)
            ended = recording.take(message) == TraceRecording::Took::end || ended;
    };
    EXPECT_TRUE(attempt_until(*attempt, [&] {
        listen();
        return recording.rows() >= 40;
    }));
    EXPECT_EQ(services->sending().clients, 1U);
    attempt.reset();
    const std::int64_t last = monotonic_ns() + 5'000'000'000;
    while (!ended && monotonic_ns() < last) {
        connection.wait(10);
        listen();
    }
    EXPECT_TRUE(ended);
    const Trace trace = recording.finish();
    EXPECT_EQ(recording.left_out(), 0U);
    const double rate = static_cast<double>(trace.t.size() - 1) / (trace.t.back() - trace.t.front());
    EXPECT_GT(rate, 10) << "60 where the machine has time";
    EXPECT_LT(rate, 70);
    EXPECT_TRUE(trace.hand[0].has(Channel::force));
    EXPECT_TRUE(trace.camera.recorded());
}

nlohmann::json printed_by(QProcess& program) {
    EXPECT_TRUE(program.waitForFinished(60000));
    EXPECT_EQ(program.exitCode(), 0) << program.readAllStandardError().toStdString();
    return nlohmann::json::parse(program.readAllStandardOutput().toStdString(), nullptr, false);
}
nlohmann::json printed_by(const QStringList& words) {
    QProcess program;
    program.start(program_path(), words);
    return printed_by(program);
}
std::string text_of_file(const QString& path) {
    std::ifstream file(path.toStdString());
    return {std::istreambuf_iterator<char>(file), {}};
}

/// An attempt of three seconds at A2 that a program records from its begin to its end.
struct RecordedAttempt {
    RecordedAttempt() {
        programme.store.reset();
        const SetVariable address("FULCRUM_OPENIGTLINK", "127.0.0.1:0");
        const auto services = make_services(programme.folder.path().toStdString());
        services->open_store(false);
        QProcess record;
        record.start(program_path(),
                     {"igtl", "record", QString::fromStdString(services->sending().address), "-o",
                      path("trace.csv"), "--events", path("events.csv"), "--seconds", "60", "--json"});
        perform(*services);
        if (id.empty()) {
            record.kill();
            record.waitForFinished();
            return;
        }
        document = printed_by(record);
        const database::Session ann = programme.session("ann");
        events = database::Attempts(*services->store()).read_trace(ann, id).events.size();
        export_trace(*services->store(), ann, id, path("stored").toStdString());
    }
    void perform(ui::ApplicationServices& services) {
        const LoadedTask loaded = load_task_and_scene("A2");
        ui::AttemptRequest request{programme.session("ann"),
                                   "A2",
                                   false,
                                   7,
                                   make_operator(OperatorLevel::expert, loaded.task, loaded.scene, 7),
                                   ui::window_device,
                                   "mouse and keyboard",
                                   false,
                                   nullptr,
                                   0,
                                   false,
                                   {}};
        const auto attempt = services.start_attempt(request);
        ASSERT_TRUE(attempt_until(*attempt, [&] {
            return attempt->phase() == ui::AttemptPhase::ready && services.sending().clients == 1;
        }));
        attempt->start();
        ASSERT_TRUE(attempt_until(*attempt, [&] { return attempt->health().ticks >= 3000; }));
        attempt->abandon();
        ASSERT_TRUE(attempt_until(*attempt, [&] { return attempt->outcome().has_value(); }));
        id = attempt->outcome()->attempt_id;
    }
    QString path(const char* name) const { return programme.folder.filePath(QString::fromLatin1(name)); }
    /// As fulcrum import measures it.
    nlohmann::json imported(const char* trace, const char* exercise) const {
        return printed_by({"import", path(trace), "--exercise", exercise, "--person", "external-robot",
                           "--db", QString::fromStdString(programme.path), "--json"});
    }
    database::test::Programme programme;
    nlohmann::json document;  ///< of fulcrum igtl record
    std::string id;
    std::size_t events = 0;  ///< that are stored
};

TEST(LiveIgtl, AnAttemptOfTheWindowThatIsRecordedAndImportedIsMeasuredAsItself) {
    const RecordedAttempt attempt;
    ASSERT_FALSE(attempt.id.empty());
    EXPECT_EQ(attempt.document["ended_because"], "attempt ended");
    EXPECT_EQ(attempt.document["left_out"], 0);
    EXPECT_EQ(attempt.document["events"], attempt.events);
    const std::string events = text_of_file(attempt.path("events.csv"));
    EXPECT_EQ(events, text_of_file(attempt.path("stored/events.csv"))) << "the same file, with the seed";
    EXPECT_NE(events.find(",abandoned,"), std::string::npos);

    const nlohmann::json recorded = attempt.imported("trace.csv", "recorded");
    const nlohmann::json stored = attempt.imported("stored/trace.csv", "stored");
    EXPECT_FALSE(recorded["attempt"].is_null());
    test::Recorded expected;
    expected.rate = recorded["mean_rate_hz"];
    EXPECT_GT(expected.rate, 10) << "60 where the machine has time";
    // Of three seconds, with the rate that the machine has time for, these are measured well; of every other
    // metric it is asked only why it is absent.
    const bool often = expected.rate > 40 && recorded["gaps"].empty();
    const std::set<std::string> measured = {"time", "path_len", "ang_path", "speed_mean"};
    expected.share = 0.03;
    expected.precisions = 2;
    expected.comparable = [&](const MetricDescriptor& metric) {
        return expected.rate < metric.minimum_rate * 0.999 || (often && measured.count(metric.id) != 0);
    };
    const test::Compared whole = test::compare_metrics(stored["metrics"], recorded["metrics"], expected);
    std::set<std::string> need_events;
    for (const nlohmann::json& row : recorded["metrics"])
        if (test::absence_of(row) == "metric.no_events") need_events.insert(row["id"].get<std::string>());
    std::set<std::string> known;
    for (const nlohmann::json& row : stored["metrics"])
        if (find_metric(row["id"].get<std::string>())->needs_events)
            known.insert(row["id"].get<std::string>());
    EXPECT_EQ(need_events, known) << "a trace alone has no events, and says so of each that needs them";
    EXPECT_GT(known.size(), 10U);

    // With its events, against what is stored with the attempt.
    const nlohmann::json score = nlohmann::json::parse(text_of_file(attempt.path("stored/attempt.json")));
    const nlohmann::json read = printed_by({"metrics", attempt.path("trace.csv"), "--events",
                                            attempt.path("events.csv"), "--task", "A2", "--json"});
    expected.events = true;
    const test::Compared judged = test::compare_metrics(score["metrics"], read["metrics"], expected);
    for (const nlohmann::json& row : read["metrics"])
        EXPECT_NE(test::absence_of(row), "metric.no_events") << row["id"];
    if (often) {
        EXPECT_EQ(judged.equal.count("path_len"), 1U);
        EXPECT_EQ(whole.equal, measured);
    }
}

TEST(LiveIgtl, APortInUseIsReportedAndAttemptsContinueWithoutSending) {
    const test::OwnFolder folder;
    const igtl::Server other({"127.0.0.1", 0});
    const SetVariable address("FULCRUM_OPENIGTLINK", "127.0.0.1:" + std::to_string(other.port()));
    const auto services = make_services(folder.path().string());
    EXPECT_NE(services->sending().trouble.words().find("cannot be served"), std::string::npos);
    EXPECT_TRUE(services->sending().address.empty());
    services->open_store(false);
    const auto attempt = services->start_demonstration(services->store()->station_session(), "A2");
    EXPECT_TRUE(attempt_until(*attempt, [&] { return attempt->phase() == ui::AttemptPhase::ready; }));
}

TEST(LiveIgtl, TrackedInstrumentsMoveAnAttemptWhichPausesWhereTheTrackerStops) {
    const test::OwnFolder folder;
    test::FakeTracker tracker({"LeftTipToPatient", "RightTipToPatient"});
    const std::string program = program_path();
    const SetVariable daemon("FULCRUM_HAPTICD",
                             program.substr(0, program.find_last_of('/')) + "/fulcrum-hapticd");
    const SetVariable device("FULCRUM_DEVICE", "openigtlink:" + tracker.address());
    const auto services = make_services(folder.path().string());
    services->open_store(false);
    EXPECT_EQ(services->device_in_use().device_class, DeviceClass::tracked);
    const auto session = services->store()->station_session();
    const TaskDefinition& a2 = *std::find_if(services->tasks().begin(), services->tasks().end(),
                                             [](const TaskDefinition& task) { return task.id == "A2"; });
    struct Still : Rig {
        void read(std::uint32_t, RigSample&) override {}
        void write_force(Hand, const Vector3&) override {}
        bool has_force(Hand) const override { return false; }
        double damping(Hand) const override { return -1; }
    };
    const auto rig = services->hands(services->scene_for(a2), std::make_shared<Still>());
    EXPECT_EQ(services->device_in_use().title, "OpenIGTLink " + tracker.address());
    const auto left = [&] {
        RigSample sample;
        rig->read(1, sample);
        return sample.hand[0];
    };
    const std::int64_t limit = monotonic_ns() + 8'000'000'000;
    const DeviceSample before = left();
    igtl::Pose pose;
    pose.place = Vector3(0.01, 0.005, 0);
    tracker.move(0, pose);
    while (left().handle[1] - before.handle[1] < 49'990 && monotonic_ns() < limit) usleep(1000);
    const DeviceSample moved = left();
    EXPECT_NEAR(moved.handle[0] - before.handle[0], -100'000, 300)
        << "to the right is -x of the trocar's frame";
    EXPECT_NEAR(moved.handle[1] - before.handle[1], 50'000, 300);
    EXPECT_EQ(moved.present, 1);
    tracker.mode = test::FakeTracker::Mode::silent;
    while (left().present == 1 && monotonic_ns() < limit) usleep(1000);
    EXPECT_EQ(left().present, 0);
    EXPECT_NEAR(left().handle[1], moved.handle[1], 300) << "it stays where it was";
    while (services->device_trouble().empty() && monotonic_ns() < limit) usleep(1000);
    EXPECT_NE(services->device_trouble().words().find("sends no pose"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::app
