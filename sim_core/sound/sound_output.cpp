// SPDX-License-Identifier: Apache-2.0
#include "sim_core/sound/sound_output.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "sim_core/controllers/sdl_library.h"
#include "sim_core/devices/device_page.h"
#include "sim_core/devices/shared_latest.h"
#include "sim_core/sound/sdl_sound.h"
#include "sim_core/sound/synthesiser.h"

namespace fulcrum {

using namespace sound;

namespace {

constexpr std::int64_t millisecond = 1000000;  // ns
constexpr std::int64_t old_after = 500 * millisecond, rests_after = 5000 * millisecond;
constexpr std::chrono::milliseconds look_every{100}, first_again{250}, last_again{30000}, ending{3000};

struct PlayedState {
    SoundState state;
    std::int64_t at = 0;  // ns
};

}  // namespace

LibraryLook sound::SdlSound::load() {
    return load_run_time_library(
        "FULCRUM_LIBSDL2", {"libSDL2-2.0.so.0", "libSDL2-2.0.so", "libSDL2.so"},
        {symbol("SDL_SetHint", set_hint), symbol("SDL_InitSubSystem", init),
         symbol("SDL_QuitSubSystem", quit), symbol("SDL_GetError", error),
         symbol("SDL_OpenAudioDevice", open), symbol("SDL_PauseAudioDevice", pause),
         symbol("SDL_GetAudioDeviceStatus", status), symbol("SDL_CloseAudioDevice", close)});
}

struct SoundOutput::Shared {
    SdlSound sdl;
    SharedLatest<PlayedState> newest;
    // Of SDL's thread.
    Synthesiser maker;
    PlayedState played;

    mutable std::mutex mutex;
    std::condition_variable changed;
    bool stop = false, ended = false, plays = false;
    Sentence trouble;
};

/// The thread that opens the device. Only it calls SDL.
class SoundOutput::Keeper {
  public:
    explicit Keeper(Shared& shared) : shared_(shared), sdl_(shared.sdl) {}
    ~Keeper() {
        drop();
        if (!started_) return;
        const std::lock_guard lock(controllers::sdl_start());
        sdl_.quit(sdl_init_audio);
    }
    /// How long until the next one.
    std::chrono::milliseconds look() {
        if (device_ != 0 && sdl_.status(device_) == sdl_audio_stopped) {
            drop();
            report({QT_TRANSLATE_NOOP(
                "errors", "No sound: the sound device is gone. Connect it again, or another one.")});
        }
        if (device_ == 0 && !open()) {
            // Less and less often: some sound systems print a message each time.
            const auto wait = again_;
            again_ = std::min(2 * again_, last_again);
            return wait;
        }
        again_ = first_again;
        rest();
        return look_every;
    }

  private:
    void report(const Sentence& trouble) {
        const std::lock_guard lock(shared_.mutex);
        shared_.plays = trouble.empty();
        shared_.trouble = trouble;
    }
    bool start() {
        const std::lock_guard lock(controllers::sdl_start());
        sdl_.set_hint("SDL_NO_SIGNAL_HANDLERS", "1");
        sdl_.set_hint("SDL_AUDIO_DEVICE_APP_NAME", "Fulcrum");
        started_ = sdl_.init(sdl_init_audio) == 0;
        return started_;
    }
    bool open() {
        SdlAudioSpec asked;
        asked.rate = sound_rate;
        asked.format = sdl_audio_float;
        asked.channels = sound_channels;
        asked.frames = sound_block_frames;
        asked.fill = &SoundOutput::fill;
        asked.user = &shared_;
        // Without permission to change it SDL converts for a device that plays something else.
        if (started_ || start()) device_ = sdl_.open(nullptr, 0, &asked, nullptr, 0);
        if (device_ == 0) {
            const char* const said = sdl_.error();
            const std::string why = said != nullptr ? said : "";
            if (!was_open_)
                report(
                    {QT_TRANSLATE_NOOP("errors",
                                       "No sound: no sound device can be used (%1). Connect one, or choose "
                                       "one in the settings of the operating system."),
                     why});
            return false;
        }
        was_open_ = true;
        rests_ = true;
        report({});
        return true;
    }
    void rest() {
        PlayedState now;
        const bool news = shared_.newest.read(now) && monotonic_ns() - now.at < rests_after;
        if (news != rests_) return;
        rests_ = !news;
        sdl_.pause(device_, rests_ ? 1 : 0);
    }
    void drop() {
        if (device_ != 0) sdl_.close(device_);
        device_ = 0;
    }
    Shared& shared_;
    const SdlSound& sdl_;
    std::uint32_t device_ = 0;
    std::chrono::milliseconds again_ = first_again;
    bool started_ = false, was_open_ = false, rests_ = true;
};

/// SDL's thread.
void SoundOutput::fill(void* shared, std::uint8_t* bytes, int count) {
    auto& one = *static_cast<Shared*>(shared);
    one.newest.read(one.played);
    SoundState state = one.played.state;
    if (monotonic_ns() - one.played.at > old_after) {
        for (int h = 0; h < 2; ++h) state.excess[h] = 0;
        state.energy[0] = state.energy[1] = state.bleeding = 0;
    }
    constexpr int frame = sound_channels * static_cast<int>(sizeof(float));
    // SDL's blocks are aligned for every format.
    one.maker.fill(state, static_cast<float*>(static_cast<void*>(bytes)), count / frame);
}

void SoundOutput::run(const std::shared_ptr<Shared>& shared) {
    {
        Keeper keeper(*shared);
        for (bool stop = false; !stop;) {
            const auto next = keeper.look();
            std::unique_lock lock(shared->mutex);
            shared->changed.wait_for(lock, next, [&] { return shared->stop; });
            stop = shared->stop;
        }
    }
    const std::lock_guard lock(shared->mutex);
    shared->ended = true;
    shared->changed.notify_all();
}

SoundOutput::SoundOutput(const SoundState& before) : shared_(std::make_shared<Shared>()) {
    float unheard[sound_channels];
    shared_->maker.fill(before, unheard, 1);
    shared_->played.state = before;
    const LibraryLook look = shared_->sdl.load();
    if (look.state != LibraryState::ready) {
        shared_->ended = true;
        shared_->trouble = {QT_TRANSLATE_NOOP("errors", "No sound: %1 (%2). To hear it, %3."),
                            Sentence(controllers::sdl_problem(look.state)), look.detail,
                            Sentence(controllers::sdl_hint(look.state))};
        return;
    }
    std::thread([shared = shared_] { run(shared); }).detach();
}

SoundOutput::~SoundOutput() {
    std::unique_lock lock(shared_->mutex);
    shared_->stop = true;
    shared_->changed.notify_all();
    // One that hangs in the library is left alone; its state lives as long as it does.
    shared_->changed.wait_for(lock, ending, [&] { return shared_->ended; });
}

void SoundOutput::play(const SoundState& state) noexcept {
    shared_->newest.write({state, monotonic_ns()});
}

bool SoundOutput::plays() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->plays;
}

Sentence SoundOutput::trouble() const {
    const std::lock_guard lock(shared_->mutex);
    return shared_->trouble;
}

}  // namespace fulcrum
