// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/certificates.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <set>
#include <tuple>

#include "assessment/curriculum/standing.h"
#include "database/records/curricula.h"
#include "database/records/people.h"
#include "database/records/standings.h"
#include "database/rows/crypto.h"

namespace fulcrum::database {
namespace {

/// 5 bits a character, without letters that look alike.
constexpr char code_letters[] = "0123456789ABCDEFGHJKMNPQRSTVWXYZ";
constexpr std::size_t code_length = 16, group = 4;

std::string code_of(const Certificate& certificate) {
    std::string content = certificate.programme + '\n' + certificate.person_id + '\n' +
                          certificate.curriculum + '\n' + certificate.stage;
    for (const CertificateTask& task : certificate.tasks)
        content += '\n' + task.task + ' ' + std::to_string(task.declared_at);
    const Bytes digest = blake2b(content.data(), content.size(), 16);
    std::string code;
    for (std::size_t i = 0; i < code_length; ++i) {
        if (i > 0 && i % group == 0) code += '-';
        unsigned letter = 0;
        for (std::size_t bit = 5 * i; bit < 5 * i + 5; ++bit)
            letter = 2 * letter + (static_cast<unsigned>(digest[bit / 8] >> (7 - bit % 8)) & 1U);
        code += code_letters[letter];
    }
    return code;
}

/// What of a typed code counts.
std::string plain_code(const std::string& typed) {
    std::string code;
    for (const char c : typed)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            code += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return code;
}

bool is_proficient(Standing standing) {
    return standing == Standing::proficient || standing == Standing::maintained || standing == Standing::due;
}

constexpr std::int64_t no_end = std::numeric_limits<std::int64_t>::max();

/// The time in which a person followed one version, from a move to the next.
struct Period {
    const Curriculum* curriculum = nullptr;
    std::int64_t from = 0, until = no_end;  ///< UTC ms; `until` belongs to the next one
};

/// Up to `at`, oldest first, as curriculum_at() orders them.
std::vector<Period> periods_of(std::vector<CurriculumAssignment> assignments, std::int64_t at) {
    std::sort(assignments.begin(), assignments.end(),
              [](const CurriculumAssignment& a, const CurriculumAssignment& b) {
                  return std::make_tuple(a.time, a.curriculum->name()) <
                         std::make_tuple(b.time, b.curriculum->name());
              });
    std::vector<Period> periods;
    for (const CurriculumAssignment& one : assignments) {
        if (one.time > at) break;
        if (!periods.empty() && periods.back().from == one.time) periods.pop_back();
        if (!periods.empty()) periods.back().until = one.time;
        if (!periods.empty() && periods.back().curriculum == one.curriculum)
            periods.back().until = no_end;
        else
            periods.push_back({one.curriculum, one.time});
    }
    return periods;
}

/// Name of the version that was followed then.
std::string followed_at(const std::vector<Period>& periods, std::int64_t time) {
    std::string name;
    for (const Period& period : periods)
        if (name.empty() || period.from <= time) name = period.curriculum->name();
    return name;
}

/// Whether the certificate says more than those before it.
bool has_more(const Certificate& certificate, const std::vector<Certificate>& before) {
    return std::none_of(before.begin(), before.end(), [&](const Certificate& other) {
        return std::all_of(
            certificate.tasks.begin(), certificate.tasks.end(), [&](const CertificateTask& task) {
                return std::any_of(other.tasks.begin(), other.tasks.end(),
                                   [&](const CertificateTask& one) { return one.task == task.task; });
            });
    });
}

/// Of what this record says under this id.
std::vector<Certificate> made_of(const Store& store, const PersonRecord& record, std::int64_t at,
                                 const std::string& id, const std::string& name) {
    const std::vector<Period> periods = periods_of(record.assignments, at);
    std::vector<Certificate> made;
    for (const Period& period : periods) {
        const Curriculum& curriculum = *period.curriculum;
        const std::vector<TaskStanding> standings = standing_in(record, at, curriculum);
        for (const CurriculumStage& stage : curriculum.stages) {
            Certificate certificate;
            certificate.programme = store.programme_name();
            certificate.person_id = id;
            certificate.person_name = name;
            certificate.curriculum = curriculum.name();
            certificate.curriculum_title = curriculum.title;
            certificate.stage = stage.id;
            certificate.stage_title = stage.title;
            certificate.completed_at = period.from;
            certificate.follows = periods.back().curriculum->name();
            bool complete = true;
            for (const TaskStanding& standing : standings) {
                if (curriculum.find(standing.task)->stage != stage.id) continue;
                // Afterwards another version's rule declared it.
                complete =
                    complete && is_proficient(standing.standing) && standing.declared_at < period.until;
                certificate.tasks.push_back({standing.task, standing.declared_at, standing.by_override,
                                             followed_at(periods, standing.declared_at)});
                certificate.completed_at = std::max(certificate.completed_at, standing.declared_at);
            }
            if (!complete || certificate.tasks.empty() || !has_more(certificate, made)) continue;
            certificate.code = code_of(certificate);
            made.push_back(std::move(certificate));
        }
    }
    return made;
}

/// Ids of the accounts that belong to the person, as person_owners; one for nearly everybody.
std::vector<std::string> accounts_of(Connection& connection, const std::string& person_id) {
    std::vector<std::string> accounts = {person_id};
    Query rows(connection,
               "SELECT d.id FROM person d JOIN person t ON t.id = d.merged_into AND t.merged_into = '' WHERE "
               "d.merged_into = ? ORDER BY d.id");
    rows.bind(person_id);
    while (rows.next()) accounts.push_back(rows.text(0));
    return accounts;
}

/// What was recorded under one account, out of all that the person's accounts have.
PersonRecord part_of(const Store& store, const Session& session, const PersonRecord& whole,
                     const Person& person, const std::string& account, const Curriculum& newest) {
    std::set<std::string> attempts;
    {
        Query rows(store.connection(), "SELECT id FROM attempt WHERE person_id = ?");
        rows.bind(account);
        while (rows.next()) attempts.insert(rows.text(0));
    }
    PersonRecord part;
    part.assignments = Curricula(store).of_account(session, person.id, account, newest);
    for (const CountedAttempt& one : whole.attempts)
        if (attempts.count(one.id) != 0) part.attempts.push_back(one);
    for (const ReleasedRating& one : whole.ratings)
        if (attempts.count(one.attempt) != 0) part.ratings.push_back(one);
    for (const OverrideRow& row : Standings(store).overrides(session, person.id))
        if (row.person_id == account && !row.own) part.overrides.push_back(row.decision);
    return part;
}

/// Those that each account has by itself, where the person has several: a merge changes days of declaration
/// and versions, and ends no certificate while the person is proficient in its tasks. `missing`: a version
/// that the person or an account follows and that is not installed; then none of that account.
std::vector<Certificate> before_merges(const Store& store, const Session& session, const Person& person,
                                       const Curriculum& newest, std::string& missing) {
    std::vector<Certificate> found;
    const std::vector<std::string> accounts = accounts_of(store.connection(), person.id);
    if (accounts.size() < 2 || store.is_demo() || person.kind != PersonKind::real) return found;
    const PersonRecord whole = Standings(store).record(session, person.id, newest, false);
    const std::int64_t at = store.now();
    if (const std::string name = missing_in(whole.assignments, at); !name.empty()) {
        missing = name;
        return found;
    }
    for (const std::string& account : accounts) {
        const PersonRecord part = part_of(store, session, whole, person, account, newest);
        if (const std::string name = missing_in(part.assignments, at); !name.empty()) {
            missing = name;
            continue;
        }
        for (Certificate& one : made_of(store, part, at, account, person.display_name)) {
            const Curriculum* version = newest.version_named(one.curriculum);
            const std::vector<TaskStanding> now =
                standing_in(whole, at, version == nullptr ? newest : *version);
            const bool valid =
                std::all_of(one.tasks.begin(), one.tasks.end(), [&](const CertificateTask& task) {
                    return std::any_of(now.begin(), now.end(), [&](const TaskStanding& standing) {
                        return standing.task == task.task && is_proficient(standing.standing);
                    });
                });
            if (!valid) continue;
            one.person_id = person.id;
            one.follows = curriculum_at(whole.assignments, at)->name();
            found.push_back(std::move(one));
        }
    }
    return found;
}

/// What papers say that the program wrote while a decision on a proficiency in force declared it once more:
/// the same with the days of these decisions, as it was after each of them. `decisions`: newest first.
std::vector<Certificate> as_declared_again(const Certificate& present,
                                           const std::vector<OverrideRow>& decisions, std::int64_t at) {
    std::vector<Certificate> printed;
    Certificate one = present;
    for (auto row = decisions.rbegin(); row != decisions.rend(); ++row) {
        const StandingOverride& decision = row->decision;
        if (row->own || decision.kind != StandingOverride::Kind::proficient || decision.time > at) continue;
        const auto task = std::find_if(one.tasks.begin(), one.tasks.end(), [&](const CertificateTask& known) {
            return known.task == decision.task;
        });
        if (task == one.tasks.end() || decision.time <= task->declared_at) continue;
        task->declared_at = decision.time;
        task->by_override = true;
        one.completed_at = std::max(one.completed_at, decision.time);
        one.code = code_of(one);
        printed.push_back(one);
    }
    return printed;
}

/// As certificates(). `missing`: a version that the person follows and that is not installed; then none.
std::vector<Certificate> of_person(const Store& store, const Session& session, const std::string& person_id,
                                   const Curriculum& newest, std::string& missing) {
    const PersonRecord record = Standings(store).record(session, person_id, newest, false);
    const std::int64_t at = store.now();  // one moment: a move may come into force at any
    if (store.is_demo()) return {};
    const std::optional<Person> person = People(store).find(session, person_id);
    if (!person || person->kind != PersonKind::real) return {};
    missing = missing_in(record.assignments, at);
    if (!missing.empty()) return {};
    return made_of(store, record, at, person_id, person->display_name);
}

}  // namespace

std::vector<Certificate> certificates(const Store& store, const Session& session,
                                      const std::string& person_id, const Curriculum& newest) {
    std::string missing;
    std::vector<Certificate> made = of_person(store, session, person_id, newest, missing);
    if (!missing.empty())
        throw StoreError(StoreErrorKind::bad_value, not_here_words(missing), not_here_hint());
    return made;
}

std::optional<Certificate> find_certificate(const Store& store, const Session& session,
                                            const std::string& code, const Curriculum& curriculum) {
    const std::string wanted = plain_code(code);
    int unknown = 0;
    for (const Person& person : People(store).list(session)) {
        if (!store.allowed(session, Operation::read_progress, Subject::person(person.id))) continue;
        std::string missing;
        std::vector<Certificate> all = of_person(store, session, person.id, curriculum, missing);
        if (!all.empty()) {
            const std::vector<Certificate> present = all;
            const std::vector<OverrideRow> decisions = Standings(store).overrides(session, person.id);
            for (const Certificate& one : present)
                for (Certificate& older : as_declared_again(one, decisions, store.now()))
                    all.push_back(std::move(older));
        }
        for (Certificate& one : before_merges(store, session, person, curriculum, missing))
            all.push_back(std::move(one));
        for (Certificate& one : all)
            if (plain_code(one.code) == wanted) return std::move(one);
        if (!missing.empty()) ++unknown;
    }
    // It may be one of theirs.
    if (unknown > 0)
        throw StoreError(StoreErrorKind::bad_value,
                         {QT_TRANSLATE_NOOP("errors",
                                            "no certificate with this code was found, but of people who "
                                            "follow a curriculum that is not at this station none can be "
                                            "looked at (how many: %1)"),
                          unknown},
                         not_here_hint());
    return std::nullopt;
}

}  // namespace fulcrum::database
