// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/device_test.h"

#include <QCheckBox>
#include <QComboBox>
#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "ui/shell/calibration_box.h"
#include "ui/shell/frame_check.h"
#include "ui/shell/workspace_fit.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

QComboBox* make_list(const char* name, const QString& title) {
    auto* list = new QComboBox;
    list->setObjectName(QLatin1String(name));
    list->setAccessibleName(title);
    list->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    list->setMinimumContentsLength(20);
    return list;
}

QWidget* titled(const QString& title, QComboBox* list) {
    auto* both = new QWidget;
    auto* row = new QHBoxLayout(both);
    row->setContentsMargins(0, 0, 0, 0);
    auto* label = new QLabel(title);
    label->setBuddy(list);
    row->addWidget(label);
    row->addWidget(list);
    return both;
}

}  // namespace

DeviceTest::DeviceTest(Context& context) : context_(context) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(8);
    open_ = make_button(tr("Connect and try it"), "open_device");
    column->addWidget(open_, 0, Qt::AlignLeft);
    connect(open_, &QPushButton::clicked, this, [this] {
        context_.guarded([this] { context_.services().open_device(); });
        show_settings();
    });
    tried_ = build_try();
    column->addWidget(tried_);
    reach_ = new WorkspaceFit(context, [this] { show_settings(); });
    reach_->hide();
    column->addWidget(build_settings());
    column->addWidget(reach_);
    calibration_ = new CalibrationBox(context);
    column->addWidget(calibration_);
}

QWidget* DeviceTest::build_try() {
    auto* holder = new QWidget;
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(make_label(tr("Move each hand to the right, up and away from you, one after the other. "
                                    "The dot goes the same way "
                                    "and gets smaller further away; each direction gets a mark."),
                                 "muted"));
    away_note_ = make_label(tr("Away from you: hold the shoulder button and push the stick up."), "muted");
    column->addWidget(away_note_);
    frame_ = new FrameCheck;
    frame_->setObjectName(QStringLiteral("frame_check"));
    column->addWidget(frame_, 0, Qt::AlignLeft);
    marks_ = make_label({});
    marks_->setObjectName(QStringLiteral("frame_marks"));
    column->addWidget(marks_);
    auto* buttons = new QWidget;
    auto* row = new FlowRow(buttons);
    again_ = make_button(tr("Begin again"), "frame_again");
    force_ = make_button(tr("Force test"), "force_test");
    stop_ = make_button(tr("Stop (Esc)"), "stop_force_test", "primary");
    shake_ = make_button(tr("Rumble"), "try_rumble");
    for (QPushButton* one : {again_, force_, stop_, shake_}) row->add(one);
    column->addWidget(buttons);
    force_line_ = make_label({});
    force_line_->setObjectName(QStringLiteral("force_test_line"));
    column->addWidget(force_line_);
    connect(again_, &QPushButton::clicked, frame_, &FrameCheck::begin_again);
    connect(force_, &QPushButton::clicked, this, [this] {
        forced_ = context_.services().start_force_test();
        show_force();
        stop_->setFocus();
    });
    connect(stop_, &QPushButton::clicked, this, [this] {
        context_.services().stop_force_test();
        show_force();
        force_->setFocus();
    });
    connect(shake_, &QPushButton::clicked, this, [this] {
        context_.guarded([this] {
            if (const auto pad = context_.services().game_controller()) pad->rumble(0.6, 0.3);
        });
    });
    return holder;
}

QWidget* DeviceTest::build_settings() {
    auto* holder = new QWidget;
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    const QString motion = tr("Movement of the instrument");
    motion_ = make_list("motion_scale", motion);
    motion_->setMinimumContentsLength(7);
    for (const int percent : motion_percents) motion_->addItem(tr("%1 %").arg(percent), percent);
    auto* row_holder = new QWidget;
    auto* row = new FlowRow(row_holder);
    row->add(titled(motion, motion_));
    rumble_ = new QCheckBox(tr("Rumble on contact and on too much force"));
    rumble_->setObjectName(QStringLiteral("rumble"));
    rumble_->setAccessibleName(rumble_->text());
    row->add(rumble_);
    column->addWidget(row_holder);
    motion_note_ = make_label({}, "muted");
    column->addWidget(motion_note_);
    connect(motion_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
        DeviceService& devices = context_.services();
        devices.set_motion_scale(devices.device_in_use().kind, 0.01 * motion_->itemData(index).toInt());
    });
    connect(rumble_, &QCheckBox::toggled, this,
            [this](bool wanted) { context_.services().set_rumble_wanted(wanted); });
    slots_row_ = new QWidget;
    auto* slots_flow = new FlowRow(slots_row_);
    const QString titles[] = {tr("Left instrument"), tr("Right instrument"), tr("Scope")};
    const char* const names[] = {"slot_left", "slot_right", "slot_scope"};
    const QString parts[] = {tr("left device"), tr("right device"), tr("third device")};
    for (int i = 0; i < 3; ++i) {
        slot_[i] = make_list(names[i], titles[i]);
        for (int part = 0; part < 3; ++part) slot_[i]->addItem(parts[part], part);
        slot_[i]->addItem(tr("mouse and keyboard"), -1);
        slots_flow->add(titled(titles[i], slot_[i]));
        connect(slot_[i], QOverload<int>::of(&QComboBox::activated), this, [this, i] { change_slots(i); });
    }
    column->addWidget(slots_row_);
    pedal_row_ = build_pedal();
    column->addWidget(pedal_row_);
    return holder;
}

QWidget* DeviceTest::build_pedal() {
    auto* holder = new QWidget;
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    const QString title = tr("Pedal (energy, suction)");
    pedal_ = make_list("slot_pedal", title);
    pedal_->addItem(tr("button of each hand"), pedal_of_each_hand);
    const QString parts[] = {tr("button of the left device"), tr("button of the right device"),
                             tr("button of the third device")};
    for (int part = 0; part < 3; ++part) pedal_->addItem(parts[part], part);
    pedal_->addItem(tr("key or foot switch only"), pedal_keys_only);
    auto* flow_holder = new QWidget;
    auto* flow = new FlowRow(flow_holder);
    flow->add(titled(title, pedal_));
    column->addWidget(flow_holder);
    column->addWidget(make_label(
        tr("The button of one device is the pedal for both hands. The key of the pedal works with every "
           "choice; give it to a foot switch that types a key under Mouse and keys for the hands."),
        "muted"));
    clutch_note_ = make_label({}, "muted");
    clutch_note_->setObjectName(QStringLiteral("clutch_note"));
    column->addWidget(clutch_note_);
    connect(pedal_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
        DeviceService& devices = context_.services();
        const std::string kind = devices.device_in_use().kind;
        SlotChoice now = devices.slot_choice(kind);
        now.pedal = pedal_->itemData(index).toInt();
        devices.set_slot_choice(kind, now);
    });
    return holder;
}

/// Two instruments cannot be moved by one part: the other one gets what this one had.
void DeviceTest::change_slots(int changed) {
    DeviceService& devices = context_.services();
    const std::string kind = devices.device_in_use().kind;
    const SlotChoice before = devices.slot_choice(kind);
    const int had[] = {before.left, before.right, before.scope};
    int now[] = {before.left, before.right, before.scope};
    now[changed] = slot_[changed]->currentData().toInt();
    for (int i = 0; i < 3; ++i)
        if (i != changed && now[i] == now[changed] && now[i] >= 0) now[i] = had[changed];
    devices.set_slot_choice(kind, {now[0], now[1], now[2], before.pedal});
    show_settings();
}

void DeviceTest::show_settings() {
    DeviceService& devices = context_.services();
    const DeviceInUse used = devices.device_in_use();
    const bool controller = used.device_class == DeviceClass::controller;
    const bool mice = used.kind.empty();
    const double scale = devices.motion_scale(used.kind);
    motion_->setCurrentIndex(motion_->findData(static_cast<int>(std::lround(100 * scale))));
    motion_note_->setText(
        mice ? tr("How far the instrument moves for the same movement of the mouse, from the next attempt. "
                  "At 100 %, about 3 pixels move the handle by 1 mm.")
        : controller
            ? tr("Speed for the same push of a stick, from the next attempt on; 100 %: at most 12 cm/s of "
                 "the "
                 "handle.")
            : tr("For the same movement of the device, from the next attempt on; 100 %: as far as the hand. "
                 "Where the instrument begins, the device is at that moment, wherever you hold it."));
    calibration_->show_device();
    rumble_->setVisible(controller);
    rumble_->setChecked(devices.rumble_wanted());
    const SlotChoice slots_now = devices.slot_choice(used.kind);
    const int now[] = {slots_now.left, slots_now.right, slots_now.scope};
    for (int i = 0; i < 3; ++i) slot_[i]->setCurrentIndex(slot_[i]->findData(now[i]));
    pedal_->setCurrentIndex(pedal_->findData(slots_now.pedal));
}

void DeviceTest::show_readings(const DeviceReadings* readings, bool trouble) {
    DeviceService& devices = context_.services();
    const DeviceInUse used = devices.device_in_use();
    const bool open = readings != nullptr;
    open_->setVisible(!open && !used.kind.empty());
    tried_->setVisible(open);
    slots_row_->setVisible(open && readings->held.size() >= 2);
    pedal_row_->setVisible(open && !readings->held.empty());
    if (open && !was_open_) {
        frame_->begin_again();
        show_settings();
    }
    was_open_ = open;
    if (!open) {
        reach_->hide();
        forced_ = false;
        return;
    }
    frame_->show_readings(*readings);
    reach_->show_readings(*readings);
    show_clutch(*readings);
    marks_->setText(frame_->lines().join(QLatin1Char('\n')));
    shake_->setVisible(readings->controller.has_value());
    away_note_->setVisible(readings->controller.has_value());
    const bool runs = devices.force_test().runs;
    if (runs && trouble) devices.stop_force_test();
    gives_force_ = readings->gives_force;
    force_->setEnabled(!trouble);
    show_force();
}

/// The button for energy is free where it is not the pedal.
void DeviceTest::show_clutch(const DeviceReadings& readings) {
    bool own = false;
    for (const DeviceReadings::Slot& slot : readings.held) own = own || slot.clutch;
    DeviceService& devices = context_.services();
    const bool free = devices.slot_choice(devices.device_in_use().kind).pedal != pedal_of_each_hand;
    const QString what = tr(
        "While it is held the instrument stays, without force, and you move the handle to a better place.");
    clutch_note_->setText(own    ? tr("Clutch: a button of the device.") + QLatin1Char(' ') + what
                          : free ? tr("Clutch: the button for energy, where it is not the pedal.") +
                                       QLatin1Char(' ') + what
                                 : QString());
    clutch_note_->setVisible(!readings.held.empty() && (own || free));
}

void DeviceTest::show_force() {
    const ForceTestState now = context_.services().force_test();
    const QString directions[] = {tr("to the right"), tr("up"), tr("towards you")};
    QString line;
    if (now.runs) {
        line = tr("%1, %2: %3 N. You feel a gentle push. Press Stop or Esc at any time.")
                   .arg(std::string(now.hand) == "left" ? tr("Left hand") : tr("Right hand"),
                        directions[now.axis], decimal(now.asked, 2));
    } else if (forced_) {
        line = now.largest_asked > 0
                   ? tr("The test is over: up to %1 N were asked for, up to %2 N rendered. The force is 0.")
                         .arg(decimal(now.largest_asked, 2), decimal(now.rendered, 2))
                   : tr("The test was stopped. The force is 0.");
    }
    force_->setVisible(gives_force_ && !now.runs);
    stop_->setVisible(now.runs);
    force_line_->setText(line);
    force_line_->setVisible(!line.isEmpty());
}

void DeviceTest::stop() {
    calibration_->stop();
    context_.services().stop_force_test();
    forced_ = false;
}

void DeviceTest::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape && context_.services().force_test().runs) {
        stop_->click();
        return;
    }
    QWidget::keyPressEvent(event);
}

}  // namespace fulcrum::ui

#include "moc_device_test.cpp"
