// SPDX-License-Identifier: Apache-2.0
#include "assessment/operators/limb.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double two_pi = 6.283185307179586;
constexpr double shortest_s = 0.18;    // no sub-movement is faster
constexpr double jaw_rate = 3.0;       // rad/s
constexpr double grip_rate = 20.0;     // N/s
constexpr double path_time_s = 0.07;   // correlation time of the noise on the way
constexpr double path_return_s = 0.5;  // how fast its trace fades
constexpr double drift_time_s = 0.8;
constexpr double path_smooth_s = 0.03, drift_smooth_s = 0.15;
// What the second low-pass takes from the drift's strength, given back: sqrt(1 + drift_smooth / drift_time).
constexpr double drift_gain = 1.0897247358851685;

// Flash and Hogan 1985: share of the displacement at share t of the duration.
double minimum_jerk(double t) {
    if (t <= 0) return 0;
    if (t >= 1) return 1;
    return t * t * t * (10 + t * (-15 + 6 * t));
}
double minimum_jerk_rate(double t) {
    return t <= 0 || t >= 1 ? 0 : 30 * t * t * (1 - t) * (1 - t);
}

Vector3 normal_vector(Random& random) {
    const double x = random.normal(), y = random.normal(), z = random.normal();
    return {x, y, z};
}

}  // namespace

Limb::Limb(const Skill& skill, const InstrumentSpec& spec, double tick_period, const Random& random)
    : skill_(skill), spec_(spec), trocar_(make_trocar(spec.trocar)), period_(tick_period), random_(random) {
    settled_ = planned_ = trocar_.position + trocar_.rotation.col(2) * spec.start_insertion;
    for (std::size_t i = 0; i < 3; ++i) {
        phase_[i] = random_.uniform(0, two_pi);
        frequency_[i] = random_.uniform(8.5, 11.5);
        loudness_[i] = 1;
    }
}

Vector3 Limb::destination() const noexcept {
    Vector3 end = settled_;
    for (int i = 0; i < count_; ++i) end += movements_[static_cast<std::size_t>(i)].displacement;
    return end;
}

void Limb::add(const SubMovement& movement) noexcept {
    if (count_ == static_cast<int>(movements_.size()))
        return;  // six at once: the arm is busy, the wish is lost and made again
    movements_[static_cast<std::size_t>(count_++)] = movement;
    end_time_ = std::max(end_time_, movement.start + movement.duration);
}

void Limb::reach(const Vector3& displacement, double width, double slowness) noexcept {
    const double distance = displacement.norm();
    if (distance <= 0) return;
    const double gain = skill_.gain + skill_.gain_spread * random_.normal();
    SubMovement movement;
    movement.displacement = std::clamp(gain, 0.3, 1.5) * displacement +
                            steadiness_ * skill_.endpoint_noise * distance * 0.577 * normal_vector(random_);
    movement.start = time_;
    // Fitts: time grows with the logarithm of distance over width.
    const double difficulty = math::log(1 + distance / std::max(width, 1e-4)) / 0.6931471805599453;
    movement.duration = std::max(shortest_s, skill_.duration_scale * slowness * (0.14 + 0.19 * difficulty));
    add(movement);
}

void Limb::carry(const Vector3& displacement, double duration) noexcept {
    // A hesitant hand moves in pieces, each a movement of its own, with short halts between.
    const int pieces = 1 + static_cast<int>(skill_.hesitation * random_.uniform(0.6, 1.4) + 0.5);
    double start = time_;
    for (int i = 0; i < pieces; ++i) {
        SubMovement movement;
        movement.start = start;
        movement.duration = std::max(duration / pieces, shortest_s);
        movement.displacement = displacement / pieces;
        add(movement);
        start += movement.duration * (pieces > 1 ? random_.uniform(0.7, 1.2) : 1.0);
    }
}

void Limb::stop() noexcept {
    // What is left undone is taken back by a short opposite movement, as an arm brakes.
    Vector3 undone = Vector3::Zero();
    for (int i = 0; i < count_; ++i) {
        const SubMovement& movement = movements_[static_cast<std::size_t>(i)];
        undone += (1 - minimum_jerk((time_ - movement.start) / movement.duration)) * movement.displacement;
    }
    // Coast a little: half of what the fastest sub-movement would still do in 0.1 s.
    const Vector3 here = destination() - undone;
    count_ = 0;
    settled_ = here;
    end_time_ = time_;
    const Vector3 coast = 0.1 * undone;
    const double length = coast.norm();
    add({time_, shortest_s, length > 0.002 ? Vector3(coast * (0.002 / length)) : coast});
}

Vector3 Limb::wandering(const Vector3& value, double time, double strength) noexcept {
    const double keep = 1 - period_ / time;
    return keep * value + strength * std::sqrt(1 - keep * keep) * normal_vector(random_);
}

void Limb::tick() noexcept {
    time_ += period_;
    planned_ = settled_;
    Vector3 velocity = Vector3::Zero();
    for (int i = 0; i < count_;) {
        const SubMovement& movement = movements_[static_cast<std::size_t>(i)];
        const double t = (time_ - movement.start) / movement.duration;
        if (t >= 1) {
            settled_ += movement.displacement;
            planned_ += movement.displacement;
            for (int j = i + 1; j < count_; ++j)
                movements_[static_cast<std::size_t>(j - 1)] = movements_[static_cast<std::size_t>(j)];
            --count_;
            continue;
        }
        planned_ += minimum_jerk(t) * movement.displacement;
        velocity += minimum_jerk_rate(t) / movement.duration * movement.displacement;
        ++i;
    }
    const double speed = velocity.norm();

    // Signal-dependent noise: a velocity error that is as large as the movement is fast, slowly changing, its
    // trace fading. Each noise passes a second low-pass, so that the velocity itself is continuous.
    path_raw_ = wandering(path_raw_, path_time_s, 1.0);
    path_velocity_ += period_ / path_smooth_s * (path_raw_ - path_velocity_);
    path_ += period_ * (steadiness_ * skill_.path_noise * speed * path_velocity_ - path_ / path_return_s);
    drift_raw_ = wandering(drift_raw_, drift_time_s, skill_.drift * drift_gain);
    drift_ += period_ / drift_smooth_s * (drift_raw_ - drift_);
    Vector3 tremor;
    for (std::size_t i = 0; i < 3; ++i) {
        frequency_[i] = std::clamp(frequency_[i] + 0.03 * random_.normal(), 8.0, 12.0);
        loudness_[i] = std::clamp(loudness_[i] + 0.01 * random_.normal(), 0.5, 1.5);
        phase_[i] += two_pi * frequency_[i] * period_;
        if (phase_[i] > two_pi) phase_[i] -= two_pi;
        tremor[static_cast<Eigen::Index>(i)] =
            1.41421356 * skill_.tremor * loudness_[i] * math::sin(phase_[i]);
    }
    wander_ = path_ + drift_ + tremor;

    const auto towards = [&](double value, double wish, double rate) {
        const double step = rate * period_;
        return value + std::clamp(wish - value, -step, step);
    };
    jaw_ = towards(jaw_, jaw_wish_, jaw_rate);
    grip_ = towards(grip_, grip_wish_, grip_rate);
}

DeviceSample Limb::sample() noexcept {
    DeviceReading reading;
    reading.handle = handle_for_tip(trocar_, tip());
    reading.jaw = jaw_;
    reading.grip = grip_;
    reading.buttons = static_cast<std::uint16_t>((pressed_ ? button_primary : button_none) | buttons_);
    last_ = quantise(reading, last_);
    return last_;
}

void Reach::start(Limb& limb, const Vector3& goal, const Vector3& view, double width, double delay,
                  double patience) noexcept {
    goal_ = goal;
    misjudged_ = skill_.depth_error * limb.random().normal() * view;
    width_ = width;
    tolerance_ = patience * skill_.tolerance;
    corrections_ = 0;
    arrived_ = false;
    first_ = true;
    next_ = limb.time() + delay;
}

void Reach::update(Limb& limb, const Vector3& seen) noexcept {
    if (limb.time() < next_) return;
    const double gap = skill_.gap_s;
    if (!first_ && limb.remaining() > std::max(0.0, -gap)) return;
    // Overlapping corrections trust the plan (a forward model); a hand that has stopped trusts the eye.
    const bool looking = gap > 0 || limb.remaining() < -skill_.reaction_s;
    const Vector3 here = looking && !first_ ? seen : limb.destination();
    if (!first_) misjudged_ *= 0.4;  // each look at the tip next to the goal corrects the depth
    const Vector3 error = goal_ + misjudged_ - here;
    const double distance = error.norm();
    if (!first_ && distance < tolerance_ + misjudged_.norm()) {
        arrived_ = misjudged_.norm() < tolerance_ && limb.remaining() <= 0;
        next_ = limb.time() + skill_.reaction_s;
        return;
    }
    arrived_ = false;
    limb.reach(error, width_);
    if (!first_) ++corrections_;
    first_ = false;
    // The next look: when this sub-movement ends, sooner for who overlaps, never before a reaction time has
    // passed.
    const double pause = gap + skill_.gap_spread_s * limb.random().normal();
    next_ = limb.time() + std::max(skill_.reaction_s, limb.remaining() + pause);
}

}  // namespace fulcrum
