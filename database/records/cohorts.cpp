// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "database/records/people_rows.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/store/audit.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

enum class Table { members, educators };

QString table_name(Table table) {
    return table == Table::members ? "cohort_member" : "cohort_educator";
}

std::vector<std::string> ids_in(Connection& connection, Table table, const std::string& cohort_id) {
    Query rows(connection, "SELECT t.person_id FROM " + table_name(table) +
                               " t JOIN person p ON p.id = t.person_id WHERE t.cohort_id = ? ORDER BY "
                               "p.display_name, p.login_key");
    rows.bind(cohort_id);
    std::vector<std::string> ids;
    while (rows.next()) ids.push_back(rows.text(0));
    return ids;
}

std::string joined(const std::vector<std::string>& ids) {
    std::string text;
    for (const std::string& id : ids) text += (text.empty() ? "" : ", ") + id;
    return text;
}

void write_people(const Store& store, Table table, const std::string& cohort_id,
                  const std::vector<std::string>& person_ids) {
    Connection& connection = store.connection();
    Query(connection, "DELETE FROM " + table_name(table) + " WHERE cohort_id = ?").bind(cohort_id).run();
    for (const std::string& named : person_ids) {
        Person person = read_person(store, named);
        if (!person.merged_into.empty()) person = read_person(store, person.merged_into);
        const std::string& id = person.id;
        if (person.kind != PersonKind::real && !store.is_demo()) {
            throw StoreError(
                StoreErrorKind::bad_value,
                {QT_TRANSLATE_NOOP("errors", "%1 is not a real person (%2) and cannot be in a cohort"),
                 person.display_name, row_of(person_kinds, person.kind).name},
                QT_TRANSLATE_NOOP("errors", "choose real people only"));
        }
        const std::vector<Role>& roles = person.roles;
        if (table == Table::educators &&
            std::find(roles.begin(), roles.end(), Role::educator) == roles.end()) {
            throw StoreError(StoreErrorKind::bad_value,
                             {QT_TRANSLATE_NOOP("errors", "%1 is not an educator"), person.display_name},
                             QT_TRANSLATE_NOOP("errors", "have an administrator give them the role first"));
        }
        Query(connection, "INSERT INTO " + table_name(table) +
                              " (cohort_id, person_id) VALUES (?, ?) ON CONFLICT DO NOTHING")
            .bind(cohort_id)
            .bind(id)
            .run();
    }
}

void require_cohort(const Store& store, const std::string& cohort_id) {
    Query row(store.connection(), "SELECT 1 FROM cohort WHERE id = ?");
    row.bind(cohort_id);
    if (!row.next())
        throw StoreError(StoreErrorKind::not_found, {QT_TRANSLATE_NOOP("errors", "no cohort %1"), cohort_id},
                         QT_TRANSLATE_NOOP("errors", "list the cohorts and name one of them"));
}

void require_free_name(const Store& store, const std::string& name, const std::string& own_id) {
    Query row(store.connection(), "SELECT 1 FROM cohort WHERE name = ? AND id <> ?");
    row.bind(name).bind(own_id);
    if (row.next())
        throw StoreError(StoreErrorKind::conflict,
                         {QT_TRANSLATE_NOOP("errors", "a cohort \"%1\" exists"), name},
                         QT_TRANSLATE_NOOP("errors", "choose another name"));
}

std::string insert_cohort(const Store& store, const std::string& name) {
    require_free_name(store, name, "");
    std::string id = random_uuid();
    Query(store.connection(), "INSERT INTO cohort (id, name, created) VALUES (?, ?, ?)")
        .bind(id)
        .bind(name)
        .bind(store.now())
        .run();
    return id;
}

void replace_people(const Store& store, const Session& director, Table table, const std::string& cohort_id,
                    const std::vector<std::string>& person_ids) {
    store.require(director, Operation::manage_cohorts);
    Transaction transaction(store.connection());
    require_cohort(store, cohort_id);
    const std::string before = joined(ids_in(store.connection(), table, cohort_id));
    write_people(store, table, cohort_id, person_ids);
    Query(store.connection(), "UPDATE cohort SET version = version + 1 WHERE id = ?").bind(cohort_id).run();
    Audit(store).append(
        director, cohort_id, table == Table::members ? "cohort.set_members" : "cohort.set_educators",
        json_object({{"before", before}, {"after", joined(person_ids)}}), {{RecordKind::cohort, cohort_id}});
    transaction.commit();
}

}  // namespace

std::vector<Cohort> People::cohorts(const Session& session) const {
    store_.require(session, Operation::list_cohorts);
    const Scope scope = scope_of(session.role(), Operation::list_cohorts);
    QString where = "1 = 1";
    if (scope == Scope::own) where = "id IN (SELECT cohort_id FROM cohort_member WHERE person_id = ?)";
    if (scope == Scope::cohort) where = "id IN (SELECT cohort_id FROM cohort_educator WHERE person_id = ?)";
    std::vector<Cohort> cohorts;
    {
        Query rows(store_.connection(), "SELECT id, name FROM cohort WHERE " + where + " ORDER BY name");
        if (scope != Scope::programme) rows.bind(session.person_id());
        while (rows.next()) cohorts.push_back({rows.text(0), rows.text(1), {}, {}});
    }
    for (Cohort& cohort : cohorts) {
        // A trainee sees which cohort they are in, not who else is.
        cohort.members = scope == Scope::own ? std::vector<std::string>{session.person_id()}
                                             : ids_in(store_.connection(), Table::members, cohort.id);
        cohort.educators = ids_in(store_.connection(), Table::educators, cohort.id);
    }
    return cohorts;
}

std::optional<Cohort> People::find_cohort(const Session& session, const std::string& id_or_name) const {
    for (Cohort& cohort : cohorts(session)) {
        if (cohort.id == id_or_name || cohort.name == id_or_name) return std::move(cohort);
    }
    return std::nullopt;
}

std::string People::create_cohort(const Session& director, const std::string& name) const {
    store_.require(director, Operation::manage_cohorts);
    require_name(name, QT_TRANSLATE_NOOP("errors", "name of the cohort"));
    Transaction transaction(store_.connection());
    std::string id = insert_cohort(store_, name);
    Audit(store_).append(director, id, "cohort.create", json_object({{"name", name}}),
                         {{RecordKind::cohort, id}});
    transaction.commit();
    return id;
}

void People::rename_cohort(const Session& director, const std::string& cohort_id,
                           const std::string& name) const {
    store_.require(director, Operation::manage_cohorts);
    require_name(name, QT_TRANSLATE_NOOP("errors", "name of the cohort"));
    Transaction transaction(store_.connection());
    require_cohort(store_, cohort_id);
    require_free_name(store_, name, cohort_id);
    Query(store_.connection(), "UPDATE cohort SET name = ?, version = version + 1 WHERE id = ?")
        .bind(name)
        .bind(cohort_id)
        .run();
    Audit(store_).append(director, cohort_id, "cohort.rename", json_object({{"after", name}}),
                         {{RecordKind::cohort, cohort_id}});
    transaction.commit();
}

void People::set_members(const Session& director, const std::string& cohort_id,
                         const std::vector<std::string>& person_ids) const {
    replace_people(store_, director, Table::members, cohort_id, person_ids);
}

void People::set_educators(const Session& director, const std::string& cohort_id,
                           const std::vector<std::string>& person_ids) const {
    replace_people(store_, director, Table::educators, cohort_id, person_ids);
}

std::string People::create_demo_cohort(const Session& station, const std::string& name,
                                       const std::vector<std::string>& members,
                                       const std::vector<std::string>& educators) const {
    require_open_demo(store_, station);
    require_name(name, QT_TRANSLATE_NOOP("errors", "name of the cohort"));
    Transaction transaction(store_.connection());
    std::string id = insert_cohort(store_, name);
    write_people(store_, Table::members, id, members);
    write_people(store_, Table::educators, id, educators);
    Audit(store_).append(station, id, "cohort.create", json_object({{"name", name}}),
                         {{RecordKind::cohort, id}});
    transaction.commit();
    return id;
}

}  // namespace fulcrum::database
