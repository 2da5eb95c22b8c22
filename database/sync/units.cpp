// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/sync/units.h"

#include <QDataStream>
#include <QIODevice>
#include <QSqlRecord>
#include <algorithm>
#include <iterator>

namespace fulcrum::database {
namespace {

QString joined(const std::vector<std::string>& words) {
    QString text;
    for (const std::string& word : words) text += (text.isEmpty() ? "" : ", ") + QString::fromStdString(word);
    return text;
}

QString marks(std::size_t count) {
    return QStringList(QVector<QString>(static_cast<int>(count), QStringLiteral("?")).toList()).join(", ");
}

/// The same bytes for the same values from either engine.
QByteArray bytes_of(const SyncRow& row) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream.setVersion(QDataStream::Qt_5_15);
    for (const QVariant& value : row) {
        if (value.isNull()) {
            stream << 'n';
        } else if (value.type() == QVariant::Double) {
            stream << 'd' << value.toDouble();
        } else if (value.type() == QVariant::Int || value.type() == QVariant::LongLong) {
            stream << 'i' << value.toLongLong();
        } else {
            stream << 't' << value.toByteArray();
        }
    }
    return bytes;
}

/// Rows in statements of at most so many values and bytes.
void insert_rows(Connection& connection, const char* table, const std::vector<std::string>& names,
                 const std::vector<SyncRow>& rows, const QString& conflict) {
    constexpr std::size_t most_values = 8000;
    constexpr int most_bytes = 1 << 20;
    const std::size_t at_once =
        connection.is_server() ? std::max<std::size_t>(1, most_values / names.size()) : 1;
    for (std::size_t first = 0; first < rows.size();) {
        std::size_t count = 0;
        for (int bytes = 0; count < at_once && first + count < rows.size() && bytes < most_bytes; ++count)
            for (const QVariant& value : rows[first + count])
                if (value.type() == QVariant::ByteArray) bytes += value.toByteArray().size();
        QString groups;
        for (std::size_t i = 0; i < count; ++i) groups += (i == 0 ? "(" : ", (") + marks(names.size()) + ")";
        Query statement(connection,
                        QString("INSERT INTO %1 (%2) VALUES ").arg(table, joined(names)) + groups + conflict);
        for (std::size_t i = 0; i < count; ++i)
            for (const QVariant& value : rows[first + i]) statement.bind(value);
        statement.run();
        first += count;
    }
}

std::vector<std::string> columns_in(Connection& store, const char* table) {
    std::vector<std::string> names;
    const QSqlRecord record = store.database().record(table);
    for (int i = 0; i < record.count(); ++i) names.push_back(record.fieldName(i).toStdString());
    if (names.empty())
        throw StoreError(StoreErrorKind::failed,
                         {QT_TRANSLATE_NOOP("errors", "the store has no table %1"), std::string(table)},
                         QT_TRANSLATE_NOOP("errors", "run `fulcrum db check`"));
    return names;
}

/// Scores in force at `from` whose attempt has one at `to`. Two stations may have scored an attempt that was
/// cut off, neither knowing of the other's score.
std::set<std::string> scores_with_another(Connection& from, Connection& to) {
    const char* const sql = "SELECT attempt_id, id FROM score WHERE in_force = 1";
    std::set<std::string> scored, scores;
    Query there(to, sql);
    while (there.next()) scored.insert(there.text(0));
    Query here(from, sql);
    while (here.next())
        if (scored.count(here.text(0)) != 0) scores.insert(here.text(1));
    return scores;
}

}  // namespace

void copy_rows(Connection& from, Connection& to, const char* table, const char* where,
               const SyncRow& values) {
    const std::vector<std::string> names = columns_in(from, table);
    Query query(from, QString("SELECT %1 FROM %2 WHERE %3").arg(joined(names), table, where));
    for (const QVariant& value : values) query.bind(value);
    std::vector<SyncRow> rows;
    while (query.next()) rows.push_back(query.row());
    insert_rows(to, table, names, rows, " ON CONFLICT DO NOTHING");
}

Units::Columns Units::columns_of(Connection& layout, const char* table, const char* key) const {
    Columns columns{table, key, columns_in(layout, table)};
    const auto found = std::find(columns.names.begin(), columns.names.end(), key);
    columns.key_at = static_cast<std::size_t>(found - columns.names.begin());
    return columns;
}

Units::Units(const SyncTable& table, Connection& layout)
    : table_(table), root_(columns_of(layout, table.table, table.key[0])) {
    for (const ChildTable& child : table.children)
        children_.push_back(columns_of(layout, child.table, child.key));
}

std::set<std::string> Units::keys(Connection& connection, bool exchanged) const {
    Query rows(connection,
               QString::fromStdString("SELECT " + key_expression(table_) + " FROM " + table_.table +
                                      (exchanged ? std::string(" WHERE ") + table_.where : "")));
    std::set<std::string> keys;
    while (rows.next()) keys.insert(rows.text(0));
    return keys;
}

std::vector<std::string> Units::missing(Connection& from, Connection& to) const {
    const std::set<std::string> all = keys(from, true), there = keys(to, false);
    std::vector<std::string> missing;
    std::set_difference(all.begin(), all.end(), there.begin(), there.end(), std::back_inserter(missing));
    if (missing.empty() || std::string(table_.table) != "score") return missing;
    const std::set<std::string> kept = scores_with_another(from, to);
    missing.erase(std::remove_if(missing.begin(), missing.end(),
                                 [&](const std::string& key) { return kept.count(key) != 0; }),
                  missing.end());
    return missing;
}

std::map<std::string, UnitState> Units::states(Connection& connection) const {
    std::map<std::string, UnitState> states;
    const auto position = [&](const char* name) {
        const auto found = std::find(root_.names.begin(), root_.names.end(), name);
        return static_cast<int>(found - root_.names.begin());
    };
    const int version = position("version"), unique = table_.unique == nullptr ? -1 : position(table_.unique);
    Query roots(connection,
                QString("SELECT %1 FROM %2 WHERE %3").arg(joined(root_.names), table_.table, table_.where));
    while (roots.next()) {
        UnitState& state = states[roots.text(static_cast<int>(root_.key_at))];
        state.version = roots.integer(version);
        if (unique >= 0) state.unique = roots.text(unique);
        state.content = bytes_of(roots.row());
    }
    for (const Columns& child : children_) {
        std::map<std::string, std::vector<QByteArray>> rows_of;
        Query rows(connection, QString("SELECT %1 FROM %2").arg(joined(child.names), child.table));
        while (rows.next())
            rows_of[rows.text(static_cast<int>(child.key_at))].push_back(bytes_of(rows.row()));
        for (auto& [key, state] : states) {
            std::vector<QByteArray>& of = rows_of[key];
            std::sort(of.begin(), of.end());
            state.content += '|';
            for (const QByteArray& row : of) state.content += row;
        }
    }
    return states;
}

std::vector<Unit> Units::read(Connection& connection, const std::vector<std::string>& keys,
                              bool whole) const {
    std::vector<Unit> units;
    std::map<std::string, std::size_t> place;
    const QString in = " IN (" + marks(keys.size()) + ")";
    Query roots(connection, QString("SELECT %1, %2 FROM %3 WHERE %2")
                                    .arg(joined(root_.names), QString::fromStdString(key_expression(table_)),
                                         table_.table) +
                                in);
    for (const std::string& key : keys) roots.bind(key);
    while (roots.next()) {
        Unit unit;
        unit.key = roots.text(static_cast<int>(root_.names.size()));
        unit.root = {roots.row().begin(), roots.row().end() - 1};
        unit.children.resize(children_.size());
        place[unit.key] = units.size();
        units.push_back(std::move(unit));
    }
    for (std::size_t i = 0; i < children_.size(); ++i) {
        const Columns& child = children_[i];
        if (table_.children[i].up_only && !whole) continue;
        Query rows(
            connection,
            QString("SELECT %1 FROM %2 WHERE %3").arg(joined(child.names), child.table, child.key) + in);
        for (const std::string& key : keys) rows.bind(key);
        while (rows.next()) {
            const auto unit = place.find(rows.text(static_cast<int>(child.key_at)));
            if (unit != place.end()) units[unit->second].children[i].push_back(rows.row());
        }
    }
    return units;
}

void Units::add(Connection& connection, const std::vector<Unit>& units) const {
    // What belongs to a unit comes before it: an attempt that is there takes no more of a trace.
    for (std::size_t i = 0; i < children_.size(); ++i) {
        std::vector<SyncRow> rows;
        for (const Unit& unit : units)
            rows.insert(rows.end(), unit.children[i].begin(), unit.children[i].end());
        insert_rows(connection, children_[i].table, children_[i].names, rows, {});
    }
    std::vector<SyncRow> roots;
    for (const Unit& unit : units) roots.push_back(unit.root);
    std::vector<std::string> key(table_.key.begin(), table_.key.end());
    insert_rows(connection, root_.table, root_.names, roots, " ON CONFLICT (" + joined(key) + ") DO NOTHING");
}

int Units::replace(Connection& connection, const std::vector<Unit>& units, bool guarded) const {
    QString update;
    for (const std::string& name : root_.names) {
        if (name != root_.key)
            update += (update.isEmpty() ? "" : ", ") + QString::fromStdString(name + " = excluded." + name);
    }
    const QString sql =
        QString("INSERT INTO %1 (%2) VALUES (%3) ON CONFLICT (%4) DO UPDATE SET %5")
            .arg(root_.table, joined(root_.names), marks(root_.names.size()), root_.key, update) +
        (guarded ? QString(" WHERE %1.version < excluded.version").arg(root_.table) : QString());
    int written = 0;
    for (const Unit& unit : units) {
        Query root(connection, sql);
        for (const QVariant& value : unit.root) root.bind(value);
        root.run();
        if (root.rows_changed() == 0) continue;  // somebody else wrote a newer one since we looked
        ++written;
        for (std::size_t i = 0; i < children_.size(); ++i) {
            Query(connection,
                  QString("DELETE FROM %1 WHERE %2 = ?").arg(children_[i].table, children_[i].key))
                .bind(unit.key)
                .run();
            insert_rows(connection, children_[i].table, children_[i].names, unit.children[i], {});
        }
    }
    return written;
}

std::set<std::string> Units::values(const Unit& unit, const Reference& reference) const {
    std::set<std::string> values;
    const auto add = [&](const Columns& columns, const SyncRow& row) {
        const auto found = std::find(columns.names.begin(), columns.names.end(), reference.column);
        values.insert(
            row.at(static_cast<std::size_t>(found - columns.names.begin())).toString().toStdString());
    };
    if (std::string(reference.table) == root_.table) add(root_, unit.root);
    for (std::size_t i = 0; i < children_.size(); ++i) {
        if (std::string(reference.table) != children_[i].table) continue;
        for (const SyncRow& row : unit.children[i]) add(children_[i], row);
    }
    return values;
}

}  // namespace fulcrum::database
