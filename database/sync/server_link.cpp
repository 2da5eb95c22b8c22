// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/server_link.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include "database/rows/errors.h"
#include "database/store/station_key.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::database {
namespace {

constexpr const char* link_heading = "Fulcrum programme server 1: keep it secret";

std::string link_path(const std::string& station_id, const std::string& enrolment) {
    const QFileInfo key(QString::fromStdString(StationKey::path_of(station_id)));
    return (key.path() + '/' + key.completeBaseName()).toStdString() + ".server" +
           (enrolment.empty() ? "" : "." + enrolment);
}

[[noreturn]] void fail_link(const std::string& path, const Sentence& why) {
    throw StoreError(StoreErrorKind::failed,
                     {QT_TRANSLATE_NOOP("errors", "%1: the programme server of this station: %2"), path, why},
                     QT_TRANSLATE_NOOP("errors",
                                       "make its folder readable and writable for you, or move the file away "
                                       "and enrol the station again"));
}

std::optional<ServerLink> read_link(const std::string& path) {
    QFile file(QString::fromStdString(path));
    if (!file.exists()) return std::nullopt;
    if (!file.open(QIODevice::ReadOnly))
        fail_link(path,
                  {QT_TRANSLATE_NOOP("errors", "cannot be read (%1)"), file.errorString().toStdString()});
    constexpr qint64 longest = 65536;
    constexpr int lines_of_link = 6;
    const QList<QByteArray> lines = file.read(longest).split('\n');
    if (lines.size() != lines_of_link || lines[0] != link_heading || lines[3].isEmpty() ||
        !ServerAddress::is_address(lines[1].toStdString()))
        fail_link(path, QT_TRANSLATE_NOOP("errors", "is damaged"));
    ServerLink link;
    link.address = ServerAddress::parse(lines[1].toStdString());
    link.server_id = lines[2].toStdString();
    link.password = lines[3].toStdString();
    for (const QByteArray& cohort : lines[4].split(' '))
        if (!cohort.isEmpty()) link.cohorts.push_back(cohort.toStdString());
    return link;
}

std::string text_of_link(const ServerLink& link) {
    std::string cohorts;
    for (const std::string& id : link.cohorts) cohorts += (cohorts.empty() ? "" : " ") + id;
    return std::string(link_heading) + '\n' + link.address.text() + '\n' + link.server_id + '\n' +
           link.password + '\n' + cohorts + '\n';
}

}  // namespace

std::optional<ServerLink> ServerLink::of(const std::string& station_id) {
    return read_link(link_path(station_id, {}));
}

std::optional<ServerLink> ServerLink::unfinished(const std::string& station_id,
                                                 const std::string& enrolment) {
    return read_link(link_path(station_id, enrolment));
}

bool ServerLink::begin(const std::string& station_id, const std::string& enrolment) const {
    const std::string path = link_path(station_id, enrolment);
    try {
        QDir().mkpath(QFileInfo(QString::fromStdString(path)).path());
        write_output_file(path, text_of_link(*this), OutputFile::Existing::keep,
                          OutputFile::Access::owner_only);
    } catch (const std::system_error& error) {
        if (error.code() == std::errc::file_exists) return false;
        fail_link(path, {QT_TRANSLATE_NOOP("errors", "cannot be written (%1)"), error.code().message()});
    }
    return true;
}

void ServerLink::finish(const std::string& station_id, const std::string& enrolment) const {
    const std::string path = link_path(station_id, {});
    try {
        write_output_file(path, text_of_link(*this), OutputFile::Existing::replace,
                          OutputFile::Access::owner_only);
    } catch (const std::system_error& error) {
        fail_link(path, {QT_TRANSLATE_NOOP("errors", "cannot be written (%1)"), error.code().message()});
    }
    QFile::remove(QString::fromStdString(link_path(station_id, enrolment)));
}

bool ServerLink::is_for(const ServerAddress& other) const {
    ServerAddress own = address, same = other;
    if (same.user.empty()) same.user = own.user;
    return own.text() == same.text();
}

}  // namespace fulcrum::database
