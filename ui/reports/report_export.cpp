// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/reports/report_export.h"

#include <QCoreApplication>
#include <QPointer>
#include <QVariant>
#include <memory>

#include "ui/page/background_job.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

QString words(const char* source) {
    return QCoreApplication::translate("fulcrum::ui::report_export", source);
}

/// Property of a job: the page from which its report was asked for.
constexpr const char* asking_page = "asking_page";

void show_job(JobBar* bar, BackgroundJob* job) {
    bar->watch(job, words(QT_TRANSLATE_NOOP("fulcrum::ui::report_export", "Writing the report …")));
}

}  // namespace

ReportFormat report_format_of(const QString& path) {
    for (const ReportFormatRow& row : report_formats)
        if (row.ending != nullptr && path.endsWith(QLatin1String(row.ending), Qt::CaseInsensitive))
            return row.kind;
    return ReportFormat::pdf;
}

void export_report(Context& context, QWidget* page, JobBar* bar, const ReportRequest& request,
                   std::function<void(const QString&)> done) {
    auto files = std::make_shared<std::vector<std::string>>();
    BackgroundJob* job = BackgroundJob::run(
        &context,
        [files, request, session = context.session(), store_path = context.store().path(),
         tasks = context.services().tasks(), curriculum = context.services().curriculum(),
         version = context.services().program_version()](const Progress& progress) {
            database::StoreOptions options;
            options.read_only = true;
            const database::Store store = database::Store::open(store_path, options);
            ReportRequest whole = request;
            whole.curriculum = &curriculum;
            *files = write_report(store, session, whole, tasks, version, progress);
        },
        [&context, files, page = QPointer<QWidget>(page), done = std::move(done)] {
            if (files->empty()) return;
            context.say(
                words(QT_TRANSLATE_NOOP("fulcrum::ui::report_export", "Saved %1")).arg(text(files->front())));
            if (page) done(text(files->front()));
        },
        [&context](const QString& error) { context.complain(error); });
    QObject::connect(&context, &Context::session_changed, job, [&context, job] {
        if (!context.signed_in()) job->cancel();
    });
    job->setProperty(asking_page, page->objectName());
    QObject::connect(job, &BackgroundJob::ended, job, [job] { job->setProperty(asking_page, QVariant()); });
    show_job(bar, job);
}

void show_begun_reports(Context& context, const QWidget* page, JobBar* bar) {
    for (BackgroundJob* job : context.findChildren<BackgroundJob*>(QString(), Qt::FindDirectChildrenOnly))
        if (job->property(asking_page).toString() == page->objectName()) show_job(bar, job);
}

}  // namespace fulcrum::ui
