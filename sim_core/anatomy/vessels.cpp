// SPDX-License-Identifier: Apache-2.0
#include "sim_core/anatomy/vessels.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double least_radius = 0.55;  // pixels; thinner ones only fade
constexpr int most_generations = 6;

Eigen::Vector2d turned(const Eigen::Vector2d& v, double angle) {
    double sine = 0, cosine = 1;
    math::sin_cos(angle, sine, cosine);
    return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y()};
}

}  // namespace

VesselField::VesselField(int width, int height)
    : width_(width),
      height_(height),
      values_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0F) {}

// A soft disc: its centre is as strong as it is wide, its edge half a pixel soft.
void VesselField::stroke(const Eigen::Vector2d& centre, double radius) {
    const double strength = std::min(1.0, 0.35 + 0.65 * radius / (2.2 * least_radius));
    const double drawn = std::max(radius, least_radius);
    const int reach = static_cast<int>(std::ceil(drawn + 1));
    const int ci = static_cast<int>(std::floor(centre.x())), cj = static_cast<int>(std::floor(centre.y()));
    // A little more than the disc, so that rounding leaves out nothing that the disc covers.
    const double farthest = (drawn + 0.5) * (drawn + 0.5) * (1 + 1e-9);
    for (int j = cj - reach; j <= cj + reach; ++j) {
        const double dy = j + 0.5 - centre.y();
        const auto y = static_cast<std::size_t>(((j % height_) + height_) % height_);
        float* const row = values_.data() + y * static_cast<std::size_t>(width_);
        for (int i = ci - reach; i <= ci + reach; ++i) {
            const double dx = i + 0.5 - centre.x(), squared = dx * dx + dy * dy;
            if (squared > farthest) continue;
            const double cover = std::clamp(drawn + 0.5 - std::sqrt(squared), 0.0, 1.0);
            const int x = i >= 0 && i < width_ ? i : ((i % width_) + width_) % width_;
            row[x] = std::max(row[x], static_cast<float>(strength * cover));
        }
    }
}

void VesselField::grow(const VesselGrowth& growth) {
    Random random(growth.seed, 3);
    std::vector<Branch> waiting;
    for (int tree = 0; tree < growth.trees; ++tree) {
        Branch trunk;
        // One per cell of a jittered lattice: even cover without a pattern.
        const double cells = std::sqrt(static_cast<double>(growth.trees) * width_ / height_);
        const int across = std::max(1, static_cast<int>(std::lround(cells)));
        const int down = std::max(1, (growth.trees + across - 1) / across);
        trunk.place = Eigen::Vector2d((tree % across + random.uniform()) * width_ / across,
                                      (tree / across + random.uniform()) * height_ / down);
        const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
        trunk.direction = turned(side * growth.along.normalized(), random.normal(0, 0.25));
        trunk.radius = growth.trunk_radius * width_ * random.uniform(0.65, 1.15);
        trunk.length = growth.reach * width_ * random.uniform(0.7, 1.2);
        trunk.generation = 0;
        waiting.push_back(trunk);
    }
    while (!waiting.empty()) {
        Branch branch = waiting.back();
        waiting.pop_back();
        const double preferred_x = branch.direction.x(), preferred_y = branch.direction.y();
        double bend = 0;
        double until_fork = branch.length * random.uniform(0.15, 0.35);
        const double whole = branch.length;
        while (branch.length > 0) {
            const double step = std::max(0.5, 0.45 * branch.radius);
            // A random bend, pulled back to the branch's own direction: vessels meander but do not reverse.
            const double off = preferred_x * branch.direction.y() - preferred_y * branch.direction.x();
            bend = 0.94 * bend + random.normal(0, 0.028) - 0.012 * off;
            branch.direction = turned(branch.direction, bend * step * 0.35).normalized();
            branch.place += step * branch.direction;
            branch.length -= step;
            until_fork -= step;
            double taper = 0.45 + 0.55 * std::max(0.0, branch.length / whole);
            // Trunks emerge from the depth, so they begin thin.
            if (branch.generation == 0) taper *= std::min(1.0, 0.1 + 4 * (whole - branch.length) / whole);
            stroke(branch.place, branch.radius * taper);
            if (until_fork > 0 || branch.generation >= most_generations || branch.radius < 0.4) continue;
            // Murray: r^3 = a^3 + b^3. The side branch takes a share of the flow.
            const double share = random.uniform(0.12, 0.5);
            Branch side = branch;
            const double angle = random.uniform(0.5, 1.05) * (random.uniform() < 0.5 ? -1 : 1);
            side.direction = turned(branch.direction, angle);
            side.radius = branch.radius * math::exp(math::log(share) / 3);
            side.length = whole * random.uniform(0.35, 0.6);
            side.generation = branch.generation + 1;
            waiting.push_back(side);
            branch.direction = turned(branch.direction, -0.3 * angle);
            branch.radius *= math::exp(math::log(1 - 0.6 * share) / 3);
            until_fork = whole * random.uniform(0.14, 0.3);
        }
    }
}

}  // namespace fulcrum
