// SPDX-License-Identifier: GPL-3.0-or-later
// Certificates: a stage of the curriculum all of whose tasks a real person is proficient in. Nothing is
// stored: a certificate and its check code follow from the record, so that a code is valid as long as the
// record says the same. Provisional limits never make one, since nobody is proficient by them.
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
};

struct Certificate {
    std::string programme, person_id, person_name;
    std::string curriculum;  ///< "rectal@1"
    std::string curriculum_title, stage, stage_title;
    std::vector<CertificateTask> tasks;  ///< in the curriculum's order
    std::int64_t completed_at = 0;       ///< UTC ms, of the last declaration
    std::string code;                    ///< "7K2Q-…": 16 characters in groups of four (80 bits)
};

/// Of the stages that a person has completed, in their order; none in the demonstration and for synthetic
/// people, none for a stage with a relapsed task. Checked as read_progress. Throws AccessDenied, StoreError.
std::vector<Certificate> certificates(const Store& store, const Session& session,
                                      const std::string& person_id, const Curriculum& curriculum);
/// The certificate with this code, among the people whose progress the session may read; capitals, spaces and
/// hyphens of `code` do not matter. Throws as certificates().
std::optional<Certificate> find_certificate(const Store& store, const Session& session,
                                            const std::string& code, const Curriculum& curriculum);

}  // namespace fulcrum::database
