// SPDX-License-Identifier: Apache-2.0
#include "sim_core/igtl/message.h"

#include <algorithm>
#include <cstring>

#include "sim_core/igtl/byte_order.h"
#include "sim_core/igtl/crc64.h"

namespace fulcrum::igtl {
namespace {

constexpr std::uint16_t newest_version = 3;
constexpr std::size_t at_type = 2, at_device = 14, at_time = 34, at_size = 42, at_crc = 50;
constexpr std::size_t meta_entry_size = 8, meta_count_size = 2;
constexpr std::int64_t second_ns = 1000 * 1'000'000;

/// A text of at most `size` bytes that ends with the first zero.
std::string_view text_in(const std::uint8_t* field, std::size_t size) noexcept {
    const auto* const begin = reinterpret_cast<const char*>(field);
    return {begin, static_cast<std::size_t>(std::find(begin, begin + size, '\0') - begin)};
}

/// The name of a type: printable, without a space, filled up with zeros.
bool is_type_name(const std::uint8_t* field) noexcept {
    const std::string_view name = text_in(field, type_size);
    const auto rest = field + name.size();
    return !name.empty() && std::all_of(field, rest, [](std::uint8_t c) { return c > 0x20 && c < 0x7f; }) &&
           std::all_of(rest, field + type_size, [](std::uint8_t c) { return c == 0; });
}

void put_text(std::uint8_t* field, std::size_t size, std::string_view text) noexcept {
    std::memcpy(field, text.data(), std::min(size, text.size()));
}

/// The table of the metadata has room for its entries, and these for the metadata.
bool fits(ByteView table, std::size_t meta) noexcept {
    if (table.size == 0) return meta == 0;
    if (table.size < meta_count_size) return false;
    const std::size_t count = read_number<std::uint16_t>(table.data);
    if (table.size != meta_count_size + count * meta_entry_size) return false;
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t* const entry = table.data + meta_count_size + i * meta_entry_size;
        sum += std::uint64_t{read_number<std::uint16_t>(entry)} + read_number<std::uint32_t>(entry + 4);
    }
    return sum == meta;
}

/// Splits a body of version 2 or above.
bool split(ByteView body, Message& message) noexcept {
    if (body.size < extended_header_size) return false;
    const std::size_t extended = read_number<std::uint16_t>(body.data),
                      table = read_number<std::uint16_t>(body.data + 2),
                      meta = read_number<std::uint32_t>(body.data + 4);
    message.id = read_number<std::uint32_t>(body.data + 8);
    if (extended < extended_header_size || extended > body.size || table > body.size - extended ||
        meta > body.size - extended - table)
        return false;
    message.content = {body.data + extended, body.size - extended - table - meta};
    message.meta_header = {message.content.data + message.content.size, table};
    message.meta = {message.meta_header.data + table, meta};
    return fits(message.meta_header, meta);
}

}  // namespace

void append_message(Bytes& out, const Envelope& envelope, ByteView content) {
    const bool extended = envelope.version >= 2;
    const std::size_t table = extended ? std::min<std::size_t>(envelope.meta_header.size, 0xffff) : 0,
                      meta = extended ? envelope.meta.size : 0,
                      body_size = content.size + (extended ? extended_header_size + table + meta : 0);
    const std::size_t from = out.size();
    out.resize(from + header_size + body_size, 0);
    std::uint8_t* const header = out.data() + from;
    std::uint8_t* const body = header + header_size;
    std::uint8_t* to = body;
    const auto put = [&to](const std::uint8_t* bytes, std::size_t size) {
        if (size > 0) std::memcpy(to, bytes, size);
        to += size;
    };
    if (extended) {
        write_number(to, static_cast<std::uint16_t>(extended_header_size));
        write_number(to + 2, static_cast<std::uint16_t>(table));
        write_number(to + 4, static_cast<std::uint32_t>(meta));
        write_number(to + 8, envelope.id);
        to += extended_header_size;
    }
    put(content.data, content.size);
    put(envelope.meta_header.data, table);
    put(envelope.meta.data, meta);
    write_number(header, envelope.version);
    put_text(header + at_type, type_size, envelope.type);
    put_text(header + at_device, device_size, envelope.device);
    write_number(header + at_time, envelope.time);
    write_number(header + at_size, static_cast<std::uint64_t>(body_size));
    write_number(header + at_crc, crc64(body, body_size));
}

Decoder::Decoder() : buffer_(header_size + largest_body) {}

std::uint8_t* Decoder::space() noexcept {
    if (begin_ > 0) {
        std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
        end_ -= begin_;
        begin_ = 0;
    }
    return buffer_.data() + end_;
}

std::size_t Decoder::room() const noexcept {
    return broken_ ? 0 : buffer_.size() - (end_ - begin_);
}

void Decoder::take(std::size_t count) noexcept {
    end_ = std::min(end_ + count, buffer_.size());
}

void Decoder::reset() noexcept {
    begin_ = end_ = 0;
    skip_ = 0;
    broken_ = false;
}

Decoder::Found Decoder::next(Message& message) noexcept {
    if (broken_) return Found::broken;
    const auto skipped = static_cast<std::size_t>(std::min<std::uint64_t>(skip_, end_ - begin_));
    begin_ += skipped;
    skip_ -= skipped;
    if (skip_ > 0) return Found::nothing;
    return parse(message);
}

Decoder::Found Decoder::parse(Message& message) noexcept {
    const std::size_t have = end_ - begin_;
    const std::uint8_t* const header = buffer_.data() + begin_;
    // What cannot be a header is noticed as soon as its first bytes are there: nobody waits for more.
    if (have >= 2) {
        const auto version = read_number<std::uint16_t>(header);
        broken_ = version < 1 || version > newest_version;
    }
    if (have >= header_size && !broken_)
        broken_ =
            !is_type_name(header + at_type) || read_number<std::uint64_t>(header + at_size) > longest_skip;
    if (broken_) return Found::broken;
    if (have < header_size) return Found::nothing;
    const auto body_size = read_number<std::uint64_t>(header + at_size);
    message = {};
    message.version = read_number<std::uint16_t>(header);
    message.type = text_in(header + at_type, type_size);
    message.device = text_in(header + at_device, device_size);
    message.time = read_number<std::uint64_t>(header + at_time);
    if (body_size > largest_body) {
        begin_ += header_size;
        skip_ = body_size;
        return Found::skipped;
    }
    const auto size = static_cast<std::size_t>(body_size);
    if (have < header_size + size) return Found::nothing;
    begin_ += header_size + size;
    const ByteView body{header + header_size, size};
    if (crc64(body.data, size) != read_number<std::uint64_t>(header + at_crc)) return Found::wrong_checksum;
    message.content = body;
    if (message.version >= 2 && !split(body, message)) return Found::wrong_content;
    return Found::message;
}

std::uint64_t timestamp_of(std::int64_t ns) noexcept {
    if (ns < 0) return 0;
    const auto seconds = static_cast<std::uint64_t>(ns / second_ns),
               rest = static_cast<std::uint64_t>(ns % second_ns);
    return (seconds << 32U) | ((rest << 32U) + second_ns / 2) / second_ns;
}

std::int64_t ns_of(std::uint64_t timestamp) noexcept {
    const auto seconds = static_cast<std::int64_t>(timestamp >> 32U);
    const std::uint64_t rest = timestamp & 0xffffffffU;
    return seconds * second_ns + static_cast<std::int64_t>((rest * second_ns + (1ULL << 31U)) >> 32U);
}

}  // namespace fulcrum::igtl
