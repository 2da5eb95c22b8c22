// SPDX-License-Identifier: Apache-2.0
// The pathology report of constructed cuts, compared with closed forms.
#include "assessment/pathology/pathology.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr double mm = 1e-3;
using Reasons = std::vector<GradeReason>;

SpecimenPlan plan() {
    SpecimenPlan plan;
    plan.levels = 4;
    plan.line = 60 * mm;
    plan.spacing = 20 * mm;
    plan.plane = 3 * mm;
    plan.areolar = 6 * mm;
    plan.fat = 18 * mm;
    plan.tolerance = 2 * mm;
    plan.corridor = 10 * mm;
    plan.tumour = Tumour{1, Sector::mid, 8 * mm, 12 * mm};
    return plan;
}

/// One stroke over the whole line of a level; signed distance by the place from 0 to the line's length.
template <typename Distance>
CutStroke across(int level, Distance distance, double from = 0, double to = 60 * mm, int pieces = 600) {
    CutStroke stroke;
    stroke.hand = 1;
    const double origin = level * 60 * mm;
    for (int i = 0; i < pieces; ++i) {
        CutElement e;
        const double a = from + (to - from) * i / pieces, b = from + (to - from) * (i + 1) / pieces;
        e.begin = 10.0 * level + i * 0.01;
        e.end = e.begin + 0.01;
        e.from = origin + a;
        e.to = origin + b;
        e.from_distance = distance(a);
        e.distance = distance(b);
        e.length = std::hypot(e.to - e.from, e.distance - e.from_distance);
        stroke.elements.push_back(e);
    }
    stroke.begin = stroke.elements.front().begin;
    stroke.end = stroke.elements.back().end;
    return stroke;
}

template <typename Distance>
std::vector<CutStroke> all_levels(Distance distance) {
    std::vector<CutStroke> strokes;
    for (int level = 0; level < 4; ++level)
        strokes.push_back(across(level, [&](double x) { return distance(level, x); }));
    return strokes;
}

TEST(Pathology, OfACutInThePlaneIsComplete) {
    const PathologyReport report = pathology_report(all_levels([](int, double) { return 0.0; }), plan());
    ASSERT_EQ(report.findings.size(), 12U);
    for (const SectorFinding& finding : report.findings) {
        EXPECT_NEAR(finding.divided, 1, 1e-9);
        EXPECT_NEAR(finding.plane.length, 20 * mm, 1e-12);
        EXPECT_EQ(finding.plane.median, 0.0);
        EXPECT_EQ(finding.plane.worst, 0.0);
        EXPECT_EQ(finding.plane.in_plane, 1.0);
        EXPECT_EQ(finding.defect, 0.0);
    }
    EXPECT_NEAR(report.divided, 1, 1e-9);
    EXPECT_EQ(report.grade, 3);
    EXPECT_EQ(report.reasons, Reasons{GradeReason::intact});
    EXPECT_TRUE(report.defects.empty());
    EXPECT_NEAR(report.coning.value(), 0, 1e-12);
    // The tumour's edge lies at 10 mm, the cut at 3 mm: 7 mm are left.
    EXPECT_NEAR(report.circumferential.distance.value(), 7 * mm, 1e-9);
    // Its lower edge lies at 20 + 6 mm, the lowest level at 60 mm.
    EXPECT_EQ(report.lowest_level, 3);
    EXPECT_NEAR(report.distal.distance.value(), 34 * mm, 1e-12);
}

// On every level the distance rises evenly from 0 on the right to 6 mm on the left: 0..2, 2..4, 4..6 mm.
TEST(Pathology, DistinguishesSectors) {
    const PathologyReport report =
        pathology_report(all_levels([](int, double x) { return 0.1 * x; }), plan());
    const double expected[] = {1, 3, 5};
    for (std::size_t sector = 0; sector < 3; ++sector) {
        const PlaneDeviation& plane = report.sectors[sector].plane;
        EXPECT_NEAR(plane.median.value(), expected[sector] * mm, 0.01 * mm);
        EXPECT_NEAR(plane.side.value(), expected[sector] * mm, 0.01 * mm);
        EXPECT_NEAR(plane.p95.value(), (expected[sector] + 0.9) * mm, 0.01 * mm);
        EXPECT_NEAR(plane.worst.value(), (expected[sector] + 1) * mm, 1e-9);
        EXPECT_NEAR(plane.too_deep.value(), sector == 0 ? 0 : 1, 1e-6);
        EXPECT_NEAR(plane.too_shallow.value(), 0, 1e-9);
        EXPECT_NEAR(plane.in_plane.value(), sector == 0 ? 1 : 0, 1e-6);
        EXPECT_EQ(report.sectors[sector].level, -1);
    }
    EXPECT_NEAR(report.plane.too_deep.value(), 2.0 / 3, 1e-6);
    EXPECT_EQ(report.deepest_defect, 0.0) << "towards the sacrum the fat is whole";
    EXPECT_EQ(report.grade, 3);
}

TEST(Pathology, FindsADefectWhereAndHowDeepItIs) {
    // A notch of 12 mm width, 9 mm inwards at its middle (x = 45 mm): 6 mm into the fat, from where it is 3
    // mm.
    std::vector<CutStroke> strokes = all_levels([](int level, double x) {
        return level == 2 ? -9 * mm * std::max(0.0, 1 - std::abs(x - 45 * mm) / (6 * mm)) : 0.0;
    });
    const PathologyReport report = pathology_report(strokes, plan());
    EXPECT_EQ(report.grade, 2);
    EXPECT_EQ(report.reasons, Reasons{GradeReason::defect});
    ASSERT_EQ(report.defects.size(), 1U);
    const Defect& defect = report.defects[0];
    EXPECT_EQ(defect.level, 2);
    EXPECT_NEAR(defect.depth, 6 * mm, 1e-9);
    EXPECT_NEAR(defect.from, 41 * mm, 1e-6);
    EXPECT_NEAR(defect.to, 49 * mm, 1e-6);
    EXPECT_FALSE(defect.muscularis);
    EXPECT_NEAR(defect.when.begin, 20 + 4.5, 0.02) << "the moment of its deepest place";
    EXPECT_NEAR(report.deepest_defect, 6 * mm, 1e-9);
    EXPECT_NEAR(report.findings[2 * 3 + 2].defect, 6 * mm, 1e-9);
    EXPECT_EQ(report.findings[2 * 3 + 1].defect, 0.0);
    // 4.9 mm is not a deep defect.
    for (CutStroke& stroke : strokes)
        for (CutElement& element : stroke.elements) {
            element.from_distance *= 7.9 / 9;
            element.distance *= 7.9 / 9;
        }
    EXPECT_EQ(pathology_report(strokes, plan()).grade, 3);
}

TEST(Pathology, ADefectDownToTheMuscularisIsGradeOne) {
    const auto at = [&](double depth) {
        return pathology_report(
            all_levels([&](int level, double x) { return level == 0 && x < 5 * mm ? -depth : 0.0; }), plan());
    };
    EXPECT_EQ(at(13.9 * mm).grade, 2);
    const PathologyReport wall = at(14.1 * mm);
    EXPECT_EQ(wall.grade, 1);
    EXPECT_EQ(wall.reasons, Reasons{GradeReason::muscularis});
    EXPECT_TRUE(wall.defects.at(0).muscularis);
    EXPECT_NEAR(at(40 * mm).deepest_defect, 12 * mm, 1e-12) << "behind the wall there is no fat";
}

TEST(Pathology, DetectsConingWithoutADeepLevel) {
    const auto trend = [](double inwards) {
        return pathology_report(all_levels([&](int level, double) { return -inwards * level / 3; }), plan());
    };
    EXPECT_NEAR(trend(4 * mm).coning.value(), 4 * mm, 1e-9);
    EXPECT_EQ(trend(4 * mm).grade, 2);
    EXPECT_EQ(trend(4 * mm).reasons, Reasons{GradeReason::coning});
    EXPECT_EQ(trend(2.9 * mm).grade, 3);
    EXPECT_NEAR(trend(-6 * mm).coning.value(), -6 * mm, 1e-9);
    EXPECT_EQ(trend(-6 * mm).grade, 3) << "towards the sacrum is deep, not coning";
    EXPECT_EQ(trend(6 * mm).reasons, (Reasons{GradeReason::fat, GradeReason::coning}));
    EXPECT_EQ(trend(6.1 * mm).reasons, Reasons{GradeReason::deep_coning});
    EXPECT_EQ(trend(6.1 * mm).grade, 1);
    // Two levels are not a trend.
    std::vector<CutStroke> two = all_levels([](int level, double) { return -4 * mm * level; });
    two.resize(2);
    EXPECT_FALSE(pathology_report(two, plan()).coning.has_value());
}

TEST(Pathology, MeasuresTheMarginToTheTumoursEdge) {
    const auto margin = [](double depth) {
        return pathology_report(all_levels([&](int, double) { return -depth; }), plan())
            .circumferential.distance.value();
    };
    EXPECT_NEAR(margin(6 * mm), 1 * mm, 1e-9);
    EXPECT_EQ(margin(8 * mm), 0.0) << "through the tumour";
    // Next to it, in the right sector: the path back to the plane leads from (17, 15) to (17.1, 3) mm, past
    // the corner of the tumour's edge at (20, 10).
    std::vector<CutStroke> strokes = all_levels(
        [](int level, double x) { return level == 1 && x > 16.9 * mm && x <= 17 * mm ? -12 * mm : 0.0; });
    EXPECT_NEAR(pathology_report(strokes, plan()).circumferential.distance.value(), (3 - 0.1 * 5 / 12) * mm,
                1e-6);
    // A cut of another level is as far as the levels are apart, less half the tumour.
    SpecimenPlan close = plan();
    close.spacing = 8 * mm;
    strokes = all_levels([](int level, double) { return level == 2 ? -10 * mm : 0.0; });
    EXPECT_NEAR(pathology_report(strokes, close).circumferential.distance.value(), 2 * mm, 1e-9);
}

TEST(Pathology, GivesTheReasonForAnAbsentMargin) {
    SpecimenPlan without = plan();
    without.tumour.reset();
    const auto strokes = all_levels([](int, double) { return 0.0; });
    EXPECT_EQ(pathology_report(strokes, without).circumferential.absence, MarginAbsence::no_tumour);
    EXPECT_EQ(pathology_report(strokes, without).distal.absence, MarginAbsence::no_tumour);
    // Only the first level: nothing next to the tumour, nothing below it.
    const PathologyReport first = pathology_report({strokes[0]}, plan());
    EXPECT_EQ(first.circumferential.absence, MarginAbsence::not_divided);
    EXPECT_EQ(first.distal.absence, MarginAbsence::not_divided);
    EXPECT_EQ(first.lowest_level, 0);
    // A level of which a tenth is undivided is not fully divided, and limits the distal reach.
    const PathologyReport bridge = pathology_report({strokes[0], strokes[1],
                                                     across(
                                                         2, [](double) { return 0.0; }, 0, 54 * mm),
                                                     strokes[3]},
                                                    plan());
    EXPECT_EQ(bridge.lowest_level, 1);
    EXPECT_NEAR(bridge.divided, 0.975, 1e-3);
}

TEST(Pathology, WithoutACutIsEmpty) {
    const PathologyReport report = pathology_report({}, plan());
    EXPECT_FALSE(report.grade.has_value());
    EXPECT_EQ(report.reasons, Reasons{GradeReason::nothing_cut});
    EXPECT_FALSE(report.plane.median.has_value());
    EXPECT_EQ(report.divided, 0.0);
    EXPECT_FALSE(report.circumferential.distance.has_value());
    EXPECT_TRUE(pathology_report({}, SpecimenPlan{}).findings.empty());
}

TEST(Pathology, OfOneSectorHasNoGradeAndTheMarginOfThatSector) {
    const PathologyReport report = pathology_report({across(
                                                        1, [](double) { return 1 * mm; }, 20 * mm, 40 * mm)},
                                                    plan());
    EXPECT_FALSE(report.grade.has_value());
    EXPECT_EQ(report.reasons, Reasons{GradeReason::undivided});
    EXPECT_FALSE(report.sectors[0].plane.median.has_value());
    EXPECT_NEAR(report.sectors[1].plane.median.value(), 1 * mm, 1e-12);
    EXPECT_FALSE(report.coning.has_value());
    EXPECT_NEAR(report.circumferential.distance.value(), 8 * mm, 1e-9);
}

TEST(Pathology, IsGradedFromNinetyFivePercentOn) {
    const auto divided = [](double share) {
        std::vector<CutStroke> strokes = all_levels([](int, double) { return 0.0; });
        strokes[3] = across(
            3, [](double) { return 0.0; }, 0, (4 * share - 3) * 60 * mm);
        return pathology_report(strokes, plan());
    };
    EXPECT_EQ(divided(0.95).grade, 3);
    EXPECT_FALSE(divided(0.949).grade.has_value());
    EXPECT_EQ(divided(0.949).reasons, Reasons{GradeReason::undivided});
    // The tumour's sector alone decides its margin.
    EXPECT_TRUE(divided(0.8).circumferential.distance.has_value());
    std::vector<CutStroke> strokes = all_levels([](int, double) { return 0.0; });
    strokes[1] = across(
        1, [](double) { return 0.0; }, 0, 38.5 * mm);
    EXPECT_EQ(pathology_report(strokes, plan()).circumferential.absence, MarginAbsence::not_divided);
}

TEST(Pathology, JudgesTheLineThatTheTaskAsksFor) {
    const auto in_plane = [](double) { return 0.0; };
    std::vector<CutStroke> strokes = all_levels([](int, double) { return 0.0; });
    strokes[3] = across(3, in_plane, 0, 30 * mm);
    EXPECT_FALSE(pathology_report(strokes, plan()).grade.has_value()) << "87.5 % of the whole line";
    SpecimenPlan most = plan();
    most.asked = 210 * mm;
    const PathologyReport report = pathology_report(strokes, most);
    EXPECT_EQ(report.grade, 3);
    EXPECT_NEAR(report.divided, 1, 1e-9);
    EXPECT_EQ(report.lowest_level, 3);
    EXPECT_NEAR(report.findings[10].divided, 1, 1e-9) << "half of it is asked for";
    for (const SectorFinding& sector : report.sectors) EXPECT_NEAR(sector.divided, 1, 1e-9);
    strokes[3] = across(3, in_plane, 0, 20 * mm);
    EXPECT_NEAR(pathology_report(strokes, most).divided, 200.0 / 210, 1e-9);
    EXPECT_NEAR(pathology_report(strokes, most).sectors[1].divided, 60.0 / 70, 1e-9);
    most.asked = 120 * mm;
    strokes.resize(2);
    EXPECT_EQ(pathology_report(strokes, most).grade, 3);
    EXPECT_EQ(pathology_report(strokes, most).lowest_level, 1) << "of the next nothing is asked";
    most.asked = 240 * mm;
    const auto all = all_levels([](int level, double x) { return -3 * mm * level + 0.05 * x; });
    EXPECT_EQ(pathology_json(pathology_report(all, most)), pathology_json(pathology_report(all, plan())));
    std::string text = pathology_json(pathology_report(all, plan()));
    const std::string key = "\"asked_mm\":240.0,";
    ASSERT_NE(text.find(key), std::string::npos) << text;
    text.erase(text.find(key), key.size());
    EXPECT_NEAR(parse_pathology(text, "old.json").plan.asked, 240 * mm, 1e-12) << "version 3";
}

TEST(Pathology, DefectsCountByDepthAndByShareOfTheLength) {
    // A third of each level 2.5 mm in the fat, that is 5.5 mm inwards of the plane.
    const auto shallow = [](double share) {
        return pathology_report(
            all_levels([&](int, double x) { return x < share * 60 * mm ? -5.5 * mm : 0.0; }), plan());
    };
    EXPECT_EQ(shallow(0.19).grade, 3);
    EXPECT_EQ(shallow(0.33).grade, 2);
    EXPECT_EQ(shallow(0.33).reasons, Reasons{GradeReason::fat});
    // Three quarters of each level 8.1 mm in the fat.
    const auto bulk = [](double depth) {
        SpecimenPlan wide = plan();
        wide.corridor = 15 * mm;
        return pathology_report(
            all_levels([&](int, double x) { return x < 45 * mm ? -(3 * mm + depth) : 0.0; }), wide);
    };
    EXPECT_EQ(bulk(8 * mm).grade, 2);
    EXPECT_EQ(bulk(8.1 * mm).grade, 1);
    EXPECT_EQ(bulk(8.1 * mm).reasons, Reasons{GradeReason::bulk_loss});
}

TEST(Pathology, APerforatedBowelIsGradeOne) {
    const auto strokes = all_levels([](int, double) { return 0.0; });
    const PathologyReport report = pathology_report(strokes, plan(), true);
    EXPECT_EQ(report.grade, 1);
    EXPECT_EQ(report.reasons, Reasons{GradeReason::perforation});
}

TEST(Pathology, RoundingDecidesNoGradeAndNoMargin) {
    const auto margin = [](double left) {
        return pathology_report(all_levels([&](int, double) { return -(7 * mm - left); }), plan())
            .circumferential;
    };
    EXPECT_TRUE(margin_is_positive(margin(0.99 * mm)));
    EXPECT_TRUE(margin_is_positive(margin(1.0 * mm)));
    EXPECT_FALSE(margin_is_positive(margin(1.001 * mm)));
    EXPECT_FALSE(margin_is_positive({}));
    const auto notch = [](double depth) {
        return pathology_report(all_levels([&](int level, double x) {
                                    return level == 1 && x < 3 * mm ? -(3 * mm + depth) : 0.0;
                                }),
                                plan());
    };
    EXPECT_EQ(notch(5 * mm).grade, 3);
    EXPECT_EQ(notch(5.001 * mm).grade, 2);
}

TEST(Pathology, OmitsValuesThatAreNotNumbers) {
    std::vector<CutStroke> strokes = all_levels([](int, double) { return 1 * mm; });
    const PathologyReport clean = pathology_report(strokes, plan());
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    for (const double bad : {nan, inf, -inf}) {
        for (double CutElement::*field : {&CutElement::from, &CutElement::to, &CutElement::from_distance,
                                          &CutElement::distance, &CutElement::length}) {
            CutElement element = strokes[0].elements[0];
            element.*field = bad;
            strokes[0].elements.push_back(element);
        }
    }
    CutElement none = strokes[0].elements[0];
    none.length = 0;
    strokes[0].elements.push_back(none);
    EXPECT_EQ(pathology_json(pathology_report(strokes, plan())), pathology_json(clean));
}

// A blade that slides over the rim of a level may be reported further along it, or on the next level: neither
// was cut.
TEST(Pathology, OmitsPathsThatAreNotOnTheSpecimen) {
    const double rim = 1e-6;
    std::vector<CutStroke> strokes = all_levels([](int, double) { return 1 * mm; });
    const PathologyReport clean = pathology_report(strokes, plan());
    EXPECT_EQ(clean.grade, 3);
    const auto way = [&](double from, double from_distance, double to, double distance) {
        CutElement e = strokes[0].elements[0];
        e.from = from;
        e.to = to;
        e.from_distance = from_distance;
        e.distance = distance;
        e.length = std::hypot(to - from, distance - from_distance);
        return e;
    };
    std::vector<CutStroke> slid = strokes;
    for (const double from : {60 * mm - rim, 60 * mm + rim, rim, 240 * mm - rim})
        slid[0].elements.push_back(way(from, 1 * mm, from, -7.9 * mm));  // 4.9 mm into the fat
    slid[0].elements.push_back(way(58 * mm, 1 * mm, 62 * mm, -7.9 * mm));
    slid[0].elements.push_back(way(130 * mm, -7.9 * mm, 20 * mm, 1 * mm));
    EXPECT_EQ(pathology_json(pathology_report(slid, plan())), pathology_json(clean));
    // To the rim and inside of it the same depths count.
    for (const auto& [from, to] : {std::pair(58 * mm, 60 * mm - rim), std::pair(60 * mm + rim, 62 * mm),
                                   std::pair(rim, 2 * mm), std::pair(30 * mm, 30 * mm)}) {
        std::vector<CutStroke> deep = strokes;
        deep[0].elements.push_back(way(from, 1 * mm, to, -7.9 * mm));
        EXPECT_NEAR(pathology_report(deep, plan()).deepest_defect, 4.9 * mm, 1e-9) << from;
    }
}

TEST(Pathology, SurvivesJson) {
    const PathologyReport report = pathology_report(
        all_levels([](int level, double x) { return -3 * mm * level + 2 * mm * std::sin(100 * x); }), plan());
    const std::string text = pathology_json(report);
    const PathologyReport again = parse_pathology(text, "report.json");
    EXPECT_EQ(again.grade, report.grade);
    EXPECT_EQ(again.reasons, report.reasons);
    EXPECT_EQ(again.findings.size(), report.findings.size());
    EXPECT_EQ(again.defects.size(), report.defects.size());
    EXPECT_NEAR(again.circumferential.distance.value(), report.circumferential.distance.value(), 5.1e-10);
    EXPECT_NEAR(again.plane.p95.value(), report.plane.p95.value(), 5.1e-10);
    EXPECT_EQ(again.plan.tumour->sector, Sector::mid);
    EXPECT_EQ(pathology_json(again), text) << "read back and written again";
    const PathologyReport nothing =
        parse_pathology(pathology_json(pathology_report({}, plan())), "empty.json");
    EXPECT_FALSE(nothing.grade.has_value());
    EXPECT_EQ(nothing.distal.absence, MarginAbsence::not_divided);
    for (const char* bad : {"", "{}", "[1]", R"({"version": "one"})"})
        EXPECT_THROW(parse_pathology(bad, "bad.json"), InputError) << bad;
    std::string unknown = text;
    unknown.replace(unknown.find("\"mid\""), 5, "\"top\"");
    EXPECT_THROW(parse_pathology(unknown, "bad.json"), InputError);
}

/// Any cut at all, also far beyond the specimen.
std::vector<CutStroke> any_cut() {
    std::vector<CutStroke> strokes;
    const int count = *rc::gen::inRange(0, 4);
    for (int s = 0; s < count; ++s) {
        CutStroke stroke;
        const int elements = *rc::gen::inRange(0, 12);
        double x = 1e-4 * *rc::gen::inRange(-300, 3000), d = 1e-4 * *rc::gen::inRange(-300, 300);
        for (int i = 0; i < elements; ++i) {
            CutElement e;
            e.begin = i;
            e.end = i + 1;
            e.from = x;
            e.from_distance = d;
            x += 1e-4 * *rc::gen::inRange(-800, 800);
            d += 1e-4 * *rc::gen::inRange(-100, 100);
            e.to = x;
            e.distance = d;
            e.length = std::hypot(e.to - e.from, e.distance - e.from_distance);
            stroke.elements.push_back(e);
        }
        strokes.push_back(std::move(stroke));
    }
    return strokes;
}

/// Whether a way on a grid of 0.1 mm is a surface of the specimen: not from one level to another, nor along a
/// rim.
bool on_specimen(const CutElement& e) {
    for (int k = -20; k <= 20; ++k) {
        const double a = e.from - k * 60 * mm, b = e.to - k * 60 * mm, least = 1e-5;
        if (std::abs(a) < least && std::abs(b) < least) return false;
        if (k > 0 && k < 4 && std::min(a, b) < -least && std::max(a, b) > least) return false;
    }
    return true;
}

RC_GTEST_PROP(PathologyProperties, LengthIsKeptAndSharesAreShares, ()) {
    const std::vector<CutStroke> strokes = any_cut();
    const PathologyReport report = pathology_report(strokes, plan());
    double length = 0, parts = 0;
    for (const CutStroke& stroke : strokes)
        for (const CutElement& element : stroke.elements)
            if (on_specimen(element)) length += element.length;
    for (const SectorFinding& finding : report.findings) {
        parts += finding.plane.length;
        RC_ASSERT(finding.divided >= 0 && finding.divided <= 1 + 1e-9);
        RC_ASSERT(finding.defect >= 0 && finding.defect <= 0.012 + 1e-12);
        RC_ASSERT(finding.defect <= report.deepest_defect);
        if (!finding.plane.median) continue;
        const double sum = *finding.plane.in_plane + *finding.plane.too_deep + *finding.plane.too_shallow;
        RC_ASSERT(std::abs(sum - 1) < 1e-9);
        RC_ASSERT(*finding.plane.median <= *finding.plane.p95 + 1e-12);
        RC_ASSERT(*finding.plane.p95 <= std::abs(*finding.plane.worst) + 1e-12);
    }
    RC_ASSERT(std::abs(parts - length) <= 1e-9 * (1 + length));
    RC_ASSERT(report.grade.has_value() == (length > 0 && report.divided >= fully_divided_share - 1e-9));
    if (report.grade == 1)
        RC_ASSERT(report.deepest_defect >= 0.011 - 1e-12 || report.coning.value_or(0) > deep_coning_limit ||
                  report.median_fat_depth > bulk_loss_depth);
    if (report.circumferential.distance) RC_ASSERT(*report.circumferential.distance >= 0);
    if (report.distal.distance) RC_ASSERT(*report.distal.distance >= 0);
    const std::string text = pathology_json(report);
    RC_ASSERT(text.find("nan") == std::string::npos);
    RC_ASSERT(pathology_json(parse_pathology(text, "any")) == text);
}

RC_GTEST_PROP(PathologyProperties, AMirroredCutHasMirroredSectors, ()) {
    const std::vector<CutStroke> strokes = any_cut();
    std::vector<CutStroke> mirrored = strokes;
    // Right for left, and with it the first level for the last.
    for (CutStroke& stroke : mirrored)
        for (CutElement& e : stroke.elements) {
            e.from = 0.24 - e.from;
            e.to = 0.24 - e.to;
        }
    const PathologyReport a = pathology_report(strokes, plan()), b = pathology_report(mirrored, plan());
    RC_ASSERT(std::abs(a.divided - b.divided) < 1e-9);
    RC_ASSERT(std::abs(a.sectors[0].plane.length - b.sectors[2].plane.length) < 1e-9);
    RC_ASSERT(std::abs(a.deepest_defect - b.deepest_defect) < 1e-12);
}

RC_GTEST_PROP(PathologyProperties, CuttingMoreNeverImprovesTheSpecimen, ()) {
    std::vector<CutStroke> strokes = any_cut();
    const PathologyReport before = pathology_report(strokes, plan());
    for (CutStroke& stroke : any_cut()) strokes.push_back(std::move(stroke));
    const PathologyReport after = pathology_report(strokes, plan());
    RC_ASSERT(after.deepest_defect >= before.deepest_defect);
    RC_ASSERT(after.divided >= before.divided - 1e-12);
    RC_ASSERT(after.lowest_level >= before.lowest_level);
    if (before.circumferential.distance)
        RC_ASSERT(*after.circumferential.distance <= *before.circumferential.distance);
    if (before.grade == 1) RC_ASSERT(after.grade == 1);
}

}  // namespace
}  // namespace fulcrum
