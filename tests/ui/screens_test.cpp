// SPDX-License-Identifier: GPL-3.0-or-later
// Every screen of every role: none reports an error without an action, all fit a small display, none shows a
// mark of Markdown, and a change of theme changes all of them. With FULCRUM_PICTURES=FOLDER the screens are
// stored there, in both themes at 1024 x 768 and 1920 x 1080.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QFrame>
#include <QGroupBox>
#include <QImage>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTabBar>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTextBrowser>
#include <QTextDocument>

#include "database/records/attempts.h"
#include "database/records/people.h"
#include "database/rows/errors.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/page/background_job.h"
#include "ui/page/error_text.h"
#include "ui/review/debrief_page.h"
#include "ui/shell/main_window.h"
#include "ui/shell/page_table.h"
#include "ui/style/text.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::ui::window_test {
namespace {

using database::Role;

/// What a label's format makes of its text.
QString as_shown(const QLabel& label) {
    QTextDocument document;
    const Qt::TextFormat format = label.textFormat();
    if (format == Qt::MarkdownText) {
        document.setMarkdown(label.text());
    } else if (format == Qt::RichText || (format == Qt::AutoText && Qt::mightBeRichText(label.text()))) {
        document.setHtml(label.text());
    } else {
        return label.text();
    }
    return document.toPlainText();
}

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

/// A programme with one person of each role, a cohort and one attempt.
class Screens : public ::testing::Test {
  protected:
    Screens() {
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
        const database::People people(*services.store());
        const database::Session alma = people
                                           .create_programme("Department of Surgery, University Hospital",
                                                             "alma", "Alma Admin", "correct horse")
                                           .administrator;
        sessions.emplace(Role::administrator, alma);
        for (const auto& [role, login, name] : {std::tuple{Role::trainee, "tara", "Tara Trainee"},
                                                std::tuple{Role::educator, "ed", "Ed Educator"},
                                                std::tuple{Role::director, "dora", "Dora Director"}}) {
            const auto made = people.create(alma, login, name, {role});
            const database::Session once = people.sign_in(login, made.one_time_password);
            sessions.emplace(role, people.change_password(once, made.one_time_password, "a long password"));
        }
        const database::Session& dora = sessions.at(Role::director);
        const std::string cohort = people.create_cohort(dora, "Spring");
        people.set_members(dora, cohort, {sessions.at(Role::trainee).person_id()});
        people.set_educators(dora, cohort, {sessions.at(Role::educator).person_id()});
    }
    ~Screens() override { apply_theme(*qApp, Theme::light); }

    void open(QSize size) {
        window = std::make_unique<MainWindow>(services);
        window->resize(size);
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        size_ = size;
    }
    void sign_in(Role role) {
        window->context().set_session(sessions.at(role));
        settle();
    }
    /// Handles what is due, and waits for the work that the page does in the background.
    void settle() {
        EXPECT_TRUE(wait_for([&] {
            QCoreApplication::processEvents();
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            QCoreApplication::processEvents();
            return window->findChildren<BackgroundJob*>().isEmpty();
        }));
    }
    std::vector<const char*> rail() {
        std::vector<const char*> names;
        for (const PageEntry* entry : pages_of(window->context())) names.push_back(entry->name);
        return names;
    }
    void go_to(const char* name) {
        click(*window, name);
        settle();
    }
    /// The trainee's attempt A2, by mouse, with too much force; its id.
    std::string perform() {
        sign_in(Role::trainee);
        emit window->context().attempt_wanted("A2", true, 0, false);
        auto* theatre = static_cast<TheatrePage*>(window->current_page());
        services.control.ticks_per_update = 40;
        EXPECT_TRUE(wait_for([&] {
            return theatre->session() != nullptr && theatre->session()->phase() == AttemptPhase::running;
        }));
        services.control.press_hard = true;
        QTest::qWait(300);
        services.control.complete = true;
        wait_for_debrief();
        return static_cast<DebriefPage*>(window->current_page())->model()->summary.meta.id;
    }
    void wait_for_debrief() {
        EXPECT_TRUE(wait_for([&] {
            return window->current_page()->objectName() == "debrief_page" &&
                   static_cast<DebriefPage*>(window->current_page())->is_ready();
        }));
        settle();
    }
    QString error_shown() {
        auto* line = window->findChild<QLabel*>("message_text");
        if (!line->isVisible() || line->parentWidget()->property("role").toString() != "error") return {};
        return line->text();
    }
    /// The page has the space that it needs, and the window has kept its size.
    void expect_fits(const QString& screen) {
        EXPECT_EQ(window->size(), size_) << screen.toStdString();
        for (QScrollArea* area : window->current_page()->findChildren<QScrollArea*>()) {
            if (!area->isVisible() || area->widget()->objectName() != "page_body") continue;
            EXPECT_EQ(area->horizontalScrollBar()->maximum(), 0)
                << screen.toStdString() << ": " << area->widget()->minimumSizeHint().width() << " px wide";
        }
        const QRect shown = window->rect();
        for (QAbstractButton* button : window->findChildren<QAbstractButton*>()) {
            if (!button->isVisible() || button->visibleRegion().isEmpty()) continue;
            const QRect place(button->mapTo(window.get(), QPoint()), button->size());
            EXPECT_TRUE(place.left() >= 0 && place.right() <= shown.right())
                << screen.toStdString() << ": " << button->objectName().toStdString();
        }
    }
    void keep(const QString& screen) {
        const QByteArray folder = qgetenv("FULCRUM_PICTURES");
        if (folder.isEmpty()) return;
        QDir().mkpath(QString::fromLocal8Bit(folder));
        window->grab().save(QStringLiteral("%1/%2-%3x%4-%5.png")
                                .arg(QString::fromLocal8Bit(folder), screen)
                                .arg(size_.width())
                                .arg(size_.height())
                                .arg(current_theme() == Theme::light ? "light" : "dark"));
    }
    /// Opens every screen of every role and calls `look`.
    template <typename F>
    void visit(const std::string& attempt, F look) {
        for (const auto& [role, session] : sessions) {
            const QString who = role_text(database::role_name(role));
            sign_in(role);
            for (const char* name : rail()) {
                go_to(name);
                look(who + '-' + QString(name).mid(5));
            }
            go_to("rail_password");
            look(who + "-password");
            if (role == Role::trainee) {
                emit window->context().briefing_wanted("B1");
                settle();
                look(who + "-briefing");
                theatre([&] { look(who + "-theatre"); });
            }
            if (role == Role::administrator) continue;
            emit window->context().debrief_wanted(text(attempt), -1);
            wait_for_debrief();
            look(who + "-debrief");
        }
        window->context().sign_out();
        settle();
        look("sign-in");
    }
    template <typename F>
    void theatre(F look) {
        emit window->context().attempt_wanted("A2", false, 0, false);
        auto* page = static_cast<TheatrePage*>(window->current_page());
        services.control.ticks_per_update = 1;
        EXPECT_TRUE(wait_for([&] { return page->view()->pictures() > 2; }));
        look();
        emit window->context().home_wanted();
        settle();
    }

    FakeServices services;
    std::map<Role, database::Session> sessions;
    std::unique_ptr<MainWindow> window;
    QSize size_;
};

TEST_F(Screens, FitASmallDisplayWithoutAnError) {
    open({1012, 726});  // 1024 x 768 without the frame
    const std::string attempt = perform();
    visit(attempt, [&](const QString& screen) {
        expect_fits(screen);
        EXPECT_EQ(error_shown().toStdString(), "") << screen.toStdString();
    });
    window->start();
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

TEST_F(Screens, EducatorWithoutACohortIsToldSoWithoutMarksOfMarkdown) {
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

TEST_F(Screens, StationSaysHowThePictureIsDrawn) {
    open({1012, 726});
    sign_in(Role::administrator);
    go_to("rail_station");
    const QString shown = window->findChild<QLabel*>("picture_quality")->text();
    for (const char* part : {"Drawn by: ", "Resolution: ", "Anti-aliasing: "})
        EXPECT_TRUE(shown.contains(part)) << part << shown.toStdString();
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
    const auto compare = [&](const QString& screen, const std::function<void()>& show) {
        window->set_theme(Theme::dark);
        show();
        QImage fresh = window->grab().toImage();
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
                // A new sign-in makes every page again.
                window->context().sign_out();
                sign_in(role);
                go_to(name);
                window->setFocus();
                settle();
            });
        }
        if (role != Role::administrator) {
            compare(who + "-debrief", [&, role = role] {
                window->context().sign_out();
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
    for (const QSize size : {QSize(1024, 768), QSize(1920, 1080)}) {
        for (const Theme theme : {Theme::light, Theme::dark}) {
            window->set_theme(theme);
            window->resize(size);
            size_ = size;
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
    }
    const QStringList pictures =
        QDir(QString::fromLocal8Bit(qgetenv("FULCRUM_PICTURES"))).entryList({"*.png"}, QDir::Files);
    for (const char* kind : {"1024x768-light", "1024x768-dark", "1920x1080-light", "1920x1080-dark"})
        EXPECT_GE(pictures.filter(kind).size(), 15) << kind;
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

TEST_F(Screens, NameNoOperationOfTheStoreInARefusal) {
    for (int i = 0; i < static_cast<int>(database::operation_count); ++i) {
        const std::string name = database::operation_name(static_cast<database::Operation>(i));
        const QString line = error_text(database::AccessDenied(name, "trainee", "not in this role"));
        EXPECT_TRUE(line.startsWith("You may not ")) << line.toStdString();
        EXPECT_FALSE(line.startsWith("You may not do this")) << name << " has no sentence of its own";
        EXPECT_FALSE(line.contains('_')) << line.toStdString();
    }
}

/// Looks around as one person of the demonstration.
class Demonstration : public ::testing::Test {
  protected:
    Demonstration() : window(services) {
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.start();
        click(window, "look_around");
        EXPECT_TRUE(wait_for([&] { return sees(window, "pick_demo_person"); }));
    }
    void pick(const char* name) {
        ASSERT_TRUE(wait_for([&] { return sees(window, "pick_demo_person"); }));
        for (QAbstractButton* button : window.findChildren<QAbstractButton*>("pick_demo_person")) {
            if (button->isVisible() && button->text().startsWith(name)) {
                QTest::mouseClick(button, Qt::LeftButton);
                return;
            }
        }
        FAIL() << name;
    }
    bool shows_error() {
        auto* line = window.findChild<QLabel*>("message_text");
        return line->isVisible() && line->parentWidget()->property("role").toString() == "error";
    }
    FakeServices services;
    MainWindow window;
};

TEST_F(Demonstration, NoPageOfAnyRoleReportsAnError) {
    for (const char* name : {"Nova", "Iris", "Dora"}) {
        pick(name);
        ASSERT_TRUE(wait_for([&] { return window.context().signed_in(); }));
        for (const PageEntry* entry : pages_of(window.context())) {
            click(window, entry->name);
            QTest::qWait(50);
            EXPECT_FALSE(shows_error()) << name << ", " << entry->name << ": "
                                        << window.findChild<QLabel*>("message_text")->text().toStdString();
        }
        click(window, "switch_user");
    }
}

TEST_F(Demonstration, AttemptByMouseIsNotCalledSimulatedAndNamesAreMarkedOnce) {
    pick("Nova");
    ASSERT_TRUE(wait_for([&] { return sees(window, "briefing_A2"); }));
    emit window.context().attempt_wanted("A2", false, 0, false);
    auto* theatre = static_cast<TheatrePage*>(window.current_page());
    ASSERT_TRUE(wait_for([&] {
        return theatre->session() != nullptr && theatre->session()->phase() == AttemptPhase::running;
    }));
    QTest::qWait(200);
    services.control.complete = true;
    ASSERT_TRUE(wait_for([&] { return window.current_page()->objectName() == "debrief_page"; }));
    auto* debrief = static_cast<DebriefPage*>(window.current_page());
    ASSERT_TRUE(wait_for([&] { return debrief->is_ready(); }));
    const QString notes = window.findChild<QLabel*>("debrief_notes")->text();
    EXPECT_FALSE(notes.contains("simulated operator")) << notes.toStdString();
    click(window, "rail_attempts");
    for (QTableWidget* table : window.findChildren<QTableWidget*>("attempts_table")) {
        if (!table->isVisible()) continue;
        ASSERT_GT(table->rowCount(), 0);
        EXPECT_EQ(table->item(0, 0)->text().count("(synthetic)"), 1);
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
