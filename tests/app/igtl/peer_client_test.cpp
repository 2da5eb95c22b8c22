// SPDX-License-Identifier: GPL-3.0-or-later
// What is sent, as a program reads it that was made with the library of the protocol's own project
// (tests/fakes/openigtlink_peer.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "app/igtl/live_sender.h"
#include "app/igtl/wire_frame.h"
#include "app/services/application.h"
#include "assessment/trace/events_csv.h"
#include "database/scoring/loaded_task.h"
#include "sim_core/devices/device_page.h"
#include "sim_core/igtl/content.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/openigtlink_peer.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

using fulcrum::test::OpenIgtlinkPeer;
using nlohmann::json;

std::vector<double> doubles_of(const igtl::Transform& transform) {
    return {transform.values.begin(), transform.values.end()};
}

/// A message as the program's own decoder reads it, with the names of the fields that the peer prints.
json fields_of(const igtl::Message& message) {
    json fields = {{"type", std::string(message.type)},
                   {"device", std::string(message.device)},
                   {"sec", message.time >> 32U},
                   {"frac", message.time & 0xffffffffU}};
    igtl::Transform transform;
    igtl::Sensor sensor;
    igtl::Status status;
    std::string_view text;
    std::uint16_t encoding = 0;
    if (message.type == "TRANSFORM" && igtl::read_transform(message.content, transform)) {
        fields["values"] = doubles_of(transform);
    } else if (message.type == "SENSOR" && igtl::read_sensor(message.content, sensor)) {
        fields["values"] = std::vector<double>(sensor.values.begin(), sensor.values.begin() + sensor.count);
        fields["unit"] = sensor.unit;
    } else if (message.type == "STRING" && igtl::read_string(message.content, text, encoding)) {
        fields["text"] = std::string(text);
        fields["encoding"] = encoding;
    } else if (message.type == "STATUS" && igtl::read_status(message.content, status)) {
        fields["code"] = status.code;
        fields["subcode"] = status.subcode;
        fields["name"] = std::string(status.name);
        fields["text"] = std::string(status.text);
    } else {
        ADD_FAILURE() << fields.dump();
    }
    return fields;
}

/// Two clients of one server: the peer and the program's own connection.
class HeardTwice {
  public:
    HeardTwice(const igtl::Address& address, const std::vector<std::string>& more)
        : connection_(address, 2000), peer_(words_of(address, more)) {}
    void listen() {
        connection_.read_into(decoder_);
        igtl::Message message;
        for (auto found = decoder_.next(message); found != igtl::Decoder::Found::nothing;
             found = decoder_.next(message)) {
            ASSERT_EQ(found, igtl::Decoder::Found::message);
            own.push_back(fields_of(message));
        }
        for (const std::string& line : peer_.lines(0)) {
            const json fields = json::parse(line);
            EXPECT_NE(fields["type"], "error") << line;
            if (fields["type"] != "connected") peers.push_back(fields);
        }
    }
    /// Listens until this holds; waits at most 20 s.
    bool until(const std::function<bool()>& holds) {
        const std::int64_t last = monotonic_ns() + 20'000'000'000;
        for (;;) {
            listen();
            if (holds()) return true;
            if (monotonic_ns() > last) return false;
            connection_.wait(2);
        }
    }
    bool both_ended() const { return ended(own) && ended(peers); }

    std::vector<json> own, peers;

  private:
    static std::vector<std::string> words_of(const igtl::Address& address,
                                             const std::vector<std::string>& more) {
        std::vector<std::string> words = {"read", address.host, std::to_string(address.port), "60"};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    }
    static bool ended(const std::vector<json>& messages) {
        return !messages.empty() && messages.back()["type"] == "STATUS" && messages.back()["name"] == "end";
    }

    igtl::Connection connection_;
    igtl::Decoder decoder_;
    OpenIgtlinkPeer peer_;
};

std::size_t count_of(const std::vector<json>& messages, const std::string& type, const std::string& device) {
    return static_cast<std::size_t>(std::count_if(messages.begin(), messages.end(), [&](const json& message) {
        return message["type"] == type && message["device"] == device;
    }));
}

/// Message for message, in the same order; numbers equal exactly.
void expect_read_alike(const HeardTwice& heard) {
    ASSERT_EQ(heard.peers.size(), heard.own.size());
    for (std::size_t i = 0; i < heard.own.size(); ++i)
        ASSERT_TRUE(heard.peers[i] == heard.own[i]) << heard.peers[i].dump() << '\n' << heard.own[i].dump();
}

/// A sample in which everything that is sent differs from tick to tick and from hand to hand.
TickSample sample_to_send(std::uint32_t tick) {
    TickSample sample;
    sample.tick = tick;
    const auto t = static_cast<std::int32_t>(tick);
    for (int h = 0; h < hand_count; ++h) {
        HandSample& hand = sample.hand[h];
        const Vector3 axis = Vector3(std::sin(0.01 * t + h), std::cos(0.02 * t), -1.5 + h).normalized();
        for (int i = 0; i < 3; ++i) {
            hand.tip[i] = (h == 0 ? 1 : -1) * (123'457 * (i + 1) + 31 * t);
            hand.axis[i] = static_cast<std::int32_t>(std::lround(1e8 * axis[i]));
            hand.force[i] = 1000 * i - 700 * h + t;
        }
        hand.roll = 1000 * t - 500'000 * h;
        hand.jaw_force = 7 * t + h;
        hand.jaw_area = 11 * t + h;
        hand.tissue = static_cast<std::int16_t>(h - 1);
        hand.patch = static_cast<std::int16_t>(t % 40);
        hand.flags = static_cast<std::uint16_t>(t % 256);
    }
    const Quaternion q = Quaternion(1, 0.1 * std::sin(0.03 * t), 0.4, -0.2).normalized();
    const double parts[4] = {q.w(), q.x(), q.y(), q.z()};
    for (int i = 0; i < 4; ++i)
        sample.camera.orientation[i] = static_cast<std::int32_t>(std::lround(1e8 * parts[i]));
    for (int i = 0; i < 3; ++i) sample.camera.tip[i] = 345'679 * (i + 1) - 17 * t;
    return sample;
}

/// To the axes of 3D Slicer: right, anterior, superior.
Vector3 slicer_of(const Vector3& patient) {
    return {-patient.x(), patient.z(), patient.y()};
}
void expect_near(const json& values, std::size_t from, const Vector3& expected, double within) {
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(values.at(from + i).get<double>(), expected[static_cast<Eigen::Index>(i)], within)
            << from + i;
}

/// A message of a frame has what this frame has; places to float32 of half a metre in mm.
void expect_of_frame(const json& message, const WireFrame& frame) {
    const std::string device = message["device"];
    const json& values = message["values"];
    for (std::size_t h = 0; h < hand_count; ++h) {
        const WireHand& hand = frame.hand[h];
        const std::string side = h == 0 ? "Left" : "Right";
        if (device == tool_names[h]) {
            expect_near(values, 6, slicer_of(hand.axis), 1e-6);
            expect_near(values, 9, 1e3 * slicer_of(hand.tip), 2e-5);
        } else if (device == side + "Force") {
            expect_near(values, 0, slicer_of(hand.force), 0);
            EXPECT_EQ(message["unit"], igtl::unit_newton);
        } else if (device == side + "State") {
            const std::vector<double> state = {hand.roll,
                                               hand.jaw_force,
                                               hand.jaw_area,
                                               static_cast<double>(hand.tissue),
                                               static_cast<double>(hand.patch),
                                               hand.inside ? 1.0 : 0.0,
                                               hand.in_view ? 1.0 : 0.0,
                                               hand.energy ? 1.0 : 0.0,
                                               hand.cutting ? 1.0 : 0.0};
            EXPECT_EQ(values.get<std::vector<double>>(), state);
        }
    }
    if (device != tool_names[hand_count]) return;
    const Matrix3 view = frame.view.normalized().toRotationMatrix();
    for (int column = 0; column < 3; ++column)
        expect_near(values, 3 * static_cast<std::size_t>(column), slicer_of(Vector3(view.col(column))), 1e-6);
    expect_near(values, 9, 1e3 * slicer_of(frame.scope), 2e-5);
}

std::int64_t ns_of_fields(const json& message) {
    return igtl::ns_of((message["sec"].get<std::uint64_t>() << 32U) | message["frac"].get<std::uint64_t>());
}

/// Every message of a frame, by the tick whose time it has.
void expect_sent_samples(const std::vector<json>& messages) {
    std::int64_t start = 0;
    for (const json& message : messages) {
        SCOPED_TRACE(message.dump());
        if (message["type"] == "STATUS" && message["name"] == "begin") start = ns_of_fields(message);
        if (message["type"] != "TRANSFORM" && message["type"] != "SENSOR") continue;
        const double ticks = static_cast<double>(ns_of_fields(message) - start) / 1e6;
        ASSERT_NEAR(ticks, std::round(ticks), 1e-4);
        ASSERT_GE(ticks, 1);
        expect_of_frame(message, frame_of(sample_to_send(static_cast<std::uint32_t>(std::lround(ticks)))));
    }
}

Event event_to_send(EventKind kind, std::uint32_t tick) {
    Event event;
    event.tick = tick;
    event.kind = kind;
    event.hand = 1;
    event.tissue = 0;
    event.detail = -12;
    event.value = 0.1F;
    return event;
}

TEST(IgtlSender, WhatTheProtocolsOwnLibraryReadsIsWhatIsSent) {
    if (!OpenIgtlinkPeer::built()) GTEST_SKIP() << OpenIgtlinkPeer::not_built;
    LiveSender sender({"127.0.0.1", 0});
    HeardTwice heard({"127.0.0.1", sender.port()}, {});
    ASSERT_TRUE(heard.until([&] { return sender.clients() == 2; }));
    const Scene scene = load_task_and_scene("A2").scene;
    ASSERT_NEAR(scene.tick_period(), 1e-3, 1e-12);
    const auto tap = sender.begin(scene, 4321);
    std::uint32_t tick = 0;
    std::vector<Event> events;
    const auto add = [&](EventKind kind) {
        events.push_back(event_to_send(kind, tick));
        tap->events.add(events.back());
    };
    add(EventKind::attempt_begin);
    const auto leave_until = [&](std::size_t frames) {
        return heard.until([&] {
            tap->newest.write({sample_to_send(++tick)});
            return count_of(heard.peers, "TRANSFORM", tool_names[hand_count]) >= frames;
        });
    };
    ASSERT_TRUE(leave_until(10));
    add(EventKind::grasp);
    ASSERT_TRUE(leave_until(30));
    add(EventKind::completed);
    tap->ended.store(true);
    ASSERT_TRUE(heard.until([&] { return heard.both_ended(); }));
    expect_read_alike(heard);
    expect_sent_samples(heard.peers);
    for (const char* const device : {"LeftTipToPatient", "RightTipToPatient"})
        EXPECT_GE(count_of(heard.peers, "TRANSFORM", device), 30U) << device;
    for (const char* const device : {"LeftForce", "RightForce", "LeftState", "RightState"})
        EXPECT_GE(count_of(heard.peers, "SENSOR", device), 29U) << device;
    // The events, with the seed; the tissues that they name.
    const WireScene wire = wire_scene(scene);
    put_seed(events[0], 4321);
    EXPECT_EQ(count_of(heard.peers, "STRING", "Event"), events.size());
    std::string labels;
    for (const std::string& label : wire.tissues) labels += (labels.empty() ? "" : "\n") + label;
    for (const Event& event : events) {
        std::ostringstream file;
        write_events_csv({event}, wire.tissues, scene.tick_period(), file);
        const auto sent = std::count_if(heard.peers.begin(), heard.peers.end(), [&](const json& message) {
            return message["device"] == "Event" &&
                   file.str().find('\n' + message["text"].get<std::string>() + '\n') != std::string::npos;
        });
        EXPECT_EQ(sent, 1) << file.str();
    }
    EXPECT_EQ(count_of(heard.peers, "STRING", "Tissues"), 1U);
    EXPECT_EQ(heard.peers.front()["text"], labels);
    EXPECT_EQ(sender.dropped(), 0U);
}

TEST(IgtlSender, AProgramOfTheProtocolsOwnLibraryMaySendAnythingAndGetsTdataWhileItAsksForIt) {
    if (!OpenIgtlinkPeer::built()) GTEST_SKIP() << OpenIgtlinkPeer::not_built;
    LiveSender sender({"127.0.0.1", 0});
    HeardTwice heard({"127.0.0.1", sender.port()}, {"greet", "tdata", "20", "15"});
    ASSERT_TRUE(heard.until([&] { return sender.clients() == 2; }));
    const auto tap = sender.begin(load_task_and_scene("A2").scene, 1);
    std::uint32_t tick = 0;
    ASSERT_TRUE(heard.until([&] {
        tap->newest.write({sample_to_send(++tick)});
        // It asks for the end after 15, and then gets each tool by itself again.
        const auto asked = std::find_if(heard.peers.begin(), heard.peers.end(),
                                        [](const json& message) { return message["type"] == "TDATA"; });
        const std::vector<json> later(asked, heard.peers.end());
        return count_of(later, "TDATA", "Fulcrum") >= 15 &&
               count_of(later, "TRANSFORM", tool_names[hand_count]) >= 5;
    })) << count_of(heard.peers, "TDATA", "Fulcrum");
    tap->ended.store(true);
    ASSERT_TRUE(heard.until([&] { return heard.both_ended(); }));
    EXPECT_EQ(sender.clients(), 2U);
    EXPECT_EQ(sender.dropped(), 0U) << "for nothing of what it sent";
    // Each tool as the other client got it, by itself at the same time.
    for (const json& message : heard.peers) {
        if (message["type"] != "TDATA") continue;
        ASSERT_EQ(message["tools"].size(), hand_count + 1U);
        for (const json& tool : message["tools"]) {
            const auto same = std::find_if(heard.own.begin(), heard.own.end(), [&](const json& one) {
                return one["type"] == "TRANSFORM" && one["device"] == tool["name"] &&
                       one["sec"] == message["sec"] && one["frac"] == message["frac"];
            });
            ASSERT_TRUE(same != heard.own.end()) << tool.dump();
            EXPECT_TRUE((*same)["values"] == tool["values"]) << tool.dump() << '\n' << same->dump();
            EXPECT_EQ(tool["kind"], 2);
        }
    }
    expect_sent_samples(heard.own);
}

TEST(SentStream, OfAnAttemptIsReadByTheProtocolsOwnLibraryAsByThisProgram) {
    if (!OpenIgtlinkPeer::built()) GTEST_SKIP() << OpenIgtlinkPeer::not_built;
    const fulcrum::test::OwnFolder folder;
    const fulcrum::test::Variable address("FULCRUM_OPENIGTLINK", "127.0.0.1:0");
    const auto services = make_services(folder.path().string());
    services->open_store(false);
    const ui::SendingState state = services->sending();
    ASSERT_TRUE(state.trouble.empty()) << state.trouble.words();
    HeardTwice heard(igtl::parse_address(state.address, "test"), {"greet"});
    ASSERT_TRUE(heard.until([&] { return services->sending().clients == 2; }));
    auto attempt = services->start_demonstration(services->store()->station_session(), "A2");
    ASSERT_TRUE(heard.until([&] {
        attempt->update();
        return attempt->phase() == ui::AttemptPhase::ready;
    }));
    attempt->start();
    EXPECT_TRUE(heard.until([&] {
        attempt->update();
        return count_of(heard.peers, "TRANSFORM", "LeftTipToPatient") >= 60 &&
               count_of(heard.peers, "STRING", "Event") >= 1;
    })) << heard.peers.size();
    attempt.reset();
    ASSERT_TRUE(heard.until([&] { return heard.both_ended(); }));
    expect_read_alike(heard);
    const std::size_t frames = count_of(heard.peers, "TRANSFORM", "LeftTipToPatient");
    for (const char* const device : {"RightTipToPatient", "CameraToPatient"})
        EXPECT_EQ(count_of(heard.peers, "TRANSFORM", device), frames) << device;
    for (const char* const device : {"LeftForce", "RightForce", "LeftState", "RightState"})
        EXPECT_EQ(count_of(heard.peers, "SENSOR", device), frames) << device;
    EXPECT_EQ(services->sending().dropped, 0U);
}

}  // namespace
}  // namespace fulcrum::app
