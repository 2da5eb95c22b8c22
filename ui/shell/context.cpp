// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/context.h"

#include <exception>

#include "database/errors.h"
#include "ui/style/text.h"

namespace fulcrum::ui {

void Context::set_session(const database::Session& session) {
    session_ = session;
    emit session_changed();
}

void Context::sign_out() {
    session_.reset();
    emit session_changed();
}

bool Context::allowed(database::Operation operation, const database::Subject& subject) {
    return session_.has_value() && services_.store() != nullptr &&
           store().allowed(*session_, operation, subject);
}

const TaskDefinition* Context::task(const std::string& id) {
    for (const TaskDefinition& task : services_.tasks()) {
        if (task.id == id) return &task;
    }
    return nullptr;
}

QString Context::task_title(const std::string& id) {
    const TaskDefinition* definition = task(id);
    return definition == nullptr ? text(id) : text(id) + QStringLiteral(" · ") + text(definition->title);
}

bool Context::guarded(const std::function<void()>& work) {
    try {
        work();
        return true;
    } catch (const std::exception& error) {
        complain(QString::fromUtf8(error.what()));
        return false;
    }
}

Page::Page(Context& context, const char* name) : context_(context) {
    setObjectName(QString::fromLatin1(name));
    setProperty("role", "page");
}

}  // namespace fulcrum::ui
