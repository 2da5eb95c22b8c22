// SPDX-License-Identifier: GPL-3.0-or-later
// What wrong tries of a login cost: its owner seconds, a guesser minutes.
#include "tests/database/cut_off_process.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

/// The wait after a wrong try of Ann's login.
double guess(const Programme& programme) {
    try {
        programme.people().sign_in("ann", "a colleague's guess");
    } catch (const SignInRefused& refused) {
        EXPECT_EQ(refused.reason(), SignInRefused::Reason::wrong);
        return refused.wait_s();
    }
    ADD_FAILURE() << "not refused";
    return longest_wait_s;
}

TEST(SignIn, WrongTriesOfAColleagueKeepTheRightPasswordOutForHalfAMinuteAtMost) {
    const TemporaryFoldersInMemory in_memory;
    Programme programme;
    for (int wrong = 0; wrong < tries_before_longest_wait; ++wrong) {
        const double wait = guess(programme);
        EXPECT_LE(wait, 30) << wrong;
        programme.clock.pass_s(wait - 1);
        EXPECT_THROW(programme.people().sign_in("ann", "too early"), SignInRefused);
        EXPECT_DOUBLE_EQ(programme.people().sign_in_wait_s("ann"), 1) << "a try too early makes it no longer";
        programme.clock.pass_s(1);
    }
    EXPECT_NO_THROW(programme.people().sign_in("ann", password));
    // A password that an administrator issues ends a wait of five minutes at once.
    for (int wrong = 0; wrong < tries_before_longest_wait; ++wrong) programme.clock.pass_s(guess(programme));
    EXPECT_DOUBLE_EQ(guess(programme), 300);
    const std::string issued =
        programme.people().issue_one_time_password(programme.session("administrator"), programme.id("ann"));
    EXPECT_NO_THROW(programme.people().sign_in("ann", issued));
}

TEST(SignIn, AGuesserHasATryInFiveMinutesWhateverTheRhythm) {
    constexpr double night_s = 8 * 3600;
    constexpr int in_a_night = static_cast<int>(night_s / longest_wait_s) + tries_before_longest_wait + 1;
    const TemporaryFoldersInMemory in_memory;
    int tries = 0;
    {
        const Programme programme;
        for (double passed = 0; passed < night_s; ++tries) {
            const double wait = guess(programme);
            programme.clock.pass_s(wait);
            passed += wait;
        }
        EXPECT_LE(tries, in_a_night);
    }
    // As fast as it is allowed, then a pause in which some are forgotten.
    const Programme programme;
    tries = 0;
    for (double passed = 0; passed < night_s;) {
        for (double wait = 0; wait < longest_wait_s; ++tries) {
            wait = guess(programme);
            programme.clock.pass_s(wait);
            passed += wait;
        }
        programme.clock.pass_s(3600);
        passed += 3600;
    }
    EXPECT_LE(tries, in_a_night);
    programme.clock.pass_s(longest_wait_s * (tries_before_longest_wait + 1));
    EXPECT_DOUBLE_EQ(guess(programme), first_wait_s) << "what was typed in the morning is forgotten";
}

}  // namespace
}  // namespace fulcrum::database::test
