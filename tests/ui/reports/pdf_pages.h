// SPDX-License-Identifier: GPL-3.0-or-later
// The text of the pages of a PDF.
#pragma once

#include <gtest/gtest.h>

#include <QByteArray>
#include <QList>
#include <QProcess>
#include <string>

namespace fulcrum::ui {

/// The text of each page, in its layout.
inline QList<QByteArray> pages_of(const std::string& path) {
    QProcess process;
    process.start(QStringLiteral("pdftotext"),
                  {QStringLiteral("-layout"), QString::fromStdString(path), QStringLiteral("-")});
    EXPECT_TRUE(process.waitForFinished(20000)) << "pdftotext (poppler-utils) is needed";
    QList<QByteArray> pages = process.readAllStandardOutput().split('\f');
    if (!pages.isEmpty() && pages.back().trimmed().isEmpty()) pages.pop_back();
    return pages;
}

}  // namespace fulcrum::ui
