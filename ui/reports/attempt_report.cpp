// SPDX-License-Identifier: GPL-3.0-or-later
// One attempt on paper and as data: verdict, gates, figures, where it leaves a specimen the pathology report,
// and the ratings that the trainee is shown.
#include <QCoreApplication>
#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "assessment/metrics/registry.h"
#include "assessment/metrics/statement_words.h"
#include "database/rows/force_devices.h"
#include "database/store/audit.h"
#include "ui/reports/paper.h"
#include "ui/reports/pathology_words.h"
#include "ui/reports/rating_words.h"
#include "ui/reports/report_rows.h"
#include "ui/reports/report_texts.h"
#include "ui/reports/specimen_map.h"
#include "ui/reports/unaccepted_files.h"
#include "ui/reports/void_words.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

/// Rows of equal cells across the paper; the first columns read from the left, figures from the right.
class Columns {
  public:
    Columns(Sheet& sheet, std::vector<double> shares, std::size_t words)
        : sheet_(sheet), shares_(std::move(shares)), words_(words) {}
    void row(const QStringList& cells) {
        double x = 0;
        for (std::size_t i = 0; i < shares_.size(); ++i) {
            const double width = shares_[i] * sheet_.width();
            sheet_.cell(x, width, cells[static_cast<int>(i)], i < words_ ? Qt::AlignLeft : Qt::AlignRight);
            x += width;
        }
        sheet_.to(sheet_.y() + sheet_.line_height() + Sheet::mm(0.6));
    }

  private:
    Sheet& sheet_;
    std::vector<double> shares_;
    std::size_t words_;
};

void head(Sheet& sheet, const AttemptPaper& paper) {
    const database::AttemptSummary& attempt = paper.report.attempt;
    const bool voided = attempt.state == AttemptState::voided;
    sheet.new_page();
    if (paper.provenance.demo) sheet.watermark(ReportTexts::tr("DEMONSTRATION"));
    sheet.font(9, false, paper_palette().muted);
    sheet.paragraph(join_with_dots(
        {text(paper.provenance.programme), capital(ReportTexts::tr("report on one attempt"))}));
    sheet.font(17, true);
    sheet.paragraph(join_with_dots({text(attempt.meta.task_id), asset_text(paper.task.title)}));
    sheet.font(9, false, paper_palette().muted);
    sheet.paragraph(
        join_with_dots({text(attempt.person_name), local_time(attempt.meta.started),
                        mode_text(attempt.meta.mode), device_class_text(attempt.meta.device_class),
                        attempt_state(voided ? attempt.recorded_state : attempt.state)}));
    if (attempt.meta.rig_use) sheet.paragraph(rig_text(attempt.meta.device, *attempt.meta.rig_use));
    const bool operated = attempt.meta.device_class == DeviceClass::synthetic;
    if (operated || attempt.synthetic || paper.provenance.demo) {
        sheet.font(9, true, paper_palette().bad);
        sheet.paragraph(
            operated
                ? ReportTexts::tr("Performed by a simulated operator, not by a person.")
                : ReportTexts::tr("Performed in the demonstration, on the account of a synthetic person."));
    }
    if (attempt.provisional) {
        sheet.font(9, true, paper_palette().bad);
        sheet.paragraph(ReportTexts::tr(
            "Provisional limits (of synthetic operators, or of the task itself): they allow \"passed "
            "(provisional)\", never proficiency or a certificate."));
    }
    if (const QString note = unaccepted_note(paper.unaccepted); !note.isEmpty()) {
        sheet.font(9, true, paper_palette().bad);
        sheet.paragraph(note);
    }
    // A voided attempt has no result: it may be that of another person.
    sheet.font(11, true, voided ? paper_palette().muted : paper_palette().text);
    sheet.paragraph(voided ? capital(attempt_state(attempt.state))
                           : join_with_dots({capital(verdict(attempt.passed, attempt.provisional)),
                                             attempt.points && attempt.passed ? points_text(*attempt.points)
                                                                              : QString()}));
    sheet.font(9);
    for (const QString& note : void_notes(attempt)) sheet.paragraph(note);
    const QString advice = paper.report.score ? statement_text(paper.report.score->advice) : QString();
    const QString reason = statement_text(attempt.not_scored_because);
    // Where nothing was scored the advice says why.
    if (attempt.meta.origin)
        sheet.paragraph(ReportTexts::tr(
            "Practice from a moment of another attempt or of a demonstration: a part of the task, never "
            "scored."));
    else if (!voided && !attempt.passed && !advice.contains(reason))
        sheet.paragraph(ReportTexts::tr("Not scored: %1").arg(reason));
    if (!advice.isEmpty()) sheet.paragraph(advice);
    sheet.skip(2);
}

void gates(Sheet& sheet, const database::ScoreRow& score) {
    if (score.gates.empty()) return;
    Columns columns(sheet, {0.36, 0.16, 0.15, 0.15, 0.18}, 2);
    sheet.font(8, true, paper_palette().muted);
    columns.row({capital(ReportTexts::tr("gate")), capital(ReportTexts::tr("hand")),
                 capital(ReportTexts::tr("value")), capital(ReportTexts::tr("limit")),
                 capital(ReportTexts::tr("result"))});
    sheet.rule();
    for (const database::GateRow& gate : score.gates) {
        const MetricDescriptor* metric = find_metric(gate.metric);
        const bool higher = metric != nullptr && metric->direction == Direction::higher;
        const bool missed = gate.passed && !*gate.passed;
        sheet.font(8, false, missed ? paper_palette().bad : paper_palette().text);
        columns.row({metric_text(gate.metric), hand_text(gate.hand), figure_with_unit(gate.value, gate.unit),
                     gate.limit ? (higher ? QStringLiteral("≥ ") : QStringLiteral("≤ ")) +
                                      figure_with_unit(gate.limit, gate.unit)
                                : ReportTexts::tr("none"),
                     gate.passed ? (*gate.passed ? ReportTexts::tr("met") : ReportTexts::tr("not met"))
                                 : ReportTexts::tr("not judged")});
    }
    sheet.skip(2);
}

/// Where the foot of a page begins.
double foot_of(const Sheet& sheet) {
    return sheet.height() - Sheet::mm(footer_mm + 3);
}

/// `turn`: begins a new page, with a foot on the one before.
void pathology(Sheet& sheet, const PathologyReport& report, const std::function<void()>& turn) {
    sheet.font(12, true);
    sheet.paragraph(ReportTexts::tr("Pathology report (simulated)"));
    sheet.skip(1);
    sheet.font(7.5);
    const double unit = dots_per_inch / 96.0;
    const QFontMetricsF metrics(sheet.painter().font(), sheet.painter().device());
    const double map = specimen_map_layout(report, sheet.width(), metrics, unit).height;
    if (sheet.y() + map + Sheet::mm(45) > foot_of(sheet)) {
        turn();
        sheet.font(7.5);
    }
    paint_specimen_map(sheet.painter(), QPointF(0, sheet.y()), sheet.width(), report, paper_palette(), unit);
    sheet.to(sheet.y() + map);
    sheet.skip(1.5);
    for (const PathologyLine& line : pathology_lines(report)) {
        sheet.font(8.5, true, paper_palette().muted);
        const double top = sheet.y();
        sheet.cell(0, sheet.width() * 0.27, line.title);
        sheet.font(8.5, false, line.bad ? paper_palette().bad : paper_palette().text);
        const QRectF room(sheet.width() * 0.27, top, sheet.width() * 0.73, sheet.height());
        QRectF used;
        sheet.painter().drawText(room, Qt::TextWordWrap, line.words, &used);
        sheet.to(used.bottom() + Sheet::mm(0.8));
    }
    sheet.skip(1.5);
    const std::vector<QStringList> rows = pathology_rows(report);
    sheet.font(8);
    // The table, its head and its legend stay together.
    const double table =
        static_cast<double>(rows.size() + 2) * (sheet.line_height() + Sheet::mm(0.6)) + Sheet::mm(13);
    if (sheet.y() + table > foot_of(sheet)) turn();
    Columns columns(sheet, {0.06, 0.10, 0.10, 0.105, 0.10, 0.10, 0.105, 0.105, 0.125, 0.10}, 2);
    sheet.font(6.2, true, paper_palette().muted);
    columns.row(pathology_columns());
    sheet.rule();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (i == report.findings.size()) sheet.rule();
        sheet.font(8, i >= report.findings.size());
        columns.row(rows[i]);
    }
    sheet.skip(1);
    sheet.font(7, false, paper_palette().muted);
    sheet.paragraph(pathology_legend(report));
}

using Rated = std::vector<const database::RatingRow*>;

/// A table of one form: its items by raters, then the totals and what raters wrote.
void rating_table(Sheet& sheet, const Rated& raters) {
    constexpr int longest_remark = 400;
    const ObserverForm& form = raters.front()->form;
    sheet.font(9, true);
    sheet.paragraph(form_text(form.title));
    std::vector<double> shares{0.40};
    QStringList names{capital(ReportTexts::tr("item"))}, totals{capital(ReportTexts::tr("total"))};
    for (const database::RatingRow* one : raters) {
        shares.push_back(0.60 / static_cast<double>(raters.size()));
        names << text(one->rater_name);
        totals << rating_sum_text(form, one->answers);
    }
    Columns columns(sheet, shares, 1);
    sheet.font(8, true, paper_palette().muted);
    columns.row(names);
    sheet.rule();
    sheet.font(8);
    for (std::size_t i = 0; i < form.items.size(); ++i) {
        QStringList cells{form_text(form.items[i].title)};
        for (const database::RatingRow* one : raters)
            cells << rating_answer_text(form.items[i], one->answers[i]);
        columns.row(cells);
    }
    sheet.font(8, true);
    columns.row(totals);
    sheet.font(8);
    for (const database::RatingRow* one : raters) {
        QString remark = text(one->remark).simplified();
        if (remark.size() > longest_remark) remark = remark.left(longest_remark) + QStringLiteral(" …");
        const QString line = join_with_dots(
            {text(one->rater_name), local_time(one->handed_in), blinding_text(one->blinding), remark});
        sheet.paragraph(line);
    }
    sheet.skip(3);
}

void ratings(Sheet& sheet, const AttemptPaper& paper, const std::function<void()>& turn) {
    constexpr std::size_t most_in_a_table = 5;
    std::map<std::string, Rated> by_form;
    for (const database::RatingRow& one : paper.ratings) by_form[one.form.name()].push_back(&one);
    bool titled = false;
    for (const auto& [name, all] : by_form) {
        for (std::size_t first = 0; first < all.size(); first += most_in_a_table) {
            const Rated some(
                all.begin() + static_cast<std::ptrdiff_t>(first),
                all.begin() + static_cast<std::ptrdiff_t>(std::min(all.size(), first + most_in_a_table)));
            const double lines = static_cast<double>(some.front()->form.items.size() + 4 + 5 * some.size());
            if (sheet.y() + lines * Sheet::mm(4.2) > foot_of(sheet)) turn();
            if (!titled) {
                sheet.skip(2);
                sheet.font(12, true);
                sheet.paragraph(ReportTexts::tr("Ratings with observer forms"));
                titled = true;
            }
            rating_table(sheet, some);
        }
    }
}

/// One line of the CSV: a figure of the attempt, its place where it belongs to one.
void csv_row(std::string& csv, const AttemptPaper& paper, const std::string& figure,
             const std::string& version, const std::string& hand, const std::string& tissue,
             const std::string& level, const std::string& sector, const std::optional<double>& value,
             const std::string& unit, const Statement& absent_because, const std::string& rater = {}) {
    const database::AttemptMeta& meta = paper.report.attempt.meta;
    for (const std::string& cell :
         {csv_text(meta.id), csv_text(paper.report.attempt.person_login), csv_text(meta.task_id),
          database::iso_utc(meta.started), csv_text(figure), version, hand, csv_text(tissue), level, sector,
          csv_number(value), csv_text(unit), csv_text(words_of(absent_because)), csv_text(rater)})
        csv += cell + ",";
    csv.back() = '\r';
    csv += '\n';
}

void csv_finding(std::string& csv, const AttemptPaper& paper, const SectorFinding& finding,
                 const std::string& version) {
    const std::string level = finding.level < 0 ? "all" : std::to_string(finding.level + 1);
    const auto row = [&](const char* name, const std::optional<double>& value, double scale,
                         const char* unit) {
        csv_row(csv, paper, name, version, "", "", level, sector_name(finding.sector),
                value ? std::optional<double>(*value * scale) : std::nullopt, unit,
                value ? Statement() : StatementId::sector_uncut);
    };
    row("pathology.divided", finding.divided, 100, "%");
    row("pathology.median", finding.plane.median, 1e3, "mm");
    row("pathology.p95", finding.plane.p95, 1e3, "mm");
    row("pathology.side", finding.plane.side, 1e3, "mm");
    row("pathology.worst", finding.plane.worst, 1e3, "mm");
    row("pathology.in_plane", finding.plane.in_plane, 100, "%");
    row("pathology.too_deep", finding.plane.too_deep, 100, "%");
    row("pathology.too_shallow", finding.plane.too_shallow, 100, "%");
    row("pathology.defect", finding.defect, 1e3, "mm");
}

void csv_rating(std::string& csv, const AttemptPaper& paper, const database::RatingRow& rating) {
    const std::string form = "rating." + rating.form.id + ".", version = std::to_string(rating.form.version);
    for (std::size_t i = 0; i < rating.form.items.size(); ++i) {
        const std::optional<int>& answer = rating.answers[i];
        csv_row(csv, paper, form + rating.form.items[i].id, version, "", "", "", "",
                answer ? std::optional<double>(*answer) : std::nullopt, "-",
                answer ? Statement() : Statement::plain("not seen"), rating.rater_name);
    }
}

}  // namespace

AttemptPaper gather_attempt(const database::Store& store, const database::Session& session,
                            const std::string& attempt_id, const std::vector<TaskDefinition>& tasks,
                            const std::string& program_version) {
    AttemptPaper paper;
    paper.report =
        database::Reports(store).attempt_report(session, attempt_id, database::ReportPurpose::exported);
    paper.provenance = provenance_of(store, session, program_version);
    take_basis(paper.provenance, paper.report);
    paper.unaccepted = unaccepted_files(store, session, paper.report.attempt);
    paper.provenance.attempt_key = database::Audit(store).signer_of(attempt_id);
    paper.task = {paper.report.attempt.meta.task_id, paper.report.attempt.meta.task_id, ""};
    for (const TaskDefinition& task : tasks)
        if (task.id == paper.task.id) paper.task = {task.id, task.title, task.stage};
    const database::Subject person = database::Subject::person(paper.report.attempt.meta.person_id);
    if (store.allowed(session, database::Operation::read_ratings, person))
        for (const database::RatingRow& row : database::Ratings(store).of_attempt(session, attempt_id).rows)
            if (row.released > 0) paper.ratings.push_back(row);
    return paper;
}

void write_attempt_pdf(const AttemptPaper& paper, const std::string& path) {
    Sheet sheet(path, false,
                ReportTexts::tr("Attempt of %1, %2")
                    .arg(text(paper.report.attempt.person_name), text(paper.task.id)));
    head(sheet, paper);
    if (paper.report.score) gates(sheet, *paper.report.score);
    const QString n = ReportTexts::tr("attempt %1").arg(text(paper.report.attempt.meta.id));
    const auto turn = [&] {
        footer(sheet, paper.provenance, n);
        sheet.new_page();
        if (paper.provenance.demo) sheet.watermark(ReportTexts::tr("DEMONSTRATION"));
    };
    if (paper.report.pathology) pathology(sheet, *paper.report.pathology, turn);
    ratings(sheet, paper, turn);
    footer(sheet, paper.provenance, n);
    sheet.finish();
}

std::string attempt_csv(const AttemptPaper& paper) {
    std::string csv =
        "attempt_id,login,task,started_utc,figure,version,hand,tissue,level,sector,value,unit,absent_"
        "because,rater\r\n"
        "-,-,-,-,-,-,-,-,-,-,as unit says,-,-,-\r\n";
    // The values may be those of another person.
    if (const database::AttemptSummary& attempt = paper.report.attempt; attempt.state == AttemptState::voided)
        csv_row(csv, paper, "voided", "", "", "", "", "", {}, "-", Statement::plain(attempt.void_reason));
    for (const database::AssetFile& file : paper.unaccepted)
        csv_row(csv, paper, "file_not_accepted", "", "", "", "", "", {}, "-",
                Statement::plain(joined_assets({file})));
    if (paper.report.score) {
        for (const database::MetricRow& metric : paper.report.score->metrics)
            csv_row(csv, paper, metric.id, std::to_string(metric.version), metric.hand, metric.tissue, "", "",
                    metric.value, metric.unit.empty() ? "-" : metric.unit, metric.absent_because);
    }
    if (paper.report.pathology) {
        const std::string version = std::to_string(paper.report.pathology->version);
        for (const SectorFinding& finding : paper.report.pathology->findings)
            csv_finding(csv, paper, finding, version);
        for (const SectorFinding& finding : paper.report.pathology->sectors)
            csv_finding(csv, paper, finding, version);
    }
    for (const database::RatingRow& rating : paper.ratings) csv_rating(csv, paper, rating);
    return csv;
}

std::string attempt_json(const AttemptPaper& paper) {
    using Json = nlohmann::ordered_json;
    const database::AttemptSummary& attempt = paper.report.attempt;
    const auto number = [](const std::optional<double>& value) {
        return value ? Json(*value) : Json(nullptr);
    };
    const auto words = [](const std::string& value) { return value.empty() ? Json(nullptr) : Json(value); };
    Json gates = Json::array(), metrics = Json::array();
    if (paper.report.score) {
        for (const database::GateRow& gate : paper.report.score->gates)
            gates.push_back({{"metric", gate.metric},
                             {"hand", words(gate.hand)},
                             {"tissue", words(gate.tissue)},
                             {"kind", row_of(gate_kinds, gate.kind).name},
                             {"value", number(gate.value)},
                             {"unit", gate.unit},
                             {"limit", number(gate.limit)},
                             {"limit_source", words(gate.limit_source)},
                             {"z", number(gate.z)},
                             {"passed", gate.passed ? Json(*gate.passed) : Json(nullptr)},
                             {"absent_because", words(words_of(gate.not_passed_because))},
                             {"absent_code", statement_json(gate.not_passed_because)},
                             {"provisional", gate.provisional}});
        for (const database::MetricRow& metric : paper.report.score->metrics)
            metrics.push_back(metric_json(metric));
    }
    Json ratings = Json::array();
    for (const database::RatingRow& rating : paper.ratings) ratings.push_back(rating_json(rating));
    Json continues = nullptr;
    if (const auto& origin = attempt.meta.origin)
        continues = {{"attempt", words(origin->source_id)}, {"tick", origin->tick}, {"goal", origin->goal}};
    Json unaccepted = Json::array();
    for (const database::AssetFile& file : paper.unaccepted)
        unaccepted.push_back({{"file", file.name}, {"sha256", file.digest}});
    Json voided = nullptr;
    if (attempt.state == AttemptState::voided)
        voided = {{"time", database::iso_utc(attempt.voided_at)}, {"reason", attempt.void_reason}};
    const Json document = {
        {"report", "attempt"},
        {"attempt", attempt.meta.id},
        {"person",
         {{"id", attempt.meta.person_id}, {"login", attempt.person_login}, {"name", attempt.person_name}}},
        {"synthetic", attempt.synthetic},
        {"task", attempt.meta.task_id},
        {"started", database::iso_utc(attempt.meta.started)},
        {"device_class", row_of(device_classes, attempt.meta.device_class).name},
        {"device", Json::parse(database::device_json(attempt.meta.device, attempt.meta.rig_use))},
        {"mode", row_of(attempt_modes, attempt.meta.mode).name},
        {"files_not_accepted", std::move(unaccepted)},
        {"state", row_of(attempt_states, attempt.state).name},
        {"voided", std::move(voided)},
        {"duration_s", attempt.duration_s},
        {"passed", attempt.passed ? Json(*attempt.passed) : Json(nullptr)},
        {"provisional", attempt.provisional},
        {"continues", std::move(continues)},
        {"not_scored_because",
         words(why_not_scored(attempt.not_scored_because, attempt.meta.origin.has_value()))},
        {"not_scored_code", statement_json(attempt.not_scored_because)},
        {"points", number(attempt.points)},
        {"gates", std::move(gates)},
        {"metrics", std::move(metrics)},
        {"pathology",
         paper.report.pathology ? Json::parse(pathology_json(*paper.report.pathology)) : Json(nullptr)},
        {"ratings", std::move(ratings)},
        {"signed_by", words(paper.provenance.attempt_key.value_or(""))},
        {"provenance", provenance_json(paper.provenance)}};
    return document.dump(2) + "\n";
}

}  // namespace fulcrum::ui
