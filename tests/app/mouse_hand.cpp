// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/mouse_hand.h"

#include <QApplication>
#include <QCursor>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QWheelEvent>
#include <QtTest>
#include <cmath>

#include "tests/app/hand_wishes.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::app::program_test {
namespace {

constexpr double metres_per_pixel = 0.35e-3,
                 metres_per_wheel_unit = 4e-3 / 120;  // of the handle, as in the help
constexpr double near_enough = 0.6e-3;                // m of the handle

class PointingMind : public ObservingRig {
  public:
    PointingMind(const Scene& scene, double depth) : depth_(depth) {
        for (const InstrumentSpec& spec : scene.instruments) {
            const auto h = static_cast<std::size_t>(spec.hand);
            trocar_[h] = make_trocar(spec.trocar);
            tip_radius_[h] = spec.tip_radius;
            point_[h] = trocar_[h].position + trocar_[h].rotation.col(2) * spec.start_insertion;
        }
    }
    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        asked_ = display.active_target >= 0 &&
                 static_cast<std::size_t>(display.active_target) < world.targets.size();
        if (asked_) target_ = world.targets[static_cast<std::size_t>(display.active_target)];
    }
    void read(std::uint32_t, RigSample& sample) override {
        if (asked_) approach(static_cast<std::size_t>(target_.hand));
        for (std::size_t h = 0; h < hand_count; ++h) {
            DeviceReading reading;
            reading.handle = handle_for_tip(trocar_[h], point_[h]);
            sample.hand[h] = quantise(reading, sample.hand[h]);
        }
    }
    void write_force(Hand, const Vector3&) override {}
    bool has_force(Hand) const override { return false; }
    double damping(Hand) const override { return -1; }

  private:
    void approach(std::size_t h) {
        const Vector3 out = (trocar_[h].position - target_.centre).normalized();
        const Vector3 contact = target_.centre + out * (target_.radius + tip_radius_[h] + 0.3e-3 - depth_);
        const Vector3 away = point_[h] - contact;
        const bool beside = (away - out * out.dot(away)).norm() > 5e-3;
        const Vector3 way = (beside ? Vector3(contact + 0.018 * out) : contact) - point_[h];
        const double speed = beside || way.norm() > 8e-3 ? 0.22e-3 : 0.05e-3;  // m a tick
        point_[h] += way.norm() > speed ? Vector3(way * (speed / way.norm())) : way;
    }
    Trocar trocar_[hand_count];
    double tip_radius_[hand_count] = {0, 0};
    Vector3 point_[hand_count] = {Vector3::Zero(), Vector3::Zero()};
    TargetSphere target_;
    double depth_;
    bool asked_ = false;
};

}  // namespace

std::unique_ptr<ObservingRig> make_pointing_mind(const Scene& scene, double depth) {
    return std::make_unique<PointingMind>(scene, depth);
}

bool MouseHand::work_until(const std::function<bool()>& done, int milliseconds) {
    QElapsedTimer timer;
    timer.start();
    while (timer.elapsed() < milliseconds) {
        QTest::qWait(8);
        if (theatre_.session() == nullptr || done()) return true;
        keep_pointer_in(*theatre_.view());
        if (theatre_.session() == nullptr || theatre_.session()->phase() != ui::AttemptPhase::running)
            continue;
        think();
        jaws();
        buttons();
        scope();
        steer();
    }
    return false;
}

void MouseHand::think() {
    const ui::AttemptSession& session = *theatre_.session();
    mind_.observe(session.snapshot(), session.display());
    const std::uint32_t now = session.health().ticks;
    while (tick_ < now) {
        const RigSample before = wish_;
        mind_.read(++tick_, wish_);
        for (int h = 0; h < hand_count; ++h)  // a press is short, and the screen slow
            asks_exchange_[h] = asks_exchange_[h] || begins_exchange(before, wish_, h);
    }
}

void MouseHand::take(int hand) {
    if (static_cast<int>(theatre_.input()->active_hand()) == hand) return;
    QTest::mouseClick(theatre_.view(), Qt::RightButton, {}, theatre_.view()->mapFromGlobal(QCursor::pos()));
    ++events_;
}

void MouseHand::buttons() {
    const auto& field = theatre_.session()->snapshot().field;
    for (int h = 0; h < hand_count; ++h) {
        const bool pedal = (wish_.hand[h].buttons & button_energy) != 0;
        if (pedal) take(h);
        if (pedal != pedal_ && (pedal || static_cast<int>(theatre_.input()->active_hand()) == h)) {
            pedal ? QTest::keyPress(theatre_.view(), Qt::Key_B)
                  : QTest::keyRelease(theatre_.view(), Qt::Key_B);
            pedal_ = pedal;
            ++events_;
        }
        if (!asks_exchange_[h] || field.empty()) continue;
        asks_exchange_[h] = false;
        if (field[0].tools[h].exchange_left > 0) continue;  // the exchange is in progress
        take(h);
        QTest::keyPress(theatre_.view(), Qt::Key_T);
        const bool coming = QTest::qWaitFor(
            [&] {
                return theatre_.session() == nullptr || theatre_.session()->snapshot().field.empty() ||
                       theatre_.session()->snapshot().field[0].tools[h].exchange_left > 0;
            },
            1000);
        asks_exchange_[h] = !coming;  // repeated if the key was missed
        if (theatre_.session() != nullptr) QTest::keyRelease(theatre_.view(), Qt::Key_T);
        ++events_;
    }
}

void MouseHand::jaws() {
    const Scene& scene = theatre_.session()->scene();
    for (int h = 0; h < hand_count; ++h) {
        const InstrumentSpec* const spec = scene.instrument(static_cast<Hand>(h));
        if (spec == nullptr || (!type_of(spec->kind).jaws && !spec->cuts())) continue;
        const bool closed = wants_closed(*theatre_.session(), wish_, h);
        if (closed == theatre_.input()->jaws_closed(static_cast<Hand>(h))) continue;
        QTest::keyClick(theatre_.view(), h == 0 ? Qt::Key_X : Qt::Key_M);
        ++events_;
    }
}

void MouseHand::scope() {
    const Scene& scene = theatre_.session()->scene();
    if (!scene.camera || wish_.camera.handle[2] == 0) return;
    if (scene.instruments.empty()) {
        turn_scope();
        return;
    }
    constexpr int keys[] = {0, Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down};
    const Look look = wanted_look(*theatre_.session(), theatre_.input()->targets(), wish_, scope_key_ != 0);
    hold_key(scope_key_, keys[static_cast<int>(look)]);
}

void MouseHand::hold_key(int& held, int key) {
    if (key == held) {
        // Pressed again twice a second: a window that lost the keyboard has let go of its keys.
        if (key == 0 || since_press_.elapsed() < 500) return;
        QTest::keyPress(theatre_.view(), static_cast<Qt::Key>(key));
        since_press_.restart();
        return;
    }
    since_press_.restart();
    if (held != 0) QTest::keyRelease(theatre_.view(), static_cast<Qt::Key>(held));
    if (key != 0) QTest::keyPress(theatre_.view(), static_cast<Qt::Key>(key));
    held = key;
    ++events_;
}

void MouseHand::turn_scope() {
    const DeviceReading& is = theatre_.input()->targets().camera;
    const double post = device_angle_unit * wish_.camera.roll - is.roll;
    const double head = device_angle_unit * wish_.camera.jaw - is.jaw;
    hold_key(post_key_, std::abs(post) < 0.03 ? 0 : post > 0 ? Qt::Key_End : Qt::Key_Home);
    hold_key(head_key_, std::abs(head) < 0.03 ? 0 : head > 0 ? Qt::Key_Comma : Qt::Key_Period);
}

void turn_wheel(ui::TheatreView& view, int units) {
    const QPointF place = view.mapFromGlobal(QCursor::pos());
    QWheelEvent event(place, view.mapToGlobal(place.toPoint()), QPoint(), QPoint(0, units), Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view, &event);
}

int slide_mouse(ui::TheatreView& view, const QPoint& by, Qt::KeyboardModifiers with) {
    const QPoint from = view.mapFromGlobal(QCursor::pos());
    constexpr int parts = 10;
    for (int i = 1; i <= parts; ++i) {
        const QPoint to = from + by * i / parts;
        QMouseEvent event(QEvent::MouseMove, to, view.mapToGlobal(to), Qt::NoButton, Qt::NoButton, with);
        QApplication::sendEvent(&view, &event);
        QTest::qWait(16);
    }
    return parts;
}

void MouseHand::steer() {
    const ui::AttemptSession& session = *theatre_.session();
    const ui::MouseKeyboardInput& input = *theatre_.input();
    ui::TheatreView* view = theatre_.view();
    if (session.scene().instruments.empty()) {
        if (wish_.camera.handle[2] != 0)
            events_ += bring_by_mouse(theatre_, input.targets().camera.handle, handle_of(wish_.camera),
                                      session.scene().camera->trocar);
        return;
    }
    double error[hand_count] = {0, 0};
    for (int h = 0; h < hand_count; ++h) {
        if (session.scene().instrument(static_cast<Hand>(h)) != nullptr)
            error[h] = (handle_of(wish_.hand[h]) - input.targets().hand[h].handle).norm();
    }
    auto h = static_cast<int>(input.active_hand());
    if (error[1 - h] > near_enough && error[1 - h] > 1.5 * error[h]) {
        QTest::mouseClick(view, Qt::RightButton, {}, view->mapFromGlobal(QCursor::pos()));
        h = static_cast<int>(input.active_hand());
        ++events_;
    }
    events_ += bring_by_mouse(theatre_, input.targets().hand[h].handle, handle_of(wish_.hand[h]),
                              session.scene().instrument(static_cast<Hand>(h))->trocar);
}

void keep_pointer_in(ui::TheatreView& view) {
    if (!view.rect().contains(view.mapFromGlobal(QCursor::pos())))
        QTest::mouseMove(&view, view.rect().center());
}

int bring_by_mouse(ui::TheatrePage& theatre, const Vector3& is, const Vector3& wish,
                   const TrocarSpec& trocar) {
    if ((wish - is).norm() < near_enough) return 0;
    int events = 0;
    ui::TheatreView* const view = theatre.view();
    const auto units = static_cast<int>(std::lround((is.norm() - wish.norm()) / metres_per_wheel_unit));
    if (std::abs(units) >= 4) {
        turn_wheel(*view, units);
        ++events;
    }
    const Eigen::Vector2d across = movement_on_screen(*theatre.session(), trocar, is, wish);
    const QPoint pixels(static_cast<int>(std::lround(across.x() / metres_per_pixel)),
                        -static_cast<int>(std::lround(across.y() / metres_per_pixel)));
    if (pixels.isNull()) return events;
    const QPoint limited(std::clamp(pixels.x(), -220, 220), std::clamp(pixels.y(), -180, 180));
    QTest::mouseMove(view, view->mapFromGlobal(QCursor::pos()) + limited);
    return events + 1;
}

}  // namespace fulcrum::app::program_test
