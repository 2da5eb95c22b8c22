// SPDX-License-Identifier: Apache-2.0
#include "sim_core/haptics/hand_output.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

/// Share of the device's b for Eq. 8: at the bound itself a contact oscillates without end.
constexpr double share_of_damping = 0.8;
constexpr double unexplained = 0.02;  // N in a tick that tissue's own motion and a surface's bends may add
constexpr double motor_time = 10;     // s, time constant of the motors' temperature (provisional)
constexpr double onset_depth =
    0.0005;  // m of depth over which dampers come in (ToolContactModel::onset_depth)

}  // namespace

double largest_eigenvalue(const Matrix3& matrix) {
    if (!matrix.allFinite()) return 0;
    const Eigen::SelfAdjointEigenSolver<Matrix3> solver(matrix, Eigen::EigenvaluesOnly);
    return solver.info() == Eigen::Success ? std::max(0.0, solver.eigenvalues()[2]) : 0.0;
}

void HandOutput::set_device(const std::optional<ForceOutput>& device) {
    device_.reset();
    if (device && is_usable(*device)) device_ = device;
    heat_ = 0;
}

void HandOutput::restart() noexcept {
    const std::optional<ForceOutput> device = device_;
    const double heat = heat_;
    *this = HandOutput(limits_, passivity_control_);
    device_ = device;
    heat_ = heat;
}

/// Velocity of the hand, m/s: zero at first and after an absence.
Vector3 HandOutput::move(const HandTick& tick) noexcept {
    Vector3 velocity = Vector3::Zero();
    if (moved_before_ && tick.connected) velocity = (tick.device - device_before_) / limits_.tick_period;
    device_before_ = tick.device;
    moved_before_ = tick.connected;
    return velocity.allFinite() ? velocity : Vector3(Vector3::Zero());
}

/// The largest force that the motors can give now, N: the peak while they are cool; as their mean load nears
/// what they hold for any time, it falls to that.
double HandOutput::peak_now(double sent) noexcept {
    heat_ += (sent * sent - heat_) * std::min(1.0, limits_.tick_period / motor_time);
    const double peak = std::min(device_->peak, limits_.force);
    const double lasting = std::min(device_->continuous, peak);
    const double lasting2 = lasting * lasting;
    // From half of the lasting load on.
    const double cool = lasting2 > 0 ? std::clamp(2 * (1 - heat_ / lasting2), 0.0, 1.0) : 0.0;
    return std::sqrt(lasting2 + (peak * peak - lasting2) * cool);
}

/// N, by which the force at the hand can have changed by the motion of the hands since the last tick: springs
/// and dampers as they are rendered, and the change of the lever under the load.
double HandOutput::explained(const HandTick& tick, const Matrix3& stiffness, double damping,
                             const Vector3& velocity) noexcept {
    const double moved = (tick.handle - handle_before_).norm();
    const double length = std::max(1e-3, tick.handle.norm());
    const ToolLoad& spring = tick.load.spring;
    const double lever =
        device_->scale * (3 * spring.force.norm() + 2 * spring.moment.norm() / length) / length;
    const double slope = stiffness.trace() + damping * velocity.norm() / onset_depth + lever;
    const double by_motion = std::max(slope, slope_before_) * (moved + tick.carried) +
                             damping * (velocity - velocity_before_).norm();
    handle_before_ = tick.handle;
    slope_before_ = slope;
    velocity_before_ = velocity;
    return by_motion + unexplained;
}

/// Share of the model's force that is rendered, so that the stiffness at the hand is at most `allowed`. One
/// share for all directions keeps the force's potential; it falls at once and rises again, while something is
/// touched, only as far as the hand has put in more than is stored: a share that grew with the lever would
/// give energy.
double HandOutput::share_of_model(double stiffest, double allowed) noexcept {
    const double wanted = allowed < stiffest ? allowed / stiffest : 1.0;
    if (!(stiffest > 0) || wanted <= share_) return share_ = wanted;
    const double stored = share_ > 0 ? 0.5 * sent_before_.squaredNorm() / (share_ * stiffest) : 0.0;
    const double spare = passivity_.stored - stored;
    if (!(spare > 0)) return share_;
    return share_ = stored > 0 ? std::min(wanted, share_ * (1 + spare / stored)) : wanted;
}

/// Where the scene asks for it, and when the contact has ended and only the rest of a jump is sent, the hand
/// gets back no more than it put in.
Vector3 HandOutput::keep_passive(const Vector3& force, const Vector3& velocity, bool touching) noexcept {
    const double period = limits_.tick_period;
    Vector3 sent = force;
    if (passivity_control_ || !touching) {
        sent = passivity_.step(force, velocity, period);
    } else {
        // Tissue that the other hand moves may give energy.
        passivity_.stored = std::max(0.0, passivity_.stored - force.dot(velocity) * period);
    }
    // What was cut does not come back at once.
    safety_.difference += sent - force;
    safety_.sent = sent;
    foreseen_ = sent.dot(velocity) * period;
    sent_before_ = sent;
    return sent;
}

/// The torque follows at the force's slew limit over slew_arm, within the device's limit.
double HandOutput::slew_torque(double wanted, bool live) noexcept {
    const double most = limits_.slew * limits_.tick_period * slew_arm;
    const double target = live ? std::clamp(wanted, -device_->torque, device_->torque) : 0.0;
    torque_sent_ += std::clamp(target - torque_sent_, -most, most);
    return torque_sent_;
}

HandForce HandOutput::step(const HandTick& tick) noexcept {
    HandForce sent;
    const Vector3 velocity = move(tick);
    if (!device_) return sent;
    const double scale = device_->scale;
    const Matrix3 stiffness = scale * tick.load.stiffness.at_hand(tick.handle);
    const double stiffest = largest_eigenvalue(stiffness);
    const double damping = scale * largest_eigenvalue(tick.load.damping.at_hand(tick.handle));
    const PassivityCheck check = check_passivity(std::min(stiffest, device_->stiffness), damping,
                                                 share_of_damping * device_->damping, limits_.tick_period);
    const double keep = damping > 0 ? std::min(1.0, check.damping / damping) : 1.0;
    passivity_.correct(foreseen_, sent_before_.dot(velocity) * limits_.tick_period);
    const double share = scale * share_of_model(stiffest, check.stiffness);
    sent.limited = check.limited || check.stiffness < stiffest;
    sent.stiffness = check.stiffness;
    const auto felt = [&](const SplitLoad& load) {
        const HandLoad spring = load_at_hand(tick.handle, load.spring);
        const HandLoad damper = load_at_hand(tick.handle, load.damper);
        HandLoad sum;
        sum.force = -share * (spring.force + keep * damper.force);
        sum.torque = -share * (spring.torque + keep * damper.torque);
        return sum;
    };
    const HandLoad now = felt(tick.load);
    SafetyInput input;
    input.force = now.force;
    input.model_changed = tick.model_changed;
    if (tick.model_changed) input.old_force = felt(tick.old_load).force;
    input.model_age = tick.model_age;
    input.connected = tick.connected;
    input.explained = explained(tick, share_ * stiffness, keep * damping, velocity);
    SafetyLimits limits = limits_;
    limits.force = peak_now(safety_.sent.norm());
    limits.slew = std::min(limits_.slew, device_->slew);
    const SafetyOutput safe = step_safety(limits, input, safety_);
    sent.flags = safe.flags;
    sent.force = keep_passive(safe.force, velocity, stiffest > 0);
    const bool live = (safe.flags & (safety_stale | safety_not_finite)) == 0 && tick.connected;
    const double ramp =
        limits_.ramp_ticks == 0 ? 1.0 : std::min(1.0, safety_.ramp / static_cast<double>(limits_.ramp_ticks));
    sent.torque = slew_torque(std::isfinite(now.torque) ? ramp * now.torque : 0.0, live);
    return sent;
}

}  // namespace fulcrum
