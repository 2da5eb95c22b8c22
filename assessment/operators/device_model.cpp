// SPDX-License-Identifier: Apache-2.0
#include "assessment/operators/device_model.h"

#include "assessment/operators/device_models.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {

Quaternion view_of(const ScopeModel& scope, bool exists, const DeviceSample& sample) {
    return exists ? scope_pose(scope, sample).orientation : Quaternion::Identity();
}

std::optional<ScreenStep> screen_step(const DeviceReading& from, const Trocar& trocar, const Vector3& wanted,
                                      const Quaternion& view) {
    const Vector3 along = from.handle.normalized();
    const auto across = [&](const Vector3& v) { return Vector3(v - along * along.dot(v)); };
    const Matrix3 to_trocar = trocar.rotation.transpose();
    const Vector3 sideways = across(to_trocar * (view * Vector3(1, 0, 0)));
    const Vector3 upwards = across(to_trocar * (view * Vector3(0, 1, 0)));
    const Vector3 step = across(wanted - from.handle);
    const double rr = sideways.dot(sideways), ru = sideways.dot(upwards), uu = upwards.dot(upwards);
    const double determinant = rr * uu - ru * ru;
    if (determinant < 1e-6) return std::nullopt;
    return ScreenStep{(uu * sideways.dot(step) - ru * upwards.dot(step)) / determinant,
                      (rr * upwards.dot(step) - ru * sideways.dot(step)) / determinant};
}

bool has_device_model(DeviceClass device_class) {
    return device_class != DeviceClass::external;
}

std::unique_ptr<ObservingRig> through_device(std::unique_ptr<ObservingRig> hands, DeviceClass device_class,
                                             const Scene& scene, std::uint64_t attempt) {
    switch (device_class) {
        case DeviceClass::haptic:
        case DeviceClass::synthetic:
            return hands;
        case DeviceClass::mouse_keyboard:
            return make_mouse_model(std::move(hands), scene);
        case DeviceClass::tracked:
            return make_tracked_model(std::move(hands), scene, attempt);
        case DeviceClass::controller:
            return make_controller_model(std::move(hands), scene, attempt);
        case DeviceClass::external:
            break;
    }
    throw InputError(
        QT_TRANSLATE_NOOP("errors", "operator"), row_of(device_classes, device_class).name,
        QT_TRANSLATE_NOOP("errors", "there is no model of this class of devices"),
        QT_TRANSLATE_NOOP("errors", "use haptic, synthetic, tracked, controller or mouse-keyboard"));
}

}  // namespace fulcrum
