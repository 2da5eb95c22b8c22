// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/replay_source.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <thread>

#include "sim_core/haptics/loop.h"
#include "sim_core/instrument/instrument.h"

namespace fulcrum::app {
namespace {

constexpr std::uint32_t picture_ticks = 100;

class Replay : public ui::ReplaySource {
  public:
    Replay(LoadedTask loaded, std::uint64_t seed, const ForceDevices& devices,
           std::shared_ptr<const database::Trace> trace)
        : loaded_(std::move(loaded)), trace_(std::move(trace)), seed_(seed), devices_(devices) {
        for (const InstrumentSpec& spec : loaded_.scene.instruments) {
            instruments_[static_cast<int>(spec.hand)] = make_instrument(spec, loaded_.scene.tick_period());
        }
        if (loaded_.scene.camera) scope_ = make_scope(*loaded_.scene.camera);
        steps_total_ = std::max<std::size_t>(1, trace_->steps.size());
        thread_ = std::thread([this] { run(); });
    }
    ~Replay() override {
        stop_.store(true);
        thread_.join();
    }
    Replay(const Replay&) = delete;
    Replay& operator=(const Replay&) = delete;

    const Scene& scene() const override { return loaded_.scene; }
    double duration_s() const override {
        return trace_->samples.empty() ? 0.0 : trace_->samples.back().tick * loaded_.scene.tick_period();
    }
    void seek(double time_s) override {
        wanted_s_ = std::clamp(time_s, 0.0, duration_s());
        moved_ = true;
    }
    bool update() override {
        const std::uint64_t pictures = pictures_made_.load();
        if (pictures == 0 || (!moved_ && pictures == pictures_seen_)) return false;
        const bool was_short = short_of_;
        pictures_seen_ = pictures;
        if (!moved_ && !was_short) return false;
        moved_ = false;
        compose();
        return true;
    }
    const WorldSnapshot& snapshot() const override { return shown_; }
    double shown_s() const override { return shown_s_; }
    double ready() const override {
        return static_cast<double>(steps_done_.load()) / static_cast<double>(steps_total_);
    }
    std::optional<double> differs_from_s() const override {
        const double at = differs_from_.load();
        return at < 0 ? std::nullopt : std::optional<double>(at);
    }

  private:
    void run() {
        try {
            AttemptEngine engine(loaded_.scene, loaded_.task, seed_);
            keep(engine.initial_snapshot());
            const AttemptRecord record{trace_->inputs, trace_->samples, trace_->steps, trace_->events,
                                       devices_};
            std::uint32_t next = picture_ticks;
            const ReplayOutcome outcome =
                replay_record(engine, record, false, [&](const WorldSnapshot& snapshot) {
                    steps_done_.fetch_add(1);
                    if (snapshot.tick >= next) {
                        keep(snapshot);
                        next = snapshot.tick + picture_ticks;
                    }
                    return !stop_.load();
                });
            if (!outcome.identical) differs_from_.store(outcome.first_divergence_s);
            steps_done_.store(steps_total_);
        } catch (const std::exception&) {
            differs_from_.store(
                0.0);  // the tissue cannot be simulated here: only the recorded poses are shown
            steps_done_.store(steps_total_);
        }
    }
    void keep(const WorldSnapshot& snapshot) {
        const std::lock_guard<std::mutex> lock(mutex_);
        pictures_.push_back(snapshot);
        pictures_made_.store(pictures_.size());
    }
    void compose() {
        const double period = loaded_.scene.tick_period();
        const auto tick = static_cast<std::uint32_t>(std::lround(wanted_s_ / period));
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            const auto after =
                std::upper_bound(pictures_.begin(), pictures_.end(), tick,
                                 [](std::uint32_t t, const WorldSnapshot& s) { return t < s.tick; });
            const WorldSnapshot& before = after == pictures_.begin() ? pictures_.front() : *(after - 1);
            shown_ = before;
            short_of_ = after == pictures_.end() && before.tick + picture_ticks < tick;
            if (after != pictures_.end() && after->tick > before.tick)
                blend(*after,
                      std::clamp((static_cast<double>(tick) - before.tick) / (after->tick - before.tick), 0.0,
                                 1.0));
        }
        shown_s_ = wanted_s_;
        if (trace_->samples.empty() || trace_->inputs.size() != trace_->samples.size()) return;
        const auto found = std::lower_bound(trace_->samples.begin(), trace_->samples.end(), tick,
                                            [](const TickSample& s, std::uint32_t t) { return s.tick < t; });
        const auto index = std::min<std::size_t>(static_cast<std::size_t>(found - trace_->samples.begin()),
                                                 trace_->samples.size() - 1);
        const TickSample& sample = trace_->samples[index];
        const RigSample& input = trace_->inputs[index];
        for (int hand = 0; hand < hand_count; ++hand) {
            if (loaded_.scene.instrument(static_cast<Hand>(hand)) == nullptr) continue;
            ToolPose pose = tool_pose(instruments_[hand], input.hand[hand]).pose();
            const HandSample& recorded = sample.hand[hand];
            for (int i = 0; i < 3; ++i) {
                pose.tip[i] = recorded.tip[i] * sample_length_unit;
                pose.axis[i] = recorded.axis[i] * sample_axis_unit;
            }
            pose.jaw_angle = recorded.jaw_angle * sample_angle_unit;
            pose.jaw_force = recorded.jaw_force * sample_force_unit;
            shown_.tools[hand] = pose;
        }
        if (loaded_.scene.camera) shown_.camera = scope_pose(scope_, input.camera);
        shown_.tick = sample.tick;
    }
    void blend(const WorldSnapshot& next, double u) {
        for (int hand = 0; hand < hand_count; ++hand)
            shown_.lift[hand] += u * (next.lift[hand] - shown_.lift[hand]);
        for (std::size_t i = 0; i < shown_.nodes.size(); ++i)
            shown_.nodes[i] += u * (next.nodes[i] - shown_.nodes[i]);
        for (std::size_t i = 0; i < shown_.rings.size(); ++i) {
            shown_.rings[i].position += u * (next.rings[i].position - shown_.rings[i].position);
            // Lumen pressure scales the first two directors.
            const double before = shown_.rings[i].rotation.col(0).norm(),
                         after = next.rings[i].rotation.col(0).norm();
            const auto turned = [](Matrix3 directors, double scale) {
                directors.leftCols<2>() /= scale;
                return Quaternion(directors);
            };
            const Quaternion from = turned(shown_.rings[i].rotation, before),
                             to = turned(next.rings[i].rotation, after);
            shown_.rings[i].rotation = from.slerp(u, to).toRotationMatrix();
            shown_.rings[i].rotation.leftCols<2>() *= before + u * (after - before);
        }
    }

    LoadedTask loaded_;
    std::shared_ptr<const database::Trace> trace_;
    std::uint64_t seed_;
    ForceDevices devices_;
    InstrumentModel instruments_[hand_count];
    ScopeModel scope_;
    std::mutex mutex_;
    std::vector<WorldSnapshot> pictures_;
    std::atomic<std::uint64_t> pictures_made_{0};
    std::atomic<std::size_t> steps_done_{0};
    std::size_t steps_total_ = 1;
    std::atomic<double> differs_from_{-1.0};
    std::atomic<bool> stop_{false};
    WorldSnapshot shown_;
    double wanted_s_ = 0, shown_s_ = 0;
    bool moved_ = true, short_of_ = false;
    std::uint64_t pictures_seen_ = 0;
    std::thread thread_;
};

}  // namespace

std::unique_ptr<ui::ReplaySource> make_replay_source(LoadedTask loaded, std::uint64_t seed,
                                                     const ForceDevices& devices,
                                                     std::shared_ptr<const database::Trace> trace) {
    return std::make_unique<Replay>(std::move(loaded), seed, devices, std::move(trace));
}

}  // namespace fulcrum::app
