// SPDX-License-Identifier: GPL-3.0-or-later
// The devices that the window can use for the hands. UI thread.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assessment/attempt/scene_reach.h"
#include "sim_core/controllers/game_controller.h"
#include "sim_core/numerics/name_table.h"
#include "ui/services/attempt_session.h"

namespace fulcrum::ui {

enum class DeviceState : std::uint8_t { usable, connected, absent };
inline constexpr NameRow<DeviceState> device_states[] = {
    {DeviceState::usable, "usable", QT_TRANSLATE_NOOP("fulcrum::device_states", "can be used")},
    {DeviceState::connected, "connected",
     QT_TRANSLATE_NOOP("fulcrum::device_states", "connected, cannot be used")},
    {DeviceState::absent, "absent", QT_TRANSLATE_NOOP("fulcrum::device_states", "not connected")}};
static_assert(in_order(device_states));

/// A kind of device on this machine: one line of `fulcrum devices` and of the page of settings.
struct ListedDevice {
    std::string kind, title;  ///< texts in English, see device_words()
    DeviceClass device_class = DeviceClass::haptic;
    DeviceState state = DeviceState::absent;
    std::vector<std::string> found;       ///< what is connected
    std::string why, what_to_do;          ///< empty where it can be used
    std::string detail = {};              ///< of why: what the system says, in no language
    bool can_be_chosen = true;            ///< for the hands, on the page of settings
    bool needs_calibration = false;       ///< nothing else keeps it from being used
    std::vector<std::string> rules = {};  ///< udev rules with which a person may open it
};

/// Why attempts with a device are never assessed.
enum class PracticeOnly : std::uint8_t {
    no,
    scripted,  ///< no person moves it
    no_limits  ///< no limits exist for it; those of its class, made with less, are a guide
};
/// Stored with attempts.
inline constexpr const char* two_mice_title =
    QT_TRANSLATE_NOOP("fulcrum::device_list", "two mice and keyboard");

/// What the clutch of a device that the daemon reads is.
enum class ClutchButton : std::uint8_t {
    none,
    own,    ///< a button of its own
    energy  ///< the button for energy, which is not the pedal
};
inline constexpr int pedal_of_each_hand = -2;  ///< see SlotChoice

/// What the next attempt is made with.
struct DeviceInUse {
    DeviceClass device_class = window_device;
    std::string title = "mouse and keyboard";  ///< stored with the attempt
    PracticeOnly practice_only = PracticeOnly::no;
    bool virtual_mice = false;  ///< two pointers of the X server, for tests
    bool two_mice = false;      ///< the window reads one mouse for each hand
    std::string kind;           ///< of a device with a driver of its own, "virtual"; else empty
    /// Left, right, scope: what a device that the daemon reads moves; known once it is open.
    bool drives[hand_count + 1] = {false, false, false};
    ClutchButton clutch = ClutchButton::none;  ///< of what it moves
    int pedal = pedal_of_each_hand;            ///< SlotChoice::pedal
};

/// The newest readings of a device that is open.
struct DeviceReadings {
    struct Slot {
        const char* name = "";  ///< "left", "right", "scope"
        bool present = false;   ///< it answered
        Vector3 position = Vector3::Zero();
        double jaw = 0;  ///< share of the opening
        std::uint32_t buttons = 0;
        std::optional<WorkspaceBox> workspace = {};  ///< device frame; none: not known
        bool clutch = false;                         ///< one of its buttons is the clutch
    };
    std::vector<Slot> held;
    double rate = 0;           ///< Hz, since the call before
    double worst_delay = -1;   ///< s, longest delay of a reading; -1: not measured
    double jitter = -1;        ///< s, standard deviation of the time between two; -1: not measured
    bool gives_force = false;  ///< to at least one hand
    bool needs_calibration = false;
    std::string firmware;                          ///< versions that its library states; empty: none
    std::optional<ControllerReadings> controller;  ///< of a game controller, which has no slots
};

/// A guided calibration: what to do now, and after its end what came out.
struct CalibrationState {
    bool runs = false;
    int step = 0, steps = 0;    ///< from 1
    Sentence what_to_do, seen;  ///< what is read now; may be empty
    bool ready = false;         ///< what the step asks for was seen
    bool can_skip = false;      ///< the step may be left out
    Sentence result;            ///< after the end
    bool good = false;          ///< it was stored
};

/// The force test while it runs, and what came out.
struct ForceTestState {
    bool runs = false;
    const char* hand = "";     ///< "left", "right"
    int axis = 0;              ///< 0 to the right, 1 up, 2 towards the person
    double asked = 0;          ///< N, now
    double largest_asked = 0;  ///< N, so far
    double rendered = 0;       ///< N, largest that the device reported to have rendered
    double progress = 0;       ///< 0 to 1
};

/// What gives energy, apart from the key of the pedal: pedal_of_each_hand is the button of the part that
/// moves the hand.
inline constexpr int pedal_keys_only = -1;

/// Which part of a device moves what; -1: mouse and keyboard.
struct SlotChoice {
    int left = 0, right = 1, scope = 2;
    int pedal = pedal_of_each_hand;  ///< or the part whose button is the pedal for both hands
};
inline bool operator==(const SlotChoice& a, const SlotChoice& b) {
    return a.left == b.left && a.right == b.right && a.scope == b.scope && a.pedal == b.pedal;
}

/// Movement of an instrument over that of its device.
inline constexpr double least_motion_scale = 0.5, largest_motion_scale = 2;

/// Share of the model's force that a device may render: at least this, at most 1.
inline constexpr double least_force_scale = 0.1;

/// Whether attempts are sent to other programs over OpenIGTLink.
struct SendingState {
    bool wanted = false;
    bool fixed = false;            ///< an environment variable says so
    std::string address;           ///< where they connect; empty while it is off, or cannot be served
    bool other_computers = false;  ///< can connect there
    std::size_t clients = 0;
    std::size_t dropped = 0;  ///< connections closed because of what the other side did
    Sentence trouble;         ///< why it cannot be served, and what to do
};

class DeviceService {
  public:
    virtual ~DeviceService() = default;
    virtual DeviceInUse device_in_use() const { return {}; }
    /// The hands of an attempt in `scene`: the device in use, opened where it is not, and `others` (mouse and
    /// keyboard) for what it does not have. Throws InputError where it does not open.
    virtual std::shared_ptr<Rig> hands(const Scene& /*scene*/, std::shared_ptr<Rig> others) { return others; }
    /// The game controller that moves the hands, opened where it is not; null where another device does.
    /// Throws InputError where none opens.
    virtual std::shared_ptr<GameController> game_controller() { return nullptr; }
    /// Whether controllers rumble on contact and on too much force; remembered.
    virtual bool rumble_wanted() const { return true; }
    virtual void set_rumble_wanted(bool /*wanted*/) {}
    /// What is wrong with the device in use and what to do; empty while nothing is.
    virtual Sentence device_trouble() { return {}; }
    virtual SendingState sending() const { return {}; }
    /// Remembered; from the next attempt on.
    virtual void choose_sending(bool /*wanted*/) {}
    /// The devices of this machine. The function that is returned does the work and may run on any thread.
    virtual std::function<std::vector<ListedDevice>()> list_devices() {
        return [] { return std::vector<ListedDevice>(); };
    }
    /// Opens the device in use without an attempt. Throws InputError.
    virtual void open_device() {}
    /// From now on attempts use the device of this kind (of list_devices()); remembered.
    virtual void choose_device(const std::string& /*kind*/) {}
    /// Whether choose_device() has an effect: an environment variable does not name the device.
    virtual bool device_can_be_chosen() const { return false; }
    /// For attempts that begin afterwards, with devices of this kind ("": mouse); remembered.
    /// Where the handles of a task have to go, from where the instruments begin. The function that is
    /// returned builds the scene and may run on any thread; it throws InputError.
    virtual std::function<SceneReach()> scene_reach(const std::string& /*task_id*/) {
        return [] { return SceneReach(); };
    }
    /// Of devices of this kind there is something to calibrate.
    virtual bool can_calibrate(const std::string& /*kind*/) const { return false; }
    /// When it was calibrated last (local time, "2026-11-26 10:30"); empty: never, or not by this program.
    virtual std::string calibrated_at(const std::string& /*kind*/) const { return {}; }
    /// Of the device in use; `hand`: 0 left, 1 right, where each hand is calibrated by itself. Throws
    /// InputError.
    virtual void start_calibration(int /*hand*/) {}
    /// To be asked about 30 times a second while it runs.
    virtual CalibrationState calibration() { return {}; }
    /// The person did what the step asks for.
    virtual void calibration_next() {}
    virtual void calibration_skip() {}
    virtual void stop_calibration() {}
    virtual double motion_scale(const std::string& /*kind*/) const { return 1; }
    /// An attempt with devices of this kind begins when the handle is where the scene is in the middle of its
    /// workspace; remembered.
    virtual bool begins_at_ring(const std::string& /*kind*/) const { return false; }
    virtual void set_begins_at_ring(const std::string& /*kind*/, bool /*wanted*/) {}
    virtual void set_motion_scale(const std::string& /*kind*/, double /*scale*/) {}
    virtual SlotChoice slot_choice(const std::string& /*kind*/) const { return {}; }
    virtual void set_slot_choice(const std::string& /*kind*/, const SlotChoice& /*choice*/) {}
    /// Gives the hands of the open device a force that rises slowly, to 0.1 N and then to 0.3 N, along each
    /// axis in turn. False where it cannot.
    virtual bool start_force_test() { return false; }
    virtual void stop_force_test() {}
    virtual ForceTestState force_test() { return {}; }
    /// Nothing while the device in use is not open: an attempt or open_device() opens it. Does not wait.
    virtual std::optional<DeviceReadings> device_readings() { return std::nullopt; }
    /// For attempts that begin afterwards, with devices of this kind; remembered. 1 unless it was set.
    virtual double force_scale(const std::string& /*kind*/) const { return 1; }
    virtual void set_force_scale(const std::string& /*kind*/, double /*scale*/) {}
};

}  // namespace fulcrum::ui
