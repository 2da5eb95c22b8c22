// SPDX-License-Identifier: GPL-3.0-or-later
// A draft of the curriculum that no file has is neither discarded nor replaced by one press, and does not end
// with the window before that was asked.
#include <QDialog>
#include <QPushButton>

#include "assessment/learning/pass_rule.h"
#include "tests/ui/dashboards/curriculum_view.h"
#include "ui/language/language.h"

namespace fulcrum::ui::window_test {
namespace {

class CurriculumLeaving : public CurriculumView {
  protected:
    CurriculumLeaving() {
        be_educator();
        window.activateWindow();
        EXPECT_TRUE(QTest::qWaitForWindowActive(&window));
    }
    ~CurriculumLeaving() override { window.set_language(Language::english); }
    const OutlivesItsWindows outlives;
    void change() {
        choose("C4");
        step("rule_passes", 1, Qt::Key_Left);
    }
    bool is_begun() { return pass_rule_text(page().draft().find("C4")->rule) == "of:3,5"; }
    void focus(const char* button) {
        auto* wanted = find<QPushButton>(window, button);
        bring(*wanted);
        wanted->setFocus();
    }
    void hold(Qt::Key key) {
        for (int i = 0; i < 8; ++i) {
            QKeyEvent down(QEvent::KeyPress, key, Qt::NoModifier, QString(), i > 0);
            QApplication::sendEvent(window.focusWidget(), &down);
        }
        QKeyEvent up(QEvent::KeyRelease, key, Qt::NoModifier);
        QApplication::sendEvent(window.focusWidget(), &up);
        QCoreApplication::processEvents();
    }
    QDialog* dialog() { return qobject_cast<QDialog*>(QApplication::activeModalWidget()); }
    void save_to(const QString& file) {
        bring(*find<QLineEdit>(window, "curriculum_path"));
        type(window, "curriculum_path", file);
        click(window, "curriculum_save");
    }
};

TEST_F(CurriculumLeaving, AHeldKeyDiscardsNothing) {
    change();
    for (const Qt::Key key : {Qt::Key_Return, Qt::Key_Space}) {
        focus("curriculum_discard");
        hold(key);
        EXPECT_TRUE(sees(window, "curriculum_discard_sure")) << key;
        EXPECT_EQ(window.focusWidget()->objectName(), "curriculum_discard") << key;
        EXPECT_TRUE(is_begun()) << key;
        QTest::keyClick(window.focusWidget(), Qt::Key_Escape);
        EXPECT_FALSE(sees(window, "curriculum_discard_sure")) << key;
    }
    click(window, "curriculum_discard");
    step("rule_passes", 1, Qt::Key_Right);
    EXPECT_FALSE(sees(window, "curriculum_discard_sure")) << "asked about another draft";
    step("rule_passes", 1, Qt::Key_Left);
    click(window, "curriculum_discard");
    click(window, "curriculum_discard_sure");
    EXPECT_FALSE(is_begun());
    EXPECT_EQ(window.focusWidget()->objectName(), "curriculum_tasks");
}

TEST_F(CurriculumLeaving, OpeningAnotherDraftAsksOnlyWhereOneWouldBeLost) {
    change();
    focus("curriculum_open");
    hold(Qt::Key_Return);
    EXPECT_EQ(dialog(), nullptr) << "no file is asked for yet";
    EXPECT_TRUE(is_begun());
    click(window, "curriculum_open_sure");
    ASSERT_TRUE(wait_for([&] { return dialog() != nullptr; }));
    dialog()->reject();
    EXPECT_TRUE(is_begun()) << "nothing was opened";
    const QTemporaryDir folder;
    save_to(folder.filePath("mine.json"));
    EXPECT_FALSE(sees(window, "curriculum_open_sure"));
    click(window, "curriculum_open");
    ASSERT_TRUE(wait_for([&] { return dialog() != nullptr; })) << "the draft is in its file";
    dialog()->reject();
}

TEST_F(CurriculumLeaving, ADraftIsNamedBeforeTheWindowClosesAndKeptAtASignOut) {
    change();
    EXPECT_FALSE(window.close());
    EXPECT_EQ(find<QLabel>(window, "question_words")->text(),
              "Not saved yet, and lost when the window closes: a draft of the curriculum.");
    click(window, "question_no");
    emit window.context().switch_user_wanted();
    EXPECT_FALSE(window.context().signed_in()) << "it is kept: nothing is asked";
    window.set_language(Language::german);
    EXPECT_FALSE(window.close());
    EXPECT_TRUE(find<QLabel>(window, "question_words")
                    ->text()
                    .endsWith(": ein Entwurf des Curriculums von jemandem, der abgemeldet ist."));
    click(window, "question_no");
    window.set_language(Language::english);
    const database::People people(*services.store());
    open_as(people.sign_in("ed", "a long password"));
    EXPECT_TRUE(is_begun());
    const QTemporaryDir folder;
    save_to(folder.filePath("mine.json"));
    EXPECT_TRUE(window.close()) << message().toStdString();
}

}  // namespace
}  // namespace fulcrum::ui::window_test
