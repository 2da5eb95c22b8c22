// SPDX-License-Identifier: GPL-3.0-or-later
// Every screen of every role at the largest text size: nothing is cut off. With FULCRUM_PICTURES=FOLDER the
// screens are stored there, in both themes and in German.
#include <gtest/gtest.h>

#include <QPlainTextEdit>
#include <QPushButton>

#include "tests/ui/screens.h"
#include "tests/ui/trace_files.h"
#include "ui/language/language.h"

namespace fulcrum::ui::window_test {
namespace {

class LargeText : public Screens {
  protected:
    ~LargeText() override {
        window.reset();
        apply_text_size(*qApp, 100);
        use_language(Language::english);
    }
};

TEST_F(LargeText, CutsNothingOffOnAnyScreen) {
    const QTemporaryDir folder;
    write_perktutor(folder.filePath(QStringLiteral("needle.xml")).toStdString());
    for (const Language language : {Language::english, Language::german}) {
        open({1024, 768});  // the smallest window
        const std::string attempt = perform();
        window->set_language(language);
        window->set_text_size(200);
        window->set_theme(language == Language::english ? Theme::light : Theme::dark);
        const QString name = QString::fromLatin1(row_of(languages, language).name);
        int seen = 0;
        visit(attempt, [&](const QString& screen) {
            keep("large-" + screen);
            seen += expect_whole(name + ' ' + screen);
            expect_fits(name + ' ' + screen);
            if (const auto* notes = window->findChild<QPlainTextEdit*>("rating_remark")) {
                EXPECT_EQ(notes->maximumHeight(), with_text(84)) << screen.toStdString();
            }
            each_tab(screen, [&](const QString& tab) {
                keep("large-" + tab);
                seen += expect_whole(name + ' ' + tab);
                expect_fits(name + ' ' + tab);
            });
            if (!sees(*window, "show_trace_import")) return;
            click(*window, "show_trace_import");
            read_trace_in(*window, folder.filePath(QStringLiteral("needle.xml")), "perktutor.json");
            settle();
            bring(*find<QPushButton>(*window, "trace_import"));
            keep("large-trace-import");
            EXPECT_GT(expect_whole(name + " trace import"), 15);
            expect_fits(name + " trace import");
            click(*window, "show_trace_import");
        });
        EXPECT_GT(seen, 300);
    }
}

TEST_F(LargeText, LeavesTheWholeWidthToThePageAndAMenuShowsTheOtherPages) {
    open({1024, 768});
    sign_in(Role::trainee);
    EXPECT_FALSE(sees(*window, "menu"));
    EXPECT_TRUE(sees(*window, "rail_metrics"));
    window->set_text_size(200);
    settle();
    EXPECT_TRUE(sees(*window, "menu"));
    EXPECT_FALSE(sees(*window, "rail_metrics"));
    ASSERT_TRUE(become_active(*window));
    const int whole = window->current_page()->width();
    EXPECT_EQ(whole, window->width());

    click(*window, "menu");
    EXPECT_TRUE(sees(*window, "rail_metrics"));
    EXPECT_EQ(window->current_page()->width(), whole) << "the menu lies over the page";
    keep("large-menu");
    QTest::keyClick(window->focusWidget(), Qt::Key_Escape);
    EXPECT_FALSE(sees(*window, "rail_metrics"));

    click(*window, "menu");
    QTest::keyClick(window->focusWidget(), Qt::Key_Tab);
    QTest::keyClick(window->focusWidget(), Qt::Key_Space);
    settle();
    EXPECT_NE(window->current_page()->objectName(), "home_page") << "chosen by keyboard";
    EXPECT_FALSE(sees(*window, "rail_metrics")) << "closed by the choice";

    click(*window, "menu");
    window->resize(1400, 768);
    EXPECT_TRUE(wait_for([&] { return !sees(*window, "menu") && sees(*window, "rail_metrics"); }));
    EXPECT_LT(window->current_page()->width(), window->width());
    window->resize(1024, 768);
    EXPECT_TRUE(wait_for([&] { return sees(*window, "menu") && !sees(*window, "rail_metrics"); }));
}

TEST_F(LargeText, CutsNothingOffOnTheLock) {
    open({1280, 800});
    window->set_text_size(200);
    window = std::make_unique<MainWindow>(services, nullptr, 200, 600000);
    window->resize(1280, 800);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    window->start();
    window->context().set_session(sessions.at(Role::trainee));
    ASSERT_TRUE(wait_for([&] { return sees(*window, "unlock"); }));
    settle();
    keep("large-lock");
    EXPECT_GT(expect_whole("lock"), 3);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
