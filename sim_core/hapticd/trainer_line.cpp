// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/trainer_line.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstring>

namespace fulcrum::hapticd {
namespace {

using Kind = TrainerMessage::Kind;
constexpr std::size_t checksum_digits = 4;
constexpr std::int64_t largest_angle = 1'500'000;          // µrad
constexpr std::int64_t largest_insertion = 400 * 1000;     // µm
constexpr std::int64_t largest_roll = 2000LL * 1'000'000;  // µrad
constexpr std::int64_t largest_jaw = 1000, largest_buttons = 15;

/// Takes fields off the front of a line; each but the last ends with a comma.
class Fields {
  public:
    explicit Fields(std::string_view rest) : rest_(rest) {}
    std::string_view text() noexcept {
        if (ended_) {
            good_ = false;
            return {};
        }
        const std::size_t comma = rest_.find(',');
        const std::string_view field = rest_.substr(0, comma);
        ended_ = comma == std::string_view::npos;
        rest_ = ended_ ? std::string_view() : rest_.substr(comma + 1);
        return field;
    }
    /// 0 and not good() where it is not a whole number from `least` to `most`.
    std::int64_t number(std::int64_t least, std::int64_t most) noexcept {
        const std::string_view field = text();
        std::int64_t value = 0;
        const char* const end = field.data() + field.size();
        const auto [stopped, error] = std::from_chars(field.data(), end, value);
        if (error == std::errc() && stopped == end && !field.empty() && value >= least && value <= most)
            return value;
        good_ = false;
        return 0;
    }
    void fail() noexcept { good_ = false; }
    /// All fields were read and each was good.
    bool complete() const noexcept { return good_ && ended_; }

  private:
    std::string_view rest_;
    bool ended_ = false, good_ = true;
};

std::size_t part_of(char letter) noexcept {
    return static_cast<std::size_t>(
        std::find(std::begin(trainer_letters), std::end(trainer_letters), letter) - trainer_letters);
}

Kind read_hello(Fields fields, TrainerHello& hello) noexcept {
    const std::string_view name = fields.text();
    const bool printable = std::all_of(name.begin(), name.end(), [](char c) { return c >= ' ' && c <= '~'; });
    if (name.empty() || name.size() >= hello.name.size() || !printable) return Kind::wrong_values;
    std::copy(name.begin(), name.end(), hello.name.begin());
    hello.rate = static_cast<int>(fields.number(trainer_slowest, trainer_fastest));
    const std::string_view letters = fields.text();
    if (letters.empty()) fields.fail();
    for (const char letter : letters) {
        const std::size_t part = part_of(letter);
        if (part == trainer_parts || hello.part[part]) {
            fields.fail();
            break;
        }
        hello.part[part] = true;
    }
    return fields.complete() ? Kind::hello : Kind::wrong_values;
}

Kind read_pose(Fields fields, TrainerPose& pose) noexcept {
    constexpr double micro = 1e-6, milli = 1e-3;
    pose.sequence = static_cast<std::uint16_t>(fields.number(0, UINT16_MAX));
    pose.time_us = static_cast<std::uint32_t>(fields.number(0, UINT32_MAX));
    const std::string_view letter = fields.text();
    pose.part = letter.size() == 1 ? part_of(letter.front()) : trainer_parts;
    pose.pitch = micro * static_cast<double>(fields.number(-largest_angle, largest_angle));
    pose.yaw = micro * static_cast<double>(fields.number(-largest_angle, largest_angle));
    pose.insertion = micro * static_cast<double>(fields.number(0, largest_insertion));
    pose.roll = micro * static_cast<double>(fields.number(-largest_roll, largest_roll));
    pose.jaw = milli * static_cast<double>(fields.number(0, largest_jaw));
    pose.buttons = static_cast<std::uint32_t>(fields.number(0, largest_buttons));
    return fields.complete() && pose.part < trainer_parts ? Kind::pose : Kind::wrong_values;
}

/// "F12,": 12; 0 where it begins with something else.
int version_of(std::string_view line) noexcept {
    int version = 0;
    if (line.size() < 3 || line.front() != 'F') return 0;
    const char* const end = line.data() + line.size();
    const auto [stopped, error] = std::from_chars(line.data() + 1, end, version);
    return error == std::errc() && stopped != end && *stopped == ',' && version > 0 ? version : 0;
}

}  // namespace

std::uint16_t trainer_checksum(std::string_view bytes) noexcept {
    std::uint32_t sum = 0xFFFF;
    for (const char byte : bytes) {
        sum ^= static_cast<std::uint32_t>(static_cast<unsigned char>(byte)) << 8U;
        for (int bit = 0; bit < 8; ++bit) sum = (sum & 0x8000U) != 0 ? (sum << 1U) ^ 0x1021U : sum << 1U;
        sum &= 0xFFFFU;
    }
    return static_cast<std::uint16_t>(sum);
}

std::string trainer_line(std::string_view body) {
    char end[8];
    std::snprintf(end, sizeof end, "*%04X\n", static_cast<unsigned>(trainer_checksum(body)));
    return std::string(body) + end;
}

TrainerMessage read_trainer_line(std::string_view line) noexcept {
    TrainerMessage message;
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    if (line.empty()) return message;
    message.kind = Kind::not_a_line;
    const int version = version_of(line);
    if (version == 0 || line.size() > trainer_longest || line.size() < checksum_digits + 2) return message;
    const std::size_t star = line.size() - checksum_digits - 1;
    if (line[star] != '*') return message;
    unsigned sum = 0;
    const char* const end = line.data() + line.size();
    const auto [stopped, error] = std::from_chars(line.data() + star + 1, end, sum, 16);
    if (error != std::errc() || stopped != end) return message;
    message.kind = Kind::wrong_checksum;
    line = line.substr(0, star);
    if (sum != trainer_checksum(line)) return message;
    message.version = version;
    message.kind = Kind::other_version;
    if (version != trainer_version) return message;
    Fields fields(line);
    fields.text();
    const std::string_view what = fields.text();
    message.kind = what == "H"   ? read_hello(fields, message.hello)
                   : what == "P" ? read_pose(fields, message.pose)
                                 : Kind::not_a_line;
    return message;
}

TrainerMessage TrainerDecoder::next() noexcept {
    while (begin_ < end_) {
        const char* const first = bytes_.data() + begin_;
        const void* const found = std::memchr(first, '\n', end_ - begin_);
        if (found == nullptr) break;
        const std::string_view line(first, static_cast<std::size_t>(static_cast<const char*>(found) - first));
        begin_ += line.size() + 1;
        if (too_long_) {
            too_long_ = false;
            continue;
        }
        const TrainerMessage message = read_trainer_line(line);
        if (message.kind != Kind::nothing) return message;
    }
    std::memmove(bytes_.data(), bytes_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
    TrainerMessage message;
    if (end_ > trainer_longest + 1) {
        if (!too_long_) message.kind = Kind::not_a_line;
        too_long_ = true;
        end_ = 0;
    }
    return message;
}

}  // namespace fulcrum::hapticd
