// SPDX-License-Identifier: Apache-2.0
// The table of event types is whole, and says what the places that use it have always done.
#include "sim_core/telemetry/event_types.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace fulcrum {
namespace {

using Names = std::set<std::string>;

template <typename Condition>
Names names_where(const Condition& holds) {
    Names names;
    for (const EventType& type : event_kinds)
        if (holds(type)) names.insert(type.name);
    return names;
}

TEST(EventTypes, EachHasANameAndATitleOfItsOwn) {
    Names names, titles;
    for (const EventType& type : event_kinds) {
        names.insert(type.name);
        titles.insert(type.title);
        EXPECT_STREQ(event_name(type.kind), type.name);
        EXPECT_EQ(find_type(type.kind), &type);
    }
    EXPECT_EQ(names.size(), std::size(event_kinds));
    EXPECT_EQ(titles.size(), std::size(event_kinds));
}

TEST(EventTypes, ErrorsAreOfWhoeverPerformsAndFaultsOfDeviceOrSimulation) {
    const auto of = [](EventWeight weight) {
        return names_where([weight](const EventType& type) { return type.weight == weight; });
    };
    EXPECT_EQ(of(EventWeight::critical), (Names{"perforation", "vessel_injury", "nerve_injury"}));
    EXPECT_EQ(of(EventWeight::error),
              (Names{"slip", "drop", "over_force_begin", "tool_collision", "tear", "jaw_pressure",
                     "bleed_begin", "fibres_parted", "lens_contact"}));
    EXPECT_EQ(of(EventWeight::fault), (Names{"device_lost", "device_fault", "simulator_fault"}));
    for (const EventType& type : event_kinds)
        EXPECT_EQ(is_error(type.kind),
                  type.weight == EventWeight::error || type.weight == EventWeight::critical)
            << type.name;
}

TEST(EventTypes, TheCheckBySimulationLeavesOutWhatComesFromOutside) {
    EXPECT_EQ(names_where([](const EventType& type) { return !is_from_simulation(type.kind); }),
              (Names{"attempt_begin", "pause", "resume", "device_lost", "device_back", "device_fault",
                     "world_late", "simulator_fault", "stability_limited", "completed", "abandoned",
                     "timed_out", "interrupted", "samples_lost"}));
}

TEST(EventTypes, EachMarkOfAReplayIsOfOneType) {
    std::map<ReplayMark, std::string> marks;
    for (const EventType& type : event_kinds) {
        if (type.mark == ReplayMark::none) continue;
        EXPECT_TRUE(marks.emplace(type.mark, type.name).second) << type.name;
    }
    EXPECT_EQ(marks, (std::map<ReplayMark, std::string>{{ReplayMark::goal, "phase_begin"},
                                                        {ReplayMark::progress, "goal_progress"},
                                                        {ReplayMark::movement, "first_movement"},
                                                        {ReplayMark::target_shown, "target_shown"},
                                                        {ReplayMark::target_reached, "target_reached"},
                                                        {ReplayMark::blood, "blood_loss"},
                                                        {ReplayMark::traction, "cut_traction"},
                                                        {ReplayMark::traction_over, "cut_end"}}));
}

TEST(EventTypes, OnlyTheseAreNotWorthALine) {
    EXPECT_EQ(names_where([](const EventType& type) { return type.line == LineContent::none; }),
              (Names{"phase_end", "target_shown", "over_force_end", "wall_contact", "world_late",
                     "stability_limited", "goal_progress", "cut_advance", "cut_traction", "cut_rolled_back",
                     "blood_loss", "heat_dose", "heat_area"}));
}

TEST(EventTypes, ANumberOfANewerProgramIsOrdinary) {
    const auto newer = static_cast<EventKind>(std::size(event_kinds));
    EXPECT_EQ(find_type(newer), nullptr);
    EXPECT_EQ(weight_of(newer), EventWeight::ordinary);
    EXPECT_FALSE(is_error(newer));
    EXPECT_TRUE(is_from_simulation(newer)) << "and the check by simulation compares it";
}

}  // namespace
}  // namespace fulcrum
