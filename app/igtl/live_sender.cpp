// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/igtl/live_sender.h"

#include <algorithm>
#include <chrono>

#include "assessment/trace/events_csv.h"
#include "sim_core/devices/device_page.h"
#include "sim_core/instrument/device.h"

namespace fulcrum::app {
namespace {

constexpr std::int64_t ms_ns = 1'000'000, frame_ns = 1000 * ms_ns / 60;
constexpr std::uint32_t stopped_flags = rig_paused | rig_device_lost;

}  // namespace

std::int64_t wall_clock_ns() {
    const auto now = std::chrono::system_clock::now().time_since_epoch();
    return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

/// The sender's thread: which attempt it sends and how far it is.
class LiveSender::Pass {
  public:
    explicit Pass(igtl::Server& server) : server_(server) {}

    void follow(const std::shared_ptr<const Attempt>& newest) {
        if (newest == attempt_) return;
        end(true);
        attempt_ = newest;
        begun_ = paused_ = false;
        tick_ = 0;
        waiting_.clear();
        begin_event_.reset();
    }
    void send_newest() {
        if (attempt_ == nullptr || ended_with(attempt_)) return;
        const bool over =
            attempt_->tap->ended.load(std::memory_order_acquire);  // then what is there is the last
        for (const Event& event : attempt_->tap->events.take()) waiting_.push_back(event);
        TappedSample newest;
        if (attempt_->tap->newest.read(newest) && newest.sample.tick != tick_) send(newest.sample);
        if (begun_) send_events();
        if (over) end(attempt_->tap->part.load());
    }
    /// `part`: the attempt is still under way, or events of it are missing.
    void end(bool part) {
        if (attempt_ == nullptr || !begun_) return;
        if (!part && begin_event_) {
            put_seed(*begin_event_, attempt_->seed);
            send(*begin_event_);
        }
        server_.send(state_message(WireState::end, time_of(tick_), part));
        server_.greet_with({});
        begun_ = false;
        over_ = attempt_;
    }

  private:
    bool ended_with(const std::shared_ptr<const Attempt>& attempt) const { return over_ == attempt; }
    /// Times of an attempt are those of its ticks, from where the clock stood at its first sample.
    std::int64_t time_of(std::uint32_t tick) const {
        return start_ + static_cast<std::int64_t>(tick * attempt_->tick_period * 1e9 + 0.5);
    }
    void send(const TickSample& sample) {
        if (!begun_) {
            start_ = wall_clock_ns();
            start_ -= time_of(sample.tick) - start_;
            server_.send(begin_of(attempt_->scene, start_, false));
            server_.greet_with(begin_of(attempt_->scene, start_, true));
            begun_ = true;
        }
        const bool stopped = (sample.rig_flags & stopped_flags) != 0;
        if (stopped != paused_)
            server_.send(state_message(stopped ? WireState::pause : WireState::resume, time_of(sample.tick)));
        paused_ = stopped;
        tick_ = sample.tick;
        if (!stopped && server_.clients() > 0)
            server_.send(messages_of(frame_of(sample), attempt_->scene, time_of(sample.tick)),
                         monotonic_ns() / ms_ns);
    }
    void send(const Event& event) {
        server_.send(event_message(event, attempt_->scene, attempt_->tick_period, time_of(event.tick)));
    }
    void send_events() {
        for (const Event& event : waiting_) {
            if (event.kind == EventKind::attempt_begin)
                begin_event_ = event;
            else if (server_.clients() > 0)
                send(event);
        }
        waiting_.clear();
    }

    igtl::Server& server_;
    std::shared_ptr<const Attempt> attempt_, over_;
    bool begun_ = false, paused_ = false;
    std::uint32_t tick_ = 0;
    std::int64_t start_ = 0;
    std::vector<Event> waiting_;        // for the first sample, which says when the attempt began
    std::optional<Event> begin_event_;  // for the end
};

LiveSender::LiveSender(const igtl::Address& address) : server_(address), port_(server_.port()) {
    thread_ = std::thread([this] { run(); });
}

LiveSender::~LiveSender() {
    stop_.store(true);
    thread_.join();
}

std::shared_ptr<SampleTap> LiveSender::begin(const Scene& scene, std::uint64_t seed) {
    auto attempt = std::make_shared<Attempt>();
    attempt->tap = std::make_shared<SampleTap>();
    attempt->scene = wire_scene(scene);
    attempt->seed = seed;
    attempt->tick_period = scene.tick_period();
    const std::lock_guard<std::mutex> lock(mutex_);
    next_ = attempt;
    return attempt->tap;
}

void LiveSender::run() {
    Pass pass(server_);
    std::int64_t due = monotonic_ns();
    while (!stop_.load(std::memory_order_relaxed)) {
        const std::int64_t now = monotonic_ns();
        if (now < due) {
            server_.step(static_cast<int>((due - now) / ms_ns) + 1);
            continue;
        }
        due = std::max(due + frame_ns, now);
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            pass.follow(next_);
        }
        pass.send_newest();
        clients_.store(server_.clients(), std::memory_order_relaxed);
        dropped_.store(server_.dropped(), std::memory_order_relaxed);
    }
    pass.end(true);
}

}  // namespace fulcrum::app
