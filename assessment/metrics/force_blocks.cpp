// SPDX-License-Identifier: Apache-2.0
// The forces of a hand at 1 kHz, filtered, without spikes.
#include <algorithm>

#include "assessment/metrics/analysis.h"
#include "assessment/metrics/signal.h"

namespace fulcrum {

namespace {

constexpr double force_cutoff = 50.0;  // Hz
// A spike of one sample can be distinguished from a short force only where samples are dense.
constexpr double despike_rate = 500.0;  // Hz
constexpr double force_step = 1e-3;     // N, the record's resolution
constexpr double area_step = 1e-9;      // m2

/// A column with its spikes replaced; adds how many to `replaced`.
std::vector<double> despiked(const Trace& trace, std::vector<double> samples, double resolution,
                             std::size_t& replaced) {
    if (!samples.empty() && trace.mean_rate() >= despike_rate * 0.999)
        for (const TraceBlock& block : trace.blocks)
            replaced += despike(samples, block.first, block.last, resolution);
    return samples;
}

std::vector<double> filtered_force(const std::vector<double>& column) {
    return low_pass(column, force_cutoff, force_rate);
}

}  // namespace

HandTrace despiked_forces(const Trace& trace, std::size_t h, std::size_t& replaced) {
    const HandTrace& hand = trace.hand[h];
    HandTrace out;
    out.fx = despiked(trace, hand.fx, force_step, replaced);
    out.fy = despiked(trace, hand.fy, force_step, replaced);
    out.fz = despiked(trace, hand.fz, force_step, replaced);
    out.jaw_force = despiked(trace, hand.jaw_force, force_step, replaced);
    out.jaw_area = despiked(trace, hand.jaw_area, area_step, replaced);
    return out;
}

void Analysis::build_force(std::size_t h) {
    const HandTrace& hand = trace_.hand[h];
    HandAnalysis& out = hands_[h];
    if (!hand.has(Channel::force) && !hand.has(Channel::jaw_force)) return;
    out.force.resize(grids_.size());
    for (std::size_t g = 0; g < grids_.size(); ++g) {
        out.force[g].begin = grids_[g].begin();
        if (hand.has(Channel::tissue)) out.force[g].tissue = grids_[g].hold(hand.tissue);
        if (hand.has(Channel::patch)) out.force[g].patch = grids_[g].hold(hand.patch);
    }
    if (hand.has(Channel::force)) add_forces(h);
    if (hand.has(Channel::jaw_force)) add_jaw(h);
}

// A column at a time, so that copies of all of them are never in memory together.
void Analysis::add_forces(std::size_t h) {
    const HandTrace& hand = trace_.hand[h];
    std::size_t replaced = 0;
    Eigen::Index row = 0;
    for (const auto* column : {&hand.fx, &hand.fy, &hand.fz}) {
        const std::vector<double> samples = despiked(trace_, *column, force_step, replaced);
        for (std::size_t g = 0; g < grids_.size(); ++g) {
            ForceBlock& block = hands_[h].force[g];
            if (row == 0) block.force.resize(3, static_cast<Eigen::Index>(grids_[g].size()));
            const std::vector<double> smooth = filtered_force(grids_[g].interpolate(samples));
            block.force.row(row) =
                Eigen::Map<const Eigen::RowVectorXd>(smooth.data(), static_cast<Eigen::Index>(smooth.size()));
        }
        ++row;
    }
    for (ForceBlock& block : hands_[h].force) {
        const Eigen::RowVectorXd norm = block.force.colwise().norm();
        block.norm.assign(norm.data(), norm.data() + norm.size());
    }
}

void Analysis::add_jaw(std::size_t h) {
    const HandTrace& hand = trace_.hand[h];
    std::size_t replaced = 0;
    const std::vector<double> forces = despiked(trace_, hand.jaw_force, force_step, replaced),
                              areas = despiked(trace_, hand.jaw_area, area_step, replaced);
    for (std::size_t g = 0; g < grids_.size(); ++g) {
        ForceBlock& block = hands_[h].force[g];
        std::vector<double> jaw = grids_[g].interpolate_within(forces, hand.tissue);
        block.grasp.resize(jaw.size());
        for (std::size_t i = 0; i < jaw.size(); ++i)
            block.grasp[i] = jaw[i] > contact_force && (block.tissue.empty() || block.tissue[i] >= 0) ? 1 : 0;
        block.jaw = filtered_force(jaw);
        if (!hand.has(Channel::jaw_area)) continue;
        const std::vector<double> area = grids_[g].interpolate_within(areas, hand.tissue);
        for (std::size_t i = 0; i < jaw.size(); ++i)
            jaw[i] = block.grasp[i] != 0 && area[i] > 0 ? jaw[i] / area[i] : 0.0;
        block.pressure = filtered_force(jaw);
    }
}

}  // namespace fulcrum
