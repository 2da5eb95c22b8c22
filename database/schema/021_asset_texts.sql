-- SPDX-License-Identifier: GPL-3.0-or-later
-- What an accepted file says: of curricula and benchmark sets, so that a programme server can pass them on to other
-- stations. The digest (SHA-256 of the text) is that of the acceptance.

CREATE TABLE asset_text (
    digest TEXT PRIMARY KEY REFERENCES asset_acceptance (digest),
    text TEXT NOT NULL CHECK (text <> '')
);

CREATE TRIGGER asset_text_is_fixed BEFORE UPDATE ON asset_text
BEGIN SELECT RAISE(ABORT, 'what an accepted file says is never changed'); END;
CREATE TRIGGER asset_text_is_kept BEFORE DELETE ON asset_text
BEGIN SELECT RAISE(ABORT, 'what an accepted file says is never deleted'); END;
