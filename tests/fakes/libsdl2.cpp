// SPDX-License-Identifier: Apache-2.0
// A library with the functions of SDL 2 that Fulcrum uses, for two controllers that a test scripts
// (fake_sdl.h), and for a sound device. FAKE_SDL_OLD leaves a function of each out.
#include <sys/syscall.h>
#include <time.h>

#include <cmath>
#include <thread>
#include <vector>

#include "tests/fakes/fake_sdl.h"
#include "tests/fakes/mapped_page.h"

namespace {

using fulcrum::test::FakeSdlController;
using fulcrum::test::FakeSdlPage;

fulcrum::test::MappedPage<FakeSdlPage> mapped("FAKE_SDL_PAGE");
std::atomic<long> caller{0};  // the thread between start and end
constexpr std::uint32_t audio = 0x10;

std::int64_t clock_ns() {
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return now.tv_sec * 1'000'000'000LL + now.tv_nsec;
}

/// As SDL_AudioSpec.
struct Spec {
    int rate;
    std::uint16_t format;
    std::uint8_t channels, silence;
    std::uint16_t frames, padding;
    std::uint32_t bytes;
    void (*fill)(void* user, std::uint8_t* bytes, int count);
    void* user;
};

/// The one device that is open; its thread asks for a block as often as a real one plays it.
struct Device {
    Spec spec{};
    std::thread thread;
    std::atomic<bool> stop{false}, paused{true};
    void run(FakeSdlPage* page) {
        std::vector<float> block(static_cast<std::size_t>(spec.frames) * spec.channels);
        const std::int64_t lasts = 1'000'000'000LL * spec.frames / spec.rate;
        std::int64_t next = clock_ns();
        while (!stop) {
            next += lasts;
            if (!paused && page->sound.lost == 0) ask(page, block);
            const std::int64_t left = next - clock_ns();
            if (left > 0) usleep(static_cast<useconds_t>(left / 1000));
        }
    }
    void ask(FakeSdlPage* page, std::vector<float>& block) {
        const std::int64_t asked = clock_ns();
        spec.fill(spec.user, reinterpret_cast<std::uint8_t*>(block.data()),
                  static_cast<int>(block.size() * sizeof(float)));
        fulcrum::test::FakeSound& seen = page->sound;
        std::uint64_t played = 0;
        for (std::size_t i = 0; i < block.size(); ++i) {
            if (!(std::abs(block[i]) <= 1)) ++seen.outside;
            if (block[i] == 0) continue;
            if (played++ == 0 && seen.heard_at == 0) {
                seen.heard_in = static_cast<std::int32_t>(i / spec.channels);
                seen.heard_at = asked;
            }
        }
        seen.played += played;
        ++seen.blocks;
    }
};
Device* device = nullptr;

FakeSdlPage* page() {
    return mapped.get();
}

/// The page, for calls that are allowed between start and end only.
FakeSdlPage* used() {
    while (page()->hang == 1) usleep(500);
    if (caller != syscall(SYS_gettid)) ++page()->misuse;
    return page();
}

FakeSdlController* at(int index) {
    FakeSdlPage* const now = used();
    for (FakeSdlController& one : now->controller)
        if (one.plugged == 1 && index-- == 0) return &one;
    ++now->misuse;
    return &now->controller[0];
}

FakeSdlController* opened(void* controller) {
    auto* const one = static_cast<FakeSdlController*>(controller);
    if (one == nullptr || one->open == 0) ++used()->misuse;
    used();
    return one;
}

}  // namespace

extern "C" {

int SDL_SetHint(const char*, const char*) {
    return 1;
}
int SDL_InitSubSystem(std::uint32_t what) {
    mapped.map();
    if (what == audio) {
        while (page()->sound.hang == 1) usleep(500);
        if (page()->sound.init_fails == 1) return -1;
        ++page()->sound.started;
        return 0;
    }
    if (page()->init_fails == 1) return -1;
    if (caller != 0) ++page()->misuse;
    caller = syscall(SYS_gettid);
    ++page()->started;
    return 0;
}
void SDL_QuitSubSystem(std::uint32_t what) {
    if (what == audio) {
        if (device != nullptr) ++page()->misuse;
        ++page()->sound.ended;
        return;
    }
    ++used()->ended;
    caller = 0;
}
const char* SDL_GetError() {
    if (page()->sound.init_fails == 1) return "no available audio device";
    return page()->init_fails == 1 ? "no udev" : "permission denied";
}
int SDL_JoystickEventState(int state) {
    used();
    return state;
}
int SDL_NumJoysticks() {
    int count = 0;
    for (const FakeSdlController& one : used()->controller) count += one.plugged == 1 ? 1 : 0;
    return count;
}
const char* SDL_JoystickNameForIndex(int index) {
    return at(index)->name;
}
int SDL_IsGameController(int index) {
    return at(index)->known == 1 ? 1 : 0;
}
const char* SDL_GameControllerNameForIndex(int index) {
    return at(index)->name;
}
void* SDL_GameControllerOpen(int index) {
    FakeSdlController* const one = at(index);
    if (one->opens == 0) return nullptr;
    one->open = 1;
    return one;
}
void SDL_GameControllerClose(void* controller) {
    FakeSdlController* const one = opened(controller);
    one->open = 0;
    ++one->closed;
}
int SDL_GameControllerGetAttached(void* controller) {
    return opened(controller)->plugged == 1 ? 1 : 0;
}
void SDL_GameControllerUpdate() {
    ++used()->updates;
}
std::int16_t SDL_GameControllerGetAxis(void* controller, int axis) {
    const FakeSdlController* const one = opened(controller);
    return one->plugged == 1 ? static_cast<std::int16_t>(one->axis[axis].load()) : std::int16_t{0};
}
std::uint8_t SDL_GameControllerGetButton(void* controller, int button) {
    const FakeSdlController* const one = opened(controller);
    return one->plugged == 1 && (one->buttons >> static_cast<unsigned>(button) & 1U) != 0 ? 1 : 0;
}
void* SDL_JoystickOpen(int index) {
    return SDL_GameControllerOpen(index);
}
void SDL_JoystickClose(void* joystick) {
    SDL_GameControllerClose(joystick);
}
int SDL_JoystickGetAttached(void* joystick) {
    return SDL_GameControllerGetAttached(joystick);
}
void SDL_JoystickUpdate() {
    SDL_GameControllerUpdate();
}
int SDL_JoystickNumAxes(void* joystick) {
    return opened(joystick)->axes;
}
std::int16_t SDL_JoystickGetAxis(void* joystick, int axis) {
    if (axis < 0 || axis >= opened(joystick)->axes) ++used()->misuse;
    return SDL_GameControllerGetAxis(joystick, axis);
}
int SDL_JoystickNumButtons(void*) {
    return 12;
}
std::uint8_t SDL_JoystickGetButton(void* joystick, int button) {
    return SDL_GameControllerGetButton(joystick, button);
}
#if !defined(FAKE_SDL_OLD)
int SDL_GameControllerRumble(void* controller, std::uint16_t low, std::uint16_t high,
                             std::uint32_t milliseconds) {
    FakeSdlController* const one = opened(controller);
    if (one->rumble_fails == 1) return -1;
    one->slow = low;
    one->fast = high;
    one->rumble_ms = milliseconds;
    ++one->rumbles;
    if ((low > 0 || high > 0) && one->felt_at == 0) one->felt_at = clock_ns();
    return 0;
}
std::uint32_t SDL_OpenAudioDevice(const char*, int capture, const Spec* asked, Spec* given, int) {
    if (capture != 0 || device != nullptr || page()->sound.started == page()->sound.ended) ++page()->misuse;
    if (page()->sound.opens == 0) return 0;
    device = new Device;
    device->spec = *asked;
    if (given != nullptr) *given = *asked;
    page()->sound.frames = asked->frames;
    page()->sound.open = 1;
    device->thread = std::thread([one = device, seen = page()] { one->run(seen); });
    return 2;
}
#endif
void SDL_PauseAudioDevice(std::uint32_t, int pause) {
    if (device == nullptr) {
        ++page()->misuse;
        return;
    }
    device->paused = pause != 0;
    page()->sound.plays = pause != 0 ? 0 : 1;
}
int SDL_GetAudioDeviceStatus(std::uint32_t) {
    if (device == nullptr || page()->sound.lost == 1) return 0;
    return device->paused ? 2 : 1;
}
void SDL_CloseAudioDevice(std::uint32_t) {
    if (device == nullptr) {
        ++page()->misuse;
        return;
    }
    device->stop = true;
    device->thread.join();
    delete device;
    device = nullptr;
    page()->sound.open = page()->sound.plays = 0;
    ++page()->sound.closed;
}

}  // extern "C"
