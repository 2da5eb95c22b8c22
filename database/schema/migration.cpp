// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/schema/migration.h"

#include <QDir>
#include <QFile>
#include <QStringList>

// A static library's resources are dropped by the linker unless something names them; the macro must stand
// outside any namespace.
static void load_schema_resources() {
    Q_INIT_RESOURCE(schema);
}

namespace fulcrum::database {
namespace {

const QString folder = QStringLiteral(":/fulcrum/database/schema");

QStringList steps() {
    load_schema_resources();
    return QDir(folder).entryList({QStringLiteral("*.sql")}, QDir::Files, QDir::Name);
}

}  // namespace

int latest_schema_version() {
    static const int version = static_cast<int>(steps().size());
    return version;
}

QString schema_step(int from) {
    const QString name = steps().at(from);
    QFile file(folder + "/" + name);
    if (!file.open(QIODevice::ReadOnly)) {
        throw StoreError(
            StoreErrorKind::failed,
            {QT_TRANSLATE_NOOP("errors", "the program has no schema step %1"), name.toStdString()},
            QT_TRANSLATE_NOOP("errors", "install it again"));
    }
    return QString::fromUtf8(file.readAll());
}

int read_schema_version(Connection& connection) {
    Query id(connection, "PRAGMA application_id");
    const std::int64_t found = id.next() ? id.integer(0) : 0;
    if (found != application_id) {
        throw StoreError(StoreErrorKind::not_a_store,
                         {QT_TRANSLATE_NOOP("errors", "%1: not a Fulcrum store"), connection.path()},
                         QT_TRANSLATE_NOOP("errors", "name the right file with --db"));
    }
    Query version(connection, "PRAGMA user_version");
    return version.next() ? static_cast<int>(version.integer(0)) : 0;
}

void migrate(Connection& connection, int target) {
    while (true) {
        // Read inside the transaction: two programs may open an old store at the same moment.
        Transaction transaction(connection);
        int from = 0;
        {
            // Closed before the step: a table cannot be dropped while a statement is open.
            Query version(connection, "PRAGMA user_version");
            if (version.next()) from = static_cast<int>(version.integer(0));
        }
        if (from >= target) return;
        connection.execute(schema_step(from));
        Query broken(connection, "PRAGMA foreign_key_check");
        if (broken.next()) {
            throw StoreError(
                StoreErrorKind::corrupt,
                {QT_TRANSLATE_NOOP("errors", "%1: rows of table %2 point nowhere after schema step %3"),
                 connection.path(), broken.text(0), from + 1},
                QT_TRANSLATE_NOOP("errors", "the store was left as it was; restore a backup or report this"));
        }
        connection.execute("PRAGMA user_version = " + QString::number(from + 1));
        transaction.commit();
    }
}

}  // namespace fulcrum::database
