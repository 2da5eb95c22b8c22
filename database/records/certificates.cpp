// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/certificates.h"

#include <algorithm>
#include <cctype>

#include "assessment/curriculum/standing.h"
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

}  // namespace

std::vector<Certificate> certificates(const Store& store, const Session& session,
                                      const std::string& person_id, const Curriculum& newest) {
    const PersonRecord record = Standings(store).record(session, person_id, newest);
    const std::int64_t at = store.now();  // one moment: a move may come into force at any
    const Curriculum& curriculum = *curriculum_at(record.assignments, at);
    const std::vector<TaskStanding> standings = standing_of(record, at);
    if (store.is_demo()) return {};
    const std::optional<Person> person = People(store).find(session, person_id);
    if (!person || person->kind != PersonKind::real) return {};
    std::vector<Certificate> made;
    for (const CurriculumStage& stage : curriculum.stages) {
        Certificate certificate{store.programme_name(),
                                person_id,
                                person->display_name,
                                curriculum.name(),
                                curriculum.title,
                                stage.id,
                                stage.title,
                                {},
                                0,
                                {}};
        bool complete = true;
        for (const TaskStanding& standing : standings) {
            if (curriculum.find(standing.task)->stage != stage.id) continue;
            complete = complete && is_proficient(standing.standing);
            certificate.tasks.push_back({standing.task, standing.declared_at, standing.by_override});
            certificate.completed_at = std::max(certificate.completed_at, standing.declared_at);
        }
        if (!complete || certificate.tasks.empty()) continue;
        certificate.code = code_of(certificate);
        made.push_back(std::move(certificate));
    }
    return made;
}

std::optional<Certificate> find_certificate(const Store& store, const Session& session,
                                            const std::string& code, const Curriculum& curriculum) {
    const std::string wanted = plain_code(code);
    for (const Person& person : People(store).list(session)) {
        if (!store.allowed(session, Operation::read_progress, Subject::person(person.id))) continue;
        for (Certificate& one : certificates(store, session, person.id, curriculum))
            if (plain_code(one.code) == wanted) return std::move(one);
    }
    return std::nullopt;
}

}  // namespace fulcrum::database
