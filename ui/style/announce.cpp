// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/announce.h"

#include <QAccessible>
#include <QAccessibleWidget>
#include <QLabel>
#include <QVariant>

namespace fulcrum::ui {
namespace {

constexpr const char* announcer_name = "announcer";
constexpr const char* announcer_mark = "announces";

QAccessibleInterface* make_announcer_interface(const QString& /*class_name*/, QObject* object) {
    if (object == nullptr || !object->isWidgetType() || !object->property(announcer_mark).toBool())
        return nullptr;
    return new QAccessibleWidget(static_cast<QWidget*>(object), QAccessible::AlertMessage);
}

/// Before it is asked for its role the first time, which is kept.
void install_announcers() {
    static const bool installed = [] {
        QAccessible::installFactory(make_announcer_interface);
        return true;
    }();
    Q_UNUSED(installed)
}

void send_accessible_event(QWidget* widget, QAccessible::Event what) {
    QAccessibleEvent event(widget, what);
    QAccessible::updateAccessibility(&event);
}

}  // namespace

// One invisible widget of the window says everything: its role is that of an alert, which a screen reader
// reads where it appears, wherever the focus is. On Linux Qt hands on that it appears, not the alert itself.
void announce(const QWidget* from, const QString& words) {
    const QString line = words.simplified();
    // What is behind the lock is hidden, and not for whoever is there.
    if (from == nullptr || line.isEmpty()) return;
    if (!from->isWindow() && !from->isVisibleTo(from->window())) return;
    QWidget* const window = from->window();
    auto* announcer = window->findChild<QWidget*>(QLatin1String(announcer_name), Qt::FindDirectChildrenOnly);
    const bool is_new = announcer == nullptr;
    if (is_new) {
        install_announcers();
        announcer = new QWidget(window);
        announcer->setObjectName(QLatin1String(announcer_name));
        announcer->setProperty(announcer_mark, true);
        announcer->setAttribute(Qt::WA_TransparentForMouseEvents);
        announcer->setGeometry(0, 0, 1, 1);
        announcer->lower();
    }
    announcer->setAccessibleName(line);
    announcer->setProperty(announced_property, announcer->property(announced_property).toInt() + 1);
    if (is_new)
        announcer->show();  // which reports that it appears
    else
        send_accessible_event(announcer, QAccessible::ObjectShow);
    send_accessible_event(announcer, QAccessible::Alert);
}

void announce_problem(QLabel* label, const QString& problem) {
    label->setText(problem);
    announce(label, problem);
}

void announce_change(QLabel* label, const QString& words) {
    const bool is_new = label->text() != words;
    label->setText(words);
    if (is_new && label->isVisible()) announce(label, words);
}

}  // namespace fulcrum::ui
