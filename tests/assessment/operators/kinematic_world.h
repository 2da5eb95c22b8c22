// SPDX-License-Identifier: Apache-2.0
// A kinematic world for operators: rigid targets, and a bowel that moves only where it is held. Instruments
// and monitor are the real ones.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "assessment/operators/operator.h"
#include "assessment/task/bowel_line.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/numerics/random.h"
#include "sim_core/telemetry/event.h"

namespace fulcrum::test {

class KinematicWorld : public EventSink {
  public:
    KinematicWorld(const Scene& scene, const TaskDefinition& task, ObservingRig& rig, std::uint64_t seed)
        : scene_(scene), rig_(rig), monitor_(task, scene, seed) {
        for (const InstrumentSpec& spec : scene.instruments) {
            model_[static_cast<int>(spec.hand)] = make_instrument(spec, scene.tick_period());
        }
        if (scene.targets) scatter(*scene.targets, seed);
        if (scene.bowel) lay(*scene.bowel);
    }

    /// Runs until the monitor ends the attempt.
    void run() {
        std::vector<TickSample> ticks(static_cast<std::size_t>(scene_.ticks_per_step));
        rig_.observe(world_, monitor_.display());
        for (std::uint32_t tick = 1; !monitor_.display().ended; ++tick) {
            RigSample input;
            input.tick = tick;
            rig_.read(tick, input);
            const std::size_t slot = (tick - 1) % ticks.size();
            ticks[slot] = make_sample(input);
            samples.push_back(ticks[slot]);
            if (tick % static_cast<std::uint32_t>(scene_.ticks_per_step) != 0) continue;
            step();
            monitor_.on_step(ticks.data(), ticks.size(), world_, *this);
            rig_.observe(world_, monitor_.display());
        }
    }
    void on_event(const Event& event) noexcept override { events.push_back(event); }
    const TaskDisplay& display() const { return monitor_.display(); }
    int count(EventKind kind) const {
        return static_cast<int>(
            std::count_if(events.begin(), events.end(), [&](const Event& e) { return e.kind == kind; }));
    }
    Vector3 tip(std::size_t i, Hand hand) const {
        const auto& t = samples[i].hand[static_cast<int>(hand)].tip;
        return sample_length_unit * Vector3(t[0], t[1], t[2]);
    }
    /// Path of a tip, m, from positions 20 ms apart.
    double path(Hand hand) const {
        double sum = 0;
        for (std::size_t i = 20; i < samples.size(); i += 20)
            sum += (tip(i, hand) - tip(i - 20, hand)).norm();
        return sum;
    }
    double largest_force() const { return largest_force_; }

    std::vector<TickSample> samples;
    std::vector<Event> events;

  private:
    void scatter(const TargetFieldSpec& field, std::uint64_t seed) {
        Random random(seed, 77);
        for (int i = 0; i < 2 * field.per_hand; ++i) {
            TargetSphere sphere;
            sphere.radius = field.radius;
            sphere.hand = i < field.per_hand ? Hand::left : Hand::right;
            const auto near = [&](const TargetSphere& other) {
                return (other.centre - sphere.centre).norm() < field.minimum_distance;
            };
            do {
                for (int k = 0; k < 3; ++k) {
                    sphere.centre[k] = field.centre[k] + random.uniform(-1, 1) * field.half_extent[k];
                }
            } while (std::any_of(world_.targets.begin(), world_.targets.end(), near));
            world_.targets.push_back(sphere);
        }
    }

    // Rows of a meander on a plane, about as wide as the real one's.
    void lay(const BowelSpec& bowel) {
        for (int i = 0; i <= bowel.segments; ++i) {
            const double s = bowel.length * i / bowel.segments, bight = 0.26;
            const int row = static_cast<int>(s / bight);
            const double along = (s - row * bight) / bight;
            rest_.emplace_back((row % 2 == 0 ? 1 : -1) * (0.09 - 0.18 * along),
                               0.03 + 0.042 * (row + 0.3 * along), -0.025);
            world_.bowel.node_arc_lengths.push_back(s);
        }
        world_.bowel.nodes = rest_;
    }

    TickSample make_sample(const RigSample& input) {
        TickSample sample;
        sample.tick = input.tick;
        for (int h = 0; h < hand_count; ++h) {
            tool_[h] = tool_pose(model_[h], input.hand[h]);
            Vector3 force = Vector3::Zero();
            HandSample& hand = sample.hand[h];
            for (const TargetSphere& target : world_.targets) {
                const Vector3 away = tool_[h].tip - target.centre;
                const double depth = target.radius + model_[h].tip_radius - away.norm();
                if (depth <= 0) continue;
                force -= scene_.targets->stiffness * depth * away.normalized();
                hand.tissue = 0;
            }
            unsigned flags = tool_[h].inside ? static_cast<unsigned>(hand_inside) : 0U;
            if (world_.grasps[h].held) {
                const auto node = static_cast<std::size_t>(held_node_[h]);
                force = 30 * (world_.bowel.nodes[node] - rest_[node]);
                hand.tissue = 0;
                flags |= hand_grasping;
                hand.jaw_force = static_cast<std::int32_t>(std::lround(tool_[h].grip * 1000));
                hand.jaw_area = 100000;
            }
            hand.flags = static_cast<std::uint16_t>(flags);
            largest_force_ = std::max(largest_force_, force.norm());
            for (int k = 0; k < 3; ++k) {
                hand.tip[k] = static_cast<std::int32_t>(std::lround(tool_[h].tip[k] / sample_length_unit));
                hand.force[k] = static_cast<std::int32_t>(std::lround(force[k] * 1000));
            }
            hand.jaw_angle = input.hand[h].jaw;
        }
        return sample;
    }

    void step() {
        for (int h = 0; h < hand_count; ++h) {
            world_.tools[h] = tool_[h].pose();
            if (scene_.bowel) update_grasp(h);
        }
        world_.bowel.nodes = rest_;
        for (int h = 0; h < hand_count; ++h) {
            if (!world_.grasps[h].held) continue;
            const Vector3 moved = jaws(h) - held_from_[h];
            for (std::size_t i = 0; i < rest_.size(); ++i) {
                const double away = std::abs(world_.bowel.node_arc_lengths[i] - world_.grasps[h].arc_length);
                world_.bowel.nodes[i] += std::max(0.0, 1 - away / 0.1) * moved;
            }
        }
        ++world_.step;
    }

    Vector3 jaws(int h) const { return tool_[h].tip - 0.5 * model_[h].jaw_length * tool_[h].axis; }

    void update_grasp(int h) {
        GraspState& grasp = world_.grasps[h];
        const double opening = tool_[h].jaw_angle / model_[h].jaw_opening;
        if (opening > 0.45) {
            ready_[h] = true;
            grasp.held = false;
        }
        if (grasp.held || opening > 0.35 || tool_[h].grip < 0.2 || !ready_[h]) return;
        ready_[h] = false;
        std::size_t nearest = 0;
        for (std::size_t i = 0; i < world_.bowel.nodes.size(); ++i) {
            if ((world_.bowel.nodes[i] - jaws(h)).norm() < (world_.bowel.nodes[nearest] - jaws(h)).norm())
                nearest = i;
        }
        if (std::abs((world_.bowel.nodes[nearest] - jaws(h)).norm() - scene_.bowel->outer_radius) > 0.006)
            return;
        grasp.held = true;
        grasp.tissue = static_cast<std::int8_t>(scene_.tissue_index(scene_.bowel->tissue));
        grasp.slipped = false;
        grasp.arc_length = world_.bowel.node_arc_lengths[nearest];
        grasp.patch = static_cast<std::int32_t>(nearest);
        held_node_[h] = static_cast<int>(nearest);
        held_from_[h] = jaws(h);
    }

    Scene scene_;
    ObservingRig& rig_;
    TaskMonitor monitor_;
    InstrumentModel model_[hand_count];
    ToolKinematics tool_[hand_count];
    WorldSnapshot world_;
    std::vector<Vector3> rest_;
    bool ready_[hand_count] = {false, false};
    int held_node_[hand_count] = {0, 0};
    Vector3 held_from_[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    double largest_force_ = 0;
};

}  // namespace fulcrum::test
