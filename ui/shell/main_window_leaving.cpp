// SPDX-License-Identifier: GPL-3.0-or-later
// What ends or replaces pages: another role, a sign-out, the end of the window. Each is asked about first
// where something that somebody has begun would be lost by it.
#include <QApplication>
#include <QCloseEvent>
#include <QComboBox>
#include <QStackedWidget>

#include "database/records/people.h"
#include "ui/language/language.h"
#include "ui/review/debrief_page.h"
#include "ui/shell/main_window.h"
#include "ui/shell/question_bar.h"
#include "ui/style/appearance.h"
#include "ui/style/text.h"
#include "ui/theatre/theatre_page.h"

namespace fulcrum::ui {

void MainWindow::show_role_in_use() {
    if (!context_.signed_in()) return;
    role_->setCurrentIndex(role_->findData(static_cast<int>(context_.session().role())));
}

void MainWindow::ask_role(int index) {
    const auto role = static_cast<database::Role>(role_->itemData(index).toInt());
    question_->take_back();
    if (role == context_.session().role()) return;
    const QString now = role_text(database::role_name(context_.session().role())),
                  then = role_text(database::role_name(role));
    question_->ask({tr("You still act as %1. As %2 you see the pages of that role.").arg(now, then),
                    tr("Act as %1").arg(then), tr("Stay %1").arg(now), [this, role] { act_as(role); },
                    [this] { show_role_in_use(); }},
                   QuestionBar::Keyboard::stays);
    role_->setCurrentIndex(index);  // what was taken back had another one
}

void MainWindow::act_as(database::Role role) {
    keep_comment();
    if (!context_.guarded([&] {
            context_.set_session(database::People(context_.store()).act_as(context_.session(), role));
        }))
        show_role_in_use();
}

void MainWindow::switch_user() {
    if (TheatrePage* theatre = running_theatre()) {
        theatre->ask_before_leaving();
        return;
    }
    unless_begun(Page::Ending::session, [this] { context_.sign_out(); });
}

void MainWindow::keep_comment() {
    if (auto* debrief = qobject_cast<DebriefPage*>(current_page())) debrief->keep_comment();
}

QStringList MainWindow::begun_input(Page::Ending ending) const {
    QStringList lost;
    for (const auto& [type, one] : pages_) lost += one->begun_input(ending);
    if (ending == Page::Ending::window && drafts_.has_unsaved())
        lost << tr("a draft of the curriculum by somebody who has signed out");
    lost.removeDuplicates();
    lost.sort();
    return lost;
}

void MainWindow::unless_begun(Page::Ending ending, const std::function<void()>& end) {
    keep_comment();
    const QStringList lost = begun_input(ending);
    if (lost.isEmpty()) return end();
    Question question{{}, {}, tr("Go back"), end, {}};
    switch (ending) {
        case Page::Ending::pages:
            question.words = tr("Not saved yet, and lost when the pages are made again for this: %1.");
            question.yes = tr("Change it and lose that");
            question.on_no = [this] { context_.set_asked_look({}); };
            break;
        case Page::Ending::session:
            question.words = tr("Not saved yet, and lost at the sign-out: %1.");
            question.yes = tr("Sign out and lose that");
            break;
        case Page::Ending::window:
            question.words = tr("Not saved yet, and lost when the window closes: %1.");
            question.yes = tr("Close and lose that");
            break;
    }
    question.words = question.words.arg(lost.join(QStringLiteral("; ")));
    // From the task bar the window may be closed while nobody sees it.
    if (isMinimized()) setWindowState((windowState() & ~Qt::WindowMinimized) | Qt::WindowActive);
    question_->ask(question, QuestionBar::Keyboard::comes);
}

void MainWindow::ask_look(Context::Look look) {
    if (look.text_percent == text_percent()) look.text_percent.reset();
    if (look.language == language_in_use()) look.language.reset();
    question_->take_back();  // it was about what was chosen before
    context_.set_asked_look(look);
    if (look.text_percent || look.language)
        unless_begun(Page::Ending::pages, [this, look] { use_look(look); });
}

void MainWindow::use_look(const Context::Look& look) {
    if (look.text_percent) {
        apply_text_size(*qApp, *look.text_percent);
        store_text_percent(*look.text_percent);
    }
    if (look.language) {
        use_language(*look.language);
        store_language(*look.language);
        unsetLocale();  // what is made from now on writes dates and numbers as the language does
    }
    rebuild();
    context_.set_asked_look({});
}

void MainWindow::set_text_size(int percent) {
    use_look({percent, {}});
}

void MainWindow::set_language(Language language) {
    use_look({{}, language});
}

void MainWindow::closeEvent(QCloseEvent* event) {
    TheatrePage* theatre = running_theatre();
    if (theatre != nullptr && layers_->currentIndex() == 0) {
        theatre->ask_before_leaving();
        event->ignore();
        return;
    }
    keep_comment();
    if (!closing_ && !begun_input(Page::Ending::window).isEmpty()) {
        event->ignore();
        unless_begun(Page::Ending::window, [this] {
            closing_ = true;
            close();
            closing_ = false;
        });
        return;
    }
    QMainWindow::closeEvent(event);
}

}  // namespace fulcrum::ui
