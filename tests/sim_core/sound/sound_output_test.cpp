// SPDX-License-Identifier: Apache-2.0
// Sound through the real loading of a library: a fake of SDL 2 with every fault, and SDL 2 itself playing
// into nothing.
#include "sim_core/sound/sound_output.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <iostream>

#include "sim_core/controllers/game_controller.h"
#include "sim_core/sound/sdl_sound.h"
#include "sim_core/sound/synthesiser.h"
#include "tests/fakes/fake_page.h"
#include "tests/fakes/fake_sdl.h"
#include "tests/support/built.h"

#define SDL_MAIN_HANDLED
#include <SDL2/SDL.h>

namespace fulcrum {
namespace {

using test::FakePage;
using test::FakeSdlPage;
using test::until;
using test::Variable;

class SoundOutputs : public ::testing::Test {
  protected:
    SoundOutputs() { state.volume = 1; }
    ~SoundOutputs() override {
        EXPECT_EQ(page->misuse, 0U) << "calls that SDL does not allow";
        EXPECT_EQ(sound().outside, 0U);
        EXPECT_EQ(sound().open, 0U) << "closed with the output";
        EXPECT_EQ(sound().started, sound().ended);
    }
    test::FakeSound& sound() { return page->sound; }
    /// Plays the state until the condition holds, as the window does.
    template <typename Condition>
    bool play_until(SoundOutput& output, Condition&& holds) {
        return until([&] {
            output.play(state);
            return holds();
        });
    }
    bool begin(SoundOutput& output) {
        const std::uint64_t before = sound().blocks;
        return play_until(output, [&] { return sound().plays == 1U && sound().blocks > before + 2; });
    }
    FakePage<FakeSdlPage> page{"FAKE_SDL_PAGE"};
    Variable library{"FULCRUM_LIBSDL2", test::fake_library("libSDL2.so")};
    SoundState state;
};

TEST_F(SoundOutputs, ContactIsHeardInTheNextBlockThatTheDeviceAsksFor) {
    SoundOutput output;
    ASSERT_TRUE(begin(output));
    EXPECT_TRUE(output.plays());
    EXPECT_EQ(output.trouble().words(), "");
    EXPECT_EQ(sound().played, 0U) << "silence until then";
    std::int64_t worst = 0;
    for (int contact = 0; contact < 8; ++contact) {
        ASSERT_TRUE(play_until(output, [&, before = sound().played.load()]() mutable {
            const bool same = before == sound().played;  // the click before has ended
            before = sound().played;
            usleep(8000);
            return same;
        }));
        sound().heard_at = 0;
        ++state.contacts[contact % 2];
        state.strength[contact % 2] = 0.5;
        const std::uint64_t blocks = sound().blocks;
        const std::int64_t sent = monotonic_ns();
        output.play(state);
        ASSERT_TRUE(until([&] { return sound().heard_at != 0; }));
        EXPECT_EQ(sound().heard_in, 0) << "in the first frame of the block";
        EXPECT_LE(sound().blocks, blocks + 3);
        worst = std::max(worst, sound().heard_at - sent);
    }
    std::cout << "from the state to the block with its first sample: at most "
              << 1e-6 * static_cast<double>(worst) << " ms; a block is "
              << 1e3 * sound_block_frames / sound_rate << " ms\n";
    EXPECT_EQ(sound().frames, static_cast<std::uint32_t>(sound_block_frames));
}

TEST_F(SoundOutputs, TooMuchForceEnergyAndBleedingAreHeardInTheNextBlockToo) {
    const struct {
        const char* what;
        void (*begin)(SoundState& state);
    } sounds[] = {{"too much force", [](SoundState& now) { now.excess[0] = 0.2; }},
                  {"energy", [](SoundState& now) { now.energy[1] = 1; }},
                  {"bleeding", [](SoundState& now) { now.bleeding = 1; }}};
    SoundOutput output;
    ASSERT_TRUE(begin(output));
    for (const auto& one : sounds) {
        std::int64_t worst = 0;
        for (int time = 0; time < 6; ++time) {
            const SoundState quiet = state;
            ASSERT_TRUE(play_until(output, [&, before = sound().played.load()]() mutable {
                const bool same = before == sound().played;
                before = sound().played;
                usleep(8000);
                return same;
            })) << one.what;
            sound().heard_at = 0;
            one.begin(state);
            const std::uint64_t blocks = sound().blocks;
            const std::int64_t sent = monotonic_ns();
            output.play(state);
            ASSERT_TRUE(until([&] { return sound().heard_at != 0; })) << one.what;
            EXPECT_LE(sound().heard_in, 1) << one.what << ": a wave begins with a sample that is 0";
            EXPECT_LE(sound().blocks, blocks + 3) << one.what;
            worst = std::max(worst, sound().heard_at - sent);
            state = quiet;
            output.play(state);
        }
        std::cout << one.what << ": from the state to the block with its first sample: at most "
                  << 1e-6 * static_cast<double>(worst) << " ms\n";
    }
}

TEST_F(SoundOutputs, WhatLastsEndsByItselfWhenNobodySaysMore) {
    SoundOutput output;
    ASSERT_TRUE(begin(output));
    state.energy[0] = state.bleeding = 1;
    state.excess[1] = 1;
    output.play(state);
    ASSERT_TRUE(until([&] { return sound().played > 0U; }));
    EXPECT_TRUE(until([&] {
        const std::uint64_t before = sound().played, blocks = sound().blocks;
        until([&] { return sound().blocks > blocks + 3; });
        return sound().played == before;
    })) << "a window that hangs does not hum on";
}

TEST_F(SoundOutputs, TheFirstStateOfARestingDeviceIsHeardButNothingOfBefore) {
    SoundState before;
    before.contacts[0] = 3;
    before.tests = 2;
    SoundOutput output(before);
    ASSERT_TRUE(until([&] { return output.plays(); }));
    EXPECT_EQ(sound().plays, 0U) << "at rest until there is something to play";
    before.volume = 1;
    state = before;
    ASSERT_TRUE(begin(output));
    EXPECT_EQ(sound().played, 0U);
    ++state.tests;
    output.play(state);
    EXPECT_TRUE(until([&] { return sound().played > 0U; }));
}

TEST_F(SoundOutputs, ATestThatWakesTheDeviceIsHeard) {
    SoundOutput output;
    ASSERT_TRUE(until([&] { return output.plays(); }));
    ++state.tests;
    output.play(state);
    EXPECT_TRUE(until([&] { return sound().played > 0U; }));
}

TEST_F(SoundOutputs, NoDeviceIsOneReasonAndTheFirstOneThatIsConnectedPlays) {
    sound().init_fails = 1;
    {
        SoundOutput output;
        ASSERT_TRUE(play_until(output, [&] { return !output.trouble().empty(); }));
        EXPECT_EQ(output.trouble().words(),
                  "No sound: no sound device can be used (no available audio device). Connect one, or choose "
                  "one in the settings of the operating system.");
        EXPECT_FALSE(output.plays());
        sound().init_fails = 0;
        EXPECT_TRUE(begin(output));
        EXPECT_TRUE(output.trouble().empty());
    }
    EXPECT_EQ(sound().closed, 1U);
    sound().opens = 0;
    SoundOutput output;
    ASSERT_TRUE(play_until(output, [&] { return !output.trouble().empty(); }));
    EXPECT_NE(output.trouble().words().find("(permission denied)"), std::string::npos);
    EXPECT_EQ(sound().open, 0U);
}

TEST_F(SoundOutputs, ADeviceThatIsLostSaysSoAndPlaysAgainWhenItIsBack) {
    SoundOutput output;
    ASSERT_TRUE(begin(output));
    sound().opens = 0;
    sound().lost = 1;
    ASSERT_TRUE(play_until(output, [&] { return !output.trouble().empty(); }));
    EXPECT_EQ(output.trouble().words(),
              "No sound: the sound device is gone. Connect it again, or another one.");
    EXPECT_FALSE(output.plays());
    sound().lost = 0;
    sound().opens = 1;
    ASSERT_TRUE(begin(output));
    EXPECT_TRUE(output.trouble().empty());
}

TEST_F(SoundOutputs, ALibraryThatIsMissingOrTooOldIsNamed) {
    {
        const Variable none("FULCRUM_LIBSDL2", "libSDL2-not-there.so");
        SoundOutput output;
        output.play(state);
        const std::string why = output.trouble().words();
        EXPECT_EQ(why.rfind("No sound: the library SDL 2 is not installed (libSDL2-not-there.so", 0), 0U)
            << why;
        EXPECT_NE(why.find("To hear it, install the newest libSDL2-2.0.so.0"), std::string::npos) << why;
    }
    const Variable old("FULCRUM_LIBSDL2", test::fake_library("libSDL2_old.so"));
    const SoundOutput output;
    EXPECT_NE(output.trouble().words().find("lacks a function that Fulcrum needs (SDL_OpenAudioDevice)"),
              std::string::npos)
        << output.trouble().words();
}

TEST_F(SoundOutputs, NobodyWaitsForALibraryThatHangsAndAControllerWorksAtTheSameTime) {
    sound().hang = 1;
    const std::int64_t begun = monotonic_ns();
    auto output = std::make_unique<SoundOutput>();
    output->play(state);
    EXPECT_FALSE(output->plays());
    EXPECT_LT(monotonic_ns() - begun, 2'000'000'000);
    sound().hang = 0;
    ASSERT_TRUE(begin(*output));
    page->controller[0].plugged = 1;
    const auto pad = GameController::open();
    state.energy[0] = 1;
    EXPECT_TRUE(play_until(*output, [&] { return sound().played > 1000U && pad->readings().readings > 5; }));
    output.reset();
    EXPECT_TRUE(pad->readings().connected);
}

TEST(SdlSound, DeclaresWhatTheHeaderDoes) {
    using sound::SdlAudioSpec;
    static_assert(sizeof(SdlAudioSpec) == sizeof(SDL_AudioSpec));
    EXPECT_EQ(offsetof(SdlAudioSpec, rate), offsetof(SDL_AudioSpec, freq));
    EXPECT_EQ(offsetof(SdlAudioSpec, format), offsetof(SDL_AudioSpec, format));
    EXPECT_EQ(offsetof(SdlAudioSpec, channels), offsetof(SDL_AudioSpec, channels));
    EXPECT_EQ(offsetof(SdlAudioSpec, frames), offsetof(SDL_AudioSpec, samples));
    EXPECT_EQ(offsetof(SdlAudioSpec, bytes), offsetof(SDL_AudioSpec, size));
    EXPECT_EQ(offsetof(SdlAudioSpec, fill), offsetof(SDL_AudioSpec, callback));
    EXPECT_EQ(offsetof(SdlAudioSpec, user), offsetof(SDL_AudioSpec, userdata));
    EXPECT_EQ(sound::sdl_init_audio, SDL_INIT_AUDIO);
    EXPECT_EQ(sound::sdl_audio_stopped, SDL_AUDIO_STOPPED);
    EXPECT_EQ(sound::sdl_audio_float, AUDIO_F32SYS);
    EXPECT_STREQ(SDL_HINT_AUDIO_DEVICE_APP_NAME, "SDL_AUDIO_DEVICE_APP_NAME");
    static_assert(std::is_same_v<SDL_AudioDeviceID, std::uint32_t>);
    static_assert(std::is_same_v<decltype(&SDL_PauseAudioDevice), decltype(sound::SdlSound::pause)>);
    static_assert(std::is_same_v<decltype(&SDL_CloseAudioDevice), decltype(sound::SdlSound::close)>);
}

TEST(SoundOfSdl, TheLibraryOfThisMachinePlaysIntoNothing) {
    ASSERT_NE(dlopen("libSDL2-2.0.so.0", RTLD_NOW | RTLD_LOCAL), nullptr) << dlerror();
    const Variable driver("SDL_AUDIODRIVER", "dummy");
    SoundOutput output;
    SoundState state;
    state.volume = 1;
    EXPECT_TRUE(until([&] {
        output.play(state);
        return output.plays();
    })) << output.trouble().words();
}

}  // namespace
}  // namespace fulcrum
