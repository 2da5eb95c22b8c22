// SPDX-License-Identifier: GPL-3.0-or-later
// What every page shares: the services, who is signed in, and how to reach other pages. UI thread.
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QWidget>
#include <functional>
#include <optional>

#include "database/access/access.h"
#include "ui/language/language.h"
#include "ui/services/application_services.h"
#include "ui/style/palette.h"

class QLineEdit;

namespace fulcrum::ui {

class BackgroundJob;

/// "Deeper spheres"; the id alone for a variant that the task does not have, or without a task.
QString variant_title(const TaskDefinition* task, const std::string& variant);

class Context : public QObject {
    Q_OBJECT
  public:
    explicit Context(ApplicationServices& services, QObject* parent = nullptr)
        : QObject(parent), services_(services) {}

    ApplicationServices& services() { return services_; }
    /// Only after the store was opened.
    database::Store& store() { return *services_.store(); }
    bool signed_in() const { return session_.has_value(); }
    /// Only while signed in.
    const database::Session& session() const { return *session_; }
    void set_session(const database::Session& session);
    void sign_out();
    /// What the store will answer; false while nobody is signed in, and if the store cannot be read (reported
    /// as by guarded()).
    bool allowed(database::Operation operation, const database::Subject& subject = {});

    const TaskDefinition* task(const std::string& id);
    /// "A2 · Fulcrum targeting"; the id alone for a task that this program does not know.
    QString task_title(const std::string& id);
    QString variant_title(const std::string& task_id, const std::string& variant) {
        return ui::variant_title(task(task_id), variant);
    }

    /// Runs `work`; what it throws becomes a message and false. The one place where errors of a page end.
    bool guarded(const std::function<void()>& work);
    void say(const QString& line) { emit message(line, false); }
    void complain(const QString& line) { emit message(line, true); }
    /// Attempts that were interrupted earlier and were scored at this sign-in.
    const std::vector<InterruptedScore>& interrupted() const { return interrupted_; }
    /// Asks for those scores on a thread of its own; interrupted_scored() follows if there were any.
    void score_interrupted();
    /// Another text size or language, where one was chosen.
    struct Look {
        std::optional<int> text_percent;
        std::optional<Language> language;
    };
    /// That was chosen while the window asks whether the pages may be made again for it.
    const Look& asked_look() const { return asked_look_; }
    void set_asked_look(const Look& look) {
        asked_look_ = look;
        emit appearance_changed();
    }
    /// Devices other than mouse and keyboard report their activity here, so that the window does not lock.
    void note_input() { emit input_seen(); }

  signals:
    void session_changed();
    void message(const QString& line, bool is_error);
    void input_seen();
    void home_wanted();
    /// `variant` empty: the one that who is signed in has practised least. `goal` and `ghost`: the beginning
    /// of practice that is chosen there.
    void briefing_wanted(const QString& task_id, const QString& variant = {}, int goal = 0,
                         bool ghost = false);
    /// Practice only: `goal` > 0, from the beginning of that goal on; `ghost`, with an expert's instruments.
    void attempt_wanted(const QString& task_id, bool assessed, int goal, bool ghost,
                        const QString& variant = {});
    void demonstration_wanted(const QString& task_id, const QString& variant = {});
    /// A practice run that begins with this moment of an attempt.
    void take_over_wanted(std::shared_ptr<const fulcrum::ui::ReplayMoment> from);
    void interrupted_scored();
    /// `time_s` < 0: from the start.
    void debrief_wanted(const QString& attempt_id, double time_s);
    /// This attempt next to another one.
    void compare_wanted(const QString& attempt_id);
    /// The debrief without name and score, to rate the attempt blind.
    void rating_wanted(const QString& attempt_id);
    /// Who is signed in has handed in a form of it; it was voided or reassigned here. A page that is not
    /// shown need not be read again to leave it out.
    void rating_handed_in(const QString& attempt_id);
    void attempt_voided(const QString& attempt_id);
    void progress_wanted(const QString& person_id, const QString& task_id);
    /// The page that explains the metrics, at this one; from there back to a moment of an attempt ("": none).
    void metric_wanted(const QString& metric_id, const QString& attempt_id, double time_s);
    void switch_user_wanted();
    /// A backup is to take the store's place.
    void restore_wanted();
    /// From the page of settings, also of what is in use; appearance_changed() follows once the window has
    /// it, or asks about it.
    void theme_wanted(fulcrum::ui::Theme theme);
    void text_size_wanted(int percent);
    void language_wanted(fulcrum::ui::Language language);
    void appearance_changed();

  private:
    ApplicationServices& services_;
    std::optional<database::Session> session_;
    std::vector<InterruptedScore> interrupted_;
    BackgroundJob* scoring_ = nullptr;
    Look asked_look_;
};

/// What a person types here is for nothing unless it is used: Page::begun_input() then has `what`, such as
/// "a reason". A text that the program puts in is nobody's input.
void mark_begun(QLineEdit* edit, const QString& what);

/// A page of the window's stack. enter() is called each time it is shown; leave() before another takes its
/// place.
class Page : public QWidget {
    Q_OBJECT
  public:
    explicit Page(Context& context, const char* name);
    virtual void enter() {}
    virtual void leave() {}
    /// After a lock. `used`: the control of the page that had the keyboard before; null where there is none
    /// any longer.
    virtual void take_keyboard(QWidget* used) { (used != nullptr ? used : this)->setFocus(); }
    /// With another language or text size the pages are made again; a sign-out ends the session; the window
    /// ends. Each ends what those before it end.
    enum class Ending { pages, session, window };
    /// What somebody has begun here that it would end, in words; empty: nothing, or what there is is kept.
    /// Of Page itself: what was typed into fields that are marked and not hidden. A page adds what else it
    /// has.
    virtual QStringList begun_input(Ending ending) const;

  protected:
    Context& context() const { return context_; }

  private:
    Context& context_;
};

}  // namespace fulcrum::ui
