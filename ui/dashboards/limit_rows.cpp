// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/limit_rows.h"

#include <QCoreApplication>
#include <algorithm>

#include "assessment/metrics/registry.h"
#include "assessment/scoring/gate_rules.h"
#include "assessment/scoring/taken_over.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

struct LimitWords {
    Q_DECLARE_TR_FUNCTIONS(fulcrum::ui::LimitsPage)
};

bool is_shown(const GateSpec& gate, const std::vector<const BenchmarkSet*>& sets) {
    return gate.kind == GateKind::benchmark ||
           std::any_of(sets.begin(), sets.end(), [&](const BenchmarkSet* set) {
               return set->find(gate.metric, gate.hand, gate.tissue) != nullptr;
           });
}

QString words_of_provisional(const ProvisionalLimit& limit) {
    const MetricDescriptor& metric = *find_metric(limit.metric);
    const bool higher = metric.direction == Direction::higher;
    const QString bound =
        limit.exclusive ? (higher ? LimitWords::tr("%1: more than %2") : LimitWords::tr("%1: less than %2"))
        : higher        ? LimitWords::tr("%1: at least %2")
                        : LimitWords::tr("%1: at most %2");
    return bound.arg(gate_name(limit.metric, limit.hand, limit.tissue),
                     figure_with_unit(limit.limit, metric.unit));
}

}  // namespace

QString gate_name(const std::string& metric, const std::string& hand, const std::string& tissue) {
    QString name = metric_text(metric);
    if (!hand.empty()) name += QStringLiteral(" · ") + hand_text(hand);
    if (!tissue.empty()) name += QStringLiteral(" · ") + asset_text(tissue);
    return name;
}

QString gate_name(const GateSpec& gate) {
    return gate_name(gate.metric, gate.hand, gate.tissue);
}

std::optional<double> limit_in(const BenchmarkSet& set, const GateSpec& gate) {
    return judge_gate(gate, {}, &set).limit;
}

std::vector<double> values_of(const std::vector<TriedAttempt>& attempts, const GateSpec& gate,
                              const std::vector<const BenchmarkSet*>& sets) {
    std::vector<double> values;
    for (const TriedAttempt& attempt : attempts) {
        if (std::none_of(sets.begin(), sets.end(),
                         [&](const BenchmarkSet* set) { return in_tissue_of(*set, attempt); }))
            continue;
        for (const database::GateRow& row : attempt.gates)
            if (row.metric == gate.metric && row.hand == gate.hand && row.tissue == gate.tissue && row.value)
                values.push_back(gated_value(*find_metric(gate.metric), *row.value));
    }
    return values;
}

std::vector<GateLimits> gate_limits(const TaskDefinition& task, const std::vector<const BenchmarkSet*>& sets,
                                    const std::vector<TriedAttempt>& attempts) {
    std::vector<GateLimits> gates;
    for (const GateSpec& gate : task.gates) {
        if (!is_shown(gate, sets)) continue;
        GateLimits row;
        row.name = gate_name(gate);
        row.unit = text(find_metric(gate.metric)->unit);
        if (gate.kind == GateKind::absolute)
            row.name = LimitWords::tr("%1 (limit of the task: %2)")
                           .arg(row.name, figure_with_unit(gate.limit, row.unit.toStdString()));
        row.higher_is_better = find_metric(gate.metric)->direction == Direction::higher;
        for (const BenchmarkSet* set : sets) row.limits.push_back(limit_in(*set, gate));
        row.values = values_of(attempts, gate, sets);
        gates.push_back(std::move(row));
    }
    return gates;
}

QString taken_over_words(const TaskDefinition& task, const BenchmarkSet& set) {
    QStringList limits;
    for (const ProvisionalLimit& limit : taken_over(task, set).by_site) limits << words_of_provisional(limit);
    return limits.join(QStringLiteral("; "));
}

QString left_provisional_words(const TaskDefinition& task, const BenchmarkSet& set) {
    if (set.provisional) return {};
    QStringList limits;
    for (const LeftProvisional& one : taken_over(task, set).left) {
        QString words = words_of_provisional(one.now);
        if (one.taken_over)
            words += LimitWords::tr(" (changed by an update since version %1 took it over)").arg(set.version);
        limits << words;
    }
    if (limits.isEmpty()) return {};
    return LimitWords::tr(
               "Provisional limits of the task that version %1 of the set does not take over: %2. "
               "Attempts are passed provisionally, and nobody becomes proficient by them, until "
               "the set is built again and put in force.")
        .arg(QString::number(set.version), limits.join(QStringLiteral("; ")));
}

QString share_of(int part, int all) {
    return all == 0 ? QStringLiteral("–")
                    : LimitWords::tr("%1 of %2 (%3 %)").arg(part).arg(all).arg(qRound(100.0 * part / all));
}

QStringList pass_columns() {
    return {LimitWords::tr("Set"),          LimitWords::tr("Made from"),  LimitWords::tr("Experts"),
            LimitWords::tr("Experts pass"), LimitWords::tr("Would pass"), LimitWords::tr("People")};
}

QStringList pass_cells(const QString& name, const BenchmarkSet& set, const TaskDefinition& task,
                       const std::vector<TriedAttempt>& attempts) {
    const TrialCount count = count_passes(task, attempts, set);
    QString passes = share_of(count.passed, count.attempts);
    if (count.not_judged > 0) passes += LimitWords::tr(", not judged: %1").arg(count.not_judged);
    return {name,
            asset_text(set.source),
            QString::number(set.experts.size()),
            QStringLiteral("%1 %").arg(qRound(100 * set.expert_pass_share)),
            passes,
            share_of(count.people_passed, count.people)};
}

}  // namespace fulcrum::ui
