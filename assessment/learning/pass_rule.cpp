// SPDX-License-Identifier: Apache-2.0
#include "assessment/learning/pass_rule.h"

#include <cmath>
#include <cstdlib>
#include <vector>

#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr int most = 60;

[[noreturn]] void refuse(const std::string& text, const std::string& wrong) {
    throw InputError("pass rule '" + text + "'", "", wrong,
                     "write row:K, of:K,N or lc-cusum:P0,P1,H, such as lc-cusum:0.1,0.3,2.5");
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
            refuse(text, "'" + part + "' is not a number");
        numbers.push_back(value);
        at = end + 1;
    }
    if (numbers.size() != count)
        refuse(text, "has " + std::to_string(numbers.size()) + " numbers where " + std::to_string(count) +
                         " are needed");
    return numbers;
}

int whole(const std::string& text, double value) {
    if (value != std::floor(value) || value < 1 || value > most)
        refuse(text, "K and N must be whole numbers from 1 to " + std::to_string(most));
    return static_cast<int>(value);
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
        if (rule.k > rule.n) refuse(text, "K is larger than N");
    } else if (text.rfind("lc-cusum:", 0) == 0) {
        rule.kind = PassRuleKind::lc_cusum;
        const std::vector<double> numbers = numbers_of(text, 9, 3);
        rule.p0 = numbers[0];
        rule.p1 = numbers[1];
        rule.h = numbers[2];
        if (!(rule.p0 > 0 && rule.p0 < rule.p1 && rule.p1 < 1)) refuse(text, "needs 0 < P0 < P1 < 1");
        if (rule.h <= 0 || rule.h > 100) refuse(text, "H must be above 0 and at most 100");
    } else {
        refuse(text, "is not a rule");
    }
    return rule;
}

double lc_cusum_step(const PassRule& rule, bool passed) {
    return passed ? std::log((1 - rule.p0) / (1 - rule.p1)) : std::log(rule.p0 / rule.p1);
}

}  // namespace fulcrum
