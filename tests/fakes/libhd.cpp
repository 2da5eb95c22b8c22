// SPDX-License-Identifier: Apache-2.0
// A library with the functions of libHD that fulcrum-hapticd uses, for two devices that a test scripts
// (fake_touch.h). It refuses what the real one refuses: calls outside a frame, a second begin, a force above
// the device's limit. FAKE_TOUCH_OLD leaves a function out.
#include <time.h>
#include <unistd.h>

#include <clocale>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <mutex>
#include <string>
#include <thread>

#include "tests/fakes/fake_touch.h"
#include "tests/fakes/mapped_page.h"

namespace {

using fulcrum::test::FakeTouchDevice;
using fulcrum::test::FakeTouchPage;

struct Error {
    std::uint32_t code;
    std::int32_t internal;
    std::uint32_t device;
};

fulcrum::test::MappedPage<FakeTouchPage> mapped("FAKE_TOUCH_PAGE");
FakeTouchPage* page() {
    return mapped.get();
}

std::mutex guard;
std::deque<Error> errors;
std::uint32_t current = 0xFFFFFFFF;
bool framed[2] = {};
double wanted[2][3] = {};
std::uint32_t (*callback)(void*) = nullptr;
void* callback_data = nullptr;
std::thread scheduler;
std::atomic<bool> runs{false};

void push(std::uint32_t code, std::uint32_t device) {
    const std::lock_guard<std::mutex> lock(guard);
    if (errors.size() < 64) errors.push_back({code, 0, device});
}
void misuse(std::uint32_t code) {
    ++page()->misuse;
    push(code, current);
}
bool is_open(std::uint32_t handle) {
    return handle < 2 && page()->device[handle].open == 1;
}
FakeTouchDevice* device() {
    if (is_open(current)) return &page()->device[current];
    misuse(0x0104);
    return nullptr;
}
std::int64_t now_ns() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * 1000000000LL + time.tv_nsec;
}

void run_scheduler() {
    std::int64_t deadline = now_ns();
    while (runs) {
        deadline += 1'000'000;
        timespec time{};
        time.tv_sec = deadline / 1000000000LL;
        time.tv_nsec = deadline % 1000000000LL;
        clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &time, nullptr);
        if (page()->hang == 0 && callback != nullptr && callback(callback_data) == 0) return;
    }
}

}  // namespace

extern "C" {

std::uint32_t hdInitDevice(const char* name) {
    if (!runs) mapped.map();
    std::printf("DEVELOPER EDITION: commercial distribution is prohibited\n");
    std::fflush(stdout);
    if (page()->of_desktop == 1) std::setlocale(LC_ALL, "");
    char number[16];
    std::snprintf(number, sizeof number, "%.1f", 0.5);
    if (std::strcmp(number, "0.5") != 0) page()->comma = 1;
    ++page()->inits;
    if (runs) misuse(0x0102);
    const std::uint32_t handle = name != nullptr && std::strcmp(name, "Left Device") == 0 ? 0 : 1;
    if (page()->init_errors > 0) {
        --page()->init_errors;
        push(page()->init_error, 0xFFFFFFFF);
        return 0xFFFFFFFF;
    }
    page()->device[handle].open = 1;
    page()->device[handle].enabled = 0;
    current = handle;
    return handle;
}
void hdDisableDevice(std::uint32_t handle) {
    if (runs || !is_open(handle)) {
        misuse(0x0102);
    } else {
        page()->device[handle].open = 0;
        ++page()->closed_in_order;
    }
}
void hdMakeCurrentDevice(std::uint32_t handle) {
    if (!is_open(handle)) misuse(0x0104);
    current = handle;
}
void hdBeginFrame(std::uint32_t handle) {
    hdMakeCurrentDevice(handle);
    if (!is_open(handle)) return;
    if (framed[handle]) misuse(0x0400);
    framed[handle] = true;
}
void hdEndFrame(std::uint32_t handle) {
    if (!is_open(handle)) return;
    if (!framed[handle] || handle != current) misuse(0x0401);
    framed[handle] = false;
    FakeTouchDevice& one = page()->device[handle];
    const double size =
        std::sqrt(wanted[handle][0] * wanted[handle][0] + wanted[handle][1] * wanted[handle][1] +
                  wanted[handle][2] * wanted[handle][2]);
    if (size > one.max_force * (1 + 1e-9)) push(0x0201, handle);
    bool was = false, is = false;
    for (int axis = 0; axis < 3; ++axis) {
        was = was || one.force[axis] != 0;
        one.force[axis] = one.enabled == 1 ? wanted[handle][axis] : 0;
        is = is || one.force[axis] != 0;
        wanted[handle][axis] = 0;
    }
    one.force_time = now_ns();
    if (was && !is) one.zero_time = one.force_time.load();
    if (one.tick_error != 0) push(one.tick_error, handle);
    ++one.frames;
}
void hdEnable(std::uint32_t what) {
    if (FakeTouchDevice* one = device(); one != nullptr && what == 0x4000) one->enabled = 1;
}
void hdGetDoublev(std::uint32_t what, double* values) {
    FakeTouchDevice* const one = device();
    if (one == nullptr) return;
    const bool state = what == 0x2050 || what == 0x2150;
    if (state && !framed[current]) misuse(0x0402);
    for (int axis = 0; state && axis < 3; ++axis)
        values[axis] = what == 0x2050 ? one->position[axis] : one->gimbal[axis];
    if (what == 0x2602) *values = one->max_stiffness;
    if (what == 0x2603) *values = one->max_force;
    if (what == 0x2604) *values = one->continuous_force;
    for (int i = 0; what == 0x2551 && i < 6; ++i) values[i] = one->workspace[i];
    if (what == 0x2505) *values = one->firmware;
    const bool stated =
        what == 0x2551 || what == 0x2505 || what == 0x2602 || what == 0x2603 || what == 0x2604;
    if (!state && !stated) misuse(0x0103);
}
void hdGetIntegerv(std::uint32_t what, std::int32_t* values) {
    FakeTouchDevice* const one = device();
    if (one == nullptr) return;
    if (what == 0x2000 && !framed[current]) misuse(0x0402);
    if (what == 0x2000)
        *values = one->buttons;
    else if (what == 0x2555)
        *values = 4;  // inkwell
    else
        misuse(0x0103);
}
const char* hdGetString(std::uint32_t what) {
    return what == 0x2501 ? "Touch" : what == 0x2502 ? "2023.11.15" : "";
}
void hdSetDoublev(std::uint32_t what, const double* values) {
    if (what != 0x2700 || device() == nullptr || !framed[current]) {
        misuse(0x0402);
        return;
    }
    for (int axis = 0; axis < 3; ++axis) wanted[current][axis] = values[axis];
}
Error hdGetError() {
    const std::lock_guard<std::mutex> lock(guard);
    if (errors.empty()) return {0, 0, 0};
    const Error first = errors.front();
    errors.pop_front();
    return first;
}
const char* hdGetErrorString(std::uint32_t code) {
    if (page()->old_firmware == 1) return "Firmware version is not supported";
    return code == 0x0302 ? "Communication error" : "";
}
std::uint32_t hdCheckCalibration() {
    FakeTouchDevice* const one = device();
    return one != nullptr ? one->calibration.load() : 0x5000;
}
void hdUpdateCalibration(std::uint32_t style) {
    FakeTouchDevice* const one = device();
    if (one == nullptr || style != 4) return;
    ++one->updates;
    if (one->calibration == 0x5001) one->calibration = 0x5000;
}
unsigned long hdScheduleAsynchronous(std::uint32_t (*function)(void*), void* data, std::uint16_t) {
    callback = function;
    callback_data = data;
    return 7;
}
void hdSetSchedulerRate(unsigned long rate) {
    page()->rate = static_cast<std::uint32_t>(rate);
}
void hdStartScheduler() {
    runs = true;
    scheduler = std::thread(run_scheduler);
}
void hdStopScheduler() {
    if (!runs.exchange(false)) misuse(0x0102);
    if (scheduler.joinable()) scheduler.join();
}
#if !defined(FAKE_TOUCH_OLD)
void hdUnschedule(unsigned long handle) {
    if (handle != 7 || runs) misuse(0x0102);
    callback = nullptr;
}
#endif

}  // extern "C"
