// SPDX-License-Identifier: Apache-2.0
#include "sim_core/rod/rod.h"

#include <cmath>
#include <string>

#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/state_archive.h"
#include "sim_core/rod/rod_system.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.141592653589793;

void require(bool good, const char* what) {
    if (!good) throw std::invalid_argument(what);
}

std::size_t padded(std::size_t count) {
    return (count + 7) / 4 * 4;
}

void check(const RodSpec& spec) {
    require(spec.segments >= 2 && spec.segments <= 4096, "rod: segments must be 2 to 4096");
    require(spec.length > 0 && std::isfinite(spec.length), "rod: length must be positive");
    require(spec.outer_radius > 0 && std::isfinite(spec.outer_radius), "rod: outer radius must be positive");
    require(spec.inner_radius >= 0 && spec.inner_radius < spec.outer_radius,
            "rod: inner radius must be at least 0 and below the outer");
    require(spec.young_modulus > 0 && std::isfinite(spec.young_modulus),
            "rod: Young's modulus must be positive");
    require(spec.poisson_ratio > -1 && spec.poisson_ratio <= 0.5,
            "rod: Poisson's ratio must be above -1 and at most 0.5");
    require(spec.exponent >= 0.01 && spec.exponent <= 100, "rod: the exponent of EXP2 must be 0.01 to 100");
    require(spec.linear_density > 0 && std::isfinite(spec.linear_density),
            "rod: linear density must be positive");
    require(spec.mass_damping >= 0 && spec.stiffness_damping >= 0, "rod: damping must not be negative");
    for (const double k : spec.intrinsic_curvature)
        require(std::isfinite(k), "rod: natural curvature must be finite");
    const bool shaped = !spec.rest_nodes.empty();
    require(!shaped || spec.rest_nodes.size() == static_cast<std::size_t>(spec.segments) + 1,
            "rod: rest_nodes must be segments + 1");
    for (std::size_t i = 0; i + 1 < spec.rest_nodes.size(); ++i) {
        const double edge = (spec.rest_nodes[i + 1] - spec.rest_nodes[i]).norm();
        require(std::isfinite(edge) && edge > 1e-9, "rod: rest_nodes must be finite and distinct");
    }
}

// Rest shape from uniform natural curvature: every joint turns by the same rotation.
void roll_out(const RodSpec& spec, Rod::Tables& tables) {
    const auto n = static_cast<std::size_t>(spec.segments);
    const double cell = spec.length / spec.segments;
    const double curvature = std::sqrt(spec.intrinsic_curvature[0] * spec.intrinsic_curvature[0] +
                                       spec.intrinsic_curvature[1] * spec.intrinsic_curvature[1]);
    Vector3 t(1, 0, 0), d1(0, 1, 0);
    tables.rest_nodes.assign(n + 1, Vector3::Zero());
    tables.rest_directors.assign(n, d1);
    tables.rest_ends[0].rotation = frame_of(d1, t);
    const auto turn = [&](double over) {
        // Half the twist, then the bend, then the other half, as the joint's symmetric definition has it.
        const double half = 0.5 * spec.intrinsic_curvature[2] * over;
        const auto spin = [&](double angle) {
            d1 = (d1 * math::cos(angle) + t.cross(d1) * math::sin(angle)).normalized();
        };
        spin(half);
        if (curvature > 0) {
            const Vector3 axis =
                (d1 * spec.intrinsic_curvature[0] + t.cross(d1) * spec.intrinsic_curvature[1]) / curvature;
            const double angle = curvature * over;
            const Vector3 next = (t * math::cos(angle) + axis.cross(t) * math::sin(angle)).normalized();
            d1 = d1 * math::cos(angle) + axis.cross(d1) * math::sin(angle) +
                 axis * (axis.dot(d1) * (1 - math::cos(angle)));
            t = next;
            d1 = (d1 - t * t.dot(d1)).normalized();
        }
        spin(half);
    };
    for (std::size_t j = 0; j < n; ++j) {
        turn(j == 0 ? 0.5 * cell : cell);
        tables.rest_directors[j] = d1;
        tables.rest_nodes[j + 1] = tables.rest_nodes[j] + t * cell;
    }
    turn(0.5 * cell);
    tables.rest_ends[1].rotation = frame_of(d1, t);
    tables.rest_ends[1].position = tables.rest_nodes[n];
}

void shape_rest(const RodSpec& spec, Rod::Tables& tables) {
    const auto n = static_cast<std::size_t>(spec.segments);
    tables.rest_nodes = spec.rest_nodes;
    tables.rest_directors.resize(n);
    Vector3 t = (spec.rest_nodes[1] - spec.rest_nodes[0]).normalized();
    Vector3 d1 = perpendicular(t);
    tables.rest_ends[0] = {spec.rest_nodes[0], frame_of(d1, t)};
    for (std::size_t j = 0; j < n; ++j) {
        const Vector3 next = (spec.rest_nodes[j + 1] - spec.rest_nodes[j]).normalized();
        require(t.dot(next) > -0.999, "rod: rest_nodes fold back on themselves");
        d1 = transport(d1, t, next);
        d1 = (d1 - next * next.dot(d1)).normalized();
        t = next;
        tables.rest_directors[j] = d1;
    }
    tables.rest_ends[1] = {spec.rest_nodes[n], frame_of(d1, t)};
}

}  // namespace

RodScratch::RodScratch() = default;
RodScratch::~RodScratch() = default;
RodScratch::RodScratch(RodScratch&&) noexcept = default;
RodScratch& RodScratch::operator=(RodScratch&&) noexcept = default;
RodScratch::RodScratch(const RodScratch& other)
    : data_(other.data_ ? std::make_unique<Data>(*other.data_) : nullptr) {}
RodScratch& RodScratch::operator=(const RodScratch& other) {
    if (data_ && other.data_) {
        *data_ = *other.data_;
    } else {
        data_ = other.data_ ? std::make_unique<Data>(*other.data_) : nullptr;
    }
    return *this;
}

void RodScratch::fields(StateArchive& archive) {
    archive(*data_);
}

std::size_t RodScratch::bytes() const {
    if (!data_) return 0;
    const Data& d = *data_;
    return sizeof(Data) + d.shape.bytes() + d.trial.bytes() + d.start.bytes() + d.joints.bytes() +
           d.section.bytes() + d.matrix.bytes() + d.damping.bytes() + d.factor.bytes() +
           8 * d.gradient.capacity() * sizeof(double) +
           d.contact_points.capacity() * (sizeof(RodPoint) + sizeof(Vector3) + 4 * sizeof(double));
}

// Cell, stiffness and natural angles of joint i. Stiffness of the section: N m2.
static void set_joint(const RodSpec& spec, double bending, double torsional, std::size_t i,
                      Rod::Tables& tables) {
    const auto n = static_cast<std::size_t>(spec.segments);
    const double k1 = spec.intrinsic_curvature[0], k2 = spec.intrinsic_curvature[1];
    const double curvature = std::sqrt(k1 * k1 + k2 * k2);
    // Quadrature weights over joints: the trapezoidal rule, which corresponds to a clamp over half a
    // cell, with Gregory's end correction (5/12, 13/12) at a clamp. The correction removes the leading
    // error of a bent cantilever (order h^2 q L^2 / 8 EI).
    const auto joint_cell = [&](std::size_t joint) {
        return joint == 0   ? 0.5 * tables.rest_length[0]
               : joint == n ? 0.5 * tables.rest_length[n - 1]
                            : 0.5 * (tables.rest_length[joint - 1] + tables.rest_length[joint]);
    };
    double cell = joint_cell(i);
    for (std::size_t e = 0; e < 2; ++e) {
        if (spec.ends[e] != RodEnd::clamped) continue;
        const double moved = tables.rest_length[e == 0 ? 0 : n - 1] / 12;
        if (i == (e == 0 ? 0 : n)) cell -= moved;
        if (i == (e == 0 ? 1 : n - 1)) cell += moved;
    }
    tables.cell[i] = cell;
    const bool end = i == 0 || i == n;
    const RodEnd kind = i == 0 ? spec.ends[0] : spec.ends[1];
    if (!end || kind == RodEnd::clamped) tables.bend[i] = bending / cell;
    if (!end || kind == RodEnd::clamped || kind == RodEnd::held) tables.twist[i] = torsional / cell;
    if (spec.rest_nodes.empty()) {
        cell = joint_cell(i);  // the natural angles are those of the rest shape itself
        const double angle = curvature * cell;
        require(angle < 3.0,
                "rod: natural curvature turns by more than 3 rad per segment; use more segments");
        const double size = curvature > 0 ? 2 * math::tan(0.5 * angle) / curvature : 0;
        tables.rest_1[i] = k1 * size;
        tables.rest_2[i] = k2 * size;
        tables.rest_twist[i] = spec.intrinsic_curvature[2] * cell;
    } else if (!end) {
        const Vector3 a = (spec.rest_nodes[i] - spec.rest_nodes[i - 1]).normalized();
        const Vector3 b = (spec.rest_nodes[i + 1] - spec.rest_nodes[i]).normalized();
        const Vector3 binormal = a.cross(b) * (2 / (1 + a.dot(b))), d1 = tables.rest_directors[i - 1];
        tables.rest_1[i] = binormal.dot(d1);
        tables.rest_2[i] = binormal.dot(a.cross(d1));
    }
    if (tables.bend[i] > 0 && (tables.rest_1[i] != 0 || tables.rest_2[i] != 0)) tables.curved = true;
}

// Penalties of contacts, grasps and held rotations.
static void set_penalties(const RodSpec& spec, double length, double bending, double axial,
                          Rod::Tables& tables) {
    const double shortest = length / spec.segments;
    const double scale = axial / shortest + 12 * bending / (shortest * shortest * shortest);
    tables.contact_penalty =
        30 * scale;  // a larger penalty makes the active set chatter; the multipliers close the gap
    tables.self_penalty = scale;
    // The force at a jaw hardly depends on fine segments; a larger penalty would only amplify its rounding
    // error.
    const double coarse = spec.segments > 128 ? length / 128 : shortest;
    tables.grasp_penalty = 1e4 * (axial / coarse + 12 * bending / (coarse * coarse * coarse));
    tables.turn_penalty = 1e4 * bending / coarse;
}

Rod::Rod(RodSpec spec) : spec_(std::move(spec)) {
    if (!spec_.layers.empty()) {
        spec_.inner_radius = spec_.outer_radius;
        for (const WallLayer& layer : spec_.layers) spec_.inner_radius -= layer.thickness;
        if (std::fabs(spec_.inner_radius) < 1e-12 * spec_.outer_radius) spec_.inner_radius = 0;
    }
    check(spec_);
    auto tables = std::make_shared<Tables>();
    const auto n = static_cast<std::size_t>(spec_.segments);
    tables->segments = spec_.segments;
    const bool shaped = !spec_.rest_nodes.empty();
    node_arc_lengths_.assign(n + 1, 0.0);
    for (std::size_t j = 0; j < n; ++j) {
        tables->rest_length.push_back(shaped ? (spec_.rest_nodes[j + 1] - spec_.rest_nodes[j]).norm()
                                             : spec_.length / spec_.segments);
        node_arc_lengths_[j + 1] =
            shaped ? node_arc_lengths_[j] + tables->rest_length[j]
                   : spec_.length * static_cast<double>(j + 1) / static_cast<double>(spec_.segments);
    }
    length_ = spec_.length = node_arc_lengths_[n];
    tables->node_s = node_arc_lengths_;
    if (shaped) {
        shape_rest(spec_, *tables);
    } else {
        roll_out(spec_, *tables);
    }

    const double ro = spec_.outer_radius, ri = spec_.inner_radius;
    const double area = pi * (ro * ro - ri * ri),
                 inertia = 0.25 * pi * (ro * ro * ro * ro - ri * ri * ri * ri);
    const double shear = spec_.young_modulus / (2 * (1 + spec_.poisson_ratio));
    bending_stiffness_ = spec_.young_modulus * inertia;
    torsional_stiffness_ = shear * 2 * inertia;
    axial_stiffness_ = spec_.young_modulus * area;
    if (!spec_.layers.empty()) {
        const TubeStiffness tube = tube_stiffness(spec_.layers, ro, spec_.poisson_ratio);
        axial_stiffness_ = tube.axial;
        bending_stiffness_ = tube.bending;
        torsional_stiffness_ = tube.torsional;
    }
    if (spec_.law == MaterialLaw::exp2) {
        const WallLayer plain{ro - ri, spec_.young_modulus, spec_.exponent};
        tables->section.emplace(spec_.layers.empty() ? std::vector<WallLayer>{plain} : spec_.layers, ro);
    }

    for (auto* array : {&tables->bend, &tables->twist, &tables->rest_1, &tables->rest_2, &tables->rest_twist,
                        &tables->cell}) {
        array->assign(padded(n + 1), 0.0);
    }
    node_mass_.assign(n + 1, 0.0);
    for (std::size_t j = 0; j < n; ++j) {
        const double length = tables->rest_length[j], half = 0.5 * spec_.linear_density * length;
        node_mass_[j] += half;
        node_mass_[j + 1] += half;
        tables->stretch.push_back(axial_stiffness_ / length);
        tables->spin_inertia.push_back(0.5 * spec_.linear_density * length * (ro * ro + ri * ri));
    }
    tables->mass = node_mass_;
    for (std::size_t i = 0; i <= n; ++i) {
        set_joint(spec_, bending_stiffness_, torsional_stiffness_, i, *tables);
    }
    if (tables->section) {
        tables->none.assign(padded(n + 1), 0.0);
        tables->unit = tables->none;
        for (std::size_t i = 0; i <= n; ++i) tables->unit[i] = tables->bend[i] > 0 ? 1.0 : 0.0;
    }
    set_penalties(spec_, length_, bending_stiffness_, axial_stiffness_, *tables);
    tables->outer_radius = ro;
    tables_ = tables;
}

std::size_t Rod::bytes() const {
    const auto n = static_cast<std::size_t>(spec_.segments);
    return sizeof(Rod) + sizeof(Tables) + (n + 8) * (11 * sizeof(double) + 3 * sizeof(Vector3));
}

RodState Rod::make_state() const {
    const auto n = static_cast<std::size_t>(spec_.segments);
    RodState state;
    state.nodes = tables_->rest_nodes;
    state.directors = tables_->rest_directors;
    state.joint_twist.assign(tables_->rest_twist.begin(),
                             tables_->rest_twist.begin() + static_cast<std::ptrdiff_t>(n) + 1);
    state.velocities.assign(n + 1, Vector3::Zero());
    state.spins.assign(n, 0.0);
    state.ends[0] = tables_->rest_ends[0];
    state.ends[1] = tables_->rest_ends[1];
    return state;
}

RodState Rod::make_state(const std::vector<Vector3>& nodes) const {
    const auto n = static_cast<std::size_t>(spec_.segments);
    require(nodes.size() == n + 1, "rod: a state needs segments + 1 nodes");
    RodState state = make_state();
    state.nodes = nodes;
    state.joint_twist.assign(n + 1, 0.0);
    Vector3 t = (nodes[1] - nodes[0]).normalized();
    Vector3 d1 = perpendicular(t);
    state.ends[0] = {nodes[0], frame_of(d1, t)};
    for (std::size_t j = 0; j < n; ++j) {
        const Vector3 next = (nodes[j + 1] - nodes[j]).normalized();
        require(next.allFinite() && t.dot(next) > -0.999,
                "rod: nodes of a state must be finite, distinct and not folded back");
        d1 = transport(d1, t, next);
        d1 = (d1 - next * next.dot(d1)).normalized();
        t = next;
        state.directors[j] = d1;
    }
    state.ends[1] = {nodes[n], frame_of(d1, t)};
    return state;
}

RodScratch Rod::make_scratch(int tethers, int grasps, int contacts, int self_contacts) const {
    const auto n = static_cast<std::size_t>(spec_.segments), entries = 4 * (n + 1);
    RodScratch scratch;
    scratch.data_ = std::make_unique<RodScratch::Data>();
    RodScratch::Data& d = *scratch.data_;
    for (RodShape* shape : {&d.shape, &d.trial, &d.start}) shape->resize(spec_.segments);
    d.joints.resize(spec_.segments);
    if (tables_->section) d.section.resize(spec_.segments);
    d.matrix = BlockBand(n + 1);
    d.factor = BlockBandFactor(n + 1);
    if (spec_.stiffness_damping > 0) d.damping = BlockBand(n + 1);
    for (auto* array : {&d.gradient, &d.step, &d.inertia, &d.predicted, &d.dead, &d.shift_weight, &d.column,
                        &d.damping_force}) {
        array->assign(entries, 0.0);
    }
    const auto size = [](int count) { return static_cast<std::size_t>(count > 0 ? count : 0); };
    d.tether_points.resize(size(tethers));
    d.tether_start.resize(size(tethers), Vector3::Zero());
    d.grasp_points.resize(size(grasps));
    for (auto* array : {&d.grasp_lambda, &d.grasp_force, &d.grasp_target, &d.turn_lambda, &d.turn_force})
        array->resize(size(grasps), Vector3::Zero());
    d.turn_target.resize(size(grasps), Matrix3::Identity());
    d.saved_grasps.reserve(size(grasps));
    d.contact_points.resize(size(contacts));
    d.contact_start.resize(size(contacts), Vector3::Zero());
    for (auto* array : {&d.contact_lambda, &d.contact_force, &d.contact_start_lambda})
        array->resize(size(contacts), 0.0);
    d.contact_active.resize(size(contacts), 0);
    d.self_points.resize(2 * size(self_contacts));
    for (auto* array : {&d.self_lambda, &d.self_force}) array->resize(size(self_contacts), 0.0);
    d.saved = make_state();
    return scratch;
}

void Rod::stop(RodState& state) {
    for (Vector3& v : state.velocities) v.setZero();
    for (double& spin : state.spins) spin = 0;
}

bool Rod::finite(const RodState& state) {
    double sum = 0;
    for (const Vector3& v : state.nodes) sum += 0 * (v.x() + v.y() + v.z());
    for (const Vector3& v : state.directors) sum += 0 * (v.x() + v.y() + v.z());
    for (const Vector3& v : state.velocities) sum += 0 * (v.x() + v.y() + v.z());
    for (const double v : state.joint_twist) sum += 0 * v;
    for (const double v : state.spins) sum += 0 * v;
    return sum == 0;
}

}  // namespace fulcrum
