// SPDX-License-Identifier: GPL-3.0-or-later
// A programme with people in every role, made once a process and copied for each test.
#pragma once

#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include "database/records/attempts.h"
#include "database/records/people.h"
#include "database/records/recorder.h"
#include "database/records/report_data.h"
#include "database/records/reviews.h"
#include "database/store/audit.h"

namespace fulcrum::database::test {

inline constexpr UtcMilliseconds noon = 1795780800000;  // a day in 2026
inline const char* const password = "correct horse battery";

/// Clocks that tests turn by hand: the one that people can set, and the time since the machine was started.
struct ManualClock {
    std::shared_ptr<UtcMilliseconds> time = std::make_shared<UtcMilliseconds>(noon);
    std::shared_ptr<BootTime> since_boot = std::make_shared<BootTime>(BootTime{"first start", 3600 * 1000});
    StoreOptions options() const {
        StoreOptions result;
        result.busy_timeout_ms = 200;
        result.clock = [time = time] { return *time; };
        result.boot_time = [since_boot = since_boot] { return *since_boot; };
        return result;
    }
    void pass_s(double seconds) const {
        set_forward_s(seconds);
        since_boot->ms += static_cast<std::int64_t>(seconds * 1000.0);
    }
    /// Somebody sets the clock.
    void set_forward_s(double seconds) const { *time += static_cast<UtcMilliseconds>(seconds * 1000.0); }
    void restart() const { *since_boot = {since_boot->boot + " and another", 0}; }
};

inline ScoreRow example_score(bool passed, double points) {
    ScoreRow score;
    score.program_version = "0.1.0";
    score.limits = "A2-operators@1";
    score.passed = passed;
    score.points = points;
    score.advice = {StatementId::gate_missed,
                    {{"metric", std::string("f_max")}, {"value", 6.0}, {"limit", 4.0}}};
    score.gates.push_back({"path_len", "left", "", GateKind::benchmark, 812.5, "mm", 900.0, "A2-operators@1",
                           0.7, 61.0, passed, true,
                           passed ? Statement() : Statement(StatementId::no_benchmark)});
    score.gates.push_back(
        {"perforation", "", "", GateKind::absolute, 0.0, "count", 0.0, "safety", {}, {}, true, false, {}});
    score.metrics.push_back({"path_len", 1, "left", "", 812.5, {}, "mm", Direction::lower, {{0.25, 31.5}}});
    score.metrics.push_back({"sparc",
                             2,
                             "right",
                             "",
                             {},
                             {StatementId::few_movements, {{"count", 3.0}, {"least", 5.0}}},
                             "1",
                             Direction::higher,
                             {}});
    return score;
}

inline AttemptMeta example_meta(const std::string& person_id, const std::string& task = "A2") {
    AttemptMeta meta;
    meta.person_id = person_id;
    meta.task_id = task;
    meta.mode = AttemptMode::assessed;
    meta.device_class = DeviceClass::mouse_keyboard;
    meta.device = "mouse and keyboard";
    meta.variant = "standard";
    meta.seed = 0xfedcba9876543210ULL;
    meta.fidelity = "standard";
    meta.scene = "a2_targets.json";
    meta.limits = "A2-operators@1";
    meta.program_version = "0.1.0";
    return meta;
}

inline AttemptResult example_result(bool passed, double points) {
    AttemptResult result;
    result.state = AttemptState::completed;
    result.duration_s = 31.5;
    result.wall_s = 31.6;
    result.state_hash = "00c0ffee00c0ffee";
    result.score = example_score(passed, points);
    return result;
}

class Programme {
  public:
    Programme() {
        const Template& made = made_once();
        path = folder.filePath("fulcrum.db").toStdString();
        std::filesystem::copy_file(made.path, path);
        sessions = made.sessions;
        cohort = made.cohort;
        recovery_code = made.recovery_code;
        open();
    }
    void open() {
        store.reset();
        store = std::make_unique<Store>(Store::open(path, clock.options()));
    }
    const Session& session(const std::string& login) const { return sessions.at(login); }
    const std::string& id(const std::string& login) const { return sessions.at(login).person_id(); }
    People people() const { return People(*store); }
    Attempts attempts() const { return Attempts(*store); }

    /// An error that a program records at the end of that second.
    static Event slip() { return {999, EventKind::slip, 1, 2, 7, 0.5F}; }
    /// A finished attempt of a second's trace, by its own person.
    std::string record(const std::string& login, bool passed = true, double points = 70,
                       const std::string& task = "A2", const std::vector<Event>& errors = {}) const {
        Recorder recorder(path, session(login), example_meta(id(login), task), clock.options());
        append_second(recorder);
        for (const Event& error : errors) recorder.append(error);
        recorder.finish(example_result(passed, points));
        return recorder.attempt_id();
    }
    /// Written by a recorder that never finished; closed as interrupted by the next open().
    std::string record_broken(const std::string& login) const {
        Recorder recorder(path, session(login), example_meta(id(login)), clock.options());
        append_second(recorder);
        recorder.flush();
        return recorder.attempt_id();
    }
    static void append_second(Recorder& recorder, std::uint32_t from = 0) {
        for (std::uint32_t tick = from; tick < from + 1000; ++tick) {
            RigSample input;
            input.tick = tick;
            input.hand[0].handle[0] = static_cast<std::int32_t>(tick * 3);
            recorder.append(input);
            TickSample sample;
            sample.tick = tick;
            sample.hand[1].tip[2] = -static_cast<std::int32_t>(tick * tick % 977);
            recorder.append(sample);
            if (tick % 5 == 4) recorder.append(StepRecord{tick / 5, tick - 4, tick, 0, tick});
            if (tick % 250 == 0) recorder.append(Event{tick, EventKind::grasp, 1, 2, 7, 0.5F});
        }
    }

    QTemporaryDir folder;
    std::string path, cohort, recovery_code;
    ManualClock clock;
    std::unique_ptr<Store> store;
    std::map<std::string, Session>
        sessions;  ///< administrator, director, educator, other_educator, ann, ben, eve

  private:
    struct Template {
        QTemporaryDir folder;
        std::string path, cohort, recovery_code;
        std::map<std::string, Session> sessions;
    };
    static const Template& made_once() {
        static const std::unique_ptr<Template> made = [] {
            auto result = std::make_unique<Template>();
            result->path = result->folder.filePath("template.db").toStdString();
            const ManualClock clock;
            {
                Store store = Store::create(result->path, false, clock.options());
                const People people(store);
                CreatedProgramme programme =
                    people.create_programme("Test programme", "administrator", "Ada Min", password);
                result->recovery_code = programme.recovery_code;
                const Session administrator = programme.administrator;
                result->sessions.emplace("administrator", administrator);
                const auto add = [&](const char* login, const char* name, const std::vector<Role>& roles) {
                    const People::Created created = people.create(administrator, login, name, roles);
                    const Session first = people.sign_in(login, created.one_time_password);
                    result->sessions.emplace(
                        login, people.change_password(first, created.one_time_password, password));
                };
                add("director", "Dora Rector", {Role::director});
                add("educator", "Edu Cator", {Role::educator});
                add("other_educator", "Otto Cator", {Role::educator});
                add("ann", "Ann Trainee", {Role::trainee});
                add("ben", "Ben Trainee", {Role::trainee});
                add("eve", "Eve Elsewhere", {Role::trainee});
                const Session& director = result->sessions.at("director");
                result->cohort = people.create_cohort(director, "Year 1");
                people.set_members(
                    director, result->cohort,
                    {result->sessions.at("ann").person_id(), result->sessions.at("ben").person_id()});
                people.set_educators(director, result->cohort, {result->sessions.at("educator").person_id()});
                result->sessions.emplace("station", store.station_session());
            }
            return result;
        }();
        return *made;
    }
};

/// The kind of StoreError that `call` throws; fails the test if it throws none.
template <typename Call>
StoreErrorKind error_kind(Call&& call) {
    try {
        call();
    } catch (const StoreError& error) {
        EXPECT_FALSE(error.problem().empty());
        EXPECT_FALSE(error.hint().empty());
        return error.kind();
    }
    ADD_FAILURE() << "no StoreError was thrown";
    return StoreErrorKind::failed;
}

}  // namespace fulcrum::database::test
