// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/devices.h"

#include "app/live/device_rig.h"

namespace fulcrum::app {

DeviceClass class_of(const DeviceFacts& facts) {
    return facts.force[0] || facts.force[1] ? DeviceClass::haptic : DeviceClass::tracked;
}

Devices::Devices(std::string specification) : specification_(std::move(specification)) {}

namespace {
constexpr const char *two_mice = "two-mice", *virtual_mice = "two-mice:virtual";
}

void Devices::open() {
    if (specification_.empty() || specification_ == two_mice || specification_ == virtual_mice) return;
    if (client_ != nullptr && client_->poll() != DaemonClient::Health::ended) return;
    client_.reset();  // the one that ended, before another takes the device
    client_ = std::make_shared<DaemonClient>(hapticd_program(), specification_);
}

ui::DeviceInUse Devices::in_use() const {
    if (specification_.empty()) return {};
    ui::DeviceInUse device;
    if (specification_.rfind("virtual:", 0) == 0) device.practice_only = ui::PracticeOnly::scripted;
    if (specification_ == two_mice || specification_ == virtual_mice) {
        device.title = "two mice and keyboard";
        device.two_mice = true;
        device.virtual_mice = specification_ == virtual_mice;
        device.practice_only = ui::PracticeOnly::no_limits;
        return device;
    }
    device.device_class = client_ != nullptr ? class_of(client_->facts()) : DeviceClass::haptic;
    device.title = client_ != nullptr ? client_->facts().title : specification_;
    return device;
}

std::shared_ptr<Rig> Devices::hands(const Scene& scene, std::shared_ptr<Rig> others) {
    open();
    if (client_ == nullptr) return others;
    return std::make_shared<DeviceRig>(client_, client_->state(), client_->command(), client_->facts(), scene,
                                       std::move(others));
}

std::string Devices::trouble() {
    if (client_ == nullptr) return {};
    client_->poll();
    return client_->message();
}

}  // namespace fulcrum::app
