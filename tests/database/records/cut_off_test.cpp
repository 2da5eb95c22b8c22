// SPDX-License-Identifier: GPL-3.0-or-later
// Attempts that were cut off three times in a row are for the educator to see.
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

/// Who has at least three in a row, as an educator sees it: "person task count".
std::vector<std::string> series(const Programme& programme) {
    std::vector<std::string> found;
    for (const CutOffSeries& one : programme.attempts().cut_off_series(programme.session("educator"))) {
        const AttemptSummary& last = one.attempts.front();
        found.push_back(last.person_login + " " + last.meta.task_id + " " +
                        std::to_string(one.attempts.size()));
    }
    return found;
}

std::string cut_off(Programme& programme, const std::string& login, AttemptState state,
                    const std::string& task = "A2") {
    programme.clock.pass_s(60);
    Recorder recorder(programme.path, programme.session(login), example_meta(programme.id(login), task),
                      programme.clock.options());
    Programme::append_second(recorder);
    AttemptResult result = example_result(false, 0);
    result.state = state;
    result.score->passed.reset();
    recorder.finish(result);
    return recorder.attempt_id();
}

TEST(CutOff, ThreeInARowOfOnePersonAndTaskAreShown) {
    Programme programme;
    for (int i = 0; i < 2; ++i) cut_off(programme, "ann", AttemptState::interrupted);
    cut_off(programme, "ann", AttemptState::interrupted, "B1");  // another task
    cut_off(programme, "ben", AttemptState::interrupted);        // another person
    EXPECT_EQ(series(programme), std::vector<std::string>{});
    const std::string last = cut_off(programme, "ann", AttemptState::failed_simulation);
    EXPECT_EQ(series(programme), std::vector<std::string>{"ann A2 3"});
    const CutOffSeries one = programme.attempts().cut_off_series(programme.session("educator")).at(0);
    EXPECT_EQ(one.attempts.front().meta.id, last);
    EXPECT_EQ(one.attempts.front().duration_s, 31.5);

    // A kill, found at the next start, counts like any other.
    programme.clock.pass_s(60);
    programme.record_broken("ann");
    programme.open();
    EXPECT_EQ(series(programme), std::vector<std::string>{"ann A2 4"});

    // An attempt that runs to its end ends the series.
    programme.clock.pass_s(60);
    programme.record("ann", false, 20);
    EXPECT_EQ(series(programme), std::vector<std::string>{});
}

TEST(CutOff, ALostDeviceThatMadePracticeOfAnAttemptCounts) {
    Programme programme;
    for (int i = 0; i < 3; ++i) {
        programme.clock.pass_s(60);
        Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                          programme.clock.options());
        Programme::append_second(recorder);
        ASSERT_TRUE(recorder.relabel_as_practice(StatementId::practice_device_lost));
        recorder.finish(example_result(true, 70));
    }
    EXPECT_EQ(series(programme), std::vector<std::string>{"ann A2 3"});
}

TEST(CutOff, WhatFailedBeforeItWasCutOffCounts) {
    Programme programme;
    for (const AttemptState state : {AttemptState::interrupted, AttemptState::failed_simulation}) {
        programme.clock.pass_s(60);
        Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                          programme.clock.options());
        Programme::append_second(recorder);
        AttemptResult result = example_result(false, 0);
        result.state = state;
        recorder.finish(result);
        EXPECT_TRUE(programme.attempts().read(programme.session("ann"), recorder.attempt_id()).counting);
    }
}

}  // namespace
}  // namespace fulcrum::database::test
