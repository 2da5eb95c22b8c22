// SPDX-License-Identifier: GPL-3.0-or-later
// The one window: a top bar (programme, acting role, person, switch user), a rail of the role's pages, the
// page stack, and the lock.
#pragma once

#include <QMainWindow>
#include <QPointer>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <map>
#include <typeindex>
#include <vector>

#include "ui/page/context.h"
#include "ui/shell/idle_watch.h"
#include "ui/shell/kept_drafts.h"
#include "ui/shell/replay_watch.h"
#include "ui/shell/schedule_watch.h"
#include "ui/style/palette.h"

class QComboBox;
class QFrame;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QStackedWidget;
class QVBoxLayout;

namespace fulcrum::ui {

class BriefingPage;
class DebriefPage;
class ElidedLabel;
class LockPage;
struct PageEntry;
class ProgressPage;
class QuestionBar;
class TheatrePage;

/// The geometry nearest to `wanted` (without its frame) that the available part of a screen has room for,
/// frame included.
QRect fit_window(const QRect& wanted, const QRect& available, const QMargins& frame);

class MainWindow : public QMainWindow {
    Q_OBJECT
  public:
    explicit MainWindow(ApplicationServices& services, QWidget* parent = nullptr,
                        int lock_ms = IdleWatch::lock_after_ms, int close_ms = IdleWatch::close_after_ms);
    ~MainWindow() override;
    /// Opens the store if there is one and shows the first page: first start, sign-in, or what went wrong and
    /// what to do.
    void start();
    Context& context() { return context_; }
    Page* current_page() const;
    /// These three apply at once and are remembered. With another language or text size all pages are made
    /// again.
    void set_theme(Theme theme);
    void set_text_size(int percent);
    void set_language(Language language);

  protected:
    void closeEvent(QCloseEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool focusNextPrevChild(bool next) override;

  private:
    void build();
    QWidget* build_banner();
    QWidget* build_top_bar();
    QWidget* build_message();
    void keep_within_screen();
    void connect_context();
    void connect_lock_page();
    void connect_first_pages();
    /// All that is on the screen is made again; the page and the control in use are shown again, and the
    /// draft of a curriculum and a one-time password that is shown are kept.
    void rebuild();
    void session_changed();
    /// The version of the curriculum that the person follows, where it is not installed.
    void look_for_followed();
    /// Who is signed in, in which roles, and the pages for that.
    void show_session();
    void show_page(Page* page);
    void show_home();
    void show_sign_in();
    /// Nobody is signed in and no store is open then.
    void show_restore();
    void start_restored(const QString& line);
    void show_trouble(const QString& problem, const QString& hint, bool damaged);
    void look_around();
    void show_banner();
    /// Which has signed in the person whose account its address names.
    bool on_server() { return context_.services().store() != nullptr && context_.store().is_server(); }
    void fill_rail();
    /// As wide as its longest title needs. Where that is much of the window, the rail lies over the page and
    /// a button shows it.
    void fit_rail();
    /// Shows what the page and the room allow.
    void show_rail();
    void open_menu(bool open);
    /// Of the role that was chosen in the top bar: by keys or the wheel, too, it is only chosen.
    void ask_role(int index);
    void act_as(database::Role role);
    void show_role_in_use();
    void switch_user();
    /// Of the page that is shown: while its author is still signed in.
    void keep_comment();
    /// What would be lost by it, in words; each once.
    QStringList begun_input(Page::Ending ending) const;
    /// Does it; where somebody has begun something that it would end, only after a question.
    void unless_begun(Page::Ending ending, const std::function<void()>& end);
    /// All that was chosen and not answered yet; what is in use is no change.
    void ask_look(Context::Look look);
    void use_look(const Context::Look& look);
    void lock();
    void unlock();
    void show_message(const QString& line, bool is_error);
    /// Made on first use.
    Page* page(std::type_index type, Page* (*make)(Context&));
    template <typename P>
    P* page();
    /// Null where it was not used yet.
    template <typename P>
    P* made() const;
    /// The theatre while an attempt runs in it, else null.
    TheatrePage* running_theatre() const;

    Context context_;
    IdleWatch idle_;
    ScheduleWatch schedules_;
    ReplayWatch replays_;
    QuestionBar* question_ = nullptr;
    QStackedWidget* layers_ = nullptr;  ///< the window proper, the lock
    QStackedWidget* stack_ = nullptr;
    QFrame *top_bar_ = nullptr, *rail_ = nullptr, *banner_ = nullptr, *message_ = nullptr;
    QWidget* message_area_ = nullptr;
    ElidedLabel *programme_ = nullptr, *person_ = nullptr;
    QLabel *message_text_ = nullptr, *banner_text_ = nullptr;
    QTimer message_timer_;
    QComboBox* role_ = nullptr;
    QPushButton *switch_user_ = nullptr, *theme_ = nullptr, *menu_ = nullptr, *rail_switch_user_ = nullptr;
    QVBoxLayout* rail_layout_ = nullptr;
    QHBoxLayout* rail_and_pages_ = nullptr;  ///< rail and pages
    bool narrow_ = false;                    ///< too little room for rail and pages
    std::vector<std::pair<QPushButton*, const PageEntry*>> rail_buttons_;
    std::map<std::type_index, Page*> pages_;
    KeptDrafts drafts_;
    bool fitted_ = false;   ///< to the screen, with its real frame
    bool closing_ = false;  ///< although something was begun
    QPointer<QWidget> used_before_lock_;
    QString used_name_;  ///< its name: the page may be filled again behind the lock
    LockPage* lock_page_ = nullptr;
};

}  // namespace fulcrum::ui
