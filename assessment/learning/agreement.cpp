// SPDX-License-Identifier: Apache-2.0
#include "assessment/learning/agreement.h"

#include <cmath>
#include <stdexcept>

#include "sim_core/numerics/name_table.h"

namespace fulcrum {
namespace {

constexpr double one_sided = 0.975;

/// Continued fraction of the incomplete beta function (Lentz's method).
double beta_fraction(double a, double b, double x) {
    constexpr double tiny = 1e-300;
    double c = 1, d = 1 - (a + b) * x / (a + 1);
    d = 1 / (std::fabs(d) < tiny ? tiny : d);
    double h = d;
    for (int m = 1; m <= 500; ++m) {
        const double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        d = 1 + even * d;
        c = 1 + even / c;
        d = 1 / (std::fabs(d) < tiny ? tiny : d);
        if (std::fabs(c) < tiny) c = tiny;
        h *= d * c;
        const double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        d = 1 + odd * d;
        c = 1 + odd / c;
        d = 1 / (std::fabs(d) < tiny ? tiny : d);
        if (std::fabs(c) < tiny) c = tiny;
        const double step = d * c;
        h *= step;
        if (std::fabs(step - 1) < 1e-15) break;
    }
    return h;
}

/// Regularised incomplete beta function I_x(a, b).
double incomplete_beta(double a, double b, double x) {
    if (x <= 0) return 0;
    if (x >= 1) return 1;
    const double front =
        std::exp(std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log1p(-x));
    return x < (a + 1) / (a + b + 2) ? front * beta_fraction(a, b, x) / a
                                     : 1 - front * beta_fraction(b, a, 1 - x) / b;
}

/// Mean squares of a table of targets and raters.
struct Table {
    double n = 0, k = 0;             ///< targets, raters
    double between = 0, within = 0;  ///< targets; within targets
    double raters = 0, residual = 0;
};

Table table_of(const std::vector<std::vector<double>>& ratings) {
    if (ratings.size() < 2 || ratings[0].size() < 2)
        throw std::invalid_argument(QT_TRANSLATE_NOOP("errors", "needs at least two targets and two raters"));
    Table table;
    table.n = static_cast<double>(ratings.size());
    table.k = static_cast<double>(ratings[0].size());
    double mean = 0;
    std::vector<double> raters(ratings[0].size(), 0.0), targets;
    for (const std::vector<double>& row : ratings) {
        if (row.size() != raters.size())
            throw std::invalid_argument(QT_TRANSLATE_NOOP("errors", "a rating is missing"));
        double sum = 0;
        for (std::size_t j = 0; j < row.size(); ++j) {
            if (!std::isfinite(row[j]))
                throw std::invalid_argument(QT_TRANSLATE_NOOP("errors", "a rating is not a number"));
            sum += row[j];
            raters[j] += row[j] / table.n;
        }
        targets.push_back(sum / table.k);
        mean += sum / (table.n * table.k);
    }
    double total = 0;
    for (std::size_t i = 0; i < ratings.size(); ++i) {
        table.between += table.k * (targets[i] - mean) * (targets[i] - mean);
        for (const double x : ratings[i]) {
            table.within += (x - targets[i]) * (x - targets[i]);
            total += (x - mean) * (x - mean);
        }
    }
    for (const double rater : raters) table.raters += table.n * (rater - mean) * (rater - mean);
    table.residual = total - table.between - table.raters;
    table.between /= table.n - 1;
    table.within /= table.n * (table.k - 1);
    table.raters /= table.k - 1;
    table.residual /= (table.n - 1) * (table.k - 1);
    if (total <= 0) throw std::invalid_argument(QT_TRANSLATE_NOOP("errors", "all ratings are equal"));
    return table;
}

Correlation single(double f, double low, double high, double k) {
    const auto of = [k](double ratio) { return (ratio - 1) / (ratio + k - 1); };
    return {of(f), of(low), of(high)};
}
Correlation mean_of_raters(double f, double low, double high) {
    return {1 - 1 / f, 1 - 1 / low, 1 - 1 / high};
}

/// ICC(2,1), its interval after Shrout and Fleiss 1979.
Correlation two_way(const Table& t) {
    const double n = t.n, k = t.k;
    Correlation c;
    c.value = (t.between - t.residual) / (t.between + (k - 1) * t.residual + k * (t.raters - t.residual) / n);
    const double f = t.raters / t.residual, a = k * c.value, b = n * (1 + (k - 1) * c.value) - a;
    const double top = a * f + b;
    const double freedom = (k - 1) * (n - 1) * top * top / ((n - 1) * a * a * f * f + b * b);
    const double upper = f_quantile(one_sided, n - 1, freedom), lower = f_quantile(one_sided, freedom, n - 1);
    const double rest = k * t.raters + (k * n - k - n) * t.residual;
    c.low = n * (t.between - upper * t.residual) / (upper * rest + n * t.between);
    c.high = n * (lower * t.between - t.residual) / (rest + n * lower * t.between);
    return c;
}

}  // namespace

double f_quantile(double p, double d1, double d2) {
    const auto below = [&](double f) { return incomplete_beta(0.5 * d1, 0.5 * d2, d1 * f / (d1 * f + d2)); };
    double low = 0, high = 1;
    while (below(high) < p && high < 1e12) high *= 2;
    for (int i = 0; i < 200; ++i) {
        const double middle = 0.5 * (low + high);
        (below(middle) < p ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

IntraclassCorrelations intraclass_correlations(const std::vector<std::vector<double>>& ratings) {
    const Table t = table_of(ratings);
    // Without any disagreement the ratios are infinite; a residual this small changes no digit that is shown.
    Table safe = t;
    const double least = 1e-12 * (t.between + t.within + t.raters);
    safe.within = std::max(safe.within, least);
    safe.residual = std::max(safe.residual, least);
    safe.between = std::max(safe.between, least);
    const double n = safe.n, k = safe.k;
    IntraclassCorrelations result;
    const double f1 = safe.between / safe.within, f3 = safe.between / safe.residual;
    const double low1 = f1 / f_quantile(one_sided, n - 1, n * (k - 1));
    const double high1 = f1 * f_quantile(one_sided, n * (k - 1), n - 1);
    const double low3 = f3 / f_quantile(one_sided, n - 1, (n - 1) * (k - 1));
    const double high3 = f3 * f_quantile(one_sided, (n - 1) * (k - 1), n - 1);
    result.one_1 = single(f1, low1, high1, k);
    result.one_k = mean_of_raters(f1, low1, high1);
    result.three_1 = single(f3, low3, high3, k);
    result.three_k = mean_of_raters(f3, low3, high3);
    result.two_1 = two_way(safe);
    const auto step_up = [k](double r) { return k * r / (1 + (k - 1) * r); };  // Spearman and Brown
    result.two_k = {step_up(result.two_1.value), step_up(result.two_1.low), step_up(result.two_1.high)};
    return result;
}

double cronbach_alpha(const std::vector<std::vector<double>>& scores) {
    const Table t = table_of(scores);
    // As ICC(3,k): the same quantity in other words.
    if (t.between <= 0)
        throw std::invalid_argument(QT_TRANSLATE_NOOP("errors", "all targets have the same sum"));
    return 1 - t.residual / t.between;
}

}  // namespace fulcrum
