// SPDX-License-Identifier: Apache-2.0
#include "sim_core/telemetry/event.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace fulcrum {
namespace {

constexpr int kinds = 53;  // stored in records: a kind is added at the end, none is renumbered

TEST(Event, EveryKindHasANameOfItsOwn) {
    std::set<std::string> names;
    for (int k = 0; k < kinds; ++k) names.insert(event_name(static_cast<EventKind>(k)));
    EXPECT_EQ(names.size(), static_cast<std::size_t>(kinds));
    EXPECT_EQ(names.count("unknown"), 0U);
    EXPECT_STREQ(event_name(static_cast<EventKind>(kinds)), "unknown");
    EXPECT_STREQ(event_name(EventKind::nerve_injury), "nerve_injury");
    EXPECT_STREQ(event_name(EventKind::fibres_parted), "fibres_parted");
}

// Records of earlier versions hold these numbers.
TEST(Event, FieldsAreStoredAsTheNumbersOfEarlierRecords) {
    Event event;
    for (int bits = 0; bits < 8; ++bits) {
        event.detail = bits;
        const Activation activation = activation_of(event);
        EXPECT_EQ(activation.in_view, (bits & 1) != 0);
        EXPECT_EQ(activation.on_target, (bits & 2) != 0);
        EXPECT_EQ(activation.clear, (bits & 4) != 0);
        EXPECT_EQ(activation.safe(), bits == 7);
        EXPECT_EQ(detail_of(activation), bits);
    }
    for (const std::int32_t stored : {0, 1, 256, 257}) {
        event.detail = stored;
        const NerveInjury injury = nerve_injury_of(event);
        EXPECT_EQ(injury.nerve, stored % 256);
        EXPECT_EQ(injury.cause, stored >= 256 ? InjuryCause::blade : InjuryCause::heat);
        EXPECT_EQ(detail_of(injury), stored);
    }
    event.value = 0.25F;
    event.detail = -1500;
    EXPECT_EQ(cut_place_of(event).along, 0.25);
    EXPECT_DOUBLE_EQ(cut_place_of(event).distance, -1.5e-3);
    EXPECT_EQ(cut_traction_of(event).length, 0);
}

}  // namespace
}  // namespace fulcrum
