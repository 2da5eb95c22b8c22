// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/text.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <map>

#include "assessment/metrics/registry.h"
#include "assessment/metrics/statement_words.h"
#include "assessment/task/limit_source.h"
#include "sim_core/telemetry/event_types.h"
#include "ui/language/language.h"

namespace fulcrum::ui {
namespace {

QString words(const char* source) {
    return QCoreApplication::translate("fulcrum::ui::text", source);
}

std::string in_readers_language(const char* context, const char* source) {
    return QCoreApplication::translate(context, source).toStdString();
}

}  // namespace

QString statement_text(const Statement& statement) {
    static const QRegularExpression minus(QStringLiteral("(?<=[ (])-(?=[0-9])"));
    return text(words_of(statement, in_readers_language)).replace(minus, QString(QChar(0x2212)));
}

QString metric_text(const std::string& id) {
    const MetricDescriptor* metric = find_metric(id);
    return metric == nullptr ? text(id) : metric_words(metric->name);
}

QString metric_words(const std::string& source) {
    return QCoreApplication::translate("fulcrum::metrics", source.c_str());
}

QString asset_text(const std::string& english) {
    return english.empty() ? QString() : QCoreApplication::translate("assets", english.c_str());
}

QString day_format() {
    return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "d MMM yyyy"));
}

QString event_text(const std::string& name) {
    const EventType* row = find_row(event_kinds, name);
    return row == nullptr ? text(name) : QCoreApplication::translate("fulcrum::events", row->title);
}

QString join_with_dots(QStringList parts) {
    parts.removeAll(QString());
    return parts.join(QStringLiteral(" · "));
}

QString figure(double value) {
    if (!std::isfinite(value)) return QStringLiteral("–");
    const double size = std::abs(value);
    int decimals = 0;
    if (size < 1) {
        decimals = 3;
    } else if (size < 10) {
        decimals = 2;
    } else if (size < 100) {
        decimals = 1;
    }
    QString shown = QString::number(value, 'f', decimals);
    if (shown.contains(QLatin1Char('.'))) {
        while (shown.endsWith(QLatin1Char('0'))) shown.chop(1);
        if (shown.endsWith(QLatin1Char('.'))) shown.chop(1);
    }
    if (shown == QLatin1String("-0")) shown = QStringLiteral("0");
    return with_decimal_sign(shown).replace(QLatin1Char('-'), QChar(0x2212));
}

QString points_figure(const std::optional<double>& points) {
    return points ? decimal(*points, 1) : QStringLiteral("–");
}

QString limit_source_text(const std::string& line) {
    const LimitSource source = read_limit_source(line);
    const QString set = QString::number(source.set);
    switch (source.kind) {
        case LimitSource::Kind::words:
            return asset_text(source.of);
        case LimitSource::Kind::taken_over:
            return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "%1; taken over with benchmark set %2 (%3)"))
                .arg(asset_text(source.of), set, asset_text(source.site));
        case LimitSource::Kind::range:
            break;
    }
    QString shown =
        source.is_simulated()
            ? words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "%1 simulated experts, benchmark set %2"))
            : words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "%1 experts, benchmark set %2"));
    shown = shown.arg(QString::number(source.experts), set);
    if (!source.is_simulated()) shown += QStringLiteral(" (%1)").arg(asset_text(source.of));
    if (source.worst_counted)
        shown += words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "; the worst value that counts"));
    return shown;
}

QString account_text(const std::string& name, bool active) {
    return active ? text(name)
                  : words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "%1 (deactivated)")).arg(text(name));
}

QString capital(QString words) {
    if (!words.isEmpty()) words[0] = words[0].toUpper();
    return words;
}

QString figure(const std::optional<double>& value) {
    return value ? figure(*value) : QStringLiteral("–");
}

QString unit_text(const std::string& unit) {
    if (unit.empty() || unit == "count" || unit == "-" || unit == "1" || unit == "–" || unit == "share") {
        return {};
    }
    if (unit == "deg") return QStringLiteral("°");
    return text(unit);
}

QString figure_with_unit(const std::optional<double>& value, const std::string& unit) {
    if (!value) return QStringLiteral("–");
    const QString shown = unit_text(unit);
    if (shown.isEmpty() || unit == "deg") return figure(*value) + shown;
    return figure(*value) + QChar(0x202F) + shown;
}

QString z_text(const std::optional<double>& z) {
    if (!z || !std::isfinite(*z)) return QStringLiteral("–");
    if (*z < -z_shown_up_to) return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "below −5"));
    if (*z > z_shown_up_to) return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "above 5 (far outside)"));
    return decimal(*z, 2).replace(QLatin1Char('-'), QChar(0x2212));
}

QString points_text(double points) {
    return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "%1 of 100 points")).arg(figure(points));
}

QString clock_text(double seconds) {
    if (!std::isfinite(seconds) || seconds < 0) seconds = 0;
    // Rounded, as every other value: a time next to its gate is the same time.
    const auto tenths = std::llround(seconds * 10.0);
    return with_decimal_sign(QStringLiteral("%1:%2.%3")
                                 .arg(tenths / 600)
                                 .arg((tenths / 10) % 60, 2, 10, QLatin1Char('0'))
                                 .arg(tenths % 10));
}

QString minutes_text(double seconds) {
    const auto whole = std::llround(std::max(0.0, seconds));
    return whole % 60 == 0
               ? QStringLiteral("%1\u00a0min").arg(whole / 60)
               : QStringLiteral("%1:%2\u00a0min").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
}

QString local_time(std::int64_t utc_ms) {
    if (utc_ms == 0) return QStringLiteral("–");
    return QLocale().toString(QDateTime::fromMSecsSinceEpoch(utc_ms),
                              words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "d MMM yyyy HH:mm")));
}

QString verdict(const std::optional<bool>& passed, bool provisional) {
    if (!passed) return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "not scored"));
    if (!*passed) return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "failed"));
    return provisional ? words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "passed (provisional)"))
                       : words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "passed"));
}

QString attempt_state(AttemptState state) {
    return QCoreApplication::translate("fulcrum::attempts", row_of(attempt_states, state).title);
}

QString mode_text(AttemptMode mode) {
    return QCoreApplication::translate("fulcrum::attempts", row_of(attempt_modes, mode).title);
}

QString person_text(const std::string& name, bool synthetic) {
    const QString shown = text(name);
    // The demonstration's people carry it in their names.
    if (!synthetic || shown.contains(QLatin1String("(synthetic)"))) return shown;
    return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "%1 (synthetic)")).arg(shown);
}

QString hand_text(const std::string& hand) {
    if (hand == "left") return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "left hand"));
    if (hand == "right") return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "right hand"));
    return {};
}

QString felt_text(const ForceDevices& devices) {
    const auto percent = [](const ForceOutput& device) { return std::round(100 * device.scale); };
    const auto &left = devices[0], &right = devices[1];
    if (!left && !right) return {};
    if (left && right && percent(*left) != percent(*right))
        return words(QT_TRANSLATE_NOOP("fulcrum::ui::text",
                                       "Force was felt at %1 % by the left hand and at %2 % by the right."))
            .arg(percent(*left))
            .arg(percent(*right));
    if (left && right)
        return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "Force was felt at %1 %.")).arg(percent(*left));
    return (left ? words(QT_TRANSLATE_NOOP("fulcrum::ui::text",
                                           "Force was felt at %1 %, by the left hand only."))
                 : words(QT_TRANSLATE_NOOP("fulcrum::ui::text",
                                           "Force was felt at %1 %, by the right hand only.")))
        .arg(percent(left ? *left : *right));
}

QString rig_text(const std::string& title, const RigUse& use) {
    QStringList parts{title.empty() ? QString()
                                    : QCoreApplication::translate("fulcrum::device_list", title.c_str())};
    if (use.measured > 0 && use.stated > 0)
        parts << words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "%1 readings per second (%2 stated)"))
                     .arg(decimal(use.measured, 0), decimal(use.stated, 0));
    else if (use.measured > 0)
        parts << words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "%1 readings per second"))
                     .arg(decimal(use.measured, 0));
    else if (use.stated > 0)
        parts << words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "%1 readings per second stated"))
                     .arg(decimal(use.stated, 0));
    if (std::abs(use.motion - 1) > 1e-9)
        parts << words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "movement of the instrument %1 %"))
                     .arg(decimal(100 * use.motion, 0));
    const bool swapped = use.part[0] == 1 || use.part[1] == 0;
    if (swapped) parts << words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "left and right device swapped"));
    parts.removeAll(QString());
    return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "Device: %1.")).arg(parts.join(QStringLiteral("; ")));
}

QString device_class_text(DeviceClass device_class) {
    return QCoreApplication::translate("fulcrum::devices", row_of(device_classes, device_class).title);
}

QString versions_in_short(const std::vector<std::string>& versions) {
    const auto version_of = [](const std::string& one) { return one.substr(one.rfind('@') + 1); };
    std::map<std::string, int> counts;
    for (const std::string& one : versions) ++counts[version_of(one)];
    if (counts.empty()) return QStringLiteral("–");
    const auto most = std::max_element(counts.begin(), counts.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (counts.size() == 1) {
        return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "all %1 at version %2"))
            .arg(most->second)
            .arg(text(most->first));
    }
    QStringList others;
    for (const std::string& one : versions) {
        if (version_of(one) != most->first) others << text(one);
    }
    return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "%1 at version %2; %3"))
        .arg(most->second)
        .arg(text(most->first), others.join(QStringLiteral(", ")));
}

}  // namespace fulcrum::ui
