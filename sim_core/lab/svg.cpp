// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/svg.h"

#include <array>
#include <cmath>

namespace fulcrum::lab {
namespace {

std::string escaped(const std::string& words) {
    std::string result;
    for (const char c : words) {
        if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '&')
            result += "&amp;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

}  // namespace

std::string pixel(double value) {
    const auto hundredths = std::llround(value * 100);
    const long long whole = std::llabs(hundredths) / 100, rest = std::llabs(hundredths) % 100;
    std::string text = (hundredths < 0 ? "-" : "") + std::to_string(whole);
    if (rest != 0) {
        text += rest < 10 ? ".0" : ".";
        text += rest % 10 == 0 ? std::to_string(rest / 10) : std::to_string(rest);
    }
    return text;
}

const char* series_colour(std::size_t index) {
    static constexpr std::array<const char*, 7> colours = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                           "#E69F00", "#56B4E9", "#444444"};
    return colours[index % colours.size()];
}

Svg::Svg(double width, double height) {
    body_ =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- SPDX-License-Identifier: Apache-2.0 -->\n<svg "
        "xmlns=\"http://www.w3.org/2000/svg\" width=\"" +
        pixel(width) + "\" height=\"" + pixel(height) + "\" viewBox=\"0 0 " + pixel(width) + " " +
        pixel(height) + "\" font-family=\"DejaVu Sans, Helvetica, Arial, sans-serif\">\n";
    rectangle(0, 0, width, height, "#ffffff");
}

void Svg::line(double x1, double y1, double x2, double y2, const std::string& colour, double width,
               bool dashed) {
    body_ += "<line x1=\"" + pixel(x1) + "\" y1=\"" + pixel(y1) + "\" x2=\"" + pixel(x2) + "\" y2=\"" +
             pixel(y2) + "\" stroke=\"" + colour + "\" stroke-width=\"" + pixel(width) + "\"" +
             (dashed ? " stroke-dasharray=\"6 4\"" : "") + "/>\n";
}

void Svg::rectangle(double x, double y, double width, double height, const std::string& fill,
                    const std::string& stroke) {
    body_ += "<rect x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" width=\"" + pixel(width) + "\" height=\"" +
             pixel(height) + "\" fill=\"" + fill + "\"" +
             (stroke == "none" ? "" : " stroke=\"" + stroke + "\"") + "/>\n";
}

void Svg::text(double x, double y, const std::string& words, double size, const std::string& anchor,
               double degrees, const std::string& colour, bool bold) {
    body_ += "<text x=\"" + pixel(x) + "\" y=\"" + pixel(y) + "\" font-size=\"" + pixel(size) +
             "\" text-anchor=\"" + anchor + "\" fill=\"" + colour + "\"" +
             (bold ? " font-weight=\"bold\"" : "");
    if (degrees != 0)
        body_ += " transform=\"rotate(" + pixel(degrees) + " " + pixel(x) + " " + pixel(y) + ")\"";
    body_ += ">" + escaped(words) + "</text>\n";
}

void Svg::marker(double x, double y, int shape, double size, const std::string& colour, bool filled) {
    const std::string paint = std::string(" fill=\"") + (filled ? colour : "#ffffff") + "\" stroke=\"" +
                              colour + "\" stroke-width=\"1.5\"/>\n";
    const auto at = [](double px, double py) { return pixel(px) + "," + pixel(py) + " "; };
    switch (shape % 6) {
        case 0:
            body_ +=
                "<circle cx=\"" + pixel(x) + "\" cy=\"" + pixel(y) + "\" r=\"" + pixel(size) + "\"" + paint;
            break;
        case 1:
            body_ += "<rect x=\"" + pixel(x - size) + "\" y=\"" + pixel(y - size) + "\" width=\"" +
                     pixel(2 * size) + "\" height=\"" + pixel(2 * size) + "\"" + paint;
            break;
        case 2:
            body_ += "<polygon points=\"" + at(x, y - 1.2 * size) + at(x + 1.1 * size, y + size) +
                     at(x - 1.1 * size, y + size) + "\"" + paint;
            break;
        case 3:
            body_ += "<polygon points=\"" + at(x, y - 1.3 * size) + at(x + 1.3 * size, y) +
                     at(x, y + 1.3 * size) + at(x - 1.3 * size, y) + "\"" + paint;
            break;
        case 4:
            line(x - size, y - size, x + size, y + size, colour, filled ? 2.5 : 1.5);
            line(x - size, y + size, x + size, y - size, colour, filled ? 2.5 : 1.5);
            break;
        default:
            line(x - 1.2 * size, y, x + 1.2 * size, y, colour, filled ? 2.5 : 1.5);
            line(x, y - 1.2 * size, x, y + 1.2 * size, colour, filled ? 2.5 : 1.5);
    }
}

void Svg::polyline(const std::string& points, const std::string& colour, double width, bool dashed) {
    body_ += "<polyline points=\"" + points + "\" fill=\"none\" stroke=\"" + colour + "\" stroke-width=\"" +
             pixel(width) + "\"" + (dashed ? " stroke-dasharray=\"7 4\"" : "") + "/>\n";
}

std::string Svg::finish() const {
    return body_ + "</svg>\n";
}

}  // namespace fulcrum::lab
