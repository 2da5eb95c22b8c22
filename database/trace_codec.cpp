// SPDX-License-Identifier: GPL-3.0-or-later
// A record is a row of 32-bit columns. Every column is predicted from its own past (order 0 to 3, wrapping
// arithmetic) and, where a partner is named, from an earlier column's residual; the residual is zigzag-coded
// in Rice codes whose parameter is chosen per block. zstd then removes what repeats.
#include "database/trace_codec.h"

#include <zstd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "database/crypto.h"
#include "database/errors.h"

namespace fulcrum::database {
namespace {

constexpr std::uint8_t layout_version = 1;
constexpr std::size_t checksum_size = 16;
constexpr unsigned block_size = 128;       // residuals that share a Rice parameter
constexpr unsigned zero_block = 31;        // parameter that says: all residuals are 0
constexpr unsigned longest_quotient = 20;  // then the residual follows in 32 plain bits
constexpr unsigned highest_order = 3;
constexpr int compression_level = 3;

[[noreturn]] void corrupt(const char* what) {
    throw StoreError(StoreErrorKind::corrupt, std::string("a trace chunk is damaged (") + what + ")",
                     "the rest of the attempt can be read; restore the newest backup for this part");
}

class BitWriter {
  public:
    explicit BitWriter(std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}
    /// The low `count` bits of value, lowest first; count 0 to 32.
    void put(std::uint32_t value, unsigned count) {
        pending_ |= static_cast<std::uint64_t>(value) << filled_;
        filled_ += count;
        while (filled_ >= 8) {
            bytes_.push_back(static_cast<std::uint8_t>(pending_));
            pending_ >>= 8U;
            filled_ -= 8;
        }
    }
    void finish() {
        if (filled_ > 0) bytes_.push_back(static_cast<std::uint8_t>(pending_));
        pending_ = 0;
        filled_ = 0;
    }

  private:
    std::vector<std::uint8_t>& bytes_;
    std::uint64_t pending_ = 0;
    unsigned filled_ = 0;
};

class BitReader {
  public:
    BitReader(const std::uint8_t* begin, const std::uint8_t* end) : next_(begin), end_(end) {}
    std::uint32_t take(unsigned count) {
        while (filled_ < count) {
            if (next_ == end_) corrupt("it ends too early");
            pending_ |= static_cast<std::uint64_t>(*next_++) << filled_;
            filled_ += 8;
        }
        const auto value = static_cast<std::uint32_t>(pending_ & ((std::uint64_t{1} << count) - 1U));
        pending_ >>= count;
        filled_ -= count;
        return value;
    }
    bool at_end() const { return next_ == end_; }

  private:
    const std::uint8_t *next_, *end_;
    std::uint64_t pending_ = 0;
    unsigned filled_ = 0;
};

std::uint32_t zigzag(std::uint32_t value) {
    return (value << 1U) ^ (0U - (value >> 31U));
}
std::uint32_t unzigzag(std::uint32_t value) {
    return (value >> 1U) ^ (0U - (value & 1U));
}

/// Pass 0, 1, 2 of differences in place. Pass p leaves the first p + 1 values alone, so that only the first
/// of a column is large.
void difference(std::vector<std::uint32_t>& column, std::size_t pass) {
    for (std::size_t i = column.size(); i-- > pass + 1;) column[i] -= column[i - 1];
}
void restore(std::vector<std::uint32_t>& column, std::size_t pass) {
    for (std::size_t i = pass + 1; i < column.size(); ++i) column[i] += column[i - 1];
}

unsigned bit_length(std::uint32_t value) {
    unsigned bits = 0;
    while (value != 0) {
        ++bits;
        value >>= 1U;
    }
    return bits;
}

std::uint64_t rice_cost(const std::uint32_t* values, std::size_t count, unsigned parameter) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t quotient = values[i] >> parameter;
        bits += quotient < longest_quotient ? quotient + 1U + parameter : longest_quotient + 32U;
    }
    return bits;
}

unsigned best_parameter(const std::uint32_t* values, std::size_t count) {
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < count; ++i) sum += values[i];
    if (sum == 0) return zero_block;
    // The parameter near log2 of the mean is best for a geometric distribution; its neighbours cover
    // outliers.
    const unsigned middle =
        bit_length(static_cast<std::uint32_t>(std::min<std::uint64_t>(sum / count, 0x3fffffffU)));
    unsigned best = 0;
    std::uint64_t best_bits = std::numeric_limits<std::uint64_t>::max();
    for (unsigned parameter = middle >= 3 ? middle - 3 : 0; parameter <= std::min(middle + 1, 30U);
         ++parameter) {
        const std::uint64_t bits = rice_cost(values, count, parameter);
        if (bits < best_bits) {
            best_bits = bits;
            best = parameter;
        }
    }
    return best;
}

/// Sum of bit lengths: what choosing the prediction goes by.
std::uint64_t roughness(const std::vector<std::uint32_t>& column, const std::vector<std::uint32_t>* partner,
                        bool add) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < column.size(); ++i) {
        const std::uint32_t reference = partner == nullptr ? 0U : (*partner)[i];
        bits += bit_length(zigzag(add ? column[i] + reference : column[i] - reference));
    }
    return bits;
}

/// Columns and their partners (an earlier column, or -1) of each kind of record.
template <typename Record>
struct Layout;

// Values narrower than 32 bits are checked on the way back: a damaged chunk that passed its checksum must not
// wrap.
template <typename Narrow>
Narrow narrow(std::uint32_t value) {
    const auto wide = static_cast<std::int32_t>(value);
    if (wide < std::numeric_limits<Narrow>::min() || wide > std::numeric_limits<Narrow>::max())
        corrupt("a value out of range");
    return static_cast<Narrow>(wide);
}

class ColumnWriter {
  public:
    explicit ColumnWriter(std::uint32_t* out) : out_(out) {}
    void operator()(std::uint32_t value) { *out_++ = value; }
    void operator()(std::int32_t value) { *out_++ = static_cast<std::uint32_t>(value); }
    void operator()(std::uint16_t value) { *out_++ = value; }
    void operator()(std::int16_t value) {
        *out_++ = static_cast<std::uint32_t>(static_cast<std::int32_t>(value));
    }
    void operator()(std::uint8_t value) { *out_++ = value; }
    void operator()(std::int8_t value) {
        *out_++ = static_cast<std::uint32_t>(static_cast<std::int32_t>(value));
    }

  private:
    std::uint32_t* out_;
};

class ColumnReader {
  public:
    explicit ColumnReader(const std::uint32_t* in) : in_(in) {}
    void operator()(std::uint32_t& value) { value = *in_++; }
    void operator()(std::int32_t& value) { value = static_cast<std::int32_t>(*in_++); }
    template <typename Narrow>
    void operator()(Narrow& value) {
        value = narrow<Narrow>(*in_++);
    }

  private:
    const std::uint32_t* in_;
};

template <typename Visitor, typename Hand>
void visit_hand(Visitor& visit, Hand& hand) {
    for (auto& value : hand.tip) visit(value);
    for (auto& value : hand.axis) visit(value);
    visit(hand.roll);
    visit(hand.jaw_angle);
    for (auto& value : hand.force) visit(value);
    for (auto& value : hand.device_force) visit(value);
    visit(hand.jaw_force);
    visit(hand.jaw_area);
    visit(hand.tissue);
    visit(hand.patch);
    visit(hand.flags);
    visit(hand.filter_grade);
}

template <typename Visitor, typename Device>
void visit_device(Visitor& visit, Device& device) {
    for (auto& value : device.handle) visit(value);
    visit(device.roll);
    visit(device.jaw);
    visit(device.grip);
    visit(device.buttons);
    visit(device.present);
    visit(device.faulty);
}

template <>
struct Layout<TickSample> {
    static constexpr TraceStream stream = TraceStream::samples;
    static constexpr std::size_t hand_columns = 20, columns = 4 + 2 * hand_columns + 7;
    template <typename Visitor, typename Record>
    static void visit(Visitor& visitor, Record& record) {
        visitor(record.tick);
        visitor(record.rig_flags);
        visitor(record.model_step);
        visitor(record.missed);
        for (auto& hand : record.hand) visit_hand(visitor, hand);
        for (auto& value : record.camera.tip) visitor(value);
        for (auto& value : record.camera.orientation) visitor(value);
    }
    static int partner(std::size_t column) {
        if (column < 4 || column >= 4 + 2 * hand_columns) return -1;
        // The device force follows the force.
        const std::size_t within = (column - 4) % hand_columns;
        return within >= 11 && within < 14 ? static_cast<int>(column) - 3 : -1;
    }
    static std::uint32_t first_tick(const TickSample& record) { return record.tick; }
    static std::uint32_t last_tick(const TickSample& record) { return record.tick; }
};

template <>
struct Layout<RigSample> {
    static constexpr TraceStream stream = TraceStream::inputs;
    static constexpr std::size_t columns = 2 + 3 * 9;
    template <typename Visitor, typename Record>
    static void visit(Visitor& visitor, Record& record) {
        visitor(record.tick);
        visitor(record.flags);
        for (auto& hand : record.hand) visit_device(visitor, hand);
        visit_device(visitor, record.camera);
    }
    static int partner(std::size_t) { return -1; }
    static std::uint32_t first_tick(const RigSample& record) { return record.tick; }
    static std::uint32_t last_tick(const RigSample& record) { return record.tick; }
};

template <>
struct Layout<StepRecord> {
    static constexpr TraceStream stream = TraceStream::steps;
    static constexpr std::size_t columns = 6;
    static void visit(ColumnWriter& visitor, const StepRecord& record) {
        visitor(record.step);
        visitor(record.first_tick);
        visitor(record.last_tick);
        visitor(record.outcome);
        visitor(static_cast<std::uint32_t>(record.state_hash));
        visitor(static_cast<std::uint32_t>(record.state_hash >> 32U));
    }
    static void visit(ColumnReader& visitor, StepRecord& record) {
        visitor(record.step);
        visitor(record.first_tick);
        visitor(record.last_tick);
        visitor(record.outcome);
        std::uint32_t low = 0, high = 0;
        visitor(low);
        visitor(high);
        record.state_hash = low | static_cast<std::uint64_t>(high) << 32U;
    }
    static int partner(std::size_t column) { return column == 2 ? 1 : -1; }
    static std::uint32_t first_tick(const StepRecord& record) { return record.first_tick; }
    static std::uint32_t last_tick(const StepRecord& record) { return record.last_tick; }
};

template <>
struct Layout<Event> {
    static constexpr TraceStream stream = TraceStream::events;
    static constexpr std::size_t columns = 6;
    static void visit(ColumnWriter& visitor, const Event& record) {
        visitor(record.tick);
        visitor(static_cast<std::uint16_t>(record.kind));
        visitor(record.hand);
        visitor(record.tissue);
        visitor(record.detail);
        std::uint32_t bits = 0;
        std::memcpy(&bits, &record.value, sizeof bits);
        visitor(bits);
    }
    static void visit(ColumnReader& visitor, Event& record) {
        visitor(record.tick);
        std::uint16_t kind = 0;
        visitor(kind);
        record.kind = static_cast<EventKind>(kind);
        visitor(record.hand);
        visitor(record.tissue);
        visitor(record.detail);
        std::uint32_t bits = 0;
        visitor(bits);
        std::memcpy(&record.value, &bits, sizeof bits);
    }
    static int partner(std::size_t) { return -1; }
    static std::uint32_t first_tick(const Event& record) { return record.tick; }
    static std::uint32_t last_tick(const Event& record) { return record.tick; }
};

void put_header(std::vector<std::uint8_t>& bytes, TraceStream stream, std::size_t count,
                std::size_t columns) {
    bytes.push_back(layout_version);
    bytes.push_back(static_cast<std::uint8_t>(stream));
    bytes.push_back(static_cast<std::uint8_t>(count & 0xffU));
    bytes.push_back(static_cast<std::uint8_t>(count >> 8U));
    bytes.push_back(static_cast<std::uint8_t>(columns));
}
constexpr std::size_t header_size = 5;

}  // namespace

const char* stream_name(TraceStream stream) {
    switch (stream) {
        case TraceStream::samples:
            return "samples";
        case TraceStream::inputs:
            return "inputs";
        case TraceStream::steps:
            return "steps";
        case TraceStream::events:
            return "events";
    }
    return "unknown";
}

struct TraceCodec::State {
    ZSTD_CCtx* compressor = ZSTD_createCCtx();
    ZSTD_DCtx* decompressor = ZSTD_createDCtx();
    std::vector<std::uint32_t> rows;  // record after record
    std::vector<std::vector<std::uint32_t>>
        residuals;  // column after column, as coded before any partner was taken off
    std::vector<std::uint32_t> candidate, codes;
    std::vector<std::uint8_t> plain;

    ~State() {
        ZSTD_freeCCtx(compressor);
        ZSTD_freeDCtx(decompressor);
    }

    void write_column(BitWriter& writer, std::size_t column, std::size_t columns, std::size_t count,
                      int partner) {
        candidate.resize(count);
        for (std::size_t i = 0; i < count; ++i) candidate[i] = rows[i * columns + column];
        // Order, and sign of the partner's share: 0 none, 1 less it, 2 plus it.
        unsigned best_order = 0, best_share = 0;
        std::uint64_t best = std::numeric_limits<std::uint64_t>::max();
        const auto* reference = partner >= 0 ? &residuals[static_cast<std::size_t>(partner)] : nullptr;
        for (unsigned order = 0; order <= highest_order; ++order) {
            if (order > 0) difference(candidate, order - 1);
            const std::uint64_t own = roughness(candidate, nullptr, false);
            if (own < best) {
                best = own;
                best_order = order;
                best_share = 0;
                residuals[column] = candidate;
            }
            if (reference != nullptr && orders[static_cast<std::size_t>(partner)] == order) {
                for (const unsigned share : {1U, 2U}) {
                    const std::uint64_t shared = roughness(candidate, reference, share == 2U);
                    if (shared < best) {
                        best = shared;
                        best_order = order;
                        best_share = share;
                        residuals[column] = candidate;
                    }
                }
            }
        }
        orders[column] = best_order;
        writer.put(best_order, 2);
        writer.put(best_share, 2);
        codes.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            std::uint32_t value = residuals[column][i];
            if (best_share == 1U) value -= (*reference)[i];
            if (best_share == 2U) value += (*reference)[i];
            codes[i] = zigzag(value);
        }
        for (std::size_t begin = 0; begin < count; begin += block_size) {
            const std::size_t length = std::min<std::size_t>(block_size, count - begin);
            const unsigned parameter = best_parameter(codes.data() + begin, length);
            writer.put(parameter, 5);
            if (parameter == zero_block) continue;
            for (std::size_t i = begin; i < begin + length; ++i) {
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

    void read_column(BitReader& reader, std::size_t column, std::size_t columns, std::size_t count,
                     int partner) {
        const unsigned order = reader.take(2), share = reader.take(2);
        if (share > 2U ||
            (share != 0U && (partner < 0 || orders[static_cast<std::size_t>(partner)] != order)))
            corrupt("its layout");
        orders[column] = order;
        auto& values = residuals[column];
        values.resize(count);
        for (std::size_t begin = 0; begin < count; begin += block_size) {
            const std::size_t end = std::min<std::size_t>(begin + block_size, count);
            const unsigned parameter = reader.take(5);
            for (std::size_t i = begin; i < end; ++i) {
                std::uint32_t code = 0;
                if (parameter != zero_block) {
                    unsigned quotient = 0;
                    while (quotient < longest_quotient && reader.take(1) == 1U) ++quotient;
                    code = quotient == longest_quotient ? reader.take(32)
                                                        : quotient << parameter | reader.take(parameter);
                }
                values[i] = unzigzag(code);
                if (share == 1U) values[i] += residuals[static_cast<std::size_t>(partner)][i];
                if (share == 2U) values[i] -= residuals[static_cast<std::size_t>(partner)][i];
            }
        }
        candidate = values;
        for (unsigned pass = order; pass-- > 0;) restore(candidate, pass);
        for (std::size_t i = 0; i < count; ++i) rows[i * columns + column] = candidate[i];
    }

    std::array<unsigned, 64> orders{};

    template <typename Record>
    TraceChunk encode(const Record* records, std::size_t count) {
        using Columns = Layout<Record>;
        if (count == 0 || count > chunk_maximum_records) {
            throw StoreError(StoreErrorKind::bad_value,
                             "a trace chunk holds 1 to " + std::to_string(chunk_maximum_records) + " records",
                             "split it");
        }
        rows.resize(count * Columns::columns);
        residuals.resize(std::max(residuals.size(), Columns::columns));
        for (std::size_t i = 0; i < count; ++i) {
            ColumnWriter writer(rows.data() + i * Columns::columns);
            Columns::visit(writer, records[i]);
        }
        plain.clear();
        put_header(plain, Columns::stream, count, Columns::columns);
        BitWriter writer(plain);
        for (std::size_t column = 0; column < Columns::columns; ++column) {
            write_column(writer, column, Columns::columns, count, Columns::partner(column));
        }
        writer.finish();

        TraceChunk chunk;
        chunk.stream = Columns::stream;
        chunk.count = static_cast<std::uint32_t>(count);
        chunk.first_tick = Columns::first_tick(records[0]);
        chunk.last_tick = Columns::last_tick(records[count - 1]);
        chunk.data.resize(ZSTD_compressBound(plain.size()));
        const std::size_t size = ZSTD_compressCCtx(compressor, chunk.data.data(), chunk.data.size(),
                                                   plain.data(), plain.size(), compression_level);
        if (ZSTD_isError(size) != 0U) {
            throw StoreError(StoreErrorKind::failed, std::string("zstd: ") + ZSTD_getErrorName(size),
                             "free some memory");
        }
        chunk.data.resize(size);
        chunk.checksum = blake2b(chunk.data, checksum_size);
        return chunk;
    }

    template <typename Record>
    void decode(const TraceChunk& chunk, std::vector<Record>& records) {
        using Columns = Layout<Record>;
        if (chunk.stream != Columns::stream) corrupt("another stream");
        if (chunk.data.size() > chunk_maximum_bytes || chunk.count == 0 ||
            chunk.count > chunk_maximum_records)
            corrupt("its size");
        if (chunk.checksum != blake2b(chunk.data, checksum_size)) corrupt("its checksum");
        const std::size_t count = chunk.count;
        // No residual takes more than longest_quotient + 32 bits: nothing honest is larger than this.
        const std::size_t most = header_size + Columns::columns * (1 + count * 7 + count / block_size + 1);
        const unsigned long long announced = ZSTD_getFrameContentSize(chunk.data.data(), chunk.data.size());
        if (announced == ZSTD_CONTENTSIZE_ERROR || announced == ZSTD_CONTENTSIZE_UNKNOWN ||
            announced > most || announced < header_size) {
            corrupt("its length");
        }
        plain.resize(static_cast<std::size_t>(announced));
        const std::size_t size = ZSTD_decompressDCtx(decompressor, plain.data(), plain.size(),
                                                     chunk.data.data(), chunk.data.size());
        if (ZSTD_isError(size) != 0U || size != plain.size()) corrupt("its compression");
        std::vector<std::uint8_t> header;
        put_header(header, Columns::stream, count, Columns::columns);
        if (!std::equal(header.begin(), header.end(), plain.begin())) corrupt("its header");

        rows.resize(count * Columns::columns);
        residuals.resize(std::max(residuals.size(), Columns::columns));
        BitReader reader(plain.data() + header_size, plain.data() + plain.size());
        for (std::size_t column = 0; column < Columns::columns; ++column) {
            read_column(reader, column, Columns::columns, count, Columns::partner(column));
        }
        if (!reader.at_end()) corrupt("something follows its end");
        std::vector<Record> decoded(count);
        for (std::size_t i = 0; i < count; ++i) {
            ColumnReader column_reader(rows.data() + i * Columns::columns);
            Columns::visit(column_reader, decoded[i]);
        }
        if (Columns::first_tick(decoded.front()) != chunk.first_tick ||
            Columns::last_tick(decoded.back()) != chunk.last_tick) {
            corrupt("its ticks");
        }
        records.insert(records.end(), decoded.begin(), decoded.end());
    }
};

TraceCodec::TraceCodec() : state_(new State) {}
TraceCodec::~TraceCodec() {
    delete state_;
}
TraceChunk TraceCodec::encode(const TickSample* records, std::size_t count) {
    return state_->encode(records, count);
}
TraceChunk TraceCodec::encode(const RigSample* records, std::size_t count) {
    return state_->encode(records, count);
}
TraceChunk TraceCodec::encode(const StepRecord* records, std::size_t count) {
    return state_->encode(records, count);
}
TraceChunk TraceCodec::encode(const Event* records, std::size_t count) {
    return state_->encode(records, count);
}
void TraceCodec::decode(const TraceChunk& chunk, std::vector<TickSample>& records) {
    state_->decode(chunk, records);
}
void TraceCodec::decode(const TraceChunk& chunk, std::vector<RigSample>& records) {
    state_->decode(chunk, records);
}
void TraceCodec::decode(const TraceChunk& chunk, std::vector<StepRecord>& records) {
    state_->decode(chunk, records);
}
void TraceCodec::decode(const TraceChunk& chunk, std::vector<Event>& records) {
    state_->decode(chunk, records);
}

}  // namespace fulcrum::database
