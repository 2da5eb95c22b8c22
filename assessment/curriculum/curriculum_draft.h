// SPDX-License-Identifier: Apache-2.0
// A curriculum while it is edited: what is wrong with it and where, all at once, and its file. Pure.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "assessment/curriculum/curriculum.h"
#include "sim_core/numerics/sentence.h"

namespace fulcrum {

enum class CurriculumField : std::uint8_t {
    title,   ///< of the curriculum
    stages,  ///< `index`: of the stage
    task,    ///< this and all below: `index` of the task; the task itself
    stage,
    after,
    rule,
    variants,
    devices,
    ratings,
    remedies
};

struct CurriculumProblem {
    CurriculumField field = CurriculumField::title;
    std::size_t index = 0;
    Sentence problem, hint;
    bool blocks = true;  ///< false: it can be published, but its author should know
};

/// In the order of the fields and of the tasks. Where nothing blocks, parse_curriculum(), check_rules(),
/// check_ratings() and check_remedies() accept the draft's text.
std::vector<CurriculumProblem> check_draft(const Curriculum& draft, const std::vector<InstalledTask>& tasks,
                                           const std::vector<ObserverForm>& forms);

/// The draft as a file. Remarks at the top of the text that it was made from are kept.
std::string curriculum_text(const Curriculum& draft);
/// Whether both say the same, whatever their versions and what they began with.
bool same_contents(const Curriculum& a, const Curriculum& b);

}  // namespace fulcrum
