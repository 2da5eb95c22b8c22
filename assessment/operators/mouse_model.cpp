// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "assessment/operators/device_models.h"
#include "sim_core/instrument/mouse_mapping.h"
#include "sim_core/scene/instrument_type.h"

namespace fulcrum {
namespace {

constexpr double event_period = 1.0 / 60;  // s
constexpr double change_time = 0.25;       // s, the other hand's key is found and pressed
constexpr double notch_time = 0.05;        // s, between two notches of the wheel
constexpr double near_enough = 0.6e-3;     // m of the handle: the hand has no reason to move
constexpr double furthest_ahead = 6e-3;    // m of the handle
constexpr double closed_share = 0.3;       // of the opening: narrower jaws are meant to be closed

class MouseModel : public ObservingRig {
  public:
    MouseModel(std::unique_ptr<ObservingRig> hands, const Scene& scene)
        : hands_(std::move(hands)),
          period_(scene.tick_period()),
          event_ticks_(static_cast<std::uint32_t>(std::max(1L, std::lround(event_period / period_)))) {
        for (const InstrumentSpec& spec : scene.instruments) {
            Arm& arm = arms_[static_cast<std::size_t>(spec.hand)];
            arm.exists = true;
            arm.spec = spec;
            arm.trocar = make_trocar(spec.trocar);
            arm.target = start_reading(spec.trocar.shaft_length, spec.start_insertion,
                                       spec.jaw_opening * open_jaw_share);
            arm.follower = HandleFollower(arm.target);
            DeviceSample& wish = wish_.hand[static_cast<std::size_t>(spec.hand)];
            wish = quantise(arm.target, wish);
        }
        if (!arms_[1].exists) active_ = 0;
        if (!scene.camera) return;
        scope_ = make_scope(*scene.camera);
        has_scope_ = true;
        scope_alone_ = scene.instruments.empty();
        camera_ = start_reading(scene.camera->trocar.shaft_length, scene.camera->start_insertion, 0);
        camera_follower_ = HandleFollower(camera_);
        if (scope_alone_) wish_.camera = quantise(camera_, wish_.camera);
    }

    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        hands_->observe(world, display);
    }

    void read(std::uint32_t tick, RigSample& sample) override {
        // Nobody plans further ahead than the device follows.
        if (std::max({error_of(0), error_of(1), error_of_scope()}) <= furthest_ahead)
            hands_->read(tick, wish_);
        if (tick % event_ticks_ == 0) handle_events(sample.camera);
        for (std::size_t h = 0; h < hand_count; ++h)
            if (arms_[h].exists) sample.hand[h] = arms_[h].follower.tick();
        sample.camera = has_scope_ ? camera_follower_.tick() : wish_.camera;
    }

    void write_force(Hand /*hand*/, const Vector3& /*force*/) override {}
    bool has_force(Hand /*hand*/) const override { return false; }
    double damping(Hand /*hand*/) const override { return -1; }

  private:
    struct Arm {
        bool exists = false;
        InstrumentSpec spec;
        Trocar trocar;
        DeviceReading target;
        HandleFollower follower;
    };

    double error_of(std::size_t h) const {
        return arms_[h].exists ? (handle_of(wish_.hand[h]) - arms_[h].target.handle).norm() : 0;
    }

    /// Where the mouse moves the scope itself; 0 in other scenes.
    double error_of_scope() const {
        return scope_alone_ ? (handle_of(wish_.camera) - camera_.handle).norm() : 0;
    }

    /// What a person does between two frames of the screen.
    void handle_events(const DeviceSample& scope_sample) {
        const double dt = event_ticks_ * period_;
        since_notch_ += dt;
        const std::size_t other = 1 - active_;
        const bool pedal = (wish_.hand[other].buttons & (button_energy | button_exchange)) != 0;
        if (changing_ <= 0 && arms_[other].exists &&
            (pedal || (error_of(other) > near_enough && error_of(other) > 1.5 * error_of(active_)))) {
            active_ = other;
            changing_ = change_time;
        }
        changing_ -= dt;
        if (changing_ <= 0 && arms_[active_].exists) steer(dt, scope_sample);
        if (scope_alone_) {
            steer_scope(dt, scope_sample);
        } else {
            move_scope(dt);
        }
        for (std::size_t h = 0; h < hand_count; ++h) {
            if (!arms_[h].exists) continue;
            press(h);
            arms_[h].follower.aim(arms_[h].target, static_cast<int>(event_ticks_) - 1);
        }
        if (has_scope_) camera_follower_.aim(camera_, static_cast<int>(event_ticks_) - 1);
    }

    /// The active hand.
    void steer(double dt, const DeviceSample& scope_sample) {
        Arm& arm = arms_[active_];
        arm.target.roll = device_angle_unit * wish_.hand[active_].roll;
        follow(arm.target, arm.trocar, handle_of(wish_.hand[active_]), dt, scope_sample);
    }

    /// The scope where it is the only instrument: the mouse moves it, keys turn light post and camera head.
    void steer_scope(double dt, const DeviceSample& scope_sample) {
        const auto turn = [&](double& angle, std::int32_t wished) {
            const double off = device_angle_unit * wished - angle, most = key_turn_speed * dt;
            angle += std::clamp(off, -most, most);
        };
        turn(camera_.roll, wish_.camera.roll);
        turn(camera_.jaw, wish_.camera.jaw);
        follow(camera_, scope_.trocar, handle_of(wish_.camera), dt, scope_sample);
    }

    /// Mouse, wheel and insertion keys bring a handle to where it is wanted.
    void follow(DeviceReading& target, const Trocar& trocar, const Vector3& wanted, double dt,
                const DeviceSample& scope_sample) {
        const double deeper = target.handle.norm() - wanted.norm();
        if (std::abs(deeper) >= metres_per_notch) {
            if (since_notch_ >= notch_time) {
                insert_handle(target, trocar, std::copysign(metres_per_notch, deeper));
                since_notch_ = 0;
            }
        } else if (std::abs(deeper) > 0.5 * key_insertion_speed * dt) {
            insert_handle(target, trocar, std::copysign(key_insertion_speed * dt, deeper));
        }
        const Quaternion view = view_of(scope_, has_scope_, scope_sample);
        const std::optional<ScreenStep> step = screen_step(target, trocar, wanted, view);
        if (!step) return;
        const double columns = std::round(step->right / metres_per_pixel),
                     rows = std::round(step->up / metres_per_pixel);
        if (columns == 0 && rows == 0) return;
        shift_handle(target, trocar, view * Vector3(columns * metres_per_pixel, rows * metres_per_pixel, 0));
    }

    /// The button of a hand closes the jaws or works the blade; pedal and exchange belong to the active hand.
    void press(std::size_t h) {
        Arm& arm = arms_[h];
        const DeviceSample& wish = wish_.hand[h];
        const bool closed =
            (wish.buttons & button_primary) != 0 ||
            (jaws_press(arm.spec.kind) && device_angle_unit * wish.jaw < closed_share * arm.spec.jaw_opening);
        arm.target.jaw = closed ? 0 : arm.spec.jaw_opening * open_jaw_share;
        arm.target.grip = closed ? arm.spec.grip_force : 0;
        unsigned buttons = closed ? button_primary : button_none;
        if (h == active_) buttons |= wish.buttons & (button_energy | button_exchange);
        arm.target.buttons = static_cast<std::uint16_t>(buttons);
    }

    void move_scope(double dt) {
        if (!has_scope_) return;
        const Vector3 step = handle_of(wish_.camera) - camera_.handle;
        const double reach = key_camera_speed * dt;
        camera_.handle += step.norm() > reach ? Vector3(step * (reach / step.norm())) : step;
        camera_.roll = device_angle_unit * wish_.camera.roll;
    }

    std::unique_ptr<ObservingRig> hands_;
    double period_;
    std::uint32_t event_ticks_;
    std::array<Arm, hand_count> arms_;
    std::size_t active_ = 1;
    double changing_ = 0, since_notch_ = 1;
    bool has_scope_ = false, scope_alone_ = false;
    ScopeModel scope_;
    DeviceReading camera_;
    HandleFollower camera_follower_;
    RigSample wish_;
};

}  // namespace

std::unique_ptr<ObservingRig> make_mouse_model(std::unique_ptr<ObservingRig> hands, const Scene& scene) {
    return std::make_unique<MouseModel>(std::move(hands), scene);
}

}  // namespace fulcrum
