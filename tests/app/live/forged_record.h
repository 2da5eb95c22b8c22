// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of a synthetic expert, and what whoever holds the station's key can do to them: replaced and
// signed again they pass every part of the check but the simulation.
#pragma once

#include "database/rows/connection.h"
#include "database/store/audit.h"
#include "tests/app/live/kept_station.h"

namespace fulcrum::app {

/// Practice of A2; returns its id.
inline std::string record_expert_attempt(const KeptStation& station, const std::string& path,
                                         std::uint64_t seed) {
    PerformRequest request;
    request.loaded = load_task_and_scene("A2");
    request.operator_level = OperatorLevel::expert;
    request.seed = seed;
    request.assessed = false;
    database::AttemptMeta meta = station.meta(request.loaded);
    meta.seed = seed;
    const Limits limits = limits_for(request.loaded.task, request.loaded.scene, DeviceClass::synthetic);
    database::Recorder recorder(path, station.session, meta);
    perform(request, &recorder, limits);
    return recorder.attempt_id();
}

/// Puts other data in place of a chunk, as whoever has the file can; the trigger is put back.
inline void replace_chunk(const KeptStation& station, const std::string& id, int stream, std::int64_t number,
                          const database::TraceChunk& chunk) {
    std::string trigger;
    {
        database::Query row(station.store.connection(),
                            "SELECT sql FROM sqlite_master WHERE name = 'trace_chunk_is_fixed'");
        ASSERT_TRUE(row.next());
        trigger = row.text(0);
    }
    station.store.connection().execute("DROP TRIGGER trace_chunk_is_fixed");
    database::Query(station.store.connection(),
                    "UPDATE trace_chunk SET data = ?, checksum = ? WHERE attempt_id = ? AND stream = ? AND "
                    "number = ?")
        .bind(chunk.data)
        .bind(chunk.checksum)
        .bind(id)
        .bind(stream)
        .bind(number)
        .run();
    station.store.connection().execute(QString::fromStdString(trigger));
}
/// What the station's key signs says that the records are as they are now.
inline void sign_again(const KeptStation& station, const std::string& id) {
    database::Audit(station.store)
        .append(station.session, id, "score.add", "{}",
                {{database::RecordKind::attempt, id}, {database::RecordKind::trace, id}});
}
/// The forces of a second, all gone.
inline void take_forces_away(const KeptStation& station, const std::string& id) {
    database::TraceCodec codec;
    const database::Trace trace = database::Attempts(station.store).read_trace(station.session, id);
    database::TraceChunk stored;
    {
        database::Query row(station.store.connection(),
                            "SELECT first_tick, last_tick FROM trace_chunk WHERE attempt_id = ? AND stream = "
                            "0 AND number = 2");
        row.bind(id);
        ASSERT_TRUE(row.next());
        stored.first_tick = static_cast<std::uint32_t>(row.integer(0));
        stored.last_tick = static_cast<std::uint32_t>(row.integer(1));
    }
    std::vector<TickSample> samples;
    std::vector<RigSample> inputs;
    for (std::size_t i = 0; i < trace.samples.size(); ++i) {
        if (trace.samples[i].tick < stored.first_tick || trace.samples[i].tick > stored.last_tick) continue;
        samples.push_back(trace.samples[i]);
        inputs.push_back(trace.inputs[i]);
    }
    for (TickSample& sample : samples) {
        sample.hand[0].force[0] = sample.hand[0].force[1] = sample.hand[0].force[2] = 0;
        sample.hand[1].tip[0] += 1;  // 0.1 um
    }
    replace_chunk(station, id, 0, 2, codec.encode(samples.data(), samples.size(), inputs.data()));
}

}  // namespace fulcrum::app
