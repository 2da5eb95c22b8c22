// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/hand_wishes.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::app::program_test {

Vector3 handle_of(const DeviceSample& sample) {
    return device_length_unit * Vector3(sample.handle[0], sample.handle[1], sample.handle[2]);
}

bool begins_exchange(const RigSample& before, const RigSample& now, int hand) {
    return (now.hand[hand].buttons & button_exchange) != 0 &&
           (before.hand[hand].buttons & button_exchange) == 0;
}

bool holds_blade(const ui::AttemptSession& session, int hand) {
    const InstrumentSpec* const spec = session.scene().instrument(static_cast<Hand>(hand));
    const auto& field = session.snapshot().field;
    if (field.empty()) return spec != nullptr && spec->cuts();
    const InstrumentKind kind = field[0].tools[hand].kind;
    return kind == InstrumentKind::scissors || kind == InstrumentKind::hook;
}

bool wants_closed(const ui::AttemptSession& session, const RigSample& wish, int hand) {
    const InstrumentSpec* const spec = session.scene().instrument(static_cast<Hand>(hand));
    if (spec == nullptr || (!type_of(spec->kind).jaws && !spec->cuts())) return false;
    return holds_blade(session, hand) ? (wish.hand[hand].buttons & button_primary) != 0
                                      : device_angle_unit * wish.hand[hand].jaw < 0.3 * spec->jaw_opening;
}

Eigen::Vector2d movement_on_screen(const ui::AttemptSession& session, const TrocarSpec& trocar,
                                   const Vector3& is, const Vector3& wanted) {
    const Matrix3 to_trocar =
        make_trocar(trocar).rotation.transpose() * session.snapshot().camera.orientation.toRotationMatrix();
    const Vector3 along = is.normalized();
    const auto across = [&](const Vector3& v) { return Vector3(v - along * along.dot(v)); };
    const Vector3 right = across(to_trocar.col(0)), up = across(to_trocar.col(1)),
                  step = across(wanted.normalized() * is.norm() - is);
    const double a = right.dot(right) + 1e-3, b = right.dot(up), c = up.dot(up) + 1e-3;
    const double r = right.dot(step), u = up.dot(step), determinant = a * c - b * b;
    return {(c * r - b * u) / determinant, (a * u - b * r) / determinant};
}

Look wanted_look(const ui::AttemptSession& session, const ui::HandTargets& now, const RigSample& wish,
                 bool turning) {
    const Scene& scene = session.scene();
    if (!scene.camera || wish.camera.handle[2] == 0) return Look::none;
    const Vector3 off = handle_of(wish.camera) - now.camera.handle;
    const Vector3 seen =
        session.snapshot().camera.orientation.inverse() * (make_trocar(scene.camera->trocar).rotation * off);
    if (std::max(std::abs(seen.x()), std::abs(seen.y())) <= (turning ? 0.006 : 0.016)) return Look::none;
    // The view turns, the scope's handle goes the other way.
    if (std::abs(seen.x()) > std::abs(seen.y())) return seen.x() > 0 ? Look::left : Look::right;
    return seen.y() > 0 ? Look::down : Look::up;
}

}  // namespace fulcrum::app::program_test
