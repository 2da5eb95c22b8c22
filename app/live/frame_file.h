// SPDX-License-Identifier: GPL-3.0-or-later
// Key frames of a replay on the disk, so that the next opening has them at once (docs/FORMATS.md, Key frames
// of replays). Nothing depends on such a file: one that is missing, of another build, of another record, cut
// off or altered is as good as none, and is removed. Scores and `replay --verify` never read one.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace fulcrum::app {

using FrameDigest = std::array<std::uint8_t, 32>;

/// One key frame as FrameStore has it.
struct PackedFrame {
    std::uint32_t tick = 0;
    std::shared_ptr<const std::vector<std::uint8_t>> packed;
};

/// Where the frames of one record are kept, and what they have to belong to.
struct FrameKeeping {
    static constexpr std::uint64_t most_in_folder = std::uint64_t{2} << 30U;

    std::string folder;  ///< empty: nowhere
    std::string name;    ///< of the file in it
    FrameDigest belongs = {};
    std::uint64_t most_bytes = most_in_folder;  ///< of all files in the folder; those opened longest ago go

    bool wanted() const { return !folder.empty() && !name.empty(); }
    /// Removes the file.
    void forget() const noexcept;
};
/// What frames belong to: this very program (its version, its physics and the identity that the linker gave
/// it) and the `record`, a text that says all that decides the simulation.
FrameDigest frames_belong_to(const std::string& record);

/// A file opened for reading; constant, any thread. Frames are read when they are asked for.
class FrameFile {
  public:
    /// The file with its time set to now; null where there is none that belongs.
    static std::shared_ptr<const FrameFile> open(const FrameKeeping& keeping);
    ~FrameFile();
    FrameFile(const FrameFile&) = delete;
    FrameFile& operator=(const FrameFile&) = delete;

    std::size_t count() const { return entries_.size(); }
    std::uint32_t tick(std::size_t number) const { return entries_[number].tick; }
    /// Of the record; the frames are from a pass through all of it.
    std::uint32_t last_tick() const { return last_tick_; }
    std::uint64_t bytes() const { return bytes_; }
    /// Throws StateArchiveError where it cannot be read or does not match its checksum.
    std::vector<std::uint8_t> packed(std::size_t number) const;

  private:
    struct Entry {
        std::uint32_t tick = 0, size = 0;
        std::uint64_t place = 0;
        std::array<std::uint8_t, 16> checksum = {};
    };
    explicit FrameFile(int descriptor) : descriptor_(descriptor) {}
    bool read_table(const FrameDigest& belongs);

    const int descriptor_;
    std::uint32_t last_tick_ = 0;
    std::uint64_t bytes_ = 0;
    std::vector<Entry> entries_;
};

/// Writes a file in pieces, so that seeks need not wait for it. It has its name only when it is complete;
/// whatever prevents it (a full disk, a folder that may not be written) means that no frames are kept. Not
/// synced: after a power failure the checksums tell whether it arrived.
class FrameFileWriter {
  public:
    static constexpr std::size_t piece_bytes = 4U << 20U;

    FrameFileWriter(FrameKeeping keeping, std::vector<PackedFrame> frames, std::uint32_t last_tick);
    ~FrameFileWriter();
    FrameFileWriter(const FrameFileWriter&) = delete;
    FrameFileWriter& operator=(const FrameFileWriter&) = delete;

    /// Writes the next piece; false when there is nothing left to do.
    bool write_more();
    /// The file has its name.
    bool complete() const { return complete_; }

  private:
    bool begin();
    bool make_room(std::uint64_t bytes) const;
    void finish();

    const FrameKeeping keeping_;
    const std::vector<PackedFrame> frames_;
    const std::uint32_t last_tick_;
    std::string unfinished_;
    int folder_ = -1, file_ = -1;
    std::size_t next_ = 0;
    bool begun_ = false, complete_ = false;
};

}  // namespace fulcrum::app
