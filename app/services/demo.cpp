// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/demo.h"

#include <filesystem>

#include "app/assets.h"
#include "app/live/performance.h"
#include "database/records/people.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::app {
namespace {

struct Trainee {
    const char *login, *name, *preset;
};

constexpr Trainee trainees[] = {
    {"demo-amara", "Amara (synthetic)", "novice"},
    {"demo-bjorn", "Björn (synthetic)", "intermediate"},
    {"demo-chiara", "Chiara (synthetic)", "expert"},
};

void remove_store(const std::string& path) {
    std::error_code ignored;
    for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(path + suffix, ignored);
}

}  // namespace

bool build_demo(const std::string& path, const ui::Progress& progress) {
    const std::string unfinished = path + ".building";
    remove_store(unfinished);
    const std::vector<std::string> tasks = task_ids();
    const auto attempts_of = [](const std::string& task) { return task == "A2" ? 3 : 1; };
    double total = 0, done = 0;
    for (const std::string& task : tasks)
        total += attempts_of(task) * static_cast<double>(std::size(trainees));
    bool stopped = false;
    {
        database::Store store = database::Store::create(unfinished, true);
        const database::Session station = store.station_session();
        const database::People people(store);
        std::vector<std::string> members;
        for (const Trainee& trainee : trainees)
            members.push_back(people.ensure_synthetic(station, trainee.login, trainee.name).id);
        const database::Person educator =
            people.ensure_synthetic(station, "demo-educator", "Educator (synthetic)");
        const database::Person director =
            people.ensure_synthetic(station, "demo-director", "Director (synthetic)");
        for (const std::string& id : members) people.set_demo_roles(station, id, {database::Role::trainee});
        people.set_demo_roles(station, educator.id, {database::Role::educator});
        people.set_demo_roles(station, director.id, {database::Role::director});
        people.create_demo_cohort(station, "Demonstration cohort", members, {educator.id});

        std::uint64_t seed = 3000;
        for (const std::string& task : tasks) {
            const std::optional<BenchmarkSet> benchmark = benchmark_in_force(task);
            for (std::size_t i = 0; i < std::size(trainees) && !stopped; ++i) {
                for (int k = 0; k < attempts_of(task) && !stopped; ++k) {
                    PerformRequest request;
                    request.loaded = load_task_and_scene(task);
                    request.operator_name = trainees[i].preset;
                    request.seed = ++seed;
                    const std::string line = std::string(trainees[i].name) + " performs " + task;
                    request.keep_going = [&](double) {
                        return stopped = !progress(done / total, line), !stopped;
                    };
                    if (!progress(done / total, line)) {
                        stopped = true;
                        break;
                    }
                    database::AttemptMeta meta =
                        attempt_meta(request.loaded, seed, "assessed", "synthetic", "synthetic operator",
                                     benchmark ? &*benchmark : nullptr);
                    meta.person_id = members[i];
                    meta.operator_name = request.operator_name;
                    database::Recorder recorder(store.path(), station, meta);
                    perform(request, &recorder, benchmark ? &*benchmark : nullptr);
                    ++done;
                }
            }
        }
        if (!stopped) store.seal_demo(station);
    }
    if (stopped) {
        remove_store(unfinished);
        return false;
    }
    remove_store(path);  // what an older program left unfinished
    rename_replacing(unfinished, path);
    remove_store(unfinished);
    return true;
}

}  // namespace fulcrum::app
