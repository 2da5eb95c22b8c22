// SPDX-License-Identifier: GPL-3.0-or-later
// The program's own window with its services, threads, world, recorder and store, and functions that use it.
#pragma once

#include <gtest/gtest.h>

#include <QLabel>
#include <QTemporaryDir>

#include "database/records/attempts.h"
#include "tests/app/forwarding_services.h"
#include "tests/ui/hands.h"
#include "ui/review/debrief_page.h"
#include "ui/shell/main_window.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/theatre_page.h"
#include "ui/theatre/theatre_view.h"

namespace fulcrum::app::program_test {

/// Passes on the readings of the hands' device and simulates its faults.
class SpoiltRig : public Rig {
  public:
    enum class Fault { none, not_a_number, jump, silence };
    explicit SpoiltRig(std::shared_ptr<Rig> rig) : rig_(std::move(rig)) {}
    void spoil(Fault fault) { fault_.store(fault); }
    /// m, added to the left handle: simulates a device that was moved.
    void displace(double along) { displaced_.store(along); }
    void read(std::uint32_t tick, RigSample& sample) override;
    void write_force(Hand hand, const Vector3& force) override;
    bool has_force(Hand) const override { return true; }
    double damping(Hand) const override { return 0.5; }
    std::optional<ForceOutput> force_output(Hand) const override {
        ForceOutput output;
        output.damping = 0.5;
        output.scale = 0.4;
        return output;
    }
    double sent(Hand hand) const { return sent_[static_cast<int>(hand)].load(); }
    /// m between a hand's handle and its target.
    double behind(Hand hand, const ui::HandTargets& wanted) const;

  private:
    std::shared_ptr<Rig> rig_;
    std::atomic<Fault> fault_{Fault::none};
    std::atomic<double> displaced_{0}, sent_[hand_count] = {{0}, {0}};
    std::atomic<double> handle_[hand_count][3] = {};
    DeviceSample last_;
};

/// The program's services with devices that can be made faulty.
class ServicesWithRig : public ForwardingServices {
  public:
    explicit ServicesWithRig(const std::string& folder) : ForwardingServices(folder) {
        between = [this](std::shared_ptr<Rig> own) -> std::shared_ptr<Rig> {
            if (!spoils_devices) return own;
            rig = std::make_shared<SpoiltRig>(std::move(own));
            return rig;
        };
    }
    bool spoils_devices = false;
    std::shared_ptr<SpoiltRig> rig;  ///< of the latest attempt; null unless spoils_devices
};

class Window : public ::testing::Test {
  protected:
    Window();
    void expect_page(const char* name);
    QString shown(const char* name) { return ui::window_test::find<QLabel>(window, name)->text(); }
    void create_programme();
    /// Returns the one-time password.
    QString add_person(const QString& name, const QString& login, const char* role);
    void switch_user();
    void sign_in(const QString& login, const QString& password);
    void first_sign_in(const QString& login, const QString& once, const QString& password);
    /// The programme of Alma, the administrator, with Tara's account; Tara signs in.
    void create_programme_and_trainee();
    /// From the home page through the briefing to the theatre; returns when the attempt runs.
    void start(const char* task, bool assessed);
    ui::TheatrePage& theatre() { return *static_cast<ui::TheatrePage*>(window.current_page()); }
    /// The realignment shown in the picture; `back` is false while none is shown.
    ui::Realignment aligned() { return theatre().view()->realignment().value_or(ui::Realignment()); }
    /// Moves both hands until the attempt has detected a movement.
    void move_hands(int moves);
    void abandon();
    ui::DebriefPage& wait_for_debrief();
    void home();
    database::AttemptSummary newest_attempt();
    /// Replays the stored record in a new engine, from the state that it began with, and expects
    /// bit-identical results.
    void expect_replays(const std::string& attempt_id);

    QTemporaryDir folder;
    ServicesWithRig services;
    ui::MainWindow window;
};

}  // namespace fulcrum::app::program_test
