// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/devices.h"

#include <QSettings>
#include <algorithm>
#include <iterator>

#include "app/live/device_rig.h"
#include "sim_core/devices/device_table.h"

namespace fulcrum::app {

DeviceClass class_of(const DeviceFacts& facts) {
    const DeviceRow* const row = device_row(facts.kind);
    const DeviceClass usual = row != nullptr ? row->device_class : DeviceClass::haptic;
    const bool forceless = !facts.force[0] && !facts.force[1];
    return usual == DeviceClass::haptic && forceless ? DeviceClass::tracked : usual;
}

Devices::Devices(std::string specification) : specification_(std::move(specification)) {}

namespace {
constexpr const char *two_mice = "two-mice", *virtual_mice = "two-mice:virtual";
constexpr const char *rumble_key = "rumble", *chosen_key = "device";

/// "virtual" of "virtual:path.json".
std::string kind_of(const std::string& specification) {
    return specification.substr(0, specification.find(':'));
}

bool is_controller(const std::string& specification) {
    const DeviceRow* const row = device_row(specification);
    return row != nullptr && row->read_by == ReadBy::program;
}

QString motion_key(const std::string& kind) {
    return QStringLiteral("motion_scale/") +
           (kind.empty() ? QStringLiteral("mouse") : QString::fromStdString(kind));
}
QString slot_key(const std::string& kind) {
    return QStringLiteral("hands/") + QString::fromStdString(kind);
}

QString scale_key(const std::string& kind) {
    return QStringLiteral("force_scale/") + QString::fromStdString(kind);
}
}  // namespace

void Devices::open() {
    if (specification_.empty() || specification_ == two_mice || specification_ == virtual_mice ||
        is_controller(specification_))
        return;
    // One whose overseer is stopped does not come back by itself.
    const auto health = client_ != nullptr ? client_->poll() : DaemonClient::Health::ended;
    const bool runs = health == DaemonClient::Health::good || health == DaemonClient::Health::restarting;
    if (runs && client_->wait_for_sign()) return;
    test_.reset();
    client_.reset();  // the one that ended, before another takes the device
    calibration_.reset();
    client_ = std::make_shared<DaemonClient>(hapticd_program(), with_calibration(specification_));
    counted_at_ = -1;
}

double Devices::force_scale(const std::string& kind) {
    bool is_number = false;
    const double scale = QSettings().value(scale_key(kind), 1.0).toDouble(&is_number);
    return is_number && scale >= ui::least_force_scale && scale <= 1 ? scale : 1;
}

void Devices::set_force_scale(const std::string& kind, double scale) {
    QSettings().setValue(scale_key(kind), std::clamp(scale, ui::least_force_scale, 1.0));
}

double Devices::motion_scale(const std::string& kind) {
    bool is_number = false;
    const double scale = QSettings().value(motion_key(kind), 1.0).toDouble(&is_number);
    return is_number && scale >= ui::least_motion_scale && scale <= ui::largest_motion_scale ? scale : 1;
}

void Devices::set_motion_scale(const std::string& kind, double scale) {
    QSettings().setValue(motion_key(kind),
                         std::clamp(scale, ui::least_motion_scale, ui::largest_motion_scale));
}

static QString ring_key(const std::string& kind) {
    return QStringLiteral("begin_at_ring/") + QString::fromStdString(kind);
}

bool Devices::begins_at_ring(const std::string& kind) {
    return QSettings().value(ring_key(kind), false).toBool();
}

void Devices::set_begins_at_ring(const std::string& kind, bool wanted) {
    QSettings().setValue(ring_key(kind), wanted);
}

ui::SlotChoice Devices::slot_choice(const std::string& kind) {
    const QStringList kept = QSettings().value(slot_key(kind)).toString().split(QLatin1Char(' '));
    int parts[device_slots] = {0, 1, scope_slot}, pedal = ui::pedal_of_each_hand;
    const int count = kept.size();
    if (count != device_slots && count != device_slots + 1) return {};
    for (int i = 0; i < count; ++i) {
        bool is_number = false;
        const int part = kept[i].toInt(&is_number);
        const bool of_pedal = i == device_slots;
        const bool twice = !of_pedal && part >= 0 && std::find(parts, parts + i, part) != parts + i;
        const int least = of_pedal ? ui::pedal_of_each_hand : -1;
        if (!is_number || part < least || part >= device_slots || twice) return {};
        (of_pedal ? pedal : parts[i]) = part;
    }
    return {parts[0], parts[1], parts[2], pedal};
}

void Devices::set_slot_choice(const std::string& kind, const ui::SlotChoice& choice) {
    QSettings().setValue(
        slot_key(kind),
        QStringLiteral("%1 %2 %3 %4").arg(choice.left).arg(choice.right).arg(choice.scope).arg(choice.pedal));
}

std::string Devices::chosen() {
    const std::string kind = QSettings().value(QLatin1String(chosen_key)).toString().toStdString();
    const DeviceRow* const row = find_row(device_table, kind);
    // Mouse and keyboard are what is used without a choice.
    const bool known = row != nullptr && can_be_chosen(*row) && row->found_by != FoundBy::screen;
    return known ? kind : std::string();
}

void Devices::choose(const std::string& kind) {
    QSettings().setValue(QLatin1String(chosen_key), QString::fromStdString(kind));
    if (chosen() == specification_) return;
    test_.reset();
    calibration_.reset();
    pad_.reset();
    client_.reset();
    specification_ = chosen();
}

void Devices::start_calibration(int hand) {
    calibration_.reset();
    if (is_controller(specification_)) {
        calibration_ = begin_calibration(specification_, hand, game_controller());
        return;
    }
    test_.reset();
    client_.reset();  // a device is open once
    calibration_ = begin_calibration(specification_, hand, nullptr);
}

ui::CalibrationState Devices::calibration() {
    if (calibration_ == nullptr) return {};
    const ui::CalibrationState now = calibration_->look();
    // With the new ranges from the next reading on.
    if (!now.runs && is_controller(specification_)) pad_.reset();
    return now;
}

void Devices::open_now() {
    open();
    game_controller();
}

bool Devices::start_force_test() {
    const bool can = client_ != nullptr && client_->poll() == DaemonClient::Health::good &&
                     (client_->facts().force[0] || client_->facts().force[1]);
    test_.reset();
    if (can) test_ = std::make_unique<ForceTest>(client_);
    return can;
}

ui::ForceTestState Devices::force_test() const {
    if (test_ == nullptr) return {};
    test_->keep();
    return {test_->runs(),          test_->hand() == 0 ? "left" : "right",
            test_->axis(),          test_->asked(),
            test_->largest_asked(), test_->rendered(),
            test_->progress()};
}

std::optional<ui::DeviceReadings> Devices::readings() {
    if (pad_ != nullptr) {
        ui::DeviceReadings now;
        now.controller = pad_->readings();
        now.rate = now.controller->rate;
        if (now.rate > 0) now.worst_delay = now.controller->worst_gap;
        return now;
    }
    if (client_ == nullptr || client_->poll() != DaemonClient::Health::good) return std::nullopt;
    ui::DeviceReadings now;
    std::uint64_t count = 0;
    for (int i = 0; i < device_slots; ++i) {
        DevicePose pose;
        if (!client_->facts().slot[i] || !client_->state().pose[i].read(pose)) continue;
        now.held.push_back({device_slot_names[i], pose.present != 0,
                            Vector3(pose.position[0], pose.position[1], pose.position[2]), pose.jaw,
                            pose.buttons, client_->facts().workspace[i], client_->facts().clutch[i]});
        count = std::max(count, pose.sequence);
    }
    const std::int64_t at = monotonic_ns();
    if (counted_at_ >= 0 && count >= counted_ && at > counted_at_)
        now.rate = static_cast<double>(count - counted_) / (1e-9 * static_cast<double>(at - counted_at_));
    LoopReport loop;
    if (client_->state().loop.read(loop) && loop.ticks > 0) {
        now.worst_delay = 1e-9 * static_cast<double>(loop.worst_late);
        now.jitter = loop.jitter;
    }
    FaultReport fault;
    now.needs_calibration = client_->state().fault.read(fault) &&
                            fault.fault == static_cast<std::uint64_t>(DeviceFault::needs_calibration);
    now.firmware = client_->facts().firmware;
    now.gives_force = client_->facts().force[0] || client_->facts().force[1];
    counted_ = count;
    counted_at_ = at;
    return now;
}

ui::DeviceInUse Devices::in_use() const {
    if (specification_.empty()) return {};
    ui::DeviceInUse device;
    const DeviceRow* const row = device_row(specification_);
    if (row != nullptr && row->found_by == FoundBy::script) device.practice_only = ui::PracticeOnly::scripted;
    if (specification_.rfind("joystick:raw", 0) == 0) device.practice_only = ui::PracticeOnly::scripted;
    if (specification_ == two_mice || specification_ == virtual_mice) {
        device.title = ui::two_mice_title;
        device.two_mice = true;
        device.virtual_mice = specification_ == virtual_mice;
        device.practice_only = ui::PracticeOnly::no_limits;
        return device;
    }
    device.kind = kind_of(specification_);
    if (is_controller(specification_)) {
        device.device_class = row->device_class;
        device.title = pad_ != nullptr ? pad_->name() : std::string(row->title);
        return device;
    }
    device.device_class = client_ != nullptr ? class_of(client_->facts())
                          : row != nullptr   ? row->device_class
                                             : DeviceClass::haptic;
    device.title = client_ != nullptr ? client_->facts().title : specification_;
    const ui::SlotChoice use = slot_choice(device.kind);
    const int parts[device_slots] = {use.left, use.right, use.scope};
    const auto moves = [this](int part) {
        return part >= 0 && part < device_slots && (client_ == nullptr || client_->facts().slot[part]);
    };
    if (std::none_of(std::begin(parts), std::end(parts), moves)) {
        const ui::DeviceInUse mouse{};  // it moves everything
        device.device_class = mouse.device_class;
        device.title = mouse.title;
    }
    if (client_ == nullptr) return device;
    device.pedal = use.pedal;
    for (int i = 0; i < device_slots; ++i) {
        const int part = parts[i];
        device.drives[i] = moves(part);
        if (!device.drives[i]) continue;
        const bool has_pedal = row != nullptr && (row->moves & moves_pedal) != 0;
        if (client_->facts().clutch[part]) {
            device.clutch = ui::ClutchButton::own;
        } else if (device.clutch == ui::ClutchButton::none && has_pedal &&
                   use.pedal != ui::pedal_of_each_hand && use.pedal != part) {
            device.clutch = ui::ClutchButton::energy;
        }
    }
    return device;
}

std::shared_ptr<Rig> Devices::hands(const Scene& scene, std::shared_ptr<Rig> others) {
    open();
    rig_.reset();
    if (client_ == nullptr) return others;
    test_.reset();
    const std::string kind = kind_of(specification_);
    const ui::SlotChoice use = slot_choice(kind);
    const auto rig = std::make_shared<DeviceRig>(
        client_, client_->state(), client_->command(), client_->facts(), scene, std::move(others),
        SlotUse{use.left, use.right, use.scope, motion_scale(kind), use.pedal}, force_scale(kind));
    rig_ = rig;
    return rig;
}

std::shared_ptr<GameController> Devices::game_controller() {
    if (!is_controller(specification_)) return nullptr;
    // One that was not found again may have another name now: over Bluetooth, or another controller.
    if (pad_ != nullptr && pad_->readings().connected) return pad_;
    pad_.reset();
    const std::size_t colon = specification_.find(':');
    pad_ = GameController::open(colon == std::string::npos ? std::string() : specification_.substr(colon + 1),
                                controller_ranges());
    return pad_;
}

bool Devices::rumble_wanted() {
    return QSettings().value(QLatin1String(rumble_key), true).toBool();
}

void Devices::set_rumble_wanted(bool wanted) {
    QSettings().setValue(QLatin1String(rumble_key), wanted);
}

Sentence Devices::trouble() {
    if (pad_ != nullptr) return pad_->trouble();
    if (client_ == nullptr) return {};
    client_->poll();
    return client_->message();
}

}  // namespace fulcrum::app
