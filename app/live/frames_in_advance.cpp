// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/live/frames_in_advance.h"

#include <sys/stat.h>

#include <filesystem>

#include "app/live/frame_keeping.h"
#include "app/live/frame_pass.h"
#include "app/live/real_time.h"
#include "app/live/stored_start.h"
#include "database/store/kept_frames.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/state_archive.h"

namespace fulcrum::app {
namespace {

/// Of the files in a folder; 0 where there is none.
std::uint64_t bytes_in(const std::string& folder) {
    std::error_code unknown;
    std::uint64_t sum = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder, unknown)) {
        const std::uint64_t bytes = entry.file_size(unknown);
        if (!unknown) sum += bytes;
    }
    return sum;
}

/// Its record is in the store, and a simulation made it.
bool has_record(const database::AttemptSummary& attempt) {
    return attempt.recorded_state != AttemptState::running && attempt.events > 0 &&
           !database::is_external_task(attempt.meta.task_id);
}

bool still_stored(const database::Store& store, const database::Session& session,
                  const std::string& attempt_id, const LoadedTask& loaded, const FrameKeeping& keeping) {
    try {
        return frame_keeping(store, session, attempt_id, loaded).belongs == keeping.belongs;
    } catch (const std::exception&) {
        return false;
    }
}

}  // namespace

void FramesInAdvance::finish() noexcept {
    stop();
    if (thread_.joinable()) thread_.join();
}

void FramesInAdvance::begin(const std::string& store_path, const database::Session& session,
                            std::set<std::string> except) noexcept {
    try {
        if (at_work()) return;
        if (thread_.joinable()) thread_.join();
        std::set<std::string> seen;
        if (work_ != nullptr && work_->store_path == store_path &&
            work_->session.person_id() == session.person_id())
            seen = std::move(work_->seen);
        for (const std::string& id : opened_) seen.erase(id);
        opened_.clear();
        work_ = std::make_shared<Work>(store_path, session);
        work_->seen = std::move(seen);
        work_->except = std::move(except);
        thread_ = std::thread([work = work_] { run(*work); });
    } catch (const std::exception&) {
        if (!thread_.joinable()) work_.reset();
    }
}

void FramesInAdvance::stop() noexcept {
    if (work_ != nullptr) work_->stop.store(true);
}

std::vector<PackedFrame> FramesInAdvance::take(const std::string& attempt_id) noexcept {
    stop();
    try {
        opened_.insert(attempt_id);
        if (!at_work()) return {};
        std::shared_ptr<const FrameStore> frames;
        {
            const std::lock_guard<std::mutex> lock(work_->mutex);
            if (work_->attempt_id == attempt_id) frames = work_->frames;
        }
        return frames != nullptr ? frames->frames() : std::vector<PackedFrame>();
    } catch (const std::exception&) {
        return {};
    }
}

void FramesInAdvance::run(Work& work) noexcept {
    take_lowest_priority();
    try {
        make_all(work);
    } catch (const std::exception&) {
        // The store is in use, closed or damaged: pages that need it say so.
    }
    work.ended.store(true);
}

void FramesInAdvance::make_all(Work& work) {
    database::StoreOptions options;
    options.close_interrupted = false;
    const database::Store store = database::Store::open(work.store_path, options);
    const std::string folder = database::kept_frames_folder(store);
    if (folder.empty()) return;
    const database::Attempts attempts(store);
    database::AttemptFilter filter;
    filter.limit = most_attempts;
    for (const database::AttemptSummary& attempt : attempts.list(work.session, filter)) {
        if (work.stop.load() || bytes_in(folder) > most_bytes) return;
        if (!has_record(attempt) || work.seen.count(attempt.meta.id) > 0 ||
            work.except.count(attempt.meta.id) > 0)
            continue;
        try {
            make_one(work, store, attempts, attempt);
        } catch (const InputError&) {
            // A task that is not known here.
        } catch (const StateArchiveError&) {
        } catch (const database::StoreError& error) {
            // Damaged, or at another station; anything else may be over a minute later.
            if (error.kind() != database::StoreErrorKind::corrupt &&
                error.kind() != database::StoreErrorKind::not_found)
                throw;
        }
        if (!work.stop.load()) work.seen.insert(attempt.meta.id);
    }
}

void FramesInAdvance::make_one(Work& work, const database::Store& store, const database::Attempts& attempts,
                               const database::AttemptSummary& attempt) {
    const StoredStart stored = stored_start(attempts, work.session, attempt);
    if (!stored.readable) return;
    const FrameKeeping keeping = frame_keeping(store, work.session, attempt.meta.id, stored.start.loaded);
    if (!keeping.wanted() || FrameFile::open(keeping) != nullptr) return;
    const auto trace =
        std::make_shared<const database::Trace>(attempts.read_packed_trace(work.session, attempt.meta.id));
    const std::shared_ptr<const RecordTicks> ticks = database::ticks_of(trace);
    if (ticks->size() == 0) return;
    const AttemptRecord record{{}, {}, trace->steps, trace->events, attempt.meta.force_devices, ticks};
    const auto frames = std::make_shared<FrameStore>();
    {
        const std::lock_guard<std::mutex> lock(work.mutex);
        work.attempt_id = attempt.meta.id;
        work.frames = frames;
    }
    FramePass pass(stored.start, record, *frames);
    while (!work.stop.load() && pass.identical() && pass.run_slice()) {
    }
    if (work.stop.load() || !pass.identical()) return;
    FrameFileWriter writer(keeping, frames->frames(), ticks->last_sample().tick);
    while (!work.stop.load() && writer.write_more()) {
    }
    // Who erased it looked for its file before this one was there.
    if (writer.complete() &&
        !still_stored(store, work.session, attempt.meta.id, stored.start.loaded, keeping))
        keeping.forget();
}

}  // namespace fulcrum::app
