// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/rows/trace_bits.h"

#include <algorithm>
#include <limits>
#include <string>

#include "database/rows/errors.h"

namespace fulcrum::database {
namespace {

constexpr std::size_t block_size = 128;    // codes that share a parameter
constexpr unsigned zero_block = 31;        // the parameter that says: all codes are 0
constexpr unsigned longest_quotient = 20;  // then the code follows in 32 plain bits

std::uint64_t rice_cost(const std::uint32_t* codes, std::size_t count, unsigned parameter) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t quotient = codes[i] >> parameter;
        bits += quotient < longest_quotient ? quotient + 1U + parameter : longest_quotient + 32U;
    }
    return bits;
}

unsigned best_parameter(const std::uint32_t* codes, std::size_t count) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += codes[i];
    if (sum == 0) return zero_block;
    // Near log2 of the mean is best for a geometric distribution; lower neighbours serve where few outliers
    // make the mean.
    const unsigned middle =
        bit_length(static_cast<std::uint32_t>(std::min<std::uint64_t>(sum / count, 0x3fffffffU)));
    unsigned best = 0;
    std::uint64_t best_bits = std::numeric_limits<std::uint64_t>::max();
    for (unsigned parameter = middle >= 3 ? middle - 3 : 0; parameter <= std::min(middle + 1, 30U);
         ++parameter) {
        const std::uint64_t bits = rice_cost(codes, count, parameter);
        if (bits < best_bits) {
            best_bits = bits;
            best = parameter;
        }
    }
    return best;
}

}  // namespace

void damaged_chunk(const char* what) {
    throw StoreError(
        StoreErrorKind::corrupt,
        {QT_TRANSLATE_NOOP("errors", "a part of the recording is damaged (%1)"), what},
        QT_TRANSLATE_NOOP("errors",
                          "the rest of the attempt can be read; restore the newest backup for this part"));
}

void BitWriter::finish() {
    if (filled_ > 0) bytes_.push_back(static_cast<std::uint8_t>(pending_));
    pending_ = 0;
    filled_ = 0;
}

void write_rice(BitWriter& writer, const std::uint32_t* codes, std::size_t count) {
    for (std::size_t begin = 0; begin < count; begin += block_size) {
        const std::size_t end = std::min(begin + block_size, count);
        const unsigned parameter = best_parameter(codes + begin, end - begin);
        writer.put(parameter, 5);
        if (parameter == zero_block) continue;
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t quotient = codes[i] >> parameter;
            if (quotient < longest_quotient) {
                writer.put((1U << quotient) - 1U, quotient + 1U);  // ones, then a zero
                writer.put(codes[i] & ((1U << parameter) - 1U), parameter);
            } else {
                writer.put((1U << longest_quotient) - 1U, longest_quotient);
                writer.put(codes[i], 32);
            }
        }
    }
}

void read_rice(BitReader& reader, std::uint32_t* codes, std::size_t count) {
    for (std::size_t begin = 0; begin < count; begin += block_size) {
        const std::size_t end = std::min(begin + block_size, count);
        const unsigned parameter = reader.take(5);
        if (parameter == zero_block) {
            std::fill(codes + begin, codes + end, 0U);
            continue;
        }
        for (std::size_t i = begin; i < end; ++i) {
            const unsigned quotient = reader.take_ones(longest_quotient);
            codes[i] = quotient == longest_quotient ? reader.take(32)
                                                    : quotient << parameter | reader.take(parameter);
        }
    }
}

void skip_rice(BitReader& reader, std::size_t count) {
    for (std::size_t begin = 0; begin < count; begin += block_size) {
        const unsigned parameter = reader.take(5);
        if (parameter == zero_block) continue;
        const std::size_t codes = std::min(block_size, count - begin);
        for (std::size_t i = 0; i < codes; ++i) reader.skip_code(parameter, longest_quotient);
    }
}

std::size_t rice_bound(std::size_t count) {
    return count * (longest_quotient + 32U) / 8U + count / block_size + 2U;
}

}  // namespace fulcrum::database
