// SPDX-License-Identifier: Apache-2.0
#include "sim_core/rod/rod_section.h"

#include <cmath>

namespace fulcrum {
namespace {

// Strain at a joint, from the edges on either side; end frames do not count as edges.
struct JointStrain {
    double strain, by_length;  // mean strain; its derivative by either edge's length, 1/m
    bool has_a, has_b;
};

JointStrain joint_strain(const Rod::Tables& tables, const RodShape& shape, std::size_t i) {
    const auto n = static_cast<std::size_t>(tables.segments);
    JointStrain s{0, 0, i > 0, i < n};
    double rest = 0, now = 0;
    if (s.has_a) rest += tables.rest_length[i - 1], now += shape.length[i] - tables.rest_length[i - 1];
    if (s.has_b) rest += tables.rest_length[i], now += shape.length[i + 1] - tables.rest_length[i];
    s.by_length = 1.0 / rest;
    s.strain = now * s.by_length;
    return s;
}

// block += ss u v^T + se (u f^T + e v^T) + ee e f^T for the four-vectors u, e of the rows, v, f of the
// columns.
void add_outer(Block4& block, const Lanes& u, const Lanes& e, const Lanes& v, const Lanes& f, double ss,
               double se, double ee) {
    const Lanes by_v = ss * u + se * e, by_f = se * u + ee * e;
    for (int c = 0; c < 4; ++c) block.column[c] += by_v * v[c] + by_f * f[c];
}

// block += factor (I - t t^T) on the vector part.
void add_across(Block4& block, const Lanes& t, double factor) {
    for (int c = 0; c < 3; ++c) {
        block.column[c] -= t * (factor * t[c]);
        block.column[c][c] += factor;
    }
}

}  // namespace

void RodSectionTerms::resize(int segments) {
    unit.resize(segments);
    bend.assign(unit.energy.size(), 0.0);
    response.assign(unit.energy.size(), BendingResponse{});
    force.assign(static_cast<std::size_t>(segments), 0.0);
    tangent.assign(static_cast<std::size_t>(segments), 0.0);
}

std::size_t RodSectionTerms::bytes() const {
    return unit.bytes() + sizeof(BendingResponse) * response.capacity() +
           sizeof(double) * (bend.capacity() + force.capacity() + tangent.capacity());
}

bool section_terms(const Rod::Tables& tables, const RodShape& shape, bool hessian, RodSectionTerms& work,
                   RodJointTerms& out) {
    const auto n = static_cast<std::size_t>(tables.segments);
    const TubeSection& section = *tables.section;
    if (!unit_joint_terms(tables, shape, work.unit)) return false;
    double bent = 0;
    work.stretch = 0;
    for (std::size_t j = 0; j < n; ++j) {
        const double rest = tables.rest_length[j];
        const AxialResponse axial = section.axial((shape.length[j + 1] - rest) / rest);
        work.stretch += rest * axial.energy;
        work.force[j] = axial.force;
        work.tangent[j] = axial.tangent / rest;
    }
    // The stiffness of each joint at this shape goes through the linear kernel; the terms from the section's
    // own derivatives are added afterwards.
    for (std::size_t i = 0; i <= n; ++i) {
        if (tables.unit[i] == 0) continue;
        const double cell = tables.cell[i];
        const JointStrain s = joint_strain(tables, shape, i);
        BendingResponse& b = work.response[i];
        b = section.bending(s.strain, 2.0 * work.unit.energy[i] / (cell * cell));
        work.bend[i] = 2.0 * b.by_square / cell;
        bent += cell * b.energy;
    }
    if (!joint_terms(tables, shape, work.bend, hessian, out)) return false;
    out.bend = bent;
    for (std::size_t i = 0; i <= n; ++i) {
        if (tables.unit[i] == 0) continue;
        const double cell = tables.cell[i];
        const JointStrain s = joint_strain(tables, shape, i);
        const BendingResponse& b = work.response[i];
        const double pull = cell * b.by_strain * s.by_length;
        const Lanes ta{shape.tx[i], shape.ty[i], shape.tz[i], 0},
            tb{shape.tx[i + 1], shape.ty[i + 1], shape.tz[i + 1], 0};
        double *ga = &out.gradient_a[4 * i], *gb = &out.gradient_b[4 * i];
        if (s.has_a) store_lanes(ga, load_lanes(ga) + ta * pull);
        if (s.has_b) store_lanes(gb, load_lanes(gb) + tb * pull);
        if (!hessian) continue;
        const double ss = 4.0 * b.by_square_square / (cell * cell * cell),
                     se = 2.0 * b.by_strain_square / cell * s.by_length,
                     ee = cell * b.by_strain_strain * s.by_length * s.by_length;
        const Lanes ua = load_lanes(&work.unit.gradient_a[4 * i]),
                    ub = load_lanes(&work.unit.gradient_b[4 * i]);
        if (s.has_a) {
            add_outer(out.aa[i], ua, ta, ua, ta, ss, se, ee);
            add_across(out.aa[i], ta, pull * shape.inverse[i]);
        }
        if (s.has_b) {
            add_outer(out.bb[i], ub, tb, ub, tb, ss, se, ee);
            add_across(out.bb[i], tb, pull * shape.inverse[i + 1]);
        }
        if (s.has_a && s.has_b) add_outer(out.ab[i], ua, ta, ub, tb, ss, se, ee);
    }
    return std::isfinite(bent + work.stretch);
}

}  // namespace fulcrum
