// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/mail_room.h"

#include <QCoreApplication>

namespace fulcrum::ui {

MailRoom* MailRoom::of_application() {
    QCoreApplication* application = QCoreApplication::instance();
    auto* room = application->findChild<MailRoom*>({}, Qt::FindDirectChildrenOnly);
    return room != nullptr ? room : new MailRoom(application);
}

void MailRoom::post(std::function<void()> letter) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        letters_.push_back(std::move(letter));
    }
    QMetaObject::invokeMethod(this, "deliver", Qt::QueuedConnection);
}

// One letter a call, as many calls as letters: a letter that opens an event loop of its own does not hold up
// the rest.
void MailRoom::deliver() {
    std::function<void()> letter;
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (letters_.empty()) return;
        letter = std::move(letters_.front());
        letters_.erase(letters_.begin());
    }
    letter();
}

}  // namespace fulcrum::ui

#include "moc_mail_room.cpp"
