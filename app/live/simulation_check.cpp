// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/simulation_check.h"

#include <algorithm>
#include <chrono>
#include <random>

#include "app/live/performance.h"
#include "assessment/attempt/engine_state.h"
#include "assessment/metrics/version.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/number_text.h"
#include "sim_core/telemetry/event_types.h"

namespace fulcrum::app {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double progress_every_s = 0.1;  // steps of the world are far more frequent

/// The stored metrics and a recomputation from the stored record: the same numbers to the last bit, the same
/// absences.
bool same_metrics(const std::vector<database::MetricRow>& stored,
                  const std::vector<database::MetricRow>& again) {
    if (stored.size() != again.size()) return false;
    for (std::size_t i = 0; i < stored.size(); ++i) {
        const database::MetricRow &a = stored[i], &b = again[i];
        if (a.id != b.id || a.hand != b.hand || a.tissue != b.tissue ||
            a.value.has_value() != b.value.has_value())
            return false;
        if (a.value && *a.value != *b.value) return false;
    }
    return true;
}

/// A newer metric gives other numbers for the same record.
bool same_versions(const std::vector<database::MetricRow>& stored,
                   const std::vector<database::MetricRow>& again) {
    if (stored.size() != again.size()) return false;
    for (std::size_t i = 0; i < stored.size(); ++i)
        if (stored[i].id != again[i].id || stored[i].version != again[i].version) return false;
    return true;
}

std::vector<Event> simulated_kinds(const std::vector<Event>& events) {
    std::vector<Event> kept;
    for (const Event& event : events)
        if (is_from_simulation(event.kind)) kept.push_back(event);
    return kept;
}

bool same_event(const Event& a, const Event& b) {
    return a.tick == b.tick && a.kind == b.kind && a.hand == b.hand && a.tissue == b.tissue &&
           a.detail == b.detail && a.value == b.value;
}

bool same_events(const std::vector<Event>& recorded, const std::vector<Event>& again) {
    const std::vector<Event> left = simulated_kinds(recorded), right = simulated_kinds(again);
    return left.size() == right.size() && std::equal(left.begin(), left.end(), right.begin(), same_event);
}

/// The files that decide what is simulated are as they were.
bool same_files(const std::vector<database::AssetFile>& then, const std::vector<database::AssetFile>& now) {
    for (const database::AssetFile& file : now) {
        if (file.name.rfind("tasks/", 0) != 0) continue;  // the scene is in the record
        for (const database::AssetFile& old : then)
            if (old.name == file.name && old.digest != file.digest) return false;
    }
    return true;
}

std::vector<std::string> chosen(std::vector<std::string> ids, const SimulationSample& sample) {
    std::mt19937_64 numbers(sample.seed);
    const std::size_t wanted = std::min(ids.size(), static_cast<std::size_t>(sample.attempts));
    for (std::size_t i = 0; i < wanted; ++i)
        std::swap(ids[i], ids[i + static_cast<std::size_t>(numbers() % (ids.size() - i))]);
    ids.resize(wanted);
    return ids;
}

void describe(const std::string& id, const ReplayVerdict& verdict, database::CheckItem& item) {
    if (!verdict.outcome.identical) {
        item.problems.push_back(
            {QT_TRANSLATE_NOOP("errors", "attempt %1: its record is not what its inputs give, from %2 s on"),
             id, decimal_text(verdict.outcome.first_divergence_s, 3)});
        return;
    }
    if (!verdict.complete) return;
    if (!verdict.hash_identical)
        item.problems.push_back(
            {QT_TRANSLATE_NOOP("errors", "attempt %1: it ends in another state than the store has of it"),
             id});
    if (!verdict.events_identical)
        item.problems.push_back(
            {QT_TRANSLATE_NOOP("errors", "attempt %1: its events are not those that its inputs give"), id});
    if (verdict.score_differs)
        item.problems.push_back(
            {QT_TRANSLATE_NOOP("errors", "attempt %1: its score is not what its record gives"), id});
}

}  // namespace

ReplayVerdict verify_replay(const LoadedTask& loaded, const database::AttemptSummary& summary,
                            database::Trace trace, const std::vector<std::uint8_t>& start,
                            const std::optional<database::ScoreRow>& score,
                            const std::function<bool()>& keep_going) {
    const AttemptRecord record{std::move(trace.inputs), std::move(trace.samples), std::move(trace.steps),
                               std::move(trace.events), summary.meta.force_devices};
    if (record.inputs.size() != record.samples.size())
        throw InputError(summary.meta.id, "trace",
                         QT_TRANSLATE_NOOP("errors", "the numbers of inputs and samples differ"),
                         QT_TRANSLATE_NOOP("errors", "run fulcrum db check"));
    AttemptEngine engine(loaded.scene, loaded.task, summary.meta.seed);
    if (!start.empty()) restore_engine(engine, start);
    ReplayVerdict verdict;
    verdict.samples = record.samples.size();
    verdict.outcome = replay_record(engine, record, false, [&](const WorldSnapshot&) {
        verdict.complete = !keep_going || keep_going();
        return verdict.complete;
    });
    if (!verdict.complete) return verdict;
    // An attempt that was interrupted has no hash of its end.
    verdict.hash_identical =
        summary.state_hash.empty() || summary.state_hash == hex(verdict.outcome.state_hash);
    verdict.events_identical = same_events(record.events, verdict.outcome.events);
    if (!score) return verdict;
    const Limits limits = limits_for(loaded.task, loaded.scene, summary.meta.device_class);
    const ScoredAttempt again = score_record(loaded.scene, loaded.task, engine.initial_snapshot().targets,
                                             record.samples, record.events, limits);
    const std::vector<database::MetricRow> metrics = to_row(again, summary.meta.limits).metrics;
    verdict.metrics_identical = same_metrics(score->metrics, metrics);
    verdict.score_differs = score->program_version == program_version &&
                            same_versions(score->metrics, metrics) && !verdict.metrics_identical;
    return verdict;
}

std::uint64_t random_sample_seed() {
    std::random_device device;
    return device();
}

database::CheckItem check_by_simulation(const database::Store& store, const database::Session& session,
                                        const SimulationSample& sample,
                                        const database::StoreProgress& progress) {
    database::CheckItem item(database::CheckId::simulation);
    const database::CheckableAttempts all =
        database::checkable_attempts(store, session, program_version, cpu_features());
    const Clock::time_point begin = Clock::now();
    bool stopped = false;
    double reported = -progress_every_s;
    const auto keep_going = [&] {
        const double spent = std::chrono::duration<double>(Clock::now() - begin).count();
        if (progress && !stopped && spent - reported >= progress_every_s) {
            reported = spent;
            stopped = !progress(sample.most_s > 0 ? std::min(1.0, spent / sample.most_s) : 0, item.name);
        }
        return !stopped && (sample.most_s <= 0 || spent < sample.most_s);
    };
    item.notes.push_back({QT_TRANSLATE_NOOP("errors", "%1 attempts drawn of %2 with the seed %3"),
                          std::min<std::size_t>(all.ids.size(), static_cast<std::size_t>(sample.attempts)),
                          all.ids.size(), sample.seed});
    if (all.others > 0)
        item.notes.push_back({QT_TRANSLATE_NOOP("errors",
                                                "%1 attempts of other versions of the program, or "
                                                "taken over from a moment, cannot be simulated here"),
                              all.others});
    for (const std::string& id : chosen(all.ids, sample)) {
        if (!keep_going()) {
            item.notes.push_back(
                {QT_TRANSLATE_NOOP("errors", "attempt %1: not simulated, the time was over"), id});
            continue;
        }
        try {
            database::CheckedAttempt attempt = database::read_checked_attempt(store, session, id);
            const LoadedTask loaded = load_recorded(attempt.scene_text, attempt.summary);
            if (!same_files(attempt.assets, loaded.assets)) {
                item.notes.push_back(
                    {QT_TRANSLATE_NOOP("errors",
                                       "attempt %1: not simulated, its task's file was changed since"),
                     id});
                continue;
            }
            const ReplayVerdict verdict = verify_replay(loaded, attempt.summary, std::move(attempt.trace), {},
                                                        attempt.score, keep_going);
            ++item.count;
            describe(id, verdict, item);
            item.notes.push_back(
                verdict.complete
                    ? Sentence(QT_TRANSLATE_NOOP("errors", "attempt %1: simulated, %2 samples compared"), id,
                               verdict.samples)
                    : Sentence(QT_TRANSLATE_NOOP("errors", "attempt %1: simulated until the time was over"),
                               id));
        } catch (const InputError& error) {
            item.notes.push_back({QT_TRANSLATE_NOOP("errors", "attempt %1: not simulated (%2)"), id,
                                  error.problem_sentence()});
        } catch (const database::StoreError& error) {
            item.problems.push_back({QT_TRANSLATE_NOOP("errors", "attempt %1: cannot be read (%2)"), id,
                                     error.problem_sentence()});
        }
    }
    item.ok = item.problems.empty();
    return item;
}

database::CheckReport check_store_and_sample(const database::Store& store, const database::Session& session,
                                             const SimulationSample& sample,
                                             const database::StoreProgress& progress) {
    const bool simulates = sample.attempts > 0 && store.found_schema() == database::Store::schema_version();
    bool stopped = false;
    const auto part = [&](double from, double to) {
        return [&, from, to](double done, const std::string& line) {
            stopped = stopped || (progress && !progress(from + done * (to - from), line));
            return !stopped;
        };
    };
    const double stored = simulates ? 0.5 : 1;
    database::CheckReport report = store.check(session, part(0, stored));
    if (!simulates || !report.ok || !report.complete) return report;
    report.items.push_back(check_by_simulation(store, session, sample, part(stored, 1)));
    report.ok = report.items.back().ok;
    report.complete = !stopped;
    return report;
}

}  // namespace fulcrum::app
