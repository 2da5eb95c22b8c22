// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/device_facts.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "sim_core/numerics/worded_error.h"

namespace fulcrum {
namespace {

nlohmann::json box_json(const std::optional<WorkspaceBox>& box) {
    if (!box) return nullptr;
    return {{"least_m", {box->least.x(), box->least.y(), box->least.z()}},
            {"most_m", {box->most.x(), box->most.y(), box->most.z()}}};
}

std::optional<WorkspaceBox> box_of(const nlohmann::json& document) {
    if (document.is_null()) return std::nullopt;
    WorkspaceBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        box.least[static_cast<Eigen::Index>(axis)] = document.at("least_m").at(axis).get<double>();
        box.most[static_cast<Eigen::Index>(axis)] = document.at("most_m").at(axis).get<double>();
    }
    if (!is_usable(box))
        throw WordedError(QT_TRANSLATE_NOOP("errors", "the device reports a workspace that is not possible"));
    return box;
}

}  // namespace

nlohmann::json to_json(const DeviceFacts& facts) {
    nlohmann::json document = {{"kind", facts.kind},  {"title", facts.title},   {"rate_hz", facts.rate},
                               {"slots", facts.slot}, {"clutch", facts.clutch}, {"firmware", facts.firmware}};
    for (const auto& box : facts.workspace) document["workspace"].push_back(box_json(box));
    for (const auto& force : facts.force) {
        if (!force) {
            document["force"].push_back(nullptr);
            continue;
        }
        document["force"].push_back({{"damping_n_s_m", force->damping},
                                     {"peak_n", force->peak},
                                     {"continuous_n", force->continuous},
                                     {"stiffness_n_m", force->stiffness},
                                     {"torque_n_m", force->torque}});
    }
    return document;
}

DeviceFacts facts_from_json(const nlohmann::json& document) {
    DeviceFacts facts;
    facts.kind = document.at("kind").get<std::string>();
    facts.title = document.at("title").get<std::string>();
    facts.rate = document.at("rate_hz").get<double>();
    for (std::size_t i = 0; i < device_slots; ++i) facts.slot[i] = document.at("slots").at(i).get<bool>();
    facts.firmware = document.at("firmware").get<std::string>();
    for (std::size_t i = 0; i < device_slots; ++i) {
        facts.clutch[i] = document.at("clutch").at(i).get<bool>();
        facts.workspace[i] = box_of(document.at("workspace").at(i));
    }
    for (std::size_t h = 0; h < 2; ++h) {
        const nlohmann::json& force = document.at("force").at(h);
        if (force.is_null()) continue;
        ForceOutput output;
        output.damping = force.at("damping_n_s_m").get<double>();
        output.peak = force.at("peak_n").get<double>();
        output.continuous = force.at("continuous_n").get<double>();
        output.stiffness = force.at("stiffness_n_m").get<double>();
        output.torque = force.at("torque_n_m").get<double>();
        if (!is_usable(output))
            throw WordedError(QT_TRANSLATE_NOOP("errors", "the device reports forces that are not possible"));
        facts.force[h] = output;
    }
    if (!(facts.rate >= 1 && facts.rate <= 1e5))
        throw WordedError(QT_TRANSLATE_NOOP("errors", "the device reports a rate that is not possible"));
    return facts;
}

}  // namespace fulcrum
