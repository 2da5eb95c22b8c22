// SPDX-License-Identifier: Apache-2.0
// No tunnelling: hands drive their instruments straight through the resting bowel, from all sides, through
// haptic loop and world at their own rates. Each crossing has met its contact before the tool is out on the
// other side, even if every model is a whole step late.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/haptics/loop.h"
#include "sim_core/numerics/random.h"
#include "sim_core/world/parts/bowel/bowel_part.h"
#include "sim_core/world/world.h"
#include "tests/support/force_device.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

constexpr double outside = 0.024;  // m from the centre line of a tube of 16 mm: a shaft there touches nothing
constexpr double through = 0.008;  // m from the centre line at most, for the path of a crossing

struct Crossing {
    int hand = 0;
    Vector3 from = Vector3::Zero(), to = Vector3::Zero();  ///< m, of the tip
    double out =
        0;  ///< fraction of the path at which the shaft has left the tube, for the bowel's present position
};

struct Outcome {
    bool met = false;        ///< a contact with force, so far
    bool tunnelled = false;  ///< out on the other side without contact
    bool straight = true;    ///< the trocar allows the requested path
    bool finite = true;
    double largest_sent = 0;  ///< N, to the device
    double first_gap = 0;     ///< m, shaft to centre line when it was met
};

class TunnelHands {
  public:
    explicit TunnelHands(bool late)
        : late_(late),
          scene_(load_scene(test::source_path("assets/scenes/b1_bowel.json"))),
          world_(scene_, 1),
          loop_(scene_, world_),
          outputs_(5),
          pending_(world_.local_models()) {
        for (const InstrumentSpec& spec : scene_.instruments)
            loop_.set_device(spec.hand, test::ideal_device());
    }

    const Scene& scene() const { return scene_; }
    const std::vector<Vector3>& line() const { return world_.find<BowelPart>()->state().nodes; }
    Vector3 trocar(int hand) const { return scene_.instrument(static_cast<Hand>(hand))->trocar.position; }

    /// Shaft to centre line, where they are nearest: from the bowel to the shaft.
    Vector3 gap(int hand, const Vector3& tip) const {
        Vector3 least = Vector3::Constant(1);
        for (std::size_t i = 0; i + 1 < line().size(); ++i) {
            const SegmentPair pair = closest_points_of_segments(trocar(hand), tip, line()[i], line()[i + 1]);
            const Vector3 gap = pair.on_first - pair.on_second;
            if (gap.squaredNorm() < least.squaredNorm()) least = gap;
        }
        return least;
    }

    /// The path starts and ends in free space and passes through the tube in between.
    bool goes_through(Crossing& crossing) const {
        crossing.out = 0;
        constexpr int places = 60;
        double nearest = 1;
        for (int k = 0; k <= places; ++k) {
            const double share = static_cast<double>(k) / places;
            const double distance =
                gap(crossing.hand, crossing.from + share * (crossing.to - crossing.from)).norm();
            if ((k < places / 4 || k == places) && distance < outside) return false;
            if (nearest < through && crossing.out <= 0 && distance > outside) crossing.out = share;
            nearest = std::min(nearest, distance);
        }
        return nearest < through;
    }

    /// Withdrawn instruments, until the bowel is at rest.
    void rest() {
        Outcome none;
        for (int k = 0; k < 200; ++k) {
            Crossing away;
            const Vector3 out = trocar(0) - Vector3(0, 0, 0.03);
            run_step(away, out, out, none);
            double fastest = 0;
            for (const Vector3& velocity : world_.find<BowelPart>()->state().velocities)
                fastest = std::max(fastest, velocity.norm());
            if (fastest < 0.02) break;
        }
    }

    /// From outside the body along the shaft to the start, without crossing the bowel.
    void approach(const Crossing& crossing) {
        Outcome none;
        const Vector3 pivot = trocar(crossing.hand);
        const Vector3 out = pivot - 0.03 * (crossing.from - pivot).normalized();
        constexpr int parts = 10;
        for (int k = 0; k < parts; ++k) {
            run_step(crossing, out + k * (crossing.from - out) / parts,
                     out + (k + 1) * (crossing.from - out) / parts, none);
        }
    }

    Outcome cross(const Crossing& crossing, double speed) {
        Outcome outcome;
        const double length = (crossing.to - crossing.from).norm(), a_step = speed * scene_.step_period();
        const Vector3 along = (crossing.to - crossing.from) / length;
        for (double done = 0; done < length; done += a_step) {
            const double next = std::min(length, done + a_step);
            run_step(crossing, crossing.from + done * along, crossing.from + next * along, outcome);
        }
        return outcome;
    }

  private:
    void run_step(const Crossing& crossing, const Vector3& from, const Vector3& to, Outcome& outcome) {
        const Trocar pivot = make_trocar(scene_.instrument(static_cast<Hand>(crossing.hand))->trocar);
        const Vector3 along = crossing.to - crossing.from;
        for (int i = 0; i < 5; ++i) {
            RigSample input;
            input.tick = ++tick_;
            for (const InstrumentSpec& spec : scene_.instruments)
                input.hand[static_cast<int>(spec.hand)] = start_sample(spec.trocar, -0.05);
            const Vector3 tip = from + (i + 1) / 5.0 * (to - from);
            const Vector3 handle = handle_for_tip(pivot, tip) / device_length_unit;
            DeviceSample& device = input.hand[crossing.hand];
            for (int k = 0; k < 3; ++k) device.handle[k] = static_cast<std::int32_t>(std::lround(handle[k]));
            if (scene_.camera)
                input.camera = start_sample(scene_.camera->trocar, scene_.camera->start_insertion);
            const TickOutput& output = outputs_[static_cast<std::size_t>(i)] = loop_.tick(input);
            const ToolKinematics& tool = output.contact[crossing.hand].tool;
            const std::int32_t* counts = output.sample.hand[crossing.hand].force;
            const double force = sample_force_unit * Vector3(counts[0], counts[1], counts[2]).norm();
            outcome.straight = outcome.straight && (tool.tip - tip).norm() < 1e-4;
            if (!outcome.met && output.contact[crossing.hand].vertex >= 0 && force > 0) {
                outcome.met = true;
                outcome.first_gap = gap(crossing.hand, tool.tip).norm();
            }
            const double share = (tip - crossing.from).dot(along) / std::max(1e-12, along.squaredNorm());
            outcome.tunnelled = outcome.tunnelled || (!outcome.met && share > crossing.out);
            outcome.finite = outcome.finite && output.device_force[crossing.hand].allFinite();
            outcome.largest_sent = std::max(outcome.largest_sent, output.device_force[crossing.hand].norm());
        }
        world_.step(outputs_.data(), outputs_.size());
        loop_.adopt(late_ ? pending_ : world_.local_models());
        pending_ = world_.local_models();
    }

    bool late_;
    Scene scene_;
    World world_;
    HapticLoop loop_;
    std::vector<TickOutput> outputs_;
    LocalModels pending_;
    std::uint32_t tick_ = 0;
};

Vector3 direction(Random& random) {
    const Vector3 v(random.normal(), random.normal(), random.normal());
    return v.norm() > 1e-6 ? Vector3(v.normalized()) : Vector3(Vector3::UnitX());
}

void cross_everywhere(double speed, bool late, int wanted) {
    TunnelHands hands(late);
    Random random(static_cast<std::uint64_t>(speed), late ? 1 : 0);
    // A late model holds the tool pose of ten ticks ago.
    const double run_up = 0.05 + 0.012 * speed;
    int crossings = 0;
    for (int tried = 0; tried < 100 * wanted && crossings < wanted; ++tried) {
        Crossing crossing;
        crossing.hand = static_cast<int>(random.below(2));
        const auto at =
            static_cast<std::size_t>(random.uniform(0.1, 0.9) * static_cast<double>(hands.line().size()));
        const Vector3 aim = hands.line()[at] + 0.006 * direction(random), along = direction(random);
        crossing.from = aim - (run_up + random.uniform(0, 0.010)) * along;
        crossing.to = aim + 0.06 * along;
        if (!hands.goes_through(crossing)) continue;
        hands.approach(crossing);
        if (!hands.goes_through(crossing)) continue;  // the bowel still moved
        const Outcome outcome = hands.cross(crossing, speed);
        hands.rest();
        if (!outcome.straight) continue;
        ++crossings;
        const testing::Message place = testing::Message()
                                       << speed << " m/s, try " << tried << (late ? ", late" : "");
        EXPECT_TRUE(outcome.met) << place;
        EXPECT_FALSE(outcome.tunnelled) << place;
        // At 1 m/s, ten ticks are 10 mm of travel: the wall must be felt before the middle is reached.
        if (speed < 2) {
            EXPECT_GT(outcome.first_gap, 0.010) << place;
        }
        EXPECT_TRUE(outcome.finite) << place;
        EXPECT_LE(outcome.largest_sent, hands.scene().force_limit + 1e-9) << place;
    }
    EXPECT_EQ(crossings, wanted);
}

TEST(Tunnel, ToolAtOneMetrePerSecondNeverCrossesTheBowelWithoutContact) {
    cross_everywhere(1, false, 40);
    cross_everywhere(1, true, 20);
}

TEST(Tunnel, ToolAtTenMetresPerSecondNeverCrossesTheBowelWithoutContact) {
    cross_everywhere(10, false, 40);
}

}  // namespace
}  // namespace fulcrum
