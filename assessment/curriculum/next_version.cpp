// SPDX-License-Identifier: Apache-2.0
#include "assessment/curriculum/next_version.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "sim_core/numerics/input_error.h"

namespace fulcrum {

std::string next_version_text(const Curriculum& from, const std::map<std::string, PassRule>& rules) {
    if (from.text.empty())
        throw InputError({QT_TRANSLATE_NOOP("errors", "curriculum %1"), from.name()}, "",
                         QT_TRANSLATE_NOOP("errors", "was not read from a file"),
                         QT_TRANSLATE_NOOP("errors", "choose an installed curriculum"));
    // Ordered, so that a person finds everything where it was.
    auto document = nlohmann::ordered_json::parse(from.text);
    document["version"] = from.version + 1;
    for (const auto& [task, rule] : rules) {
        auto& nodes = document["tasks"];
        const auto found = std::find_if(
            nodes.begin(), nodes.end(),
            [&, &id = task](const nlohmann::ordered_json& node) { return node.at("task") == id; });
        if (found == nodes.end())
            throw InputError({QT_TRANSLATE_NOOP("errors", "curriculum %1"), from.name()}, "/tasks",
                             {QT_TRANSLATE_NOOP("errors", "has no task %1"), task},
                             QT_TRANSLATE_NOOP("errors", "name one of its tasks"));
        (*found)["rule"] = pass_rule_text(rule);
    }
    return document.dump(2) + "\n";
}

}  // namespace fulcrum
