// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of the stations that a test program makes are in a folder of its own, and so are those of the
// programs that it starts.
#pragma once

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <memory>

namespace fulcrum::database::test {

class OwnStationKeys {
  public:
    OwnStationKeys() {
        if (!qEnvironmentVariableIsEmpty("FULCRUM_STATION_KEYS")) return;
        folder_ = std::make_unique<QTemporaryDir>();
        qputenv("FULCRUM_STATION_KEYS", folder_->path().toLocal8Bit());
    }

  private:
    std::unique_ptr<QTemporaryDir> folder_;  ///< none in a program that a test started: it may be killed
};

/// A test that changes keys: it has copies of them, so that the others keep theirs.
class KeysOfOneTest {
  public:
    KeysOfOneTest() {
        const QDir usual(QString::fromLocal8Bit(before_));
        for (const QString& name : usual.entryList({QStringLiteral("*.key")}, QDir::Files))
            QFile::copy(usual.filePath(name), folder_.filePath(name));
        qputenv("FULCRUM_STATION_KEYS", folder_.path().toLocal8Bit());
    }
    ~KeysOfOneTest() { qputenv("FULCRUM_STATION_KEYS", before_); }
    KeysOfOneTest(const KeysOfOneTest&) = delete;
    KeysOfOneTest& operator=(const KeysOfOneTest&) = delete;

  private:
    const QByteArray before_ = qgetenv("FULCRUM_STATION_KEYS");
    QTemporaryDir folder_;
};

}  // namespace fulcrum::database::test
