// SPDX-License-Identifier: Apache-2.0
// Each sound by its spectrum, level and beginning; the limits of what comes out, whatever goes in.
#include "sim_core/sound/synthesiser.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

constexpr int sound_block = 256;

class Sounds : public ::testing::Test {
  protected:
    Sounds() {
        state.volume = 1;
        play(0.01);
    }
    /// Left and right of the next seconds.
    const std::vector<float>& play(double seconds) {
        for (auto& one : side) one.clear();
        float block[2 * sound_block];
        for (int left = static_cast<int>(seconds * sound_rate); left > 0; left -= sound_block) {
            const int frames = std::min(left, sound_block);
            maker.fill(state, block, frames);
            for (int i = 0; i < frames; ++i)
                for (int s = 0; s < 2; ++s) side[s].push_back(block[2 * i + s]);
        }
        return side[0];
    }
    static double peak(const std::vector<float>& samples) {
        double largest = 0;
        for (const float one : samples) largest = std::max(largest, std::abs(static_cast<double>(one)));
        return largest;
    }
    /// Amplitude at one frequency (Hz).
    static double at(const std::vector<float>& samples, double frequency) {
        double cosine = 0, sine = 0;
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const double angle = 2 * 3.14159265358979 * frequency * static_cast<double>(i) / sound_rate;
            cosine += samples[i] * std::cos(angle);
            sine += samples[i] * std::sin(angle);
        }
        return 2 * std::hypot(cosine, sine) / static_cast<double>(samples.size());
    }
    static double loudest(const std::vector<float>& samples, double from, double to) {
        double best = 0, found = 0;
        for (double frequency = from; frequency <= to; frequency += 10)
            if (at(samples, frequency) > best) {
                best = at(samples, frequency);
                found = frequency;
            }
        return found;
    }
    /// Largest step from a sample to the next.
    static double steepest(const std::vector<float>& samples) {
        double step = 0;
        for (std::size_t i = 1; i < samples.size(); ++i)
            step = std::max(step, std::abs(static_cast<double>(samples[i]) - samples[i - 1]));
        return step;
    }
    SoundState state;
    Synthesiser maker;
    std::vector<float> side[2];
};

TEST_F(Sounds, WithoutAReasonThereIsSilence) {
    EXPECT_EQ(peak(play(1)), 0);
    EXPECT_EQ(peak(side[1]), 0);
}

TEST_F(Sounds, AContactClicksInTheFirstSampleOnItsSideAndFadesAway) {
    double before = 0;
    for (const double strength : {0.0, 0.3, 1.0}) {
        ++state.contacts[0];
        state.strength[0] = strength;
        play(0.05);
        EXPECT_NE(side[0].front(), 0) << "it begins with the first sample after the contact";
        EXPECT_GT(peak(side[0]), 1.2 * before) << "louder for a harder contact";
        EXPECT_NEAR(peak(side[1]), 0.35 * peak(side[0]), 0.01) << "heard on its side";
        before = peak(side[0]);
        EXPECT_NEAR(loudest(side[0], 100, 2000), 330, 60) << "tissue";
        EXPECT_LT(steepest(side[0]), 0.1) << "no step";
        play(0.3);
        EXPECT_EQ(side[0].back(), 0);
    }
    ++state.contacts[1];
    state.hard[1] = 1;
    play(0.05);
    EXPECT_GT(peak(side[1]), peak(side[0]));
    EXPECT_NEAR(loudest(side[1], 100, 2000), 1100, 60) << "no tissue with a limit";
    EXPECT_EQ(peak(play(0.5)) > 0.01, false) << "one contact, one click";
}

TEST_F(Sounds, ContactsInQuickSuccessionDoNotCrackle) {
    state.strength[0] = 1;
    for (int i = 0; i < 40; ++i) {
        ++state.contacts[0];
        state.hard[0] = i % 2 == 0 ? 1 : 0;
        play(0.004);
        EXPECT_LT(steepest(side[0]), 0.12) << i;
    }
}

TEST_F(Sounds, ToneOfTooMuchForceRisesWithTheExcess) {
    double height = 0, loud = 0;
    for (const double excess : {0.01, 0.5, 1.0, 30.0}) {
        state.excess[1] = excess;
        play(0.2);  // the pitch slides
        play(0.2);
        const double now = loudest(side[1], 400, 1500);
        EXPECT_NEAR(now, 520 + 520 * std::min(1.0, excess), 10) << excess;
        EXPECT_GE(now, height);
        EXPECT_GE(peak(side[1]), loud - 0.001);
        EXPECT_GT(peak(side[1]), 2 * peak(side[0]));
        height = now;
        loud = peak(side[1]);
    }
    state.excess[1] = 0;
    play(0.1);
    EXPECT_LT(steepest(side[1]), 0.05) << "it ends without a crack";
    EXPECT_EQ(peak(play(0.1)), 0);
}

TEST_F(Sounds, EnergyHumsWhileItIsOn) {
    state.energy[0] = 1;
    play(0.2);
    EXPECT_LT(steepest(side[0]), 0.01);
    play(0.5);
    EXPECT_EQ(loudest(side[0], 20, 1000), 100);
    EXPECT_GT(at(side[0], 300), 0.02) << "a buzz, no pure tone";
    EXPECT_GT(peak(side[0]), 0.05);
    state.energy[0] = 0;
    play(0.2);
    EXPECT_EQ(peak(play(0.1)), 0);
}

TEST_F(Sounds, BleedingGivesTwoTonesOnceASecondUntilItStops) {
    state.bleeding = 1;
    for (int second = 0; second < 2; ++second) {
        EXPECT_NEAR(loudest(play(0.15), 800, 2000), 1480, 15) << second;
        EXPECT_NEAR(loudest(play(0.15), 800, 2000), 1110, 15) << second;
        play(0.1);
        EXPECT_LT(peak(play(0.6)), 1e-4) << second;
    }
    play(0.05);
    state.bleeding = 0;
    play(0.1);
    EXPECT_LT(steepest(side[0]), 0.1);
    EXPECT_EQ(peak(play(1)), 0);
}

TEST_F(Sounds, VolumeSetsTheLevelAndNoneIsSilence) {
    state.energy[0] = state.energy[1] = 1;
    play(0.2);
    const double full = peak(play(0.1));
    state.volume = 0.5;
    play(0.2);
    EXPECT_LT(steepest(side[0]), 0.02) << "moved during a sound";
    EXPECT_NEAR(peak(play(0.1)), full / 4, 0.02 * full);
    state.volume = 0;
    play(0.2);
    EXPECT_EQ(peak(play(0.1)), 0);
}

TEST_F(Sounds, ATestPlaysEverySoundOnceAndEnds) {
    ++state.tests;
    EXPECT_GT(peak(play(0.2)), 0.1);
    EXPECT_GT(peak(side[0]), 2 * peak(side[1]));
    play(0.2);
    EXPECT_GT(peak(side[1]), 2 * peak(side[0]));
    play(0.1);
    play(0.3);
    EXPECT_GT(loudest(side[0], 400, 1500), 500);
    play(0.25);
    EXPECT_EQ(loudest(play(0.2), 20, 400), 100);
    play(0.3);
    EXPECT_GT(peak(play(0.2)), 0.2) << "bleeding";
    play(0.5);
    EXPECT_EQ(peak(play(0.5)), 0);
}

TEST_F(Sounds, WhateverGoesInEverySampleIsANumberWithinOne) {
    const double worst[] = {std::nan(""), std::numeric_limits<double>::infinity(), -1e300, 1e300, 1e-310, 1};
    for (const double bad : worst) {
        state = {};
        state.volume = std::isnan(bad) ? 1 : bad;
        for (int h = 0; h < 2; ++h) {
            state.contacts[h] = static_cast<std::uint64_t>(1 + h);
            state.strength[h] = state.excess[h] = bad;
            state.energy[h] = state.bleeding = ~std::uint64_t{0};
        }
        state.tests += 1;
        for (int i = 0; i < 30; ++i) {
            ++state.contacts[i % 2];
            play(0.02);
            for (const auto& one : side)
                for (const float sample : one) {
                    ASSERT_TRUE(std::isfinite(sample)) << bad;
                    ASSERT_LE(std::abs(sample), 1) << bad;
                    ASSERT_TRUE(sample == 0 || std::isnormal(sample)) << bad;
                }
        }
    }
    state = {};
    state.volume = 1;
    play(0.5);
    play(2);
    EXPECT_EQ(peak(play(0.5)), 0) << "and it ends";
    maker.fill(state, nullptr, 100);
    maker.fill(state, nullptr, -1);
}

TEST_F(Sounds, TheSameStatesGiveTheSameSamplesInBlocksOfAnySize) {
    Synthesiser one, other;
    std::vector<float> a(2 * 4800), b(2 * 4800);
    SoundState quiet;
    quiet.volume = 0.7;
    one.fill(quiet, a.data(), 10);
    other.fill(quiet, b.data(), 10);
    SoundState loud = quiet;
    loud.contacts[0] = loud.tests = 1;
    loud.strength[0] = 0.4;
    loud.excess[1] = 0.2;
    loud.energy[0] = loud.bleeding = 1;
    one.fill(loud, a.data(), 4800);
    for (int i = 0; i < 4800; i += 480) other.fill(loud, b.data() + 2 * i, 480);
    EXPECT_EQ(a, b);
}

TEST_F(Sounds, WhatWasCountedBeforeTheFirstBlockIsNotHeard) {
    Synthesiser late;
    SoundState old;
    old.volume = 1;
    old.contacts[0] = 7;
    old.tests = 3;
    std::vector<float> samples(2 * 4800);
    late.fill(old, samples.data(), 4800);
    EXPECT_EQ(peak(samples), 0);
}

TEST_F(Sounds, FillingAllocatesNothing) {
    state.energy[0] = state.bleeding = 1;
    ++state.contacts[0];
    float block[2 * sound_block];
    EXPECT_EQ(test::allocations_in([&] {
                  for (int i = 0; i < 20; ++i) maker.fill(state, block, sound_block);
              }),
              0U);
}

}  // namespace
}  // namespace fulcrum
