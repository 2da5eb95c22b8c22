-- SPDX-License-Identifier: GPL-3.0-or-later
-- The pathology report of an attempt that leaves a specimen, as its score judged it: one JSON document
-- (assessment/pathology). It belongs to a score, so that a newer judgement lies beside the one in force.

CREATE TABLE pathology (
    score_id TEXT PRIMARY KEY REFERENCES score (id),
    report TEXT NOT NULL
);
CREATE TRIGGER pathology_is_fixed BEFORE UPDATE ON pathology
BEGIN SELECT RAISE(ABORT, 'nobody edits a score'); END;
