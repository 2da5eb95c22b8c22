// SPDX-License-Identifier: Apache-2.0
// The pathology report's figures as metrics: values, evidence, why absent.
#include <gtest/gtest.h>

#include <cmath>

#include "assessment/metrics/registry.h"
#include "assessment/scoring/score.h"
#include "tests/assessment/metrics/traces.h"

namespace fulcrum {
namespace {

const char* const specimen_ids[] = {"tme_grade",       "tme_defect",    "crm_mm",        "drm_mm",
                                    "plane_dev_right", "plane_dev_mid", "plane_dev_left"};

MetricContext context() {
    MetricContext context;
    context.specimen =
        SpecimenPlan{2, 0.06, 0.03, 0.003, 0.006, 0.018, 0.002, 0.01, Tumour{0, Sector::mid, 0.008, 0.01}};
    return context;
}

/// One cut from `from` to `to` m along the line, at a distance from the plane in um.
std::vector<Event> cut(double from, double to, std::int32_t distance) {
    std::vector<Event> events;
    const auto add = [&](double t, EventKind kind, double value, std::int32_t detail) {
        Event event;
        event.tick = static_cast<std::uint32_t>(std::lround(t * 1000));
        event.kind = kind;
        event.hand = 1;
        event.value = static_cast<float>(value);
        event.detail = detail;
        events.push_back(event);
    };
    add(1, EventKind::cut_begin, from, distance);
    for (int i = 1; i <= 100; ++i)
        add(1 + 0.05 * i, EventKind::cut_advance, from + (to - from) * i / 100, distance);
    add(6, EventKind::cut_end, to, distance);
    return events;
}

MetricResult result(const std::string& id, const std::vector<Event>& events,
                    const MetricContext& known = context()) {
    return test::measure(test::make_trace(20), id, "", events, known);
}

TEST(Specimen, OfACutInThePlane) {
    const std::vector<Event> events = cut(0, 0.12, 500);
    EXPECT_EQ(result("tme_grade", events).value, 3);
    EXPECT_EQ(result("tme_defect", events).value, 0);
    EXPECT_NEAR(result("crm_mm", events).value.value(), 7.5, 1e-6);
    EXPECT_NEAR(result("drm_mm", events).value.value(), 25, 1e-9);
    for (const char* id : {"plane_dev_right", "plane_dev_mid", "plane_dev_left"})
        EXPECT_NEAR(result(id, events).value.value(), 0.5, 1e-9) << id;
}

TEST(Specimen, ADefectIsEvidence) {
    const MetricResult grade = result("tme_grade", cut(0, 0.12, -9000));
    EXPECT_EQ(grade.value, 2);
    EXPECT_NEAR(result("tme_defect", cut(0, 0.12, -9000)).value.value(), 6, 1e-6);
    ASSERT_FALSE(grade.evidence.empty());
    EXPECT_GE(grade.evidence[0].begin, 0.5);
    EXPECT_NEAR(result("crm_mm", cut(0, 0.12, -9000)).value.value(), 0, 1e-9);
    EXPECT_FALSE(result("crm_mm", cut(0, 0.12, -9000)).evidence.empty());
    // Outside the corridor nothing is divided: neither grade nor margin.
    EXPECT_EQ(result("tme_grade", cut(0, 0.12, -15000)).absence, Absence::not_done);
    EXPECT_EQ(result("crm_mm", cut(0, 0.12, -15000)).absence, Absence::not_done);
}

TEST(Specimen, SaysWhyAFigureIsAbsent) {
    MetricContext none;
    for (const char* id : specimen_ids) {
        EXPECT_EQ(result(id, cut(0, 0.12, 0), none).absence, Absence::not_measured) << id;
        EXPECT_EQ(result(id, {}).absence, Absence::not_done) << id;
        EXPECT_EQ(find_metric(id)->absent_means, AbsentMeans::failed) << id;
    }
    EXPECT_EQ(result("plane_dev_left", cut(0, 0.03, 0)).absence, Absence::not_done);
    EXPECT_EQ(result("crm_mm", cut(0.06, 0.12, 0)).absence, Absence::not_done);
    EXPECT_EQ(result("drm_mm", cut(0, 0.06, 0)).absence, Absence::not_done);
    MetricContext healthy = context();
    healthy.specimen->tumour.reset();
    EXPECT_EQ(result("crm_mm", cut(0, 0.12, 0), healthy).absence, Absence::not_measured);
    EXPECT_EQ(result("tme_grade", cut(0, 0.12, 0), healthy).value, 3);
}

// A margin can only become smaller: what an interrupted attempt has cut away stays cut away.
TEST(Specimen, AMarginThatIsGoneFailsAnInterruptedAttempt) {
    TaskDefinition task;
    task.id = "C4";
    task.metrics = {"crm_mm"};
    task.gates = {{"crm_mm", "", "", GateKind::absolute, 1.0, "positive at 1 mm"}};
    std::vector<Event> events = cut(0, 0.12, -8000);
    Event end;
    end.tick = 20000;
    end.kind = EventKind::interrupted;
    events.push_back(end);
    const Trace trace = test::make_trace(20);
    MetricContext known = context();
    known.metrics = {"crm_mm"};
    Score score = score_attempt(task, trace, events, compute_metrics(trace, events, known), nullptr);
    EXPECT_EQ(score.passed, false);
    events = cut(0, 0.12, 0);
    events.push_back(end);
    score = score_attempt(task, trace, events, compute_metrics(trace, events, known), nullptr);
    EXPECT_FALSE(score.passed.has_value());
}

}  // namespace
}  // namespace fulcrum
