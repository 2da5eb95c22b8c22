// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/devices.h"

#include <QSettings>
#include <algorithm>

#include "app/live/device_rig.h"

namespace fulcrum::app {

DeviceClass class_of(const DeviceFacts& facts) {
    return facts.force[0] || facts.force[1] ? DeviceClass::haptic : DeviceClass::tracked;
}

Devices::Devices(std::string specification) : specification_(std::move(specification)) {}

namespace {
constexpr const char *two_mice = "two-mice", *virtual_mice = "two-mice:virtual";

/// "virtual" of "virtual:path.json".
std::string kind_of(const std::string& specification) {
    return specification.substr(0, specification.find(':'));
}

QString scale_key(const std::string& kind) {
    return QStringLiteral("force_scale/") + QString::fromStdString(kind);
}
}  // namespace

void Devices::open() {
    if (specification_.empty() || specification_ == two_mice || specification_ == virtual_mice) return;
    if (client_ != nullptr && client_->poll() != DaemonClient::Health::ended) return;
    client_.reset();  // the one that ended, before another takes the device
    client_ = std::make_shared<DaemonClient>(hapticd_program(), specification_);
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

std::optional<ui::DeviceReadings> Devices::readings() {
    if (client_ == nullptr || client_->poll() != DaemonClient::Health::good) return std::nullopt;
    constexpr const char* names[device_slots] = {"left", "right", "scope"};
    ui::DeviceReadings now;
    std::uint64_t count = 0;
    for (int i = 0; i < device_slots; ++i) {
        DevicePose pose;
        if (!client_->facts().slot[i] || !client_->state().pose[i].read(pose)) continue;
        now.held.push_back({names[i], pose.present != 0,
                            Vector3(pose.position[0], pose.position[1], pose.position[2]), pose.jaw,
                            pose.buttons});
        count = std::max(count, pose.sequence);
    }
    const std::int64_t at = monotonic_ns();
    if (counted_at_ >= 0 && count >= counted_ && at > counted_at_)
        now.rate = static_cast<double>(count - counted_) / (1e-9 * static_cast<double>(at - counted_at_));
    counted_ = count;
    counted_at_ = at;
    return now;
}

ui::DeviceInUse Devices::in_use() const {
    if (specification_.empty()) return {};
    ui::DeviceInUse device;
    if (specification_.rfind("virtual:", 0) == 0) device.practice_only = ui::PracticeOnly::scripted;
    if (specification_ == two_mice || specification_ == virtual_mice) {
        device.title = QT_TRANSLATE_NOOP("fulcrum::device_list", "two mice and keyboard");
        device.two_mice = true;
        device.virtual_mice = specification_ == virtual_mice;
        device.practice_only = ui::PracticeOnly::no_limits;
        return device;
    }
    device.kind = kind_of(specification_);
    device.device_class = client_ != nullptr ? class_of(client_->facts()) : DeviceClass::haptic;
    device.title = client_ != nullptr ? client_->facts().title : specification_;
    return device;
}

std::shared_ptr<Rig> Devices::hands(const Scene& scene, std::shared_ptr<Rig> others) {
    open();
    if (client_ == nullptr) return others;
    return std::make_shared<DeviceRig>(client_, client_->state(), client_->command(), client_->facts(), scene,
                                       std::move(others), SlotUse{}, force_scale(kind_of(specification_)));
}

Sentence Devices::trouble() {
    if (client_ == nullptr) return {};
    client_->poll();
    return client_->message();
}

}  // namespace fulcrum::app
