// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/fidelity_page.h"

#include <algorithm>
#include <cmath>

#include "sim_core/lab/chart.h"

namespace fulcrum::app {
namespace {

using lab::short_number;

std::string name_of(FidelityLevel level) {
    return row_of(fidelity_levels, level).name;
}

std::string percent_text(const MetricShift& row) {
    if (row.shift.shift == 0 && row.low() == 0 && row.high() == 0) return "0";
    return short_number(row.percent(), 3) + " (" + short_number(row.low(), 3) + " to " +
           short_number(row.high(), 3) + ")";
}

std::string metric_text(const MetricShift& row) {
    return row.metric + (row.hand.empty() ? "" : " " + row.hand);
}

std::string worst_text(const Comparison& comparison) {
    const MetricShift* worst = comparison.worst();
    if (worst == nullptr || worst->shift.shift == 0) return "none moves";
    return metric_text(*worst) + " " + percent_text(*worst);
}

std::string flips_text(const Comparison& comparison) {
    std::string text = std::to_string(comparison.flips.size()) + " of " + std::to_string(comparison.pairs);
    if (comparison.flips.empty()) return text;
    text += ", " + std::to_string(comparison.to_passed) + " to passed; seeds";
    constexpr std::size_t most = 6;
    for (std::size_t i = 0; i < std::min(most, comparison.flips.size()); ++i)
        text += " " + std::to_string(comparison.flips[i]);
    return comparison.flips.size() > most ? text + " ..." : text;
}

const char* holding_text(Holding holding) {
    switch (holding) {
        case Holding::holds:
            return "yes";
        case Holding::undecided:
            return "not decided";
        case Holding::moves:
            break;
    }
    return "no";
}

const LevelAnswer* level_of(const TaskAnswer& answer, FidelityLevel level) {
    for (const LevelAnswer& one : answer.levels)
        if (one.level == level) return &one;
    return nullptr;
}

/// The answer for one task, and whether its scene has this fidelity.
std::string sentence_of(const TaskAnswer& answer) {
    const std::string own = answer.task.fidelity, named = name_of(answer.cheapest);
    if (answer.identical())
        return "any fidelity: no part of the scene depends on it, and every value is the same. The scene "
               "keeps " +
               own + ".";
    std::string text = "**" + named + "**";
    text += answer.cheapest == FidelityLevel::fine ? ": no cheaper one gives the score that fine gives."
                                                   : " is enough.";
    if (own == named) return text + " It is the fidelity of the scene.";
    text += " The scene has " + own;
    const LevelAnswer *cheapest = level_of(answer, answer.cheapest), *used = nullptr;
    for (const LevelAnswer& level : answer.levels)
        if (name_of(level.level) == own) used = &level;
    if (used == nullptr) return text + ".";
    const std::string ratio = short_number(cheapest->processor_ms / used->processor_ms, 2);
    switch (used->holding()) {
        case Holding::holds:
            text += ", which gives the same score.";
            break;
        case Holding::undecided:
            text += ", for which these seeds do not decide.";
            break;
        case Holding::moves:
            text += ", with which the score is another one.";
            break;
    }
    return text + " " + named + " takes " + ratio +
           " times its processor time. The scene is not changed here: its benchmark set belongs to its "
           "fidelity.";
}

void add_answer(lab::ResultPage& page, const std::vector<TaskAnswer>& answers) {
    lab::ResultTable table;
    table.name = "fidelity_score_answer";
    table.columns = {"task",
                     "seeds",
                     "fidelity",
                     "processor time, ms for 1 s",
                     "performed: largest shift of a gated metric, %",
                     "performed: verdicts that change",
                     "replayed: largest shift, %",
                     "replayed: verdicts that change",
                     "score as at fine"};
    for (const TaskAnswer& answer : answers) {
        for (const LevelAnswer& level : answer.levels) {
            const bool finest = level.level == FidelityLevel::fine;
            const bool named = level.level == answer.cheapest;
            table.rows.push_back(
                {answer.task.id, std::to_string(answer.seeds),
                 named ? "**" + name_of(level.level) + "**" : name_of(level.level),
                 short_number(level.processor_ms), finest ? "reference" : worst_text(level.performed),
                 finest ? "" : flips_text(level.performed), finest ? "" : worst_text(level.replayed),
                 finest ? "" : flips_text(level.replayed), finest ? "" : holding_text(level.holding())});
        }
    }
    page.table(table);
}

void add_chance(lab::ResultPage& page, const std::vector<TaskAnswer>& answers) {
    page.heading("What chance does");
    page.paragraph(
        "The same operators at standard, performed twice; in the second attempt the handles are moved by 0.1 "
        "um, "
        "the smallest step that a device reports. An operator reacts to what it sees, so a contact that "
        "comes a millisecond later makes another attempt. What a fidelity changes while an operator performs "
        "contains this part; a shift no larger than this one is not the fidelity's.");
    lab::ResultTable table;
    table.name = "fidelity_score_chance";
    table.columns = {"task", "largest shift of a gated metric, %", "verdicts that change"};
    for (const TaskAnswer& answer : answers)
        table.rows.push_back({answer.task.id, worst_text(answer.chance), flips_text(answer.chance)});
    page.table(table);
}

const MetricShift* shift_of(const Comparison& comparison, const std::string& metric) {
    for (const MetricShift& row : comparison.shifts)
        if (metric_text(row) == metric) return &row;
    return nullptr;
}

void add_metrics(lab::ResultPage& page, const TaskAnswer& answer, bool gated) {
    lab::ResultTable table;
    table.name = "fidelity_score_" + answer.task.id + (gated ? "_gated" : "_other");
    table.columns = {"metric", "mean at fine"};
    std::vector<std::string> metrics;
    const LevelAnswer* finest = level_of(answer, FidelityLevel::fine);
    for (const MetricShift& row : finest->performed.shifts)
        if (row.gated == gated) metrics.push_back(metric_text(row));
    for (const LevelAnswer& level : answer.levels) {
        if (level.level == FidelityLevel::fine) continue;
        table.columns.push_back(name_of(level.level) + ", performed, %");
        table.columns.push_back(name_of(level.level) + ", replayed, %");
    }
    for (const std::string& metric : metrics) {
        std::vector<std::string> cells = {metric,
                                          short_number(shift_of(finest->performed, metric)->shift.reference)};
        for (const LevelAnswer& level : answer.levels) {
            if (level.level == FidelityLevel::fine) continue;
            for (const Comparison* comparison : {&level.performed, &level.replayed}) {
                const MetricShift* row = shift_of(*comparison, metric);
                std::string cell = row == nullptr ? "fewer than 2 pairs" : percent_text(*row);
                if (row != nullptr && row->one_sided > 0)
                    cell += "; " + std::to_string(row->one_sided) + " without a pair";
                if (gated && row != nullptr && std::fabs(row->percent()) > allowed_percent)
                    cell = "**" + cell + "**";
                cells.push_back(cell);
            }
        }
        table.rows.push_back(std::move(cells));
    }
    page.table(table);
}

}  // namespace

lab::ResultPage fidelity_page(const FidelityStudy& study, const std::vector<TaskAnswer>& answers) {
    lab::ResultPage page("fidelity_score", "Fidelity and score",
                         "fulcrum lab fidelity --output docs/results");
    std::string intro = "How coarse may the simulation of a task be before its score changes?";
    for (const TaskAnswer& answer : answers) intro += "\n- " + answer.task.id + ": " + sentence_of(answer);
    page.paragraph(intro);
    page.chart("fidelity_score", "largest shift of a gated metric and processor time at each fidelity",
               fidelity_chart(answers));
    add_answer(page, answers);
    page.paragraph(
        "The attempts were simulated by the program at commit " + study.commit + ", physics version " +
        std::to_string(study.physics) +
        ". *Performed*: the same synthetic operators (seeds from 3000: expert, intermediate and novice in "
        "turn) perform the task at every fidelity. *Replayed*: the input that each of them gave at standard, "
        "at every fidelity; after its end the hands keep still for 5 s. Every attempt is judged by the same "
        "limits. Shift: mean of the paired "
        "differences to fine, in percent of the metric's mean size at fine or of its limit, whichever is "
        "larger (of counts at least 1; of points: 100), with Student's 95 % t interval over the seeds, not "
        "corrected for the number of metrics. A verdict changes where passed, failed or not scored is not "
        "what it is at fine.");
    page.paragraph(
        "*Score as at fine*: yes where no verdict changes and the interval of every gated metric is within "
        "2 %, performed and replayed; not decided where no estimate is beyond 2 % but an interval does. "
        "The answer is the level with the least processor time of those with yes; the finest always is one. "
        "Levels within 5 % of that time, and those with identical attempts, cost the same.");
    add_chance(page, answers);
    for (const TaskAnswer& answer : answers) {
        page.heading(answer.task.id + ": every metric");
        page.paragraph("Task version " + std::to_string(answer.task.version) + ", limits " +
                       (answer.task.limits.empty() ? "none" : answer.task.limits) + ", " +
                       std::to_string(answer.seeds) + " seeds. Gated metrics:");
        add_metrics(page, answer, true);
        page.paragraph("<details><summary>Metrics without a gate, and points</summary>");
        add_metrics(page, answer, false);
        page.paragraph("</details>");
    }
    page.document(to_json(study));
    return page;
}

}  // namespace fulcrum::app
