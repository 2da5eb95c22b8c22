// SPDX-License-Identifier: GPL-3.0-or-later
// Any stored chunk with a valid checksum is decoded to the count that it announces or refused as corrupt. The
// first bytes choose stream, count and ticks; the rest are the compressed bytes themselves or, so that
// mutations reach the layout behind the compression, the bytes to be compressed.
#include <zstd.h>

#include <cstddef>
#include <cstdint>

#include "database/rows/crypto.h"
#include "database/rows/errors.h"
#include "database/rows/trace_codec.h"

namespace {

template <typename Record>
void decode(fulcrum::database::TraceCodec& codec, const fulcrum::database::TraceChunk& chunk) {
    std::vector<Record> records;
    try {
        codec.decode(chunk, records);
        if (records.size() != chunk.count) __builtin_trap();
    } catch (const fulcrum::database::StoreError& error) {
        if (error.kind() != fulcrum::database::StoreErrorKind::corrupt) __builtin_trap();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace fulcrum::database;
    if (size < 8) return 0;
    static TraceCodec codec;
    TraceChunk chunk;
    chunk.stream = static_cast<TraceStream>(data[0] & 3U);
    const bool raw = (data[0] & 4U) != 0U;
    chunk.count = static_cast<std::uint32_t>(data[1]) | static_cast<std::uint32_t>(data[2]) << 8U;
    chunk.first_tick = static_cast<std::uint32_t>(data[3]) | static_cast<std::uint32_t>(data[4]) << 8U;
    chunk.last_tick =
        chunk.first_tick + (static_cast<std::uint32_t>(data[5]) | static_cast<std::uint32_t>(data[6]) << 8U);
    const std::uint8_t* rest = data + 8;
    const std::size_t length = size - 8;
    if (raw) {
        chunk.data.assign(rest, rest + length);
    } else {
        chunk.data.resize(ZSTD_compressBound(length));
        chunk.data.resize(ZSTD_compress(chunk.data.data(), chunk.data.size(), rest, length, 1));
    }
    chunk.checksum = blake2b(chunk.data, 16);
    switch (chunk.stream) {
        case TraceStream::samples:
            decode<fulcrum::TickSample>(codec, chunk);
            break;
        case TraceStream::inputs:
            decode<fulcrum::RigSample>(codec, chunk);
            break;
        case TraceStream::steps:
            decode<fulcrum::StepRecord>(codec, chunk);
            break;
        case TraceStream::events:
            decode<fulcrum::Event>(codec, chunk);
            break;
    }
    return 0;
}
