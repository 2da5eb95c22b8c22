// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/part_choice.h"

#include <QComboBox>
#include <algorithm>
#include <utility>

#include "database/scoring/range_metrics.h"
#include "ui/page/background_job.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr double least_part_s = 0.2;

}  // namespace

PartChoice::PartChoice(const QString& prefix, QWidget* parent) : QWidget(parent) {
    const auto named = [&prefix](const char* rest) { return (prefix + QLatin1String(rest)).toLatin1(); };
    auto* row = new FlowRow(this);
    QLabel* name = make_label(tr("Part"));
    name->setWordWrap(false);
    row->add(name);
    step_ = make_narrow_choice(named("_step"), tr("Part of the attempt"), 14);
    row->add(step_, 1, with_text(180));
    begin_ = make_button(tr("Start part here"), named("_part_begin"));
    end_ = make_button(tr("End part here"), named("_part_end"));
    whole_ = make_button(tr("Whole attempt"), named("_part_whole"));
    for (QPushButton* button : {begin_, end_, whole_}) row->add(button);
    words_ = make_label({}, "muted");
    words_->setObjectName(prefix + QStringLiteral("_part_words"));
    row->add(words_, 2, with_text(220));
    connect(step_, QOverload<int>::of(&QComboBox::activated), this, &PartChoice::choose_step);
    connect(begin_, &QPushButton::clicked, this, [this] {
        const double end = is_part() ? to_ : last_;
        choose(moment_, std::max(end, moment_ + least_part_s));
    });
    connect(end_, &QPushButton::clicked, this,
            [this] { choose(std::min(from_, moment_ - least_part_s), moment_); });
    connect(whole_, &QPushButton::clicked, this, [this] { choose(0, 0); });
    show_words();
}

void PartChoice::open(const PhaseMoments& moments, const TaskDefinition* task, double first, double last,
                      bool usable) {
    from_ = to_ = 0;
    moment_ = first_ = first;
    last_ = last;
    usable_ = usable;
    note_.clear();
    const QSignalBlocker quiet(step_);
    step_->clear();
    step_->addItem(tr("Whole attempt"));
    double from = std::max(moments.begin, first);
    std::vector<std::pair<double, int>> in_order;
    for (const auto& [goal, time] : moments.met) in_order.emplace_back(time, goal);
    std::sort(in_order.begin(), in_order.end());
    for (const auto& [time, goal] : in_order) {
        const bool known =
            task != nullptr && goal >= 0 && static_cast<std::size_t>(goal) < task->goals.size();
        if (!known || time - from < least_part_s) continue;
        step_->addItem(
            tr("Step %1: %2").arg(goal + 1).arg(asset_text(task->goals[static_cast<std::size_t>(goal)].text)),
            QPointF(from, time));
        from = time;
    }
    for (QWidget* control : std::initializer_list<QWidget*>{step_, begin_, end_}) control->setEnabled(usable);
    show_words();
}

void PartChoice::choose_step(int index) {
    const QPointF part = step_->itemData(index).toPointF();
    choose(part.x(), part.y());
    if (is_part()) emit step_begins(from_);
}

void PartChoice::choose(double from, double to) {
    if (!usable_) return;
    from_ = std::clamp(from, first_, last_);
    to_ = std::clamp(to, first_, last_);
    if (to_ - from_ < least_part_s) from_ = to_ = 0;
    note_.clear();
    const int known = is_part() ? step_->findData(QPointF(from_, to_)) : 0;
    if (known >= 0) {
        step_->setCurrentIndex(known);
    } else if (step_->itemData(step_->count() - 1).isNull() && step_->count() > 1) {
        step_->setCurrentIndex(step_->count() - 1);
    } else {
        step_->addItem(tr("Own range"));
        step_->setCurrentIndex(step_->count() - 1);
    }
    show_words();
    emit part_changed();
}

void PartChoice::set_note(const QString& note) {
    note_ = note;
    show_words();
}

void PartChoice::show_words() {
    const QString words =
        is_part() ? tr("%1 to %2").arg(clock_text(from_), clock_text(to_)) + note_ : QString();
    words_->setText(words);
    words_->setVisible(!words.isEmpty());
    whole_->setEnabled(is_part());
}

void PartMeasure::measure(std::vector<MeasuredPart> parts, const TaskDefinition& task) {
    cancel();
    auto found = std::make_shared<std::vector<std::vector<ComparedMetric>>>();
    job_ = BackgroundJob::run(
        this,
        [found, parts = std::move(parts), task, one = one_at_a_time_](const Progress& progress) {
            // A part that was chosen before lets go first: a long one takes hundreds of megabytes.
            const std::lock_guard alone(*one);
            RangeOptions options;
            options.stop = [&progress] { return !progress(0, {}); };
            for (const MeasuredPart& part : parts)
                found->push_back(
                    part.scene ? compared_metrics(metrics_of_range(*part.scene, task, part.seed, *part.trace,
                                                                   part.from, part.to, options))
                               : std::vector<ComparedMetric>());
        },
        [this, found] {
            job_ = nullptr;
            emit measured(*found);
        },
        [this](const QString& why) {
            job_ = nullptr;
            emit failed(why);
        });
}

void PartMeasure::cancel() {
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
}

}  // namespace fulcrum::ui

#include "moc_part_choice.cpp"
