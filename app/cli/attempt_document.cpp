// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/attempt_document.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/cli/commands.h"
#include "app/live/performance.h"
#include "assessment/assets/assets.h"
#include "assessment/attempt/engine.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/metrics/statement_words.h"
#include "assessment/trace/events_csv.h"
#include "assessment/trace/trace_csv.h"
#include "database/records/error_reviews.h"
#include "database/records/external_attempts.h"
#include "database/records/report_data.h"
#include "database/rows/force_devices.h"
#include "sim_core/numerics/files.h"

namespace fulcrum::app {
namespace {

std::uint64_t seed_of(const std::vector<Event>& events) {
    const auto begin = std::find_if(events.begin(), events.end(), [](const Event& event) {
        return event.kind == EventKind::attempt_begin;
    });
    return begin != events.end() && begin->detail > 0 ? static_cast<std::uint64_t>(begin->detail) : 0;
}

}  // namespace

nlohmann::json score_document(const ScoredAttempt& scored) {
    const Score& score = scored.score;
    return {{"duration_s", scored.duration_s},
            {"state", row_of(attempt_states, scored.state).name},
            {"passed", or_null(score.passed)},
            {"not_scored_because", or_null(words_of(score.not_scored_because))},
            {"not_scored_code", statement_json(score.not_scored_because)},
            {"points", or_null(score.points)},
            {"advice", words_of(score.advice)},
            {"advice_code", statement_json(score.advice)},
            {"gates", gates_to_json(score.gates)},
            {"metrics", metrics_to_json(scored.metrics)},
            {"critical_errors", critical_errors_to_json(score.critical_errors)},
            {"pathology",
             scored.pathology ? nlohmann::json::parse(pathology_json(*scored.pathology)) : nlohmann::json()}};
}

nlohmann::json attempt_document(const database::AttemptMeta& meta, const std::string& attempt,
                                const ScoredAttempt& scored) {
    nlohmann::json document = score_document(scored);
    document.update({{"attempt", attempt},
                     {"task", meta.task_id},
                     {"operator", or_null(meta.operator_name)},
                     {"mode", row_of(attempt_modes, meta.mode).name},
                     {"device_class", row_of(device_classes, meta.device_class).name},
                     {"device", nlohmann::json::parse(database::device_json(meta.device, meta.rig_use))},
                     {"variant", meta.variant},
                     {"seed", meta.seed},
                     {"fidelity", meta.fidelity}});
    return document;
}

nlohmann::json origin_json(const std::optional<database::AttemptOrigin>& origin) {
    if (!origin) return {};
    return {{"attempt", or_null(origin->source_id)}, {"tick", origin->tick}, {"goal", origin->goal}};
}

namespace {

/// With what a store does not have of it from the record, where that is of the same version.
MetricResult stored_result(const database::MetricRow& row, const std::vector<MetricResult>& measured) {
    MetricResult result = from_row(row);
    const MetricResult* now = find_result(measured, row.id, row.hand, row.tissue);
    if (now != nullptr && now->version == row.version && now->value.has_value() == row.value.has_value()) {
        result.absence = now->absence;
        result.count = now->count;
    }
    return result;
}

/// In place of what the record gives today: with the limits that were in force when the attempt began, and
/// the metrics as they were when it was scored.
void take_stored(ScoredAttempt& scored, const database::ScoreRow& stored) {
    std::vector<MetricResult> metrics;
    for (const database::MetricRow& row : stored.metrics)
        metrics.push_back(stored_result(row, scored.metrics));
    scored.metrics = std::move(metrics);
    scored.pathology = database::pathology_of(stored);
    scored.score = Score();
    scored.score.passed = stored.passed;
    scored.score.not_scored_because = stored.not_scored_because;
    scored.score.points = stored.points;
    scored.score.advice = stored.advice;
    for (const database::GateRow& row : stored.gates) {
        scored.score.provisional = scored.score.provisional || row.provisional;
        scored.score.gates.push_back(from_row(row));
    }
    for (const database::CriticalErrorRow& row : stored.critical_errors)
        scored.score.critical_errors.push_back(from_row(row));
}

std::vector<std::string> write_files(const std::string& folder,
                                     const std::vector<std::pair<const char*, std::string>>& contents) {
    std::filesystem::create_directories(folder);
    std::vector<std::string> files;
    for (const auto& [name, text] : contents) {
        files.push_back((std::filesystem::path(folder) / name).string());
        write_whole_file(files.back(), text, FileAccess::owner_only);
    }
    return files;
}

std::string text_of(const nlohmann::json& document) {
    return document.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

/// What educators said of recorded errors: all of it, oldest first; the last of an event counts. Names
/// nobody, as the rest of the document.
nlohmann::json error_reviews_json(const database::Store& store, const database::Session& session,
                                  const std::string& attempt, const std::vector<std::string>& tissues,
                                  double tick_period) {
    nlohmann::json list = nlohmann::json::array();
    for (const database::ErrorReview& review : database::ErrorReviews(store).history(session, attempt)) {
        const bool known = review.tissue >= 0 && static_cast<std::size_t>(review.tissue) < tissues.size();
        list.push_back({{"time_s", review.tick * tick_period},
                        {"kind", event_name(review.kind)},
                        {"hand", review.hand == 0   ? "left"
                                 : review.hand == 1 ? "right"
                                                    : ""},
                        {"tissue", known ? tissues[static_cast<std::size_t>(review.tissue)] : ""},
                        {"detail", review.detail},
                        {"verdict", row_of(database::error_verdicts, review.verdict).name},
                        {"reason", review.reason},
                        {"time", review.time}});
    }
    return list;
}

/// As the report on an attempt has it: the record of a voided one may be that of another person.
void put_void(nlohmann::json& document, const database::AttemptSummary& summary) {
    document["state"] = row_of(attempt_states, summary.state).name;
    document["voided"] = nullptr;
    if (summary.state == AttemptState::voided)
        document["voided"] = {{"time", database::iso_utc(summary.voided_at)},
                              {"reason", summary.void_reason}};
}

/// An attempt that was recorded elsewhere: its trace as it was measured, and the stored metrics.
std::vector<std::string> export_external(const database::Store& store, const database::Session& session,
                                         const database::AttemptSummary& summary, const std::string& folder) {
    const std::string trace = database::ExternalAttempts(store).trace(session, summary.meta.id);
    ScoredAttempt measured;
    measured.state = summary.recorded_state;
    measured.duration_s = summary.duration_s;
    measured.score.not_scored_because = summary.not_scored_because;
    std::istringstream in(trace);
    measured.metrics = metrics_from_json(
        metrics_of_trace(read_trace_csv(in, "trace.csv"), "trace.csv")["metrics"], "metrics");
    if (const auto stored = database::Attempts(store).score(session, summary.meta.id))
        take_stored(measured, *stored);
    nlohmann::json document = attempt_document(summary.meta, summary.meta.id, measured);
    put_void(document, summary);
    return write_files(folder, {{"trace.csv", trace}, {"attempt.json", text_of(document)}});
}

}  // namespace

std::vector<std::string> export_trace(const database::Store& store, const database::Session& session,
                                      const std::string& attempt, const std::string& folder) {
    const database::Attempts attempts(store);
    const database::AttemptSummary summary = attempts.read(session, attempt);
    if (database::is_external_task(summary.meta.task_id))
        return export_external(store, session, summary, folder);
    const database::Trace record = attempts.read_trace(session, attempt);
    const LoadedTask loaded = load_recorded(attempts, session, summary);
    ScoredAttempt scored =
        score_record(loaded.scene, loaded.task, targets_of(loaded.scene, loaded.task, summary.meta.seed),
                     record.samples, record.events, Limits());
    scored.state = summary.recorded_state;
    scored.duration_s = summary.duration_s;
    if (const auto stored = attempts.score(session, attempt)) {
        take_stored(scored, *stored);
    } else {
        scored.score = Score();
        if (summary.meta.origin) {
            scored.score.not_scored_because = Statement::plain(database::never_scored_words);
            scored.pathology.reset();  // the rest of the specimen was divided before
        }
    }
    const std::array<bool, hand_count> hands = {loaded.scene.instrument(Hand::left) != nullptr,
                                                loaded.scene.instrument(Hand::right) != nullptr};
    const std::vector<std::string> labels = tissue_labels(loaded.scene);
    std::ostringstream trace, table;
    write_trace_csv(trace_from_samples(record.samples, record.events, labels, loaded.scene.tick_rate, hands),
                    trace);
    std::vector<Event> events = record.events;
    for (Event& event : events) put_seed(event, summary.meta.seed);
    write_events_csv(events, labels, loaded.scene.tick_period(), table);
    nlohmann::json document = attempt_document(summary.meta, attempt, scored);
    put_void(document, summary);
    document["continues"] = origin_json(summary.meta.origin);
    document["error_reviews"] =
        error_reviews_json(store, session, attempt, labels, loaded.scene.tick_period());
    return write_files(
        folder,
        {{"trace.csv", trace.str()}, {"events.csv", table.str()}, {"attempt.json", text_of(document)}});
}

nlohmann::json score_of_trace(Trace trace, const std::string& events_file, const LoadedTask& loaded,
                              DeviceClass device_class) {
    put_labels_first(trace, tissue_labels(loaded.scene));
    const std::vector<Event> events = read_events_csv(events_file, trace.tissues, loaded.scene.tick_period());
    trace.tick_period = loaded.scene.tick_period();
    split_blocks(trace, events);
    nlohmann::json document = score_document(
        score_trace(loaded.scene, loaded.task, targets_of(loaded.scene, loaded.task, seed_of(events)), trace,
                    events, limits_for(loaded.task, loaded.scene, device_class)));
    document["device_class"] = row_of(device_classes, device_class).name;
    document["fidelity"] = loaded.scene.fidelity.id;
    document["variant"] = loaded.scene.variant;
    return document;
}

}  // namespace fulcrum::app
