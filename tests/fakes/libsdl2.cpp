// SPDX-License-Identifier: Apache-2.0
// A library with the functions of SDL 2 that Fulcrum uses, for two controllers that a test scripts
// (fake_sdl.h). FAKE_SDL_OLD leaves a function out.
#include <sys/syscall.h>
#include <time.h>

#include "tests/fakes/fake_sdl.h"
#include "tests/fakes/mapped_page.h"

namespace {

using fulcrum::test::FakeSdlController;
using fulcrum::test::FakeSdlPage;

fulcrum::test::MappedPage<FakeSdlPage> mapped("FAKE_SDL_PAGE");
std::atomic<long> caller{0};  // the thread between start and end

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
int SDL_InitSubSystem(std::uint32_t) {
    mapped.map();
    if (page()->init_fails == 1) return -1;
    if (caller != 0) ++page()->misuse;
    caller = syscall(SYS_gettid);
    ++page()->started;
    return 0;
}
void SDL_QuitSubSystem(std::uint32_t) {
    ++used()->ended;
    caller = 0;
}
const char* SDL_GetError() {
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
#if !defined(FAKE_SDL_OLD)
int SDL_GameControllerRumble(void* controller, std::uint16_t low, std::uint16_t high,
                             std::uint32_t milliseconds) {
    FakeSdlController* const one = opened(controller);
    if (one->rumble_fails == 1) return -1;
    one->slow = low;
    one->fast = high;
    one->rumble_ms = milliseconds;
    ++one->rumbles;
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    one->rumble_time = now.tv_sec * 1'000'000'000LL + now.tv_nsec;
    return 0;
}
#endif

}  // extern "C"
