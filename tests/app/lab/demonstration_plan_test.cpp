// SPDX-License-Identifier: GPL-3.0-or-later
// The plan of the demonstration programme.
#include "app/lab/demonstration_plan.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace fulcrum::app {
namespace {

TEST(DemonstrationPlan, HasTwentyFourTraineesWhoLearnInAllWays) {
    ASSERT_EQ(demo_trainees().size(), 24U);
    ASSERT_EQ(demo_educators().size(), 3U);
    std::map<LearningKind, int> kinds;
    std::set<std::string> logins, names;
    for (const DemoTrainee& trainee : demo_trainees()) {
        ++kinds[trainee.learning];
        logins.insert(trainee.login);
        names.insert(trainee.name);
    }
    for (const auto& row : learning_kinds) EXPECT_GE(kinds[row.kind], 2) << row.name;
    EXPECT_EQ(logins.size(), 24U);
    EXPECT_EQ(names.size(), 24U);
}

TEST(DemonstrationPlan, IsPractisedForTwelveWeeksWithinAnHourOfWork) {
    int all = 0;
    std::map<std::size_t, std::set<int>> weeks;
    std::map<std::size_t, int> last;
    for (int day = 0; day < demo_days; ++day)
        for (const DemoSession& session : demo_sessions({24}, day)) {
            EXPECT_LT(day % 7, 5) << "nobody practises at the weekend";
            all += session.attempts;
            weeks[session.trainee].insert(day / 7);
            last[session.trainee] = day;
        }
    EXPECT_GE(all, 500);
    EXPECT_LE(all, 800);
    for (std::size_t i = 0; i < 24; ++i) {
        const LearningKind kind = demo_trainees()[i].learning;
        if (kind == LearningKind::stopped) {
            EXPECT_LT(last[i], 35);
            EXPECT_GE(weeks[i].size(), 3U);
        } else {
            EXPECT_GE(last[i], 70) << demo_trainees()[i].login;
        }
        if (kind == LearningKind::relapsed) {
            EXPECT_EQ(weeks[i].count(8), 0U);
        }
    }
}

TEST(DemonstrationPlan, FirstTraineesPractiseTheSameWhoeverElseTakesPart) {
    for (int day = 0; day < demo_days; ++day) {
        std::map<std::size_t, int> few, all;
        for (const DemoSession& one : demo_sessions({4}, day)) few[one.trainee] += one.attempts;
        for (const DemoSession& one : demo_sessions({24}, day))
            if (one.trainee < 4) all[one.trainee] += one.attempts;
        EXPECT_EQ(few, all) << day;
    }
}

TEST(DemonstrationPlan, AnySizeGivesEachTraineeAsManyAttemptsAsWanted) {
    for (const DemoSize& size : {DemoSize{40, 12, 60, 0}, DemoSize{3, 1, 6, 0}, DemoSize{200, 12, 600, 0}}) {
        std::map<std::size_t, int> all;
        std::set<int> days;
        for (int day = 0; day < demo_days; ++day) {
            for (const DemoSession& one : demo_sessions(size, day)) {
                EXPECT_GE(day, demo_days - 7 * size.weeks);
                all[one.trainee] += one.attempts;
                if (one.trainee == 1) days.insert(day);
            }
        }
        EXPECT_EQ(all.size(), size.trainees);
        for (const auto& [trainee, attempts] : all) EXPECT_EQ(attempts, size.attempts) << trainee;
        EXPECT_EQ(days.size(), std::min<std::size_t>(5U * static_cast<unsigned>(size.weeks),
                                                     static_cast<std::size_t>(size.attempts)))
            << "spread over all working days";
    }
    std::set<std::string> logins, names;
    for (std::size_t i = 0; i < most_demo_trainees; ++i) {
        logins.insert(demo_trainee(i).login);
        names.insert(demo_trainee(i).name);
        EXPECT_EQ(demo_trainee(i).learning, demo_trainees()[i % 24].learning);
    }
    EXPECT_EQ(logins.size(), most_demo_trainees);
    EXPECT_EQ(names.size(), most_demo_trainees);
}

TEST(DemonstrationPlan, CurvesDifferAsTheirNamesSay) {
    const auto first = [](LearningKind kind) {
        for (std::size_t i = 0; i < demo_trainees().size(); ++i)
            if (demo_trainees()[i].learning == kind) return i;
        return std::size_t{99};
    };
    const auto mastery = [&](LearningKind kind, int own, int day) {
        return demo_mastery(first(kind), own, 0, day);
    };
    for (const auto& row : learning_kinds) {
        for (int own = 0; own < 40; ++own) {
            EXPECT_LE(mastery(row.kind, own, 0), mastery(row.kind, own + 1, 0)) << row.name;
            EXPECT_LE(mastery(row.kind, own, 0), 1) << row.name;
        }
    }
    EXPECT_GT(mastery(LearningKind::fast, 15, 0), 0.95);
    EXPECT_GT(mastery(LearningKind::fast, 8, 0), mastery(LearningKind::steady, 8, 0) + 0.1);
    EXPECT_GT(mastery(LearningKind::steady, 8, 0), mastery(LearningKind::slow, 8, 0) + 0.1);
    EXPECT_LT(mastery(LearningKind::plateau, 60, 0), 0.55);
    EXPECT_LT(mastery(LearningKind::relapsed, 20, 75), mastery(LearningKind::relapsed, 20, 40) - 0.2);
}

TEST(DemonstrationPlan, DecisionsAndCorrectionsNameParticipants) {
    int decisions = 0, proficient = 0, corrections = 0, granted = 0;
    for (int day = 0; day < demo_days; ++day) {
        EXPECT_TRUE(demo_decisions(0, day).empty());
        for (const DemoDecision& one : demo_decisions(24, day)) {
            ++decisions;
            proficient += one.kind == StandingOverride::Kind::proficient ? 1 : 0;
            EXPECT_LT(one.trainee, 24U);
            EXPECT_LT(one.educator, 3U);
        }
        for (const DemoCorrection& one : demo_corrections(24, day)) {
            ++corrections;
            granted += one.granted ? 1 : 0;
        }
    }
    EXPECT_GE(decisions, 20);
    EXPECT_GE(proficient, 3);
    EXPECT_EQ(corrections, 3);
    EXPECT_EQ(granted, 2);
}

}  // namespace
}  // namespace fulcrum::app
