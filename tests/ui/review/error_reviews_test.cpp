// SPDX-License-Identifier: GPL-3.0-or-later
// An educator confirms and strikes recorded errors in the debrief, with real events; the trainee reads it
// there; who rates blind does not; the score stays.
#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <cmath>
#include <map>

#include "database/records/attempts.h"
#include "database/records/error_reviews.h"
#include "database/records/people.h"
#include "database/records/recorder.h"
#include "database/records/reviews.h"
#include "database/sync/station_erasure.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/charts/time_chart.h"
#include "ui/language/language.h"
#include "ui/review/debrief_page.h"
#include "ui/review/error_review_bar.h"
#include "ui/review/replay_panel.h"
#include "ui/shell/main_window.h"

namespace fulcrum::ui::window_test {
namespace {

using database::ErrorVerdict;
using database::Role;
using database::Session;

class ErrorReviewPages : public ::testing::Test {
  protected:
    ErrorReviewPages() {
        services.open_store(false);
        const database::People people(*services.store());
        const Session alma =
            people.create_programme("Surgery", "alma", "Alma Admin", "correct horse").administrator;
        const auto add = [&](const std::string& login, const std::string& name, Role role) {
            const auto made = people.create(alma, login, name, {role});
            sessions.emplace(login, people.change_password(people.sign_in(login, made.one_time_password),
                                                           made.one_time_password, "a long password"));
        };
        add("tara", "Tara Trainee", Role::trainee);
        add("ed", "Ed Educator", Role::educator);
        add("ida", "Ida Instructor", Role::educator);
        add("dora", "Dora Director", Role::director);
        const std::string cohort = people.create_cohort(sessions.at("dora"), "Spring");
        people.set_members(sessions.at("dora"), cohort, {sessions.at("tara").person_id()});
        people.set_educators(sessions.at("dora"), cohort,
                             {sessions.at("ed").person_id(), sessions.at("ida").person_id()});
        attempt = record();
        window = std::make_unique<MainWindow>(services);
        window->resize(1012, 726);
        window->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        QApplication::setActiveWindow(window.get());  // there is no window manager that would do it
    }
    ~ErrorReviewPages() override {
        use_language(Language::english);
        apply_theme(*qApp, Theme::light);
        apply_text_size(*qApp, 100);
    }
    /// Two seconds with a grasp, a slip and too much force. What slipped may have dropped in the same moment.
    std::string record(bool dropped = false) {
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
            if (tick == 200) recorder.append(Event{tick, EventKind::grasp, 0, -1, 0, 0.0F});
            if (tick == slip_tick) recorder.append(Event{tick, EventKind::slip, 0, -1, 0, 0.0F});
            if (dropped && tick == slip_tick) recorder.append(Event{tick, EventKind::drop, 0, -1, 0, 0.0F});
            if (tick == force_tick)
                recorder.append(Event{tick, EventKind::over_force_begin, 1, -1, 4000, 6.0F});
        }
        database::AttemptResult result;
        result.state = AttemptState::completed;
        result.duration_s = result.wall_s = 2;
        recorder.finish(result);
        return recorder.attempt_id();
    }
    DebriefPage* debrief(const std::string& login) {
        window->context().set_session(sessions.at(login));
        emit window->context().debrief_wanted(QString::fromStdString(attempt), -1);
        auto* page = static_cast<DebriefPage*>(window->current_page());
        EXPECT_TRUE(wait_for([&] { return page->is_ready(); }));
        return page;
    }
    QListWidget* list() { return find<QListWidget>(*window, "event_list"); }
    int row_of(const QString& words) {
        for (int row = 0; row < list()->count(); ++row)
            if (list()->item(row)->text().contains(words)) return row;
        ADD_FAILURE() << "no line with " << words.toStdString();
        return -1;
    }
    void choose(const QString& words) {
        QListWidget* events = list();
        bring(*events);
        QListWidgetItem* item = events->item(row_of(words));
        events->scrollToItem(item);
        QTest::mouseClick(events->viewport(), Qt::LeftButton, {}, events->visualItemRect(item).center());
    }
    void say(const char* reason, const char* button) {
        auto* field = find<QLineEdit>(*window, "review_error_reason");
        bring(*field);
        QTest::mouseClick(field, Qt::LeftButton);
        QTest::keyClicks(field, reason);
        click(*window, button);
    }
    QString label(const char* name) { return find<QLabel>(*window, name)->text(); }
    std::vector<database::ErrorReview> reviews() {
        return database::ErrorReviews(*services.store()).history(sessions.at("tara"), attempt);
    }
    void keep(const char* name) {
        const QByteArray folder = qgetenv("FULCRUM_PICTURES");
        if (!folder.isEmpty())
            window->grab().save(QString::fromLocal8Bit(folder) + "/error-review-" + name + ".png");
    }
    static constexpr std::uint32_t slip_tick = 600, force_tick = 1200;
    FakeServices services;
    std::map<std::string, Session> sessions;
    std::string attempt;
    std::unique_ptr<MainWindow> window;
};

TEST_F(ErrorReviewPages, AnEducatorStrikesAndConfirmsAndTheTraineeReadsIt) {
    debrief("ed");
    EXPECT_FALSE(find<QAbstractButton>(*window, "review_error_strike")->isEnabled()) << "nothing is chosen";
    choose("Grasp");
    EXPECT_FALSE(find<QAbstractButton>(*window, "review_error_strike")->isEnabled()) << "no error";
    choose("slipped");
    EXPECT_TRUE(label("review_error_chosen").contains("slipped"));
    click(*window, "review_error_strike");
    EXPECT_TRUE(reviews().empty()) << "not without a reason";
    EXPECT_EQ(QApplication::focusWidget()->objectName(), "review_error_reason");
    auto* reason = find<QLineEdit>(*window, "review_error_reason");
    QTest::keyClicks(reason, "The flap was ");
    emit window->context().theme_wanted(Theme::dark);
    EXPECT_EQ(find<QLineEdit>(*window, "review_error_reason")->text(), "The flap was ");
    QTest::keyClicks(reason, "torn before.");
    keep("chosen-dark");
    click(*window, "review_error_strike");
    ASSERT_EQ(reviews().size(), 1U);
    EXPECT_EQ(reviews()[0].verdict, ErrorVerdict::struck);
    EXPECT_EQ(reviews()[0].tick, slip_tick);
    EXPECT_TRUE(reason->text().isEmpty());
    const auto expect_struck = [&] {
        const int row = row_of("slipped");
        ASSERT_LT(row + 1, list()->count());
        EXPECT_TRUE(list()->item(row)->font().strikeOut());
        EXPECT_TRUE(
            list()->item(row + 1)->text().contains("struck by Ed Educator: The flap was torn before."));
        EXPECT_FALSE(list()->item(row + 1)->font().strikeOut());
        EXPECT_TRUE(list()->item(row)->data(Qt::AccessibleTextRole).toString().contains("torn before"));
        EXPECT_TRUE(label("debrief_notes").contains("struck 1 error"))
            << label("debrief_notes").toStdString();
    };
    expect_struck();

    // By keyboard alone: a line of the list, then the field, then the button.
    choose("slipped");
    QTest::keyClick(list(), Qt::Key_Down);
    EXPECT_TRUE(label("review_error_chosen").contains("Too much force")) << "over the line of the note";
    QTest::keyClick(list(), Qt::Key_Tab);
    ASSERT_EQ(QApplication::focusWidget()->objectName(), "review_error_reason");
    QTest::keyClicks(QApplication::focusWidget(), "Seen.");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    ASSERT_EQ(QApplication::focusWidget()->objectName(), "review_error_confirm");
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Space);
    ASSERT_EQ(reviews().size(), 2U);
    EXPECT_EQ(QApplication::focusWidget()->objectName(), "review_error_reason");
    EXPECT_EQ(reviews()[1].verdict, ErrorVerdict::confirmed);
    keep("done-dark");
    emit window->context().theme_wanted(Theme::light);
    keep("done-light");

    debrief("tara");
    expect_struck();
    EXPECT_TRUE(
        list()->item(row_of("Too much force") + 1)->text().contains("✓ confirmed by Ed Educator: Seen."));
    EXPECT_FALSE(list()->item(row_of("Too much force"))->font().strikeOut());
    EXPECT_FALSE(sees(*window, "review_error_reason"));
    keep("trainee-light");
    debrief("dora");
    expect_struck();
    EXPECT_FALSE(sees(*window, "review_error_reason")) << "directors read";
}

TEST_F(ErrorReviewPages, TheReplayMovesTheCursorAndNotTheChoice) {
    debrief("ed");
    choose("slipped");
    window->findChild<ReplayPanel*>()->seek(1.9);
    EXPECT_TRUE(list()->currentItem()->text().contains("Too much force"));
    say("The flap was torn before.", "review_error_strike");
    ASSERT_EQ(reviews().size(), 1U);
    EXPECT_EQ(reviews()[0].kind, EventKind::slip);
    EXPECT_FALSE(find<QAbstractButton>(*window, "review_error_strike")->isEnabled())
        << "another one has to be chosen";
    // The newest counts.
    choose("slipped");
    say("I looked again.", "review_error_confirm");
    EXPECT_FALSE(list()->item(row_of("slipped"))->font().strikeOut());
    EXPECT_FALSE(label("debrief_notes").contains("struck"));
}

TEST_F(ErrorReviewPages, ARaterWhoIsBlindReadsOwnReviewsOnly) {
    database::ErrorReviews(*services.store())
        .add(sessions.at("ed"), attempt, Event{slip_tick, EventKind::slip, 0, -1, 0, 0.0F},
             ErrorVerdict::struck, "Tara has told me.");
    window->context().set_session(sessions.at("ida"));
    emit window->context().rating_wanted(QString::fromStdString(attempt));
    auto* page = static_cast<DebriefPage*>(window->current_page());
    ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    ASSERT_TRUE(sees(*window, "rating_blind_notice"));
    const auto shown = [&] {
        QString all;
        for (int row = 0; row < list()->count(); ++row) all += list()->item(row)->text() + "\n";
        return all;
    };
    EXPECT_FALSE(shown().contains("Tara")) << shown().toStdString();
    EXPECT_FALSE(list()->item(row_of("slipped"))->font().strikeOut());
    choose("Too much force");
    say("Seen.", "review_error_confirm");
    EXPECT_TRUE(shown().contains("confirmed by Ida Instructor: Seen.")) << "her own";
    EXPECT_FALSE(shown().contains("Tara"));
    EXPECT_TRUE(sees(*window, "rating_blind_notice")) << "still blind";
    click(*window, "lift_blinding");
    EXPECT_TRUE(shown().contains("Tara has told me."));
}

TEST_F(ErrorReviewPages, TheMarksInTheChartsShowWhatWasStruckAndConfirmed) {
    debrief("ed");
    const auto mark = [&](double time) {
        for (const ChartMark& one : find<TimeChart>(*window, "force_chart")->marks())
            if (std::abs(one.time - time) < 1e-6) return one;
        ADD_FAILURE() << "no mark at " << time;
        return ChartMark();
    };
    EXPECT_EQ(mark(0.6).review, MarkReview::none);
    choose("slipped");
    say("The flap was torn before.", "review_error_strike");
    choose("Too much force");
    say("Seen.", "review_error_confirm");
    EXPECT_EQ(mark(0.6).review, MarkReview::struck);
    EXPECT_TRUE(mark(0.6).text.contains("struck by Ed Educator: The flap was torn before."));
    EXPECT_EQ(mark(1.2).review, MarkReview::confirmed);
    EXPECT_EQ(mark(0.2).review, MarkReview::none) << "a grasp is no error";
    keep_picture(*window, "error-review-marks-light");
    emit window->context().theme_wanted(Theme::dark);
    keep_picture(*window, "error-review-marks-dark");
    debrief("tara");
    EXPECT_EQ(mark(0.6).review, MarkReview::struck);
    choose("slipped");
    debrief("ed");
    choose("slipped");
    say("I looked again.", "review_error_confirm");
    EXPECT_EQ(mark(0.6).review, MarkReview::confirmed) << "the newest counts";
}

TEST_F(ErrorReviewPages, AReasonThatWasBegunIsThereAgain) {
    const auto reason = [&] { return find<QLineEdit>(*window, "review_error_reason"); };
    const auto drafts = [&](const char* login) {
        std::vector<std::string> all;
        for (const auto& one : database::Reviews(*services.store()).comments(sessions.at(login), attempt))
            if (is_begun_reason(one)) all.push_back(one.text);
        return all;
    };
    const auto away = [&] { choose_page(*window, "rail_metrics"); };
    const auto begin = [&](const char* words) {
        choose("Too much force");
        QTest::mouseClick(reason(), Qt::LeftButton);
        QTest::keyClicks(reason(), words);
    };
    debrief("ed");
    begin("The cam");
    away();
    ASSERT_EQ(drafts("ed").size(), 1U) << "the page was left";
    EXPECT_TRUE(drafts("ida").empty()) << "of its author alone";
    EXPECT_TRUE(reviews().empty());
    debrief("ed");
    EXPECT_EQ(reason()->text(), "The cam");
    EXPECT_TRUE(label("review_error_chosen").contains("Too much force")) << "of the error that it is about";
    EXPECT_TRUE(find<QAbstractButton>(*window, "review_error_strike")->isEnabled());
    EXPECT_FALSE(sees(*window, "draft_send")) << "it is not for sending";
    // Typed on: it stays one draft, also in another language and when the screen is locked.
    QTest::keyClicks(reason(), "era was");
    emit window->context().language_wanted(Language::german);
    debrief("ed");
    EXPECT_EQ(reason()->text(), "The camera was");
    ASSERT_EQ(drafts("ed").size(), 1U);
    emit window->context().language_wanted(Language::english);
    debrief("ed");
    QTest::keyClicks(reason(), " off");
    away();
    debrief("ida");
    EXPECT_TRUE(reason()->text().isEmpty());
    begin("Hers");
    away();
    debrief("tara");
    EXPECT_TRUE(drafts("tara").empty());
    debrief("ed");
    EXPECT_EQ(reason()->text(), "The camera was off");
    bring(*find<QAbstractButton>(*window, "review_error_strike"));
    click(*window, "review_error_strike");
    ASSERT_EQ(reviews().size(), 1U);
    EXPECT_EQ(reviews()[0].reason, "The camera was off");
    EXPECT_EQ(reviews()[0].tick, force_tick);
    EXPECT_TRUE(drafts("ed").empty()) << "it was given";
    EXPECT_EQ(drafts("ida").size(), 1U);
    EXPECT_FALSE(sees(*window, "draft_delete"));
    // Emptied is dropped; deleted among the comments it does not come back.
    debrief("ida");
    reason()->selectAll();
    QTest::keyClick(reason(), Qt::Key_Delete);
    debrief("ida");
    EXPECT_TRUE(drafts("ida").empty());
    EXPECT_TRUE(reason()->text().isEmpty());
    begin("Once more");
    debrief("ida");
    bring(*find<QAbstractButton>(*window, "draft_delete"));
    click(*window, "draft_delete");
    EXPECT_TRUE(reason()->text().isEmpty());
    debrief("ida");
    EXPECT_TRUE(drafts("ida").empty());
}

TEST_F(ErrorReviewPages, AReasonThatWasBegunStaysWithItsErrorAmongSeveralOfOneMoment) {
    attempt = record(true);
    const auto leave_and_return = [&] {
        choose_page(*window, "rail_metrics");
        debrief("ed");
    };
    const auto begin = [&](const char* error, const char* words) {
        choose(error);
        auto* reason = find<QLineEdit>(*window, "review_error_reason");
        QTest::mouseClick(reason, Qt::LeftButton);
        QTest::keyClicks(reason, words);
    };
    const auto drafts = [&] {
        std::vector<database::Comment> all;
        for (const auto& one : database::Reviews(*services.store()).comments(sessions.at("ed"), attempt))
            if (is_begun_reason(one)) all.push_back(one);
        return all;
    };
    debrief("ed");
    begin("dropped", "It fell on its own.");
    leave_and_return();
    EXPECT_TRUE(label("review_error_chosen").contains("dropped"))
        << label("review_error_chosen").toStdString();
    ASSERT_EQ(drafts().size(), 1U);
    EXPECT_EQ(begun_words(drafts()[0]), "It fell on its own.");
    EXPECT_TRUE(label("comment_words").endsWith("It fell on its own."));
    EXPECT_FALSE(label("comment_words").contains("600")) << "what names the error is not shown";
    bring(*find<QAbstractButton>(*window, "review_error_strike"));
    click(*window, "review_error_strike");
    ASSERT_EQ(reviews().size(), 1U);
    EXPECT_EQ(reviews()[0].kind, EventKind::drop);
    EXPECT_EQ(reviews()[0].reason, "It fell on its own.");
    EXPECT_TRUE(drafts().empty());

    // Another line is looked at, which is no error: the reason stays with the error that it is about.
    begin("Too much force", "A twitch.");
    choose("Grasp");
    EXPECT_FALSE(find<QAbstractButton>(*window, "review_error_strike")->isEnabled());
    leave_and_return();
    ASSERT_EQ(drafts().size(), 1U);
    EXPECT_NEAR(drafts()[0].time_s, 1.2, 1e-9);
    EXPECT_TRUE(label("review_error_chosen").contains("Too much force"));
    EXPECT_EQ(find<QLineEdit>(*window, "review_error_reason")->text(), "A twitch.");
    // Another error that is chosen takes it.
    choose("slipped");
    leave_and_return();
    ASSERT_EQ(drafts().size(), 1U);
    EXPECT_TRUE(label("review_error_chosen").contains("slipped"));

    // A draft of an older program names no error: of two in its moment none is chosen.
    choose_page(*window, "rail_metrics");
    const database::Reviews comments(*services.store());
    comments.edit_draft(sessions.at("ed"), drafts()[0].id, 0.6,
                        database::begun_reason_mark + std::string("Old."));
    debrief("ed");
    EXPECT_EQ(find<QLineEdit>(*window, "review_error_reason")->text(), "Old.");
    EXPECT_FALSE(find<QAbstractButton>(*window, "review_error_strike")->isEnabled());
}

TEST_F(ErrorReviewPages, AVoidTakesNothingBackAndAnErasedAttemptIsRefused) {
    debrief("ed");
    database::Attempts(*services.store()).void_attempt(sessions.at("ida"), attempt, "the camera was off");
    choose("slipped");
    say("The flap was torn before.", "review_error_strike");
    EXPECT_EQ(reviews().size(), 1U) << "a void takes nothing back";
    choose("Too much force");
    {
        const database::Store store = database::Store::open(services.store()->path());
        database::erase_person(store, sessions.at("dora"), sessions.at("tara").person_id(), "asked", false);
    }
    say("Too late.", "review_error_confirm");
    EXPECT_TRUE(sees(*window, "message_text"));
    EXPECT_EQ(find<QLineEdit>(*window, "review_error_reason")->text(), "Too late.") << "the words stay";
}

TEST_F(ErrorReviewPages, FitTheSmallestWindowWithLargeTextInBothThemesAndLanguages) {
    struct Look {
        Theme theme;
        Language language;
        const char* name;
    };
    for (const Look& look : {Look{Theme::light, Language::english, "large-light"},
                             Look{Theme::dark, Language::german, "large-dark-german"}}) {
        emit window->context().theme_wanted(look.theme);
        emit window->context().language_wanted(look.language);
        window->set_text_size(200);
        debrief("ed");
        QListWidget* events = list();
        events->setCurrentRow(1);
        auto* field = find<QLineEdit>(*window, "review_error_reason");
        bring(*field);
        QCoreApplication::processEvents();
        for (const char* name : {"review_error_reason", "review_error_confirm", "review_error_strike"}) {
            auto* widget = find<QWidget>(*window, name);
            const QRect place(widget->mapTo(window.get(), QPoint()), widget->size());
            EXPECT_TRUE(place.left() >= 0 && place.right() <= window->width()) << look.name << " " << name;
            EXPECT_FALSE(widget->accessibleName().isEmpty()) << name;
            bring(*widget);
            EXPECT_FALSE(widget->visibleRegion().isEmpty()) << look.name << " " << name;
        }
        keep(look.name);
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
