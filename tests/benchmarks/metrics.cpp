// SPDX-License-Identifier: Apache-2.0
// All metrics of a ten-minute record of two hands at 1 kHz (budget: 2 s), and reader and writer of the trace
// file.
#include <benchmark/benchmark.h>

#include <cmath>
#include <sstream>

#include "assessment/metrics/metric.h"
#include "assessment/trace/trace_csv.h"

namespace {

using namespace fulcrum;

/// Reaches of 1 s with rests, tremor, contact on every second one.
std::vector<TickSample> record_of(std::uint32_t ticks) {
    std::vector<TickSample> samples(ticks);
    for (std::uint32_t i = 0; i < ticks; ++i) {
        TickSample& sample = samples[i];
        sample.tick = i;
        const double t = i * 1e-3;
        for (int h = 0; h < hand_count; ++h) {
            HandSample& hand = sample.hand[h];
            const double phase = std::fmod(t + 0.7 * h, 3.0);
            const double s = phase < 0.5 ? 0 : phase > 2 ? 1 : (phase - 0.5) / 1.5;
            const double x = s * s * s * (10 - 15 * s + 6 * s * s) + 1e-3 * std::sin(55 * t);
            hand.tip[0] = static_cast<std::int32_t>(8e5 * x);
            hand.tip[1] = static_cast<std::int32_t>(2e5 * std::sin(0.7 * t));
            hand.tip[2] = static_cast<std::int32_t>(3e5 * std::cos(0.3 * t));
            hand.axis[0] = static_cast<std::int32_t>(1e8 * std::sin(0.2 * x));
            hand.axis[2] = static_cast<std::int32_t>(-1e8 * std::cos(0.2 * x));
            const bool contact = phase > 1;
            hand.force[0] = contact ? static_cast<std::int32_t>(2000 * std::sin(2 * t)) : 0;
            hand.force[2] = contact ? 900 : 0;
            hand.jaw_force = contact ? 3000 : 0;
            hand.jaw_area = contact ? 50000 : 0;
            hand.tissue = contact ? 0 : -1;
            hand.patch = contact ? static_cast<std::int16_t>(i / 3000) : std::int16_t{-1};
            hand.flags = hand_inside | hand_in_view;
        }
    }
    return samples;
}

MetricContext limits() {
    MetricContext context;
    context.tissues = {{"bowel", 1.5}};
    return context;
}

void metrics_of_a_record(benchmark::State& state) {
    const auto samples = record_of(static_cast<std::uint32_t>(state.range(0)) * 1000);
    for (auto _ : state) {
        const Trace trace = trace_from_samples(samples, {}, {"bowel"});
        benchmark::DoNotOptimize(compute_metrics(trace, {}, limits()).size());
    }
}
BENCHMARK(metrics_of_a_record)->Arg(60)->Arg(600)->Unit(benchmark::kMillisecond);

void write_a_minute(benchmark::State& state) {
    const Trace trace = trace_from_samples(record_of(60000), {}, {"bowel"});
    for (auto _ : state) {
        std::ostringstream out;
        write_trace_csv(trace, out);
        benchmark::DoNotOptimize(out.tellp());
    }
}
BENCHMARK(write_a_minute)->Unit(benchmark::kMillisecond);

void read_a_minute(benchmark::State& state) {
    std::ostringstream out;
    write_trace_csv(trace_from_samples(record_of(60000), {}, {"bowel"}), out);
    const std::string text = out.str();
    for (auto _ : state) {
        std::istringstream in(text);
        benchmark::DoNotOptimize(read_trace_csv(in, "minute.csv").t.size());
    }
}
BENCHMARK(read_a_minute)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
