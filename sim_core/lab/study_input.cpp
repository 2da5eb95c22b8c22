// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/study_input.h"

#include <cmath>
#include <filesystem>

#include "sim_core/geometry/mesh_file.h"

namespace fulcrum::lab {
namespace {

const nlohmann::json* find(const JsonDocument& study, const std::string& key) {
    if (!study.root().is_object()) study.fail("", "a study must be a JSON object", "write {\"model\": …}");
    const auto place = study.root().find(key);
    return place == study.root().end() || place->is_null() ? nullptr : &*place;
}

[[noreturn]] void fail_missing(const JsonDocument& study, const std::string& key) {
    study.fail("", "the key \"" + key + "\" is missing",
               "add it; docs/FORMATS.md lists the keys of each model");
}

double checked(const JsonDocument& study, const std::string& pointer, const nlohmann::json& value,
               double least, double most) {
    const double number = value.is_number() ? value.get<double>() : std::nan("");
    if (!(number >= least && number <= most)) {
        study.fail(
            pointer, "the value is not a number within its range",
            "give a number from " + nlohmann::json(least).dump() + " to " + nlohmann::json(most).dump());
    }
    return number;
}

}  // namespace

std::string text_of(const JsonDocument& study, const std::string& key) {
    const auto* value = find(study, key);
    if (value == nullptr) fail_missing(study, key);
    if (!value->is_string() || value->get<std::string>().empty())
        study.fail("/" + key, "the value is not a string", "give a text in quotes");
    return value->get<std::string>();
}

double number_of(const JsonDocument& study, const std::string& key, double fallback, double least,
                 double most) {
    const auto* value = find(study, key);
    return value == nullptr ? fallback : checked(study, "/" + key, *value, least, most);
}

double number_of(const JsonDocument& study, const std::string& key, double least, double most) {
    const auto* value = find(study, key);
    if (value == nullptr) fail_missing(study, key);
    return checked(study, "/" + key, *value, least, most);
}

std::vector<double> numbers_of(const JsonDocument& study, const std::string& key, std::size_t count,
                               const std::vector<double>& fallback, double most) {
    const auto* value = find(study, key);
    if (value == nullptr) {
        if (fallback.empty()) fail_missing(study, key);
        return fallback;
    }
    return numbers_at(study, *value, "/" + key, count, most);
}

std::vector<double> numbers_at(const JsonDocument& study, const nlohmann::json& value,
                               const std::string& pointer, std::size_t count, double most) {
    if (!value.is_array() || value.size() != count) {
        study.fail(pointer, "the value is not an array of " + std::to_string(count) + " numbers",
                   "give " + std::to_string(count) + " numbers in brackets");
    }
    std::vector<double> numbers;
    for (std::size_t i = 0; i < count; ++i) {
        numbers.push_back(checked(study, pointer + "/" + std::to_string(i), value[i], -most, most));
    }
    return numbers;
}

std::vector<std::int32_t> vertex_list_of(const JsonDocument& study, const std::string& key,
                                         std::size_t vertices) {
    std::vector<std::int32_t> numbers;
    const auto* list = find(study, key);
    if (list == nullptr) return numbers;
    if (!list->is_array())
        study.fail("/" + key, "the value is not a list", "give vertex numbers in brackets");
    for (std::size_t i = 0; i < list->size(); ++i) {
        const auto& number = (*list)[i];
        if (!number.is_number_integer() || number.get<double>() < 0 ||
            number.get<double>() >= static_cast<double>(vertices))
            study.fail("/" + key + "/" + std::to_string(i), "the mesh has no vertex of this number",
                       "give whole numbers from 0 to " + std::to_string(vertices - 1));
        numbers.push_back(number.get<std::int32_t>());
    }
    return numbers;
}

TriangleMesh mesh_of(const JsonDocument& study, const std::string& key) {
    const std::string name = text_of(study, key);
    const std::filesystem::path next_to_study = std::filesystem::path(study.file()).parent_path() / name;
    std::error_code ignored;
    return read_obj(std::filesystem::exists(next_to_study, ignored) ? next_to_study.string() : name);
}

}  // namespace fulcrum::lab
