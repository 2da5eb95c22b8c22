// SPDX-License-Identifier: Apache-2.0
// What a metric is (descriptor) and what it gives (result). A metric is a descriptor and a pure function of
// the recorded trace and events; definitions, filters and sources: docs/FORMATS.md and the descriptors
// themselves.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/metrics/statement.h"
#include "assessment/pathology/pathology.h"
#include "assessment/trace/trace.h"
#include "sim_core/rigid/target_sphere.h"

namespace fulcrum {

enum class Direction : std::uint8_t {
    lower,
    higher,
    context
};                                            ///< which way is better; context is never a gate
enum class Scale : std::uint8_t { raw, ln };  ///< ln only for metrics that cannot be 0
/// How samples become one figure. count, share and grade (an ordinal) take no z; count, total and maximum can
/// only grow during an attempt, minimum only fall.
enum class Aggregation : std::uint8_t {
    total,
    maximum,
    minimum,
    mean,
    deviation,
    median_of_segments,
    ratio,
    share,
    grade,
    count
};
enum class EvidenceGrade : std::uint8_t {
    strong,    ///< several studies separate experts from novices with it
    moderate,  ///< one study, or several with small groups
    expert,    ///< reasoned or agreed by experts; no published separation
};
/// Whose channels a metric needs: a row for each hand, one row from both, one row from whichever is there.
/// `any`: as either, or the scope alone; `scope`: one row from the scope.
enum class Hands : std::uint8_t { each, both, either, any, scope };
/// What an attempt is when a gate's metric is absent because the trainee did not do the thing.
enum class AbsentMeans : std::uint8_t { failed, not_scored };
/// Why a value is absent.
enum class Absence : std::uint8_t {
    none,          ///< there is a value
    not_done,      ///< the trainee did not do what the metric measures
    not_measured,  ///< a channel, a limit or samples are missing
};

/// Every field is filled; check_registry() refuses a descriptor that leaves one empty. Name, explanation and
/// advice are marked for translation where they are written (context fulcrum::metrics).
struct MetricDescriptor {
    std::string id;              ///< permanent
    std::string name;            ///< as on screens
    std::string unit;            ///< "-" where dimensionless
    double precision = 0;        ///< smallest difference worth showing, in `unit`
    double least_deviation = 0;  ///< on its scale: a benchmark set's standard deviation counts as at least
                                 ///< this, since no person repeats an attempt more exactly
    Direction direction = Direction::context;
    Scale scale = Scale::raw;
    Aggregation aggregation = Aggregation::total;
    EvidenceGrade grade = EvidenceGrade::expert;
    std::string source;  ///< where the definition comes from
    int version = 0;     ///< from 1; changes whenever a value could change
    std::string filter;  ///< what the samples went through first
    Hands hands = Hands::each;
    bool per_tissue = false;      ///< also one row for each tissue label
    bool absolute_value = false;  ///< signed metric: the size is what counts
    bool needs_events = false;    ///< absent for traces that carry no events
    double minimum_rate = 0;      ///< Hz, mean rate of the trace below which it is absent
    std::vector<Channel> channels;
    std::vector<std::string> dependencies;  ///< ids of metrics that its definition uses
    AbsentMeans absent_means = AbsentMeans::not_scored;
    std::string explanation;    ///< plain language, one or two sentences
    std::string advice_fault;   ///< what was wrong, as in "the tip travelled {value}, above the limit of
                                ///< {limit}"; see statement_words.h
    std::string advice_remedy;  ///< one thing to try, imperative
};

/// One row. Zero is a value; an unknown is absent with its reason.
struct MetricResult {
    std::string id;
    int version = 1;
    std::string hand;    ///< "left", "right" or "" (none)
    std::string tissue;  ///< label or "" (all tissues together)
    std::optional<double> value;
    std::string unit;
    Direction direction = Direction::context;
    Absence absence = Absence::none;
    Statement absent_because;            ///< empty where there is a value
    std::vector<TimeInterval> evidence;  ///< worst first where there is an order; may be empty
    std::optional<int> count;            ///< segments behind a median, targets behind a mean
};

/// Limits of one tissue; absent ones are not checked.
struct TissueLimits {
    std::string label;
    std::optional<double> force;  ///< N
};

/// What a task asks of a cut along a marked line.
struct CutPlan {
    double length = 0;     ///< m, of the marked line
    double tolerance = 0;  ///< m, a cut element further from the line is too deep or too shallow
    double corridor = 0;   ///< m, a cut element further from the line does not divide it
    double traction_low = 0, traction_high = 0;  ///< N/m, target band of the traction across the cut
};

/// What a metric must know apart from the trace.
struct MetricContext {
    std::optional<CutPlan> cut;            ///< absent: the task marks no line
    std::optional<SpecimenPlan> specimen;  ///< absent: the task leaves none
    std::vector<TissueLimits> tissues;
    std::vector<TargetSphere> targets;  ///< target i is Event::detail of target_shown
    double framing_distance =
        0;  ///< m, from the lens to a target of the wanted size; 0: the task asks for none
    std::vector<std::string> phases;   ///< HUD or goal name of phase i (Event::detail of phase_begin)
    std::vector<std::string> metrics;  ///< ids wanted; empty: all of the registry
    /// Rows that only describe, whatever their descriptor says: "id" or "id.hand".
    std::vector<std::string> described;
    bool events_recorded = true;  ///< false for a trace file, which carries none: counts are absent, not 0
};

/// All wanted metrics, in the registry's order, each for both hands and (where per_tissue) for all tissues
/// and each tissue that was touched or has limits; counted events also for both hands together (hand "").
/// Pure; 10 minutes at 1 kHz with two hands take less than 2 s. Any thread. Throws std::invalid_argument for
/// an id that the registry does not know.
std::vector<MetricResult> compute_metrics(const Trace& trace, const std::vector<Event>& events,
                                          const MetricContext& context);
/// Whether a row is among those that only describe.
bool only_describes(const std::vector<std::string>& described, const std::string& id,
                    const std::string& hand);
/// Force and jaw samples of both hands that the filter of the force metrics replaces as spikes.
std::size_t replaced_force_samples(const Trace& trace);

/// The row of a metric; hand and tissue as in MetricResult. Null where there is none.
const MetricResult* find_result(const std::vector<MetricResult>& results, const std::string& id,
                                const std::string& hand, const std::string& tissue);

}  // namespace fulcrum
