// SPDX-License-Identifier: GPL-3.0-or-later
// Plain rows of an attempt: what it was, how it ended, its metrics, gates and score, with their provenance
// (docs/FORMATS.md, perform).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "assessment/metrics/metric.h"
#include "assessment/task/attempt_words.h"
#include "sim_core/instrument/device.h"

namespace fulcrum::database {

/// Where practice began that did not begin at the beginning: with a state of another attempt, or of a
/// demonstration at the beginning of a goal.
struct AttemptOrigin {
    std::string source_id;            ///< the attempt that it continues; empty: a demonstration
    std::uint32_t tick = 0;           ///< last tick of the source; the first of this attempt is the next
    int goal = 0;                     ///< index of the goal that it begins in
    std::string build;                ///< that wrote `state`, and can read it
    std::vector<std::uint8_t> state;  ///< pack_bytes() of the engine's; not read back with the attempt
};

/// A file that decides a result: a scene, a task, a benchmark set, a curriculum.
struct AssetFile {
    std::string name;    ///< within the assets folder, "benchmarks/A2.json"
    std::string digest;  ///< SHA-256 of its bytes, hex, as `sha256sum` prints it
};

/// Known before the first tick; written when the recorder opens.
struct AttemptMeta {
    std::string id;         ///< UUID; empty: the recorder makes one
    std::string person_id;  ///< UUID
    std::string task_id;    ///< "A2"
    int task_version = 1;
    AttemptMode mode = AttemptMode::practice;
    DeviceClass device_class = DeviceClass::mouse_keyboard;
    std::string device;          ///< what the device calls itself
    std::string operator_name;   ///< synthetic operator preset, or empty
    std::string variant;         ///< anatomy variant
    ForceDevices force_devices;  ///< what the hands' devices could render, with the force scale
    /// How the device was set up and how often it was read; none: simulated, from elsewhere, or older.
    std::optional<RigUse> rig_use;
    std::uint64_t seed = 0;
    std::string fidelity;
    std::string scene;         ///< file name
    std::string scene_text;    ///< the scene as it is used, for the record; not read back with the attempt
    std::string scene_digest;  ///< BLAKE2b-256 of scene_text, hex, made by the recorder; empty without it
    std::string curriculum;    ///< id@version or empty
    std::string limits;        ///< benchmark set id@version in force at the start, or empty
    std::vector<AssetFile> assets;  ///< what it is performed with; not read back with the attempt
    std::string program_version;
    std::string cpu_features;             ///< feature level, for replay
    std::int64_t started = 0;             ///< UTC ms; 0: the recorder's clock
    int utc_offset_min = 0;               ///< local time minus UTC; filled by the recorder if started == 0
    std::optional<AttemptOrigin> origin;  ///< of practice only; such an attempt is never scored
    /// False: result and scores alone are stored, and the record says that the trace was not kept.
    bool keep_trace = true;
};

/// In place of the number of events of an attempt whose trace was not kept (docs/FORMATS.md).
inline constexpr std::int64_t trace_not_kept = -1;

/// An exercise that is not ours has its name after this as the task of its attempts: no task of ours begins
/// so (database/records/external_attempts.h).
inline const std::string external_task_prefix = "external-";
inline bool is_external_task(const std::string& task_id) {
    return task_id.rfind(external_task_prefix, 0) == 0;
}

/// One value, or why it is absent.
struct MetricRow {
    std::string id;
    int version = 1;
    std::string hand;    ///< left | right | "" none
    std::string tissue;  ///< label | "" all
    std::optional<double> value;
    Statement absent_because;  ///< empty when there is a value
    std::string unit;
    Direction direction = Direction::context;
    std::vector<std::pair<double, double>> evidence;  ///< s
};

struct GateRow {
    std::string metric, hand, tissue;
    GateKind kind = GateKind::benchmark;
    std::optional<double> value;
    std::string unit;
    std::optional<double> limit;  ///< absent where no benchmark set has a level, and then so is its source
    std::string limit_source;
    std::optional<double> z;
    std::optional<double> points;  ///< 0..100
    std::optional<bool> passed;
    bool provisional = false;
    Statement not_passed_because;  ///< empty unless passed is false or empty
};

struct CriticalErrorRow {
    double time_s = 0;
    std::string kind;          ///< event name
    std::string hand, tissue;  ///< "" none
    std::string text;
};

/// Metrics held against limits. The first score of an attempt stays in force; later ones are kept next to it.
struct ScoreRow {
    std::string id;             ///< UUID, made by the store
    std::int64_t computed = 0;  ///< UTC ms, made by the store
    std::string program_version, limits;
    bool in_force = false;       ///< made by the store
    std::optional<bool> passed;  ///< empty: not scored
    Statement not_scored_because;
    std::optional<double> points;  ///< 0..100
    Statement advice;              ///< one sentence
    std::vector<GateRow> gates;
    std::vector<MetricRow> metrics;
    std::vector<CriticalErrorRow> critical_errors;
    std::string pathology;  ///< JSON (assessment/pathology); empty: the task leaves no specimen
};

/// A field left at the end (damage, cut surface), as one checksummed blob.
struct ProductBlob {
    std::string kind;
    std::vector<std::uint8_t> data;  ///< at most 64 MiB
};

/// How it ended; written by Recorder::finish in one transaction with the last chunks.
struct AttemptResult {
    AttemptState state = AttemptState::running;  ///< how it ended; never running nor voided
    double duration_s = 0;                       ///< attempt clock
    double wall_s = 0;
    std::uint32_t missed_ticks = 0;
    std::uint64_t lost_samples = 0;
    std::string state_hash;  ///< hex
    std::optional<ScoreRow> score;
    std::vector<ProductBlob> products;
    std::optional<RigUse> rig_use;  ///< with the measured rate; in place of that of the beginning
};

struct AttemptSummary {
    AttemptMeta meta;
    std::string station_id;  ///< that recorded it
    std::string person_login, person_name;
    bool synthetic = false;  ///< the person is marked synthetic or external
    AttemptState state = AttemptState::running;
    AttemptState recorded_state = AttemptState::running;  ///< what it was before a void
    double duration_s = 0, wall_s = 0;
    std::uint32_t missed_ticks = 0;
    std::uint64_t lost_samples = 0;
    std::uint64_t events = 0;  ///< 0 where the trace was not kept (meta.keep_trace)
    std::string state_hash;
    std::optional<bool> passed;  ///< of the score in force
    /// A gate of the score in force has a provisional limit; of a failure that was scored after its set had
    /// been replaced: that set was provisional.
    bool provisional = false;
    /// It failed, and the gates that a benchmark set judges have no limits: there was no set for it.
    bool without_limits = false;
    std::optional<double> points;
    Statement not_scored_because;
    bool counting = false;               ///< enters progress and cohorts, device class aside (docs/MANUAL.md)
    std::string void_reason, voided_by;  ///< display name; "" if not voided
    std::int64_t voided_at = 0;
    std::string reassigned_from, reassigned_to;  ///< attempt ids or ""
    int unread_comments = 0;                     ///< sent, not yet read by the trainee
    int comments = 0;                            ///< sent
};

struct Comment {
    std::string id, attempt_id, author_id, author_name;
    double time_s = 0;  ///< moment in the attempt
    std::string text;
    std::int64_t created = 0;
    std::int64_t sent = 0;  ///< 0: a draft, seen by its author only
    std::int64_t read = 0;  ///< 0: unread by the trainee
};

/// A reason for confirming or striking an error that was begun and not given is kept as a draft of a comment
/// at the error's moment that begins so. It is not for sending.
inline constexpr char begun_reason_mark[] = "\u270E ";
inline bool is_begun_reason(const Comment& comment) {
    return comment.sent == 0 && comment.text.rfind(begun_reason_mark, 0) == 0;
}

}  // namespace fulcrum::database
