// SPDX-License-Identifier: GPL-3.0-or-later
// Cost of recording: two hands and a camera at 1 kHz, every channel, through codec and store. Budget
// (docs/QUALITY.md): under 1 % of a core and under 10 MiB for 10 minutes. The hands make realistic reaches,
// with 8 to 12 Hz tremor of 30 um RMS on every axis.
#include <benchmark/benchmark.h>

#include <QCoreApplication>
#include <QTemporaryDir>
#include <cmath>
#include <vector>

#include "database/records/attempts.h"
#include "database/records/people.h"
#include "database/records/recorder.h"

namespace fulcrum::database {
namespace {

struct Recording {
    std::vector<TickSample> samples;
    std::vector<RigSample> inputs;
};

std::int32_t counts(double value, double unit) {
    return static_cast<std::int32_t>(std::lround(value / unit));
}

Recording hands(std::uint32_t ticks) {
    Recording recording;
    double tremor[3][3] = {}, phase[3][3] = {};
    for (std::uint32_t tick = 0; tick < ticks; ++tick) {
        const double t = tick * 1e-3;
        RigSample input;
        TickSample sample;
        input.tick = sample.tick = tick;
        sample.model_step = tick / 5;
        DeviceSample* devices[3] = {&input.hand[0], &input.hand[1], &input.camera};
        for (int d = 0; d < 3; ++d) {
            const double reach = std::fmod(t * (0.8 + 0.1 * d), 2.0);
            const double s = std::min(1.0, reach), blend = s * s * s * (10 + s * (-15 + 6 * s));
            Vector3 handle;
            for (int axis = 0; axis < 3; ++axis) {
                // Its frequency varies between 8 and 12 Hz, as in real hands.
                phase[d][axis] += 2e-3 * 3.14159265 * (10.0 + 2.0 * std::sin(0.7 * t + axis + d));
                tremor[d][axis] = 3e-5 * 1.41421356 * std::sin(phase[d][axis]);
                handle[axis] = (axis == 2 ? -0.2 : 0.0) +
                               0.04 * blend * std::sin(axis + 0.3 * d + std::floor(t / 2)) + tremor[d][axis];
                devices[d]->handle[axis] = counts(handle[axis], device_length_unit);
            }
            devices[d]->roll = counts(0.2 * blend, device_angle_unit);
            devices[d]->jaw = counts(0.5 * blend, device_angle_unit);
            devices[d]->grip = counts(2.0 * blend, device_force_unit);
            for (int axis = 0; axis < 3; ++axis) handle[axis] = devices[d]->handle[axis] * device_length_unit;
            const Vector3 shaft = -handle.normalized();
            const Vector3 tip = shaft * (0.36 - handle.norm());
            if (d == 2) {
                for (int axis = 0; axis < 3; ++axis)
                    sample.camera.tip[axis] = counts(tip[axis], sample_length_unit);
                const Quaternion q = Quaternion::FromTwoVectors(Vector3(0, 0, -1), shaft);
                const double parts[4] = {q.w(), q.x(), q.y(), q.z()};
                for (int part = 0; part < 4; ++part)
                    sample.camera.orientation[part] = counts(parts[part], sample_axis_unit);
                continue;
            }
            HandSample& hand = sample.hand[d];
            const double depth = std::max(0.0, blend - 0.6);
            Vector3 pressed = Vector3::Zero();
            for (int axis = 0; axis < 3; ++axis) {
                hand.tip[axis] = counts(tip[axis], sample_length_unit);
                hand.axis[axis] = counts(shaft[axis], sample_axis_unit);
                // 500 N/m of contact: 30 um of tremor is 15 mN.
                const double force =
                    depth > 0 ? 3.0 * depth * std::sin(axis + 1.0) + 500.0 * tremor[d][axis] : 0.0;
                pressed[axis] = force;
                hand.force[axis] = counts(force, sample_force_unit);
                hand.device_force[axis] = counts(-force, sample_force_unit);
            }
            const Vector3 torque = tip.cross(pressed);  // about the trocar, which lies at the origin
            for (int axis = 0; axis < 3; ++axis) hand.torque[axis] = counts(torque[axis], sample_torque_unit);
            hand.roll = devices[d]->roll;
            hand.jaw_angle = devices[d]->jaw;
            hand.jaw_force = depth > 0.2 ? devices[d]->grip : 0;
            hand.jaw_area = hand.jaw_force > 0 ? 30000 + counts(1e-6 * depth, sample_area_unit) : 0;
            hand.tissue = depth > 0 ? 1 : -1;
            hand.patch = depth > 0 ? static_cast<std::int16_t>(t * 3) : std::int16_t{-1};
            hand.flags = static_cast<std::uint16_t>(hand_inside | hand_in_view |
                                                    (hand.jaw_force > 0 ? hand_grasping : 0));
        }
        recording.samples.push_back(sample);
        recording.inputs.push_back(input);
    }
    return recording;
}

constexpr double ten_minutes_s = 600, mebibyte = 1048576;

void report(benchmark::State& state, double bytes, double recorded_s) {
    state.counters["MiB_per_10_min"] = bytes / mebibyte * ten_minutes_s / recorded_s;
    state.counters["recorded_s"] =
        benchmark::Counter(recorded_s * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

/// Ten seconds of hand motion, in blocks of one second, with the base of each block's first tick.
template <typename Encode>
void encode(benchmark::State& state, Encode&& second_from) {
    const Recording recording = hands(10000);
    double bytes = 0;
    for (auto _ : state) {
        bytes = 0;
        for (std::size_t begin = 0; begin < 10000; begin += 1000)
            bytes += static_cast<double>(second_from(recording, begin).data.size());
    }
    report(state, bytes, 10);
}

void encode_samples(benchmark::State& state) {
    TraceCodec codec;
    encode(state, [&](const Recording& recording, std::size_t begin) {
        return codec.encode(&recording.samples[begin], 1000, &recording.inputs[begin]);
    });
}
BENCHMARK(encode_samples)->Unit(benchmark::kMillisecond);

void encode_inputs(benchmark::State& state) {
    TraceCodec codec;
    encode(state, [&](const Recording& recording, std::size_t begin) {
        return codec.encode(&recording.inputs[begin], 1000);
    });
}
BENCHMARK(encode_inputs)->Unit(benchmark::kMillisecond);

void decode_samples(benchmark::State& state) {
    const Recording recording = hands(1000);
    TraceCodec codec;
    const TraceChunk chunk = codec.encode(recording.samples.data(), 1000, recording.inputs.data());
    for (auto _ : state) {
        std::vector<TickSample> back;
        codec.decode(chunk, back, &recording.inputs);
        benchmark::DoNotOptimize(back.data());
    }
    report(state, static_cast<double>(chunk.data.size()), 1);
}
BENCHMARK(decode_samples)->Unit(benchmark::kMillisecond);

/// The complete path: codec, transactions of one second each, the disk.
void record_attempt(benchmark::State& state) {
    const std::uint32_t seconds = 60;
    const Recording recording = hands(seconds * 1000);
    const QTemporaryDir folder;
    const std::string path = folder.filePath("bench.db").toStdString();
    const Store store = Store::create(path);
    const Person person = People(store).ensure_synthetic(store.station_session(), "bench", "Bench");
    double bytes = 0;
    for (auto _ : state) {
        AttemptMeta meta;
        meta.person_id = person.id;
        meta.task_id = "B1";
        meta.device_class = DeviceClass::synthetic;
        Recorder recorder(path, store.station_session(), meta);
        for (std::uint32_t tick = 0; tick < seconds * 1000; ++tick) {
            recorder.append(recording.inputs[tick]);
            recorder.append(recording.samples[tick]);
            if (tick % 5 == 4)
                recorder.append(StepRecord{tick / 5, tick - 4, tick, 0,
                                           tick % 100 == 99 ? tick * 0x9e3779b97f4a7c15ULL : 0});
        }
        AttemptResult result;
        result.state = AttemptState::completed;
        recorder.finish(result);
        bytes = static_cast<double>(recorder.bytes_written());
    }
    report(state, bytes, seconds);
}
BENCHMARK(record_attempt)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->Iterations(3);

}  // namespace
}  // namespace fulcrum::database

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
