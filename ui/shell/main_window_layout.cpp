// SPDX-License-Identifier: GPL-3.0-or-later
// What the window consists of: banner, top bar, message, rail, pages, lock.
#include <QComboBox>
#include <QShortcut>
#include <QStackedWidget>
#include <typeinfo>

#include "database/store/store.h"
#include "ui/shell/first_start_page.h"
#include "ui/shell/lock_page.h"
#include "ui/shell/main_window.h"
#include "ui/shell/question_bar.h"
#include "ui/style/announce.h"
#include "ui/style/appearance.h"
#include "ui/style/reading_order.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/theatre/theatre_page.h"

namespace fulcrum::ui {

void MainWindow::build() {
    auto* proper = new QWidget;
    auto* layout = new QVBoxLayout(proper);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(build_banner());
    layout->addWidget(build_top_bar());
    layout->addWidget(build_message());
    rail_and_pages_ = new QHBoxLayout;
    rail_and_pages_->setSpacing(0);
    narrow_ = false;
    rail_ = new QFrame;
    rail_->setProperty("role", "rail");
    auto* close = new QShortcut(Qt::Key_Escape, rail_, nullptr, nullptr, Qt::WidgetWithChildrenShortcut);
    connect(close, &QShortcut::activated, this, [this] {
        if (!narrow_) return;  // it is a part of the window
        menu_->setChecked(false);
        menu_->setFocus();
    });
    rail_layout_ = new QVBoxLayout(rail_);
    rail_layout_->setContentsMargins(8, 16, 8, 16);
    rail_layout_->setSpacing(4);
    rail_and_pages_->addWidget(rail_);
    stack_ = new QStackedWidget;
    rail_and_pages_->addWidget(stack_, 1);
    layout->addLayout(rail_and_pages_, 1);

    layers_ = new QStackedWidget;
    layers_->addWidget(proper);
    lock_page_ = new LockPage(context_);
    layers_->addWidget(lock_page_);
    auto* all = new QWidget;
    auto* column = new QVBoxLayout(all);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    question_ = new QuestionBar;
    column->addWidget(question_);
    column->addWidget(layers_, 1);
    setCentralWidget(all);
    connect_lock_page();
}

QWidget* MainWindow::build_banner() {
    banner_ = new QFrame;
    banner_->setProperty("role", "banner");
    auto* row = new QHBoxLayout(banner_);
    row->setContentsMargins(16, 3, 16, 3);
    banner_text_ = make_label({});
    banner_text_->setObjectName(QStringLiteral("banner_text"));
    banner_text_->setAlignment(Qt::AlignCenter);
    row->addWidget(banner_text_);
    banner_->hide();
    return banner_;
}

void MainWindow::show_banner() {
    const database::Store* store = context_.services().store();
    const bool shown = store != nullptr && (store->is_demo() || store->is_server());
    if (shown)
        banner_text_->setText(
            store->is_demo() ? tr("Demonstration: the people and their attempts are simulated.")
                             : tr("Programme server, read only: attempts, ratings and decisions are made at "
                                  "the stations."));
    const bool is_new = shown && banner_->isHidden();
    banner_->setVisible(shown);
    if (is_new) announce(banner_, banner_text_->text());
}

QWidget* MainWindow::build_top_bar() {
    top_bar_ = new QFrame;
    top_bar_->setProperty("role", "top_bar");
    auto* bar = new QHBoxLayout(top_bar_);
    bar->setContentsMargins(18, 8, 18, 8);
    bar->setSpacing(12);
    menu_ = make_button(tr("Menu"), "menu");
    menu_->setCheckable(true);
    menu_->hide();
    connect(menu_, &QPushButton::toggled, this, &MainWindow::open_menu);
    bar->addWidget(menu_);
    programme_ = new ElidedLabel;
    programme_->setProperty("role", "heading");
    bar->addWidget(programme_);
    bar->addStretch(1);  // the two names have what they need before space is left over
    person_ = new ElidedLabel;
    person_->setObjectName(QStringLiteral("signed_in_person"));
    person_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    bar->addWidget(person_);
    role_ = new QComboBox;
    role_->setObjectName(QStringLiteral("acting_role"));
    role_->setAccessibleName(tr("Acting role"));
    role_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    bar->addWidget(role_);
    theme_ = make_button(theme_title(current_theme() == Theme::light ? Theme::dark : Theme::light), "theme");
    bar->addWidget(theme_);
    switch_user_ = make_button(tr("Switch user"), "switch_user");
    bar->addWidget(switch_user_);
    // Not of the button, which is hidden where there is little room.
    auto* keys = new QShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+U")), top_bar_);
    connect(keys, &QShortcut::activated, switch_user_, &QPushButton::click);
    connect(role_, QOverload<int>::of(&QComboBox::activated), this, &MainWindow::ask_role);
    connect(switch_user_, &QPushButton::clicked, this, &MainWindow::switch_user);
    connect(theme_, &QPushButton::clicked, this,
            [this] { set_theme(current_theme() == Theme::light ? Theme::dark : Theme::light); });
    return top_bar_;
}

bool MainWindow::focusNextPrevChild(bool next) {
    return focus_in_reading_order(*centralWidget(), next);
}

void MainWindow::fit_rail() {
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    int widest = 0;
    for (const QPushButton* button : rail_->findChildren<QPushButton*>())
        widest = std::max(widest, QFontMetrics(bold).horizontalAdvance(button->text()));
    constexpr int margins = 2 * (8 + 8);  // of the rail and of a button
    rail_->setFixedWidth(std::max(170, widest + margins + 2));
    constexpr double page_needs = 4.7;  // pixels a percent of text size: the widest page
    const bool narrow = width() - rail_->width() < page_needs * text_percent();
    if (narrow != narrow_) {
        narrow_ = narrow;
        if (narrow)
            rail_and_pages_->removeWidget(rail_);
        else
            rail_and_pages_->insertWidget(0, rail_);
    }
    show_rail();
}

void MainWindow::show_rail() {
    const auto shows = [this](const std::type_info& type) { return typeid(*current_page()) == type; };
    // The first start ends with the recovery code, which is shown only once: no other page until it is noted.
    const bool wanted = context_.signed_in() && !rail_buttons_.empty() && !shows(typeid(TheatrePage)) &&
                        !shows(typeid(FirstStartPage));
    if (!wanted || !narrow_) menu_->setChecked(false);
    menu_->setVisible(wanted && narrow_);
    programme_->setVisible(!narrow_);
    theme_->setVisible(!narrow_);  // Settings has it too
    // The server signs in, when the program starts.
    switch_user_->setVisible(!on_server() && !menu_->isVisibleTo(top_bar_));
    if (!rail_buttons_.empty()) rail_switch_user_->setVisible(!on_server() && narrow_);
    rail_->setVisible(wanted && (!narrow_ || menu_->isChecked()));
}

void MainWindow::open_menu(bool open) {
    show_rail();
    if (!open || !narrow_) return;
    rail_->setGeometry(QRect(stack_->pos(), QSize(rail_->width(), stack_->height())));
    rail_->raise();
    rail_buttons_.front().first->setFocus();
    for (const auto& [button, entry] : rail_buttons_) {
        if (button->isChecked()) button->setFocus();
    }
}

QWidget* MainWindow::build_message() {
    message_ = new QFrame;
    message_->setProperty("role", "message");
    auto* row = new QHBoxLayout(message_);
    row->setContentsMargins(14, 6, 8, 6);
    message_text_ = make_label({});
    message_text_->setObjectName(QStringLiteral("message_text"));
    message_text_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    QPushButton* close = make_button(tr("Close"), "close_message");
    connect(close, &QPushButton::clicked, this, [this] { message_area_->hide(); });
    row->addWidget(message_text_, 1);
    row->addWidget(close);
    message_area_ = new QWidget;
    auto* holder = new QHBoxLayout(message_area_);
    holder->setContentsMargins(18, 6, 18, 0);
    holder->addWidget(message_);
    message_area_->hide();
    message_timer_.setSingleShot(true);
    message_timer_.setInterval(6000);
    connect(&message_timer_, &QTimer::timeout, message_area_, &QWidget::hide);
    return message_area_;
}

void MainWindow::show_message(const QString& line, bool is_error) {
    message_text_->setText(line);
    set_role(message_, is_error ? "error" : "message");
    message_area_->show();
    // What is said behind the lock is for the person who unlocks it.
    if (layers_->currentWidget() != lock_page_) announce(message_area_, line);
    // Good news disappears after a while; a problem stays until the user closes it.
    message_timer_.stop();
    if (!is_error && layers_->currentWidget() != lock_page_) message_timer_.start();
}

}  // namespace fulcrum::ui
