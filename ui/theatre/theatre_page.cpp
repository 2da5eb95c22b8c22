// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/theatre_page.h"

#include "assessment/task/asked_hand.h"
#include "ui/services/device_in_scene.h"
#include "ui/style/announce.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/theatre_view.h"
#include "ui/theatre/two_mice.h"

namespace fulcrum::ui {

TheatrePage::TheatrePage(Context& context) : Page(context, "theatre_page"), view_(new TheatreView) {
    view_->setObjectName(QStringLiteral("theatre_view"));
    view_->set_paced(true);
    view_->setMouseTracking(true);
    view_->installEventFilter(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(view_, 1);

    bar_ = new QFrame;
    bar_->setProperty("role", "top_bar");
    auto* row = new QHBoxLayout(bar_);
    row->setContentsMargins(14, 5, 14, 5);
    pause_ = make_button(tr("Pause (Esc)"), "theatre_pause");
    help_ = make_button(tr("Keys (F1)"), "theatre_help");
    sound_ = make_button({}, "theatre_sound");
    leave_ = make_button(tr("Abandon …"), "theatre_abandon");
    for (QPushButton* button : {pause_, help_, sound_, leave_}) button->setFocusPolicy(Qt::NoFocus);
    row->addWidget(pause_);
    row->addWidget(help_);
    row->addWidget(sound_);
    row->addStretch();
    row->addWidget(leave_);
    layout->addWidget(bar_);

    panel_ = make_card(12);
    panel_->setParent(this);
    panel_->setObjectName(QStringLiteral("theatre_panel"));
    panel_heading_ = make_label({}, "title");
    panel_text_ = make_label({});
    panel_text_->setObjectName(QStringLiteral("panel_text"));
    card_layout(panel_)->addWidget(panel_heading_);
    card_layout(panel_)->addWidget(panel_text_);
    auto* buttons = new QHBoxLayout;
    abandon_ = make_button(tr("Abandon the attempt"), "panel_abandon");
    resume_ = make_button(tr("Resume"), "panel_resume", "primary");
    buttons->addWidget(abandon_);
    buttons->addStretch();
    buttons->addWidget(resume_);
    card_layout(panel_)->addLayout(buttons);
    panel_->hide();
    strip_ = make_card(0);
    strip_->setParent(this);
    card_layout(strip_)->setContentsMargins(12, 6, 12, 6);  // the forces above stay visible
    strip_->setObjectName(QStringLiteral("theatre_keys"));
    strip_->setAttribute(Qt::WA_TransparentForMouseEvents);
    strip_text_ = make_label({});
    card_layout(strip_)->addWidget(strip_text_);
    strip_->hide();

    connect(pause_, &QPushButton::clicked, this, &TheatrePage::pause);
    connect(help_, &QPushButton::clicked, this, &TheatrePage::toggle_help);
    connect(sound_, &QPushButton::clicked, this, &TheatrePage::toggle_sound);
    connect(leave_, &QPushButton::clicked, this, &TheatrePage::ask_before_leaving);
    connect(resume_, &QPushButton::clicked, this, &TheatrePage::resume);
    connect(abandon_, &QPushButton::clicked, this, &TheatrePage::abandon);
    timer_.setTimerType(Qt::PreciseTimer);
    timer_.setInterval(16);
    connect(&timer_, &QTimer::timeout, this, &TheatrePage::tick);
}

TheatrePage::~TheatrePage() {
    if (session_ != nullptr && has_begun()) session_->abandon();
}

bool TheatrePage::open(const std::function<void()>& work) {
    if (is_running()) return false;
    demonstrated_.clear();
    const bool opened = context().guarded([&] {
        work();
        world_loading_ = aligning_ = false;
        done_.clear();
        active_target_ = -1;
        help_shown_ = false;
        mouse_known_ = false;
        view_->unload();
    });
    if (!opened) {  // nothing reads them
        mice_.reset();
        pad_.reset();
        watch_.reset();
    }
    return opened;
}

AttemptRequest TheatrePage::request(const std::string& task_id, bool assessed, MouseKeyboardInput& input,
                                    const Scene& scene, const Goal* first) {
    watch_ = std::make_shared<HandWatch>(scene);
    const auto rig = std::make_shared<WatchedRig>(context().services().hands(scene, input.rig()), watch_);
    pad_ = context().services().game_controller();
    // Known once it is open.
    const DeviceInUse device = device_in_scene(context().services().device_in_use(), scene);
    mice_ = device.two_mice ? TwoMice::open(device.virtual_mice) : nullptr;
    // A device of the daemon moves its parts with a scale of its own; the mouse next to it keeps the mouse's.
    input.set_sensitivity(context().services().motion_scale(pad_ != nullptr ? device.kind : std::string()));
    input.set_keys(KeyMap::of_person(context().session().person_id()));
    take_up(device, input);
    if (input.keys().left_handed()) input.take_hand(Hand::left);
    if (first != nullptr) input.take_hand(asked_hand(*first).value_or(input.active_hand()));
    // The mouse is for the hand that the device does not move.
    if (hands_.drives[0] != hands_.drives[1]) input.take_hand(hands_.drives[0] ? Hand::right : Hand::left);
    return {context().session(),
            task_id,
            assessed,
            0,
            rig,
            device.device_class,
            device.title,
            device.practice_only != PracticeOnly::no,
            nullptr,
            0,
            false,
            {}};
}

bool TheatrePage::begin(const std::string& task_id, bool assessed, int goal, bool ghost,
                        const std::string& variant) {
    const TaskDefinition* task = context().task(task_id);
    return task != nullptr && open([&] {
               const Scene scene = context().services().scene_for(*task, variant);
               auto input = std::make_unique<MouseKeyboardInput>(scene);
               const Goal* const first =
                   task->goals.empty() ? nullptr : &task->goals[static_cast<std::size_t>(goal)];
               AttemptRequest asked = request(task_id, assessed, *input, scene, first);
               asked.goal = goal;
               asked.ghost = ghost;
               asked.variant = variant;
               session_ = context().services().start_attempt(asked);
               input_ = std::move(input);
           });
}

bool TheatrePage::take_over(std::shared_ptr<const ReplayMoment> from) {
    return from != nullptr && open([&] {
               auto input = std::make_unique<MouseKeyboardInput>(from->scene());
               AttemptRequest asked = request(from->task_id(), false, *input, from->scene());
               asked.from = from;
               session_ = context().services().start_attempt(asked);
               input_ = std::move(input);
           });
}

bool TheatrePage::demonstrate(const std::string& task_id, const std::string& variant) {
    const TaskDefinition* task = context().task(task_id);
    return task != nullptr && open([&] {
               mice_.reset();
               pad_.reset();
               watch_.reset();
               const Scene scene = context().services().scene_for(*task, variant);
               session_ = context().services().start_demonstration(context().session(), task_id, variant);
               input_ = std::make_unique<MouseKeyboardInput>(scene);
               input_->set_keys(KeyMap::of_person(context().session().person_id()));
               // What moves nothing here has the class of mouse and keyboard, as in an attempt.
               const DeviceInUse device = device_in_scene(context().services().device_in_use(), scene);
               help_fits_ = device.device_class == window_device && !device.two_mice;
               demonstrated_ = text(task_id);
           });
}

void TheatrePage::enter() {
    show_panel(Panel::none, {}, {});
    if (is_running()) view_->set_notice(tr("Preparing the scene …"));
    show_sound();
    since_tick_.start();
    timer_.start();
    view_->setFocus();
}

bool TheatrePage::has_begun() const {
    return session_ != nullptr && session_->phase() != AttemptPhase::starting &&
           session_->phase() != AttemptPhase::ready;
}

/// Nothing is on the clock yet: the geometry is made, the first picture drawn, then the attempt begins.
void TheatrePage::prepare() {
    if (!world_loading_) {
        world_loading_ = true;
        view_->load(session_->scene(), session_->snapshot());
        view_->set_notice(tr("Preparing the scene …"));
        return;
    }
    if (!view_->drawing_error().isEmpty()) {
        const QString why = view_->drawing_error();
        end_session();
        show_panel(Panel::failed, tr("The attempt did not begin"),
                   tr("The scene cannot be drawn on this machine: %1. Nothing was stored.").arg(why));
        return;
    }
    if (!view_->is_loaded()) return;
    if (view_->pictures() == 0) {
        view_->set_notice({});
        show_world();
    } else if (shown_ == Panel::none && isVisible() && hands_are_there()) {
        mouse_known_ = false;
        since_tick_.restart();
        if (const RigSample* hands = session_->hands_at_start()) input_->begin_from(*hands);
        if (const auto path = session_->ghost()) ghost_.emplace(path);
        session_->start();
    }
}

void TheatrePage::end_session() {
    timer_.stop();
    strip_->hide();
    since_moved_ = -1;
    strip_tick_ = 0;
    learns_ = teaching_begun_ = strip_ended_ = false;
    session_.reset();
    input_.reset();
    watch_.reset();
    mice_.reset();
    give_feedback();
    pad_.reset();
    ghost_.reset();
    begin_place_.reset();
    aligning_ = false;
    view_->unload();
    view_->unsetCursor();
}

/// Before it has begun, and of a demonstration at any time: it is as if it had never been.
void TheatrePage::cancel() {
    const QString task = demonstrated_.isEmpty() ? text(session_->task().id) : demonstrated_;
    const QString variant = session_ == nullptr ? QString() : text(session_->scene().variant);
    end_session();
    emit context().briefing_wanted(task, variant);
}

void TheatrePage::leave() {
    timer_.stop();
    view_->unsetCursor();
    close_attempt(Closed::by_trainee);
}

QString TheatrePage::close_attempt(Closed why) {
    if (session_ == nullptr) return {};
    const bool watched = !demonstrated_.isEmpty(), begun = has_begun() && !watched;
    const bool abandons = why == Closed::by_trainee;
    if (begun && abandons) session_->abandon();
    if (begun && !abandons) session_->interrupt();
    end_session();
    const QString line = watched    ? tr("The demonstration was closed; nothing was stored.")
                         : !begun   ? tr("The attempt had not begun; nothing was stored.")
                         : abandons ? tr("The attempt was closed, counts as abandoned and is stored.")
                                    : tr("The attempt was closed as interrupted and stored.");
    show_panel(Panel::failed, !begun ? tr("Closed") : abandons ? tr("Abandoned") : tr("Interrupted"), line);
    return line;
}

void TheatrePage::pause() {
    if (session_ == nullptr) return;
    if (!has_begun() || !demonstrated_.isEmpty()) {
        // What has not begun, or is only watched, waits without a word: the theatre is hidden behind the
        // lock.
        if (session_->phase() == AttemptPhase::running) session_->pause();
        return;
    }
    if (session_->phase() != AttemptPhase::running) return;
    session_->pause();
    input_->release_all();
    show_panel(Panel::paused, tr("Paused"),
               tr("The timer is stopped and the scene is hidden. The pause is recorded."));
}

void TheatrePage::resume() {
    if (session_ == nullptr) {
        emit context().home_wanted();
        return;
    }
    session_->resume();
    mouse_known_ = false;
    show_panel(Panel::none, {}, {});
    view_->setFocus();
}

void TheatrePage::ask_before_leaving() {
    if (session_ == nullptr) return;
    if (!has_begun() || !demonstrated_.isEmpty()) {
        cancel();
        return;
    }
    aligning_ = false;
    view_->set_realignment({});
    if (session_->phase() == AttemptPhase::running) session_->pause();
    input_->release_all();
    const bool counts = session_->assessed() && session_->display().moving_seen;
    show_panel(Panel::leaving, tr("Abandon this attempt?"),
               counts ? tr("This attempt is assessed and has begun. If you abandon it, it counts as failed. "
                           "Everything recorded so far is kept.")
                      : tr("This attempt is stored as abandoned and does not count."));
}

void TheatrePage::abandon() {
    if (session_ == nullptr) {
        emit context().home_wanted();
        return;
    }
    session_->abandon();
    show_panel(Panel::finishing, tr("Storing the attempt …"), {});
}

void TheatrePage::show_panel(Panel panel, const QString& heading, const QString& line) {
    shown_ = panel;
    panel_->setVisible(panel != Panel::none);
    const bool hides = panel != Panel::none, can_choose = hides && panel != Panel::finishing;
    setFocusProxy(can_choose ? static_cast<QWidget*>(resume_) : view_);  // of the page, when it is unlocked
    view_->set_notice(hides ? QStringLiteral(" ") : QString());
    view_->setFocusPolicy(hides ? Qt::ClickFocus : Qt::StrongFocus);  // Tab does not lead to what is hidden
    for (QPushButton* button : {pause_, help_, leave_}) button->setEnabled(!hides);
    sound_->setFocusPolicy(hides ? Qt::StrongFocus : Qt::NoFocus);  // its key belongs to the scene
    view_->setCursor(hides || !demonstrated_.isEmpty() ? Qt::ArrowCursor : Qt::BlankCursor);
    pause_->setVisible(demonstrated_.isEmpty());
    help_->setVisible(demonstrated_.isEmpty() || help_fits_);
    leave_->setText(demonstrated_.isEmpty() ? tr("Abandon …") : tr("End the demonstration (Esc)"));
    if (!hides) return;
    help_shown_ = false;
    view_->set_cover({}, {});
    panel_heading_->setText(heading);
    panel_text_->setText(line);
    panel_text_->setVisible(!line.isEmpty());
    resume_->setVisible(can_choose);
    resume_->setText(panel == Panel::failed ? tr("Home") : tr("Resume"));
    abandon_->setVisible(can_choose && panel != Panel::failed);
    place_panel();
    panel_->raise();
    if (can_choose && isVisible()) resume_->setFocus();
    if (isVisible()) announce(panel_, heading + QLatin1Char(' ') + line);
}

void TheatrePage::tick() {
    if (session_ == nullptr) return;
    const double dt = std::min(static_cast<double>(since_tick_.restart()) * 1e-3, 0.4);
    if (mice_ != nullptr) read_mice();
    if (pad_ != nullptr) read_controller();
    note_use();
    if (session_ == nullptr) return;
    if (session_->phase() == AttemptPhase::running || aligning_) input_->advance(dt);
    world_is_new_ = session_->update() || world_is_new_;
    follow_phase();
    give_feedback();
    if (session_ == nullptr) {
        strip_->hide();
        return;
    }
    show_strip();
    if (!world_is_new_) return;
    // At most 33 pictures a second, and never so many that drawing takes more than two thirds of this thread:
    // the hands are read here too.
    const double pause_ms = std::max(30.0, 1.5 * view_->last_frame_ms());
    if (since_picture_.isValid() && static_cast<double>(since_picture_.elapsed()) < pause_ms) return;
    since_picture_.start();
    world_is_new_ = false;
    show_world();
}

void TheatrePage::follow_phase() {
    switch (session_->phase()) {
        case AttemptPhase::starting:
            break;
        case AttemptPhase::ready:
            prepare();
            break;
        case AttemptPhase::running:
            if (aligning_) {
                aligning_ = false;
                view_->set_realignment({});
            }
            if (shown_ == Panel::device_lost || shown_ == Panel::paused) show_panel(Panel::none, {}, {});
            break;
        case AttemptPhase::paused:
            if (!demonstrated_.isEmpty()) {
                if (isVisible()) session_->resume();
            } else if (shown_ == Panel::none) {
                show_panel(Panel::paused, tr("Paused"),
                           tr("The timer is stopped and the scene is hidden. The pause is recorded."));
            }
            break;
        case AttemptPhase::device_lost:
            align();
            break;
        case AttemptPhase::finishing:
            if (shown_ != Panel::finishing) show_panel(Panel::finishing, tr("Storing the attempt …"), {});
            break;
        case AttemptPhase::finished:
            finish();
            break;
        case AttemptPhase::failed: {
            const QString why = sentence_text(session_->message());
            end_session();
            show_panel(Panel::failed, tr("The attempt could not continue"), why);
            break;
        }
    }
}

/// A device is lost: a message while it is away, its ghosts when it is back.
void TheatrePage::align() {
    if (shown_ == Panel::leaving) return;
    const Realignment realignment = session_->realignment();
    const bool was_aligning = aligning_;
    aligning_ = realignment.back;
    if (!realignment.back) {
        if (was_aligning) view_->set_realignment({});
        const QString trouble = sentence_text(context().services().device_trouble());
        const QString line = trouble.isEmpty()
                                 ? sentence_text(session_->message())
                                 : trouble + QLatin1Char(' ') +
                                       tr("The force is 0 and the timer is stopped; the recording is kept.");
        if (shown_ != Panel::device_lost || line != panel_text_->text())
            show_panel(Panel::device_lost, tr("Device lost"), line);
        return;
    }
    if (shown_ != Panel::none) {
        show_panel(Panel::none, {}, {});
        if (isVisible()) view_->setFocus();
        mouse_known_ = false;
    }
    view_->set_realignment(realignment);
}

void TheatrePage::finish() {
    if (!demonstrated_.isEmpty()) {
        cancel();
        return;
    }
    const std::string id = session_->outcome() ? session_->outcome()->attempt_id : std::string();
    end_session();
    if (id.empty()) {
        emit context().home_wanted();
    } else {
        emit context().debrief_wanted(text(id), -1);
    }
}

void TheatrePage::show_world() {
    const TaskDisplay& display = session_->display();
    const WorldSnapshot& world = session_->snapshot();
    input_->set_camera(world.camera.orientation);
    done_.resize(world.targets.size(), false);
    if (display.active_target != active_target_) {
        // Targets are asked for one after the other: the one that is asked for no more was held.
        if (active_target_ >= 0 && static_cast<std::size_t>(active_target_) < done_.size()) {
            done_[static_cast<std::size_t>(active_target_)] = true;
        }
        active_target_ = display.active_target;
    }
    const LoopHealth health = session_->health();
    HudState hud;
    hud.task = &session_->task();
    set_scope(hud, session_->scene());
    hud.display = display;
    hud.assessed = session_->assessed();
    hud.became_practice = session_->became_practice();
    if (!demonstrated_.isEmpty()) hud.place = tr("demonstration by a simulated expert");
    hud.active_hand = input_->active_hand();
    hud.shows_active_hand = demonstrated_.isEmpty() && mice_ == nullptr && pad_ == nullptr;
    hud.next_key = input_->keys().words(KeyAction::exchange);
    hud.pedal_key = input_->keys().words(KeyAction::pedal);
    hud.force_felt = !demonstrated_.isEmpty() || health.force_felt[0] || health.force_felt[1];
    for (int h = 0; h < hand_count; ++h) {
        const InstrumentSpec* spec = session_->scene().instrument(static_cast<Hand>(h));
        const bool by_input = demonstrated_.isEmpty() && !hands_.drives[h];
        hud.jaws_closed[h] =
            by_input ? input_->jaws_closed(static_cast<Hand>(h)) : world.tools[h].jaw_angle < 0.3;
        hud.has_jaws[h] = spec != nullptr && type_of(spec->kind).jaws;
        if (spec != nullptr && !spec->exchange.empty() && !world.field.empty()) {
            hud.has_jaws[h] = type_of(world.field[0].tools[h].kind).jaws;
            hud.tool[h] = tool_words(world.field[0].tools[h]);
            hud.tool_active[h] = world.field[0].tools[h].active;
        }
    }
    if (health.missed_ticks > 0 || health.lost_samples > 0) {
        hud.health = tr("%1 of %2 ticks missed").arg(health.missed_ticks).arg(health.ticks);
    }
    view_->set_ghost(ghost_ ? &ghost_->follow(world.tools, display.goal) : nullptr);
    if (ghost_) hud.place = tr("the ghost of an expert waits for you");
    view_->set_hud(hud);
    view_->set_targets(done_, display.active_target, display.hold_progress > 0);
    view_->show_world(world);
}

}  // namespace fulcrum::ui

#include "moc_theatre_page.cpp"
