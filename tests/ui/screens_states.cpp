// SPDX-License-Identifier: GPL-3.0-or-later
// Screens of visit() that no entry of the rail leads to: a page in another state, and those before a sign-in.
#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <filesystem>
#include <fstream>

#include "sim_core/devices/device_table.h"
#include "tests/ui/screens.h"
#include "ui/shell/idle_watch.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::ui::window_test {
namespace {

/// A store of which the header is garbage.
void copy_damaged_store(const std::string& from, const std::string& to) {
    std::filesystem::copy_file(from, to);
    std::fstream file(to, std::ios::in | std::ios::out | std::ios::binary);
    file.write(std::string(200, '\x5a').data(), 200);
}

}  // namespace

void Screens::use_touch() {
    services.in_use.kind = "touch";
    services.in_use.title = device_row("touch")->title;
    services.in_use.device_class = DeviceClass::haptic;
    DeviceReadings now;
    now.rate = 1000;
    now.worst_delay = 0.4e-3;
    now.jitter = 0.05e-3;
    now.gives_force = true;
    now.held = {{"left", true, Vector3::Zero(), 1, 0}, {"right", true, Vector3::Zero(), 1, 0}};
    for (DeviceReadings::Slot& slot : now.held)
        slot.workspace = WorkspaceBox{Vector3(-0.08, -0.06, -0.035), Vector3(0.08, 0.06, 0.035)};
    services.reach[0] = services.reach[1] =
        WorkspaceBox{Vector3(-0.05, 0, -0.04), Vector3(0.05, 0.05, 0.055)};
    services.readings_when_open = now;
}

void Screens::visit_device(const QString& who, const Look& look) {
    use_touch();
    go_to("rail_settings");
    bring(*find<QPushButton>(*window, "open_device"));
    click(*window, "open_device");
    EXPECT_TRUE(wait_for([&] { return sees(*window, "frame_check") && sees(*window, "reach_lines"); }));
    // What is reached is read in the background, and makes the page longer.
    EXPECT_TRUE(wait_for([&] {
        return find<QLabel>(*window, "reach_lines")
            ->text()
            .contains(QLatin1String("ring"), Qt::CaseInsensitive);
    }));
    settle();
    bring(*find<QWidget>(*window, "frame_check"));
    look(who + "-settings-device");

    services.calibrating.steps = 6;
    services.calibrating.what_to_do =
        "Hold the instrument straight away from you, half way in, its jaws open, and keep it still.";
    services.calibrating.seen = "It moves.";
    services.calibrating.ready = services.calibrating.can_skip = true;
    bring(*find<QPushButton>(*window, "calibrate"));
    click(*window, "calibrate");
    EXPECT_TRUE(wait_for([&] { return sees(*window, "calibration_next"); }));
    settle();
    bring(*find<QWidget>(*window, "calibration_cancel"));
    look(who + "-settings-calibration");

    go_to("rail_password");  // which ends the calibration
    services.in_use = {};
    services.reach = {};
    services.readings.reset();
    services.readings_when_open.reset();
}

void Screens::visit_lock(const Look& look) {
    QMetaObject::invokeMethod(window->findChild<IdleWatch*>(), "lock");
    EXPECT_TRUE(sees(*window, "unlock"));
    settle();
    look("lock");
    type(*window, "unlock_password", "a long password");
    click(*window, "unlock");
    EXPECT_TRUE(wait_for([&] { return !sees(*window, "unlock"); }));
    settle();
}

void Screens::theatre(const std::function<void()>& look) {
    emit window->context().attempt_wanted("A2", false, 0, false);
    auto* page = static_cast<TheatrePage*>(window->current_page());
    services.control.ticks_per_update = 1;
    EXPECT_TRUE(wait_for([&] { return page->view()->pictures() > 2; }));
    look();
    emit window->context().home_wanted();
    settle();
}

void Screens::visit_theatre(const QString& screen, const Look& look) {
    emit window->context().attempt_wanted("A2", false, 0, false);
    auto* page = static_cast<TheatrePage*>(window->current_page());
    const auto runs = [&] { return page->session()->phase() == AttemptPhase::running; };
    services.control.ticks_per_update = 1;
    EXPECT_TRUE(wait_for([&] { return page->view()->pictures() > 2 && runs(); }));
    look(screen);

    QTest::keyClick(page->view(), Qt::Key_Escape);
    EXPECT_TRUE(wait_for([&] { return sees(*window, "panel_resume"); }));
    settle();
    look(screen + "-paused");
    click(*window, "panel_resume");
    EXPECT_TRUE(wait_for(runs));

    services.trouble = words_of(DeviceFault::no_answer);
    services.control.drop_device = true;
    EXPECT_TRUE(wait_for([&] { return sees(*window, "panel_resume"); }));
    settle();
    look(screen + "-device-lost");

    Realignment back;
    back.back = true;
    for (int hand = 0; hand < hand_count; ++hand) {
        Realignment::OneHand& one = back.hand[hand];
        one.exists = true;
        one.distance = 0.012;
        one.angle = 0.2;
        one.device = page->session()->snapshot().tools[hand];
        one.device.tip.x() += one.distance;
    }
    services.control.realignment = back;
    EXPECT_TRUE(wait_for([&] { return page->view()->realignment().has_value(); }));
    settle();
    look(screen + "-realignment");
    services.trouble = {};
    emit window->context().home_wanted();
    settle();
}

void Screens::visit_rating(const QString& screen, const Look& look) {
    bring(*find<QPushButton>(*window, "rating_begin"));
    click(*window, "rating_begin");
    settle();
    bring(*find<QWidget>(*window, "rating_remark"));
    look(screen);
    click(*window, "rating_discard");  // asks
    click(*window, "rating_discard_sure");
    settle();
}

void Screens::visit_first_pages(const Look& look) {
    const QTemporaryDir folder;
    const std::string backup = plain(folder.filePath("monday.db")),
                      store = plain(folder.filePath("programme.db"));
    services.store()->backup(sessions.at(Role::administrator), backup);
    copy_damaged_store(backup, store);
    services.choose_store(store);
    window->start();
    EXPECT_EQ(window->current_page()->objectName(), "repair_page");
    EXPECT_TRUE(wait_for([&] { return sees(*window, "found_backups"); }));
    click(*window, "put_aside");  // asks
    settle();
    look("repair");
    click(*window, "put_aside_confirm");
    click(*window, "close_message");
    settle();
    EXPECT_EQ(window->current_page()->objectName(), "first_start_page");
    look("first-start");
    click(*window, "create_programme");
    settle();
    look("create-programme");
    click(*window, "create_back");
    click(*window, "join_programme");
    settle();
    look("join-programme");
    click(*window, "join_back");
    services.choose_store({});
    window->start();
    settle();
    EXPECT_EQ(window->current_page()->objectName(), "sign_in_page");
}

}  // namespace fulcrum::ui::window_test
