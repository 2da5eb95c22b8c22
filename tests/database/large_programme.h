// SPDX-License-Identifier: GPL-3.0-or-later
// A cohort of many trainees with scored attempts, the same for the same seed. Written as rows in one
// transaction: a password for each person would take longer than all the rest.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "database/records/people.h"
#include "database/rows/connection.h"
#include "database/store/score_rows.h"
#include "sim_core/numerics/random.h"

namespace fulcrum::database::test {

struct LargeProgramme {
    Session director;
    std::string cohort;
};

/// `metrics` rows a score; attempts are spread over the tasks and four weeks. `change` may write another
/// score.
inline LargeProgramme make_large_programme(const Store& store, int trainees, int attempts_each, int metrics,
                                           std::uint64_t seed,
                                           const std::vector<std::string>& tasks = {"A2", "B1"},
                                           const std::function<void(ScoreRow&, Random&)>& change = {},
                                           int task_version = 1) {
    const char* const password = "correct horse battery";
    const People people(store);
    const Session administrator =
        people.create_programme("Department of Surgery", "administrator", "Ada Min", password).administrator;
    const People::Created created = people.create(administrator, "director", "Dora Rector", {Role::director});
    const Session director = people.change_password(people.sign_in("director", created.one_time_password),
                                                    created.one_time_password, password);
    LargeProgramme made{director, people.create_cohort(director, "Everyone")};
    const Session station = store.station_session();
    Connection& connection = store.connection();
    Random random(seed);
    Transaction transaction(connection);
    for (int i = 0; i < trainees; ++i) {
        const std::string number = std::to_string(1000 + i), id = "trainee-" + number;
        Query(connection,
              "INSERT INTO person (id, login, login_key, display_name, kind, created) VALUES (?, ?, ?, ?, "
              "'real', ?)")
            .bind(id)
            .bind("trainee" + number)
            .bind("trainee" + number)
            .bind("Trainee " + number)
            .bind(store.now())
            .run();
        Query(connection, "INSERT INTO person_role (person_id, role) VALUES (?, 'trainee')").bind(id).run();
        Query(connection, "INSERT INTO cohort_member (cohort_id, person_id) VALUES (?, ?)")
            .bind(made.cohort)
            .bind(id)
            .run();
        const double talent = random.uniform(0, 20);
        for (int a = 0; a < attempts_each; ++a) {
            const std::string attempt = id + "-" + std::to_string(a);
            const std::string& task = tasks[static_cast<std::size_t>(a) % tasks.size()];
            const double points = std::min(100.0, 30 + talent + 4 * a + random.uniform(0, 15));
            Query(connection,
                  "INSERT INTO attempt (id, person_id, station_id, task_id, task_version, mode, "
                  "device_class, device, "
                  "operator_name, variant, seed, fidelity, scene, scene_digest, curriculum, limits, "
                  "program_version, "
                  "cpu_features, started, utc_offset_min, state, duration_s) VALUES (?, ?, ?, ?, ?, "
                  "'assessed', 'haptic', "
                  "'stylus', '', 'standard', 1, 'standard', 'scene', '', '', ?, '0.1.0', '', ?, 60, "
                  "'completed', ?)")
                .bind(attempt)
                .bind(id)
                .bind(store.station_id())
                .bind(task)
                .bind(task_version)
                .bind(task + "-operators@1")
                .bind(store.now() - (attempts_each - a) * std::int64_t{86'400'000})
                .bind(120 - points)
                .run();
            ScoreRow score;
            score.program_version = "0.1.0";
            score.limits = task + "-operators@1";
            score.passed = points > 60;
            score.points = points;
            // As many as a task of the programme has on average.
            for (int gate = 0; gate < 9; ++gate)
                score.gates.push_back({gate == 0 ? "time" : "metric_" + std::to_string(gate),
                                       "",
                                       "",
                                       GateKind::benchmark,
                                       120 - points,
                                       "s",
                                       60.0,
                                       "operators",
                                       0.5,
                                       points,
                                       *score.passed,
                                       false,
                                       {}});
            for (const char* folder : {"tasks/", "scenes/", "benchmarks/"})
                Query(connection, "INSERT INTO attempt_asset (attempt_id, file, digest) VALUES (?, ?, ?)")
                    .bind(attempt)
                    .bind(folder + task + ".json")
                    .bind("0123456789abcdef0123456789abcdef0123456789abcdef0123456789abcdef")
                    .run();
            for (int m = 0; m < metrics; ++m) {
                score.metrics.push_back({"metric_" + std::to_string(m),
                                         1,
                                         m % 2 == 0 ? "left" : "right",
                                         "",
                                         random.uniform(0, 100),
                                         {},
                                         "mm",
                                         Direction::lower,
                                         {{1.0, 2.0}}});
            }
            if (change) change(score, random);
            write_score(store, station, attempt, score);
        }
    }
    transaction.commit();
    return made;
}

}  // namespace fulcrum::database::test
