// SPDX-License-Identifier: Apache-2.0
#include "assessment/learning/pass_rule.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <locale>
#include <map>
#include <sstream>
#include <utility>
#include <vector>

#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr int most = 60;
// The last N attempts are kept as bits: 2^15 states at most.
constexpr int most_of = 16;

[[noreturn]] void refuse(const std::string& text, const Sentence& wrong) {
    throw InputError(
        Sentence(QT_TRANSLATE_NOOP("errors", "pass rule '%1'"), text), "", wrong,
        QT_TRANSLATE_NOOP("errors", "write row:K, of:K,N or lc-cusum:P0,P1,H, such as lc-cusum:0.1,0.3,2.5"));
}

/// The numbers behind the colon, exactly `count`.
std::vector<double> numbers_of(const std::string& text, std::size_t from, std::size_t count) {
    std::vector<double> numbers;
    std::size_t at = from;
    while (at <= text.size()) {
        const std::size_t end = std::min(text.find(',', at), text.size());
        const std::string part = text.substr(at, end - at);
        char* rest = nullptr;
        const double value = std::strtod(part.c_str(), &rest);
        if (part.empty() || *rest != '\0' || !std::isfinite(value))
            refuse(text, {QT_TRANSLATE_NOOP("errors", "'%1' is not a number"), part});
        numbers.push_back(value);
        at = end + 1;
    }
    if (numbers.size() != count)
        refuse(text,
               {QT_TRANSLATE_NOOP("errors", "has %1 numbers where %2 are needed"), numbers.size(), count});
    return numbers;
}

int whole(const std::string& text, double value) {
    if (value != std::floor(value) || value < 1 || value > most)
        refuse(text, {QT_TRANSLATE_NOOP("errors", "K and N must be whole numbers from 1 to %1"), most});
    return static_cast<int>(value);
}

/// In a row: passes since the last failure. K of N: 0 and the outcomes of the last N - 1 attempts as bits.
/// LC-CUSUM: failures and passes since the sum was last 0.
using State = std::pair<int, int>;

/// The state after one more attempt; none: the rule is met.
std::optional<State> step(const PassRule& rule, const State& state, bool passed) {
    switch (rule.kind) {
        case PassRuleKind::in_a_row: {
            const int run = passed ? state.first + 1 : 0;
            return run >= rule.k ? std::nullopt : std::optional<State>({run, 0});
        }
        case PassRuleKind::k_of_n: {
            const unsigned bits = (static_cast<unsigned>(state.second) << 1U) | (passed ? 1U : 0U);
            int passes = 0;
            for (int i = 0; i < rule.n; ++i)
                passes += static_cast<int>((bits >> static_cast<unsigned>(i)) & 1U);
            if (passes >= rule.k) return std::nullopt;
            const unsigned kept = bits & ((1U << static_cast<unsigned>(rule.n - 1)) - 1U);
            return State{0, static_cast<int>(kept)};
        }
        case PassRuleKind::lc_cusum: {
            const State next{state.first + (passed ? 0 : 1), state.second + (passed ? 1 : 0)};
            const double sum =
                next.first * lc_cusum_step(rule, false) + next.second * lc_cusum_step(rule, true);
            if (sum >= rule.h) return std::nullopt;
            return sum <= 0 ? State{0, 0} : next;
        }
    }
    return std::nullopt;
}

}  // namespace

PassRule parse_pass_rule(const std::string& text) {
    PassRule rule;
    if (text.rfind("row:", 0) == 0) {
        rule.kind = PassRuleKind::in_a_row;
        rule.k = rule.n = whole(text, numbers_of(text, 4, 1)[0]);
    } else if (text.rfind("of:", 0) == 0) {
        rule.kind = PassRuleKind::k_of_n;
        const std::vector<double> numbers = numbers_of(text, 3, 2);
        rule.k = whole(text, numbers[0]);
        rule.n = whole(text, numbers[1]);
        if (rule.n > most_of) refuse(text, {QT_TRANSLATE_NOOP("errors", "N must be at most %1"), most_of});
        if (rule.k > rule.n) refuse(text, QT_TRANSLATE_NOOP("errors", "K is larger than N"));
    } else if (text.rfind("lc-cusum:", 0) == 0) {
        rule.kind = PassRuleKind::lc_cusum;
        const std::vector<double> numbers = numbers_of(text, 9, 3);
        rule.p0 = numbers[0];
        rule.p1 = numbers[1];
        rule.h = numbers[2];
        if (!(rule.p0 > 0 && rule.p0 < rule.p1 && rule.p1 < 1))
            refuse(text, QT_TRANSLATE_NOOP("errors", "needs 0 < P0 < P1 < 1"));
        if (rule.h <= 0 || rule.h > 100)
            refuse(text, QT_TRANSLATE_NOOP("errors", "H must be above 0 and at most 100"));
    } else {
        refuse(text, QT_TRANSLATE_NOOP("errors", "is not a rule"));
    }
    return rule;
}

std::string pass_rule_text(const PassRule& rule) {
    std::ostringstream text;
    text.imbue(std::locale::classic());
    switch (rule.kind) {
        case PassRuleKind::in_a_row:
            text << "row:" << rule.k;
            break;
        case PassRuleKind::k_of_n:
            text << "of:" << rule.k << ',' << rule.n;
            break;
        case PassRuleKind::lc_cusum:
            text << "lc-cusum:" << rule.p0 << ',' << rule.p1 << ',' << rule.h;
            break;
    }
    return text.str();
}

int least_window(int variants) {
    return std::max(2, variants);
}

bool can_be_met(const PassRule& rule, int variants) {
    return rule.kind == PassRuleKind::lc_cusum || rule.n >= least_window(variants);
}

std::optional<PassRuleProblem> why_never_met(const PassRule& rule, int variants) {
    if (can_be_met(rule, variants)) return std::nullopt;
    const Sentence problem =
        rule.n == 1
            ? Sentence(QT_TRANSLATE_NOOP(
                  "errors",
                  "nobody can meet the rule: it counts one attempt, and asks for passes on two days"))
            : Sentence(
                  QT_TRANSLATE_NOOP(
                      "errors",
                      "nobody can meet the rule: it counts %1 attempts, and asks for passes on %2 variants"),
                  rule.n, variants);
    return PassRuleProblem{problem,
                           {QT_TRANSLATE_NOOP("errors", "let it count at least %1 attempts, or use LC-CUSUM"),
                            least_window(variants)}};
}

std::vector<double> operating_curve(const PassRule& rule, double q, int attempts) {
    std::map<State, double> now{{{0, 0}, 1.0}};
    std::vector<double> curve;
    double met = 0;
    for (int t = 1; t <= attempts; ++t) {
        std::map<State, double> next;
        double met_now = 0;
        for (const auto& [state, chance] : now) {
            for (const bool passed : {true, false}) {
                const double share = chance * (passed ? q : 1 - q);
                if (share <= 0) continue;
                const std::optional<State> after = step(rule, state, passed);
                if (after) {
                    next[*after] += share;
                } else {
                    met_now += share;
                }
            }
        }
        met += met_now;
        curve.push_back(met);
        now = std::move(next);
    }
    return curve;
}

OperatingPoint operating_point(const PassRule& rule, double q, int attempts) {
    OperatingPoint point;
    double moment = 0;
    int t = 0;
    for (const double declared : operating_curve(rule, q, attempts)) {
        ++t;
        moment += t * (declared - point.declared);
        point.declared = declared;
        if (!point.median_attempts && declared >= 0.5) point.median_attempts = t;
    }
    if (point.declared > 0) point.mean_attempts_if_declared = moment / point.declared;
    return point;
}

double lc_cusum_step(const PassRule& rule, bool passed) {
    return passed ? std::log((1 - rule.p0) / (1 - rule.p1)) : std::log(rule.p0 / rule.p1);
}

}  // namespace fulcrum
