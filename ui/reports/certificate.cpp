// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/certificate.h"

#include <QCoreApplication>

#include "ui/reports/paper.h"
#include "ui/reports/report_rows.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

QString say(const char* source) {
    return QCoreApplication::translate("fulcrum::ui::certificate", source);
}

QString day(std::int64_t utc_ms) {
    return local_time(utc_ms).section(QLatin1Char(' '), 0, 2);
}

/// `of`: the version that the certificate is of.
QString task_line(const database::CertificateTask& task, const std::string& of,
                  const std::vector<TaskDefinition>& tasks) {
    QString title = text(task.task);
    for (const TaskDefinition& one : tasks)
        if (one.id == task.task) title += QStringLiteral("  ") + asset_text(one.title);
    if (!task.by_override && !task.curriculum.empty() && task.curriculum != of)
        return say(QT_TRANSLATE_NOOP("fulcrum::ui::certificate",
                                     "%1: proficient since %2, by the rule of %3"))
            .arg(title, day(task.declared_at), text(task.curriculum));
    return (task.by_override ? say(QT_TRANSLATE_NOOP("fulcrum::ui::certificate",
                                                     "%1: proficient since %2, by decision of an educator"))
                             : say(QT_TRANSLATE_NOOP("fulcrum::ui::certificate", "%1: proficient since %2")))
        .arg(title, day(task.declared_at));
}

/// A paragraph in the middle of the page; moves down.
void centred(Sheet& sheet, const QString& shown) {
    const double side = Sheet::mm(22);
    QRectF used;
    sheet.painter().drawText(QRectF(side, sheet.y(), sheet.width() - 2 * side, sheet.height()),
                             Qt::AlignHCenter | Qt::TextWordWrap, shown, &used);
    sheet.to(used.bottom() + Sheet::mm(0.8));
}

/// Two lines around what is certified, the outer one strong.
void frame(Sheet& sheet, double bottom) {
    QPainter& painter = sheet.painter();
    painter.save();
    painter.setBrush(Qt::NoBrush);
    const QRectF outer(Sheet::mm(1), Sheet::mm(1), sheet.width() - Sheet::mm(2), bottom - Sheet::mm(1));
    painter.setPen(QPen(paper_palette().accent, Sheet::mm(0.9)));
    painter.drawRect(outer);
    painter.setPen(QPen(paper_palette().accent, Sheet::mm(0.25)));
    const double gap = Sheet::mm(1.6);
    painter.drawRect(outer.adjusted(gap, gap, -gap, -gap));
    painter.restore();
}

/// A line to sign on, with what it is for below it.
void signature(Sheet& sheet, double x, double y, const QString& whose) {
    QPainter& painter = sheet.painter();
    const double length = Sheet::mm(70);
    sheet.font(8.5, false, paper_palette().muted);
    painter.save();
    painter.setPen(QPen(paper_palette().text, Sheet::mm(0.2)));
    painter.drawLine(QPointF(x, y), QPointF(x + length, y));
    painter.restore();
    painter.drawText(QRectF(x, y + Sheet::mm(1), length, Sheet::mm(6)), Qt::AlignHCenter, whose);
}

}  // namespace

void write_certificate(const database::Store& store, const database::Session& session,
                       const database::Certificate& certificate, const std::vector<TaskDefinition>& tasks,
                       const std::string& program_version, const std::string& path) {
    store.require(session, database::Operation::export_person,
                  database::Subject::person(certificate.person_id));
    Sheet sheet(path, true,
                say(QT_TRANSLATE_NOOP("fulcrum::ui::certificate", "Certificate of %1"))
                    .arg(text(certificate.person_name)));
    sheet.new_page();
    const double bottom = sheet.height() - Sheet::mm(footer_mm + 4);  // the foot follows
    frame(sheet, bottom);
    sheet.skip(12);
    sheet.font(12, false, paper_palette().muted);
    centred(sheet, text(certificate.programme));
    sheet.skip(3);
    sheet.font(32, true, paper_palette().accent);
    centred(sheet, say(QT_TRANSLATE_NOOP("fulcrum::ui::certificate", "Certificate")));
    sheet.skip(5);
    sheet.font(22, true);
    centred(sheet, text(certificate.person_name));
    sheet.skip(2);
    sheet.font(12.5);
    centred(sheet, say(QT_TRANSLATE_NOOP("fulcrum::ui::certificate",
                                         "has completed stage %1, %2, of the curriculum %3 on %4."))
                       .arg(text(certificate.stage), asset_text(certificate.stage_title),
                            asset_text(certificate.curriculum_title), day(certificate.completed_at)));
    sheet.skip(4);
    sheet.font(10);
    for (const database::CertificateTask& task : certificate.tasks)
        centred(sheet, task_line(task, certificate.curriculum, tasks));
    if (!certificate.follows.empty() && certificate.follows != certificate.curriculum)
        centred(sheet, say(QT_TRANSLATE_NOOP("fulcrum::ui::certificate",
                                             "Completed under %1, before the move to %2."))
                           .arg(text(certificate.curriculum), text(certificate.follows)));
    sheet.skip(3);
    sheet.font(8, false, paper_palette().muted);
    centred(
        sheet,
        say(QT_TRANSLATE_NOOP(
                "fulcrum::ui::certificate",
                "Proficiency is declared by the rule of the curriculum (%1) or by an educator; limits from "
                "synthetic operators never declare it. It is checked again after 14, 30, 91 and 182 days."))
            .arg(text(certificate.curriculum)));
    const double signed_at = bottom - Sheet::mm(34), side = Sheet::mm(30);
    signature(sheet, side, signed_at,
              say(QT_TRANSLATE_NOOP("fulcrum::ui::certificate", "Director of the programme")));
    signature(sheet, sheet.width() - side - Sheet::mm(70), signed_at,
              say(QT_TRANSLATE_NOOP("fulcrum::ui::certificate", "Date")));
    sheet.to(bottom - Sheet::mm(22));
    sheet.font(12, true);
    centred(sheet,
            say(QT_TRANSLATE_NOOP("fulcrum::ui::certificate", "Check code %1")).arg(text(certificate.code)));
    sheet.font(8, false, paper_palette().muted);
    centred(sheet,
            say(QT_TRANSLATE_NOOP(
                    "fulcrum::ui::certificate",
                    "The programme verifies it with: fulcrum certificate --verify %1 --as LOGIN. The code is "
                    "valid while every proficiency above is in force."))
                .arg(text(certificate.code)));
    footer(sheet, provenance_of(store, session, program_version),
           say(QT_TRANSLATE_NOOP("fulcrum::ui::certificate", "person %1")).arg(text(certificate.person_id)));
    sheet.finish();
}

}  // namespace fulcrum::ui
