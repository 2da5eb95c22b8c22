// SPDX-License-Identifier: GPL-3.0-or-later
// What the page of building limits says about a set that was built.
#include <QCoreApplication>

#include "sim_core/scene/fidelity.h"
#include "sim_core/scene/standard_names.h"
#include "ui/dashboards/benchmark_page.h"
#include "ui/dashboards/limit_rows.h"
#include "ui/style/text.h"

namespace fulcrum::ui {

QString BenchmarkPage::key_text(const BenchmarkKey& key) const {
    QStringList parts{context().task_title(key.task), device_class_text(key.device_class)};
    if (key.variant != standard_variant) parts << context().variant_title(key.task, key.variant);
    const NameRow<FidelityLevel>* fidelity = find_row(fidelity_levels, key.fidelity);
    if (fidelity != nullptr && key.fidelity != standard_fidelity)
        parts << QCoreApplication::translate("fulcrum::fidelity", fidelity->title);
    return join_with_dots(parts);
}

/// What was left out, and which gates the experts themselves failed.
QStringList BenchmarkPage::explained() const {
    QStringList lines;
    if (built_->build.set) {
        for (const BenchmarkLevel& level : built_->build.set->levels) {
            const QString gate = gate_name(level.metric, level.hand, level.tissue);
            for (const std::string& expert : level.left_out)
                lines << tr("%1: %2 is left out, whose mean is more than 1.96 standard deviations from that "
                            "of the "
                            "experts.")
                             .arg(gate, text(expert));
            if (level.absolute_limit)
                lines << tr("%1: the limit is the worst value of the experts, %2.")
                             .arg(gate, figure_with_unit(*level.absolute_limit, level.unit));
        }
    }
    for (const BenchmarkFailure& failure : built_->build.failures)
        lines << tr("%1: failed by %2 of the experts' own attempts.")
                     .arg(failure.event.empty() ? gate_name(failure.metric, failure.hand, {})
                                                : capital(event_text(failure.event)))
                     .arg(failure.attempts);
    return lines;
}

/// What becomes of the task's provisional limits when the set is put in force.
QString BenchmarkPage::limits_of_site() const {
    if (!built_->build.set) return {};
    const BenchmarkSet& set = *built_->build.set;
    if (set.provisional)
        return tr(
            "Provisional: these attempts are simulated. Nobody becomes proficient by a pass with this "
            "set, and it takes over no limits of the task.");
    const QString limits = taken_over_words(built_->task, set);
    if (limits.isEmpty()) return {};
    return tr("Provisional limits of the task that the set takes over as limits of your site when you put it "
              "in force: %1. The experts' own attempts above were judged by them too.")
        .arg(limits);
}

}  // namespace fulcrum::ui
