// SPDX-License-Identifier: GPL-3.0-or-later
// In the machine's order of bytes, as the states themselves: a head (FileHead), a FileEntry for each frame,
// the BLAKE2b-256 of both, the packed frames one after the other.
#include "app/live/frame_file.h"

#include <dirent.h>
#include <fcntl.h>
#include <link.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <ctime>

#include "app/live/performance.h"
#include "database/rows/crypto.h"
#include "sim_core/numerics/state_archive.h"

namespace fulcrum::app {
namespace {

constexpr char format_word[8] = {'F', 'U', 'L', 'F', 'R', 'A', 'M', '1'};
constexpr const char* unfinished_word = ".new-";
constexpr std::time_t abandoned_after_s = 3600;    // an unfinished file that nobody will finish
constexpr std::uint64_t share_of_free_space = 10;  // a file takes at most this part: attempts need the disk

struct FileHead {
    char word[8];
    std::uint32_t frames, last_tick;
    std::uint8_t belongs[32];
};
struct FileEntry {
    std::uint32_t tick, size;
    std::uint8_t checksum[16];
};
static_assert(sizeof(FileHead) == 48 && sizeof(FileEntry) == 24);

[[noreturn]] void fail_altered() {
    throw StateArchiveError(
        QT_TRANSLATE_NOOP("errors", "a kept key frame cannot be read, or does not match its checksum"));
}

/// Our own folder that nobody else can write, or -1.
int open_frames_folder(const std::string& path) {
    const int folder = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    struct stat status {};
    if (folder < 0) return -1;
    if (::fstat(folder, &status) == 0 && status.st_uid == ::geteuid() &&
        (status.st_mode & (S_IWGRP | S_IWOTH)) == 0)
        return folder;
    ::close(folder);
    return -1;
}

bool read_exactly(int file, void* to, std::size_t size, std::uint64_t place) {
    auto* bytes = static_cast<std::uint8_t*>(to);
    while (size > 0) {
        const ssize_t got = ::pread(file, bytes, size, static_cast<off_t>(place));
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        bytes += got;
        size -= static_cast<std::size_t>(got);
        place += static_cast<std::uint64_t>(got);
    }
    return true;
}

bool write_exactly(int file, const std::vector<std::uint8_t>& bytes) {
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t put = ::write(file, bytes.data() + done, bytes.size() - done);
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) return false;
        done += static_cast<std::size_t>(put);
    }
    return true;
}

template <typename Value>
void append_value(std::vector<std::uint8_t>& out, const Value& value) {
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(&value);
    out.insert(out.end(), bytes, bytes + sizeof value);
}

/// Head and table with their checksum.
std::vector<std::uint8_t> table_of(const FrameDigest& belongs, const std::vector<PackedFrame>& frames,
                                   std::uint32_t last_tick) {
    std::vector<std::uint8_t> table;
    FileHead head = {};
    std::memcpy(head.word, format_word, sizeof head.word);
    head.frames = static_cast<std::uint32_t>(frames.size());
    head.last_tick = last_tick;
    std::memcpy(head.belongs, belongs.data(), belongs.size());
    append_value(table, head);
    for (const PackedFrame& frame : frames) {
        FileEntry entry = {};
        entry.tick = frame.tick;
        entry.size = static_cast<std::uint32_t>(frame.packed->size());
        const std::vector<std::uint8_t> checksum = database::blake2b(*frame.packed, sizeof entry.checksum);
        std::memcpy(entry.checksum, checksum.data(), sizeof entry.checksum);
        append_value(table, entry);
    }
    const std::vector<std::uint8_t> digest = database::blake2b(table);
    table.insert(table.end(), digest.begin(), digest.end());
    return table;
}

#if defined(__linux__)
int find_build_note(dl_phdr_info* info, std::size_t, void* found) {
    for (int i = 0; i < info->dlpi_phnum; ++i) {
        const auto& part = info->dlpi_phdr[i];
        if (part.p_type != PT_NOTE) continue;
        const auto* at = reinterpret_cast<const std::uint8_t*>(info->dlpi_addr + part.p_vaddr);
        const std::uint8_t* end = at + part.p_memsz;
        ElfW(Nhdr) note;
        while (at + sizeof note <= end) {
            std::memcpy(&note, at, sizeof note);
            const std::uint8_t* name = at + sizeof note;
            const std::uint8_t* text = name + (note.n_namesz + 3U) / 4 * 4;
            if (note.n_type == NT_GNU_BUILD_ID && text + note.n_descsz <= end)
                static_cast<std::vector<std::uint8_t>*>(found)->assign(text, text + note.n_descsz);
            at = text + (note.n_descsz + 3U) / 4 * 4;
        }
    }
    return 1;  // the program itself comes first
}
#endif

/// What the linker made of all that is in this program; empty where it made none.
std::string program_identity() {
    std::vector<std::uint8_t> note;
#if defined(__linux__)
    ::dl_iterate_phdr(find_build_note, &note);
#endif
    return database::to_hex(note);
}

}  // namespace

void FrameKeeping::forget() const noexcept {
    if (!wanted()) return;
    const int opened = open_frames_folder(folder);
    if (opened < 0) return;
    ::unlinkat(opened, name.c_str(), 0);
    ::close(opened);
}

FrameDigest frames_belong_to(const std::string& record) {
    static const std::string program = program_identity();
    const std::string text = state_build() + '\n' + program + '\n' + record;
    const std::vector<std::uint8_t> digest = database::blake2b(text.data(), text.size(), sizeof(FrameDigest));
    FrameDigest made;
    std::copy(digest.begin(), digest.end(), made.begin());
    return made;
}

std::shared_ptr<const FrameFile> FrameFile::open(const FrameKeeping& keeping) {
    if (!keeping.wanted()) return nullptr;
    const int folder = open_frames_folder(keeping.folder);
    if (folder < 0) return nullptr;
    // Not blocking: a pipe of that name would wait for a writer.
    const int descriptor =
        ::openat(folder, keeping.name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    const bool is_missing = descriptor < 0 && errno == ENOENT;
    ::close(folder);
    if (is_missing) return nullptr;
    if (descriptor >= 0) {
        const std::shared_ptr<FrameFile> file(new FrameFile(descriptor));
        if (file->read_table(keeping.belongs)) {
            ::futimens(descriptor, nullptr);
            return file;
        }
    }
    keeping.forget();
    return nullptr;
}

FrameFile::~FrameFile() {
    ::close(descriptor_);
}

bool FrameFile::read_table(const FrameDigest& belongs) {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0 || !S_ISREG(status.st_mode) || status.st_uid != ::geteuid())
        return false;
    bytes_ = static_cast<std::uint64_t>(status.st_size);
    FileHead head = {};
    if (!read_exactly(descriptor_, &head, sizeof head, 0) ||
        std::memcmp(head.word, format_word, sizeof head.word) != 0 ||
        std::memcmp(head.belongs, belongs.data(), belongs.size()) != 0)
        return false;
    constexpr std::size_t digest_bytes = sizeof(FrameDigest);
    const std::uint64_t table_bytes = sizeof head + std::uint64_t{head.frames} * sizeof(FileEntry);
    if (head.frames == 0 || table_bytes + digest_bytes > bytes_) return false;
    std::vector<std::uint8_t> table(table_bytes + digest_bytes);
    if (!read_exactly(descriptor_, table.data(), table.size(), 0)) return false;
    const std::vector<std::uint8_t> digest = database::blake2b(table.data(), table_bytes, digest_bytes);
    if (!std::equal(digest.begin(), digest.end(), table.begin() + static_cast<std::ptrdiff_t>(table_bytes)))
        return false;
    std::uint64_t place = table.size();
    entries_.reserve(head.frames);
    for (std::uint32_t i = 0; i < head.frames; ++i) {
        FileEntry entry;
        std::memcpy(&entry, table.data() + sizeof head + i * sizeof entry, sizeof entry);
        if (!entries_.empty() && entry.tick <= entries_.back().tick) return false;
        entries_.push_back({entry.tick, entry.size, place, {}});
        std::copy(std::begin(entry.checksum), std::end(entry.checksum), entries_.back().checksum.begin());
        place += entry.size;
    }
    last_tick_ = head.last_tick;
    return place == bytes_ && entries_.back().tick <= last_tick_;
}

std::vector<std::uint8_t> FrameFile::packed(std::size_t number) const {
    const Entry& entry = entries_.at(number);  // read_table(): all sizes together are the file's
    std::vector<std::uint8_t> bytes(entry.size);
    if (!read_exactly(descriptor_, bytes.data(), bytes.size(), entry.place)) fail_altered();
    const std::vector<std::uint8_t> checksum = database::blake2b(bytes, entry.checksum.size());
    if (!std::equal(checksum.begin(), checksum.end(), entry.checksum.begin())) fail_altered();
    return bytes;
}

FrameFileWriter::FrameFileWriter(FrameKeeping keeping, std::vector<PackedFrame> frames,
                                 std::uint32_t last_tick)
    : keeping_(std::move(keeping)), frames_(std::move(frames)), last_tick_(last_tick) {}

FrameFileWriter::~FrameFileWriter() {
    if (file_ >= 0) {
        ::close(file_);
        ::unlinkat(folder_, unfinished_.c_str(), 0);
    }
    if (folder_ >= 0) ::close(folder_);
}

bool FrameFileWriter::write_more() {
    if (!begun_) {
        begun_ = true;
        return begin();
    }
    if (file_ < 0) return false;
    std::vector<std::uint8_t> piece;
    while (next_ < frames_.size() && piece.size() < piece_bytes) {
        const std::vector<std::uint8_t>& packed = *frames_[next_++].packed;
        piece.insert(piece.end(), packed.begin(), packed.end());
    }
    if (write_exactly(file_, piece)) {
        if (next_ < frames_.size()) return true;
        finish();
    }
    return false;
}

bool FrameFileWriter::begin() {
    if (!keeping_.wanted() || frames_.empty()) return false;
    ::mkdir(keeping_.folder.c_str(), 0700);
    folder_ = open_frames_folder(keeping_.folder);
    if (folder_ < 0) return false;
    const std::vector<std::uint8_t> table = table_of(keeping_.belongs, frames_, last_tick_);
    std::uint64_t bytes = table.size();
    for (const PackedFrame& frame : frames_) bytes += frame.packed->size();
    if (!make_room(bytes)) return false;
    static std::atomic<int> number{0};
    unfinished_ =
        keeping_.name + unfinished_word + std::to_string(::getpid()) + '-' + std::to_string(++number);
    file_ =
        ::openat(folder_, unfinished_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0600);
    return file_ >= 0 && write_exactly(file_, table);
}

/// Removes what was opened longest ago until a file of this size keeps the folder within its bound.
bool FrameFileWriter::make_room(std::uint64_t bytes) const {
    struct statvfs disk {};
    if (::fstatvfs(folder_, &disk) != 0 ||
        bytes > std::uint64_t{disk.f_bavail} * disk.f_frsize / share_of_free_space)
        return false;
    struct Kept {
        std::int64_t opened;
        std::string name;
        std::uint64_t bytes;
    };
    std::vector<Kept> all;
    std::uint64_t sum = bytes;
    DIR* listing = ::fdopendir(::dup(folder_));
    if (listing == nullptr) return false;
    while (const dirent* entry = ::readdir(listing)) {
        struct stat status {};
        const std::string name = entry->d_name;
        if (::fstatat(folder_, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0 || !S_ISREG(status.st_mode))
            continue;
        if (name.find(unfinished_word) != std::string::npos) {
            if (status.st_mtime + abandoned_after_s < ::time(nullptr)) ::unlinkat(folder_, name.c_str(), 0);
            continue;
        }
        if (name == keeping_.name) continue;  // is replaced
        all.push_back({status.st_mtim.tv_sec * std::int64_t{1000000000} + status.st_mtim.tv_nsec, name,
                       static_cast<std::uint64_t>(status.st_size)});
        sum += all.back().bytes;
    }
    ::closedir(listing);
    if (bytes > keeping_.most_bytes) return false;
    std::sort(all.begin(), all.end(), [](const Kept& a, const Kept& b) { return a.opened < b.opened; });
    for (const Kept& one : all) {
        if (sum <= keeping_.most_bytes) break;
        if (::unlinkat(folder_, one.name.c_str(), 0) == 0) sum -= one.bytes;
    }
    return sum <= keeping_.most_bytes;
}

void FrameFileWriter::finish() {
    ::close(file_);
    file_ = -1;
    complete_ = ::renameat(folder_, unfinished_.c_str(), folder_, keeping_.name.c_str()) == 0;
    if (!complete_) ::unlinkat(folder_, unfinished_.c_str(), 0);
}

}  // namespace fulcrum::app
