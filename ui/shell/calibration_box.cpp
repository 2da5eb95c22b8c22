// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/calibration_box.h"

#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {
constexpr int look_at_calibration_ms = 30;
}  // namespace

CalibrationBox::CalibrationBox(Context& context) : context_(context), hand_(new QComboBox) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(make_label(tr("Calibration"), "neutral"));
    when_ = make_label({}, "muted");
    when_->setObjectName(QStringLiteral("calibration_when"));
    column->addWidget(when_);
    auto* start = new QWidget;
    auto* row = new FlowRow(start);
    hand_->setObjectName(QStringLiteral("calibration_hand"));
    hand_->setAccessibleName(tr("Hand whose instrument is calibrated"));
    hand_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    hand_->setMinimumContentsLength(12);
    hand_->addItem(tr("Right hand"), 1);
    hand_->addItem(tr("Left hand"), 0);
    row->add(hand_);
    begin_ = make_button(tr("Calibrate"), "calibrate");
    row->add(begin_);
    column->addWidget(start);
    steps_ = new QWidget;
    auto* inner = new QVBoxLayout(steps_);
    inner->setContentsMargins(0, 0, 0, 0);
    step_ = make_label({});
    step_->setObjectName(QStringLiteral("calibration_step"));
    seen_ = make_label({}, "muted");
    seen_->setObjectName(QStringLiteral("calibration_seen"));
    inner->addWidget(step_);
    inner->addWidget(seen_);
    auto* buttons = new QWidget;
    auto* flow = new FlowRow(buttons);
    next_ = make_button(tr("Continue"), "calibration_next", "primary");
    skip_ = make_button(tr("Leave this out"), "calibration_skip");
    cancel_ = make_button(tr("Cancel"), "calibration_cancel");
    for (QPushButton* one : {next_, skip_, cancel_}) flow->add(one);
    inner->addWidget(buttons);
    column->addWidget(steps_);
    result_ = make_label({});
    result_->setObjectName(QStringLiteral("calibration_result"));
    column->addWidget(result_);
    timer_.setInterval(look_at_calibration_ms);
    connect(&timer_, &QTimer::timeout, this, &CalibrationBox::show_state);
    connect(begin_, &QPushButton::clicked, this, &CalibrationBox::begin);
    connect(next_, &QPushButton::clicked, this, [this] {
        context_.services().calibration_next();
        show_state();
    });
    connect(skip_, &QPushButton::clicked, this, [this] {
        context_.services().calibration_skip();
        show_state();
    });
    connect(cancel_, &QPushButton::clicked, this, [this] {
        stop();
        begin_->setFocus();
    });
    stop();
}

void CalibrationBox::show_device() {
    DeviceService& devices = context_.services();
    const std::string kind = devices.device_in_use().kind;
    setVisible(devices.can_calibrate(kind));
    hand_->setVisible(kind == "joystick" || kind == "trainer");
    const std::string at = devices.calibrated_at(kind);
    when_->setText(at.empty() ? tr("Not calibrated with this program yet.")
                              : tr("Calibrated last: %1.").arg(text(at)));
}

void CalibrationBox::begin() {
    const int hand = hand_->isVisible() ? hand_->currentData().toInt() : 1;
    result_->hide();
    if (!context_.guarded([&] { context_.services().start_calibration(hand); })) return;
    ran_ = true;
    timer_.start();
    show_state();
    next_->setFocus();
}

void CalibrationBox::stop() {
    context_.services().stop_calibration();
    timer_.stop();
    ran_ = false;
    steps_->hide();
    result_->hide();
    begin_->setEnabled(true);
}

void CalibrationBox::show_state() {
    if (!ran_) return;
    const CalibrationState now = context_.services().calibration();
    begin_->setEnabled(!now.runs);
    steps_->setVisible(now.runs);
    if (now.runs) {
        announce_change(
            step_, tr("Step %1 of %2: %3").arg(now.step).arg(now.steps).arg(sentence_text(now.what_to_do)));
        seen_->setText(sentence_text(now.seen));
        next_->setEnabled(now.ready);
        skip_->setVisible(now.can_skip);
        return;
    }
    timer_.stop();
    ran_ = false;
    set_tint(result_, now.good ? Tint::good : Tint::bad);
    result_->setVisible(!now.result.empty());
    announce_problem(result_, sentence_text(now.result));
    context_.services().stop_calibration();
    show_device();
    begin_->setFocus();
}

}  // namespace fulcrum::ui

#include "moc_calibration_box.cpp"
