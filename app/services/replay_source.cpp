// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/replay_source.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "app/live/frame_pass.h"
#include "app/live/frame_store.h"
#include "app/live/replay_moment.h"
#include "assessment/attempt/engine_state.h"
#include "assessment/attempt/replay_cursor.h"
#include "sim_core/haptics/loop.h"
#include "sim_core/instrument/instrument.h"

namespace fulcrum::app {
namespace {

constexpr std::uint32_t slice_ticks = 10;  // of the viewer's run between two looks at what is asked for
constexpr std::uint32_t nothing_viewed = 0xffffffff;
constexpr std::uint32_t settled_ticks = 11;  // by which the world follows the tick
constexpr std::uint32_t ahead_picture_ticks = 100;
constexpr double longest_without_picture = 0.05;  // s

using Clock = std::chrono::steady_clock;
using Player = ReplayPlayer;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

class Replay : public ui::ReplaySource {
  public:
    explicit Replay(ReplayRequest request) : request_(std::move(request)) {
        const Scene& scene = request_.start.loaded.scene;
        for (const InstrumentSpec& spec : scene.instruments)
            instruments_[static_cast<int>(spec.hand)] = make_instrument(spec, scene.tick_period());
        if (scene.camera) scope_ = make_scope(*scene.camera);
        ticks_ = database::ticks_of(request_.trace);
        shown_ticks_ = ticks_->reader();
        record_ = std::make_shared<const AttemptRecord>(
            AttemptRecord{{}, {}, request_.trace->steps, request_.trace->events, request_.devices, ticks_});
        wanted_s_ = begin_s();
        viewed_ = static_cast<std::uint32_t>(std::lround(wanted_s_ / period()));
        wanted_.store(viewed_);
        thread_ = std::thread([this] { run(); });
    }
    ~Replay() override {
        stop_.store(true);
        { const std::lock_guard<std::mutex> lock(mutex_); }
        asked_.notify_one();
        thread_.join();
        if (request_.tap != nullptr) request_.tap->ended.store(true);
    }
    Replay(const Replay&) = delete;
    Replay& operator=(const Replay&) = delete;

    const Scene& scene() const override { return request_.start.loaded.scene; }
    double duration_s() const override {
        return ticks_->size() == 0 ? 0.0 : ticks_->last_sample().tick * period();
    }
    void seek(double time_s) override {
        wanted_s_ = std::clamp(time_s, begin_s(), duration_s());
        moved_ = true;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            wanted_.store(static_cast<std::uint32_t>(std::lround(wanted_s_ / period())));
        }
        asked_.notify_one();
    }
    bool update() override {
        bool changed = moved_;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (made_ == 0 || (!moved_ && made_ == taken_)) return false;
            if (made_ != taken_) {
                shown_ = world_;
                world_tick_ = made_tick_;
                taken_ = made_;
                changed = true;
            }
        }
        moved_ = false;
        if (changed) compose();
        return changed;
    }
    const WorldSnapshot& snapshot() const override { return shown_; }
    double shown_s() const override { return shown_s_; }
    double ready() const override {
        if (finished_.load() || ticks_->size() == 0) return 1;
        const std::uint32_t first = ticks_->first_tick();
        const auto done = static_cast<double>(simulated_.load()) - first + 1;
        return std::clamp(done / static_cast<double>(ticks_->size()), 0.0, 1.0);
    }
    std::optional<double> differs_from_s() const override {
        const double at = differs_from_.load();
        return at < 0 ? std::nullopt : std::optional<double>(at);
    }
    std::shared_ptr<const ui::ReplayMoment> moment(double time_s) const override {
        const auto tick = static_cast<std::uint32_t>(std::lround(std::max(0.0, time_s) / period()));
        const std::uint32_t settled = settled_tick(*record_, std::min(tick, simulated_.load()));
        if (settled == 0 || settled < ticks_->first_tick() || differs_from_.load() >= 0) return nullptr;
        auto moment = std::make_shared<TraceMoment>();
        moment->loaded = request_.start.loaded;
        moment->seed = request_.start.seed;
        moment->attempt_id = request_.attempt_id;
        moment->record = record_;
        moment->start = request_.start.state;
        moment->tick = settled;
        try {
            moment->frame = frames_.state(settled);
        } catch (const std::exception&) {
            moment->frame.clear();  // a damaged file: practice is brought there from the beginning
        }
        for (const Event& event : record_->events) {
            if (event.tick <= settled && event.kind == EventKind::phase_begin) moment->goal = event.detail;
        }
        return moment;
    }

  private:
    double period() const { return request_.start.loaded.scene.tick_period(); }
    /// Of the record: the ticks of practice from a moment continue those of what it began with.
    double begin_s() const {
        return ticks_->size() == 0 ? 0.0 : (std::max(ticks_->first_tick(), 1U) - 1) * period();
    }

    void run() {
        try {
            if (!request_.start_is_readable)
                throw StateArchiveError(QT_TRANSLATE_NOOP(
                    "errors",
                    "the stored state was written by another version of the program, or for another scene"));
            viewer_.emplace(request_.start, *record_);
            publish(viewer_->engine.initial_snapshot(), viewer_->cursor.tick());
            simulated_.store(viewer_->cursor.tick());
            use_found_frames();
            use_kept_frames();
            while (!stop_.load()) {
                if (!finished_.load() && !ahead_) begin_pass();
                const bool viewed = view(), simulated = simulate(), kept = keep();
                if (!viewed && !simulated && !kept) wait();
            }
        } catch (const std::exception&) {
            // The tissue cannot be simulated here: only the recorded poses are shown.
            differs_from_.store(begin_s());
            if (made_ == 0) show_poses_only();
            finished_.store(true);
        }
    }

    /// The recorded poses before the tissue of the beginning, which needs no stored state.
    void show_poses_only() {
        try {
            AttemptEngine engine(request_.start.loaded.scene, request_.start.loaded.task,
                                 request_.start.seed);
            publish(engine.initial_snapshot(), 0);
        } catch (const std::exception&) {
            // There is no picture of this scene.
        }
    }

    void use_found_frames() {
        if (request_.follower != nullptr) {
            std::vector<PackedFrame> frames = request_.follower->take(request_.attempt_id);
            request_.follower.reset();
            if (!frames.empty()) request_.frames = std::move(frames);
        }
        if (!request_.frames.empty()) frames_.restore(std::move(request_.frames));
    }

    void use_kept_frames() {
        const std::shared_ptr<const FrameFile> file = FrameFile::open(request_.keeping);
        if (file == nullptr || ticks_->size() == 0 || file->last_tick() != ticks_->last_sample().tick) return;
        frames_.restore(file);
        found_ = true;
        simulated_.store(file->last_tick());
        finished_.store(true);
    }

    /// The frames found are not those of this record after all: they are made, as if there had been none.
    void forget_found_frames() {
        request_.keeping.forget();
        frames_.restore(nullptr);
        found_ = false;
        ahead_.reset();
        viewer_.emplace(request_.start, *record_);
        simulated_.store(viewer_->cursor.tick());
        viewed_ = nothing_viewed;
        shown_ahead_ = 0;
        finished_.store(false);
    }

    void begin_pass() {
        found_ = frames_.count() > 0;
        try {
            ahead_.emplace(request_.start, *record_, frames_);
        } catch (const StateArchiveError&) {
            if (!found_) throw;
            return forget_found_frames();
        }
        simulated_.store(ahead_->tick());
    }

    /// Makes the world that is asked for; false where that is shown already, or is not simulated yet.
    bool view() {
        const std::uint32_t wanted = wanted_.load();
        if (wanted == viewed_) return false;
        if (wanted > simulated_.load() && !finished_.load()) {
            // Until the simulation has come to what is asked for, its newest world is shown.
            if (simulated_.load() >= shown_ahead_ + ahead_picture_ticks) {
                shown_ahead_ = simulated_.load();
                publish(ahead_->world(), shown_ahead_);
            }
            return false;
        }
        if (!found_) {
            run_viewer(wanted);
        } else {
            try {
                run_viewer(wanted);
            } catch (const std::exception&) {
                forget_found_frames();
                return true;
            }
            if (!viewer_->cursor.outcome().identical) {
                forget_found_frames();
                return true;
            }
        }
        const bool there = viewer_->cursor.tick() >= wanted || viewer_->cursor.at_end();
        viewed_ = there ? wanted : viewer_->cursor.tick();
        shown_ahead_ = 0;
        publish(viewer_->engine.world().snapshot(), viewed_);
        return true;
    }

    /// Towards what is asked for, as far as there is time until a picture is due.
    void run_viewer(std::uint32_t wanted) {
        ReplayCursor& cursor = viewer_->cursor;
        const std::int64_t frame = frames_.before(wanted);
        if (cursor.tick() > wanted || cursor.tick() < frame) {
            frames_.put(wanted, cursor);
            if (cursor.tick() != frame)
                throw StateArchiveError(QT_TRANSLATE_NOOP(
                    "errors", "a kept key frame cannot be read, or does not match its checksum"));
        }
        const Clock::time_point begin = Clock::now();
        while (cursor.tick() < wanted && !cursor.at_end() && !stop_.load()) {
            cursor.run_to(std::min(wanted, cursor.tick() + slice_ticks));
            const bool changed = wanted_.load() < wanted;
            if (changed || seconds_since(begin) > longest_without_picture) break;
        }
    }

    /// A slice of the pass through the whole record; false at its end.
    bool simulate() {
        if (finished_.load()) return false;
        if (!ahead_) return true;  // begins with the next slice
        const bool more = ahead_->run_slice();
        if (!ahead_->identical() && found_) {
            forget_found_frames();
            return true;
        }
        if (!ahead_->identical() && differs_from_.load() < 0)
            differs_from_.store(ahead_->first_divergence_s());
        simulated_.store(ahead_->tick());
        if (more) return true;
        finished_.store(true);
        if (request_.keeping.wanted() && differs_from_.load() < 0 && ticks_->size() > 0)
            writer_.emplace(request_.keeping, frames_.frames(), ticks_->last_sample().tick);
        ahead_.reset();
        return true;
    }

    /// A piece of the file of key frames; false where there is none to write.
    bool keep() {
        if (!writer_) return false;
        if (!writer_->write_more()) writer_.reset();
        return true;
    }

    void wait() {
        std::unique_lock<std::mutex> lock(mutex_);
        asked_.wait(lock, [this] { return stop_.load() || wanted_.load() != viewed_; });
    }

    void publish(const WorldSnapshot& world, std::uint32_t tick) {
        const std::lock_guard<std::mutex> lock(mutex_);
        world_ = world;
        made_tick_ = tick;
        ++made_;
    }

    /// Recorded poses over the newest world.
    void compose() {
        const auto tick = static_cast<std::uint32_t>(std::lround(wanted_s_ / period()));
        const bool there =
            (world_tick_ <= tick && world_tick_ + settled_ticks >= tick) || differs_from_.load() >= 0;
        shown_s_ = there ? wanted_s_ : world_tick_ * period();
        if (ticks_->size() == 0) return;
        const std::size_t index = std::min(shown_ticks_->at_or_after(tick), ticks_->size() - 1);
        const TickSample& sample = shown_ticks_->sample(index);
        if (request_.tap != nullptr) request_.tap->newest.write({sample});
        const RigSample& input = shown_ticks_->input(index);
        for (int hand = 0; hand < hand_count; ++hand) {
            if (scene().instrument(static_cast<Hand>(hand)) == nullptr) continue;
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
        if (scene().camera) shown_.camera = scope_pose(scope_, input.camera);
        shown_.tick = sample.tick;
    }

    ReplayRequest request_;
    std::shared_ptr<const RecordTicks> ticks_;
    std::shared_ptr<const AttemptRecord> record_;  // with these
    InstrumentModel instruments_[hand_count];
    ScopeModel scope_;
    FrameStore frames_;

    std::atomic<std::uint32_t> wanted_{0}, simulated_{0};
    std::atomic<double> differs_from_{-1.0};
    std::atomic<bool> stop_{false}, finished_{false};
    // The thread's own.
    std::optional<Player> viewer_;
    std::optional<FramePass> ahead_;
    std::optional<FrameFileWriter> writer_;
    bool found_ = false;  // key frames are kept ones, or those of the attempt itself
    std::uint32_t viewed_ = 0, shown_ahead_ = 0;

    std::mutex mutex_;  // guards what follows, and what asked_ waits for
    std::condition_variable asked_;
    WorldSnapshot world_;
    std::uint32_t made_tick_ = 0;
    std::uint64_t made_ = 0;

    // The owner's.
    std::unique_ptr<TickReader> shown_ticks_;
    WorldSnapshot shown_;
    std::uint32_t world_tick_ = 0;
    std::uint64_t taken_ = 0;
    double wanted_s_ = 0, shown_s_ = 0;
    bool moved_ = true;
    std::thread thread_;
};

}  // namespace

std::unique_ptr<ui::ReplaySource> make_replay_source(ReplayRequest request) {
    return std::make_unique<Replay>(std::move(request));
}

}  // namespace fulcrum::app
