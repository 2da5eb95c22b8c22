// SPDX-License-Identifier: Apache-2.0
// Metrics of the scope against traces whose values follow from their construction.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "assessment/metrics/metric.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

constexpr double one_degree = 3.14159265358979323846 / 180;

double minimum_jerk(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * t * (10 + t * (-15 + 6 * t));
}

Event event_at(double seconds, EventKind kind, int detail = 0, double value = 0) {
    Event event;
    event.tick = static_cast<std::uint32_t>(std::lround(seconds * 1000));
    event.kind = kind;
    event.hand = 255;
    event.detail = detail;
    event.value = static_cast<float>(value);
    return event;
}

/// The lens moves 40 mm along x in a second and rests for a second, again and again; it looks along +y,
/// tilted by `tilt` and turned aside by `aside`.
struct Filmed {
    Trace trace;
    std::vector<Event> events;
    MetricContext context;

    explicit Filmed(int moves, double tilt = 0, double aside = 0) {
        const int samples = 2000 * moves + 1000;
        const Quaternion turned(Eigen::AngleAxisd(aside, Vector3::UnitZ()) *
                                Eigen::AngleAxisd(90 * one_degree, Vector3::UnitX()) *
                                Eigen::AngleAxisd(tilt, Vector3::UnitZ()));
        for (int i = 0; i < samples; ++i) {
            const double t = i * 1e-3, whole = std::floor((t - 1) / 2);
            const double x = t < 1 ? 0 : 0.04 * (whole + minimum_jerk(t - 1 - 2 * whole));
            trace.t.push_back(t);
            trace.camera.px.push_back(x);
            trace.camera.py.push_back(0);
            trace.camera.pz.push_back(0);
            trace.camera.qw.push_back(turned.w());
            trace.camera.qx.push_back(turned.x());
            trace.camera.qy.push_back(turned.y());
            trace.camera.qz.push_back(turned.z());
        }
        events.push_back(event_at(1, EventKind::first_movement));
        split_blocks(trace, events);
        context.framing_distance = 0.045;
        context.metrics = {"scope_path", "scope_ldlj", "horizon_err", "centre_err",
                           "size_err",   "tip_lost",   "lens_contact"};
    }
    MetricResult row(const char* id) const {
        const std::vector<MetricResult> rows = compute_metrics(trace, events, context);
        EXPECT_EQ(rows.size(), context.metrics.size());  // one row each, of no hand
        const MetricResult* found = find_result(rows, id, "", "");
        return found == nullptr ? MetricResult() : *found;
    }
};

TEST(CameraMetrics, PathIsTheWayOfTheLens) {
    EXPECT_NEAR(Filmed(5).row("scope_path").value.value_or(-1), 200, 0.2);
}

TEST(CameraMetrics, SmoothnessIsThatOfAHandThatMovesTheSameWay) {
    Filmed filmed(8);
    const double scope = filmed.row("scope_ldlj").value.value_or(0);
    filmed.trace.hand[1].px = filmed.trace.camera.px;
    filmed.trace.hand[1].py = filmed.trace.camera.py;
    filmed.trace.hand[1].pz = filmed.trace.camera.pz;
    filmed.context.metrics = {"ldlj"};
    const auto rows = compute_metrics(filmed.trace, filmed.events, filmed.context);
    const MetricResult* hand = find_result(rows, "ldlj", "right", "");
    ASSERT_NE(hand, nullptr);
    ASSERT_TRUE(hand->value);
    EXPECT_DOUBLE_EQ(scope, *hand->value);
}

TEST(CameraMetrics, WhatFollowsATipDoesNotCountAsAMovementOfItsOwn) {
    Filmed filmed(14);
    const double all = filmed.row("scope_ldlj").value.value_or(0);
    // From here on the lens shakes, as it follows the tip.
    for (std::size_t i = 12000; i < filmed.trace.t.size(); ++i)
        filmed.trace.camera.pz[i] = 0.002 * std::sin(60 * (filmed.trace.t[i] - 12));
    const std::optional<double> shaken = filmed.row("scope_ldlj").value;
    EXPECT_TRUE(!shaken || *shaken < all - 0.5);
    filmed.context.targets.resize(13);
    filmed.events.push_back(event_at(12, EventKind::target_shown, 12));
    EXPECT_NEAR(filmed.row("scope_ldlj").value.value_or(0), all, 0.01);
}

TEST(CameraMetrics, HorizonIsTheMeanSizeOfItsAngleFromTheFirstMovementOn) {
    EXPECT_NEAR(Filmed(3, 7 * one_degree).row("horizon_err").value.value_or(-1), 7, 1e-6);
    EXPECT_NEAR(Filmed(3, -7 * one_degree).row("horizon_err").value.value_or(-1), 7, 1e-6);
    Filmed filmed(3, 7 * one_degree);
    for (std::size_t i = 0; i < 990; ++i) {  // before the first movement
        filmed.trace.camera.qw[i] = 1;
        filmed.trace.camera.qx[i] = filmed.trace.camera.qy[i] = filmed.trace.camera.qz[i] = 0;
    }
    EXPECT_NEAR(filmed.row("horizon_err").value.value_or(-1), 7, 1e-6);
}

TEST(CameraMetrics, CentringAndSizeAreThoseOfTheLastSecondBeforeATargetIsHeld) {
    Filmed filmed(3, 0, 5 * one_degree);
    filmed.context.targets.resize(3);  // two, and the tip that moves
    // The lens rests from 2 s to 3 s at 40 mm and from 4 s to 5 s at 80 mm.
    const Vector3 ahead(-std::sin(5 * one_degree), std::cos(5 * one_degree), 0);
    filmed.context.targets[0].centre = Vector3(0.04, 0.05, 0);
    filmed.context.targets[1].centre = Vector3(0.08, 0, 0) + 0.045 * ahead;
    filmed.events.push_back(event_at(3, EventKind::target_reached, 0));
    filmed.events.push_back(event_at(5, EventKind::target_reached, 1));
    filmed.events.push_back(event_at(6, EventKind::target_reached, 2));
    const MetricResult centre = filmed.row("centre_err");
    EXPECT_NEAR(centre.value.value_or(-1), (5.0 + 0) / 2, 1e-3);
    EXPECT_EQ(centre.count, 2);
    ASSERT_EQ(centre.evidence.size(), 2U);
    EXPECT_NEAR(centre.evidence[0].begin, 2, 1e-9);  // the worse of the two
    EXPECT_NEAR(filmed.row("size_err").value.value_or(-1), (10.0 + 0) / 2, 1e-2);
}

TEST(CameraMetrics, LossesAreSummedAndContactsCounted) {
    Filmed filmed(3);
    EXPECT_EQ(filmed.row("lens_contact").value, 0);
    filmed.events.push_back(event_at(2, EventKind::lens_contact));
    filmed.events.push_back(event_at(4, EventKind::target_lost, 12, 1.25));
    filmed.events.push_back(event_at(6, EventKind::target_lost, 12, 0.5));
    EXPECT_EQ(filmed.row("lens_contact").value, 1);
    const MetricResult lost = filmed.row("tip_lost");
    EXPECT_EQ(lost.value, 1.75);
    ASSERT_EQ(lost.evidence.size(), 2U);
    EXPECT_NEAR(lost.evidence[0].begin, 2.75, 1e-9);
}

TEST(CameraMetrics, AbsenceSaysWhatIsMissing) {
    Filmed filmed(3);
    EXPECT_EQ(filmed.row("tip_lost").absent_because.id(), StatementId::tip_not_followed);
    EXPECT_EQ(filmed.row("tip_lost").absence, Absence::not_done);
    EXPECT_EQ(filmed.row("centre_err").absent_because.id(), StatementId::target_positions_unknown);
    filmed.context.targets.resize(13);
    EXPECT_EQ(filmed.row("centre_err").absent_because.id(), StatementId::no_target_reached);
    filmed.trace.camera = {};
    EXPECT_EQ(filmed.row("scope_path").absent_because.id(), StatementId::not_recorded);
    EXPECT_EQ(filmed.row("scope_path").absence, Absence::not_measured);
}

TEST(CameraMetrics, TimeOfAScopeWithoutHandsRunsFromItsFirstMovement) {
    Filmed filmed(3);
    filmed.context.metrics = {"time"};
    EXPECT_NEAR(filmed.row("time").value.value_or(-1), filmed.trace.end - 1, 1e-9);
    filmed.trace.camera = {};
    EXPECT_EQ(filmed.row("time").absent_because.id(), StatementId::not_recorded);
}

}  // namespace
}  // namespace fulcrum
