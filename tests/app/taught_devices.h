// SPDX-License-Identifier: GPL-3.0-or-later
// Each kind of device with which a trainee does the first steps of the theatre and then works: mouse and
// keyboard, two mice, a game controller, and the fakes of what fulcrum-hapticd reads.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "tests/app/input_watch.h"
#include "tests/app/window_fixture.h"
#include "tests/app/working_hand.h"
#include "ui/theatre/hand_deeds.h"

namespace fulcrum::app::program_test {

/// It sets the variables that lead the program to it: make it before the services.
class Taught {
  public:
    virtual ~Taught() = default;
    /// Does what a line of the first steps asks for; called again until the deed is done. False: the device
    /// cannot do it.
    virtual bool work(ui::HandDeed deed, ui::TheatreView& view) = 0;
    /// Lets go.
    virtual void rest(ui::TheatreView& view) = 0;
    /// Performs what `mind` wants with it.
    virtual std::unique_ptr<Worker> worker(ui::TheatrePage& theatre, ObservingRig& mind) = 0;
    std::string title;             ///< in results
    std::string model;             ///< in what an attempt keeps of its device
    std::string strip;             ///< in the first line of the first steps
    bool one_after_other = false;  ///< both hands are not moved at the same time
    bool clutch = false;
    InputWatch::MouseButtons buttons = InputWatch::MouseButtons::of_events;
};

/// "Mouse", "TwoMice", "Controller" (of the fake of SDL 2), "ControllerOfSdl" (a virtual one of SDL 2
/// itself; null where it has none), and each of held_kinds().
std::unique_ptr<Taught> make_taught(const std::string& kind);

struct WithTaught {
    std::unique_ptr<Taught> taught;
};

/// The window, with a device that is there before its services are.
class TaughtWindow : public WithTaught, public Window {
  protected:
    explicit TaughtWindow(std::unique_ptr<Taught> device) : WithTaught{std::move(device)} {}
    QString strip();
    /// Lines are still taught, not only shown.
    bool learns() { return ui::window_test::sees(window, "theatre_keys") && strip().contains("Enter"); }
    /// Every line that the attempt's scene and the device need, until all are marked. What the device cannot
    /// do is done with the keys that the lines name.
    void do_first_steps();
    int lines_done_ = 0;

  private:
    bool done(ui::HandDeed deed) { return theatre().deeds().test(ui::bit_of(deed)); }
    void do_one(ui::HandDeed deed);
};

}  // namespace fulcrum::app::program_test
