// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/frame_follower.h"

#include <algorithm>

namespace fulcrum::app {
namespace {

constexpr std::uint32_t slice_ticks = 10;
/// Ticks between what is made and the newest: enough that the record knows which step follows.
constexpr std::uint32_t behind_ticks = 100;
constexpr std::size_t ticks_to_drop = 5000;

template <typename Type>
void move_to(std::vector<Type>& from, std::vector<Type>& to) {
    to.insert(to.end(), from.begin(), from.end());
    from.clear();
}

template <typename Record>
std::size_t bytes_of(const Record& record) noexcept {
    return record.inputs.size() * sizeof(RigSample) + record.samples.size() * sizeof(TickSample) +
           record.steps.size() * sizeof(StepRecord);
}

}  // namespace

std::size_t FrameFollower::Waiting::bytes() const noexcept {
    return bytes_of(*this);
}

FrameFollower::~FrameFollower() {
    stop();
}

void FrameFollower::stop() noexcept {
    stop_.store(true);
    there_is_more_.post();
    if (thread_.joinable()) thread_.join();
}

void FrameFollower::begin(ReplayStart start, const ForceDevices& devices) noexcept {
    try {
        start_ = std::move(start);
        record_.devices = devices;
        frames_ = std::make_shared<FrameStore>();
        thread_ = std::thread([this] { run(); });
    } catch (...) {
        give_up();
    }
}

void FrameFollower::append(const RigSample& input, const TickSample& sample) noexcept {
    if (given_up_.load()) return;
    try {
        appended_.inputs.push_back(input);
        appended_.samples.push_back(sample);
    } catch (...) {
        give_up();
    }
}

void FrameFollower::append(const StepRecord& step) noexcept {
    if (given_up_.load()) return;
    try {
        appended_.steps.push_back(step);
    } catch (...) {
        give_up();
    }
}

void FrameFollower::hand_on() noexcept {
    if (given_up_.load()) return;
    {
        // The other thread may hold it and not get the processor; then all of it goes with the next call.
        const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock);
        if (lock.owns_lock()) {
            try {
                move_to(appended_.inputs, waiting_.inputs);
                move_to(appended_.samples, waiting_.samples);
                move_to(appended_.steps, waiting_.steps);
            } catch (...) {
                give_up();
            }
            if (waiting_.bytes() > most_) give_up();
            waiting_bytes_.store(waiting_.bytes());
        }
    }
    if (appended_.bytes() > most_) give_up();
    there_is_more_.post();
}

void FrameFollower::complete(const std::string& attempt_id, FrameKeeping keeping) noexcept {
    try {
        const std::lock_guard<std::mutex> lock(mutex_);
        move_to(appended_.inputs, waiting_.inputs);
        move_to(appended_.samples, waiting_.samples);
        move_to(appended_.steps, waiting_.steps);
        attempt_id_ = attempt_id;
        keeping_ = std::move(keeping);
        complete_ = true;
    } catch (...) {
        give_up();
    }
    there_is_more_.post();
}

bool FrameFollower::finish_here() noexcept {
    stop();
    stop_.store(false);
    make_or_give_up();
    return written_.load();
}

std::vector<PackedFrame> FrameFollower::take(const std::string& attempt_id) noexcept {
    try {
        std::shared_ptr<const FrameStore> frames;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            if (!complete_ || attempt_id_ != attempt_id) return {};
            frames = frames_;
        }
        stop_.store(true);
        there_is_more_.post();
        if (given_up_.load() || written_.load() || frames == nullptr) return {};
        return frames->frames();
    } catch (...) {
        return {};
    }
}

void FrameFollower::run() noexcept {
    take_lowest_priority();
    previous_.reset();
    make_or_give_up();
}

void FrameFollower::make_or_give_up() noexcept {
    try {
        make();
    } catch (...) {
        give_up();
    }
    if (given_up_.load() || written_.load()) {
        player_.reset();
        const std::lock_guard<std::mutex> lock(mutex_);
        frames_.reset();
        made_bytes_.store(0);
    }
}

void FrameFollower::fetch() {
    Waiting fetched;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        std::swap(fetched, waiting_);
        whole_ = complete_;
    }
    move_to(fetched.inputs, record_.inputs);
    move_to(fetched.samples, record_.samples);
    move_to(fetched.steps, record_.steps);
    if (!record_.inputs.empty()) newest_ = record_.inputs.back().tick;
}

void FrameFollower::make() {
    while (!stop_.load() && !given_up_.load() && !written_.load()) {
        fetch();
        if (!player_ && (whole_ || record_.inputs.size() > behind_ticks)) {
            player_.emplace(start_, record_);
            frames_->add(player_->cursor);
        }
        const std::uint32_t until = whole_ ? newest_ : newest_ - std::min(newest_, behind_ticks);
        made_bytes_.store(frames_->bytes() + bytes_of(record_));
        if (player_ && player_->cursor.tick() < until) {
            make_slice(until);
        } else if (whole_) {
            if (player_) player_->cursor.run_to_end();
            if (!player_ || newest_ == 0 || !player_->cursor.outcome().identical) return give_up();
            written_.store(write_file());
            return;
        } else {
            there_is_more_.wait();
        }
    }
}

void FrameFollower::make_slice(std::uint32_t until) {
    ReplayCursor& cursor = player_->cursor;
    const double begin = thread_seconds();
    const std::uint32_t before = cursor.tick();
    cursor.run_to(std::min(until, before + slice_ticks));
    since_frame_ += thread_seconds() - begin;
    if (!cursor.outcome().identical) return give_up();
    if (frames_->wants(since_frame_)) {
        frames_->add(cursor);
        since_frame_ = 0;
    }
    run_since_dropped_ += cursor.tick() - before;
    if (run_since_dropped_ < ticks_to_drop) return;
    cursor.drop_run(record_);
    run_since_dropped_ = 0;
}

bool FrameFollower::write_file() {
    FrameKeeping keeping;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        keeping = keeping_;
    }
    if (!keeping.wanted()) return false;
    FrameFileWriter writer(keeping, frames_->frames(), newest_);
    while (!stop_.load() && writer.write_more()) {
    }
    return writer.complete();
}

}  // namespace fulcrum::app
