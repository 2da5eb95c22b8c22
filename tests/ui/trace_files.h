// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of other programs as files, and the card that imports them, for the tests of the window.
#pragma once

#include <QComboBox>
#include <QLineEdit>
#include <QTemporaryDir>
#include <cmath>
#include <fstream>

#include "tests/ui/screens.h"

namespace fulcrum::ui::window_test {

/// Ten seconds of the JIGSAWS columns: the left tool goes round.
inline void write_jigsaws(const std::string& path, int rows = 300) {
    std::ofstream file(path);
    for (int i = 0; i < rows; ++i) {
        for (int column = 1; column <= 76; ++column)
            file << "  "
                 << (column == 39   ? 0.05 * std::cos(0.1 * i)
                     : column == 40 ? 0.05 * std::sin(0.1 * i)
                                    : 0.01);
        file << '\n';
    }
}

/// Five seconds of PerkTutor's XML at 50 Hz; the third device is of no mapping, and one has a pause.
inline void write_perktutor(const std::string& path) {
    std::ofstream file(path);
    file << "<TransformRecorderLog>\n";
    for (int i = 0; i < 250; ++i)
        for (const char* device : {"ProbeToRAS", "StylusTipToRAS", "ReferenceToRAS"}) {
            if (i >= 100 && i < 120 && device[0] == 'S') continue;
            file << "  <log TimeStampSec=\"" << 1700000000 + i / 50 << "\" TimeStampNSec=\""
                 << i % 50 * 20'000'000 << "\" type=\"transform\" DeviceName=\"" << device
                 << "\" transform=\"1 0 0 " << 0.4 * i << " 0 1 0 10 0 0 1 20 0 0 0 1 \" />\n";
        }
    file << "</TransformRecorderLog>\n";
}

/// Types the path, chooses the format by its file and reads.
inline void read_trace_in(QWidget& window, const QString& path, const char* mapping) {
    find<QLineEdit>(window, "trace_path")->setText(path);
    auto* formats = find<QComboBox>(window, "trace_mapping");
    for (int i = 0; i < formats->count(); ++i)
        if (formats->itemData(i).toString().endsWith(QLatin1String(mapping))) formats->setCurrentIndex(i);
    ASSERT_TRUE(formats->currentData().toString().endsWith(QLatin1String(mapping))) << mapping;
    click(window, "trace_look");
}

}  // namespace fulcrum::ui::window_test
