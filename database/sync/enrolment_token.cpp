// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/enrolment_token.h"

#include <cctype>
#include <cstring>

#include "database/rows/crypto.h"

namespace fulcrum::database {
namespace {

// Of a token's 25 bytes: server, id, end (seconds since 1970), secret, sum.
constexpr std::size_t server_size = 3, id_size = 5, end_size = 4, secret_size = 10, sum_size = 3;
constexpr std::size_t body_size = server_size + id_size + end_size + secret_size;
constexpr std::size_t token_size = body_size + sum_size, token_characters = token_size * 8 / 5;
constexpr std::size_t group_size = 5;
constexpr const char* token_letters = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";

Bytes sum_of(const Bytes& body) {
    const std::string use = "fulcrum enrolment token";
    Bytes message(use.begin(), use.end());
    message.insert(message.end(), body.begin(), body.end());
    const Bytes digest = blake2b(message);
    return {digest.begin(), digest.begin() + sum_size};
}

/// Five bits a character.
std::string letters_of(const Bytes& bytes) {
    std::string text;
    unsigned bits = 0;
    int count = 0;
    for (const std::uint8_t byte : bytes) {
        bits = (bits << 8) | byte;
        for (count += 8; count >= 5; count -= 5) {
            if (!text.empty() && (text.size() + 1) % (group_size + 1) == 0) text += '-';
            text += token_letters[(bits >> (count - 5)) & 31U];
        }
    }
    return text;
}

[[noreturn]] void refuse_typed(const Sentence& problem) {
    throw StoreError(StoreErrorKind::bad_value, {QT_TRANSLATE_NOOP("errors", "the token %1"), problem},
                     QT_TRANSLATE_NOOP(
                         "errors",
                         "copy it again from `fulcrum server enrol`, whole; nothing was sent, so it is still "
                         "good"));
}

Bytes bytes_of_letters(const std::string& typed) {
    Bytes bytes;
    unsigned bits = 0;
    int count = 0;
    std::size_t characters = 0;
    for (const char raw : typed) {
        char letter = static_cast<char>(std::toupper(static_cast<unsigned char>(raw)));
        if (letter == '-' || letter == ' ') continue;
        if (letter == 'O') letter = '0';
        if (letter == 'I' || letter == 'L') letter = '1';
        const char* const found = letter == '\0' ? nullptr : std::strchr(token_letters, letter);
        if (found == nullptr)
            refuse_typed(
                {QT_TRANSLATE_NOOP("errors", "contains '%1', which no token does"), std::string(1, raw)});
        ++characters;
        bits = (bits << 5) | static_cast<unsigned>(found - token_letters);
        count += 5;
        if (count < 8) continue;
        count -= 8;
        bytes.push_back(static_cast<std::uint8_t>((bits >> count) & 255U));
    }
    if (characters != token_characters)
        refuse_typed({QT_TRANSLATE_NOOP("errors", "has %1 characters instead of %2"),
                      static_cast<std::int64_t>(characters), static_cast<std::int64_t>(token_characters)});
    return bytes;
}

std::string digits_of(const Bytes& bytes, std::size_t from, std::size_t size) {
    const auto first = bytes.begin() + static_cast<std::ptrdiff_t>(from);
    return to_hex({first, first + static_cast<std::ptrdiff_t>(size)});
}

}  // namespace

EnrolmentToken EnrolmentToken::make(const std::string& server_id, UtcMilliseconds until) {
    return {server_id.substr(0, 2 * server_size), to_hex(random_bytes(id_size)), until / 1000 * 1000,
            to_hex(random_bytes(secret_size))};
}

EnrolmentToken EnrolmentToken::parse(const std::string& typed) {
    const Bytes bytes = bytes_of_letters(typed);
    const Bytes body(bytes.begin(), bytes.begin() + body_size), sum(bytes.begin() + body_size, bytes.end());
    if (sum_of(body) != sum) refuse_typed(QT_TRANSLATE_NOOP("errors", "is mistyped"));
    EnrolmentToken token;
    token.server = digits_of(body, 0, server_size);
    token.id = digits_of(body, server_size, id_size);
    for (std::size_t i = 0; i < end_size; ++i)
        token.until = token.until * 256 + body[server_size + id_size + i];
    token.until *= 1000;
    token.secret = digits_of(body, server_size + id_size + end_size, secret_size);
    return token;
}

std::string EnrolmentToken::text() const {
    Bytes body = from_hex(server + id);
    const std::int64_t seconds = until / 1000;
    for (int shift = 24; shift >= 0; shift -= 8)
        body.push_back(static_cast<std::uint8_t>((seconds >> shift) & 255));
    const Bytes hidden = from_hex(secret);
    body.insert(body.end(), hidden.begin(), hidden.end());
    const Bytes sum = sum_of(body);
    body.insert(body.end(), sum.begin(), sum.end());
    return letters_of(body);
}

std::string EnrolmentToken::password() const {
    return text_digest("fulcrum enrolment password " + id + " " + secret);
}

std::string EnrolmentToken::proof() const {
    return text_digest("fulcrum enrolment proof " + id + " " + secret);
}

}  // namespace fulcrum::database
