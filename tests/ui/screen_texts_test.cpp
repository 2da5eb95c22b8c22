// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of every screen: no mark of Markdown that was not formatted, no name of an operation of the store.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QGroupBox>
#include <QPlainTextEdit>
#include <QRegularExpression>
#include <QTabBar>
#include <QTableWidget>
#include <QTextBrowser>
#include <QTextDocument>
#include <set>

#include "database/records/people.h"
#include "database/rows/errors.h"
#include "tests/ui/screens.h"
#include "tests/ui/shown_texts.h"
#include "ui/language/error_text.h"

namespace fulcrum::ui::window_test {
namespace {

/// Every text that is visible in the window or can be scrolled to.
QStringList texts_shown(const QWidget& window) {
    QStringList texts;
    for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible()) continue;
        if (const auto* label = qobject_cast<const QLabel*>(widget)) texts << as_shown(*label);
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) texts << button->text();
        if (const auto* box = qobject_cast<const QGroupBox*>(widget)) texts << box->title();
        if (const auto* edit = qobject_cast<const QTextEdit*>(widget)) texts << edit->toPlainText();
        if (const auto* edit = qobject_cast<const QPlainTextEdit*>(widget)) texts << edit->toPlainText();
        if (const auto* combo = qobject_cast<const QComboBox*>(widget)) {
            for (int i = 0; i < combo->count(); ++i) texts << combo->itemText(i);
        }
        if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
            for (int i = 0; i < tabs->count(); ++i) texts << tabs->tabText(i);
        }
        const auto* view = qobject_cast<const QAbstractItemView*>(widget);
        if (view == nullptr || view->model() == nullptr) continue;
        const QAbstractItemModel& model = *view->model();
        for (int column = 0; column < model.columnCount(); ++column) {
            texts << model.headerData(column, Qt::Horizontal).toString();
            for (int row = 0; row < model.rowCount(); ++row)
                texts << model.index(row, column).data().toString();
        }
    }
    texts.removeAll(QString());
    return texts;
}

/// Whether a text contains Markdown that was not formatted.
bool has_markdown(const QString& text) {
    static const QRegularExpression marks(
        QStringLiteral(R"(\*\*|__|`|(^|\n)\s*#{1,6} [^0-9]|\]\(|(^|[\s(])\*\w[^*\n]*\w\*)"));
    return marks.match(text).hasMatch();
}

TEST_F(Screens, ShowNoMarksOfMarkdown) {
    open({1012, 726});
    const std::string attempt = perform();
    int texts = 0;
    visit(attempt, [&](const QString& screen) {
        for (const QString& shown : texts_shown(*window)) {
            ++texts;
            EXPECT_FALSE(has_markdown(shown)) << screen.toStdString() << ": " << shown.toStdString();
        }
    });
    EXPECT_GT(texts, 500);
}

TEST_F(Screens, AnEducatorWithoutACohortReadsItWithoutMarksOfMarkdown) {
    open({1012, 726});
    const database::People people(*services.store());
    const auto made =
        people.create(sessions.at(Role::administrator), "eve", "Eve Educator", {Role::educator});
    window->context().set_session(people.change_password(people.sign_in("eve", made.one_time_password),
                                                         made.one_time_password, "a long password"));
    settle();
    go_to("rail_cohort");
    const QStringList texts = texts_shown(*window);
    EXPECT_EQ(texts.filter("There is no cohort yet.").size(), 1);
    for (const QString& shown : texts) EXPECT_FALSE(has_markdown(shown)) << shown.toStdString();
}

TEST_F(Screens, MarksOfMarkdownAreFoundInEveryKindOfText) {
    for (const char* text : {"a **strong** word", "an __old__ style", "the `code`", "## Heading",
                             "first\n# Heading", "see [here](page)", "an *odd* word"})
        EXPECT_TRUE(has_markdown(text)) << text;
    for (const char* text : {"2 * 3 mm", "path_len left", "# 3 of 5", "[1 to 2] (s)", "a <b>strong</b> word"})
        EXPECT_FALSE(has_markdown(text)) << text;
    QWidget page;
    QLabel label("**label**", &page);
    QLabel formatted("**formatted**", &page);
    formatted.setTextFormat(Qt::MarkdownText);
    QPushButton button("**button**", &page);
    QTableWidget table(1, 1, &page);
    table.setItem(0, 0, new QTableWidgetItem("**cell**"));
    table.setHorizontalHeaderLabels({"**header**"});
    QTextBrowser browser(&page);
    browser.setPlainText("**browser**");
    page.show();
    QStringList marked;
    for (const QString& shown : texts_shown(page)) marked += has_markdown(shown) ? shown : QString();
    for (const char* kind : {"**label**", "**button**", "**cell**", "**header**", "**browser**"})
        EXPECT_TRUE(marked.contains(kind)) << kind;
    EXPECT_FALSE(marked.contains("**formatted**")) << "shown as bold text";
}

TEST_F(Screens, NameNoOperationOfTheStoreInARefusal) {
    for (int i = 0; i < static_cast<int>(database::operation_count); ++i) {
        const std::string name = database::operation_name(static_cast<database::Operation>(i));
        const QString line =
            error_text(database::AccessDenied(name, "trainee", database::DenialReason::not_in_role));
        EXPECT_TRUE(line.startsWith("You may not ")) << line.toStdString();
        EXPECT_FALSE(line.startsWith("You may not do this")) << name << " has no sentence of its own";
        EXPECT_FALSE(line.contains('_')) << line.toStdString();
    }
}

TEST_F(Screens, SayWhyARefusalCameForEveryReason) {
    using database::AccessDenied;
    using database::DenialReason;
    std::set<QString> shown;
    for (const NameRow<DenialReason>& row : database::denial_reasons) {
        const QString line = error_text(AccessDenied("act_as", "trainee", row.kind, "director"));
        EXPECT_TRUE(shown.insert(line).second)
            << row.name << " has the words of another: " << line.toStdString();
        EXPECT_FALSE(line.contains('%')) << line.toStdString();
    }
    EXPECT_EQ(error_text(AccessDenied("act_as", "trainee", DenialReason::role_not_held, "director")),
              "You may not act in this role as trainee. You do not hold the role director.");
    EXPECT_EQ(error_text(AccessDenied("merge_people", "administrator", DenialReason::own_account)),
              "You may not merge these accounts as administrator. You may not do this to an account of your "
              "own.");
}

}  // namespace
}  // namespace fulcrum::ui::window_test
