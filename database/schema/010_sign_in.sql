-- SPDX-License-Identifier: GPL-3.0-or-later
-- Waiting after wrong tries and the life of one-time passwords are also measured by the time since the machine
-- was started, which nobody can set: `boot` is the start it belongs to, `boot_ms` the time since then.

DROP TABLE sign_in_wait;
CREATE TABLE sign_in_wait (
    login_key TEXT PRIMARY KEY,
    wrong_tries INTEGER NOT NULL,
    last_try BIGINT NOT NULL,
    boot TEXT NOT NULL,
    boot_ms BIGINT NOT NULL
);

ALTER TABLE credential ADD COLUMN boot TEXT NOT NULL DEFAULT '';
ALTER TABLE credential ADD COLUMN boot_ms BIGINT NOT NULL DEFAULT 0;
