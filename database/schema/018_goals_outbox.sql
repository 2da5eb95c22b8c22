-- SPDX-License-Identifier: GPL-3.0-or-later
-- Goals that trainees set for themselves: a number of attempts a week (due_day = 0), or the value of a metric of a task
-- by a day (days since 1 January 1970, on the calendar of the place). task_id '': every task. A goal that is changed is
-- ended, and another one is set; nothing is edited. xapi_outbox: statements for a learning record store that this station
-- still has to send, has sent, or was told to look at; it stays at the station.

CREATE TABLE personal_goal (
    id TEXT PRIMARY KEY,
    person_id TEXT NOT NULL REFERENCES person (id),
    kind TEXT NOT NULL CHECK (kind IN ('attempts', 'metric')),
    task_id TEXT NOT NULL,
    metric TEXT NOT NULL,
    target DOUBLE PRECISION NOT NULL,
    due_day BIGINT NOT NULL CHECK (due_day >= 0),
    time BIGINT NOT NULL
);
CREATE INDEX personal_goal_person ON personal_goal (person_id, time);
CREATE TABLE personal_goal_end (
    goal_id TEXT PRIMARY KEY REFERENCES personal_goal (id),
    time BIGINT NOT NULL
);

CREATE TABLE xapi_outbox (
    endpoint TEXT NOT NULL CHECK (endpoint <> ''),
    id TEXT NOT NULL CHECK (id <> ''),
    person_id TEXT NOT NULL REFERENCES person (id),
    number BIGINT NOT NULL,
    statement TEXT NOT NULL,
    state TEXT NOT NULL DEFAULT 'waiting' CHECK (state IN ('waiting', 'done', 'quarantined')),
    tries INTEGER NOT NULL DEFAULT 0,
    next_try BIGINT NOT NULL DEFAULT 0,
    problem TEXT NOT NULL DEFAULT '',
    changed BIGINT NOT NULL,
    PRIMARY KEY (endpoint, id)
);
CREATE INDEX xapi_outbox_waiting ON xapi_outbox (endpoint, state, number);

CREATE TRIGGER personal_goal_is_fixed BEFORE UPDATE ON personal_goal
BEGIN SELECT RAISE(ABORT, 'a goal is never changed'); END;
CREATE TRIGGER personal_goal_is_kept BEFORE DELETE ON personal_goal
BEGIN SELECT RAISE(ABORT, 'a goal is never deleted'); END;
CREATE TRIGGER personal_goal_end_is_fixed BEFORE UPDATE ON personal_goal_end
BEGIN SELECT RAISE(ABORT, 'the end of a goal is never changed'); END;
CREATE TRIGGER personal_goal_end_is_kept BEFORE DELETE ON personal_goal_end
BEGIN SELECT RAISE(ABORT, 'the end of a goal is never deleted'); END;
