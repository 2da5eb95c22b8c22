// SPDX-License-Identifier: Apache-2.0
// Charts and pages: well-formed, the same bytes for the same data, nothing outside the plot, values that
// cannot be drawn skipped.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "sim_core/lab/chart.h"
#include "sim_core/lab/result_page.h"
#include "sim_core/lab/stability.h"
#include "sim_core/lab/svg.h"
#include "sim_core/lab/tradeoff.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/own_folder.h"

namespace fulcrum::lab {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

TEST(ShortNumber, RoundsToSignificantDigits) {
    EXPECT_EQ(short_number(0), "0");
    EXPECT_EQ(short_number(1), "1");
    EXPECT_EQ(short_number(-1.2345), "-1.23");
    EXPECT_EQ(short_number(999.9), "1000");
    EXPECT_EQ(short_number(123456), "123000");
    EXPECT_EQ(short_number(1234567), "1.23e06");
    EXPECT_EQ(short_number(0.00123), "0.00123");
    EXPECT_EQ(short_number(1.2e-7), "1.2e-07");
    EXPECT_EQ(short_number(0.5, 8), "0.5");
    EXPECT_EQ(short_number(std::nan("")), "nan");
}

TEST(Pixel, KeepsTwoDecimals) {
    EXPECT_EQ(pixel(1), "1");
    EXPECT_EQ(pixel(1.5), "1.5");
    EXPECT_EQ(pixel(1.054), "1.05");
    EXPECT_EQ(pixel(-0.25), "-0.25");
}

Chart example() {
    Chart chart;
    chart.title = "a < b & \"c\"";
    chart.x_logarithmic = chart.y_logarithmic = true;
    const double infinity = std::numeric_limits<double>::infinity();
    chart.series.push_back({"first",
                            {1, 10, 100, -1, 1000},
                            {1e-3, 1e-4, infinity, 1e-5, 1e-6},
                            true,
                            true,
                            false,
                            {true, false, true, true, true}});
    return chart;
}

TEST(Chart, RepeatsAndSkipsValuesThatCannotBeDrawn) {
    const std::string svg = svg_chart(example());
    EXPECT_EQ(svg, svg_chart(example()));
    EXPECT_NE(svg.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
    EXPECT_EQ(svg.find("inf"), std::string::npos);
    // Three points can be drawn: a legend marker each, rings for the two that are marked.
    EXPECT_EQ(count(svg, "<circle"), 3u + 1u + 2u);
    EXPECT_EQ(svg.substr(svg.size() - 7), "</svg>\n");
}

TEST(Chart, EmptyChartIsValid) {
    EXPECT_NE(svg_chart(Chart{}).find("</svg>"), std::string::npos);
    EXPECT_NE(svg_bars(BarChart{}).find("</svg>"), std::string::npos);
    EXPECT_NE(svg_map(CategoryMap{}).find("</svg>"), std::string::npos);
}

TEST(Map, ClipsACurveAtTheBorder) {
    CategoryMap map;
    map.x = map.y = {1, 10, 100};
    map.categories = {"stable", "degraded", "fault"};
    MapPanel panel;
    for (const double x : map.x) {
        for (const double y : map.y) panel.cells.push_back({x, y, x * y > 100 ? 2 : 0});
    }
    panel.curves.push_back({"bound", {1e-3, 1e5}, {1e5, 1e-3}, true, false, false, {}});
    map.panels.push_back(panel);
    const std::string svg = svg_map(map);
    const std::size_t at = svg.find("<polyline points=\"");
    ASSERT_NE(at, std::string::npos);
    double x = 0, y = 0;
    char comma = 0;
    std::istringstream points(svg.substr(at + 18));
    int seen = 0;
    while (points >> x >> comma >> y) {
        ++seen;
        EXPECT_GE(x, 85);
        EXPECT_LE(x, 427);
        EXPECT_GE(y, 65);
        EXPECT_LE(y, 407);
    }
    EXPECT_EQ(seen, 2);
}

TEST(Pareto, MarksUndominatedLevels) {
    TradeoffStudy study;
    study.levels = {{"a", "f", 1.0, "m", 10, false},
                    {"b", "f", 0.5, "m", 20, false},
                    {"c", "f", 0.6, "m", 30, false},
                    {"d", "f", 9, "rad", 99, false}};
    mark_pareto(study);
    EXPECT_TRUE(study.levels[0].pareto);
    EXPECT_TRUE(study.levels[1].pareto);
    EXPECT_FALSE(study.levels[2].pareto);
    EXPECT_TRUE(study.levels[3].pareto) << "compared within its own unit";
}

class Page : public ::testing::Test {
  protected:
    std::string read(const char* name) const {
        std::ifstream in(folder / name);
        return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    }
    test::OwnFolder own;
    const std::filesystem::path folder = own / "results";
    Machine machine{"Some processor", 2, {"GNU 12", "-O3", "abc123, with uncommitted changes"}};
};

TEST_F(Page, ContainsMachineCommitAndCommand) {
    ResultPage page("some", "Some page", "fulcrum lab some");
    page.table({"cells", {"a", "b"}, {{"1,5", "x|y"}}});
    page.chart("drawing", "a drawing", "<svg/>");
    page.document({{"value", 3}});
    EXPECT_EQ(page.write(folder.string(), machine).size(), 4u);
    const std::string text = read("some.md");
    for (const char* part : {"abc123, with uncommitted changes", "Some processor, 2 cores",
                             "`fulcrum lab some`", "x\\|y", "![a drawing](drawing.svg)"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    EXPECT_EQ(read("cells.csv"), "a,b\n\"1,5\",x|y\n");
    const auto json = nlohmann::json::parse(read("some.json"));
    EXPECT_EQ(json["value"], 3);
    EXPECT_EQ(json["machine"]["commit"], machine.build.commit);
}

TEST_F(Page, RefusesAFolderThatCannotBeCreated) {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "file") << "x";
    EXPECT_THROW(ResultPage("a", "b", "c").write((folder / "file").string(), machine), InputError);
}

TEST(StabilityJson, CountsNonFiniteCells) {
    StabilityMap map;
    map.model = "m";
    map.axes = {{"time_step_s", "s", {0.1, 0.2}, true}, {"stiffness_n_m", "N/m", {1}, true}};
    map.cells = {{{0.1, 1}, StabilityOutcome::stable, true, 0},
                 {{0.2, 1}, StabilityOutcome::fault, false, 0}};
    const auto json = to_json(std::vector<StabilityMap>{map});
    EXPECT_EQ(json["non_finite"], 1);
    EXPECT_EQ(json["maps"][0]["cells"][1]["outcome"], "fault");
    EXPECT_EQ(json["maps"][0]["cells"][1]["time_step_s"], 0.2);
}

}  // namespace
}  // namespace fulcrum::lab
