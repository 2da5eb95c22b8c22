// SPDX-License-Identifier: Apache-2.0
// What a Force Dimension device tells of its reach, and its clutch, through fulcrum-hapticd and a fake
// library.
#include <gtest/gtest.h>

#include "sim_core/devices/daemon_client.h"
#include "tests/fakes/fake_force_dimension.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/built.h"

namespace fulcrum {
namespace {

TEST(ReachOfForceDimension, IsThatOfItsModelAndTheFreeButtonIsTheClutch) {
    test::FakePage<test::FakeForceDimensionPage> page("FAKE_FORCE_DIMENSION_PAGE");
    const test::Variable library("FULCRUM_LIBDRD", test::fake_library("libdrd.so"));
    page->device[0].has_gripper = 0;
    const DaemonClient client(test::hapticd_program(), "force-dimension");
    ASSERT_TRUE(client.facts().workspace[0] && client.facts().workspace[1]);
    EXPECT_TRUE(client.facts().workspace[1]->size().isApprox(Vector3(0.16, 0.16, 0.11))) << "an omega.7";
    EXPECT_TRUE(client.facts().clutch[0] && client.facts().clutch[1]);
    const auto buttons = [&](int hand) {
        DevicePose pose;
        client.state().pose[hand].read(pose);
        return pose.buttons;
    };
    page->device[0].buttons = 8;  // the fourth, without a gripper
    page->device[1].buttons = 2;  // the second, with one
    EXPECT_TRUE(test::until([&] { return buttons(0) == button_clutch && buttons(1) == button_clutch; }));
    page->device[0].buttons = 2;
    page->device[1].buttons = 1;
    EXPECT_TRUE(test::until([&] { return buttons(0) == button_energy && buttons(1) == button_energy; }));
    EXPECT_EQ(page->misuse, 0U);
}

}  // namespace
}  // namespace fulcrum
