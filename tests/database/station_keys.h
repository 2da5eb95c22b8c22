// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of the stations that a test program makes are in a folder of its own, and so are those of the
// programs that it starts.
#pragma once

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace fulcrum::database::test {

class OwnStationKeys {
  public:
    OwnStationKeys() {
        if (qEnvironmentVariableIsEmpty("FULCRUM_STATION_KEYS"))
            qputenv("FULCRUM_STATION_KEYS", folder_.path().toLocal8Bit());
    }

  private:
    QTemporaryDir folder_;
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
