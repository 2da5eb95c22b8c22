// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/structures/structures_part.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "sim_core/anatomy/scene_anatomy.h"
#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

using namespace field_rules;

constexpr double outlet_size = 0.003;  // m, edge of the tissue around an opening
constexpr double turn = 6.283185307179586;

constexpr double press_reach = 0.03;  // m from the wall beyond which no tip presses it, on either side
constexpr double snap = 0.005;        // m to the wall as it is felt, which lies a little deeper

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

StructuresLayout lay_on(StructuresLayout layout, const CavityModel& felt) {
    for (VeinPlace& vein : layout.veins) {
        for (Vector3& point : vein.line) {
            const CavityPoint nearest = felt.closest(point, snap);
            if (nearest.triangle >= 0) point = nearest.position;
        }
    }
    return layout;
}

double sheet_thickness(const Scene& scene) {
    return scene.septa ? scene.septa->thickness : scene.sheet ? scene.sheet->thickness : 0.001;
}

}  // namespace

FieldModel StructuresPart::make_field(const StructuresSpec& spec, const StructuresLayout& layout,
                                      const CavityModel& felt, const HeatedSheet* sheet, double thickness,
                                      Patches& patches) {
    FieldModel model;
    model.bed = layout.bed;
    model.wall = &felt;
    for (const VeinPlace& vein : layout.veins) {
        VesselModel vessel;
        vessel.radius = vein.radius;
        vessel.pressure = spec.vessel_pressure;
        vessel.feeding_length = spec.feeding_length;
        vessel.clotting_time = spec.clotting_time;
        model.vessels.push_back(vessel);
    }
    FieldHeat heat(spec, model.heat);
    // Where openings will be is not known yet: their tissue passes its heat on to the body.
    patches.outlets = 0;
    for (std::size_t i = 0; i < field_outlet_capacity; ++i) {
        heat.patch(outlet_size * outlet_size * outlet_size, outlet_size * outlet_size);
        model.heat.patches.back().perfusion += spec.conductivity * outlet_size;
    }
    model.first_bed = heat.bed(layout.bed);
    for (const std::vector<Vector3>& nerve : layout.nerves)
        model.nerves.push_back({nerve, heat.nerve(nerve, layout.bed, model.first_bed,
                                                  [&](const Vector3&) { return spec.nerve_height; })});

    patches.roots = model.heat.patches.size();
    if (sheet == nullptr) return model;
    const TriangleMesh& mesh = sheet->mesh();
    patches.root_count = static_cast<std::int32_t>(mesh.triangles.size());
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> edges;
    const auto centre = [&](std::int32_t root) {
        const Triangle& t = mesh.triangles[at(root)];
        return Vector3((mesh.vertices[at(t[0])] + mesh.vertices[at(t[1])] + mesh.vertices[at(t[2])]) / 3);
    };
    for (std::int32_t root = 0; root < patches.root_count; ++root) {
        const Triangle& t = mesh.triangles[at(root)];
        const double area =
            triangle_area(mesh.vertices[at(t[0])], mesh.vertices[at(t[1])], mesh.vertices[at(t[2])]);
        const std::int32_t here = heat.patch(area * thickness, 2 * area);
        for (std::size_t c = 0; c < 3; ++c) {
            const std::int32_t a = t[c], b = t[(c + 1) % 3];
            const auto [found, fresh] = edges.insert({{std::min(a, b), std::max(a, b)}, root});
            if (fresh) continue;
            const double length = (mesh.vertices[at(a)] - mesh.vertices[at(b)]).norm();
            heat.link(here - root + found->second, here, length * thickness,
                      (centre(found->second) - centre(root)).norm());
        }
    }
    return model;
}

StructuresPart::StructuresPart(const Scene& scene, const FieldWall& wall, const CavityModel& felt,
                               const HeatedSheet* sheet, std::uint64_t seed)
    : spec_(*scene.structures),
      layout_(lay_on(place_structures(spec_, wall, seed), felt)),
      sheet_(sheet),
      field_(scene, spec_, make_field(spec_, layout_, felt, sheet, sheet_thickness(scene), patches_),
             field_outlet_capacity),
      outlet_vein_(field_outlet_capacity, -1) {
    for (std::size_t i = 0; i < field_outlet_capacity; ++i) field_.outlets()[i].patch = patches_.outlets + i;
    if (sheet_ != nullptr) {
        const TriangleMesh& mesh = sheet_->mesh();
        for (std::int32_t root = 0; root < patches_.root_count; ++root) {
            const Triangle& t = mesh.triangles[at(root)];
            root_area_.push_back(
                triangle_area(mesh.vertices[at(t[0])], mesh.vertices[at(t[1])], mesh.vertices[at(t[2])]));
        }
        // Energy is for the areolar tissue; the mesorectum beyond it is to stay whole.
        for (std::int32_t root = 0; root < patches_.root_count; ++root) {
            root_is_target_.push_back(sheet_->root_in_fat(root) ? 0 : 1);
        }
    }
    const TissueSpec& fascia = scene.tissues[at(scene.tissue_index(spec_.bed_tissue))];
    wall_stiffness_ = fascia.stiffness;
    if (fascia.cutting) energy_factor_ = fascia.cutting->energy_factor;
}

HeldTool StructuresPart::held(int number, const ToolKinematics& tool) const noexcept {
    const FieldHand& hand = field_.hand(number);
    HeldTool held;
    held.tool = tool;
    if (hand.instrument == nullptr) return held;
    held.instrument = &field_.instrument(number);
    held.energised = hand.usable() && gives_energy(hand.kind()) && (tool.buttons & button_energy) != 0;
    held.tool.inside = tool.inside && hand.usable();
    if (held.energised) {
        held.tool.buttons = static_cast<std::uint16_t>(tool.buttons | button_primary);
    } else if (type_of(hand.kind()).blade == InstrumentBlade::energy) {
        held.tool.buttons = static_cast<std::uint16_t>(tool.buttons & ~button_primary);
    }
    return held;
}

void StructuresPart::step(const TickOutput* outputs, std::size_t count, double dt) noexcept {
    field_.begin_step();
    for (int number = 0; number < hand_count; ++number) {
        if (field_.hand(number).instrument != nullptr) step_tool(number, outputs, count, dt);
    }
    const HeatReport heat = field_.step_heat(dt);
    field_.seal_outlets(dt);
    field_.bleed(dt);
    field_.end_step(heat.steam, dt);
}

void StructuresPart::step_tool(int number, const TickOutput* outputs, std::size_t count, double dt) noexcept {
    FieldHand& hand = field_.hand(number);
    const ToolKinematics& tool = outputs[count - 1].contact[number].tool;
    // What jaws hold is let go of first.
    const bool holds = type_of(hand.kind()).grasps && Jaws::may_hold(tool, hand.instrument->jaw_opening);
    field_.exchange(number, outputs, count, holds, dt);
    field_.clear(hand);
    if (!tool.tip.allFinite()) {
        hand.cutting = false;
        return;
    }
    if (!tool.present) return;  // it stays where it was, and a blade's path continues from there
    double least = 0;
    if (OperativeField::step_jaws(hand, tool) == JawAction::close && type_of(hand.kind()).clips &&
        field_.clips_left())
        field_.fire_clip(hand, tool, least);
    const double pedal = OperativeField::pedal(number, outputs, count);
    const bool energised = pedal > 0 && gives_energy(hand.kind());
    field_.divide_nerves(number, tool, energised);
    if (!tool.inside || !hand.usable()) return;
    press(hand, tool, energised);
    if (gives_energy(hand.kind())) {
        field_.measure_nerves(hand, tool);
        const std::int32_t root = sheet_ != nullptr ? sheet_->under(number).root : -1;
        if (root >= 0) field_.touch(hand, root_patch(root));
        field_.touch_nerves_and_bed(hand, tool);
        if (pedal > 0) apply_energy(number, tool, pedal);
    } else if (type_of(hand.kind()).suction && pedal > 0) {
        hand.active = true;
        field_.suck(tool, dt);
    }
}

void StructuresPart::press(const FieldHand& hand, const ToolKinematics& tool, bool energised) noexcept {
    const double radius = hand.instrument->tip_radius;
    const CavityPoint wall = field_.model().wall->closest(tool.tip, press_reach);
    const double depth = radius - wall.distance;
    if (wall.triangle < 0 || !(depth > 0)) return;
    const bool blade = field_.is_blade(hand, tool, energised);
    const double force = wall_stiffness_ * depth,
                 cover = (energised ? energy_factor_ : 1.0) * spec_.vein_depth;
    if (blade ? depth <= cover : force <= spec_.vein_tear_force) return;
    const Vector3& foot = wall.position;
    for (std::size_t v = 0; v < layout_.veins.size(); ++v) {
        const VeinPlace& vein = layout_.veins[v];
        double apart = 1;
        Vector3 place = foot;
        for (std::size_t i = 0; i + 1 < vein.line.size(); ++i) {
            const SegmentPair pair = closest_points_of_segments(foot, foot, vein.line[i], vein.line[i + 1]);
            const double distance = (pair.on_second - foot).norm();
            if (!(distance < apart)) continue;
            apart = distance;
            place = pair.on_second;
        }
        if (!(apart < vein.radius + blade_half)) continue;
        const double share = blade ? (depth - cover) / (2 * vein.radius) : force / spec_.vein_tear_force - 1;
        open_vein(static_cast<std::int32_t>(v), place, std::clamp(share, least_opening, 1.0));
    }
}

void StructuresPart::open_vein(std::int32_t vein, const Vector3& place, double share) noexcept {
    // The same opening, else a place that is free, else the nearest of this vein, else the nearest of all.
    std::size_t chosen = 0;
    double least = 1e9;
    for (std::size_t i = 0; i < outlet_vein_.size(); ++i) {
        const double distance = (field_.outlets()[i].position - place).norm();
        const double rank = outlet_vein_[i] == vein ? (distance < same_opening ? distance : 20 + distance)
                            : outlet_vein_[i] < 0   ? 10
                                                    : 40 + distance;
        if (!(rank < least)) continue;
        least = rank;
        chosen = i;
    }
    FieldOutlet& outlet = field_.outlets()[chosen];
    if (!outlet.opened) {
        outlet_vein_[chosen] = vein;
        outlet.vessel = vein;
        outlet.position = place;
        outlet.opened = outlet.injured = outlet.exposed = true;
    }
    open_vessel(share, outlet.bleed);
}

// A hook's current finds its way through water: tissue that has dried takes no more power.
double StructuresPart::conducting_share(const FieldHand& hand, const EnergyReach& reach) const noexcept {
    const double whole = field_.model().heat.patches[reach.patch].water;
    return type_of(hand.kind()).energy == InstrumentEnergy::monopolar && whole > 0
               ? field_.heat().water[reach.patch] / whole
               : 1.0;
}

void StructuresPart::apply_energy(int number, const ToolKinematics& tool, double duty) noexcept {
    FieldHand& hand = field_.hand(number);
    hand.active = true;
    EnergyReach reach = field_.reach_outlets(hand, tool);
    const SheetUnder under = sheet_ != nullptr ? sheet_->under(number) : SheetUnder();
    if (under.root >= 0)
        reach.take(0, root_patch(under.root), under.fat ? EnergyTarget::fat : EnergyTarget::sheet);
    field_.reach_nerves_and_bed(hand, tool, reach);
    field_.give(hand, reach, field_.tool_model(hand).tissue_power * duty * conducting_share(hand, reach));
    field_.spread(hand, tool, duty);
    // The same steam on a sheet, by its area: over a plane it adds up to the power at the blade.
    const double density = spread_power * duty / (turn * spread_length * spread_length);
    if (sheet_ == nullptr) return;
    const std::vector<Triangle>& triangles = sheet_->mesh().triangles;
    const std::vector<Vector3>& x = sheet_->vertices_now();
    for (std::int32_t r = 0; r < patches_.root_count; ++r) {
        const Triangle& corner = triangles[at(r)];
        const Vector3 centre((x[at(corner[0])] + x[at(corner[1])] + x[at(corner[2])]) / 3);
        const double away = (centre - tool.tip).norm();
        if (away < spread_reach)
            field_.heat_patch(root_patch(r),
                              density * root_area_[at(r)] * math::exp(-std::max(0.0, away) / spread_length));
    }
}

void StructuresPart::publish_model(int number, const TickOutput& /*last*/, LocalModel& model) noexcept {
    const FieldHand& hand = field_.hand(number);
    model.energises = hand.usable() && gives_energy(hand.kind());
}

void StructuresPart::size_snapshot(WorldSnapshot& snapshot) const {
    snapshot.field.resize(1);
    field_.size_view(snapshot.field[0]);
    StructuresView& view = snapshot.structures;
    for (const VeinPlace& vein : layout_.veins)
        view.veins.push_back({vein.line, vein.radius, spec_.vein_depth});
    view.sheet_char.assign(root_area_.size(), 0.0F);
    view.sheet_dose.assign(root_area_.size(), 0.0F);
}

void StructuresPart::fill_snapshot(WorldSnapshot& snapshot) const noexcept {
    FieldView& view = snapshot.field[0];
    StructuresView& structures = snapshot.structures;
    field_.fill_view(view);
    for (std::size_t i = 0; i < outlet_vein_.size(); ++i) view.outlets[i].vein = outlet_vein_[i];
    const HeatState& heat = field_.heat();
    for (std::size_t r = 0; r < root_area_.size(); ++r) {
        const std::size_t patch = patches_.roots + r;
        const double water = field_.model().heat.patches[patch].water;
        structures.sheet_char[r] = water > 0 ? static_cast<float>(1 - heat.water[patch] / water) : 0.0F;
        structures.sheet_dose[r] = static_cast<float>(heat.dose[patch]);
        if (root_is_target_[r] != 0) continue;
        view.lateral_dose = std::max(view.lateral_dose, heat.dose[patch]);
        if (heat.dose[patch] >= lethal_dose) view.lateral_area += root_area_[r];
    }
}

void StructuresPart::list_state(StateList& list) {
    field_.list_state(list, [](StateHash&, std::size_t) {});
    list.hashed(outlet_vein_);
    list.also_hashed([this](StateHash& hash) {
        for (std::size_t n = 0; n < layout_.nerves.size(); ++n)
            hash.add(static_cast<std::int64_t>(field_.divided(n) ? 1 : 0));
    });
}

void StructuresPart::add_costs(double us, std::vector<PartCost>& costs) const {
    std::size_t lines = 0;
    for (const VeinPlace& vein : layout_.veins) lines += vein.line.size();
    for (const std::vector<Vector3>& nerve : layout_.nerves) lines += 2 * nerve.size();
    costs.push_back({"structures", us,
                     sizeof(*this) + field_.model_bytes() + lines * sizeof(Vector3) + root_area_.size() * 9 +
                         state_bytes()});
}

std::unique_ptr<Part> build_structures_part(const Scene& scene, std::uint64_t seed, const PartList& parts) {
    if (!scene.structures) return nullptr;
    const RectumParameters rectum = rectum_parameters(scene);
    return std::make_unique<StructuresPart>(scene, presacral_wall(rectum.curve, rectum.promontory),
                                            *wall_of(parts), heated_sheet_of(parts), seed);
}

}  // namespace fulcrum
