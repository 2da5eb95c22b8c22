// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/haply_device.h"

#include <poll.h>
#include <pthread.h>
#include <sched.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>

#include "sim_core/hapticd/tool_axes.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/worded_error.h"

namespace fulcrum::hapticd {
namespace {

using haply::Understood;
using haply::WebSocket;

constexpr double rate_hz = 1000, full_turn = 6.283185307179586;
constexpr std::int64_t tick_ns = 1'000'000, look_ns = 5'000'000;
constexpr std::int64_t connect_limit_ns = 2000 * tick_ns, answer_limit_ns = 1000 * tick_ns;
constexpr int ask_again_ms = 50;
constexpr double closing_time_s = 0.15, longest_read_s = 0.02;  // a button closes the jaws in 0.15 s
constexpr int priority = 84;                                    // below the loop of the process
// The service states no limits.
constexpr double peak = 4, continuous = 2, stiffness = 500;
// A service that renders another form of the command reports no force.
constexpr double clearly_asked = 0.05, hardly_rendered = 0.005;  // N
constexpr int most_not_rendered = 50;
constexpr const char* hint_of_words =
    QT_TRANSLATE_NOOP("errors",
                      "write haply:PORT, then left=ID, right=ID, events=PORT, grip=+z or axes=+x+z-y, each "
                      "after a comma");

int port_of(const std::string& word, int least) {
    const bool digits =
        !word.empty() && word.size() <= 5 && word.find_first_not_of("0123456789") == std::string::npos;
    const int port = digits ? std::stoi(word) : -1;
    return port >= least && port <= 65535 ? port : -1;
}

[[noreturn]] void refuse_haply_word(const std::string& word) {
    throw InputError("haply", "", {QT_TRANSLATE_NOOP("errors", "'%1' is not known"), word}, hint_of_words);
}

void take_haply_word(HaplySpecification& wanted, const std::string& word) {
    const std::size_t equals = word.find('=');
    const std::string key = word.substr(0, equals);
    const std::string value = equals == std::string::npos ? std::string() : word.substr(equals + 1);
    constexpr const char* hand_keys[] = {"left", "right"};
    for (std::size_t h = 0; h < 2; ++h) {
        if (key != hand_keys[h]) continue;
        if (value.empty()) refuse_haply_word(word);
        wanted.hand[h] = value;
        return;
    }
    if (key == "events" && port_of(value, 0) >= 0) {
        wanted.events_port = port_of(value, 0);
    } else if (key == "grip" && direction_of(value)) {
        wanted.grip = *direction_of(value);
    } else if (const auto axes = axes_of(value); key == "axes" && axes) {
        if (axes->determinant() < 0.5) refuse_haply_word(word);
        wanted.axes = *axes;
    } else {
        refuse_haply_word(word);
    }
}

}  // namespace

HaplySpecification haply_specification(const std::string& specification) {
    HaplySpecification wanted;
    wanted.axes = *axes_of("+x+z-y");
    std::size_t at = specification.find(':');
    bool first = true;
    while (at != std::string::npos) {
        const std::size_t comma = specification.find(',', at + 1);
        const std::string word =
            specification.substr(at + 1, comma == std::string::npos ? comma : comma - at - 1);
        at = comma;
        if (const int port = first ? port_of(word, 1) : -1; port > 0)
            wanted.ports = {port};
        else
            take_haply_word(wanted, word);
        first = false;
    }
    if (wanted.hand[0] && wanted.hand[0] == wanted.hand[1])
        throw InputError("haply", "",
                         {QT_TRANSLATE_NOOP("errors", "'%1' names one device for both hands"), specification},
                         QT_TRANSLATE_NOOP("errors", "give each hand a device of its own"));
    return wanted;
}

HaplyDevice::HaplyDevice(HaplySpecification specification) : wanted_(std::move(specification)) {
    facts_.kind = "haply";
    facts_.title = "Haply Inverse3";
    facts_.rate = rate_hz;
    silent_ = DeviceFault::haply_silent;
}

/// What answers there speaks WebSocket.
bool HaplyDevice::try_port(int port) {
    service_ = std::make_unique<WebSocket>(port);
    const std::int64_t until = monotonic_ns() + connect_limit_ns;
    while (service_->state() == WebSocket::State::connecting && monotonic_ns() < until)
        service_->serve(look_ns);
    return service_->state() == WebSocket::State::open;
}

void HaplyDevice::connect() {
    int failed = 0, answering = 0;
    for (const int port : wanted_.ports) {
        const int error = haply::probe(port);
        if (error == 0) {
            where_ = "127.0.0.1:" + std::to_string(port);
            if (try_port(port)) return;
            if (answering == 0) answering = port;
        } else if (failed == 0) {
            failed = error;
        }
    }
    where_ = "127.0.0.1:" + std::to_string(answering != 0 ? answering : wanted_.ports.front());
    if (answering == 0)
        throw InputError(where_, "",
                         {QT_TRANSLATE_NOOP("errors", "the Inverse service of Haply does not answer: %1"),
                          std::strerror(failed)},
                         QT_TRANSLATE_NOOP("errors",
                                           "install the service from Haply and start it on this computer; "
                                           "haply:PORT names another port"));
    throw InputError(where_, "",
                     QT_TRANSLATE_NOOP("errors", "what answers there is not the Inverse service of Haply"),
                     QT_TRANSLATE_NOOP("errors",
                                       "end the program that listens at this port, or name the port of "
                                       "the service: haply:PORT"));
}

/// Throws InputError where none comes that can be used.
haply::Message HaplyDevice::first_message() {
    const std::int64_t until = monotonic_ns() + answer_limit_ns;
    std::string text;
    haply::Message message;
    Understood what = Understood::yes;
    bool any = false;
    while (!any && service_->state() == WebSocket::State::open && monotonic_ns() < until) {
        service_->serve(look_ns);
        any = service_->take(text);
    }
    if (any) what = haply::read_message(text, message);
    if (any && (what == Understood::yes || what == Understood::not_numbers)) return message;
    if (!any)
        throw InputError(
            where_, "",
            service_->state() == WebSocket::State::open
                ? QT_TRANSLATE_NOOP("errors", "the Inverse service of Haply sends nothing")
                : QT_TRANSLATE_NOOP("errors", "the service closed the connection"),
            QT_TRANSLATE_NOOP("errors", "restart the Inverse service, and end other programs that use it"));
    throw InputError(
        where_, "",
        QT_TRANSLATE_NOOP("errors",
                          "what it sends is not what the Inverse service of Haply sends from version 3.1 on"),
        QT_TRANSLATE_NOOP("errors", "install the newest version of the Inverse service"));
}

void HaplyDevice::choose(const haply::Message& inventory) {
    std::string connected;
    for (const haply::Inverse3& one : inventory.devices)
        connected += (connected.empty() ? "" : ", ") + one.id;
    if (inventory.devices.empty())
        throw InputError(where_, "",
                         QT_TRANSLATE_NOOP("errors", "the Inverse service of Haply reports no Inverse3"),
                         QT_TRANSLATE_NOOP("errors",
                                           "connect the device and its power supply, and wait until the "
                                           "service shows it"));
    std::vector<const haply::Inverse3*> left;
    for (const haply::Inverse3& one : inventory.devices) left.push_back(&one);
    const auto give = [&](std::size_t h, std::size_t index) {
        hands_[h].id = left[index]->id;
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(index));
    };
    const bool named = wanted_.hand[0] || wanted_.hand[1];
    for (std::size_t h = 0; h < 2; ++h) {
        if (!wanted_.hand[h]) continue;
        const auto found = std::find_if(left.begin(), left.end(),
                                        [&](const auto* one) { return one->id == *wanted_.hand[h]; });
        if (found == left.end())
            throw InputError(
                where_, "",
                {QT_TRANSLATE_NOOP("errors", "no Inverse3 with the identity %1 is connected, only %2"),
                 *wanted_.hand[h], connected},
                QT_TRANSLATE_NOOP("errors", "connect it, or name another: haply:left=ID,right=ID"));
        give(h, static_cast<std::size_t>(found - left.begin()));
    }
    constexpr const char* sides[] = {"left", "right"};
    for (std::size_t h = 0; h < 2 && !named; ++h)
        for (std::size_t i = 0; i < left.size() && hands_[h].id.empty(); ++i)
            if (left[i]->handedness == sides[h]) give(h, i);
    for (const std::size_t h : {std::size_t{1}, std::size_t{0}})  // one alone is the right hand's
        if (!named && hands_[h].id.empty() && !left.empty()) give(h, left.size() - 1);
    int grip = 0;
    for (Hand& hand : hands_)
        if (!hand.id.empty() && grip < static_cast<int>(inventory.grips.size())) hand.grip = grip++;
    if (grip > 0) facts_.title += " with VerseGrip";
}

/// The device of a hand that another session of the service uses; empty: none. Before the first command.
std::string HaplyDevice::used_elsewhere(const haply::Message& inventory) const {
    for (const haply::Inverse3& one : inventory.devices)
        for (const Hand& hand : hands_)
            if (one.in_use && one.id == hand.id) return one.id;
    return {};
}

/// Two programs would add up their forces at one handle. A session that has just ended may still be counted.
/// Asked again by new connections: another answer costs a command, which would act on a device in use.
void HaplyDevice::require_free(const haply::Message& inventory) {
    const std::int64_t until = monotonic_ns() + answer_limit_ns;
    std::string used = used_elsewhere(inventory);
    while (!used.empty() && monotonic_ns() < until) {
        service_.reset();
        poll(nullptr, 0, ask_again_ms);
        connect();
        used = used_elsewhere(first_message());
    }
    if (used.empty()) return;
    throw InputError(
        where_, "", {QT_TRANSLATE_NOOP("errors", "the Inverse3 %1 is in use by another program"), used},
        QT_TRANSLATE_NOOP("errors",
                          "end the other program that uses it; where there is none, restart the Inverse "
                          "service"));
}

void HaplyDevice::open() {
    try {
        connect();
        const haply::Message inventory = first_message();
        choose(inventory);
        require_free(inventory);
        ForceOutput force;
        force.peak = peak;
        force.continuous = continuous;
        force.stiffness = stiffness;
        force.damping = stiffness / (2 * rate_hz);  // what Eq. 8 needs for this stiffness at this rate
        for (int h = 0; h < 2; ++h) {
            if (hands_[h].id.empty()) continue;
            facts_.slot[h] = true;
            facts_.force[h] = force;
        }
        if (wanted_.events_port != 0 && haply::probe(wanted_.events_port) == 0)
            events_ = std::make_unique<WebSocket>(wanted_.events_port);
        // It answers before it is used, and the event channel is open before rights are given up.
        std::int64_t due = 0;
        const std::int64_t until = monotonic_ns() + answer_limit_ns;
        const auto begun = [this] {
            return std::all_of(std::begin(hands_), std::end(hands_),
                               [](const Hand& hand) { return hand.id.empty() || hand.last.sequence > 0; });
        };
        while (monotonic_ns() < until &&
               (!begun() || (events_ != nullptr && events_->state() == WebSocket::State::connecting)))
            exchange(due);
        if (!begun())
            throw InputError(
                where_, "",
                QT_TRANSLATE_NOOP("errors",
                                  "the Inverse service of Haply sends no position that can be used"),
                QT_TRANSLATE_NOOP("errors", "restart the service, and install its newest version"));
        thread_ = std::thread([this] { run(); });
        sched_param parameter{};
        parameter.sched_priority = priority;
        pthread_setschedparam(thread_.native_handle(), SCHED_FIFO, &parameter);  // as far as it is allowed
    } catch (const InputError&) {
        close();
        throw;
    } catch (const std::exception& error) {
        close();
        throw InputError(where_, "", sentence_of(error),
                         QT_TRANSLATE_NOOP("errors", "install the package libwebsockets17 again"));
    }
}

void HaplyDevice::close() noexcept {
    stop_ = true;
    if (thread_.joinable()) thread_.join();  // it sends the last force, which is 0
    service_.reset();
    events_.reset();
}

void HaplyDevice::see(DeviceFault fault, std::int64_t now) {
    for (Hand& hand : hands_) hand.memory.see(fault, now);
}

void HaplyDevice::command() {
    const std::int64_t now = monotonic_ns();
    std::vector<std::pair<std::string, Vector3>> forces;
    for (int h = 0; h < 2; ++h) {
        Hand& hand = hands_[h];
        if (hand.id.empty()) continue;
        const bool good = !stop_ && hand.memory.at(now) == DeviceFault::none;
        hand.asked = good ? Vector3(wanted_.axes.transpose() * wanted_force(h, now)) : Vector3::Zero();
        forces.emplace_back(hand.id, hand.asked);
    }
    service_->send(haply::force_command(forces, form_));
    answered_ = false;
}

void HaplyDevice::check_form(const Hand& hand, const haply::Inverse3& device) {
    if (!device.force || hand.asked.norm() < clearly_asked || device.force->norm() > hardly_rendered) {
        not_rendered_ = 0;
    } else if (++not_rendered_ > most_not_rendered) {
        form_ = form_ == haply::ForceForm::vector ? haply::ForceForm::values : haply::ForceForm::vector;
        not_rendered_ = 0;
    }
}

void HaplyDevice::take_hand(Hand& hand, const haply::Message& message, std::int64_t now) {
    const auto found = std::find_if(message.devices.begin(), message.devices.end(),
                                    [&hand](const haply::Inverse3& one) { return one.id == hand.id; });
    if (found == message.devices.end()) return hand.memory.see(DeviceFault::no_answer, now);
    if (!found->calibrated) hand.memory.see(DeviceFault::needs_calibration, now);
    if (!found->powered) hand.memory.see(DeviceFault::no_power, now);
    if (!found->position) return;
    check_form(hand, *found);
    const Vector3 position = wanted_.axes * *found->position;
    for (int axis = 0; axis < 3; ++axis) hand.last.position[axis] = position[axis];
    bool pressed[3] = {false, false, false};
    if (hand.grip >= 0 && hand.grip < static_cast<int>(message.grips.size())) {
        const haply::Grip& grip = message.grips[static_cast<std::size_t>(hand.grip)];
        std::copy(std::begin(grip.button), std::end(grip.button), pressed);
        if (grip.orientation) {
            const double roll = roll_of(wanted_.axes * grip.orientation->toRotationMatrix(), wanted_.grip);
            hand.roll += std::remainder(roll - hand.roll, full_turn);
        }
    }
    const double step =
        std::clamp(1e-9 * static_cast<double>(now - read_at_), 0.0, longest_read_s) / closing_time_s;
    hand.jaw += std::clamp((pressed[0] ? 0.0 : 1.0) - hand.jaw, -step, step);
    hand.last.roll = hand.roll;
    hand.last.jaw = hand.jaw;
    hand.last.buttons =
        (pressed[1] ? std::uint64_t{button_energy} : 0U) | (pressed[2] ? std::uint64_t{button_exchange} : 0U);
    ++hand.last.sequence;  // publish() counts by itself; here: something was read
}

void HaplyDevice::publish_all(std::int64_t now) {
    for (int h = 0; h < 2; ++h) {
        Hand& hand = hands_[h];
        if (hand.id.empty()) continue;
        ServoReading reading = hand.last;
        const DeviceFault fault = hand.memory.at(now);
        reading.fault = static_cast<std::uint64_t>(fault);
        if (fault != DeviceFault::none) reading.buttons = button_none;
        publish(h, reading);
    }
}

void HaplyDevice::take_event(const haply::Event& event, std::int64_t now) {
    // The reason of a safety event is in its data; a version may also name the event after it.
    constexpr const char* safety[] = {"device-safety-triggered", "ebrake_triggered", "stall_detected",
                                      "stability_ceiling"};
    const bool gone = event.name == "device-disconnected";
    const bool braked = std::any_of(std::begin(safety), std::end(safety),
                                    [&event](const char* name) { return event.name == name; });
    if (!gone && !braked) return;
    for (Hand& hand : hands_)
        if (event.device == hand.id || event.device.empty())
            hand.memory.see(gone ? DeviceFault::no_answer : DeviceFault::safety_brake, now);
}

void HaplyDevice::take_arrived() {
    const std::int64_t now = monotonic_ns();
    std::string text;
    while (events_ != nullptr && events_->take(text))
        if (const auto event = haply::read_event(text)) take_event(*event, now);
    while (service_->take(text)) {
        answered_ = true;
        haply::Message message;
        const Understood what = haply::read_message(text, message);
        if (what == Understood::refused)  // a version that wants the other form
            form_ = form_ == haply::ForceForm::vector ? haply::ForceForm::values : haply::ForceForm::vector;
        if (what != Understood::yes) see(DeviceFault::haply_message, now);
        if (what == Understood::yes || what == Understood::not_numbers)
            for (Hand& hand : hands_)
                if (!hand.id.empty()) take_hand(hand, message, now);
        read_at_ = now;
        publish_all(now);
    }
}

/// One command at most, and what has arrived.
void HaplyDevice::exchange(std::int64_t& due) {
    std::int64_t now = monotonic_ns();
    if (answered_ && now >= due) {
        command();
        due = std::max(due + tick_ns, now);
    }
    const std::int64_t wait = answered_ ? std::clamp<std::int64_t>(due - now, 0, tick_ns) : tick_ns;
    service_->serve(wait);
    if (events_ != nullptr) events_->serve(0);
    take_arrived();
}

void HaplyDevice::run() {
    std::int64_t due = 0;
    while (!stop_) {
        if (service_->state() == WebSocket::State::open) {
            exchange(due);
            continue;
        }
        const std::int64_t now = monotonic_ns();
        see(DeviceFault::haply_ended, now);
        publish_all(now);
        service_->serve(tick_ns);  // waits
    }
    end_exchange();
}

/// The last command is a force of 0. It waits for the answer to the one before, but not for long.
void HaplyDevice::end_exchange() {
    const std::int64_t until = monotonic_ns() + servo_silence;
    while (!answered_ && service_->state() == WebSocket::State::open && monotonic_ns() < until) {
        service_->serve(tick_ns);
        take_arrived();
    }
    if (service_->state() == WebSocket::State::open) command();
}

}  // namespace fulcrum::hapticd
