// SPDX-License-Identifier: Apache-2.0
// The documented trace format: reading, writing, errors.
#include "assessment/trace/trace_csv.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "assessment/trace/utf8.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

Trace read(const std::string& text) {
    std::istringstream in(text);
    return read_trace_csv(in, "trace.csv");
}

/// The error message, or "" if the text was read.
std::string complaint(const std::string& text) {
    try {
        read(text);
    } catch (const InputError& error) {
        return error.what();
    }
    return {};
}

TEST(TraceCsv, ReadsTheChannelsOfTheFile) {
    const Trace trace = read(
        "t,left.px,left.py,left.pz,left.tissue,right.in_view,note\n"
        "s,m,m,m,-,1,-\n"
        "0,0.1,-0.2,3e-2,,1,hello\n"
        "0.001,0.1,-0.2,0.03,bowel,0,\n"
        "0.002,0.1,-0.2,0.03,wall,0,\n"
        "0.003,0.1,-0.2,0.03,bowel,1,\n");
    EXPECT_EQ(trace.t.size(), 4U);
    EXPECT_TRUE(trace.hand[0].has(Channel::position));
    EXPECT_FALSE(trace.hand[1].has(Channel::position));
    EXPECT_EQ(trace.hand[0].pz[0], 0.03);
    EXPECT_EQ(trace.tissues, (std::vector<std::string>{"bowel", "wall"}));
    EXPECT_EQ(trace.hand[0].tissue, (std::vector<std::int16_t>{-1, 0, 1, 0}));
    EXPECT_EQ(trace.hand[1].in_view, (std::vector<std::uint8_t>{1, 0, 0, 1}));
    EXPECT_EQ(trace.ignored_columns, (std::vector<std::string>{"note"}));
    EXPECT_EQ(trace.blocks.size(), 1U);
}

TEST(TraceCsv, AcceptsChangesMadeBySpreadsheets) {
    const Trace trace = read("\xEF\xBB\xBFt,\"left.tissue\"\r\ns,-\r\n0,\"bowel\"\r\n1,\r\n\r\n");
    EXPECT_EQ(trace.t.size(), 2U);
    EXPECT_EQ(trace.hand[0].tissue[0], 0);
}

TEST(TraceCsv, WritesTheValuesThatItReads) {
    std::vector<TickSample> samples(500);
    std::mt19937 random(5);
    std::uniform_int_distribution<int> count(-900000, 900000);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        samples[i].tick = static_cast<std::uint32_t>(i);
        for (HandSample& hand : samples[i].hand) {
            for (auto& x : hand.tip) x = count(random);
            for (auto& x : hand.force) x = count(random) / 1000;
            hand.axis[0] = 60000000, hand.axis[1] = -80000000;
            hand.roll = count(random);
            hand.jaw_force = 1000, hand.jaw_area = 12345;
            hand.tissue = static_cast<std::int16_t>(i % 3) - 1;
            hand.patch = static_cast<std::int16_t>(i % 50);
            hand.flags = static_cast<std::uint16_t>(i % 8 + (i % 4 == 0 ? hand_cutting : 0));
        }
    }
    const Trace trace = trace_from_samples(samples, {}, {"wall", "bowel"});
    std::stringstream text;
    write_trace_csv(trace, text);
    const Trace back = read_trace_csv(text, "trace.csv");
    EXPECT_EQ(back.t, trace.t);
    for (std::size_t h = 0; h < 2; ++h) {
        EXPECT_EQ(back.hand[h].px, trace.hand[h].px);
        EXPECT_EQ(back.hand[h].ay, trace.hand[h].ay);
        EXPECT_EQ(back.hand[h].fz, trace.hand[h].fz);
        EXPECT_EQ(back.hand[h].roll, trace.hand[h].roll);
        EXPECT_EQ(back.hand[h].jaw_area, trace.hand[h].jaw_area);
        EXPECT_EQ(back.hand[h].patch, trace.hand[h].patch);
        EXPECT_EQ(back.hand[h].in_view, trace.hand[h].in_view);
        EXPECT_EQ(back.hand[h].cutting, trace.hand[h].cutting);
        EXPECT_EQ(back.hand[h].cutting[4], 1);
        EXPECT_EQ(back.hand[h].cutting[5], 0);
        for (std::size_t i = 0; i < samples.size(); ++i) {
            const auto label = [&](const Trace& any) {
                const int tissue = any.hand[h].tissue[i];
                return tissue < 0 ? std::string() : any.tissues[static_cast<std::size_t>(tissue)];
            };
            ASSERT_EQ(label(back), label(trace));
        }
    }
    EXPECT_EQ(back.camera.qw, trace.camera.qw);
    std::stringstream again;
    write_trace_csv(back, again);
    EXPECT_EQ(again.str(), text.str());
}

TEST(TraceCsv, NamesTheGapsBetweenSamples) {
    std::stringstream text("t\ns\n0\n0.1\n0.3\n0.4\n2\n2.1\n");
    const Trace trace = read_trace_csv(text, "trace.csv");
    ASSERT_EQ(trace.gaps.size(), 2U);
    EXPECT_EQ(trace.gaps[0].begin, 0.1);
    EXPECT_EQ(trace.gaps[0].end, 0.3);
    EXPECT_EQ(trace.gaps[1].begin, 0.4);
    EXPECT_EQ(trace.blocks.size(), 3U);
}

TEST(TraceCsv, NamesFileRowColumnAndHint) {
    const std::string good = "t,left.fx\ns,N\n";
    EXPECT_EQ(complaint(good + "0,1\n0.001,abc\n"),
              "trace.csv:4: left.fx: 'abc' is not a number; give forces in newtons");
    EXPECT_EQ(complaint(good + "0,1\n0,2\n"),
              "trace.csv:4: t: the time does not increase; sort the rows and remove duplicates");
}

TEST(TraceCsv, RefusesBrokenFiles) {
    const struct {
        const char* text;
        const char* place;
    } cases[] = {
        {"", "trace.csv:1: t:"},
        {"t\n", "trace.csv:2: t:"},
        {"t\ns\n", "trace.csv:3: t:"},
        {"x,left.fx\ns,N\n0,1\n", "trace.csv:1: t:"},        // missing t
        {"t,left.fx\ns,N\n0,1\n-1,1\n", "trace.csv:4: t:"},  // time decreases
        {"t,left.fx\ns,N\n0,1,2\n", "trace.csv:3: (row):"},  // unequal row lengths
        {"t,left.fx\ns,N\n0\n", "trace.csv:3: (row):"},
        {"t,left.fx\ns,N\n0,nan\n", "trace.csv:3: left.fx:"},
        {"t,left.fx\ns,N\n0,inf\n", "trace.csv:3: left.fx:"},
        {"t,left.fx\ns,N\n0,\n", "trace.csv:3: left.fx:"},
        {"t,left.fx\ns,N\n0,1e999\n", "trace.csv:3: left.fx:"},
        {"t,left.fx\ns,N\n0,1 2\n", "trace.csv:3: left.fx:"},
        {"t,left.px\ns,mm\n0,120\n", "trace.csv:2: left.px:"},  // wrong unit
        {"t,left.px\ns,m\n0,120\n", "trace.csv:3: left.px:"},   // values in millimetres
        {"t,left.px\n0,0.1\n", "trace.csv:2: t:"},              // no row of units
        {"t,left.fx,left.fx\ns,N,N\n0,1,1\n", "trace.csv:1: 'left.fx':"},
        {"t,left.in_view\ns,-\n0,2\n", "trace.csv:3: left.in_view:"},
        {"t,left.in_view\ns,-\n0,0.5\n", "trace.csv:3: left.in_view:"},
        {"t,left.ax,left.ay,left.az\ns,-,-,-\n0,0.5,0,0\n", "trace.csv:3: left.ax:"},
        {"t,left.tissue\ns,-\n0,\xFF\n", "trace.csv:3: left.tissue:"},
        {"t,left.fx\ns,N\n0,1\n\n0.1,1\n", "trace.csv:5: (row):"},  // a blank line inside
        {"t\ns\n8000\n", "trace.csv:3: t:"},                        // beyond two hours
    };
    for (const auto& broken : cases) {
        const std::string message = complaint(broken.text);
        EXPECT_EQ(message.substr(0, std::string(broken.place).size()), broken.place) << broken.text << "\n"
                                                                                     << message;
        EXPECT_NE(message.find("; "), std::string::npos) << message;
    }
}

TEST(TraceCsv, EnforcesItsLimits) {
    EXPECT_NE(complaint("t," + std::string(70000, 'x') + "\n"), "");
    std::string many = "t";
    for (int i = 0; i < 300; ++i) many += ",c" + std::to_string(i);
    EXPECT_NE(complaint(many + "\n"), "");
    std::string labels = "t,left.tissue\ns,-\n";
    for (int i = 0; i < 130; ++i) labels += std::to_string(i) + ",label" + std::to_string(i) + "\n";
    EXPECT_NE(complaint(labels).find("different labels"), std::string::npos);
    EXPECT_NE(complaint("t,left.tissue\ns,-\n0," + std::string(65, 'a') + "\n"), "");
    EXPECT_THROW(read_trace_csv(std::string("no/such/file.csv")), InputError);
}

TEST(Utf8, AcceptsOnlyWellFormedText) {
    EXPECT_TRUE(is_utf8("bowel"));
    EXPECT_TRUE(is_utf8("Gefäß"));
    EXPECT_TRUE(is_utf8("\xF0\x9F\x98\x80"));
    EXPECT_FALSE(is_utf8("\xC0\x80"));          // overlong
    EXPECT_FALSE(is_utf8("\xED\xA0\x80"));      // surrogate
    EXPECT_FALSE(is_utf8("\xF5\x80\x80\x80"));  // beyond Unicode
    EXPECT_FALSE(is_utf8("\xE2\x82"));          // cut short
    EXPECT_FALSE(is_utf8("\x80"));
    EXPECT_FALSE(is_utf8("a\tb"));
}

}  // namespace
}  // namespace fulcrum
