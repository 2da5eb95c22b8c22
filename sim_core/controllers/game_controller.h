// SPDX-License-Identifier: Apache-2.0
// A game controller for two hands and the scope, read through SDL 2 by a thread of its own every 4 ms. Sticks
// ask for a speed: what they asked for is added up until it is taken, so that the hands move at the same
// speed however seldom the window looks. Sticks, triggers and buttons: docs/DEVICES.md.
//
// All functions may be called from one thread, which is not the reader's. They wait for the reader for no
// longer than it takes to copy its state.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim_core/devices/run_time_library.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum {

/// One that the system reports.
struct ConnectedController {
    std::string name;
    bool known = false;  ///< SDL knows where its sticks and buttons are
};

/// What was asked for since the last call, and what is held now. Left hand or stick first. "s": seconds at
/// full speed.
struct ControllerMotion {
    bool connected = false;
    bool begun[2] = {false, false};  ///< the stick was in its middle since the controller was connected
    double across[2][2] = {};        ///< s; stick: to the right, up
    double along[2] = {};            ///< s; stick with the shoulder button: away from the person
    double turned[2] = {};           ///< s; the same: to the right
    double scope[2] = {};            ///< s; pad: to the right, up
    double scope_along = 0, scope_turned = 0, head_turned = 0;  ///< s; pad with another button
    double trigger[2] = {};                                     ///< 0 to 1, now
    bool pedal[2] = {}, exchange = false;                       ///< held now
    int latches[2] = {}, starts = 0;                            ///< presses
    bool used = false;                                          ///< a hand was there
};

/// How far sticks and triggers of a controller go, as a calibration measured it: a worn one does not reach
/// its ends.
struct ControllerRanges {
    double stick[2][2][2] = {{{-1, 1}, {-1, 1}}, {{-1, 1}, {-1, 1}}};  ///< to the left and right, down and up
    double trigger[2] = {1, 1};
};
/// Every end at least half of the way.
bool is_usable(const ControllerRanges& ranges);

/// The newest state, for a page that shows it.
struct ControllerReadings {
    bool connected = false;
    std::string name;
    double stick[2][2] = {};                           ///< -1 to 1: to the right, up
    double trigger[2] = {};                            ///< 0 to 1
    double raw_stick[2][2] = {}, raw_trigger[2] = {};  ///< without the ranges of a calibration
    std::uint32_t buttons = 0;                         ///< bit: button of SDL
    bool begun[2] = {};                                ///< see ControllerMotion
    bool rumbles = true;                               ///< false: it refused to
    std::uint64_t readings = 0;                        ///< since it was opened
    double rate = 0;                                   ///< Hz, in the last second
    double worst_gap = 0;                              ///< s between two readings, in the last second
};

/// What loading the library gave, and the controllers that are connected.
struct ControllerLook {
    LibraryLook library;
    std::string failure;  ///< SDL did not start, or did not open one: what it said
    std::vector<ConnectedController> connected;
};

class GameController {
  public:
    /// Loads the library and reads the first controller that is connected, or the first of this name. Throws
    /// InputError where there is none, with what to do.
    static std::shared_ptr<GameController> open(const std::string& name = {},
                                                const ControllerRanges& ranges = {});
    /// Any thread. Takes some 10 ms where none is being read.
    static ControllerLook look();
    ~GameController();
    GameController(const GameController&) = delete;
    GameController& operator=(const GameController&) = delete;

    const std::string& name() const { return name_; }
    ControllerMotion take();
    ControllerReadings readings() const;
    /// Strengths of the slow and the fast motor, 0 to 1: an intensity, no force. They stop by themselves half
    /// a second after the last call.
    void rumble(double slow, double fast);
    /// What is wrong with it and what to do; empty while nothing is.
    Sentence trouble() const;

  private:
    struct Shared;
    explicit GameController(std::shared_ptr<Shared> shared, std::string name);
    static void run(const std::shared_ptr<Shared>& shared);
    class Reader;
    static std::weak_ptr<Shared> reading_;
    std::shared_ptr<Shared> shared_;
    std::string name_;
};

}  // namespace fulcrum
