-- SPDX-License-Identifier: GPL-3.0-or-later
-- Moves of people from one version of a curriculum to another. Before the first move a person follows the
-- version that the first attempt names (attempt.curriculum). Added, never changed.

CREATE TABLE curriculum_move (
    id TEXT PRIMARY KEY,
    person_id TEXT NOT NULL REFERENCES person (id),
    curriculum TEXT NOT NULL CHECK (curriculum <> ''),
    author_id TEXT NOT NULL REFERENCES person (id),
    time BIGINT NOT NULL,
    reason TEXT NOT NULL CHECK (reason <> '')
);
CREATE INDEX curriculum_move_person ON curriculum_move (person_id, time);

CREATE TRIGGER curriculum_move_is_fixed BEFORE UPDATE ON curriculum_move
BEGIN SELECT RAISE(ABORT, 'a move to another curriculum is never changed'); END;
CREATE TRIGGER curriculum_move_is_kept BEFORE DELETE ON curriculum_move
BEGIN SELECT RAISE(ABORT, 'a move to another curriculum is never deleted'); END;
