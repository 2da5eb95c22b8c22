// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/certificate_card.h"

#include <QDir>
#include <QFileInfo>

#include "database/records/certificates.h"
#include "database/records/curricula.h"
#include "ui/reports/certificate.h"
#include "ui/reports/export_row.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

/// A file that is not there yet.
QString free_path(const QString& folder, const QString& name) {
    QString path = QDir(folder).filePath(name + QStringLiteral(".pdf"));
    for (int number = 2; QFileInfo::exists(path); ++number)
        path = QDir(folder).filePath(QStringLiteral("%1 (%2).pdf").arg(name).arg(number));
    return path;
}

}  // namespace

CertificateCard::CertificateCard(Context& context) : context_(context) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    QFrame* card = make_card(6);
    lines_ = card_layout(card);
    layout->addWidget(card);
    hide();
}

void CertificateCard::show_person(const std::string& person_id, const QString& folder) {
    folder_ = folder;
    clear_layout(lines_);
    const database::Subject subject = database::Subject::person(person_id);
    std::vector<database::Certificate> made;
    std::string missing;
    if (!person_id.empty() && context_.allowed(database::Operation::read_progress, subject) &&
        context_.allowed(database::Operation::export_person, subject))
        context_.guarded([&] {
            const Curriculum& newest = context_.services().curriculum();
            missing = database::Curricula(context_.store()).missing(context_.session(), person_id, newest);
            if (missing.empty())
                made = database::certificates(context_.store(), context_.session(), person_id, newest);
        });
    setVisible(!made.empty() || !missing.empty());
    if (!missing.empty()) {
        QLabel* words = make_label(tr("No certificate: the curriculum %1, which is followed, is not at this "
                                      "station.")
                                       .arg(text(missing)),
                                   "muted");
        words->setObjectName(QStringLiteral("no_certificate"));
        lines_->addWidget(words);
    }
    for (const database::Certificate& one : made) {
        auto* row = new QHBoxLayout;
        const QString stage = text(one.stage), title = asset_text(one.stage_title),
                      day = date_text(one.completed_at), code = text(one.code);
        QLabel* words = make_label(
            one.curriculum == one.follows
                ? tr("Stage %1, %2, completed on %3. Check code %4.").arg(stage, title, day, code)
                : tr("Stage %1, %2, completed on %3 under %4, before the move to %5. Check code %6.")
                      .arg(stage, title, day, text(one.curriculum), text(one.follows), code));
        words->setObjectName(QStringLiteral("certificate_words"));
        words->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        row->addWidget(words, 1);
        QPushButton* button = make_button(tr("Save the certificate (PDF)"), "save_certificate");
        connect(
            button, &QPushButton::clicked, this,
            [this, person_id, version = one.curriculum, id = one.stage] { save(person_id, version, id); });
        row->addWidget(button);
        lines_->addLayout(row);
    }
}

void CertificateCard::save(const std::string& person_id, const std::string& curriculum,
                           const std::string& stage) {
    QString path;
    const bool saved = context_.guarded([&] {
        // The record may have changed since the page was filled.
        for (const database::Certificate& one : database::certificates(
                 context_.store(), context_.session(), person_id, context_.services().curriculum())) {
            if (one.curriculum != curriculum || one.stage != stage) continue;
            path = free_path(folder_,
                             file_name(tr("Certificate %1 %2").arg(text(stage), text(one.person_name))));
            write_certificate(context_.store(), context_.session(), one, context_.services().tasks(),
                              context_.services().program_version(), plain(path));
        }
    });
    if (!saved) return;
    if (path.isEmpty()) {
        context_.complain(tr("The stage is no longer completed."));
    } else {
        context_.say(tr("Wrote %1").arg(path));
    }
}

}  // namespace fulcrum::ui

#include "moc_certificate_card.cpp"
