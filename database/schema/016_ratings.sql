-- SPDX-License-Identifier: GPL-3.0-or-later
-- Observer forms that raters filled in for attempts. A draft (handed_in = 0) is its rater's alone; what was handed in
-- is never changed. Each rating keeps the text of its form, by its BLAKE2b-256, so that a file that is edited or
-- removed later changes nothing. blinding: 'not_asked' (the form does not ask for it), 'kept', 'lifted' (the rater saw
-- name or score, or could have). A value that is NULL: the item was not seen. rating_seen: who opened an attempt with
-- name and score.

CREATE TABLE form_text (
    digest TEXT PRIMARY KEY,
    text TEXT NOT NULL
);
CREATE TABLE rating (
    id TEXT PRIMARY KEY,
    attempt_id TEXT NOT NULL REFERENCES attempt (id),
    rater_id TEXT NOT NULL REFERENCES person (id),
    form TEXT NOT NULL CHECK (form <> ''),
    form_digest TEXT NOT NULL REFERENCES form_text (digest),
    blinding TEXT NOT NULL CHECK (blinding IN ('not_asked', 'kept', 'lifted')),
    begun BIGINT NOT NULL,
    handed_in BIGINT NOT NULL DEFAULT 0,
    remark TEXT NOT NULL DEFAULT ''
);
CREATE INDEX rating_attempt ON rating (attempt_id, handed_in);
CREATE TABLE rating_item (
    rating_id TEXT NOT NULL REFERENCES rating (id),
    number INTEGER NOT NULL CHECK (number >= 0),
    item TEXT NOT NULL CHECK (item <> ''),
    value INTEGER CHECK (value BETWEEN 0 AND 100),
    PRIMARY KEY (rating_id, number)
);
CREATE TABLE rating_release (
    rating_id TEXT PRIMARY KEY REFERENCES rating (id),
    person_id TEXT NOT NULL REFERENCES person (id),
    time BIGINT NOT NULL
);
CREATE TABLE rating_seen (
    attempt_id TEXT NOT NULL REFERENCES attempt (id),
    person_id TEXT NOT NULL REFERENCES person (id),
    time BIGINT NOT NULL,
    PRIMARY KEY (attempt_id, person_id)
);

CREATE TRIGGER form_text_is_fixed BEFORE UPDATE ON form_text
BEGIN SELECT RAISE(ABORT, 'the form of a rating is never changed'); END;
CREATE TRIGGER form_text_is_kept BEFORE DELETE ON form_text
BEGIN SELECT RAISE(ABORT, 'the form of a rating is never deleted'); END;
CREATE TRIGGER rating_is_fixed BEFORE UPDATE ON rating WHEN OLD.handed_in > 0
BEGIN SELECT RAISE(ABORT, 'a form that was handed in is never changed'); END;
CREATE TRIGGER rating_is_kept BEFORE DELETE ON rating WHEN OLD.handed_in > 0
BEGIN SELECT RAISE(ABORT, 'a form that was handed in is never deleted'); END;
CREATE TRIGGER rating_item_is_fixed BEFORE UPDATE ON rating_item
BEGIN SELECT RAISE(ABORT, 'an answer is replaced, never changed'); END;
CREATE TRIGGER rating_item_is_kept BEFORE DELETE ON rating_item
WHEN (SELECT handed_in FROM rating WHERE id = OLD.rating_id) > 0
BEGIN SELECT RAISE(ABORT, 'a form that was handed in is never changed'); END;
CREATE TRIGGER rating_item_is_in_time BEFORE INSERT ON rating_item
WHEN (SELECT handed_in FROM rating WHERE id = NEW.rating_id) > 0
BEGIN SELECT RAISE(ABORT, 'a form that was handed in is never changed'); END;
CREATE TRIGGER rating_release_is_fixed BEFORE UPDATE ON rating_release
BEGIN SELECT RAISE(ABORT, 'a release is never changed'); END;
CREATE TRIGGER rating_release_is_kept BEFORE DELETE ON rating_release
BEGIN SELECT RAISE(ABORT, 'a release is never deleted'); END;
