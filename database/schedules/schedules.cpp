// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/schedules/schedules.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <QDateTime>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>

#include "database/rows/connection.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/store/audit.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

constexpr const char* key_start = "report_schedule ";

std::string key_of(const std::string& id) {
    return key_start + id;
}

/// A text, or what is said with what in its places.
QJsonValue value_of(const Sentence& sentence) {
    if (!sentence.marked()) return QString::fromStdString(sentence.words());
    QJsonArray parts;
    for (const Sentence& part : sentence.parts()) parts.append(value_of(part));
    return QJsonObject{{QStringLiteral("say"), QString::fromStdString(sentence.source())},
                       {QStringLiteral("with"), parts}};
}

Sentence sentence_in(const QJsonValue& value, int depth = 0) {
    constexpr int deepest = 8;
    if (!value.isObject() || depth == deepest) return value.toString().toStdString();
    const QJsonObject said = value.toObject();
    std::vector<Sentence> parts;
    const QJsonArray with = said.value(QLatin1String("with")).toArray();
    for (const auto& part : with) parts.push_back(sentence_in(part, depth + 1));
    return Sentence::from_parts(said.value(QLatin1String("say")).toString().toStdString(), true,
                                std::move(parts));
}

/// What is in the audit log: in English.
std::string audited_text(const ReportSchedule& schedule) {
    return json_object({{"cohort", schedule.cohort_id},
                        {"format", schedule.format},
                        {"folder", schedule.folder},
                        {"every", every_name(schedule.every)},
                        {"last", schedule.last_period},
                        {"problem", schedule.problem.words()}});
}

/// What is kept: older programs read "problem". The sentence, to be put into the reader's words, is a text
/// here, so that a cohort's id in it is not taken for that of the schedule (all_schedules).
std::string text_of(const ReportSchedule& schedule) {
    const QJsonDocument said(QJsonArray{value_of(schedule.problem)});
    return json_object({{"cohort", schedule.cohort_id},
                        {"format", schedule.format},
                        {"folder", schedule.folder},
                        {"every", every_name(schedule.every)},
                        {"last", schedule.last_period},
                        {"problem", schedule.problem.words()},
                        {"said", said.toJson(QJsonDocument::Compact).toStdString()}});
}

ReportSchedule schedule_of(const std::string& id, const std::string& text) {
    const QJsonObject said = QJsonDocument::fromJson(QByteArray::fromStdString(text)).object();
    const auto word = [&](const char* key) {
        return said.value(QLatin1String(key)).toString().toStdString();
    };
    ReportSchedule schedule;
    schedule.id = id;
    schedule.cohort_id = word("cohort");
    schedule.format = word("format");
    schedule.folder = word("folder");
    schedule.every =
        word("every") == every_name(ScheduleEvery::day) ? ScheduleEvery::day : ScheduleEvery::week;
    schedule.last_period = word("last");
    schedule.problem = word("problem");
    // An older program may have written the one without the other.
    const QJsonDocument kept_as = QJsonDocument::fromJson(QByteArray::fromStdString(word("said")));
    const Sentence kept = sentence_in(kept_as.array().at(0));
    if (kept.words() == schedule.problem.words()) schedule.problem = kept;
    return schedule;
}

std::vector<ReportSchedule> all_schedules(Connection& connection) {
    Query rows(
        connection,
        "SELECT s.key, s.value, COALESCE(c.name, '') FROM setting s LEFT JOIN cohort c ON s.value LIKE "
        "'%\"' || c.id || '\"%' WHERE s.key LIKE 'report_schedule %' ORDER BY s.key");
    std::vector<ReportSchedule> schedules;
    while (rows.next()) {
        schedules.push_back(schedule_of(rows.text(0).substr(std::string(key_start).size()), rows.text(1)));
        schedules.back().cohort_name = rows.text(2);
    }
    return schedules;
}

std::optional<ReportSchedule> find_schedule(const Store& store, const std::string& id) {
    for (ReportSchedule& one : all_schedules(store.connection()))
        if (one.id == id) return std::move(one);
    return std::nullopt;
}

}  // namespace

const char* every_name(ScheduleEvery every) {
    return every == ScheduleEvery::day ? "day" : "week";
}

std::string period_of(ScheduleEvery every, UtcMilliseconds time) {
    const QDate day = QDateTime::fromMSecsSinceEpoch(time, Qt::UTC).date();
    if (every == ScheduleEvery::day) return day.toString(Qt::ISODate).toStdString();
    int year = 0;
    const int week = day.weekNumber(&year);
    return QString("%1-W%2").arg(year).arg(week, 2, 10, QLatin1Char('0')).toStdString();
}

ScheduleLock::ScheduleLock(const Store& store) {
    std::error_code unknown;
    const std::filesystem::path path = std::filesystem::canonical(store.path(), unknown);
    const std::string file = (unknown ? store.path() : path.string()) + ".schedules";
    descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (descriptor_ < 0)
        throw StoreError(
            errno == ENOSPC ? StoreErrorKind::disk_full : StoreErrorKind::read_only,
            {QT_TRANSLATE_NOOP("errors", "%1: cannot be created (%2)"), file, std::strerror(errno)},
            QT_TRANSLATE_NOOP("errors", "make the store's folder writable and free some space on the disk"));
    held_ = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
}

ScheduleLock::~ScheduleLock() {
    if (descriptor_ >= 0) ::close(descriptor_);  // the file stays: without it two could hold two of them
}

std::string Schedules::add(const Session& director, const ReportSchedule& schedule) const {
    require_at_station(store_, director, Operation::export_cohort);
    store_.require(director, Operation::export_cohort, Subject::cohort(schedule.cohort_id));
    if (schedule.folder.empty() || schedule.folder[0] != '/')
        throw StoreError(
            StoreErrorKind::bad_value,
            {QT_TRANSLATE_NOOP("errors", "%1: the folder of a schedule is a path from /"), schedule.folder},
            QT_TRANSLATE_NOOP("errors", "a timer starts in another folder than you; give the whole path"));
    Transaction transaction(store_.connection());
    for (const ReportSchedule& one : all_schedules(store_.connection()))
        if (one.cohort_id == schedule.cohort_id && one.format == schedule.format &&
            one.folder == schedule.folder && one.every == schedule.every)
            throw StoreError(StoreErrorKind::conflict,
                             QT_TRANSLATE_NOOP("errors", "the same report is scheduled already"),
                             QT_TRANSLATE_NOOP("errors", "list the schedules"));
    ReportSchedule added = schedule;
    added.last_period.clear();
    added.problem = Sentence();
    std::string id = random_uuid();
    write_setting(store_.connection(), key_of(id), text_of(added));
    Audit(store_).append(director, schedule.cohort_id, "schedule.add", audited_text(added),
                         {{RecordKind::setting, key_of(id)}});
    transaction.commit();
    return id;
}

std::vector<ReportSchedule> Schedules::list(const Session& director) const {
    require_at_station(store_, director, Operation::export_cohort);
    return all_schedules(store_.connection());
}

void Schedules::remove(const Session& director, const std::string& id) const {
    require_at_station(store_, director, Operation::export_cohort);
    Transaction transaction(store_.connection());
    const std::optional<ReportSchedule> before = find_schedule(store_, id);
    if (!before)
        throw StoreError(StoreErrorKind::not_found, {QT_TRANSLATE_NOOP("errors", "no schedule %1"), id},
                         QT_TRANSLATE_NOOP("errors", "list the schedules and name one of them"));
    Query(store_.connection(), "DELETE FROM setting WHERE key = ?").bind(key_of(id)).run();
    Audit(store_).append(director, before->cohort_id, "schedule.remove", audited_text(*before),
                         {{RecordKind::setting, key_of(id)}});
    transaction.commit();
}

void Schedules::note(const Session& director, const std::string& id, const std::string& period,
                     const Sentence& problem) const {
    require_at_station(store_, director, Operation::export_cohort);
    Transaction transaction(store_.connection());
    std::optional<ReportSchedule> now = find_schedule(store_, id);
    if (!now) return;
    if (problem.empty()) now->last_period = period;
    now->problem = problem;
    write_setting(store_.connection(), key_of(id), text_of(*now));
    Audit(store_).append(director, now->cohort_id, problem.empty() ? "schedule.write" : "schedule.fail",
                         audited_text(*now), {{RecordKind::setting, key_of(id)}});
    transaction.commit();
}

}  // namespace fulcrum::database
