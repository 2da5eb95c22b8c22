// SPDX-License-Identifier: GPL-3.0-or-later
// The tests of the store and of the window protect passwords at the lowest cost that Argon2id knows: a test
// makes some 25 passwords, at 0.1 to 0.2 s of processor time each. The programs themselves keep the full
// cost.
#pragma once

#include <cstddef>

namespace fulcrum::database::test {

/// What the store last asked of the password hash; 0 before it did.
struct PasswordCost {
    unsigned long long operations = 0;
    std::size_t memory = 0;  ///< bytes
};
PasswordCost asked_password_cost();
/// How many hashes were made so far.
unsigned long long password_hashes_made();

}  // namespace fulcrum::database::test
