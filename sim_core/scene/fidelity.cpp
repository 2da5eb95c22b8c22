// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/fidelity.h"

#include "sim_core/numerics/input_error.h"

namespace fulcrum {

std::vector<std::string> fidelity_names() {
    return {"fast", "standard", "fine"};
}

Fidelity named_fidelity(const std::string& id) {
    Fidelity fidelity;  // standard
    if (id == "standard") return fidelity;
    fidelity.id = id;
    if (id == "fast") {
        fidelity.rod = "linearised";
        fidelity.projection_iterations = 1;
        fidelity.membrane_iterations = 3;
        return fidelity;
    }
    if (id == "fine") {
        fidelity.rod = "newton";
        fidelity.material = "EXP2";
        fidelity.collision = "brute";
        fidelity.tool_contact = "query";
        fidelity.projection_iterations = 8;
        fidelity.membrane_iterations = 30;
        return fidelity;
    }
    throw InputError("command line", "--fidelity", "unknown fidelity '" + id + "'",
                     "use fast, standard or fine");
}

}  // namespace fulcrum
