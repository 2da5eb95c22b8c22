// SPDX-License-Identifier: Apache-2.0
// Hand over hand: two jaws take hold 0 to 15 mm apart, one after the other or both at once, whichever hand is
// first and lets go first, whatever the tissue; nothing is lost, and at rest neither hand feels more than 3
// N.
//
// FULCRUM_HANDOVER_PAGE: a folder for the page handover.md; the command that it names makes it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <vector>

#include "sim_core/lab/chart.h"
#include "sim_core/lab/result_page.h"
#include "tests/sim_core/world/hands_on_tissue.h"

namespace fulcrum {
namespace {

enum class TakenBy : std::uint8_t { left_first, right_first, both_at_once };
constexpr const char* taken_by_words[] = {"left, then right", "right, then left", "both at once"};

/// What the holds of one tissue came to at rest.
struct HoldFigures {
    std::string tissue, order;
    int holds = 0, lost = 0;
    double alone = 0, both = 0;  // N, largest at rest
};

class HandOver : public testing::TestWithParam<const char*> {
  protected:
    HandOver() : held_(test::held_scene(GetParam())), rig_(held_.scene) {}

    static std::vector<HoldFigures>& figures() {
        static std::vector<HoldFigures> all;
        return all;
    }
    static void TearDownTestSuite() {
        const char* folder = std::getenv("FULCRUM_HANDOVER_PAGE");
        if (folder == nullptr || testing::UnitTest::GetInstance()->failed_test_count() > 0) return;
        lab::ResultPage page("handover", "Two jaws on one piece of tissue",
                             std::string("FULCRUM_HANDOVER_PAGE=") + folder +
                                 " test_sim_core --gtest_filter=Tissues/HandOver.*");
        page.paragraph(
            "Jaws take hold 0, 1, 2, 4, 6, 8, 12 and 15 mm apart, one hand after the other or both at once; "
            "then the first hand lets go, then the other (in turn where both took hold at once). Largest "
            "force "
            "at rest: of the reaction of a hold and of the recorded force of its hand, over 50 ms that begin "
            "300 ms after the last movement. At most 3 N are allowed, and no hold may be lost.");
        lab::ResultTable table;
        table.name = "handover";
        table.columns = {"tissue",
                         "taken by",
                         "holds at rest",
                         "lost",
                         "one hand, largest N at rest",
                         "both hands, largest N at rest"};
        for (const HoldFigures& one : figures())
            table.rows.push_back({one.tissue, one.order, std::to_string(one.holds), std::to_string(one.lost),
                                  lab::short_number(one.alone), lab::short_number(one.both)});
        page.table(table);
        page.write(folder, lab::this_machine(lab::build_info()));
    }

    Vector3 jaws_on(int h, const Vector3& place) const { return test::tip_for_jaws(rig_, h, place); }
    Vector3 above(int h, double from_middle, double height) const {
        const test::TissuePlace where = held_.place(rig_.world, from_middle);
        return jaws_on(h, where.point + height * where.out);
    }
    void expect_held(int h, const std::string& when) {
        EXPECT_TRUE(rig_.world.snapshot().grasps[h].held) << when << ", hand " << h;
        sum_.lost += rig_.world.snapshot().grasps[h].held ? 0 : 1;
    }
    void rests(int h, const std::string& when, bool with_other) {
        rig_.steps(60);
        double most = 0;
        for (int i = 0; i < 10; ++i) {
            rig_.step();
            most = std::max(most, rig_.world.snapshot().grasps[h].reaction.norm());
            most = std::max(most, test::recorded_force(rig_, h));
        }
        EXPECT_LE(most, 3.0) << when << ", hand " << h;
        expect_held(h, when);
        ++sum_.holds;
        double& largest = with_other ? sum_.both : sum_.alone;
        largest = std::max(largest, most);
    }
    void take_hold(int h, double from_middle, const std::string& when) {
        rig_.go(h, above(h, from_middle, 0.02), 0.2);
        rig_.go(h, above(h, from_middle, 0.002), 0.1);
        rig_.wish[h].closed = true;
        rig_.steps(30);
        expect_held(h, when);
    }
    void both_take_hold(double apart, const std::string& when) {
        const double place[hand_count] = {-0.5 * apart, 0.5 * apart};
        for (int h = 0; h < hand_count; ++h) rig_.go(h, above(h, place[h], 0.02), 0.2);
        Vector3 from[hand_count], to[hand_count];
        for (int h = 0; h < hand_count; ++h) {
            from[h] = rig_.wish[h].tip;
            to[h] = above(h, place[h], 0.002);
        }
        constexpr int steps = 36;  // 18 mm at 0.1 m/s
        for (int i = 1; i <= steps; ++i) {
            for (int h = 0; h < hand_count; ++h)
                rig_.wish[h].tip = from[h] + (static_cast<double>(i) / steps) * (to[h] - from[h]);
            rig_.step();
        }
        for (int h = 0; h < hand_count; ++h) rig_.wish[h].closed = true;
        rig_.steps(30);
        for (int h = 0; h < hand_count; ++h) expect_held(h, when);
    }
    void let_go(int h, const std::string& when) {
        rig_.wish[h].closed = false;
        rig_.steps(20);
        EXPECT_FALSE(rig_.world.snapshot().grasps[h].held) << when;
        const test::TissuePlace where = held_.place(rig_.world, 0);
        rig_.go(h, rig_.wish[h].tip + 0.02 * where.out, 0.2);
        rig_.go(h, where.point + 0.05 * where.out + Vector3(h == 0 ? 0.04 : -0.04, 0, 0), 0.3);
    }
    /// Both hold; `first` lets go before the other.
    void hand_over_from(int first, const std::string& when) {
        for (int h = 0; h < hand_count; ++h) rests(h, when + ", both", true);
        let_go(first, when);
        rests(1 - first, when + ", handed over", false);
        let_go(1 - first, when);
        rig_.steps(100);
    }

    test::HeldScene held_;
    test::SheetRig rig_;
    HoldFigures sum_;
};

constexpr double distances_apart[] = {0.0, 0.001, 0.002, 0.004, 0.006, 0.008, 0.012, 0.015};

TEST_P(HandOver, AtAnyDistanceLosesNothingAndLoadsNoHand) {
    for (const TakenBy order : {TakenBy::left_first, TakenBy::right_first, TakenBy::both_at_once}) {
        sum_ = {GetParam(), taken_by_words[static_cast<int>(order)]};
        int first = order == TakenBy::right_first ? 1 : 0;
        for (const double apart : distances_apart) {
            const std::string when = std::to_string(1e3 * apart) + " mm apart, " + sum_.order;
            if (order == TakenBy::both_at_once) {
                both_take_hold(apart, when);
                first = 1 - first;
            } else {
                take_hold(first, -0.5 * apart, when);
                rests(first, when + ", before", false);
                take_hold(1 - first, 0.5 * apart, when);
            }
            hand_over_from(first, when);
        }
        figures().push_back(sum_);
    }
}

INSTANTIATE_TEST_SUITE_P(
    Tissues, HandOver, testing::Values("bowel", "bowel_with_membrane", "membrane", "sheet", "band", "rectum"),
    [](const testing::TestParamInfo<const char*>& tissue) { return std::string(tissue.param); });

}  // namespace
}  // namespace fulcrum
