// SPDX-License-Identifier: GPL-3.0-or-later
// The world's step while the plane behind the rectum is divided: the rectum is held and lifted, a hook moves
// along one septum after the other.
#include "app/lab/plane_workload.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "app/lab/attempt_workloads.h"
#include "assessment/assets/assets.h"
#include "sim_core/anatomy/scene_anatomy.h"
#include "sim_core/haptics/loop.h"
#include "sim_core/world/world.h"

namespace fulcrum::app {
namespace {

constexpr double lift = 0.008, reach = 0.05, depth = -0.005, speed = 0.03, quick = 0.15;  // m, m/s

struct Plane {
    Scene scene = load_scene(asset_path("scenes/c4_posterior.json"));
    World world{scene, 1};
    HapticLoop loop{scene, world};
    SacralCurve curve = rectum_parameters(scene).curve;
    std::vector<TickOutput> outputs{static_cast<std::size_t>(scene.ticks_per_step)};
    Trocar trocar[hand_count];
    DeviceSample last[hand_count];
    Vector3 tip[hand_count];
    bool closed = false, button = false;
    double squeeze = 0, share = 0;
    int septum = 0, phase = 0, worst_outcome = 0;
    std::uint32_t tick = 0;

    Plane() {
        for (std::size_t h = 0; h < hand_count; ++h) {
            const InstrumentSpec& spec = *scene.instrument(static_cast<Hand>(h));
            trocar[h] = make_trocar(spec.trocar);
            last[h] = start_sample(spec.trocar, spec.start_insertion);
            tip[h] = spec.trocar.position + spec.start_insertion * spec.trocar.direction;
            ForceOutput device;
            device.damping = 0.5;
            loop.set_device(static_cast<Hand>(h), device);
        }
        const double s = curve.arc_length(scene.septa->first_angle) + 0.006;
        const Vector3 front = curve.centre_line(s) - curve.rectum_radius * curve.posterior(s);
        lead(0, front + Vector3(0, 0, 0.02), quick);
        lead(0, front, quick);
        closed = true;
        for (int i = 0; i < 40; ++i) step();
        lead(0, front - lift * curve.posterior(s), speed);
    }
    void ticks() {
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            RigSample input;
            input.tick = ++tick;
            squeeze = std::clamp(squeeze + (closed ? 0.025 : -0.025), 0.0, 1.0);
            for (std::size_t h = 0; h < hand_count; ++h) {
                DeviceReading reading;
                reading.handle = handle_for_tip(trocar[h], tip[h]);
                if (h == 0) {
                    reading.jaw = 1 - squeeze;
                    reading.grip = 8 * squeeze;
                }
                reading.buttons = h == 1 && button ? button_primary : button_none;
                input.hand[h] = last[h] = quantise(reading, last[h]);
            }
            if (scene.camera)
                input.camera = start_sample(scene.camera->trocar, scene.camera->start_insertion);
            outputs[i] = loop.tick(input);
        }
    }
    void step() {
        ticks();
        world_step();
        loop.adopt(world.local_models());
    }
    void world_step() {
        worst_outcome =
            std::max(worst_outcome, static_cast<int>(world.step(outputs.data(), outputs.size()).outcome));
    }
    /// Moves the jaws in a straight line at a speed (m/s), with the world's steps.
    void lead(int hand, const Vector3& jaws, double at) {
        const double half = hand == 0 ? 0.5 * scene.instruments[0].jaw_length : 0.0;
        const Vector3 to = jaws + half * (jaws - trocar[hand].position).normalized();
        while ((to - tip[hand]).norm() > 1e-9) {
            tip[hand] += std::min(1.0, at * scene.step_period() / (to - tip[hand]).norm()) * (to - tip[hand]);
            step();
        }
    }
    Vector3 on_line(double before) const {
        const SheetView& view = world.snapshot().sheet;
        const std::size_t count = view.line.size() / static_cast<std::size_t>(scene.septa->count);
        const std::size_t first = static_cast<std::size_t>(septum) * count;
        const double at =
            std::clamp(share * static_cast<double>(count) - 0.5, 0.0, static_cast<double>(count) - 1.001);
        const std::size_t i = first + static_cast<std::size_t>(at);
        const Vector3 here = view.line[i] + (share * static_cast<double>(count) - 0.5 - std::floor(at)) *
                                                (view.line[i + 1] - view.line[i]);
        return here + before * curve.cranial(septum_arc_length(*scene.septa, curve, septum));
    }
    /// Moves the hook by one step: to the septum, into it, along it, out of it, to the next.
    void aim() {
        const Vector3 target = phase == 0   ? on_line(reach)
                               : phase == 1 ? on_line(0.004)
                               : phase == 2 ? on_line(depth)
                                            : on_line(reach);
        const double longest = (phase == 2 ? speed : quick) * scene.step_period();
        const Vector3 to_target = target - tip[1];
        tip[1] += std::min(1.0, longest / std::max(1e-9, to_target.norm())) * to_target;
        if (phase == 2) {
            share += speed * scene.step_period() / scene.septa->width;
            if (share > 1.15) phase = 3;
        } else if (to_target.norm() <= longest) {
            phase = phase == 3 ? 0 : phase + 1;
            if (phase == 0) {
                septum = (septum + 1) % scene.septa->count;
                share = 0.05;
            }
        }
        button = phase == 2;
        ticks();
    }
};

}  // namespace

lab::Workload plane_workload() {
    lab::Workload workload;
    workload.name = "world_c4";
    workload.budget_mg = 800;
    workload.samples = 1500;
    workload.prepare = [] {
        const auto plane = std::make_shared<Plane>();
        plane->share = 0.05;
        plane->ticks();
        lab::Workload::Prepared prepared;
        prepared.step = [plane] { plane->world_step(); };
        prepared.between = [plane] {
            plane->loop.adopt(plane->world.local_models());
            plane->aim();
        };
        prepared.bytes = bytes_of(plane->world, {"sheet", "rod", "collision", "cage_and_surface"});
        prepared.error = [plane] { return std::optional<double>(plane->worst_outcome); };
        prepared.error_unit = "worst outcome of a step; 0: as it should be";
        return prepared;
    };
    return workload;
}

}  // namespace fulcrum::app
