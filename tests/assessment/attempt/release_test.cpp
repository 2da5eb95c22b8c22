// SPDX-License-Identifier: Apache-2.0
// Opening the jaws: the tool is where the tissue was pulled to, and that must not be felt or scored as a
// push.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "assessment/attempt/engine.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

constexpr std::uint32_t arrive = 600, close = 700, open_again = 1500, last = 2100;

/// The left hand moves to a place; there its jaws close, hold and open without further movement, or stay
/// open.
class LeftHand : public Rig {
  public:
    LeftHand(const Scene& scene, const Vector3& place, bool closes) : closes_(closes) {
        const InstrumentSpec& spec = *scene.instrument(Hand::left);
        const InstrumentModel model = make_instrument(spec, scene.tick_period());
        const Vector3 direction = (place - model.trocar.position).normalized();
        from_ = handle_for_tip(model.trocar, model.trocar.position + spec.start_insertion * direction);
        // The middle of the jaws is at the surface: the tip is half a jaw inside.
        to_ = handle_for_tip(model.trocar, place + 0.5 * model.jaw_length * direction);
        opening_ = model.jaw_opening;
        for (int hand = 0; hand < hand_count; ++hand) {
            const InstrumentSpec* other = scene.instrument(static_cast<Hand>(hand));
            still_[hand] = start_sample(other->trocar, other->start_insertion);
        }
        camera_ = start_sample(scene.camera->trocar, scene.camera->start_insertion);
    }
    void read(std::uint32_t tick, RigSample& sample) override {
        sample.hand[0] = last_;
        sample.hand[1] = still_[1];
        sample.camera = camera_;
        const double u = std::min(1.0, tick / static_cast<double>(arrive));
        DeviceReading reading;
        reading.handle = from_ + u * u * (3 - 2 * u) * (to_ - from_);
        const bool closed = closes_ && tick >= close && tick < open_again;
        const double since =
            tick < open_again ? tick - static_cast<double>(close) : tick - static_cast<double>(open_again);
        const double move = std::clamp(since / 150.0, 0.0, 1.0);
        reading.jaw =
            opening_ * (!closes_ || tick < close ? 1.0 : (closed ? 1.0 - 0.9 * move : 0.1 + 0.9 * move));
        reading.grip = closed ? 8.0 : 0.0;
        last_ = quantise(reading, tick == 1 ? DeviceSample{} : last_);
        sample.hand[0] = last_;
        if (tick >= last) sample.flags |= rig_abandon;
    }
    void write_force(Hand /*hand*/, const Vector3& /*force*/) override {}
    bool has_force(Hand /*hand*/) const override { return true; }
    double damping(Hand /*hand*/) const override { return 1.0; }

  private:
    Vector3 from_, to_;
    double opening_ = 1;
    bool closes_;
    DeviceSample last_, still_[hand_count], camera_;
};

struct Samples : AttemptSink {
    std::vector<HandSample> left;
    void on_tick(const RigSample& /*input*/, const TickSample& sample) noexcept override {
        left.push_back(sample.hand[0]);
    }
    void on_step(const StepRecord& /*step*/) noexcept override {}
    void on_event(const Event& /*event*/) noexcept override {}
};

Vector3 newton(const std::int32_t (&counts)[3]) {
    return sample_force_unit * Vector3(counts[0], counts[1], counts[2]);
}

struct Stage {
    TaskDefinition task = load_task(test::source_path("assets/tasks/B1.json"));
    Scene scene = load_scene(test::source_path("assets/scenes/" + task.scene));
    AttemptEngine engine{scene, task, 1};
    Vector3 trocar = scene.instrument(Hand::left)->trocar.position;
    const std::vector<RingFrame>& rings = engine.initial_snapshot().bowel.rings;
    std::size_t nearest = 0;

    Stage() {
        for (std::size_t r = 1; r < rings.size(); ++r) {
            if ((rings[r].position - trocar).norm() < (rings[nearest].position - trocar).norm()) nearest = r;
        }
    }
    /// Next to the side of the ring nearest to the left trocar, so that its wall is between the jaws.
    Vector3 flank() const {
        const Vector3 along = (rings[nearest + 1].position - rings[nearest - 1].position).normalized();
        const Vector3 side = along.cross(rings[nearest].position - trocar).normalized();
        return rings[nearest].position + (radius() + 0.001) * side;
    }
    Vector3 crest() const {
        return rings[nearest].position + radius() * (trocar - rings[nearest].position).normalized();
    }
    double radius() const { return 0.016; }
};

TEST(Contact, ForceOnAToolAtRestOnTheBowelIsSteady) {
    Stage stage;
    LeftHand rig(stage.scene, stage.crest(), false);
    Samples samples;
    run_headless(stage.engine, rig, samples);
    double least = 1e9, most = 0;
    for (std::size_t i = 1000; i < samples.left.size(); ++i) {
        const double force = newton(samples.left[i].force).norm();
        least = std::min(least, force);
        most = std::max(most, force);
    }
    EXPECT_GT(least, 0.1) << "it presses";
    EXPECT_LT(most - least, 0.15) << "N from " << least << " to " << most;
}

TEST(Release, ReleasedTissueIsNotPushedSuddenly) {
    Stage stage;
    LeftHand rig(stage.scene, stage.flank(), true);
    Samples samples;
    run_headless(stage.engine, rig, samples);

    std::size_t first = 0, release = 0;
    for (std::size_t i = 1; i < samples.left.size(); ++i) {
        const bool held = (samples.left[i].flags & hand_grasping) != 0;
        const bool before = (samples.left[i - 1].flags & hand_grasping) != 0;
        if (held && !before) first = i;
        if (!held && before) release = i;
    }
    ASSERT_GT(first, 0U) << "the jaws took hold";
    ASSERT_GT(release, first + 300) << "and let go";
    ASSERT_GT(samples.left.size(), release + 300);
    bool touched = false;
    for (std::size_t i = release; i < samples.left.size(); ++i) {
        const double force = newton(samples.left[i].force).norm();
        EXPECT_LT(force, 1.0) << "at tick " << i - release << " after the release";
        touched = touched || force > 0;
        if (i == release) continue;
        const double step = (newton(samples.left[i].force) - newton(samples.left[i - 1].force)).norm();
        EXPECT_LT(step, 0.3) << "N in one ms, tick " << i - release;
    }
    EXPECT_TRUE(touched) << "the contact comes back, slowly";
    // The force of the grasp falls with the slew limit; the force of the contact itself begins to act
    // top.
    for (std::size_t i = release; i < samples.left.size(); ++i) {
        const double step =
            (newton(samples.left[i].device_force) - newton(samples.left[i - 1].device_force)).norm();
        const double own =
            i == release ? 0.0 : (newton(samples.left[i].force) - newton(samples.left[i - 1].force)).norm();
        EXPECT_LT(step, 0.302 + own) << "N in one ms at the hand, tick " << i - release;
    }
}

}  // namespace
}  // namespace fulcrum
