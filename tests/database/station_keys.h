// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of the stations that a test program makes are in a folder of its own, and so are those of the
// programs that it starts.
#pragma once

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

}  // namespace fulcrum::database::test
