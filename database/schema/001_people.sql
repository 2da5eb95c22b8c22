-- SPDX-License-Identifier: GPL-3.0-or-later
-- Station, programme, people, sign-in, cohorts, audit chain. Times: ms since 1970 UTC. Ids: UUID text.

CREATE TABLE station (
    id TEXT PRIMARY KEY,
    name TEXT NOT NULL,
    created BIGINT NOT NULL
);

CREATE TABLE setting (
    key TEXT PRIMARY KEY,
    value TEXT NOT NULL
);

CREATE TABLE programme (
    id TEXT PRIMARY KEY,
    name TEXT NOT NULL,
    created BIGINT NOT NULL,
    recovery_verifier TEXT NOT NULL
);

CREATE TABLE person (
    id TEXT PRIMARY KEY,
    login TEXT NOT NULL,
    login_key TEXT NOT NULL UNIQUE,
    display_name TEXT NOT NULL,
    kind TEXT NOT NULL CHECK (kind IN ('real', 'synthetic', 'external')),
    active INTEGER NOT NULL DEFAULT 1 CHECK (active IN (0, 1)),
    created BIGINT NOT NULL,
    version INTEGER NOT NULL DEFAULT 1
);

CREATE TABLE person_role (
    person_id TEXT NOT NULL REFERENCES person (id),
    role TEXT NOT NULL CHECK (role IN ('trainee', 'educator', 'director', 'administrator')),
    PRIMARY KEY (person_id, role)
);

-- One row for everyone who can sign in; expires is set while the password is a one-time password.
CREATE TABLE credential (
    person_id TEXT PRIMARY KEY REFERENCES person (id),
    verifier TEXT NOT NULL,
    one_time INTEGER NOT NULL DEFAULT 0 CHECK (one_time IN (0, 1)),
    expires BIGINT,
    changed BIGINT NOT NULL,
    CHECK (one_time = 0 OR expires IS NOT NULL)
);

-- By login as typed, known or not, so that waiting tells nothing about which logins exist.
CREATE TABLE sign_in_wait (
    login_key TEXT PRIMARY KEY,
    wrong_tries INTEGER NOT NULL,
    last_wrong BIGINT NOT NULL
);

CREATE TABLE sign_in (
    person_id TEXT NOT NULL REFERENCES person (id),
    station_id TEXT NOT NULL REFERENCES station (id),
    last BIGINT NOT NULL,
    PRIMARY KEY (person_id, station_id)
);

CREATE TABLE cohort (
    id TEXT PRIMARY KEY,
    name TEXT NOT NULL UNIQUE,
    created BIGINT NOT NULL
);

CREATE TABLE cohort_member (
    cohort_id TEXT NOT NULL REFERENCES cohort (id),
    person_id TEXT NOT NULL REFERENCES person (id),
    PRIMARY KEY (cohort_id, person_id)
);
CREATE INDEX cohort_member_person ON cohort_member (person_id);

CREATE TABLE cohort_educator (
    cohort_id TEXT NOT NULL REFERENCES cohort (id),
    person_id TEXT NOT NULL REFERENCES person (id),
    PRIMARY KEY (cohort_id, person_id)
);
CREATE INDEX cohort_educator_person ON cohort_educator (person_id);

-- actor_id and object_id are no foreign keys: rows outlive what they speak of.
CREATE TABLE audit_entry (
    station_id TEXT NOT NULL REFERENCES station (id),
    sequence BIGINT NOT NULL,
    time BIGINT NOT NULL,
    actor_id TEXT NOT NULL,
    object_id TEXT NOT NULL,
    operation TEXT NOT NULL,
    digest BLOB NOT NULL,
    previous_hash BLOB NOT NULL,
    hash BLOB NOT NULL,
    PRIMARY KEY (station_id, sequence)
);
CREATE INDEX audit_entry_object ON audit_entry (object_id);

-- Apart from the chain, so that an erasure deletes what was said and keeps that something was done.
CREATE TABLE audit_payload (
    station_id TEXT NOT NULL,
    sequence BIGINT NOT NULL,
    salt BLOB NOT NULL,
    payload TEXT NOT NULL,
    PRIMARY KEY (station_id, sequence),
    FOREIGN KEY (station_id, sequence) REFERENCES audit_entry (station_id, sequence)
);

CREATE TRIGGER audit_entry_is_fixed BEFORE UPDATE ON audit_entry
BEGIN SELECT RAISE(ABORT, 'audit rows are never changed'); END;
CREATE TRIGGER audit_entry_stays BEFORE DELETE ON audit_entry
BEGIN SELECT RAISE(ABORT, 'audit rows are never deleted'); END;
