// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/cutting_values.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/scene_schema.h"

namespace fulcrum {

namespace {

using nlohmann::json;

std::string in_words(double value) {
    std::ostringstream words;
    words << value;
    return words.str();
}

const CuttingKey* find_key(const std::string& key) {
    for (const CuttingKey& known : cutting_keys) {
        if (key == known.key) return &known;
    }
    return nullptr;
}

void check(const std::string& file, const std::string& tissue, const std::string& key, double value) {
    const std::string place = "/tissues/" + tissue + "/cutting/" + key;
    if (find_key(key) == nullptr) {
        std::string known;
        for (const CuttingKey& one : cutting_keys)
            known += (known.empty() ? "" : ", ") + std::string(one.key);
        throw InputError(file, place, QT_TRANSLATE_NOOP("errors", "this is not a cutting value"),
                         {QT_TRANSLATE_NOOP("errors", "use one of %1"), known});
    }
    const CuttingRange range = cutting_range(key);
    const bool low = range.above ? !(value > range.minimum) : !(value >= range.minimum);
    if (!std::isfinite(value) || low || value > range.maximum)
        throw InputError(file, place, {QT_TRANSLATE_NOOP("errors", "%1 is out of range"), in_words(value)},
                         range.above
                             ? Sentence(QT_TRANSLATE_NOOP("errors", "give a number above %1, at most %2"),
                                        in_words(range.minimum), in_words(range.maximum))
                             : Sentence(QT_TRANSLATE_NOOP("errors", "give a number from %1 to %2"),
                                        in_words(range.minimum), in_words(range.maximum)));
}

/// The node of a tissue with cutting values. Throws InputError listing those there are.
json& cutting_of(json& scene, const std::string& file, const std::string& label) {
    std::string known;
    for (json& tissue : scene.at("tissues")) {
        if (!tissue.contains("cutting")) continue;
        if (tissue.at("label") == label) return tissue.at("cutting");
        known += (known.empty() ? "" : ", ") + tissue.at("label").get<std::string>();
    }
    throw InputError(file, "/tissues/" + label,
                     QT_TRANSLATE_NOOP("errors", "the scene has no tissue of this name with cutting values"),
                     known.empty()
                         ? Sentence(QT_TRANSLATE_NOOP("errors", "choose a task in which tissue is cut"))
                         : Sentence(QT_TRANSLATE_NOOP("errors", "use one of %1"), known));
}

}  // namespace

CuttingValues cutting_values(const Scene& scene) {
    CuttingValues values;
    for (const TissueSpec& tissue : scene.tissues) {
        if (!tissue.cutting) continue;
        for (const CuttingKey& key : cutting_keys)
            values[tissue.label][key.key] = (*tissue.cutting).*key.value;
    }
    return values;
}

CuttingRange cutting_range(const std::string& key) {
    static const json schema = json::parse(scene_schema());
    const json& limits =
        schema.at("definitions").at("tissue").at("properties").at("cutting").at("properties").at(key);
    CuttingRange range;
    range.above = limits.contains("exclusiveMinimum");
    range.minimum = limits.at(range.above ? "exclusiveMinimum" : "minimum").get<double>();
    range.maximum = limits.at("maximum").get<double>();
    range.words = (range.above ? "above " : "at least ") + in_words(range.minimum) + ", at most " +
                  in_words(range.maximum);
    return range;
}

std::string with_cutting_values(const std::string& scene_text, const std::string& file,
                                const CuttingValues& values) {
    if (values.empty()) return scene_text;
    parse_scene(scene_text, file);  // reports errors in the file itself with their own line
    json scene = json::parse(scene_text);
    for (const auto& [tissue, given] : values) {
        json& cutting = cutting_of(scene, file, tissue);
        for (const auto& [key, value] : given) {
            check(file, tissue, key, value);
            cutting[key] = value;
        }
    }
    const std::string text = scene.dump(2) + "\n";
    parse_scene(text, file);  // reports inconsistent values
    return text;
}

std::string cutting_difference(const CuttingValues& here, const CuttingValues& there) {
    for (const auto& [tissue, values] : here) {
        const auto other = there.find(tissue);
        if (other == there.end()) return tissue + ": cutting values in the first scene only";
        for (const auto& [key, value] : values) {
            const auto found = other->second.find(key);
            if (found == other->second.end() || found->second != value)
                return tissue + ": " + key + " " + in_words(value) + ", there " +
                       (found == other->second.end() ? "none" : in_words(found->second));
        }
    }
    for (const auto& [tissue, values] : there) {
        if (here.find(tissue) == here.end()) return tissue + ": cutting values in the second scene only";
    }
    return {};
}

}  // namespace fulcrum
