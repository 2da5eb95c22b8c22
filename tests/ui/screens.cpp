// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/screens.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QRadioButton>
#include <QRegularExpression>
#include <QScrollBar>
#include <QStyleOption>
#include <QTextDocument>

#include "tests/ui/cut_texts.h"
#include "tests/ui/four_people.h"
#include "tests/ui/picture_kinds.h"
#include "ui/page/background_job.h"
#include "ui/review/debrief_page.h"
#include "ui/shell/page_table.h"
#include "ui/style/widgets.h"
#include "ui/theatre/theatre_page.h"

namespace fulcrum::ui::window_test {
namespace {

/// px, of a label's longest word.
int longest_word(const QLabel& label) {
    int widest = 0;
    QTextDocument rich;
    rich.setHtml(label.text());
    const QString shown = Qt::mightBeRichText(label.text()) ? rich.toPlainText() : label.text();
    // Spaces that do not break a line hold words together.
    for (const QString& word : shown.split(QRegularExpression(QStringLiteral("[ \\t\\n\\x{200b}]"))))
        widest = std::max(widest, label.fontMetrics().horizontalAdvance(word));
    return widest;
}

}  // namespace

Screens::Screens() {
    apply_theme(*qApp, Theme::light);
    services.open_store(false);
    sessions = make_four_people(*services.store(), "Department of Surgery, University Hospital");
}

Screens::~Screens() {
    apply_theme(*qApp, Theme::light);
}

void Screens::open(QSize size) {
    window = std::make_unique<MainWindow>(services);
    window->resize(size);
    window->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
    window->start();
    size_ = size;
}

void Screens::settle() {
    EXPECT_TRUE(wait_for([&] {
        QCoreApplication::processEvents();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QCoreApplication::processEvents();
        return window->findChildren<BackgroundJob*>().isEmpty();
    }));
    // What the last result asked of the layout is still to come.
    for (int i = 0; i < 3; ++i) QCoreApplication::processEvents();
}

std::vector<const char*> Screens::rail() {
    std::vector<const char*> names;
    for (const PageEntry* entry : pages_of(window->context())) names.push_back(entry->name);
    return names;
}

std::string Screens::perform() {
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

void Screens::wait_for_debrief() {
    EXPECT_TRUE(wait_for([&] {
        return window->current_page()->objectName() == "debrief_page" &&
               static_cast<DebriefPage*>(window->current_page())->is_ready();
    }));
    settle();
}

QString Screens::error_shown() {
    auto* line = window->findChild<QLabel*>("message_text");
    if (!line->isVisible() || line->parentWidget()->property("role").toString() != "error") return {};
    return line->text();
}

void Screens::expect_fits(const QString& screen) {
    EXPECT_EQ(window->size(), size_) << screen.toStdString();
    for (QScrollArea* area : window->current_page()->findChildren<QScrollArea*>()) {
        if (!area->isVisible() || area->widget()->objectName() != "page_body") continue;
        EXPECT_EQ(area->horizontalScrollBar()->maximum(), 0)
            << screen.toStdString() << ": " << area->widget()->minimumSizeHint().width() << " px wide";
    }
    for (const QComboBox* box : window->findChildren<QComboBox*>()) {
        // That one lists tasks by their short names first, and has little room next to its button.
        if (!box->isVisible() || box->objectName() == "task_new") continue;
        QStyleOptionComboBox option;
        option.initFrom(box);
        const QRect room =
            box->style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
        EXPECT_GE(room.width(), box->fontMetrics().boundingRect(box->currentText()).width())
            << screen.toStdString() << ": " << box->currentText().toStdString();
    }
    const QRect shown = window->rect();
    for (QAbstractButton* button : window->findChildren<QAbstractButton*>()) {
        if (!button->isVisible() || button->visibleRegion().isEmpty()) continue;
        const QRect place(button->mapTo(window.get(), QPoint()), button->size());
        EXPECT_TRUE(place.left() >= 0 && place.right() <= shown.right())
            << screen.toStdString() << ": " << button->objectName().toStdString();
    }
}

int Screens::expect_whole(const QString& screen, QWidget* within) {
    const QWidget& all = within != nullptr ? *within : *window;
    int seen = 0;
    const auto needs = [&](const QWidget& widget, const QString& shown, const QSize& needed) {
        if (shown.isEmpty() || !widget.isVisible()) return;
        ++seen;
        if (widget.width() >= needed.width() && widget.height() >= needed.height()) return;
        ADD_FAILURE() << screen.toStdString() << ", " << widget.metaObject()->className() << ' '
                      << widget.objectName().toStdString() << ": \"" << shown.left(60).toStdString()
                      << "\" has " << widget.width() << " x " << widget.height() << " of " << needed.width()
                      << " x " << needed.height() << " px";
    };
    for (const QLabel* label : all.findChildren<QLabel*>()) {
        if (dynamic_cast<const ElidedLabel*>(label) != nullptr) continue;  // whole in its tool tip
        if (!label->wordWrap()) {
            needs(*label, label->text(), label->sizeHint());
            continue;
        }
        needs(*label, label->text(), {longest_word(*label), label->heightForWidth(label->width())});
    }
    for (const QPushButton* button : all.findChildren<QPushButton*>())
        needs(*button, button->text(), button->sizeHint());
    for (const QRadioButton* button : all.findChildren<QRadioButton*>())
        needs(*button, button->text(), button->sizeHint());
    for (const QCheckBox* box : all.findChildren<QCheckBox*>()) needs(*box, box->text(), box->sizeHint());
    for (const QString& line : cut_texts(all))
        ADD_FAILURE() << screen.toStdString() << ", " << line.toStdString();
    return seen;
}

void Screens::each_tab(const QString& screen, const std::function<void(const QString&)>& look) {
    if (screen.endsWith("-rating")) return;  // below the form they are those of the debrief
    for (QTabWidget* tabs : window->current_page()->findChildren<QTabWidget*>()) {
        if (!tabs->isVisible()) continue;
        const int first = tabs->currentIndex();
        for (int i = 0; i < tabs->count(); ++i) {
            if (i == first) continue;
            tabs->setCurrentIndex(i);
            settle();
            look(screen + '-' + QString::number(i));
        }
        tabs->setCurrentIndex(first);
        settle();
    }
}

void Screens::keep(const QString& screen) {
    const QByteArray folder = qgetenv("FULCRUM_PICTURES");
    if (folder.isEmpty()) return;
    QDir().mkpath(QString::fromLocal8Bit(folder));
    constexpr int fastest = 89;  // the fastest compression; the usual one takes longer than drawing
    const PictureKind kind{size_, current_theme(), language_in_use(), text_percent()};
    window->grab().save(
        QStringLiteral("%1/%2-%3.png").arg(QString::fromLocal8Bit(folder), screen, kind.name()), nullptr,
        fastest);
}

void Screens::visit(const std::string& attempt, const Look& look) {
    for (const auto& [role, session] : sessions) {
        const QString who = QString::fromLatin1(database::role_name(role));
        sign_in(role);
        for (const char* name : rail()) {
            go_to(name);
            look(who + '-' + QString(name).mid(5));
        }
        go_to("rail_password");
        look(who + "-password");
        if (role == Role::trainee) {
            visit_device(who, look);
            visit_lock(look);
            emit window->context().briefing_wanted("B1");
            settle();
            look(who + "-briefing");
            visit_theatre(who + "-theatre", look);
        }
        if (role == Role::administrator) continue;
        emit window->context().debrief_wanted(text(attempt), -1);
        wait_for_debrief();
        look(who + "-debrief");
        if (role == Role::educator) visit_rating(who + "-debrief-rating", look);
        emit window->context().compare_wanted(text(attempt));
        settle();
        look(who + "-compare");
    }
    window->context().sign_out();
    settle();
    visit_first_pages(look);
    look("sign-in");
}

}  // namespace fulcrum::ui::window_test
