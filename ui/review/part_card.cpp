// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/part_card.h"

#include "ui/charts/time_chart.h"
#include "ui/review/attempt_model.h"
#include "ui/style/flow_row.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

PartCard::PartCard(QWidget* parent) : QFrame(parent) {
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 14, 18, 14);
    layout->setSpacing(6);
    layout->addWidget(make_label(tr("Metrics of a part"), "heading"));
    layout->addWidget(make_label(
        tr("Choose a step, hold Shift and drag in a chart, or set the replay to a moment and start or "
           "end the part there.") +
            QLatin1Char('\n') + TimeChart::key_words(),
        "muted"));
    part_ = new PartChoice(QStringLiteral("review"));
    layout->addWidget(part_);
    zoom_ = make_button(tr("Zoom to the part"), "review_part_zoom", "link");
    layout->addWidget(zoom_, 0, Qt::AlignLeft);
    table_ = new ComparisonTable("part_table");
    layout->addWidget(table_);
    measure_ = new PartMeasure(this);
    connect(part_, &PartChoice::part_changed, this, &PartCard::show_part);
    connect(part_, &PartChoice::step_begins, this, &PartCard::time_chosen);
    connect(zoom_, &QPushButton::clicked, this, [this] { emit zoom_wanted(part_->from(), part_->to()); });
    connect(measure_, &PartMeasure::failed, this, &PartCard::failed);
    connect(measure_, &PartMeasure::measured, this, [this](const auto& of) {
        const auto whole = model_->score ? compared_metrics(model_->score->metrics, task_->metrics)
                                         : std::vector<ComparedMetric>();
        table_->show_part(of[0], whole);
    });
}

void PartCard::open(std::shared_ptr<const AttemptModel> model, const TaskDefinition* task) {
    close();
    model_ = std::move(model);
    if (task != nullptr) task_ = *task;
    setVisible(model_->summary.meta.keep_trace);
    part_->open({}, nullptr, model_->begin, model_->duration, false);
}

void PartCard::set_record(std::shared_ptr<const AttemptModel> model, const std::optional<Scene>& scene) {
    model_ = std::move(model);
    scene_ = scene;
    part_->open(phase_moments(model_->trace->events, model_->tick, model_->duration),
                task_ ? &*task_ : nullptr, model_->begin, model_->duration, model_->trace->tick_count() > 0);
}

void PartCard::close() {
    measure_->cancel();
    model_.reset();
    task_.reset();
    scene_.reset();
    table_->clear();
    table_->hide();
    zoom_->hide();
}

void PartCard::show_part() {
    if (model_ == nullptr) return;
    measure_->cancel();
    table_->clear();
    const bool part = part_->is_part(), measurable = part && task_ && scene_;
    zoom_->setVisible(part);
    table_->setVisible(measurable);
    if (part && !measurable)
        part_->set_note(tr("; no metrics of a part, because this program does not have the task"));
    emit part_changed(part_->from(), part_->to());
    if (measurable)
        measure_->measure({{model_->trace, scene_, model_->summary.meta.seed, part_->from(), part_->to()}},
                          *task_);
}

}  // namespace fulcrum::ui

#include "moc_part_card.cpp"
