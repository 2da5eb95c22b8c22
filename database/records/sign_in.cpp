// SPDX-License-Identifier: GPL-3.0-or-later
// Create programme, sign-in, waiting after wrong tries, passwords, recovery.
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

#include "database/access/session_maker.h"
#include "database/records/people_rows.h"
#include "database/rows/crypto.h"
#include "database/rows/json.h"
#include "database/store/audit.h"
#include "database/store/store_state.h"

namespace fulcrum::database {
namespace {

constexpr std::int64_t picker_ms = 30LL * 24 * 3600 * 1000;
// Rows of logins that nobody tries any more are dropped after this; it is far beyond the longest wait.
constexpr std::int64_t wait_forgotten_ms = 24LL * 3600 * 1000;

/// Seconds for what a colleague has typed; the longest wait for whoever guesses without end.
double wait_after(std::int64_t wrong_tries) {
    if (wrong_tries <= 0) return 0;
    if (wrong_tries > tries_before_longest_wait) return longest_wait_s;
    return std::min(usual_wait_s, first_wait_s * std::exp2(static_cast<double>(wrong_tries - 1)));
}

struct Tries {
    std::int64_t wrong = 0;
    double since_last_s = 0;
};

/// Of this login. The time since the last try is that of the machine; after a restart at least the time since
/// then has passed, whatever the clock says.
Tries read_tries(const Store& store, const std::string& login) {
    Query row(store.connection(), "SELECT wrong_tries, boot, boot_ms FROM sign_in_wait WHERE login_key = ?");
    row.bind(login_key(login));
    if (!row.next()) return {};
    const BootTime now = store.boot_time();
    const std::int64_t since = row.text(1) == now.boot ? now.ms - row.integer(2) : now.ms;
    return {row.integer(0), static_cast<double>(std::max<std::int64_t>(0, since)) * 1e-3};
}

double remaining_wait_s(const Tries& tries) {
    return std::max(0.0, wait_after(tries.wrong) - tries.since_last_s);
}

/// Each longest wait without a try takes one off, so that in the long run guesses are as rare as the longest
/// wait allows, whatever their rhythm; more than lead to it are not counted.
std::int64_t remembered(const Tries& tries) {
    constexpr std::int64_t most = tries_before_longest_wait;
    const auto forgotten = static_cast<std::int64_t>(tries.since_last_s / longest_wait_s);
    return std::clamp<std::int64_t>(tries.wrong - forgotten, 0, most);
}

/// Counts the try as a wrong one before it is looked at, so that of many at the same time one is looked at.
/// Throws SignInRefused while the login has to wait; such a try counts for nothing.
void begin_try(const Store& store, const std::string& login) {
    Transaction transaction(store.connection());
    const Tries before = read_tries(store, login);
    const double wait = remaining_wait_s(before);
    if (wait > 0) {
        const auto seconds = static_cast<long>(std::ceil(wait));
        throw SignInRefused(
            SignInRefused::Reason::wait, wait,
            {QT_TRANSLATE_NOOP("errors", "too many wrong tries with this login; wait %1 s"), seconds});
    }
    const BootTime now = store.boot_time();
    Query(store.connection(),
          "DELETE FROM sign_in_wait WHERE (boot = ? AND boot_ms < ?) OR (boot <> ? AND ? > 0)")
        .bind(now.boot)
        .bind(now.ms - wait_forgotten_ms)
        .bind(now.boot)
        .bind(now.ms - wait_forgotten_ms)
        .run();
    Query(store.connection(),
          "INSERT INTO sign_in_wait (login_key, wrong_tries, last_try, boot, boot_ms) VALUES (?, ?, ?, ?, ?) "
          "ON CONFLICT (login_key) DO UPDATE SET wrong_tries = excluded.wrong_tries, last_try = "
          "excluded.last_try, boot = excluded.boot, boot_ms = excluded.boot_ms")
        .bind(login_key(login))
        .bind(remembered(before) + 1)
        .bind(store.now())
        .bind(now.boot)
        .bind(now.ms)
        .run();
    transaction.commit();
}

/// The try that begin_try() counted was wrong.
[[noreturn]] void refuse_wrong_try(const Store& store, const std::string& login, const Sentence& what) {
    const double wait = remaining_wait_s(read_tries(store, login));
    throw SignInRefused(SignInRefused::Reason::wrong, wait,
                        {QT_TRANSLATE_NOOP("errors", "%1; you can try again in %2 s"), what,
                         static_cast<long>(std::ceil(wait))});
}

struct Account {
    std::string id, login, name, verifier;
    bool active = false, one_time = false;
    UtcMilliseconds expires = 0;
    std::string boot;  ///< machine start at which the password was made
    std::int64_t boot_ms = 0;
};

/// Empty id if no account has the login, or the account cannot sign in.
Account find_account(const Store& store, const std::string& login) {
    Account account;
    Query row(
        store.connection(),
        "SELECT p.id, p.login, p.display_name, c.verifier, p.active, c.one_time, COALESCE(c.expires, 0), "
        "c.boot, c.boot_ms "
        "FROM person p JOIN credential c ON c.person_id = p.id WHERE p.login_key = ? AND p.active = 1");
    row.bind(login_key(login));
    if (!row.next()) return account;
    account = {row.text(0), row.text(1),    row.text(2), row.text(3),   row.flag(4),
               row.flag(5), row.integer(6), row.text(7), row.integer(8)};
    return account;
}

void forget_wrong_tries(const Store& store, const std::string& login) {
    Query(store.connection(), "DELETE FROM sign_in_wait WHERE login_key = ?").bind(login_key(login)).run();
}

/// Throws SignInRefused after counting the try; a right password is no wrong try.
Account require_right_password(const Store& store, const std::string& login, const std::string& password) {
    begin_try(store, login);
    Account account = find_account(store, login);
    const bool right =
        account.id.empty() ? verify_nothing(password) : verify_secret(account.verifier, password);
    if (!right) refuse_wrong_try(store, login, QT_TRANSLATE_NOOP("errors", "login or password wrong"));
    forget_wrong_tries(store, login);
    return account;
}

/// Where this station's audit log has a one-time password from: the row with which it was issued here, or the
/// one with which the account came from another station last.
struct PasswordRow {
    std::int64_t sequence = 0;  ///< 0: none
    bool is_received = false;
};

/// The digest of the verifier that the payload of such a row names; empty where an older program wrote it.
std::string named_verifier(const std::string& payload) {
    return QJsonDocument::fromJson(QByteArray::fromStdString(payload))
        .object()
        .value(QLatin1String(verifier_key))
        .toString()
        .toStdString();
}

/// An account that another station changed comes back with the password of this one, also with one from
/// before the last: the row that names this very password was written when it was issued here. A row of an
/// older program names none; it counts where the account has not come from elsewhere since.
PasswordRow find_password_row(const Store& store, const Account& account) {
    const std::string verifier = text_digest(account.verifier);
    std::int64_t here = 0;
    {
        Query issued(
            store.connection(),
            "SELECT e.sequence, COALESCE(p.payload, '') FROM audit_entry e LEFT JOIN audit_payload p ON "
            "p.station_id = e.station_id AND p.sequence = e.sequence WHERE e.station_id = ? AND e.object_id "
            "= ? AND e.operation IN ('person.create', 'password.issue_one_time') ORDER BY e.sequence DESC");
        issued.bind(store.station_id()).bind(account.id);
        while (issued.next()) {
            if (named_verifier(issued.text(1)) == verifier) return {issued.integer(0), false};
            here = std::max(here, issued.integer(0));
        }
    }
    Query received(store.connection(),
                   "SELECT COALESCE(MAX(e.sequence), 0) FROM audit_entry e JOIN audit_payload p ON "
                   "p.station_id = e.station_id AND p.sequence = e.sequence WHERE e.station_id = ? AND "
                   "e.operation = 'sync.receive' AND instr(p.payload, ?) > 0");
    received.bind(store.station_id()).bind('"' + RecordName{RecordKind::person, account.id}.text() + '"');
    const std::int64_t elsewhere = received.next() ? received.integer(0) : 0;
    return {std::max(here, elsewhere), elsewhere > here};
}

/// The newest time that the audit log has from that row on: a clock that was set back since then does not
/// make the password younger.
UtcMilliseconds newest_time_since(const Store& store, const PasswordRow& from) {
    if (from.sequence == 0) return 0;
    Query row(store.connection(),
              "SELECT COALESCE(MAX(time), 0) FROM audit_entry WHERE station_id = ? AND sequence >= ?");
    row.bind(store.station_id()).bind(from.sequence);
    return row.next() ? row.integer(0) : 0;
}

/// Throws SignInRefused for a one-time password that is older than 24 h by the clock, by the time since the
/// machine was started, or by what the audit log has seen. How long this machine has run says nothing of a
/// password that another one issued.
void require_valid(const Store& store, const Account& account) {
    if (!account.one_time) return;
    const PasswordRow from = find_password_row(store, account);
    const BootTime now = store.boot_time();
    std::int64_t since_boot = 0;
    if (!from.is_received) since_boot = account.boot == now.boot ? now.ms - account.boot_ms : now.ms;
    const UtcMilliseconds newest = std::max(store.now(), newest_time_since(store, from));
    if (newest <= account.expires && since_boot <= one_time_password_valid_ms) return;
    throw SignInRefused(
        SignInRefused::Reason::expired, 0,
        QT_TRANSLATE_NOOP("errors",
                          "this one-time password has expired (24 h); ask an administrator for another"));
}

}  // namespace

void write_verifier(const Store& store, const std::string& person_id, const std::string& verifier,
                    bool one_time) {
    Query query(
        store.connection(),
        "INSERT INTO credential (person_id, verifier, one_time, expires, changed, boot, boot_ms) VALUES "
        "(?, ?, ?, ?, ?, ?, ?) ON CONFLICT (person_id) DO UPDATE SET verifier = excluded.verifier, "
        "one_time = excluded.one_time, expires = excluded.expires, changed = excluded.changed, boot = "
        "excluded.boot, boot_ms = excluded.boot_ms");
    query.bind(person_id).bind(verifier).bind(one_time);
    if (one_time) {
        query.bind(store.now() + one_time_password_valid_ms);
    } else {
        query.bind_null();
    }
    const BootTime since_boot = store.boot_time();
    query.bind(store.now()).bind(since_boot.boot).bind(since_boot.ms).run();
    Query(store.connection(), "UPDATE person SET version = version + 1 WHERE id = ?").bind(person_id).run();
}

CreatedProgramme People::create_programme(const std::string& programme, const std::string& login,
                                          const std::string& display_name,
                                          const std::string& password) const {
    if (store_.is_demo()) {
        throw StoreError(StoreErrorKind::sealed_demo,
                         QT_TRANSLATE_NOOP("errors", "a demo store holds no programme"),
                         QT_TRANSLATE_NOOP("errors", "make a store of your own"));
    }
    require_name(programme, QT_TRANSLATE_NOOP("errors", "name of the programme"));
    require_persons_login(login);
    require_name(display_name, QT_TRANSLATE_NOOP("errors", "name"));
    require_password(password);
    const std::string recovery_code = make_recovery_code();
    const std::string verifier = make_verifier(password);
    const std::string recovery_verifier = make_verifier(normalise_recovery_code(recovery_code));
    Connection& connection = store_.connection();
    Transaction transaction(connection);
    // Inside the transaction, which holds the write lock: of two windows that try at once only one finds no
    // administrator.
    Query any(connection,
              "SELECT 1 FROM programme UNION SELECT 1 FROM person_role WHERE role = 'administrator'");
    if (any.next()) {
        throw StoreError(
            StoreErrorKind::conflict,
            QT_TRANSLATE_NOOP("errors", "this store has a programme and its administrator already"),
            QT_TRANSLATE_NOOP("errors", "sign in"));
    }
    const std::string programme_id = random_uuid();
    Query(connection, "INSERT INTO programme (id, name, created, recovery_verifier) VALUES (?, ?, ?, ?)")
        .bind(programme_id)
        .bind(programme)
        .bind(store_.now())
        .bind(recovery_verifier)
        .run();
    make_room_for(store_, store_.station_session(), login);
    const std::string id = insert_person(store_, login, display_name, PersonKind::real);
    write_roles(connection, id, {Role::administrator});
    write_verifier(store_, id, verifier, false);
    Session session = SessionMaker::person(id, login, display_name, {Role::administrator},
                                           Role::administrator, store_.station_id(), false, false);
    Audit(store_).append(session, programme_id, "programme.create",
                         json_object({{"programme", programme}, {"administrator", id}, {"login", login}}),
                         {{RecordKind::programme, programme_id}, {RecordKind::person, id}});
    transaction.commit();
    return {std::move(session), recovery_code};
}

Session People::sign_in(const std::string& login, const std::string& password,
                        std::optional<Role> role) const {
    if (store_.is_server()) return account_session(login, password, role);
    const Account account = require_right_password(store_, login, password);
    require_valid(store_, account);
    const std::vector<Role> roles = roles_of(store_.connection(), account.id);
    if (roles.empty() || (role && std::find(roles.begin(), roles.end(), *role) == roles.end())) {
        throw SignInRefused(
            SignInRefused::Reason::role_not_held, 0,
            roles.empty() ? Sentence(QT_TRANSLATE_NOOP(
                                "errors", "this account holds no role; ask an administrator for one"))
                          : Sentence(QT_TRANSLATE_NOOP("errors", "this account does not hold the role %1"),
                                     role_name(*role)));
    }
    Session session =
        SessionMaker::person(account.id, account.login, account.name, roles, role.value_or(roles.front()),
                             store_.station_id(), account.one_time, false);
    Transaction transaction(store_.connection());
    Query(store_.connection(),
          "INSERT INTO sign_in (person_id, station_id, last) VALUES (?, ?, ?) "
          "ON CONFLICT (person_id, station_id) DO UPDATE SET last = excluded.last")
        .bind(account.id)
        .bind(store_.station_id())
        .bind(store_.now())
        .run();
    Audit(store_).append(session, account.id, "sign_in", json_object({{"role", role_name(session.role())}}));
    transaction.commit();
    return session;
}

Session People::act_as(const Session& session, Role role) const {
    if (store_.is_server()) return account_session(role);
    const std::vector<Role> roles =
        session.is_station() ? std::vector<Role>{} : roles_of(store_.connection(), session.person_id());
    if (std::find(roles.begin(), roles.end(), role) == roles.end()) {
        throw AccessDenied("act_as", role_name(session.role()), DenialReason::role_not_held, role_name(role));
    }
    return SessionMaker::person(session.person_id(), session.login(), session.display_name(), roles, role,
                                session.station_id(), session.must_change_password(), session.is_demo());
}

Session People::demo_session(const std::string& login, Role role) const {
    Query row(
        store_.connection(),
        "SELECT id, login, display_name FROM person WHERE login_key = ? AND kind <> 'real' AND active = 1");
    row.bind(login_key(login));
    if (!store_.is_demo() || !row.next())
        throw AccessDenied("demo_session", role_name(role), DenialReason::demo_people_elsewhere);
    const std::vector<Role> roles = roles_of(store_.connection(), row.text(0));
    if (std::find(roles.begin(), roles.end(), role) == roles.end()) {
        throw AccessDenied("demo_session", role_name(role), DenialReason::role_not_held, role_name(role));
    }
    return SessionMaker::person(row.text(0), row.text(1), row.text(2), roles, role, store_.station_id(),
                                false, true);
}

double People::sign_in_wait_s(const std::string& login) const {
    return remaining_wait_s(read_tries(store_, login));
}

bool People::sign_in_picker() const {
    return read_setting(store_.connection(), "sign_in_picker") != "0";
}

void People::set_sign_in_picker(const Session& administrator, bool on) const {
    store_.require(administrator, Operation::manage_settings);
    Transaction transaction(store_.connection());
    write_setting(store_.connection(), "sign_in_picker", on ? "1" : "0");
    Audit(store_).append(administrator, store_.station_id(), "setting.sign_in_picker",
                         json_object({{"after", on ? "on" : "off"}}),
                         {{RecordKind::setting, "sign_in_picker"}});
    transaction.commit();
}

std::vector<RecentSignIn> People::recent_sign_ins(const Session& station_or_person) const {
    store_.require(station_or_person, Operation::read_sign_in_list);
    std::vector<RecentSignIn> recent;
    if (!sign_in_picker()) return recent;
    Query rows(store_.connection(),
               "SELECT p.login, p.display_name, s.last FROM sign_in s JOIN person p ON p.id = s.person_id "
               "WHERE s.station_id = ? AND s.last >= ? AND p.active = 1 ORDER BY s.last DESC, p.login_key");
    rows.bind(store_.station_id()).bind(store_.now() - picker_ms);
    while (rows.next()) recent.push_back({rows.text(0), rows.text(1), rows.integer(2)});
    return recent;
}

Session People::change_password(const Session& session, const std::string& old_password,
                                const std::string& new_password) const {
    store_.require(session, Operation::change_password, Subject::person(session.person_id()));
    require_password(new_password);
    const Account account = require_right_password(store_, login_now(session), old_password);
    if (account.id != session.person_id()) {
        throw AccessDenied("change_password", role_name(session.role()), DenialReason::other_login);
    }
    require_valid(store_, account);
    if (old_password == new_password) {
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "the new password is the old one"),
                         QT_TRANSLATE_NOOP("errors", "choose another one"));
    }
    const std::string verifier = make_verifier(new_password);
    Transaction transaction(store_.connection());
    write_verifier(store_, account.id, verifier, false);
    Audit(store_).append(session, account.id, "password.change", "{}", {{RecordKind::person, account.id}});
    transaction.commit();
    return SessionMaker::person(session.person_id(), account.login, session.display_name(), session.roles(),
                                session.role(), session.station_id(), false, false);
}

std::string People::issue_one_time_password(const Session& administrator,
                                            const std::string& person_id) const {
    store_.require(administrator, Operation::issue_one_time_password);
    std::string password = make_one_time_password();
    const std::string verifier = make_verifier(password);
    Transaction transaction(store_.connection());
    const Person person = read_person(store_, person_id);
    require_own_account(person);
    if (person.kind != PersonKind::real) {
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "synthetic and external people do not sign in"),
                         QT_TRANSLATE_NOOP("errors", "name a person"));
    }
    if (person_id == administrator.person_id()) {
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "your own password is changed, not issued"),
                         QT_TRANSLATE_NOOP("errors", "use \"Change password\""));
    }
    write_verifier(store_, person_id, verifier, true);
    forget_wrong_tries(store_, person.login);
    Audit(store_).append(administrator, person_id, "password.issue_one_time",
                         json_object({{verifier_key, text_digest(verifier)}}),
                         {{RecordKind::person, person_id}});
    transaction.commit();
    return password;
}

std::string People::recover_administrator(const std::string& login, const std::string& recovery_code,
                                          const std::string& new_password) const {
    require_password(new_password);
    begin_try(store_, login);
    const Account account = find_account(store_, login);
    std::string recovery_verifier, programme_id;
    {
        Query row(store_.connection(), "SELECT recovery_verifier, id FROM programme LIMIT 1");
        if (row.next()) recovery_verifier = row.text(0), programme_id = row.text(1);
    }
    const bool last = !account.id.empty() && is_last_administrator(store_.connection(), account.id);
    const std::string code = normalise_recovery_code(recovery_code);
    const bool right =
        recovery_verifier.empty() ? verify_nothing(code) : verify_secret(recovery_verifier, code);
    if (!right || !last) {
        refuse_wrong_try(
            store_, login,
            QT_TRANSLATE_NOOP("errors",
                              "login or recovery code wrong (the code is for the last administrator only)"));
    }
    std::string next_code = make_recovery_code();
    const std::string verifier = make_verifier(new_password);
    const std::string next_verifier = make_verifier(normalise_recovery_code(next_code));
    Transaction transaction(store_.connection());
    write_verifier(store_, account.id, verifier, false);
    // A code serves once.
    Query(store_.connection(), "UPDATE programme SET recovery_verifier = ?, version = version + 1")
        .bind(next_verifier)
        .run();
    forget_wrong_tries(store_, login);
    const Session session =
        SessionMaker::person(account.id, account.login, account.name, {Role::administrator},
                             Role::administrator, store_.station_id(), false, false);
    Audit(store_).append(session, account.id, "password.recover", "{}",
                         {{RecordKind::person, account.id}, {RecordKind::programme, programme_id}});
    transaction.commit();
    return next_code;
}

}  // namespace fulcrum::database
