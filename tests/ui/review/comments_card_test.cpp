// SPDX-License-Identifier: GPL-3.0-or-later
// A comment that was typed and not sent is its author's draft, whatever ends the review.
#include "ui/review/comments_card.h"

#include <gtest/gtest.h>

#include <QLabel>
#include <QPlainTextEdit>
#include <functional>
#include <map>

#include "database/records/people.h"
#include "database/records/recorder.h"
#include "database/records/reviews.h"
#include "database/sync/station_erasure.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/language/language.h"
#include "ui/review/debrief_page.h"
#include "ui/shell/idle_watch.h"
#include "ui/shell/main_window.h"
#include "ui/style/text.h"

namespace fulcrum::ui::window_test {
namespace {

using database::Session;

class UnsentComments : public ::testing::Test {
  protected:
    UnsentComments() {
        services.open_store(false);
        const database::People people(*services.store());
        const Session alma =
            people.create_programme("Surgery", "alma", "Alma Admin", "correct horse").administrator;
        const auto add = [&](const std::string& login, database::Role role) {
            const auto made = people.create(alma, login, login, {role});
            sessions.emplace(login, people.change_password(people.sign_in(login, made.one_time_password),
                                                           made.one_time_password, "a long password"));
        };
        add("tara", database::Role::trainee);
        add("ed", database::Role::educator);
        add("dora", database::Role::director);
        const std::string cohort = people.create_cohort(sessions.at("dora"), "Spring");
        people.set_members(sessions.at("dora"), cohort, {sessions.at("tara").person_id()});
        people.set_educators(sessions.at("dora"), cohort, {sessions.at("ed").person_id()});
    }
    /// Of the trainee, two seconds.
    std::string record() {
        const Session& tara = sessions.at("tara");
        database::AttemptMeta meta;
        meta.person_id = tara.person_id();
        meta.task_id = "B2";
        meta.device = "test";
        meta.variant = meta.fidelity = "standard";
        meta.scene = "b2_plane.json";
        meta.program_version = "0.1.0-test";
        database::Recorder recorder(services.store()->path(), tara, meta, {});
        for (std::uint32_t tick = 1; tick <= 2000; ++tick) {
            RigSample input;
            TickSample sample;
            input.tick = sample.tick = tick;
            recorder.append(input);
            recorder.append(sample);
        }
        database::AttemptResult result;
        result.state = AttemptState::completed;
        result.duration_s = result.wall_s = 2;
        recorder.finish(result);
        return recorder.attempt_id();
    }
    void debrief(const std::string& attempt) {
        if (window == nullptr) {
            window = std::make_unique<MainWindow>(services);
            window->resize(1012, 726);
            window->show();
            EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
            window->start();
            window->context().set_session(sessions.at("ed"));
        }
        emit window->context().debrief_wanted(text(attempt), 1.5);
        auto* page = static_cast<DebriefPage*>(window->current_page());
        EXPECT_TRUE(wait_for([&] { return page->is_ready(); }));
    }
    std::vector<database::Comment> seen_by(const std::string& login, const std::string& attempt) {
        return database::Reviews(*services.store()).comments(sessions.at(login), attempt);
    }
    FakeServices services;
    std::map<std::string, Session> sessions;
    std::unique_ptr<MainWindow> window;
};

TEST_F(UnsentComments, AreDraftsOfTheirAuthorWhateverEndsTheReview) {
    const std::string other = record();
    struct End {
        const char* what;
        std::function<void()> end;
        bool of_window = true;  ///< the next one begins with another window
    };
    const std::vector<End> ends = {
        {"another page", [&] { choose_page(*window, "rail_metrics"); }, false},
        {"another attempt", [&] { emit window->context().debrief_wanted(text(other), -1); }, false},
        {"another language", [&] { window->set_language(Language::german); }, false},
        {"another person", [&] { emit window->context().switch_user_wanted(); }},
        {"the lock", [&] { QMetaObject::invokeMethod(window->findChild<IdleWatch*>(), "lock"); }},
        {"the window's end", [&] { window->close(); }}};
    for (const auto& [what, end, of_window] : ends) {
        const std::string attempt = record();
        debrief(attempt);
        QTest::keyClicks(find<QPlainTextEdit>(*window, "comment_text"), "Hold the flap.");
        end();
        const auto drafts = seen_by("ed", attempt);
        ASSERT_EQ(drafts.size(), 1U) << what;
        EXPECT_EQ(drafts[0].text, "Hold the flap.");
        EXPECT_EQ(drafts[0].sent, 0);
        EXPECT_NEAR(drafts[0].time_s, 1.5, 1e-3);
        EXPECT_TRUE(seen_by("tara", attempt).empty()) << what;
        if (language_in_use() != Language::english) window->set_language(Language::english);
        if (of_window) window.reset();
        EXPECT_EQ(seen_by("ed", attempt).size(), 1U) << "kept once: " << what;
    }
    // The same attempt again: the draft is there, and the field is empty.
    debrief(other);
    QTest::keyClicks(find<QPlainTextEdit>(*window, "comment_text"), "Hold the flap.");
    debrief(other);
    EXPECT_EQ(find<QLabel>(*window, "comment_words")->text(), "Hold the flap.");
    EXPECT_TRUE(find<QPlainTextEdit>(*window, "comment_text")->toPlainText().isEmpty());
    // Nothing typed, nothing kept.
    const std::string attempt = record();
    debrief(attempt);
    QTest::keyClicks(find<QPlainTextEdit>(*window, "comment_text"), "  ");
    choose_page(*window, "rail_metrics");
    EXPECT_TRUE(seen_by("ed", attempt).empty());
    // The attempt is erased in between: the page says so.
    debrief(attempt);
    QTest::keyClicks(find<QPlainTextEdit>(*window, "comment_text"), "Too late.");
    {
        const database::Store store = database::Store::open(services.store()->path());
        database::erase_person(store, sessions.at("dora"), sessions.at("tara").person_id(), "asked", false);
    }
    click(*window, "comment_send");
    EXPECT_TRUE(sees(*window, "message_text"));
    choose_page(*window, "rail_metrics");
    EXPECT_EQ(window->current_page()->objectName(), "metrics_page");
}

}  // namespace
}  // namespace fulcrum::ui::window_test
