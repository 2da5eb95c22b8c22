// SPDX-License-Identifier: Apache-2.0
// A HID joystick as an instrument through its real entry: fulcrum-hapticd loads a fake of SDL 2; and SDL 2
// itself with a virtual joystick that it does not know as a controller.
#include "sim_core/hapticd/joystick_device.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <cmath>

#include "sim_core/devices/daemon_client.h"
#include "sim_core/hapticd/trainer_device.h"
#include "sim_core/numerics/files.h"
#include "sim_core/numerics/input_error.h"
#include "tests/fakes/fake_page.h"
#include "tests/fakes/fake_sdl.h"
#include "tests/support/built.h"
#include "tests/support/own_folder.h"
#include "tests/support/process_rights.h"

#define SDL_MAIN_HANDLED
#include <SDL2/SDL.h>

namespace fulcrum {
namespace {

using test::until;

JoystickMapping right_hand(const char* name) {
    JoystickMapping mapping;
    mapping.name = name;
    JoystickPart& part = mapping.part[1];
    const double least[] = {-0.8, -0.8, 0, -3, 0}, most[] = {0.8, 0.8, 0.2, 3, 1};
    for (int m = 0; m < joystick_motions; ++m) {
        part.motion[m].axis = m;
        part.motion[m].at_low = least[m];
        part.motion[m].at_high = most[m];
        part.motion[m].at_rest = 0.5 * (least[m] + most[m]);
    }
    part.energy = 0;
    part.exchange = 1;
    part.clutch = 2;
    return mapping;
}

class JoystickOfTheDaemon : public ::testing::Test {
  protected:
    JoystickOfTheDaemon() {
        page->controller[0].plugged = 1;
        page->controller[0].known = 0;
        std::snprintf(page->controller[0].name, sizeof page->controller[0].name, "Odd Stick");
        write_whole_file(file, joystick_mapping_text(right_hand("Odd Stick")));
    }
    ~JoystickOfTheDaemon() override { EXPECT_EQ(page->misuse, 0U) << "calls that SDL does not allow"; }
    static DevicePose pose(const DaemonClient& client, int slot = 1) {
        DevicePose newest;
        client.state().pose[slot].read(newest);
        return newest;
    }
    std::string refusal(const std::string& specification) {
        try {
            const DaemonClient client(test::hapticd_program(), specification);
        } catch (const InputError& error) {
            return error.what();
        }
        return {};
    }
    test::FakePage<test::FakeSdlPage> page{"FAKE_SDL_PAGE"};
    test::Variable library{"FULCRUM_LIBSDL2", test::fake_library("libSDL2.so")};
    test::OwnFolder folder;
    const std::string file = (folder.path() / "joystick.json").string();
};

TEST_F(JoystickOfTheDaemon, AnglesMoveTheHandleAsThoseOfATrainerDo) {
    DaemonClient client(test::hapticd_program(), "joystick:" + file);
    EXPECT_EQ(client.facts().kind, "joystick");
    EXPECT_EQ(client.facts().title, "Odd Stick");
    EXPECT_TRUE(client.facts().slot[1] && client.facts().clutch[1]);
    EXPECT_FALSE(client.facts().slot[0] || client.facts().force[1]);
    auto& axes = page->controller[0].axis;
    axes[0] = 32767;
    axes[1] = -16384;
    axes[2] = 0;
    axes[4] = 32767;
    page->controller[0].buttons = 0b110;
    hapticd::TrainerPose wanted;
    wanted.pitch = 0.8;
    wanted.yaw = -0.8 * 16384 / 32767.0;
    wanted.insertion = 0.1;
    const Vector3 place = hapticd::handle_of(wanted, 0.34).position;
    ASSERT_TRUE(until([&] {
        const DevicePose now = pose(client);
        return (Vector3(now.position[0], now.position[1], now.position[2]) - place).norm() < 1e-4;
    }));
    EXPECT_TRUE(test::is_filtered(client.device_process())) << "the thread that reads SDL as well";
    const DevicePose now = pose(client);
    EXPECT_EQ(now.present, 1U);
    EXPECT_EQ(now.jaw, 1);
    EXPECT_EQ(now.buttons, std::uint32_t{button_exchange} | std::uint32_t{button_clutch});
    EXPECT_TRUE(client.message().empty());
}

TEST_F(JoystickOfTheDaemon, RawAxesAreForACalibrationAndComeBackWhole) {
    DaemonClient client(test::hapticd_program(), "joystick:raw,Odd Stick");
    for (int i = 0; i < 6; ++i) page->controller[0].axis[i] = 3000 * (i + 1);
    page->controller[0].buttons = 1U << 5U;
    ASSERT_TRUE(until([&] { return pose(client, 1).buttons != 0 && pose(client, 1).position[0] != 0; }));
    const JoystickReading reading = raw_of(pose(client, 0), pose(client, 1));
    for (int i = 0; i < raw_axes; ++i)
        EXPECT_DOUBLE_EQ(reading.axis[i], i < 6 ? 3000 * (i + 1) / 32767.0 : 0) << i;
    EXPECT_EQ(reading.buttons, 1U << 5U);
}

TEST_F(JoystickOfTheDaemon, UnpluggedOrWithALibraryThatHangsItsHandIsAbsentAndSaysWhatToDo) {
    DaemonClient client(test::hapticd_program(), "joystick:" + file);
    ASSERT_TRUE(until([&] { return pose(client).present == 1; }));
    page->controller[0].plugged = 0;
    ASSERT_TRUE(until([&] {
        client.poll();
        return pose(client).present == 0 && !client.message().empty();
    }));
    page->controller[0].plugged = 1;
    ASSERT_TRUE(until([&] {
        client.poll();
        return pose(client).present == 1 && client.message().empty();
    })) << "opened again";
    page->hang = 1;
    EXPECT_TRUE(until([&] { return pose(client).present == 0; }));
    page->hang = 0;
}

TEST_F(JoystickOfTheDaemon, WhatKeepsItFromOpeningIsNamedWithWhatToDo) {
    EXPECT_NE(refusal("joystick").find("is not calibrated; run `fulcrum devices --calibrate joystick`"),
              std::string::npos);
    EXPECT_NE(refusal("joystick:/nowhere.json").find("/nowhere.json"), std::string::npos);
    page->controller[0].axes = 3;
    EXPECT_NE(refusal("joystick:" + file).find("fewer axes than it was calibrated with"), std::string::npos);
    page->controller[0].axes = 6;
    page->controller[0].opens = 0;
    EXPECT_NE(refusal("joystick:" + file).find("Odd Stick cannot be opened: permission denied"),
              std::string::npos);
    std::snprintf(page->controller[0].name, sizeof page->controller[0].name, "Other");
    EXPECT_NE(refusal("joystick:" + file).find("none of the name Odd Stick is connected"), std::string::npos);
    page->controller[0].plugged = 0;
    EXPECT_NE(refusal("joystick:raw").find("none is connected"), std::string::npos);
    const test::Variable old("FULCRUM_LIBSDL2", "/nowhere/libSDL2.so");
    EXPECT_NE(refusal("joystick:raw").find("SDL 2"), std::string::npos);
}

TEST(JoystickOfSdl, AVirtualOneThatSdlDoesNotKnowAsAControllerIsRead) {
    void* const library = dlopen("libSDL2-2.0.so.0", RTLD_NOW | RTLD_LOCAL);
    ASSERT_NE(library, nullptr) << dlerror();
    const auto function = [library](const char* name) { return dlsym(library, name); };
    const auto init = reinterpret_cast<decltype(&SDL_InitSubSystem)>(function("SDL_InitSubSystem"));
    const auto quit = reinterpret_cast<decltype(&SDL_QuitSubSystem)>(function("SDL_QuitSubSystem"));
    const auto attach =
        reinterpret_cast<decltype(&SDL_JoystickAttachVirtualEx)>(function("SDL_JoystickAttachVirtualEx"));
    const auto detach =
        reinterpret_cast<decltype(&SDL_JoystickDetachVirtual)>(function("SDL_JoystickDetachVirtual"));
    const auto open_stick = reinterpret_cast<decltype(&SDL_JoystickOpen)>(function("SDL_JoystickOpen"));
    const auto known = reinterpret_cast<decltype(&SDL_IsGameController)>(function("SDL_IsGameController"));
    const auto set_axis =
        reinterpret_cast<decltype(&SDL_JoystickSetVirtualAxis)>(function("SDL_JoystickSetVirtualAxis"));
    const auto set_button =
        reinterpret_cast<decltype(&SDL_JoystickSetVirtualButton)>(function("SDL_JoystickSetVirtualButton"));
    ASSERT_NE(attach, nullptr) << "this SDL 2 has no virtual joysticks: install one from 2.24 on";
    ASSERT_EQ(init(SDL_INIT_JOYSTICK), 0);
    SDL_VirtualJoystickDesc description{};
    description.version = SDL_VIRTUAL_JOYSTICK_DESC_VERSION;
    description.type = SDL_JOYSTICK_TYPE_UNKNOWN;
    description.naxes = 7;
    description.nbuttons = 3;
    description.name = "Trainer Stick";
    const int index = attach(&description);
    ASSERT_GE(index, 0);
    EXPECT_EQ(known(index), SDL_FALSE);
    SDL_Joystick* const virtual_stick = open_stick(index);
    ASSERT_NE(virtual_stick, nullptr);
    {
        Joystick joystick("Trainer Stick");
        EXPECT_EQ(joystick.axes(), 7);
        set_axis(virtual_stick, 6, -32768);
        set_axis(virtual_stick, 1, 16384);
        set_button(virtual_stick, 2, 1);
        JoystickReading reading;
        ASSERT_TRUE(until([&] { return joystick.read(reading) && reading.axis[6] < -0.5; }));
        EXPECT_EQ(reading.axis[6], -1);
        EXPECT_NEAR(reading.axis[1], 0.5, 1e-3);
        EXPECT_EQ(reading.buttons, 4U);
        ASSERT_EQ(detach(index), 0);
        ASSERT_TRUE(until([&] { return !joystick.read(reading); }));
    }
    quit(SDL_INIT_JOYSTICK);
}

}  // namespace
}  // namespace fulcrum
