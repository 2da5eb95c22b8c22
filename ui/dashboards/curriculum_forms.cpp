// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/curriculum_forms.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QFormLayout>
#include <QLineEdit>
#include <QListWidget>
#include <QSpinBox>
#include <QTableWidget>
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "ui/dashboards/form_parts.h"
#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr DeviceClass curriculum_devices[] = {DeviceClass::haptic, DeviceClass::tracked,
                                              DeviceClass::controller, DeviceClass::mouse_keyboard};
constexpr int most_variants_asked = 12, most_raters = 12;

}  // namespace

QLabel* make_problems(const char* name) {
    QLabel* label = make_label({});
    label->setObjectName(QLatin1String(name));
    set_tint(label, Tint::bad);
    label->hide();
    return label;
}

void put_problems(QLabel* label, const std::vector<CurriculumProblem>& problems, std::size_t index,
                  std::initializer_list<CurriculumField> fields) {
    QStringList lines;
    for (const CurriculumProblem& one : problems) {
        if (one.index != index || std::find(fields.begin(), fields.end(), one.field) == fields.end())
            continue;
        lines << CurriculumWords::tr("%1: %2").arg(field_words(one.field), problem_words(one));
    }
    label->setVisible(!lines.isEmpty());
    announce_change(label, lines.join(QLatin1Char('\n')));
}

void ExactBox::show_value(double exact, int least_decimals) {
    if (exact == exact_value()) return;  // also while it is typed, digit by digit
    constexpr int most_decimals = 9;
    int needed = least_decimals;
    while (needed < most_decimals &&
           std::abs(QString::number(exact, 'f', needed).toDouble() - exact) > 1e-12 * std::abs(exact))
        ++needed;
    setDecimals(needed);
    setValue(exact);
    exact_ = exact;
    shown_ = value();
}

QWidget* add_named(QFormLayout* form, const QString& name, QWidget* field) {
    QLabel* label = make_label(name);
    label->setWordWrap(text_percent() > 150);
    label->setBuddy(field);
    form->addRow(label, field);
    field->setAccessibleName(name);
    return field;
}

QFormLayout* make_form() {
    auto* form = new QFormLayout;
    form->setRowWrapPolicy(QFormLayout::WrapLongRows);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(8);
    return form;
}

QString field_words(CurriculumField field) {
    switch (field) {
        case CurriculumField::title:
            return CurriculumWords::tr("Curriculum");
        case CurriculumField::stages:
            return CurriculumWords::tr("Stages");
        case CurriculumField::task:
            return CurriculumWords::tr("Task");
        case CurriculumField::stage:
            return CurriculumWords::tr("Stage");
        case CurriculumField::after:
            return CurriculumWords::tr("Prerequisites");
        case CurriculumField::rule:
            return CurriculumWords::tr("Pass rule");
        case CurriculumField::variants:
            return CurriculumWords::tr("Variants");
        case CurriculumField::devices:
            return CurriculumWords::tr("Devices");
        case CurriculumField::ratings:
            return CurriculumWords::tr("Ratings");
        case CurriculumField::remedies:
            break;
    }
    return CurriculumWords::tr("Remedies");
}

QString problem_words(const CurriculumProblem& problem) {
    return (problem.blocks ? QStringLiteral("✕ ") : QStringLiteral("▲ ")) +
           sentence_text(Sentence("%1; %2", problem.problem, problem.hint));
}

TaskNeedsForm::TaskNeedsForm(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    problems_ = make_problems("needs_problems");
    layout->addWidget(problems_);
    QFormLayout* form = make_form();
    stage_ = make_narrow_choice("task_stage", {}, 14);
    add_named(form, tr("Stage"), stage_);
    variants_ = new QSpinBox;
    variants_->setObjectName(QStringLiteral("task_variants"));
    variants_->setRange(1, most_variants_asked);
    add_named(form, tr("Passes on variants, at least"), variants_);
    layout->addLayout(form);
    layout->addWidget(make_label(tr("Devices whose attempts count"), "heading"));
    auto* row = new FlowRow;
    for (const DeviceClass one : curriculum_devices) {
        auto* box = new QCheckBox(device_class_text(one));
        box->setObjectName(QStringLiteral("task_device_") + QLatin1String(row_of(device_classes, one).name));
        connect(box, &QCheckBox::toggled, this, [this] {
            if (!setting_) emit changed();
        });
        devices_.push_back(box);
        row->add(box);
    }
    layout->addLayout(row);
    layout->addWidget(make_label(tr("Prerequisites: proficient in all of these first"), "heading"));
    after_ = new QListWidget;
    after_->setObjectName(QStringLiteral("task_after"));
    after_->setAccessibleName(tr("Prerequisites"));
    after_->setMinimumHeight(7 * fontMetrics().height());
    layout->addWidget(after_, 1);
    connect(stage_, QOverload<int>::of(&QComboBox::activated), this, [this] { emit changed(); });
    connect(variants_, QOverload<int>::of(&QSpinBox::valueChanged), this, [this] {
        if (!setting_) emit changed();
    });
    connect(after_, &QListWidget::itemChanged, this, [this] {
        if (!setting_) emit changed();
    });
}

void TaskNeedsForm::show_task(const Curriculum& draft, std::size_t index, const QStringList& titles,
                              int most_variants) {
    const CurriculumTask& task = draft.tasks[index];
    setting_ = true;
    stage_->clear();
    for (const CurriculumStage& stage : draft.stages)
        stage_->addItem(join_with_dots({text(stage.id), asset_text(stage.title)}), text(stage.id));
    stage_->setCurrentIndex(stage_->findData(text(task.stage)));
    variants_->setValue(task.variants);
    variants_->setToolTip(tr("Installed: %n variants", nullptr, most_variants));
    for (std::size_t i = 0; i < devices_.size(); ++i)
        devices_[i]->setChecked(std::find(task.device_classes.begin(), task.device_classes.end(),
                                          curriculum_devices[i]) != task.device_classes.end());
    after_->clear();
    const auto add = [&](const std::string& id, const QString& title) {
        auto* item = new QListWidgetItem(title, after_);
        item->setData(Qt::UserRole, text(id));
        item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
        const bool asked = std::find(task.after.begin(), task.after.end(), id) != task.after.end();
        item->setCheckState(asked ? Qt::Checked : Qt::Unchecked);
    };
    for (std::size_t i = 0; i < draft.tasks.size(); ++i)
        if (i != index) add(draft.tasks[i].task, titles[static_cast<int>(i)]);
    for (const std::string& id : task.after)  // that are gone
        if (draft.find(id) == nullptr) add(id, tr("%1 (not in the curriculum)").arg(text(id)));
    setting_ = false;
}

void TaskNeedsForm::show_problems(const std::vector<CurriculumProblem>& problems, std::size_t index) {
    put_problems(problems_, problems, index,
                 {CurriculumField::task, CurriculumField::stage, CurriculumField::after,
                  CurriculumField::variants, CurriculumField::devices});
}

void TaskNeedsForm::apply(CurriculumTask& task) const {
    if (stage_->currentIndex() >= 0) task.stage = plain(stage_->currentData().toString());
    task.variants = variants_->value();
    task.device_classes.clear();
    for (std::size_t i = 0; i < devices_.size(); ++i)
        if (devices_[i]->isChecked()) task.device_classes.push_back(curriculum_devices[i]);
    task.after.clear();
    for (int row = 0; row < after_->count(); ++row)
        if (after_->item(row)->checkState() == Qt::Checked)
            task.after.push_back(plain(after_->item(row)->data(Qt::UserRole).toString()));
}

TaskRatingsForm::TaskRatingsForm(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    problems_ = make_problems("ratings_problems");
    layout->addWidget(problems_);
    wanted_ = new QCheckBox(tr("Ratings by observers are needed as well"));
    wanted_->setObjectName(QStringLiteral("ratings_wanted"));
    layout->addWidget(wanted_);
    QFormLayout* form = make_form();
    form->setRowWrapPolicy(QFormLayout::WrapAllRows);  // titles of observer forms are long
    form_ = make_narrow_choice("ratings_form", {}, 14);
    add_named(form, tr("Form"), form_);
    raters_ = new QSpinBox;
    raters_->setObjectName(QStringLiteral("ratings_raters"));
    raters_->setRange(1, most_raters);
    add_named(form, tr("Raters, at least"), raters_);
    lowest_ = new ExactBox;
    lowest_->setObjectName(QStringLiteral("ratings_lowest"));
    lowest_->setRange(0, 100);
    lowest_->setSingleStep(0.5);
    add_named(form, tr("Lowest mean, on the scale of the items"), lowest_);
    layout->addLayout(form);
    every_item_ = new QCheckBox(tr("Each item reaches this mean"));
    every_item_->setObjectName(QStringLiteral("ratings_every_item"));
    blind_ = new QCheckBox(tr("Only blind ratings count"));
    blind_->setObjectName(QStringLiteral("ratings_blind"));
    for (QCheckBox* box : {every_item_, blind_}) layout->addWidget(box);
    layout->addStretch();
    const auto told = [this] {
        look();
        if (!setting_) emit changed();
    };
    for (QCheckBox* box : {wanted_, every_item_, blind_}) connect(box, &QCheckBox::toggled, this, told);
    connect(form_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, told);
    connect(raters_, QOverload<int>::of(&QSpinBox::valueChanged), this, told);
    connect(lowest_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, told);
    look();
}

void TaskRatingsForm::set_forms(const std::vector<ObserverForm>& forms) {
    setting_ = true;
    form_->clear();
    for (const ObserverForm& one : forms)
        if (form_->findData(text(one.id)) < 0) form_->addItem(asset_text(one.title), text(one.id));
    setting_ = false;
}

void TaskRatingsForm::show_task(const CurriculumTask& task) {
    setting_ = true;
    const RatingRule rule = task.ratings.value_or(RatingRule());
    wanted_->setChecked(task.ratings.has_value());
    int row = form_->findData(text(rule.form));
    if (row < 0 && !rule.form.empty()) {
        form_->addItem(tr("%1 (not installed)").arg(text(rule.form)), text(rule.form));
        row = form_->count() - 1;
    }
    form_->setCurrentIndex(std::max(0, row));
    raters_->setValue(rule.raters);
    lowest_->show_value(task.ratings ? rule.lowest_mean : 3, 2);
    every_item_->setChecked(rule.every_item);
    blind_->setChecked(rule.blind);
    items_ = rule.items;
    items_form_ = rule.form;
    setting_ = false;
    look();
}

void TaskRatingsForm::look() {
    for (QWidget* field : std::initializer_list<QWidget*>{form_, raters_, lowest_, every_item_, blind_})
        field->setEnabled(wanted_->isChecked());
}

void TaskRatingsForm::show_problems(const std::vector<CurriculumProblem>& problems, std::size_t index) {
    put_problems(problems_, problems, index, {CurriculumField::ratings});
}

void TaskRatingsForm::apply(CurriculumTask& task) const {
    task.ratings.reset();
    if (!wanted_->isChecked()) return;
    RatingRule rule;
    rule.form = plain(form_->currentData().toString());
    rule.raters = raters_->value();
    rule.lowest_mean = lowest_->exact_value();
    rule.every_item = every_item_->isChecked();
    rule.blind = blind_->isChecked();
    if (rule.form == items_form_) rule.items = items_;  // those of another form mean nothing here
    task.ratings = rule;
}

StagesForm::StagesForm(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    problems_ = make_problems("stages_problems");
    layout->addWidget(problems_);
    QFormLayout* form = make_form();
    title_ = new QLineEdit;
    title_->setObjectName(QStringLiteral("curriculum_title"));
    add_named(form, tr("Title of the curriculum"), title_);
    layout->addLayout(form);
    layout->addWidget(make_label(tr("Stages, in the order in which they are learned"), "heading"));
    table_ = make_table({tr("Short name"), tr("Title")}, "stages_table");
    table_->setAccessibleName(tr("Stages"));
    table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                            QAbstractItemView::AnyKeyPressed);
    table_->setMinimumHeight(8 * fontMetrics().height());
    layout->addWidget(table_, 1);
    auto* row = new FlowRow;
    add_ = make_button(tr("Add a stage"), "stage_add");
    remove_ = make_button(tr("Remove"), "stage_remove");
    up_ = make_button(tr("▲ Up"), "stage_up");
    down_ = make_button(tr("▼ Down"), "stage_down");
    for (QPushButton* button : {add_, remove_, up_, down_}) row->add(button);
    layout->addLayout(row);
    connect(title_, &QLineEdit::textEdited, this, [this] { emit changed(); });
    connect(table_, &QTableWidget::itemSelectionChanged, this, &StagesForm::look);
    connect(table_, &QTableWidget::cellChanged, this, [this] {
        if (setting_) return;
        read_table();
        emit changed();
    });
    connect(add_, &QPushButton::clicked, this, [this] {
        rows_.push_back({});
        fill();
        table_->selectRow(table_->rowCount() - 1);
        emit changed();
        table_->setFocus();
        table_->setCurrentCell(table_->rowCount() - 1, 0);
        table_->editItem(table_->item(table_->rowCount() - 1, 0));
    });
    connect(remove_, &QPushButton::clicked, this, [this] {
        const int at = table_->currentRow();
        if (at < 0) return;
        rows_.erase(rows_.begin() + at);
        fill();
        if (!remove_->isEnabled()) table_->setFocus();
        emit changed();
    });
    connect(up_, &QPushButton::clicked, this, [this] { move(-1); });
    connect(down_, &QPushButton::clicked, this, [this] { move(1); });
}

void StagesForm::show_draft(const Curriculum& draft) {
    rows_.clear();
    for (const CurriculumStage& stage : draft.stages) rows_.push_back({stage, stage.id});
    if (plain(title_->text()) != draft.title) title_->setText(text(draft.title));
    fill();
}

void StagesForm::fill() {
    const int before = table_->currentRow();
    setting_ = true;
    table_->setRowCount(static_cast<int>(rows_.size()));
    for (int row = 0; row < table_->rowCount(); ++row) {
        const CurriculumStage& stage = rows_[static_cast<std::size_t>(row)].stage;
        table_->setItem(row, 0, make_cell(text(stage.id)));
        table_->setItem(row, 1, make_cell(text(stage.title)));
    }
    size_columns(table_);
    if (before >= 0 && before < table_->rowCount()) table_->selectRow(before);
    setting_ = false;
    look();
}

void StagesForm::look() {
    const int row = table_->currentRow();
    remove_->setEnabled(row >= 0);
    up_->setEnabled(row > 0);
    down_->setEnabled(row >= 0 && row + 1 < table_->rowCount());
}

void StagesForm::read_table() {
    for (int row = 0; row < table_->rowCount() && row < static_cast<int>(rows_.size()); ++row) {
        CurriculumStage& stage = rows_[static_cast<std::size_t>(row)].stage;
        stage.id = plain(table_->item(row, 0)->text().trimmed());
        stage.title = plain(table_->item(row, 1)->text().trimmed());
    }
}

void StagesForm::move(int by) {
    const int row = table_->currentRow(), to = row + by;
    if (row < 0 || to < 0 || to >= table_->rowCount()) return;
    std::swap(rows_[static_cast<std::size_t>(row)], rows_[static_cast<std::size_t>(to)]);
    fill();
    table_->selectRow(to);
    if (!(by < 0 ? up_ : down_)->isEnabled()) table_->setFocus();
    emit changed();
}

void StagesForm::show_problems(const std::vector<CurriculumProblem>& problems) {
    QStringList lines;
    for (const CurriculumProblem& one : problems)
        if (one.field == CurriculumField::title || one.field == CurriculumField::stages)
            lines << problem_words(one);
    problems_->setVisible(!lines.isEmpty());
    announce_change(problems_, lines.join(QLatin1Char('\n')));
}

void StagesForm::apply(Curriculum& draft) {
    draft.title = plain(title_->text().trimmed());
    draft.stages.clear();
    std::vector<std::string> stage_of;
    for (const CurriculumTask& task : draft.tasks) stage_of.push_back(task.stage);
    for (Row& row : rows_) {
        draft.stages.push_back(row.stage);
        // While two have one name, their tasks stay apart.
        const auto same = std::count_if(rows_.begin(), rows_.end(),
                                        [&](const Row& other) { return other.stage.id == row.stage.id; });
        if (same > 1 || row.stage.id.empty()) continue;
        for (std::size_t i = 0; i < stage_of.size(); ++i)
            if (!row.before.empty() && stage_of[i] == row.before) draft.tasks[i].stage = row.stage.id;
        row.before = row.stage.id;
    }
}

}  // namespace fulcrum::ui

#include "moc_curriculum_forms.cpp"
