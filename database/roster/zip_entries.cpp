// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/roster/zip_entries.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "sim_core/numerics/input_error.h"

namespace fulcrum::database {
namespace {

// PKWARE APPNOTE 6.3: signatures, and how long the fixed parts are.
constexpr std::uint32_t local_mark = 0x04034b50, central_mark = 0x02014b50, end_mark = 0x06054b50;
constexpr std::size_t local_size = 30, central_size = 46, end_size = 22, longest_comment = 0xffff;
constexpr std::uint16_t encrypted_flag = 1, stored_method = 0, deflated_method = 8;
constexpr std::uint32_t in_zip64 = 0xffffffff;  // the value is elsewhere: larger than 4 GiB

/// One entry of the central directory.
struct ZipEntry {
    std::string name;
    std::uint16_t flags = 0, method = 0;
    std::uint32_t crc = 0, packed = 0, unpacked = 0, offset = 0;
};

class ZipReader {
  public:
    ZipReader(const std::string& bytes, const std::string& file) : bytes_(bytes), file_(file) {}

    std::map<std::string, std::string> read(const std::vector<std::string>& names) const {
        std::map<std::string, std::string> found;
        std::string folder;  // in which the first one was
        for (const ZipEntry& entry : directory()) {
            const std::size_t slash = entry.name.rfind('/');
            const std::string name = slash == std::string::npos ? entry.name : entry.name.substr(slash + 1);
            const std::string where = entry.name.substr(0, entry.name.size() - name.size());
            const bool at_top = std::count(where.begin(), where.end(), '/') <= 1 &&
                                (where.empty() || (where.front() != '/' && where.front() != '.'));
            if (!at_top || std::find(names.begin(), names.end(), name) == names.end()) continue;
            if (found.empty()) folder = where;
            if (where != folder || found.count(name) > 0)
                throw InputError(file_, name, QT_TRANSLATE_NOOP("errors", "is in the archive twice"),
                                 QT_TRANSLATE_NOOP("errors", "pack every file once, all in the same folder"));
            found[name] = unpacked(entry);
        }
        return found;
    }

  private:
    [[noreturn]] void damaged(const std::string& entry = {}) const {
        throw InputError(file_, entry, QT_TRANSLATE_NOOP("errors", "the archive is damaged or cut off"),
                         QT_TRANSLATE_NOOP("errors", "export it again, or unpack it and name the folder"));
    }
    /// Little endian; `size` bytes at `at`, which must lie within.
    std::uint32_t number(std::size_t at, std::size_t size) const {
        if (at > bytes_.size() || bytes_.size() - at < size) damaged();
        std::uint32_t value = 0;
        for (std::size_t i = size; i > 0; --i)
            value = value << 8U | static_cast<unsigned char>(bytes_[at + i - 1]);
        return value;
    }
    std::uint16_t two(std::size_t at) const { return static_cast<std::uint16_t>(number(at, 2)); }
    std::uint32_t four(std::size_t at) const { return number(at, 4); }
    std::string part(std::size_t at, std::size_t size) const {
        if (at > bytes_.size() || bytes_.size() - at < size) damaged();
        return bytes_.substr(at, size);
    }

    /// Where the record at the end begins: the last one whose comment fills the rest of the file.
    std::size_t find_end() const {
        if (bytes_.size() < end_size) damaged();
        const std::size_t last = bytes_.size() - end_size;
        const std::size_t first = last > longest_comment ? last - longest_comment : 0;
        for (std::size_t at = last;; --at) {
            if (four(at) == end_mark && two(at + 20) == last - at) return at;
            if (at == first) damaged();
        }
    }

    std::vector<ZipEntry> directory() const {
        const std::size_t end = find_end();
        const std::size_t count = two(end + 10);
        if (two(end + 4) != 0 || two(end + 6) != 0 || two(end + 8) != count)
            throw InputError(file_, "", QT_TRANSLATE_NOOP("errors", "the archive is in several parts"),
                             QT_TRANSLATE_NOOP("errors", "pack it in one file"));
        if (count > most_zip_entries)
            throw InputError(file_, "", {QT_TRANSLATE_NOOP("errors", "the archive has %1 files"), count},
                             QT_TRANSLATE_NOOP("errors", "pack the OneRoster files alone"));
        std::vector<ZipEntry> entries;
        std::size_t at = four(end + 16);
        for (std::size_t i = 0; i < count; ++i) {
            if (four(at) != central_mark) damaged();
            ZipEntry entry;
            entry.flags = two(at + 8);
            entry.method = two(at + 10);
            entry.crc = four(at + 16);
            entry.packed = four(at + 20);
            entry.unpacked = four(at + 24);
            entry.offset = four(at + 42);
            const std::size_t name = two(at + 28), extra = two(at + 30), comment = two(at + 32);
            entry.name = part(at + central_size, name);
            entries.push_back(std::move(entry));
            at += central_size + name + extra + comment;
        }
        return entries;
    }

    std::string unpacked(const ZipEntry& entry) const {
        const auto refuse = [&](const Sentence& problem, const Sentence& hint) {
            throw InputError(file_, entry.name, problem, hint);
        };
        if ((entry.flags & encrypted_flag) != 0)
            refuse(QT_TRANSLATE_NOOP("errors", "is encrypted"),
                   QT_TRANSLATE_NOOP("errors", "pack it without a password"));
        if (entry.method != stored_method && entry.method != deflated_method)
            refuse({QT_TRANSLATE_NOOP("errors", "is packed by another method (%1)"), entry.method},
                   QT_TRANSLATE_NOOP("errors", "pack it as an ordinary ZIP archive (deflate)"));
        if (entry.unpacked > largest_zip_entry || entry.packed == in_zip64)
            refuse(QT_TRANSLATE_NOOP("errors", "is larger than 16 MiB"),
                   QT_TRANSLATE_NOOP("errors", "split it into smaller files"));
        if (four(entry.offset) != local_mark) damaged(entry.name);
        const std::size_t data =
            std::size_t{entry.offset} + local_size + two(entry.offset + 26U) + two(entry.offset + 28U);
        const std::string packed = part(data, entry.packed);
        std::string content = entry.method == stored_method ? packed : inflated(packed, entry);
        if (content.size() != entry.unpacked) damaged(entry.name);
        const uLong crc =
            crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
        if (crc != entry.crc) damaged(entry.name);
        return content;
    }

    /// Never longer than the entry says.
    std::string inflated(const std::string& packed, const ZipEntry& entry) const {
        std::string content(std::size_t{entry.unpacked} + 1, '\0');  // one more would be too many
        z_stream stream = {};
        if (inflateInit2(&stream, -MAX_WBITS) != Z_OK) damaged(entry.name);
        stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
        stream.avail_in = static_cast<uInt>(packed.size());
        stream.next_out = reinterpret_cast<Bytef*>(content.data());
        stream.avail_out = static_cast<uInt>(content.size());
        const int result = inflate(&stream, Z_FINISH);
        const std::size_t written = content.size() - stream.avail_out;
        inflateEnd(&stream);
        if (result != Z_STREAM_END || written > entry.unpacked) damaged(entry.name);
        content.resize(written);
        return content;
    }

    const std::string& bytes_;
    const std::string& file_;
};

}  // namespace

bool is_zip(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    char head[4] = {};
    if (!in.read(head, sizeof head) || head[0] != 'P' || head[1] != 'K') return false;
    return (head[2] == 3 && head[3] == 4) || (head[2] == 5 && head[3] == 6);  // the second: without entries
}

std::map<std::string, std::string> parse_zip(const std::string& bytes, const std::string& file,
                                             const std::vector<std::string>& names) {
    return ZipReader(bytes, file).read(names);
}

std::map<std::string, std::string> zip_entries(const std::string& path,
                                               const std::vector<std::string>& names) {
    const std::string name = std::filesystem::path(path).filename().string();
    std::error_code error;
    std::ifstream in(path, std::ios::binary);
    if (!in || !std::filesystem::is_regular_file(path, error))
        throw InputError(path, "", QT_TRANSLATE_NOOP("errors", "cannot be read"),
                         QT_TRANSLATE_NOOP("errors", "name a file that exists and may be read"));
    if (std::filesystem::file_size(path, error) > largest_zip)
        throw InputError(name, "", QT_TRANSLATE_NOOP("errors", "is larger than 64 MiB"),
                         QT_TRANSLATE_NOOP("errors", "pack the OneRoster files alone"));
    return parse_zip({std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()}, name, names);
}

}  // namespace fulcrum::database
