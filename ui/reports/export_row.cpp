// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/export_row.h"

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QStandardPaths>

#include "ui/reports/report_export.h"
#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

/// The formats to choose from, in the order of ReportFormat: those whose files have an ending of their own.
std::vector<const char*> endings_of_formats() {
    std::vector<const char*> found;
    for (const ReportFormatRow& row : report_formats)
        if (row.ending != nullptr) found.push_back(row.ending);
    return found;
}
const std::vector<const char*> endings = endings_of_formats();

QLatin1String ending_of(int index) {
    return QLatin1String(endings[static_cast<std::size_t>(index)]);
}

bool has_ending(const QString& path) {
    for (const char* ending : endings) {
        if (path.endsWith(QLatin1String(ending), Qt::CaseInsensitive)) return true;
    }
    return false;
}

}  // namespace

QString file_name(const QString& name) {
    QString kept;
    for (const QChar& c : name)
        kept += c.isLetterOrNumber() || c == QLatin1Char('-') || c == QLatin1Char('_') ? c : QLatin1Char(' ');
    kept = kept.simplified();
    return kept.isEmpty() ? QStringLiteral("report") : kept;
}

ExportRow::ExportRow(const char* save_name, QWidget* parent)
    : QWidget(parent), format_(new QComboBox), path_(new QLineEdit) {
    auto* row = new FlowRow(this);
    row->setContentsMargins(0, 0, 0, 0);
    QLabel* label = make_label(tr("Report"));
    label->setWordWrap(false);
    row->add(label);
    format_->setObjectName(QStringLiteral("export_format"));
    format_->setAccessibleName(tr("Format of the report"));
    for (const char* ending : endings) format_->addItem(QString::fromLatin1(ending + 1).toUpper());
    row->add(format_);
    path_->setObjectName(QStringLiteral("export_path"));
    path_->setAccessibleName(tr("File of the report"));
    row->add(path_, 1, with_text(180));
    QPushButton* other = make_button(tr("Choose …"), "export_choose");
    row->add(other);
    save_ = make_button(tr("Save report"), save_name, "primary");
    row->add(save_);
    connect(format_, QOverload<int>::of(&QComboBox::activated), this, &ExportRow::format_chosen);
    connect(path_, &QLineEdit::textChanged, this, &ExportRow::look);
    connect(other, &QPushButton::clicked, this, &ExportRow::choose);
    connect(save_, &QPushButton::clicked, this, [this] { emit save_wanted(path()); });
}

void ExportRow::propose(const QString& name) {
    if (name == proposed_) return;  // what was typed stays while it is the same person or cohort
    proposed_ = name;
    QString folder = QFileInfo(path_->text()).path();
    if (path_->text().isEmpty()) {
        folder = QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation);
        if (!QFileInfo(folder).isDir()) folder = QDir::homePath();
    }
    path_->setText(QDir::toNativeSeparators(
        QDir(folder).filePath(file_name(name) + ending_of(format_->currentIndex()))));
    look();
}

QString ExportRow::path() const {
    const QString typed = QDir::fromNativeSeparators(path_->text().trimmed());
    if (typed.isEmpty() || has_ending(typed)) return typed;
    return typed + ending_of(format_->currentIndex());
}

void ExportRow::look() {
    const QString file = path();
    if (has_ending(path_->text().trimmed()))
        format_->setCurrentIndex(static_cast<int>(report_format_of(file)));
    save_->setEnabled(!file.isEmpty() && !QFileInfo(file).isDir());
    save_->setText(QFileInfo(file).isFile() ? tr("Replace report") : tr("Save report"));
}

void ExportRow::format_chosen() {
    QString file = path();
    if (file.isEmpty()) return;
    for (const char* ending : endings) {
        if (file.endsWith(QLatin1String(ending), Qt::CaseInsensitive))
            file.chop(static_cast<int>(qstrlen(ending)));
    }
    path_->setText(QDir::toNativeSeparators(file + ending_of(format_->currentIndex())));
}

void ExportRow::choose() {
    // Not a loop of its own: the window keeps working while the person looks around.
    auto* dialog = new QFileDialog(this, tr("File of the report"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({tr("Reports (*.pdf *.csv *.xlsx *.json)")});
    // What is there already is said by the button that would replace it.
    dialog->setOption(QFileDialog::DontConfirmOverwrite);
    dialog->setDirectory(QFileInfo(path()).path());
    dialog->selectFile(QFileInfo(path()).fileName());
    connect(dialog, &QFileDialog::fileSelected, this,
            [this](const QString& file) { path_->setText(QDir::toNativeSeparators(file)); });
    dialog->open();
}

}  // namespace fulcrum::ui

#include "moc_export_row.cpp"
