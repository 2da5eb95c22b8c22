// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates: a stage of the curriculum all of whose tasks a real person is proficient in. Nothing is
// stored: a certificate and its check code follow from the record, so that a code is valid as long as the
// record says the same. Provisional limits never make one, since nobody is proficient by them.
//
// A certificate is of the version that the person followed when the stage was completed. A move to another
// version, whose stages and rules may be others, neither takes it away nor makes one of that version.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/curriculum/curriculum.h"
#include "database/store/store.h"

namespace fulcrum::database {

struct CertificateTask {
    std::string task;
    std::int64_t declared_at = 0;  ///< UTC ms, of the proficiency
    bool by_override = false;      ///< declared by an educator, not by the rule
    std::string curriculum = {};   ///< "rectal@1", whose rule declared it: followed at that time
};

struct Certificate {
    std::string programme, person_id, person_name;
    std::string curriculum;  ///< "rectal@1", followed when the stage was completed
    std::string curriculum_title, stage, stage_title;
    std::vector<CertificateTask> tasks;  ///< in the curriculum's order
    /// UTC ms, of the last declaration, or of the move to a version that asks for less.
    std::int64_t completed_at = 0;
    std::string code;          ///< "7K2Q-…": 16 characters in groups of four (80 bits)
    std::string follows = {};  ///< "rectal@2", the version that the person follows now
};

/// Of the stages that a person has completed under each version that the person has followed, the oldest
/// first, in the order of its stages. None where an earlier certificate has all of its tasks: of the same
/// stage after a move, for example. None in the demonstration and for synthetic people, none for a stage with
/// a relapsed task. Checked as read_progress. Throws AccessDenied, StoreError (also where a version that the
/// person follows is not at this station).
std::vector<Certificate> certificates(const Store& store, const Session& session,
                                      const std::string& person_id, const Curriculum& curriculum);
/// The certificate with this code, among the people whose progress the session may read; capitals, spaces and
/// hyphens of `code` do not matter. Also one that an account had before it was merged into another or another
/// into it, while the person is proficient in its tasks, and one that was written while a decision on a
/// proficiency in force declared it once more: with the days on that paper. Throws AccessDenied, StoreError
/// (also where it is not found, and people follow a version that is not at this station: it may be theirs).
std::optional<Certificate> find_certificate(const Store& store, const Session& session,
                                            const std::string& code, const Curriculum& curriculum);

}  // namespace fulcrum::database
