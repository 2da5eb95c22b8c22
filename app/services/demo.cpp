// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/demo.h"

#include <QCoreApplication>
#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <thread>

#include "app/cli/installed_curriculum.h"
#include "app/live/performance.h"
#include "assessment/assets/assets.h"
#include "database/records/people.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::app {
namespace {

struct Trainee {
    const char *login, *name;
    OperatorLevel level;
};

constexpr Trainee trainees[] = {
    {"demo-amara", "Amara (synthetic)", OperatorLevel::novice},
    {"demo-bjorn", "Björn (synthetic)", OperatorLevel::intermediate},
    {"demo-chiara", "Chiara (synthetic)", OperatorLevel::expert},
};

/// Number of attempts of each trainee at a task: each trainee is a little further in the curriculum than the
/// previous one.
const int* attempts_at(const std::string& stage) {
    static constexpr int first[] = {2, 1, 1}, second[] = {1, 1, 1}, later[] = {0, 0, 1};
    return stage == "A" ? first : stage == "B" ? second : later;
}

struct Job {
    LoadedTask loaded;
    Limits limits;
    std::size_t trainee = 0;
    std::uint64_t seed = 0;
};

/// The longest first, so that the cores finish at about the same time.
std::vector<Job> jobs_of_cohort() {
    std::vector<Job> jobs;
    std::uint64_t seed = 3000;
    for (const std::string& task : task_ids()) {
        const LoadedTask loaded = load_task_and_scene(task);
        const Limits limits = limits_for(loaded.task, loaded.scene, DeviceClass::synthetic);
        const int* attempts = attempts_at(loaded.task.stage);
        for (std::size_t trainee = 0; trainee < std::size(trainees); ++trainee) {
            for (int k = 0; k < attempts[trainee]; ++k) jobs.push_back({loaded, limits, trainee, ++seed});
        }
    }
    std::stable_sort(jobs.begin(), jobs.end(), [](const Job& a, const Job& b) {
        return a.loaded.task.stage != b.loaded.task.stage
                   ? a.loaded.task.stage > b.loaded.task.stage
                   : a.loaded.task.time_limit_s > b.loaded.task.time_limit_s;
    });
    return jobs;
}

/// Simulates and records one attempt. `keep_going` gets the elapsed share of its time limit.
void simulate(const Job& job, const std::string& store_path, const database::Session& station,
              const std::string& person_id, const std::function<bool(double)>& keep_going) {
    PerformRequest request;
    request.loaded = job.loaded;
    request.operator_level = trainees[job.trainee].level;
    request.seed = job.seed;
    request.keep_going = [&](double simulated) {
        return keep_going(simulated / job.loaded.task.time_limit_s);
    };
    database::AttemptMeta meta = attempt_meta(job.loaded, job.seed, AttemptMode::assessed,
                                              DeviceClass::synthetic, "synthetic operator", job.limits);
    meta.person_id = person_id;
    meta.curriculum = installed_curriculum().name();
    meta.operator_name = row_of(operator_levels, *request.operator_level).name;
    database::Recorder recorder(store_path, station, meta);
    perform(request, &recorder, job.limits);
}

/// Simulates all attempts, one thread per core; false if stopped. Throws what an attempt throws.
bool simulate_all(const std::vector<Job>& jobs, const std::string& store_path,
                  const database::Session& station, const std::vector<std::string>& members,
                  const ui::Progress& progress) {
    std::atomic<std::size_t> next{0};
    std::atomic<bool> stopped{false};
    std::mutex lock;
    std::vector<double> done(jobs.size(), 0.0);
    std::exception_ptr trouble;
    const auto report = [&](std::size_t job, double share, const std::string& line) {
        const std::lock_guard<std::mutex> guard(lock);
        done[job] = share;
        double sum = 0;
        for (const double one : done) sum += one;
        if (!progress(sum / static_cast<double>(jobs.size()), line)) stopped = true;
        return !stopped;
    };
    const auto work = [&] {
        for (std::size_t i = next++; i < jobs.size() && !stopped; i = next++) {
            const Job& job = jobs[i];
            const std::string line = QCoreApplication::translate("fulcrum::app::demo", "%1 performs %2")
                                         .arg(QString::fromUtf8(trainees[job.trainee].name),
                                              QString::fromStdString(job.loaded.task.id))
                                         .toStdString();
            try {
                simulate(job, store_path, station, members[job.trainee],
                         [&](double share) { return report(i, std::min(share, 0.99), line); });
                report(i, 1, line);
            } catch (...) {
                const std::lock_guard<std::mutex> guard(lock);
                trouble = std::current_exception();
                stopped = true;
            }
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    if (trouble) std::rethrow_exception(trouble);
    return !stopped;
}

/// Creates the people and their cohort; returns the trainees' ids.
std::vector<std::string> create_people(const database::Store& store, const database::Session& station) {
    const database::People people(store);
    std::vector<std::string> members;
    for (const Trainee& trainee : trainees) {
        members.push_back(people.ensure_synthetic(station, trainee.login, trainee.name).id);
        people.set_demo_roles(station, members.back(), {database::Role::trainee});
    }
    const database::Person educator =
        people.ensure_synthetic(station, "demo-educator", "Educator (synthetic)");
    const database::Person director =
        people.ensure_synthetic(station, "demo-director", "Director (synthetic)");
    people.set_demo_roles(station, educator.id, {database::Role::educator});
    people.set_demo_roles(station, director.id, {database::Role::director});
    people.create_demo_cohort(station, "Demonstration cohort", members, {educator.id});
    return members;
}

void remove_store(const std::string& path) {
    std::error_code ignored;
    for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(path + suffix, ignored);
}

}  // namespace

bool build_demo(const std::string& path, const ui::Progress& progress) {
    const std::string unfinished = path + ".building";
    remove_store(unfinished);
    bool complete = false;
    {
        database::Store store = database::Store::create(unfinished, true);
        const database::Session station = store.station_session();
        const std::vector<std::string> members = create_people(store, station);
        complete = simulate_all(jobs_of_cohort(), store.path(), station, members, progress);
        if (complete) store.seal_demo(station);
    }
    if (complete) {
        remove_store(path);  // an unfinished store of an older program
        rename_replacing(unfinished, path);
    }
    remove_store(unfinished);
    return complete;
}

}  // namespace fulcrum::app
