// SPDX-License-Identifier: Apache-2.0
// The references in docs/ are generated: scenes and tasks from their schemas (metrics from the registry:
// tests/assessment/metrics/reference_test.cpp). FULCRUM_WRITE_REFERENCES=1 writes the files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/generated.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

namespace fs = std::filesystem;
using json = nlohmann::ordered_json;

using test::expect_generated;
using test::expect_generated_file;
using test::in_cell;
using test::text_of;

std::string number_text(const json& value) {
    if (!value.is_number_float()) return value.dump();
    std::ostringstream out;
    out << value.get<double>();
    return out.str();
}

std::string value_text(const json& value) {
    if (value.is_number()) return number_text(value);
    if (value.is_array()) {
        std::string text = "[";
        for (const json& item : value) text += (text.size() > 1 ? ", " : "") + value_text(item);
        return text + "]";
    }
    return value.is_string() ? value.get<std::string>() : value.dump();
}

/// "number, 0 to 20", "a, b or c", "list of ...".
std::string type_text(const json& node) {
    if (node.contains("$ref")) {
        const std::string name = node["$ref"].get<std::string>();
        const std::string last = name.substr(name.rfind('/') + 1);
        return last == "vector" ? "vector [x, y, z]" : "[" + last + "](#" + last + ")";
    }
    if (node.contains("enum")) {
        std::string text;
        for (const json& one : node["enum"]) text += (text.empty() ? "" : ", ") + value_text(one);
        return "one of: " + text;
    }
    const std::string type = node.value("type", "any");
    if (type == "array") {
        std::string text = "list";
        if (node.contains("minItems") || node.contains("maxItems"))
            text += " of " + (node.contains("minItems") ? node["minItems"].dump() : std::string("0")) +
                    (node.contains("maxItems") ? " to " + node["maxItems"].dump() : std::string(" or more"));
        return node.contains("items") && node["items"].value("type", "") != "object"
                   ? text + ": " + type_text(node["items"])
                   : text;
    }
    if (type == "string" || type == "boolean") return type == "string" ? "text" : "true or false";
    std::string text = type == "integer" ? "whole number" : type;
    if (node.contains("minimum")) text += ", from " + number_text(node["minimum"]);
    if (node.contains("exclusiveMinimum")) text += ", above " + number_text(node["exclusiveMinimum"]);
    if (node.contains("maximum")) text += ", to " + number_text(node["maximum"]);
    return text;
}

bool is_required(const json& object, const std::string& key) {
    if (!object.contains("required")) return false;
    const json& names = object["required"];
    return std::find(names.begin(), names.end(), key) != names.end();
}

/// A section for an object and one for each object in it.
std::string object_section(const json& object, const std::string& title) {
    std::string text = "## " + title + "\n\n";
    if (object.contains("description")) text += object["description"].get<std::string>() + "\n\n";
    text += "| key | value | default | meaning |\n| --- | --- | --- | --- |\n";
    std::vector<std::pair<std::string, const json*>> inner;
    for (const auto& [key, node] : object["properties"].items()) {
        if (key == "$comment") continue;
        const bool is_object = node.value("type", "") == "object";
        const bool is_list = node.contains("items") && node["items"].value("type", "") == "object";
        const std::string name = title == "scene" || title == "task" ? key : title + "." + key;
        if (is_object) inner.emplace_back(name, &node);
        if (is_list) inner.emplace_back(name, &node["items"]);
        std::string type = is_object || is_list
                               ? std::string(is_list ? "list of objects" : "object") + ", see below"
                               : type_text(node);
        std::string fallback = is_required(object, key) ? "**required**" : "absent";
        if (node.contains("default")) fallback = value_text(node["default"]);
        if (fallback.empty()) fallback = "empty";
        text += "| `" + key + "` | " + in_cell(type) + " | " + in_cell(fallback) + " | " +
                in_cell(node.value("description", "")) + " |\n";
    }
    text += "\n";
    for (const auto& [name, node] : inner) text += object_section(*node, name);
    return text;
}

std::string schema_text(const json& schema, const std::string& title) {
    std::string text = object_section(schema, title);
    for (const auto& [name, node] : schema["definitions"].items())
        if (node.value("type", "") == "object") text += object_section(node, name);
    return text;
}

std::vector<fs::path> json_files(const std::string& folder) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(test::source_path(folder)))
        if (entry.path().extension() == ".json") found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

/// The parts of scenes, in order: the name of each and the structure that it is read into.
std::vector<std::pair<std::string, std::string>> scene_parts() {
    static const std::regex line(R"(SCENE_PART\(std::(?:optional|vector)<(\w+)>, (\w+)\))");
    const std::string text = text_of("sim_core/scene/scene_parts.inc");
    std::vector<std::pair<std::string, std::string>> parts;
    for (std::sregex_iterator it(text.begin(), text.end(), line), end; it != end; ++it)
        parts.emplace_back((*it)[2].str(), (*it)[1].str());
    return parts;
}

/// What sim_core/scene/scene_schema.cpp puts together, with keys in their order.
json scene_schema_of_parts() {
    const json common = json::parse(text_of("assets/schemas/scene/common.json"));
    json schema = common;
    schema["$comment"] = "SPDX-License-Identifier: Apache-2.0";
    json& properties = schema["properties"] = json::object();
    for (const auto& [key, node] : common["properties"].items()) {
        if (key == "fidelity") {
            for (const auto& part : scene_parts()) {
                properties[part.first] = json::parse(text_of("assets/schemas/scene/" + part.first + ".json"));
                properties[part.first].erase("$comment");
            }
        }
        properties[key] = node;
    }
    return schema;
}

TEST(References, TheSchemaOfScenesIsPutTogetherFromItsParts) {
    ASSERT_GE(scene_parts().size(), 12U);
    std::set<std::string> files, parts = {"common"};
    for (const fs::path& path : json_files("assets/schemas/scene")) files.insert(path.stem().string());
    for (const auto& part : scene_parts()) parts.insert(part.first);
    EXPECT_EQ(files, parts) << "a file for each line of sim_core/scene/scene_parts.inc";
    expect_generated_file("assets/schemas/scene.schema.json", scene_schema_of_parts().dump(1) + "\n");
}

TEST(References, ScenesAreThoseOfTheSchema) {
    const json schema = scene_schema_of_parts();
    std::string text = "## The scenes in `assets/scenes`\n\n| file | parts |\n| --- | --- |\n";
    for (const fs::path& path : json_files("assets/scenes")) {
        std::string parts;
        const json scene = json::parse(text_of(fs::relative(path, test::source_path("")).string()));
        for (const auto& [key, node] : scene.items())
            if ((node.is_object() || node.is_array()) && key != "tissues" && key != "instruments" &&
                key != "gravity")
                parts += (parts.empty() ? "" : ", ") + key;
        text += "| `assets/scenes/" + path.filename().string() + "` | " + parts + " |\n";
    }
    expect_generated("SCENES.md", "scenes", text + "\n" + schema_text(schema, "scene"));
}

TEST(References, TasksAreThoseOfTheSchema) {
    const json schema = json::parse(text_of("assets/schemas/task.schema.json"));
    std::string text =
        "## The tasks in `assets/tasks`\n\n| task | title | scene | goals | gates | critical errors |\n"
        "| --- | --- | --- | --- | --- | --- |\n";
    for (const fs::path& path : json_files("assets/tasks")) {
        const json task = json::parse(text_of(fs::relative(path, test::source_path("")).string()));
        std::string goals, errors;
        for (const json& goal : task["goals"])
            goals += (goals.empty() ? "" : ", ") + goal["kind"].get<std::string>();
        for (const json& error : task.value("critical_errors", json::array()))
            errors += (errors.empty() ? "" : ", ") + error.get<std::string>();
        text += "| " + task["id"].get<std::string>() + " | " + task["title"].get<std::string>() + " | " +
                task["scene"].get<std::string>() + " | " + goals + " | " +
                std::to_string(task["gates"].size()) + " | " + errors + " |\n";
    }
    expect_generated("TASKS.md", "tasks", text + "\n" + schema_text(schema, "task"));
}

/// Initial values of the fields of every struct in sim_core's headers, as written.
using Fields = std::map<std::string, std::string>;
struct Struct {
    std::string base;
    Fields fields;
};

/// Splits at commas outside brackets.
std::vector<std::string> declarators(const std::string& text) {
    std::vector<std::string> parts(1);
    int depth = 0;
    for (const char c : text) {
        depth += c == '(' || c == '{' ? 1 : c == ')' || c == '}' ? -1 : 0;
        if (c == ',' && depth == 0)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

std::string trimmed(const std::string& text) {
    const std::size_t from = text.find_first_not_of(" \n"), to = text.find_last_not_of(" \n");
    return from == std::string::npos ? "" : text.substr(from, to - from + 1);
}

std::map<std::string, Struct> structs_of_headers() {
    static const std::regex comment("//[^\n]*");
    static const std::regex head(R"(\bstruct (\w+)( : (public )?(\w+))? \{\n)");
    static const std::regex field(
        R"((?:^|\n)\s*(?:static constexpr )?([\w:]+) (\w+ =[^;]*|\w+, \w+ =[^;]*);)");
    std::map<std::string, Struct> structs;
    for (const auto& entry : fs::recursive_directory_iterator(test::source_path("sim_core"))) {
        if (entry.path().extension() != ".h") continue;
        const std::string text = std::regex_replace(
            text_of(fs::relative(entry.path(), test::source_path("")).string()), comment, "");
        for (std::sregex_iterator it(text.begin(), text.end(), head), none; it != none; ++it) {
            const auto from = static_cast<std::size_t>(it->position() + it->length());
            const std::string body = text.substr(from, text.find("\n};", from) - from);
            Struct& found = structs[(*it)[1].str()];
            found.base = (*it)[4].str();
            for (std::sregex_iterator f(body.begin(), body.end(), field); f != none; ++f)
                for (const std::string& part : declarators((*f)[2].str())) {
                    const std::size_t equals = part.find('=');
                    if (equals != std::string::npos)
                        found.fields[trimmed(part.substr(0, equals))] = trimmed(part.substr(equals + 1));
                }
        }
    }
    return structs;
}

const std::string* initial_value(const std::map<std::string, Struct>& structs, std::string name,
                                 const std::string& field) {
    for (auto at = structs.find(name); at != structs.end(); at = structs.find(at->second.base)) {
        const auto value = at->second.fields.find(field);
        if (value != at->second.fields.end()) return &value->second;
    }
    return nullptr;
}

bool same_letters(const std::string& first, const std::string& second) {
    return std::equal(first.begin(), first.end(), second.begin(), second.end(), [](char a, char b) {
        return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
    });
}

/// Whether a default of the schema is what a field starts with.
bool same_value(const json& fallback, const std::string& initial, bool degrees) {
    if (fallback.is_boolean()) return initial == (fallback.get<bool>() ? "true" : "false");
    if (fallback.is_string()) {
        const std::string name = fallback.get<std::string>();
        const std::size_t scope = initial.rfind("::");
        if (scope == std::string::npos) return initial == "\"" + name + "\"";
        return same_letters(initial.substr(scope + 2), name);  // an enumerator
    }
    if (fallback.is_array()) {
        if (initial == "Vector3::Zero()") return fallback == json::array({0, 0, 0});
        if (initial == "Vector3::UnitZ()") return fallback == json::array({0, 0, 1});
        const std::size_t open = initial.find('('), close = initial.rfind(')');
        if (open == std::string::npos || close == std::string::npos) return false;
        const auto parts = declarators(initial.substr(open + 1, close - open - 1));
        if (parts.size() != fallback.size()) return false;
        for (std::size_t i = 0; i < parts.size(); ++i)
            if (std::stod(parts[i]) != fallback[i].get<double>()) return false;
        return true;
    }
    const double factor = degrees ? 3.14159265358979323846 / 180 : 1;
    const double expected = factor * fallback.get<double>(), value = std::stod(initial);
    return std::abs(value - expected) <= 1e-9 * std::max(1.0, std::abs(value));
}

/// Objects of the scene's schema and the structures that they are read into.
const std::map<std::string, std::string>& structure_of() {
    static const auto table = [] {
        std::map<std::string, std::string> all = {{"scene", "Scene"},
                                                  {"camera", "CameraSpec"},
                                                  {"bowel.nodule", "NoduleSpec"},
                                                  {"sheet.fibres", "FibreSpec"},
                                                  {"septa.fibres", "FibreSpec"},
                                                  {"fidelity", "Fidelity"},
                                                  {"tissue", "TissueSpec"},
                                                  {"tissue.cutting", "CuttingSpec"},
                                                  {"trocar", "TrocarSpec"},
                                                  {"instrument", "InstrumentSpec"}};
        for (const auto& part : scene_parts()) all.insert(part);
        return all;
    }();
    return table;
}

void check_defaults(const json& object, const std::string& title,
                    const std::map<std::string, Struct>& structs, int& checked) {
    for (const auto& [key, node] : object["properties"].items()) {
        const std::string name = title == "scene" ? key : title + "." + key;
        if (node.value("type", "") == "object") check_defaults(node, name, structs, checked);
        if (node.contains("items") && node["items"].value("type", "") == "object")
            check_defaults(node["items"], name, structs, checked);
        if (!node.contains("default")) continue;
        const auto structure = structure_of().find(title);
        ASSERT_NE(structure, structure_of().end()) << title << ": name the structure that it is read into";
        const bool degrees = key.size() > 4 && key.compare(key.size() - 4, 4, "_deg") == 0;
        std::string field = degrees ? key.substr(0, key.size() - 4) : key;
        if (structure->second == "FibreSpec") field = field.substr(0, field.find('_'));
        const std::string* initial = initial_value(structs, structure->second, field);
        ASSERT_NE(initial, nullptr) << structure->second << " has no field " << field << " with a value";
        // A value may be a constant of the same structure.
        if (const std::string* constant = initial_value(structs, structure->second, *initial))
            initial = constant;
        EXPECT_TRUE(same_value(node["default"], *initial, degrees))
            << name << ": the schema says " << node["default"] << ", the code " << *initial;
        ++checked;
    }
}

TEST(References, DefaultsOfTheSceneSchemaAreThoseOfTheCode) {
    const json schema = scene_schema_of_parts();
    const auto structs = structs_of_headers();
    int checked = 0;
    check_defaults(schema, "scene", structs, checked);
    for (const auto& [name, node] : schema["definitions"].items())
        if (node.value("type", "") == "object") check_defaults(node, name, structs, checked);
    EXPECT_GE(checked, 190);
    EXPECT_FALSE(same_value(json(3), "4", false));
}

}  // namespace
}  // namespace fulcrum
