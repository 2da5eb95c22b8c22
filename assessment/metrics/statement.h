// SPDX-License-Identifier: Apache-2.0
// What is stored of a sentence: its id and its parameters, no words. An attempt of years ago reads in today's
// words and in the language of whoever reads it.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace fulcrum {

/// Names and words: statement_words.h.
enum class StatementId : std::uint8_t {
    none,   ///< nothing to say
    plain,  ///< a sentence that was stored as text: shown as it is

    // Why a metric has no value.
    nothing_moved,
    hand_never_moved,
    few_way_points,
    still_between_way_points,
    target_positions_unknown,
    no_target_shown,
    no_target_reached,
    tip_not_followed,
    few_target_movements,
    no_movement_between_rests,
    never_inside,
    flat_movement,
    no_specimen,
    nothing_cut,
    specimen_undivided,
    no_tumour,
    tumour_plane_undivided,
    not_beyond_tumour,
    sector_uncut,
    no_marked_line,
    traction_not_recorded,
    no_traction_band,
    line_without_length,
    no_energy,
    nothing_recorded,
    few_movements,
    few_loaded_movements,
    movements_hold_little,
    device_noise,
    short_inside,
    hand_still,
    all_still,
    one_hand_still,
    nobody_inside,
    no_force,
    no_force_on,
    no_force_limit,
    no_force_limit_for,
    short_force,
    nothing_grasped,
    numbers_too_large,
    no_events,
    few_samples,
    low_rate,
    samples_lost,
    not_recorded,

    // Why a gate was not judged.
    metric_not_computed,
    metric_unknown,
    no_benchmark,
    no_benchmark_level,
    cutting_differs,
    device_class_differs,
    fidelity_differs,
    variant_differs,
    limits_replaced,
    limits_outdated,

    // Why an attempt has no score.
    simulator_failed,
    attempt_interrupted,
    ended_before_moving,
    device_was_lost,
    no_gates,
    recorded_elsewhere,
    gate_not_judged,

    // Why an assessed attempt became practice.
    practice_device_lost,
    practice_stood_still,

    // Advice.
    critical_error,
    gate_missed,
    gates_met,
    gates_met_narrowly,
    time_ran_out,
    attempt_abandoned,
    gate_without_value,
    not_scored,
};

struct Parameter;

/// An id and its parameters, in alphabetical order. Empty: nothing to say.
class Statement {
  public:
    Statement();
    Statement(StatementId id);  // NOLINT: an id without parameters is a statement
    Statement(StatementId id, std::initializer_list<Parameter> parameters);
    /// A sentence that is no more than text; empty text says nothing.
    static Statement plain(std::string text);

    StatementId id() const { return id_; }
    bool empty() const { return id_ == StatementId::none; }
    const std::vector<Parameter>& parameters() const { return parameters_; }
    void add(Parameter parameter);
    /// Null where there is none of this name, or it is of another type.
    const double* number(std::string_view name) const;
    const std::string* text(std::string_view name) const;
    const Statement* statement(std::string_view name) const;

  private:
    friend Statement statement_from_json(const nlohmann::ordered_json& node);
    void sort();

    StatementId id_ = StatementId::none;
    std::vector<Parameter> parameters_;
};

/// A number in the unit that its name ends with (or the metric's), a text (an id, a label, a name from a
/// task), or another statement.
struct Parameter {
    Parameter(std::string key, double number) : name(std::move(key)), value(number) {}
    Parameter(std::string key, std::string text) : name(std::move(key)), value(std::move(text)) {}
    Parameter(std::string key, Statement part) : name(std::move(key)), value(std::move(part)) {}
    std::string name;
    std::variant<double, std::string, Statement> value;
};

bool operator==(const Statement& a, const Statement& b);
bool operator!=(const Statement& a, const Statement& b);

/// {"id": "metric.low_rate", "rate_hz": 10.0, "least_hz": 20.0}; null for an empty one and for plain text.
nlohmann::ordered_json statement_json(const Statement& statement);

/// As a store keeps it: compact JSON; plain text as it is; "" for an empty one.
std::string stored_text(const Statement& statement);
/// The other way. What is not a statement of this program is plain text: stores from before statements had
/// ids hold English sentences.
Statement statement_of(const std::string& stored);

}  // namespace fulcrum
