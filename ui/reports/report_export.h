// SPDX-License-Identifier: GPL-3.0-or-later
// Reports asked for on a screen: where to, then written on a worker thread with progress and a way to stop
// it.
#pragma once

#include <QString>
#include <functional>

#include "ui/page/context.h"
#include "ui/reports/report.h"

namespace fulcrum::ui {

class JobBar;

/// By the file's ending.
ReportFormat report_format_of(const QString& path);
/// Writes on a worker thread with a store of its own, shown in `bar`; `done` gets the first file's path on
/// the UI thread, where `page` is still there. That it is saved, or what went wrong, is said on the window.
/// Signing out stops it; it is written also where the pages are made again (another text size or language).
void export_report(Context& context, QWidget* page, JobBar* bar, const ReportRequest& request,
                   std::function<void(const QString&)> done);
/// Those that are being written and were begun on a page that this one takes the place of, in its bar, which
/// is in its layout.
void show_begun_reports(Context& context, const QWidget* page, JobBar* bar);

}  // namespace fulcrum::ui
