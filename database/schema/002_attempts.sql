-- SPDX-License-Identifier: GPL-3.0-or-later
-- Attempts, traces, scores. An attempt changes only while it runs; scores, gates and metrics never.

CREATE TABLE attempt (
    id TEXT PRIMARY KEY,
    person_id TEXT NOT NULL REFERENCES person (id),
    station_id TEXT NOT NULL REFERENCES station (id),
    task_id TEXT NOT NULL,
    task_version INTEGER NOT NULL,
    mode TEXT NOT NULL CHECK (mode IN ('assessed', 'practice')),
    device_class TEXT NOT NULL
        CHECK (device_class IN ('haptic', 'tracked', 'controller', 'mouse-keyboard', 'synthetic', 'external')),
    device TEXT NOT NULL,
    operator_name TEXT NOT NULL,
    variant TEXT NOT NULL,
    seed BIGINT NOT NULL,
    fidelity TEXT NOT NULL,
    scene TEXT NOT NULL,
    scene_digest TEXT NOT NULL,
    curriculum TEXT NOT NULL,
    limits TEXT NOT NULL,
    program_version TEXT NOT NULL,
    cpu_features TEXT NOT NULL,
    started BIGINT NOT NULL,
    utc_offset_min INTEGER NOT NULL,
    state TEXT NOT NULL
        CHECK (state IN ('running', 'completed', 'timed_out', 'abandoned', 'interrupted', 'failed_simulation')),
    duration_s DOUBLE PRECISION NOT NULL DEFAULT 0,
    wall_s DOUBLE PRECISION NOT NULL DEFAULT 0,
    missed_ticks BIGINT NOT NULL DEFAULT 0,
    lost_samples BIGINT NOT NULL DEFAULT 0,
    events BIGINT NOT NULL DEFAULT 0,
    state_hash TEXT NOT NULL DEFAULT ''
);
CREATE INDEX attempt_person ON attempt (person_id, task_id, started);
CREATE INDEX attempt_started ON attempt (started);
CREATE INDEX attempt_running ON attempt (state) WHERE state = 'running';

CREATE TRIGGER attempt_is_fixed BEFORE UPDATE ON attempt WHEN OLD.state <> 'running'
BEGIN SELECT RAISE(ABORT, 'an attempt that has ended is never changed'); END;

-- stream: 0 samples, 1 inputs, 2 steps, 3 events. checksum: BLAKE2b-128 of data.
CREATE TABLE trace_chunk (
    attempt_id TEXT NOT NULL REFERENCES attempt (id),
    stream INTEGER NOT NULL,
    number INTEGER NOT NULL,
    first_tick BIGINT NOT NULL,
    last_tick BIGINT NOT NULL,
    records INTEGER NOT NULL,
    checksum BLOB NOT NULL,
    data BLOB NOT NULL,
    UNIQUE (attempt_id, stream, number)
);
CREATE TRIGGER trace_chunk_is_fixed BEFORE UPDATE ON trace_chunk
BEGIN SELECT RAISE(ABORT, 'a trace is never changed'); END;

CREATE TABLE attempt_product (
    attempt_id TEXT NOT NULL REFERENCES attempt (id),
    kind TEXT NOT NULL,
    checksum BLOB NOT NULL,
    data BLOB NOT NULL,
    PRIMARY KEY (attempt_id, kind)
);

CREATE TABLE score (
    id TEXT PRIMARY KEY,
    attempt_id TEXT NOT NULL REFERENCES attempt (id),
    computed BIGINT NOT NULL,
    program_version TEXT NOT NULL,
    limits TEXT NOT NULL,
    in_force INTEGER NOT NULL CHECK (in_force IN (0, 1)),
    passed INTEGER CHECK (passed IN (0, 1)),
    not_scored_because TEXT NOT NULL,
    points DOUBLE PRECISION,
    advice TEXT NOT NULL
);
CREATE INDEX score_attempt ON score (attempt_id);
CREATE UNIQUE INDEX score_one_in_force ON score (attempt_id) WHERE in_force = 1;

CREATE TABLE gate (
    score_id TEXT NOT NULL REFERENCES score (id),
    number INTEGER NOT NULL,
    metric TEXT NOT NULL,
    hand TEXT NOT NULL,
    tissue TEXT NOT NULL,
    kind TEXT NOT NULL CHECK (kind IN ('benchmark', 'absolute')),
    value DOUBLE PRECISION,
    unit TEXT NOT NULL,
    limit_value DOUBLE PRECISION NOT NULL,
    limit_source TEXT NOT NULL,
    z DOUBLE PRECISION,
    points DOUBLE PRECISION,
    passed INTEGER CHECK (passed IN (0, 1)),
    provisional INTEGER NOT NULL CHECK (provisional IN (0, 1)),
    not_passed_because TEXT NOT NULL,
    PRIMARY KEY (score_id, number)
);

CREATE TABLE metric (
    score_id TEXT NOT NULL REFERENCES score (id),
    number INTEGER NOT NULL,
    id TEXT NOT NULL,
    version INTEGER NOT NULL,
    hand TEXT NOT NULL,
    tissue TEXT NOT NULL,
    value DOUBLE PRECISION,
    absent_because TEXT NOT NULL,
    unit TEXT NOT NULL,
    direction TEXT NOT NULL,
    evidence TEXT NOT NULL,
    PRIMARY KEY (score_id, number)
);
CREATE INDEX metric_id ON metric (id);

CREATE TABLE critical_error (
    score_id TEXT NOT NULL REFERENCES score (id),
    number INTEGER NOT NULL,
    time_s DOUBLE PRECISION NOT NULL,
    kind TEXT NOT NULL,
    hand TEXT NOT NULL,
    tissue TEXT NOT NULL,
    text TEXT NOT NULL,
    PRIMARY KEY (score_id, number)
);

CREATE TRIGGER score_is_fixed BEFORE UPDATE ON score
BEGIN SELECT RAISE(ABORT, 'nobody edits a score'); END;
CREATE TRIGGER gate_is_fixed BEFORE UPDATE ON gate
BEGIN SELECT RAISE(ABORT, 'nobody edits a score'); END;
CREATE TRIGGER metric_is_fixed BEFORE UPDATE ON metric
BEGIN SELECT RAISE(ABORT, 'nobody edits a score'); END;
