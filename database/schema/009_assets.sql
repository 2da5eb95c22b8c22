-- SPDX-License-Identifier: GPL-3.0-or-later
-- Which files an attempt was performed with, and which the programme has accepted in addition to those that the
-- program was delivered with. Digests: SHA-256 of the file, hex.

CREATE TABLE attempt_asset (
    attempt_id TEXT NOT NULL REFERENCES attempt (id),
    file TEXT NOT NULL,
    digest TEXT NOT NULL,
    PRIMARY KEY (attempt_id, file)
);

CREATE TABLE asset_acceptance (
    digest TEXT PRIMARY KEY,
    file TEXT NOT NULL,
    person_id TEXT NOT NULL REFERENCES person (id),
    time BIGINT NOT NULL,
    reason TEXT NOT NULL CHECK (reason <> '')
);

CREATE TRIGGER attempt_asset_is_fixed BEFORE UPDATE ON attempt_asset
BEGIN SELECT RAISE(ABORT, 'the files of an attempt are never changed'); END;
CREATE TRIGGER asset_acceptance_is_fixed BEFORE UPDATE ON asset_acceptance
BEGIN SELECT RAISE(ABORT, 'an acceptance is never changed'); END;
