// SPDX-License-Identifier: Apache-2.0
// Cheating operators: ways to a pass without the skill that a task asks for. Each is an expert whose skill,
// hands, pedals or camera are changed in one respect. None may pass; tests/assessment/operators/cheats_test
// holds every one of them against every task that it fits.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "assessment/operators/operator.h"
#include "assessment/operators/skill.h"

namespace fulcrum {

struct Scene;
struct TaskDefinition;

/// What a cheat needs of a scene; it changes nothing in others.
enum class CheatSite : std::uint8_t {
    any,
    jaws,    ///< tissue to grasp
    blade,   ///< a line to divide
    sheet,   ///< the single sheet of B2; septa are divided as well by a blade that always cuts
    septa,   ///< levels of septa; on the single sheet jaws slide before they overload it
    energy,  ///< an instrument that gives energy
    bands,   ///< bands to divide
    hands,   ///< two hands
    scope,   ///< the scope alone; what others do to the hands is then done to the scope
    view,    ///< two hands, and a gate on work outside the image
    lift,    ///< bowel to lift
};

struct CheatView;

/// One way to cheat.
struct Cheat {
    const char* name;
    const char* what;  ///< what it does, for lists
    CheatSite site;
    void (*skill)(Skill& skill);                      ///< null: the skill is not changed
    void (*act)(CheatView& view, RigSample& sample);  ///< null: the hands are not changed
    /// It comes and goes: s of the attempt from which on it has to have come and gone once before anyone
    /// judges it, since its purpose is what follows. Negative: it lasts.
    double returns_from = -1;
};

/// An expert who cheats.
class CheatingRig : public ObservingRig {
  public:
    /// A cheat that comes and goes has done so once; any other, always.
    virtual bool has_cheated() const noexcept = 0;
};

/// Every cheat, in a fixed order.
const std::vector<Cheat>& cheats();
/// Those that change something in a task.
std::vector<const Cheat*> cheats_for(const TaskDefinition& task, const Scene& scene);
/// Throws InputError for a task that operators cannot perform.
std::unique_ptr<CheatingRig> make_cheat(const Cheat& cheat, const TaskDefinition& task, const Scene& scene,
                                        std::uint64_t seed);

}  // namespace fulcrum
