// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/chart_axis.h"

#include <algorithm>
#include <cmath>

#include "sim_core/lab/chart.h"

namespace fulcrum::lab {

std::string short_number(double value, int digits) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    if (value == 0) return "0";
    const bool negative = value < 0;
    double size = std::fabs(value);
    int exponent = static_cast<int>(std::floor(std::log10(size)));
    const double scale = std::pow(10.0, digits - 1 - exponent);
    auto mantissa = std::isfinite(scale) ? std::llround(size * scale) : 0;
    const auto limit = std::llround(std::pow(10.0, digits));
    if (mantissa >= limit) {
        mantissa /= 10;
        ++exponent;
    }
    std::string figures = std::to_string(mantissa);
    std::string text;
    if (exponent >= -3 && exponent <= 5) {
        const int point = exponent + 1;
        if (point <= 0) {
            text = "0." + std::string(static_cast<std::size_t>(-point), '0') + figures;
        } else if (point >= static_cast<int>(figures.size())) {
            text = figures + std::string(static_cast<std::size_t>(point) - figures.size(), '0');
        } else {
            text = figures.substr(0, static_cast<std::size_t>(point)) + "." +
                   figures.substr(static_cast<std::size_t>(point));
        }
        if (text.find('.') != std::string::npos) {
            text.erase(text.find_last_not_of('0') + 1);
            if (text.back() == '.') text.pop_back();
        }
    } else {
        std::string rest = figures.substr(1);
        rest.erase(rest.find_last_not_of('0') + 1);
        text = figures.substr(0, 1) + (rest.empty() ? "" : "." + rest) + "e" + (exponent < 0 ? "-" : "") +
               (std::abs(exponent) < 10 ? "0" : "") + std::to_string(std::abs(exponent));
    }
    return (negative ? "-" : "") + text;
}

ChartAxis::ChartAxis(const std::vector<double>& values, bool logarithmic) : logarithmic_(logarithmic) {
    bool any = false;
    for (const double value : values) {
        if (!takes(value)) continue;
        const double v = logarithmic ? std::log10(value) : value;
        low_ = any ? std::min(low_, v) : v;
        high_ = any ? std::max(high_, v) : v;
        any = true;
    }
    if (!any) return;
    if (high_ - low_ < 1e-12) {
        low_ -= logarithmic ? 0.5 : std::max(1e-12, 0.5 * std::fabs(low_));
        high_ += logarithmic ? 0.5 : std::max(1e-12, 0.5 * std::fabs(high_));
    }
    const double open = 0.04 * (high_ - low_);
    low_ -= open;
    high_ += open;
}

void ChartAxis::place(double first, double last) {
    first_ = first;
    last_ = last;
}

bool ChartAxis::takes(double value) const {
    return std::isfinite(value) && (!logarithmic_ || value > 0);
}

double ChartAxis::scaled(double value) const {
    return ((logarithmic_ ? std::log10(value) : value) - low_) / (high_ - low_);
}

double ChartAxis::unscaled(double share) const {
    const double v = low_ + share * (high_ - low_);
    return logarithmic_ ? std::pow(10.0, v) : v;
}

bool ChartAxis::inside(double value) const {
    if (!takes(value)) return false;
    const double share = scaled(value);
    return share >= 0 && share <= 1;
}

double ChartAxis::at(double value) const {
    return first_ + (last_ - first_) * scaled(value);
}

std::vector<ChartAxis::Tick> ChartAxis::ticks() const {
    std::vector<Tick> ticks;
    if (logarithmic_) {
        const int from = static_cast<int>(std::floor(low_)), to = static_cast<int>(std::ceil(high_));
        const int stride = std::max(1, (to - from + 7) / 8);
        for (int decade = from; decade <= to; ++decade) {
            for (int part = 1; part <= 9; ++part) {
                const double value = part * std::pow(10.0, decade);
                if (!inside(value)) continue;
                const bool named = (part == 1 && (decade % stride + stride) % stride == 0) ||
                                   (high_ - low_ < 1.5 && (part == 2 || part == 5));
                if (part != 1 && high_ - low_ > 6) continue;
                ticks.push_back({value, named ? short_number(value, 2) : ""});
            }
        }
        return ticks;
    }
    const double raw = (high_ - low_) / 6, power = std::pow(10.0, std::floor(std::log10(raw)));
    double step = power;
    for (const double part : {2.0, 5.0, 10.0}) {
        if (step < raw) step = part * power;
    }
    for (double k = std::ceil(low_ / step); k * step <= high_; ++k)
        ticks.push_back({k * step, short_number(k * step, 4)});
    return ticks;
}

}  // namespace fulcrum::lab
