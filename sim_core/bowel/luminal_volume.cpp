// SPDX-License-Identifier: Apache-2.0
#include "sim_core/bowel/luminal_volume.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double least_scale = 0.2, most_scale = 3.0;  // outside this range the wall model is not valid

}  // namespace

LuminalVolume::LuminalVolume(const Cage& cage, const LuminalSpec& spec) : spec_(spec) {
    const auto rings = static_cast<std::size_t>(cage.rings());
    for (std::size_t r = 0; r < rings; ++r) {
        double area = 0, radius = 0;
        for (std::size_t k = 0; k < ring_size; ++k) {
            const Vector3& here = cage.templates[r][k];
            const Vector3& next = cage.templates[r][(k + 1) % ring_size];
            area += 0.5 * (here.x() * next.y() - here.y() * next.x());
            radius += here.norm() / ring_size;
        }
        const double before = r > 0 ? cage.arc_lengths[r] - cage.arc_lengths[r - 1] : 0.0;
        const double after = r + 1 < rings ? cage.arc_lengths[r + 1] - cage.arc_lengths[r] : 0.0;
        volume_.push_back(std::abs(area) * 0.5 * (before + after));
        compliance_.push_back(radius / (spec.young_modulus * spec.wall_thickness));
        total_ += volume_.back();
    }
}

double LuminalVolume::scale_at(std::size_t ring, double pressure) const {
    return std::clamp(1.0 + compliance_[ring] * pressure, least_scale, most_scale);
}

double LuminalVolume::ratio_at(const double* stretch, double pressure) const {
    double sum = 0;
    for (std::size_t r = 0; r < volume_.size(); ++r) {
        const double scale = scale_at(r, pressure);
        sum += volume_[r] * stretch[r] * scale * scale;
    }
    return sum / total_;
}

double LuminalVolume::solve(const double* stretch) {
    if (!(spec_.bulk_modulus > 0)) return 0.0;
    // p = -bulk (V / V0 - 1): the left side increases with p, the right side decreases, so the solution is
    // unique; bisection keeps Newton's steps in the bracket.
    double low = -spec_.bulk_modulus, high = spec_.bulk_modulus;
    const double hoop =
        spec_.young_modulus * spec_.wall_thickness / 0.002;  // Pa: above the pressure of any scale in range
    low = std::max(low, -hoop);
    high = std::min(high, hoop);
    double p = std::clamp(pressure_, low, high);
    for (int round = 0; round < 60; ++round) {
        const double residual = p + spec_.bulk_modulus * (ratio_at(stretch, p) - 1.0);
        (residual > 0 ? high : low) = p;
        double slope = 0;
        for (std::size_t r = 0; r < volume_.size(); ++r)
            slope += 2 * volume_[r] * stretch[r] * scale_at(r, p) * compliance_[r];
        double next = p - residual / (1.0 + spec_.bulk_modulus * slope / total_);
        if (!(next > low && next < high)) next = 0.5 * (low + high);
        if (std::abs(next - p) < 1e-9 * hoop) {
            p = next;
            break;
        }
        p = next;
    }
    pressure_ = std::isfinite(p) ? p : 0.0;
    return pressure_;
}

double LuminalVolume::scale(int ring) const {
    return scale_at(static_cast<std::size_t>(ring), pressure_);
}

double LuminalVolume::volume_ratio(const double* stretch) const {
    return ratio_at(stretch, pressure_);
}

}  // namespace fulcrum
