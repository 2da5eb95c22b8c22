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

constexpr double poll_period = 1.0 / 60;  // s
constexpr double fastest = stick_handle_speed;
constexpr int steps_of_stick = 127;       // from the middle to one side
constexpr int dead_steps = 19;            // 15 %: the middle of a stick is not exact
constexpr double thumb_noise = 0.02;      // of a stick's range, standard deviation while it is pushed
constexpr double closing_s = 0.12;        // s in which a thumb means to be there
constexpr double button_s = 0.12;         // s, a shoulder button or the pad is found
constexpr double close_to_goal = 0.6e-3;  // m of the handle: the thumb has no reason to move
constexpr double planned_ahead = 6e-3;    // m of the handle
constexpr double scope_near = 3e-3;       // m of the scope's handle
constexpr double trigger_steps = 255;     // of a trigger
constexpr std::uint64_t thumb_stream = 0x7468756d62;

/// What a stick reports for a wanted share (-1 to 1) of the fastest speed, and the share that it gives.
double stick(double wanted, Random& thumb) {
    if (std::abs(wanted) * (steps_of_stick - dead_steps) < 0.5) return 0;
    const double size = dead_steps + std::min(1.0, std::abs(wanted)) * (steps_of_stick - dead_steps);
    const double pushed = std::round(size + thumb_noise * steps_of_stick * thumb.normal());
    const double beyond = std::clamp(pushed, 0.0, 1.0 * steps_of_stick) - dead_steps;
    return std::copysign(std::max(0.0, beyond) / (steps_of_stick - dead_steps), wanted);
}

/// One hand's instrument, or the scope where it is the only one.
struct Thumb {
    bool exists = false, along = false;  // along: the shoulder button is held
    double busy = 0;                     // s, until the button or the pad is found
    Trocar trocar;
    DeviceReading target;
    HandleFollower follower;

    void start(const TrocarSpec& spec, double insertion, double jaw) {
        exists = true;
        trocar = make_trocar(spec);
        target = start_reading(spec.shaft_length, insertion, jaw);
        follower = HandleFollower(target);
    }
    double error(const DeviceSample& wish) const {
        return exists ? (handle_of(wish) - target.handle).norm() : 0;
    }
    void push(const Vector3& wanted, double dt, const Quaternion& view, Random& random) {
        busy -= dt;
        const double deeper = target.handle.norm() - wanted.norm();
        const Vector3 ray = wanted * (target.handle.norm() / wanted.norm());
        const double across = (ray - target.handle).norm();
        const double here = along ? std::abs(deeper) : across, there = along ? across : std::abs(deeper);
        if (busy <= 0 && there > close_to_goal && there > 1.5 * here) {
            along = !along;
            busy = button_s;
        }
        if (busy > 0) return;
        if (along) {
            if (std::abs(deeper) > 0.5 * close_to_goal)
                insert_handle(target, trocar, stick(deeper / closing_s / fastest, random) * fastest * dt);
            return;
        }
        const std::optional<ScreenStep> step = screen_step(target, trocar, wanted, view);
        if (!step || across <= 0.5 * close_to_goal) return;
        const double size = std::hypot(step->right, step->up);
        const double share = std::min(1.0, size / closing_s / fastest) / size;
        const double across_x = stick(share * step->right, random),
                     across_y = stick(share * step->up, random);
        shift_handle(target, trocar, view * Vector3(across_x * fastest * dt, across_y * fastest * dt, 0));
    }
};

class ControllerModel : public ObservingRig {
  public:
    ControllerModel(std::unique_ptr<ObservingRig> hands, const Scene& scene, std::uint64_t attempt)
        : hands_(std::move(hands)),
          specs_(scene.instruments),
          period_(scene.tick_period()),
          poll_ticks_(static_cast<std::uint32_t>(std::max(1L, std::lround(poll_period / period_)))),
          random_(attempt, thumb_stream) {
        for (const InstrumentSpec& spec : specs_) {
            const auto h = static_cast<std::size_t>(spec.hand);
            thumbs_[h].start(spec.trocar, spec.start_insertion, spec.jaw_opening * open_jaw_share);
            wish_.hand[h] = quantise(thumbs_[h].target, wish_.hand[h]);
        }
        if (!scene.camera) return;
        scope_ = make_scope(*scene.camera);
        camera_.start(scene.camera->trocar, scene.camera->start_insertion, 0);
        wish_.camera = quantise(camera_.target, wish_.camera);
    }

    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        hands_->observe(world, display);
    }

    void read(std::uint32_t tick, RigSample& sample) override {
        // Nobody plans further ahead than the device follows.
        const double behind = std::max(thumbs_[0].error(wish_.hand[0]), thumbs_[1].error(wish_.hand[1]));
        if (std::max(behind, specs_.empty() ? camera_.error(wish_.camera) : 0.0) <= planned_ahead)
            hands_->read(tick, wish_);
        if (tick % poll_ticks_ == 0) poll(sample.camera);
        for (std::size_t h = 0; h < hand_count; ++h)
            if (thumbs_[h].exists) sample.hand[h] = thumbs_[h].follower.tick();
        sample.camera = camera_.exists ? camera_.follower.tick() : wish_.camera;
    }

    void write_force(Hand /*hand*/, const Vector3& /*force*/) override {}
    bool has_force(Hand /*hand*/) const override { return false; }
    double damping(Hand /*hand*/) const override { return -1; }

  private:
    void poll(const DeviceSample& scope_sample) {
        const double dt = poll_ticks_ * period_;
        const Quaternion view = view_of(scope_, camera_.exists, scope_sample);
        const bool pad = !specs_.empty() && camera_.exists && moves_scope(dt);
        for (const InstrumentSpec& spec : specs_) {
            const auto h = static_cast<std::size_t>(spec.hand);
            if (!(pad && h == 0)) thumbs_[h].push(handle_of(wish_.hand[h]), dt, view, random_);
            pull_trigger(spec, thumbs_[h].target, wish_.hand[h]);
            thumbs_[h].follower.aim(thumbs_[h].target, static_cast<int>(poll_ticks_) - 1);
        }
        if (!camera_.exists) return;
        if (specs_.empty()) {
            camera_.push(handle_of(wish_.camera), dt, view, random_);
            turn(camera_.target.roll, wish_.camera.roll, dt);
            turn(camera_.target.jaw, wish_.camera.jaw, dt);
        }
        camera_.follower.aim(camera_.target, static_cast<int>(poll_ticks_) - 1);
    }

    /// The left thumb on the pad, while its own instrument can wait; true while it is there.
    bool moves_scope(double dt) {
        const Vector3 step = handle_of(wish_.camera) - camera_.target.handle;
        const double off = step.norm();
        const bool wanted = off > (on_pad_ ? 0.3 : 1.0) * scope_near;
        const bool waits = thumbs_[0].error(wish_.hand[0]) < 2 * close_to_goal || off > 5 * scope_near;
        if (!(wanted && (on_pad_ || waits))) {
            on_pad_ = false;
            return false;
        }
        if (!on_pad_) camera_.busy = button_s;
        on_pad_ = true;
        camera_.busy -= dt;
        if (camera_.busy > 0) return true;
        const double reach = std::min(off, key_camera_speed * dt);
        camera_.target.handle += (reach / off) * step;
        camera_.target.roll = device_angle_unit * wish_.camera.roll;
        return true;
    }

    /// Light post and camera head: the other stick, full speed or none below a step of it.
    void turn(double& angle, std::int32_t wanted, double dt) {
        const double off = device_angle_unit * wanted - angle;
        angle += stick(off / closing_s / key_turn_speed, random_) * key_turn_speed * dt;
    }

    static void pull_trigger(const InstrumentSpec& spec, DeviceReading& target, const DeviceSample& wish) {
        target.buttons = wish.buttons;
        const double opening = spec.jaw_opening;
        if (!(opening > 0)) return;
        const double grip = device_force_unit * wish.grip, open = device_angle_unit * wish.jaw / opening;
        const double pulled = grip > 0 ? trigger_closed + (1 - trigger_closed) * grip / spec.grip_force
                                       : trigger_closed * (1 - open);
        const double reported = std::round(std::clamp(pulled, 0.0, 1.0) * trigger_steps) / trigger_steps;
        target.jaw = opening * std::max(0.0, 1 - reported / trigger_closed);
        target.grip = spec.grip_force * std::max(0.0, reported - trigger_closed) / (1 - trigger_closed);
    }

    std::unique_ptr<ObservingRig> hands_;
    std::vector<InstrumentSpec> specs_;
    double period_;
    std::uint32_t poll_ticks_;
    std::array<Thumb, hand_count> thumbs_;
    Thumb camera_;
    ScopeModel scope_;
    bool on_pad_ = false;
    RigSample wish_;
    Random random_;
};

}  // namespace

std::unique_ptr<ObservingRig> make_controller_model(std::unique_ptr<ObservingRig> hands, const Scene& scene,
                                                    std::uint64_t attempt) {
    return std::make_unique<ControllerModel>(std::move(hands), scene, attempt);
}

}  // namespace fulcrum
