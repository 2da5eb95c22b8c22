// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/rule_run.h"

#include <set>

namespace fulcrum {
namespace {

bool on_two_days(const std::vector<Outcome>& outcomes, std::size_t from) {
    std::set<std::int64_t> days;
    for (std::size_t i = from; i < outcomes.size(); ++i)
        if (outcomes[i].passed) days.insert(outcomes[i].day);
    return days.size() >= 2;
}

int variants_passed(const std::vector<Outcome>& outcomes, std::size_t from) {
    std::set<std::string> variants;
    for (std::size_t i = from; i < outcomes.size(); ++i)
        if (outcomes[i].passed) variants.insert(outcomes[i].variant);
    return static_cast<int>(variants.size());
}

}  // namespace

RuleState judge(const CurriculumTask& task, const std::vector<Outcome>& outcomes) {
    const PassRule& rule = task.rule;
    RuleState state;
    std::size_t from = outcomes.size();
    double have = 0, need = 1, one_pass = 1;
    if (rule.kind == PassRuleKind::lc_cusum) {
        // Held at the limit until there are passes on two days and on enough variants.
        double sum = 0;
        from = 0;
        for (std::size_t i = 0; i < outcomes.size(); ++i) {
            sum = std::max(0.0, std::min(rule.h, sum) + lc_cusum_step(rule, outcomes[i].passed));
            if (sum <= 0) from = i + 1;
        }
        have = sum;
        need = rule.h;
        one_pass = lc_cusum_step(rule, true);
    } else {
        const std::size_t window = std::min<std::size_t>(outcomes.size(), static_cast<std::size_t>(rule.n));
        from = outcomes.size() - window;
        if (rule.kind == PassRuleKind::in_a_row)
            while (from < outcomes.size() &&
                   std::any_of(outcomes.begin() + static_cast<std::ptrdiff_t>(from), outcomes.end(),
                               [](const Outcome& one) { return !one.passed; }))
                ++from;
        for (std::size_t i = from; i < outcomes.size(); ++i) have += outcomes[i].passed ? 1 : 0;
        need = rule.k;
    }
    const bool enough = have >= need - 1e-12;
    const bool two_days = on_two_days(outcomes, from);
    const int more_variants = std::max(0, task.variants - variants_passed(outcomes, from));
    state.met = enough && two_days && more_variants == 0;
    state.one_more_day = enough && !two_days;
    state.more_variants = enough ? more_variants : 0;
    state.progress = std::clamp(have / need, 0.0, 1.0);
    state.of_one_pass = one_pass / need;
    return state;
}

}  // namespace fulcrum
