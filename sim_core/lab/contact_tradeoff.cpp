// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/contact_tradeoff.h"

#include "sim_core/lab/contact_run.h"

namespace fulcrum::lab {
namespace {

struct Resolution {
    int sections, around;
};

// Force (N) over 2 s of sliding: mean absolute difference to the run with a new model at every tick.
double force_error(std::uint32_t age) {
    const auto aged = build_contact_run(), fresh = build_contact_run();
    double sum = 0;
    int counted = 0;
    for (int i = 0; i < 2000; ++i) {
        fresh->prepare_tick(0, 1);
        fresh->touch();
        aged->prepare_tick(0, age);
        aged->touch();
        if (i < 100) continue;
        sum += (aged->result.force - fresh->result.force).norm();
        ++counted;
    }
    return sum / counted;
}

}  // namespace

TradeoffStudy tool_contact_tradeoff() {
    TradeoffStudy study;
    study.model = "tool_contact";
    study.reference = "brute force over all triangles";
    for (const bool query : {false, true}) {
        for (const Resolution& size : {Resolution{150, 17}, Resolution{299, 33}, Resolution{450, 50}}) {
            const auto run = build_contact_run(size.sections, size.around);
            run->model.search_always = query;
            TradeoffLevel level;
            level.family = query ? "query" : "dynamic_point";
            level.level =
                level.family + ", " + std::to_string(2 * size.sections * size.around) + " triangles";
            level.error = worst_contact_distance(*run);
            level.error_unit = "m, largest of 20 poses";
            level.time_us = median_time_us(
                50, 1000, [&] { run->touch(); }, [&] { run->prepare_tick(0); });
            study.levels.push_back(level);
        }
    }
    mark_pareto(study);
    return study;
}

TradeoffStudy model_age_tradeoff() {
    TradeoffStudy study;
    study.model = "haptic_model_age";
    study.reference = "fully synchronous step: a new model at every tick";
    for (const std::uint32_t age : {1U, 2U, 5U, 10U, 20U, 40U}) {
        TradeoffLevel level;
        level.family = "age";
        level.level = "new model every " + std::to_string(age) + (age == 1 ? " tick" : " ticks");
        level.error = force_error(age);
        level.error_unit = "N, mean over 2 s of sliding";
        const auto run = build_contact_run();
        const double tick = median_time_us(
            50, 1000, [&] { run->touch(); }, [&] { run->prepare_tick(0, age); });
        const double build = median_time_us(
            10, 200, [&] { run->publish(); }, [&] { run->prepare_tick(0, age); });
        level.time_us = tick + build / age;
        study.levels.push_back(level);
    }
    mark_pareto(study);
    return study;
}

}  // namespace fulcrum::lab
