-- SPDX-License-Identifier: GPL-3.0-or-later
-- What others say of an attempt, beside it: void, reassignment, comments, corrections asked for.

CREATE TABLE attempt_void (
    attempt_id TEXT PRIMARY KEY REFERENCES attempt (id),
    person_id TEXT NOT NULL REFERENCES person (id),
    time BIGINT NOT NULL,
    reason TEXT NOT NULL
);

CREATE TABLE attempt_reassignment (
    from_id TEXT PRIMARY KEY REFERENCES attempt (id),
    to_id TEXT NOT NULL UNIQUE REFERENCES attempt (id)
);

CREATE TABLE comment (
    id TEXT PRIMARY KEY,
    attempt_id TEXT NOT NULL REFERENCES attempt (id),
    author_id TEXT NOT NULL REFERENCES person (id),
    time_s DOUBLE PRECISION NOT NULL,
    text TEXT NOT NULL,
    created BIGINT NOT NULL,
    sent BIGINT NOT NULL DEFAULT 0,
    read BIGINT NOT NULL DEFAULT 0
);
CREATE INDEX comment_attempt ON comment (attempt_id);
CREATE INDEX comment_author ON comment (author_id);

CREATE TRIGGER comment_is_fixed BEFORE UPDATE OF text, time_s, author_id, attempt_id, sent ON comment WHEN OLD.sent <> 0
BEGIN SELECT RAISE(ABORT, 'a comment that was sent is never changed'); END;

CREATE TABLE correction_request (
    id TEXT PRIMARY KEY,
    attempt_id TEXT NOT NULL REFERENCES attempt (id),
    person_id TEXT NOT NULL REFERENCES person (id),
    text TEXT NOT NULL,
    asked BIGINT NOT NULL
);
CREATE INDEX correction_request_attempt ON correction_request (attempt_id);
