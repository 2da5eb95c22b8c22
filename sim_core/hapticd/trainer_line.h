// SPDX-License-Identifier: Apache-2.0
// The lines of a trainer on a serial port (docs/TRAINER.md): text, whole numbers only, a checksum in each.
// Needs nothing but the standard library, and allocates nothing.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fulcrum::hapticd {

inline constexpr int trainer_version = 1;
inline constexpr std::size_t trainer_longest = 96;  ///< bytes of a line, without its end
inline constexpr std::size_t trainer_parts = 3;     ///< left hand, right hand, scope
inline constexpr char trainer_letters[trainer_parts] = {'L', 'R', 'S'};
inline constexpr int trainer_slowest = 20, trainer_fastest = 500;  ///< lines a second for each part

/// What a trainer is.
struct TrainerHello {
    std::array<char, 33> name{};  ///< printable ASCII, ends with 0
    int rate = 0;                 ///< lines a second for each part
    bool part[trainer_parts] = {};
};

/// Where one part is.
struct TrainerPose {
    std::size_t part = 0;
    std::uint16_t sequence = 0;      ///< rises by 1 with each line of the part, 0 after 65535
    std::uint32_t time_us = 0;       ///< clock of the trainer, 0 after 2^32 - 1
    double pitch = 0, yaw = 0;       ///< rad: the tip up, the tip to the right
    double insertion = 0, roll = 0;  ///< m from the pivot to the tip; rad, positive from trocar to tip
    double jaw = 0;                  ///< share of the opening
    std::uint32_t buttons = 0;       ///< DeviceButton mask
};

struct TrainerMessage {
    enum class Kind : std::uint8_t {
        nothing,         ///< no whole line yet
        hello,           ///< `hello` holds it
        pose,            ///< `pose` holds it
        wrong_checksum,  ///< a line that was changed on its path
        not_a_line,      ///< bytes that are no line of this protocol
        wrong_values,    ///< a field that is not a number, or out of its range
        other_version    ///< `version` holds it
    };
    Kind kind = Kind::nothing;
    TrainerHello hello;
    TrainerPose pose;
    int version = 0;
};

/// CRC-16/CCITT-FALSE: polynomial 0x1021, begins with 0xFFFF; 0x29B1 for "123456789".
std::uint16_t trainer_checksum(std::string_view bytes) noexcept;
/// With checksum and line end. `body`: "F1,?".
std::string trainer_line(std::string_view body);
/// A line without its end.
TrainerMessage read_trainer_line(std::string_view line) noexcept;

/// Cuts what arrives into lines.
class TrainerDecoder {
  public:
    /// Where the next bytes go, and how many fit; there is always room after next() returned nothing.
    char* space() noexcept { return bytes_.data() + end_; }
    std::size_t room() const noexcept { return bytes_.size() - end_; }
    void take(std::size_t count) noexcept { end_ += count; }
    TrainerMessage next() noexcept;
    void reset() noexcept {
        begin_ = end_ = 0;
        too_long_ = false;
    }

  private:
    std::array<char, 1024> bytes_{};
    std::size_t begin_ = 0, end_ = 0;
    bool too_long_ = false;  // until the end of this line nothing is used
};

}  // namespace fulcrum::hapticd
