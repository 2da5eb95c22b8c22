// SPDX-License-Identifier: GPL-3.0-or-later
// Sign-in at a programme server: the server's own. Its account has the person's id as its name, and its row
// policies show that person what the person's roles may see.
#include <algorithm>

#include "database/access/session_maker.h"
#include "database/records/people_rows.h"
#include "database/store/server_roles.h"

namespace fulcrum::database {
namespace {

std::string account_of(Connection& server) {
    Query row(server, "SELECT session_user::text");
    return row.next() ? row.text(0) : std::string();
}

/// Roles that the programme gave the person and that the account was given.
std::vector<Role> roles_at_server(Connection& server, const std::string& person_id) {
    std::vector<Role> roles = roles_of(server, person_id);
    const auto is_granted = [&](Role role) {
        if (std::find(std::begin(server_roles), std::end(server_roles), role) == std::end(server_roles))
            return false;
        Query granted(
            server, "SELECT 1 FROM pg_roles WHERE rolname = ? AND pg_has_role(session_user, oid, 'member')");
        granted.bind(server_group(role));
        return granted.next();
    };
    roles.erase(std::remove_if(roles.begin(), roles.end(), [&](Role role) { return !is_granted(role); }),
                roles.end());
    return roles;
}

[[noreturn]] void refuse_account(const std::string& account, const Sentence& why) {
    throw SignInRefused(
        SignInRefused::Reason::role_not_held, 0,
        {QT_TRANSLATE_NOOP("errors",
                           "the server's account \"%1\" %2; have the owner of the server's database run "
                           "`fulcrum server grant LOGIN`, and connect with the account that it names"),
         account, why});
}

/// A password that the server takes for this account.
void require_account_password(const Store& store, const std::string& password) {
    try {
        const Connection same(ServerAddress::parse(store.path()), true, password);
    } catch (const ConnectError& error) {
        if (error.why() != ServerRefusal::password) throw;
        throw SignInRefused(SignInRefused::Reason::wrong, 0,
                            QT_TRANSLATE_NOOP("errors", "login or password wrong"));
    }
}

}  // namespace

Session People::account_session(std::optional<Role> role) const {
    Connection& server = store_.connection();
    const std::string account = account_of(server);
    Query person(server, "SELECT id, login, display_name FROM person WHERE id = ? AND active = 1");
    person.bind(account);
    if (!person.next())
        refuse_account(account, QT_TRANSLATE_NOOP("errors", "is not that of an active person"));
    const std::vector<Role> roles = roles_at_server(server, account);
    if (roles.empty())
        refuse_account(account, QT_TRANSLATE_NOOP("errors", "has no role that this person holds"));
    if (role && std::find(roles.begin(), roles.end(), *role) == roles.end())
        throw SignInRefused(
            SignInRefused::Reason::role_not_held, 0,
            {QT_TRANSLATE_NOOP("errors", "this account does not hold the role %1"), role_name(*role)});
    return SessionMaker::person(person.text(0), person.text(1), person.text(2), roles,
                                role.value_or(roles.front()), store_.station_id(), false, false);
}

Session People::account_session(const std::string& login, const std::string& password,
                                std::optional<Role> role) const {
    require_account_password(store_, password);
    Session session = account_session(role);
    if (login_key(session.login()) != login_key(login))
        throw SignInRefused(SignInRefused::Reason::wrong, 0,
                            QT_TRANSLATE_NOOP("errors", "login or password wrong"));
    return session;
}

}  // namespace fulcrum::database
