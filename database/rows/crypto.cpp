// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/rows/crypto.h"

#include <sodium.h>

#include <array>
#include <cctype>
#include <fstream>
#include <stdexcept>

#include "sim_core/numerics/worded_error.h"

namespace fulcrum::database {
namespace {

void ready() {
    static const int outcome = sodium_init();
    if (outcome < 0) throw std::runtime_error("libsodium cannot start");
}

std::string grouped_code(int characters, const char* alphabet) {
    ready();
    std::string code;
    for (int i = 0; i < characters; ++i) {
        if (i > 0 && i % 4 == 0) code += '-';
        code += alphabet[randombytes_uniform(32)];
    }
    return code;
}

}  // namespace

Bytes random_bytes(std::size_t count) {
    ready();
    Bytes bytes(count);
    randombytes_buf(bytes.data(), count);
    return bytes;
}

namespace {

struct KeyPair {
    std::array<unsigned char, crypto_sign_PUBLICKEYBYTES> open{};
    std::array<unsigned char, crypto_sign_SECRETKEYBYTES> secret{};
    explicit KeyPair(const Bytes& seed) {
        ready();
        if (seed.size() != crypto_sign_SEEDBYTES) throw std::invalid_argument("a seed has 32 bytes");
        crypto_sign_seed_keypair(open.data(), secret.data(), seed.data());
    }
    KeyPair(const KeyPair&) = delete;
    KeyPair& operator=(const KeyPair&) = delete;
    ~KeyPair() { sodium_memzero(secret.data(), secret.size()); }
};

}  // namespace

Bytes public_half_of(const Bytes& seed) {
    const KeyPair pair(seed);
    return {pair.open.begin(), pair.open.end()};
}

Bytes sign(const Bytes& seed, const Bytes& message) {
    const KeyPair pair(seed);
    Bytes signature(crypto_sign_BYTES);
    crypto_sign_detached(signature.data(), nullptr, message.data(), message.size(), pair.secret.data());
    return signature;
}

bool signature_holds(const Bytes& public_half, const Bytes& message, const Bytes& signature) {
    ready();
    return public_half.size() == crypto_sign_PUBLICKEYBYTES && signature.size() == crypto_sign_BYTES &&
           crypto_sign_verify_detached(signature.data(), message.data(), message.size(),
                                       public_half.data()) == 0;
}

std::string random_uuid() {
    Bytes bytes = random_bytes(16);
    bytes[6] = static_cast<std::uint8_t>((bytes[6] & 0x0fU) | 0x40U);
    bytes[8] = static_cast<std::uint8_t>((bytes[8] & 0x3fU) | 0x80U);
    std::string text = to_hex(bytes);
    for (const std::size_t place : {20U, 16U, 12U, 8U}) text.insert(place, 1, '-');
    return text;
}

Bytes blake2b(const void* data, std::size_t length, std::size_t size) {
    ready();
    Bytes digest(size);
    crypto_generichash(digest.data(), size, static_cast<const unsigned char*>(data), length, nullptr, 0);
    return digest;
}

Bytes blake2b(const Bytes& data, std::size_t size) {
    return blake2b(data.data(), data.size(), size);
}

std::string to_hex(const Bytes& bytes) {
    static constexpr char digits[] = "0123456789abcdef";
    std::string text;
    text.reserve(bytes.size() * 2);
    for (const std::uint8_t byte : bytes) {
        text += digits[byte >> 4U];
        text += digits[byte & 15U];
    }
    return text;
}

Bytes from_hex(const std::string& text) {
    const auto digit = [](char c) {
        return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
    };
    Bytes bytes;
    if (text.size() % 2 != 0) return bytes;
    for (std::size_t i = 0; i < text.size(); i += 2) {
        const int high = digit(text[i]), low = digit(text[i + 1]);
        if (high < 0 || low < 0) return {};
        bytes.push_back(static_cast<std::uint8_t>(16 * high + low));
    }
    return bytes;
}

std::string text_digest(const std::string& text) {
    return to_hex(blake2b(text.data(), text.size(), 32));
}

std::string sha256_hex(const std::string& text) {
    ready();
    Bytes digest(crypto_hash_sha256_BYTES);
    crypto_hash_sha256(digest.data(), reinterpret_cast<const unsigned char*>(text.data()), text.size());
    return to_hex(digest);
}

const std::string& program_digest() {
    static const std::string digest = [] {
        ready();
        std::ifstream program("/proc/self/exe", std::ios::binary);
        if (!program) return std::string();
        crypto_hash_sha256_state state;
        crypto_hash_sha256_init(&state);
        std::vector<char> block(std::size_t{1} << 16U);
        while (program) {
            program.read(block.data(), static_cast<std::streamsize>(block.size()));
            crypto_hash_sha256_update(&state, reinterpret_cast<const unsigned char*>(block.data()),
                                      static_cast<unsigned long long>(program.gcount()));
        }
        if (program.bad()) return std::string();
        Bytes bytes(crypto_hash_sha256_BYTES);
        crypto_hash_sha256_final(&state, bytes.data());
        return to_hex(bytes);
    }();
    return digest;
}

namespace {

Bytes hmac_sha256(const Bytes& key, const Bytes& message) {
    crypto_auth_hmacsha256_state state;
    Bytes result(crypto_auth_hmacsha256_BYTES);
    crypto_auth_hmacsha256_init(&state, key.data(), key.size());
    crypto_auth_hmacsha256_update(&state, message.data(), message.size());
    crypto_auth_hmacsha256_final(&state, result.data());
    return result;
}

std::string base64(const Bytes& bytes) {
    std::string text(sodium_base64_encoded_len(bytes.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
    sodium_bin2base64(text.data(), text.size(), bytes.data(), bytes.size(), sodium_base64_VARIANT_ORIGINAL);
    text.pop_back();  // its end
    return text;
}

}  // namespace

std::string scram_verifier(const std::string& password) {
    ready();
    constexpr int rounds = 4096;  // as the server itself does
    const Bytes key(password.begin(), password.end()), salt = random_bytes(16);
    const auto keyed = [](const Bytes& salted, const std::string& use) {
        return hmac_sha256(salted, Bytes(use.begin(), use.end()));
    };
    Bytes block = salt;
    block.insert(block.end(), {0, 0, 0, 1});
    block = hmac_sha256(key, block);
    Bytes salted = block;
    for (int round = 1; round < rounds; ++round) {
        block = hmac_sha256(key, block);
        for (std::size_t i = 0; i < salted.size(); ++i) salted[i] ^= block[i];
    }
    const Bytes client = keyed(salted, "Client Key");
    Bytes stored(crypto_hash_sha256_BYTES);
    crypto_hash_sha256(stored.data(), client.data(), client.size());
    return "SCRAM-SHA-256$" + std::to_string(rounds) + ":" + base64(salt) + "$" + base64(stored) + ":" +
           base64(keyed(salted, "Server Key"));
}

std::string make_verifier(const std::string& secret) {
    ready();
    char verifier[crypto_pwhash_STRBYTES];
    if (crypto_pwhash_str_alg(verifier, secret.data(), secret.size(), crypto_pwhash_OPSLIMIT_INTERACTIVE,
                              crypto_pwhash_MEMLIMIT_INTERACTIVE, crypto_pwhash_ALG_ARGON2ID13) != 0) {
        throw WordedError(QT_TRANSLATE_NOOP(
            "errors",
            "there is not enough memory to protect a password (64 MiB are needed); close other programs"));
    }
    return verifier;
}

bool verify_secret(const std::string& verifier, const std::string& secret) {
    ready();
    // The function reads STRBYTES of a terminated string; a verifier of another length is not one of ours.
    if (verifier.size() >= crypto_pwhash_STRBYTES) return false;
    char stored[crypto_pwhash_STRBYTES] = {};
    verifier.copy(stored, verifier.size());
    return crypto_pwhash_str_verify(stored, secret.data(), secret.size()) == 0;
}

bool verify_nothing(const std::string& secret) {
    return verify_secret(nobodys_verifier, secret) && false;
}

std::string make_recovery_code() {
    return grouped_code(24, "ABCDEFGHJKLMNPQRSTUVWXYZ23456789");
}

std::string normalise_recovery_code(const std::string& typed) {
    std::string code;
    for (const char c : typed) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
            code += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
        }
    }
    return code;
}

std::string make_one_time_password() {
    return grouped_code(12, "abcdefghijkmnpqrstuvwxyz23456789");
}

}  // namespace fulcrum::database
