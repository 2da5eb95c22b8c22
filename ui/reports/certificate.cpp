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

QString task_line(const database::CertificateTask& task, const std::vector<TaskDefinition>& tasks) {
    QString title = text(task.task);
    for (const TaskDefinition& one : tasks)
        if (one.id == task.task) title += QStringLiteral("  ") + asset_text(one.title);
    return (task.by_override ? say("%1: proficient since %2, by decision of an educator")
                             : say("%1: proficient since %2"))
        .arg(title, day(task.declared_at));
}

}  // namespace

void write_certificate(const database::Store& store, const database::Session& session,
                       const database::Certificate& certificate, const std::vector<TaskDefinition>& tasks,
                       const std::string& program_version, const std::string& path) {
    store.require(session, database::Operation::export_person,
                  database::Subject::person(certificate.person_id));
    Sheet sheet(path, false, say("Certificate of %1").arg(text(certificate.person_name)));
    sheet.new_page();
    sheet.font(10, false, paper_palette().muted);
    sheet.skip(20);
    sheet.paragraph(text(certificate.programme));
    sheet.font(26, true);
    sheet.paragraph(say("Certificate"));
    sheet.skip(8);
    sheet.font(18, true);
    sheet.paragraph(text(certificate.person_name));
    sheet.font(12);
    sheet.paragraph(say("has completed stage %1, %2, of the curriculum %3 on %4.")
                        .arg(text(certificate.stage), asset_text(certificate.stage_title),
                             asset_text(certificate.curriculum_title), day(certificate.completed_at)));
    sheet.skip(6);
    sheet.font(10.5);
    for (const database::CertificateTask& task : certificate.tasks)
        sheet.paragraph(QStringLiteral("•  ") + task_line(task, tasks));
    sheet.skip(8);
    sheet.font(9, false, paper_palette().muted);
    sheet.paragraph(
        say("Proficiency is declared by the rule of the curriculum (%1) or by an educator; limits from "
            "synthetic operators never declare it. It is checked again after 14, 30, 91 and 182 days.")
            .arg(text(certificate.curriculum)));
    sheet.skip(10);
    sheet.font(13, true);
    sheet.paragraph(say("Check code %1").arg(text(certificate.code)));
    sheet.font(9, false, paper_palette().muted);
    sheet.paragraph(
        say("The programme verifies it with: fulcrum certificate --verify %1 --as LOGIN. The code is "
            "valid while every proficiency above is in force.")
            .arg(text(certificate.code)));
    footer(sheet, provenance_of(store, session, program_version),
           say("person %1").arg(text(certificate.person_id)));
    sheet.finish();
}

}  // namespace fulcrum::ui
