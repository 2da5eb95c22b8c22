// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/goals_card.h"

#include <QApplication>
#include <QComboBox>
#include <QDateEdit>
#include <QDoubleSpinBox>
#include <QFrame>
#include <QLabel>
#include <algorithm>
#include <cmath>

#include "assessment/metrics/registry.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/trainee/goal_words.h"

namespace fulcrum::ui {

using database::GoalOf;
using database::GoalWish;
using database::Operation;
using database::Subject;

GoalsCard::GoalsCard(Context& context, bool own) : context_(context), own_(own) {
    setObjectName(QStringLiteral("goals_card"));
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    QFrame* card = make_card(8);
    outer->addWidget(card);
    heading_ = make_label(own ? tr("Your goals") : tr("Goals that the trainee set"), "heading");
    card_layout(card)->addWidget(heading_);
    lines_ = new QVBoxLayout;
    lines_->setSpacing(8);
    card_layout(card)->addLayout(lines_);
    if (!own) return;
    editor_ = make_editor();
    card_layout(card)->addWidget(editor_);
    add_ = make_button(tr("Set a goal"), "set_goal");
    connect(add_, &QPushButton::clicked, this, [this] {
        GoalWish wish;
        wish.target = 3;
        edit({}, wish);
    });
    card_layout(card)->addWidget(add_, 0, Qt::AlignLeft);
}

QWidget* GoalsCard::make_editor() {
    auto* editor = new QWidget;
    auto* column = new QVBoxLayout(editor);
    column->setContentsMargins(0, 0, 0, 0);
    auto* row = new FlowRow;
    const auto combo = [&](const QString& label, const char* name) {
        auto* box = new QComboBox;
        box->setObjectName(QString::fromLatin1(name));
        box->setAccessibleName(label);
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(18);
        row->add(box);
        return box;
    };
    kind_ = combo(tr("Kind of goal"), "goal_kind");
    kind_->addItem(tr("Attempts a week"));
    kind_->addItem(tr("Value of a metric"));
    task_ = combo(tr("Task"), "goal_task");
    metric_ = combo(tr("Metric"), "goal_metric");
    target_ = new QDoubleSpinBox;
    target_->setObjectName(QStringLiteral("goal_target"));
    target_->setAccessibleName(tr("Goal"));
    target_->setMinimumWidth(with_text(110));
    row->add(target_);
    due_label_ = make_label(tr("by"));
    due_label_->setWordWrap(false);
    row->add(due_label_);
    due_ = new QDateEdit;
    due_->setObjectName(QStringLiteral("goal_due"));
    due_->setAccessibleName(tr("Day by which it is reached"));
    due_->setCalendarPopup(true);
    row->add(due_);
    column->addLayout(row);
    latest_ = make_label({}, "muted");
    latest_->setObjectName(QStringLiteral("goal_latest"));
    column->addWidget(latest_);
    auto* buttons = new FlowRow;
    QPushButton* keep = make_button(tr("Save"), "goal_save", "primary");
    buttons->add(keep);
    QPushButton* cancel = make_button(tr("Cancel"), "goal_cancel");
    buttons->add(cancel);
    column->addLayout(buttons);
    connect(kind_, QOverload<int>::of(&QComboBox::activated), this, [this] { kind_changed(); });
    connect(task_, QOverload<int>::of(&QComboBox::activated), this, [this] { task_changed(); });
    connect(metric_, QOverload<int>::of(&QComboBox::activated), this, [this] { metric_changed(); });
    connect(keep, &QPushButton::clicked, this, &GoalsCard::save);
    connect(cancel, &QPushButton::clicked, this, &GoalsCard::close_editor);
    return editor;
}

std::int64_t GoalsCard::today() const {
    return day_of(QDateTime::fromMSecsSinceEpoch(context_.store().now()).date());
}

bool GoalsCard::may_set() const {
    return own_ && context_.allowed(Operation::set_goal, Subject::person(person_id_)) &&
           !context_.store().is_read_only();
}

void GoalsCard::show_person(const std::string& person_id) {
    person_id_ = person_id;
    clear_layout(lines_);
    const Subject subject = Subject::person(person_id);
    std::vector<database::GoalProgress> goals;
    const bool readable = !person_id.empty() && context_.allowed(Operation::read_goals, subject);
    if (readable)
        context_.guarded([&] {
            goals = database::Goals(context_.store()).progress(context_.session(), person_id, today());
        });
    for (const database::GoalProgress& one : goals) lines_->addWidget(line_of(one));
    if (own_) {
        const bool settable = may_set();
        if (settable && goals.empty())
            lines_->addWidget(
                make_label(tr("Set a goal for yourself: a number of attempts a week, or a value of a metric "
                              "by a date. Only you and your educators see it."),
                           "muted"));
        close_editor();
        add_->setVisible(settable && goals.size() < database::most_goals);
        setVisible(readable && (settable || !goals.empty()));
    } else {
        setVisible(readable && !goals.empty());
    }
}

QWidget* GoalsCard::line_of(const database::GoalProgress& progress) {
    auto* line = new QWidget;
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(new GoalRing(progress), 0, Qt::AlignTop);
    auto* words = new QVBoxLayout;
    const GoalWish& wish = progress.goal.wish;
    QLabel* title =
        make_label(goal_title(wish, wish.task.empty() ? QString() : context_.task_title(wish.task)));
    title->setObjectName(QStringLiteral("goal_words"));
    words->addWidget(title);
    QLabel* state = make_label(goal_state(progress), progress.reached ? "good" : "muted");
    state->setObjectName(QStringLiteral("goal_state"));
    words->addWidget(state);
    if (may_set()) {
        auto* buttons = new FlowRow;
        QPushButton* change = make_button(tr("Change"), "goal_change", "link");
        connect(change, &QPushButton::clicked, this, [this, id = progress.goal.id, wish] { edit(id, wish); });
        buttons->add(change);
        QPushButton* remove = make_button(tr("Remove goal"), "goal_drop", "link");
        connect(remove, &QPushButton::clicked, this, [this, id = progress.goal.id] { drop(id); });
        buttons->add(remove);
        words->addLayout(buttons);
    }
    row->addLayout(words, 1);
    return line;
}

void GoalsCard::edit(const std::string& goal_id, const GoalWish& wish) {
    edited_ = goal_id;
    kind_->setCurrentIndex(wish.kind == GoalOf::metric ? 1 : 0);
    kind_changed();
    if (!wish.task.empty()) task_->setCurrentIndex(std::max(0, task_->findData(text(wish.task))));
    task_changed();
    if (!wish.metric.empty()) metric_->setCurrentIndex(std::max(0, metric_->findData(text(wish.metric))));
    if (wish.kind == GoalOf::metric) metric_changed();
    target_->setValue(wish.target);
    due_->setDateRange(date_of(today()), date_of(today() + database::longest_goal_days));
    due_->setDate(wish.due_day > 0 ? date_of(wish.due_day) : date_of(today() + 28));
    editor_->show();
    add_->hide();
    kind_->setFocus();
}

void GoalsCard::close_editor() {
    edited_.clear();
    const bool was_used = editor_->isAncestorOf(QApplication::focusWidget());
    editor_->hide();
    add_->setVisible(lines_->count() < static_cast<int>(database::most_goals));
    if (was_used && !add_->isHidden()) add_->setFocus();
}

void GoalsCard::kind_changed() {
    const bool metric = kind_->currentIndex() == 1;
    const QVariant chosen = task_->currentData();
    task_->clear();
    if (!metric) task_->addItem(tr("Any task"), QString());
    for (const TaskDefinition& task : context_.services().tasks())
        task_->addItem(context_.task_title(task.id), text(task.id));
    task_->setCurrentIndex(std::max(0, task_->findData(chosen)));
    metric_->setVisible(metric);
    due_->setVisible(metric);
    due_label_->setVisible(metric);
    due_->setDateRange(date_of(today()), date_of(today() + database::longest_goal_days));
    task_changed();
}

void GoalsCard::task_changed() {
    metric_->clear();
    if (const TaskDefinition* task = context_.task(task_->currentData().toString().toStdString())) {
        for (const std::string& id : task->metrics) {
            const MetricDescriptor* metric = find_metric(id);
            const auto& described = task->context;
            if (metric != nullptr && metric->direction != Direction::context &&
                std::find(described.begin(), described.end(), id) == described.end())
                metric_->addItem(metric_text(id), text(id));
        }
    }
    metric_changed();
}

void GoalsCard::metric_changed() {
    set_ranges();
    const bool metric = kind_->currentIndex() == 1;
    latest_->setVisible(metric);
    if (!metric) return;
    const std::string id = metric_->currentData().toString().toStdString(),
                      task = task_->currentData().toString().toStdString();
    std::optional<double> latest;
    context_.guarded([&] {
        latest = database::Goals(context_.store()).latest_value(context_.session(), person_id_, task, id);
    });
    const MetricDescriptor* known = find_metric(id);
    const std::string unit = known == nullptr ? std::string() : known->unit;
    latest_->setText(latest ? tr("Your latest value: %1. Of both hands the worse one counts.")
                                  .arg(figure_with_unit(latest, unit))
                            : tr("You have no completed attempt with this metric yet."));
    target_->setValue(latest.value_or(0));
}

void GoalsCard::set_ranges() {
    const MetricDescriptor* metric = find_metric(metric_->currentData().toString().toStdString());
    if (kind_->currentIndex() == 0 || metric == nullptr) {
        target_->setDecimals(0);
        target_->setRange(1, database::most_attempts_a_week);
        target_->setSingleStep(1);
        target_->setSuffix({});
        return;
    }
    const double precision = metric->precision > 0 ? metric->precision : 1;
    target_->setDecimals(std::max(0, static_cast<int>(std::ceil(-std::log10(precision) - 1e-9))));
    target_->setRange(-1e6, 1e6);
    target_->setSingleStep(precision);
    const QString unit = unit_text(metric->unit);
    target_->setSuffix(unit.isEmpty() ? QString() : QLatin1Char(' ') + unit);
}

GoalWish GoalsCard::wish() const {
    GoalWish wish;
    wish.task = task_->currentData().toString().toStdString();
    wish.target = target_->value();
    if (kind_->currentIndex() == 0) return wish;
    wish.kind = GoalOf::metric;
    wish.metric = metric_->currentData().toString().toStdString();
    wish.due_day = day_of(due_->date());
    return wish;
}

void GoalsCard::save() {
    if (context_.guarded([&] {
            const database::Goals goals(context_.store());
            if (edited_.empty()) {
                goals.set(context_.session(), wish(), today());
            } else {
                goals.change(context_.session(), edited_, wish(), today());
            }
        }))
        show_person(person_id_);
}

void GoalsCard::drop(const std::string& goal_id) {
    context_.guarded([&] { database::Goals(context_.store()).drop(context_.session(), goal_id); });
    show_person(person_id_);
    if (add_ != nullptr && add_->isVisible()) add_->setFocus();  // not on what removes the next one
}

}  // namespace fulcrum::ui
