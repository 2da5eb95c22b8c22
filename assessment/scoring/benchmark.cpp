// SPDX-License-Identifier: Apache-2.0
#include "assessment/scoring/benchmark.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "assessment/metrics/registry.h"
#include "sim_core/scene/json_document.h"
#include "sim_core/scene/json_names.h"
#include "sim_core/scene/standard_names.h"

namespace fulcrum {

extern const char* const
    benchmark_schema_text;  // assets/schemas/benchmark.schema.json, embedded by the build

namespace {

using nlohmann::json;

constexpr std::size_t size_limit = std::size_t{1} << 20U;

json text_or_null(const std::string& text) {
    return text.empty() ? json(nullptr) : json(text);
}
json number_or_null(const std::optional<double>& number) {
    return number ? json(*number) : json(nullptr);
}
std::string text_of(const json& value) {
    return value.is_null() ? std::string() : value.get<std::string>();
}
std::optional<double> number_of(const json& value) {
    return value.is_null() ? std::nullopt : std::optional<double>(value.get<double>());
}

json people_to_json(const std::vector<BenchmarkPerson>& people) {
    json rows = json::array();
    for (const BenchmarkPerson& person : people)
        rows.push_back({{"name", person.name},
                        {"attempts", person.attempts},
                        {"familiarisation", person.familiarisation}});
    return rows;
}

std::vector<BenchmarkPerson> people_from_json(const json& rows) {
    std::vector<BenchmarkPerson> people;
    for (const json& row : rows)
        people.push_back({row.at("name").get<std::string>(), row.at("attempts").get<int>(),
                          row.at("familiarisation").get<int>()});
    return people;
}

BenchmarkLevel level_from_json(const json& row) {
    BenchmarkLevel level;
    level.metric = row.at("metric").get<std::string>();
    level.metric_version = row.at("metric_version").get<int>();
    level.hand = text_of(row.at("hand"));
    level.tissue = text_of(row.at("tissue"));
    level.unit = row.at("unit").get<std::string>();
    level.scale = row.at("scale").get<std::string>() == "ln" ? Scale::ln : Scale::raw;
    level.mean = row.at("mean").get<double>();
    level.deviation = row.at("deviation").get<double>();
    level.z_novice = number_of(row.at("z_novice"));
    level.absolute_limit = number_of(row.at("absolute_limit"));
    if (row.contains("k")) level.k = row.at("k").get<double>();
    level.experts = row.at("experts").get<int>();
    level.left_out = row.at("left_out").get<std::vector<std::string>>();
    return level;
}

[[noreturn]] void fail_outdated(const JsonDocument& document, const std::string& metric,
                                const std::string& pointer, const Sentence& wrong) {
    try {
        document.fail(pointer, wrong, QT_TRANSLATE_NOOP("errors", "build the set again"));
    } catch (const InputError& error) {
        throw OutdatedSet(error, metric);
    }
}

/// What the schema cannot say: the level fits the program's metric, and can be held against an attempt.
void check_level(const JsonDocument& document, const BenchmarkLevel& level, const std::string& place) {
    const MetricDescriptor* descriptor = find_metric(level.metric);
    if (descriptor == nullptr)
        document.fail(place + "/metric", {QT_TRANSLATE_NOOP("errors", "unknown metric '%1'"), level.metric},
                      QT_TRANSLATE_NOOP("errors", "give the id of a metric"));
    if (descriptor->unit != level.unit)
        fail_outdated(
            document, level.metric, place + "/unit",
            {QT_TRANSLATE_NOOP("errors", "unit '%1' of a metric in '%2'"), level.unit, descriptor->unit});
    if (descriptor->version != level.metric_version)
        fail_outdated(document, level.metric, place + "/metric_version",
                      {QT_TRANSLATE_NOOP("errors", "version %1 where the program computes version %2"),
                       level.metric_version, descriptor->version});
    if (descriptor->scale != level.scale)
        fail_outdated(document, level.metric, place + "/scale",
                      QT_TRANSLATE_NOOP("errors", "not the scale of the metric"));
    if (!level.absolute_limit && !(level.deviation > 0))
        document.fail(
            place + "/deviation",
            QT_TRANSLATE_NOOP("errors", "neither a deviation above 0 nor an absolute limit"),
            QT_TRANSLATE_NOOP("errors", "give the deviation, or the worst expert value as absolute_limit"));
}

}  // namespace

std::string benchmark_name(const BenchmarkKey& key) {
    const std::string device_class = row_of(device_classes, key.device_class).name;
    std::string name = key.task;
    if (key.variant != standard_variant) name += "-" + key.variant;
    if (key.device_class != DeviceClass::haptic) name += "-" + device_class;
    if (key.fidelity != standard_fidelity) name += "-" + key.fidelity;
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}

const BenchmarkLevel* BenchmarkSet::find(const std::string& metric, const std::string& hand,
                                         const std::string& tissue) const {
    for (const BenchmarkLevel& level : levels)
        if (level.metric == metric && level.hand == hand && level.tissue == tissue) return &level;
    return nullptr;
}

json benchmark_to_json(const BenchmarkSet& set) {
    json levels = json::array();
    for (const BenchmarkLevel& level : set.levels) {
        levels.push_back({{"metric", level.metric},
                          {"metric_version", level.metric_version},
                          {"hand", text_or_null(level.hand)},
                          {"tissue", text_or_null(level.tissue)},
                          {"unit", level.unit},
                          {"scale", level.scale == Scale::ln ? "ln" : "raw"},
                          {"mean", level.mean},
                          {"deviation", level.deviation},
                          {"z_novice", number_or_null(level.z_novice)},
                          {"absolute_limit", number_or_null(level.absolute_limit)},
                          {"experts", level.experts},
                          {"left_out", level.left_out}});
        if (level.k) levels.back()["k"] = *level.k;
    }
    json document = {{"$comment", "SPDX-License-Identifier: Apache-2.0"},
                     {"version", set.version},
                     {"task", set.task},
                     {"task_version", set.task_version},
                     {"variant_family", set.variant_family},
                     {"device_class", row_of(device_classes, set.device_class).name},
                     {"fidelity", set.fidelity},
                     {"source", set.source},
                     {"provisional", set.provisional},
                     {"k", set.k},
                     {"p0", set.p0},
                     {"expert_pass_share", set.expert_pass_share},
                     {"experts", people_to_json(set.experts)},
                     {"novices", people_to_json(set.novices)},
                     {"levels", std::move(levels)}};
    if (!set.note.empty()) document["note"] = set.note;
    if (!set.intermediates.empty()) document["intermediates"] = people_to_json(set.intermediates);
    if (set.intermediate_pass_share) document["intermediate_pass_share"] = *set.intermediate_pass_share;
    if (!set.taken_over.empty()) document["taken_over"] = taken_over_to_json(set.taken_over);
    if (!set.cutting.empty()) document["cutting"] = set.cutting;
    return document;
}

BenchmarkSet parse_benchmark(const std::string& text, const std::string& file) {
    const JsonDocument document = JsonDocument::parse(text, file);
    document.check_schema(benchmark_schema_text);
    const json& root = document.root();
    BenchmarkSet set;
    set.version = root.at("version").get<int>();
    set.task = root.at("task").get<std::string>();
    set.task_version = root.at("task_version").get<int>();
    set.variant_family = root.at("variant_family").get<std::string>();
    set.device_class = named(document, root.at("device_class"), "/device_class", device_classes);
    set.fidelity = root.at("fidelity").get<std::string>();
    set.source = root.at("source").get<std::string>();
    set.note = root.value("note", std::string());
    set.provisional = root.at("provisional").get<bool>();
    set.k = root.at("k").get<double>();
    set.p0 = root.at("p0").get<double>();
    set.expert_pass_share = root.at("expert_pass_share").get<double>();
    set.experts = people_from_json(root.at("experts"));
    set.novices = people_from_json(root.at("novices"));
    if (root.contains("intermediates")) set.intermediates = people_from_json(root.at("intermediates"));
    if (root.contains("intermediate_pass_share"))
        set.intermediate_pass_share = root.at("intermediate_pass_share").get<double>();
    set.taken_over = taken_over_from_json(document);
    if (root.contains("cutting")) set.cutting = root.at("cutting").get<CuttingValues>();
    std::set<std::tuple<std::string, std::string, std::string>> seen;
    for (const json& row : root.at("levels")) {
        const std::string place = "/levels/" + std::to_string(set.levels.size());
        BenchmarkLevel level = level_from_json(row);
        check_level(document, level, place);
        if (!seen.emplace(level.metric, level.hand, level.tissue).second)
            document.fail(place,
                          {QT_TRANSLATE_NOOP("errors", "the level of '%1' is given twice"), level.metric},
                          QT_TRANSLATE_NOOP("errors", "remove one"));
        set.levels.push_back(std::move(level));
    }
    return set;
}

BenchmarkSet load_benchmark(const std::string& path) {
    return parse_benchmark(read_text_file(path, size_limit), path);
}

}  // namespace fulcrum
