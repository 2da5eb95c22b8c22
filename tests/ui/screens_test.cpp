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
    visit(attempt, [&](const QString& screen) {
        expect_fits(screen);
        EXPECT_EQ(error_shown().toStdString(), "") << screen.toStdString();
        // The name of the person is whole: the one of the programme gives way.
        const auto* person = window->findChild<QLabel*>("signed_in_person");
        if (person->isVisible()) {
            EXPECT_GE(person->width() + 1, person->sizeHint().width()) << screen.toStdString();
        }
    });
    window->start();
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

TEST_F(Screens, FirstStartFitsASmallDisplay) {
    FakeServices empty;
    window = std::make_unique<MainWindow>(empty);
    size_ = QSize(1012, 726);
    window->resize(size_);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    window->start();
    settle();
    EXPECT_EQ(window->current_page()->objectName(), "first_start_page");
    expect_fits("first start");
    click(*window, "create_programme");
    settle();
    expect_fits("create programme");
    window.reset();
}

TEST_F(Screens, FollowAThemeSwitchedWhileTheyAreOpen) {
    open({1200, 760});
    const std::string attempt = perform();
    // A new sign-in makes every page again, and without pages the theme is switched at once.
    const auto compare = [&](const QString& screen, const std::function<void()>& show) {
        window->context().sign_out();
        window->set_theme(Theme::dark);
        show();
        const QImage fresh = window->grab().toImage();
        window->context().sign_out();
        window->set_theme(Theme::light);
        show();
        window->set_theme(Theme::dark);
        settle();
        const QImage switched = window->grab().toImage();
        ASSERT_EQ(fresh.size(), switched.size());
        int differ = 0;
        for (int y = 0; y < fresh.height(); ++y) {
            for (int x = 0; x < fresh.width(); ++x) differ += fresh.pixel(x, y) != switched.pixel(x, y);
        }
        EXPECT_LT(differ, fresh.width() * fresh.height() / 2000) << screen.toStdString();
        if (differ > 0 && qEnvironmentVariableIsSet("FULCRUM_PICTURES")) {
            keep(screen + "-switched");
            fresh.save(QString::fromLocal8Bit(qgetenv("FULCRUM_PICTURES")) + "/" + screen + "-fresh.png");
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
    // Without FULCRUM_PICTURES the pictures are drawn into a temporary folder.
    QTemporaryDir own;
    const bool asked = !qEnvironmentVariableIsEmpty("FULCRUM_PICTURES");
    if (!asked) qputenv("FULCRUM_PICTURES", own.path().toLocal8Bit());
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
        visit(attempt, [&](const QString& screen) {
            keep(screen);
            for (const QPushButton* button : window->findChildren<QPushButton*>()) {
                if (!button->isVisible()) continue;
                EXPECT_GE(button->width(), button->sizeHint().width())
                    << screen.toStdString() << ": " << button->text().toStdString();
            }
        });
    }
    const QStringList pictures =
        QDir(QString::fromLocal8Bit(qgetenv("FULCRUM_PICTURES"))).entryList({"*.png"}, QDir::Files);
    for (const PictureKind& kind : kinds)
        EXPECT_GE(pictures.filter(QRegularExpression('-' + kind.name() + "\\.png$")).size(), 15)
            << kind.name().toStdString();
    window.reset();
    apply_text_size(*qApp, 100);
    use_language(Language::english);
    if (!asked) qunsetenv("FULCRUM_PICTURES");
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
