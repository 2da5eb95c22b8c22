// SPDX-License-Identifier: GPL-3.0-or-later
// A store with attempts of a synthetic expert, and the proof that key frames belong to their record.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "app/live/frame_keeping.h"
#include "app/live/frame_store.h"
#include "app/live/performance.h"
#include "assessment/attempt/replay_cursor.h"
#include "database/records/attempts.h"
#include "database/records/people.h"
#include "tests/assessment/attempt/expert_record.h"

namespace fulcrum::app {

/// A store of its own with a synthetic expert; where there is a file it is the one of that file.
struct KeptStation {
    explicit KeptStation(const std::string& path) : store(database::Store::open_or_create(path)) {}
    database::Store store;
    database::Session session = store.station_session();
    std::string person = database::People(store).ensure_synthetic(session, "expert", "Synthetic expert").id;

    database::AttemptMeta meta(const LoadedTask& loaded) const {
        database::AttemptMeta made = attempt_meta(loaded, test::expert_seed, AttemptMode::practice,
                                                  DeviceClass::synthetic, "synthetic operator", {});
        made.person_id = person;
        return made;
    }
    /// As open_replay() looks for it.
    FrameKeeping keeping(const std::string& attempt) const {
        const database::Attempts attempts(store);
        return frame_keeping(store, session, attempt,
                             load_recorded(attempts, session, attempts.read(session, attempt)));
    }
    AttemptRecord record(const std::string& attempt) const {
        const database::Trace trace = database::Attempts(store).read_trace(session, attempt);
        return {trace.inputs, trace.samples, trace.steps, trace.events, {}};
    }
};

/// From every frame to the next one, and from the last one to the end.
inline void expect_frames_bit_for_bit(const FrameKeeping& keeping, const LoadedTask& loaded,
                                      std::uint64_t seed, const AttemptRecord& record) {
    const auto file = FrameFile::open(keeping);
    ASSERT_NE(file, nullptr);
    EXPECT_EQ(file->last_tick(), record.inputs.back().tick);
    FrameStore frames;
    frames.restore(file);
    AttemptEngine engine(loaded.scene, loaded.task, seed);
    ReplayCursor cursor(engine, record);
    for (std::size_t i = 0; i < file->count(); ++i) {
        frames.put(file->tick(i), cursor);
        ASSERT_EQ(cursor.tick(), file->tick(i));
        if (i + 1 < file->count()) {
            cursor.run_to(file->tick(i + 1));
        } else {
            cursor.run_to_end();
        }
        ASSERT_TRUE(cursor.outcome().identical) << "from frame " << i;
    }
}

}  // namespace fulcrum::app
