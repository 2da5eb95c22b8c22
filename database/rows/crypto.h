// SPDX-License-Identifier: GPL-3.0-or-later
// Random ids and codes, digests, password verifiers: thin names over libsodium. Any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace fulcrum::database {

using Bytes = std::vector<std::uint8_t>;

/// Random UUID (version 4), lower case.
std::string random_uuid();
Bytes random_bytes(std::size_t count);
/// BLAKE2b of `size` bytes (16 to 64).
Bytes blake2b(const void* data, std::size_t length, std::size_t size);
Bytes blake2b(const Bytes& data, std::size_t size = 32);
std::string to_hex(const Bytes& bytes);
/// Of lower case digits; empty where it is not that.
Bytes from_hex(const std::string& text);
/// BLAKE2b-256 of a text, hex.
std::string text_digest(const std::string& text);

/// SHA-256 of a text, hex, as `sha256sum` prints it for a file.
std::string sha256_hex(const std::string& text);
/// The same of the file of this program; empty where it cannot be read. Read once.
const std::string& program_digest();

/// Ed25519. The seed (32 bytes) is the secret half; a signature has 64 bytes.
Bytes public_half_of(const Bytes& seed);
Bytes sign(const Bytes& seed, const Bytes& message);
bool signature_holds(const Bytes& public_half, const Bytes& message, const Bytes& signature);

/// Argon2id, interactive limits (64 MiB, about 0.1 s).
std::string make_verifier(const std::string& secret);
bool verify_secret(const std::string& verifier, const std::string& secret);
/// Of a secret that nobody knows, at the cost of make_verifier(): ready from the start, so that a program's
/// first wrong try with an unknown login takes no longer than with a known one.
inline constexpr char nobodys_verifier[] =
    "$argon2id$v=19$m=65536,t=2,p=1$oKnGHLxqEMkp0j3yWp2mZA$2f8q0cB6Hk3vEwXz1mJpQyTnRsUoLaKdGhFiVbNcMeY";
/// What PostgreSQL keeps of an account's password (SCRAM-SHA-256), so that a server is never sent the
/// password itself and cannot write it into its log. `password`: of ASCII characters.
std::string scram_verifier(const std::string& password);
/// Takes as long as a verification and fails: a login that does not exist answers as slowly as one that does.
bool verify_nothing(const std::string& secret);

/// 24 characters of 5 bits in groups of four, without letters that look alike.
std::string make_recovery_code();
/// Upper case, without separators: what is hashed and compared.
std::string normalise_recovery_code(const std::string& typed);
/// 12 characters in groups of four (60 bits).
std::string make_one_time_password();

}  // namespace fulcrum::database
