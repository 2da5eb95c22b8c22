// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/enrolment_proof.h"

#include "database/rows/connection.h"
#include "database/schema/server_version.h"
#include "database/store/station_key.h"

namespace fulcrum::database {
namespace {

// Two scalars times their points in one run over the bits, in extended coordinates of the curve
// -x^2 + y^2 = 1 + d x^2 y^2 over the numbers modulo p. Values may be negative; only those that are compared
// are brought into 0 ... p - 1.
const char* const ed25519_function = R"(
CREATE OR REPLACE FUNCTION ed25519_holds(public_half bytea, message bytea, signature bytea) RETURNS boolean
    LANGUAGE plpgsql IMMUTABLE STRICT SET search_path = public, pg_temp AS $$
DECLARE
    p CONSTANT numeric := 57896044618658097711785492504343953926634992332820282019728792003956564819949;
    size_of_group CONSTANT numeric := 7237005577332262213973186563042994240857116359379907606001950938285454250989;
    d CONSTANT numeric := 37095705934669439343138083508754565189542113879843219016388785533085940283555;
    two_d CONSTANT numeric := 16295367250680780974490674513165176452449235426866156013048779062215315747161;
    root CONSTANT numeric := 19681161376707505956807079304988542015446066515923890162744021073123829784752;
    base_x CONSTANT numeric := 15112221349535400772501151409588531511454012693041857206046113283949847762202;
    base_y CONSTANT numeric := 46316835694926478169428394003475163141307993866256225615783033603165251855960;
    key_x numeric; key_y numeric := 0; key_sign int; share numeric := 0; point_y numeric := 0; point_sign int;
    digest bytea; hash numeric := 0; hash_bits bit(256) := 0::bit(256); share_bits bit(256) := 0::bit(256);
    u numeric; v numeric; v3 numeric; power numeric; base numeric;
    x numeric; y numeric; z numeric; t numeric; a numeric; b numeric; c numeric; e numeric; f numeric;
    g numeric; h numeric; other_x numeric; other_y numeric; half numeric;
BEGIN
    IF length(public_half) <> 32 OR length(signature) <> 64 THEN RETURN false; END IF;
    FOR i IN REVERSE 31..0 LOOP
        key_y := key_y * 256 + get_byte(public_half, i);
        point_y := point_y * 256 + get_byte(signature, i);
        share := share * 256 + get_byte(signature, 32 + i);
    END LOOP;
    key_sign := get_byte(public_half, 31) / 128;
    point_sign := get_byte(signature, 31) / 128;
    key_y := key_y - key_sign * (p + 19);
    point_y := point_y - point_sign * (p + 19);
    IF share >= size_of_group OR key_y >= p THEN RETURN false; END IF;
    digest := sha512(substring(signature FROM 1 FOR 32) || public_half || message);
    FOR i IN REVERSE 63..0 LOOP hash := hash * 256 + get_byte(digest, i); END LOOP;
    hash := hash % size_of_group;
    -- x of the key: the root of u / v, where there is one.
    u := (key_y * key_y - 1) % p;
    v := (d * (key_y * key_y % p) + 1) % p;
    v3 := (v * v % p) * v % p;
    base := (u * v3 % p) * (v3 * v % p) % p;
    power := 1;
    FOR i IN REVERSE 251..0 LOOP  -- (p - 5) / 8
        power := power * power % p;
        IF i <> 1 THEN power := power * base % p; END IF;
    END LOOP;
    key_x := (u * v3 % p) * power % p;
    half := v * (key_x * key_x % p);
    IF (half - u) % p <> 0 THEN
        IF (half + u) % p <> 0 THEN RETURN false; END IF;
        key_x := key_x * root;
    END IF;
    key_x := ((key_x % p) + p) % p;
    IF key_x = 0 AND key_sign = 1 THEN RETURN false; END IF;
    IF key_x % 2 <> key_sign THEN key_x := p - key_x; END IF;
    key_x := p - key_x;  -- the key's point is taken away
    half := hash;
    FOR i IN 0..252 LOOP
        IF half % 2 = 1 THEN hash_bits := set_bit(hash_bits, i, 1); END IF;
        half := div(half, 2);
        IF get_byte(signature, 32 + i / 8) >> (i % 8) & 1 = 1 THEN share_bits := set_bit(share_bits, i, 1); END IF;
    END LOOP;
    x := key_x; y := key_y; z := 1; t := x * y % p;
    FOR i IN REVERSE 255..0 LOOP
        a := x * x % p;
        b := y * y % p;
        h := a + b;
        e := h - (x + y) * (x + y) % p;
        g := a - b;
        f := 2 * (z * z % p) + g;
        x := e * f % p; y := g * h % p; z := f * g % p; t := e * h % p;
        CONTINUE WHEN i > 253;
        IF i = 253 THEN
            -- Eight times the key: nothing where its order is small, and everybody can sign for such a key.
            IF x = 0 THEN RETURN false; END IF;
            x := 0; y := 1; z := 1; t := 0;
            CONTINUE;
        END IF;
        FOR which IN 1..2 LOOP
            IF which = 1 THEN
                CONTINUE WHEN get_bit(share_bits, i) = 0;
                other_x := base_x; other_y := base_y;
            ELSE
                CONTINUE WHEN get_bit(hash_bits, i) = 0;
                other_x := key_x; other_y := key_y;
            END IF;
            a := (y - x) * (other_y - other_x) % p;
            b := (y + x) * (other_y + other_x) % p;
            c := (t * two_d % p) * (other_x * other_y % p) % p;
            e := b - a; f := 2 * z - c; g := 2 * z + c; h := b + a;
            x := e * f % p; y := g * h % p; z := f * g % p; t := e * h % p;
        END LOOP;
    END LOOP;
    power := 1;
    FOR i IN REVERSE 254..0 LOOP  -- p - 2
        power := power * power % p;
        IF i <> 2 AND i <> 4 THEN power := power * z % p; END IF;
    END LOOP;
    x := ((x * power % p) + p) % p;
    y := ((y * power % p) + p) % p;
    RETURN y = point_y AND x % 2 = point_sign;
END $$;
)";

const char* const statement_heading = "fulcrum enrolment 1";

Sentence not_proved(const KeptProof& kept) {
    return {QT_TRANSLATE_NOOP("errors",
                              "station %1: what the server keeps of its enrolment is not signed by the key "
                              "%2, with which it was enrolled: end its access (`fulcrum server withdraw "
                              "%1`), and find out who could write into the server's tables"),
            kept.station_id, key_fingerprint(kept.public_half)};
}

Sentence not_asked(const KeptProof& kept) {
    return {QT_TRANSLATE_NOOP("errors",
                              "station %1: was enrolled before stations proved that they hold their key "
                              "(%2); enrol it again with a new token"),
            kept.station_id, key_fingerprint(kept.public_half)};
}

}  // namespace

std::string enrolment_statement(const std::string& server_id, const std::string& token_id,
                                const std::string& station_id, const Bytes& public_half,
                                const std::string& verifier) {
    return std::string(statement_heading) + "\nserver " + server_id + "\ntoken " + token_id + "\nstation " +
           station_id + "\nkey " + to_hex(public_half) + "\npassword " + sha256_hex(verifier);
}

bool server_asks_for_proof(Connection& server) {
    Query row(server, "SELECT 1 FROM pg_proc WHERE proname = 'enrol_station' AND pronargs = 5");
    return row.next();
}

const char* signature_function() {
    return ed25519_function;
}

Proof look_at_proof(const std::string& server_id, const KeptProof& kept) {
    if (kept.statement.empty() && kept.signature.empty()) return Proof::not_asked;
    // All but the password, of which the server keeps what it was signed with.
    const std::string own =
        enrolment_statement(server_id, kept.token_id, kept.station_id, kept.public_half, {});
    const std::size_t before_password = own.rfind(' ') + 1;
    const bool is_own = kept.statement.size() == own.size() &&
                        kept.statement.compare(0, before_password, own, 0, before_password) == 0;
    return is_own && enrolment_signature_holds(kept.public_half, kept.statement, kept.signature)
               ? Proof::holds
               : Proof::broken;
}

void check_proofs(Connection& server, std::vector<Sentence>& problems, std::vector<Sentence>& notes) {
    const std::string server_id = require_server(server);
    const bool asks = server_asks_for_proof(server);
    Query rows(server, QString("SELECT id, station_id, public_half, %1 FROM enrolment WHERE used IS NOT NULL "
                               "AND withdrawn IS NULL ORDER BY station_id")
                           .arg(asks ? "COALESCE(statement, ''), COALESCE(signature, '')" : "'', ''"));
    while (rows.next()) {
        KeptProof kept{rows.text(0), rows.text(1), rows.text(3), rows.bytes(2), rows.bytes(4)};
        const Proof proof = look_at_proof(server_id, kept);
        if (proof == Proof::broken) problems.push_back(not_proved(kept));
        if (proof == Proof::not_asked) notes.push_back(not_asked(kept));
    }
}

}  // namespace fulcrum::database
