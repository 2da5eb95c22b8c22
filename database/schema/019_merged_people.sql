-- SPDX-License-Identifier: GPL-3.0-or-later
-- A person who was entered twice: the doubled row stays, so that what is signed under its id stays as it was signed, and
-- names the person it belongs to. '': belongs to itself. One step: a row that is merged is nobody's target
-- (database/rows/same_person.h).

ALTER TABLE person ADD COLUMN merged_into TEXT NOT NULL DEFAULT '';
CREATE INDEX person_merged_into ON person (merged_into);
