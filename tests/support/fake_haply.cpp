// SPDX-License-Identifier: Apache-2.0
#include "tests/support/fake_haply.h"

#include <libwebsockets.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <deque>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "sim_core/devices/device_page.h"
#include "tests/support/device_thread.h"

namespace fulcrum::test {

using nlohmann::json;

struct WebSocketServer::Library {
    struct Client {
        std::string arriving;
        std::deque<std::string> leaving;
    };
    lws_context* context = nullptr;
    std::map<lws*, Client> clients;

    static int called(lws* socket, lws_callback_reasons reason, void*, void* in, std::size_t size) {
        auto* const owner = static_cast<WebSocketServer*>(lws_context_user(lws_get_context(socket)));
        if (owner == nullptr || owner->library_ == nullptr) return 0;
        return owner->library_->answer(*owner, socket, reason, in, size);
    }
    int answer(WebSocketServer& owner, lws* socket, lws_callback_reasons reason, void* in, std::size_t size) {
        switch (reason) {
            case LWS_CALLBACK_ESTABLISHED:
                owner.clients_ = static_cast<int>((clients[socket], clients.size()));
                put(socket, owner.first_());
                return 0;
            case LWS_CALLBACK_CLOSED:
                clients.erase(socket);
                owner.clients_ = static_cast<int>(clients.size());
                return 0;
            case LWS_CALLBACK_RECEIVE: {
                Client& client = clients[socket];
                client.arriving.append(static_cast<const char*>(in), size);
                if (lws_is_final_fragment(socket) == 0 || lws_remaining_packet_payload(socket) != 0) return 0;
                if (!client.leaving.empty()) ++owner.early_;
                put(socket, owner.answer_(client.arriving));
                client.arriving.clear();
                int waiting = 0;
                if (ioctl(lws_get_socket_fd(socket), FIONREAD, &waiting) == 0 && waiting > 0) ++owner.early_;
                return 0;
            }
            case LWS_CALLBACK_SERVER_WRITEABLE:
                return write(owner, socket);
            default:
                return 0;
        }
    }
    void put(lws* socket, const std::string& text) {
        if (text.empty()) return;
        clients[socket].leaving.push_back(text);
        lws_callback_on_writable(socket);
    }
    int write(const WebSocketServer& owner, lws* socket) {
        if (owner.hang_up_) return -1;
        Client& client = clients[socket];
        if (client.leaving.empty()) return 0;
        std::string framed(LWS_PRE, '\0');
        framed += client.leaving.front();
        const std::size_t size = client.leaving.front().size();
        client.leaving.pop_front();
        if (!client.leaving.empty()) lws_callback_on_writable(socket);
        auto* const first = reinterpret_cast<unsigned char*>(framed.data()) + LWS_PRE;
        return lws_write(socket, first, size, LWS_WRITE_TEXT) < 0 ? -1 : 0;
    }
};

WebSocketServer::WebSocketServer(int port, std::function<std::string()> first,
                                 std::function<std::string(const std::string&)> answer)
    : first_(std::move(first)), answer_(std::move(answer)), library_(std::make_unique<Library>()) {
    static const lws_protocols protocols[] = {{"haply", &Library::called, 0, 16384, 0, nullptr, 0},
                                              {nullptr, nullptr, 0, 0, 0, nullptr, 0}};
    lws_set_log_level(0, nullptr);
    lws_context_creation_info wanted{};
    wanted.port = port;
    wanted.iface = "127.0.0.1";
    wanted.protocols = protocols;
    wanted.gid = static_cast<gid_t>(-1);
    wanted.uid = static_cast<uid_t>(-1);
    wanted.fd_limit_per_thread = 32;
    wanted.options = LWS_SERVER_OPTION_DISABLE_IPV6 | LWS_SERVER_OPTION_FAIL_UPON_UNABLE_TO_BIND |
                     LWS_SERVER_OPTION_EXPLICIT_VHOSTS;
    wanted.user = this;
    library_->context = lws_create_context(&wanted);
    lws_vhost* const host =
        library_->context != nullptr ? lws_create_vhost(library_->context, &wanted) : nullptr;
    if (host == nullptr) throw std::runtime_error("no WebSocket server at port " + std::to_string(port));
    port_ = lws_get_vhost_listen_port(host);
    thread_ = std::thread([this] { run(); });
}

WebSocketServer::~WebSocketServer() {
    stop_ = true;
    lws_cancel_service(library_->context);
    thread_.join();
    lws_context_destroy(library_->context);
}

void WebSocketServer::say(const std::string& text) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        to_say_.push_back(text);
    }
    lws_cancel_service(library_->context);
}

void WebSocketServer::run() {
    work_as_a_device();
    while (!stop_) {
        lws_service(library_->context, 0);
        std::vector<std::string> said;
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            said.swap(to_say_);
        }
        for (auto& [socket, client] : library_->clients) {
            for (const std::string& text : said) library_->put(socket, text);
            if (hang_up_) lws_callback_on_writable(socket);
        }
        if (hang_up_ && library_->clients.empty()) hang_up_ = false;
    }
}

FakeHaply::FakeHaply(std::vector<Device> devices, int grips, int port)
    : devices_(std::move(devices)),
      places_(devices_.size(), Vector3(0.01, -0.15, 0.1)),
      forces_(devices_.size(), Vector3::Zero()),
      grips_(static_cast<std::size_t>(grips)) {
    events_ = std::make_unique<WebSocketServer>(
        0, [] { return std::string(); }, [](const std::string&) { return std::string(); });
    service_ = std::make_unique<WebSocketServer>(
        port, [this] { return inventory(); }, [this](const std::string& command) { return answer(command); });
}

std::string FakeHaply::specification() const {
    return "haply:" + std::to_string(port()) + ",events=" + std::to_string(events_->port());
}

void FakeHaply::move(std::size_t device, const Vector3& position) {
    const std::lock_guard<std::mutex> lock(mutex_);
    places_.at(device) = position;
}

void FakeHaply::turn(std::size_t grip, const Quaternion& orientation, bool a, bool b, bool c) {
    const std::lock_guard<std::mutex> lock(mutex_);
    grips_.at(grip) = {orientation, {a, b, c}};
}

Vector3 FakeHaply::force(std::size_t device) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return forces_.at(device);
}

Vector3 FakeHaply::rendered(std::size_t device) const {
    constexpr std::int64_t one_tick = 20'000'000;  // ns
    const std::lock_guard<std::mutex> lock(mutex_);
    return monotonic_ns() - commanded_ > one_tick ? Vector3::Zero() : forces_.at(device);
}

void FakeHaply::event(const std::string& name, const std::string& device, const std::string& reason) const {
    json data = {{"device_id", device}};
    if (!reason.empty()) data["reason"] = reason;
    events_->say(json{{"name", name}, {"level", "warning"}, {"data", data}}.dump());
}

std::string FakeHaply::inventory() {
    if (mode == Mode::other_service) return R"({"service": "another", "devices": []})";
    const std::lock_guard<std::mutex> lock(mutex_);
    json document = json::parse(state());
    document["session_id"] = 1;
    ++inventories;
    const bool used = inventories_in_use > 0;
    if (used) --inventories_in_use;
    for (std::size_t i = 0; i < devices_.size(); ++i) {
        document["inverse3"][i]["config"] = {{"handedness", devices_[i].handedness}};
        document["inverse3"][i]["status"]["in_use"] = used && i == 0;
    }
    return document.dump();
}

std::string FakeHaply::state() const {
    const auto numbers = [](const Vector3& v) { return json{{"x", v.x()}, {"y", v.y()}, {"z", v.z()}}; };
    json devices = json::array(), grips = json::array();
    for (std::size_t i = 0; i < devices_.size(); ++i)
        devices.push_back(
            {{"device_id", devices_[i].id},
             {"state",
              {{"cursor_position", numbers(places_[i])}, {"current_cursor_force", numbers(forces_[i])}}},
             {"status",
              {{"calibrated", mode != Mode::not_calibrated},
               {"power_supply", mode != Mode::no_power},
               {"in_use", true}}}});  // an answer: by the session that commands it
    for (const Grip& grip : grips_) {
        const Quaternion& q = grip.orientation;
        grips.push_back(
            {{"device_id", "61576"},
             {"state",
              {{"orientation", {{"w", q.w()}, {"x", q.x()}, {"y", q.y()}, {"z", q.z()}}},
               {"buttons", {{"a", grip.button[0]}, {"b", grip.button[1]}, {"c", grip.button[2]}}}}}});
    }
    return json{{"inverse3", devices}, {"wireless_verse_grip", grips}}.dump();
}

/// The server's thread waits: as a service does that answers one message after the other.
void FakeHaply::take_time() {
    if (mode != Mode::slow && mode != Mode::falling_behind) {
        answers_ = 0;
        return;
    }
    const int ms = mode == Mode::slow ? 5 + (7 * answers_) % 11 : std::min(5 + answers_, 40);
    ++answers_;
    usleep(1000 * static_cast<unsigned>(ms));
}

std::string FakeHaply::answer(const std::string& command) {
    take_time();
    const std::lock_guard<std::mutex> lock(mutex_);
    ++commands;
    commanded_ = monotonic_ns();
    const json document = json::parse(command, nullptr, false);
    const char* const key = form == Form::vector ? "vector" : "values";
    for (const json& one : document.at("inverse3")) {
        const json& force = one.at("commands").at("set_cursor_force");
        if (form == Form::refuses_vector && force.contains("vector")) return R"({"error": "unknown key"})";
        for (std::size_t i = 0; i < devices_.size(); ++i) {
            if (one.at("device_id") != devices_[i].id) continue;
            forces_[i] = Vector3::Zero();
            if (force.contains(key))
                forces_[i] = Vector3(force[key].at("x"), force[key].at("y"), force[key].at("z"));
        }
    }
    std::string text = state();
    const auto spoil = [&text](const char* with) {
        const std::size_t begin = text.find("\"x\":", text.find("cursor_position")) + 4;
        text.replace(begin, text.find_first_of(",}", begin) - begin, with);
    };
    switch (mode.load()) {
        case Mode::silent:
            return {};
        case Mode::garbage:
            return std::string(300, 'G');
        case Mode::cut:
            return text.substr(0, text.size() / 2);
        case Mode::nan:
            spoil("NaN");
            return text;
        case Mode::null:
            spoil("null");
            return text;
        case Mode::far_away:
            spoil("1000");
            return text;
        case Mode::no_device:
            return R"({"inverse3": []})";
        case Mode::other_service:
            return R"({"service": "another"})";
        default:
            return text;
    }
}

}  // namespace fulcrum::test
