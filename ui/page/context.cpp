// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/context.h"

#include <QLineEdit>
#include <QStackedWidget>
#include <QVariant>
#include <exception>

#include "database/rows/attempt_records.h"
#include "database/rows/errors.h"
#include "ui/language/error_text.h"
#include "ui/page/background_job.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

constexpr const char* begun_property = "fulcrum_begun";

/// Not hidden by its page; a tab behind another one is not hidden.
bool is_offered(const QWidget* input, const QWidget* page) {
    for (const QWidget* one = input; one != nullptr && one != page; one = one->parentWidget())
        if (one->isHidden() && qobject_cast<const QStackedWidget*>(one->parentWidget()) == nullptr)
            return false;
    return true;
}

}  // namespace

void mark_begun(QLineEdit* edit, const QString& what) {
    edit->setProperty(begun_property, what);
}

void Context::set_session(const database::Session& session) {
    session_ = session;
    emit session_changed();
}

void Context::sign_out() {
    if (scoring_ != nullptr) scoring_->cancel();
    scoring_ = nullptr;
    interrupted_.clear();
    session_.reset();
    emit session_changed();
}

void Context::score_interrupted() {
    if (scoring_ != nullptr || !session_ || session_->must_change_password() ||
        !allowed(database::Operation::score_interrupted))
        return;
    auto scored = std::make_shared<std::vector<InterruptedScore>>();
    scoring_ = BackgroundJob::run(
        this,
        [this, scored, session = *session_](const Progress& progress) {
            *scored = services_.score_interrupted(session, progress);
        },
        [this, scored] {
            scoring_ = nullptr;
            if (scored->empty()) return;
            interrupted_ = std::move(*scored);
            emit interrupted_scored();
        },
        [this](const QString& why) {
            scoring_ = nullptr;
            complain(
                tr("Interrupted attempts could not be scored. Fulcrum tries again at the next sign-in: %1")
                    .arg(why));
        });
}

bool Context::allowed(database::Operation operation, const database::Subject& subject) {
    if (!session_.has_value() || services_.store() == nullptr) return false;
    bool answer = false;
    guarded([&] { answer = store().allowed(*session_, operation, subject); });
    return answer;
}

const TaskDefinition* Context::task(const std::string& id) {
    for (const TaskDefinition& task : services_.tasks()) {
        if (task.id == id) return &task;
    }
    return nullptr;
}

QString Context::task_title(const std::string& id) {
    if (database::is_external_task(id))
        return tr("External: %1").arg(text(id.substr(database::external_task_prefix.size())));
    const TaskDefinition* definition = task(id);
    return definition == nullptr ? text(id)
                                 : text(id) + QStringLiteral(" · ") + asset_text(definition->title);
}

QString variant_title(const TaskDefinition* task, const std::string& variant) {
    if (task != nullptr) {
        for (const TaskVariant& one : task->variants)
            if (one.id == variant) return asset_text(one.title);
    }
    return text(variant);
}

bool Context::guarded(const std::function<void()>& work) {
    try {
        work();
        return true;
    } catch (const std::exception& error) {
        complain(error_text(error));
        return false;
    }
}

Page::Page(Context& context, const char* name) : context_(context) {
    setObjectName(QString::fromLatin1(name));
    setProperty("role", "page");
}

QStringList Page::begun_input(Ending) const {
    QStringList begun;
    for (const QLineEdit* edit : findChildren<QLineEdit*>()) {
        const QString what = edit->property(begun_property).toString();
        // isModified(): by a person, since the program last wrote into it.
        if (!what.isEmpty() && edit->isModified() && !edit->text().trimmed().isEmpty() &&
            is_offered(edit, this))
            begun << what;
    }
    return begun;
}

}  // namespace fulcrum::ui

#include "moc_context.cpp"
