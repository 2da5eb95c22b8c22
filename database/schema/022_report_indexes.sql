-- SPDX-License-Identifier: GPL-3.0-or-later
-- What the table of a cohort asks of each attempt, from the index alone: its score in force, and whether one of that
-- score's gates was provisional.

CREATE INDEX score_in_force ON score (attempt_id, in_force, passed, points, not_scored_because, id) WHERE in_force = 1;
CREATE INDEX gate_provisional ON gate (score_id) WHERE provisional = 1;
