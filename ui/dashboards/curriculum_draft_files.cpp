// SPDX-License-Identifier: GPL-3.0-or-later
// Drafts of a curriculum are read, written, published and handed to another page.
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QListWidget>
#include <algorithm>

#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/output_file.h"
#include "sim_core/scene/json_document.h"
#include "ui/dashboards/curriculum_page.h"
#include "ui/style/text.h"

namespace fulcrum::ui {

void CurriculumPage::open_draft() {
    auto* dialog = new QFileDialog(this, tr("Draft of a curriculum"), path_->text());
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilter(tr("Curricula (*.json)"));
    connect(dialog, &QFileDialog::fileSelected, this, &CurriculumPage::read_draft);
    dialog->open();
}

void CurriculumPage::read_draft(const QString& path) {
    Curriculum opened;
    if (!context().guarded([&] {
            const std::string file = QDir::fromNativeSeparators(path).toStdString();
            opened = parse_draft(read_text_file(file, JsonLimits().bytes), file);
            if (opened.id != in_force().id)
                throw InputError(file, "/id",
                                 {QT_TRANSLATE_NOOP("errors", "is another curriculum: %1"), opened.id},
                                 {QT_TRANSLATE_NOOP("errors", "open a draft of %1"), in_force().id});
        }))
        return;
    draft_ = std::move(opened);
    draft_.version = in_force().next_own_version();  // a version in use is never edited
    path_->setText(QDir::toNativeSeparators(path));
    fill(0);
}

void CurriculumPage::save() {
    const std::string file = QDir::fromNativeSeparators(path_->text().trimmed()).toStdString();
    const bool written = context().guarded([&] {
        const std::string content = curriculum_text(draft_);
        parse_draft(content, file);  // what is written can be read
        write_output_file(file, content);
    });
    look();
    if (written)
        context().say(tr("Wrote %1. It is a draft: nothing has changed yet.").arg(path_->text().trimmed()));
}

void CurriculumPage::publish() {
    const bool done = context().guarded([&] {
        context().services().publish_curriculum(context().session(), curriculum_text(draft_),
                                                plain(reason_->text().trimmed()));
    });
    if (!done) return look();
    start_over();
    fill(std::max(0, tasks_->currentRow()));
    context().say(tr("Version %1 is in force. People who have begun stay on theirs until you move them.")
                      .arg(in_force().version));
}

std::optional<CurriculumPage::Begun> CurriculumPage::begun() const {
    if (based_on_.empty() || !is_changed()) return std::nullopt;
    return Begun{draft_, based_on_, reason_->text(), path_->text(), tasks_->currentRow()};
}

void CurriculumPage::take_up(const Begun& from) {
    read_installed();
    start_over();
    draft_ = from.draft;
    based_on_ = from.based_on;
    reason_->setText(from.reason);
    path_->setText(from.path);
    fill(from.row);
}

}  // namespace fulcrum::ui
