// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/hand_study.h"

#include <nlohmann/json.hpp>

#include "sim_core/instrument/lever.h"
#include "sim_core/lab/study_input.h"

namespace fulcrum::lab {
namespace {

constexpr double furthest = 10, largest = 1e6;  // m, N
constexpr double nearest_handle = 1e-3;         // m from the trocar

// The object at a pointer, with exactly these keys.
const nlohmann::json& object_at(const JsonDocument& study, const nlohmann::json& value,
                                const std::string& place, const std::vector<std::string>& keys,
                                const std::string& form) {
    if (!value.is_object()) study.fail(place, "the value is not an object", "write " + form);
    for (const std::string& key : keys) {
        if (!value.contains(key)) study.fail(place, "the key \"" + key + "\" is missing", "write " + form);
    }
    for (const auto& [key, content] : value.items()) {
        static_cast<void>(content);
        bool known = !key.empty() && key.front() == '$';
        for (const std::string& name : keys) known = known || name == key;
        if (!known)
            study.fail(place + "/" + key, "unknown key \"" + key.substr(0, 40) + "\"", "write " + form);
    }
    return value;
}

const nlohmann::json& list_at(const JsonDocument& study, const nlohmann::json& value,
                              const std::string& place, const std::string& form) {
    if (!value.is_array()) study.fail(place, "the value is not a list", "write " + form);
    return value;
}

Vector3 vector_at(const JsonDocument& study, const nlohmann::json& value, const std::string& place,
                  double most) {
    const std::vector<double> numbers = numbers_at(study, value, place, 3, most);
    return {numbers[0], numbers[1], numbers[2]};
}

HandLoad run_case(const JsonDocument& study, const nlohmann::json& given, const std::string& place,
                  const Vector3& trocar) {
    object_at(study, given, place, {"handle", "loads"}, R"({"handle": [x, y, z], "loads": [...]})");
    const Vector3 handle = vector_at(study, given["handle"], place + "/handle", furthest) - trocar;
    if (!(handle.norm() >= nearest_handle))
        study.fail(place + "/handle", "the handle is less than 1 mm from the trocar",
                   "give the place of the handle outside the body, in metres");
    const std::string form = R"({"at": [x, y, z], "force": [x, y, z]})";
    const nlohmann::json& loads = list_at(study, given["loads"], place + "/loads", "[" + form + ", ...]");
    ToolLoad sum;
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const std::string at = place + "/loads/" + std::to_string(i);
        object_at(study, loads[i], at, {"at", "force"}, form);
        sum.add(vector_at(study, loads[i]["at"], at + "/at", furthest) - trocar,
                vector_at(study, loads[i]["force"], at + "/force", largest));
    }
    return load_at_hand(handle, sum);
}

}  // namespace

nlohmann::json run_hand_study(const JsonDocument& study) {
    const std::vector<double> place = numbers_of(study, "trocar", 3, {}, furthest);
    const Vector3 trocar(place[0], place[1], place[2]);
    if (!study.root().contains("cases"))
        study.fail("", "the key \"cases\" is missing",
                   "add it; docs/FORMATS.md lists the keys of each model");
    const nlohmann::json& cases =
        list_at(study, study.root()["cases"], "/cases", R"([{"handle": [x, y, z], "loads": [...]}])");
    nlohmann::json result;
    result["cases"] = nlohmann::json::array();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const HandLoad felt = run_case(study, cases[i], "/cases/" + std::to_string(i), trocar);
        result["cases"].push_back({{"hand_force", {felt.force.x(), felt.force.y(), felt.force.z()}},
                                   {"shaft_torque_n_m", felt.torque}});
    }
    return result;
}

}  // namespace fulcrum::lab
