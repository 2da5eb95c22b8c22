// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/main_window.h"

#include <QApplication>
#include <QComboBox>
#include <QScreen>
#include <QStackedWidget>
#include <QWindow>
#include <algorithm>
#include <typeinfo>

#include "database/records/curricula.h"
#include "database/records/people.h"
#include "ui/administration/people_page.h"
#include "ui/language/error_text.h"
#include "ui/review/compare_page.h"
#include "ui/review/debrief_page.h"
#include "ui/shell/first_start_page.h"
#include "ui/shell/lock_page.h"
#include "ui/shell/page_table.h"
#include "ui/shell/password_page.h"
#include "ui/shell/question_bar.h"
#include "ui/shell/repair_page.h"
#include "ui/shell/settings_page.h"
#include "ui/shell/sign_in_page.h"
#include "ui/style/announce.h"
#include "ui/style/appearance.h"
#include "ui/style/kept_focus.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/theatre/theatre_page.h"
#include "ui/trainee/briefing_page.h"
#include "ui/trainee/home_page.h"
#include "ui/trainee/metrics_page.h"
#include "ui/trainee/progress_page.h"

namespace fulcrum::ui {
namespace {

constexpr QSize preferred_size(1280, 800), smallest_size(960, 600);
/// Pixels that a window manager's frame usually takes, until its real one is known.
constexpr QMargins usual_frame(6, 36, 6, 6);

}  // namespace

QRect fit_window(const QRect& wanted, const QRect& available, const QMargins& frame) {
    const QRect room = available.marginsRemoved(frame);
    const QSize size = wanted.size().boundedTo(room.size());
    return {QPoint(std::clamp(wanted.left(), room.left(), room.right() - size.width() + 1),
                   std::clamp(wanted.top(), room.top(), room.bottom() - size.height() + 1)),
            size};
}

Page* MainWindow::page(std::type_index type, Page* (*make)(Context&)) {
    Page*& slot = pages_[type];
    if (slot == nullptr) {
        slot = make(context_);
        stack_->addWidget(slot);
    }
    return slot;
}

template <typename P>
P* MainWindow::page() {
    return static_cast<P*>(page(typeid(P), [](Context& context) -> Page* { return new P(context); }));
}

template <typename P>
P* MainWindow::made() const {
    const auto found = pages_.find(typeid(P));
    return found == pages_.end() ? nullptr : static_cast<P*>(found->second);
}

TheatrePage* MainWindow::running_theatre() const {
    auto* theatre = made<TheatrePage>();
    return theatre != nullptr && theatre->is_running() ? theatre : nullptr;
}

MainWindow::MainWindow(ApplicationServices& services, QWidget* parent, int lock_ms, int close_ms)
    : QMainWindow(parent),
      context_(services),
      idle_(this, lock_ms, close_ms),
      schedules_(context_, this),
      replays_(
          context_, [this] { return running_theatre() != nullptr; }, this) {
    setObjectName(QStringLiteral("main_window"));
    setWindowTitle(tr("Fulcrum"));
    build();
    connect_context();
    const QRect available = screen()->availableGeometry();
    setMinimumSize(smallest_size.boundedTo(available.marginsRemoved(usual_frame).size()));
    QRect wanted(QPoint(), preferred_size);
    wanted.moveCenter(available.center());
    setGeometry(fit_window(wanted, available, usual_frame));
}

MainWindow::~MainWindow() = default;

void MainWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    // Once the window is active its frame is known.
    if (event->type() == QEvent::ActivationChange && isActiveWindow()) keep_within_screen();
}

void MainWindow::keep_within_screen() {
    if (fitted_ || isMaximized() || isFullScreen() || windowHandle() == nullptr) return;
    fitted_ = true;
    const QRect fitting =
        fit_window(geometry(), screen()->availableGeometry(), windowHandle()->frameMargins());
    if (fitting != geometry()) setGeometry(fitting);
}

void MainWindow::connect_context() {
    connect(&context_, &Context::session_changed, this, &MainWindow::session_changed);
    connect(&context_, &Context::message, this, &MainWindow::show_message);
    connect(&context_, &Context::input_seen, &idle_, &IdleWatch::note_input);
    connect(&context_, &Context::home_wanted, this, &MainWindow::show_home);
    connect(&context_, &Context::switch_user_wanted, this, &MainWindow::switch_user);
    connect(&context_, &Context::restore_wanted, this,
            [this] { unless_begun(Page::Ending::session, [this] { show_restore(); }); });
    connect(&context_, &Context::briefing_wanted, this,
            [this](const QString& task_id, const QString& variant, int goal, bool ghost) {
                page<BriefingPage>()->set_task(plain(task_id), plain(variant), goal, ghost);
                show_page(page<BriefingPage>());
            });
    connect(&context_, &Context::attempt_wanted, this,
            [this](const QString& task_id, bool assessed, int goal, bool ghost, const QString& variant) {
                auto* theatre = page<TheatrePage>();
                if (theatre->begin(plain(task_id), assessed, goal, ghost, plain(variant))) show_page(theatre);
            });
    connect(&context_, &Context::demonstration_wanted, this,
            [this](const QString& task_id, const QString& variant) {
                auto* theatre = page<TheatrePage>();
                if (theatre->demonstrate(plain(task_id), plain(variant))) show_page(theatre);
            });
    connect(&context_, &Context::take_over_wanted, this, [this](std::shared_ptr<const ReplayMoment> from) {
        if (page<TheatrePage>()->take_over(std::move(from))) show_page(page<TheatrePage>());
    });
    connect(&context_, &Context::interrupted_scored, this, [this] {
        auto* home = qobject_cast<HomePage*>(current_page());
        if (home == nullptr) return;
        const KeptFocus focus(home);
        home->show_scored();
    });
    connect(&context_, &Context::debrief_wanted, this, [this](const QString& attempt_id, double time_s) {
        page<DebriefPage>()->open(plain(attempt_id), time_s);
        show_page(page<DebriefPage>());
    });
    connect(&context_, &Context::compare_wanted, this, [this](const QString& attempt_id) {
        page<ComparePage>()->open(plain(attempt_id));
        show_page(page<ComparePage>());
    });
    connect(&context_, &Context::rating_wanted, this, [this](const QString& attempt_id) {
        page<DebriefPage>()->open_to_rate(plain(attempt_id));
        show_page(page<DebriefPage>());
    });
    connect(&context_, &Context::progress_wanted, this,
            [this](const QString& person_id, const QString& task_id) {
                page<ProgressPage>()->show_person(plain(person_id), plain(task_id));
                show_page(page<ProgressPage>());
            });
    connect(&context_, &Context::metric_wanted, this,
            [this](const QString& metric_id, const QString& attempt_id, double time_s) {
                page<MetricsPage>()->show_metric(plain(metric_id), attempt_id, time_s);
                show_page(page<MetricsPage>());
            });
    connect(&idle_, &IdleWatch::lock, this, &MainWindow::lock);
    connect(&idle_, &IdleWatch::close_attempt, this, [this] {
        if (TheatrePage* theatre = running_theatre())
            lock_page_->set_notice(theatre->close_attempt(TheatrePage::Closed::by_idle_watch));
    });
    connect(&context_, &Context::theme_wanted, this, &MainWindow::set_theme);
    connect(&context_, &Context::text_size_wanted, this, [this](int percent) {
        Context::Look look = context_.asked_look();
        look.text_percent = percent;
        ask_look(look);
    });
    connect(&context_, &Context::language_wanted, this, [this](Language language) {
        Context::Look look = context_.asked_look();
        look.language = language;
        ask_look(look);
    });
}

void MainWindow::connect_lock_page() {
    connect(lock_page_, &LockPage::unlocked, this, &MainWindow::unlock);
    connect(lock_page_, &LockPage::switch_user, this, [this] {
        unless_begun(Page::Ending::session, [this] {
            unlock();
            if (TheatrePage* theatre = running_theatre())
                theatre->close_attempt(TheatrePage::Closed::by_trainee);
            context_.sign_out();
        });
    });
}

void MainWindow::connect_first_pages() {
    auto* first = page<FirstStartPage>();
    connect(first, &FirstStartPage::restore_wanted, this, &MainWindow::show_restore, Qt::UniqueConnection);
    connect(first, &FirstStartPage::programme_joined, this, &MainWindow::show_sign_in, Qt::UniqueConnection);
    connect(first, &FirstStartPage::demo_opened, this, &MainWindow::show_sign_in, Qt::UniqueConnection);
    connect(first, &FirstStartPage::programme_created, this, &MainWindow::show_home, Qt::UniqueConnection);
    auto* sign_in = page<SignInPage>();
    connect(sign_in, &SignInPage::leave_demo, this, &MainWindow::start, Qt::UniqueConnection);
    auto* repair = page<RepairPage>();
    connect(repair, &RepairPage::try_again, this, &MainWindow::start, Qt::UniqueConnection);
    connect(repair, &RepairPage::restored, this, &MainWindow::start_restored, Qt::UniqueConnection);
    connect(repair, &RepairPage::look_around_wanted, this, &MainWindow::look_around, Qt::UniqueConnection);
}

void MainWindow::start() {
    connect_first_pages();
    auto* first = page<FirstStartPage>();
    try {
        if (database::Store::exists(context_.services().store_path(false)))
            context_.services().open_store(false);
        const bool ready = context_.services().store() != nullptr && !context_.store().is_demo() &&
                           context_.store().has_administrator();
        if (on_server() || ready) first->forget_input();
        if (on_server()) {
            context_.set_session(database::People(context_.store()).account_session());
            show_home();
        } else if (ready) {
            show_sign_in();
        } else {
            show_page(first);
        }
    } catch (const database::StoreError& error) {
        show_trouble(sentence_text(error.problem_sentence()), sentence_text(error.hint_sentence()),
                     error.kind() == database::StoreErrorKind::corrupt ||
                         error.kind() == database::StoreErrorKind::not_a_store);
    } catch (const database::SignInRefused& error) {
        show_trouble(error_text(error), {}, false);
    } catch (const std::exception& error) {
        // A file that cannot be used, such as a curriculum that was edited: also this has to be read.
        show_trouble(error_text(error), {}, false);
    }
}

void MainWindow::show_trouble(const QString& problem, const QString& hint, bool damaged) {
    context_.services().close_store();
    page<RepairPage>()->show_trouble(problem, hint, damaged);
    show_page(page<RepairPage>());
}

void MainWindow::show_restore() {
    if (context_.signed_in()) context_.sign_out();
    context_.services().close_store();
    connect_first_pages();
    page<RepairPage>()->show_restore();
    show_page(page<RepairPage>());
}

void MainWindow::start_restored(const QString& line) {
    start();
    show_message(line, false);
}

void MainWindow::look_around() {
    show_page(page<FirstStartPage>());
    page<FirstStartPage>()->look_around();
}

Page* MainWindow::current_page() const {
    return static_cast<Page*>(stack_->currentWidget());
}

void MainWindow::set_theme(Theme theme) {
    apply_theme(*qApp, theme);
    store_theme(theme);
    theme_->setText(theme_title(theme == Theme::light ? Theme::dark : Theme::light));
    theme_->setAccessibleName(theme_->text());
    update();
    emit context_.appearance_changed();
}

void MainWindow::rebuild() {
    const std::type_index shown = typeid(*current_page());
    const QString used = focusWidget() != nullptr ? focusWidget()->objectName() : QString();
    drafts_.keep(made<CurriculumPage>());
    std::vector<PeoplePage::Issued> issued;
    if (const auto* people = made<PeoplePage>()) issued = people->issued();
    for (auto& [type, old] : pages_) old->leave();
    pages_.clear();
    rail_buttons_.clear();
    message_timer_.stop();
    build();  // what there was is deleted with the old central widget
    connect_first_pages();
    if (context_.signed_in()) {
        show_session();
        if (const auto draft = drafts_.take(context_.session())) page<CurriculumPage>()->take_up(*draft);
        for (const PeoplePage::Issued& one : issued) page<PeoplePage>()->show_issued(one);
        if (shown == typeid(SettingsPage))
            show_page(page<SettingsPage>());
        else
            show_home();
        // Without a name it would be any widget, such as one that nobody sees the focus on.
        auto* control = used.isEmpty() ? nullptr : centralWidget()->findChild<QWidget*>(used);
        if (control != nullptr) {
            control->setFocus();
            bring_into_view(control);
        }
    } else if (shown == typeid(SignInPage)) {
        show_sign_in();
    } else {
        start();
    }
}

void MainWindow::show_page(Page* next) {
    Page* before = current_page();
    if (before != next) question_->take_back();
    if (before != nullptr && before != next) before->leave();
    if (before != next && typeid(*next) == typeid(TheatrePage)) message_area_->hide();
    stack_->setCurrentWidget(next);
    const bool theatre = typeid(*next) == typeid(TheatrePage);
    const bool before_sign_in = !context_.signed_in();
    top_bar_->setVisible(context_.services().store() != nullptr && !before_sign_in);
    menu_->setChecked(false);
    show_rail();
    show_banner();
    role_->setEnabled(!theatre);
    for (auto& [button, entry] : rail_buttons_) {
        const QSignalBlocker quiet(button);
        button->setChecked(entry->type == std::type_index(typeid(*next)));
    }
    next->enter();
}

void MainWindow::session_changed() {
    question_->take_back();
    idle_.set_active(context_.signed_in());
    if (!context_.signed_in()) {
        drafts_.keep(made<CurriculumPage>());
        // Nothing of one person's screens stays for the next.
        for (auto& [type, old] : pages_) {
            if (old == page<FirstStartPage>() || old == page<SignInPage>() || old == page<RepairPage>())
                continue;
            old->leave();
            stack_->removeWidget(old);
            old->deleteLater();
        }
        std::map<std::type_index, Page*> kept;
        kept[typeid(FirstStartPage)] = page<FirstStartPage>();
        kept[typeid(SignInPage)] = page<SignInPage>();
        kept[typeid(RepairPage)] = page<RepairPage>();
        pages_ = std::move(kept);
        clear_layout(rail_layout_);
        rail_buttons_.clear();
        message_area_->hide();
        setWindowTitle(tr("Fulcrum"));
        show_sign_in();
        return;
    }
    look_for_followed();
    show_session();
    if (const auto draft = drafts_.take(context_.session())) page<CurriculumPage>()->take_up(*draft);
    context_.score_interrupted();
    if (current_page() != page<FirstStartPage>()) show_home();
}

/// An exchange of another program (`fulcrum sync`) may have brought it since.
void MainWindow::look_for_followed() {
    const std::string& person = context_.session().person_id();
    if (!context_.allowed(database::Operation::read_progress, database::Subject::person(person))) return;
    context_.guarded([&] {
        const Curriculum& newest = context_.services().curriculum();
        if (!database::Curricula(context_.store()).missing(context_.session(), person, newest).empty())
            context_.services().look_for_curriculum();
    });
}

void MainWindow::show_session() {
    const database::Session& session = context_.session();
    const QString role = role_text(database::role_name(session.role()));
    setWindowTitle(tr("Fulcrum — %1, %2").arg(text(session.display_name()), role));
    programme_->setText(context_.store().is_demo() ? tr("Demonstration")
                                                   : text(context_.store().programme_name()));
    person_->setText(text(session.display_name()));
    // A usual name is whole; the programme, which is the same on every screen, gives way.
    person_->setMinimumWidth(std::min(person_->sizeHint().width(), text_percent() > 150 ? 200 : 240));
    role_->clear();
    for (const database::Role held : session.roles())
        role_->addItem(tr("Acting as %1").arg(role_text(database::role_name(held))), static_cast<int>(held));
    show_role_in_use();
    // Qt keeps the least width of a combo box when its content changes: it would stay as wide as the last
    // person's role.
    QEvent look_again(QEvent::StyleChange);
    QCoreApplication::sendEvent(role_, &look_again);
    fill_rail();
}

void MainWindow::fill_rail() {
    clear_layout(rail_layout_);
    rail_buttons_.clear();
    if (context_.session().must_change_password()) return;
    for (const PageEntry* entry : pages_of(context_)) {
        QPushButton* button = make_button(page_title(*entry), entry->name, "rail");
        button->setCheckable(true);
        rail_layout_->addWidget(button);
        rail_buttons_.emplace_back(button, entry);
        connect(button, &QPushButton::clicked, this,
                [this, entry] { show_page(page(entry->type, entry->make)); });
    }
    rail_layout_->addStretch();
    if (!context_.session().is_demo() && !on_server()) {
        QPushButton* password = make_button(tr("Change password"), "rail_password", "rail");
        connect(password, &QPushButton::clicked, this, [this] { show_page(page<PasswordPage>()); });
        rail_layout_->addWidget(password);
    }
    rail_switch_user_ = make_button(tr("Switch user"), "rail_switch_user", "rail");
    connect(rail_switch_user_, &QPushButton::clicked, this, &MainWindow::switch_user);
    rail_layout_->addWidget(rail_switch_user_);
    fit_rail();
}

void MainWindow::show_home() {
    if (!context_.signed_in()) {
        show_sign_in();
    } else if (context_.session().must_change_password()) {
        show_page(page<PasswordPage>());
    } else if (!rail_buttons_.empty()) {
        const PageEntry* first = rail_buttons_.front().second;
        show_page(page(first->type, first->make));
    }
}

void MainWindow::show_sign_in() {
    show_page(page<SignInPage>());
}

void MainWindow::lock() {
    question_->take_back();
    used_before_lock_ = focusWidget();
    used_name_ = used_before_lock_ != nullptr ? used_before_lock_->objectName() : QString();
    if (TheatrePage* theatre = running_theatre()) theatre->pause();
    keep_comment();
    message_area_->hide();
    layers_->setCurrentWidget(lock_page_);
    lock_page_->enter();
}

void MainWindow::unlock() {
    question_->take_back();
    idle_.unlocked();
    layers_->setCurrentIndex(0);
    if (!message_area_->isHidden()) {  // came behind the lock
        announce(message_area_, message_text_->text());
        if (message_->property("role").toString() == QLatin1String("message")) message_timer_.start();
    }
    Page* const shown = current_page();
    if (shown == nullptr) return;
    const auto usable = [shown](const QWidget* one) {
        return one->isVisible() && one->isEnabled() && shown->isAncestorOf(one);
    };
    QWidget* used = used_before_lock_;
    if (used == nullptr || !usable(used)) {
        used = nullptr;
        // What was read behind the lock may have put another one with its name in its place.
        const QList<QWidget*> same = shown->findChildren<QWidget*>(used_name_);
        const auto found = std::find_if(same.begin(), same.end(), usable);
        if (!used_name_.isEmpty() && found != same.end()) used = *found;
    }
    // The theatre asks what is to happen next, also where the lock closed its attempt.
    shown->take_keyboard(qobject_cast<TheatrePage*>(shown) != nullptr ? nullptr : used);
}

void MainWindow::resizeEvent(QResizeEvent* event) {
    QMainWindow::resizeEvent(event);
    if (stack_ == nullptr || stack_->currentWidget() == nullptr) return;  // not built yet
    menu_->setChecked(false);
    fit_rail();
}

}  // namespace fulcrum::ui

#include "moc_main_window.cpp"
