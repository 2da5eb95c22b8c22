// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/demonstration_plan.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/random.h"

namespace fulcrum::app {
namespace {

using Kind = StandingOverride::Kind;

/// How each kind practises and learns.
struct LearningRow {
    LearningKind kind;
    int sessions;              ///< in a week
    int attempts;              ///< in a session
    double start, end;         ///< mastery without practice, and after much
    double attempts_to_learn;  ///< time constant, in attempts
};
constexpr LearningRow learning_rows[] = {
    {LearningKind::fast, 2, 2, 0.40, 1.00, 5},    {LearningKind::steady, 1, 3, 0.25, 0.97, 9},
    {LearningKind::slow, 1, 2, 0.10, 0.85, 16},   {LearningKind::plateau, 1, 3, 0.20, 0.52, 6},
    {LearningKind::stopped, 1, 3, 0.25, 0.95, 9}, {LearningKind::relapsed, 2, 2, 0.40, 1.00, 5},
};
static_assert(in_order(learning_rows));

// Practice of other tasks counts for a fifth.
constexpr double transfer = 0.2;
// A trainee who stops does so in the sixth week. One who relapses pauses from the eighth to the tenth week,
// and has then lost half of what was learned.
constexpr int last_day_of_stopped = 35, pause_begins = 49, pause_ends = 70;
constexpr double kept_after_pause = 0.5;
constexpr double absence = 0.08;

constexpr std::uint64_t week_stream = 0x7765656b, choice_stream = 0x63686f69;

const LearningRow& learning_of(std::size_t trainee) {
    return row_of(learning_rows, demo_trainee(trainee).learning);
}

bool is_away(std::size_t trainee, int day) {
    const LearningKind kind = demo_trainee(trainee).learning;
    return (kind == LearningKind::stopped && day >= last_day_of_stopped) ||
           (kind == LearningKind::relapsed && day >= pause_begins && day < pause_ends);
}

}  // namespace

const std::vector<DemoTrainee>& demo_trainees() {
    static const std::vector<DemoTrainee> trainees = {
        {"demo-amara", "Amara Okafor (synthetic)", LearningKind::fast},
        {"demo-bjorn", "Björn Lindqvist (synthetic)", LearningKind::slow},
        {"demo-chiara", "Chiara Moretti (synthetic)", LearningKind::steady},
        {"demo-dmitri", "Dmitri Volkov (synthetic)", LearningKind::plateau},
        {"demo-elif", "Elif Kaya (synthetic)", LearningKind::stopped},
        {"demo-farid", "Farid Haddad (synthetic)", LearningKind::relapsed},
        {"demo-greta", "Greta Brandt (synthetic)", LearningKind::fast},
        {"demo-hiro", "Hiro Tanaka (synthetic)", LearningKind::steady},
        {"demo-ines", "Inês Carvalho (synthetic)", LearningKind::slow},
        {"demo-jonas", "Jonas Weber (synthetic)", LearningKind::steady},
        {"demo-kavya", "Kavya Rao (synthetic)", LearningKind::fast},
        {"demo-liam", "Liam Byrne (synthetic)", LearningKind::slow},
        {"demo-mei", "Mei Chen (synthetic)", LearningKind::steady},
        {"demo-noah", "Noah Fischer (synthetic)", LearningKind::plateau},
        {"demo-olga", "Olga Novak (synthetic)", LearningKind::stopped},
        {"demo-pedro", "Pedro Alvarez (synthetic)", LearningKind::slow},
        {"demo-quynh", "Quỳnh Tran (synthetic)", LearningKind::steady},
        {"demo-rosa", "Rosa Jiménez (synthetic)", LearningKind::fast},
        {"demo-samir", "Samir Patel (synthetic)", LearningKind::slow},
        {"demo-tova", "Tova Levin (synthetic)", LearningKind::relapsed},
        {"demo-umar", "Umar Farooq (synthetic)", LearningKind::steady},
        {"demo-vera", "Vera Kowalska (synthetic)", LearningKind::plateau},
        {"demo-wim", "Wim de Vries (synthetic)", LearningKind::slow},
        {"demo-yara", "Yara Nasser (synthetic)", LearningKind::stopped}};
    return trainees;
}

const std::vector<DemoEducator>& demo_educators() {
    static const std::vector<DemoEducator> educators = {{"demo-educator", "Dr Hanna Berg (synthetic)"},
                                                        {"demo-educator-2", "Dr Paul Adeyemi (synthetic)"},
                                                        {"demo-educator-3", "Dr Lucía Serrano (synthetic)"}};
    return educators;
}

const DemoTrainee& demo_trainee(std::size_t trainee) {
    static const std::vector<DemoTrainee> all = [] {
        std::vector<DemoTrainee> made = demo_trainees();
        const std::size_t named = made.size();
        for (std::size_t i = named; i < most_demo_trainees; ++i) {
            const std::string number = std::to_string(i + 1);
            made.push_back(
                {"demo-trainee-" + number, "Trainee " + number + " (synthetic)", made[i % named].learning});
        }
        return made;
    }();
    return all.at(trainee);
}

namespace {

constexpr int working_days = 5, days_a_week = 7;

/// Attempts of a trainee on a day, where everybody performs `all` of them from `first_day` on: as evenly as
/// whole numbers allow over the days on which the trainee is there.
int even_share(std::size_t trainee, int day, int first_day, int all) {
    if (day < first_day || day % days_a_week >= working_days || is_away(trainee, day)) return 0;
    int days = 0, before = 0;
    for (int one = first_day; one < demo_days; ++one) {
        if (one % days_a_week >= working_days || is_away(trainee, one)) continue;
        if (one < day) ++before;
        ++days;
    }
    return all * (before + 1) / days - all * before / days;
}

/// As the trainee's kind practises.
int usual_share(std::size_t trainee, int day) {
    const int week = day / days_a_week, weekday = day % days_a_week;
    const LearningRow& learning = learning_of(trainee);
    Random random(1000 * static_cast<std::uint64_t>(week) + trainee, week_stream);
    const int first = static_cast<int>(random.below(working_days));
    int attempts = 0;
    for (int k = 0; k < learning.sessions; ++k) {
        const int on = (first + 2 * k) % working_days;
        const bool absent = random.uniform() < absence;
        const int here = learning.attempts + (random.uniform() < 0.25 ? 1 : 0);
        if (on == weekday && !absent && !is_away(trainee, day)) attempts = here;
    }
    return attempts;
}

}  // namespace

std::vector<DemoSession> demo_sessions(const DemoSize& size, int day) {
    const int first_day = demo_days - days_a_week * size.weeks;
    std::vector<DemoSession> sessions;
    for (std::size_t i = 0; i < size.trainees; ++i) {
        const int attempts =
            size.attempts > 0 ? even_share(i, day, first_day, size.attempts) : usual_share(i, day);
        if (attempts > 0) sessions.push_back({i, attempts});
    }
    // The station is booked by the day: who begins changes.
    if (!sessions.empty())
        std::rotate(sessions.begin(), sessions.begin() + day % static_cast<int>(sessions.size()),
                    sessions.end());
    return sessions;
}

double demo_mastery(std::size_t trainee, int own, int others, int day) {
    const LearningRow& learning = learning_of(trainee);
    const double practice = own + transfer * others;
    double learned = 1 - std::exp(-practice / learning.attempts_to_learn);
    if (learning.kind == LearningKind::relapsed && day >= pause_ends) learned *= kept_after_pause;
    return learning.start + (learning.end - learning.start) * learned;
}

bool demo_own_choice(std::size_t trainee, int before) {
    constexpr double share = 0.4;
    Random random(1000 * static_cast<std::uint64_t>(before) + trainee, choice_stream);
    return random.uniform() < share;
}

std::vector<DemoDecision> demo_decisions(std::size_t trainees, int day) {
    constexpr const char* early =
        "Has finished the box trainer course. May practise the next tasks while A2 is not yet proficient.";
    std::vector<DemoDecision> decisions;
    const auto add = [&](int on, std::size_t trainee, std::size_t educator, const char* task, Kind kind,
                         const char* reason) {
        if (on == day && trainee < trainees) decisions.push_back({on, trainee, educator, task, kind, reason});
    };
    std::size_t fast = 0, stopped = 0;
    for (std::size_t i = 0; i < std::max(trainees, demo_trainees().size()); ++i) {
        const LearningKind kind = demo_trainee(i).learning;
        const std::size_t educator = i % demo_educators().size();
        const bool quick = kind == LearningKind::fast || kind == LearningKind::relapsed;
        if (quick)
            for (const char* task : {"A3", "B1", "B2", "B3"})
                add(11, i, educator, task, Kind::unlocked, early);
        if (kind == LearningKind::steady)
            for (const char* task : {"A3", "B1"}) add(25, i, educator, task, Kind::unlocked, early);
        if (kind == LearningKind::plateau) add(39, i, educator, "A3", Kind::unlocked, early);
        if (kind == LearningKind::fast && fast++ < 2) {
            add(fast == 1 ? 44 : 58, i, educator, "C4", Kind::unlocked,
                "Has assisted at twelve rectal resections. May begin with the dissection.");
            add(fast == 1 ? 66 : 77, i, educator, fast == 1 ? "A2" : "A1", Kind::proficient,
                "Observed in two sessions; the limits of this task are still provisional.");
        }
        if (kind == LearningKind::stopped && stopped++ == 0)
            add(30, i, educator, "A1", Kind::proficient,
                "Holds the camera in theatre every week; observed in two sessions.");
    }
    return decisions;
}

std::vector<DemoCorrection> demo_corrections(std::size_t trainees, int day) {
    static const DemoCorrection corrections[] = {
        {1, 23, true, 1, "The cable of the camera came loose in the middle of it.",
         "The cable of the camera was loose; replaced afterwards."},
        {8, 60, true, 2, "A colleague moved the trainer while I was practising.",
         "The trainer was moved during the attempt."},
        {6, 83, false, 0, "I started the wrong variant and gave up.", ""}};
    std::vector<DemoCorrection> found;
    for (const DemoCorrection& one : corrections)
        if (one.day == day && one.trainee < trainees) found.push_back(one);
    return found;
}

const char* demo_comment(const std::string& task, bool passed) {
    struct Words {
        const char *task, *passed, *failed;
    };
    static constexpr Words words[] = {
        {"A1",
         "The horizon stays level here although you follow the tip. Keep the light post turning on the way.",
         "You turn the head and the light post one after the other here. Try to do both on the way."},
        {"A2",
         "A direct path, and you stop at the sphere instead of searching for it. Now the same with the left.",
         "The tip goes past the sphere in depth here. Watch the shadow of the tip before you touch."},
        {"A3", "A calm transfer: the second jaws are closed before the first open.",
         "You let go before the other jaws hold. Wait until you see the ring move with both."},
        {"B1", "Short steps and a light grip: the bowel is never pulled at its mesentery.",
         "The grip is harder than needed here. Take more tissue with less force."},
        {"B2", "Good traction across the line, and the blade follows it.",
         "The sheet is slack here, so the blade leaves the line. Build up traction first, then cut."},
        {"B3", "The vessel is held before the energy is on, and the nerve keeps its distance.",
         "The blade is active while it touches the wrong side. Look for the nerve before you press the "
         "pedal."},
        {"C4", "You stay in the plane and in the middle of the fibres; the envelope is intact.",
         "You leave the plane towards the rectum here. Lift more, until the fibres open."}};
    for (const Words& one : words)
        if (task == one.task) return passed ? one.passed : one.failed;
    return passed ? "Well done: steady and without haste." : "Slower, and with both hands.";
}

}  // namespace fulcrum::app
