// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/sending.h"

#include <QSettings>
#include <cstdlib>

#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {
namespace {

constexpr const char *sending_key = "openigtlink", *sending_variable = "FULCRUM_OPENIGTLINK";

}  // namespace

Sending::Sending() {
    const char* const named = std::getenv(sending_variable);
    fixed_ = named != nullptr && *named != '\0';
    if (fixed_)
        start(named, sending_variable);
    else if (QSettings().value(QLatin1String(sending_key), false).toBool())
        start({}, {});
}

void Sending::start(const std::string& address, const std::string& named) {
    try {
        const igtl::Address wanted = igtl::parse_address(address, named, 0);
        sender_ = std::make_unique<LiveSender>(wanted);
        address_ = igtl::Address{wanted.host, sender_->port()}.text();
        trouble_ = {};
    } catch (const InputError& error) {
        trouble_ = sentence_of(error);
    }
}

ui::SendingState Sending::state() const {
    ui::SendingState state;
    state.wanted = sender_ != nullptr || !trouble_.empty();
    state.fixed = fixed_;
    state.trouble = trouble_;
    if (sender_ == nullptr) return state;
    state.address = address_;
    state.other_computers = address_.rfind("127.", 0) != 0 && address_.rfind("[::1]", 0) != 0 &&
                            address_.rfind("localhost:", 0) != 0;
    state.clients = sender_->clients();
    state.dropped = sender_->dropped();
    return state;
}

void Sending::choose(bool wanted) {
    if (fixed_) return;
    QSettings().setValue(QLatin1String(sending_key), wanted);
    trouble_ = {};
    if (!wanted)
        sender_.reset();
    else if (sender_ == nullptr)
        start({}, {});
}

std::shared_ptr<SampleTap> Sending::begin(const Scene& scene, std::uint64_t seed) {
    return sender_ != nullptr ? sender_->begin(scene, seed) : nullptr;
}

}  // namespace fulcrum::app
