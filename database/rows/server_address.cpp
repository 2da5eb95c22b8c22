// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/rows/server_address.h"

#include <QUrl>
#include <QUrlQuery>
#include <algorithm>

#include "database/rows/errors.h"

namespace fulcrum::database {
namespace {

[[noreturn]] void refuse(const Sentence& problem, const Sentence& hint) {
    throw StoreError(StoreErrorKind::bad_value,
                     {QT_TRANSLATE_NOOP("errors", "the address of the server %1"), problem}, hint);
}

const char* hint_of(ServerRefusal why, const std::string& said) {
    switch (why) {
        case ServerRefusal::password:
            return QT_TRANSLATE_NOOP(
                "errors",
                "put the right password into ~/.pgpass (HOST:PORT:DATABASE:USER:PASSWORD, mode 0600), or "
                "name such a file in PGPASSFILE");
        case ServerRefusal::account:
            return QT_TRANSLATE_NOOP(
                "errors",
                "name the account that the administrator of the server made for this station or this person; "
                "if its access was withdrawn, ask the server's owner for a new token (`fulcrum server "
                "enrol`)");
        case ServerRefusal::database:
            return QT_TRANSLATE_NOOP(
                "errors",
                "have the administrator of the server make it: createdb, then `fulcrum server create`");
        case ServerRefusal::rule:
            return QT_TRANSLATE_NOOP("errors",
                                     "have the server's administrator allow this account from this machine "
                                     "in pg_hba.conf, with hostssl");
        case ServerRefusal::none:
            break;
    }
    // Words of libpq, not of the server: in English or German ("certificate verify failed", "root certificate
    // file"); the name of the protocol is the same in every language.
    const auto contains = [&said](const char* words) { return said.find(words) != std::string::npos; };
    if (contains("does not match host name") || contains("nicht mit dem Hostnamen"))
        return QT_TRANSLATE_NOOP("errors",
                                 "write the server's name in the address as its certificate names it, or "
                                 "have its administrator make a certificate for this name");
    if (contains("ertificate") || contains("ertifikat"))
        return QT_TRANSLATE_NOOP(
            "errors",
            "the server's certificate is not known here: ask its administrator for the certificate of the "
            "authority that made it, put that into ~/.postgresql/root.crt, or name its file in "
            "PGSSLROOTCERT; if it was known before, another machine may answer in the server's place");
    if (contains("SSL"))
        return QT_TRANSLATE_NOOP(
            "errors", "the connection must be encrypted: have the server's administrator turn ssl on");
    return QT_TRANSLATE_NOOP(
        "errors", "check the address, the network, and that the server runs, and try again; nothing is lost");
}

}  // namespace

ServerAddress ServerAddress::parse(const std::string& text) {
    const char* const form = QT_TRANSLATE_NOOP("errors", "write it as postgresql://USER@HOST:PORT/DATABASE");
    const QUrl url(QString::fromStdString(text), QUrl::StrictMode);
    if (!url.isValid() || (url.scheme() != "postgresql" && url.scheme() != "postgres"))
        refuse({QT_TRANSLATE_NOOP("errors", "'%1' cannot be read"),
                url.password().isEmpty() ? text : std::string("...")},
               form);
    if (!url.password().isEmpty())
        refuse(
            QT_TRANSLATE_NOOP("errors", "contains a password, which other users of this machine could read"),
            QT_TRANSLATE_NOOP("errors",
                              "leave it out; put it into the file ~/.pgpass "
                              "(HOST:PORT:DATABASE:USER:PASSWORD, mode 0600), or "
                              "name such a file in PGPASSFILE"));
    ServerAddress address;
    address.user = url.userName().toStdString();
    address.host = url.host().toStdString();
    address.port = url.port(0);
    address.database = url.path().mid(1).toStdString();
    for (const auto& [key, value] : QUrlQuery(url).queryItems(QUrl::FullyDecoded)) {
        if (key == "host") {
            address.host = value.toStdString();
        } else if (key == "port") {
            address.port = value.toInt();
        } else if (key == "service") {
            address.service = value.toStdString();
        } else {
            refuse({QT_TRANSLATE_NOOP("errors", "has the parameter '%1', which is not known"),
                    key.toStdString()},
                   QT_TRANSLATE_NOOP(
                       "errors",
                       "host, port and service are; for others use the environment variables of libpq"));
        }
    }
    const auto plain = [](const std::string& word) {
        return std::none_of(word.begin(), word.end(),
                            [](char c) { return c == ';' || c == '\'' || c == '\\' || c == ' '; });
    };
    if (!plain(address.service) || !plain(address.host) || !plain(address.user) || !plain(address.database))
        refuse(QT_TRANSLATE_NOOP("errors", "contains a quote, a space, a backslash or a semicolon"), form);
    if (address.database.empty() && address.service.empty())
        refuse(QT_TRANSLATE_NOOP("errors", "names no database"), form);
    return address;
}

bool ServerAddress::is_address(const std::string& text) {
    return text.rfind("postgresql://", 0) == 0 || text.rfind("postgres://", 0) == 0;
}

std::string ServerAddress::text() const {
    const bool socket = !host.empty() && host[0] == '/';
    std::string result = "postgresql://" + (user.empty() ? "" : user + "@") + (socket ? "" : host);
    if (port != 0 && !socket) result += ":" + std::to_string(port);
    result += "/" + database;
    char between = '?';
    const auto add = [&](const std::string& parameter) {
        result += between + parameter;
        between = '&';
    };
    if (socket) add("host=" + host);
    if (port != 0 && socket) add("port=" + std::to_string(port));
    if (!service.empty()) add("service=" + service);
    return result;
}

bool ServerAddress::is_local() const {
    return (host.empty() && service.empty()) || (!host.empty() && host[0] == '/') || host == "localhost" ||
           host == "127.0.0.1" || host == "::1";
}

std::string ServerAddress::options() const {
    std::string result = "connect_timeout=10;application_name=fulcrum";
    if (!service.empty()) result += ";service=" + service;
    // A stricter mode of the environment stays.
    const QByteArray wanted = qgetenv("PGSSLMODE");
    if (!is_local() && wanted != "verify-ca" && wanted != "verify-full") result += ";sslmode=require";
    return result;
}

void fail_to_connect(const std::string& server, ServerRefusal why, const std::string& said) {
    throw ConnectError(why, {QT_TRANSLATE_NOOP("errors", "%1: cannot connect (%2)"), server, said},
                       hint_of(why, said));
}

void fail_on_server(const std::string& server, const std::string& state, const std::string& said) {
    const std::string kind = state.substr(0, 2);
    const auto fail = [&](StoreErrorKind as, const Sentence& problem, const char* hint) {
        throw StoreError(as, {"%1: %2 (%3)", server, problem, said}, hint);
    };
    if (state.empty() || kind == "08" || kind == "57")
        fail(StoreErrorKind::unreachable, QT_TRANSLATE_NOOP("errors", "the connection was lost"),
             QT_TRANSLATE_NOOP("errors", "nothing is lost; try again when the server can be reached"));
    if (state == "42501")
        fail(StoreErrorKind::read_only,
             QT_TRANSLATE_NOOP("errors", "this account of the server may not do that"),
             QT_TRANSLATE_NOOP(
                 "errors",
                 "a station's account has to be a member of fulcrum_station, a person's is made by `fulcrum "
                 "server grant`; create, grant and erase need the database's owner"));
    if (kind == "23" || state == "P0001")
        fail(StoreErrorKind::conflict, QT_TRANSLATE_NOOP("errors", "refused by a rule of the server"),
             QT_TRANSLATE_NOOP("errors",
                               "sync again; if it is refused again, `fulcrum db check` looks at this store"));
    if (kind == "40" || state == "55P03")
        fail(StoreErrorKind::locked, QT_TRANSLATE_NOOP("errors", "another station is writing the same rows"),
             QT_TRANSLATE_NOOP("errors", "sync again"));
    if (kind == "53")
        fail(StoreErrorKind::disk_full,
             QT_TRANSLATE_NOOP("errors", "the server has no room or no connection left"),
             QT_TRANSLATE_NOOP("errors",
                               "tell its administrator, then sync again; what was stored before is intact"));
    if (state == "42883" || state == "42P01")
        fail(
            StoreErrorKind::older_schema,
            QT_TRANSLATE_NOOP("errors", "the server was set up by an older program"),
            QT_TRANSLATE_NOOP("errors",
                              "have its administrator run `fulcrum server create` with this program; nothing "
                              "is lost"));
    throw StoreError(StoreErrorKind::failed,
                     {QT_TRANSLATE_NOOP("errors", "%1: the server refused (%2)"), server, said},
                     QT_TRANSLATE_NOOP("errors", "tell its administrator"));
}

}  // namespace fulcrum::database
