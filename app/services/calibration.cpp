// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/calibration.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSettings>
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "sim_core/controllers/joystick_mapping.h"
#include "sim_core/devices/device_table.h"
#include "sim_core/numerics/files.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/number_text.h"

namespace fulcrum::app {
namespace {

constexpr double held_still_s = 0.5, held_still_m = 1e-3;
constexpr double mrad = 1e-3;

std::string kind_in(const std::string& named) {
    return named.substr(0, named.find(':'));
}

std::string rest_of(const std::string& named) {
    const std::size_t colon = named.find(':');
    return colon == std::string::npos ? std::string() : named.substr(colon + 1);
}

/// How devices of a kind are calibrated. A new kind is a row of the table at the end of the classes.
struct CalibrationRow {
    const char* kind;
    bool of_each_hand;     ///< each hand is calibrated by itself
    const char* validity;  ///< what stays true after it: shown with the result
    const char* dock;      ///< where the handle is put, of a device that calibrates itself there; else null
    std::unique_ptr<GuidedCalibration> (*begin)(const std::string& named, int hand,
                                                std::shared_ptr<GameController> pad);
};
/// Null where there is nothing to calibrate.
const CalibrationRow* calibration_of(const std::string& kind);

void note_calibration(const std::string& kind) {
    QSettings().setValue(QStringLiteral("calibration/") + QString::fromStdString(kind),
                         QDateTime::currentDateTime().toString(QStringLiteral("yyyy-MM-dd HH:mm")));
}

double seconds_now() {
    return 1e-9 * static_cast<double>(monotonic_ns());
}

/// How long a place has not changed.
class Stillness {
  public:
    void see(const Vector3& place, double now) {
        if (!known_ || !((place - at_).norm() <= held_still_m)) {
            at_ = place;
            since_ = now;
            known_ = true;
        }
        now_ = now;
    }
    void forget() { known_ = false; }
    bool still() const { return known_ && now_ - since_ >= held_still_s; }

  private:
    Vector3 at_ = Vector3::Zero();
    double since_ = 0, now_ = 0;
    bool known_ = false;
};

Vector3 place_of(const DevicePose& pose) {
    return {pose.position[0], pose.position[1], pose.position[2]};
}

Sentence place_words(const DevicePose& pose) {
    if (pose.present == 0) return QT_TRANSLATE_NOOP("errors", "The device does not answer.");
    return {QT_TRANSLATE_NOOP("errors", "It is at (%1, %2, %3) mm."), decimal_text(1e3 * pose.position[0], 1),
            decimal_text(1e3 * pose.position[1], 1), decimal_text(1e3 * pose.position[2], 1)};
}

/// Steps, results and the end, which all calibrations have.
class Stepwise : public GuidedCalibration {
  public:
    Stepwise(std::string kind, int steps) : kind_(std::move(kind)), steps_(steps) {}
    ui::CalibrationState look() override {
        ui::CalibrationState state;
        state.runs = step_ < steps_ && result_.empty();
        state.step = std::min(step_ + 1, steps_);
        state.steps = steps_;
        state.result = result_;
        state.good = good_;
        if (state.runs) show(state);
        ready_ = state.runs && state.ready;
        return state;
    }
    void next() override {
        look();
        if (ready_) take();
    }

  protected:
    virtual void show(ui::CalibrationState& state) = 0;
    /// What the step asked for is there.
    virtual void take() = 0;
    void advance() {
        if (++step_ < steps_) return;
        try {
            store();
            note_calibration(kind_);
            result_ = calibration_of(kind_)->validity;
            good_ = true;
        } catch (const InputError& error) {
            result_ = {QT_TRANSLATE_NOOP("errors", "It could not be stored: %1"), error.problem()};
        }
    }
    virtual void store() {}
    std::string kind_;
    int step_ = 0, steps_;

  private:
    Sentence result_;
    bool good_ = false, ready_ = false;
};

/// Devices that calibrate themselves where the handle is put to its place.
class DockCalibration : public Stepwise {
  public:
    DockCalibration(const std::string& named)
        : Stepwise(kind_in(named), 2), client_(hapticd_program(), named) {}

  private:
    void show(ui::CalibrationState& state) override {
        client_.poll();
        FaultReport fault;
        client_.state().fault.read(fault);
        const bool needed = fault.fault == static_cast<std::uint64_t>(DeviceFault::needs_calibration);
        DevicePose pose;
        for (int i = hand_count - 1; i >= 0; --i)
            if (client_.facts().slot[i]) client_.state().pose[i].read(pose);
        const double now = seconds_now();
        if (step_ == 0) {
            if (needed) good_since_ = now;
            if (good_since_ < 0) good_since_ = now;
            state.what_to_do = calibration_of(kind_)->dock;
            state.seen = needed ? QT_TRANSLATE_NOOP("errors", "The device reports that it is not calibrated.")
                                : QT_TRANSLATE_NOOP("errors", "The device reports that it is calibrated.");
            state.ready = !needed && fault.fault == 0 && now - good_since_ >= held_still_s;
            return;
        }
        if (pose.present != 0)
            still_.see(place_of(pose), now);
        else
            still_.forget();
        state.what_to_do = QT_TRANSLATE_NOOP(
            "errors", "Hold the handle still in the middle of where you will work, for a second.");
        state.seen = place_words(pose);
        state.ready = still_.still() && !needed;
    }
    void take() override { advance(); }
    DaemonClient client_;
    Stillness still_;
    double good_since_ = -1;
};

/// Where a trainer's instrument points straight away.
class ZeroCalibration : public Stepwise {
  public:
    ZeroCalibration(const std::string& named, int hand)
        : Stepwise("trainer", 1), hand_(hand), client_(hapticd_program(), named) {
        if (!client_.facts().slot[hand])
            throw InputError(client_.facts().title, "",
                             QT_TRANSLATE_NOOP("errors", "has no instrument for this hand"),
                             QT_TRANSLATE_NOOP("errors", "choose the other hand"));
    }

  private:
    void show(ui::CalibrationState& state) override {
        client_.poll();
        pose_ = {};
        client_.state().pose[hand_].read(pose_);
        if (pose_.present != 0 && place_of(pose_).norm() > 0.01)
            still_.see(place_of(pose_), seconds_now());
        else
            still_.forget();
        state.what_to_do = QT_TRANSLATE_NOOP(
            "errors",
            "Hold the instrument level and straight away from you, its jaws upright, and keep it still.");
        state.seen = place_words(pose_);
        state.ready = still_.still();
    }
    void take() override { advance(); }
    void store() override {
        // From the pivot to the handle; the tip is on the other side.
        const Vector3 to_the_tip = -place_of(pose_).normalized();
        const double zero[] = {std::asin(std::clamp(to_the_tip.y(), -1.0, 1.0)),
                               std::atan2(to_the_tip.x(), -to_the_tip.z()),
                               std::remainder(pose_.roll, 2 * M_PI)};
        QStringList words;
        for (const double angle : zero) words << QString::number(std::lround(angle / mrad));
        QSettings().setValue(QLatin1String(hand_ == 0 ? "trainer/zero-left" : "trainer/zero-right"),
                             words.join(QLatin1Char(';')));
    }
    int hand_;
    DaemonClient client_;
    DevicePose pose_;
    Stillness still_;
};

/// Which axis of a joystick is which motion, and how far each goes.
class AxesCalibration : public Stepwise {
  public:
    AxesCalibration(const std::string& name, int hand)
        : Stepwise("joystick", JoystickCalibration::steps),
          hand_(hand),
          client_(hapticd_program(), name.empty() ? "joystick:raw" : "joystick:raw," + name) {}
    void skip() override {
        if (!look().can_skip) return;
        axes_.skip();
        advance();
    }

  private:
    void show(ui::CalibrationState& state) override {
        client_.poll();
        DevicePose left, right;
        const bool there =
            client_.state().pose[0].read(left) && client_.state().pose[1].read(right) && left.present != 0;
        if (there) axes_.see(raw_of(left, right), raw_axes, seconds_now());
        constexpr const char* words[] = {
            QT_TRANSLATE_NOOP("errors",
                              "Hold the instrument straight away from you, half way in, its jaws open, and "
                              "keep it still."),
            QT_TRANSLATE_NOOP("errors", "Move the tip from all the way down to all the way up; stop there."),
            QT_TRANSLATE_NOOP("errors",
                              "Move the tip from all the way left to all the way right; stop there."),
            QT_TRANSLATE_NOOP("errors",
                              "Pull the instrument all the way out, then push it all the way in; "
                              "stop there."),
            QT_TRANSLATE_NOOP("errors",
                              "Turn the shaft all the way counterclockwise, then all the way "
                              "clockwise as you see it; stop there."),
            QT_TRANSLATE_NOOP("errors", "Close the jaws, then open them all the way; stop there.")};
        state.what_to_do = words[step_];
        if (!there)
            state.seen = QT_TRANSLATE_NOOP("errors", "The device does not answer.");
        else if (!axes_.ready())
            state.seen = step_ == 0
                             ? QT_TRANSLATE_NOOP("errors", "It moves.")
                             : QT_TRANSLATE_NOOP("errors", "No axis moved from one end to the other yet.");
        else
            state.seen = QT_TRANSLATE_NOOP("errors", "Seen.");
        state.ready = there && axes_.ready();
        state.can_skip = axes_.can_skip();
    }
    void take() override {
        if (axes_.next()) advance();
    }
    void store() override {
        JoystickMapping mapping;
        try {
            mapping = read_joystick_mapping(joystick_file());
        } catch (const InputError&) {  // the first one
        }
        if (mapping.name != client_.facts().title) mapping = {};
        mapping.name = client_.facts().title;
        mapping.part[hand_] = axes_.part();
        QDir().mkpath(QFileInfo(QString::fromStdString(joystick_file())).absolutePath());
        write_whole_file(joystick_file(), joystick_mapping_text(mapping));
    }
    int hand_;
    DaemonClient client_;
    JoystickCalibration axes_;
};

/// How far sticks and triggers go.
class RangeCalibration : public Stepwise {
  public:
    explicit RangeCalibration(std::shared_ptr<GameController> pad)
        : Stepwise("controller", 2), pad_(std::move(pad)) {
        for (auto& stick : ranges_.stick)
            for (auto& ends : stick) ends[0] = ends[1] = 0;
        ranges_.trigger[0] = ranges_.trigger[1] = 0;
    }

  private:
    void show(ui::CalibrationState& state) override {
        const ControllerReadings now = pad_->readings();
        double furthest = 0;
        for (int h = 0; h < 2; ++h) {
            for (int i = 0; i < 2; ++i) {
                auto& ends = ranges_.stick[h][i];
                ends[0] = std::min(ends[0], now.raw_stick[h][i]);
                ends[1] = std::max(ends[1], now.raw_stick[h][i]);
                furthest = std::max(furthest, std::abs(now.raw_stick[h][i]));
            }
            ranges_.trigger[h] = std::max(ranges_.trigger[h], now.raw_trigger[h]);
        }
        if (step_ == 0) {
            state.what_to_do = QT_TRANSLATE_NOOP(
                "errors", "Turn each stick along its edge once, and press each trigger all the way.");
            state.seen =
                is_usable(ranges_)
                    ? QT_TRANSLATE_NOOP("errors", "Seen.")
                    : QT_TRANSLATE_NOOP("errors", "Not all sticks and triggers went to all their ends yet.");
            state.ready = now.connected && is_usable(ranges_);
            return;
        }
        state.what_to_do = QT_TRANSLATE_NOOP("errors", "Let go of both sticks.");
        state.ready = now.connected && furthest <= 0.15;
        state.seen = state.ready ? QT_TRANSLATE_NOOP("errors", "Both are in their middle.")
                                 : QT_TRANSLATE_NOOP("errors", "A stick is not in its middle.");
    }
    void take() override { advance(); }
    void store() override {
        QStringList words;
        for (int h = 0; h < 2; ++h) {
            for (const auto& ends : ranges_.stick[h])
                for (const double end : ends) words << QString::number(end, 'f', 4);
            words << QString::number(ranges_.trigger[h], 'f', 4);
        }
        QSettings().setValue(QStringLiteral("controller/ranges"), words.join(QLatin1Char(' ')));
    }
    std::shared_ptr<GameController> pad_;
    ControllerRanges ranges_;
};

std::unique_ptr<GuidedCalibration> begin_dock(const std::string& named, int /*hand*/,
                                              std::shared_ptr<GameController> /*pad*/) {
    return std::make_unique<DockCalibration>(named);
}
std::unique_ptr<GuidedCalibration> begin_zero(const std::string& named, int hand,
                                              std::shared_ptr<GameController> /*pad*/) {
    return std::make_unique<ZeroCalibration>(named, hand);
}
std::unique_ptr<GuidedCalibration> begin_axes(const std::string& named, int hand,
                                              std::shared_ptr<GameController> /*pad*/) {
    return std::make_unique<AxesCalibration>(rest_of(named), hand);
}
std::unique_ptr<GuidedCalibration> begin_ranges(const std::string& named, int /*hand*/,
                                                std::shared_ptr<GameController> pad) {
    if (pad == nullptr) pad = GameController::open(rest_of(named));
    return std::make_unique<RangeCalibration>(std::move(pad));
}

constexpr const char* until_switched_off =
    QT_TRANSLATE_NOOP("errors", "Calibrated. It is valid until the device is switched off or unplugged.");
constexpr CalibrationRow calibrations[] = {
    {"touch", false, until_switched_off,
     QT_TRANSLATE_NOOP("errors", "Put the stylus into the inkwell and leave it there for two seconds."),
     begin_dock},
    {"haply", false, until_switched_off,
     QT_TRANSLATE_NOOP("errors",
                       "Put the handle into its rest, and leave it there until the Inverse "
                       "service reports that it is calibrated."),
     begin_dock},
    {"force-dimension", false, until_switched_off,
     QT_TRANSLATE_NOOP("errors",
                       "Put the handle on its calibration pole or push it to its stops, as the "
                       "maker's manual says, until its light stops blinking."),
     begin_dock},
    {"trainer", true,
     QT_TRANSLATE_NOOP("errors", "Stored. It is valid until a sensor of the trainer is moved."), nullptr,
     begin_zero},
    {"joystick", true,
     QT_TRANSLATE_NOOP("errors", "Stored. It is valid for this joystick until its sensors are moved."),
     nullptr, begin_axes},
    {"controller", false,
     QT_TRANSLATE_NOOP("errors", "Stored. It is valid for this controller, from now on."), nullptr,
     begin_ranges},
};

const CalibrationRow* calibration_of(const std::string& kind) {
    for (const CalibrationRow& row : calibrations)
        if (kind == row.kind) return &row;
    return nullptr;
}

}  // namespace

bool can_calibrate(const std::string& kind) {
    return calibration_of(kind) != nullptr;
}

bool calibrates_hands(const std::string& kind) {
    const CalibrationRow* const row = calibration_of(kind);
    return row != nullptr && row->of_each_hand;
}

std::unique_ptr<GuidedCalibration> begin_calibration(const std::string& named, int hand,
                                                     std::shared_ptr<GameController> pad) {
    if (const CalibrationRow* const row = calibration_of(kind_in(named)))
        return row->begin(named, hand, std::move(pad));
    throw InputError(named, "", QT_TRANSLATE_NOOP("errors", "needs no calibration"),
                     QT_TRANSLATE_NOOP("errors", "use it as it is"));
}

std::string joystick_file() {
    return (QFileInfo(QSettings().fileName()).absolutePath() + QStringLiteral("/fulcrum-joystick.json"))
        .toStdString();
}

std::string with_calibration(const std::string& named) {
    const std::string kind = kind_in(named);
    if (named == "joystick" && QFileInfo::exists(QString::fromStdString(joystick_file())))
        return "joystick:" + joystick_file();
    if (kind != "trainer" || named.find("zero-") != std::string::npos) return named;
    std::string whole = named;
    for (const char* key : {"zero-left", "zero-right"}) {
        const std::string zero =
            QSettings().value(QLatin1String("trainer/") + QLatin1String(key)).toString().toStdString();
        if (zero.empty()) continue;
        whole += (whole == "trainer" ? ":" : ",") + std::string(key) + "=" + zero;
    }
    return whole;
}

ControllerRanges controller_ranges() {
    const QStringList words =
        QSettings().value(QStringLiteral("controller/ranges")).toString().split(QLatin1Char(' '));
    ControllerRanges ranges, usual;
    if (words.size() != 10) return usual;
    for (int h = 0; h < 2; ++h) {
        for (int i = 0; i < 4; ++i) ranges.stick[h][i / 2][i % 2] = words[5 * h + i].toDouble();
        ranges.trigger[h] = words[5 * h + 4].toDouble();
    }
    return is_usable(ranges) ? ranges : usual;
}

std::string calibrated_at(const std::string& kind) {
    return QSettings()
        .value(QStringLiteral("calibration/") + QString::fromStdString(kind))
        .toString()
        .toStdString();
}

}  // namespace fulcrum::app
