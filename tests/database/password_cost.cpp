// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/database/password_cost.h"

#include <sodium.h>

#include <atomic>

namespace {
std::atomic<unsigned long long> operations{0}, hashes{0};
std::atomic<std::size_t> memory{0};
}  // namespace

namespace fulcrum::database::test {
unsigned long long password_hashes_made() {
    return hashes;
}
PasswordCost asked_password_cost() {
    return {operations, memory};
}
}  // namespace fulcrum::database::test

// Takes the place of the library's function in this executable. A verifier names the cost it was made with,
// so that checking it is the library's own function, unchanged.
extern "C" int crypto_pwhash_str_alg(char out[crypto_pwhash_STRBYTES], const char* const password,
                                     unsigned long long length, unsigned long long asked_operations,
                                     std::size_t asked_memory, int algorithm) {
    operations = asked_operations;
    ++hashes;
    memory = asked_memory;
    if (algorithm != crypto_pwhash_ALG_ARGON2ID13) return -1;
    return crypto_pwhash_argon2id_str(out, password, length, crypto_pwhash_argon2id_OPSLIMIT_MIN,
                                      crypto_pwhash_argon2id_MEMLIMIT_MIN);
}
