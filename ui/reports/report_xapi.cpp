// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/report_xapi.h"

#include <QUrl>
#include <QUuid>
#include <cmath>

#include "assessment/metrics/metric_names.h"
#include "assessment/metrics/statement_words.h"
#include "sim_core/numerics/input_error.h"
#include "ui/reports/json_text.h"
#include "ui/reports/report_rows.h"
#include "ui/reports/report_writer.h"

namespace fulcrum::ui {
namespace {

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

/// The task was performed to its end: practice of its last part is none of that.
bool completes_task(const database::ProgressPoint& point) {
    return point.state == AttemptState::completed && !point.continues;
}

/// What the person did: an attempt without a verdict is completed or, when it did not come to its end,
/// attempted.
const char* verb_of(const database::ProgressPoint& point) {
    if (point.passed) return *point.passed ? "passed" : "failed";
    return completes_task(point) ? "completed" : "attempted";
}

/// Cut off by a crash and not scored yet: its record decides whether it failed, and a statement is never made
/// twice.
bool awaits_score(const database::ProgressPoint& point) {
    return point.state == AttemptState::interrupted && !point.passed && point.not_scored_because.empty() &&
           !point.continues;
}

void add_verb(JsonText& json, const char* name) {
    json.key("verb").begin_object().member("id", std::string(verbs) + name);
    json.key("display").begin_object().member("en-US", name).end_object().end_object();
}

/// ISO 8601, in hundredths of a second as the specification allows.
std::string duration(double seconds) {
    const long long hundredths = std::llround(std::max(0.0, seconds) * 100);
    const std::string rest = std::to_string(hundredths % 100);
    return "PT" + std::to_string(hundredths / 100) + "." + (rest.size() < 2 ? "0" : "") + rest + "S";
}

/// What is the same in many statements: of a programme, a person, a task.
struct Parts {
    const PersonReport& report;
    const std::string& home_page;
    std::string actor, object;  ///< JSON

    void set_actor() {
        JsonText json;
        write_actor(json, report.person_id);
        actor = json.take();
    }
    void set_task(const std::string& id) {
        const ReportTask* task = nullptr;
        for (const ReportTask& one : report.tasks)
            if (one.id == id) task = &one;
        JsonText json;
        json.begin_object().member("objectType", "Activity").member("id", under(home_page, "task/" + id));
        json.key("definition").begin_object();
        json.key("name").begin_object().member("en", task != nullptr ? task->title : id).end_object();
        json.member("type", simulation).end_object().end_object();
        object = json.take();
    }
    void write_actor(JsonText& json, const std::string& account) const {
        json.begin_object().member("objectType", "Agent").key("account").begin_object();
        json.member("homePage", home_page).member("name", account).end_object().end_object();
    }
    bool synthetic() const { return report.synthetic || report.provenance.demo; }
};

/// The member of an extension; our terms have no letter that needs escaping.
std::string term(const char* name) {
    return std::string(terms) + name;
}

/// As metric_json() gives it.
void add_metric(JsonText& json, const database::MetricRow& metric) {
    json.begin_object().member("id", metric.id).member("version", metric.version);
    json.member_or_null("hand", metric.hand).member_or_null("tissue", metric.tissue);
    json.member("value", metric.value);
    json.member_or_null("absent_because", words_of(metric.absent_because)).key("absent_code");
    metric.absent_because.empty() ? json.null() : json.raw(statement_json(metric.absent_because).dump());
    json.member("unit", metric.unit).member("direction", row_of(metric_directions, metric.direction).name);
    json.key("evidence").begin_array();
    for (const auto& [from, to] : metric.evidence) json.begin_array().value(from).value(to).end_array();
    json.end_array().end_object();
}

void add_metrics(JsonText& json, const database::ProgressPoint& point) {
    json.begin_array();
    for (const database::MetricRow& metric : point.metrics) add_metric(json, metric);
    json.end_array();
}

void add_result(JsonText& json, const database::ProgressPoint& point) {
    json.key("result").begin_object().member("completion", completes_task(point));
    if (point.passed) json.member("success", *point.passed);
    if (point.points)
        json.key("score")
            .begin_object()
            .member("scaled", *point.points / 100)
            .member("raw", *point.points)
            .member("min", 0)
            .member("max", 100)
            .end_object();
    json.member("duration", duration(point.duration_s)).key("extensions").begin_object();
    add_metrics(json.key(term("metrics")), point);
    if (!point.passed) {
        const std::string why = why_not_scored(point.not_scored_because, point.continues);
        if (!why.empty()) json.member(term("not-scored-because"), why);
    }
    json.end_object().end_object();
}

/// Which profile describes the statement.
void add_profile(JsonText& json) {
    json.key("contextActivities").begin_object().key("category").begin_array().begin_object();
    json.member("objectType", "Activity").member("id", xapi_profile_version);
    json.key("definition").begin_object().member("type", "http://adlnet.gov/expapi/activities/profile");
    json.end_object().end_object().end_array().end_object();
}

void add_context(JsonText& json, const Parts& parts, DeviceClass device_class,
                 const database::ProgressPoint& point) {
    json.key("context").begin_object().member("platform", parts.report.provenance.program_version);
    add_profile(json);
    json.member("language", "en").key("extensions").begin_object();
    json.member(term("device-class"), row_of(device_classes, device_class).name);
    json.member(term("mode"), row_of(attempt_modes, point.mode).name);
    json.member(term("state"), row_of(attempt_states, point.state).name);
    json.member(term("fidelity"), point.fidelity).member(term("variant"), point.variant);
    if (!point.limits.empty()) json.member(term("limits"), point.limits);
    // A statement is sent once: what it says must not change with a move or a void of another attempt.
    json.member(term("counting"), point.counting || point.left_out)
        .member(term("provisional"), point.provisional);
    json.member(term("synthetic"), parts.synthetic()).end_object().end_object();
}

void add_end(JsonText& json, std::int64_t time) {
    json.member("timestamp", database::iso_utc(time)).member("version", "1.0.3").end_object();
}

XapiStatement statement(const Parts& parts, DeviceClass device_class, const database::ProgressPoint& point) {
    XapiStatement made{statement_id(parts.home_page, point.attempt_id), {}};
    JsonText json;
    json.begin_object().member("id", made.id).key("actor").raw(parts.actor);
    add_verb(json, verb_of(point));
    json.key("object").raw(parts.object);
    add_result(json, point);
    add_context(json, parts, device_class, point);
    add_end(json, point.started + std::llround(point.duration_s * 1000));
    made.text = json.take();
    return made;
}

std::string rating_statement_id(const std::string& home_page, const std::string& rating_id) {
    return id_from(under(home_page, "rating/" + rating_id));
}

void add_reference(JsonText& json, const std::string& id) {
    json.begin_object().member("objectType", "StatementRef").member("id", id).end_object();
}

void add_rating_result(JsonText& json, const database::RatingRow& rating) {
    json.key("result").begin_object().key("extensions").begin_object();
    json.key(term("rating-items")).begin_array();
    for (std::size_t i = 0; i < rating.form.items.size(); ++i) {
        const FormItem& item = rating.form.items[i];
        json.begin_object().member("id", item.id).member("value", rating.answers[i]);
        json.member("lowest", item.lowest).member("highest", item.highest).end_object();
    }
    json.end_array().end_object();
    if (const std::optional<double> share = form_share(rating.form, rating.answers)) {
        const FormSum sum = form_sum(rating.form, rating.answers);
        json.key("score").begin_object().member("scaled", *share).member("raw", sum.sum);
        json.member("min", sum.lowest).member("max", sum.highest).end_object();
    }
    json.end_object();
}

/// What a rater said of the attempt. The rater is named, as an account, only where the form was not blind.
XapiStatement rating_statement(const Parts& parts, const database::ProgressPoint& point,
                               const database::RatingRow& rating) {
    XapiStatement made{rating_statement_id(parts.home_page, rating.id), {}};
    JsonText json;
    json.begin_object().member("id", made.id).key("actor").raw(parts.actor);
    add_verb(json, "scored");
    json.key("object").raw(parts.object);
    add_rating_result(json, rating);
    json.key("context").begin_object();
    add_reference(json.key("statement"), statement_id(parts.home_page, point.attempt_id));
    json.member("platform", parts.report.provenance.program_version).member("language", "en");
    add_profile(json);
    json.key("extensions").begin_object().member(term("form"), rating.form.name());
    json.member(term("blinding"), row_of(database::blindings, rating.blinding).name);
    json.member(term("synthetic"), parts.synthetic()).end_object();
    if (rating.blinding != database::Blinding::kept)
        parts.write_actor(json.key("instructor"), rating.rater_id);
    json.end_object();
    add_end(json, rating.handed_in);
    made.text = json.take();
    return made;
}

/// Said by the program, not by the trainee.
XapiStatement voiding(const Parts& parts, const std::string& what, const std::string& id, std::int64_t at) {
    XapiStatement made{id_from(under(parts.home_page, what)), {}};
    JsonText json;
    json.begin_object().member("id", made.id);
    parts.write_actor(json.key("actor"), "fulcrum");
    add_verb(json, "voided");
    add_reference(json.key("object"), id);
    add_profile(json.key("context").begin_object());
    json.end_object();
    add_end(json, at);
    made.text = json.take();
    return made;
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

void each_xapi_statement(const PersonReport& report, const std::string& home_page,
                         const std::function<void(XapiStatement&&)>& visit) {
    require_home_page(home_page);
    Parts parts{report, home_page, {}, {}};
    parts.set_actor();
    const auto about = [&](const std::string& attempt_id, XapiStatement&& made) {
        made.attempt_id = attempt_id;
        visit(std::move(made));
    };
    for (const database::PersonProgress& progress : report.progress) {
        parts.set_task(progress.task_id);
        for (const database::ProgressSeries& series : progress.series)
            for (const database::ProgressPoint& point : series.points) {
                if (!awaits_score(point))
                    about(point.attempt_id, statement(parts, series.device_class, point));
                for (const database::RatingRow& rating : point.ratings)
                    about(point.attempt_id, rating_statement(parts, point, rating));
            }
        for (const database::VoidedAttempt& attempt : progress.voided) {
            about(attempt.attempt_id, voiding(parts, "void/" + attempt.attempt_id,
                                              statement_id(home_page, attempt.attempt_id), attempt.at));
            for (const std::string& rating : attempt.ratings)
                about(attempt.attempt_id, voiding(parts, "void/rating/" + rating,
                                                  rating_statement_id(home_page, rating), attempt.at));
        }
    }
}

std::string xapi_statements(const std::vector<PersonReport>& people, const std::string& home_page) {
    require_home_page(home_page);
    std::string text = "[";
    for (const PersonReport& report : people)
        each_xapi_statement(report, home_page, [&](XapiStatement&& one) {
            text += text.size() > 1 ? ",\n" : "\n";
            text += one.text;
        });
    return text + "\n]\n";
}

namespace {

class XapiWriter : public ReportWriter {
  public:
    void check(const ReportRequest& request) const override { require_home_page(request.home_page); }
    ReportFiles write_person(const PersonReport& report, const ReportRequest& request) const override {
        return write({report}, request);
    }
    ReportFiles write_cohort(const ReportSource& source, const ReportRequest& request,
                             const Progress& progress) const override {
        // Without the table of a cohort: it has no statements.
        const auto people = gather_people(source.store, source.session, request.cohort_id, source.tasks,
                                          source.program_version, progress);
        return people ? write(*people, request) : ReportFiles();
    }

  private:
    static ReportFiles write(const std::vector<PersonReport>& people, const ReportRequest& request) {
        save_report(request.path, xapi_statements(people, request.home_page));
        return {request.path};
    }
};

}  // namespace

const ReportWriter& xapi_writer() {
    static const XapiWriter writer;
    return writer;
}

}  // namespace fulcrum::ui
