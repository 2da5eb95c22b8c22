// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/rows/packed_bytes.h"

#include <zstd.h>

#include <string>

#include "database/rows/errors.h"

namespace fulcrum::database {
namespace {

[[noreturn]] void damaged(const Sentence& why) {
    throw StoreError(StoreErrorKind::corrupt,
                     {QT_TRANSLATE_NOOP("errors", "a stored state is damaged: %1"), why},
                     QT_TRANSLATE_NOOP("errors", "restore the newest backup"));
}

}  // namespace

std::vector<std::uint8_t> pack_bytes(const std::vector<std::uint8_t>& bytes, int level) {
    std::vector<std::uint8_t> packed(ZSTD_compressBound(bytes.size()));
    const std::size_t size = ZSTD_compress(packed.data(), packed.size(), bytes.data(), bytes.size(), level);
    if (ZSTD_isError(size) != 0U)
        throw StoreError(StoreErrorKind::failed, {"zstd: %1", ZSTD_getErrorName(size)},
                         QT_TRANSLATE_NOOP("errors", "close other programs: memory may be short"));
    packed.resize(size);
    packed.shrink_to_fit();
    return packed;
}

std::vector<std::uint8_t> unpack_bytes(const std::vector<std::uint8_t>& packed) {
    const unsigned long long announced = ZSTD_getFrameContentSize(packed.data(), packed.size());
    if (announced == ZSTD_CONTENTSIZE_ERROR || announced == ZSTD_CONTENTSIZE_UNKNOWN ||
        announced > packed_maximum_bytes)
        damaged(QT_TRANSLATE_NOOP("errors", "it does not say its size"));
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(announced));
    const std::size_t size = ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
    if (ZSTD_isError(size) != 0U) damaged(ZSTD_getErrorName(size));
    if (size != bytes.size()) damaged(QT_TRANSLATE_NOOP("errors", "it ends too early"));
    return bytes;
}

}  // namespace fulcrum::database
