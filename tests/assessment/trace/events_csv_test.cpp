// SPDX-License-Identifier: Apache-2.0
// Events CSV (docs/FORMATS.md): what is written is read again; wrong files name the place and what to do.
#include "assessment/trace/events_csv.h"

#include <gtest/gtest.h>

#include <sstream>
#include <utility>

#include "assessment/trace/trace.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

const std::vector<std::string> labels = {"bowel", "vessel"};
constexpr const char* header = "t,event,hand,tissue,value,detail\ns,-,-,-,event,event\n";

TEST(EventsCsv, ReadsWhatItWrites) {
    std::vector<Event> events;
    for (int kind = 0; kind < 51; ++kind) {
        Event event;
        event.tick = static_cast<std::uint32_t>(kind * 37);
        event.kind = static_cast<EventKind>(kind);
        event.hand = kind % 3 == 2 ? std::uint8_t{255} : static_cast<std::uint8_t>(kind % 3);
        event.tissue = static_cast<std::int8_t>(kind % 3 - 1);
        event.value = 0.1F * static_cast<float>(kind) - 1.7F;
        event.detail = kind * 1000 - 20000;
        events.push_back(event);
    }
    std::stringstream text;
    write_events_csv(events, labels, 0.001, text);
    const std::vector<Event> again = read_events_csv(text, "events.csv", labels, 0.001);
    ASSERT_EQ(again.size(), events.size());
    for (std::size_t i = 0; i < events.size(); ++i) {
        EXPECT_EQ(again[i].tick, events[i].tick);
        EXPECT_EQ(again[i].kind, events[i].kind);
        EXPECT_EQ(again[i].hand, events[i].hand);
        EXPECT_EQ(again[i].tissue, events[i].tissue);
        EXPECT_EQ(again[i].value, events[i].value);
        EXPECT_EQ(again[i].detail, events[i].detail);
    }
}

TEST(EventsCsv, IsWrittenInTheOrderOfTime) {
    std::vector<Event> events(3);
    events[0].tick = 900;
    events[1].tick = 1200;
    events[2].tick = 1000;  // seen to have begun only later
    events[2].kind = EventKind::first_movement;
    std::stringstream text;
    write_events_csv(events, labels, 0.001, text);
    const std::vector<Event> again = read_events_csv(text, "events.csv", labels, 0.001);
    ASSERT_EQ(again.size(), 3U);
    EXPECT_EQ(again[1].kind, EventKind::first_movement);
    EXPECT_EQ(again[2].tick, 1200U);
}

TEST(EventsCsv, NamesRowColumnAndHintOfWhatIsWrong) {
    const std::pair<const char*, const char*> cases[] = {
        {"1,dance,,,0,0\n", "3: event"},
        {"1,grasp,middle,,0,0\n", "3: hand"},
        {"1,grasp,left,bone,0,0\n", "3: tissue"},
        {"x,grasp,,,0,0\n", "3: t"},
        {"-1,grasp,,,0,0\n", "3: t"},
        {"1,grasp,,,nan,0\n", "3: value"},
        {"1,grasp,,,0,1.5\n", "3: detail"},
        {"1,grasp,,,0\n", "3: (row)"},
        {"2,grasp,,,0,0\n1,release,,,0,0\n", "4: t"},
    };
    for (const auto& [rows, place] : cases) {
        std::istringstream in(std::string(header) + rows);
        try {
            read_events_csv(in, "events.csv", labels, 0.001);
            ADD_FAILURE() << rows << " was accepted";
        } catch (const InputError& error) {
            EXPECT_EQ(error.place(), place) << error.what();
            EXPECT_FALSE(error.hint().empty()) << rows;
        }
    }
    std::istringstream empty(""), other("t,left.px\ns,m\n");
    EXPECT_THROW(read_events_csv(empty, "events.csv", labels, 0.001), InputError);
    EXPECT_THROW(read_events_csv(other, "events.csv", labels, 0.001), InputError);
}

TEST(PutLabelsFirst, KeepsWhatEachSampleTouches) {
    Trace trace;
    trace.t = {0, 1, 2, 3};
    trace.tissues = {"wall", "vessel"};
    trace.hand[0].tissue = {0, 1, -1, 0};
    put_labels_first(trace, labels);
    EXPECT_EQ(trace.tissues, (std::vector<std::string>{"bowel", "vessel", "wall"}));
    EXPECT_EQ(trace.hand[0].tissue, (std::vector<std::int16_t>{2, 1, -1, 2}));
}

}  // namespace
}  // namespace fulcrum
