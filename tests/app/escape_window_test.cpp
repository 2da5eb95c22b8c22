// SPDX-License-Identifier: GPL-3.0-or-later
// The window is closed while an assessed attempt runs: it asks, stays open, and an attempt that is then
// abandoned is stored as failed. One window serves for every moment.
#include "tests/app/escape_attempt.h"
#include "tests/app/window_fixture.h"

namespace fulcrum::app::program_test {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

class EscapeWindow : public Window {
  protected:
    EscapeWindow() {
        services.seed = 2001;
        services.between = [this](std::shared_ptr<Rig>) -> std::shared_ptr<Rig> {
            hands = hands_at_a2(load_task_and_scene("A2"), true);
            return hands;
        };
    }
    AttemptPhase phase() { return theatre().session()->phase(); }
    std::size_t stored() {
        return database::Attempts(*services.store()).list(window.context().session()).size();
    }
    /// Its events go through closeEvent(): the window stays, and asks.
    void close_and_be_asked() {
        EXPECT_FALSE(window.close());
        EXPECT_TRUE(window.isVisible());
        EXPECT_TRUE(sees(window, "panel_abandon"));
    }
    void break_the_limit() {
        ASSERT_TRUE(wait_for([&] { return hands->broke.load(); }));
        // Until the press has been recorded.
        const std::uint32_t recorded = theatre().session()->health().ticks + 400;
        ASSERT_TRUE(wait_for([&] { return theatre().session()->health().ticks >= recorded; }));
    }
    void expect_stored_as_failed(std::size_t attempts) {
        wait_for_debrief();
        EXPECT_EQ(stored(), attempts);
        const database::AttemptSummary attempt = newest_attempt();
        EXPECT_EQ(attempt.state, AttemptState::abandoned);
        expect_failed(attempt);
        home();
    }

    std::shared_ptr<EscapingHands> hands;  ///< of the latest attempt
};

TEST_F(EscapeWindow, ClosingTheWindowAsksAtEveryMomentAndTakesNoBrokenLimitBack) {
    create_programme_and_trainee();
    {
        SCOPED_TRACE("ready: there is nothing to ask about");
        click(window, "briefing_A2");
        expect_page("briefing_page");
        check(window, "mode_assessed");
        click(window, "start_attempt");
        expect_page("theatre_page");
        EXPECT_FALSE(window.close());
        expect_page("briefing_page");
        EXPECT_EQ(stored(), 0U);
        home();
    }
    {
        SCOPED_TRACE("running, before and after a limit is broken, paused, and finishing");
        start("A2", true);
        ASSERT_TRUE(wait_for([&] { return hands->moved.load(); }));
        close_and_be_asked();
        EXPECT_EQ(phase(), AttemptPhase::paused);
        click(window, "panel_resume");
        ASSERT_NO_FATAL_FAILURE(break_the_limit());
        close_and_be_asked();
        EXPECT_EQ(phase(), AttemptPhase::paused);
        close_and_be_asked();
        click(window, "panel_abandon");
        const AttemptSession& session = *theatre().session();
        ASSERT_TRUE(comes_true([&] { return session.phase() >= AttemptPhase::finishing; }));
        EXPECT_FALSE(window.close()) << "it has not seen the end yet";
        expect_stored_as_failed(1);
    }
    {
        SCOPED_TRACE("device lost");
        start("A2", true);
        ASSERT_NO_FATAL_FAILURE(break_the_limit());
        hands->resting = hands->unplugged = true;
        ASSERT_TRUE(wait_for([&] { return phase() == AttemptPhase::device_lost; }));
        ASSERT_TRUE(wait_for([&] { return sees(window, "theatre_panel"); }));
        close_and_be_asked();
        EXPECT_EQ(phase(), AttemptPhase::device_lost);
        click(window, "panel_abandon");
        expect_stored_as_failed(2);
    }
}

}  // namespace
}  // namespace fulcrum::app::program_test
