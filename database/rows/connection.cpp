// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/rows/connection.h"

#include <sqlite3.h>
#include <sys/statvfs.h>

#include <QSqlDriver>
#include <QSqlError>
#include <QSqlField>
#include <QSqlRecord>
#include <atomic>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <random>
#include <thread>

#include "database/rows/server_refusal.h"

namespace fulcrum::database {
namespace {

std::string unique_connection_name() {
    static std::atomic<std::uint64_t> counter{0};
    return "fulcrum-" + std::to_string(counter.fetch_add(1));
}

/// Waits for another program's write: up to the patience of the connection, a random few milliseconds at a
/// time. SQLite's own waiting grows to 100 ms a time, and of eight programs at once the one that has waited
/// longest then asks the least often.
int wait_for_others(void* connection, int tries) {
    static thread_local std::chrono::steady_clock::time_point start;
    static thread_local std::minstd_rand random{std::random_device{}()};
    const auto now = std::chrono::steady_clock::now();
    if (tries == 0) start = now;
    const auto patience =
        std::chrono::milliseconds(static_cast<const Connection*>(connection)->busy_timeout_ms());
    if (now - start >= patience) return 0;
    std::this_thread::sleep_for(std::chrono::microseconds(500 + random() % 4500));
    return 1;
}

/// Nobody writes in the folder: it has no permission for it, or its file system is mounted read-only (which
/// permissions do not show).
bool is_fixed(const std::filesystem::path& folder) {
    std::error_code error;
    const auto permissions = std::filesystem::status(folder, error).permissions();
    if ((permissions & std::filesystem::perms::owner_write) == std::filesystem::perms::none) return true;
    struct statvfs system {};
    return ::statvfs(folder.c_str(), &system) == 0 && (system.f_flag & ST_RDONLY) != 0;
}

}  // namespace

Connection::Connection(const std::string& path, bool read_only, bool create, int busy_timeout_ms)
    : path_(path), name_(unique_connection_name()), read_only_(read_only), busy_timeout_ms_(busy_timeout_ms) {
    database_ = QSqlDatabase::addDatabase("QSQLITE", QString::fromStdString(name_));
    if (!database_.isValid()) {
        throw StoreError(
            StoreErrorKind::failed, QT_TRANSLATE_NOOP("errors", "the SQLite driver of Qt is missing"),
            QT_TRANSLATE_NOOP("errors", "install libqt5sql5-sqlite (and start within a Qt application)"));
    }
    QString options;
    QString name = QString::fromStdString(path);
    if (read_only) {
        options = "QSQLITE_OPEN_READONLY";
        // A store whose folder cannot be written has no room for SQLite's shared-memory file; without a log
        // next to it, it can be read as it is.
        const std::filesystem::path file(path);
        std::error_code error;
        if (is_fixed(file.parent_path().empty() ? "." : file.parent_path()) &&
            !std::filesystem::exists(path + "-wal", error)) {
            options += ";QSQLITE_OPEN_URI";
            name = "file:" + QString::fromUtf8(QByteArray::fromStdString(path).toPercentEncoding("/")) +
                   "?immutable=1";
        }
    } else if (!create && !std::filesystem::exists(path)) {
        throw StoreError(StoreErrorKind::missing,
                         {QT_TRANSLATE_NOOP("errors", "%1: there is no store"), path},
                         QT_TRANSLATE_NOOP(
                             "errors", "create one with `fulcrum db create`, or name another one with --db"));
    }
    database_.setConnectOptions(options);
    database_.setDatabaseName(name);
    if (!database_.open()) {
        const QString text = database_.lastError().text();
        const int code = database_.lastError().nativeErrorCode().toInt();
        database_ = QSqlDatabase();
        QSqlDatabase::removeDatabase(QString::fromStdString(name_));
        fail(text, code == 0 ? SQLITE_CANTOPEN : code);
    }
    sqlite3_extended_result_codes(handle(), 1);
    sqlite3_busy_handler(handle(), wait_for_others, this);
    execute("PRAGMA foreign_keys = ON");
    // KiB. With SQLite's 2 MiB the rows of a programme's attempts are read from the file again and again:
    // with 60,000 attempts reading them all takes 1.05 s, with this 0.75 s.
    execute("PRAGMA cache_size = -16384");
    // Full: a commit that was acknowledged survives a power cut; at one commit a second it costs nothing that
    // matters.
    execute("PRAGMA synchronous = FULL");
}

Connection::Connection(const ServerAddress& server, bool read_only, const std::string& password)
    : path_(server.text()), name_(unique_connection_name()), read_only_(read_only), is_server_(true) {
    database_ = QSqlDatabase::addDatabase("QPSQL", QString::fromStdString(name_));
    if (!database_.isValid()) {
        throw StoreError(StoreErrorKind::failed,
                         QT_TRANSLATE_NOOP("errors", "the PostgreSQL driver of Qt is missing"),
                         QT_TRANSLATE_NOOP("errors", "install libqt5sql5-psql"));
    }
    if (!server.host.empty()) database_.setHostName(QString::fromStdString(server.host));
    if (!server.database.empty()) database_.setDatabaseName(QString::fromStdString(server.database));
    if (!server.user.empty()) database_.setUserName(QString::fromStdString(server.user));
    if (server.port != 0) database_.setPort(server.port);
    if (!password.empty()) database_.setPassword(QString::fromStdString(password));
    database_.setConnectOptions(QString::fromStdString(server.options()));
    const auto asked = std::chrono::steady_clock::now();
    if (!database_.open()) {
        const bool answered = std::chrono::steady_clock::now() - asked < refused_within;
        const std::string said = database_.lastError().text().simplified().toStdString();
        database_ = QSqlDatabase();
        QSqlDatabase::removeDatabase(QString::fromStdString(name_));
        fail_to_connect(path_, answered ? refusal_of(server, password) : ServerRefusal::none, said);
    }
    set_up_server();
}

void Connection::set_up_server() {
    execute("SET client_min_messages = warning");  // the driver prints notices
    // The queries of a report are estimated to be large, and compiling one took more than running it:
    // all attempts of 200 trainees with 300 each in 1.75 s with it and 0.52 s without.
    execute("SET jit = off");
    if (read_only_) execute("SET SESSION CHARACTERISTICS AS TRANSACTION READ ONLY");
}

bool Connection::reconnected(const QSqlError& error) {
    const QString state = error.nativeErrorCode();
    const bool lost = state.isEmpty() || state.startsWith("08") || state.startsWith("57P");
    if (!lost || !read_only_ || depth_ > 0) return false;
    database_.close();
    if (!database_.open()) return false;
    set_up_server();
    return true;
}

Connection::~Connection() {
    database_.close();
    database_ = QSqlDatabase();
    QSqlDatabase::removeDatabase(QString::fromStdString(name_));
}

sqlite3* Connection::handle() const {
    const QVariant value = database_.driver() ? database_.driver()->handle() : QVariant();
    if (!value.isValid() || qstrcmp(value.typeName(), "sqlite3*") != 0) return nullptr;
    return *static_cast<sqlite3* const*>(value.constData());
}

void Connection::execute(const QString& sql) {
    if (is_server_) {
        begin_statement();
        QSqlQuery query(database_);
        if (!query.exec(sql)) fail(query.lastError());
        // Each statement has a result of its own, and the first that failed ends the rest.
        while (query.nextResult()) {
        }
        if (query.lastError().isValid()) fail(query.lastError());
        return;
    }
    char* message = nullptr;
    const int code = sqlite3_exec(handle(), sql.toUtf8().constData(), nullptr, nullptr, &message);
    if (code != SQLITE_OK) {
        const QString text = QString::fromUtf8(message != nullptr ? message : sqlite3_errstr(code));
        sqlite3_free(message);
        fail(text, code);
    }
}

void Connection::fail(const QString& text, int code) {
    if (code == 0 && handle() != nullptr) code = sqlite3_extended_errcode(handle());
    const std::string said = text.trimmed().toStdString();
    switch (code & 0xff) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
        case SQLITE_PROTOCOL:  // other programs kept changing the log's index while this one read it
            throw StoreError(
                StoreErrorKind::locked,
                {QT_TRANSLATE_NOOP("errors", "%1: another program is writing to the store"), path_},
                QT_TRANSLATE_NOOP("errors", "wait for it or close it, then try again; nothing was lost"));
        case SQLITE_READONLY:
        case SQLITE_PERM:
            throw StoreError(
                StoreErrorKind::read_only,
                {QT_TRANSLATE_NOOP("errors", "%1: the store cannot be written"), path_},
                QT_TRANSLATE_NOOP(
                    "errors", "make the file and its folder writable for this user, or open it read-only"));
        case SQLITE_CANTOPEN:
            throw StoreError(
                std::filesystem::exists(path_) ? StoreErrorKind::read_only : StoreErrorKind::missing,
                {QT_TRANSLATE_NOOP("errors", "%1: the store cannot be opened (%2)"), path_, said},
                QT_TRANSLATE_NOOP("errors",
                                  "check that the path is right and that this user may read and write the "
                                  "file and its folder"));
        case SQLITE_NOTADB:
            throw StoreError(StoreErrorKind::not_a_store,
                             {QT_TRANSLATE_NOOP("errors", "%1: not a Fulcrum store"), path_},
                             QT_TRANSLATE_NOOP("errors", "name the right file with --db"));
        case SQLITE_CORRUPT:
            throw StoreError(
                StoreErrorKind::corrupt,
                {QT_TRANSLATE_NOOP("errors", "%1: the store is damaged (%2)"), path_, said},
                QT_TRANSLATE_NOOP(
                    "errors", "run `fulcrum db check`, copy the file away, and restore the newest backup"));
        case SQLITE_FULL:
            throw StoreError(
                StoreErrorKind::disk_full,
                {QT_TRANSLATE_NOOP("errors", "%1: no room left on the disk"), path_},
                QT_TRANSLATE_NOOP("errors",
                                  "free some space and try again; what was stored before is intact"));
        case SQLITE_IOERR:
            throw StoreError(
                code == SQLITE_IOERR_WRITE || code == SQLITE_IOERR_SHMSIZE ? StoreErrorKind::disk_full
                                                                           : StoreErrorKind::failed,
                {QT_TRANSLATE_NOOP("errors", "%1: the disk reported an error (%2)"), path_, said},
                QT_TRANSLATE_NOOP(
                    "errors",
                    "check the disk's space and health and try again; what was stored before is intact"));
        case SQLITE_CONSTRAINT:
            throw StoreError(
                StoreErrorKind::conflict,
                {QT_TRANSLATE_NOOP("errors", "%1: refused by a rule of the store (%2)"), path_, said},
                QT_TRANSLATE_NOOP("errors", "correct the value and try again"));
        default:
            throw StoreError(StoreErrorKind::failed, {"%1: %2", path_, said},
                             QT_TRANSLATE_NOOP("errors", "run `fulcrum db check`"));
    }
}

void Connection::fail(const QSqlError& error) {
    if (!is_server_) fail(error.databaseText());
    fail_on_server(path_, error.nativeErrorCode().toStdString(),
                   error.databaseText().simplified().toStdString());
}

Query::Query(Connection& connection, const QString& sql)
    : connection_(connection), sql_(sql), query_(connection.database()) {
    if (connection_.is_server()) return;
    query_.setForwardOnly(true);
    if (!query_.prepare(sql)) connection_.fail(query_.lastError());
}

Query& Query::bind(const QVariant& value) {
    if (connection_.is_server()) {
        values_.push_back(value);
    } else {
        query_.addBindValue(value);
    }
    return *this;
}

/// The statement with each ? outside of quotes replaced by its value.
QString Query::with_values() const {
    QString text;
    std::size_t next = 0;
    bool quoted = false;
    for (const QChar c : sql_) {
        if (c == QLatin1Char('\'')) quoted = !quoted;
        if (c != QLatin1Char('?') || quoted) {
            text += c;
            continue;
        }
        const QVariant& value = values_.at(next++);
        if (value.isNull()) {
            text += QLatin1String("NULL");
            continue;
        }
        QSqlField field(QString(), value.type());
        field.setValue(value);
        text += connection_.database().driver()->formatValue(field);
    }
    return text;
}

Query& Query::bind(const std::string& value) {
    return bind(QVariant(QString::fromStdString(value)));
}
Query& Query::bind(const QByteArray& value) {
    return bind(QVariant(value));
}
Query& Query::bind(const std::vector<std::uint8_t>& value) {
    return bind(
        QVariant(QByteArray(reinterpret_cast<const char*>(value.data()), static_cast<int>(value.size()))));
}
Query& Query::bind(std::int64_t value) {
    return bind(QVariant(static_cast<qlonglong>(value)));
}
Query& Query::bind(double value) {
    if (!std::isfinite(value)) {
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "a number that is not finite cannot be stored"),
                         QT_TRANSLATE_NOOP("errors", "leave it out, with the reason"));
    }
    return bind(QVariant(value));
}
Query& Query::bind(const std::optional<double>& value) {
    return value ? bind(*value) : bind_null();
}
Query& Query::bind(const std::optional<bool>& value) {
    return value ? bind(*value) : bind_null();
}
Query& Query::bind_null() {
    return bind(QVariant());
}

void Query::run() {
    ran_ = true;
    if (connection_.is_server()) {
        connection_.begin_statement();
        if (!query_.exec(with_values())) {
            if (!connection_.reconnected(query_.lastError())) connection_.fail(query_.lastError());
            query_ = QSqlQuery(connection_.database());
            if (!query_.exec(with_values())) connection_.fail(query_.lastError());
        }
    } else if (!query_.exec()) {
        connection_.fail(query_.lastError());
    }
    columns_ = query_.record().count();  // made again at each call
}

Query& Query::again() {
    query_.finish();
    values_.clear();
    ran_ = has_ahead_ = false;
    return *this;
}

void Query::read_ahead() {
    has_ahead_ = query_.next();
    if (!has_ahead_) {
        if (query_.lastError().isValid()) connection_.fail(query_.lastError());
        return;
    }
    ahead_.resize(static_cast<std::size_t>(columns_));
    for (int column = 0; column < columns_; ++column) {
        QVariant value = query_.value(column);
        // The driver for PostgreSQL gives integers from 0 up as unsigned ones.
        if (value.type() == QVariant::ULongLong) value.convert(QVariant::LongLong);
        ahead_[static_cast<std::size_t>(column)] = std::move(value);
    }
}

bool Query::next() {
    if (!ran_) {
        run();
        read_ahead();
    }
    if (!has_ahead_) return false;
    row_.swap(ahead_);
    read_ahead();
    return true;
}

std::string Query::text(int column) const {
    return value(column).toString().toStdString();
}
std::int64_t Query::integer(int column) const {
    return value(column).toLongLong();
}
double Query::real(int column) const {
    return value(column).toDouble();
}
bool Query::is_null(int column) const {
    return value(column).isNull();
}
std::optional<double> Query::optional_real(int column) const {
    if (is_null(column)) return std::nullopt;
    return real(column);
}
std::optional<bool> Query::optional_flag(int column) const {
    if (is_null(column)) return std::nullopt;
    return flag(column);
}
std::vector<std::uint8_t> Query::bytes(int column) const {
    const QByteArray bytes = value(column).toByteArray();
    return std::vector<std::uint8_t>(bytes.begin(), bytes.end());
}
int Query::rows_changed() const {
    return query_.numRowsAffected();
}

Transaction::Transaction(Connection& connection) : connection_(connection) {
    if (connection_.depth_ == 0) connection_.execute(connection_.is_server() ? "BEGIN" : "BEGIN IMMEDIATE");
    ++connection_.depth_;
}

Transaction::~Transaction() {
    if (!open_) return;
    --connection_.depth_;
    if (connection_.depth_ != 0) return;
    // A failed rollback leaves nothing to do: the database has already rolled back on such errors.
    if (connection_.is_server()) {
        if (connection_.database().isOpen()) QSqlQuery(connection_.database()).exec("ROLLBACK");
    } else {
        sqlite3_exec(connection_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
    }
}

void Transaction::commit() {
    if (connection_.depth_ == 1) connection_.execute("COMMIT");
    open_ = false;
    --connection_.depth_;
}

}  // namespace fulcrum::database
