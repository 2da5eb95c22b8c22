// SPDX-License-Identifier: Apache-2.0
#include "sim_core/haply/web_socket.h"

#include <arpa/inet.h>
#include <libwebsockets.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>

#include "sim_core/numerics/name_table.h"
#include "sim_core/numerics/worded_error.h"

namespace fulcrum::haply {
namespace {

constexpr const char* this_computer = "127.0.0.1";
constexpr std::size_t longest_message = 256 * 1024, most_messages = 64;
constexpr unsigned int most_descriptors = 8;
constexpr std::int64_t looking_ns = 1'000'000, second_ns = 1000 * looking_ns;

}  // namespace

int probe(int port) noexcept {
    const int one = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (one < 0) return errno;
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int failed =
        connect(one, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 ? 0 : errno;
    close(one);
    return failed;
}

struct WebSocket::Library {
    lws_context* context = nullptr;
    lws* socket = nullptr;

    static int called(lws* socket, lws_callback_reasons reason, void*, void* in, std::size_t size) {
        auto* const owner = static_cast<WebSocket*>(lws_context_user(lws_get_context(socket)));
        if (owner == nullptr || owner->library_ == nullptr) return 0;
        if (reason == LWS_CALLBACK_CLIENT_RECEIVE && lws_is_first_fragment(socket) != 0)
            owner->arriving_.clear();
        const int result = owner->answer(static_cast<int>(reason), in, size);
        if (reason == LWS_CALLBACK_CLIENT_RECEIVE && result == 0 && lws_is_final_fragment(socket) != 0 &&
            lws_remaining_packet_payload(socket) == 0 && owner->arrived_.size() < most_messages)
            owner->arrived_.push_back(std::move(owner->arriving_));
        return result;
    }
};

WebSocket::WebSocket(int port) : library_(std::make_unique<Library>()) {
    static const lws_protocols protocols[] = {{"haply", &Library::called, 0, 16384, 0, nullptr, 0},
                                              {nullptr, nullptr, 0, 0, 0, nullptr, 0}};
    // The library would go through a proxy, which may be on another computer.
    for (const char* variable : {"http_proxy", "socks_proxy"}) unsetenv(variable);
    lws_set_log_level(0, nullptr);
    lws_context_creation_info wanted{};
    wanted.port = CONTEXT_PORT_NO_LISTEN;
    wanted.protocols = protocols;
    wanted.gid = static_cast<gid_t>(-1);
    wanted.uid = static_cast<uid_t>(-1);
    wanted.fd_limit_per_thread = most_descriptors;
    wanted.user = this;
    library_->context = lws_create_context(&wanted);
    if (library_->context == nullptr)
        throw WordedError(QT_TRANSLATE_NOOP("errors", "libwebsockets, which speaks with it, does not start"));
    lws_client_connect_info to{};
    to.context = library_->context;
    to.address = this_computer;
    to.host = to.origin = "localhost";
    to.port = port;
    to.path = "/";
    to.local_protocol_name = protocols[0].name;
    to.pwsi = &library_->socket;
    if (lws_client_connect_via_info(&to) == nullptr && state_ == State::connecting)
        state_ = State::not_a_web_socket;
}

WebSocket::~WebSocket() {
    if (library_->context != nullptr) lws_context_destroy(library_->context);
}

int WebSocket::answer(int reason, void* in, std::size_t size) {
    switch (reason) {
        case LWS_CALLBACK_CLIENT_CONNECTION_ERROR:
            state_ = State::not_a_web_socket;
            library_->socket = nullptr;
            return 0;
        case LWS_CALLBACK_CLIENT_ESTABLISHED:
            state_ = State::open;
            return 0;
        case LWS_CALLBACK_CLIENT_RECEIVE:
            arriving_.append(static_cast<const char*>(in), size);
            return arriving_.size() > longest_message ? -1 : 0;
        case LWS_CALLBACK_CLIENT_WRITEABLE: {
            if (!sends_) return 0;
            sends_ = false;
            std::string framed(LWS_PRE, '\0');
            framed += leaving_;
            auto* const first = reinterpret_cast<unsigned char*>(framed.data()) + LWS_PRE;
            return lws_write(library_->socket, first, leaving_.size(), LWS_WRITE_TEXT) < 0 ? -1 : 0;
        }
        case LWS_CALLBACK_CLIENT_CLOSED:
        case LWS_CALLBACK_WSI_DESTROY:
            if (state_ == State::open) state_ = State::closed;
            library_->socket = nullptr;
            return 0;
        default:
            return 0;
    }
}

void WebSocket::serve(std::int64_t wait) {
    if (state_ == State::connecting || state_ == State::open) {
        const int descriptor = library_->socket != nullptr ? lws_get_socket_fd(library_->socket) : -1;
        const short wanted = static_cast<short>(POLLIN | (sends_ ? POLLOUT : 0));
        pollfd one{descriptor, wanted, 0};
        if (state_ == State::connecting && wait > looking_ns) wait = looking_ns;
        const timespec time{wait / second_ns, wait % second_ns};
        ppoll(&one, 1, &time, nullptr);
        if (sends_ && library_->socket != nullptr) lws_callback_on_writable(library_->socket);
        lws_service(library_->context, -1);
    } else if (wait > 0) {
        const timespec time{wait / second_ns, wait % second_ns};
        ppoll(nullptr, 0, &time, nullptr);
    }
}

bool WebSocket::take(std::string& text) {
    if (arrived_.empty()) return false;
    text = std::move(arrived_.front());
    arrived_.pop_front();
    return true;
}

void WebSocket::send(const std::string& text) {
    leaving_ = text;
    sends_ = true;
    if (library_->socket != nullptr && state_ == State::open) {
        lws_callback_on_writable(library_->socket);
        lws_service(library_->context, -1);
    }
}

}  // namespace fulcrum::haply
