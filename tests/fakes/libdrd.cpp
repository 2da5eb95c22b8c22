// SPDX-License-Identifier: Apache-2.0
// A library with the functions of libdrd that fulcrum-hapticd uses, for two devices that a test scripts
// (fake_force_dimension.h). FAKE_FORCE_DIMENSION_OLD leaves a function out.
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "tests/fakes/fake_force_dimension.h"
#include "tests/fakes/mapped_page.h"

namespace {

using fulcrum::test::FakeForceDimensionDevice;
using fulcrum::test::FakeForceDimensionPage;

fulcrum::test::MappedPage<FakeForceDimensionPage> mapped("FAKE_FORCE_DIMENSION_PAGE");
FakeForceDimensionPage* page() {
    return mapped.get();
}

FakeForceDimensionDevice* device(char id) {
    while (page()->hang == 1) usleep(500);
    if (id >= 0 && id < 2 && page()->device[static_cast<int>(id)].open == 1)
        return &page()->device[static_cast<int>(id)];
    ++page()->misuse;
    return nullptr;
}

constexpr int status_power = 0, status_connected = 1, status_force = 5;

}  // namespace

extern "C" {

int dhdGetDeviceCount() {
    mapped.map();
    std::printf("Force Dimension SDK\n");
    std::fflush(stdout);
    return page()->count;
}
int dhdOpenID(char id) {
    if (id < 0 || id >= page()->count) return -1;
    FakeForceDimensionDevice& one = page()->device[static_cast<int>(id)];
    if (one.opens == 0 || one.open == 1) return -1;
    one.open = 1;
    one.status[status_power] = one.status[status_connected] = 1;
    return id;
}
int dhdClose(char id) {
    FakeForceDimensionDevice* const one = device(id);
    if (one == nullptr) return -1;
    one->open = 0;
    ++one->closed;
    return 0;
}
const char* dhdGetSystemName(char) {
    return "omega.7";
}
int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double (*turn)[3], char id) {
    FakeForceDimensionDevice* const one = device(id);
    if (one == nullptr || one->pose_fails == 1) return -1;
    ++one->ticks;
    *x = one->position[0];
    *y = one->position[1];
    *z = one->position[2];
    const double c = std::cos(one->turn), s = std::sin(one->turn);
    const double d = std::cos(one->tilt), t = std::sin(one->tilt);
    const double made[3][3] = {{d, t * s, t * c}, {0, c, -s}, {-t, d * s, d * c}};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) turn[i][j] = made[i][j];
    return 1;  // time guard: not an error
}
int dhdGetGripperAngleRad(double* angle, char id) {
    FakeForceDimensionDevice* const one = device(id);
    if (one == nullptr || one->has_gripper == 0) return -1;
    *angle = one->gripper;
    return 0;
}
unsigned int dhdGetButtonMask(char id) {
    FakeForceDimensionDevice* const one = device(id);
    return one != nullptr ? one->buttons.load() : 0;
}
int dhdEnableForce(unsigned char on, char id) {
    FakeForceDimensionDevice* const one = device(id);
    if (one == nullptr) return -1;
    one->status[status_force] = on;
    one->enabled += on;
    return 0;
}
int dhdSetForceAndTorqueAndGripperForce(double x, double y, double z, double, double, double, double,
                                        char id) {
    FakeForceDimensionDevice* const one = device(id);
    if (one == nullptr || one->force_fails == 1) return -1;
    const double force[3] = {x, y, z};
    for (int axis = 0; axis < 3; ++axis) one->force[axis] = one->status[status_force] == 1 ? force[axis] : 0;
    return one->saturated == 1 ? 2 : 0;
}
int dhdSetMaxForce(double force, char id) {
    FakeForceDimensionDevice* const one = device(id);
    if (one == nullptr) return -1;
    one->max_force = force;
    return 0;
}
int dhdGetStatus(int* status, char id) {
    FakeForceDimensionDevice* const one = device(id);
    if (one == nullptr) return -1;
    for (int i = 0; i < 17; ++i) status[i] = one->status[i];
    return 0;
}
#if !defined(FAKE_FORCE_DIMENSION_OLD)
const char* dhdErrorGetLastStr() {
    return page()->old_firmware == 1 ? "firmware version is not supported" : "no device found";
}
#endif

}  // extern "C"
