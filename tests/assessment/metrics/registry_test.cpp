// SPDX-License-Identifier: Apache-2.0
// The registry is complete and free of duplicates and cycles; results survive JSON; long traces are quick
// enough to test.
#include "assessment/metrics/registry.h"
#include "assessment/metrics/statement_words.h"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <thread>

#include "assessment/metrics/metrics_json.h"
#include "assessment/trace/trace_csv.h"
#include "sim_core/numerics/input_error.h"
#include "tests/assessment/metrics/traces.h"

namespace fulcrum {
namespace {

TEST(Registry, HoldsTheMetricsOfTheSpecification) {
    for (const char* id :
         {"time",           "path_len",   "ang_path",     "econ",       "retract_path", "seek_path",
          "depth_axis",     "depth_err",  "depth_err_sd", "n_moves",    "n_sub",        "idle",
          "speed_mean",     "speed_peak", "ws_volume",    "off_screen", "handed",       "bimanual_r",
          "bimanual_r_ang", "simul",      "sparc",        "ldlj",       "tremor",       "f_sparc",
          "f_max",          "f_sd",       "f_mean_nz",    "impulse",    "f_peaks",      "dfdt_max",
          "f_volume",       "over_time",  "over_impulse", "grasp_max",  "grasp_ftp",    "grasp_ftp_patch",
          "grasp_kpa",      "slip",       "regrasp",      "drop",       "perforation"})
        EXPECT_NE(find_metric(id), nullptr) << id;
    for (const char* id :
         {"traction_eff", "traction_eff_len", "cut_dev", "cut_dev_max", "plane_dev", "plane_dev_median",
          "plane_dev_p95", "plane_deep", "plane_shallow", "area_developed"})
        EXPECT_NE(find_metric(id), nullptr) << id;
    for (const char* id :
         {"energy_safe", "energy_time", "lateral_heat", "bleed_ml", "vessel_injury", "nerve_injury", "tear"})
        EXPECT_NE(find_metric(id), nullptr) << id;
    for (const char* id :
         {"scope_path", "scope_ldlj", "horizon_err", "centre_err", "size_err", "tip_lost", "lens_contact"})
        EXPECT_NE(find_metric(id), nullptr) << id;
    for (const char* id : {"tme_grade", "tme_defect", "crm_mm", "drm_mm", "plane_dev_right", "plane_dev_mid",
                           "plane_dev_left"})
        EXPECT_NE(find_metric(id), nullptr) << id;
    EXPECT_EQ(find_metric("path_lenght"), nullptr);
}

TEST(Registry, TakesLogarithmsOnlyOfWhatCannotBeZero) {
    const std::set<std::string> allowed = {"time",  "path_len", "ang_path", "ws_volume",
                                           "f_max", "impulse",  "dfdt_max", "scope_path"};
    for (const Metric& metric : metric_registry())
        EXPECT_EQ(metric.descriptor.scale == Scale::ln, allowed.count(metric.descriptor.id) == 1)
            << metric.descriptor.id;
}

TEST(Registry, RefusesDuplicatesCyclesAndGaps) {
    const std::vector<Metric> good(metric_registry().begin(), metric_registry().begin() + 3);
    EXPECT_NO_THROW(check_registry(good));
    std::vector<Metric> twice = good;
    twice.push_back(good[0]);
    EXPECT_THROW(check_registry(twice), std::logic_error);
    std::vector<Metric> cycle = good;
    cycle[0].descriptor.dependencies = {cycle[1].descriptor.id};
    cycle[1].descriptor.dependencies = {cycle[0].descriptor.id};
    EXPECT_THROW(check_registry(cycle), std::logic_error);
    std::vector<Metric> unknown = good;
    unknown[2].descriptor.dependencies = {"nothing"};
    EXPECT_THROW(check_registry(unknown), std::logic_error);
    for (std::string MetricDescriptor::*field :
         {&MetricDescriptor::name, &MetricDescriptor::unit, &MetricDescriptor::source,
          &MetricDescriptor::filter, &MetricDescriptor::explanation, &MetricDescriptor::advice_fault,
          &MetricDescriptor::advice_remedy}) {
        std::vector<Metric> gap = good;
        (gap[1].descriptor.*field).clear();
        EXPECT_THROW(check_registry(gap), std::logic_error);
    }
    std::vector<Metric> logarithm = good;
    logarithm[0].descriptor.aggregation = Aggregation::count;
    EXPECT_THROW(check_registry(logarithm), std::logic_error);
}

TEST(Compute, GivesOneRowAValueAndRefusesUnknownIds) {
    Trace trace = test::make_trace(3.0);
    trace.tissues = {"bowel", "wall"};
    test::set_position(trace, Hand::left, [](double t) { return Vector3(0.01 * t, 0, 0); });
    test::set_force(trace, Hand::left, [](double) { return Vector3(1, 0, 0); });
    test::set_tissue(trace, Hand::left, [](double t) { return t < 2 ? 0 : -1; });
    const std::vector<MetricResult> results = compute_metrics(trace, {}, {});
    std::set<std::string> keys;
    for (const MetricResult& result : results) {
        EXPECT_TRUE(keys.insert(result.id + "/" + result.hand + "/" + result.tissue).second) << result.id;
        EXPECT_EQ(result.value.has_value(), result.absent_because.empty()) << result.id;
        EXPECT_EQ(words_of(result.absent_because).find('{'), std::string::npos)
            << words_of(result.absent_because);
        EXPECT_EQ(result.value.has_value(), result.absence == Absence::none) << result.id;
    }
    EXPECT_NE(find_result(results, "f_max", "left", "bowel"), nullptr);
    EXPECT_EQ(find_result(results, "f_max", "left", "wall"), nullptr);  // neither touched nor limited
    MetricContext context;
    context.metrics = {"path_len", "no_such_metric"};
    EXPECT_THROW(compute_metrics(trace, {}, context), std::invalid_argument);
}

TEST(Compute, GivesTheSameRowsOnEveryThreadAndTheSecondTime) {
    Trace trace = test::make_trace(12.0);
    test::set_position(trace, Hand::left, test::reaches(5, 0.1, 1.0, 1.0));
    test::set_force(trace, Hand::left, [](double t) { return Vector3(std::sin(t), 1, 0); });
    const nlohmann::json first = metrics_to_json(compute_metrics(trace, {}, {}));
    nlohmann::json other;
    std::thread thread([&] { other = metrics_to_json(compute_metrics(trace, {}, {})); });
    const nlohmann::json second = metrics_to_json(compute_metrics(trace, {}, {}));
    thread.join();
    EXPECT_EQ(first, second);
    EXPECT_EQ(first, other);
}

TEST(Compute, OfAnEmptyRecordIsAbsentThroughout) {
    Trace trace = trace_from_samples({}, {}, {"bowel"});
    for (const MetricResult& result : compute_metrics(trace, {}, {})) {
        const bool counted = result.id == "slip" || result.id == "regrasp" || result.id == "drop" ||
                             result.id == "perforation" || result.id == "vessel_injury" ||
                             result.id == "nerve_injury" || result.id == "tear" ||
                             result.id == "lens_contact";
        EXPECT_EQ(result.value.has_value(), counted) << result.id;
    }
}

TEST(Json, KeepsEveryField) {
    Trace trace = test::make_trace(3.0);
    test::set_position(trace, Hand::left, test::reaches(1, 0.1, 1.0, 1.0));
    const std::vector<MetricResult> results = compute_metrics(trace, {}, {});
    const nlohmann::json rows = metrics_to_json(results);
    const std::vector<MetricResult> back =
        metrics_from_json(nlohmann::json::parse(rows.dump()), "attempt.json");
    ASSERT_EQ(back.size(), results.size());
    EXPECT_EQ(metrics_to_json(back), rows);
    for (const char* key :
         {"id", "version", "hand", "tissue", "value", "absent_because", "unit", "direction", "evidence"})
        EXPECT_TRUE(rows[0].contains(key)) << key;
    nlohmann::json broken = rows;
    broken[2].erase("unit");
    try {
        metrics_from_json(broken, "attempt.json");
        FAIL() << "a row without unit was read";
    } catch (const InputError& error) {
        EXPECT_EQ(error.place(), "/metrics/2");
    }
}

TEST(Json, OfATraceFile) {
    Trace trace = test::make_trace(6.0, 200.0);
    test::set_position(trace, Hand::left, [](double t) {
        const double angle = t * test::pi;
        return Vector3(0.020 * std::cos(angle), 0.020 * std::sin(angle), 0.010 * angle / (2 * test::pi));
    });
    const std::string path = ::testing::TempDir() + "helix_trace.csv";
    {
        std::ofstream out(path);
        write_trace_csv(trace, out);
    }
    const nlohmann::json json = metrics_of_trace(read_trace_csv(path), path);
    EXPECT_EQ(json.at("samples"), 1201);
    EXPECT_NEAR(json.at("mean_rate_hz").get<double>(), 200.0, 1e-6);
    const std::vector<MetricResult> results = metrics_from_json(json.at("metrics"), path);
    EXPECT_NEAR(find_result(results, "path_len", "left", "")->value.value_or(0), 378.1829, 0.378);
    EXPECT_EQ(words_of(find_result(results, "f_max", "left", "")->absent_because),
              "not recorded: left.fx, left.fy, left.fz");
    EXPECT_FALSE(find_result(results, "slip", "left", "")->value);
}

}  // namespace
}  // namespace fulcrum
