// SPDX-License-Identifier: Apache-2.0
// Fibres between two layers tear under tension: at the ends of cuts, or without a blade.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "sim_core/numerics/input_error.h"
#include "tests/sim_core/world/parts/sheet/cut_truth.h"
#include "tests/sim_core/world/parts/sheet/sheet_rig.h"
#include "tests/support/allocation_count.h"

namespace fulcrum {
namespace {

Scene with_fibres(double strength, double pre_strain = 0.06) {
    Scene scene = test::sheet_scene();
    scene.sheet->pre_strain = pre_strain;
    scene.sheet->fibres = FibreSpec{strength, 0.03};
    return scene;
}

Vector3 on_line(const Scene& scene, double x, double above) {
    return scene.sheet->centre + (x - 0.5 * scene.sheet->line_length) * scene.sheet->along +
           Vector3(0, 0, above);
}

/// A blade divides 15 mm of the line and is withdrawn.
void cut_a_little(test::SheetRig& rig) {
    rig.go(1, on_line(rig.scene, 0.035, 0.02), 0.2);
    rig.go(1, on_line(rig.scene, 0.035, 0.002), 0.1);
    rig.wish[1].button = true;
    rig.go(1, on_line(rig.scene, 0.042, -0.006), 0.04);
    rig.go(1, on_line(rig.scene, 0.055, -0.006), 0.03);
    rig.wish[1].button = false;
    rig.go(1, on_line(rig.scene, 0.055, 0.03), 0.1);
}

/// One tear, from its three events.
struct Parting {
    Vector3 from, to;  ///< along the line and across it, m
    double traction, length;
};
std::vector<Parting> partings(const test::SheetRig& rig) {
    std::vector<Parting> reported;
    for (std::size_t i = 0; i < rig.events.size(); ++i) {
        if (rig.events[i].kind != EventKind::fibres_parted) continue;
        if (i + 2 >= rig.events.size()) {
            ADD_FAILURE() << "the end of the tear is not reported";
            break;
        }
        const Event &begin = rig.events[i], &end = rig.events[i + 1], &pull = rig.events[i + 2];
        EXPECT_EQ(end.kind, EventKind::cut_advance);
        EXPECT_EQ(pull.kind, EventKind::cut_traction);
        for (const Event* event : {&begin, &end, &pull}) EXPECT_EQ(event->hand, 255);
        const auto place = [](const Event& event) {
            return Vector3(static_cast<double>(event.value), -1e-6 * event.detail, 0);
        };
        reported.push_back({place(begin), place(end), static_cast<double>(pull.value), 1e-6 * pull.detail});
    }
    return reported;
}

double parted(const test::SheetRig& rig) {
    double length = 0;
    for (const Parting& one : partings(rig)) length += one.length;
    return length;
}

void expect_whole(const SheetPart& sheet) {
    const CutCheck check = check_cut(sheet.surface(), sheet.state().positions.data());
    EXPECT_TRUE(check.passed()) << check.complaint();
    EXPECT_NEAR(sheet.surface().area_visible() + sheet.surface().area_removed(),
                sheet.surface().area_before(), 1e-9 * sheet.surface().area_before());
    EXPECT_NEAR(sheet.membrane().mass(sheet.state().membrane),
                sheet.surface().area_visible() * sheet.membrane().density(), 1e-12);
}

TEST(SheetFibres, BelowTheirStrengthNoneTearAndNothingElseChanges) {
    test::SheetRig strong(with_fibres(1000)), none;
    for (test::SheetRig* rig : {&strong, &none}) {
        rig->hold_flap(0, Vector3(0, 0.006, 0.008));
        cut_a_little(*rig);
        rig->steps(20);
    }
    EXPECT_EQ(strong.count(EventKind::fibres_parted), 0);
    EXPECT_GT(none.sheet().surface().version(), 5U);
    EXPECT_EQ(strong.sheet().surface().digest(), none.sheet().surface().digest());
    EXPECT_EQ(strong.sheet().state().positions, none.sheet().state().positions);
}

TEST(SheetFibres, WeakerFibresLetACutExtendFurther) {
    double before = -1;
    for (const double strength : {7.0, 5.0, 4.0}) {
        test::SheetRig rig(with_fibres(strength));
        rig.hold_flap(0, Vector3(0, 0.006, 0.008));
        cut_a_little(rig);
        rig.steps(40);
        EXPECT_GT(parted(rig), before) << strength;
        before = parted(rig);
        expect_whole(rig.sheet());
    }
    EXPECT_GT(before, 0.01);
}

TEST(SheetFibres, CutExtendsUnderTensionAndStopsWhenSlack) {
    test::SheetRig rig(with_fibres(4.5));
    rig.hold_flap(0, Vector3(0, 0.002, 0.002));
    cut_a_little(rig);
    const auto divided = [&] {
        int sum = 0;
        for (const std::uint8_t at : rig.sheet().state().divided) sum += at;
        return sum;
    };
    rig.steps(20);
    const int first = divided(), stands = rig.count(EventKind::fibres_parted);
    rig.steps(20);
    EXPECT_EQ(rig.count(EventKind::fibres_parted), stands) << "low tension";
    rig.worst_change = 0;
    const Vector3 back(0, 0.006, 0.010);
    rig.go(0, rig.wish[0].tip + back, 0.05);
    rig.steps(40);
    EXPECT_GT(rig.count(EventKind::fibres_parted), stands + 10);
    EXPECT_GT(divided(), first + 1);
    EXPECT_LE(rig.worst_change, 0.3 * (1 + 1e-9)) << "N per ms, to the holding hand";
    for (const Parting& one : partings(rig)) {
        EXPECT_GT(one.length, 0.0001);
        EXPECT_LT(one.length, 0.002);
        EXPECT_NEAR(one.length, (one.to - one.from).norm(), 2e-6);
        EXPECT_LT(std::abs(one.to.y()), 0.009);
        EXPECT_GT(one.traction, 4.5);
    }
    // The flap is released: the tension drops and the ends stop; drawn again, they extend.
    rig.go(0, rig.wish[0].tip - back, 0.05);
    rig.steps(10);
    const int then = rig.count(EventKind::fibres_parted);
    rig.steps(40);
    EXPECT_EQ(rig.count(EventKind::fibres_parted), then);
    rig.go(0, rig.wish[0].tip + 1.6 * back, 0.05);
    rig.steps(20);
    EXPECT_GT(rig.count(EventKind::fibres_parted), then);
    expect_whole(rig.sheet());
}

TEST(SheetFibres, StrongTractionTearsThemWithoutABlade) {
    test::SheetRig rig(with_fibres(4));
    rig.hold_flap(0, Vector3(0, 0.002, 0.002));
    rig.steps(60);
    EXPECT_EQ(rig.count(EventKind::fibres_parted), 0);
    rig.worst_change = 0;
    rig.go(0, rig.wish[0].tip + Vector3(0, 0.008, 0.010), 0.05);
    const double held = rig.hand(0).pull.norm();
    rig.steps(120);
    EXPECT_GT(rig.count(EventKind::fibres_parted), 5);
    EXPECT_EQ(rig.count(EventKind::cut_begin), 0);
    EXPECT_LT(rig.hand(0).pull.norm(), 0.9 * held) << "the traction drops";
    EXPECT_LE(rig.worst_change, 0.3 * (1 + 1e-9));
    expect_whole(rig.sheet());
}

// The scene of task B2: its traction band ends at 18 N/m. The reported tears are exactly the torn tissue.
TEST(SheetFibres, FibresOfTheTaskTearOnlyAboveItsTractionBandAndAreReported) {
    test::SheetRig rig(load_scene(test::source_path("assets/scenes/b2_plane.json")));
    ASSERT_TRUE(rig.scene.sheet->fibres.has_value());
    const auto most = [&] {
        double traction = 0;
        for (const double at : rig.world.snapshot().sheet.line_traction) traction = std::max(traction, at);
        return traction;
    };
    rig.hold_flap(0, Vector3(0, 0.001, 0.001));
    for (int i = 0; i < 200 && most() < 17; ++i)
        rig.go(0, rig.wish[0].tip + Vector3(0, 0.0001, 0.0001), 0.02);
    rig.steps(100);
    EXPECT_GT(most(), 15);
    EXPECT_LT(most(), 18);
    EXPECT_EQ(rig.count(EventKind::fibres_parted), 0);
    rig.worst_change = 0;
    for (int i = 0; i < 40; ++i) {
        rig.go(0, rig.wish[0].tip + Vector3(0, 0.0005, 0.0005), 0.02);
        rig.steps(4);
    }
    EXPECT_LE(rig.worst_change, 0.3 * (1 + 1e-9));
    const std::vector<Parting> reported = partings(rig);
    ASSERT_GT(reported.size(), 20U);
    const SheetView& sheet = rig.world.snapshot().sheet;
    for (const Parting& one : reported) {
        EXPECT_GT(one.traction, rig.scene.sheet->fibres->strength);
        for (const double share : {0.25, 0.5, 0.75}) {
            const Vector3 place = one.from + share * (one.to - one.from);
            EXPECT_FALSE(test::whole_around(sheet, place, 0.0008)) << place.transpose();
        }
    }
    std::vector<std::array<double, 2>> paths;
    for (const Parting& one : reported) paths.push_back({one.from.x(), one.to.x()});
    const double low = 0.5 * (rig.scene.sheet->line_length - rig.scene.sheet->length);
    const test::PartedLine line =
        test::parted_line(sheet, {low, low + rig.scene.sheet->length}, {-0.01, 0.01}, paths);
    EXPECT_LE(line.longest_unreported, 0.0008 + 1e-9) << "at " << line.unreported_at;
    EXPECT_GT(line.parted, 0.01);
    expect_whole(rig.sheet());
}

TEST(SheetFibres, TearingAddsNoEnergy) {
    // Stretched beyond their strength without contact. Of two sheets that are identical up to a step, the one
    // whose fibres tear in it must not end with more energy.
    Scene scene = with_fibres(5, 0.2);
    SheetPart sheet(scene, scene.step_period());
    scene.sheet->fibres.reset();
    SheetPart whole(scene, scene.step_period());
    const SheetAction nobody[hand_count];
    const auto energy = [](const SheetPart& of) {
        const MembraneEnergy e = of.membrane().energy(of.state().membrane);
        return e.kinetic + e.elastic();
    };
    int parted = 0, fell = 0;
    std::uint64_t allocated = 0;
    for (std::uint32_t k = 1; k <= 60; ++k) {
        whole.restore(sheet.state(), sheet.surface().state());
        allocated += test::allocations_in([&] { sheet.step(nobody, 5 * k, scene.step_period()); });
        whole.step(nobody, 5 * k, scene.step_period());
        const double now = energy(sheet), without = energy(whole);
        if (sheet.surface().version() == whole.surface().version()) {
            EXPECT_EQ(now, without);
            continue;
        }
        ++parted;
        EXPECT_LE(now, without);
        fell += now < without ? 1 : 0;
    }
    EXPECT_GT(parted, 10);
    EXPECT_GT(fell, parted / 2);
    EXPECT_EQ(allocated, 0U);
    expect_whole(sheet);
}

TEST(SheetFibres, SaveInTheMiddleContinuesIdentically) {
    const Scene scene = with_fibres(5, 0.2);
    SheetPart sheet(scene, scene.step_period()), other(scene, scene.step_period());
    const SheetAction nobody[hand_count];
    for (std::uint32_t k = 1; k <= 40; ++k) sheet.step(nobody, 5 * k, scene.step_period());
    EXPECT_GT(sheet.surface().version(), 3U);
    other.restore(sheet.state(), sheet.surface().state());
    for (std::uint32_t k = 41; k <= 80; ++k) {
        sheet.step(nobody, 5 * k, scene.step_period());
        other.step(nobody, 5 * k, scene.step_period());
    }
    StateHash one, two;
    sheet.hash(one);
    other.hash(two);
    EXPECT_EQ(one.value(), two.value());
}

}  // namespace
}  // namespace fulcrum
