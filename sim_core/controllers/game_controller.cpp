// SPDX-License-Identifier: Apache-2.0
#include "sim_core/controllers/game_controller.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <thread>

#include "sim_core/controllers/sdl_library.h"
#include "sim_core/controllers/stick_response.h"
#include "sim_core/devices/device_page.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {

using namespace controllers;

namespace {

constexpr std::int64_t millisecond = 1'000'000;
constexpr auto read_every = std::chrono::milliseconds(4);
constexpr std::int64_t look_every = 250 * millisecond, silent_after = 500 * millisecond,
                       rumble_for = 500 * millisecond, rumble_every = 40 * millisecond,
                       longest_step = 100 * millisecond;
constexpr std::uint32_t rumble_ms = 60;  // a little longer than rumble_every
constexpr std::uint32_t parts_used = sdl_init_joystick | sdl_init_controller;
constexpr int opening_ms = 3000;

bool start_sdl(const SdlLibrary& sdl) {
    const std::lock_guard lock(sdl_start());
    sdl.set_hint("SDL_NO_SIGNAL_HANDLERS", "1");
    sdl.set_hint("SDL_JOYSTICK_ALLOW_BACKGROUND_EVENTS", "1");
    // Buttons by their place, whatever is printed on them.
    sdl.set_hint("SDL_GAMECONTROLLER_USE_BUTTON_LABELS", "0");
    return sdl.init(parts_used) == 0;
}

void end_sdl(const SdlLibrary& sdl) {
    const std::lock_guard lock(sdl_start());
    sdl.quit(parts_used);
}

std::string text_of(const char* words) {
    return words != nullptr ? words : "";
}

std::vector<ConnectedController> connected_now(const SdlLibrary& sdl) {
    std::vector<ConnectedController> found;
    for (int i = 0; i < sdl.joystick_count(); ++i) {
        const bool known = sdl.is_controller(i) != 0;
        found.push_back({text_of(known ? sdl.controller_name(i) : sdl.joystick_name(i)), known});
    }
    return found;
}

/// From -1 to 1 between the ends.
double in_range(double value, double least, double most) {
    return std::clamp(value >= 0 ? value / most : -value / least, -1.0, 1.0);
}

double share(std::int16_t axis) {
    return std::clamp(axis / 32767.0, -1.0, 1.0);
}

/// Between SDL's start and end only one thread calls it.
std::mutex sdl_use;

[[noreturn]] void refuse(const Sentence& problem, const Sentence& hint) {
    throw InputError(QT_TRANSLATE_NOOP("errors", "game controller"), "", problem, hint);
}

}  // namespace

struct GameController::Shared {
    SdlLibrary sdl;
    std::string wanted;  // name; empty: any
    ControllerRanges ranges;

    mutable std::mutex mutex;
    std::condition_variable changed;
    bool looked = false, stop = false, ended = false;
    std::string failure;                         // of SDL's start
    std::vector<ConnectedController> connected;  // of the last look
    ControllerReadings now;
    ControllerMotion motion;
    double slow = 0, fast = 0;
    std::int64_t rumble_asked = 0, last_tick = 0;
};

std::weak_ptr<GameController::Shared> GameController::reading_;

/// The reader's thread. Only it calls SDL.
class GameController::Reader {
  public:
    explicit Reader(Shared& shared) : shared_(shared), sdl_(shared.sdl) {}
    ~Reader() { drop(); }

    void tick(std::int64_t now) {
        sdl_.update();
        if (controller_ != nullptr && sdl_.attached(controller_) == 0) drop();
        if (now >= next_look_) {
            next_look_ = now + look_every;
            look(now);
        }
        if (controller_ != nullptr) read(now);
        shake(now);
        const std::lock_guard lock(shared_.mutex);
        shared_.last_tick = monotonic_ns();
        shared_.looked = true;
    }

  private:
    void look(std::int64_t now) {
        const std::vector<ConnectedController> found = connected_now(sdl_);
        const bool reads = controller_ != nullptr;
        for (std::size_t i = 0; i < found.size() && controller_ == nullptr; ++i) {
            if (!found[i].known || (!shared_.wanted.empty() && found[i].name != shared_.wanted)) continue;
            controller_ = sdl_.open(static_cast<int>(i));
            if (controller_ == nullptr) failure_ = text_of(sdl_.error());
            if (controller_ != nullptr) {
                // From now on only this one: another controller is not the same hand.
                shared_.wanted = found[i].name;
                failure_.clear();
            }
        }
        const std::lock_guard lock(shared_.mutex);
        shared_.connected = found;
        shared_.failure = failure_;
        if (reads || controller_ == nullptr) return;
        held_ = 0;
        last_ = now;
        shared_.now = {};
        shared_.now.name = shared_.wanted;
        shared_.now.connected = shared_.motion.connected = true;
        window_begin_ = 0;
    }

    void drop() {
        if (controller_ == nullptr) return;
        sdl_.rumble(controller_, 0, 0, 0);
        sdl_.close(controller_);
        controller_ = nullptr;
        next_look_ = 0;
        const std::lock_guard lock(shared_.mutex);
        shared_.now.connected = false;
        shared_.motion = {};
    }

    void read(std::int64_t now) {
        ControllerReadings newest;
        const int axes[2][2] = {{axis_left_x, axis_left_y}, {axis_right_x, axis_right_y}};
        for (int h = 0; h < 2; ++h) {
            newest.stick[h][0] = share(sdl_.axis(controller_, axes[h][0]));
            newest.stick[h][1] = -share(sdl_.axis(controller_, axes[h][1]));  // SDL counts downwards
            newest.trigger[h] = std::max(0.0, share(sdl_.axis(controller_, axis_left_trigger + h)));
            for (int i = 0; i < 2; ++i) {
                const double(&ends)[2] = shared_.ranges.stick[h][i];
                newest.raw_stick[h][i] = newest.stick[h][i];
                newest.stick[h][i] = in_range(newest.stick[h][i], ends[0], ends[1]);
            }
            newest.raw_trigger[h] = newest.trigger[h];
            newest.trigger[h] = in_range(newest.trigger[h], -1, shared_.ranges.trigger[h]);
        }
        for (int b = 0; b < button_count; ++b)
            if (sdl_.button(controller_, b) != 0) newest.buttons |= 1U << static_cast<unsigned>(b);
        const double dt = 1e-9 * static_cast<double>(std::min(now - last_, longest_step));
        const std::lock_guard lock(shared_.mutex);
        ControllerReadings& shown = shared_.now;
        for (int h = 0; h < 2; ++h) {
            std::copy_n(newest.stick[h], 2, shown.stick[h]);
            std::copy_n(newest.raw_stick[h], 2, shown.raw_stick[h]);
            shown.trigger[h] = newest.trigger[h];
            shown.raw_trigger[h] = newest.raw_trigger[h];
            const double pushed = std::hypot(newest.stick[h][0], newest.stick[h][1]);
            // A stick that is pushed, or stuck, when it is connected moves nothing until it was let go.
            shown.begun[h] = shown.begun[h] || pushed <= stick_dead_zone;
            shared_.motion.begun[h] = shown.begun[h];
        }
        shown.buttons = newest.buttons;
        count(shown, now);
        add(shown, dt);
        held_ = newest.buttons;
        last_ = now;
    }

    void count(ControllerReadings& shown, std::int64_t now) {
        ++shown.readings;
        if (window_begin_ == 0) {
            window_begin_ = now;
            in_window_ = 0;
            worst_ = 0;
            return;
        }
        ++in_window_;
        worst_ = std::max(worst_, now - last_);
        if (now - window_begin_ < 1000 * millisecond) return;
        shown.rate = 1e9 * static_cast<double>(in_window_) / static_cast<double>(now - window_begin_);
        shown.worst_gap = 1e-9 * static_cast<double>(worst_);
        window_begin_ = now;
        in_window_ = 0;
        worst_ = 0;
    }

    /// What is held in this moment, for `dt` seconds.
    void add(const ControllerReadings& now, double dt) {
        ControllerMotion& motion = shared_.motion;
        const auto held = [&now](SdlButton b) { return (now.buttons >> static_cast<unsigned>(b) & 1U) != 0; };
        const auto pressed = [&](SdlButton b) {
            return held(b) && (held_ >> static_cast<unsigned>(b) & 1U) == 0;
        };
        for (int h = 0; h < 2; ++h) {
            const double x = now.stick[h][0], y = now.stick[h][1];
            const bool along = held(h == 0 ? button_left_shoulder : button_right_shoulder);
            motion.trigger[h] = now.trigger[h];
            if (now.trigger[h] > 0.1) motion.used = true;
            if (!now.begun[h]) continue;
            if (along) {
                // One at a time: a thumb that pushes in does not turn.
                const bool turns = std::abs(x) > std::abs(y);
                const double most = turns ? x : y;
                const double done = std::copysign(stick_speed(std::abs(most)), most) * dt;
                (turns ? motion.turned[h] : motion.along[h]) += done;
                motion.used = motion.used || done != 0;
            } else if (const double pushed = std::hypot(x, y); pushed > stick_dead_zone) {
                const double speed = stick_speed(pushed) / pushed * dt;
                motion.across[h][0] += speed * x;
                motion.across[h][1] += speed * y;
                motion.used = true;
            }
        }
        const double right = (held(button_pad_right) ? dt : 0) - (held(button_pad_left) ? dt : 0);
        const double up = (held(button_pad_up) ? dt : 0) - (held(button_pad_down) ? dt : 0);
        if (held(button_back)) {
            motion.head_turned += right;
        } else if (held(button_north)) {
            motion.scope_along += up;
            motion.scope_turned += right;
        } else {
            motion.scope[0] += right;
            motion.scope[1] += up;
        }
        motion.pedal[0] = held(button_west);
        motion.pedal[1] = held(button_east);
        motion.exchange = held(button_south);
        motion.latches[0] += pressed(button_left_stick) ? 1 : 0;
        motion.latches[1] += pressed(button_right_stick) ? 1 : 0;
        motion.starts += pressed(button_start) ? 1 : 0;
        motion.used = motion.used || now.buttons != 0;
    }

    void shake(std::int64_t now) {
        double slow = 0, fast = 0;
        {
            const std::lock_guard lock(shared_.mutex);
            if (shared_.rumble_asked != 0 && now - shared_.rumble_asked < rumble_for) {
                slow = shared_.slow;
                fast = shared_.fast;
            }
        }
        const bool on = slow > 0 || fast > 0;
        const bool changed = slow != slow_ || fast != fast_;
        if (controller_ == nullptr || (!on && !changed) || (!changed && now < next_rumble_)) return;
        slow_ = slow;
        fast_ = fast;
        next_rumble_ = now + rumble_every;
        const auto level = [](double strength) {
            return static_cast<std::uint16_t>(std::lround(65535 * std::clamp(strength, 0.0, 1.0)));
        };
        const bool done = sdl_.rumble(controller_, level(slow), level(fast), on ? rumble_ms : 0) == 0;
        const std::lock_guard lock(shared_.mutex);
        shared_.now.rumbles = done;
    }

    Shared& shared_;
    const SdlLibrary& sdl_;
    SdlController* controller_ = nullptr;
    std::string failure_;
    std::uint32_t held_ = 0;  // buttons of the reading before
    std::int64_t last_ = 0, next_look_ = 0, next_rumble_ = 0, window_begin_ = 0, in_window_ = 0, worst_ = 0;
    double slow_ = 0, fast_ = 0;
};

void GameController::run(const std::shared_ptr<Shared>& shared) {
    const bool started = start_sdl(shared->sdl);
    if (started) {
        shared->sdl.joystick_events(sdl_ignore);
        Reader reader(*shared);
        auto next = std::chrono::steady_clock::now();
        for (bool stop = false; !stop;) {
            reader.tick(monotonic_ns());
            shared->changed.notify_all();
            next = std::max(next + read_every, std::chrono::steady_clock::now() - read_every);
            std::unique_lock lock(shared->mutex);
            shared->changed.wait_until(lock, next, [&] { return shared->stop; });
            stop = shared->stop;
        }
    }
    const std::string why = started ? std::string() : text_of(shared->sdl.error());
    if (started) end_sdl(shared->sdl);
    const std::lock_guard lock(shared->mutex);
    if (!started) shared->failure = why;
    shared->looked = shared->ended = true;
    shared->changed.notify_all();
}

bool is_usable(const ControllerRanges& ranges) {
    bool good = true;
    for (int h = 0; h < 2; ++h) {
        for (const auto& ends : ranges.stick[h])
            good = good && ends[0] >= -1 && ends[0] <= -0.5 && ends[1] >= 0.5 && ends[1] <= 1;
        good = good && ranges.trigger[h] >= 0.5 && ranges.trigger[h] <= 1;
    }
    return good;
}

std::shared_ptr<GameController> GameController::open(const std::string& name,
                                                     const ControllerRanges& ranges) {
    auto shared = std::make_shared<Shared>();
    if (is_usable(ranges)) shared->ranges = ranges;
    const LibraryLook look = shared->sdl.load();
    if (look.state != LibraryState::ready)
        refuse({"%1 (%2)", Sentence(sdl_problem(look.state)), look.detail}, sdl_hint(look.state));
    shared->wanted = name;
    shared->last_tick = monotonic_ns();
    {
        const std::lock_guard alone(sdl_use);
        reading_ = shared;
        std::thread([shared] { run(shared); }).detach();
    }
    std::shared_ptr<GameController> made(new GameController(shared, name));
    std::unique_lock lock(shared->mutex);
    const bool answered =
        shared->changed.wait_for(lock, std::chrono::milliseconds(opening_ms), [&] { return shared->looked; });
    if (shared->now.connected) {
        made->name_ = shared->now.name;
        return made;
    }
    const bool ended = shared->ended;
    const std::string failure = shared->failure;
    const std::vector<ConnectedController> found = shared->connected;
    lock.unlock();
    if (!answered)
        refuse(QT_TRANSLATE_NOOP("errors", "the library SDL 2 does not answer"),
               QT_TRANSLATE_NOOP("errors", "unplug the controller, wait ten seconds and connect it again"));
    if (ended)
        refuse({QT_TRANSLATE_NOOP("errors", "the library SDL 2 does not start: %1"), failure},
               sdl_hint(LibraryState::unusable));
    for (const ConnectedController& one : found) {
        if (!name.empty() && one.name != name) continue;
        if (one.known)
            refuse(
                {QT_TRANSLATE_NOOP("errors", "%1 cannot be opened: %2"), one.name, failure},
                QT_TRANSLATE_NOOP("errors",
                                  "close other programs that use it; on Linux your account needs the right "
                                  "to read /dev/input/event*"));
        refuse({QT_TRANSLATE_NOOP("errors", "SDL does not know the sticks and buttons of %1"), one.name},
               QT_TRANSLATE_NOOP("errors",
                                 "set SDL_GAMECONTROLLERCONFIG to its mapping, or use another controller"));
    }
    if (name.empty())
        refuse(QT_TRANSLATE_NOOP("errors", "none is connected"),
               QT_TRANSLATE_NOOP("errors", "connect one and switch it on, or use mouse and keyboard"));
    refuse({QT_TRANSLATE_NOOP("errors", "none of the name %1 is connected"), name},
           QT_TRANSLATE_NOOP("errors", "connect it and switch it on, or use mouse and keyboard"));
}

GameController::GameController(std::shared_ptr<Shared> shared, std::string name)
    : shared_(std::move(shared)), name_(std::move(name)) {}

GameController::~GameController() {
    std::unique_lock lock(shared_->mutex);
    shared_->stop = true;
    shared_->changed.notify_all();
    // A reader that hangs in the library is left alone; its state lives as long as it does.
    shared_->changed.wait_for(lock, std::chrono::milliseconds(opening_ms), [&] { return shared_->ended; });
}

ControllerMotion GameController::take() {
    const std::lock_guard lock(shared_->mutex);
    ControllerMotion taken = shared_->motion;
    ControllerMotion& left = shared_->motion;
    left = {};
    left.connected = taken.connected;
    std::copy_n(taken.begun, 2, left.begun);
    std::copy_n(taken.trigger, 2, left.trigger);
    std::copy_n(taken.pedal, 2, left.pedal);
    left.exchange = taken.exchange;
    if (monotonic_ns() - shared_->last_tick > silent_after) taken = {};
    return taken;
}

ControllerReadings GameController::readings() const {
    const std::lock_guard lock(shared_->mutex);
    ControllerReadings now = shared_->now;
    if (monotonic_ns() - shared_->last_tick > silent_after) now.connected = false;
    return now;
}

void GameController::rumble(double slow, double fast) {
    const std::lock_guard lock(shared_->mutex);
    shared_->slow = std::isfinite(slow) ? slow : 0;
    shared_->fast = std::isfinite(fast) ? fast : 0;
    shared_->rumble_asked = monotonic_ns();
}

Sentence GameController::trouble() const {
    const std::lock_guard lock(shared_->mutex);
    if (monotonic_ns() - shared_->last_tick > silent_after)
        return {QT_TRANSLATE_NOOP("errors",
                                  "%1 does not answer. Unplug it, wait ten seconds and connect it again."),
                name_};
    if (!shared_->now.connected)
        return {QT_TRANSLATE_NOOP(
                    "errors", "%1 is not connected. Connect it again, switch it on, or charge its battery."),
                name_};
    for (const bool begun : shared_->now.begun)
        if (!begun)
            return {
                QT_TRANSLATE_NOOP("errors",
                                  "A stick of %1 is not in its middle, so it moves nothing. Let go of it; "
                                  "if it stays, connect the controller again without touching it."),
                name_};
    return {};
}

ControllerLook GameController::look() {
    ControllerLook look;
    SdlLibrary sdl;
    look.library = sdl.load();
    if (look.library.state != LibraryState::ready) return look;
    const std::lock_guard alone(sdl_use);
    const std::shared_ptr<Shared> reading = reading_.lock();
    std::unique_lock<std::mutex> lock;
    if (reading != nullptr) lock = std::unique_lock(reading->mutex);
    // One that has ended knows nothing of now.
    if (reading != nullptr && !reading->ended) {
        look.failure = reading->failure;
        look.connected = reading->connected;
        return look;
    }
    if (lock.owns_lock()) lock.unlock();
    if (!start_sdl(sdl)) {
        look.failure = text_of(sdl.error());
        return look;
    }
    sdl.update();
    look.connected = connected_now(sdl);
    end_sdl(sdl);
    return look;
}

}  // namespace fulcrum
