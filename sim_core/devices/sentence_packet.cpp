// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/sentence_packet.h"

#include <nlohmann/json.hpp>

namespace fulcrum {
namespace {

constexpr int deepest = 8;

Sentence read(const nlohmann::json& packet, const Sentence& otherwise, int depth) {
    if (packet.is_string()) return packet.get<std::string>();
    if (depth == deepest || !packet.is_object()) return otherwise;
    const auto said = packet.find("say"), with = packet.find("with");
    if (said == packet.end() || with == packet.end() || !said->is_string() || !with->is_array())
        return otherwise;
    std::vector<Sentence> parts;
    for (const nlohmann::json& part : *with) parts.push_back(read(part, {}, depth + 1));
    return Sentence::from_parts(said->get<std::string>(), true, std::move(parts));
}

}  // namespace

nlohmann::json sentence_packet(const Sentence& sentence) {
    if (!sentence.marked()) return sentence.words();
    nlohmann::json parts = nlohmann::json::array();
    for (const Sentence& part : sentence.parts()) parts.push_back(sentence_packet(part));
    return {{"say", sentence.source()}, {"with", std::move(parts)}};
}

Sentence sentence_of(const nlohmann::json& packet, const Sentence& otherwise) {
    return read(packet, otherwise, 0);
}

}  // namespace fulcrum
