// SPDX-License-Identifier: GPL-3.0-or-later
// Accounts and roles. Sign-in: sign_in.cpp; cohorts: cohorts.cpp.
#include "database/records/people.h"

#include <QString>
#include <algorithm>
#include <map>

#include "database/access/session_maker.h"
#include "database/records/attempt_query.h"
#include "database/records/people_rows.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/rows/same_person.h"
#include "database/store/audit.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

const char* const person_columns =
    "SELECT p.id, p.login, p.display_name, p.kind, p.active, p.created, COALESCE((SELECT MAX(s.last) FROM "
    "sign_in s "
    "WHERE s.person_id = p.id), 0), p.merged_into FROM person p ";

Person person_of_row(const Query& row) {
    Person person;
    person.id = row.text(0);
    person.login = row.text(1);
    person.display_name = row.text(2);
    person.kind = person_kind_of(row.text(3), person.id);
    person.active = row.flag(4);
    person.created = row.integer(5);
    person.last_sign_in = row.integer(6);
    person.merged_into = row.text(7);
    return person;
}

std::string role_list(const std::vector<Role>& roles) {
    std::string text;
    for (const Role role : roles) text += (text.empty() ? "" : ", ") + std::string(role_name(role));
    return text;
}

}  // namespace

std::string login_key(const std::string& login) {
    std::string key = login;
    for (char& c : key) {
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    }
    return key;
}

bool is_reserved_login(const std::string& login) {
    const std::string key = login_key(login);
    return key.rfind("synthetic-", 0) == 0 || key.rfind("external-", 0) == 0;
}

void require_persons_login(const std::string& login) {
    require_login(login);
    if (is_reserved_login(login))
        throw StoreError(
            StoreErrorKind::bad_value,
            {QT_TRANSLATE_NOOP("errors", "the login \"%1\" cannot be used"), login},
            QT_TRANSLATE_NOOP("errors",
                              "logins that begin with synthetic- or external- belong to simulated people"));
    if (login_key(login).rfind("erased-", 0) == 0)
        throw StoreError(
            StoreErrorKind::bad_value,
            {QT_TRANSLATE_NOOP("errors", "the login \"%1\" cannot be used"), login},
            QT_TRANSLATE_NOOP("errors", "logins that begin with erased- belong to people who were erased"));
}

void make_room_for(const Store& store, const Session& actor, const std::string& login) {
    Connection& connection = store.connection();
    std::string id;
    {
        Query row(connection, "SELECT id FROM person WHERE login_key = ? AND kind <> 'real'");
        row.bind(login_key(login));
        if (!row.next()) return;
        id = row.text(0);
    }
    const std::string moved = "synthetic-" + id.substr(0, 8) + "-" + login.substr(0, 40);
    Query(connection, "UPDATE person SET login = ?, login_key = ?, version = version + 1 WHERE id = ?")
        .bind(moved)
        .bind(login_key(moved))
        .bind(id)
        .run();
    Audit(store).append(actor, id, "person.move_login", json_object({{"before", login}, {"after", moved}}),
                        {{RecordKind::person, id}});
}

void require_login(const std::string& login) {
    const bool fits =
        !login.empty() && login.size() <= 64 && std::all_of(login.begin(), login.end(), [](char c) {
            return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
                   c == '_' || c == '-' || c == '@';
        });
    if (!fits || login_key(login) == "station") {
        throw StoreError(
            StoreErrorKind::bad_value,
            {QT_TRANSLATE_NOOP("errors", "the login \"%1\" cannot be used"), login},
            QT_TRANSLATE_NOOP("errors", "use 1 to 64 letters, digits or . _ - @, and not \"station\""));
    }
}

namespace {

/// Control characters, line and paragraph separators, and those that change the direction of what follows: a
/// name with them reads as something else on a screen or in a report.
bool misleads(QChar c) {
    const ushort code = c.unicode();
    return c.category() == QChar::Other_Control || code == 0x2028 || code == 0x2029 || code == 0x061c ||
           code == 0x200e || code == 0x200f || (code >= 0x202a && code <= 0x202e) ||
           (code >= 0x2066 && code <= 0x2069) || code == 0xfeff;
}

}  // namespace

void require_name(const std::string& name, const char* what) {
    const QString whole = QString::fromStdString(name);
    if (whole.toStdString() != name || std::any_of(whole.begin(), whole.end(), misleads)) {
        throw StoreError(
            StoreErrorKind::bad_value,
            {QT_TRANSLATE_NOOP("errors", "%1: it contains control or direction characters"), what},
            QT_TRANSLATE_NOOP("errors", "type it with letters, digits and punctuation only"));
    }
    const QString text = whole.trimmed();
    if (text.isEmpty() || text.size() > 120) {
        throw StoreError(StoreErrorKind::bad_value,
                         {QT_TRANSLATE_NOOP("errors", "%1: it is empty or too long"), what},
                         QT_TRANSLATE_NOOP("errors", "use 1 to 120 characters"));
    }
}

void require_password(const std::string& password) {
    const int characters = static_cast<int>(QString::fromStdString(password).toUcs4().size());
    if (characters < password_minimum_length || password.size() > 1024) {
        throw StoreError(
            StoreErrorKind::bad_value,
            QT_TRANSLATE_NOOP("errors", "the password is too short (or beyond 1,024 bytes)"),
            {QT_TRANSLATE_NOOP("errors", "use at least %1 characters"), password_minimum_length});
    }
}

std::vector<Role> roles_of(Connection& connection, const std::string& person_id) {
    Query rows(connection, "SELECT role FROM person_role WHERE person_id = ?");
    rows.bind(person_id);
    std::vector<Role> roles;
    while (rows.next()) {
        Role role = Role::trainee;
        if (parse_role(rows.text(0), role)) roles.push_back(role);
    }
    std::sort(roles.begin(), roles.end());
    return roles;
}

void write_roles(Connection& connection, const std::string& person_id, const std::vector<Role>& roles) {
    Query(connection, "DELETE FROM person_role WHERE person_id = ?").bind(person_id).run();
    for (const Role role : roles) {
        if (role == Role::station) {
            throw StoreError(
                StoreErrorKind::bad_value, QT_TRANSLATE_NOOP("errors", "station is not the role of a person"),
                QT_TRANSLATE_NOOP("errors", "choose trainee, educator, director or administrator"));
        }
        Query(connection, "INSERT INTO person_role (person_id, role) VALUES (?, ?) ON CONFLICT DO NOTHING")
            .bind(person_id)
            .bind(role_name(role))
            .run();
    }
}

namespace {

/// Throws conflict where somebody else than this person has the login.
void require_free(Connection& connection, const std::string& login, const std::string& person_id) {
    Query taken(connection, "SELECT 1 FROM person WHERE login_key = ? AND id <> ?");
    taken.bind(login_key(login)).bind(person_id);
    if (taken.next()) {
        throw StoreError(StoreErrorKind::conflict,
                         {QT_TRANSLATE_NOOP("errors", "the login \"%1\" is taken"), login},
                         QT_TRANSLATE_NOOP("errors", "choose another one"));
    }
}

}  // namespace

std::string insert_person(const Store& store, const std::string& login, const std::string& display_name,
                          PersonKind kind) {
    Connection& connection = store.connection();
    std::string id = random_uuid();
    require_free(connection, login, id);
    Query(connection,
          "INSERT INTO person (id, login, login_key, display_name, kind, active, created, version) "
          "VALUES (?, ?, ?, ?, ?, 1, ?, 1)")
        .bind(id)
        .bind(login)
        .bind(login_key(login))
        .bind(display_name)
        .bind(std::string(row_of(person_kinds, kind).name))
        .bind(store.now())
        .run();
    return id;
}

std::map<std::string, std::string> merged_people(Connection& connection) {
    Query rows(
        connection,
        QString("SELECT person_id, owner_id FROM %1 same WHERE person_id <> owner_id").arg(person_owners));
    std::map<std::string, std::string> owners;
    while (rows.next()) owners[rows.text(0)] = rows.text(1);
    return owners;
}

bool is_last_administrator(Connection& connection, const std::string& person_id) {
    Query rows(connection,
               "SELECT SUM(p.id = ?), SUM(p.id <> ?) FROM person p JOIN person_role r ON r.person_id = p.id "
               "WHERE r.role = 'administrator' AND p.active = 1");
    rows.bind(person_id).bind(person_id);
    return rows.next() && rows.integer(0) > 0 && rows.integer(1) == 0;
}

Person read_person(const Store& store, const std::string& person_id) {
    Query row(store.connection(), QString(person_columns) + "WHERE p.id = ?");
    row.bind(person_id);
    if (!row.next())
        throw StoreError(StoreErrorKind::not_found, {QT_TRANSLATE_NOOP("errors", "no person %1"), person_id},
                         QT_TRANSLATE_NOOP("errors", "list the people and name one of them"));
    Person person = person_of_row(row);
    person.roles = roles_of(store.connection(), person.id);
    return person;
}

void require_own_account(const Person& person) {
    if (person.merged_into.empty()) return;
    throw StoreError(
        StoreErrorKind::conflict,
        {QT_TRANSLATE_NOOP("errors", "%1 is merged into another account"), person.login},
        QT_TRANSLATE_NOOP("errors",
                          "change the account that stays, or undo the merge first (`fulcrum people "
                          "unmerge`)"));
}

void require_open_demo(const Store& store, const Session& station) {
    if (!store.is_demo() || !station.is_station()) {
        throw AccessDenied("build_demo", role_name(station.role()), DenialReason::program_only);
    }
    if (read_setting(store.connection(), "demo_sealed") == "1") {
        throw StoreError(StoreErrorKind::sealed_demo,
                         QT_TRANSLATE_NOOP("errors", "the demo takes practice attempts only"),
                         QT_TRANSLATE_NOOP("errors", "delete the demo store to build it again"));
    }
}

People::Created People::create(const Session& administrator, const std::string& login,
                               const std::string& display_name, const std::vector<Role>& roles) const {
    store_.require(administrator, Operation::manage_people);
    store_.require(administrator, Operation::manage_roles);
    require_persons_login(login);
    require_name(display_name, QT_TRANSLATE_NOOP("errors", "name"));
    Created created;
    created.one_time_password = make_one_time_password();
    const std::string verifier = make_verifier(created.one_time_password);
    Transaction transaction(store_.connection());
    make_room_for(store_, administrator, login);
    const std::string id = insert_person(store_, login, display_name, PersonKind::real);
    write_roles(store_.connection(), id, roles);
    write_verifier(store_, id, verifier, true);
    Audit(store_).append(administrator, id, "person.create",
                         json_object({{"login", login},
                                      {"name", display_name},
                                      {"roles", role_list(roles)},
                                      {verifier_key, text_digest(verifier)}}),
                         {{RecordKind::person, id}});
    transaction.commit();
    created.person = read_person(store_, id);
    return created;
}

void People::rename(const Session& administrator, const std::string& person_id,
                    const std::string& display_name) const {
    store_.require(administrator, Operation::manage_people);
    require_name(display_name, QT_TRANSLATE_NOOP("errors", "name"));
    Transaction transaction(store_.connection());
    const Person before = read_person(store_, person_id);
    Query(store_.connection(), "UPDATE person SET display_name = ?, version = version + 1 WHERE id = ?")
        .bind(display_name)
        .bind(person_id)
        .run();
    Audit(store_).append(administrator, person_id, "person.rename",
                         json_object({{"before", before.display_name}, {"after", display_name}}),
                         {{RecordKind::person, person_id}});
    transaction.commit();
}

void People::set_login(const Session& administrator, const std::string& person_id,
                       const std::string& login) const {
    store_.require(administrator, Operation::manage_people);
    require_persons_login(login);
    Transaction transaction(store_.connection());
    const Person before = read_person(store_, person_id);
    require_own_account(before);
    if (before.kind != PersonKind::real || before.login == "erased-" + person_id) {
        throw StoreError(
            StoreErrorKind::bad_value,
            {QT_TRANSLATE_NOOP("errors", "the login of %1 cannot be changed"), before.login},
            QT_TRANSLATE_NOOP(
                "errors",
                "choose the account of a person; simulated, external and erased people keep theirs"));
    }
    if (before.login == login) return;
    make_room_for(store_, administrator, login);
    require_free(store_.connection(), login, person_id);
    Query(store_.connection(),
          "UPDATE person SET login = ?, login_key = ?, version = version + 1 WHERE id = ?")
        .bind(login)
        .bind(login_key(login))
        .bind(person_id)
        .run();
    Audit(store_).append(administrator, person_id, "person.set_login",
                         json_object({{"before", before.login}, {"after", login}}),
                         {{RecordKind::person, person_id}});
    transaction.commit();
}

std::string People::login_now(const Session& session) const {
    Query row(store_.connection(), "SELECT login FROM person WHERE id = ?");
    row.bind(session.person_id());
    return row.next() ? row.text(0) : session.login();
}

void People::set_active(const Session& administrator, const std::string& person_id, bool active) const {
    store_.require(administrator, Operation::manage_people);
    Transaction transaction(store_.connection());
    const Person before = read_person(store_, person_id);
    require_own_account(before);
    if (!active && is_last_administrator(store_.connection(), person_id)) {
        throw StoreError(StoreErrorKind::conflict,
                         QT_TRANSLATE_NOOP("errors", "the last administrator cannot be deactivated"),
                         QT_TRANSLATE_NOOP("errors", "make someone else administrator first"));
    }
    Query(store_.connection(), "UPDATE person SET active = ?, version = version + 1 WHERE id = ?")
        .bind(active)
        .bind(person_id)
        .run();
    Audit(store_).append(
        administrator, person_id, "person.set_active",
        json_object({{"before", before.active ? "yes" : "no"}, {"after", active ? "yes" : "no"}}),
        {{RecordKind::person, person_id}});
    transaction.commit();
}

void People::set_roles(const Session& administrator, const std::string& person_id,
                       const std::vector<Role>& roles) const {
    store_.require(administrator, Operation::manage_roles);
    Transaction transaction(store_.connection());
    const Person before = read_person(store_, person_id);
    require_own_account(before);
    if (before.kind != PersonKind::real) {
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "synthetic and external people cannot have roles"),
                         QT_TRANSLATE_NOOP("errors", "make an account for a person"));
    }
    const bool stays = std::find(roles.begin(), roles.end(), Role::administrator) != roles.end();
    if (!stays && is_last_administrator(store_.connection(), person_id)) {
        throw StoreError(StoreErrorKind::conflict,
                         QT_TRANSLATE_NOOP("errors", "the last administrator cannot give up the role"),
                         QT_TRANSLATE_NOOP("errors", "make someone else administrator first"));
    }
    write_roles(store_.connection(), person_id, roles);
    Query(store_.connection(), "UPDATE person SET version = version + 1 WHERE id = ?").bind(person_id).run();
    Audit(store_).append(administrator, person_id, "person.set_roles",
                         json_object({{"before", role_list(before.roles)}, {"after", role_list(roles)}}),
                         {{RecordKind::person, person_id}});
    transaction.commit();
}

Person People::ensure_synthetic(const Session& station, const std::string& login,
                                const std::string& display_name, PersonKind kind) const {
    // A sealed demo refuses new people but still finds those it has.
    store_.require(station, Operation::list_people);
    if (kind == PersonKind::real) {
        throw StoreError(
            StoreErrorKind::bad_value,
            QT_TRANSLATE_NOOP("errors", "only an administrator can make an account for a real person"),
            QT_TRANSLATE_NOOP("errors", "ask an administrator"));
    }
    Transaction transaction(store_.connection());
    std::string id;
    {
        Query row(store_.connection(), "SELECT id, kind FROM person WHERE login_key = ?");
        row.bind(login_key(login));
        if (row.next()) {
            if (person_kind_of(row.text(1), row.text(0)) != PersonKind::real) id = row.text(0);
        }
    }
    if (id.empty()) {
        store_.require(station, Operation::create_synthetic);
        // In a store with a programme the answer is the same whether somebody real has this login or nobody.
        if (!is_reserved_login(login) && !store_.is_demo() && store_.has_administrator()) {
            throw StoreError(
                StoreErrorKind::conflict,
                {QT_TRANSLATE_NOOP("errors", "the login \"%1\" is not one of a simulated person"), login},
                QT_TRANSLATE_NOOP(
                    "errors",
                    "name a synthetic or external person of this store, or a new one whose login begins with "
                    "synthetic- or external-; operators and traces may not perform for others"));
        }
        require_login(login);
        require_name(display_name, QT_TRANSLATE_NOOP("errors", "name"));
        id = insert_person(store_, login, display_name, kind);
        Audit(store_).append(station, id, "person.create_synthetic",
                             json_object({{"login", login},
                                          {"name", display_name},
                                          {"kind", std::string(row_of(person_kinds, kind).name)}}),
                             {{RecordKind::person, id}});
    }
    transaction.commit();
    return read_person(store_, id);
}

void People::set_demo_roles(const Session& station, const std::string& person_id,
                            const std::vector<Role>& roles) const {
    require_open_demo(store_, station);
    Transaction transaction(store_.connection());
    write_roles(store_.connection(), read_person(store_, person_id).id, roles);
    Audit(store_).append(station, person_id, "person.set_roles", json_object({{"after", role_list(roles)}}),
                         {{RecordKind::person, person_id}});
    transaction.commit();
}

std::vector<Person> People::list(const Session& session) const {
    store_.require(session, Operation::list_people);
    Query rows(store_.connection(), QString(person_columns) + "WHERE " +
                                        visible_people(session, Operation::list_people, "p.id") +
                                        " ORDER BY p.display_name, p.login_key");
    bind_visible_people(rows, session, Operation::list_people);
    std::vector<Person> people;
    while (rows.next()) people.push_back(person_of_row(rows));
    // One query for all: a programme has thousands.
    std::map<std::string, std::vector<Role>> held;
    Query roles(store_.connection(), "SELECT person_id, role FROM person_role");
    while (roles.next()) {
        Role role = Role::trainee;
        if (parse_role(roles.text(1), role)) held[roles.text(0)].push_back(role);
    }
    for (Person& person : people) {
        const auto found = held.find(person.id);
        if (found == held.end()) continue;
        person.roles = std::move(found->second);
        std::sort(person.roles.begin(), person.roles.end());
    }
    return people;
}

std::optional<Person> People::find(const Session& session, const std::string& person_id) const {
    store_.require(session, Operation::list_people);
    Query row(store_.connection(), "SELECT 1 FROM person WHERE id = ?");
    row.bind(person_id);
    if (!row.next()) return std::nullopt;
    store_.require(session, Operation::list_people, Subject::person(person_id));
    return read_person(store_, person_id);
}

std::optional<Person> People::find_login(const Session& session, const std::string& login) const {
    store_.require(session, Operation::list_people);
    std::string id;
    {
        Query row(store_.connection(), "SELECT " + owner_of("p.id") + " FROM person p WHERE p.login_key = ?");
        row.bind(login_key(login));
        if (!row.next()) return std::nullopt;
        id = row.text(0);
    }
    return find(session, id);
}

}  // namespace fulcrum::database
