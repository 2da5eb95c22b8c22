// SPDX-License-Identifier: GPL-3.0-or-later
// The window begins with the theme, the text size and the language that are remembered.
#include <gtest/gtest.h>

#include <QApplication>
#include <QPushButton>
#include <QSettings>
#include <QTemporaryDir>
#include <QTimer>

#include "app/services/application.h"
#include "sim_core/numerics/input_error.h"
#include "ui/style/appearance.h"

namespace fulcrum::app::program_test {
namespace {

class WindowStart : public ::testing::Test {
  protected:
    WindowStart() {
        QSettings().clear();
        qputenv("FULCRUM_DATA", folder_.path().toLocal8Bit());
        qunsetenv("FULCRUM_LANGUAGE");
    }
    ~WindowStart() override {
        QSettings().clear();
        qunsetenv("FULCRUM_DATA");
        qunsetenv("FULCRUM_LANGUAGE");
        ui::use_language(ui::Language::english);
        ui::apply_text_size(*qApp, 100);
        ui::apply_theme(*qApp, ui::Theme::light);
    }
    /// Opens the window, reads the text of its first button and closes it.
    QString first_words() {
        QString shown;
        QTimer look;
        QObject::connect(&look, &QTimer::timeout, [&] {
            for (QWidget* window : QApplication::topLevelWidgets()) {
                if (window->objectName() != "main_window" || !window->isVisible()) continue;
                const auto* button = window->findChild<QPushButton*>("create_programme");
                if (button == nullptr || !button->isVisible()) continue;
                shown = button->text();
                window->close();
            }
        });
        look.start(20);
        EXPECT_EQ(run_window(), 0);
        return shown;
    }

  private:
    QTemporaryDir folder_;
};

TEST_F(WindowStart, UsesTheStandardWhereNothingIsRemembered) {
    EXPECT_EQ(first_words(), "Create programme");
    EXPECT_EQ(ui::current_theme(), ui::Theme::light);
    EXPECT_EQ(ui::text_percent(), 100);
}

TEST_F(WindowStart, UsesWhatIsRemembered) {
    ui::store_theme(ui::Theme::dark);
    ui::store_text_percent(150);
    ui::store_language(ui::Language::german);
    EXPECT_EQ(first_words(), "Programm anlegen");
    EXPECT_EQ(ui::current_theme(), ui::Theme::dark);
    EXPECT_EQ(ui::text_percent(), 150);
}

TEST_F(WindowStart, EnvironmentVariableWinsOverTheLanguageThatIsRemembered) {
    ui::store_language(ui::Language::german);
    qputenv("FULCRUM_LANGUAGE", "en");
    EXPECT_EQ(first_words(), "Create programme");
    EXPECT_EQ(ui::stored_appearance().language, ui::Language::german) << "what is remembered stays";
}

TEST_F(WindowStart, LanguageThatDoesNotExistIsAnErrorThatNamesThoseThatDo) {
    qputenv("FULCRUM_LANGUAGE", "deutsch");
    try {
        run_window();
        FAIL() << "the window was opened";
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(),
                     "FULCRUM_LANGUAGE: \"deutsch\" is not the name of a language; use one of: en, de");
    }
}

}  // namespace
}  // namespace fulcrum::app::program_test
