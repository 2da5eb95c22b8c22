-- SPDX-License-Identifier: GPL-3.0-or-later
-- Decisions of educators on where a person stands in a curriculum. Added, never changed.

CREATE TABLE standing_override (
    id TEXT PRIMARY KEY,
    person_id TEXT NOT NULL REFERENCES person (id),
    task_id TEXT NOT NULL CHECK (task_id <> ''),
    kind TEXT NOT NULL CHECK (kind IN ('unlocked', 'proficient')),
    author_id TEXT NOT NULL REFERENCES person (id),
    time BIGINT NOT NULL,
    reason TEXT NOT NULL CHECK (reason <> '')
);
CREATE INDEX standing_override_person ON standing_override (person_id, time);

CREATE TRIGGER standing_override_is_fixed BEFORE UPDATE ON standing_override
BEGIN SELECT RAISE(ABORT, 'a decision on a standing is never changed'); END;
CREATE TRIGGER standing_override_is_kept BEFORE DELETE ON standing_override
BEGIN SELECT RAISE(ABORT, 'a decision on a standing is never deleted'); END;
