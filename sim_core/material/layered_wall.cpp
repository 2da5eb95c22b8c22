// SPDX-License-Identifier: Apache-2.0
#include "sim_core/material/layered_wall.h"

#include <cmath>
#include <stdexcept>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.141592653589793;
constexpr double most_pressure =
    4e6;  // Pa, end of the table: far above the strength of any wall (0.3 to 0.6 MPa)

void require(bool good, const char* what) {
    if (!good) throw std::invalid_argument(what);
}

void check_layers(const std::vector<WallLayer>& layers) {
    require(!layers.empty() && layers.size() <= 8, "wall: 1 to 8 layers");
    for (const WallLayer& layer : layers) {
        require(layer.thickness > 0 && std::isfinite(layer.thickness),
                "wall: a layer's thickness must be positive");
        require(layer.young > 0 && std::isfinite(layer.young), "wall: a layer's modulus must be positive");
        require(layer.exponent >= 0.01 && layer.exponent <= 100,
                "wall: a layer's exponent must be 0.01 to 100");
    }
}

}  // namespace

std::vector<WallLayer> bowel_wall_layers() {
    return {{0.0010, 8.0e3, 3.0}, {0.0006, 80.0e3, 3.0}, {0.0012, 28.0e3, 3.0}, {0.0002, 30.0e3, 3.0}};
}

TubeStiffness tube_stiffness(const std::vector<WallLayer>& layers, double outer_radius, double poisson) {
    check_layers(layers);
    TubeStiffness sum;
    double outer = outer_radius;
    for (std::size_t k = layers.size(); k-- > 0;) {
        double inner = outer - layers[k].thickness;
        if (std::fabs(inner) < 1e-12 * outer_radius) inner = 0;
        require(inner >= 0, "wall: the layers are thicker than the tube's radius");
        const double area = pi * (outer * outer - inner * inner);
        const double inertia = 0.25 * area * (outer * outer + inner * inner);
        sum.axial += layers[k].young * area;
        sum.bending += layers[k].young * inertia;
        sum.torsional += layers[k].young / (1 + poisson) * inertia;  // G J, J = 2 I
        outer = inner;
    }
    return sum;
}

LayeredWall::LayeredWall(const LayeredWallSpec& spec) : spec_(spec) {
    check_layers(spec_.layers);
    const double nu = spec_.poisson_ratio;
    require(nu >= 0 && nu <= 0.49, "wall: Poisson's ratio must be 0 to 0.49");
    require(spec_.backing > 0, "wall: the backing must be positive");
    const WallNodule& nodule = spec_.nodule;
    if (nodule.height > 0) {
        require(spec_.nodule_layer >= 0 && spec_.nodule_layer < static_cast<int>(spec_.layers.size()),
                "wall: the nodule's layer does not exist");
        const WallLayer& layer = spec_.layers[static_cast<std::size_t>(spec_.nodule_layer)];
        require(nodule.height <= layer.thickness, "wall: the nodule is thicker than its layer");
        require(nodule.radius > 0 && std::isfinite(nodule.radius),
                "wall: the nodule's radius must be positive");
        require(nodule.young > 0 && std::isfinite(nodule.young),
                "wall: the nodule's modulus must be positive");
        require(nodule.exponent >= 0.01 && nodule.exponent <= 100,
                "wall: the nodule's exponent must be 0.01 to 100");
    }
    for (const WallLayer& layer : spec_.layers) thickness_ += layer.thickness;
    modulus_factor_ = (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    const auto slope = [&](double young, double exponent, double e) {  // d strain / d pressure
        return 1 / (modulus_factor_ * exp2_tangent({young, exponent}, e));
    };
    for (std::size_t i = 0; i < points; ++i) {
        // Dense where the curve bends (small pressures), coarse where it is steep.
        const double u = static_cast<double>(i) / (points - 1), p = most_pressure * u * u * u;
        pressure_[i] = p;
        depth_[i] = depth_at(p, 0);
        depth_slope_[i] = 1 / spec_.backing;
        for (const WallLayer& layer : spec_.layers) {
            depth_slope_[i] +=
                layer.thickness * slope(layer.young, layer.exponent, strain(layer.young, layer.exponent, p));
        }
        if (nodule.height <= 0) continue;
        const WallLayer& replaced = spec_.layers[static_cast<std::size_t>(spec_.nodule_layer)];
        const double soft = strain(replaced.young, replaced.exponent, p),
                     hard = strain(nodule.young, nodule.exponent, p);
        relief_[i] = hard - soft;
        relief_slope_[i] =
            slope(nodule.young, nodule.exponent, hard) - slope(replaced.young, replaced.exponent, soft);
    }
}

double LayeredWall::strain(double young, double exponent, double pressure) const {
    // e exp(a e^2) = q is increasing and convex, so Newton started right of the root descends to it. The
    // start is where the exponential alone or the linear term alone reaches q.
    const double q = pressure / (modulus_factor_ * young);
    if (q <= 0) return 0;
    const double by_power = q > 1 ? std::sqrt(math::log(q) / exponent) + 1 / std::sqrt(exponent) : q;
    double e = q < by_power ? q : by_power;
    for (int i = 0; i < 60; ++i) {
        const double power = exponent * e * e, value = e * math::exp(power) - q;
        const double next = e - value / ((1 + 2 * power) * math::exp(power));
        if (std::fabs(next - e) <= 1e-15 * e) return next;
        e = next;
    }
    return e;
}

double LayeredWall::depth_at(double pressure, double nodule_height) const {
    double depth = pressure / spec_.backing;
    for (std::size_t k = 0; k < spec_.layers.size(); ++k) {
        const WallLayer& layer = spec_.layers[k];
        const double e = strain(layer.young, layer.exponent, pressure);
        depth += layer.thickness * e;
        if (nodule_height > 0 && static_cast<int>(k) == spec_.nodule_layer)
            depth += nodule_height * (strain(spec_.nodule.young, spec_.nodule.exponent, pressure) - e);
    }
    return depth;
}

double LayeredWall::nodule_height(double distance) const {
    const WallNodule& nodule = spec_.nodule;
    if (nodule.height <= 0 || !(std::fabs(distance) < nodule.radius)) return 0;
    const double u = distance / nodule.radius, rise = 1 - u * u;
    return nodule.height * rise * rise;
}

void LayeredWall::pressure_at(double depth, double nodule_height, double& pressure, double& slope) const {
    const double h =
        nodule_height > 0 ? (nodule_height < spec_.nodule.height ? nodule_height : spec_.nodule.height) : 0;
    const auto depth_of = [&](std::size_t i) { return depth_[i] + h * relief_[i]; };
    const auto rate_of = [&](std::size_t i) { return 1 / (depth_slope_[i] + h * relief_slope_[i]); };
    pressure = slope = 0;
    if (!(depth > 0)) return;  // also catches NaN
    const std::size_t last = points - 1;
    if (depth >= depth_of(last)) {
        slope = rate_of(last);
        pressure = pressure_[last] + slope * (depth - depth_of(last));
        if (!(pressure < 1e12)) pressure = 1e12;
        return;
    }
    std::size_t low = 0, high = last;
    while (high - low > 1) {
        const std::size_t middle = (low + high) / 2;
        (depth_of(middle) <= depth ? low : high) = middle;
    }
    // Cubic Hermite with the exact slopes at both ends.
    const double from = depth_of(low), width = depth_of(high) - from, u = (depth - from) / width;
    const double p0 = pressure_[low], p1 = pressure_[high], s0 = rate_of(low) * width,
                 s1 = rate_of(high) * width;
    const double c2 = 3 * (p1 - p0) - 2 * s0 - s1, c3 = 2 * (p0 - p1) + s0 + s1;
    pressure = p0 + u * (s0 + u * (c2 + u * c3));
    slope = (s0 + u * (2 * c2 + 3 * u * c3)) / width;
}

Indentation LayeredWall::indent(double depth, double area, double puncture_force,
                                double nodule_height) const {
    Indentation answer;
    if (!(area > 0)) return answer;
    double pressure, slope;
    pressure_at(depth, nodule_height, pressure, slope);
    answer.force = pressure * area;
    answer.stiffness = slope * area;
    if (answer.force >= puncture_force) {
        answer.force = puncture_force > 0 ? puncture_force : 0;
        answer.stiffness = 0;
        answer.punctured = true;
    }
    return answer;
}

}  // namespace fulcrum
