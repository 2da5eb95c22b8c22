// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/igtl/wire_frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <sstream>

#include "app/igtl/live_sender.h"
#include "assessment/assets/assets.h"
#include "assessment/trace/events_csv.h"
#include "database/scoring/loaded_task.h"
#include "sim_core/devices/device_page.h"
#include "sim_core/instrument/device.h"
#include "sim_core/telemetry/event_types.h"

namespace fulcrum::app {
namespace {

using Took = TraceRecording::Took;

Scene scene_of_a2() {
    return load_task_and_scene("A2").scene;
}

/// A sample of any content with unit axes and quaternion.
TickSample any_sample(std::mt19937& random, std::uint32_t tick) {
    std::normal_distribution<double> normal;
    const auto direction = [&] {
        return Vector3(normal(random), normal(random), normal(random)).normalized();
    };
    TickSample sample;
    sample.tick = tick;
    for (HandSample& hand : sample.hand) {
        const Vector3 axis = direction();
        for (int i = 0; i < 3; ++i) {
            hand.tip[i] = static_cast<std::int32_t>(random() % 10'000'000U) - 5'000'000;  // half a metre
            hand.axis[i] = static_cast<std::int32_t>(std::lround(1e8 * axis[i]));
            hand.force[i] = static_cast<std::int32_t>(5e3 * normal(random));
        }
        hand.roll = static_cast<std::int32_t>(3e6 * normal(random));
        hand.jaw_force = static_cast<std::int32_t>(tick * 7);
        hand.jaw_area = static_cast<std::int32_t>(tick * 11);
        hand.tissue = static_cast<std::int16_t>(tick % 2 == 0 ? -1 : 0);
        hand.patch = static_cast<std::int16_t>(tick % 40) - 1;
        hand.flags = static_cast<std::uint16_t>(random() & 0xffU);
    }
    Quaternion q(normal(random), normal(random), normal(random), normal(random));
    q.normalize();
    const double parts[4] = {q.w(), q.x(), q.y(), q.z()};
    for (int i = 0; i < 4; ++i)
        sample.camera.orientation[i] = static_cast<std::int32_t>(std::lround(1e8 * parts[i]));
    for (int i = 0; i < 3; ++i) sample.camera.tip[i] = static_cast<std::int32_t>(2e6 * normal(random));
    return sample;
}

/// Gives all messages of these bytes to the recording; the last answer.
Took give(TraceRecording& recording, const igtl::Bytes& bytes) {
    igtl::Decoder decoder;
    Took last = Took::nothing;
    for (std::size_t at = 0; at < bytes.size();) {
        std::uint8_t* const space = decoder.space();
        const std::size_t count = std::min(bytes.size() - at, decoder.room());
        std::copy_n(bytes.data() + at, count, space);
        decoder.take(count);
        at += count;
        igtl::Message message;
        for (auto found = decoder.next(message); found != igtl::Decoder::Found::nothing;
             found = decoder.next(message)) {
            EXPECT_EQ(found, igtl::Decoder::Found::message);
            last = recording.take(message);
        }
    }
    return last;
}
void give(TraceRecording& recording, const igtl::ServedFrame& frame, bool as_tdata = false) {
    give(recording, as_tdata ? frame.tdata : frame.transforms);
    give(recording, frame.others);
}
igtl::Bytes pose_message(const char* tool, double x, std::int64_t ns) {
    igtl::Bytes bytes;
    igtl::Pose pose;
    pose.place.x() = x;
    igtl::append_transform(bytes, tool, igtl::timestamp_of(ns), igtl::transform_of(pose), 2);
    return bytes;
}

TEST(IgtlWireFrame, ASampleComesBackAsTheRecordHasIt) {
    const WireScene scene = wire_scene(scene_of_a2());
    ASSERT_FALSE(scene.tissues.empty());
    std::mt19937 random(3);
    std::vector<TickSample> samples;
    for (std::uint32_t tick = 1; tick <= 300; ++tick) samples.push_back(any_sample(random, tick));
    const Trace sent = trace_from_samples(samples, {}, scene.tissues);
    constexpr std::int64_t start = 1'764'115'200'000'000'000;
    for (const bool as_tdata : {false, true}) {
        TraceRecording recording;
        give(recording, greeting_of(scene, start));
        give(recording, state_message(WireState::begin, start));
        for (std::size_t row = 0; row < sent.t.size(); ++row)
            give(recording,
                 messages_of(row % 2 == 0 ? frame_of(sent, row, scene) : frame_of(samples[row]), scene,
                             start + std::llround(1e9 * sent.t[row])),
                 as_tdata);
        EXPECT_EQ(give(recording, state_message(WireState::end, start + 301'000'000)), Took::end);
        const Trace got = recording.finish();
        EXPECT_EQ(recording.left_out(), 0U);
        ASSERT_EQ(got.t, sent.t);
        EXPECT_EQ(got.tissues, sent.tissues);
        for (std::size_t h = 0; h < hand_count; ++h) {
            const HandTrace &a = sent.hand[h], &b = got.hand[h];
            // Exact: places rounded to the unit of the record, the rest sent as doubles.
            EXPECT_EQ(b.px, a.px);
            EXPECT_EQ(b.pz, a.pz);
            EXPECT_EQ(b.fx, a.fx);
            EXPECT_EQ(b.fy, a.fy);
            EXPECT_EQ(b.roll, a.roll);
            EXPECT_EQ(b.jaw_force, a.jaw_force);
            EXPECT_EQ(b.jaw_area, a.jaw_area);
            EXPECT_EQ(b.tissue, a.tissue);
            EXPECT_EQ(b.patch, a.patch);
            EXPECT_EQ(b.inside, a.inside);
            EXPECT_EQ(b.in_view, a.in_view);
            EXPECT_EQ(b.energy, a.energy);
            EXPECT_EQ(b.cutting, a.cutting);
            for (std::size_t i = 0; i < a.ax.size(); ++i) {
                EXPECT_NEAR(b.ax[i], a.ax[i], 1.5e-7);
                EXPECT_NEAR(b.az[i], a.az[i], 1.5e-7);
            }
        }
        for (std::size_t i = 0; i < sent.t.size(); ++i) {
            EXPECT_EQ(got.camera.py[i], sent.camera.py[i]);
            const Quaternion a(sent.camera.qw[i], sent.camera.qx[i], sent.camera.qy[i], sent.camera.qz[i]),
                b(got.camera.qw[i], got.camera.qx[i], got.camera.qy[i], got.camera.qz[i]);
            EXPECT_NEAR(std::abs(a.normalized().dot(b)), 1, 1e-12);
        }
    }
}

/// One of each kind, in the order of a record, in which an event can follow a later one.
std::vector<Event> event_of_each_kind() {
    std::vector<Event> events;
    for (const auto& row : event_kinds) {
        const auto i = static_cast<std::int32_t>(events.size());
        Event event;
        event.tick = static_cast<std::uint32_t>(7 * i + (i % 5 == 0 ? 30 : 0));
        event.kind = row.kind;
        event.hand = static_cast<std::uint8_t>(i % 3 == 2 ? 255 : i % 3);
        event.tissue = static_cast<std::int8_t>(i % 2 - 1);
        event.detail = -1000 * i;
        event.value = 0.1F * static_cast<float>(i);
        events.push_back(event);
    }
    return events;
}

TEST(IgtlWireFrame, EventsComeBackAsTheFileOfTheirAttemptAndOnlyWhole) {
    const WireScene scene = wire_scene(scene_of_a2());
    const std::vector<Event> events = event_of_each_kind();
    EXPECT_GT(events.size(), 50U);
    std::ostringstream file;
    write_events_csv(events, scene.tissues, 1e-3, file);
    constexpr std::int64_t start = 1'764'115'200'000'000'000;
    enum class Sent { all, begun_before, cut_off, no_begin, no_end, no_events };
    const auto recorded = [&](Sent sent) {
        TraceRecording recording;
        if (sent == Sent::no_begin)
            give(recording, greeting_of(scene, start));
        else
            give(recording, begin_of(scene, start, sent == Sent::begun_before));
        if (sent != Sent::no_events)
            for (const Event& event : events)
                give(recording, event_message(event, scene, 1e-3, start + 1'000'000LL * event.tick));
        give(recording, messages_of(WireFrame(), scene, start + 1'000'000));
        if (sent != Sent::no_end) {
            EXPECT_EQ(give(recording, state_message(WireState::end, start + 9, sent == Sent::cut_off)),
                      Took::end);
        }
        EXPECT_EQ(recording.left_out(), 0U);
        EXPECT_EQ(recording.events(), sent == Sent::no_events ? 0U : events.size());
        EXPECT_EQ(recording.finish().t.size(), 1U) << "an event is no row of the trace";
        return recording.events_csv();
    };
    EXPECT_EQ(recorded(Sent::all), file.str());
    for (const Sent part : {Sent::begun_before, Sent::cut_off, Sent::no_begin, Sent::no_end, Sent::no_events})
        EXPECT_FALSE(recorded(part)) << static_cast<int>(part);

    // What is none is left out and counted, and the file would lack it.
    for (const char* row : {"", "0.1,grasp", "0.1,no_such_event,,,0,0", "0.1,grasp,left,no_such_tissue,0,0",
                            "-1,grasp,,,0,0", "0.1,grasp,,,inf,0", "0.1,grasp,,,0,0\n0.2,grasp,,,0,0"}) {
        TraceRecording recording;
        give(recording, begin_of(scene, start, false));
        give(recording, event_message(events[0], scene, 1e-3, start));
        igtl::Bytes wrong;
        igtl::append_string(wrong, "Event", igtl::timestamp_of(start), row);
        give(recording, wrong);
        give(recording, state_message(WireState::end, start));
        EXPECT_EQ(recording.left_out(), 1U) << row;
        EXPECT_EQ(recording.events(), 1U) << row;
        EXPECT_FALSE(recording.events_csv()) << row;
    }
    // The scene has no such tissue: it is sent without one.
    Event foreign = events[0];
    foreign.tissue = 100;
    TraceRecording recording;
    give(recording, begin_of(scene, start, false));
    give(recording, event_message(foreign, scene, 1e-3, start));
    give(recording, state_message(WireState::end, start));
    EXPECT_TRUE(recording.events_csv());
}

TEST(IgtlWireFrame, WhatIsSentIsInMillimetresAndTheAxesOfSlicer) {
    WireScene scene = wire_scene(scene_of_a2());
    scene.trocar[1].reset();
    scene.camera = false;
    WireFrame frame;
    frame.hand[0].tip = Vector3(0.01, 0.02, 0.03);  // to the patient's left, cranial, anterior
    frame.hand[0].axis = Vector3(0, 0.6, -0.8);
    const igtl::ServedFrame messages = messages_of(frame, scene, 0);
    igtl::Decoder decoder;
    std::copy_n(messages.transforms.data(), messages.transforms.size(), decoder.space());
    decoder.take(messages.transforms.size());
    igtl::Message message;
    ASSERT_EQ(decoder.next(message), igtl::Decoder::Found::message);
    EXPECT_EQ(message.device, "LeftTipToPatient");
    igtl::Transform transform;
    ASSERT_TRUE(igtl::read_transform(message.content, transform));
    EXPECT_FLOAT_EQ(transform.values[9], -10);  // right
    EXPECT_FLOAT_EQ(transform.values[10], 30);  // anterior
    EXPECT_FLOAT_EQ(transform.values[11], 20);  // superior
    EXPECT_NEAR(transform.values[6], 0, 1e-6);  // the shaft: z of the tool
    EXPECT_NEAR(transform.values[7], -0.8, 1e-6);
    EXPECT_NEAR(transform.values[8], 0.6, 1e-6);
    EXPECT_TRUE(igtl::pose_of(transform)) << "a right-handed frame";
    EXPECT_EQ(decoder.next(message), igtl::Decoder::Found::nothing) << "no message of what is not there";
}

TEST(IgtlRecording, ToolsOfAnotherProgramMakeATraceWithTheirChannelsOnly) {
    TraceRecording recording({"Probe", "Stylus", "Endoscope"});
    give(recording, pose_message("Reference", 0, 0));
    give(recording, pose_message("Probe", 0.001, 5'000'000'000));  // alone: left out, the stylus comes later
    for (int i = 1; i <= 20; ++i) {
        give(recording, pose_message("Probe", 0.001 * i, 5'000'000'000 + i * 10'000'000));
        give(recording, pose_message("Stylus", 0.002 * i, 5'000'000'000 + i * 10'000'000 + 3'000'000));
    }
    const Trace trace = recording.finish();
    ASSERT_EQ(trace.t.size(), 20U);
    EXPECT_EQ(recording.left_out(), 1U);
    EXPECT_EQ(recording.unknown_tools(), std::vector<std::string>{"Reference"});
    EXPECT_NEAR(trace.t[1] - trace.t[0], 0.01, 1e-12);
    EXPECT_NEAR(trace.hand[1].px[19], -0.04, 1e-12);
    EXPECT_TRUE(trace.hand[0].has(Channel::axis));
    EXPECT_FALSE(trace.hand[0].has(Channel::force));
    EXPECT_FALSE(trace.hand[0].has(Channel::roll));
    EXPECT_FALSE(trace.camera.recorded());
}

TEST(IgtlRecording, WhatIsNotUsableIsLeftOutAndCounted) {
    TraceRecording recording;
    const auto at = [](int i) { return 1'000'000'000 + i * 10'000'000LL; };
    give(recording, pose_message(tool_names[0], 0.001, at(1)));
    give(recording, pose_message(tool_names[0], 0.002, at(2)));
    give(recording, pose_message(tool_names[0], 0.003, at(2)));  // the same time again
    give(recording, pose_message(tool_names[0], 0.004, at(1)));  // an older one
    give(recording, pose_message(tool_names[0], std::numeric_limits<double>::quiet_NaN(), at(4)));
    give(recording, pose_message(tool_names[0], 0.005, at(5)));
    give(recording, pose_message(tool_names[0], 0.006, at(1'000'000)));  // above the limit of a trace
    igtl::Bytes sensor;
    const double values[] = {1, 2, std::numeric_limits<double>::infinity()};
    igtl::append_sensor(sensor, "LeftForce", 0, values, 3, igtl::unit_newton);
    igtl::append_sensor(sensor, "LeftForce", 0, values, 2, igtl::unit_newton);  // too few
    igtl::append_string(sensor, "Tissues", 0, "fat,\"\nbowel\n\n");
    give(recording, sensor);
    const Trace trace = recording.finish();
    EXPECT_EQ(trace.t.size(), 3U);
    EXPECT_EQ(recording.left_out(), 6U);
    EXPECT_EQ(trace.tissues, (std::vector<std::string>{"fat__", "bowel", "_"}));
    EXPECT_FALSE(trace.hand[0].has(Channel::force));
    EXPECT_TRUE(TraceRecording().finish().t.empty());
}

/// What a client of a sender has received so far.
struct Listener {
    explicit Listener(int port) : connection({"127.0.0.1", port}, 2000) {}
    /// Waits at most 5 s.
    bool until(const std::function<bool()>& holds) {
        const std::int64_t last = monotonic_ns() + 5'000'000'000;
        while (!holds()) {
            if (monotonic_ns() > last) return false;
            connection.wait(5);
            connection.read_into(decoder);
            igtl::Message message;
            while (decoder.next(message) == igtl::Decoder::Found::message) {
                igtl::Status status;
                if (message.type == "STATUS" && igtl::read_status(message.content, status))
                    states.emplace_back(status.name);
                if (message.device == tool_names[0]) ++frames;
                ended = recording.take(message) == Took::end || ended;
            }
        }
        return true;
    }
    igtl::Connection connection;
    igtl::Decoder decoder;
    TraceRecording recording;
    std::vector<std::string> states;
    int frames = 0;
    bool ended = false;
};

TEST(IgtlSender, AnAttemptIsSentWithItsPausesAndItsEndToEveryClient) {
    LiveSender sender({"127.0.0.1", 0});
    Listener early(sender.port());
    const Scene scene = scene_of_a2();
    const auto tap = sender.begin(scene, 1234);
    std::mt19937 random(5);
    std::uint32_t tick = 0;
    const auto leave = [&](std::uint32_t flags) {
        TickSample sample = any_sample(random, ++tick);
        sample.rig_flags = flags;
        tap->newest.write({sample});
    };
    std::vector<Event> events;
    const auto leave_event = [&](EventKind kind) {
        Event event;
        event.tick = tick;
        event.kind = kind;
        events.push_back(event);
        tap->events.add(event);
    };
    leave_event(EventKind::attempt_begin);  // before the first sample
    leave_event(EventKind::phase_begin);
    ASSERT_TRUE(early.until([&] {
        leave(0);
        return early.frames >= 3 && early.recording.events() == 1;
    }));
    Listener late(sender.port());  // gets the beginning as well
    ASSERT_TRUE(late.until([&] {
        leave(0);
        return late.frames >= 2;
    }));
    const auto has = [](const Listener& one, const char* state) {
        return std::find(one.states.begin(), one.states.end(), state) != one.states.end();
    };
    ASSERT_TRUE(early.until([&] {
        leave(rig_paused);
        return has(early, "pause");
    }));
    const int frames = early.frames;
    for (int i = 0; i < 5; ++i) {
        leave(rig_device_lost);
        early.until([deadline = monotonic_ns() + 20'000'000] { return monotonic_ns() > deadline; });
    }
    EXPECT_EQ(early.frames, frames) << "a pause is not sent";
    ASSERT_TRUE(early.until([&] {
        leave(0);
        return has(early, "resume") && early.frames > frames;
    }));
    const std::size_t sent = events.size();
    leave_event(EventKind::completed);
    ASSERT_TRUE(early.until([&] { return early.recording.events() == sent; }))
        << "the event that begins the attempt carries its seed, and is sent last";
    EXPECT_FALSE(early.recording.events_csv());
    tap->ended.store(true);
    EXPECT_TRUE(early.until([&] { return early.ended; }));
    EXPECT_TRUE(late.until([&] { return late.ended; }));
    EXPECT_EQ(early.states, (std::vector<std::string>{"begin", "pause", "resume", "end"}));
    EXPECT_EQ(late.states, early.states);
    // The events as the record exports them; not to a client that has not the first of them.
    put_seed(events[0], 1234);
    std::ostringstream file;
    write_events_csv(events, wire_scene(scene).tissues, scene.tick_period(), file);
    EXPECT_EQ(early.recording.events_csv(), file.str());
    EXPECT_GT(late.recording.events(), 0U);
    EXPECT_FALSE(late.recording.events_csv());
    // Times are those of the ticks, whenever a frame was sent.
    const Trace trace = late.recording.finish();
    ASSERT_GT(trace.t.size(), 1U);
    for (const double t : trace.t) EXPECT_NEAR(t * 1e3, std::round(t * 1e3), 1e-5);
    EXPECT_LE(trace.t.back(), 1e-3 * tick);
    // The next attempt begins with its own tissues.
    const auto next = sender.begin(scene, 1);
    next->newest.write({any_sample(random, 1)});
    EXPECT_TRUE(early.until([&] { return early.states.size() == 5; }));
    EXPECT_EQ(early.states.back(), "begin");
    EXPECT_EQ(sender.dropped(), 0U);
}

TEST(IgtlSender, AnAttemptWhoseEventsAreNotAllSentEndsAsAPart) {
    for (const bool stored : {false, true}) {
        auto sender = std::make_unique<LiveSender>(igtl::Address{"127.0.0.1", 0});
        Listener listener(sender->port());
        const auto tap = sender->begin(scene_of_a2(), 1);
        std::mt19937 random(7);
        Event event;
        tap->events.add(event);
        event.kind = EventKind::phase_begin;
        tap->events.add(event);
        std::uint32_t tick = 0;
        ASSERT_TRUE(listener.until([&] {
            tap->newest.write({any_sample(random, ++tick)});
            return listener.frames >= 2 && listener.recording.events() == 1;
        }));
        if (stored) {  // it could not be, and what came after that is missing
            tap->part.store(true);
            tap->ended.store(true);
        } else {  // sending is switched off
            sender.reset();
        }
        EXPECT_TRUE(listener.until([&] { return listener.ended; }));
        EXPECT_EQ(listener.recording.events(), 1U) << "the seed is of a whole attempt";
        EXPECT_FALSE(listener.recording.events_csv());
    }
}

TEST(IgtlSender, NobodyWaitsForAClientThatDoesNotRead) {
    LiveSender sender({"127.0.0.1", 0});
    const igtl::Connection silent({"127.0.0.1", sender.port()}, 2000);
    const auto tap = sender.begin(scene_of_a2(), 1);
    std::mt19937 random(6);
    std::int64_t longest = 0;
    for (std::uint32_t tick = 1; tick <= 2000; ++tick) {
        const TickSample sample = any_sample(random, tick);
        const std::int64_t begin = monotonic_ns();
        tap->newest.write({sample});
        longest = std::max(longest, monotonic_ns() - begin);
    }
    EXPECT_LT(longest, 50'000'000) << "only a copy, and what the system takes away";
}

}  // namespace
}  // namespace fulcrum::app
