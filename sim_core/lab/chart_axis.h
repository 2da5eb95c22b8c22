// SPDX-License-Identifier: Apache-2.0
// One axis of a chart: range, ticks, and the position of a value.
#pragma once

#include <string>
#include <vector>

namespace fulcrum::lab {

class ChartAxis {
  public:
    /// Range over the given values (those that are finite, and positive if logarithmic), slightly widened on
    /// each side.
    ChartAxis(const std::vector<double>& values, bool logarithmic);
    /// Pixel range of the axis; `first` corresponds to the smallest value.
    void place(double first, double last);

    bool takes(double value) const;     ///< finite, and positive if logarithmic
    bool inside(double value) const;    ///< accepted and within the range
    double at(double value) const;      ///< pixel
    double scaled(double value) const;  ///< 0 at the smallest, 1 at the largest value
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
