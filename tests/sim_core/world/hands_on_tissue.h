// SPDX-License-Identifier: Apache-2.0
// Scenes with a grasper in each hand, and a place on each kind of tissue that both can take.
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "sim_core/world/parts/bowel/bowel_part.h"
#include "tests/sim_core/world/parts/sheet/sheet_rig.h"

namespace fulcrum::test {

/// A place on tissue: m; unit, along the tissue; unit, towards the hands.
struct TissuePlace {
    Vector3 point = Vector3::Zero(), along = Vector3::UnitX(), out = Vector3::UnitZ();
};

struct HeldScene {
    Scene scene;
    /// The place that is so far (m) along the tissue from its middle.
    std::function<TissuePlace(const World&, double)> place;
};

/// Both hands with the left hand's grasper.
inline Scene two_graspers(const std::string& file) {
    Scene scene = load_scene(source_path("assets/scenes/" + file + ".json"));
    InstrumentSpec& right = scene.instruments[1];
    const InstrumentSpec& left = scene.instruments[0];
    right.kind = InstrumentKind::grasper;
    right.exchange.clear();
    right.jaw_length = left.jaw_length;
    right.jaw_opening = left.jaw_opening;
    right.tip_box = left.tip_box;
    right.tip_radius = left.tip_radius;
    right.grip_force = left.grip_force;
    return scene;
}

/// On the bowel's wall where it faces `up`, in the middle between the hands.
inline TissuePlace on_wall(const World& world, double from_middle, const Vector3& up) {
    const BowelPart& bowel = *world.find<BowelPart>();
    double s = 0, nearest = std::numeric_limits<double>::infinity();
    for (int k = 10; k <= 90; ++k) {
        const double along = 0.01 * k * bowel.rod().length();
        const double aside =
            (bowel.rod().frame_at(bowel.state(), along).frame.position - Vector3(0, 0.05, 0)).norm();
        if (aside >= nearest) continue;
        nearest = aside;
        s = along;
    }
    s += from_middle;
    const Vector3 centre = bowel.rod().frame_at(bowel.state(), s).frame.position;
    TissuePlace place;
    place.along = (bowel.rod().frame_at(bowel.state(), s + 0.005).frame.position -
                   bowel.rod().frame_at(bowel.state(), s - 0.005).frame.position)
                      .normalized();
    place.out = (up - up.dot(place.along) * place.along).normalized();
    double wall = 0;  // m, how far out the skin reaches here
    for (const SkinRow& row : bowel.skin().rows()) {
        const Vector3 off = skin_vertex(row, bowel.ring_frames()) - centre;
        if (std::abs(off.dot(place.along)) < 0.004 &&
            (off - off.dot(place.out) * place.out - off.dot(place.along) * place.along).norm() < 0.004)
            wall = std::max(wall, off.dot(place.out));
    }
    place.point = centre + wall * place.out;
    return place;
}

inline TissuePlace on_bowel(const World& world, double from_middle) {
    return on_wall(world, from_middle, Vector3::UnitZ());
}

/// The middle of the membrane's triangle that is 25 mm from the bowel's wall, about the middle of its length.
inline TissuePlace on_membrane(const World& world, double from_middle) {
    const MembraneView& view = world.snapshot().membranes[0];
    const std::vector<Vector3>& nodes = world.snapshot().bowel.nodes;
    TissuePlace place;
    double best = std::numeric_limits<double>::infinity();
    for (const Triangle& triangle : view.triangles) {
        const auto at = [&](std::size_t c) { return view.positions[static_cast<std::size_t>(triangle[c])]; };
        const Vector3 middle = (at(0) + at(1) + at(2)) / 3;
        double from_bowel = std::numeric_limits<double>::infinity();
        for (const Vector3& node : nodes) from_bowel = std::min(from_bowel, (node - middle).norm());
        const double off = std::abs(from_bowel - 0.040) + 0.2 * (middle - nodes[nodes.size() / 2]).norm();
        if (off >= best) continue;
        best = off;
        place.point = middle;
        place.along = (at(1) - at(0)).normalized();
        place.out = (at(1) - at(0)).cross(at(2) - at(0)).normalized();
    }
    if (place.out.z() < 0) place.out = -place.out;
    place.point += from_middle * place.along;
    return place;
}

inline TissuePlace on_sheet(const World& world, double from_middle) {
    const SheetSpec& sheet = *world.scene().sheet;
    TissuePlace place;
    place.along = sheet.along;
    // The middle of the free edge, where it is now.
    const std::vector<Vector3>& flap = world.snapshot().sheet.flap;
    place.point = flap[flap.size() / 2] - 0.004 * sheet.across + from_middle * place.along;
    return place;
}

inline TissuePlace on_band(const World& world, double from_middle) {
    const BandView& band = world.snapshot().bands.bands[0];
    TissuePlace place;
    const std::size_t middle = strand_nodes / 2;
    place.point = band.position[middle];
    place.along = (band.position[middle + 1] - band.position[middle - 1]).normalized();
    place.out = (Vector3::UnitZ() - place.along.z() * place.along).normalized();
    place.point += from_middle * place.along;
    return place;
}

inline TissuePlace on_rectum(const World& world, double from_middle) {
    return on_wall(world, from_middle, Vector3(0, 0.5, 1));
}

inline HeldScene held_scene(const std::string& tissue) {
    if (tissue == "bowel") return {two_graspers("b1_bowel"), on_bowel};
    if (tissue == "bowel_with_membrane") return {two_graspers("b1_mesentery"), on_bowel};
    if (tissue == "membrane") return {two_graspers("b1_mesentery"), on_membrane};
    if (tissue == "sheet") return {two_graspers("b2_areolar"), on_sheet};
    if (tissue == "band") return {two_graspers("b3_bands"), on_band};
    return {two_graspers("c4_posterior"), on_rectum};
}

/// Position of a tip for which the middle of its jaws is at the given point.
inline Vector3 tip_for_jaws(const SheetRig& rig, int hand, const Vector3& jaws) {
    const double half = 0.5 * rig.scene.instruments[static_cast<std::size_t>(hand)].jaw_length;
    return jaws + half * (jaws - rig.trocar[hand].position).normalized();
}

/// N, as recorded in the last tick.
inline double recorded_force(const SheetRig& rig, int hand) {
    const HandSample& sample = rig.outputs.back().sample.hand[hand];
    return sample_force_unit * Vector3(sample.force[0], sample.force[1], sample.force[2]).norm();
}

}  // namespace fulcrum::test
