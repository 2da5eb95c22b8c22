// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/concern_words.h"

#include <QCoreApplication>

#include "assessment/scoring/score.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

QString say(const char* source, int count = -1) {
    return QCoreApplication::translate("fulcrum::ui::concerns", source, nullptr, count);
}

}  // namespace

QString concern_text(const Concern& concern, const QString& task_title, std::int64_t now) {
    switch (concern.kind) {
        case ConcernKind::relapsed:
            if (concern.provisional)
                return say(QT_TRANSLATE_NOOP("fulcrum::ui::concerns",
                                             "%1: proficiency was lost; latest attempt on %2, by limits that "
                                             "are provisional and cannot restore it: "
                                             "build the benchmark set, or decide."))
                    .arg(task_title, date_text(concern.since));
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::concerns",
                                         "%1: proficiency was lost; latest attempt on %2."))
                .arg(task_title, date_text(concern.since));
        case ConcernKind::check_overdue:
            if (concern.provisional)
                return say(QT_TRANSLATE_NOOP("fulcrum::ui::concerns",
                                             "%1: a retention check was due on %2. The limits are "
                                             "provisional and cannot complete it: "
                                             "build the benchmark set, or decide."))
                    .arg(task_title, date_text(concern.since));
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::concerns", "%1: a retention check was due on %2."))
                .arg(task_title, date_text(concern.since));
        case ConcernKind::rating_late:
            return say(QT_TRANSLATE_NOOP(
                           "fulcrum::ui::concerns",
                           "%1: ratings of the attempt of %2 are missing. Where nobody is left to "
                           "rate it, the next attempt that meets the rule is rated, or decide."))
                .arg(task_title, date_text(concern.since));
        case ConcernKind::plateau:
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::concerns",
                                         "%1: after %n attempts the curve levels off at %2 points "
                                         "(95 % interval %3 to %4), below the pass mark of %5."),
                       concern.attempts)
                .arg(task_title, figure(concern.plateau), figure(concern.low), figure(concern.high),
                     figure(pass_mark));
        case ConcernKind::stalled:
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::concerns", "%1: %n attempts without proficiency."),
                       concern.attempts)
                .arg(task_title);
        case ConcernKind::stopped:
            return say(QT_TRANSLATE_NOOP("fulcrum::ui::concerns",
                                         "No practice for %n days, since %1, and tasks remain."),
                       static_cast<int>((now - concern.since) / 86'400'000))
                .arg(date_text(concern.since));
    }
    return {};
}

}  // namespace fulcrum::ui
