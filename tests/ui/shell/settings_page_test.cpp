// SPDX-License-Identifier: GPL-3.0-or-later
// The page of settings, used with mouse and keyboard: each choice applies at once and is remembered.
#include "ui/shell/settings_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>

#include "tests/ui/settings_screens.h"
#include "ui/shell/page_table.h"
#include "ui/style/appearance.h"

namespace fulcrum::ui::window_test {
namespace {

class Settings : public SettingsScreens {
  protected:
    QString focused() {
        const QWidget* widget = window->focusWidget();
        return widget != nullptr ? widget->objectName() : QString();
    }
};

TEST_F(Settings, AreOfferedToEveryRole) {
    open({1280, 800});
    for (const auto& [role, session] : sessions) {
        sign_in(role);
        go_to("rail_settings");
        EXPECT_EQ(window->current_page()->objectName(), "settings_page") << database::role_name(role);
        EXPECT_EQ(error_shown(), "");
    }
}

TEST_F(Settings, ThemeAppliesAtOnceIsRememberedAndFollowsTheButton) {
    open_page();
    auto* dark = find<QRadioButton>(*window, "theme_dark");
    auto* light = find<QRadioButton>(*window, "theme_light");
    EXPECT_TRUE(light->isChecked());
    check(*window, "theme_dark");
    EXPECT_EQ(current_theme(), Theme::dark);
    EXPECT_EQ(stored_appearance().theme, Theme::dark);
    EXPECT_EQ(find<QPushButton>(*window, "theme")->text(), "Light");
    click(*window, "theme");
    EXPECT_EQ(current_theme(), Theme::light);
    EXPECT_TRUE(light->isChecked());
    EXPECT_FALSE(dark->isChecked());
    EXPECT_EQ(find<QPushButton>(*window, "theme")->text(), "Dark");
    EXPECT_EQ(stored_appearance().theme, Theme::light);
}

TEST_F(Settings, TextSizeAppliesAtOnceAndIsRemembered) {
    open_page();
    const double usual = qApp->font().pointSizeF();
    auto* size = find<QComboBox>(*window, "text_size");
    EXPECT_EQ(size->currentText(), "100 %");
    size->setFocus();
    for (int i = 0; i < 4; ++i) QTest::keyClick(find<QComboBox>(*window, "text_size"), Qt::Key_Down);
    settle();
    EXPECT_EQ(text_percent(), 200);
    EXPECT_DOUBLE_EQ(qApp->font().pointSizeF(), 2 * usual);
    EXPECT_EQ(stored_appearance().text_percent, 200);
    EXPECT_EQ(window->current_page()->objectName(), "settings_page");
    EXPECT_EQ(find<QComboBox>(*window, "text_size")->currentText(), "200 %");
    EXPECT_EQ(focused(), "text_size") << "the keyboard stays where it was";
    QTest::keyClick(find<QComboBox>(*window, "text_size"), Qt::Key_Home);
    settle();
    EXPECT_DOUBLE_EQ(qApp->font().pointSizeF(), usual);
}

TEST_F(Settings, LanguageAppliesAtOnceToAllOfTheWindowAndIsRemembered) {
    open_page();
    EXPECT_EQ(find<QPushButton>(*window, "rail_home")->text(), "Home");
    check(*window, "language_de");
    settle();
    EXPECT_EQ(language_in_use(), Language::german);
    EXPECT_EQ(stored_appearance().language, Language::german);
    EXPECT_EQ(window->current_page()->objectName(), "settings_page");
    EXPECT_EQ(focused(), "language_de");
    EXPECT_EQ(find<QPushButton>(*window, "rail_settings")->text(), "Einstellungen");
    EXPECT_EQ(find<QPushButton>(*window, "switch_user")->text(), "Benutzerwechsel");
    EXPECT_TRUE(find<QRadioButton>(*window, "language_de")->isChecked());
    EXPECT_EQ(window->locale().language(), QLocale::German);
    // Another page, and the lock, are those of the new language too.
    go_to("rail_progress");
    EXPECT_EQ(find<QPushButton>(*window, "rail_progress")->text(), "Mein Fortschritt");
    go_to("rail_settings");
    check(*window, "language_en");
    settle();
    EXPECT_EQ(find<QPushButton>(*window, "rail_settings")->text(), "Settings");
}

/// Every message can be put into German (test_structure: Sentences.*; test_ui: German.*, GermanMessages.*).
TEST_F(Settings, GermanIsOfferedWithoutReservation) {
    open_page();
    const auto* german = find<QRadioButton>(*window, "language_de");
    EXPECT_TRUE(german->accessibleDescription().isEmpty()) << german->accessibleDescription().toStdString();
    for (const QLabel* label : window->findChildren<QLabel*>())
        EXPECT_FALSE(label->isVisible() && label->text().contains("in English"))
            << label->text().toStdString();
}

TEST_F(Settings, EnvironmentVariableWinsAndThePageSaysSo) {
    const QByteArray before = qgetenv("FULCRUM_LANGUAGE");
    store_language(Language::german);
    qputenv("FULCRUM_LANGUAGE", "en");
    EXPECT_EQ(chosen_language(stored_appearance().language), Language::english);
    open_page();
    EXPECT_FALSE(find<QRadioButton>(*window, "language_de")->isEnabled());
    int said = 0;
    for (const QLabel* label : window->findChildren<QLabel*>())
        said += label->isVisible() && label->text().contains("FULCRUM_LANGUAGE");
    EXPECT_EQ(said, 1);
    if (before.isNull())
        qunsetenv("FULCRUM_LANGUAGE");
    else
        qputenv("FULCRUM_LANGUAGE", before);
}

TEST_F(Settings, EveryControlIsReachedByTheKeyboardAndHasAName) {
    open_page();
    ASSERT_TRUE(become_active(*window));
    EXPECT_EQ(focused(), "theme_light");
    QTest::keyClick(window->focusWidget(), Qt::Key_Right);
    EXPECT_EQ(current_theme(), Theme::dark);
    QStringList reached;
    for (int i = 0; i < 6; ++i) {
        reached << focused();
        EXPECT_NE(window->focusWidget()->property("accessibleName").toString(), "")
            << focused().toStdString();
        QTest::keyClick(window->focusWidget(), Qt::Key_Tab);
    }
    for (const char* name : {"theme_dark", "text_size", "language_en"})
        EXPECT_TRUE(reached.contains(name)) << name << " of " << reached.join(' ').toStdString();
}

TEST_F(Settings, DamagedSettingsAreReadAsTheStandard) {
    QSettings().setValue("theme", "purple");
    QSettings().setValue("text_percent", "large");
    QSettings().setValue("language", 7);
    const Appearance look = stored_appearance();
    EXPECT_EQ(look.theme, Theme::light);
    EXPECT_EQ(look.text_percent, 100);
    EXPECT_EQ(look.language, Language::english);
    for (const auto& [stored, used] : {std::pair{-5, 100}, {131, 125}, {190, 200}, {1000000, 200}}) {
        QSettings().setValue("text_percent", stored);
        EXPECT_EQ(stored_appearance().text_percent, used) << stored;
    }
}

TEST_F(Settings, AreDrawnInBothThemesAndLanguages) {
    open_page();
    for (const Theme theme : {Theme::light, Theme::dark}) {
        window->set_theme(theme);
        for (const Language language : {Language::english, Language::german}) {
            window->set_language(language);
            settle();
            expect_fits("settings");
            keep(QStringLiteral("settings-") + QLatin1String(row_of(languages, language).name));
        }
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
