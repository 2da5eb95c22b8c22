// SPDX-License-Identifier: Apache-2.0
#include "sim_core/sound/synthesiser.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double nothing = 1e-6;  // a level that is not heard, and far above the smallest normal number

// Levels of full scale at volume 1, and what the other channel gets of a hand's sounds.
constexpr double click_level = 0.5, over_level = 0.25, energy_level = 0.12, alarm_level = 0.3, across = 0.35;
constexpr double soft_click = 330, hard_click = 1100;  // Hz
constexpr double over_lowest = 520, over_rise = 520;   // Hz, for an excess of 100 %
constexpr double hum = 100;                            // Hz
constexpr double alarm_tones[] = {1480, 1110};         // Hz
constexpr int rise_samples = sound_rate / 1000;
const double click_decay = std::exp(-1.0 / (0.012 * sound_rate));
constexpr double gain_share = 1.0 / (0.004 * sound_rate), frequency_share = 1.0 / (0.02 * sound_rate);
constexpr std::int64_t alarm_every = sound_rate, alarm_tone = sound_rate * 15 / 100;

/// 0 to 1; 0 for NaN.
double share_of(double value) noexcept {
    return value > 0 ? std::min(value, 1.0) : 0;
}

double sine(double turns) noexcept {
    return std::sin(2 * pi * turns);
}

/// The same up to 0.7, and never beyond 1.
double limited(double value) noexcept {
    constexpr double knee = 0.7;
    const double size = std::abs(value);
    if (size <= knee) return value;
    return std::copysign(knee + (1 - knee) * std::tanh((size - knee) / (1 - knee)), value);
}

}  // namespace

double Synthesiser::Ramp::step(double share) noexcept {
    now += (target - now) * share;
    if (std::abs(target - now) < nothing) now = target;
    return now;
}

void Synthesiser::Click::start(double strength, bool hard) noexcept {
    const double peak = click_level * (0.2 + 0.8 * share_of(strength));
    if (level == 0) phase = 0;
    frequency = hard ? hard_click : soft_click;
    // From where it is: a second contact does not cut the first one off.
    rising = rise_samples;
    rise = std::max(0.0, peak - level) / rise_samples;
}

double Synthesiser::Click::next() noexcept {
    if (rising > 0) {
        --rising;
        level += rise;
    } else if (level > 0) {
        level *= click_decay;
        if (level < nothing) level = 0;
    }
    if (level == 0) return 0;
    phase += frequency / sound_rate;
    phase -= std::floor(phase);
    return level * (0.75 * sine(phase) + 0.25 * sine(2 * phase));
}

double Synthesiser::Voice::turn() noexcept {
    phase += frequency.step(frequency_share) / sound_rate;
    phase -= std::floor(phase);
    return phase;
}

void Synthesiser::take(const SoundState& state) noexcept {
    const SoundState before = wanted_;
    wanted_ = state;
    volume_.target = share_of(state.volume) * share_of(state.volume);
    if (!known_) volume_.now = volume_.target;
    for (int h = 0; h < 2; ++h)
        if (known_ && state.contacts[h] != before.contacts[h])
            click_[h].start(state.strength[h], state.hard[h] != 0);
    if (known_ && state.tests != before.tests) test_at_ = 0;
    known_ = true;
}

/// Every sound once, over what the attempt asks for.
void Synthesiser::follow_test() noexcept {
    if (test_at_ < 0) return;
    const double at = static_cast<double>(test_at_) / sound_rate;
    const auto between = [at](double from, double to) { return at >= from && at < to; };
    if (test_at_ == 0) click_[0].start(0.6, false);
    if (test_at_ == sound_rate / 4) click_[1].start(0.6, false);
    if (between(0.5, 0.8)) over_[0].gain.target = over_level * 0.75;
    if (between(0.5, 0.8)) over_[0].frequency.target = over_lowest + over_rise * (at - 0.5) / 0.3;
    if (between(1.0, 1.3)) energy_[1].gain.target = energy_level;
    if (between(1.5, 1.8)) alarm_.gain.target = alarm_level;
    if (between(1.5, 1.8)) alarm_.frequency.target = alarm_tones[at < 1.65 ? 0 : 1];
    ++test_at_;
    if (at >= sound_test_lasts) test_at_ = -1;
}

void Synthesiser::follow_alarm() noexcept {
    const bool on = wanted_.bleeding != 0;
    if (on && alarm_at_ < 0) alarm_at_ = 0;
    if (!on) alarm_at_ = -1;
    const bool sounds = on && alarm_at_ < 2 * alarm_tone;
    alarm_.gain.target = sounds ? alarm_level : 0;
    if (sounds) alarm_.frequency.target = alarm_tones[alarm_at_ / alarm_tone];
    if (on) alarm_at_ = (alarm_at_ + 1) % alarm_every;
}

void Synthesiser::mix(float* pair) noexcept {
    for (int h = 0; h < 2; ++h) {
        const bool over = wanted_.excess[h] > 0;
        const double excess = share_of(wanted_.excess[h]);
        over_[h].gain.target = over ? over_level * (0.5 + 0.5 * excess) : 0;
        if (over) over_[h].frequency.target = over_lowest + over_rise * excess;
        energy_[h].gain.target = wanted_.energy[h] != 0 ? energy_level : 0;
        energy_[h].frequency.now = energy_[h].frequency.target = hum;
    }
    follow_alarm();
    follow_test();
    double side[2];
    for (int h = 0; h < 2; ++h) {
        side[h] = click_[h].next();
        Voice& over = over_[h];
        // A tone that begins has its height at once.
        if (over.gain.now == 0) over.frequency.now = over.frequency.target;
        if (over.gain.step(gain_share) > 0) side[h] += over.gain.now * sine(over.turn());
        Voice& energy = energy_[h];
        if (energy.gain.step(gain_share) > 0) {
            const double turn = energy.turn();
            side[h] += energy.gain.now * (0.6 * sine(turn) + 0.3 * sine(3 * turn) + 0.1 * sine(5 * turn));
        }
    }
    if (alarm_.gain.now == 0) alarm_.frequency.now = alarm_.frequency.target;
    const double alarm = alarm_.gain.step(gain_share) > 0 ? alarm_.gain.now * sine(alarm_.turn()) : 0;
    const double volume = volume_.step(gain_share);
    pair[0] = static_cast<float>(limited(volume * (side[0] + across * side[1] + alarm)));
    pair[1] = static_cast<float>(limited(volume * (side[1] + across * side[0] + alarm)));
}

void Synthesiser::fill(const SoundState& state, float* samples, int frames) noexcept {
    if (samples == nullptr || frames <= 0) return;
    take(state);
    for (int i = 0; i < frames; ++i) mix(samples + static_cast<std::ptrdiff_t>(sound_channels) * i);
}

}  // namespace fulcrum
