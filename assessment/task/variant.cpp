// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/variant.h"

#include <algorithm>

#include "assessment/task/task.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

const TaskVariant* find(const TaskDefinition& task, const std::string& id) {
    const auto found = std::find_if(task.variants.begin(), task.variants.end(),
                                    [&](const TaskVariant& one) { return one.id == id; });
    return found == task.variants.end() ? nullptr : &*found;
}

}  // namespace

const TaskVariant& require_variant(const TaskDefinition& task, const std::string& id) {
    const TaskVariant* variant = find(task, id.empty() ? std::string(standard_variant) : id);
    if (variant != nullptr) return *variant;
    std::string known;
    for (const TaskVariant& one : task.variants) known += (known.empty() ? "" : ", ") + one.id;
    throw InputError({QT_TRANSLATE_NOOP("errors", "task %1"), task.id}, "/variants",
                     {QT_TRANSLATE_NOOP("errors", "has no variant \"%1\""), id},
                     {QT_TRANSLATE_NOOP("errors", "choose one of these: %1"), known});
}

std::string variant_family(const TaskDefinition& task, const std::string& id) {
    const TaskVariant* variant = find(task, id);
    return variant == nullptr ? id : variant->family;
}

std::string next_variant(const TaskDefinition& task, const std::map<std::string, int>& attempts) {
    const auto practised = [&](const TaskVariant& variant) {
        const auto found = attempts.find(variant.id);
        return found == attempts.end() ? 0 : found->second;
    };
    const auto least = std::min_element(
        task.variants.begin(), task.variants.end(),
        [&](const TaskVariant& a, const TaskVariant& b) { return practised(a) < practised(b); });
    return least == task.variants.end() ? standard_variant : least->id;
}

}  // namespace fulcrum
