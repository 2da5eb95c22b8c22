// SPDX-License-Identifier: Apache-2.0
// What the service of another maker sends is read as it is meant; what cannot be used is left out, and what
// is right next to it is read all the same.
#include "sim_core/haply/messages.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::haply {
namespace {

/// Of one Inverse3 and one grip with a wire.
nlohmann::json usual_message() {
    return nlohmann::json::parse(R"({
        "inverse3": [{"device_id": "04BA", "config": {"handedness": "right"},
            "status": {"calibrated": true, "power_supply": true},
            "state": {"cursor_position": {"x": 0.01, "y": -0.1, "z": 0.2},
                      "current_cursor_force": {"x": 0, "y": 1.5, "z": 0}}}],
        "verse_grip": [{"device_id": "61576",
            "state": {"orientation": {"w": 0, "x": 0, "y": 0, "z": 1}, "button": true}}]})");
}

Understood understood(const nlohmann::json& document, Message& message) {
    return read_message(document.dump(), message);
}

TEST(HaplyMessages, AStateIsReadWithWhatItSays) {
    Message message;
    ASSERT_EQ(understood(usual_message(), message), Understood::yes);
    ASSERT_EQ(message.devices.size(), 1U);
    const Inverse3& device = message.devices[0];
    EXPECT_EQ(device.id, "04BA");
    EXPECT_EQ(device.handedness, "right");
    EXPECT_TRUE(device.calibrated && device.powered);
    EXPECT_FALSE(device.in_use) << "of a version that does not say so";
    ASSERT_TRUE(device.position && device.force);
    EXPECT_EQ(*device.position, Vector3(0.01, -0.1, 0.2));
    EXPECT_EQ(*device.force, Vector3(0, 1.5, 0));
    ASSERT_EQ(message.grips.size(), 1U);
    ASSERT_TRUE(message.grips[0].orientation);
    EXPECT_EQ(message.grips[0].orientation->z(), 1);
    EXPECT_TRUE(message.grips[0].button[0]);
    EXPECT_FALSE(message.grips[0].button[1] || message.grips[0].button[2]);
}

TEST(HaplyMessages, AnInventoryHasNoStatesAndNoPower) {
    nlohmann::json document = usual_message();
    document["inverse3"][0].erase("state");
    document["inverse3"][0]["status"] = {{"calibrated", false}, {"power_supply", 0}, {"in_use", true}};
    document["verse_grip"][0].erase("state");
    Message message;
    ASSERT_EQ(understood(document, message), Understood::yes);
    EXPECT_FALSE(message.devices[0].position);
    EXPECT_FALSE(message.devices[0].calibrated || message.devices[0].powered);
    EXPECT_TRUE(message.devices[0].in_use);
    EXPECT_FALSE(message.grips[0].orientation);
}

TEST(HaplyMessages, ButtonsOfAWirelessGripHaveTheNamesOfEveryVersion) {
    for (const char* const names : {"abc", "012"})
        for (int pressed = 0; pressed < 3; ++pressed) {
            const std::string name =
                std::string(names == std::string("abc") ? "" : "button_") + names[pressed];
            nlohmann::json document = usual_message();
            nlohmann::json grip = {{"device_id", "7"}};
            grip["state"]["buttons"][name] = true;
            document.erase("verse_grip");
            document["wireless_verse_grip"] = nlohmann::json::array();
            document["wireless_verse_grip"].push_back(grip);
            Message message;
            ASSERT_EQ(understood(document, message), Understood::yes) << name;
            ASSERT_EQ(message.grips.size(), 1U);
            for (int i = 0; i < 3; ++i) EXPECT_EQ(message.grips[0].button[i], i == pressed) << name;
        }
}

TEST(HaplyMessages, PlacesAndTurnsThatAreNoneAreLeftOutAndTheRestIsRead) {
    const nlohmann::json places[] = {
        {{"x", 11}, {"y", 0}, {"z", 0}}, {{"x", 0}, {"y", 0}}, {{"x", "0"}, {"y", 0}, {"z", 0}}, nullptr, 3};
    for (const nlohmann::json& place : places) {
        nlohmann::json document = usual_message();
        document["inverse3"].push_back(document["inverse3"][0]);
        document["inverse3"][0]["state"]["cursor_position"] = place;
        Message message;
        EXPECT_EQ(understood(document, message), Understood::not_numbers) << place;
        ASSERT_EQ(message.devices.size(), 2U);
        EXPECT_FALSE(message.devices[0].position) << place;
        EXPECT_TRUE(message.devices[1].position) << "of the other device";
    }
    const nlohmann::json turns[] = {{{"w", 0}, {"x", 0}, {"y", 0}, {"z", 0}},
                                    {{"w", 2}, {"x", 0}, {"y", 0}, {"z", 0}},
                                    {{"w", 1}},
                                    "none"};
    for (const nlohmann::json& turn : turns) {
        nlohmann::json document = usual_message();
        document["verse_grip"][0]["state"]["orientation"] = turn;
        Message message;
        EXPECT_EQ(understood(document, message), Understood::not_numbers) << turn;
        EXPECT_FALSE(message.grips[0].orientation) << turn;
        EXPECT_TRUE(message.devices[0].position);
    }
}

TEST(HaplyMessages, OtherTextsAreNamed) {
    Message message;
    for (const char* text : {"", "{", "\xff", "{\"inverse3\": [1e999]}"})
        EXPECT_EQ(read_message(text, message), Understood::not_json) << text;
    for (const char* text : {"[]", "3", "null", "{}", R"({"inverse3": {}})", R"({"inverse4": []})"})
        EXPECT_EQ(read_message(text, message), Understood::other_service) << text;
    for (const char* name : {"error", "errors"}) {
        nlohmann::json document = usual_message();
        document[name] = "no such command";
        EXPECT_EQ(understood(document, message), Understood::refused);
    }
    EXPECT_EQ(read_message(R"({"inverse3": [3, "x", {"device_id": 4}, null]})", message), Understood::yes);
    EXPECT_TRUE(message.devices.empty()) << "no device without a name";
    nlohmann::json many = usual_message();
    for (int i = 0; i < 100; ++i) many["inverse3"].push_back(many["inverse3"][0]);
    EXPECT_EQ(understood(many, message), Understood::yes);
    EXPECT_LE(message.devices.size(), 8U);
}

TEST(HaplyMessages, EventsNameTheirDevice) {
    const auto event = read_event(R"({"name": "device-disconnected", "data": {"device_id": "04BA"}})");
    ASSERT_TRUE(event);
    EXPECT_EQ(event->name, "device-disconnected");
    EXPECT_EQ(event->device, "04BA");
    EXPECT_EQ(read_event(R"({"name": "server-started"})")->device, "");
    for (const char* text : {"", "[]", "{}", R"({"name": 3})", R"({"name": ""})"})
        EXPECT_FALSE(read_event(text)) << text;
}

TEST(HaplyMessages, AForceIsWrittenInTheFormOfTheVersionAndNeverAsSomethingElse) {
    using Forces = std::vector<std::pair<std::string, Vector3>>;
    const Forces forces = {{"0\"4", Vector3(1, -2.5, 0)}, {"B", Vector3(0, 0, 3)}};
    for (const ForceForm form : {ForceForm::vector, ForceForm::values}) {
        const nlohmann::json command = nlohmann::json::parse(force_command(forces, form));
        ASSERT_EQ(command.at("inverse3").size(), 2U);
        const nlohmann::json& one = command["inverse3"][0];
        EXPECT_EQ(one.at("device_id"), "0\"4");
        const nlohmann::json& force = one.at("commands").at("set_cursor_force");
        EXPECT_EQ(force.size(), 1U);
        EXPECT_EQ(force.at(form == ForceForm::vector ? "vector" : "values"),
                  nlohmann::json({{"x", 1.0}, {"y", -2.5}, {"z", 0.0}}));
    }
    EXPECT_EQ(force_command(Forces(), ForceForm::vector), R"({"inverse3":[]})");
    // A name with bytes that are not text does not throw where the loop runs.
    const Forces odd = {{"\xff", Vector3(0, 0, 0)}};
    EXPECT_FALSE(force_command(odd, ForceForm::vector).empty());
}

}  // namespace
}  // namespace fulcrum::haply
