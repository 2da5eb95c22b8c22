// SPDX-License-Identifier: GPL-3.0-or-later
// The context of the texts of reports and of the pathology report: ReportTexts::tr("Passed").
#pragma once

#include <QCoreApplication>

namespace fulcrum::ui {

struct ReportTexts {
    Q_DECLARE_TR_FUNCTIONS(fulcrum::ui::ReportTexts)
};

}  // namespace fulcrum::ui
