-- SPDX-License-Identifier: GPL-3.0-or-later
-- A row that changes carries a number that rises with each change: where a station and the programme server differ,
-- the higher one counts (docs/FORMATS.md, Sync). person has one since step 1.

ALTER TABLE cohort ADD COLUMN version INTEGER NOT NULL DEFAULT 1;
ALTER TABLE programme ADD COLUMN version INTEGER NOT NULL DEFAULT 1;
