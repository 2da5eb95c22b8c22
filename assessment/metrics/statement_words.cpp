// SPDX-License-Identifier: Apache-2.0
#include "assessment/metrics/statement_words.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "assessment/metrics/registry.h"
#include "assessment/task/attempt_words.h"
#include "sim_core/numerics/number_text.h"
#include "sim_core/telemetry/event_types.h"

namespace fulcrum {

constexpr StatementRow statements[] = {
    {StatementId::none, "none", ""},
    {StatementId::plain, "plain", QT_TRANSLATE_NOOP("fulcrum::statements", "{text}")},
    {StatementId::nothing_moved, "metric.nothing_moved",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "no instrument moved faster than 5 mm/s for 0.2 s inside the body")},
    {StatementId::hand_never_moved, "metric.hand_never_moved",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "the instrument never moved faster than 5 mm/s for 0.2 s inside the body")},
    {StatementId::few_way_points, "metric.few_way_points",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "fewer than {least} way-points (targets reached, grasps, releases)")},
    {StatementId::still_between_way_points, "metric.still_between_way_points",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the instrument did not move between way-points")},
    {StatementId::target_positions_unknown, "metric.target_positions_unknown",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the positions of targets are not known")},
    {StatementId::no_target_shown, "metric.no_target_shown",
     QT_TRANSLATE_NOOP("fulcrum::statements", "no target was shown to this hand")},
    {StatementId::no_target_reached, "metric.no_target_reached",
     QT_TRANSLATE_NOOP("fulcrum::statements", "no target was held")},
    {StatementId::tip_not_followed, "metric.tip_not_followed",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the moving tip was never found")},
    {StatementId::few_target_movements, "metric.few_target_movements",
     QT_TRANSLATE_NOOP("fulcrum::statements", "fewer than {least} movements towards a target")},
    {StatementId::no_movement_between_rests, "metric.no_movement_between_rests",
     QT_TRANSLATE_NOOP("fulcrum::statements", "no movement between two rests")},
    {StatementId::never_inside, "metric.never_inside",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the instrument was never inside the body")},
    {StatementId::flat_movement, "metric.flat_movement",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the tip did not move in three dimensions")},
    {StatementId::no_specimen, "metric.no_specimen",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the task leaves no specimen")},
    {StatementId::nothing_cut, "metric.nothing_cut",
     QT_TRANSLATE_NOOP("fulcrum::statements", "nothing was cut")},
    {StatementId::specimen_undivided, "metric.specimen_undivided",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "{percent} % of the plane was divided; a grade needs {least} %")},
    {StatementId::no_tumour, "metric.no_tumour",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the case has no tumour")},
    {StatementId::tumour_plane_undivided, "metric.tumour_plane_undivided",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the plane next to the tumour was not divided")},
    {StatementId::not_beyond_tumour, "metric.not_beyond_tumour",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the dissection did not reach beyond the tumour")},
    {StatementId::sector_uncut, "metric.sector_uncut",
     QT_TRANSLATE_NOOP("fulcrum::statements", "nothing was cut in this sector")},
    {StatementId::no_marked_line, "metric.no_marked_line",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the task marks no line to cut along")},
    {StatementId::traction_not_recorded, "metric.traction_not_recorded",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the traction of the cut was not recorded")},
    {StatementId::no_traction_band, "metric.no_traction_band",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the task sets no range of traction")},
    {StatementId::line_without_length, "metric.line_without_length",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the task's line has no length")},
    {StatementId::no_energy, "metric.no_energy",
     QT_TRANSLATE_NOOP("fulcrum::statements", "energy was never activated")},
    {StatementId::nothing_recorded, "metric.nothing_recorded",
     QT_TRANSLATE_NOOP("fulcrum::statements", "nothing was recorded")},
    {StatementId::few_movements, "metric.few_movements",
     QT_TRANSLATE_NOOP("fulcrum::statements", "{count} movements, fewer than {least}")},
    {StatementId::few_loaded_movements, "metric.few_loaded_movements",
     QT_TRANSLATE_NOOP("fulcrum::statements", "{count} movements with force on tissue, fewer than {least}")},
    {StatementId::movements_hold_little, "metric.movements_hold_little",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "movements between two rests hold less than half of the moving time")},
    {StatementId::device_noise, "metric.device_noise",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "the device's position noise at rest is {noise_um} µm, above {limit_um} µm")},
    {StatementId::short_inside, "metric.short_inside",
     QT_TRANSLATE_NOOP("fulcrum::statements", "less than {least_s} s with the instrument inside the body")},
    {StatementId::hand_still, "metric.hand_still",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the instrument did not move")},
    {StatementId::all_still, "metric.all_still",
     QT_TRANSLATE_NOOP("fulcrum::statements", "no instrument moved")},
    {StatementId::one_hand_still, "metric.one_hand_still",
     QT_TRANSLATE_NOOP("fulcrum::statements", "one of the instruments did not move while both were inside")},
    {StatementId::nobody_inside, "metric.nobody_inside",
     QT_TRANSLATE_NOOP("fulcrum::statements", "no instrument was inside the body")},
    {StatementId::no_force, "metric.no_force",
     QT_TRANSLATE_NOOP("fulcrum::statements", "there was no force on tissue")},
    {StatementId::no_force_on, "metric.no_force_on",
     QT_TRANSLATE_NOOP("fulcrum::statements", "there was no force on {tissue}")},
    {StatementId::no_force_limit, "metric.no_force_limit",
     QT_TRANSLATE_NOOP("fulcrum::statements", "no force limit is known for any tissue")},
    {StatementId::no_force_limit_for, "metric.no_force_limit_for",
     QT_TRANSLATE_NOOP("fulcrum::statements", "no force limit is known for {tissue}")},
    {StatementId::short_force, "metric.short_force",
     QT_TRANSLATE_NOOP("fulcrum::statements", "less than {least_s} s with force on tissue")},
    {StatementId::nothing_grasped, "metric.nothing_grasped",
     QT_TRANSLATE_NOOP("fulcrum::statements", "nothing was grasped")},
    {StatementId::numbers_too_large, "metric.numbers_too_large",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the record's numbers are too large for it")},
    {StatementId::no_events, "metric.no_events",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the record carries no events")},
    {StatementId::few_samples, "metric.few_samples",
     QT_TRANSLATE_NOOP("fulcrum::statements", "fewer than two consecutive samples")},
    {StatementId::low_rate, "metric.low_rate",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the mean rate of {rate_hz} Hz is below {least_hz} Hz")},
    {StatementId::samples_lost, "metric.samples_lost",
     QT_TRANSLATE_NOOP("fulcrum::statements", "{count} samples were lost")},
    {StatementId::not_recorded, "metric.not_recorded",
     QT_TRANSLATE_NOOP("fulcrum::statements", "not recorded: {channels}")},
    {StatementId::metric_not_computed, "gate.metric_not_computed",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the metric was not computed")},
    {StatementId::metric_unknown, "gate.metric_unknown",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the program does not know the metric")},
    {StatementId::no_benchmark, "gate.no_benchmark",
     QT_TRANSLATE_NOOP("fulcrum::statements", "there is no benchmark for this task and device class")},
    {StatementId::no_benchmark_level, "gate.no_benchmark_level",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the benchmark set has no level for it")},
    {StatementId::cutting_differs, "gate.cutting_differs",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "not comparable: cutting parameters differ from those of the benchmark's scene "
                       "({difference})")},
    {StatementId::device_class_differs, "gate.device_class_differs",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "not comparable: there are no limits for this device class ({device})")},
    {StatementId::fidelity_differs, "gate.fidelity_differs",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "not comparable: the limits are for fidelity {limits}, the attempt used {used}")},
    {StatementId::variant_differs, "gate.variant_differs",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "not comparable: the limits are for variant {limits}, the attempt used {used}")},
    {StatementId::limits_replaced, "gate.limits_replaced",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "not comparable: the limits in force when the attempt began have been replaced")},
    {StatementId::limits_outdated, "gate.limits_outdated",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "not comparable: the limits in force were made with another version of the metric "
                       "'{metric}'; they have to be built again")},
    {StatementId::simulator_failed, "score.simulator_failed",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the simulator failed during the attempt")},
    {StatementId::attempt_interrupted, "score.attempt_interrupted",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the attempt was interrupted")},
    {StatementId::ended_before_moving, "score.ended_before_moving",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the attempt ended before the first movement")},
    {StatementId::device_was_lost, "score.device_was_lost",
     QT_TRANSLATE_NOOP("fulcrum::statements", "a device was lost and came back: what followed is practice")},
    {StatementId::no_gates, "score.no_gates",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the task has no gates")},
    {StatementId::recorded_elsewhere, "score.recorded_elsewhere",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "it was recorded elsewhere and imported: measured, but judged by no limits")},
    {StatementId::gate_not_judged, "score.gate_not_judged",
     QT_TRANSLATE_NOOP("fulcrum::statements", "{metric}{of_hand}: {because}")},
    {StatementId::practice_device_lost, "practice.device_lost",
     QT_TRANSLATE_NOOP("fulcrum::statements", "a device was lost and came back")},
    {StatementId::practice_stood_still, "practice.stood_still",
     QT_TRANSLATE_NOOP("fulcrum::statements", "the program stood still for {seconds} s")},
    {StatementId::critical_error, "advice.critical_error",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "{where}critical error, {event}{in_tissue} at {time}; {remedy}.")},
    {StatementId::gate_missed, "advice.gate_missed",
     QT_TRANSLATE_NOOP("fulcrum::statements", "{where}{fault} ({excess}){on_tissue}; {remedy}.")},
    {StatementId::gates_met, "advice.gates_met",
     QT_TRANSLATE_NOOP("fulcrum::statements", "All gates are met. Repeat the task to make it a habit.")},
    {StatementId::gates_met_narrowly, "advice.gates_met_narrowly",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "All gates are met. Closest to its limit: {metric}{of_hand} ({value}, limit {limit}). "
                       "To improve: {remedy}.")},
    {StatementId::time_ran_out, "advice.time_ran_out",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "The time ran out before the last step was completed. To improve: {remedy}.")},
    {StatementId::attempt_abandoned, "advice.attempt_abandoned",
     QT_TRANSLATE_NOOP("fulcrum::statements",
                       "The attempt was abandoned before the last step was completed. Carry the next one "
                       "through to the end.")},
    {StatementId::gate_without_value, "advice.gate_without_value",
     QT_TRANSLATE_NOOP("fulcrum::statements", "{where}{metric} has no value because {because}; {remedy}.")},
    {StatementId::not_scored, "advice.not_scored",
     QT_TRANSLATE_NOOP("fulcrum::statements", "Not scored: {because}.")},
};
static_assert(in_order(statements));

namespace {

constexpr const char* statement_context = "fulcrum::statements";
/// Between a number's whole part and its decimals.
constexpr const char* decimal_sign = QT_TRANSLATE_NOOP("fulcrum::statements", ".");

std::string clock_words(double t) {
    const auto seconds = static_cast<int>(std::max(0.0, t));
    return std::to_string(seconds / 60) + (seconds % 60 < 10 ? ":0" : ":") + std::to_string(seconds % 60);
}

/// Sentences begin with a letter of a hand's or an event's name, which their tables write small.
std::string capitalised(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    // In UTF-8 the letters à to þ are 0x20 above their capitals; ÷ is among them.
    constexpr char latin = '\xC3', first = '\xA0', last = '\xBE', divided_by = '\xB7';
    if (text.size() > 1 && text[0] == latin && text[1] >= first && text[1] <= last && text[1] != divided_by)
        text[1] = static_cast<char>(text[1] - 0x20);
    return text;
}

bool is_advice(StatementId id) {
    return id >= StatementId::critical_error;
}

/// One statement's words: fills its row's text with what stands in braces.
class Wording {
  public:
    Wording(const Statement& statement, Translate translate) : statement_(statement), translate_(translate) {
        const std::string* id =
            statement.text(statement.id() == StatementId::critical_error ? "event" : "metric");
        if (id != nullptr) metric_ = find_metric(*id);
    }

    std::string words() const {
        std::string text = fill(marked(row_of(statements, statement_.id()).words));
        return is_advice(statement_.id()) ? capitalised(std::move(text)) : text;
    }

  private:
    std::string marked(const char* source) const { return translate_(statement_context, source); }
    std::string of_asset(const std::string& source) const {
        return source.empty() ? source : translate_("assets", source.c_str());
    }
    /// The number's decimal point as the reader's language writes it.
    std::string written(std::string number) const {
        const std::size_t point = number.find('.');
        return point == std::string::npos ? number : number.replace(point, 1, marked(decimal_sign));
    }
    /// A number that no metric writes: one digit after the point where it has any.
    std::string number_words(double value) const {
        const std::string text = decimal_text(value, 1);
        const std::size_t whole = text.size() - 2;
        return written(text.compare(whole, 2, ".0") == 0 ? text.substr(0, whole) : text);
    }
    /// A value with its unit, as many digits as the metric's precision asks for.
    std::string value_words(const MetricDescriptor& metric, double value) const {
        const int digits = std::max(0, static_cast<int>(std::ceil(-std::log10(metric.precision) - 1e-9)));
        std::string text = written(decimal_text(value, digits));
        if (metric.unit != "-") text += " " + metric.unit;
        return text;
    }
    std::string of_metric(const std::string& source) const {
        return translate_("fulcrum::metrics", source.c_str());
    }

    std::string fill(const std::string& text) const {
        std::string out;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t open = text.find('{', at), close = text.find('}', open);
            if (close == std::string::npos) return out + text.substr(at);
            const std::string name = text.substr(open + 1, close - open - 1);
            out += text.substr(at, open - at) + named(name).value_or("{" + name + "}");
            at = close + 1;
        }
        return out;
    }

    std::string text_of(std::string_view name) const {
        const std::string* text = statement_.text(name);
        return text == nullptr ? std::string() : *text;
    }

    std::optional<std::string> named(const std::string& name) const {
        if (name == "where") return where();
        if (name == "of_hand")
            return text_of("hand").empty()
                       ? ""
                       : fill(marked(QT_TRANSLATE_NOOP("fulcrum::statements", ", {hand}")));
        if (name == "in_tissue")
            return text_of("tissue").empty()
                       ? ""
                       : fill(marked(QT_TRANSLATE_NOOP("fulcrum::statements", " ({tissue})")));
        if (name == "on_tissue")
            return text_of("tissue").empty()
                       ? ""
                       : fill(marked(QT_TRANSLATE_NOOP("fulcrum::statements", ", on {tissue}")));
        if (name == "hand") return hand();
        if (name == "device") return device();
        if (name == "event") return event();
        if (name == "time" && statement_.number("time_s") != nullptr)
            return clock_words(*statement_.number("time_s"));
        if (name == "metric" && metric_ != nullptr) return of_metric(metric_->name);
        if (name == "fault") return fault();
        if (name == "excess") return excess();
        if (name == "remedy") return remedy();
        return parameter(name);
    }

    std::optional<std::string> device() const {
        const NameRow<DeviceClass>* row = find_row(device_classes, text_of("device"));
        if (row == nullptr) return parameter("device");
        return translate_("fulcrum::devices", row->title);
    }

    std::optional<std::string> parameter(const std::string& name) const {
        if (const double* number = statement_.number(name))
            return metric_ != nullptr && (name == "value" || name == "limit") ? value_words(*metric_, *number)
                                                                              : number_words(*number);
        if (const std::string* text = statement_.text(name))
            return name == "tissue" || name == "phase" ? of_asset(*text) : *text;
        if (const Statement* part = statement_.statement(name)) return words_of(*part, translate_);
        return std::nullopt;
    }

    std::string hand() const {
        const std::string hand = text_of("hand");
        if (hand == "left") return marked(QT_TRANSLATE_NOOP("fulcrum::statements", "left hand"));
        if (hand == "right") return marked(QT_TRANSLATE_NOOP("fulcrum::statements", "right hand"));
        return hand;
    }

    std::string where() const {
        const bool hand = !text_of("hand").empty(), phase = !text_of("phase").empty();
        if (hand && phase)
            return fill(marked(QT_TRANSLATE_NOOP("fulcrum::statements", "{hand}, in '{phase}': ")));
        if (hand) return fill(marked(QT_TRANSLATE_NOOP("fulcrum::statements", "{hand}: ")));
        if (phase) return fill(marked(QT_TRANSLATE_NOOP("fulcrum::statements", "in '{phase}': ")));
        return {};
    }

    std::string event() const {
        const std::string name = text_of("event");
        const auto* row = find_row(event_kinds, name);
        return row == nullptr ? name : translate_("fulcrum::events", row->title);
    }

    std::string fault() const {
        if (metric_ != nullptr) return fill(of_metric(metric_->advice_fault));
        return fill(
            marked(QT_TRANSLATE_NOOP("fulcrum::statements", "{metric} is {value}, the limit is {limit}")));
    }

    std::string remedy() const {
        if (const std::string* of_task = statement_.text("advice")) return of_asset(*of_task);
        if (metric_ != nullptr) return of_metric(metric_->advice_remedy);
        return marked(QT_TRANSLATE_NOOP("fulcrum::statements", "replay that moment and plan it differently"));
    }

    /// How far beyond the limit: in the experts' standard deviations, in percent, or in the metric's unit.
    std::optional<std::string> excess() const {
        const double *value = statement_.number("value"), *limit = statement_.number("limit");
        if (value == nullptr || limit == nullptr) return std::nullopt;
        const auto with = [&](const char* source, const std::string& amount) {
            std::string text = marked(source);
            const std::size_t at = text.find("{amount}");
            return at == std::string::npos ? text : text.replace(at, 8, amount);
        };
        const double* z = statement_.number("z");
        const bool higher = metric_ != nullptr && metric_->direction == Direction::higher;
        const bool more_than_twice = !higher && *limit > 0 && *value > 2 * *limit;
        if ((z != nullptr && *z > z_shown_up_to) || (z == nullptr && more_than_twice))
            return marked(QT_TRANSLATE_NOOP("fulcrum::statements", "far outside"));
        if (z != nullptr)
            return with(
                QT_TRANSLATE_NOOP("fulcrum::statements", "{amount} standard deviations from the experts"),
                written(decimal_text(*z, 1)));
        if (!higher && *limit > 0) {
            const double percent = 100.0 * (*value - *limit) / *limit;
            if (percent < 1) return marked(QT_TRANSLATE_NOOP("fulcrum::statements", "less than 1 % over"));
            return with(QT_TRANSLATE_NOOP("fulcrum::statements", "{amount} % over"),
                        decimal_text(percent, 0));
        }
        const double difference = std::abs(*value - *limit);
        return with(higher ? QT_TRANSLATE_NOOP("fulcrum::statements", "{amount} short")
                           : QT_TRANSLATE_NOOP("fulcrum::statements", "{amount} over"),
                    metric_ != nullptr ? value_words(*metric_, difference) : number_words(difference));
    }

    const Statement& statement_;
    Translate translate_;
    const MetricDescriptor* metric_ = nullptr;
};

}  // namespace

std::string words_of(const Statement& statement, Translate translate) {
    if (statement.empty()) return {};
    if (statement.id() == StatementId::plain) return *statement.text("text");
    return Wording(statement, translate).words();
}

}  // namespace fulcrum
