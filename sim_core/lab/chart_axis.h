// SPDX-License-Identifier: Apache-2.0
// One axis of a chart: range, ticks, and where a value lies.
#pragma once

#include <string>
#include <vector>

namespace fulcrum::lab {

class ChartAxis {
  public:
    /// Range over the values given (those that are finite, and positive where logarithmic), opened by a
    /// little on each side.
    ChartAxis(const std::vector<double>& values, bool logarithmic);
    /// Pixels between which the range lies; first belongs to the least value.
    void place(double first, double last);

    bool takes(double value) const;     ///< finite, and positive where logarithmic
    bool inside(double value) const;    ///< takes it and it lies in the range
    double at(double value) const;      ///< pixel
    double scaled(double value) const;  ///< 0 at the least, 1 at the largest value
    double unscaled(double share) const;

    struct Tick {
        double value = 0;
        std::string label;  ///< empty: minor
    };
    std::vector<Tick> ticks() const;

  private:
    bool logarithmic_;
    double low_ = 0, high_ = 1;  // of the value, or of its decimal logarithm
    double first_ = 0, last_ = 1;
};

}  // namespace fulcrum::lab
