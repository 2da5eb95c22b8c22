// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/roster/roster.h"

#include <QString>
#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

#include "database/records/people_rows.h"
#include "database/roster/csv_rows.h"
#include "database/roster/zip_entries.h"
#include "database/rows/errors.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::database {
namespace {

namespace files = std::filesystem;

/// What the store would refuse, found before anything is written.
void check(const RosterPerson& person) {
    try {
        require_persons_login(person.login);
        require_name(person.name, QT_TRANSLATE_NOOP("errors", "name"));
    } catch (const StoreError& error) {
        throw InputError(person.place, "", error.problem_sentence(), error.hint_sentence());
    }
}

/// As other programs write it, and spreadsheets that have opened the file: what is not known is a no, since a
/// yes makes an account.
bool is_yes(const std::string& cell) {
    const QString word = QString::fromStdString(cell).toLower();
    return word.isEmpty() || word == "true" || word == "wahr" || word == "1";
}

void add_role(std::vector<Role>& roles, Role role) {
    if (std::find(roles.begin(), roles.end(), role) != roles.end()) return;
    roles.push_back(role);
    std::sort(roles.begin(), roles.end());
}

void add_once(std::vector<std::string>& list, const std::string& login) {
    if (std::find(list.begin(), list.end(), login) == list.end()) list.push_back(login);
}

RosterCohort& cohort_named(Roster& roster, const std::string& name, const std::string& place) {
    for (RosterCohort& cohort : roster.cohorts) {
        if (cohort.name == name) return cohort;
    }
    try {
        require_name(name, QT_TRANSLATE_NOOP("errors", "name of the cohort"));
    } catch (const StoreError& error) {
        throw InputError(place, "", error.problem_sentence(), error.hint_sentence());
    }
    roster.cohorts.push_back({name, {}, {}, place});
    return roster.cohorts.back();
}

void enrol(RosterCohort& cohort, const std::string& login, Role role) {
    add_once(role == Role::educator ? cohort.educators : cohort.members, login);
}

// login, name, role, cohort.
Roster read_list(const std::string& path) {
    const CsvRows rows = CsvRows::load(path);
    rows.require({"login", "name"});
    Roster roster;
    std::map<std::string, std::size_t> by_login;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        RosterPerson person{rows.cell(i, "login"), rows.cell(i, "name"), {}, rows.place(i)};
        check(person);
        Role role = Role::trainee;
        const std::string word = rows.cell(i, "role");
        if (!word.empty() && word != role_name(Role::trainee) && word != role_name(Role::educator))
            throw InputError(person.place, "",
                             {QT_TRANSLATE_NOOP("errors", "'%1' is not a role that can be imported"), word},
                             QT_TRANSLATE_NOOP(
                                 "errors", "write trainee or educator; give other roles on the page People"));
        if (word == role_name(Role::educator)) role = Role::educator;
        const auto [known, fresh] = by_login.emplace(login_key(person.login), roster.people.size());
        if (fresh) {
            roster.people.push_back(person);
        } else if (roster.people[known->second].name != person.name) {
            throw InputError(person.place, "",
                             {QT_TRANSLATE_NOOP("errors", "login %1 has another name here than in %2"),
                              person.login, roster.people[known->second].place},
                             QT_TRANSLATE_NOOP("errors", "give every person a login of their own"));
        }
        add_role(roster.people[known->second].roles, role);
        const std::string cohort = rows.cell(i, "cohort");
        if (!cohort.empty())
            enrol(cohort_named(roster, cohort, person.place), roster.people[known->second].login, role);
    }
    return roster;
}

/// The role of the program that a word of OneRoster names.
std::optional<Role> role_of(const std::string& word) {
    if (word == "student") return Role::trainee;
    if (word == "teacher") return Role::educator;
    return std::nullopt;
}

class OneRoster {
  public:
    /// A folder, or an archive of the same files.
    explicit OneRoster(const files::path& place) : place_(place), packed_(!files::is_directory(place)) {
        if (packed_)
            entries_ =
                zip_entries(place.string(), {"users.csv", "roles.csv", "classes.csv", "enrollments.csv"});
        read_users();
        read_roles();
        read_classes();
        read_enrollments();
        gather();
    }
    Roster roster;

  private:
    struct User {
        RosterPerson person;
        std::string other_role;  ///< a role that is not imported
    };
    struct Class {
        std::string name, place;
    };

    std::optional<CsvRows> table(const char* name) const {
        if (packed_) {
            const auto entry = entries_.find(name);
            if (entry == entries_.end()) return std::nullopt;
            return CsvRows::parse(entry->second, name);
        }
        const files::path path = place_ / name;
        if (!files::exists(path)) return std::nullopt;
        return CsvRows::load(path.string());
    }
    void leave_out(const CsvRows& rows, std::size_t row, const Sentence& why) {
        roster.left_out.push_back({"%1: %2", rows.place(row), why});
    }
    /// False: the row is marked to be deleted, and left out.
    bool active(const CsvRows& rows, std::size_t row) {
        const std::string& status = rows.cell(row, "status");
        if (status.empty() || status == "active") return true;
        leave_out(
            rows, row,
            {QT_TRANSLATE_NOOP("errors", "status %1: an import deletes and deactivates nobody"), status});
        return false;
    }
    void give(User& user, const std::string& word) {
        const std::optional<Role> role = role_of(word);
        if (role) {
            add_role(user.person.roles, *role);
        } else if (!word.empty()) {
            user.other_role = word;
        }
    }

    void read_users() {
        const std::optional<CsvRows> rows = table("users.csv");
        if (!rows)
            throw InputError(
                place_.string(), "", QT_TRANSLATE_NOOP("errors", "has no users.csv"),
                QT_TRANSLATE_NOOP("errors", "name the ZIP archive or the folder with the OneRoster files"));
        rows->require({"sourcedId", "username", "givenName", "familyName"});
        std::map<std::string, std::string> logins;
        for (std::size_t i = 0; i < rows->size(); ++i) {
            if (!active(*rows, i)) continue;
            if (!is_yes(rows->cell(i, "enabledUser"))) {
                leave_out(*rows, i,
                          {QT_TRANSLATE_NOOP("errors", "%1 is not enabled"), rows->cell(i, "username")});
                continue;
            }
            User user;
            const std::string &given = rows->cell(i, "givenName"), &family = rows->cell(i, "familyName");
            user.person = {rows->cell(i, "username"),
                           given.empty() || family.empty() ? given + family : given + " " + family,
                           {},
                           rows->place(i)};
            check(user.person);
            give(user, rows->cell(i, "role"));
            const std::string& id = rows->cell(i, "sourcedId");
            if (!users_.emplace(id, user).second)
                throw InputError(user.person.place, "",
                                 {QT_TRANSLATE_NOOP("errors", "sourcedId '%1' occurs twice"), id},
                                 QT_TRANSLATE_NOOP("errors", "give every row an id of its own"));
            order_.push_back(id);
            const auto [known, fresh] = logins.emplace(login_key(user.person.login), user.person.place);
            if (!fresh)
                throw InputError(user.person.place, "",
                                 {QT_TRANSLATE_NOOP("errors", "login %1 is also used by %2"),
                                  user.person.login, known->second},
                                 QT_TRANSLATE_NOOP("errors", "give every person a login of their own"));
        }
    }
    // OneRoster 1.2 keeps the roles apart.
    void read_roles() {
        const std::optional<CsvRows> rows = table("roles.csv");
        if (!rows) return;
        rows->require({"userSourcedId", "role"});
        for (std::size_t i = 0; i < rows->size(); ++i) {
            if (!active(*rows, i)) continue;
            const auto user = users_.find(rows->cell(i, "userSourcedId"));
            if (user != users_.end()) give(user->second, rows->cell(i, "role"));
        }
    }
    void read_classes() {
        const std::optional<CsvRows> rows = table("classes.csv");
        if (!rows) return;
        rows->require({"sourcedId", "title"});
        std::map<std::string, std::string> titles;
        for (std::size_t i = 0; i < rows->size(); ++i) {
            if (!active(*rows, i)) continue;
            const std::string &id = rows->cell(i, "sourcedId"), &title = rows->cell(i, "title");
            cohort_named(roster, title, rows->place(i));
            if (!classes_.emplace(id, Class{title, rows->place(i)}).second)
                throw InputError(rows->place(i), "",
                                 {QT_TRANSLATE_NOOP("errors", "sourcedId '%1' occurs twice"), id},
                                 QT_TRANSLATE_NOOP("errors", "give every row an id of its own"));
            // They would be one cohort, and the educator of each would see the people of both.
            const auto [known, fresh] = titles.emplace(title, rows->place(i));
            if (!fresh)
                throw InputError(
                    rows->place(i), "",
                    {QT_TRANSLATE_NOOP("errors", "the title '%1' is also used by %2"), title, known->second},
                    QT_TRANSLATE_NOOP("errors", "give every class a title of its own"));
        }
    }
    void read_enrollments() {
        const std::optional<CsvRows> rows = table("enrollments.csv");
        if (!rows) return;
        rows->require({"classSourcedId", "userSourcedId", "role"});
        for (std::size_t i = 0; i < rows->size(); ++i) {
            if (!active(*rows, i)) continue;
            const auto user = users_.find(rows->cell(i, "userSourcedId"));
            const auto group = classes_.find(rows->cell(i, "classSourcedId"));
            if (user == users_.end() || group == classes_.end()) {
                leave_out(*rows, i,
                          user == users_.end() ? QT_TRANSLATE_NOOP("errors", "there is no such user")
                                               : QT_TRANSLATE_NOOP("errors", "there is no such class"));
                continue;
            }
            const std::optional<Role> role = role_of(rows->cell(i, "role"));
            if (!role) {
                leave_out(
                    *rows, i,
                    {QT_TRANSLATE_NOOP("errors", "the role %1 is not imported"), rows->cell(i, "role")});
                continue;
            }
            add_role(user->second.person.roles, *role);
            enrol(cohort_named(roster, group->second.name, group->second.place), user->second.person.login,
                  *role);
        }
    }
    void gather() {
        for (const std::string& id : order_) {
            const User& user = users_.at(id);
            if (user.person.roles.empty()) {
                roster.left_out.push_back(
                    user.other_role.empty()
                        ? Sentence(QT_TRANSLATE_NOOP("errors", "%1: %2 has no role"), user.person.place,
                                   user.person.login)
                        : Sentence(
                              QT_TRANSLATE_NOOP("errors", "%1: %2 has the role %3, which is not imported"),
                              user.person.place, user.person.login, user.other_role));
                continue;
            }
            roster.people.push_back(user.person);
        }
    }

    files::path place_;
    bool packed_;
    std::map<std::string, std::string> entries_;  ///< of the archive
    std::map<std::string, User> users_;
    std::map<std::string, Class> classes_;
    std::vector<std::string> order_;
};

}  // namespace

Roster read_roster(const std::string& path) {
    if (files::is_directory(path) || is_zip(path)) return OneRoster(path).roster;
    return read_list(path);
}

}  // namespace fulcrum::database
