// SPDX-License-Identifier: GPL-3.0-or-later
// The strip of keys at the foot of the theatre. A person who uses a kind of device for the first time
// practises on it: each line gets a mark when it was done, and the strip stays until all are.
#include <QSettings>

#include "ui/style/widgets.h"
#include "ui/theatre/mouse_keyboard_input.h"
#include "ui/theatre/theatre_page.h"

namespace fulcrum::ui {
namespace {

constexpr qint64 needed_ms = 8000, learning_ms = 120000;

}  // namespace

QString TheatrePage::learnt_key() const {
    const std::string& person = context().session().person_id();
    const char* const devices[] = {"mouse", "two-mice", "controller"};
    return QStringLiteral("learnt/%1/%2%3")
        .arg(person.empty() ? QStringLiteral("station") : QString::fromStdString(person),
             QLatin1String(devices[static_cast<int>(input_->device())]),
             session_->scene().instruments.empty() ? QStringLiteral("-scope") : QString());
}

/// From the beginning until a hand has moved for some seconds; in practice, where the device is new to the
/// person, until each line was done, two minutes at most.
void TheatrePage::show_strip() {
    const bool begun = has_begun() && demonstrated_.isEmpty();
    if (begun && session_->display().moving_seen && !since_moved_.isValid()) {
        since_moved_.start();
        learns_ = !session_->assessed() && !QSettings().value(learnt_key(), false).toBool();
    }
    const bool live =
        begun && shown_ == Panel::none && !help_shown_ && session_->phase() == AttemptPhase::running;
    const QStringList lines = live ? input_->first_lines() : QStringList();
    const bool all_tried = live && static_cast<int>(input_->tried().count()) >= lines.size();
    if (learns_ && all_tried) {
        QSettings().setValue(learnt_key(), true);
        learns_ = false;
        since_moved_.start();
    }
    const bool needed =
        live && !(since_moved_.isValid() && since_moved_.elapsed() > (learns_ ? learning_ms : needed_ms));
    if (needed) {
        QStringList parts;
        for (int i = 0; i < lines.size(); ++i) {
            const bool tried = input_->tried().test(static_cast<std::size_t>(i));
            parts << QStringLiteral("%1<b>%2</b>&nbsp;%3")
                         .arg(tried ? QStringLiteral("✓&nbsp;") : QString(),
                              lines[i]
                                  .section(QLatin1Char('\t'), 0, 0)
                                  .toHtmlEscaped()
                                  .replace(QLatin1Char(' '), QStringLiteral("&nbsp;")),
                              lines[i].section(QLatin1Char('\t'), 1).toHtmlEscaped());
        }
        parts << tr("<b>F1</b>&nbsp;all keys");
        const QString shown = parts.join(QStringLiteral(" &nbsp; "));
        if (shown != strip_text_->text()) {
            strip_text_->setTextFormat(Qt::RichText);
            strip_text_->setText(shown);
            place_strip();
        }
    }
    if (needed == strip_->isVisible()) return;
    strip_->setVisible(needed);
    if (needed) {
        place_strip();
        strip_->raise();
    }
}

void TheatrePage::place_strip() {
    const int width = this->width() - 40;
    const int height = strip_->layout()->totalHeightForWidth(width);
    strip_->setGeometry(20, bar_->y() - height - 8, width, height);
}

}  // namespace fulcrum::ui
