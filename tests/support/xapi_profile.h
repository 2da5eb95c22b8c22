// SPDX-License-Identifier: Apache-2.0
// Holds a statement against an xAPI profile, as the specification of profiles (1.0, part 3: processing
// statement templates) says: which templates it matches, whether it follows their rules, whether its
// extensions are concepts of the profile with values of their schemas.
#pragma once

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace fulcrum::test {

/// What a location (JSONPath of the profile: $.a.b, ['name'], [*]) selects: parts of the statement.
inline std::vector<const nlohmann::json*> selected_by(const std::string& location,
                                                      const nlohmann::json& statement) {
    std::vector<const nlohmann::json*> found{&statement};
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
        std::vector<const nlohmann::json*> next;
        for (const nlohmann::json* one : found) {
            if (all && one->is_array())
                for (const nlohmann::json& element : *one) next.push_back(&element);
            if (!all && one->is_object() && one->contains(name)) next.push_back(&one->at(name));
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
        const std::vector<const nlohmann::json*> values = selected_by(location, statement);
        if (presence == "included" && values.empty()) problems.push_back(location + " is missing");
        if (presence == "excluded" && !values.empty()) problems.push_back(location + " is there");
        const auto shares = [&](const nlohmann::json& list) {
            for (const nlohmann::json* value : values)
                for (const nlohmann::json& one : list)
                    if (one == *value) return true;
            return false;
        };
        if (rule.contains("any") && !values.empty() && !shares(rule.at("any")))
            problems.push_back(location + " is " + values.front()->dump());
        if (rule.contains("none") && shares(rule.at("none")))
            problems.push_back(location + " is " + values.front()->dump());
    }
    return problems;
}

inline bool has_json_type(const nlohmann::json& value, const std::string& type) {
    if (type == "null") return value.is_null();
    if (type == "boolean") return value.is_boolean();
    if (type == "integer") return value.is_number_integer();
    if (type == "number") return value.is_number();
    if (type == "string") return value.is_string();
    if (type == "array") return value.is_array();
    return type == "object" && value.is_object();
}

/// `types`: one, or a list of them.
inline bool has_one_of_types(const nlohmann::json& value, const nlohmann::json& types) {
    if (!types.is_array()) return has_json_type(value, types.get_ref<const std::string&>());
    return std::any_of(types.begin(), types.end(), [&](const nlohmann::json& one) {
        return has_json_type(value, one.get_ref<const std::string&>());
    });
}

/// Letters of a text in UTF-8.
inline std::size_t letters_in(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
    }));
}

/// What is wrong with a value by a schema of the profile; empty: nothing. Written for the keywords that the
/// profile uses, any other is a problem: the product's reader, made for files written by hand, takes many
/// times as long for the evidence of thousands of metrics. XapiProfile shows that both judge alike.
inline std::string schema_problem(const nlohmann::json& schema, const nlohmann::json& value) {
    for (const auto& [keyword, rule] : schema.items()) {
        bool fits = true;
        std::string inside;
        if (keyword == "type") {
            fits = has_one_of_types(value, rule);
        } else if (keyword == "enum") {
            fits = std::find(rule.begin(), rule.end(), value) != rule.end();
        } else if (keyword == "minLength") {
            fits = !value.is_string() ||
                   letters_in(value.get_ref<const std::string&>()) >= rule.get<std::size_t>();
        } else if (keyword == "minItems") {
            fits = !value.is_array() || value.size() >= rule.get<std::size_t>();
        } else if (keyword == "maxItems") {
            fits = !value.is_array() || value.size() <= rule.get<std::size_t>();
        } else if (keyword == "required") {
            for (const nlohmann::json& name : rule)
                fits = fits && (!value.is_object() || value.contains(name.get_ref<const std::string&>()));
        } else if (keyword == "properties") {
            for (const auto& [name, part] : rule.items())
                if (inside.empty() && value.is_object() && value.contains(name))
                    inside = schema_problem(part, value.at(name));
        } else if (keyword == "items") {
            if (value.is_array())
                for (const nlohmann::json& element : value)
                    if (inside.empty()) inside = schema_problem(rule, element);
        } else {
            fits = false;
        }
        if (!fits) return value.dump() + " does not have " + keyword + ' ' + rule.dump();
        if (!inside.empty()) return inside;
    }
    return {};
}

/// The concept of the profile that an extension is; null: there is none.
inline const nlohmann::json* concept_of_profile(const nlohmann::json& profile, const std::string& id,
                                                const char* type) {
    for (const nlohmann::json& one : profile.at("concepts"))
        if (one.at("id") == id && one.at("type") == type) return &one;
    return nullptr;
}

/// The schema in this text. Each text is parsed once: thousands of statements name the same few.
inline const nlohmann::json& parsed_schema(const std::string& text) {
    static std::map<std::string, nlohmann::json> parsed;
    const auto found = parsed.find(text);
    if (found != parsed.end()) return found->second;
    return parsed.emplace(text, nlohmann::json::parse(text)).first->second;
}

inline std::vector<std::string> extension_problems(const nlohmann::json& profile,
                                                   const nlohmann::json& statement) {
    std::vector<std::string> problems;
    const std::string verb = statement.at("verb").at("id");
    for (const auto& [part, type] :
         {std::pair{"result", "ResultExtension"}, {"context", "ContextExtension"}}) {
        if (!statement.contains(part) || !statement.at(part).contains("extensions")) continue;
        for (const auto& [id, value] : statement.at(part).at("extensions").items()) {
            const nlohmann::json* concept_of = concept_of_profile(profile, id, type);
            if (concept_of == nullptr) {
                problems.push_back(id + " is no " + type + " of the profile");
                continue;
            }
            const nlohmann::json& schema =
                parsed_schema(concept_of->at("inlineSchema").get_ref<const std::string&>());
            const std::string wrong = schema_problem(schema, value);
            if (!wrong.empty()) problems.push_back(id + ": " + wrong);
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
        const std::vector<const nlohmann::json*> type = selected_by("$.object.definition.type", statement);
        const bool same_type = !one.contains("objectActivityType") ||
                               (!type.empty() && *type.front() == one.at("objectActivityType"));
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
