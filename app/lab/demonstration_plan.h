// SPDX-License-Identifier: GPL-3.0-or-later
// What the demonstration programme simulates: who its people are, when they practise and how they learn, and
// what its educators do. Pure: the same plan gives the same programme.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "assessment/curriculum/standing.h"
#include "sim_core/numerics/name_table.h"

namespace fulcrum::app {

/// How a trainee learns.
enum class LearningKind : std::uint8_t { fast, steady, slow, plateau, stopped, relapsed };
inline constexpr NameRow<LearningKind> learning_kinds[] = {
    {LearningKind::fast, "fast", "fast"},          {LearningKind::steady, "steady", "steady"},
    {LearningKind::slow, "slow", "slow"},          {LearningKind::plateau, "plateau", "plateau"},
    {LearningKind::stopped, "stopped", "stopped"}, {LearningKind::relapsed, "relapsed", "relapsed"}};
static_assert(in_order(learning_kinds));

struct DemoTrainee {
    std::string login, name;
    LearningKind learning;
};
struct DemoEducator {
    const char *login, *name;
};

inline constexpr int demo_days = 84;                           ///< 12 weeks
inline constexpr std::int64_t demo_begin = 1'788'134'400'000;  ///< UTC ms, Monday 2026-08-31
inline constexpr std::int64_t demo_day = 86'400'000;           ///< ms
inline constexpr const char* demo_director = "demo-director";

/// Of the delivered programme, 24. The first six learn in six different ways.
const std::vector<DemoTrainee>& demo_trainees();
/// The same and, beyond them, trainees with numbers for names, up to most_demo_trainees.
const DemoTrainee& demo_trainee(std::size_t trainee);
inline constexpr std::size_t most_demo_trainees = 200;

/// How large a programme is.
struct DemoSize {
    std::size_t trainees = 24;  ///< the first so many
    int weeks = demo_days / 7;  ///< the last so many
    int attempts = 0;           ///< of each trainee; 0: as each kind practises
    int seed = 0;               ///< other individuals and other attempts
};
inline constexpr int most_demo_attempts = 600, most_demo_seed = 1000;

/// 3.
const std::vector<DemoEducator>& demo_educators();

/// A trainee's practice on one day.
struct DemoSession {
    std::size_t trainee = 0;
    int attempts = 0;
};
/// In the order in which they take place. `day`: 0 to demo_days - 1.
std::vector<DemoSession> demo_sessions(const DemoSize& size, int day);

/// What draw_learner() takes, after `own` attempts at this task and `others` at other tasks.
double demo_mastery(std::size_t trainee, int own, int others, int day);
/// Whether the trainee chooses a task instead of following the recommendation. `before`: attempts so far.
bool demo_own_choice(std::size_t trainee, int before);

/// An educator's decision on a standing.
struct DemoDecision {
    int day = 0;
    std::size_t trainee = 0, educator = 0;
    const char* task;
    StandingOverride::Kind kind = StandingOverride::Kind::unlocked;
    const char* reason;
};
std::vector<DemoDecision> demo_decisions(std::size_t trainees, int day);

/// A trainee asks for a correction of the latest attempt; with `educator` it is voided.
struct DemoCorrection {
    std::size_t trainee = 0;
    int day = 0;
    bool granted = false;
    std::size_t educator = 0;
    const char *request, *reason;
};
std::vector<DemoCorrection> demo_corrections(std::size_t trainees, int day);

/// What an educator says of an attempt.
const char* demo_comment(const std::string& task, bool passed);
/// Day until which trainees have read their comments.
inline constexpr int demo_read_until = 76;

}  // namespace fulcrum::app
