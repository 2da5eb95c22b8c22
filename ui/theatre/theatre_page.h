// SPDX-License-Identifier: GPL-3.0-or-later
// The theatre: an attempt while it runs. Reads mouse and keyboard, shows the world, pauses (scene hidden),
// helps, abandons; when the attempt is stored it opens the debrief.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>

#include "ui/page/context.h"
#include "ui/theatre/begin_place.h"
#include "ui/theatre/feedback.h"
#include "ui/theatre/taught_lines.h"

class QFrame;
class QLabel;
class QPushButton;

namespace fulcrum::ui {

class MouseKeyboardInput;
class TwoMice;
class TheatreView;

class TheatrePage : public Page {
    Q_OBJECT
  public:
    explicit TheatrePage(Context& context);
    ~TheatrePage() override;
    /// Prepares an attempt; false (and a message) when it cannot. It begins once its scene has been drawn.
    /// Practice only: `goal` > 0, from the beginning of that goal in a demonstration on; `ghost`, with an
    /// expert's instruments.
    bool begin(const std::string& task_id, bool assessed, int goal = 0, bool ghost = false,
               const std::string& variant = {});
    /// Prepares a practice run that begins with a moment of a stored attempt; else as begin().
    bool take_over(std::shared_ptr<const ReplayMoment> from);
    /// An expert operator performs the task to be watched; afterwards the briefing is wanted.
    bool demonstrate(const std::string& task_id, const std::string& variant = {});
    bool is_running() const { return session_ != nullptr; }
    void enter() override;
    void leave() override;
    void pause();
    /// Who ends an attempt before its time: the trainee, who abandons it, or the watch over idle hands, which
    /// interrupts it.
    enum class Closed { by_trainee, by_idle_watch };
    /// What was closed and whether it is stored; empty: nothing ran.
    QString close_attempt(Closed why);
    /// Someone wants to go elsewhere while the attempt runs: pause and ask.
    void ask_before_leaving();
    TheatreView* view() const { return view_; }
    const AttemptSession* session() const { return session_.get(); }
    /// The hands while an attempt runs, else null.
    MouseKeyboardInput* input() const { return input_.get(); }
    /// What the hands of the attempt did of what its scene needs.
    HandDeeds deeds() const;

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    enum class Panel { none, paused, leaving, device_lost, finishing, failed };
    bool open(const std::function<void()>& work);
    /// An attempt with the device in use; `input` moves what that device does not have. `first`: the goal
    /// that it begins with; null: not known.
    AttemptRequest request(const std::string& task_id, bool assessed, MouseKeyboardInput& input,
                           const Scene& scene, const Goal* first = nullptr);
    bool has_begun() const;
    bool takes_hands() const;
    bool hands_are_there();
    void prepare();
    void align();
    void cancel();
    void end_session();
    void tick();
    void follow_phase();
    void show_world();
    void show_panel(Panel panel, const QString& heading, const QString& line);
    void place_panel();
    void take_up(const DeviceInUse& device, MouseKeyboardInput& input);
    QString learnt_key() const;
    /// What this person did before with this kind of device.
    HandDeeds learnt() const;
    void keep_learnt(const HandDeeds& deeds) const;
    void begin_teaching();
    void skip_teaching();
    void teach_again();
    HandDeeds needed() const;
    /// With at most so many lines.
    QString strip_words(int most) const;
    void show_strip();
    /// With as many lines as leave the height that times and forces need above it.
    void place_strip();
    /// Texts and bars of the view go out of its way.
    void clear_of_strip();
    void resume();
    void abandon();
    void finish();
    void toggle_help();
    void toggle_sound();
    void show_sound();
    bool key(QKeyEvent* event, bool pressed);
    void mouse_move(QMouseEvent* event);
    void read_mice();
    void read_controller();
    void note_use();
    void give_feedback();
    void keep_pointer(const QPoint& place);

    std::unique_ptr<AttemptSession> session_;
    std::unique_ptr<MouseKeyboardInput> input_;
    std::unique_ptr<TwoMice> mice_;        ///< null: one mouse and the keyboard
    std::shared_ptr<GameController> pad_;  ///< null: no game controller
    std::shared_ptr<HandWatch> watch_;     ///< null: nobody moves the hands here
    std::uint32_t seen_uses_ = 0;
    TaughtHands hands_;
    QString hands_title_;  ///< of a device that the daemon reads
    QString strip_all_;    ///< words of the strip, before what has no room is left out
    HandDeeds known_;      ///< before this attempt
    std::optional<GhostPace> ghost_;
    BeginPlace begin_place_;
    Feedback feedback_;
    TheatreView* view_;
    QFrame *panel_, *bar_, *strip_;
    QLabel *panel_heading_, *panel_text_, *strip_text_;
    QPushButton *resume_, *abandon_, *pause_, *help_, *sound_, *leave_;
    QTimer timer_;
    QElapsedTimer since_tick_, since_picture_;
    double since_moved_ = -1;       ///< s of work since a hand moved; negative: none has
    std::uint32_t strip_tick_ = 0;  ///< at the last look at the strip
    Panel shown_ = Panel::none;
    std::vector<bool> done_;
    int active_target_ = -1;
    QPoint last_mouse_;                  ///< on the screen
    std::optional<QPoint> put_back_to_;  ///< of the pointer, until it is seen there
    bool world_is_new_ = false, mouse_known_ = false, help_shown_ = false, world_loading_ = false,
         aligning_ = false, learns_ = false, teaching_begun_ = false, strip_ended_ = false;
    QString demonstrated_;   ///< task, while it is a demonstration
    bool help_fits_ = true;  ///< to the device in use, while it is a demonstration
};

}  // namespace fulcrum::ui
