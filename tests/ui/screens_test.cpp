// SPDX-License-Identifier: GPL-3.0-or-later
// Every screen of every role: none reports an error without an action, all fit a small display, and a change
// of theme changes all of them. With FULCRUM_PICTURES=FOLDER the screens are stored there, in both themes at
// 1024 x 768 and 1920 x 1080, or as FULCRUM_PICTURES_AS says.
#include <gtest/gtest.h>

#include <QImage>
#include <QPushButton>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "database/records/people.h"
#include "tests/ui/picture_kinds.h"
#include "tests/ui/screens.h"
#include "ui/shell/page_table.h"
#include "ui/shell/picture_card.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/renderer/scene_renderer.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::ui::window_test {
namespace {

TEST_F(Screens, FitASmallDisplayWithoutAnError) {
    open({1012, 726});  // 1024 x 768 without the frame
    const std::string attempt = perform();
    QStringList visited;
    visit(attempt, [&](const QString& screen) {
        visited << screen;
        expect_fits(screen);
        EXPECT_EQ(error_shown().toStdString(), "") << screen.toStdString();
        // The name of the person is whole: the one of the programme gives way.
        const auto* person = window->findChild<QLabel*>("signed_in_person");
        if (person->isVisible()) {
            EXPECT_GE(person->width() + 1, person->sizeHint().width()) << screen.toStdString();
        }
    });
    window->start();
    for (const char* state :
         {"trainee-settings-device", "trainee-settings-calibration", "lock", "trainee-theatre-paused",
          "trainee-theatre-device-lost", "trainee-theatre-realignment", "educator-debrief-rating", "repair",
          "first-start", "create-programme", "join-programme", "sign-in"})
        EXPECT_EQ(visited.count(state), 1) << state;
}

TEST_F(Screens, AttemptBeginsWithTheHandThatTheFirstGoalAsksFor) {
    open({1012, 726});
    sign_in(Role::trainee);
    emit window->context().attempt_wanted("A2", false, 0, false);
    const auto* page = static_cast<TheatrePage*>(window->current_page());
    ASSERT_NE(page->input(), nullptr);
    EXPECT_EQ(page->input()->active_hand(), Hand::left);
    emit window->context().home_wanted();
    settle();
}

TEST_F(Screens, SettingsShowHowThePictureIsDrawnAndWhy) {
    open({1012, 726});
    sign_in(Role::trainee);
    go_to("rail_settings");
    const QString shown = window->findChild<QLabel*>("picture_quality")->text();
    for (const char* part : {"Drawn by: ", "Resolution: ", "Anti-aliasing: "})
        EXPECT_TRUE(shown.contains(part)) << part << shown.toStdString();
    PictureQuality quality;
    quality.software = true;
    quality.smoothing = Smoothing::edges;
    EXPECT_TRUE(PictureCard::picture_text(quality).contains("because OpenGL offers no graphics card here"));
    EXPECT_TRUE(PictureCard::picture_text(quality).contains("would take too long on a processor"));
    quality.software = false;
    EXPECT_TRUE(PictureCard::picture_text(quality).contains("Resolution: that of the window. If drawing"));
}

TEST_F(Screens, TheRecoveryCodeIsLeftOnlyOnceItIsNoted) {
    FakeServices empty;
    window = std::make_unique<MainWindow>(empty);
    size_ = QSize(1012, 726);
    window->resize(size_);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    window->start();
    settle();
    click(*window, "create_programme");
    type_programme(*window);
    click(*window, "create_confirm");
    ASSERT_TRUE(wait_for([&] { return sees(*window, "code_continue"); }));
    settle();
    EXPECT_TRUE(window->context().signed_in());
    EXPECT_FALSE(sees(*window, "rail_password")) << "the list of pages leads away from it";
    expect_fits("recovery code");
    keep("recovery-code");
    check(*window, "code_noted");
    click(*window, "code_continue");
    settle();
    EXPECT_TRUE(sees(*window, "rail_password"));
    window.reset();
}

TEST_F(Screens, FollowAThemeSwitchedWhileTheyAreOpen) {
    open({1200, 760});
    const std::string attempt = perform();
    // A new sign-in makes every page again. Each screen is opened in either theme and switched to the other.
    const auto compare = [&](const QString& screen, const std::function<void()>& show) {
        QImage fresh[2], switched[2];  // light, dark
        for (const Theme theme : {Theme::light, Theme::dark}) {
            const int before = theme == Theme::light ? 0 : 1, after = 1 - before;
            window->context().sign_out();
            show();
            fresh[before] = window->grab().toImage();
            window->set_theme(theme == Theme::light ? Theme::dark : Theme::light);
            settle();
            switched[after] = window->grab().toImage();
        }
        for (const int theme : {0, 1}) {
            const char* name = theme == 0 ? "light" : "dark";
            const QImage &one = fresh[theme], &other = switched[theme];
            ASSERT_EQ(one.size(), other.size());
            if (one == other) continue;
            int differ = 0;
            for (int y = 0; y < one.height(); ++y)
                for (int x = 0; x < one.width(); ++x) differ += one.pixel(x, y) != other.pixel(x, y);
            EXPECT_LT(differ, one.width() * one.height() / 2000) << screen.toStdString() << ", " << name;
            if (const QString folder = qEnvironmentVariable("FULCRUM_PICTURES"); !folder.isEmpty()) {
                one.save(folder + '/' + screen + "-fresh-" + name + ".png");
                other.save(folder + '/' + screen + "-switched-" + name + ".png");
            }
        }
    };
    for (const auto& [role, session] : sessions) {
        const QString who = role_text(database::role_name(role));
        sign_in(role);
        for (const char* name : rail()) {
            compare(who + '-' + name, [&, role = role] {
                sign_in(role);
                go_to(name);
                window->setFocus();
                settle();
            });
        }
        if (role != Role::administrator) {
            compare(who + "-debrief", [&, role = role] {
                sign_in(role);
                emit window->context().debrief_wanted(text(attempt), -1);
                wait_for_debrief();
                EXPECT_TRUE(wait_for([&] {
                    for (TheatreView* view : window->findChildren<TheatreView*>()) {
                        if (view->isVisible()) return view->pictures() > 0;
                    }
                    return false;
                }));
                window->setFocus();
                settle();
            });
        }
    }
}

TEST_F(Screens, AreDrawnInBothThemesAtBothSizes) {
    const bool asked = !qEnvironmentVariableIsEmpty("FULCRUM_PICTURES");
    open({1024, 768});
    const std::string attempt = perform();
    const auto kinds = picture_kinds({{{1024, 768}, Theme::light},
                                      {{1024, 768}, Theme::dark},
                                      {{1920, 1080}, Theme::light},
                                      {{1920, 1080}, Theme::dark}});
    for (const PictureKind& kind : kinds) {
        window->set_theme(kind.theme);
        if (kind.language != language_in_use()) window->set_language(kind.language);
        if (kind.percent != text_percent()) window->set_text_size(kind.percent);
        window->resize(kind.size);
        size_ = kind.size;
        settle();
        int drawn = 0;
        visit(attempt, [&](const QString& screen) {
            if (asked) keep(screen);
            drawn += window->grab().isNull() ? 0 : 1;
            for (const QPushButton* button : window->findChildren<QPushButton*>()) {
                if (!button->isVisible()) continue;
                EXPECT_GE(button->width(), button->sizeHint().width())
                    << screen.toStdString() << ": " << button->text().toStdString();
            }
        });
        EXPECT_GE(drawn, 26) << kind.name().toStdString();
    }
    window.reset();
    apply_text_size(*qApp, 100);
    use_language(Language::english);
}

TEST_F(Screens, WindowWithItsFrameStaysWithinTheDisplay) {
    const QMargins frame(6, 36, 6, 6);
    for (const QRect available : {QRect(0, 0, 1024, 768), QRect(0, 28, 1280, 772), QRect(1920, 0, 800, 600),
                                  QRect(0, 0, 2560, 1440)}) {
        QRect wanted(QPoint(), QSize(1280, 800));
        wanted.moveCenter(available.center());
        const QRect fitted = fit_window(wanted, available, frame);
        EXPECT_TRUE(available.contains(fitted.marginsAdded(frame)))
            << available.width() << " x " << available.height();
        if (available.width() > 2000) {
            EXPECT_EQ(fitted, wanted);
        }
    }
    // The window itself, on the display that the test has.
    open({1280, 800});
    MainWindow fresh(services);
    fresh.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&fresh));
    EXPECT_TRUE(fresh.screen()->availableGeometry().contains(fresh.geometry().marginsAdded(frame)));
}

}  // namespace
}  // namespace fulcrum::ui::window_test
