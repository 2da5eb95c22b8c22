// SPDX-License-Identifier: Apache-2.0
// Content and level of detail of a scene. A scene is read from JSON (assets/scenes, schema
// assets/schemas/scene.schema.json); the world is built only from this list: an absent part is not built, not
// stepped and costs nothing. Frames: patient frame (origin at the middle of the pelvic inlet, +x patient's
// left, +y cranial, +z anterior). SI units.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim_core/material/layered_wall.h"
#include "sim_core/numerics/types.h"
#include "sim_core/scene/bands_spec.h"
#include "sim_core/scene/camera_targets_spec.h"
#include "sim_core/scene/fidelity_levels.h"
#include "sim_core/scene/instrument_type.h"
#include "sim_core/scene/objects_spec.h"
#include "sim_core/scene/septa_spec.h"
#include "sim_core/scene/structures_spec.h"

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

/// Rigid spheres to touch (A2). Positions are drawn from the attempt's seed inside the box, `per_hand` for
/// each hand, at varied depth.
struct TargetFieldSpec {
    int per_hand = 10;
    double radius = 0.006;                            ///< m
    Vector3 centre = Vector3::Zero();                 ///< m
    Vector3 half_extent = Vector3(0.05, 0.04, 0.03);  ///< m
    double minimum_distance = 0.02;                   ///< m between centres, for all hands together
    std::string tissue = "target";
    double stiffness = 600;  ///< N/m
    double damping = 0.5;    ///< N s/m
};

struct CavitySpec {
    double pelvis_width = 0.125;  ///< m, transverse diameter of the inlet
    double pelvis_depth = 0.115;  ///< m, inlet to floor
    std::uint64_t seed = 1;
    std::string tissue = "wall";
};

/// A stiff lump under the mucosa, for the contact with a layered wall.
struct NoduleSpec {
    double at = 0.5;   ///< fraction of the bowel's length
    double angle = 0;  ///< rad around the bowel, from d1 towards d2
    WallNodule shape;
};

/// Where a bowel lies.
enum class BowelLayout : std::uint8_t {
    colon,   ///< the rectosigmoid in a cavity
    rectum,  ///< along the sacral hollow; needs presacral
};

struct BowelSpec {
    double length = 0.9;            ///< m
    double outer_radius = 0.016;    ///< m, mean
    double wall_thickness = 0.003;  ///< m
    double young_modulus = 32.3e3;  ///< Pa
    double poisson_ratio = 0.35;
    std::vector<WallLayer> layers;     ///< of the wall, lumen first; then wall_thickness is their sum and
                                       ///< young_modulus the mean of the tube
    std::optional<NoduleSpec> nodule;  ///< with layers only
    double luminal_bulk_modulus = 0;   ///< Pa, of contents that fill the lumen and cannot leave; 0: none
    double linear_density = 0.25;      ///< kg/m
    double damping = 6.0;              ///< 1/s, mass-proportional
    int segments = 64;
    double sphere_spacing = 0.016;  ///< m
    int surface_vertices = 20000;   ///< requested, the generator rounds
    std::uint64_t seed = 1;
    std::string tissue = "bowel";
    double floor_friction = 0.3;
    BowelLayout layout = BowelLayout::colon;
    double weight = 1;            ///< fraction of its weight not carried by the tissue beneath
    double blade_width = 0.0006;  ///< m, of the band that a blade removes; its surface can be cut if its
                                  ///< tissue has `cutting`
};

/// The mesentery of B1: tension-only springs from the rod to a line on the wall, through the rod's attachment
/// interface.
struct TetherSpec {
    int count = 24;
    double first = 0.10, last = 0.90;  ///< fractions of the bowel's length that carry it
    double stiffness = 15;             ///< N/m each
    double damping = 0.2;              ///< N s/m each
    double slack = 1.15;               ///< rest length over the distance at rest
};

/// A membrane of masses and springs from the bowel's wall to the wall of the cavity: the mesentery, as an
/// alternative to tethers.
struct MembraneSpec {
    std::string kind = "mesentery";    ///< "mesentery", the only one
    double first = 0.10, last = 0.90;  ///< fractions of the bowel's length that carry it
    double structural_stiffness = 12;  ///< N/m each spring, as shear and bend
    double shear_stiffness = 6;
    double bend_stiffness = 0.6;
    double surface_density = 1.0;     ///< kg/m2
    double pre_strain = 0;            ///< -0.5 .. 1; below 0: slack
    double stiffness_damping = 5e-5;  ///< s
    double mass_damping = 4;          ///< 1/s
    double weight = 0;                ///< fraction of its weight not carried by the wall beneath
};

/// A rectangle of layered tissue between a fixed edge and a flap, to be held under traction and divided along
/// a marked line (B2).
struct SheetSpec {
    std::string kind = "areolar";  ///< "areolar", the only one
    std::string tissue = "areolar";
    Vector3 centre = Vector3::Zero();    ///< m
    Vector3 along = Vector3(0, 1, 0);    ///< unit, of the marked line
    Vector3 across = Vector3(1, 0, 0);   ///< unit, from the fixed edge to the flap, at right angles to it
    double length = 0.12, width = 0.05;  ///< m, along and across
    double spacing = 0.004;              ///< m between vertices
    double thickness = 0.0015;           ///< m
    double line_length = 0.10;           ///< m, in the middle of the length
    double line_at = 0.5;                ///< fraction of the width from the fixed edge
    double flap_stiffness = 300;         ///< N/m, of the support of the whole flap edge
    double structural_stiffness = 20;    ///< N/m each spring, as shear and bend
    double shear_stiffness = 8;
    double bend_stiffness = 1;
    double surface_density = 0.8;  ///< kg/m2
    double pre_strain = 0.06;
    double stiffness_damping = 3e-5;  ///< s
    double mass_damping = 12;         ///< 1/s
    double weight = 0.3;              ///< fraction of its weight not carried by the tissue beneath
    double blade_width = 0.0006;      ///< m, of the band that a blade removes
    std::optional<FibreSpec> fibres;  ///< absent: only a blade divides the tissue
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
    std::optional<TargetFieldSpec> targets;
    std::optional<CavitySpec> cavity;
    std::optional<BowelSpec> bowel;
    std::optional<TetherSpec> tethers;
    std::vector<MembraneSpec> membranes;
    std::optional<SheetSpec> sheet;
    std::optional<PresacralSpec> presacral;
    std::optional<SeptaSpec> septa;
    std::optional<BandsSpec> bands;
    std::optional<StructuresSpec> structures;
    std::optional<ObjectsSpec> objects;
    std::optional<CameraTargetsSpec> camera_targets;
    Fidelity fidelity;

    double tick_period() const { return 1.0 / tick_rate; }
    double step_period() const { return static_cast<double>(ticks_per_step) / tick_rate; }
    int tissue_index(const std::string& label) const;  ///< -1 if unknown
    const InstrumentSpec* instrument(Hand hand) const;
    const FieldSpec* field() const;  ///< of bands or structures; null without
    /// Index of the tissue of the wall that instruments feel; -1 without a wall.
    int wall_tissue() const;
};

/// Reads and checks a scene file. Throws InputError with file, place (line or JSON pointer) and hint.
Scene load_scene(const std::string& path);
/// As load_scene, from text; `file` names the source in errors.
Scene parse_scene(const std::string& text, const std::string& file);

}  // namespace fulcrum
