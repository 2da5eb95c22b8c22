// SPDX-License-Identifier: Apache-2.0
// Limits on time that hold on a busy machine as well.
#pragma once

#include <ctime>

namespace fulcrum::test {

/// Processor time of all threads of this process since it was made.
class ProcessorTime {
  public:
    double milliseconds() const { return 1e3 * static_cast<double>(std::clock() - start_) / CLOCKS_PER_SEC; }

  private:
    std::clock_t start_ = std::clock();
};

}  // namespace fulcrum::test
