// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/devices_card.h"

#include <QComboBox>
#include <QCoreApplication>
#include <cmath>

#include "ui/language/language.h"
#include "ui/language/words.h"
#include "ui/page/background_job.h"
#include "ui/shell/device_test.h"
#include "ui/style/announce.h"
#include "ui/style/kept_focus.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

QString device_words(const std::string& english) {
    const QString words = QCoreApplication::translate("fulcrum::device_list", english.c_str());
    return with_quotation_marks(
        words != text(english) ? words : QCoreApplication::translate("errors", english.c_str()));
}

namespace {

constexpr int look_every_ms = 3000, read_every_ms = 200;

/// The state as sign and words; never by colour alone.
QString state_words(const ListedDevice& device) {
    const char* const signs[] = {"✓", "!", "–"};
    return QStringLiteral("%1 %2: %3")
        .arg(
            QString::fromUtf8(signs[static_cast<std::size_t>(device.state)]), device_words(device.title),
            QCoreApplication::translate("fulcrum::device_states", row_of(device_states, device.state).title));
}

QStringList particulars(const ListedDevice& device) {
    QStringList lines;
    for (const std::string& found : device.found) lines << device_words(found);
    const QString why = device.detail.empty()
                            ? device_words(device.why)
                            : device_words(device.why) + QStringLiteral(" (%1)").arg(text(device.detail));
    if (!device.why.empty()) lines << DevicesCard::tr("Why: %1").arg(why);
    if (!device.what_to_do.empty())
        lines << DevicesCard::tr("What to do: %1").arg(device_words(device.what_to_do));
    // Where a person is not permitted, the line is in what to do already.
    if (device.state == DeviceState::absent && !device.rules.empty())
        lines << DevicesCard::tr(
            "Where it is connected and not found: install 70-fulcrum.rules "
            "(fulcrum devices shows its lines), then connect it again.");
    return lines;
}

QString slot_words(const DeviceReadings::Slot& slot) {
    const std::pair<const char*, QString> names[] = {{"left", DevicesCard::tr("Left hand")},
                                                     {"right", DevicesCard::tr("Right hand")},
                                                     {"scope", DevicesCard::tr("Scope")}};
    QString name;
    for (const auto& [id, shown] : names)
        if (std::string(slot.name) == id) name = shown;
    if (!slot.present) return DevicesCard::tr("%1: does not answer").arg(name);
    return DevicesCard::tr("%1: at (%2, %3, %4) mm, jaws %5 % open, buttons %6")
        .arg(name, decimal(1e3 * slot.position.x(), 1), decimal(1e3 * slot.position.y(), 1),
             decimal(1e3 * slot.position.z(), 1), decimal(100 * slot.jaw, 0))
        .arg(slot.buttons);
}

QStringList controller_words(const ControllerReadings& pad) {
    if (!pad.connected) return {DevicesCard::tr("%1: not connected").arg(text(pad.name))};
    QStringList lines{text(pad.name)};
    const QString names[] = {DevicesCard::tr("Left stick"), DevicesCard::tr("Right stick")};
    for (int h = 0; h < 2; ++h)
        lines << (pad.begun[h]
                      ? DevicesCard::tr("%1: %2 % to the right, %3 % up, trigger %4 %")
                            .arg(names[h], decimal(100 * pad.stick[h][0], 0),
                                 decimal(100 * pad.stick[h][1], 0), decimal(100 * pad.trigger[h], 0))
                      : DevicesCard::tr("%1: not in its middle since it was connected").arg(names[h]));
    if (!pad.rumbles) lines << DevicesCard::tr("It does not rumble.");
    return lines;
}

}  // namespace

DevicesCard::DevicesCard(Context& context)
    : context_(context), scale_(new QComboBox), list_(new QVBoxLayout) {
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 16);
    layout->setSpacing(8);
    layout->addWidget(make_label(tr("Devices for the hands"), "heading"));
    use_ = make_label({});
    use_->setObjectName(QStringLiteral("device_in_use"));
    trouble_ = make_label({}, "bad");
    readings_ = make_label({}, "muted");
    readings_->setObjectName(QStringLiteral("device_readings"));
    for (QLabel* label : {use_, trouble_, readings_}) layout->addWidget(label);
    force_ = build_force();
    layout->addWidget(force_);
    test_ = new DeviceTest(context);
    layout->addWidget(test_);
    list_->setSpacing(6);
    layout->addLayout(list_);
    again_ = make_button(tr("Search for devices again"), "look_for_devices");
    layout->addWidget(again_, 0, Qt::AlignLeft);
    connect(again_, &QPushButton::clicked, this, &DevicesCard::look);
    look_timer_.setInterval(look_every_ms);
    connect(&look_timer_, &QTimer::timeout, this, &DevicesCard::look);
    readings_timer_.setInterval(read_every_ms);
    connect(&readings_timer_, &QTimer::timeout, this, &DevicesCard::show_readings);
}

QWidget* DevicesCard::build_force() {
    auto* holder = new QWidget;
    auto* column = new QVBoxLayout(holder);
    column->setContentsMargins(0, 0, 0, 0);
    auto* row = new QHBoxLayout;
    scale_->setObjectName(QStringLiteral("force_scale"));
    scale_->setAccessibleName(tr("Force given to the hand"));
    scale_->setMinimumContentsLength(7);
    const int least = static_cast<int>(std::lround(100 * least_force_scale));
    for (int percent = least; percent <= 100; percent += 10)
        scale_->addItem(tr("%1 %").arg(percent), percent);
    auto* title = new QLabel(tr("Force given to the hand"));
    title->setBuddy(scale_);
    row->addWidget(title);
    row->addWidget(scale_);
    row->addStretch();
    column->addLayout(row);
    column->addWidget(
        make_label(tr("Share of the model's force, from the next attempt on. Each attempt stores it "
                      "and the debrief names it."),
                   "muted"));
    connect(scale_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
        DeviceService& devices = context_.services();
        devices.set_force_scale(devices.device_in_use().kind, 0.01 * scale_->itemData(index).toInt());
    });
    return holder;
}

void DevicesCard::showEvent(QShowEvent* event) {
    QFrame::showEvent(event);
    show_use();
    show_readings();
    look();
    look_timer_.start();
    readings_timer_.start();
}

void DevicesCard::hideEvent(QHideEvent* event) {
    QFrame::hideEvent(event);
    look_timer_.stop();
    readings_timer_.stop();
    test_->stop();
}

void DevicesCard::show_use() {
    const DeviceInUse used = context_.services().device_in_use();
    const QString title = device_words(used.title);
    use_->setText(context_.services().device_can_be_chosen()
                      ? tr("In use: %1. It moves the hands from the next attempt on.").arg(title)
                      : tr("In use: %1. This device was set when Fulcrum was started (environment variable "
                           "FULCRUM_DEVICE). Start Fulcrum without it to choose a device here.")
                            .arg(title));
    test_->show_settings();
    force_->setVisible(!used.kind.empty() && used.device_class == DeviceClass::haptic);
    const double scale = context_.services().force_scale(used.kind);
    scale_->setCurrentIndex(scale_->findData(10 * static_cast<int>(std::lround(10 * scale))));
}

void DevicesCard::show_readings() {
    DeviceService& devices = context_.services();
    const QString trouble = sentence_text(devices.device_trouble());
    trouble_->setVisible(!trouble.isEmpty());
    announce_change(trouble_, trouble);
    QStringList lines;
    const auto now = devices.device_readings();
    if (now) {
        if (now->rate > 0)
            lines << (now->worst_delay >= 0
                          ? tr("%1 readings per second, at most %2 ms late")
                                .arg(decimal(now->rate, 0), decimal(1e3 * now->worst_delay, 1))
                          : tr("%1 readings per second").arg(decimal(now->rate, 0)));
        if (now->rate > 0 && now->jitter >= 0)
            lines << tr("Jitter of the readings: %1 ms").arg(decimal(1e3 * now->jitter, 2));
        if (!now->firmware.empty()) lines << tr("Versions: %1").arg(text(now->firmware));
        for (const DeviceReadings::Slot& slot : now->held) lines << slot_words(slot);
        if (!now->held.empty())
            lines << (now->needs_calibration ? tr("Calibration: needed") : tr("Calibration: valid"));
        if (now->controller) lines << controller_words(*now->controller);
    } else if (!devices.device_in_use().kind.empty()) {
        lines << tr(
            "Its readings are shown here while it is open: an attempt opens it, or the button below.");
    }
    test_->show_readings(now ? &*now : nullptr, !trouble.isEmpty());
    readings_->setText(lines.join(QLatin1Char('\n')));
    readings_->setVisible(!lines.isEmpty());
}

void DevicesCard::look() {
    if (job_ != nullptr) return;
    auto found = std::make_shared<std::vector<ListedDevice>>();
    job_ = BackgroundJob::run(
        this, [found, list = context_.services().list_devices()](const Progress&) { *found = list(); },
        [this, found] {
            job_ = nullptr;
            show_list(*found);
        },
        [this](const QString& why) {
            job_ = nullptr;
            context_.complain(why);
        });
}

void DevicesCard::show_list(const std::vector<ListedDevice>& devices) {
    QString now;
    for (const ListedDevice& device : devices)
        now += state_words(device) + QLatin1Char('\n') + particulars(device).join(QLatin1Char('\n'));
    if (now == shown_) return;
    shown_ = now;
    const KeptFocus focus(this, again_);
    clear_layout(list_);
    for (const ListedDevice& device : devices) {
        QLabel* state = make_label(state_words(device));
        state->setObjectName(QStringLiteral("device_") + text(device.kind));
        if (device.state == DeviceState::usable) set_tint(state, Tint::good);
        if (device.state == DeviceState::connected) set_tint(state, Tint::bad);
        list_->addWidget(state);
        const bool choosable = (device.state == DeviceState::usable || device.needs_calibration) &&
                               device.can_be_chosen && context_.services().device_can_be_chosen();
        if (choosable) {
            QPushButton* use = make_button(tr("Use for the hands"), "");
            use->setObjectName(QStringLiteral("use_") + text(device.kind));
            use->setAccessibleName(tr("Use %1 for the hands").arg(device_words(device.title)));
            connect(use, &QPushButton::clicked, this, [this, kind = device.kind] {
                context_.services().choose_device(kind);
                show_use();
                show_readings();
            });
            list_->addWidget(use, 0, Qt::AlignLeft);
        }
        const QStringList lines = particulars(device);
        if (lines.isEmpty()) continue;
        QLabel* more = make_label(lines.join(QLatin1Char('\n')), "muted");
        more->setIndent(24);
        list_->addWidget(more);
    }
}

}  // namespace fulcrum::ui

#include "moc_devices_card.cpp"
