// SPDX-License-Identifier: Apache-2.0
// Holds a statement against an xAPI profile, as the specification of profiles (1.0, part 3: processing
// statement templates) says: which templates it matches, whether it follows their rules, whether its
// extensions are concepts of the profile with values of their schemas.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim_core/scene/json_document.h"

namespace fulcrum::test {

/// What a location (JSONPath of the profile: $.a.b, ['name'], [*]) selects.
inline std::vector<nlohmann::json> selected_by(const std::string& location, const nlohmann::json& statement) {
    std::vector<nlohmann::json> found{statement};
    std::size_t at = 1;  // after $
    while (at < location.size()) {
        std::string name;
        bool all = false;
        if (location.compare(at, 3, "[*]") == 0) {
            all = true;
            at += 3;
        } else if (location.compare(at, 2, "['") == 0) {
            const std::size_t end = location.find("']", at);
            name = location.substr(at + 2, end - at - 2);
            at = end + 2;
        } else {
            const std::size_t end = location.find_first_of(".[", at + 1);
            name = location.substr(at + 1, (end == std::string::npos ? location.size() : end) - at - 1);
            at = end == std::string::npos ? location.size() : end;
        }
        std::vector<nlohmann::json> next;
        for (const nlohmann::json& one : found) {
            if (all && one.is_array()) next.insert(next.end(), one.begin(), one.end());
            if (!all && one.is_object() && one.contains(name)) next.push_back(one.at(name));
        }
        found = std::move(next);
    }
    return found;
}

inline std::vector<std::string> template_problems(const nlohmann::json& of, const nlohmann::json& statement) {
    std::vector<std::string> problems;
    for (const nlohmann::json& rule : of.at("rules")) {
        const std::string location = rule.at("location");
        const std::string presence = rule.value("presence", "");
        const std::vector<nlohmann::json> values = selected_by(location, statement);
        if (presence == "included" && values.empty()) problems.push_back(location + " is missing");
        if (presence == "excluded" && !values.empty()) problems.push_back(location + " is there");
        const auto shares = [&](const nlohmann::json& list) {
            for (const nlohmann::json& value : values)
                for (const nlohmann::json& one : list)
                    if (one == value) return true;
            return false;
        };
        if (rule.contains("any") && !values.empty() && !shares(rule.at("any")))
            problems.push_back(location + " is " + values.front().dump());
        if (rule.contains("none") && shares(rule.at("none")))
            problems.push_back(location + " is " + values.front().dump());
    }
    return problems;
}

inline std::vector<std::string> extension_problems(const nlohmann::json& profile,
                                                   const nlohmann::json& statement) {
    std::vector<std::string> problems;
    const std::string verb = statement.at("verb").at("id");
    for (const auto& [part, type] :
         {std::pair{"result", "ResultExtension"}, {"context", "ContextExtension"}}) {
        if (!statement.contains(part) || !statement.at(part).contains("extensions")) continue;
        for (const auto& [id, value] : statement.at(part).at("extensions").items()) {
            const nlohmann::json* concept_of = nullptr;
            for (const nlohmann::json& one : profile.at("concepts"))
                if (one.at("id") == id && one.at("type") == type) concept_of = &one;
            if (concept_of == nullptr) {
                problems.push_back(id + " is no " + type + " of the profile");
                continue;
            }
            try {
                JsonDocument::parse(value.dump(), id)
                    .check_schema(concept_of->at("inlineSchema").get<std::string>().c_str());
            } catch (const std::exception& error) {
                problems.push_back(error.what());
            }
            if (!concept_of->contains("recommendedVerbs")) continue;
            const nlohmann::json& verbs = concept_of->at("recommendedVerbs");
            if (std::find(verbs.begin(), verbs.end(), verb) == verbs.end())
                problems.push_back(id + " with the verb " + verb);
        }
    }
    return problems;
}

/// Empty: the statement follows exactly one template of the profile.
inline std::vector<std::string> profile_problems(const nlohmann::json& profile,
                                                 const nlohmann::json& statement) {
    std::vector<const nlohmann::json*> matching;
    for (const nlohmann::json& one : profile.at("templates")) {
        const std::vector<nlohmann::json> type = selected_by("$.object.definition.type", statement);
        const bool same_type = !one.contains("objectActivityType") ||
                               (!type.empty() && type.front() == one.at("objectActivityType"));
        if (one.at("verb") == statement.at("verb").at("id") && same_type) matching.push_back(&one);
    }
    if (matching.size() != 1)
        return {std::to_string(matching.size()) + " templates match the verb and the object"};
    std::vector<std::string> problems = template_problems(*matching.front(), statement);
    for (std::string& problem : extension_problems(profile, statement))
        problems.push_back(std::move(problem));
    return problems;
}

}  // namespace fulcrum::test
