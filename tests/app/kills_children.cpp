// SPDX-License-Identifier: GPL-3.0-or-later
// The programs that the tests kill.
#include <QCoreApplication>
#include <chrono>
#include <random>
#include <thread>

#include "app/live/live_attempt.h"
#include "assessment/operators/operator.h"
#include "database/records/people.h"
#include "tests/app/counters.h"
#include "tests/app/forwarding_services.h"
#include "tests/ui/hands.h"
#include "ui/shell/main_window.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::app::program_test {
namespace {

class CountingOperator : public CountingRig<ObservingRig> {
  public:
    using CountingRig::CountingRig;
    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        rig_->observe(world, display);
    }
};

/// Ends the child; the parent reports that it ended by itself.
void need(bool condition, const char* what) {
    if (condition) return;
    std::fprintf(stderr, "the window did not reach: %s\n", what);
    std::_Exit(3);
}

}  // namespace

int perform_until_killed(const char* folder, const char* counters_path, unsigned long seed) {
    Counters* counters = map_counters(counters_path);
    if (counters == nullptr) return 1;
    const std::string store_path = std::string(folder) + "/fulcrum.db";
    std::mt19937_64 random(seed);
    const database::Store store = database::Store::open(store_path);
    const database::Session station = store.station_session();
    const database::Person person =
        database::People(store).ensure_synthetic(station, "expert", "Synthetic expert");
    const LoadedTask loaded = load_task_and_scene("A2");
    const Limits limits = limits_for(loaded.task, loaded.scene, DeviceClass::synthetic);
    for (std::uint64_t number = 0;; ++number) {
        LiveRequest request;
        request.loaded = loaded;
        request.seed = 5000 + seed * 100 + number;
        request.rig = std::make_shared<CountingOperator>(
            make_operator(OperatorLevel::expert, loaded.task, loaded.scene, request.seed), *counters);
        request.store_path = store_path;
        request.session = station;
        request.meta = attempt_meta(loaded, request.seed, AttemptMode::assessed, DeviceClass::synthetic,
                                    "synthetic operator", limits);
        request.meta.person_id = person.id;
        request.limits = limits;
        counters->ticks.store(0);
        LiveAttempt attempt(std::move(request));
        attempt.start();
        std::this_thread::sleep_for(std::chrono::milliseconds(300 + random() % 1500));
        attempt.abandon();
        attempt.wait();
        attempt.rethrow();
        counters->finished.fetch_add(1);
    }
}

int use_window_until_killed(const char* folder, const char* counters_path, unsigned long seed) {
    using namespace ui;
    using namespace ui::window_test;
    Counters* counters = map_counters(counters_path);
    if (counters == nullptr) return 1;
    std::mt19937_64 random(seed);
    ForwardingServices services(folder);
    services.between = [&](std::shared_ptr<Rig> hands) {
        return std::make_shared<CountingRig<Rig>>(std::move(hands), *counters);
    };
    MainWindow window(services);
    window.resize(1280, 800);
    window.show();
    need(QTest::qWaitForWindowExposed(&window), "the screen");
    window.activateWindow();
    window.start();
    const auto on = [&](const char* page) {
        return wait_for([&] { return window.current_page()->objectName() == QLatin1String(page); }, 120000);
    };
    need(on("sign_in_page"), "the sign-in");
    type(window, "login", QString::fromLatin1(trainee_login));
    type(window, "password", QString::fromLatin1(trainee_password));
    QTest::keyClick(find<QLineEdit>(window, "password"), Qt::Key_Return);
    for (;;) {
        need(on("home_page"), "home");
        counters->ticks.store(0);
        click(window, "briefing_A2");
        need(on("briefing_page"), "the briefing");
        check(window, "mode_assessed");
        click(window, "start_attempt");
        need(on("theatre_page"), "the theatre");
        auto* theatre = static_cast<TheatrePage*>(window.current_page());
        need(wait_for([&] { return theatre->session()->phase() == AttemptPhase::running; }, 120000),
             "an attempt that runs");
        const auto moves = static_cast<int>(5 + random() % 60);
        for (int i = 0; i < moves; ++i) {
            QTest::mouseMove(theatre->view(),
                             theatre->view()->rect().center() + QPoint(5 * (i % 24), -3 * (i % 24)));
            QTest::qWait(20);
        }
        click(window, "theatre_abandon");
        click(window, "panel_abandon");
        need(on("debrief_page"), "the debrief");  // which opens once the score is stored
        counters->finished.fetch_add(1);
        click(window, "rail_home");
    }
}

}  // namespace fulcrum::app::program_test
