// SPDX-License-Identifier: Apache-2.0
// Drawing primitives of charts; only SVG Tiny 1.2, which Qt renders.
#pragma once

#include <string>

namespace fulcrum::lab {

/// Text of an SVG file under construction. Coordinates in pixels, y down.
class Svg {
  public:
    Svg(double width, double height);
    void line(double x1, double y1, double x2, double y2, const std::string& colour, double width = 1,
              bool dashed = false);
    void rectangle(double x, double y, double width, double height, const std::string& fill,
                   const std::string& stroke = "none");
    /// anchor: start, middle, end; degrees: turned about its point.
    void text(double x, double y, const std::string& words, double size, const std::string& anchor = "start",
              double degrees = 0, const std::string& colour = "#222222", bool bold = false);
    /// Shape 0 to 5: circle, square, triangle, diamond, cross, plus.
    void marker(double x, double y, int shape, double size, const std::string& colour, bool filled);
    void polyline(const std::string& points, const std::string& colour, double width, bool dashed);
    std::string finish() const;

  private:
    std::string body_;
};

/// Pixel coordinate with two decimals.
std::string pixel(double value);
/// Colour of a series, cycling through the palette.
const char* series_colour(std::size_t index);

}  // namespace fulcrum::lab
