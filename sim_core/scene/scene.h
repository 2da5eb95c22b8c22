// SPDX-License-Identifier: Apache-2.0
// Content and level of detail of a scene. A scene is read from JSON (assets/scenes, schema
// assets/schemas/scene.schema.json); the world is built only from its parts (scene_parts.inc): an absent part
// is not built, not stepped and costs nothing. Frames: patient frame (origin at the middle of the pelvic
// inlet, +x patient's left, +y cranial, +z anterior). SI units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim_core/numerics/types.h"
#include "sim_core/scene/all_specs.h"  // made by the build: every *_spec.h of this folder
#include "sim_core/scene/fidelity_levels.h"
#include "sim_core/scene/instrument_type.h"

namespace fulcrum {

/// Conditions under which a blade enters a tissue and advances in it (Eqs. 6 and 7, docs/THEORY.md, section
/// 5). Set by the surgeon.
struct CuttingSpec {
    double penetrate = 0.3;        ///< N, force across the tissue above which a blade breaks through
    double static_friction = 0.1;  ///< N, force along the tissue above which it breaks through
    double dynamic_friction =
        0.06;  ///< N, force along the tissue above which it advances; at most static_friction
    double energy_factor = 0.4;  ///< fraction of these forces needed with energy on; provisional
};

/// A tissue that instruments can touch. A limit <= 0 means no limit.
struct TissueSpec {
    std::string label;                ///< as in traces: "bowel", "wall", "target"
    double force_limit = 0;           ///< N, contact or traction force above it is over-force
    double perforation_force = 0;     ///< N, median of the published distribution
    double perforation_spread = 0;    ///< N, its standard deviation; the attempt's seed draws one value
    double jaw_pressure_limit = 0;    ///< Pa
    double jaw_force_time_limit = 0;  ///< N s of one grasp
    double friction = 0.5;            ///< jaw friction coefficient
    double stiffness = 400;           ///< N/m, wall stiffness of a tip contact of the instrument's own area
    double damping = 0.4;             ///< N s/m
    std::optional<CuttingSpec> cutting;  ///< absent: the tissue cannot be cut
};

/// A trocar: the pivot of an instrument or of the scope.
struct TrocarSpec {
    Vector3 position = Vector3::Zero();     ///< m
    Vector3 direction = Vector3(0, 0, -1);  ///< nominal shaft direction into the body, unit
    Vector3 up = Vector3(0, 0, 1);          ///< +y of the trocar frame after orthogonalisation
    double shaft_length = 0.34;             ///< m, handle to tip
};

struct InstrumentSpec {
    Hand hand = Hand::left;
    InstrumentKind kind = InstrumentKind::grasper;
    bool cuts() const { return type_of(kind).blade != InstrumentBlade::none; }
    /// With bands or structures: kinds that this hand changes between, by a button of its device; the first
    /// is held at the start. Empty: `kind` alone.
    std::vector<InstrumentKind> exchange;
    TrocarSpec trocar;
    double start_insertion = 0.12;                   ///< m, insertion the device is aligned to at the start
    double shaft_radius = 0.0025;                    ///< m
    double tip_radius = 0.0025;                      ///< m, of the proxy
    Vector3 tip_box = Vector3(0.020, 0.005, 0.005);  ///< m, edges a (along the shaft), b, c of Eq. 4's cuboid
    double jaw_length = 0.020;                       ///< m
    double jaw_opening = 1.0;                        ///< rad, widest
    double grip_force = 8.0;  ///< N, jaw force at full squeeze of a device without grip sensing
};

struct CameraSpec {
    TrocarSpec trocar;
    double start_insertion = 0.06;              ///< m
    double angle = 0.5235987755982988;          ///< rad between shaft and view direction (30 deg scope)
    double field_of_view = 1.2217304763960306;  ///< rad, full angle of the round image
};

/// One choice for every row of the speed-accuracy table (docs/THEORY.md, section 8).
struct Fidelity {
    std::string id = "standard";  ///< as records name it: a level of fidelity.h or the scene's own choice
    RodLevel rod = RodLevel::newton_k;
    int rod_iterations = 8;
    MaterialLaw material = MaterialLaw::linear;
    SkinScope skinning = SkinScope::local;
    CollisionSearch collision = CollisionSearch::coherent;
    int projection_iterations = 3;
    ToolContactLevel tool_contact = ToolContactLevel::dynamic_point;
    MembraneIntegrator membrane = MembraneIntegrator::global_local;
    int membrane_iterations = 6;  ///< of global_local, a step
    FilterLevel filter = FilterLevel::adaptive;
};

struct Scene {
    std::string id;
    int version = 1;
    std::string variant = "standard";
    Vector3 gravity = Vector3(0, 0, -9.81);  ///< m/s2
    int tick_rate = 1000;                    ///< Hz
    int ticks_per_step = 5;
    double force_limit = 10.0;  ///< N, largest force sent to a hand
    bool passivity_control =
        false;                  ///< the device never returns more energy to the hand than the hand put in
    double slew_limit = 300.0;  ///< N/s, on changes of the model, on loss and on resume
    std::vector<TissueSpec> tissues;
    std::vector<InstrumentSpec> instruments;  ///< at most one per hand; none with camera_targets only
    std::optional<CameraSpec> camera;
    Fidelity fidelity;

    double tick_period() const { return 1.0 / tick_rate; }
    double step_period() const { return static_cast<double>(ticks_per_step) / tick_rate; }
    int tissue_index(const std::string& label) const;  ///< -1 if unknown
    const InstrumentSpec* instrument(Hand hand) const;
    const FieldSpec* field() const;  ///< of bands or structures; null without
    /// Index of the tissue of the wall that instruments feel; -1 without a wall.
    int wall_tissue() const;

    // The parts: a member for each line of the list.
#define SCENE_PART(type, name) type name;
#include "sim_core/scene/scene_parts.inc"
};

/// Reads and checks a scene file. Throws InputError with file, place (line or JSON pointer) and hint.
Scene load_scene(const std::string& path);
/// As load_scene, from text; `file` names the source in errors.
Scene parse_scene(const std::string& text, const std::string& file);

}  // namespace fulcrum
