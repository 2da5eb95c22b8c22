// SPDX-License-Identifier: Apache-2.0
// Schema check by valijson; its findings become one error that the user can act on.
#ifndef VALIJSON_USE_EXCEPTIONS
#define VALIJSON_USE_EXCEPTIONS 1
#endif
#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>
#include <stdexcept>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "sim_core/scene/json_document.h"

namespace fulcrum {
namespace {

using nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

const json& resolve(const json& schema, const json& node) {
    const json* at = &node;
    for (int hops = 0; at->is_object() && at->contains("$ref") && hops < 8; ++hops) {
        at = &schema.at(json::json_pointer(at->at("$ref").get<std::string>().substr(1)));
    }
    return *at;
}

// The part of the schema for a place in the document; the root schema if there is none.
const json& schema_at(const json& schema, const std::vector<std::string>& tokens) {
    const json* at = &resolve(schema, schema);
    for (const std::string& token : tokens) {
        if (at->contains("properties") && at->at("properties").contains(token)) {
            at = &resolve(schema, at->at("properties").at(token));
        } else if (at->contains("items")) {
            at = &resolve(schema, at->at("items"));
        } else {
            break;
        }
    }
    return *at;
}

std::string plain(const json& value) {
    return value.is_string() ? value.get<std::string>() : value.dump();
}

std::string list_of(const json& values) {
    std::string text;
    for (const json& value : values) text += (text.empty() ? "" : ", ") + plain(value);
    return text;
}

std::string keys_of(const json& node) {
    std::string text;
    for (const auto& entry : node.at("properties").items()) {
        if (entry.key() != "$comment") text += (text.empty() ? "" : ", ") + entry.key();
    }
    return text;
}

/// "number", "list" ... A schema lists one type or several.
Sentence type_words(const json& type) {
    if (type.is_array())
        return type.size() == 2 ? Sentence(QT_TRANSLATE_NOOP("errors", "%1 or %2"), type_words(type[0]),
                                           type_words(type[1]))
                                : Sentence(list_of(type));
    constexpr std::pair<const char*, const char*> names[] = {
        {"object", QT_TRANSLATE_NOOP("errors", "an object")},
        {"array", QT_TRANSLATE_NOOP("errors", "a list")},
        {"integer", QT_TRANSLATE_NOOP("errors", "a whole number")},
        {"number", QT_TRANSLATE_NOOP("errors", "a number")},
        {"string", QT_TRANSLATE_NOOP("errors", "a text")},
        {"boolean", QT_TRANSLATE_NOOP("errors", "true or false")},
        {"null", QT_TRANSLATE_NOOP("errors", "null")}};
    for (const auto& [name, words] : names)
        if (type == name) return words;
    return plain(type);
}

/// A number with its range, a list with its length.
Sentence with_limits(const Sentence& type, const json& node) {
    if (node.contains("minItems") && node.contains("maxItems") && node.at("minItems") == node.at("maxItems"))
        return {QT_TRANSLATE_NOOP("errors", "%1 of %2"), type, node.at("minItems").dump()};
    const bool above = node.contains("exclusiveMinimum"), from = node.contains("minimum");
    const std::string low = above  ? node.at("exclusiveMinimum").dump()
                            : from ? node.at("minimum").dump()
                                   : "";
    const std::string high = node.contains("maximum") ? node.at("maximum").dump() : "";
    if (above && !high.empty()) return {QT_TRANSLATE_NOOP("errors", "%1 above %2 to %3"), type, low, high};
    if (above) return {QT_TRANSLATE_NOOP("errors", "%1 above %2"), type, low};
    if (from && !high.empty()) return {QT_TRANSLATE_NOOP("errors", "%1 from %2 to %3"), type, low, high};
    if (from) return {QT_TRANSLATE_NOOP("errors", "%1 from %2"), type, low};
    return high.empty() ? type : Sentence(QT_TRANSLATE_NOOP("errors", "%1 up to %2"), type, high);
}

/// "give ...": type, range, choices and the schema's own description, which is in English.
Sentence legal_value(const json& node) {
    Sentence value;
    if (node.contains("enum")) {
        value = Sentence(QT_TRANSLATE_NOOP("errors", "one of: %1"), list_of(node.at("enum")));
    } else if (node.contains("const")) {
        value = plain(node.at("const"));
    } else if (node.contains("type")) {
        value = with_limits(type_words(node.at("type")), node);
    } else {
        value = QT_TRANSLATE_NOOP("errors", "another value");
    }
    if (!node.contains("description")) return {QT_TRANSLATE_NOOP("errors", "give %1"), value};
    return {QT_TRANSLATE_NOOP("errors", "give %1 (%2)"), value, node.at("description").get<std::string>()};
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, diagonal + (a[i - 1] == b[j - 1] ? 0U : 1U)});
            diagonal = above;
        }
    }
    return row[b.size()];
}

std::string nearest_key(const std::string& key, const json& node) {
    std::string nearest;
    std::size_t best = 4;
    for (const auto& entry : node.at("properties").items()) {
        const std::size_t distance = edit_distance(key, entry.key());
        if (distance < best) {
            best = distance;
            nearest = entry.key();
        }
    }
    return nearest;
}

std::string quoted_at_end(const std::string& text) {
    const std::size_t end = text.rfind('\'');
    const std::size_t begin =
        end == std::string::npos || end == 0 ? std::string::npos : text.rfind('\'', end - 1);
    return begin == std::string::npos ? std::string() : text.substr(begin + 1, end - begin - 1);
}

std::string lower_first(std::string text) {
    if (!text.empty() && text[0] >= 'A' && text[0] <= 'Z') text[0] = static_cast<char>(text[0] - 'A' + 'a');
    while (!text.empty() && text.back() == '.') text.pop_back();
    return text;
}

/// What the checker reports, in our words; what is legal is in the hint.
Sentence violation(const std::string& description) {
    constexpr std::pair<const char*, const char*> known[] = {
        {"Value type not permitted", QT_TRANSLATE_NOOP("errors", "the value has the wrong type")},
        {"Expected number less", QT_TRANSLATE_NOOP("errors", "the number is too large")},
        {"Expected number greater", QT_TRANSLATE_NOOP("errors", "the number is too small")},
        {"Failed to match against any enum",
         QT_TRANSLATE_NOOP("errors", "the value is not one of those allowed")},
        {"Failed to match expected value", QT_TRANSLATE_NOOP("errors", "the value is not the one allowed")},
        {"Array should contain no more", QT_TRANSLATE_NOOP("errors", "the list is too long")},
        {"Array should contain no fewer", QT_TRANSLATE_NOOP("errors", "the list is too short")},
        {"String should be no more", QT_TRANSLATE_NOOP("errors", "the text is too long")},
        {"String should be no fewer", QT_TRANSLATE_NOOP("errors", "the text is too short")},
        {"Failed to match regex",
         QT_TRANSLATE_NOOP("errors", "the text has characters that are not allowed")}};
    for (const auto& [begin, words] : known)
        if (description.rfind(begin, 0) == 0) return words;
    return lower_first(description);
}

/// A built-in schema, read once: reading it takes longer than checking a file against it.
struct ReadSchema {
    explicit ReadSchema(const char* text) try : document(json::parse(text)) {
        valijson::SchemaParser parser;
        parser.populateSchema(Adapter(document), schema);
    } catch (const std::exception& error) {
        throw std::logic_error(std::string("the built-in schema is not valid: ") + error.what());
    }
    json document;
    valijson::Schema schema;
};

/// Any thread.
const ReadSchema& read_schema(const char* text) {
    static std::mutex mutex;
    static std::map<std::string, std::unique_ptr<const ReadSchema>> schemas;
    const std::lock_guard lock(mutex);
    std::unique_ptr<const ReadSchema>& schema = schemas[text];
    if (!schema) schema = std::make_unique<const ReadSchema>(text);
    return *schema;
}

}  // namespace

void JsonDocument::check_schema(const char* schema_text) const {
    const auto& [schema_json, schema] = read_schema(schema_text);
    valijson::Validator validator;
    valijson::ValidationResults results;
    if (validator.validate(schema, Adapter(root_), &results)) return;

    // A violation is reported once at its own place and again by every parent: the deepest is the one to
    // report.
    valijson::ValidationResults::Error worst;
    for (const auto& error : results) {
        if (worst.context.empty() || error.context.size() > worst.context.size()) worst = error;
    }
    std::vector<std::string> tokens;
    std::string pointer;
    for (std::size_t i = 1; i < worst.context.size(); ++i) {
        const std::string& part = worst.context[i];
        tokens.push_back(part.size() >= 2 && part.front() == '[' ? part.substr(1, part.size() - 2) : part);
        pointer += "/" + tokens.back();
    }
    const json& node = schema_at(schema_json, tokens);
    const std::string name = quoted_at_end(worst.description);
    if (worst.description.find("additionalProperties") != std::string::npos && node.contains("properties")) {
        const std::string nearest = nearest_key(name, node);
        const Sentence keys(QT_TRANSLATE_NOOP("errors", "the keys here are %1"), keys_of(node));
        fail(pointer + "/" + name, {QT_TRANSLATE_NOOP("errors", "unknown key \"%1\""), name},
             nearest.empty()
                 ? Sentence(QT_TRANSLATE_NOOP("errors", "remove it; %1"), keys)
                 : Sentence(QT_TRANSLATE_NOOP("errors", "did you mean \"%1\"? %2"), nearest, keys));
    }
    if (worst.description.find("Missing required property") != std::string::npos &&
        node.contains("properties") && node.at("properties").contains(name)) {
        fail(pointer, {QT_TRANSLATE_NOOP("errors", "the key \"%1\" is missing"), name},
             {QT_TRANSLATE_NOOP("errors", "add it: %1"),
              legal_value(resolve(schema_json, node.at("properties").at(name)))});
    }
    fail(pointer, violation(worst.description), legal_value(node));
}

}  // namespace fulcrum
