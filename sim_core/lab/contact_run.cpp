// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/contact_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/lab/reference_tube.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum::lab {
namespace {

constexpr double length = 0.9, mean_radius = 0.016;

}  // namespace

// The bowel oscillates; a ring's velocity is the derivative.
void ContactRun::move_rings(double t) {
    double sine = 0, cosine = 1;
    math::sin_cos(3.14159265358979 * t, sine, cosine);
    for (std::size_t r = 0; r < rings.size(); ++r) {
        const RingFrame rest = rest_frame(skin->cage().arc_lengths[r]);
        rings[r].frame = rest;
        rings[r].frame.position.z() += 0.002 * sine;
        rings[r].velocity = Vector3(0, 0, 0.002 * 3.14159265358979 * cosine);
    }
}

// Back and forth along the bowel, weaving over its back.
void ContactRun::move_tool(double t, double lift) {
    const double along = 0.45 + 0.05 * math::sin(1.2 * t), weave = 0.3 * math::sin(2.0 * t);
    const double height = mean_radius + 0.0015 + lift - 0.001 * math::sin(5 * t);
    DeviceReading reading;
    reading.handle = handle_for_tip(model.instrument.trocar,
                                    {along, height * math::sin(weave), height * math::cos(weave)});
    tool = step_instrument(model.instrument, quantise(reading, instrument.last), instrument);
}

void ContactRun::publish() {
    PatchRequest request;
    request.tool = tool;
    request.contact_vertex = result.touching_surface ? result.vertex : -1;
    ++local.step;
    local.tick = tick;
    builder->build(rings.data(), request, scratch, local);
}

void ContactRun::prepare_tick(double lift, std::uint32_t period) {
    ++tick;
    const double t = tick * 1e-3;
    move_tool(t, lift);
    if (tick % period == 0) {
        move_rings(t);
        publish();
    }
}

std::shared_ptr<ContactRun> build_contact_run(int sections, int around) {
    auto run = std::make_shared<ContactRun>();
    TriangleMesh mesh = make_tube(length, sections, around, haustral_radius(mean_radius));
    const SphereChain spheres = sample_spheres(length, 0.016, [](double) { return mean_radius; });
    Cage cage = build_cage(mesh, length, spheres);
    run->skin = std::make_unique<BowelSkin>(std::move(mesh), std::move(cage));
    run->builder =
        std::make_unique<PatchBuilder>(*run->skin, PatchOptions{}, divide_into_patches(*run->skin, 4, 4));
    run->scratch = run->builder->make_scratch();
    run->rings.resize(static_cast<std::size_t>(run->skin->rings()));
    InstrumentSpec spec;
    spec.trocar.position = Vector3(0.45, 0.0, 0.2);
    spec.trocar.direction = Vector3(0, 0, -1);
    spec.trocar.up = Vector3(0, 1, 0);
    run->model.instrument = make_instrument(spec, 1e-3);
    run->move_rings(0);
    run->move_tool(0, 0);
    run->publish();
    return run;
}

std::shared_ptr<ContactRun> build_contact_run_of(int triangles) {
    const double slenderness = length / (2 * 3.14159265358979 * mean_radius);
    const int around = std::max(8, static_cast<int>(std::lround(std::sqrt(triangles / (2 * slenderness)))));
    return build_contact_run(triangles / (2 * around), around);
}

double worst_contact_distance(ContactRun& run, int poses) {
    std::vector<RingFrame> frames(run.rings.size());
    std::vector<Vector3> all(static_cast<std::size_t>(run.skin->vertices()));
    double worst = 0;
    for (int k = 0; k < poses; ++k) {
        for (std::uint32_t i = 0; i < 7 * ticks_a_step || run.tick % ticks_a_step != 0; ++i) {
            run.prepare_tick(0.004);
            run.touch();
        }
        for (std::size_t r = 0; r < frames.size(); ++r) frames[r] = run.rings[r].frame;
        skin_all(*run.skin, frames.data(), all.data());
        double nearest = std::numeric_limits<double>::infinity();
        for (const Triangle& t : run.skin->rest().triangles) {
            const Vector3 foot = closest_point_on_triangle(run.tool.tip, all[static_cast<std::size_t>(t[0])],
                                                           all[static_cast<std::size_t>(t[1])],
                                                           all[static_cast<std::size_t>(t[2])])
                                     .position;
            nearest = std::min(nearest, (run.tool.tip - foot).norm());
        }
        worst = std::max(worst, std::abs(run.result.distance - (nearest - run.model.instrument.tip_radius)));
    }
    return worst;
}

}  // namespace fulcrum::lab
