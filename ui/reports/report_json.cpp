// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metrics/statement_words.h"

#include <nlohmann/json.hpp>

#include "assessment/metrics/metric_names.h"
#include "ui/reports/report_rows.h"
#include "ui/reports/report_writer.h"

namespace fulcrum::ui {
namespace {

using Json = nlohmann::ordered_json;

template <typename T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}
Json or_null(const std::string& value) {
    return value.empty() ? Json(nullptr) : Json(value);
}
Json time_or_null(std::int64_t time) {
    return time == 0 ? Json(nullptr) : Json(database::iso_utc(time));
}

Json rated_json(const std::vector<database::RatedForm>& forms) {
    Json list = Json::array();
    for (const database::RatedForm& one : forms) {
        Json items = Json::object();
        for (const auto& [item, mean] : one.items) items[item] = mean;
        list.push_back({{"form", one.form},
                        {"title", one.title},
                        {"attempts", one.attempts},
                        {"forms", one.forms},
                        {"scaled", one.scaled},
                        {"items", std::move(items)}});
    }
    return list;
}

Json row_json(const database::CohortRow& row) {
    return {{"person_id", row.person_id},
            {"login", row.login},
            {"name", row.name},
            {"active", row.active},
            {"task", row.task_id},
            {"device_class",
             row.device_class ? Json(row_of(device_classes, *row.device_class).name) : Json(nullptr)},
            {"state", database::task_state_name(row.state)},
            {"provisional", row.provisional},
            {"attempts", row.attempts},
            {"passes", row.passes},
            {"not_counting", row.not_counting},
            {"best_points", or_null(row.best_points)},
            {"best_attempt", or_null(row.best_attempt_id)},
            {"last_attempt", time_or_null(row.last_attempt)},
            {"ratings", rated_json(row.ratings)}};
}

Json point_json(const database::ProgressPoint& point) {
    Json metrics = Json::array();
    for (const database::MetricRow& metric : point.metrics) metrics.push_back(metric_json(metric));
    Json ratings = Json::array();
    for (const database::RatingRow& rating : point.ratings) ratings.push_back(rating_json(rating));
    return {{"attempt", point.attempt_id},
            {"number", point.number},
            {"started", database::iso_utc(point.started)},
            {"utc_offset_min", point.utc_offset_min},
            {"mode", row_of(attempt_modes, point.mode).name},
            {"state", row_of(attempt_states, point.state).name},
            {"variant", point.variant},
            {"fidelity", point.fidelity},
            {"limits", or_null(point.limits)},
            {"counting", point.counting},
            {"continues", point.continues},
            {"duration_s", point.duration_s},
            {"passed", or_null(point.passed)},
            {"provisional", point.provisional},
            {"not_scored_because", or_null(why_not_scored(point.not_scored_because, point.continues))},
            {"not_scored_code", statement_json(point.not_scored_because)},
            {"points", or_null(point.points)},
            {"metrics", std::move(metrics)},
            {"pathology", point.pathology ? Json::parse(pathology_json(*point.pathology)) : Json(nullptr)},
            {"ratings", std::move(ratings)},
            {"rated", rated_json(database::rated_forms(point.ratings))}};
}

}  // namespace

Json provenance_json(const ReportProvenance& provenance) {
    Json assets = Json::array();
    for (const database::AssetFile& file : provenance.assets)
        assets.push_back({{"file", file.name}, {"sha256", file.digest}});
    return {{"programme", provenance.programme},
            {"as_of", database::iso_utc(provenance.as_of)},
            {"made_by", provenance.made_by},
            {"made_as", provenance.made_as},
            {"program_version", provenance.program_version},
            {"program_versions", provenance.program_versions},
            {"metric_versions", provenance.metric_versions},
            {"benchmark_sets", provenance.benchmark_sets},
            {"assets", assets},
            {"program_sha256", or_null(provenance.program_digest)},
            {"tamper_evident", provenance.tamper_evident},
            {"tamper_evidence", tamper_evidence(provenance)},
            {"audit_head", provenance.audit_head},
            {"station_key", or_null(provenance.station_key)},
            {"demo", provenance.demo}};
}

Json metric_json(const database::MetricRow& metric) {
    Json evidence = Json::array();
    for (const auto& [from, to] : metric.evidence) evidence.push_back({from, to});
    return {{"id", metric.id},
            {"version", metric.version},
            {"hand", or_null(metric.hand)},
            {"tissue", or_null(metric.tissue)},
            {"value", or_null(metric.value)},
            {"absent_because", or_null(words_of(metric.absent_because))},
            {"absent_code", statement_json(metric.absent_because)},
            {"unit", metric.unit},
            {"direction", row_of(metric_directions, metric.direction).name},
            {"evidence", std::move(evidence)}};
}

Json rating_json(const database::RatingRow& rating) {
    Json items = Json::array();
    for (std::size_t i = 0; i < rating.form.items.size(); ++i) {
        const FormItem& item = rating.form.items[i];
        items.push_back({{"id", item.id},
                         {"title", item.title},
                         {"value", rating.answers[i] ? Json(*rating.answers[i]) : Json(nullptr)},
                         {"lowest", item.lowest},
                         {"highest", item.highest}});
    }
    const FormSum sum = form_sum(rating.form, rating.answers);
    return {{"form", rating.form.name()},
            {"title", rating.form.title},
            {"rater", rating.rater_name},
            {"blinding", row_of(database::blindings, rating.blinding).name},
            {"handed_in", database::iso_utc(rating.handed_in)},
            {"released", database::iso_utc(rating.released)},
            {"sum", sum.answered == 0 ? Json(nullptr) : Json(sum.sum)},
            {"sum_lowest", sum.lowest},
            {"sum_highest", sum.highest},
            {"items", std::move(items)},
            {"remark", rating.remark.empty() ? Json(nullptr) : Json(rating.remark)}};
}

namespace {

/// What the rule still asks of raters, or asked in vain; null where nothing.
Json rating_state_json(const TaskStanding& standing) {
    if (standing.rated_attempt.empty()) return nullptr;
    return {{"attempt", standing.rated_attempt},
            {"raters", standing.raters},
            {"raters_needed", standing.raters_needed},
            {"too_low", standing.rated_low}};
}

}  // namespace

Json standings_json(const database::PersonStandings& person) {
    Json tasks = Json::array(), concerns = Json::array();
    const auto add = [&tasks](const TaskStanding& standing) {
        tasks.push_back({{"task", standing.task},
                         {"standing", row_of(standing_names, standing.standing).name},
                         {"provisional", standing.provisional},
                         {"by_decision", standing.by_override},
                         {"attempts", standing.attempts},
                         {"passes", standing.passes},
                         {"towards_proficiency", standing.progress},
                         {"waits_for", standing.waits_for},
                         {"rating", rating_state_json(standing)},
                         {"proficient_since", time_or_null(standing.declared_at)},
                         {"next_check", time_or_null(standing.next_check)}});
    };
    if (!person.not_here) {  // else each would be said to be locked
        for (const database::PersonTask& task : person.tasks) add(task.standing);
        for (const database::PersonTask& task : person.own_tasks) add(task.standing);
    }
    for (const Concern& concern : person.concerns) {
        Json one = {{"kind", row_of(concern_names, concern.kind).name},
                    {"task", or_null(concern.task)},
                    {"since", time_or_null(concern.since)},
                    {"provisional", concern.provisional},
                    {"attempts", concern.attempts}};
        if (concern.kind == ConcernKind::plateau)
            one["plateau"] = {{"points", concern.plateau}, {"low", concern.low}, {"high", concern.high}};
        concerns.push_back(std::move(one));
    }
    return {{"person_id", person.person_id},
            {"login", person.login},
            {"curriculum", person.curriculum},
            {"curriculum_is_here", !person.not_here},
            {"name", person.name},
            {"active", person.active},
            {"last_attempt", time_or_null(person.last_attempt)},
            {"tasks", std::move(tasks)},
            {"concerns", std::move(concerns)}};
}

namespace {

Json median_json(const SurvivalMedian& days) {
    return {{"median", or_null(days.median)}, {"low", or_null(days.low)}, {"high", or_null(days.high)}};
}

Json overview_json(const database::CohortTable& table) {
    Json tasks = Json::array();
    for (const database::TaskOverview& one : database::overview_of(table.standings, table.as_of)) {
        Json people;
        for (const auto& row : standing_names) {
            const auto found = one.people.find(row.kind);
            people[row.name] = found == one.people.end() ? 0 : found->second;
        }
        tasks.push_back(
            {{"task", one.task},
             {"people", std::move(people)},
             {"passed_provisionally", one.provisional},
             {"attempted", one.attempted},
             {"passed", one.passed},
             {"pass_share", {{"share", one.share.share}, {"low", one.share.low}, {"high", one.share.high}}},
             {"days_to_first_pass", median_json(one.days_to_pass)},
             {"days_to_proficiency", median_json(one.days_to_proficiency)}});
    }
    return tasks;
}

/// The values behind the pictures of the cohort, apart from those of `overview`.
Json dashboard_json(const CohortReport& report) {
    const database::CohortDashboard& dashboard = report.dashboard;
    const auto& people = report.table.standings;
    Json plan = Json::array(), weeks = Json::array(), checks = Json::array(), stages = Json::array();
    for (const database::PlanPoint& one : dashboard.plan)
        plan.push_back({{"person_id", people[one.person].person_id},
                        {"weeks", one.weeks},
                        {"tasks_done", one.done},
                        {"tasks_planned", one.planned}});
    for (const database::PracticeWeek& week : dashboard.weeks)
        weeks.push_back({{"monday", database::iso_utc(week.monday * 86'400'000).substr(0, 10)},
                         {"attempts", week.attempts},
                         {"people", week.people.size()}});
    for (const database::CheckSlot& slot : dashboard.checks)
        for (const database::DashboardPerson& check : slot.checks)
            checks.push_back({{"person_id", people[check.person].person_id},
                              {"task", check.task},
                              {"due_utc", database::iso_utc(check.at)},
                              {"due", slot.kind == database::CheckSlot::Kind::due ||
                                          slot.kind == database::CheckSlot::Kind::overdue},
                              {"overdue", slot.kind == database::CheckSlot::Kind::overdue}});
    for (const database::StageStep& step : dashboard.stages)
        stages.push_back(
            {{"stage", step.stage}, {"step", step.done ? "done" : "begun"}, {"people", step.people.size()}});
    return {{"plan_weeks", dashboard.plan_weeks},
            {"plan", std::move(plan)},
            {"weeks", std::move(weeks)},
            {"checks", std::move(checks)},
            {"stages", std::move(stages)}};
}

}  // namespace

std::string person_json(const PersonReport& report) {
    Json document = {{"report", "person"},
                     {"person", {{"id", report.person_id}, {"login", report.login}, {"name", report.name}}},
                     {"synthetic", report.synthetic},
                     {"provenance", provenance_json(report.provenance)}};
    document["rows"] = Json::array();
    for (const database::CohortRow& row : report.rows) document["rows"].push_back(row_json(row));
    document["standings"] = report.standings ? standings_json(*report.standings) : Json(nullptr);
    document["tasks"] = Json::array();
    for (const database::PersonProgress& progress : report.progress) {
        Json series = Json::array();
        for (const database::ProgressSeries& one : progress.series) {
            Json points = Json::array();
            for (const database::ProgressPoint& point : one.points) points.push_back(point_json(point));
            series.push_back({{"device_class", row_of(device_classes, one.device_class).name},
                              {"attempts", std::move(points)}});
        }
        document["tasks"].push_back({{"task", progress.task_id},
                                     {"state", database::task_state_name(progress.state)},
                                     {"series", std::move(series)}});
    }
    return document.dump(2) + "\n";
}

std::string cohort_json(const CohortReport& report) {
    Json document = {{"report", "cohort"},
                     {"cohort", {{"id", report.table.cohort_id}, {"name", report.table.cohort_name}}},
                     {"n", report.table.people},
                     {"deactivated", report.table.deactivated},
                     {"left_out_synthetic", report.table.left_out_synthetic},
                     {"provenance", provenance_json(report.provenance)}};
    document["tasks"] = Json::array();
    for (const ReportTask& task : report.tasks) {
        document["tasks"].push_back({{"id", task.id}, {"title", task.title}, {"stage", task.stage}});
    }
    document["rows"] = Json::array();
    for (const database::CohortRow& row : report.table.rows) document["rows"].push_back(row_json(row));
    document["curriculum"] = or_null(report.table.curriculum);
    document["overview"] = overview_json(report.table);
    document["dashboard"] = report.curriculum == nullptr ? Json(nullptr) : dashboard_json(report);
    document["standings"] = Json::array();
    for (const database::PersonStandings& person : report.table.standings)
        document["standings"].push_back(standings_json(person));
    return document.dump(2) + "\n";
}

namespace {

class JsonWriter : public ReportWriter {
  public:
    ReportFiles write_attempt(const AttemptPaper& paper, const ReportRequest& request) const override {
        save_report(request.path, attempt_json(paper));
        return {request.path};
    }
    ReportFiles write_person(const PersonReport& report, const ReportRequest& request) const override {
        save_report(request.path, person_json(report));
        return {request.path};
    }
    ReportFiles write_cohort(const ReportSource& source, const ReportRequest& request,
                             const Progress& progress) const override {
        const auto report = gather_cohort(source, request, PeoplePages::none, progress);
        if (!report) return {};
        save_report(request.path, cohort_json(*report));
        return {request.path};
    }
};

}  // namespace

const ReportWriter& json_writer() {
    static const JsonWriter writer;
    return writer;
}

}  // namespace fulcrum::ui
