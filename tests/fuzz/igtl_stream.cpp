// SPDX-License-Identifier: Apache-2.0
// For any bytes that a peer sends over OpenIGTLink, in pieces of any size: messages whose contents are read
// within their bytes, and that encode to what was received.
#include <cstdlib>
#include <cstring>

#include "sim_core/igtl/content.h"

namespace {

using namespace fulcrum::igtl;

void read_content(const Message& message) {
    Transform transform;
    Position position;
    StartTracking start;
    Status status;
    std::string_view text;
    std::uint16_t encoding = 0;
    bool good = false;
    static Sensor sensor;
    if (read_transform(message.content, transform)) {
        const auto pose = pose_of(transform);
        if (pose && !pose->place.allFinite()) std::abort();
    }
    if (read_position(message.content, position)) {
        const auto pose = pose_of(position);
        if (pose && !pose->rotation.allFinite()) std::abort();
    }
    if (const auto count = count_of_tdata(message.content))
        for (std::size_t i = 0; i < *count; ++i)
            if (element_of_tdata(message.content, i).name.size() > device_size) std::abort();
    if (read_status(message.content, status) && status.text.size() > message.content.size) std::abort();
    if (read_string(message.content, text, encoding) && text.size() > message.content.size) std::abort();
    read_start_tracking(message.content, start);
    read_tracking_answer(message.content, good);
    read_sensor(message.content, sensor);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Decoder decoder;
    decoder.reset();
    if (size == 0) return 0;
    const std::size_t piece = std::size_t{data[0]} + 1;
    for (std::size_t at = 1; at < size;) {
        std::uint8_t* const space = decoder.space();
        const std::size_t count = std::min({piece, size - at, decoder.room()});
        if (count == 0) return 0;
        std::memcpy(space, data + at, count);
        decoder.take(count);
        at += count;
        Message message;
        for (auto found = decoder.next(message); found != Decoder::Found::nothing;
             found = decoder.next(message)) {
            if (found == Decoder::Found::broken) return 0;
            if (found != Decoder::Found::message) continue;
            read_content(message);
            Envelope envelope{message.type, message.device, message.time, message.version, message.id};
            envelope.meta_header = message.meta_header;
            envelope.meta = message.meta;
            static Bytes out;
            out.clear();
            append_message(out, envelope, message.content);
            const std::size_t body = message.content.size + message.meta_header.size + message.meta.size;
            if (out.size() - header_size < body) std::abort();
        }
    }
    return 0;
}
