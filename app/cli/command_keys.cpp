// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum db keys and db rotate-key: the keys that signed this station's audit log, and a new one.
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "database/store/signing_keys.h"

namespace fulcrum::app {
namespace {

using database::SigningKey;

nlohmann::json json_of_key(const SigningKey& key, bool in_use) {
    return {{"fingerprint", key.fingerprint},      {"public_half", database::to_hex(key.public_half)},
            {"announced", key.announced},          {"in_use", in_use},
            {"first_row", key.first_row},          {"last_row", key.last_row},
            {"from", database::iso_utc(key.from)}, {"until", database::iso_utc(key.until)}};
}

int keys(const Arguments& arguments) {
    database::StoreOptions options;
    options.read_only = !arguments.has("--as");  // a sign-in is recorded
    const database::Store store = database::Store::open(store_path(arguments), options);
    store.require(session_of(arguments, store), database::Operation::check_store);
    const std::vector<SigningKey> found = database::signing_keys(store.connection(), store.station_id());
    nlohmann::json list = nlohmann::json::array();
    for (const SigningKey& key : found) {
        const bool first = &key == &found.front(), in_use = &key == &found.back();
        list.push_back(json_of_key(key, in_use));
        if (arguments.has("--json")) continue;
        std::cout << key.fingerprint << "  rows " << key.first_row << " to " << key.last_row << ", "
                  << database::iso_utc(key.from) << " to " << database::iso_utc(key.until)
                  << (in_use ? ", in use" : "")
                  << (first           ? ""
                      : key.announced ? ", announced by the key before it"
                                      : ", NOT announced by the key before it")
                  << '\n';
    }
    if (arguments.has("--json")) {
        print_json({{"store", store_path(arguments)}, {"station", store.station_id()}, {"keys", list}});
    } else if (found.empty()) {
        std::cout << "no row of the audit log is signed\n";
    }
    return 0;
}

int rotate(const Arguments& arguments) {
    const auto reason = arguments.value("--reason");
    if (!reason)
        throw UsageError("--reason", QT_TRANSLATE_NOOP("errors", "is missing"),
                         QT_TRANSLATE_NOOP("errors", "say why: it is stored in the audit log"));
    const database::Store store = open_store(arguments, false);
    const SigningKey key = database::rotate_station_key(store, person_session(arguments, store), *reason);
    if (arguments.has("--json")) {
        print_json({{"store", store_path(arguments)}, {"key", json_of_key(key, true)}});
    } else {
        std::cout << "this station signs with the key " << key.fingerprint << " from audit row "
                  << key.first_row
                  << " on; keep a copy of its file, and sync, so that the programme server knows it\n";
    }
    return 0;
}

}  // namespace

std::vector<Command> key_commands() {
    Command listing{"db keys",
                    "",
                    0,
                    0,
                    "Lists the keys that signed the station's audit log, with their periods.",
                    session_options(),
                    keys};
    Command rotating{"db rotate-key",
                     "",
                     0,
                     0,
                     "Makes a new key for the station's signatures; needs --as, an administrator.",
                     joined({{"--reason", "TEXT", "Why; stored in the audit log."}}, session_options()),
                     rotate};
    rotating.details =
        "The new key signs from now on. The old one signs the row of the audit log that names the new one, "
        "then its secret half is deleted; what it signed stays valid, and nothing later is accepted from it. "
        "Rotate the key when its file may have been copied, and when somebody who could read it leaves.";
    return {listing, rotating};
}

}  // namespace fulcrum::app
