// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/replay_watch.h"

namespace fulcrum::ui {
ReplayWatch::ReplayWatch(Context& context, std::function<bool()> attempt_runs, QObject* parent, int first_ms,
                         int then_ms)
    : QObject(parent),
      context_(context),
      attempt_runs_(std::move(attempt_runs)),
      first_ms_(first_ms),
      then_ms_(then_ms) {
    connect(&timer_, &QTimer::timeout, this, &ReplayWatch::look);
    connect(&context_, &Context::session_changed, this, &ReplayWatch::session_changed);
}

void ReplayWatch::session_changed() {
    timer_.stop();
    context_.services().stop_preparing_replays();
    if (context_.signed_in() && !context_.session().must_change_password()) timer_.start(first_ms_);
}

void ReplayWatch::look() {
    timer_.setInterval(then_ms_);
    if (!attempt_runs_()) context_.services().prepare_replays(context_.session());
}

}  // namespace fulcrum::ui

#include "moc_replay_watch.cpp"
