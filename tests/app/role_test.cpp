// SPDX-License-Identifier: GPL-3.0-or-later
// Which roles may start an attempt in the window, in the services and in the store.
#include "app/live/performance.h"
#include "database/records/recorder.h"
#include "tests/app/window_fixture.h"

namespace fulcrum::app::program_test {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

class Roles : public Window {
  protected:
    /// Whether any page of the rail offers an attempt.
    bool offered() {
        for (const char* rail : {"rail_home", "rail_progress", "rail_attempts", "rail_cohort", "rail_assign",
                                 "rail_people", "rail_station", "rail_audit"}) {
            if (!sees(window, rail)) continue;
            click(window, rail);
            // New widgets appear after the next turn of the event loop.
            wait_until_read(window);
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            for (QAbstractButton* button : window.findChildren<QAbstractButton*>()) {
                if (button->isVisible() &&
                    (button->objectName().startsWith("briefing_") || button->objectName() == "start_attempt"))
                    return true;
            }
        }
        return false;
    }
    /// The requests of the window's Start button and of the recorder.
    void take(bool performs, const char* who) {
        const database::Session& session = window.context().session();
        const LoadedTask loaded = load_task_and_scene("A2");
        AttemptRequest request{session,
                               "A2",
                               true,
                               5,
                               MouseKeyboardInput(loaded.scene).rig(),
                               window_device,
                               "mouse and keyboard",
                               false,
                               nullptr,
                               0,
                               false,
                               {}};
        database::AttemptMeta meta = attempt_meta(loaded, 5, AttemptMode::assessed,
                                                  DeviceClass::mouse_keyboard, "mouse and keyboard", {});
        meta.person_id = session.person_id();
        const auto begin = [&] { services.start_attempt(request); };  // prepared, then closed
        const auto record = [&] { database::Recorder(services.store_path(false), session, meta); };
        if (performs) {
            EXPECT_NO_THROW(begin()) << who;
            EXPECT_NO_THROW(record()) << who;
        } else {
            EXPECT_THROW(begin(), database::AccessDenied) << who;
            EXPECT_THROW(record(), database::AccessDenied) << who;
        }
    }
};

TEST_F(Roles, OnlyTraineesAreOfferedAttemptsAndOnlyTheirAttemptsAreAccepted) {
    create_programme();
    const QString tara_once = add_person("Tara Trainee", "tara", "trainee");
    const QString ed_once = add_person("Ed Educator", "ed", "educator");
    const QString dora_once = add_person("Dora Director", "dora", "director");
    EXPECT_FALSE(offered()) << "administrator";
    take(false, "administrator");
    switch_user();
    first_sign_in("ed", ed_once, "eduard's word");
    expect_page("cohort_page");
    EXPECT_FALSE(offered()) << "educator";
    take(false, "educator");
    switch_user();
    first_sign_in("dora", dora_once, "dora's password");
    expect_page("dashboard_page");
    EXPECT_FALSE(offered()) << "director";
    take(false, "director");
    switch_user();
    first_sign_in("tara", tara_once, "tara's password");
    expect_page("home_page");
    EXPECT_TRUE(offered()) << "trainee";
    home();
    click(window, "briefing_A2");
    expect_page("briefing_page");
    EXPECT_TRUE(find<QAbstractButton>(window, "start_attempt")->isEnabled());
    take(true, "trainee");
}

}  // namespace
}  // namespace fulcrum::app::program_test
