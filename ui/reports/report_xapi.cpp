// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/report_xapi.h"

#include <QUrl>
#include <QUuid>
#include <cmath>
#include <nlohmann/json.hpp>

#include "assessment/metrics/statement_words.h"
#include "sim_core/numerics/input_error.h"
#include "ui/reports/report_rows.h"

namespace fulcrum::ui {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* verbs = "http://adlnet.gov/expapi/verbs/";
constexpr const char* simulation = "http://adlnet.gov/expapi/activities/simulation";
/// Our own terms: what an attempt has that the specification has no word for.
constexpr const char* terms = "urn:fulcrum:xapi:";

std::string id_from(const std::string& text) {
    // The namespace of names that are addresses (RFC 4122, appendix C).
    const QUuid addresses(QStringLiteral("{6ba7b811-9dad-11d1-80b4-00c04fd430c8}"));
    return QUuid::createUuidV5(addresses, QString::fromStdString(text))
        .toString(QUuid::WithoutBraces)
        .toStdString();
}

std::string under(const std::string& home_page, const std::string& rest) {
    return home_page + (home_page.back() == '/' ? "" : "/") + rest;
}

std::string statement_id(const std::string& home_page, const std::string& attempt_id) {
    return id_from(under(home_page, "attempt/" + attempt_id));
}

/// What the person did: an attempt without a verdict is completed or, when it did not come to its end,
/// attempted.
const char* verb_of(const database::ProgressPoint& point) {
    if (point.passed) return *point.passed ? "passed" : "failed";
    return point.state == AttemptState::completed ? "completed" : "attempted";
}

Json verb(const char* name) {
    return {{"id", std::string(verbs) + name}, {"display", {{"en-US", name}}}};
}

Json actor(const std::string& home_page, const std::string& person_id) {
    return {{"objectType", "Agent"}, {"account", {{"homePage", home_page}, {"name", person_id}}}};
}

Json activity(const std::string& home_page, const ReportTask& task) {
    return {{"objectType", "Activity"},
            {"id", under(home_page, "task/" + task.id)},
            {"definition", {{"name", {{"en", task.title}}}, {"type", simulation}}}};
}

/// ISO 8601, in hundredths of a second as the specification allows.
std::string duration(double seconds) {
    const long long hundredths = std::llround(std::max(0.0, seconds) * 100);
    const std::string rest = std::to_string(hundredths % 100);
    return "PT" + std::to_string(hundredths / 100) + "." + (rest.size() < 2 ? "0" : "") + rest + "S";
}

Json metrics(const database::ProgressPoint& point) {
    Json list = Json::array();
    for (const database::MetricRow& metric : point.metrics) list.push_back(metric_json(metric));
    return list;
}

Json result(const database::ProgressPoint& point) {
    Json made = {{"completion", point.state == AttemptState::completed}};
    if (point.passed) made["success"] = *point.passed;
    if (point.points)
        made["score"] = {{"scaled", *point.points / 100}, {"raw", *point.points}, {"min", 0}, {"max", 100}};
    made["duration"] = duration(point.duration_s);
    made["extensions"] = {{std::string(terms) + "metrics", metrics(point)}};
    if (!point.passed && !words_of(point.not_scored_because).empty())
        made["extensions"][std::string(terms) + "not-scored-because"] = words_of(point.not_scored_because);
    return made;
}

Json context(const PersonReport& report, DeviceClass device_class, const database::ProgressPoint& point) {
    Json extensions;
    const auto add = [&](const char* name, Json value) {
        extensions[std::string(terms) + name] = std::move(value);
    };
    add("device-class", row_of(device_classes, device_class).name);
    add("mode", row_of(attempt_modes, point.mode).name);
    add("state", row_of(attempt_states, point.state).name);
    add("fidelity", point.fidelity);
    add("variant", point.variant);
    if (!point.limits.empty()) add("limits", point.limits);
    add("counting", point.counting);
    add("provisional", point.provisional);
    add("synthetic", report.synthetic || report.provenance.demo);
    return {{"platform", report.provenance.program_version},
            {"language", "en"},
            {"extensions", std::move(extensions)}};
}

Json statement(const PersonReport& report, const std::string& home_page, const ReportTask& task,
               DeviceClass device_class, const database::ProgressPoint& point) {
    return {{"id", statement_id(home_page, point.attempt_id)},
            {"actor", actor(home_page, report.person_id)},
            {"verb", verb(verb_of(point))},
            {"object", activity(home_page, task)},
            {"result", result(point)},
            {"context", context(report, device_class, point)},
            {"timestamp", database::iso_utc(point.started + std::llround(point.duration_s * 1000))},
            {"version", "1.0.3"}};
}

std::string rating_statement_id(const std::string& home_page, const std::string& rating_id) {
    return id_from(under(home_page, "rating/" + rating_id));
}

/// What a rater said of the attempt. The rater is named, as an account, only where the form was not blind.
Json rating_statement(const PersonReport& report, const std::string& home_page, const ReportTask& task,
                      const database::ProgressPoint& point, const database::RatingRow& rating) {
    const std::optional<double> share = form_share(rating.form, rating.answers);
    const FormSum sum = form_sum(rating.form, rating.answers);
    Json items = Json::array();
    for (std::size_t i = 0; i < rating.form.items.size(); ++i)
        items.push_back({{"id", rating.form.items[i].id},
                         {"value", rating.answers[i] ? Json(*rating.answers[i]) : Json(nullptr)},
                         {"lowest", rating.form.items[i].lowest},
                         {"highest", rating.form.items[i].highest}});
    Json said = {{"extensions", {{std::string(terms) + "rating-items", std::move(items)}}}};
    if (share)
        said["score"] = {{"scaled", *share}, {"raw", sum.sum}, {"min", sum.lowest}, {"max", sum.highest}};
    Json about = {
        {"statement", {{"objectType", "StatementRef"}, {"id", statement_id(home_page, point.attempt_id)}}},
        {"platform", report.provenance.program_version},
        {"language", "en"},
        {"extensions",
         {{std::string(terms) + "form", rating.form.name()},
          {std::string(terms) + "blinding", row_of(database::blindings, rating.blinding).name},
          {std::string(terms) + "synthetic", report.synthetic || report.provenance.demo}}}};
    if (rating.blinding != database::Blinding::kept) about["instructor"] = actor(home_page, rating.rater_id);
    return {{"id", rating_statement_id(home_page, rating.id)},
            {"actor", actor(home_page, report.person_id)},
            {"verb", verb("scored")},
            {"object", activity(home_page, task)},
            {"result", std::move(said)},
            {"context", std::move(about)},
            {"timestamp", database::iso_utc(rating.handed_in)},
            {"version", "1.0.3"}};
}

/// Said by the program, not by the trainee.
Json voiding(const std::string& home_page, const std::string& what, const std::string& id, std::int64_t at) {
    return {{"id", id_from(under(home_page, what))},
            {"actor", actor(home_page, "fulcrum")},
            {"verb", verb("voided")},
            {"object", {{"objectType", "StatementRef"}, {"id", id}}},
            {"timestamp", database::iso_utc(at)},
            {"version", "1.0.3"}};
}

void add_person(Json& statements, const PersonReport& report, const std::string& home_page) {
    for (const database::PersonProgress& progress : report.progress) {
        ReportTask task{progress.task_id, progress.task_id, ""};
        for (const ReportTask& one : report.tasks)
            if (one.id == progress.task_id) task = one;
        for (const database::ProgressSeries& series : progress.series)
            for (const database::ProgressPoint& point : series.points) {
                statements.push_back(statement(report, home_page, task, series.device_class, point));
                for (const database::RatingRow& rating : point.ratings)
                    statements.push_back(rating_statement(report, home_page, task, point, rating));
            }
        for (const database::VoidedAttempt& attempt : progress.voided) {
            statements.push_back(voiding(home_page, "void/" + attempt.attempt_id,
                                         statement_id(home_page, attempt.attempt_id), attempt.at));
            for (const std::string& rating : attempt.ratings)
                statements.push_back(voiding(home_page, "void/rating/" + rating,
                                             rating_statement_id(home_page, rating), attempt.at));
        }
    }
}

}  // namespace

void require_home_page(const std::string& home_page) {
    const QUrl url(QString::fromStdString(home_page), QUrl::StrictMode);
    const bool web = url.scheme() == QStringLiteral("http") || url.scheme() == QStringLiteral("https");
    if (url.isValid() && web && !url.host().isEmpty()) return;
    throw InputError(
        QT_TRANSLATE_NOOP("errors", "command line"), "--home-page",
        home_page.empty() ? Sentence(QT_TRANSLATE_NOOP("errors", "is missing"))
                          : Sentence(QT_TRANSLATE_NOOP("errors", "\"%1\" is not a web address"), home_page),
        QT_TRANSLATE_NOOP(
            "errors",
            "name the address that the ids of your people belong to, such as https://training.example"));
}

std::string xapi_statements(const std::vector<PersonReport>& people, const std::string& home_page) {
    require_home_page(home_page);
    Json statements = Json::array();
    for (const PersonReport& report : people) add_person(statements, report, home_page);
    return statements.dump(2) + "\n";
}

}  // namespace fulcrum::ui
