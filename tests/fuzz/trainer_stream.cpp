// SPDX-License-Identifier: Apache-2.0
// For any bytes that a trainer's serial port gives, in pieces of any size: the decoder always takes more, and
// what it gives is finite, within its ranges, and is read the same from a line that is written from it.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include "sim_core/hapticd/trainer_line.h"

namespace {

using namespace fulcrum::hapticd;
using Kind = TrainerMessage::Kind;

void look_at(const TrainerMessage& message) {
    if (message.kind == Kind::hello) {
        const TrainerHello& hello = message.hello;
        const bool any =
            std::any_of(std::begin(hello.part), std::end(hello.part), [](bool has) { return has; });
        if (hello.name.back() != 0 || hello.rate < trainer_slowest || hello.rate > trainer_fastest || !any)
            std::abort();
    }
    if (message.kind != Kind::pose) return;
    const TrainerPose& pose = message.pose;
    for (const double value : {pose.pitch, pose.yaw, pose.insertion, pose.roll, pose.jaw})
        if (!std::isfinite(value)) std::abort();
    if (pose.part >= trainer_parts || std::abs(pose.pitch) > 1.5 || std::abs(pose.yaw) > 1.5 ||
        pose.insertion < 0 || pose.insertion > 0.4 || pose.jaw < 0 || pose.jaw > 1 || pose.buttons > 15)
        std::abort();
    const auto micro = [](double value) { return std::to_string(std::lround(1e6 * value)); };
    std::string line =
        trainer_line("F1,P," + std::to_string(pose.sequence) + "," + std::to_string(pose.time_us) + "," +
                     trainer_letters[pose.part] + "," + micro(pose.pitch) + "," + micro(pose.yaw) + "," +
                     micro(pose.insertion) + "," + micro(pose.roll) + "," +
                     std::to_string(std::lround(1e3 * pose.jaw)) + "," + std::to_string(pose.buttons));
    line.pop_back();
    const TrainerMessage again = read_trainer_line(line);
    if (again.kind != Kind::pose || again.pose.pitch != pose.pitch || again.pose.roll != pose.roll ||
        again.pose.sequence != pose.sequence || again.pose.part != pose.part)
        std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static TrainerDecoder decoder;
    decoder.reset();
    if (size == 0) return 0;
    // Lines as they come seldom have the right checksum: here each gets one, and the stream comes as it is.
    std::string_view all(reinterpret_cast<const char*>(data) + 1, size - 1);
    for (std::string_view rest = all; !rest.empty();) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest = line.size() < rest.size() ? rest.substr(line.size() + 1) : std::string_view();
        std::string signed_line = trainer_line(line.substr(0, line.find('*')));
        signed_line.pop_back();
        look_at(read_trainer_line(signed_line));
    }
    const std::size_t piece = std::size_t{data[0]} + 1;
    while (!all.empty()) {
        const std::size_t count = std::min({piece, all.size(), decoder.room()});
        if (count == 0) std::abort();
        std::memcpy(decoder.space(), all.data(), count);
        decoder.take(count);
        all.remove_prefix(count);
        for (TrainerMessage message = decoder.next(); message.kind != Kind::nothing; message = decoder.next())
            look_at(message);
    }
    return 0;
}
