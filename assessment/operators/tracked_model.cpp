// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "assessment/operators/device_models.h"
#include "sim_core/instrument/mouse_mapping.h"
#include "sim_core/numerics/random.h"
#include "sim_core/scene/instrument_type.h"

namespace fulcrum {
namespace {

constexpr double frames_a_second = 120;
constexpr std::size_t frames_late = 2;            // from the movement to the pose in the program
constexpr double pose_noise = 0.05e-3;            // m, standard deviation of an axis of the handle
constexpr double angle_noise = 0.2 * 0.01745329;  // rad, standard deviation of a turn about the shaft
constexpr double closed_jaws = 0.3;               // of the opening: narrower jaws hold what is between them
constexpr std::uint64_t noise_stream = 0x747261636b;

/// A pose of one instrument on its way from the tracker to the program.
class TrackedHandle {
  public:
    TrackedHandle() = default;
    /// `spec`: null for the scope.
    TrackedHandle(const DeviceReading& start, const InstrumentSpec* spec) : follower_(start), spec_(spec) {
        frames_.fill(start);
    }

    /// The tracker takes a picture; the oldest of those under way arrives, and the next comes after `ticks`.
    void frame(const DeviceSample& wish, int ticks, Random& random) {
        follower_.aim(frames_[next_], ticks - 1);
        DeviceReading& seen = frames_[next_];
        seen.handle = handle_of(wish);
        for (int i = 0; i < 3; ++i) seen.handle[i] += pose_noise * random.normal();
        seen.roll = device_angle_unit * wish.roll + angle_noise * random.normal();
        seen.jaw = device_angle_unit * wish.jaw;
        if (spec_ == nullptr) seen.jaw += angle_noise * random.normal();  // the turn of the camera head
        const bool closed =
            spec_ != nullptr && jaws_press(spec_->kind) && seen.jaw < closed_jaws * spec_->jaw_opening;
        seen.grip = closed ? spec_->grip_force : 0;
        seen.buttons = wish.buttons;
        next_ = (next_ + 1) % frames_.size();
    }
    DeviceSample tick() { return follower_.tick(); }

  private:
    std::array<DeviceReading, frames_late> frames_;
    std::size_t next_ = 0;
    HandleFollower follower_;
    const InstrumentSpec* spec_ = nullptr;
};

class TrackedModel : public ObservingRig {
  public:
    TrackedModel(std::unique_ptr<ObservingRig> hands, const Scene& scene, std::uint64_t attempt)
        : hands_(std::move(hands)),
          specs_(scene.instruments),
          ticks_a_frame_(1 / (frames_a_second * scene.tick_period())),
          random_(attempt, noise_stream) {
        for (const InstrumentSpec& spec : specs_) {
            const auto h = static_cast<std::size_t>(spec.hand);
            const DeviceReading start = start_reading(spec.trocar.shaft_length, spec.start_insertion,
                                                      spec.jaw_opening * open_jaw_share);
            handles_[h] = TrackedHandle(start, &spec);
            exists_[h] = true;
            wish_.hand[h] = quantise(start, wish_.hand[h]);
        }
        if (!scene.camera) return;
        has_scope_ = true;
        const DeviceReading start =
            start_reading(scene.camera->trocar.shaft_length, scene.camera->start_insertion, 0);
        scope_ = TrackedHandle(start, nullptr);
        wish_.camera = quantise(start, wish_.camera);
    }

    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        hands_->observe(world, display);
    }

    void read(std::uint32_t tick, RigSample& sample) override {
        hands_->read(tick, wish_);
        const double frame = std::ceil(tick / ticks_a_frame_);
        if (frame * ticks_a_frame_ < tick + 1.0) {
            const int next = static_cast<int>(std::floor((frame + 1) * ticks_a_frame_) - tick);
            for (std::size_t h = 0; h < hand_count; ++h)
                if (exists_[h]) handles_[h].frame(wish_.hand[h], next, random_);
            if (has_scope_) scope_.frame(wish_.camera, next, random_);
        }
        for (std::size_t h = 0; h < hand_count; ++h)
            if (exists_[h]) sample.hand[h] = handles_[h].tick();
        sample.camera = has_scope_ ? scope_.tick() : wish_.camera;
    }

    void write_force(Hand /*hand*/, const Vector3& /*force*/) override {}
    bool has_force(Hand /*hand*/) const override { return false; }
    double damping(Hand /*hand*/) const override { return -1; }

  private:
    std::unique_ptr<ObservingRig> hands_;
    std::vector<InstrumentSpec> specs_;
    std::array<TrackedHandle, hand_count> handles_;
    std::array<bool, hand_count> exists_ = {false, false};
    TrackedHandle scope_;
    bool has_scope_ = false;
    double ticks_a_frame_;
    RigSample wish_;
    Random random_;
};

}  // namespace

std::unique_ptr<ObservingRig> make_tracked_model(std::unique_ptr<ObservingRig> hands, const Scene& scene,
                                                 std::uint64_t attempt) {
    return std::make_unique<TrackedModel>(std::move(hands), scene, attempt);
}

}  // namespace fulcrum
