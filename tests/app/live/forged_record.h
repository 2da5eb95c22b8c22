// SPDX-License-Identifier: GPL-3.0-or-later
// Recordings of a synthetic expert, and what whoever holds the station's key can do to them: replaced and
// signed again they pass every part of the check but the simulation.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "database/rows/connection.h"
#include "database/store/audit.h"
#include "tests/app/live/kept_station.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {

/// Practice of A2 with an expert's hands, performed by somebody with a device of this class; returns its id.
inline std::string record_expert_hands(const KeptStation& station, const std::string& path,
                                       std::uint64_t seed, const database::Session& performer,
                                       DeviceClass device_class) {
    PerformRequest request;
    request.loaded = load_task_and_scene("A2");
    request.operator_level = OperatorLevel::expert;
    request.seed = seed;
    request.assessed = false;
    database::AttemptMeta meta = station.meta(request.loaded);
    meta.seed = seed;
    meta.device_class = device_class;
    if (!performer.is_station()) meta.person_id = performer.person_id();
    const Limits limits = limits_for(request.loaded.task, request.loaded.scene, device_class);
    database::Recorder recorder(path, performer, meta);
    perform(request, &recorder, limits);
    return recorder.attempt_id();
}
/// By the station's synthetic expert.
inline std::string record_expert_attempt(const KeptStation& station, const std::string& path,
                                         std::uint64_t seed) {
    return record_expert_hands(station, path, seed, station.session, DeviceClass::synthetic);
}

/// Writes the store of a station with two attempts of its expert; their ids. They are performed at the first
/// call: the stores are copies of one.
inline const std::vector<std::string>& place_two_attempts(const std::string& path) {
    static const test::OwnFolder folder;
    static const std::string made = (folder / "made.db").string();
    static const std::vector<std::string> ids = [] {
        const KeptStation station(made);
        std::vector<std::string> recorded;
        for (const std::uint64_t seed : {11ULL, 12ULL})
            recorded.push_back(record_expert_attempt(station, made, seed));
        station.store.connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");  // one file, to be copied
        return recorded;
    }();
    EXPECT_TRUE(std::filesystem::copy_file(made, path));
    return ids;
}

/// Does what a trigger forbids, as whoever has the file can; the trigger is put back.
template <typename Deed>
void past_trigger(const KeptStation& station, const std::string& name, Deed&& deed) {
    database::Connection& connection = station.store.connection();
    std::string trigger;
    {
        database::Query row(connection, "SELECT sql FROM sqlite_master WHERE name = ?");
        row.bind(name);
        ASSERT_TRUE(row.next()) << name;
        trigger = row.text(0);
    }
    connection.execute("DROP TRIGGER " + QString::fromStdString(name));
    deed(connection);
    connection.execute(QString::fromStdString(trigger));
}
/// Puts other data in place of a chunk.
inline void replace_chunk(const KeptStation& station, const std::string& id, int stream, std::int64_t number,
                          const database::TraceChunk& chunk) {
    past_trigger(station, "trace_chunk_is_fixed", [&](database::Connection& connection) {
        database::Query(connection,
                        "UPDATE trace_chunk SET data = ?, checksum = ? WHERE attempt_id = ? AND stream = ? "
                        "AND number = ?")
            .bind(chunk.data)
            .bind(chunk.checksum)
            .bind(id)
            .bind(stream)
            .bind(number)
            .run();
    });
}
/// The attempt has ended in another state.
inline void replace_end(const KeptStation& station, const std::string& id) {
    past_trigger(station, "attempt_is_fixed", [&](database::Connection& connection) {
        database::Query(connection, "UPDATE attempt SET state_hash = '00c0ffee00c0ffee' WHERE id = ?")
            .bind(id)
            .run();
    });
}
/// What the station's key signs says that the records are as they are now.
inline void sign_again(const KeptStation& station, const std::string& id) {
    database::Audit(station.store)
        .append(station.session, id, "score.add", "{}",
                {{database::RecordKind::attempt, id}, {database::RecordKind::trace, id}});
}
/// The forces of a second, all gone. `reader`: who may read the recording.
inline void take_forces_away(const KeptStation& station, const std::string& id,
                             const database::Session& reader) {
    database::TraceCodec codec;
    const database::Trace trace = database::Attempts(station.store).read_trace(reader, id);
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
inline void take_forces_away(const KeptStation& station, const std::string& id) {
    take_forces_away(station, id, station.session);
}

}  // namespace fulcrum::app
