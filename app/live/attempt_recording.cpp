// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/attempt_recording.h"

#include <chrono>
#include <cmath>

#include "app/live/frame_follower.h"
#include "app/live/frame_keeping.h"
#include "database/records/attempts.h"
#include "database/rows/packed_bytes.h"

namespace fulcrum::app {
namespace {

constexpr std::uint32_t flush_every_ticks = 700;

}  // namespace

AttemptRecording::AttemptRecording(const LiveRequest& request, std::vector<TargetSphere> targets)
    : request_(request),
      targets_(std::move(targets)),
      recorder_(request.store_path, *request.session, request.meta),
      watch_(request.loaded.task, request.loaded.scene,
             judged_limits(request.loaded.task, request.limits.comparable())) {
    if (request.follower == nullptr) return;
    ReplayStart start{request.loaded, request.seed};
    if (request.meta.origin) start.state = database::unpack_bytes(request.meta.origin->state);
    request.follower->begin(std::move(start), request.meta.force_devices);
}

void AttemptRecording::append(const RigSample& input, const TickSample& sample) {
    recorder_.append(input);
    recorder_.append(sample);
    watch_.see(sample);
    if (request_.follower != nullptr) request_.follower->append(input, sample);
}

void AttemptRecording::append(const StepRecord& step) {
    recorder_.append(step);
    if (request_.follower != nullptr) request_.follower->append(step);
}

void AttemptRecording::append(const Event& event) {
    recorder_.append(event);
    watch_.see(event);
    if (!request_.assessed) return;
    if (event.kind == EventKind::device_lost) lost_now_ = true;
    if (event.kind == EventKind::device_back) came_back_ = true;
}

void AttemptRecording::stood_still(double seconds) {
    if (!request_.assessed || practice_) return;
    why_practice_ =
        Statement(StatementId::practice_stood_still, {{"seconds", std::round(10 * seconds) / 10}});
    keep_now_ = lost_now_ = came_back_ = true;
}

void AttemptRecording::keep(std::uint32_t tick) {
    if (request_.follower != nullptr) request_.follower->hand_on();
    const std::uint32_t since = tick - flushed_tick_;
    if (keep_now_ || since >= flush_every_ticks || watch_.due(since)) {
        try {
            recorder_.flush();
            flushed_tick_ = tick;
            keep_now_ = false;
            watch_.written();
        } catch (const database::StoreError& locked) {
            if (locked.kind() != database::StoreErrorKind::locked) throw;
            return;
        }
    }
    if (lost_now_) {
        lost_now_ = false;
        if (!failed_before_.valid())
            failed_before_ =
                std::async(std::launch::async, [this] { return score().score.passed == false; }).share();
    }
    relabel();
}

// What follows a lost device is practice, unless what came before has failed the attempt: then it stays
// assessed. Relabelled as soon as that is known, so that the attempt is practice even if the program is
// killed.
void AttemptRecording::relabel() {
    if (!came_back_ || practice_ || !failed_before_.valid()) return;
    if (failed_before_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    if (failed_before_.get()) return;
    practice_ = recorder_.relabel_as_practice(why_practice_);
}

void AttemptRecording::settle() {
    recorder_.flush();
    if (!failed_before_.valid()) return;
    failed_before_.wait();
    relabel();
}

void AttemptRecording::finish(const database::AttemptResult& result) {
    recorder_.finish(result);
    if (request_.follower != nullptr)
        request_.follower->complete(attempt_id(),
                                    frame_keeping(request_.store_path, *request_.session, attempt_id()));
}

ScoredAttempt AttemptRecording::score() const {
    database::StoreOptions options;
    options.read_only = true;
    const database::Store store = database::Store::open(request_.store_path, options);
    const database::Trace trace =
        database::Attempts(store).read_trace(*request_.session, recorder_.attempt_id());
    return score_record(request_.loaded.scene, request_.loaded.task, targets_, trace.samples, trace.events,
                        request_.limits);
}

}  // namespace fulcrum::app
