// SPDX-License-Identifier: GPL-3.0-or-later
// For benchmark_review: an hour of two hands, and the program's debrief of one, with the steps that a
// reviewer makes in its charts.
#pragma once

#include <benchmark/benchmark.h>

#include <QApplication>
#include <QElapsedTimer>
#include <QMouseEvent>
#include <QScrollArea>
#include <QTemporaryDir>
#include <QTimer>
#include <QWheelEvent>
#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "database/records/recorder.h"
#include "sim_core/telemetry/event.h"
#include "tests/app/forwarding_services.h"
#include "tests/ui/four_people.h"
#include "ui/charts/time_chart.h"
#include "ui/review/debrief_page.h"

namespace fulcrum::ui {

/// A minute of two hands at 1 kHz, moving and pressing, with tremor; repeated for the hour.
struct Minute {
    std::vector<TickSample> samples;
    std::vector<RigSample> inputs;
};

inline Minute minute() {
    Minute made;
    for (std::uint32_t tick = 0; tick < 60000; ++tick) {
        const double t = tick * 1e-3;
        TickSample sample;
        RigSample input;
        for (int h = 0; h < 2; ++h) {
            for (int axis = 0; axis < 3; ++axis) {
                const double move = 0.03 * std::sin(0.7 * t + axis + h) + 4e-5 * std::sin(57 * t + 2 * axis);
                input.hand[h].handle[axis] =
                    static_cast<std::int32_t>(std::lround(move / device_length_unit));
                sample.hand[h].tip[axis] =
                    static_cast<std::int32_t>(std::lround(-1.3 * move / sample_length_unit));
                const double force =
                    std::max(0.0, 2.0 * std::sin(0.9 * t + axis)) * (1 + 0.02 * std::sin(57 * t));
                sample.hand[h].force[axis] =
                    static_cast<std::int32_t>(std::lround(force / sample_force_unit));
                sample.hand[h].axis[axis] =
                    static_cast<std::int32_t>(std::lround(0.5 * std::sin(0.7 * t + axis) / sample_axis_unit));
            }
            sample.hand[h].flags = hand_inside;
        }
        made.samples.push_back(sample);
        made.inputs.push_back(input);
    }
    return made;
}

/// The program's services without the picture of the replay, which a thread of its own simulates.
class ServicesOfPage : public app::program_test::ForwardingServices {
  public:
    using ForwardingServices::ForwardingServices;
    std::unique_ptr<ReplaySource> open_replay(const database::Session&, const database::AttemptSummary&,
                                              std::shared_ptr<const database::Trace>) override {
        throw std::runtime_error("not measured here");
    }
};

/// An hour of two hands in which every chart of the debrief has values: a minute's cut, energy and heat again
/// and again. Opened by the trainee who performed it.
struct HourOnPage {
    QTemporaryDir folder;
    ServicesOfPage services{folder.path().toStdString()};
    Context context{services};
    std::string attempt;
    HourOnPage() {
        const std::string path = services.store_path(false);
        {
            const database::Store store = database::Store::create(path);
            const database::Session tara = window_test::make_four_people(store).at(database::Role::trainee);
            record(path, tara);
            context.set_session(tara);
        }
        services.open_store(false);
    }

  private:
    void record(const std::string& path, const database::Session& tara) {
        database::AttemptMeta meta;
        meta.person_id = tara.person_id();
        meta.task_id = "B2";
        meta.device = "test";
        meta.variant = meta.fidelity = "standard";
        meta.scene = "b2_plane.json";
        meta.program_version = "0.1.0-benchmark";
        database::Recorder recorder(path, tara, meta);
        const Minute pattern = minute();
        for (std::uint32_t tick = 0; tick < 3'600'000; ++tick) {
            const std::uint32_t at = tick % 60000;
            TickSample sample = pattern.samples[at];
            RigSample input = pattern.inputs[at];
            sample.tick = input.tick = tick;
            if (at >= 3000 && at < 8000) sample.hand[1].flags |= hand_energy;
            recorder.append(input);
            recorder.append(sample);
            append_events(recorder, tick, at);
        }
        recorder.append(Event{3'599'999, EventKind::completed, 255, -1, 0, 0});
        database::AttemptResult result;
        result.state = AttemptState::completed;
        result.duration_s = result.wall_s = 3600;
        result.state_hash = "00ff";
        recorder.finish(result);
        attempt = recorder.attempt_id();
    }
    static void append_events(database::Recorder& recorder, std::uint32_t tick, std::uint32_t at) {
        const auto happens = [&](EventKind kind, int hand, int detail, float value) {
            recorder.append(Event{tick, kind, static_cast<std::uint8_t>(hand), -1, detail, value});
        };
        if (tick == 1) happens(EventKind::first_movement, 255, 0, 0);
        if (at == 1000) happens(EventKind::slip, 0, 0, 0);
        if (at == 2000) happens(EventKind::cut_begin, 1, 0, 0.010F);
        if (at > 2000 && at < 2900 && at % 100 == 0) {
            happens(EventKind::cut_advance, 1, 0, 0.010F + 1e-6F * static_cast<float>(at - 2000));
            happens(EventKind::cut_traction, 1, 1000, 8.0F + 0.01F * static_cast<float>(at - 2000));
        }
        if (at == 2900) happens(EventKind::cut_end, 1, 0, 0.0109F);
        if (at == 8000) happens(EventKind::heat_area, 255, 0, 1e-4F * static_cast<float>(tick));
    }
};
/// Made when it is asked for first; main() deletes it, while the application is there.
inline std::unique_ptr<HourOnPage>& kept_hour_on_page() {
    static std::unique_ptr<HourOnPage> made;
    return made;
}
inline HourOnPage& hour_on_page() {
    if (!kept_hour_on_page()) kept_hour_on_page() = std::make_unique<HourOnPage>();
    return *kept_hour_on_page();
}

/// Until `there`; false where that takes longer than two minutes.
template <typename Condition>
bool wait_until(const Condition& there) {
    QElapsedTimer waited;
    waited.start();
    QTimer wakes;  // this thread sleeps between events: the work has the processors
    wakes.start(5);
    while (!there() && waited.elapsed() < 120'000)
        QApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents);
    return there();
}

/// The debrief in a window of usual size, scrolled to its replay and charts.
class ShownDebrief {
  public:
    ShownDebrief() : page_(hour_on_page().context) {
        page_.resize(1280, 800);
        page_.show();
    }
    /// Everything that is in view is drawn.
    bool open() {
        page_.open(hour_on_page().attempt, -1);
        if (!wait_until([this] { return page_.has_charts(); })) return false;
        for (int i = 0; i < 3; ++i) QApplication::processEvents();  // laid out
        bring();
        benchmark::DoNotOptimize(page_.grab());
        for (const char* name : {"force_chart", "speed_chart", "traction_chart", "energy_chart"})
            if (chart(name) == nullptr || chart(name)->isHidden()) return false;
        return true;
    }
    /// The record for the replay, which is read after the charts.
    bool complete() {
        return wait_until([this] { return page_.is_ready(); });
    }
    void close() { page_.leave(); }
    TimeChart* chart(const char* name) { return page_.findChild<TimeChart*>(QString::fromLatin1(name)); }
    /// All four charts, on the screen.
    void draw() {
        QApplication::sendPostedEvents();
        benchmark::DoNotOptimize(chart("force_chart")->parentWidget()->grab());
    }

  private:
    void bring() {
        auto* block = page_.findChild<QWidget*>(QStringLiteral("replay_block"));
        for (QWidget* above = block->parentWidget(); above != nullptr; above = above->parentWidget())
            if (auto* area = qobject_cast<QScrollArea*>(above)) area->ensureWidgetVisible(block, 0, 8);
    }
    DebriefPage page_;
};

/// One notch of the wheel over a chart: 24 in, then 24 out again.
inline void turn_wheel(TimeChart& chart, int step) {
    const QPointF middle(0.4 * chart.viewport()->width(), 0.5 * chart.viewport()->height());
    QWheelEvent notch(middle, chart.viewport()->mapToGlobal(middle.toPoint()), QPoint(),
                      QPoint(0, step % 48 < 24 ? 120 : -120), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase,
                      false);
    QApplication::sendEvent(chart.viewport(), &notch);
}

/// A drag by a few pixels, as one movement of the mouse makes it; to and fro.
inline void drag(TimeChart& chart, int step) {
    const QPointF from(0.5 * chart.viewport()->width(), 0.5 * chart.viewport()->height()),
        to = from + QPointF(step / 60 % 2 == 0 ? -12 : 12, 0);
    QMouseEvent press(QEvent::MouseButtonPress, from, Qt::LeftButton, Qt::LeftButton, Qt::NoModifier),
        move(QEvent::MouseMove, to, Qt::NoButton, Qt::LeftButton, Qt::NoModifier),
        release(QEvent::MouseButtonRelease, to, Qt::LeftButton, Qt::NoButton, Qt::NoModifier);
    for (QMouseEvent* event : {&press, &move, &release}) QApplication::sendEvent(chart.viewport(), event);
}

}  // namespace fulcrum::ui
