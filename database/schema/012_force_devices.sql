-- SPDX-License-Identifier: GPL-3.0-or-later
-- What the hands' devices could render, and the force scale that was chosen: JSON, a key for each hand whose device
-- rendered force ("left", "right"); '' where none did, and for attempts from before this step.

ALTER TABLE attempt ADD COLUMN force_devices TEXT NOT NULL DEFAULT '';
