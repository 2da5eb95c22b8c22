// SPDX-License-Identifier: GPL-3.0-or-later
// A difference: number of sections (a section goes from the beginning of one table to that of the next) and
// the length of each in `to`; a bit for each block of what both have of a section, 1: it changed; the changed
// blocks, each byte by exclusive or, and what `to` has more of each section.
#include "app/live/state_difference.h"

#include <algorithm>
#include <cstring>

#include "sim_core/numerics/state_archive.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t block = 64;  // bytes

[[noreturn]] void not_of_this_state() {
    throw StateArchiveError(
        QT_TRANSLATE_NOOP("errors",
                          "the stored state ends too early: it does not belong to this scene in this "
                          "version of the program"));
}

struct Section {
    const std::uint8_t* data = nullptr;
    std::size_t size = 0;
};

std::size_t sections_of(const StateImage& image) {
    return image.starts.size() + 1;
}

Section section(const StateImage& image, std::size_t number) {
    if (number > image.starts.size()) return {};
    const std::size_t from = number == 0 ? 0 : image.starts[number - 1];
    const std::size_t to = number == image.starts.size() ? image.bytes.size() : image.starts[number];
    return {image.bytes.data() + from, to - from};
}

void put_number(std::vector<std::uint8_t>& out, std::size_t number) {
    const auto value = static_cast<std::uint32_t>(number);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(&value);
    out.insert(out.end(), bytes, bytes + sizeof value);
}

void append_changed(const std::uint8_t* old, const std::uint8_t* now, std::size_t size,
                    std::vector<std::uint8_t>& out) {
    const std::size_t place = out.size();
    out.resize(place + size);
    for (std::size_t i = 0; i < size; ++i) out[place + i] = old[i] ^ now[i];
}

/// Reads a difference in order.
class DifferenceReader {
  public:
    explicit DifferenceReader(const std::vector<std::uint8_t>& bytes) : bytes_(bytes) {}
    const std::uint8_t* take(std::size_t size) {
        if (size > bytes_.size() - place_) not_of_this_state();
        place_ += size;
        return bytes_.data() + place_ - size;
    }
    std::size_t number() {
        std::uint32_t value = 0;
        std::memcpy(&value, take(sizeof value), sizeof value);
        return value;
    }
    bool at_end() const { return place_ == bytes_.size(); }

  private:
    const std::vector<std::uint8_t>& bytes_;
    std::size_t place_ = 0;
};

/// A bit for each block.
class ChangedBlocks {
  public:
    explicit ChangedBlocks(const std::uint8_t* bits) : bits_(bits) {}
    bool operator[](std::size_t number) const { return (bits_[number / 8] >> (number % 8) & 1U) != 0; }
    /// This block begins a byte of bits, and none of its eight changed.
    bool none_of_eight(std::size_t number) const { return number % 8 == 0 && bits_[number / 8] == 0; }

  private:
    const std::uint8_t* bits_;
};

/// The blocks of one section; `number` of the first, then of the one after the last.
void apply_changed(std::uint8_t* bytes, std::size_t size, const ChangedBlocks& changed, std::size_t& number,
                   DifferenceReader& reader) {
    for (std::size_t at = 0; at < size;) {
        const std::size_t left = size - at;
        if (left >= 8 * block && changed.none_of_eight(number)) {
            at += 8 * block;
            number += 8;
            continue;
        }
        const std::size_t here = std::min(block, left);
        if (changed[number]) {
            const std::uint8_t* other = reader.take(here);
            for (std::size_t i = 0; i < here; ++i) bytes[at + i] ^= other[i];
        }
        at += here;
        ++number;
    }
}

}  // namespace

std::vector<std::uint8_t> state_difference(const StateImage& from, const StateImage& to) {
    std::vector<std::uint8_t> out, changed;
    std::vector<bool> bits;
    const std::size_t count = sections_of(to);
    put_number(out, count);
    for (std::size_t s = 0; s < count; ++s) {
        const Section old = section(from, s), now = section(to, s);
        put_number(out, now.size);
        const std::size_t common = std::min(old.size, now.size);
        for (std::size_t at = 0; at < common; at += block) {
            const std::size_t size = std::min(block, common - at);
            const bool differs = std::memcmp(old.data + at, now.data + at, size) != 0;
            bits.push_back(differs);
            if (differs) append_changed(old.data + at, now.data + at, size, changed);
        }
        changed.insert(changed.end(), now.data + common, now.data + now.size);
    }
    const std::size_t place = out.size();
    out.resize(place + (bits.size() + 7) / 8);
    for (std::size_t i = 0; i < bits.size(); ++i)
        if (bits[i]) out[place + i / 8] |= static_cast<std::uint8_t>(1U << (i % 8));
    out.insert(out.end(), changed.begin(), changed.end());
    return out;
}

void apply_difference(StateImage& image, const std::vector<std::uint8_t>& difference, StateImage& spare) {
    DifferenceReader reader(difference);
    const std::size_t count = reader.number();
    if (count == 0 || count > difference.size()) not_of_this_state();
    std::vector<std::size_t> sizes(count);
    std::size_t blocks = 0, bytes = 0;
    bool same_places = count == sections_of(image);
    for (std::size_t s = 0; s < count; ++s) {
        sizes[s] = reader.number();
        const std::size_t had = section(image, s).size;
        if (sizes[s] > had + difference.size()) not_of_this_state();  // what it has more is in the difference
        blocks += (std::min(had, sizes[s]) + block - 1) / block;
        bytes += sizes[s];
        same_places = same_places && sizes[s] == had;
    }
    const ChangedBlocks changed(reader.take((blocks + 7) / 8));
    std::size_t place = 0, number = 0;
    if (same_places) {
        // Nothing moves, as between most frames: only what changed is written.
        for (std::size_t s = 0; s < count; ++s) {
            apply_changed(image.bytes.data() + place, sizes[s], changed, number, reader);
            place += sizes[s];
        }
    } else {
        spare.bytes.resize(bytes);
        spare.starts.clear();
        for (std::size_t s = 0; s < count; ++s) {
            if (s > 0) spare.starts.push_back(static_cast<std::uint32_t>(place));
            const Section old = section(image, s);
            const std::size_t common = std::min(old.size, sizes[s]);
            std::uint8_t* now = spare.bytes.data() + place;
            if (common > 0) std::memcpy(now, old.data, common);
            apply_changed(now, common, changed, number, reader);
            if (sizes[s] > common)
                std::memcpy(now + common, reader.take(sizes[s] - common), sizes[s] - common);
            place += sizes[s];
        }
        std::swap(image, spare);
    }
    if (!reader.at_end()) not_of_this_state();
}

}  // namespace fulcrum::app
