-- SPDX-License-Identifier: GPL-3.0-or-later
-- What a site says of its tissues, and the scenes as attempts used them. Versions are added, never changed; a
-- version without values means the scene file's own. scene_text: digest is BLAKE2b-256 of text, hex, as
-- attempt.scene_digest; attempts from before this step have none.

CREATE TABLE tissue_setting (
    task_id TEXT NOT NULL,
    version INTEGER NOT NULL CHECK (version >= 1),
    person_id TEXT NOT NULL REFERENCES person (id),
    time BIGINT NOT NULL,
    reason TEXT NOT NULL CHECK (reason <> ''),
    PRIMARY KEY (task_id, version)
);

CREATE TABLE tissue_value (
    task_id TEXT NOT NULL,
    version INTEGER NOT NULL,
    tissue TEXT NOT NULL,
    name TEXT NOT NULL,
    value DOUBLE PRECISION NOT NULL,
    PRIMARY KEY (task_id, version, tissue, name),
    FOREIGN KEY (task_id, version) REFERENCES tissue_setting (task_id, version)
);

CREATE TABLE scene_text (
    digest TEXT PRIMARY KEY,
    text TEXT NOT NULL
);

CREATE TRIGGER tissue_setting_is_fixed BEFORE UPDATE ON tissue_setting
BEGIN SELECT RAISE(ABORT, 'tissue values are superseded, never changed'); END;
CREATE TRIGGER tissue_value_is_fixed BEFORE UPDATE ON tissue_value
BEGIN SELECT RAISE(ABORT, 'tissue values are superseded, never changed'); END;
CREATE TRIGGER scene_text_is_fixed BEFORE UPDATE ON scene_text
BEGIN SELECT RAISE(ABORT, 'a scene as it was used is never changed'); END;
