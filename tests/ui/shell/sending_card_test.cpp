// SPDX-License-Identifier: GPL-3.0-or-later
// Sending attempts to other programs, on the page of settings: on and off, where, who listens, what is wrong.
#include "ui/shell/sending_card.h"

#include <gtest/gtest.h>

#include <QCheckBox>

#include "tests/ui/screens.h"
#include "ui/language/language.h"

namespace fulcrum::ui::window_test {
namespace {

class SendingOnThePage : public Screens {
  protected:
    struct Sends : FakeServices {
        SendingState now;
        SendingState sending() const override { return now; }
        void choose_sending(bool wanted) override {
            now.wanted = wanted;
            now.address = wanted ? "127.0.0.1:18944" : "";
        }
    };
    ~SendingOnThePage() override {
        window.reset();
        use_language(Language::english);
    }
    /// Draws the card as it is; with FULCRUM_PICTURES it is kept.
    void draw(SendingCard& card, const char* name) {
        card.resize(900, card.sizeHint().height());
        settle();
        const QPixmap drawn = card.grab();
        EXPECT_FALSE(drawn.isNull());
        if (const QString folder = qEnvironmentVariable("FULCRUM_PICTURES"); !folder.isEmpty())
            drawn.save(folder + QStringLiteral("/sending-") + QLatin1String(name) + QStringLiteral(".png"));
    }
    Sends sends;
};

TEST_F(SendingOnThePage, IsOffUntilAPersonSwitchesItOnAndThenSaysWhereAndWho) {
    sends.open_store(false);
    Context context(sends);
    SendingCard card(context);
    card.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&card));
    auto* wanted = card.findChild<QCheckBox*>("send_attempts");
    auto* state = card.findChild<QLabel*>("sending_state");
    auto* trouble = card.findChild<QLabel*>("sending_trouble");
    EXPECT_FALSE(wanted->isChecked());
    EXPECT_FALSE(state->isVisible() || trouble->isVisible());
    QTest::keyClick(wanted, Qt::Key_Space);
    EXPECT_TRUE(sends.now.wanted);
    EXPECT_EQ(state->text(),
              "At 127.0.0.1:18944; programs connected: 0\nOnly programs on this computer can connect.");
    sends.now.clients = 2;
    sends.now.dropped = 1;
    EXPECT_TRUE(wait_for([&] { return state->text().contains("programs connected: 2"); }));
    EXPECT_TRUE(state->text().contains("sent something else: 1"));
    QTest::keyClick(wanted, Qt::Key_Space);
    EXPECT_FALSE(sends.now.wanted);
    sends.now = {};
    sends.now.wanted = sends.now.fixed = sends.now.other_computers = true;
    sends.now.address = "0.0.0.0:18944";
    EXPECT_TRUE(wait_for([&] { return !wanted->isEnabled(); }));
    EXPECT_TRUE(state->text().contains("Programs on other computers can connect, without a password."));
    EXPECT_TRUE(state->text().contains("FULCRUM_OPENIGTLINK"));
    sends.now.address.clear();
    sends.now.trouble = "0.0.0.0:18944: cannot be served";
    EXPECT_TRUE(wait_for([&] { return trouble->isVisible(); }));
    EXPECT_TRUE(trouble->text().contains("cannot be served"));
}

TEST_F(SendingOnThePage, IsDrawnInBothThemesAndLanguages) {
    sends.open_store(false);
    sends.choose_sending(true);
    sends.now.clients = 1;
    sends.now.dropped = 3;
    for (const Theme theme : {Theme::light, Theme::dark}) {
        open({1280, 800});
        window->set_theme(theme);
        window->set_language(theme == Theme::light ? Language::english : Language::german);
        settle();
        Context context(sends);
        SendingCard card(context);
        card.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&card));
        draw(card, theme == Theme::light ? "light" : "dark");
        if (theme == Theme::dark) {
            EXPECT_TRUE(card.findChild<QLabel*>("sending_state")->text().startsWith("Unter 127.0.0.1:18944"));
        }
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
