// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/hand_lever.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim_core/collision/cavity.h"
#include "sim_core/lab/contact_run.h"
#include "sim_core/lab/reference_tube.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum::lab {
namespace {

constexpr double shaft_length = 0.45;  // m: 5 to 95 % of it are within the kinematics' range
constexpr double tube_length = 0.24, tube_radius = 0.016;
constexpr double widest_gap = 0.0001;  // m of the tip or of the hand, before the tissue is touched
constexpr double travel = 0.003;       // m of the hand that it is meant to press by
constexpr double tip_travel = 0.002;   // m of the tip, at most
constexpr double most_push = 0.6;      // N, less than any device holds for long
constexpr double widest = 0.02;        // m

TriangleMesh make_plate(const Vector3& centre, const Vector3& normal, const Vector3& along) {
    const Vector3 x = along - along.dot(normal) * normal;
    const Vector3 u = 0.15 * x.normalized(), v = normal.cross(u);
    constexpr int cells = 10;
    TriangleMesh mesh;
    for (int j = 0; j <= cells; ++j) {
        for (int i = 0; i <= cells; ++i)
            mesh.vertices.emplace_back(centre + (2.0 * i / cells - 1) * u + (2.0 * j / cells - 1) * v);
    }
    for (int j = 0; j < cells; ++j) {
        for (int i = 0; i < cells; ++i) {
            const int a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
            mesh.triangles.push_back({a, b, d});
            mesh.triangles.push_back({a, d, c});
        }
    }
    return mesh;
}

/// Stiffness of the tissue along its surface over that against it.
double across_share(LeverTissue tissue) {
    switch (tissue) {
        case LeverTissue::sheet:
            return 0.25;
        case LeverTissue::band:
            return 0.1;
        case LeverTissue::wall:
        case LeverTissue::bowel:
            break;
    }
    return 0;
}

/// The place of the case in space: trocar at the origin, shaft along -z.
struct Place {
    Vector3 tip, normal, surface;  // m; unit, out of the tissue; m, what the tip will touch
    Vector3 handle, gradient;  // m from the trocar; motion of the tip along the normal per motion of the hand
    double gap = 0;            // m, of the tip, before the tissue is touched
};

Place place_of(const LeverCase& at, double tip_radius) {
    Place place;
    place.tip = Vector3(0, 0, -at.insertion * shaft_length);
    place.normal = Vector3(math::cos(at.tilt), 0, math::sin(at.tilt));
    place.handle = Vector3(0, 0, (1 - at.insertion) * shaft_length);
    ToolLoad unit;
    unit.add(place.tip, place.normal);
    place.gradient = load_at_hand(place.handle, unit).force;
    place.gap = widest_gap * std::min(1.0, place.gradient.norm());
    place.surface = place.tip - (tip_radius + place.gap) * place.normal;
    return place;
}

}  // namespace

const char* name_of(LeverTissue tissue) {
    switch (tissue) {
        case LeverTissue::wall:
            return "wall";
        case LeverTissue::bowel:
            return "bowel";
        case LeverTissue::sheet:
            return "sheet";
        case LeverTissue::band:
            return "band";
    }
    return "";
}

double time_to_settle(const LeverHand& hand) {
    constexpr double left_by_eq8 = 0.2, least = 3, margin = 1.25;
    const double damping = left_by_eq8 * hand.damping + (hand.arm ? hand.arm_damping : 0);
    // Two thirds of the run reduce the swing to its share.
    const double decay = 2 * hand.mass / damping;
    return std::max(least, margin * 1.5 * decay * math::log(1 / settled_share));
}

struct HandAtLever::Parts : ToolOnSkin {
    std::unique_ptr<CavityModel> plate;

    void make_tissue(const LeverCase& at, const Place& place, double period);
    void make_bowel(const LeverCase& at, const Place& place);
    void make_sheet(const LeverCase& at, const Place& place);
    void make_band(const LeverCase& at, const Place& place);
    HandTick touch(const Vector3& handle, std::uint32_t tick);
};

HandAtLever::HandAtLever() : parts_(std::make_unique<Parts>()) {
    Parts& parts = *parts_;
    TriangleMesh mesh = make_tube(tube_length, 102, 45, plain_radius(tube_radius));
    Cage cage =
        build_cage(mesh, tube_length, sample_spheres(tube_length, 0.016, [](double) { return tube_radius; }));
    parts.skin = std::make_unique<BowelSkin>(std::move(mesh), std::move(cage));
    parts.builder = std::make_unique<PatchBuilder>(*parts.skin, PatchOptions{});
    parts.scratch = parts.builder->make_scratch();
    parts.rings.resize(static_cast<std::size_t>(parts.skin->rings()));
    InstrumentSpec spec;
    spec.trocar.direction = Vector3(0, 0, -1);
    spec.trocar.up = Vector3(0, 1, 0);
    spec.trocar.shaft_length = shaft_length;
    parts.model.instrument = make_instrument(spec, 1e-3);
}

HandAtLever::~HandAtLever() = default;

void HandAtLever::Parts::make_tissue(const LeverCase& at, const Place& place, double period) {
    model.instrument.tick_period = period;
    model.cavity = nullptr;
    plate.reset();
    state = ToolContactState{};
    instrument = InstrumentState{};
    const std::uint32_t step = local.step;
    local = LocalModel{};
    local.step = step + 1;
    switch (at.tissue) {
        case LeverTissue::wall:
            plate = std::make_unique<CavityModel>(
                make_plate(place.surface, place.normal, Vector3(0, 0.9, 0.4)), FreeSide::front);
            model.cavity = plate.get();
            model.wall.tissue = 0;
            model.wall.most_stiffness = at.stiffness;
            model.wall.damping = at.damping;
            local.cavity_seed = plate->closest(place.tip, 0.05).triangle;
            break;
        case LeverTissue::bowel:
            make_bowel(at, place);
            break;
        case LeverTissue::sheet:
            make_sheet(at, place);
            break;
        case LeverTissue::band:
            make_band(at, place);
            break;
    }
}

/// The tube lies across the shaft with its crest under the tip.
void HandAtLever::Parts::make_bowel(const LeverCase& at, const Place& place) {
    Matrix3 turn;  // of the tube along +x with its crest at +z
    turn.col(0) = Vector3::UnitY();
    turn.col(2) = place.normal;
    turn.col(1) = turn.col(2).cross(turn.col(0));
    const Vector3 middle = place.surface - tube_radius * place.normal;
    for (std::size_t r = 0; r < rings.size(); ++r) {
        const RingFrame rest = rest_frame(skin->cage().arc_lengths[r]);
        rings[r].frame.position = middle + turn * (rest.position - Vector3(0.5 * tube_length, 0, 0));
        rings[r].frame.rotation = turn * rest.rotation;
    }
    PatchRequest request;
    DeviceReading reading;
    reading.handle = handle_for_tip(model.instrument.trocar, place.tip);
    request.tool = tool_pose(model.instrument, quantise(reading, DeviceSample{}));
    builder->build(rings.data(), request, scratch, local);
    TissueContact& contact = local.patch.contact;
    contact.tissue = 0;
    contact.least_stiffness = contact.most_stiffness = at.stiffness;
    contact.damping = at.damping;
}

void HandAtLever::Parts::make_sheet(const LeverCase& at, const Place& place) {
    SheetContactModel& sheet = local.sheet;
    sheet.tissue = 0;
    sheet.place = place.tip;
    sheet.normal = place.normal;
    sheet.pushes = true;
    sheet.push = -at.stiffness * place.gap;
    sheet.stiffness = at.stiffness;
    sheet.damping = at.damping;
    sheet.drag_stiffness = across_share(at.tissue) * at.stiffness;
    sheet.friction = 0.2;
}

/// A band in the jaws that leads away along the normal: stiff along itself, soft across.
void HandAtLever::Parts::make_band(const LeverCase& at, const Place& place) {
    local.mode = LocalMode::grasp;
    GraspModel& grasp = local.grasp;
    grasp.point = place.tip;
    grasp.hold_offset = Vector3::Zero();
    const Matrix3 along = place.normal * place.normal.transpose();
    grasp.stiffness = at.stiffness * (along + across_share(at.tissue) * (Matrix3::Identity() - along));
    grasp.damping = at.damping;
    grasp.friction = 10;
    grasp.tissue = 0;
}

HandTick HandAtLever::Parts::touch(const Vector3& handle, std::uint32_t tick) {
    local.tick = tick;
    DeviceReading reading;
    reading.handle = model.instrument.trocar.rotation.transpose() * handle;
    reading.grip = 16;
    const ToolKinematics tool =
        step_instrument(model.instrument, quantise(reading, instrument.last), instrument);
    step_tool_contact(model, local, tool, tick, state, tick_scratch, result);
    HandTick now;
    now.handle = handle_of(model.instrument, tool);
    now.device = handle;
    now.load = result.tissue_load;
    return now;
}

LeverRun HandAtLever::run(const LeverCase& at, const LeverHand& hand) {
    Parts& parts = *parts_;
    const Place place = place_of(at, parts.model.instrument.tip_radius);
    parts.make_tissue(at, place, hand.period);
    SafetyLimits limits;
    limits.tick_period = hand.period;
    limits.ramp_ticks = 0;
    HandOutput output(limits);
    output.set_device(hand.device);

    MovingHand moving;
    moving.hand = hand;
    moving.place = place.handle;
    const double slope = place.gradient.norm();
    const Vector3 into = -place.gradient / slope;
    const double lever = at.insertion / (1 - at.insertion);
    const double stiffest = at.stiffness * std::max(slope * slope, across_share(at.tissue) * lever * lever);
    const double share = std::min(1.0, 1.6 * hand.damping / hand.period / stiffest);
    const double felt = share * at.stiffness * slope * slope;
    const double press = std::min(travel, tip_travel / slope);
    const double push = std::min(most_push, felt * press);
    if (hand.arm) {
        const double free = at.tissue == LeverTissue::band ? 0.0 : place.gap / slope;
        moving.wanted = place.handle + (free + press + push / hand.arm_stiffness) * into;
    } else {
        moving.rail = into;
        moving.push = 0.5 * push * into;  // the first swing goes twice as far
    }
    LeverRun run;
    run.seconds = time_to_settle(hand);
    const auto ticks = static_cast<std::uint32_t>(run.seconds / hand.period);
    std::vector<double> path;
    path.reserve(ticks);
    for (std::uint32_t tick = 1; tick <= ticks; ++tick) {
        const HandTick now = parts.touch(moving.place, tick);
        const HandForce sent = output.step(now);
        const Vector3 force =
            hand.tip_force ? clamp_force(-parts.result.force, hand.device.peak) : sent.force;
        run.limited = run.limited || sent.limited;
        run.force = std::max(run.force, force.norm());
        moving.step(force, hand.period);
        if (!moving.place.allFinite()) {
            run.finite = run.bounded = false;
            return run;
        }
        run.returned = std::max(run.returned, moving.given - moving.lost);
        run.put_in = std::max(run.put_in, -moving.given);
        path.push_back(into.dot(moving.place - place.handle));
        if ((moving.place - place.handle).norm() > widest) {
            run.bounded = false;
            return run;
        }
    }
    const std::size_t third = path.size() / 3;
    const auto span = [&](std::size_t from, std::size_t to) {
        const auto ends = std::minmax_element(path.begin() + static_cast<std::ptrdiff_t>(from),
                                              path.begin() + static_cast<std::ptrdiff_t>(to));
        return *ends.second - *ends.first;
    };
    run.early = span(0, third);
    run.late = span(2 * third, path.size());
    run.settles = run.late < settled_share * run.early;
    run.depth = slope * path.back() - (at.tissue == LeverTissue::band ? 0.0 : place.gap);
    return run;
}

}  // namespace fulcrum::lab
