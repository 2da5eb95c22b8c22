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
        throw InputError("command line", "--fidelity", "unknown fidelity \"" + name + "\"",
                         "give one of: " + names_of(fidelity_levels));
    return fidelity_of(row->kind);
}

}  // namespace fulcrum
