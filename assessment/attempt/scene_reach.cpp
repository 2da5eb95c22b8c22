// SPDX-License-Identifier: Apache-2.0
#include "assessment/attempt/scene_reach.h"

#include <vector>

#include "sim_core/instrument/mouse_mapping.h"

namespace fulcrum {
namespace {

constexpr double shortest_outside = 0.02;  // m of the shaft that stays outside of the trocar

std::vector<Vector3> places_of(const WorldSnapshot& seen, Hand hand) {
    std::vector<Vector3> places;
    for (const TargetSphere& target : seen.targets)
        if (target.hand == hand) places.push_back(target.centre);
    if (!places.empty()) return places;
    const auto add = [&](const std::vector<Vector3>& more) {
        places.insert(places.end(), more.begin(), more.end());
    };
    add(seen.bowel.nodes);
    add(seen.sheet.line);
    add(seen.sheet.flap);
    for (const BandView& band : seen.bands.bands)
        places.insert(places.end(), band.position.begin(), band.position.end());
    for (const VeinView& vein : seen.structures.veins) add(vein.line);
    for (const ObjectView& object : seen.objects.objects) places.push_back(object.position);
    for (const PegView& peg : seen.objects.pegs) {
        places.push_back(peg.foot);
        places.push_back(peg.top);
    }
    return places;
}

}  // namespace

SceneReach scene_reach(const Scene& scene, const WorldSnapshot& at_start) {
    SceneReach reach;
    for (int h = 0; h < hand_count; ++h) {
        const Hand hand = static_cast<Hand>(h);
        const InstrumentSpec* const spec = scene.instrument(hand);
        if (spec == nullptr) continue;
        const Trocar trocar = make_trocar(spec->trocar);
        const Vector3 start = start_reading(trocar.shaft_length, spec->start_insertion, 0).handle;
        std::optional<WorkspaceBox>& box = reach[static_cast<std::size_t>(h)];
        for (const Vector3& place : places_of(at_start, hand)) {
            const double insertion = (place - trocar.position).norm();
            if (!place.allFinite() || insertion > trocar.shaft_length - shortest_outside) continue;
            const Vector3 way = handle_for_tip(trocar, place) - start;
            if (!box) box = WorkspaceBox();
            box->add({-way.x(), way.y(), -way.z()});
        }
    }
    return reach;
}

}  // namespace fulcrum
