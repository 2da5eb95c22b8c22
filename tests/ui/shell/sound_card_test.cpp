// SPDX-License-Identifier: GPL-3.0-or-later
// Sound on the page of settings: on and off, volume, the test, and why there is none.
#include "ui/shell/sound_card.h"

#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>

#include "tests/ui/screens.h"
#include "ui/language/language.h"

namespace fulcrum::ui::window_test {
namespace {

class SoundOnThePage : public Screens {
  protected:
    ~SoundOnThePage() override {
        window.reset();
        use_language(Language::english);
    }
    /// Draws the card as it is; with FULCRUM_PICTURES it is kept.
    void draw(SoundCard& card, const char* name, int width) {
        card.resize(width, card.heightForWidth(width));
        settle();
        const QPixmap drawn = card.grab();
        EXPECT_FALSE(drawn.isNull());
        if (const QString folder = qEnvironmentVariable("FULCRUM_PICTURES"); !folder.isEmpty())
            drawn.save(folder + QStringLiteral("/sound-") + QLatin1String(name) + QStringLiteral(".png"));
    }
};

TEST_F(SoundOnThePage, IsOnAtAModerateVolumeAndEachChoiceAppliesAtOnce) {
    services.open_store(false);
    Context context(services);
    SoundCard card(context);
    card.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&card));
    auto* wanted = card.findChild<QCheckBox*>("sound_wanted");
    auto* volume = card.findChild<QComboBox*>("sound_volume");
    auto* test = card.findChild<QPushButton*>("test_sound");
    auto* trouble = card.findChild<QLabel*>("sound_trouble");
    EXPECT_TRUE(wanted->isChecked());
    EXPECT_EQ(volume->currentText(), "50 %");
    EXPECT_FALSE(trouble->isVisible());
    volume->setFocus();
    QTest::keyClick(volume, Qt::Key_Down);
    EXPECT_DOUBLE_EQ(services.sound.volume, 0.75);
    QTest::mouseClick(test, Qt::LeftButton);
    EXPECT_EQ(services.heard.tests, 1U);
    services.no_sound = {"No sound: %1", std::string("nothing is there")};
    EXPECT_TRUE(wait_for([&] { return trouble->isVisible(); }));
    EXPECT_EQ(trouble->text(), "No sound: nothing is there");
    EXPECT_FALSE(test->isEnabled());
    QTest::keyClick(wanted, Qt::Key_Space);
    EXPECT_FALSE(services.sound.wanted);
    EXPECT_DOUBLE_EQ(services.sound.volume, 0.75) << "kept for later";
    EXPECT_FALSE(volume->isEnabled() || test->isEnabled() || trouble->isVisible());
    QTest::mouseClick(test, Qt::LeftButton);
    EXPECT_EQ(services.heard.tests, 1U);
    services.no_sound = {};
    QTest::keyClick(wanted, Qt::Key_Space);
    EXPECT_TRUE(services.sound.wanted && test->isEnabled());
}

TEST_F(SoundOnThePage, IsDrawnInBothThemesAndLanguages) {
    services.open_store(false);
    for (const Theme theme : {Theme::light, Theme::dark}) {
        const bool dark = theme == Theme::dark;
        open({1280, 800});
        window->set_theme(theme);
        window->set_language(dark ? Language::german : Language::english);
        if (dark)
            services.no_sound = {QT_TRANSLATE_NOOP("errors",
                                                   "No sound: the sound device is gone. Connect it again, or "
                                                   "another one.")};
        settle();
        Context context(services);
        SoundCard card(context);
        card.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&card));
        draw(card, dark ? "dark" : "light", dark ? 420 : 900);
        if (dark) {
            EXPECT_TRUE(card.findChild<QLabel*>("sound_trouble")->text().startsWith("Kein Ton: "));
        }
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
