-- SPDX-License-Identifier: GPL-3.0-or-later
-- Who records a running attempt: its lock is found by this row, not by the path under which the store happens
-- to be opened. `boot`: the machine start at which it began; a lock does not outlive it.

CREATE TABLE recording (
    attempt_id TEXT PRIMARY KEY REFERENCES attempt (id),
    lock_file TEXT NOT NULL,
    inode BIGINT NOT NULL,
    boot TEXT NOT NULL
);

CREATE TRIGGER trace_chunk_of_running BEFORE INSERT ON trace_chunk
WHEN (SELECT state FROM attempt WHERE id = NEW.attempt_id) <> 'running'
BEGIN SELECT RAISE(ABORT, 'an attempt that has ended takes no more of a trace'); END;
CREATE TRIGGER attempt_product_of_running BEFORE INSERT ON attempt_product
WHEN (SELECT state FROM attempt WHERE id = NEW.attempt_id) <> 'running'
BEGIN SELECT RAISE(ABORT, 'an attempt that has ended takes no more products'); END;
