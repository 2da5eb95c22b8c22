-- SPDX-License-Identifier: GPL-3.0-or-later
-- What an educator says of an error that the program recorded by itself: confirmed, or struck, with the reason. The
-- event is named by what its record holds of it: tick, kind, hand, tissue and detail; two events that agree in all five
-- happened at one moment and are one line for whoever reads them. Rows are added; the newest of an event counts. Scores
-- stay as they are.

CREATE TABLE error_review (
    id TEXT PRIMARY KEY,
    attempt_id TEXT NOT NULL REFERENCES attempt (id),
    author_id TEXT NOT NULL REFERENCES person (id),
    tick BIGINT NOT NULL CHECK (tick >= 0),
    kind TEXT NOT NULL CHECK (kind <> ''),
    hand INTEGER NOT NULL CHECK (hand BETWEEN 0 AND 255),
    tissue INTEGER NOT NULL CHECK (tissue BETWEEN -128 AND 127),
    detail BIGINT NOT NULL,
    verdict TEXT NOT NULL CHECK (verdict IN ('confirmed', 'struck')),
    reason TEXT NOT NULL CHECK (reason <> ''),
    time BIGINT NOT NULL
);
CREATE INDEX error_review_attempt ON error_review (attempt_id, time);
CREATE INDEX error_review_author ON error_review (author_id);

CREATE TRIGGER error_review_is_fixed BEFORE UPDATE ON error_review
BEGIN SELECT RAISE(ABORT, 'the review of an error is never changed'); END;
CREATE TRIGGER error_review_is_kept BEFORE DELETE ON error_review
BEGIN SELECT RAISE(ABORT, 'the review of an error is never deleted'); END;
