// SPDX-License-Identifier: GPL-3.0-or-later
// Bits and Rice codes of trace chunks; internal to this floor. Reading is bounded by the buffer, whatever is
// in it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "sim_core/numerics/name_table.h"

namespace fulcrum::database {

/// Throws StoreError corrupt: `what` completes "a trace chunk is damaged (...)".
[[noreturn]] void damaged_chunk(const char* what);

inline std::uint32_t zigzag(std::uint32_t value) {
    return (value << 1U) ^ (0U - (value >> 31U));
}
inline std::uint32_t unzigzag(std::uint32_t value) {
    return (value >> 1U) ^ (0U - (value & 1U));
}
inline unsigned bit_length(std::uint32_t value) {
    return value == 0 ? 0U : 32U - static_cast<unsigned>(__builtin_clz(value));
}

class BitWriter {
  public:
    explicit BitWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}
    /// The low `count` bits of value, lowest first; count 0 to 32, higher bits 0.
    void put(std::uint32_t value, unsigned count) {
        pending_ |= static_cast<std::uint64_t>(value) << filled_;
        filled_ += count;
        while (filled_ >= 8) {
            bytes_.push_back(static_cast<std::uint8_t>(pending_));
            pending_ >>= 8U;
            filled_ -= 8;
        }
    }
    void finish();

  private:
    std::vector<std::uint8_t>& bytes_;
    std::uint64_t pending_ = 0;
    unsigned filled_ = 0;
};

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the reader loads little-endian words");

class BitReader {
  public:
    BitReader(const std::uint8_t* begin, const std::uint8_t* end) : next_(begin), end_(end) {}
    /// count 0 to 32.
    std::uint32_t take(unsigned count) {
        refill();
        if (filled_ < count) damaged_chunk(QT_TRANSLATE_NOOP("errors", "it ends too early"));
        const auto value = static_cast<std::uint32_t>(pending_ & ((std::uint64_t{1} << count) - 1U));
        drop(count);
        return value;
    }
    /// The ones before the next zero, which is taken too; at most `most` ones, after which no zero is taken.
    unsigned take_ones(unsigned most) {
        refill();
        const std::uint64_t zeros = ~pending_;
        unsigned ones = zeros == 0 ? 64U : static_cast<unsigned>(__builtin_ctzll(zeros));
        ones = ones < most ? ones : most;
        const unsigned used = ones == most ? most : ones + 1U;
        if (filled_ < used) damaged_chunk(QT_TRANSLATE_NOOP("errors", "it ends too early"));
        drop(used);
        return ones;
    }
    /// One Rice code with this parameter; read_rice() without its value.
    void skip_code(unsigned parameter, unsigned longest_quotient) {
        if (take_ones(longest_quotient) == longest_quotient) {
            take(32);
        } else if (filled_ >= parameter) {
            drop(parameter);
        } else {
            take(parameter);
        }
    }
    bool at_end() const { return next_ == end_ && filled_ < 8; }

  private:
    void refill() {
        if (end_ - next_ >= 8) {
            // Eight bytes at once; what does not fit is loaded again by the next refill.
            std::uint64_t bytes = 0;
            std::memcpy(&bytes, next_, sizeof bytes);
            pending_ |= bytes << filled_;
            next_ += (63U - filled_) >> 3U;
            filled_ |= 56U;
            return;
        }
        while (filled_ <= 56U && next_ != end_) {
            pending_ |= static_cast<std::uint64_t>(*next_++) << filled_;
            filled_ += 8;
        }
    }
    void drop(unsigned count) {
        pending_ >>= count;
        filled_ -= count;
    }
    const std::uint8_t *next_, *end_;
    std::uint64_t pending_ = 0;
    unsigned filled_ = 0;
};

/// Residuals as Rice codes, with a parameter of their own for every 128.
void write_rice(BitWriter& writer, const std::uint32_t* codes, std::size_t count);
void read_rice(BitReader& reader, std::uint32_t* codes, std::size_t count);
/// Past `count` codes without their values.
void skip_rice(BitReader& reader, std::size_t count);
/// No honest chunk is longer than this many bytes for `count` codes.
std::size_t rice_bound(std::size_t count);

}  // namespace fulcrum::database
