// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/demonstration.h"

#include <QLockFile>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "app/cli/installed_curriculum.h"
#include "app/lab/demonstration_deeds.h"
#include "app/lab/demonstration_plan.h"
#include "app/live/performance.h"
#include "assessment/curriculum/recommendation.h"
#include "database/records/people.h"
#include "database/records/standings.h"
#include "database/rows/packed_bytes.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::app {
namespace {

namespace fs = std::filesystem;
using database::UtcMilliseconds;

constexpr UtcMilliseconds minute = 60000, hour = 60 * minute;
constexpr int utc_offset_min = 60;
constexpr std::uint64_t first_demo_seed = 3'000'000;    // outside what benchmarks and measurements use
constexpr std::uint64_t seeds_of_a_programme = 200000;  // more than its attempts
constexpr int strongest_packing = 19;
// Of each task the first passed attempt from this day on, and of some the first that was failed, keep their
// trace.
constexpr int traces_from_day = 14;
constexpr const char* failed_trace_of[] = {"A2", "B2"};

struct PreparedTask {
    LoadedTask loaded;
    Limits limits;
};

/// What the store holds of a trainee.
struct Practice {
    std::map<std::string, std::int64_t> last;  ///< UTC ms, by task
    std::map<std::string, int> attempts;       ///< by task
    std::map<std::string, std::map<std::string, int>> variants;
    int all = 0;
};

class Builder {
  public:
    explicit Builder(const DemonstrationRequest& request)
        : request_(request),
          folder_(request.output + ".work"),
          now_(folder_ / "now.db"),
          time_(std::make_shared<UtcMilliseconds>(demo_begin)),
          curriculum_(installed_curriculum()) {
        options_.clock = [time = time_] { return *time; };
        for (int day = first_day(); day < demo_days; ++day)
            for (const DemoSession& session : demo_sessions(request.size, day)) planned_ += session.attempts;
    }

    DemonstrationResult build() {
        fs::create_directories(folder_);
        QLockFile lock(QString::fromStdString((folder_ / "lock").string()));
        lock.setStaleLockTime(0);
        if (!lock.tryLock(0))
            throw InputError(folder_.string(), "", "another program works on this demonstration",
                             "wait for its end, or name another file with --output");
        for (int day = resume(); day < demo_days; ++day) {
            if (!simulate(day)) return result_;
            keep(day);
        }
        finish();
        lock.unlock();
        fs::remove_all(folder_);
        return result_;
    }

  private:
    std::uint64_t first_seed() const {
        return first_demo_seed + seeds_of_a_programme * static_cast<std::uint64_t>(request_.size.seed);
    }
    int first_day() const { return demo_days - 7 * request_.size.weeks; }
    fs::path kept(int day) const { return folder_ / ("day-" + std::to_string(day) + ".db"); }
    database::Store open() const { return database::Store::open(now_.string(), options_); }

    void remove_now() const {
        for (const char* suffix : {"", "-wal", "-shm"}) fs::remove(now_.string() + suffix);
    }

    /// The day to go on with; the store is as it was when that day began.
    int resume() {
        require_same_plan();
        remove_now();
        for (int day = demo_days - 1; day >= first_day(); --day) {
            if (!fs::exists(kept(day))) continue;
            fs::copy_file(kept(day), now_);
            return day + 1;
        }
        *time_ = demo_begin + first_day() * demo_day - 3 * demo_day + 9 * hour;
        create();
        return first_day();
    }

    /// Notes the plan where the folder is new.
    void require_same_plan() const {
        const fs::path file = folder_ / "plan";
        const DemoSize& size = request_.size;
        std::string plan =
            std::to_string(size.trainees) + " trainees, " + std::to_string(size.weeks) + " weeks\n";
        if (size.attempts > 0) plan += std::to_string(size.attempts) + " attempts of each\n";
        if (size.seed > 0) plan += "seed " + std::to_string(size.seed) + "\n";
        if (fs::exists(file)) {
            std::ifstream stream(file);
            const std::string found((std::istreambuf_iterator<char>(stream)),
                                    std::istreambuf_iterator<char>());
            if (found != plan)
                throw InputError(
                    folder_.string(), "", "holds the beginning of another plan: " + found,
                    "give the same --trainees, --weeks, --attempts and --seed as before, or delete "
                    "this folder");
            return;
        }
        write_output_file(file.string(), plan);
    }

    void create() const {
        const database::Store store = database::Store::create(now_.string(), true, options_);
        const database::Session station = store.station_session();
        const database::People people(store);
        const auto add = [&](const char* login, const char* name, database::Role role) {
            const std::string id = people.ensure_synthetic(station, login, name).id;
            people.set_demo_roles(station, id, {role});
            return id;
        };
        std::vector<std::string> members, educators;
        for (std::size_t i = 0; i < request_.size.trainees; ++i)
            members.push_back(
                add(demo_trainee(i).login.c_str(), demo_trainee(i).name.c_str(), database::Role::trainee));
        for (const DemoEducator& educator : demo_educators())
            educators.push_back(add(educator.login, educator.name, database::Role::educator));
        add(demo_director, "Prof. Anna Lindgren (synthetic)", database::Role::director);
        people.create_demo_cohort(station, "Autumn course", members, educators);
    }

    /// The state after this day, so that a later run resumes with the next one.
    void keep(int day) const {
        const fs::path half = kept(day).string() + ".half";
        fs::copy_file(now_, half, fs::copy_options::overwrite_existing);
        rename_replacing(half.string(), kept(day).string());
        if (day > first_day()) fs::remove(kept(day - 1));
    }

    /// False: stopped.
    bool simulate(int day) {
        const database::Store store = open();
        *time_ = demo_begin + day * demo_day + 7 * hour;
        shown_.clear();
        count(store);
        for (const DemoSession& session : demo_sessions(request_.size, day)) {
            for (int k = 0; k < session.attempts; ++k) {
                if (!attempt(store, session.trainee, day)) return false;
            }
            *time_ += 20 * minute;
        }
        *time_ = std::max(*time_, demo_begin + day * demo_day + 16 * hour);
        do_deeds(store, request_.size.trainees, day, shown_);
        return true;
    }

    /// What earlier days left.
    void count(const database::Store& store) {
        result_.attempts = result_.traces = 0;
        traces_.clear();
        database::AttemptFilter filter;
        filter.limit = -1;
        for (const database::AttemptSummary& one :
             database::Attempts(store).list(store.station_session(), filter)) {
            ++result_.attempts;
            if (!one.meta.keep_trace) continue;
            ++result_.traces;
            traces_.insert({one.meta.task_id, one.passed.value_or(false)});
        }
    }

    Practice practice_of(const database::Store& store, const std::string& person) const {
        Practice practice;
        database::AttemptFilter filter;
        filter.person_id = person;
        filter.limit = -1;
        for (const database::AttemptSummary& one :
             database::Attempts(store).list(store.station_session(), filter)) {
            const std::string& task = one.meta.task_id;
            practice.last[task] = std::max(practice.last[task], one.meta.started);
            ++practice.attempts[task];
            ++practice.variants[task][one.meta.variant];
            ++practice.all;
        }
        return practice;
    }

    /// What the product recommends, or what the trainee likes to practise of the tasks that are unlocked.
    std::string choose(const database::Store& store, std::size_t trainee, const std::string& person,
                       const Practice& practice) const {
        const PersonRecord record =
            database::Standings(store).record(store.station_session(), person, curriculum_);
        const std::vector<TaskStanding> standings = standing_of(record, *time_);
        std::string chosen = recommend(curriculum_, standings, practice.last, DeviceClass::synthetic).task;
        if (!demo_own_choice(trainee, practice.all)) return chosen;
        std::int64_t longest = *time_;
        for (const TaskStanding& one : standings) {
            const auto last = practice.last.find(one.task);
            const std::int64_t at = last == practice.last.end() ? 0 : last->second;
            if (one.standing == Standing::locked || at >= longest) continue;
            longest = at;
            chosen = one.task;
        }
        return chosen;
    }

    const PreparedTask& prepared(const std::string& task, const std::string& variant) {
        auto& found = tasks_[{task, variant}];
        if (found == nullptr) {
            found = std::make_unique<PreparedTask>();
            found->loaded = load_task_and_scene({task, variant, {}});
            found->limits = limits_for(found->loaded.task, found->loaded.scene, DeviceClass::synthetic);
        }
        return *found;
    }

    bool attempt(const database::Store& store, std::size_t trainee, int day) {
        const DemoTrainee& who = demo_trainee(trainee);
        const std::string person =
            database::People(store).ensure_synthetic(store.station_session(), who.login, who.name).id;
        const Practice practice = practice_of(store, person);
        const std::string task = choose(store, trainee, person, practice);
        const auto count_of = [&](const std::string& id) {
            const auto found = practice.attempts.find(id);
            return found == practice.attempts.end() ? 0 : found->second;
        };
        const auto variants = practice.variants.find(task);
        const PreparedTask& job =
            prepared(task, next_variant(prepared(task, {}).loaded.task, variants == practice.variants.end()
                                                                            ? std::map<std::string, int>()
                                                                            : variants->second));
        PerformRequest request;
        request.loaded = job.loaded;
        request.mastery = demo_mastery(trainee, count_of(task), practice.all - count_of(task), day);
        request.individual = first_seed() + trainee;
        request.seed = first_seed() + 1000 + static_cast<std::uint64_t>(result_.attempts);
        const std::string line = "day " + std::to_string(day + 1) + " of " + std::to_string(demo_days) +
                                 ", " + who.name + ", " + task + " " + job.loaded.scene.variant;
        const auto report = [&](double share) {
            return !request_.progress ||
                   request_.progress(std::min(1.0, (result_.attempts + share) / std::max(1, planned_)), line);
        };
        request.keep_going = [&](double simulated) {
            return report(std::min(0.99, simulated / job.loaded.task.time_limit_s));
        };
        const Performed performed = perform(request, nullptr, job.limits);
        if (performed.outcome.cancelled) return false;
        record(store, job, request, performed, person, day);
        ++result_.attempts;
        *time_ += 2 * minute;
        return report(0);
    }

    bool keeps_trace(const std::string& task, bool passed, int day) const {
        if (day < traces_from_day || traces_.count({task, passed}) != 0) return false;
        return passed || std::find(std::begin(failed_trace_of), std::end(failed_trace_of), task) !=
                             std::end(failed_trace_of);
    }

    void record(const database::Store& store, const PreparedTask& job, const PerformRequest& request,
                const Performed& performed, const std::string& person, int day) {
        database::AttemptMeta meta = attempt_meta(job.loaded, request.seed, AttemptMode::assessed,
                                                  DeviceClass::synthetic, "synthetic operator", job.limits);
        meta.person_id = person;
        meta.curriculum = curriculum_.name();
        meta.operator_name = "learner";
        meta.started = *time_;
        meta.utc_offset_min = utc_offset_min;
        const bool passed = performed.scored.score.passed.value_or(false);
        meta.keep_trace = keeps_trace(meta.task_id, passed, day);
        database::Recorder recorder(store.path(), store.station_session(), meta, options_);
        *time_ += static_cast<UtcMilliseconds>(1000 * performed.scored.duration_s);
        if (meta.keep_trace) {
            append(performed.record, recorder);
            traces_.insert({meta.task_id, passed});
            shown_.push_back({recorder.attempt_id(), meta.task_id, passed, 0.4 * performed.scored.duration_s,
                              *request.mastery, static_cast<std::size_t>(result_.traces++)});
        }
        recorder.finish(attempt_result(performed.scored, performed.outcome, performed.scored.duration_s, 0, 0,
                                       job.limits.name()));
    }

    /// In the order in which they were made.
    static void append(const AttemptRecord& record, database::Recorder& recorder) {
        for (const Event& event : record.events) recorder.append(event);
        for (const StepRecord& step : record.steps) recorder.append(step);
        for (std::size_t i = 0; i < record.samples.size(); ++i) {
            recorder.append(record.inputs[i]);
            recorder.append(record.samples[i]);
        }
    }

    void finish() {
        // The evening of the last Sunday: "the last 12 weeks" are the whole programme.
        *time_ = demo_begin + (demo_days - 1) * demo_day + 20 * hour;
        {
            database::Store store = open();
            count(store);
            store.seal_demo(store.station_session());
        }
        std::ifstream file(now_, std::ios::binary);
        const std::vector<std::uint8_t> bytes((std::istreambuf_iterator<char>(file)),
                                              std::istreambuf_iterator<char>());
        const std::vector<std::uint8_t> packed = database::pack_bytes(bytes, strongest_packing);
        write_output_file(request_.output, {reinterpret_cast<const char*>(packed.data()), packed.size()});
        result_.bytes = bytes.size();
        result_.packed_bytes = packed.size();
        result_.complete = true;
    }

    const DemonstrationRequest& request_;
    fs::path folder_, now_;
    std::shared_ptr<UtcMilliseconds> time_;
    database::StoreOptions options_;
    Curriculum curriculum_;
    std::map<std::pair<std::string, std::string>, std::unique_ptr<PreparedTask>> tasks_;
    std::set<std::pair<std::string, bool>> traces_;  ///< task, passed
    std::vector<ShownAttempt> shown_;                ///< of the day
    DemonstrationResult result_;
    int planned_ = 0;
};

}  // namespace

DemonstrationResult build_demonstration(const DemonstrationRequest& request) {
    return Builder(request).build();
}

}  // namespace fulcrum::app
