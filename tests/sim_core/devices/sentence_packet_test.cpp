// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/sentence_packet.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace fulcrum {
namespace {

std::string in_capitals(const char* /*context*/, const char* source) {
    std::string text = source;
    for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

TEST(SentencePacket, ArrivesAsItWasSentAndIsPutIntoWordsThere) {
    const Sentence sent("%1 was ended by %2", std::string("a device"), Sentence("signal %1", 9));
    const Sentence arrived =
        sentence_of(nlohmann::json::parse(sentence_packet(sent).dump()), "nothing arrived");
    EXPECT_EQ(arrived.words(), "a device was ended by signal 9");
    EXPECT_EQ(arrived.words(in_capitals), "a device WAS ENDED BY SIGNAL 9") << "names stay as they are";
}

TEST(SentencePacket, BytesThatAreNotASentenceAreReplaced) {
    for (const char* packet : {"null", "3", "[]", "{}", R"({"say": 1, "with": []})", R"({"say": "x"})"})
        EXPECT_EQ(sentence_of(nlohmann::json::parse(packet), "unknown").words(), "unknown") << packet;
    EXPECT_EQ(sentence_of("as it is", "unknown").words(), "as it is");
    nlohmann::json deep = "inside";
    for (int i = 0; i < 1000; ++i) deep = {{"say", "%1"}, {"with", nlohmann::json::array({deep})}};
    EXPECT_EQ(sentence_of(deep, "unknown").words(), "") << "a packet that nests without end is cut off";
}

}  // namespace
}  // namespace fulcrum
