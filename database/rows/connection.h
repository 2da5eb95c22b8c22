// SPDX-License-Identifier: GPL-3.0-or-later
// One connection to a store (SQLite) or to a programme server (PostgreSQL), with queries and transactions
// whose failures are StoreErrors. Internal to this floor.
#pragma once

#include <QSqlDatabase>
#include <QSqlQuery>
#include <QString>
#include <QVariant>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "database/rows/errors.h"
#include "database/rows/server_address.h"

struct sqlite3;
class QSqlError;

namespace fulcrum::database {

class Connection {
  public:
    /// Opens the file; throws StoreError. `create` false: the file must exist.
    Connection(const std::string& path, bool read_only, bool create, int busy_timeout_ms);
    /// Connects to a programme server, with `password` or with the one that libpq finds. Throws StoreError
    /// unreachable. `read_only`: the server refuses every write, and a lost connection is made again at the
    /// next statement.
    explicit Connection(const ServerAddress& server, bool read_only = false,
                        const std::string& password = {});
    ~Connection();
    Connection(const Connection&) = delete;
    Connection& operator=(const Connection&) = delete;

    bool is_server() const noexcept { return is_server_; }
    /// The file, or the address of the server.
    const std::string& path() const noexcept { return path_; }
    bool is_read_only() const noexcept { return read_only_; }
    /// How long a statement waits for another program's write before it fails as locked.
    int busy_timeout_ms() const noexcept { return busy_timeout_ms_; }
    QSqlDatabase& database() noexcept { return database_; }
    sqlite3* handle() const;
    /// Any number of statements, no results.
    void execute(const QString& sql);
    /// Throws what the last failure of this connection means; `code` an SQLite extended result code, 0: ask
    /// the handle.
    [[noreturn]] void fail(const QString& text, int code = 0);
    [[noreturn]] void fail(const QSqlError& error);
    /// Called before each statement for a server; may throw, and the statement is not sent then.
    void watch(std::function<void()> watcher) { watcher_ = std::move(watcher); }
    bool in_transaction() const noexcept { return depth_ > 0; }

  private:
    friend class Transaction;
    friend class Query;
    void begin_statement() const {
        if (watcher_) watcher_();
    }
    void set_up_server();
    /// After a failed statement: the connection was lost, nothing depended on it, and there is a new one.
    bool reconnected(const QSqlError& error);
    std::string path_, name_;
    bool read_only_ = false, is_server_ = false;
    int busy_timeout_ms_ = 0;
    int depth_ = 0;
    std::function<void()> watcher_;
    QSqlDatabase database_;
};

/// One statement. Bind in order, run, then read rows. Reads one row ahead: a statement whose rows were all
/// read has ended, and with it its view of the store, which a transaction begun later must not inherit
/// (SQLite refuses that as busy, without waiting, once another program has written). For a server the values
/// are written into the statement, escaped by the driver: one message for each run.
class Query {
  public:
    Query(Connection& connection, const QString& sql);
    Query& bind(const std::string& value);
    Query& bind(const char* value) { return bind(std::string(value)); }
    Query& bind(const QByteArray& value);
    Query& bind(const std::vector<std::uint8_t>& value);
    Query& bind(std::int64_t value);
    Query& bind(int value) { return bind(static_cast<std::int64_t>(value)); }
    Query& bind(bool value) { return bind(static_cast<std::int64_t>(value)); }
    /// Throws StoreError bad_value if not finite.
    Query& bind(double value);
    Query& bind(const std::optional<double>& value);
    Query& bind(const std::optional<bool>& value);
    Query& bind_null();
    /// As row() gave it, of either kind of database.
    Query& bind(const QVariant& value);
    void run();
    /// Ready to be bound and run once more.
    Query& again();
    /// Runs at the first call. False after the last row.
    bool next();
    std::string text(int column) const;
    std::int64_t integer(int column) const;
    bool flag(int column) const { return integer(column) != 0; }
    double real(int column) const;
    bool is_null(int column) const;
    std::optional<double> optional_real(int column) const;
    std::optional<bool> optional_flag(int column) const;
    std::vector<std::uint8_t> bytes(int column) const;
    int rows_changed() const;
    /// All values of the row that next() read.
    const std::vector<QVariant>& row() const noexcept { return row_; }

  private:
    const QVariant& value(int column) const { return row_.at(static_cast<std::size_t>(column)); }
    void read_ahead();
    QString with_values() const;

    Connection& connection_;
    QString sql_;                   // of a server's statement
    std::vector<QVariant> values_;  // bound to it
    QSqlQuery query_;
    bool ran_ = false, has_ahead_ = false;
    int columns_ = 0;
    std::vector<QVariant> row_, ahead_;
};

/// BEGIN IMMEDIATE (a server: BEGIN); rolled back unless committed. Nested ones join the outer.
class Transaction {
  public:
    explicit Transaction(Connection& connection);
    ~Transaction();
    Transaction(const Transaction&) = delete;
    Transaction& operator=(const Transaction&) = delete;
    void commit();

  private:
    Connection& connection_;
    bool open_ = true;
};

}  // namespace fulcrum::database
