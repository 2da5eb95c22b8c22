// SPDX-License-Identifier: Apache-2.0
#include "sim_core/igtl/message.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "sim_core/igtl/content.h"
#include "sim_core/igtl/crc64.h"
#include "tests/sim_core/igtl/golden_messages.h"
#include "tests/support/allocation_count.h"

namespace fulcrum::igtl {
namespace {

namespace golden = test::golden;
using Found = Decoder::Found;

Bytes from_hex(const std::string& text) {
    Bytes bytes;
    for (std::size_t i = 0; i + 1 < text.size(); i += 2)
        bytes.push_back(static_cast<std::uint8_t>(std::stoi(text.substr(i, 2), nullptr, 16)));
    return bytes;
}

/// What came out of a stream, copied.
struct Taken {
    Found found = Found::nothing;
    std::string type, device;
    std::uint16_t version = 0;
    std::uint64_t time = 0;
    std::uint32_t id = 0;
    Bytes content, meta_header, meta;
};
Bytes copied(ByteView view) {
    return view.size == 0 ? Bytes() : Bytes(view.data, view.data + view.size);
}

/// Feeds the bytes in pieces of this size and takes everything out that there is.
std::vector<Taken> decode(const Bytes& bytes, std::size_t piece, Decoder& decoder) {
    std::vector<Taken> all;
    for (std::size_t at = 0; at < bytes.size();) {
        std::uint8_t* const space = decoder.space();
        const std::size_t count = std::min({piece, bytes.size() - at, decoder.room()});
        if (count == 0) break;
        std::memcpy(space, bytes.data() + at, count);
        decoder.take(count);
        at += count;
        Message message;
        for (Found found = decoder.next(message); found != Found::nothing; found = decoder.next(message)) {
            all.push_back({found, std::string(message.type), std::string(message.device), message.version,
                           message.time, message.id, copied(message.content), copied(message.meta_header),
                           copied(message.meta)});
            if (found == Found::broken) return all;
        }
    }
    return all;
}
std::vector<Taken> decode(const Bytes& bytes, std::size_t piece = 65536) {
    Decoder decoder;
    return decode(bytes, piece, decoder);
}

Bytes encoded(const Taken& taken) {
    Envelope envelope{taken.type, taken.device, taken.time, taken.version, taken.id};
    envelope.meta_header = {taken.meta_header.data(), taken.meta_header.size()};
    envelope.meta = {taken.meta.data(), taken.meta.size()};
    Bytes out;
    append_message(out, envelope, {taken.content.data(), taken.content.size()});
    return out;
}

constexpr const char* all_golden[] = {golden::transform_1, golden::transform_2, golden::tdata_1,
                                      golden::tdata_2,     golden::status_1,    golden::string_1,
                                      golden::sensor_1,    golden::position_1};

TEST(IgtlMessage, ChecksumIsThatOfTheStandard) {
    const std::string digits = "123456789";  // the check value of CRC-64/ECMA-182
    EXPECT_EQ(crc64(reinterpret_cast<const std::uint8_t*>(digits.data()), digits.size()),
              0x6C40DF5F0B497347ULL);
}

TEST(IgtlMessage, EveryGoldenMessageIsDecodedAndEncodedToTheSameBytes) {
    for (const char* text : all_golden) {
        const Bytes bytes = from_hex(text);
        const std::vector<Taken> taken = decode(bytes);
        ASSERT_EQ(taken.size(), 1U) << text;
        EXPECT_EQ(taken[0].found, Found::message) << text;
        EXPECT_EQ(taken[0].device, "DeviceName");
        EXPECT_EQ(taken[0].time, 1234567892ULL);
        EXPECT_EQ(encoded(taken[0]), bytes) << text;
    }
}

TEST(IgtlMessage, ContentsOfTheGoldenMessagesAreRead) {
    const std::array<float, 12> pose = {-0.954892F, 0.196632F, -0.222525F,  -0.196632F, 0.142857F, 0.970014F,
                                        0.222525F,  0.970014F, -0.0977491F, 46.0531F,   19.4709F,  46.0531F};
    const auto is_that = [&](const Transform& read) {
        for (std::size_t i = 0; i < pose.size(); ++i) EXPECT_NEAR(read.values[i], pose[i], 1e-4) << i;
    };
    for (const char* text : {golden::transform_1, golden::transform_2}) {
        Transform transform;
        const Taken taken = decode(from_hex(text))[0];
        ASSERT_TRUE(read_transform({taken.content.data(), taken.content.size()}, transform));
        is_that(transform);
        const auto si = pose_of(transform);
        ASSERT_TRUE(si);
        EXPECT_NEAR(si->place.x(), 0.0460531, 1e-7);
        EXPECT_LT((si->rotation.transpose() * si->rotation - Matrix3::Identity()).norm(), 1e-12);
    }
    for (const char* text : {golden::tdata_1, golden::tdata_2}) {
        const Taken taken = decode(from_hex(text))[0];
        const ByteView content{taken.content.data(), taken.content.size()};
        ASSERT_EQ(count_of_tdata(content), 3U);
        for (std::size_t i = 0; i < 3; ++i) {
            const Tracked tracked = element_of_tdata(content, i);
            EXPECT_EQ(tracked.name, "Tracker" + std::to_string(i));
            EXPECT_EQ(tracked.kind, 2);
            is_that(tracked.transform);
        }
    }
    const auto content_of = [](const Taken& taken) {
        return ByteView{taken.content.data(), taken.content.size()};
    };
    const Taken status_message = decode(from_hex(golden::status_1))[0];
    Status status;
    ASSERT_TRUE(read_status(content_of(status_message), status));
    EXPECT_EQ(status.code, 15);
    EXPECT_EQ(status.subcode, 10);
    EXPECT_EQ(status.name, "ACTUATOR_DISABLED");
    EXPECT_EQ(status.text, "Actuator A is disabled.");
    const Taken string_message = decode(from_hex(golden::string_1))[0];
    std::string_view words;
    std::uint16_t encoding = 0;
    ASSERT_TRUE(read_string(content_of(string_message), words, encoding));
    EXPECT_EQ(words, "Welcome to OpenIGTLink");
    EXPECT_EQ(encoding, 3);
    const Taken sensor_message = decode(from_hex(golden::sensor_1))[0];
    Sensor sensor;
    ASSERT_TRUE(read_sensor(content_of(sensor_message), sensor));
    EXPECT_EQ(sensor.count, 6);
    EXPECT_EQ(sensor.unit, 0x00443e0000000000ULL) << "m/s2";
    EXPECT_DOUBLE_EQ(sensor.values[0], 123456.78);
    EXPECT_DOUBLE_EQ(sensor.values[1], 12345.678);
    const Taken position_message = decode(from_hex(golden::position_1))[0];
    Position position;
    ASSERT_TRUE(read_position(content_of(position_message), position));
    EXPECT_NEAR(position.place[1], 19.4709F, 1e-4);
    EXPECT_NEAR(position.quaternion[3], 1.0F / 3, 1e-6);
    EXPECT_FALSE(pose_of(position)) << "its quaternion has the length 0.88";
}

TEST(IgtlMessage, OurOwnEncodersMakeTheGoldenBytes) {
    constexpr std::uint64_t time = 1234567892ULL;
    const auto content_of = [](const Taken& taken) {
        return ByteView{taken.content.data(), taken.content.size()};
    };
    Bytes out;
    Transform transform;
    const Taken one = decode(from_hex(golden::transform_1))[0];
    ASSERT_TRUE(read_transform(content_of(one), transform));
    append_transform(out, "DeviceName", time, transform);
    EXPECT_EQ(out, from_hex(golden::transform_1));
    out.clear();
    const Tracked tracked[] = {
        {"Tracker0", 2, transform}, {"Tracker1", 2, transform}, {"Tracker2", 2, transform}};
    append_tdata(out, "DeviceName", time, tracked, 3);
    EXPECT_EQ(out, from_hex(golden::tdata_1));
    out.clear();
    append_status(out, "DeviceName", time, {15, 10, "ACTUATOR_DISABLED", "Actuator A is disabled."});
    EXPECT_EQ(out, from_hex(golden::status_1));
    out.clear();
    append_string(out, "DeviceName", time, "Welcome to OpenIGTLink");
    EXPECT_EQ(out, from_hex(golden::string_1));
    out.clear();
    const Taken two = decode(from_hex(golden::sensor_1))[0];
    Sensor sensor;
    ASSERT_TRUE(read_sensor(content_of(two), sensor));
    append_sensor(out, "DeviceName", time, sensor.values.data(), sensor.count, sensor.unit);
    EXPECT_EQ(out, from_hex(golden::sensor_1));
    out.clear();
    const Taken three = decode(from_hex(golden::position_1))[0];
    Position position;
    ASSERT_TRUE(read_position(content_of(three), position));
    append_position(out, "DeviceName", time, position);
    EXPECT_EQ(out, from_hex(golden::position_1));
}

TEST(IgtlMessage, AnyFlippedBitOfABodyOrItsChecksumIsRefused) {
    for (const char* text : all_golden) {
        const Bytes good = from_hex(text);
        for (std::size_t at = 50; at < good.size(); ++at) {
            for (unsigned int bit = 0; bit < 8; ++bit) {
                Bytes bad = good;
                bad[at] = static_cast<std::uint8_t>(bad[at] ^ (1U << bit));
                const std::vector<Taken> taken = decode(bad);
                ASSERT_EQ(taken.size(), 1U);
                ASSERT_EQ(taken[0].found, Found::wrong_checksum) << text << " byte " << at;
            }
        }
    }
}

TEST(IgtlMessage, AFlippedBitOfTheHeaderChangesNothingButWhatItSays) {
    // The checksum does not cover the header: what is left is that such a message never gives another body.
    const Bytes good = from_hex(golden::transform_1);
    const Bytes body(good.begin() + header_size, good.end());
    for (std::size_t at = 0; at < 50; ++at) {
        for (unsigned int bit = 0; bit < 8; ++bit) {
            Bytes bad = good;
            bad[at] = static_cast<std::uint8_t>(bad[at] ^ (1U << bit));
            bad.resize(header_size + largest_body + 64, 0x41);  // of a longer body there are enough bytes
            for (const Taken& taken : decode(bad)) {
                if (taken.found != Found::message) continue;
                EXPECT_EQ(taken.content, body) << at;
            }
        }
    }
}

TEST(IgtlMessage, CutOffAnywhereThereIsNoMessageAndTheRestCompletesIt) {
    for (const char* text : all_golden) {
        const Bytes bytes = from_hex(text);
        for (std::size_t cut = 0; cut < bytes.size(); ++cut) {
            Decoder decoder;
            const auto middle = bytes.begin() + static_cast<std::ptrdiff_t>(cut);
            EXPECT_TRUE(decode(Bytes(bytes.begin(), middle), 65536, decoder).empty());
            const std::vector<Taken> rest = decode(Bytes(middle, bytes.end()), 65536, decoder);
            ASSERT_EQ(rest.size(), 1U) << text << " cut at " << cut;
            EXPECT_EQ(rest[0].found, Found::message);
        }
    }
}

TEST(IgtlMessage, AWrongChecksumDoesNotLoseTheNextMessage) {
    const Bytes good = from_hex(golden::transform_1);
    Bytes stream = good;
    stream.back() ^= 1U;
    stream.insert(stream.end(), good.begin(), good.end());
    const std::vector<Taken> taken = decode(stream, 7);
    ASSERT_EQ(taken.size(), 2U);
    EXPECT_EQ(taken[0].found, Found::wrong_checksum);
    EXPECT_EQ(taken[1].found, Found::message);
}

TEST(IgtlMessage, ALongBodyIsSkippedAndALongerOneEndsTheStream) {
    const Bytes good = from_hex(golden::transform_1);
    const auto with_size = [&](std::uint64_t size) {
        Bytes header(good.begin(), good.begin() + header_size);
        for (std::size_t i = 0; i < 8; ++i)
            header[42 + i] = static_cast<std::uint8_t>(size >> (8U * (7 - i)));
        return header;
    };
    Bytes stream = with_size(3 * largest_body + 11);  // an image, say
    stream.resize(stream.size() + 3 * largest_body + 11, 0xff);
    stream.insert(stream.end(), good.begin(), good.end());
    const std::vector<Taken> taken = decode(stream, 5000);
    ASSERT_EQ(taken.size(), 2U);
    EXPECT_EQ(taken[0].found, Found::skipped);
    EXPECT_EQ(taken[1].found, Found::message);
    for (const std::uint64_t size : {longest_skip + 1, ~std::uint64_t{0}}) {
        const std::vector<Taken> broken = decode(with_size(size));
        ASSERT_EQ(broken.size(), 1U);
        EXPECT_EQ(broken[0].found, Found::broken);
    }
}

TEST(IgtlMessage, OtherProtocolsAreNoticedAtTheirFirstBytes) {
    for (const std::string& text : {std::string("GET / HTTP/1.1\r\n\r\n"), std::string("{\"a\":1}"),
                                    std::string("\0\0", 2), std::string("\xff\xff", 2)}) {
        const std::vector<Taken> taken = decode(Bytes(text.begin(), text.end()));
        ASSERT_EQ(taken.size(), 1U) << text;
        EXPECT_EQ(taken[0].found, Found::broken);
    }
}

TEST(IgtlMessage, ExtendedHeadersThatDoNotFitTheBodyAreRefused) {
    const Taken good = decode(from_hex(golden::transform_2))[0];
    const Bytes whole = from_hex(golden::transform_2);
    const Bytes body(whole.begin() + header_size, whole.end());
    // A version 1 message with this body has no extended header: append it as version 2 by hand.
    const auto found_for = [&](std::size_t at, std::uint8_t value) {
        Bytes changed = body;
        changed[at] = value;
        Bytes message;
        append_message(message, {"TRANSFORM", "x", 0, 1}, {changed.data(), changed.size()});
        message[1] = 2;
        const std::vector<Taken> taken = decode(message);
        return taken.empty() ? Found::nothing : taken[0].found;
    };
    EXPECT_EQ(found_for(1, body[1]), Found::message);
    EXPECT_EQ(found_for(0, 0xff), Found::wrong_content) << "extended header longer than the body";
    EXPECT_EQ(found_for(1, 4), Found::wrong_content) << "shorter than it is";
    EXPECT_EQ(found_for(2, 0xff), Found::wrong_content) << "table of the metadata";
    EXPECT_EQ(found_for(4, 0xff), Found::wrong_content) << "metadata";
    EXPECT_EQ(found_for(7, 1), Found::wrong_content) << "metadata that its table does not have";
    EXPECT_EQ(good.id, 1U);
}

TEST(IgtlMessage, ReadingAllocatesNothingWhateverTheBytesSay) {
    Decoder decoder;
    Bytes stream;
    for (const char* text : all_golden) {
        const Bytes bytes = from_hex(text);
        stream.insert(stream.end(), bytes.begin(), bytes.end());
    }
    Bytes hostile = from_hex(golden::sensor_1);
    hostile[58] = 255;  // so many numbers, in a body of 58 bytes
    stream.insert(stream.end(), hostile.begin(), hostile.end());
    std::size_t messages = 0;
    const std::uint64_t made = test::allocations_in([&] {
        for (std::size_t at = 0; at < stream.size(); at += 13) {
            const std::size_t size = std::min<std::size_t>(13, stream.size() - at);
            std::memcpy(decoder.space(), stream.data() + at, size);
            decoder.take(size);
            Message message;
            for (Found found = decoder.next(message); found != Found::nothing; found = decoder.next(message))
                messages += found == Found::message ? 1 : 0;
        }
    });
    EXPECT_EQ(made, 0U);
    EXPECT_EQ(messages, std::size(all_golden));
}

TEST(IgtlMessage, ATimeComesBackToTheNanosecond) {
    for (const std::int64_t ns : {0LL, 1LL, 999'999'999LL, 1'000'000'000LL, 1'764'115'200'123'456'789LL})
        EXPECT_EQ(ns_of(timestamp_of(ns)), ns);
    EXPECT_EQ(timestamp_of(-5), 0U);
    EXPECT_EQ(timestamp_of(1'500'000'000), 3ULL << 31U);
}

RC_GTEST_PROP(IgtlMessageProperty, DecodeUndoesEncodeInPiecesOfAnySize, ()) {
    const auto name = [](std::size_t longest) {
        return rc::gen::map(rc::gen::nonEmpty(rc::gen::container<std::string>(rc::gen::inRange('A', 'z'))),
                            [longest](const std::string& text) { return text.substr(0, longest); });
    };
    std::vector<Taken> sent;
    Bytes stream;
    const int count = *rc::gen::inRange(1, 6);
    for (int i = 0; i < count; ++i) {
        Taken one;
        one.found = Found::message;
        one.type = *name(type_size);
        one.device = *name(device_size);
        one.version = *rc::gen::inRange<std::uint16_t>(1, 4);
        one.time = *rc::gen::arbitrary<std::uint64_t>();
        one.content = *rc::gen::arbitrary<Bytes>();
        if (one.version >= 2) {
            one.id = *rc::gen::arbitrary<std::uint32_t>();
            one.meta = *rc::gen::resize(40, rc::gen::arbitrary<Bytes>());
            if (!one.meta.empty())
                one.meta_header = {0, 1, 0, 0, 0, 3, 0, 0, 0, static_cast<std::uint8_t>(one.meta.size())};
        }
        const Bytes bytes = encoded(one);
        stream.insert(stream.end(), bytes.begin(), bytes.end());
        sent.push_back(one);
    }
    const std::vector<Taken> got = decode(stream, *rc::gen::inRange<std::size_t>(1, 200));
    RC_ASSERT(got.size() == sent.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
        RC_ASSERT(got[i].found == Found::message);
        RC_ASSERT(encoded(got[i]) == encoded(sent[i]));
    }
}

RC_GTEST_PROP(IgtlMessageProperty, BytesOfAnyKindEndInOneOfTheAnswers, (const Bytes& noise)) {
    // Behind a good header, so that not every case ends at the version.
    Bytes stream = from_hex(golden::transform_2);
    stream.resize(header_size);
    stream.insert(stream.end(), noise.begin(), noise.end());
    for (const Taken& taken : decode(stream, 17)) RC_ASSERT(taken.found != Found::nothing);
}

RC_GTEST_PROP(IgtlMessageProperty, APoseComesBackToThePrecisionOfItsFloats, ()) {
    const auto number = [] { return *rc::gen::inRange(-1000000, 1000001) * 1e-6; };
    Pose pose;
    Quaternion turn(number(), number(), number(), number());
    if (turn.norm() < 1e-3) turn = Quaternion::Identity();
    pose.rotation = turn.normalized().toRotationMatrix();
    pose.place = Vector3(number(), number(), number());
    const auto back = pose_of(transform_of(pose));
    RC_ASSERT(back.has_value());
    RC_ASSERT((back->rotation - pose.rotation).cwiseAbs().maxCoeff() < 3e-7);
    RC_ASSERT((back->place - pose.place).cwiseAbs().maxCoeff() < 1e-7);
}

TEST(IgtlContent, PosesThatAreNoneAreRefused) {
    const auto with = [](std::size_t at, float value) {
        Transform transform;
        transform.values[at] = value;
        return transform;
    };
    EXPECT_TRUE(pose_of(Transform()));
    EXPECT_FALSE(pose_of(with(0, std::numeric_limits<float>::quiet_NaN())));
    EXPECT_FALSE(pose_of(with(11, std::numeric_limits<float>::infinity())));
    EXPECT_FALSE(pose_of(with(4, 1.1F))) << "stretched";
    EXPECT_FALSE(pose_of(with(1, 0.5F))) << "sheared";
    EXPECT_FALSE(pose_of(with(8, -1))) << "mirrored";
    EXPECT_FALSE(pose_of(with(0, 0))) << "no length";
    EXPECT_FALSE(pose_of(with(0, std::numeric_limits<float>::max())));
    Position position;
    EXPECT_TRUE(pose_of(position));
    position.quaternion[3] = 0.9F;
    EXPECT_FALSE(pose_of(position));
    position.quaternion[3] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(pose_of(position));
    position.quaternion = {0, 0, 0, 1};
    position.place[0] = std::numeric_limits<float>::infinity();
    EXPECT_FALSE(pose_of(position));
}

TEST(IgtlContent, ContentsOfAnotherSizeAreRefused) {
    Bytes bytes(3000, 0);
    Transform transform;
    Position position;
    StartTracking start;
    Status status;
    Sensor sensor;
    std::string_view text;
    std::uint16_t encoding = 0;
    bool good = false;
    for (std::size_t size = 0; size < 300; ++size) {
        const ByteView content{bytes.data(), size};
        EXPECT_EQ(read_transform(content, transform), size == 48);
        EXPECT_EQ(read_position(content, position), size == 12 || size == 24 || size == 28);
        EXPECT_EQ(read_start_tracking(content, start), size == 36);
        EXPECT_EQ(read_status(content, status), size >= 30);
        EXPECT_EQ(read_tracking_answer(content, good), size == 1);
        EXPECT_EQ(count_of_tdata(content).has_value(), size % 70 == 0);
        EXPECT_EQ(read_string(content, text, encoding), size == 4);
        EXPECT_EQ(read_sensor(content, sensor), size == 10);
    }
    bytes[0] = 255;
    EXPECT_FALSE(read_sensor({bytes.data(), 58}, sensor));
    EXPECT_TRUE(read_sensor({bytes.data(), 10 + 255 * 8}, sensor));
}

TEST(IgtlContent, RequestsForTdataComeBack) {
    Bytes out;
    append_start_tracking(out, "", 5, {20, "Patient"}, 2);
    append_stop_tracking(out, "", 6);
    append_tracking_answer(out, "", 7, false);
    const std::vector<Taken> taken = decode(out);
    ASSERT_EQ(taken.size(), 3U);
    StartTracking start;
    ASSERT_TRUE(read_start_tracking({taken[0].content.data(), taken[0].content.size()}, start));
    EXPECT_EQ(start.resolution_ms, 20);
    EXPECT_EQ(start.frame, "Patient");
    EXPECT_EQ(taken[1].type, "STP_TDATA");
    bool good = true;
    ASSERT_TRUE(read_tracking_answer({taken[2].content.data(), taken[2].content.size()}, good));
    EXPECT_FALSE(good);
}

}  // namespace
}  // namespace fulcrum::igtl
