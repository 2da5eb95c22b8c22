// SPDX-License-Identifier: Apache-2.0
// Traces of other programs: the delivered mappings, units, missing values, and every error with its place.
#include "assessment/trace/trace_mapping.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "assessment/metrics/metrics_json.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

MappedTrace read_with(const TraceMapping& mapping, const std::string& text) {
    std::istringstream in(text);
    return read_mapped_trace(in, "other.txt", mapping);
}
/// The problem, or "" if it was read.
std::string mapping_problem(const std::string& text) {
    try {
        parse_trace_mapping(text, "map.json");
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}
std::string reading_problem(const std::string& mapping, const std::string& text) {
    try {
        read_with(parse_trace_mapping(mapping, "map.json"), text);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}
bool says(const std::string& message, const std::string& part) {
    return message.find(part) != std::string::npos;
}

constexpr const char* small_mapping =
    R"({"title": "Box", "separator": "semicolon", "columns": {
        "t": {"column": "Clock", "unit": "ms"},
        "right.px": {"column": "X", "unit": "mm"},
        "right.py": {"column": "Y", "unit": "mm", "factor": -1},
        "right.pz": {"column": "Z", "unit": "cm"}}})";

TEST(TraceMapping, NamesUnitsAndSensesAreConverted) {
    const MappedTrace mapped = read_with(parse_trace_mapping(small_mapping, "map.json"),
                                         "Clock;Button;X;Y;Z\n"
                                         "1700000000000;0;10;20;3\n"
                                         "1700000000050;1;11;20;3\n"
                                         "1700000000100;0;12;20;-3\n");
    const Trace& trace = mapped.trace;
    ASSERT_EQ(trace.t.size(), 3U);
    EXPECT_EQ(trace.t[0], 0) << "the clock of the other program begins anywhere";
    EXPECT_NEAR(trace.t[2], 0.1, 1e-12);
    EXPECT_NEAR(trace.hand[1].px[1], 0.011, 1e-15);
    EXPECT_NEAR(trace.hand[1].py[0], -0.020, 1e-15);
    EXPECT_NEAR(trace.hand[1].pz[2], -0.03, 1e-15);
    EXPECT_FALSE(trace.hand[0].has(Channel::position));
    EXPECT_EQ(trace.ignored_columns, std::vector<std::string>{"Button"});
    EXPECT_EQ(mapped.left_out, 0U);
}

TEST(TraceMapping, JigsawsColumnsAreRead) {
    const TraceMapping mapping = load_trace_mapping(test::source_path("assets/mappings/jigsaws.json"));
    // 76 columns; the left tool moves 90 mm along x in 3 s, the right one is at rest.
    std::ostringstream text;
    for (int row = 0; row <= 90; ++row) {
        for (int column = 1; column <= 76; ++column)
            text << "    " << (column == 39 ? 0.001 * row : column == 58 ? 0.25 : 0.5);
        text << "\n";
    }
    const MappedTrace mapped = read_with(mapping, text.str());
    ASSERT_EQ(mapped.trace.t.size(), 91U);
    EXPECT_NEAR(mapped.trace.t.back(), 3.0, 1e-12);
    EXPECT_EQ(mapped.trace.hand[1].px[40], 0.25);
    EXPECT_EQ(mapped.trace.blocks.size(), 1U);
    const nlohmann::json document = metrics_of_trace(mapped.trace, "other.txt", std::nullopt);
    bool found = false;
    for (const nlohmann::json& row : document.at("metrics")) {
        if (row.at("id") == "path_len" && row.at("hand") == "left") {
            found = true;
            EXPECT_NEAR(row.at("value").get<double>(), 90, 0.5);
        }
        // No channel of force, so no value and no zero.
        if (row.at("id") == "f_max") {
            EXPECT_TRUE(row.at("value").is_null());
        }
    }
    EXPECT_TRUE(found);
}

TEST(TraceMapping, RosmaColumnsAreReadAndMissingSamplesAreLeftOut) {
    const TraceMapping mapping = load_trace_mapping(test::source_path("assets/mappings/rosma.json"));
    std::ostringstream text;
    text << "Date,PSM2_position_x,PSM2_position_y,PSM2_position_z,PSM1_position_x,PSM1_position_y,"
            "PSM1_position_z\n";
    for (int row = 0; row < 200; ++row)
        text << "2019-11-05,0.1,0.1,0.1," << (row >= 50 && row < 60 ? "nan" : "0.02") << ",0.03,0.04\n";
    const MappedTrace mapped = read_with(mapping, text.str());
    EXPECT_EQ(mapped.left_out, 10U);
    EXPECT_EQ(mapped.trace.t.size(), 190U);
    EXPECT_EQ(mapped.trace.blocks.size(), 2U) << "nothing is measured across the gap";
    EXPECT_EQ(mapped.trace.hand[0].px.back(), 0.02);
    EXPECT_EQ(mapped.trace.hand[1].px.back(), 0.1);
}

TEST(TraceMapping, EveryDeliveredMappingIsValid) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::source_path("assets/mappings"))) {
        EXPECT_FALSE(load_trace_mapping(entry.path().string()).columns.empty()) << entry.path();
        ++count;
    }
    EXPECT_GE(count, 2);
}

TEST(TraceMapping, WrongMappingsAreRefusedWithPlaceAndHint) {
    const auto with = [](const std::string& rest) { return R"({"title": "x", )" + rest + "}"; };
    const std::string t = R"("t": {"column": 1, "unit": "s"})";
    EXPECT_TRUE(
        says(mapping_problem(with(R"("columns": {"left.foo": {"column": 1, "unit": "m"}}, "rate_hz": 30)")),
             "(/columns/left.foo): is not a column of a trace"));
    EXPECT_TRUE(says(
        mapping_problem(with(R"("columns": {"left.px": {"column": "x", "unit": "inch"}}, "rate_hz": 30)")),
        "where one of m, cm, mm, um is needed"));
    EXPECT_TRUE(says(mapping_problem(with(R"("columns": {"left.px": {"column": "x", "unit": "m"}})")),
                     "there is no time"));
    EXPECT_TRUE(
        says(mapping_problem(with(R"("rate_hz": 30, "columns": {)" + t + "}")), "have a time already"));
    EXPECT_TRUE(says(
        mapping_problem(
            with(R"("header_rows": 0, "rate_hz": 30, "columns": {"left.px": {"column": "x", "unit": "m"}})")),
        "the file has no row of names"));
    EXPECT_TRUE(says(
        mapping_problem(
            with(R"("rate_hz": 30, "columns": {"left.energy": {"column": "e", "unit": "-", "factor": 2}})")),
        "has no meaning for this column"));
    EXPECT_TRUE(says(mapping_problem(with(R"("separator": "dot", "columns": {)" + t + "}")), "/separator"));
    EXPECT_TRUE(says(mapping_problem("{}"), "map.json"));
    EXPECT_EQ(mapping_problem(with(R"("header_rows": 0, "columns": {)" + t + "}")), "");
}

TEST(TraceMapping, FilesThatDoNotFitAreRefusedWithTheirRow) {
    const std::string head = "Clock;X;Y;Z\n";
    EXPECT_TRUE(says(reading_problem(small_mapping, "Clock;X;Y\n1;2;3\n"),
                     "other.txt:1: 'Z': the column is not in the file"));
    EXPECT_TRUE(
        says(reading_problem(small_mapping, head + "0;1;2;3\n5;1;2\n"), "other.txt:3: (row): 3 cells"));
    EXPECT_TRUE(says(reading_problem(small_mapping, head + "0;1;2;3\n0;1;2;3\n"),
                     "other.txt:3: t: the time does not increase"));
    EXPECT_TRUE(says(reading_problem(small_mapping, head + "0;1;2;3\n5;one;2;3\n"),
                     "other.txt:3: right.px: 'one' is not a number"));
    EXPECT_TRUE(says(reading_problem(small_mapping, head + "0;1;2;nan\n"), "is not a finite number"));
    EXPECT_TRUE(says(reading_problem(small_mapping, head + "0;99999;2;3\n"), "is out of range"));
    EXPECT_TRUE(says(reading_problem(small_mapping, head + "0;1;2;3\n9000000;1;2;3\n"), "more than 2 h"));
    EXPECT_TRUE(says(reading_problem(small_mapping, head), "the file has no sample"));
    EXPECT_TRUE(says(reading_problem(small_mapping, ""), "the file ends in its header"));
    EXPECT_THROW(read_mapped_trace("no/such/file.txt", parse_trace_mapping(small_mapping, "map.json")),
                 InputError);
}

}  // namespace
}  // namespace fulcrum
