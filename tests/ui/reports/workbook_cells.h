// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of a workbook, as another program reads them.
#pragma once

#include <gtest/gtest.h>

#include <QProcess>
#include <QXmlStreamReader>
#include <map>
#include <string>
#include <vector>

namespace fulcrum::ui {

inline QByteArray part_of(const QString& archive, const char* part) {
    QProcess unzip;
    unzip.start(QStringLiteral("unzip"), {QStringLiteral("-p"), archive, QString::fromLatin1(part)});
    EXPECT_TRUE(unzip.waitForFinished());
    EXPECT_EQ(unzip.exitCode(), 0) << part << unzip.readAllStandardError().constData();
    return unzip.readAllStandardOutput();
}

inline std::vector<QString> shared_strings(const QString& archive) {
    std::vector<QString> strings;
    QXmlStreamReader xml(part_of(archive, "xl/sharedStrings.xml"));
    while (!xml.atEnd()) {
        xml.readNext();
        if (xml.isStartElement() && xml.name() == QLatin1String("t"))
            strings.push_back(xml.readElementText());
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return strings;
}

/// A cell by its reference, such as "B3"; words as they are, numbers as written.
inline std::map<std::string, QString> cells_of(const QString& archive, const char* sheet) {
    const std::vector<QString> strings = shared_strings(archive);
    std::map<std::string, QString> cells;
    QXmlStreamReader xml(part_of(archive, sheet));
    std::string at;
    bool shared = false;
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement()) continue;
        EXPECT_NE(xml.name(), QLatin1String("f")) << "a formula";
        if (xml.name() == QLatin1String("c")) {
            at = xml.attributes().value(QLatin1String("r")).toString().toStdString();
            shared = xml.attributes().value(QLatin1String("t")) == QLatin1String("s");
        } else if (xml.name() == QLatin1String("v")) {
            const QString value = xml.readElementText();
            cells[at] = shared ? strings.at(value.toUInt()) : value;
        }
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return cells;
}

inline std::string reference(std::size_t column, std::size_t row) {
    std::string letters;
    for (std::size_t rest = column + 1; rest > 0; rest = (rest - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('A' + (rest - 1) % 26));
    return letters + std::to_string(row + 1);
}

}  // namespace fulcrum::ui
