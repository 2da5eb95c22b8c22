// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/event_words.h"

#include <QCoreApplication>

#include "sim_core/telemetry/event_types.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

constexpr const char* context = "fulcrum::event_lines";
constexpr double to_mm = 1e3, to_mm2 = 1e6;
constexpr double least_piece = 1e-6;  // m2: smaller pieces cannot be seen to come free

QString translated(const char* source) {
    return QCoreApplication::translate(context, source);
}

QString name_of(const EventType& type) {
    QString name = event_text(type.name);
    if (!name.isEmpty()) name[0] = name[0].toUpper();
    return name;
}

/// "": no line.
QString words_of_line(const EventType& type, const Event& event) {
    const double value = static_cast<double>(event.value);
    switch (type.line) {
        case LineContent::none:
            return {};
        case LineContent::name:
            return name_of(type);
        case LineContent::value:
            return translated(type.words).arg(figure(value));
        case LineContent::count:
            return translated(type.words).arg(event.detail + 1);
        case LineContent::count_and_value:
            return translated(type.words).arg(event.detail + 1).arg(figure(value));
        case LineContent::force:
            if (event.detail <= 0) return translated(type.words).arg(figure(value));
            return translated(QT_TRANSLATE_NOOP("fulcrum::event_lines", "Too much force: %1 N (limit %2 N)"))
                .arg(figure(value), figure(event.detail * 1e-3));
        case LineContent::samples:
            return translated(QT_TRANSLATE_NOOP("fulcrum::event_lines", "%1 samples lost")).arg(event.detail);
        case LineContent::piece:
            if (value < least_piece) return {};
            return translated(type.words).arg(figure(value * to_mm2));
        case LineContent::activation:
            if (activation_of(event).clear) return name_of(type);
            return translated(QT_TRANSLATE_NOOP("fulcrum::event_lines", "Energy on %1 mm from the nerve"))
                .arg(figure(value * to_mm));
        case LineContent::clip:
            if (event.detail < 0) return name_of(type);
            return translated(QT_TRANSLATE_NOOP("fulcrum::event_lines", "Clip on a bleeding point"));
        case LineContent::nerve:
            return nerve_injury_of(event).cause == InjuryCause::blade
                       ? translated(QT_TRANSLATE_NOOP("fulcrum::event_lines", "Nerve divided by a blade"))
                       : translated(QT_TRANSLATE_NOOP("fulcrum::event_lines", "Nerve injured by heat"));
    }
    return {};
}

}  // namespace

bool is_critical(EventKind kind) {
    return weight_of(kind) == EventWeight::critical;
}

bool is_penalty(EventKind kind) {
    return weight_of(kind) != EventWeight::ordinary;
}

QString event_words(const Event& event, const std::vector<std::string>& tissues) {
    const EventType* type = find_type(event.kind);
    if (type == nullptr) return {};
    const QString line = words_of_line(*type, event);
    if (line.isEmpty()) return {};
    QStringList parts{line};
    if (event.hand < 2) parts << hand_text(event.hand == 0 ? "left" : "right");
    if (event.tissue >= 0 && static_cast<std::size_t>(event.tissue) < tissues.size())
        parts << asset_text(tissues[static_cast<std::size_t>(event.tissue)]);
    return parts.join(QStringLiteral(", "));
}

}  // namespace fulcrum::ui
