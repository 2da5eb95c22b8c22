// SPDX-License-Identifier: Apache-2.0
// Messages of OpenIGTLink, header versions 1 to 3 (docs/FORMATS.md, OpenIGTLink): a header of 58 bytes, then
// a body with a checksum. From version 2 on the body begins with an extended header and ends with metadata.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::igtl {

using Bytes = std::vector<std::uint8_t>;

/// Some bytes that belong to somebody else.
struct ByteView {
    const std::uint8_t* data = nullptr;
    std::size_t size = 0;
};

inline constexpr std::size_t header_size = 58;
inline constexpr std::size_t extended_header_size = 12;
inline constexpr std::size_t largest_body = 65536;          ///< bytes; a longer body is skipped, not stored
inline constexpr std::uint64_t longest_skip = 1ULL << 32U;  ///< bytes; a longer body is no OpenIGTLink
inline constexpr std::size_t type_size = 12, device_size = 20;
inline constexpr int standard_port = 18944;

/// Views into the decoder's buffer, valid until its next call.
struct Message {
    std::uint16_t version = 1;
    std::string_view type, device;
    std::uint64_t time = 0;  ///< s * 2^32
    std::uint32_t id = 0;    ///< from version 2 on
    ByteView content;        ///< the body without extended header and metadata
    ByteView meta_header, meta;
};

/// What goes in front of a content. A type or a device that is too long is cut.
struct Envelope {
    std::string_view type, device;
    std::uint64_t time = 0;
    std::uint16_t version = 1;
    std::uint32_t id = 0;  ///< from version 2 on, as the metadata
    ByteView meta_header = {}, meta = {};
};

/// Appends a message with this content.
void append_message(Bytes& out, const Envelope& envelope, ByteView content);

/// Reads messages from a stream of bytes that somebody else sends. It has one buffer, made when it is
/// constructed; nothing that the bytes say makes it allocate.
class Decoder {
  public:
    Decoder();

    enum class Found {
        nothing,         ///< more bytes are needed
        message,         ///< a message with the right checksum
        skipped,         ///< the header of a message that is too long, whose body is left out
        wrong_checksum,  ///< a message that is left out
        wrong_content,   ///< right checksum, but extended header or metadata do not fit the body; left out
        broken           ///< this is no stream of OpenIGTLink; for good
    };

    /// Where the next bytes are to be written, and how many fit; at least one unless the stream is broken or
    /// next() has not been called until it found nothing.
    std::uint8_t* space() noexcept;
    std::size_t room() const noexcept;
    /// So many bytes were written at space().
    void take(std::size_t count) noexcept;
    Found next(Message& message) noexcept;
    /// Begins again, for another connection.
    void reset() noexcept;

  private:
    Found parse(Message& message) noexcept;

    Bytes buffer_;
    std::size_t begin_ = 0, end_ = 0;
    std::uint64_t skip_ = 0;  ///< bytes of a long body that are still to come
    bool broken_ = false;
};

/// The timestamp of a message from ns since 1970, and back; exact to the ns.
std::uint64_t timestamp_of(std::int64_t ns) noexcept;
std::int64_t ns_of(std::uint64_t timestamp) noexcept;

}  // namespace fulcrum::igtl
