// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/remedies_form.h"

#include <QComboBox>
#include <QListWidget>
#include <algorithm>
#include <initializer_list>

#include "assessment/metrics/registry.h"
#include "ui/dashboards/form_parts.h"
#include "ui/style/flow_row.h"
#include "ui/style/remedy_words.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr int most_remedies_of_a_task = 12;
constexpr double largest_bound = 1e6;
constexpr int least_bound_decimals = 3;

/// Adds it as it is in the file where it is not among the choices: its problem is shown.
void choose(QComboBox* box, const std::string& id) {
    int row = box->findData(text(id));
    if (row < 0) {
        box->addItem(RemediesForm::tr("%1 (not installed)").arg(text(id)), text(id));
        row = box->count() - 1;
    }
    box->setCurrentIndex(row);
}

std::string data_of(const QComboBox* box) {
    return plain(box->currentData().toString());
}

}  // namespace

RemediesForm::RemediesForm(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    problems_ = make_problems("remedies_problems");
    layout->addWidget(problems_);
    layout->addWidget(
        make_label(tr("Recommended to a trainee whose curve levels off below the pass mark: the remedy whose "
                      "metric is furthest beyond its bound, in the median of the latest five attempts."),
                   "muted"));
    list_ = new QListWidget;
    list_->setObjectName(QStringLiteral("remedies_list"));
    list_->setAccessibleName(tr("Remedies"));
    list_->setWordWrap(true);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setMinimumHeight(7 * fontMetrics().height());
    list_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    layout->addWidget(list_);
    layout->addLayout(make_buttons());
    fields_ = new QWidget;
    QFormLayout* form = make_form();
    form->setContentsMargins(0, 0, 0, 0);
    fields_->setLayout(form);
    metric_ = make_narrow_choice("remedy_metric", {}, 14);
    add_named(form, tr("Metric"), metric_);
    side_ = make_narrow_choice("remedy_side", {}, 8);
    side_->addItem(tr("above the bound"), true);
    side_->addItem(tr("below the bound"), false);
    add_named(form, tr("When it is"), side_);
    bound_ = new ExactBox;
    bound_->setObjectName(QStringLiteral("remedy_bound"));
    bound_->setRange(-largest_bound, largest_bound);
    bound_->setDecimals(least_bound_decimals);
    add_named(form, tr("Bound"), bound_);
    kind_ = make_narrow_choice("remedy_kind", {}, 14);
    kind_->addItem(tr("practise a part"), static_cast<int>(RemedyKind::practise_from));
    kind_->addItem(tr("another task"), static_cast<int>(RemedyKind::other_task));
    kind_->addItem(tr("another variant"), static_cast<int>(RemedyKind::other_variant));
    kind_->addItem(tr("practise with a ghost"), static_cast<int>(RemedyKind::ghost));
    kind_->addItem(tr("watch an expert"), static_cast<int>(RemedyKind::demonstration));
    kind_->addItem(tr("look at the replay"), static_cast<int>(RemedyKind::replay));
    add_named(form, tr("What to do"), kind_);
    target_ = make_narrow_choice("remedy_target", {}, 14);
    add_named(form, tr("Goal or task"), target_);
    variant_ = make_narrow_choice("remedy_variant", {}, 14);
    add_named(form, tr("Variant"), variant_);
    layout->addWidget(fields_);
    layout->addStretch(1);
    connect_parts();
    look();
}

QLayout* RemediesForm::make_buttons() {
    auto* row = new FlowRow;
    add_ = make_button(tr("Add a remedy"), "remedy_add");
    remove_ = make_button(tr("Remove"), "remedy_remove");
    up_ = make_button(tr("▲ Up"), "remedy_up");
    down_ = make_button(tr("▼ Down"), "remedy_down");
    for (QPushButton* button : {add_, remove_, up_, down_}) row->add(button);
    return row;
}

void RemediesForm::connect_parts() {
    connect(list_, &QListWidget::currentRowChanged, this, [this] {
        if (!setting_) show_remedy();
    });
    const auto edited = [this] {
        if (setting_ || chosen() == nullptr) return;
        read_remedy();
        show_remedy();
        fill_list(list_->currentRow());
        emit changed();
    };
    for (QComboBox* box : {metric_, side_, kind_, target_, variant_})
        connect(box, QOverload<int>::of(&QComboBox::activated), this, edited);
    connect(bound_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, edited);
    connect(add_, &QPushButton::clicked, this, &RemediesForm::add);
    connect(remove_, &QPushButton::clicked, this, [this] {
        if (chosen() == nullptr) return;
        const int row = list_->currentRow();
        remedies_.erase(remedies_.begin() + row);
        fill_list(std::min(row, static_cast<int>(remedies_.size()) - 1));
        show_remedy();
        if (!remove_->isEnabled()) list_->setFocus();
        emit changed();
    });
    connect(up_, &QPushButton::clicked, this, [this] { move(-1); });
    connect(down_, &QPushButton::clicked, this, [this] { move(1); });
}

void RemediesForm::set_tasks(const std::vector<TaskDefinition>& tasks) {
    tasks_ = &tasks;
}

const TaskDefinition* RemediesForm::find_task(const std::string& id) const {
    if (tasks_ == nullptr) return nullptr;
    const auto found =
        std::find_if(tasks_->begin(), tasks_->end(), [&](const TaskDefinition& one) { return one.id == id; });
    return found == tasks_->end() ? nullptr : &*found;
}

Remedy* RemediesForm::chosen() {
    const int row = list_->currentRow();
    return row >= 0 && row < static_cast<int>(remedies_.size()) ? &remedies_[static_cast<std::size_t>(row)]
                                                                : nullptr;
}

void RemediesForm::show_task(const CurriculumTask& task) {
    const int row = task.task == task_ ? std::max(0, list_->currentRow()) : 0;
    task_ = task.task;
    remedies_ = task.remedies;
    fill_list(std::min(row, static_cast<int>(remedies_.size()) - 1));
    show_remedy();
}

void RemediesForm::fill_list(int row) {
    setting_ = true;
    static const std::vector<TaskDefinition> none;
    list_->clear();
    int number = 0;
    for (const Remedy& remedy : remedies_)
        list_->addItem(QStringLiteral("%1.  %2").arg(++number).arg(
            remedy_words(remedy, task_, tasks_ == nullptr ? none : *tasks_)));
    list_->setCurrentRow(row);
    setting_ = false;
    look();
}

void RemediesForm::show_remedy() {
    const Remedy* remedy = chosen();
    look();
    if (remedy == nullptr) return;
    setting_ = true;
    metric_->clear();
    if (const TaskDefinition* own = find_task(task_))
        for (const std::string& id : own->metrics) metric_->addItem(metric_text(id), text(id));
    choose(metric_, remedy->metric);
    const MetricDescriptor* metric = find_metric(remedy->metric);
    side_->setCurrentIndex(side_->findData(remedy->above));
    side_->setEnabled(metric == nullptr || metric->direction == Direction::context ||
                      problem_of(*remedy).has_value());
    const QString unit = unit_text(remedy->unit);
    const QString suffix = unit.isEmpty() ? QString() : QLatin1Char(' ') + unit;
    if (suffix != bound_->suffix()) bound_->setSuffix(suffix);  // it writes what is being typed again
    bound_->show_value(remedy->bound, least_bound_decimals);
    kind_->setCurrentIndex(kind_->findData(static_cast<int>(remedy->kind)));
    show_target(*remedy);
    setting_ = false;
}

void RemediesForm::show_target(const Remedy& remedy) {
    const TaskDefinition* own = find_task(task_);
    const bool part = remedy.kind == RemedyKind::practise_from, task = remedy.kind == RemedyKind::other_task;
    target_->clear();
    variant_->clear();
    target_->setEnabled(part || task);
    variant_->setEnabled(task || remedy.kind == RemedyKind::other_variant);
    if (part && own != nullptr)
        for (std::size_t i = 1; i < own->goals.size(); ++i)
            target_->addItem(asset_text(own->goals[i].text), text(own->goals[i].id));
    if (task && tasks_ != nullptr)
        for (const TaskDefinition& one : *tasks_)
            if (one.id != task_)
                target_->addItem(text(one.id) + QLatin1Char(' ') + asset_text(one.title), text(one.id));
    if (part) choose(target_, remedy.goal);
    if (task) choose(target_, remedy.task);
    if (!variant_->isEnabled()) return;
    const TaskDefinition* of = task ? find_task(remedy.task) : own;
    if (task) variant_->addItem(tr("any"), QString());
    if (of != nullptr)
        for (const TaskVariant& one : of->variants) variant_->addItem(asset_text(one.title), text(one.id));
    choose(variant_, remedy.variant);
}

void RemediesForm::read_remedy() {
    Remedy& remedy = *chosen();
    const Remedy before = remedy;
    remedy.metric = data_of(metric_);
    remedy.above = side_->currentData().toBool();
    remedy.bound = bound_->exact_value();
    if (const MetricDescriptor* metric = find_metric(remedy.metric)) {
        remedy.unit = metric->unit;
        if (remedy.metric != before.metric && metric->direction != Direction::context)
            remedy.above = metric->direction == Direction::lower;
    }
    remedy.kind = static_cast<RemedyKind>(kind_->currentData().toInt());
    const bool same = remedy.kind == before.kind;
    remedy.goal.clear();
    remedy.task.clear();
    remedy.variant.clear();
    const TaskDefinition* own = find_task(task_);
    if (remedy.kind == RemedyKind::practise_from) {
        remedy.goal = same ? data_of(target_) : std::string();
        if (remedy.goal.empty() && own != nullptr && own->goals.size() > 1) remedy.goal = own->goals[1].id;
    } else if (remedy.kind == RemedyKind::other_task) {
        remedy.task = same ? data_of(target_) : std::string();
        if (remedy.task.empty() && tasks_ != nullptr)
            for (const TaskDefinition& one : *tasks_)
                if (remedy.task.empty() && one.id != task_) remedy.task = one.id;
        if (same && remedy.task == before.task) remedy.variant = data_of(variant_);
    } else if (remedy.kind == RemedyKind::other_variant) {
        remedy.variant = same ? data_of(variant_) : std::string();
        if (remedy.variant.empty() && own != nullptr && !own->variants.empty())
            remedy.variant = own->variants.back().id;
    }
}

void RemediesForm::add() {
    const TaskDefinition* own = find_task(task_);
    if (own == nullptr || own->metrics.empty()) return;
    Remedy added;
    added.metric = own->metrics.front();
    if (const MetricDescriptor* metric = find_metric(added.metric)) {
        added.unit = metric->unit;
        added.above = metric->direction != Direction::higher;
    }
    remedies_.push_back(added);
    fill_list(static_cast<int>(remedies_.size()) - 1);
    show_remedy();
    emit changed();
    metric_->setFocus();
}

void RemediesForm::move(int by) {
    const int row = list_->currentRow(), to = row + by;
    if (row < 0 || to < 0 || to >= static_cast<int>(remedies_.size())) return;
    std::swap(remedies_[static_cast<std::size_t>(row)], remedies_[static_cast<std::size_t>(to)]);
    fill_list(to);
    if (!(by < 0 ? up_ : down_)->isEnabled()) list_->setFocus();
    emit changed();
}

void RemediesForm::look() {
    const int row = list_->currentRow(), count = static_cast<int>(remedies_.size());
    fields_->setVisible(row >= 0);
    add_->setEnabled(find_task(task_) != nullptr && count < most_remedies_of_a_task);
    remove_->setEnabled(row >= 0);
    up_->setEnabled(row > 0);
    down_->setEnabled(row >= 0 && row + 1 < count);
}

void RemediesForm::show_problems(const std::vector<CurriculumProblem>& problems, std::size_t index) {
    put_problems(problems_, problems, index, {CurriculumField::remedies});
}

void RemediesForm::apply(CurriculumTask& task) const {
    task.remedies = remedies_;
}

}  // namespace fulcrum::ui

#include "moc_remedies_form.cpp"
