// SPDX-License-Identifier: GPL-3.0-or-later
// A record is a row of 32-bit columns. Every column is predicted from its own past (differences of order 0 to
// 3, wrapping) and, where that makes it smaller, from the residual of a partner column, or from the residuals
// of the inputs of the same ticks by coefficients fitted to every 256 ticks: the shaft's axis and the tip are
// functions of the handle, and most of what is left of them after differencing is the handle's own
// quantisation seen through a lever. Residuals become Rice codes; zstd removes what repeats.
#include "database/rows/trace_codec.h"

#include <zstd.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "database/rows/crypto.h"
#include "database/rows/errors.h"
#include "database/rows/trace_columns.h"
#include "database/rows/trace_layout.h"

namespace fulcrum::database {

using namespace trace_columns;

namespace {

constexpr std::uint8_t layout_version = 1;
constexpr std::size_t column_count_byte = 4;  // of the header
constexpr std::size_t checksum_size = 16;
constexpr int compression_level = 3;
constexpr std::size_t header_size = 6;
constexpr std::size_t segment = 256;  // ticks that share coefficients
void put_header(std::vector<std::uint8_t>& bytes, TraceStream stream, std::size_t count, std::size_t columns,
                bool with_inputs) {
    bytes.push_back(layout_version);
    bytes.push_back(static_cast<std::uint8_t>(stream));
    bytes.push_back(static_cast<std::uint8_t>(count & 0xffU));
    bytes.push_back(static_cast<std::uint8_t>(count >> 8U));
    bytes.push_back(static_cast<std::uint8_t>(columns));
    bytes.push_back(with_inputs ? 1U : 0U);
}

template <typename Record>
bool same_ticks(const Record* records, const RigSample* inputs, std::size_t count) {
    if constexpr (std::is_same_v<Record, TickSample>) {
        if (inputs == nullptr) return false;
        for (std::size_t i = 0; i < count; ++i) {
            if (records[i].tick != inputs[i].tick) return false;
        }
        return true;
    } else {
        static_cast<void>(records);
        static_cast<void>(inputs);
        static_cast<void>(count);
        return false;
    }
}

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
    std::vector<Column> residuals;    // column after column, at its order, before any share was taken off
    std::array<unsigned, 64> orders{};
    std::array<std::vector<Column>, highest_order + 1>
        inputs;  // residuals of the inputs' columns at every order
    bool with_inputs = false;
    Column candidate, shared, codes;
    std::vector<std::uint8_t> plain;

    ~State() {
        ZSTD_freeCCtx(compressor);
        ZSTD_freeDCtx(decompressor);
    }

    void load_inputs(const RigSample* records, std::size_t count) {
        using Columns = Layout<RigSample>;
        std::array<std::uint32_t, Columns::columns> row{};
        for (auto& order : inputs) order.resize(Columns::columns);
        for (Column& column : inputs[0]) column.resize(count);
        for (std::size_t i = 0; i < count; ++i) {
            ColumnWriter writer(row.data());
            Columns::visit(writer, records[i]);
            for (std::size_t column = 0; column < Columns::columns; ++column)
                inputs[0][column][i] = row[column];
        }
        for (unsigned order = 1; order <= highest_order; ++order) {
            for (Column& column : inputs[order]) column.clear();  // made when first asked for
        }
    }

    const Column& input_residuals(std::size_t column, unsigned order) {
        Column& wanted = inputs[order][column];
        if (wanted.empty()) {
            wanted = input_residuals(column, order - 1);
            difference(wanted, order - 1);
        }
        return wanted;
    }

    /// A guide that is not there is the first one again, with a coefficient of 0.
    std::array<const Column*, 3> guides_at(const Guides& guides, unsigned order) {
        std::array<const Column*, 3> columns{};
        for (std::size_t g = 0; g < 3; ++g) {
            columns[g] = &input_residuals(static_cast<std::size_t>(guides[guides[g] >= 0 ? g : 0]), order);
        }
        return columns;
    }

    /// Least squares of candidate on the guides over one segment, the first values (not yet differences) left
    /// out.
    Coefficients fit(const Guides& used, const std::array<const Column*, 3>& guides, std::size_t begin,
                     std::size_t end) const {
        Matrix3 normal = Matrix3::Zero();
        Vector3 right = Vector3::Zero();
        for (std::size_t i = std::max<std::size_t>(begin, highest_order); i < end; ++i) {
            Vector3 value;
            for (std::size_t g = 0; g < 3; ++g) {
                value[static_cast<Eigen::Index>(g)] =
                    used[g] < 0 ? 0.0 : static_cast<double>(signed_value((*guides[g])[i]));
            }
            normal += value * value.transpose();
            right += value * static_cast<double>(signed_value(candidate[i]));
        }
        normal.diagonal().array() += 1e-3;  // a guide that rests takes no part
        const Vector3 solution = normal.ldlt().solve(right) * static_cast<double>(1U << coefficient_shift);
        Coefficients coefficients{};
        for (std::size_t g = 0; g < 3; ++g) {
            const double limit = static_cast<double>(coefficient_limit),
                         wanted = solution[static_cast<Eigen::Index>(g)];
            coefficients[g] = std::isfinite(wanted)
                                  ? static_cast<std::int64_t>(std::lround(std::clamp(wanted, -limit, limit)))
                                  : 0;
        }
        return coefficients;
    }

    void write_column(BitWriter& writer, std::size_t column, std::size_t columns, std::size_t count,
                      int partner, const Guides& guides) {
        candidate.resize(count);
        for (std::size_t i = 0; i < count; ++i) candidate[i] = rows[i * columns + column];
        unsigned best_order = 0;
        Share best_share = share_none;
        std::uint64_t best = std::numeric_limits<std::uint64_t>::max();
        std::vector<Coefficients> best_coefficients;
        const auto offer = [&](const Column& left, unsigned order, Share share, std::uint64_t extra) {
            const std::uint64_t bits = roughness(left) + extra;
            if (bits >= best) return false;
            best = bits;
            best_order = order;
            best_share = share;
            residuals[column] = candidate;
            codes = left;
            return true;
        };
        shared.resize(count);
        for (unsigned order = 0; order <= highest_order; ++order) {
            if (order > 0) difference(candidate, order - 1);
            offer(candidate, order, share_none, 0);
            if (partner >= 0 && orders[static_cast<std::size_t>(partner)] == order) {
                const Column& reference = residuals[static_cast<std::size_t>(partner)];
                for (std::size_t i = 0; i < count; ++i) shared[i] = candidate[i] - reference[i];
                offer(shared, order, share_less, 0);
                for (std::size_t i = 0; i < count; ++i) shared[i] = candidate[i] + reference[i];
                offer(shared, order, share_plus, 0);
            }
            // Orders 1 and 2 are those at which moving hands are best predicted.
            if (with_inputs && guides[0] >= 0 && (order == 1 || order == 2) && best > count) {
                const auto columns_of_guides = guides_at(guides, order);
                std::vector<Coefficients> coefficients;
                std::uint64_t extra = 0;
                for (std::size_t begin = 0; begin < count; begin += segment) {
                    const std::size_t end = std::min(begin + segment, count);
                    coefficients.push_back(fit(guides, columns_of_guides, begin, end));
                    for (const int guide : guides) extra += guide >= 0 ? coefficient_bits : 0U;
                    for (std::size_t i = begin; i < end; ++i) {
                        shared[i] =
                            candidate[i] -
                            (i < highest_order ? 0U : guided(coefficients.back(), columns_of_guides, i));
                    }
                }
                if (offer(shared, order, share_guided, extra)) best_coefficients = std::move(coefficients);
            }
        }
        orders[column] = best_order;
        writer.put(best_order, 2);
        writer.put(best_share, 2);
        if (best_share == share_guided) {
            for (const Coefficients& coefficients : best_coefficients) {
                for (std::size_t g = 0; g < 3; ++g) {
                    if (guides[g] >= 0) {
                        writer.put(
                            static_cast<std::uint32_t>(coefficients[g]) & ((1U << coefficient_bits) - 1U),
                            coefficient_bits);
                    }
                }
            }
        }
        for (std::uint32_t& code : codes) code = zigzag(code);
        write_rice(writer, codes.data(), count);
    }

    /// The column's values; they stay until the next call.
    const Column& read_column(BitReader& reader, std::size_t column, std::size_t count, int partner,
                              const Guides& guides, bool is_partner) {
        const unsigned order = reader.take(2), share = reader.take(2);
        orders[column] = order;
        Column& values = residuals[column];
        values.resize(count);
        std::vector<Coefficients> coefficients;
        if (share == share_guided) {
            if (!with_inputs || guides[0] < 0) damaged_chunk(QT_TRANSLATE_NOOP("errors", "its layout"));
            coefficients.resize((count + segment - 1) / segment);
            for (Coefficients& each : coefficients) {
                for (std::size_t g = 0; g < 3; ++g) {
                    if (guides[g] < 0) continue;
                    const auto bits = static_cast<std::int64_t>(reader.take(coefficient_bits));
                    each[g] = bits > coefficient_limit ? bits - (std::int64_t{1} << coefficient_bits) : bits;
                }
            }
        } else if (share != share_none &&
                   (partner < 0 || orders[static_cast<std::size_t>(partner)] != order)) {
            damaged_chunk(QT_TRANSLATE_NOOP("errors", "its layout"));
        }
        read_rice(reader, values.data(), count);
        for (std::uint32_t& value : values) value = unzigzag(value);
        if (share == share_guided) {
            const auto columns_of_guides = guides_at(guides, order);
            for (std::size_t i = highest_order; i < count; ++i)
                values[i] += guided(coefficients[i / segment], columns_of_guides, i);
        } else if (share != share_none) {
            const Column& reference = residuals[static_cast<std::size_t>(partner)];
            for (std::size_t i = 0; i < count; ++i)
                values[i] += share == share_less ? reference[i] : 0U - reference[i];
        }
        // The residuals are kept for columns that have this one as partner; most have none.
        Column& restored = is_partner ? candidate : values;
        if (is_partner) candidate = values;
        for (unsigned pass = order; pass-- > 0;) restore(restored, pass);
        return restored;
    }

    static void skip_column(BitReader& reader, std::size_t count, const Guides& guides) {
        reader.take(2);
        if (reader.take(2) == share_guided) {
            for (std::size_t begin = 0; begin < count; begin += segment) {
                for (const int guide : guides) {
                    if (guide >= 0) reader.take(coefficient_bits);
                }
            }
        }
        skip_rice(reader, count);
    }

    /// Reads the columns of which `wanted` says where to, skips the others, stops after the last one wanted.
    template <typename Record, typename Wanted>
    void read_some(const TraceChunk& chunk, std::size_t last, Wanted wanted) {
        using Columns = Layout<Record>;
        residuals.resize(std::max(residuals.size(), Columns::columns));
        BitReader reader(plain.data() + header_size, plain.data() + plain.size());
        for (std::size_t column = 0; column <= last; ++column) {
            const Guides guides = Columns::guides(column);
            if (Column* out = wanted(column)) {
                *out = read_column(reader, column, chunk.count, -1, guides, false);
            } else {
                skip_column(reader, chunk.count, guides);
            }
        }
    }

    void decode_overview(const TraceChunk& samples, const TraceChunk* of_same_ticks,
                         TraceOverview& overview) {
        using Inputs = Layout<RigSample>;
        using Columns = Layout<TickSample>;
        if (of_same_ticks != nullptr) {
            unpack(*of_same_ticks, TraceStream::inputs, Inputs::fewest_columns, Inputs::columns);
            for (auto& order : inputs) {
                order.resize(Inputs::columns);
                for (Column& column : order) column.clear();  // differences are made when first asked for
            }
            constexpr std::size_t last = 2 + Inputs::device_columns + 2;
            read_some<RigSample>(*of_same_ticks, last, [&](std::size_t column) {
                const bool handle = column >= 2 && (column - 2) % Inputs::device_columns < 3;
                return handle ? &inputs[0][column] : nullptr;
            });
        }
        unpack(samples, TraceStream::samples, Columns::fewest_columns, Columns::columns);
        const bool paired = of_same_ticks != nullptr && of_same_ticks->count == samples.count &&
                            of_same_ticks->first_tick == samples.first_tick &&
                            of_same_ticks->last_tick == samples.last_tick;
        if (with_inputs && !paired)
            damaged_chunk(QT_TRANSLATE_NOOP("errors", "the inputs that it was made with are missing"));
        read_some<TickSample>(samples, Columns::hand_column(1, Columns::flags),
                              [&](std::size_t column) -> Column* {
                                  if (column == 0) return &overview.tick;
                                  if (column < Columns::hand_column(0, 0)) return nullptr;
                                  const std::size_t within = column - Columns::hand_column(0, 0);
                                  auto& hand = overview.hand[within / Columns::hand_columns];
                                  const std::size_t part = within % Columns::hand_columns;
                                  if (part < 3) return &hand.tip[part];
                                  if (part >= Columns::force && part < Columns::force + 3)
                                      return &hand.force[part - Columns::force];
                                  return part == Columns::flags ? &hand.flags : nullptr;
                              });
        if (overview.tick.front() != samples.first_tick || overview.tick.back() != samples.last_tick)
            damaged_chunk(QT_TRANSLATE_NOOP("errors", "its ticks"));
    }

    template <typename Record>
    TraceChunk encode(const Record* records, std::size_t count, const RigSample* of_same_ticks) {
        using Columns = Layout<Record>;
        if (count == 0 || count > chunk_maximum_records) {
            throw StoreError(StoreErrorKind::bad_value,
                             {QT_TRANSLATE_NOOP("errors", "a part of a recording holds 1 to %1 records"),
                              chunk_maximum_records},
                             QT_TRANSLATE_NOOP("errors", "split it"));
        }
        with_inputs = same_ticks(records, of_same_ticks, count);
        if (with_inputs) load_inputs(of_same_ticks, count);
        rows.resize(count * Columns::columns);
        residuals.resize(std::max(residuals.size(), Columns::columns));
        for (std::size_t i = 0; i < count; ++i) {
            ColumnWriter writer(rows.data() + i * Columns::columns);
            Columns::visit(writer, records[i]);
        }
        plain.clear();
        put_header(plain, Columns::stream, count, Columns::columns, with_inputs);
        BitWriter writer(plain);
        for (std::size_t column = 0; column < Columns::columns; ++column) {
            write_column(writer, column, Columns::columns, count, Columns::partner(column),
                         Columns::guides(column));
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
            throw StoreError(StoreErrorKind::failed, {"zstd: %1", ZSTD_getErrorName(size)},
                             QT_TRANSLATE_NOOP("errors", "free some memory"));
        }
        chunk.data.resize(size);
        chunk.checksum = blake2b(chunk.data, checksum_size);
        return chunk;
    }

    /// Returns how many columns the chunk has.
    std::size_t unpack(const TraceChunk& chunk, TraceStream stream, std::size_t fewest_columns,
                       std::size_t columns) {
        if (chunk.stream != stream) damaged_chunk(QT_TRANSLATE_NOOP("errors", "another stream"));
        if (chunk.data.size() > chunk_maximum_bytes || chunk.count == 0 ||
            chunk.count > chunk_maximum_records)
            damaged_chunk(QT_TRANSLATE_NOOP("errors", "its size"));
        if (chunk.checksum != blake2b(chunk.data, checksum_size))
            damaged_chunk(QT_TRANSLATE_NOOP("errors", "its checksum"));
        const std::size_t coefficients = (chunk.count / segment + 1) * 3 * coefficient_bits / 8 + 1;
        const std::size_t most = header_size + columns * (1 + coefficients + rice_bound(chunk.count));
        const unsigned long long announced = ZSTD_getFrameContentSize(chunk.data.data(), chunk.data.size());
        if (announced == ZSTD_CONTENTSIZE_ERROR || announced == ZSTD_CONTENTSIZE_UNKNOWN ||
            announced > most || announced < header_size) {
            damaged_chunk(QT_TRANSLATE_NOOP("errors", "its length"));
        }
        plain.resize(static_cast<std::size_t>(announced));
        const std::size_t size = ZSTD_decompressDCtx(decompressor, plain.data(), plain.size(),
                                                     chunk.data.data(), chunk.data.size());
        if (ZSTD_isError(size) != 0U || size != plain.size())
            damaged_chunk(QT_TRANSLATE_NOOP("errors", "its compression"));
        std::vector<std::uint8_t> header;
        with_inputs = plain[header_size - 1] == 1U;
        const std::size_t stored = plain[column_count_byte] == fewest_columns ? fewest_columns : columns;
        put_header(header, stream, chunk.count, stored, with_inputs);
        if (!std::equal(header.begin(), header.end(), plain.begin()))
            damaged_chunk(QT_TRANSLATE_NOOP("errors", "its header"));
        return stored;
    }

    template <typename Record>
    void decode(const TraceChunk& chunk, std::vector<Record>& records,
                const std::vector<RigSample>* all_inputs) {
        using Columns = Layout<Record>;
        const std::size_t stored = unpack(chunk, Columns::stream, Columns::fewest_columns, Columns::columns);
        const std::size_t count = chunk.count;
        if (with_inputs) {
            const RigSample* begin = nullptr;
            if (all_inputs != nullptr) {
                const auto found = std::lower_bound(
                    all_inputs->begin(), all_inputs->end(), chunk.first_tick,
                    [](const RigSample& input, std::uint32_t tick) { return input.tick < tick; });
                if (static_cast<std::size_t>(all_inputs->end() - found) >= count) begin = &*found;
            }
            if (begin == nullptr || begin->tick != chunk.first_tick ||
                begin[count - 1].tick != chunk.last_tick) {
                damaged_chunk(QT_TRANSLATE_NOOP("errors", "the inputs that it was made with are missing"));
            }
            load_inputs(begin, count);
        }
        rows.assign(count * Columns::columns, 0);
        residuals.resize(std::max(residuals.size(), Columns::columns));
        BitReader reader(plain.data() + header_size, plain.data() + plain.size());
        for (std::size_t column = 0; column < stored; ++column) {
            const Column& values = read_column(reader, column, count, Columns::partner(column),
                                               Columns::guides(column), is_partner<Columns>(column));
            for (std::size_t i = 0; i < count; ++i) rows[i * Columns::columns + column] = values[i];
        }
        if (!reader.at_end()) damaged_chunk(QT_TRANSLATE_NOOP("errors", "something follows its end"));
        std::vector<Record> decoded(count);
        for (std::size_t i = 0; i < count; ++i) {
            ColumnReader column_reader(rows.data() + i * Columns::columns);
            Columns::visit(column_reader, decoded[i]);
        }
        if (Columns::first_tick(decoded.front()) != chunk.first_tick ||
            Columns::last_tick(decoded.back()) != chunk.last_tick) {
            damaged_chunk(QT_TRANSLATE_NOOP("errors", "its ticks"));
        }
        records.insert(records.end(), decoded.begin(), decoded.end());
    }
};

TraceCodec::TraceCodec() : state_(std::make_unique<State>()) {}
TraceCodec::~TraceCodec() = default;
TraceChunk TraceCodec::encode(const TickSample* records, std::size_t count, const RigSample* inputs) {
    return state_->encode(records, count, inputs);
}
TraceChunk TraceCodec::encode(const RigSample* records, std::size_t count) {
    return state_->encode(records, count, nullptr);
}
TraceChunk TraceCodec::encode(const StepRecord* records, std::size_t count) {
    return state_->encode(records, count, nullptr);
}
TraceChunk TraceCodec::encode(const Event* records, std::size_t count) {
    return state_->encode(records, count, nullptr);
}
void TraceCodec::decode(const TraceChunk& chunk, std::vector<TickSample>& records,
                        const std::vector<RigSample>* inputs) {
    state_->decode(chunk, records, inputs);
}
void TraceCodec::decode(const TraceChunk& chunk, std::vector<RigSample>& records) {
    state_->decode(chunk, records, nullptr);
}
void TraceCodec::decode(const TraceChunk& chunk, std::vector<StepRecord>& records) {
    state_->decode(chunk, records, nullptr);
}
void TraceCodec::decode(const TraceChunk& chunk, std::vector<Event>& records) {
    state_->decode(chunk, records, nullptr);
}
void TraceCodec::decode_overview(const TraceChunk& samples, const TraceChunk* inputs,
                                 TraceOverview& overview) {
    state_->decode_overview(samples, inputs, overview);
}

std::shared_ptr<const RecordTicks> ticks_of(const std::shared_ptr<const Trace>& trace) {
    if (trace->ticks != nullptr) return trace->ticks;
    return std::make_shared<TicksInMemory>(trace, trace->inputs, trace->samples);
}

}  // namespace fulcrum::database
