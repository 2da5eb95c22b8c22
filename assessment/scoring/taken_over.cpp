// SPDX-License-Identifier: Apache-2.0
#include "assessment/scoring/taken_over.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "assessment/metrics/registry.h"
#include "assessment/scoring/benchmark.h"
#include "assessment/scoring/gate_rules.h"
#include "assessment/task/limit_source.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum {

namespace {

/// Nothing for a gate whose limit is not provisional, or whose metric this program does not know.
std::optional<ProvisionalLimit> provisional_limit(const GateSpec& gate) {
    const MetricDescriptor* metric = find_metric(gate.metric);
    if (gate.kind != GateKind::absolute || !gate.provisional || metric == nullptr) return std::nullopt;
    return ProvisionalLimit{gate.metric, gate.hand, gate.tissue, metric->version, gate.limit, gate.exclusive};
}

bool limit_same_values(const ProvisionalLimit& a, const ProvisionalLimit& b) {
    return a.metric == b.metric && a.hand == b.hand && a.tissue == b.tissue;
}

bool is_unchanged(const ProvisionalLimit& now, const ProvisionalLimit& then) {
    return now.metric_version == then.metric_version && now.limit == then.limit &&
           now.exclusive == then.exclusive;
}

/// What the set took over of the same values; null: nothing.
const ProvisionalLimit* find_taken_over(const BenchmarkSet& set, const ProvisionalLimit& now) {
    if (set.provisional) return nullptr;
    const auto found = std::find_if(set.taken_over.begin(), set.taken_over.end(),
                                    [&](const ProvisionalLimit& one) { return limit_same_values(one, now); });
    return found == set.taken_over.end() ? nullptr : &*found;
}

ProvisionalLimit taken_over_row(const nlohmann::json& row) {
    const auto text = [&](const char* key) {
        return row.at(key).is_null() ? std::string() : row.at(key).get<std::string>();
    };
    return {row.at("metric").get<std::string>(),
            text("hand"),
            text("tissue"),
            row.at("metric_version").get<int>(),
            row.at("limit").get<double>(),
            row.value("exclusive", false)};
}

}  // namespace

std::vector<ProvisionalLimit> limits_to_take_over(const TaskDefinition& task) {
    std::vector<ProvisionalLimit> limits;
    for (const GateSpec& gate : task.gates)
        if (const std::optional<ProvisionalLimit> limit = provisional_limit(gate)) limits.push_back(*limit);
    return limits;
}

bool takes_over(const BenchmarkSet& set, const GateSpec& gate) {
    const std::optional<ProvisionalLimit> now = provisional_limit(gate);
    const ProvisionalLimit* then = now ? find_taken_over(set, *now) : nullptr;
    return then != nullptr && is_unchanged(*now, *then);
}

TakenOver taken_over(const TaskDefinition& task, const BenchmarkSet& set) {
    TakenOver result;
    for (const ProvisionalLimit& now : limits_to_take_over(task)) {
        const ProvisionalLimit* then = find_taken_over(set, now);
        if (then == nullptr) {
            result.left.push_back({now, std::nullopt});
        } else if (is_unchanged(now, *then)) {
            result.by_site.push_back(now);
        } else {
            result.left.push_back({now, *then});
        }
    }
    return result;
}

std::string taken_over_source(const std::string& words, const BenchmarkSet& set) {
    LimitSource source;
    source.kind = LimitSource::Kind::taken_over;
    source.of = words;
    source.site = set.source;
    source.set = set.version;
    return limit_source_line(source);
}

std::string provisional_words(const ProvisionalLimit& limit) {
    const MetricDescriptor* metric = find_metric(limit.metric);
    const bool higher = metric != nullptr && metric->direction == Direction::higher;
    std::string words = limit.metric;
    for (const std::string& part : {limit.hand, limit.tissue})
        if (!part.empty()) words += " " + part;
    words += limit.exclusive ? (higher ? " more than " : " less than ") : higher ? " at least " : " at most ";
    words += nlohmann::json(limit.limit).dump();  // as the file has it
    if (metric != nullptr && metric->unit != "-") words += " " + metric->unit;
    return words;
}

std::string provisional_words(const std::vector<ProvisionalLimit>& limits) {
    std::string words;
    for (const ProvisionalLimit& limit : limits)
        words += (words.empty() ? "" : "; ") + provisional_words(limit);
    return words;
}

nlohmann::json taken_over_to_json(const std::vector<ProvisionalLimit>& limits) {
    using nlohmann::json;
    const auto text = [](const std::string& value) { return value.empty() ? json(nullptr) : json(value); };
    json rows = json::array();
    for (const ProvisionalLimit& limit : limits) {
        rows.push_back({{"metric", limit.metric},
                        {"metric_version", limit.metric_version},
                        {"hand", text(limit.hand)},
                        {"tissue", text(limit.tissue)},
                        {"limit", limit.limit}});
        if (limit.exclusive) rows.back()["exclusive"] = true;
    }
    return rows;
}

std::vector<ProvisionalLimit> taken_over_from_json(const JsonDocument& document) {
    std::vector<ProvisionalLimit> limits;
    if (!document.root().contains("taken_over")) return limits;
    if (document.root().at("provisional").get<bool>())
        document.fail("/taken_over",
                      QT_TRANSLATE_NOOP("errors", "a provisional set takes over no limits of its task"),
                      QT_TRANSLATE_NOOP("errors", "build the set of attempts that people performed"));
    for (const nlohmann::json& row : document.root().at("taken_over")) {
        const std::string place = "/taken_over/" + std::to_string(limits.size());
        const ProvisionalLimit limit = taken_over_row(row);
        const MetricDescriptor* metric = find_metric(limit.metric);
        if (metric == nullptr)
            document.fail(place + "/metric",
                          {QT_TRANSLATE_NOOP("errors", "unknown metric '%1'"), limit.metric},
                          QT_TRANSLATE_NOOP("errors", "give the id of a metric"));
        if (const std::optional<WrongRow> wrong = wrong_row(*metric, limit.hand, limit.tissue))
            document.fail(place + wrong->key, wrong->what, wrong->hint);
        if (std::any_of(limits.begin(), limits.end(),
                        [&](const ProvisionalLimit& one) { return limit_same_values(one, limit); }))
            document.fail(
                place, {QT_TRANSLATE_NOOP("errors", "the limit of '%1' is taken over twice"), limit.metric},
                QT_TRANSLATE_NOOP("errors", "remove one"));
        limits.push_back(limit);
    }
    return limits;
}

}  // namespace fulcrum
