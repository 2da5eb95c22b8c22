-- SPDX-License-Identifier: GPL-3.0-or-later
-- Practice that began with a state: of another attempt (source_id) at a moment, or of a demonstration
-- (source_id NULL) where a goal began. state: compressed engine state, read only by the build it names;
-- checksum: BLAKE2b-128 of it. source_id is no foreign key: an attempt can be erased, what continued it stays.
-- Such an attempt has no score.

CREATE TABLE attempt_origin (
    attempt_id TEXT PRIMARY KEY REFERENCES attempt (id),
    source_id TEXT,
    tick BIGINT NOT NULL CHECK (tick >= 1),
    goal INTEGER NOT NULL CHECK (goal >= 0),
    build TEXT NOT NULL CHECK (build <> ''),
    checksum BLOB NOT NULL,
    state BLOB NOT NULL
);

CREATE TRIGGER attempt_origin_is_fixed BEFORE UPDATE ON attempt_origin
BEGIN SELECT RAISE(ABORT, 'where an attempt began is never changed'); END;
CREATE TRIGGER attempt_origin_is_practice BEFORE INSERT ON attempt_origin
WHEN (SELECT mode FROM attempt WHERE id = NEW.attempt_id) <> 'practice'
BEGIN SELECT RAISE(ABORT, 'an attempt that continues another one is practice'); END;
CREATE TRIGGER attempt_with_origin_has_no_score BEFORE INSERT ON score
WHEN EXISTS (SELECT 1 FROM attempt_origin WHERE attempt_id = NEW.attempt_id)
BEGIN SELECT RAISE(ABORT, 'an attempt that continues another one is never scored'); END;
