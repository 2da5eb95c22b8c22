// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/display.h"

#include <unistd.h>

#include <QString>
#include <QtGlobal>
#include <cstdio>
#include <iostream>

#include "app/cli/commands.h"
#include "ui/language/language.h"

namespace fulcrum::app {
namespace {

DisplayNeeded* needed = nullptr;
QtMessageHandler handler_before = nullptr;

/// What says which display it is; empty: nothing does.
std::string asked_for() {
    std::string all;
    for (const char* name : {"QT_QPA_PLATFORM", "WAYLAND_DISPLAY", "DISPLAY"}) {
        if (qEnvironmentVariableIsEmpty(name)) continue;
        all += (all.empty() ? "" : " ") + std::string(name) + "=" + qgetenv(name).toStdString();
    }
    return all;
}

/// Qt ends the program right after a fatal message.
void take_message(QtMsgType type, const QMessageLogContext&, const QString& text) {
    if (type != QtFatalMsg) {
        needed->note(text.toStdString());
        return;
    }
    ui::use_language(ui::chosen_language().value_or(ui::Language::english));
    const std::string why = asked_for();
    const Sentence problem =
        why.empty() ? Sentence(QT_TRANSLATE_NOOP("errors", "no display can be opened"))
                    : Sentence(QT_TRANSLATE_NOOP("errors", "no display can be opened (%1)"), why);
    std::cerr << "fulcrum: " << line_of(WordedError(Sentence("%1; %2", problem, needed->hint())))
              << std::endl;
    _exit(2);
}

}  // namespace

DisplayNeeded::DisplayNeeded(Sentence hint) : hint_(std::move(hint)) {
    needed = this;
    handler_before = qInstallMessageHandler(take_message);
}

DisplayNeeded::~DisplayNeeded() {
    qInstallMessageHandler(handler_before);
    needed = nullptr;
    for (const std::string& line : notes_) std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace fulcrum::app
