// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/replay_panel.h"

#include <QComboBox>
#include <QSlider>
#include <algorithm>
#include <cmath>
#include <limits>

#include "database/rows/trace_codec.h"
#include "sim_core/telemetry/event_types.h"
#include "ui/language/language.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::ui {
namespace {

constexpr double speeds[] = {0.1, 0.25, 0.5, 1, 2, 5, 10};
constexpr double step_s = 0.02;
constexpr int lowest_picture = 230;  // px, of one that is next to another

/// What a goal's progress event counts: targets, metres run, seconds held.
void show_progress(HudState& hud, double value) {
    const auto index = static_cast<std::size_t>(hud.display.goal);
    if (hud.task == nullptr || index >= hud.task->goals.size()) return;
    const Goal& goal = hud.task->goals[index];
    double whole = goal.hold_s;
    const GoalMeasure measure = type_of(goal.kind).measure;
    if (measure == GoalMeasure::count) whole = goal.count;
    if (measure == GoalMeasure::metres) whole = goal.length_m;
    hud.display.goal_progress = whole > 0 ? std::min(1.0, value / whole) : 0;
    if (goal.kind == GoalKind::run_bowel) hud.display.run_covered_m = value;
    if (goal.kind == GoalKind::divide_line) hud.display.cut_divided_m = value;
}

struct ShownTargets {
    std::vector<bool> done;
    int active = -1;
};

/// What an event leaves on the display until another one changes it.
void show_event(HudState& hud, ShownTargets& targets, const Event& event) {
    const EventType* type = find_type(event.kind);
    if (type == nullptr) return;
    if (type->weight == EventWeight::critical) hud.display.critical = true;
    switch (type->mark) {
        case ReplayMark::none:
            break;
        case ReplayMark::goal:
            hud.display.goal = event.detail;
            hud.display.goal_progress = hud.display.run_covered_m = 0;
            break;
        case ReplayMark::progress:
            if (event.detail == hud.display.goal) show_progress(hud, static_cast<double>(event.value));
            break;
        case ReplayMark::movement:
            hud.display.moving_seen = true;
            break;
        case ReplayMark::target_shown:
            targets.active = event.detail;
            break;
        case ReplayMark::target_reached: {
            if (event.detail < 0) break;
            const auto index = static_cast<std::size_t>(event.detail);
            targets.done.resize(std::max(targets.done.size(), index + 1), false);
            targets.done[index] = true;
            if (targets.active == event.detail) targets.active = -1;
            break;
        }
        case ReplayMark::blood:
            hud.display.blood_ml = event.value;
            break;
        case ReplayMark::traction:
            if (event.hand < hand_count) hud.display.traction_n_m = static_cast<double>(event.value);
            break;
        case ReplayMark::traction_over:
            hud.display.traction_n_m = std::numeric_limits<double>::quiet_NaN();
            break;
    }
}

}  // namespace

ReplayPanel::ReplayPanel(QWidget* parent) : QWidget(parent), view_(new TheatreView) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    view_->setMinimumHeight(360);
    layout->addWidget(view_, 1);
    slider_ = new QSlider(Qt::Horizontal);
    slider_->setObjectName(QStringLiteral("replay_slider"));
    slider_->setAccessibleName(tr("Moment of the attempt"));
    layout->addWidget(slider_);
    auto* row = new FlowRow;
    play_ = make_button(tr("Play"), "replay_play", "primary");
    back_ = make_button(tr("◀ Step"), "replay_back");
    forward_ = make_button(tr("Step ▶"), "replay_forward");
    speed_ = new QComboBox;
    speed_->setObjectName(QStringLiteral("replay_speed"));
    speed_->setAccessibleName(tr("Speed"));
    for (const double speed : speeds) speed_->addItem(QStringLiteral("×%1").arg(speed), speed);
    speed_->setCurrentIndex(3);
    clock_ = make_label({});
    clock_->setWordWrap(false);
    state_ = make_label({}, "muted");
    for (QWidget* control : std::initializer_list<QWidget*>{play_, back_, forward_, speed_})
        row->add(control);
    layout->addLayout(row);
    // Two rows: next to the traces one would leave these no width.
    auto* below = new FlowRow;
    below->add(clock_);
    below->add(state_, 1);
    practise_ = make_button(tr("Practise from here"), "replay_take_over");
    practise_->setToolTip(
        tr("A practice run that begins with the scene as it is at this moment. It is never scored."));
    practise_->hide();
    below->add(practise_);
    layout->addLayout(below);
    connect(play_, &QPushButton::clicked, this, [this] { play(!playing_); });
    connect(back_, &QPushButton::clicked, this, [this] { step(-1); });
    connect(forward_, &QPushButton::clicked, this, [this] { step(1); });
    connect(practise_, &QPushButton::clicked, this, &ReplayPanel::practise);
    connect(speed_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            [this] { factor_ = speed_->currentData().toDouble(); });
    connect(slider_, &QSlider::valueChanged, this, [this](int value) { seek(value * 1e-2); });
    timer_.setInterval(16);
    connect(&timer_, &QTimer::timeout, this, &ReplayPanel::tick);
}

ReplayPanel::~ReplayPanel() = default;

void ReplayPanel::open(std::shared_ptr<const AttemptModel> model, const TaskDefinition* task) {
    close();
    model_ = std::move(model);
    task_ = task;
    const QSignalBlocker quiet(slider_);
    const int first = static_cast<int>(std::floor(model_->begin * 100));
    const int last = std::max(first + 1, static_cast<int>(std::ceil(model_->duration * 100)));
    slider_->setRange(first, last);
    slider_->setPageStep(std::max(1, (last - first) / 20));
    time_ = model_->begin;
    state_->setText(tr("reading the recording …"));
    view_->show();
    timer_.start();
    since_.start();
    show_time();
}

void ReplayPanel::set_record(std::shared_ptr<const AttemptModel> model, std::unique_ptr<ReplaySource> source,
                             const QString& why_no_picture) {
    model_ = std::move(model);
    ticks_ = model_->trace == nullptr ? nullptr : database::ticks_of(model_->trace)->reader();
    source_ = std::move(source);
    state_->setText(why_no_picture);
    view_->setVisible(source_ != nullptr);
    if (source_) source_->seek(time_);
}

void ReplayPanel::close() {
    play(false);
    timer_.stop();
    view_->unload();
    source_.reset();
    ticks_.reset();
    model_.reset();
    notice_.clear();
    time_ = 0;
    loaded_ = false;
}

void ReplayPanel::seek(double time) {
    if (!model_) return;
    time_ = std::clamp(time, model_->begin, model_->duration);
    notice_.clear();
    if (source_) source_->seek(time_);
    show_time();
    emit time_changed(time_);
}

void ReplayPanel::play(bool on) {
    if (on && model_ && time_ >= model_->duration - 1e-9) seek(model_->begin);
    playing_ = on && model_ != nullptr;
    play_->setText(playing_ ? tr("Pause") : tr("Play"));
    if (!playing_) slider_->setAccessibleDescription(clock_->text());
    since_.restart();
}

void ReplayPanel::set_speed(double factor) {
    for (int i = 0; i < speed_->count(); ++i) {
        if (std::abs(speed_->itemData(i).toDouble() - factor) < 1e-9) speed_->setCurrentIndex(i);
    }
}

void ReplayPanel::show_picture_alone() {
    for (QWidget* control : std::initializer_list<QWidget*>{slider_, play_, back_, forward_, speed_, clock_})
        control->hide();
    view_->setMinimumHeight(lowest_picture);
    alone_ = true;
}

void ReplayPanel::offer_practice(bool offered) {
    practise_->setVisible(offered);
}

void ReplayPanel::practise() {
    play(false);
    const std::shared_ptr<const ReplayMoment> from = source_ ? source_->moment(time_) : nullptr;
    if (from != nullptr) {
        emit practice_wanted(from);
    } else {
        notice_ =
            tr("Practice cannot begin at this moment yet: wait until it is prepared, or choose a "
               "later one.");
        waits_ = source_ && source_->ready() < 1;
        state_->setText(notice_);
    }
}

void ReplayPanel::step(int steps) {
    play(false);
    seek(time_ + steps * step_s);
}

void ReplayPanel::show_time() {
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(std::lround(time_ * 100)));
    clock_->setText(
        QStringLiteral("%1 / %2").arg(clock_text(time_), clock_text(model_ ? model_->duration : 0)));
    // The slider counts hundredths of a second. While it plays, nobody follows it by ear.
    if (!playing_ && !slider_->isHidden()) slider_->setAccessibleDescription(clock_->text());
}

void ReplayPanel::tick() {
    const double dt = static_cast<double>(since_.restart()) * 1e-3;
    if (playing_ && model_) {
        const double to = time_ + dt * factor_;
        if (to >= model_->duration - 1e-9) play(false);  // before seek() reports its last moment
        seek(to);
    }
    if (!source_) return;
    const bool is_new = source_->update();
    if (loaded_ || is_new) show_state();  // also while the picture stays: the preparation goes further
    if (!is_new) return;
    if (!loaded_) {
        loaded_ = true;
        view_->load(source_->scene(), source_->snapshot());
    }
    fill_hud();
    view_->show_world(source_->snapshot());
}

/// What the picture is not yet, or never will be.
void ReplayPanel::show_state() {
    constexpr double noticeable_s = 0.5;
    if (waits_ && source_->ready() >= 1) notice_.clear();
    QString text = notice_;
    if (!text.isEmpty()) {
        // What was asked for last matters most.
    } else if (source_->differs_from_s()) {
        text = tr("tissue differs from the record from %1 s on (another build); poses and forces are the "
                  "recorded ones")
                   .arg(decimal(*source_->differs_from_s(), 1));
    } else if (source_->ready() < 1) {
        const int percent = static_cast<int>(source_->ready() * 100);
        text = time_ - source_->shown_s() > noticeable_s
                   ? tr("preparing %1\u00a0%: the tissue is that of %2 so far; earlier moments are shown at "
                        "once")
                         .arg(percent)
                         .arg(clock_text(source_->shown_s()))
                   : tr("preparing %1\u00a0%").arg(percent);
    }
    if (text != state_->text()) state_->setText(text);
}

void ReplayPanel::fill_hud() {
    HudState hud;
    hud.task = task_;
    set_scope(hud, source_->scene());
    hud.place = playing_ ? tr("replay ×%1").arg(factor_) : tr("replay");
    for (int h = 0; h < hand_count; ++h) {
        const InstrumentSpec* spec = source_->scene().instrument(static_cast<Hand>(h));
        hud.has_jaws[h] = spec != nullptr && type_of(spec->kind).jaws;
        const std::vector<FieldView>& field = source_->snapshot().field;
        if (spec != nullptr && !spec->exchange.empty() && !field.empty()) {
            hud.has_jaws[h] = type_of(field[0].tools[h].kind).jaws;
            hud.tool[h] = tool_words(field[0].tools[h]);
            hud.tool_active[h] = field[0].tools[h].active;
        }
    }
    const auto tick = static_cast<std::uint32_t>(time_ / model_->tick);
    const std::size_t index = ticks_->at_or_after(tick);
    if (index < model_->trace->tick_count()) {
        const TickSample& sample = ticks_->sample(index);
        for (std::size_t h = 0; h < hand_count; ++h) {
            const HandSample& hand = sample.hand[h];
            // As recorded: the chart has no values during a pause.
            hud.display.force[h] = static_cast<float>(
                std::hypot(hand.force[0], hand.force[1], hand.force[2]) * sample_force_unit);
            hud.jaws_closed[h] = (hand.flags & hand_grasping) != 0 || hand.jaw_angle < 50000;
            hud.display.warning[h] = (hand.flags & hand_warned) != 0;
            const auto tissue = static_cast<std::size_t>(std::max<std::int16_t>(hand.tissue, 0));
            if (hand.tissue >= 0 && tissue < model_->tissues.size()) {
                for (const auto& [label, limit] : model_->force_limits) {
                    if (label == model_->tissues[tissue]) {
                        hud.display.force_limit[h] = static_cast<float>(limit);
                    }
                }
            }
        }
    }
    hud.display.lift_height_m = std::numeric_limits<double>::quiet_NaN();  // no event says it
    hud.display.traction_n_m = std::numeric_limits<double>::quiet_NaN();   // said only while tissue is cut
    ShownTargets targets;
    for (const Event& event : model_->trace->events) {
        if (event.tick > tick) break;
        show_event(hud, targets, event);
    }
    hud.display.elapsed_s = time_;
    hud.display.remaining_s = std::max(0.0, model_->duration - time_);
    if (!alone_) view_->set_hud(hud);
    view_->set_targets(targets.done, targets.active, false);
}

}  // namespace fulcrum::ui

#include "moc_replay_panel.cpp"
