// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/app/window_fixture.h"

#include <limits>

#include "app/live/performance.h"
#include "assessment/attempt/engine_state.h"
#include "database/records/people.h"

namespace fulcrum::app::program_test {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

void SpoiltRig::read(std::uint32_t tick, RigSample& sample) {
    rig_->read(tick, sample);
    for (int h = 0; h < hand_count; ++h) {
        for (int i = 0; i < 3; ++i) handle_[h][i].store(device_length_unit * sample.hand[h].handle[i]);
    }
    DeviceReading reading;
    const DeviceSample& whole = sample.hand[0];
    reading.handle = device_length_unit * Vector3(whole.handle[0], whole.handle[1], whole.handle[2]);
    reading.roll = device_angle_unit * whole.roll;
    reading.jaw = device_angle_unit * whole.jaw;
    reading.grip = device_force_unit * whole.grip;
    reading.buttons = whole.buttons;
    const double outside = reading.handle.norm();
    reading.handle *= (outside + displaced_.load()) / outside;
    const Fault fault = fault_.load();
    if (fault == Fault::not_a_number) reading.handle.y() = std::numeric_limits<double>::quiet_NaN();
    if (fault == Fault::jump) reading.handle.x() += 1.0;
    reading.present = fault != Fault::silence;
    last_ = sample.hand[0] = quantise(reading, last_);
}

double SpoiltRig::behind(Hand hand, const HandTargets& wanted) const {
    const auto h = static_cast<int>(hand);
    return (Vector3(handle_[h][0].load(), handle_[h][1].load(), handle_[h][2].load()) - wanted.hand[h].handle)
        .norm();
}

void SpoiltRig::write_force(Hand hand, const Vector3& force) {
    sent_[static_cast<int>(hand)].store(force.norm());
}

Window::Window() : services(folder.path().toStdString()), window(services) {
    window.resize(1024, 768);  // each picture is drawn by the processor
    window.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
    window.activateWindow();
    window.start();
}

void Window::expect_page(const char* name) {
    EXPECT_TRUE(wait_for([&] { return window.current_page()->objectName() == QLatin1String(name); }, 60000))
        << name << ", not " << window.current_page()->objectName().toStdString();
}

void Window::create_programme() {
    expect_page("first_start_page");
    click(window, "create_programme");
    type_programme(window);
    click(window, "create_confirm");
    ASSERT_TRUE(wait_for([&] { return sees(window, "recovery_code"); }));
    check(window, "code_noted");
    click(window, "code_continue");
    expect_page("people_page");
}

QString Window::add_person(const QString& name, const QString& login, const char* role) {
    type(window, "new_person_name", name);
    type(window, "new_person_login", login);
    for (const char* one : {"trainee", "educator", "director", "administrator"}) {
        check(window, qPrintable(QStringLiteral("new_role_") + QLatin1String(one)),
              QLatin1String(one) == QLatin1String(role));
    }
    click(window, "add_person");
    return find<QLabel>(window, "one_time_password")->property("password").toString();
}

void Window::switch_user() {
    click(window, "switch_user");
    expect_page("sign_in_page");
}

void Window::sign_in(const QString& login, const QString& password) {
    type(window, "login", login);
    type(window, "password", password);
    QTest::keyClick(find<QLineEdit>(window, "password"), Qt::Key_Return);
    ASSERT_TRUE(wait_for([&] { return window.context().signed_in(); }));
}

void Window::first_sign_in(const QString& login, const QString& once, const QString& password) {
    sign_in(login, once);
    expect_page("password_page");
    type(window, "old_password", once);
    type(window, "new_password", password);
    type(window, "new_password_again", password);
    click(window, "password_change");
    ASSERT_TRUE(wait_for([&] { return !window.context().session().must_change_password(); }));
}

void Window::create_programme_and_trainee() {
    expect_page("first_start_page");
    {
        // Without the pages, which Journey goes through.
        const database::Store store = database::Store::create(services.store_path(false));
        const database::People people(store);
        const database::Session alma =
            people.create_programme("Department of Surgery", "alma", "Alma Admin", "correct horse")
                .administrator;
        const auto made = people.create(alma, "tara", "Tara Trainee", {database::Role::trainee});
        people.change_password(people.sign_in("tara", made.one_time_password), made.one_time_password,
                               "tara's password");
    }
    window.start();
    expect_page("sign_in_page");
    sign_in("tara", "tara's password");
    expect_page("home_page");
}

void Window::start(const char* task, bool assessed) {
    click(window, qPrintable(QStringLiteral("briefing_") + QLatin1String(task)));
    expect_page("briefing_page");
    check(window, assessed ? "mode_assessed" : "mode_practice");
    click(window, "start_attempt");
    expect_page("theatre_page");
    ASSERT_TRUE(wait_for([&] { return theatre().session()->phase() == AttemptPhase::running; }, 120000));
}

void Window::move_hands(int moves) {
    TheatreView* view = theatre().view();
    const QPoint middle = view->rect().center();
    for (int i = 0; i < moves; ++i) {
        QTest::mouseMove(view, middle + QPoint(5 * (i % 24), -3 * (i % 24)));
        QTest::qWait(25);
    }
    QTest::keyPress(view, Qt::Key_D);
    EXPECT_TRUE(wait_for([&] { return theatre().session()->display().moving_seen; }, 20000));
    QTest::keyRelease(view, Qt::Key_D);
}

void Window::abandon() {
    click(window, "theatre_abandon");
    click(window, "panel_abandon");
    wait_for_debrief();
}

DebriefPage& Window::wait_for_debrief() {
    expect_page("debrief_page");
    auto* debrief = static_cast<DebriefPage*>(window.current_page());
    EXPECT_TRUE(wait_for([&] { return debrief->is_ready(); }, 60000));
    return *debrief;
}

void Window::home() {
    click(window, "rail_home");
    wait_until_read(window);
    expect_page("home_page");
}

database::AttemptSummary Window::newest_attempt() {
    const auto list = database::Attempts(*services.store()).list(window.context().session());
    EXPECT_FALSE(list.empty());
    return list.empty() ? database::AttemptSummary() : list.front();
}

void Window::expect_replays(const std::string& attempt_id) {
    const database::Attempts attempts(*services.store());
    const database::AttemptSummary summary = attempts.read(window.context().session(), attempt_id);
    database::Trace trace = attempts.read_trace(window.context().session(), attempt_id);
    EXPECT_EQ(summary.lost_samples, 0U);
    EXPECT_GT(trace.samples.size(), 200U);
    const std::uint32_t before = summary.meta.origin ? summary.meta.origin->tick : 0;
    for (std::size_t i = 0; i < trace.samples.size(); ++i) ASSERT_EQ(trace.samples[i].tick, before + i + 1);
    EXPECT_FALSE(attempts.scene_text(window.context().session(), attempt_id).empty());
    const LoadedTask loaded = load_recorded(attempts, window.context().session(), summary);
    AttemptEngine engine(loaded.scene, loaded.task, summary.meta.seed);
    if (summary.meta.origin)
        restore_engine(engine, attempts.start_state(window.context().session(), attempt_id));
    const AttemptRecord record{trace.inputs, trace.samples, trace.steps, trace.events,
                               summary.meta.force_devices};
    const ReplayOutcome replay = replay_record(engine, record);
    EXPECT_TRUE(replay.identical) << summary.meta.task_id << " differs from " << replay.first_divergence_s
                                  << " s on";
}

}  // namespace fulcrum::app::program_test
