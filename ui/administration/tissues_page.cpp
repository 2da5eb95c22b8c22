// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/administration/tissues_page.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QScrollBar>
#include <QSignalBlocker>
#include <algorithm>
#include <iterator>

#include "sim_core/scene/cutting_values.h"
#include "ui/language/language.h"
#include "ui/language/words.h"
#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

enum Column { tissue_column, words_column, scene_column, site_column, range_column };

QString number(double value) {
    return with_decimal_sign(QString::number(value, 'g', 6));
}

QString words_of(const SiteTissueValue& one) {
    return QCoreApplication::translate("fulcrum::tissues", one.words.c_str());
}

QString range_of(const SiteTissueValue& one) {
    return (one.above ? TissuesPage::tr("above %1, at most %2") : TissuesPage::tr("at least %1, at most %2"))
        .arg(number(one.minimum), number(one.maximum));
}

/// As the table above the versions writes it. A key that scenes have no longer is shown as it was stored.
QString in_words(const std::string& tissue, const std::string& key, double value) {
    const auto* const known = std::find_if(std::begin(cutting_keys), std::end(cutting_keys),
                                           [&](const CuttingKey& row) { return key == row.key; });
    if (known == std::end(cutting_keys))
        return QStringLiteral("%1, %2: %3").arg(asset_text(tissue), text(key), number(value));
    return QStringLiteral("%1, %2: %3 %4")
        .arg(asset_text(tissue), QCoreApplication::translate("fulcrum::tissues", known->words), number(value),
             QString::fromLatin1(known->unit))
        .trimmed();
}

QString in_words(const database::TissueValues& values) {
    QStringList parts;
    for (const auto& [tissue, named] : values) {
        for (const auto& [key, value] : named) parts << in_words(tissue, key, value);
    }
    return parts.isEmpty() ? TissuesPage::tr("scene value") : parts.join(QStringLiteral("; "));
}

}  // namespace

TissuesPage::TissuesPage(Context& context) : Page(context, "tissues_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(14);
    layout->addWidget(make_label(tr("Tissue"), "title"));
    layout->addWidget(make_label(
        tr("The force at which a blade cuts into and through a tissue. A change applies to attempts that "
           "begin afterwards; earlier attempts keep the values with which they were performed."),
        "muted"));
    list_ = new QListWidget;
    list_->setObjectName(QStringLiteral("tissue_tasks"));
    list_->setAccessibleName(tr("Tasks"));
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    layout->addWidget(list_);
    none_ = make_label(tr("No task of this programme has tissue that can be cut."));
    layout->addWidget(none_);
    editor_ = build_editor();
    layout->addWidget(editor_);
    layout->addStretch(1);
    connect(list_, &QListWidget::currentRowChanged, this, &TissuesPage::select);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));
}

QWidget* TissuesPage::build_editor() {
    QFrame* card = make_card(10);
    state_ = make_label({}, "heading");
    state_->setObjectName(QStringLiteral("tissue_state"));
    card_layout(card)->addWidget(state_);
    trouble_ = make_label({});
    trouble_->setObjectName(QStringLiteral("tissue_trouble"));
    set_tint(trouble_, Tint::bad);
    card_layout(card)->addWidget(trouble_);
    table_ =
        make_table({tr("Tissue"), tr("Parameter"), tr("In the scene"), tr("At this site"), tr("Allowed")},
                   "tissue_table");
    table_->setAccessibleName(tr("Tissue"));
    table_->setSelectionMode(QAbstractItemView::NoSelection);
    table_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    card_layout(card)->addWidget(table_);
    note_ = make_label({});
    note_->setObjectName(QStringLiteral("tissue_limits"));
    card_layout(card)->addWidget(note_);
    change_ = new QFrame;
    auto* change = new FlowRow(change_);
    change->setContentsMargins(0, 0, 0, 0);
    reason_ = new QLineEdit;
    reason_->setObjectName(QStringLiteral("tissue_reason"));
    reason_->setPlaceholderText(tr("Reason (kept in the audit log)"));
    reason_->setAccessibleName(tr("Reason"));
    mark_begun(reason_, tr("tissue values that are not saved"));
    change->add(reason_, 1, with_text(200));
    save_ = make_button(tr("Save values"), "save_tissues", "primary");
    change->add(save_);
    back_ = make_button(tr("Reset to the scene's values"), "scene_tissues");
    change->add(back_);
    card_layout(card)->addWidget(change_);
    card_layout(card)->addWidget(make_label(tr("Versions"), "heading"));
    history_ =
        make_table({tr("Version"), tr("Time"), tr("Person"), tr("Values"), tr("Reason")}, "tissue_versions");
    history_->setAccessibleName(tr("Versions"));
    history_->setMinimumHeight(150);
    card_layout(card)->addWidget(history_);
    no_history_ =
        make_label(tr("No values have been set at this site yet: those of the scene apply."), "muted");
    card_layout(card)->addWidget(no_history_);
    connect(save_, &QPushButton::clicked, this, &TissuesPage::save);
    connect(back_, &QPushButton::clicked, this, &TissuesPage::back_to_scene);
    return card;
}

void TissuesPage::enter() {
    fill();
    list_->setFocus();
}

std::string TissuesPage::task_id() const {
    const int row = list_->currentRow();
    return row < 0 ? std::string() : tasks_[static_cast<std::size_t>(row)];
}

bool TissuesPage::is_listed(const TaskDefinition& task) const {
    bool listed = false;
    context().guarded([&] {
        for (const TissueSpec& tissue : context().services().scene_for(task).tissues)
            listed = listed || tissue.cutting.has_value();
        // Values for tissue that the scene has no longer: no attempt begins until they are reset here.
        listed = listed ||
                 !database::Tissues(context().store()).in_force(context().session(), task.id).values.empty();
    });
    return listed;
}

void TissuesPage::fill() {
    const std::string kept = task_id();
    const QSignalBlocker quiet(list_);
    list_->clear();
    tasks_.clear();
    int current = 0;
    for (const TaskDefinition& task : context().services().tasks()) {
        if (!is_listed(task)) continue;
        if (task.id == kept) current = list_->count();
        tasks_.push_back(task.id);
        list_->addItem(context().task_title(task.id));
    }
    list_->setCurrentRow(tasks_.empty() ? -1 : current);
    list_->setVisible(!tasks_.empty());
    editor_->setVisible(!tasks_.empty());
    none_->setVisible(tasks_.empty());
    list_->setFixedHeight(std::max(1, list_->count()) * std::max(30, list_->sizeHintForRow(0)) + 10);
    select();
}

void TissuesPage::select() {
    reason_->clear();
    site_ = SiteTissues();
    const bool known = !tasks_.empty() && context().guarded([&] {
        site_ = context().services().site_tissues(context().session(), task_id());
    });
    const bool may_set = context().allowed(database::Operation::set_tissues);
    change_->setVisible(known && may_set);
    back_->setEnabled(site_.differ);
    save_->setEnabled(!site_.values.empty());
    show_values();
    show_history();
}

void TissuesPage::show_values() {
    const bool may_set = context().allowed(database::Operation::set_tissues);
    state_->setText(site_.differ ? tr("This site's values, version %1").arg(site_.version)
                                 : tr("The scene's values"));
    QStringList notes;
    for (const LimitsNote& one : site_.limits_notes)
        notes << tr("%1: attempts are not compared with the task's limits, and gates based on them are not "
                    "scored: %2. Build a benchmark set in this tissue: fulcrum benchmark build %3 "
                    "--operators --device-class %4 --db %5")
                     .arg(capital(device_class_text(one.device_class)), statement_text(one.why),
                          text(task_id()), text(row_of(device_classes, one.device_class).name),
                          text(context().store().path()));
    note_->setVisible(!notes.isEmpty());
    note_->setText(notes.join(QLatin1Char('\n')));
    edits_.clear();
    table_->setRowCount(0);
    for (const SiteTissueValue& one : site_.values) {
        const int row = table_->rowCount();
        table_->insertRow(row);
        table_->setItem(row, tissue_column, make_cell(asset_text(one.tissue)));
        table_->setItem(row, words_column, make_cell(words_of(one)));
        const QString unit = QLatin1Char(' ') + text(one.unit);
        table_->setItem(row, scene_column,
                        make_cell(number(one.scene) + unit, Qt::AlignRight | Qt::AlignVCenter));
        auto* edit = new QLineEdit(number(one.value));
        edit->setObjectName(QStringLiteral("value_%1_%2").arg(text(one.tissue), text(one.key)));
        edit->setAccessibleName(
            QStringLiteral("%1, %2 (%3)").arg(asset_text(one.tissue), words_of(one), text(one.unit)));
        edit->setAlignment(Qt::AlignRight);
        edit->setReadOnly(!may_set);
        edit->setFrame(may_set);
        mark_begun(edit, tr("tissue values that are not saved"));
        table_->setItem(row, site_column, make_cell(QString()));
        table_->setCellWidget(row, site_column, edit);
        table_->setItem(row, range_column, make_cell(range_of(one) + unit));
        edits_.push_back(edit);
        table_->setRowHeight(row, std::max(table_->rowHeight(row), edit->sizeHint().height() + 4));
    }
    fit_columns(table_);
    table_->setColumnWidth(
        site_column, std::max(with_text(110), table_->horizontalHeader()->sectionSizeHint(site_column)));
    // With large text the table scrolls sideways.
    int height = table_->horizontalHeader()->sizeHint().height() + 8 +
                 (text_percent() > 100 ? table_->horizontalScrollBar()->sizeHint().height() : 0);
    for (int row = 0; row < table_->rowCount(); ++row) height += table_->rowHeight(row);
    table_->setFixedHeight(height);
    table_->setVisible(!site_.values.empty());
    trouble_->setVisible(!site_.unusable.empty());
    trouble_->setText(
        tr("No attempt at this task can begin with these values: %1. Correct them, or reset them "
           "to the scene's values.")
            .arg(sentence_text(site_.unusable)));
}

void TissuesPage::show_history() {
    history_->setRowCount(0);
    if (tasks_.empty()) return;
    context().guarded([&] {
        for (const database::TissueSetting& one :
             database::Tissues(context().store()).history(context().session(), task_id())) {
            const int row = history_->rowCount();
            history_->insertRow(row);
            history_->setItem(row, 0, make_cell(QString::number(one.version)));
            history_->setItem(row, 1, make_cell(local_time(one.time)));
            history_->setItem(row, 2, make_cell(text(one.author_name)));
            history_->setItem(row, 3, make_cell(in_words(one.values)));
            history_->item(row, 3)->setToolTip(in_words(one.values));
            history_->setItem(row, 4, make_cell(text(one.reason)));
            history_->item(row, 4)->setToolTip(text(one.reason));
        }
    });
    fit_columns(history_, {0, 1});
    history_->setVisible(history_->rowCount() > 0);
    no_history_->setVisible(history_->rowCount() == 0);
}

void TissuesPage::save() {
    database::TissueValues values;
    for (std::size_t i = 0; i < edits_.size(); ++i) {
        const SiteTissueValue& one = site_.values[i];
        bool is_number = false;
        // Comma or point: what the person's keyboard writes.
        QString typed = edits_[i]->text().trimmed();
        double value = QLocale::c().toDouble(typed.replace(QLatin1Char(','), QLatin1Char('.')), &is_number);
        if (!is_number) {
            context().complain(tr("%1, %2: \"%3\" is not a number. Enter a number %4 %5")
                                   .arg(asset_text(one.tissue), words_of(one), edits_[i]->text(),
                                        range_of(one), text(one.unit)));
            edits_[i]->setFocus();
            return;
        }
        if (edits_[i]->text() == number(one.value)) value = one.value;  // not touched: every digit stays
        values[one.tissue][one.key] = value;
    }
    set(values, tr("Saved. Attempts that begin from now on use these values."));
}

void TissuesPage::back_to_scene() {
    set({}, tr("The scene's values apply again."));
}

void TissuesPage::set(const database::TissueValues& values, const QString& said) {
    if (!context().guarded([&] {
            context().services().set_site_tissues(context().session(), task_id(), site_.version, values,
                                                  plain(reason_->text().trimmed()));
        }))
        return;
    context().say(said);
    select();
}

}  // namespace fulcrum::ui

#include "moc_tissues_page.cpp"
