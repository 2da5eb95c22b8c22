// SPDX-License-Identifier: GPL-3.0-or-later
// The window that kills_with_force_test.cpp kills: a trainee presses on the spheres of A2 with a haptic
// device, a fake of its library, in one assessed attempt after another.
#include <QApplication>
#include <algorithm>
#include <random>

#include "assessment/operators/cheats.h"
#include "sim_core/devices/device_page.h"
#include "tests/app/counters.h"
#include "tests/app/forwarding_services.h"
#include "tests/app/posed_hand.h"
#include "tests/fakes/fake_touch.h"
#include "tests/fakes/mapped_page.h"
#include "tests/ui/hands.h"
#include "ui/shell/main_window.h"
#include "ui/theatre/theatre_page.h"

namespace fulcrum::app::program_test {
namespace {

using namespace ui;
using namespace ui::window_test;
constexpr int pressing_patience_ms = 120000;
constexpr double longest_press_s = 15;

/// Ends the child; the parent reports that it ended by itself.
void must_reach(bool condition, const char* what) {
    if (condition) return;
    std::fprintf(stderr, "the pressing window did not reach: %s\n", what);
    std::_Exit(3);
}

class PressingWindow {
  public:
    PressingWindow(const char* folder, Counters& counters, unsigned long seed)
        : counters_(counters), random_(seed), services_(folder), window_((count_ticks(), services_)) {
        window_.resize(1024, 768);
        window_.show();
        must_reach(QTest::qWaitForWindowExposed(&window_), "the screen");
        window_.activateWindow();
        window_.start();
        must_reach(on("sign_in_page"), "the sign-in");
        type(window_, "login", QString::fromLatin1(trainee_login));
        type(window_, "password", QString::fromLatin1(trainee_password));
        QTest::keyClick(find<QLineEdit>(window_, "password"), Qt::Key_Return);
    }
    void one_attempt() {
        must_reach(on("home_page"), "home");
        counters_.ticks.store(0);
        counters_.broken.store(0);
        rest();
        click(window_, "briefing_A2");
        must_reach(on("briefing_page"), "the briefing");
        check(window_, "mode_assessed");
        click(window_, "start_attempt");
        must_reach(on("theatre_page"), "the theatre");
        theatre_ = static_cast<TheatrePage*>(window_.current_page());
        must_reach(wait_for([&] { return theatre_->session()->phase() == AttemptPhase::running; },
                            pressing_patience_ms),
                   "an attempt that runs");
        press();
        if (theatre_->session() != nullptr && theatre_->session()->phase() == AttemptPhase::device_lost)
            counters_.paused.fetch_add(1);
        leave();
        counters_.finished.fetch_add(1);  // the debrief opens once the score is stored
        click(window_, "rail_home");
    }

  private:
    bool on(const char* page) {
        return wait_for([&] { return window_.current_page()->objectName() == QLatin1String(page); },
                        pressing_patience_ms);
    }
    void count_ticks() {
        services_.between = [this](std::shared_ptr<Rig> hands) {
            return std::make_shared<CountingRig<Rig>>(std::move(hands), counters_);
        };
    }
    void put(int hand, const Vector3& position) {
        for (int axis = 0; axis < 3; ++axis)
            device_.get()->device[hand].position[axis] = 1e3 * position[axis];
    }
    void rest() {
        for (int hand = 0; hand < hand_count; ++hand) put(hand, Vector3::Zero());
    }
    /// Notes when a limit of A2 (4 N) that the screen shows as broken stays broken: clearly above it for
    /// longer than the 50 Hz low-pass of the metric remembers.
    void watch_limit(const AttemptSession& session) {
        constexpr float clearly = 4.5F;  // N
        constexpr std::int64_t lasting_ns = 40 * 1'000'000LL;
        const float* const force = session.display().force;
        const std::int64_t now = monotonic_ns();
        if (std::max(force[0], force[1]) <= clearly) above_since_ = now;
        if (counters_.broken.load() == 0 && now - above_since_ > lasting_ns) counters_.broken.store(now);
    }
    /// Until the device is lost or it has had its time; every other attempt presses too hard.
    void press() {
        const Cheat* heavy = nullptr;
        for (const Cheat& one : cheats())
            if (std::string(one.name) == "heavy") heavy = &one;
        const AttemptSession& session = *theatre_->session();
        const TaskDefinition& task = *std::find_if(services_.tasks().begin(), services_.tasks().end(),
                                                   [](const TaskDefinition& one) { return one.id == "A2"; });
        const bool too_hard = random_() % 2 == 0;
        const auto mind = too_hard ? make_cheat(*heavy, task, session.scene(), random_())
                                   : make_operator(OperatorLevel::expert, task, session.scene(), random_());
        above_since_ = monotonic_ns();
        PosedHand hand(*theatre_, *mind, [this](int h, const Vector3& position) { put(h, position); });
        hand.work_until(
            [&] {
                watch_limit(session);
                return session.phase() != AttemptPhase::running ||
                       session.display().elapsed_s > longest_press_s;
            },
            pressing_patience_ms);
    }
    /// Abandons, whether a message is shown or not.
    void leave() {
        const auto clicked = [&](const char* name) {
            for (auto* button : window_.findChildren<QAbstractButton*>(QLatin1String(name))) {
                if (!button->isVisible() || !button->isEnabled()) continue;
                QTest::mouseClick(button, Qt::LeftButton);
                return true;
            }
            return false;
        };
        must_reach(wait_for(
                       [&] {
                           if (window_.current_page()->objectName() == QLatin1String("debrief_page"))
                               return true;
                           if (!clicked("panel_abandon")) clicked("theatre_abandon");
                           return false;
                       },
                       pressing_patience_ms),
                   "the debrief");
    }

    Counters& counters_;
    std::mt19937_64 random_;
    fulcrum::test::MappedPage<fulcrum::test::FakeTouchPage> device_{"FAKE_TOUCH_PAGE"};
    ForwardingServices services_;
    MainWindow window_;
    TheatrePage* theatre_ = nullptr;
    std::int64_t above_since_ = 0;  ///< ns: since then a hand has been above the limit
};

}  // namespace

int press_until_killed(const char* folder, const char* counters_path, unsigned long seed) {
    Counters* counters = map_counters(counters_path);
    if (counters == nullptr) return 1;
    PressingWindow window(folder, *counters, seed);
    for (;;) window.one_attempt();
}

}  // namespace fulcrum::app::program_test
