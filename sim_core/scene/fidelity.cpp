// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/fidelity.h"

#include "sim_core/numerics/input_error.h"

namespace fulcrum {

Fidelity fidelity_of(FidelityLevel level) {
    Fidelity fidelity;
    fidelity.id = row_of(fidelity_levels, level).name;
    switch (level) {
        case FidelityLevel::standard:
            break;
        case FidelityLevel::fast:
            fidelity.rod = RodLevel::linearised;
            fidelity.projection_iterations = 1;
            fidelity.membrane_iterations = 3;
            break;
        case FidelityLevel::fine:
            fidelity.rod = RodLevel::newton;
            fidelity.material = MaterialLaw::exp2;
            fidelity.collision = CollisionSearch::brute;
            fidelity.tool_contact = ToolContactLevel::query;
            fidelity.projection_iterations = 8;
            fidelity.membrane_iterations = 30;
            break;
    }
    return fidelity;
}

Fidelity named_fidelity(const std::string& name) {
    const NameRow<FidelityLevel>* row = find_row(fidelity_levels, name);
    if (row == nullptr)
        throw InputError(QT_TRANSLATE_NOOP("errors", "command line"), "--fidelity",
                         {QT_TRANSLATE_NOOP("errors", "unknown fidelity \"%1\""), name},
                         {QT_TRANSLATE_NOOP("errors", "give one of: %1"), names_of(fidelity_levels)});
    return fidelity_of(row->kind);
}

}  // namespace fulcrum
