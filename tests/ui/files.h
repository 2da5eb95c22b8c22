// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the files that the window has written.
#pragma once

#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>
#include <string>

namespace fulcrum::ui::window_test {

inline std::string read_text(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll().toStdString();
}

inline std::string pdf_text(const QString& path) {
    QProcess process;
    process.start(QStringLiteral("pdftotext"), {QStringLiteral("-layout"), path, QStringLiteral("-")});
    EXPECT_TRUE(process.waitForFinished(60000)) << "pdftotext (poppler-utils) is needed";
    return process.readAllStandardOutput().toStdString();
}

}  // namespace fulcrum::ui::window_test
