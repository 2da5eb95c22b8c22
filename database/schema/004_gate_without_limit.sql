-- SPDX-License-Identifier: GPL-3.0-or-later
-- A gate whose metric no benchmark set has a level for has no limit: NULL, where it was written as 0. A limit and
-- where it comes from belong together, so that the score's digest, which covers the source, covers both.

CREATE TABLE gate_with_optional_limit (
    score_id TEXT NOT NULL REFERENCES score (id),
    number INTEGER NOT NULL,
    metric TEXT NOT NULL,
    hand TEXT NOT NULL,
    tissue TEXT NOT NULL,
    kind TEXT NOT NULL CHECK (kind IN ('benchmark', 'absolute')),
    value DOUBLE PRECISION,
    unit TEXT NOT NULL,
    limit_value DOUBLE PRECISION,
    limit_source TEXT NOT NULL,
    z DOUBLE PRECISION,
    points DOUBLE PRECISION,
    passed INTEGER CHECK (passed IN (0, 1)),
    provisional INTEGER NOT NULL CHECK (provisional IN (0, 1)),
    not_passed_because TEXT NOT NULL,
    PRIMARY KEY (score_id, number),
    CHECK ((limit_value IS NULL) = (limit_source = ''))
);

INSERT INTO gate_with_optional_limit
SELECT score_id, number, metric, hand, tissue, kind, value, unit, CASE WHEN limit_source = '' THEN NULL ELSE limit_value END,
    limit_source, z, points, passed, provisional, not_passed_because
FROM gate;

DROP TABLE gate;
ALTER TABLE gate_with_optional_limit RENAME TO gate;

CREATE TRIGGER gate_is_fixed BEFORE UPDATE ON gate
BEGIN SELECT RAISE(ABORT, 'nobody edits a score'); END;
