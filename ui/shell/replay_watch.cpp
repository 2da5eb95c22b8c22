// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/replay_watch.h"

namespace fulcrum::ui {
namespace {

constexpr int first_prepared_ms = 3000;  // after the sign-in: the first page is drawn first
constexpr int prepare_every_ms = 60000;

}  // namespace

ReplayWatch::ReplayWatch(Context& context, std::function<bool()> attempt_runs, QObject* parent)
    : QObject(parent), context_(context), attempt_runs_(std::move(attempt_runs)) {
    connect(&timer_, &QTimer::timeout, this, &ReplayWatch::look);
    connect(&context_, &Context::session_changed, this, &ReplayWatch::session_changed);
}

void ReplayWatch::session_changed() {
    timer_.stop();
    context_.services().stop_preparing_replays();
    if (context_.signed_in() && !context_.session().must_change_password()) timer_.start(first_prepared_ms);
}

void ReplayWatch::look() {
    timer_.setInterval(prepare_every_ms);
    if (!attempt_runs_()) context_.services().prepare_replays(context_.session());
}

}  // namespace fulcrum::ui

#include "moc_replay_watch.cpp"
