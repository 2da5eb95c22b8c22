// SPDX-License-Identifier: Apache-2.0
// Traces of other programs: the delivered mappings, units, missing values, and every error with its place.
#include "assessment/trace/trace_mapping.h"

#include <gtest/gtest.h>

#include <cmath>
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

// -- Recordings of poses

std::string pose(const std::string& device, double seconds, double x, double y, double z) {
    const auto whole = static_cast<long>(std::floor(seconds));
    std::ostringstream text;
    text << "  <log TimeStampSec=\"" << whole << "\" TimeStampNSec=\""
         << std::lround(1e9 * (seconds - static_cast<double>(whole))) << "\" type=\"transform\" DeviceName=\""
         << device << "\" transform=\"1 0 0 " << x << " 0 1 0 " << y << " 0 0 1 " << z << " 0 0 0 1 \" />\n";
    return text.str();
}
std::string recording(const std::string& logs) {
    return "<TransformRecorderLog>\n" + logs + "</TransformRecorderLog>\n";
}

TEST(TransformRecording, PosesOfTheDeliveredMappingAreRead) {
    const TraceMapping mapping = load_trace_mapping(test::source_path("assets/mappings/perktutor.json"));
    // The recorder writes one device after the other, and does not sort: the stylus moves 90 mm to the left
    // in 3 s at 30 Hz; the probe was recorded twice as often, 1 ms later.
    std::string stylus, probe;
    for (int i = 0; i <= 90; ++i) stylus += pose("StylusTipToRAS", 1700000000 + i / 30.0, -i, 20, 30);
    for (int i = -2; i <= 184; ++i) probe += pose("ProbeToRAS", 1700000000.001 + i / 60.0, 0.5 * i, 0, 0);
    const MappedTrace mapped = read_with(
        mapping,
        recording("  <log TimeStampSec=\"0\" TimeStampNSec=\"5\" type=\"message\" message=\"a < b\" />\n" +
                  probe + stylus + pose("Needle &amp; syringe", 3, 0, 0, 0)));
    const Trace& trace = mapped.trace;
    ASSERT_EQ(trace.t.size(), 91U);
    EXPECT_EQ(mapped.left_out, 0U);
    EXPECT_NEAR(trace.t.back(), 3.0, 1e-9);
    EXPECT_NEAR(trace.hand[1].px[90], 0.090, 1e-12) << "the patient's left, in metres";
    EXPECT_NEAR(trace.hand[1].py[0], 0.030, 1e-12) << "superior";
    EXPECT_NEAR(trace.hand[1].pz[0], 0.020, 1e-12) << "anterior";
    // Between two poses of the probe: 1 ms before that of this time.
    EXPECT_NEAR(trace.hand[0].px[60], -0.001 * (60 - 0.03), 1e-8);
    EXPECT_EQ(trace.blocks.size(), 1U);
    EXPECT_EQ(trace.ignored_columns, std::vector<std::string>{"Needle & syringe"});
}

constexpr const char* tip_mapping = R"({"title": "Perk", "format": "transforms", "columns": {
    "right.px": {"column": "Tip.x", "unit": "mm"}, "right.py": {"column": "Tip.y", "unit": "mm"},
    "right.pz": {"column": "Tip.z", "unit": "mm"}, "right.ax": {"column": "Tip.z_axis.x", "unit": "-"},
    "right.ay": {"column": "Tip.z_axis.y", "unit": "-"}, "right.az": {"column": "Tip.z_axis.z", "unit": "-"}}})";

TEST(TransformRecording, AxesOrderAndRepeatedTimesAreRead) {
    const MappedTrace mapped =
        read_with(parse_trace_mapping(tip_mapping, "map.json"),
                  "<?xml version='1.0'?><!-- by hand > -->\n" +
                      recording(pose("Tip", 2, 3, 0, 0) + pose("Tip", 1, 1, 0, 0) + pose("Tip", 1, 2, 0, 0)));
    ASSERT_EQ(mapped.trace.t.size(), 2U);
    EXPECT_NEAR(mapped.trace.hand[1].px[0], 0.002, 1e-12) << "the later of two at one time";
    EXPECT_NEAR(mapped.trace.hand[1].px[1], 0.003, 1e-12);
    EXPECT_EQ(mapped.trace.hand[1].az[0], 1);
    EXPECT_EQ(mapped.trace.hand[1].ax[0], 0);
    EXPECT_EQ(mapped.trace.blocks.size(), 2U) << "1 s without a pose";
}

TEST(TransformRecording, NothingIsMadeUpWhereADeviceHasNoPose) {
    const std::string both = R"({"title": "Perk", "format": "transforms", "columns": {
        "left.px": {"column": "A.x", "unit": "mm"}, "right.px": {"column": "B.x", "unit": "mm"}}})";
    std::string logs;
    for (int i = 0; i < 100; ++i) logs += pose("A", 0.05 * i, i, 0, 0);
    for (int i = 0; i < 80; ++i)
        if (i < 20 || i >= 40) logs += pose("B", 0.05 * i + 1.01, i, 0, 0);
    const MappedTrace mapped = read_with(parse_trace_mapping(both, "map.json"), recording(logs));
    EXPECT_EQ(mapped.trace.t.size(), 59U) << "B has 60 poses; its last one is after A's last";
    EXPECT_EQ(mapped.left_out, 1U);
    EXPECT_EQ(mapped.trace.blocks.size(), 2U);
}

TEST(TransformRecording, FilesThatAreNotOneAreRefusedWithTheirLine) {
    const auto problem = [](const std::string& text) { return reading_problem(tip_mapping, text); };
    const std::string good = pose("Tip", 1, 1, 0, 0);
    EXPECT_EQ(problem(recording(good)), "");
    EXPECT_TRUE(says(problem("t,x\n0,1\n"), "does not begin with <TransformRecorderLog>"));
    EXPECT_TRUE(says(problem(""), "does not begin with"));
    EXPECT_TRUE(says(problem("<html></html>"), "does not begin with"));
    EXPECT_TRUE(says(problem("<TransformRecorderLog>\n" + good), "cut off"));
    EXPECT_TRUE(says(problem("<TransformRecorderLog>\n" + good + "  <log TimeStampSec=\"1"),
                     "other.txt:3: the file ends within an element"));
    EXPECT_TRUE(says(problem(recording(pose("Other", 1, 0, 0, 0) + pose("Third", 1, 0, 0, 0))),
                     "no pose of the device Tip; name one of these in the mapping: Other, Third"));
    const auto with = [&](const char* from, const char* to) {
        std::string text = good;
        text.replace(text.find(from), std::string(from).size(), to);
        return problem(recording(good + text));
    };
    EXPECT_TRUE(says(with("1 0 0 1", "1 0 0 x"), "other.txt:3: transform is not a number: \"x\""));
    EXPECT_TRUE(says(with("1 0 0 1", "1 0 0 nan"), "is not a number"));
    EXPECT_TRUE(says(with("1 0 0 1", "1 0 0"), "(numbers: 15)"));
    EXPECT_TRUE(says(with("0 0 0 1 ", "0 0 0 2"), "0 0 0 1"));
    EXPECT_TRUE(says(with("TimeStampNSec", "Nanoseconds"), "<log> has no attribute TimeStampNSec"));
    EXPECT_TRUE(says(with("TimeStampSec=\"1\"", "TimeStampSec=\"later\""), "TimeStampSec is not a number"));
    EXPECT_TRUE(says(with("TimeStampSec=\"1\"", "TimeStampSec=\"99999999999\""), "the time is out of range"));
    EXPECT_TRUE(says(with("TimeStampSec=\"1\"", "TimeStampSec=1"), "cannot be read"));
    EXPECT_TRUE(says(with("DeviceName=\"Tip\"", "DeviceName=\"\""), "DeviceName is empty"));
    EXPECT_TRUE(says(with("1 0 0 1", "1 0 0 1e9"), "right.px: '1e+09' is out of range"));
}

TEST(TransformRecording, MappingsThatMakeNoSenseAreRefused) {
    const auto with = [](const std::string& rest, const std::string& column) {
        return mapping_problem(R"({"title": "x", "format": "transforms", )" + rest + R"("columns": {)" +
                               column + "}}");
    };
    const std::string tip = R"("left.px": {"column": "Tip.x", "unit": "mm"})";
    EXPECT_EQ(with("", tip), "");
    EXPECT_TRUE(says(with("\"rate_hz\": 30, ", tip), "(/rate_hz): has no meaning for a recording of poses"));
    EXPECT_TRUE(says(with("\"missing\": [\"\"], ", tip), "/missing"));
    EXPECT_TRUE(says(with("", R"("t": {"column": "Tip.x", "unit": "s"})"), "have a time already"));
    for (const char* column : {"4", "\"Tip\"", "\".x\"", "\"Tip.w\""})
        EXPECT_TRUE(says(with("", std::string(R"("left.px": {"unit": "mm", "column": )") + column + "}"),
                         "does not name a device and an entry"))
            << column;
}

TEST(TraceMapping, EveryDeliveredMappingIsValid) {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(test::source_path("assets/mappings"))) {
        EXPECT_FALSE(load_trace_mapping(entry.path().string()).columns.empty()) << entry.path();
        ++count;
    }
    EXPECT_GE(count, 3);
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
