-- SPDX-License-Identifier: GPL-3.0-or-later
-- Signatures of audit rows by the station's key (Ed25519), whose secret half is not in the store. Rows from before this step have none.

CREATE TABLE station_key (
    station_id TEXT NOT NULL REFERENCES station (id),
    public_half BLOB NOT NULL,
    PRIMARY KEY (station_id, public_half)
);
CREATE TABLE audit_signature (
    station_id TEXT NOT NULL,
    sequence BIGINT NOT NULL,
    public_half BLOB NOT NULL,
    signature BLOB NOT NULL,
    PRIMARY KEY (station_id, sequence),
    FOREIGN KEY (station_id, sequence) REFERENCES audit_entry (station_id, sequence),
    FOREIGN KEY (station_id, public_half) REFERENCES station_key (station_id, public_half)
);

CREATE TRIGGER station_key_is_fixed BEFORE UPDATE ON station_key
BEGIN SELECT RAISE(ABORT, 'a key of the station is never changed'); END;
CREATE TRIGGER station_key_stays BEFORE DELETE ON station_key
BEGIN SELECT RAISE(ABORT, 'a key of the station is never deleted'); END;
CREATE TRIGGER audit_signature_is_fixed BEFORE UPDATE ON audit_signature
BEGIN SELECT RAISE(ABORT, 'a signature is never changed'); END;
CREATE TRIGGER audit_signature_stays BEFORE DELETE ON audit_signature
BEGIN SELECT RAISE(ABORT, 'a signature is never deleted'); END;
