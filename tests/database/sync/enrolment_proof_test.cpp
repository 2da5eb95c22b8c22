// SPDX-License-Identifier: GPL-3.0-or-later
// A station proves that it holds its signing key before the server makes its account.
#include "database/sync/enrolment_proof.h"

#include "database/store/station_key.h"
#include "database/sync/enrolment.h"
#include "database/sync/enrolment_token.h"
#include "database/sync/server_enrolment.h"
#include "database/sync/server_link.h"
#include "tests/database/station_keys.h"
#include "tests/database/sync/stations.h"

namespace fulcrum::database::test {
namespace {

class EnrolmentProofs : public Sync {
  protected:
    const KeysOfOneTest keys;
    std::string token() const { return make_enrolment_token(server, "lab", {}, usual_token_h).text; }
    void enrol(const std::string& with) const {
        enrol_station(*a.store, a.session("administrator"), server, with);
    }
    std::string server_id() const {
        Connection owner(server);
        Query row(owner, "SELECT id FROM programme_server");
        return row.next() ? row.text(0) : std::string();
    }
    /// What the server answers to whoever has a token and writes the call by hand.
    std::string answer(const std::string& with, const std::string& station, const Bytes& key,
                       const std::string& verifier, const Bytes& signature) const {
        const EnrolmentToken token = EnrolmentToken::parse(with);
        ServerAddress asking = server;
        asking.user = token.account();
        Connection connection(asking, false, token.password());
        Query row(connection, "SELECT answer FROM enrol_station(?, ?, ?, ?, ?)");
        row.bind(token.proof()).bind(station).bind(key).bind(verifier);
        if (signature.empty())
            row.bind_null();
        else
            row.bind(signature);
        return row.next() ? row.text(0) : std::string();
    }
    void sql(const std::string& text) const { PostgresqlServer::of_this_process()->execute(server, text); }
};

Bytes bytes_of(const std::string& text) {
    return {text.begin(), text.end()};
}

TEST_F(EnrolmentProofs, TheServersVerificationIsThatOfLibsodium) {
    Connection owner(server);
    const auto on_server = [&](const Bytes& key, const Bytes& message, const Bytes& signature) {
        Query row(owner, "SELECT ed25519_holds(?, ?, ?)");
        row.bind(key).bind(message).bind(signature);
        return row.next() && row.flag(0);
    };
    const auto same = [&](const Bytes& key, const Bytes& message, const Bytes& signature, bool expected) {
        EXPECT_EQ(signature_holds(key, message, signature), expected)
            << to_hex(key) << ' ' << to_hex(signature);
        EXPECT_EQ(on_server(key, message, signature), expected) << to_hex(key) << ' ' << to_hex(signature);
    };
    const auto flipped = [](Bytes bytes, std::size_t bit) {
        bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] ^ (1U << (bit % 8)));
        return bytes;
    };
    for (std::size_t k = 0; k < 4; ++k) {
        const Bytes seed = random_bytes(32), key = public_half_of(seed), message = random_bytes(1 + 31 * k),
                    signature = sign(seed, message);
        same(key, message, signature, true);
        same(key, flipped(message, 8 * k + k), signature, false);
        same(key, message, flipped(signature, 37 * k), false);        // the point
        same(key, message, flipped(signature, 256 + 29 * k), false);  // the number
        same(key, message, flipped(signature, 255), false);           // the sign of the point
        same(flipped(key, 31 * k), message, signature, false);
        same(key, message, Bytes(signature.begin(), signature.end() - 1), false);
    }
    // The number plus the order of the group fits the equation too, and is refused.
    const Bytes seed(32, 7), key = public_half_of(seed), message = bytes_of("message");
    Bytes other = sign(seed, message);
    const Bytes order = from_hex("edd3f55c1a631258d69cf7a2def9de1400000000000000000000000000000010");
    unsigned carry = 0;
    for (std::size_t i = 0; i < 32; ++i) {
        carry += other[32 + i] + order[i];
        other[32 + i] = static_cast<std::uint8_t>(carry & 255U);
        carry >>= 8U;
    }
    same(key, message, other, false);
    // Keys of small order, for which everybody can sign; and one that is no point, and one beyond p.
    Bytes nothing(64, 0);
    nothing[0] = 1;
    for (const char* small : {"0100000000000000000000000000000000000000000000000000000000000000",
                              "ecffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff7f",
                              "0000000000000000000000000000000000000000000000000000000000000000",
                              "0000000000000000000000000000000000000000000000000000000000000080",
                              "26e8958fc2b227b045c3f489f2ef98f0d5dfac05d3c63339b13802886d53fc05",
                              "c7176a703d4dd84fba3c0b760d10670f2a2053fa2c39ccc64ec7fd7792ac03fa",
                              "0200000000000000000000000000000000000000000000000000000000000000",
                              "eeffffffffffffffffffffffffffffffffffffffffffffffffffffffffffff7f"})
        same(from_hex(small), message, nothing, false);
}

TEST_F(EnrolmentProofs, WhoeverDoesNotHoldTheKeyIsRefusedAndTheTokenStaysGood) {
    enrol(token());
    const ServerLink before = *ServerLink::of(a.store->station_id());
    const Bytes key = StationKey::existing(a.store->station_id())->public_half();
    const std::string with = token(), id = EnrolmentToken::parse(with).id, station = a.store->station_id(),
                      verifier = scram_verifier("chosen by somebody else");
    const Bytes other_seed = random_bytes(32), other_key = public_half_of(other_seed);
    const auto signed_by_other = [&](const std::string& statement) {
        return sign(other_seed, bytes_of(statement));
    };
    const auto own = [&](const std::string& at, const std::string& token_id, const std::string& of) {
        return StationKey::existing(station)->sign_enrolment(
            enrolment_statement(at, token_id, of, key, verifier));
    };
    // The key of the station, which anyone can know, with a signature of another one, or with none.
    EXPECT_EQ(answer(with, station, key, verifier,
                     signed_by_other(enrolment_statement(server_id(), id, station, key, verifier))),
              "no_proof");
    EXPECT_EQ(answer(with, station, key, verifier, {}), "no_proof");
    // What the station has signed before, for another token, server, station or password.
    Bytes kept;
    {
        Connection owner(server);
        Query row(owner, "SELECT signature FROM enrolment WHERE used IS NOT NULL");
        ASSERT_TRUE(row.next());
        kept = row.bytes(0);
    }
    EXPECT_EQ(answer(with, station, key, verifier, kept), "no_proof");
    EXPECT_EQ(answer(with, station, key, verifier, own(server_id(), "0123456789", station)), "no_proof");
    EXPECT_EQ(answer(with, station, key, verifier, own(random_uuid(), id, station)), "no_proof");
    EXPECT_EQ(answer(with, station, key, verifier, own(server_id(), id, random_uuid())), "no_proof");
    EXPECT_EQ(answer(with, station, key, scram_verifier("another"), own(server_id(), id, station)),
              "no_proof");
    // A signature of an audit row is none of an enrolment.
    EXPECT_EQ(answer(with, station, key, verifier,
                     StationKey::existing(station)->sign(
                         bytes_of(enrolment_statement(server_id(), id, station, key, verifier)))),
              "no_proof");
    // Nobody took the station's account away, the log has every try, and the token is still good.
    EXPECT_NO_THROW(Connection(before.address, false, before.password));
    EXPECT_EQ(ServerLink::of(station)->password, before.password);
    {
        Connection owner(server);
        Query row(owner,
                  "SELECT COUNT(*) FROM server_log WHERE operation = 'enrolment.refuse' AND detail = "
                  "'no_proof'");
        EXPECT_TRUE(row.next() && row.integer(0) == 8);
    }
    enrol(with);
    EXPECT_TRUE(check_programme_server(server).problems.empty());
    // And a key of one's own does not help with the name of another station.
    EXPECT_EQ(answer(token(), station, other_key, verifier, {}), "other_key");
}

TEST_F(EnrolmentProofs, TheServersOwnerSeesWhichStationsHaveProvedIt) {
    a.record("ann");
    enrol(token());
    sync_with_server(*a.store, a.session("administrator"), server_of(*a.store));
    const auto proof = [&] { return enrolled_stations(server).front().proof; };
    const auto problems = [&] { return check_programme_server(server).problems.size(); };
    EXPECT_EQ(proof(), Proof::holds);
    EXPECT_EQ(problems(), 0U);
    // Rows that were written by hand.
    for (const char* change :
         {"UPDATE enrolment SET signature = set_byte(signature, 5, get_byte(signature, 5) # 1)",
          "UPDATE enrolment SET signature = NULL",
          "UPDATE enrolment SET statement = replace(statement, 'token ', 'token x')",
          "UPDATE enrolment SET statement = statement || 'x'"}) {
        sql("CREATE TABLE kept AS SELECT id, statement, signature FROM enrolment");
        sql(change);
        EXPECT_EQ(proof(), Proof::broken) << change;
        EXPECT_EQ(problems(), 1U) << change;
        sql("UPDATE enrolment e SET statement = k.statement, signature = k.signature FROM kept k WHERE k.id "
            "= "
            "e.id; DROP TABLE kept");
    }
    EXPECT_EQ(proof(), Proof::holds);
    // A station from before the server asked, on a server that was upgraded, and on one that was not.
    sql("UPDATE enrolment SET statement = NULL, signature = NULL");
    EXPECT_EQ(proof(), Proof::not_asked);
    EXPECT_EQ(problems(), 0U);
    EXPECT_EQ(check_programme_server(server).notes.size(), 1U);
    sql("ALTER TABLE enrolment DROP COLUMN statement, DROP COLUMN signature; DROP FUNCTION "
        "enrol_station(text, text, bytea, text, bytea)");
    EXPECT_EQ(proof(), Proof::not_asked);
    EXPECT_EQ(check_programme_server(server).notes.size(), 1U);
    const std::string with = token();
    EXPECT_EQ(error_kind([&] { enrol(with); }), StoreErrorKind::older_schema);
    EXPECT_TRUE(sync_with_server(*a.store, a.session("administrator"), server_of(*a.store)).complete);
    create_programme_server(server);
    enrol(with);
    EXPECT_EQ(proof(), Proof::holds);
    EXPECT_EQ(check_programme_server(server).notes.size(), 0U);
}

}  // namespace
}  // namespace fulcrum::database::test
