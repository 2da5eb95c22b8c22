// SPDX-License-Identifier: Apache-2.0
#include "sim_core/scene/scene.h"

namespace fulcrum {

int Scene::tissue_index(const std::string& label) const {
    for (std::size_t i = 0; i < tissues.size(); ++i) {
        if (tissues[i].label == label) return static_cast<int>(i);
    }
    return -1;
}

const InstrumentSpec* Scene::instrument(Hand hand) const {
    for (const InstrumentSpec& spec : instruments) {
        if (spec.hand == hand) return &spec;
    }
    return nullptr;
}

const FieldSpec* Scene::field() const {
    if (bands) return &*bands;
    return structures ? &*structures : nullptr;
}

int Scene::wall_tissue() const {
    if (cavity) return tissue_index(cavity->tissue);
    if (presacral) return tissue_index(presacral->tissue);
    if (bands) return tissue_index(bands->bed_tissue);
    return objects ? tissue_index(objects->tray_tissue) : -1;
}

}  // namespace fulcrum
