// SPDX-License-Identifier: GPL-3.0-or-later
// How figures, times and names are written on screens and on paper: one place, so that they agree everywhere.
#pragma once

#include <QString>
#include <QStringList>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "assessment/metrics/statement.h"
#include "assessment/task/attempt_words.h"
#include "sim_core/instrument/device.h"
#include "ui/language/words.h"

namespace fulcrum::ui {

inline QString text(const std::string& utf8) {
    return QString::fromStdString(utf8);
}
inline std::string plain(const QString& shown) {
    return shown.toStdString();
}
/// One line of text of several parts, "Surgery · attempt report", without the empty ones.
QString join_with_dots(QStringList parts);

/// What a device with force gave of the model's force: "Force was felt at 40 %."; empty where no device
/// rendered force.
QString felt_text(const ForceDevices& devices);
/// What the device of an attempt was and how often it was read: "Device: a scripted hand; 998 readings per
/// second (1000 stated); movement 150 %."
QString rig_text(const std::string& title, const RigUse& use);

/// A stored sentence (advice, a reason) in the reader's language; a text of an old store as it is.
QString statement_text(const Statement& statement);
/// A metric's name in the reader's language; the id where the program does not know the metric.
QString metric_text(const std::string& id);
/// A text of a metric's descriptor (name, explanation, advice) in the reader's language.
QString metric_words(const std::string& source);
/// A text of a task, a curriculum or a scene (title, briefing, step, tissue ...) in the reader's language. A
/// text that the program was not delivered with stays as it is.
QString asset_text(const std::string& english);
/// How the reader's language writes a day with its year, as QLocale takes it.
QString day_format();
/// An event's name in the reader's language, by its name in files.
QString event_text(const std::string& name);

/// A metric's value as it is shown: 3 significant digits below 100, whole numbers above, "–" when absent. No
/// unit.
QString figure(double value);
QString figure(const std::optional<double>& value);
/// Points in a column: always one decimal.
QString points_figure(const std::optional<double>& points);
/// Where a limit comes from, as a score stores it: "synthetic operators, seeds 1000-1999, set 4, 32 experts"
/// is shown as "32 simulated experts, benchmark set 4"; a limit that a set took over names the set too.
QString limit_source_text(const std::string& line);
/// A person's name in a list of people; "Ann (deactivated)" where nobody can sign in with the account.
QString account_text(const std::string& name, bool active);
/// With a capital letter, where words that are a part of sentences elsewhere are alone.
QString capital(QString words);
/// With its unit, "12.3 mm"; counts and dimensionless figures stand alone.
QString figure_with_unit(const std::optional<double>& value, const std::string& unit);
/// How far a value is on the worse side of the experts' mean, in their standard deviations: two decimals, and
/// beyond 5 only that; "–" when absent.
QString z_text(const std::optional<double>& z);
/// "61 of 100 points".
QString points_text(double points);
/// The unit as it is written behind a figure: "" for counts and dimensionless.
QString unit_text(const std::string& unit);
/// "2:05.3" (minutes, seconds, tenths).
QString clock_text(double seconds);
/// "5 min", "7:30 min": a limit of time, without tenths.
QString minutes_text(double seconds);
/// Local date and time of a UTC time, "21 Nov 2026 04:15"; "–" for 0.
QString local_time(std::int64_t utc_ms);
/// "passed", "passed (provisional)", "failed", "not scored".
QString verdict(const std::optional<bool>& passed, bool provisional);
/// The state of an attempt in words.
QString attempt_state(AttemptState state);
/// "assessed", "practice".
QString mode_text(AttemptMode mode);
/// A person's name; a synthetic person is marked as such, once.
QString person_text(const std::string& name, bool synthetic);
/// "left hand", "right hand" or "".
QString hand_text(const std::string& hand);
/// "mouse and keyboard", "haptic device" ...
QString device_class_text(DeviceClass device_class);
/// Of "path_len@1", "sparc@2" ...: "all 64 at version 1" or "61 at version 1; sparc@2, tremor@3", every one
/// of them, in a line; "–" for none.
QString versions_in_short(const std::vector<std::string>& versions);

}  // namespace fulcrum::ui
