// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/event_words.h"

#include <QCoreApplication>
#include <algorithm>

#include "sim_core/telemetry/event_errors.h"
#include "sim_core/telemetry/event_names.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

/// Errors have their weight from the table of errors (sim_core/telemetry/event_errors.h).
enum class Weight { ordinary, fault };

/// What a line says of its event's numbers. %1 is the value times `scale`, or the detail counted from 1; a
/// line without words says what the event is called.
enum class Number { none, value, count, number_and_value };
struct EventLineRow {
    EventKind kind;
    Weight weight = Weight::ordinary;
    const char* words = nullptr;
    Number number = Number::none;
    double scale = 1;
};

constexpr const char* context = "fulcrum::event_lines";
constexpr double to_mm = 1e3, to_mm2 = 1e6;

/// The events that are worth a line.
constexpr EventLineRow event_lines[] = {
    {EventKind::attempt_begin},
    {EventKind::first_movement},
    {EventKind::phase_begin, Weight::ordinary, QT_TRANSLATE_NOOP("fulcrum::event_lines", "Step %1 begins"),
     Number::count},
    {EventKind::target_reached, Weight::ordinary, QT_TRANSLATE_NOOP("fulcrum::event_lines", "Target %1 held"),
     Number::count},
    {EventKind::grasp},
    {EventKind::release},
    {EventKind::slip},
    {EventKind::drop},
    {EventKind::regrasp},
    {EventKind::over_force_begin, Weight::ordinary,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Too much force: %1 N"), Number::value},
    {EventKind::perforation, Weight::ordinary,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Perforation at %1 N"), Number::value},
    {EventKind::tool_collision},
    {EventKind::pause},
    {EventKind::resume},
    {EventKind::device_lost, Weight::fault},
    {EventKind::device_back},
    {EventKind::device_fault, Weight::fault},
    {EventKind::simulator_fault, Weight::fault},
    {EventKind::completed},
    {EventKind::abandoned},
    {EventKind::timed_out},
    {EventKind::interrupted},
    {EventKind::samples_lost},
    {EventKind::tear},
    {EventKind::jaw_pressure, Weight::ordinary,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Jaw pressure %1 kPa"), Number::value},
    {EventKind::cut_begin},
    {EventKind::cut_end},
    {EventKind::piece_fallen, Weight::ordinary,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "A piece of %1 mm² came free"), Number::value, to_mm2},
    {EventKind::activation_begin},
    {EventKind::activation_end},
    {EventKind::band_divided, Weight::ordinary,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Band %1 divided at %2 N"), Number::number_and_value},
    {EventKind::bleed_begin, Weight::ordinary,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Bleeding, %1 mL/min"), Number::value},
    {EventKind::bleed_end, Weight::ordinary,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Bleeding stopped after %1 mL"), Number::value},
    {EventKind::clip_applied},
    {EventKind::vessel_injury},
    {EventKind::nerve_injury},
    {EventKind::tool_exchanged},
    {EventKind::fibres_parted},
    {EventKind::lens_contact},
    {EventKind::target_lost, Weight::ordinary,
     QT_TRANSLATE_NOOP("fulcrum::event_lines", "Tip framed after %1 s without it"), Number::value},
};

constexpr double least_piece = 1e-6;  // m2: smaller pieces cannot be seen to come free

const EventLineRow* line_of(EventKind kind) {
    const auto* const found = std::find_if(std::begin(event_lines), std::end(event_lines),
                                           [&](const EventLineRow& row) { return row.kind == kind; });
    return found == std::end(event_lines) ? nullptr : found;
}

QString translated(const char* source) {
    return QCoreApplication::translate(context, source);
}

/// Lines that depend on more than one of the event's fields; "" for the others.
QString special_words(const Event& event) {
    switch (event.kind) {
        case EventKind::samples_lost:
            return translated(QT_TRANSLATE_NOOP("fulcrum::event_lines", "%1 samples lost")).arg(event.detail);
        case EventKind::over_force_begin:
            if (event.detail <= 0) return {};
            return translated(QT_TRANSLATE_NOOP("fulcrum::event_lines", "Too much force: %1 N (limit %2 N)"))
                .arg(figure(static_cast<double>(event.value)), figure(event.detail * 1e-3));
        case EventKind::activation_begin:
            if (activation_of(event).clear) return {};
            return translated(QT_TRANSLATE_NOOP("fulcrum::event_lines", "Energy on %1 mm from the nerve"))
                .arg(figure(static_cast<double>(event.value) * to_mm));
        case EventKind::clip_applied:
            if (event.detail < 0) return {};
            return translated(QT_TRANSLATE_NOOP("fulcrum::event_lines", "Clip on a bleeding point"));
        case EventKind::nerve_injury:
            return nerve_injury_of(event).cause == InjuryCause::blade
                       ? translated(QT_TRANSLATE_NOOP("fulcrum::event_lines", "Nerve divided by a blade"))
                       : translated(QT_TRANSLATE_NOOP("fulcrum::event_lines", "Nerve injured by heat"));
        default:
            return {};
    }
}

QString words_of_line(const EventLineRow& row, const Event& event) {
    const QString special = special_words(event);
    if (!special.isEmpty()) return special;
    if (row.words == nullptr) {
        QString name = event_text(event_name(event.kind));
        if (!name.isEmpty()) name[0] = name[0].toUpper();
        return name;
    }
    const QString value = figure(static_cast<double>(event.value) * row.scale);
    switch (row.number) {
        case Number::value:
            return translated(row.words).arg(value);
        case Number::count:
            return translated(row.words).arg(event.detail + 1);
        case Number::number_and_value:
            return translated(row.words).arg(event.detail + 1).arg(value);
        case Number::none:
            break;
    }
    return translated(row.words);
}

}  // namespace

bool is_critical(EventKind kind) {
    return error_weight(kind) == ErrorWeight::critical;
}

bool is_penalty(EventKind kind) {
    const EventLineRow* row = line_of(kind);
    return is_error(kind) || (row != nullptr && row->weight == Weight::fault);
}

QString event_words(const Event& event, const std::vector<std::string>& tissues) {
    const EventLineRow* row = line_of(event.kind);
    if (row == nullptr) return {};
    if (event.kind == EventKind::piece_fallen && static_cast<double>(event.value) < least_piece) return {};
    QStringList parts{words_of_line(*row, event)};
    if (event.hand < 2) parts << hand_text(event.hand == 0 ? "left" : "right");
    if (event.tissue >= 0 && static_cast<std::size_t>(event.tissue) < tissues.size())
        parts << asset_text(tissues[static_cast<std::size_t>(event.tissue)]);
    return parts.join(QStringLiteral(", "));
}

}  // namespace fulcrum::ui
