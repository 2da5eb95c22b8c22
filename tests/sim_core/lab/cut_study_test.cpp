// SPDX-License-Identifier: Apache-2.0
// `lab run` with model "cut" (docs/FORMATS.md): strokes of any kind, areas that add up, errors.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sim_core/geometry/mesh_file.h"
#include "sim_core/lab/cut_study.h"
#include "sim_core/lab/studies.h"
#include "sim_core/numerics/input_error.h"
#include "tests/sim_core/cutting/surfaces.h"
#include "tests/support/own_folder.h"

namespace fulcrum {
namespace {

using Json = nlohmann::json;

class CutStudy : public ::testing::Test {
  protected:
    void SetUp() override {
        write("sheet.obj", test::cut_sheet(10, 10, 0.01));
        write("tube.obj", test::make_tube(0.1, 20, 16, test::plain_radius(0.015)));
    }
    void write(const std::string& name, const TriangleMesh& mesh) const {
        std::ofstream out(folder_ / name);
        write_obj(out, mesh);
    }
    Json run_text(const std::string& text) const {
        std::ofstream(folder_ / "study.json") << text;
        return lab::run_study((folder_ / "study.json").string());
    }
    Json run(const Json& change) const {
        Json keys = {{"model", "cut"}, {"mesh", "sheet.obj"}, {"width_m", 0.001}};
        keys.update(change);
        return run_text(keys.dump());
    }
    static Json ring(double x, double y, double radius, int corners) {
        Json path = Json::array();
        for (int i = 0; i <= corners; ++i) {
            const double a = 6.283185307179586 * (i % corners) / corners;
            path.push_back({x + radius * std::cos(a), y + radius * std::sin(a), 0});
        }
        return path;
    }
    static void expect_whole(const Json& result) {
        const double before = result["area_before_m2"], after = result["area_after_m2"],
                     removed = result["area_removed_m2"];
        EXPECT_NEAR(before, after + removed, 1e-9 * before);
        EXPECT_TRUE(result["violation"].is_null()) << result["violation"];
        EXPECT_EQ(result["uncut_steps"], 0);
        // No triangle without area, by the numbers printed alone.
        for (const Json& t : result["visible_triangles"]) {
            Vector3 p[3];
            for (std::size_t i = 0; i < 3; ++i) {
                const Json& v = result["vertices"][t[i].get<std::size_t>()];
                p[i] = Vector3(v[0].get<double>(), v[1].get<double>(), v[2].get<double>());
            }
            EXPECT_GT(triangle_area(p[0], p[1], p[2]), 1e-15);
        }
    }
    test::OwnFolder folder_;
};

TEST_F(CutStudy, ResultHasTheDocumentedFormat) {
    const Json result = run({{"strokes", {{{0.021, 0.033, 0}, {0.071, 0.052, 0}}}}});
    for (const char* key :
         {"visible_triangles", "vertices", "area_before_m2", "area_after_m2", "area_removed_m2", "pieces",
          "dropped_pieces", "cases", "min_angle_deg", "time_us_per_step"})
        EXPECT_TRUE(result.contains(key)) << key;
    EXPECT_EQ(result["cases"].size(), 10U);
    expect_whole(result);
    const double length = std::hypot(0.05, 0.019);
    EXPECT_NEAR(result["area_removed_m2"].get<double>(), 0.001 * length, 0.002 * 0.001 * length);
    EXPECT_EQ(result["time_us_per_step"].size(), static_cast<std::size_t>(std::ceil(length / 0.002)));
    EXPECT_GT(result["min_angle_deg"].get<double>(), 0);
    EXPECT_EQ(result["pieces"], 1);
}

TEST_F(CutStudy, CircleFallsAndSpiralStays) {
    const Json fixed = {0, 10, 110, 120};
    const Json circle = run({{"strokes", {ring(0.05, 0.05, 0.025, 24)}}, {"fixed", fixed}});
    expect_whole(circle);
    EXPECT_EQ(circle["dropped_pieces"], 1);
    EXPECT_EQ(circle["pieces"], 1);
    const double inner = 0.5 * 24 * std::sin(6.283185307179586 / 24) * 0.025 * 0.025;
    EXPECT_NEAR(circle["area_removed_m2"].get<double>(), inner, 0.05 * inner);

    Json spiral = Json::array();
    for (int i = 0; i <= 60; ++i) {
        const double a = 0.25 * i, r = 0.04 - 0.0005 * i;
        spiral.push_back({0.05 + r * std::cos(a), 0.05 + r * std::sin(a), 0});
    }
    const Json wound = run({{"strokes", Json::array({spiral})}, {"fixed", fixed}});
    expect_whole(wound);
    EXPECT_EQ(wound["dropped_pieces"], 0);
    EXPECT_EQ(wound["pieces"], 1);
}

TEST_F(CutStudy, FromBorderToBorderAndBeyondMakesTwoPieces) {
    for (const double over : {0.0, 0.02}) {
        const Json result = run({{"strokes", {{{-over, 0.031, 0}, {0.1 + over, 0.064, 0}}}}});
        expect_whole(result);
        EXPECT_EQ(result["pieces"], 2);
        EXPECT_EQ(result["dropped_pieces"], 0);  // without a held vertex no piece can be identified as loose
    }
}

TEST_F(CutStudy, SecondCutAcrossTheFirstJoinsIt) {
    const Json one = {{0.02, 0.05, 0}, {0.08, 0.05, 0}}, two = {{0.053, 0.02, 0}, {0.047, 0.08, 0}};
    const Json result = run({{"strokes", {one, two}}});
    expect_whole(result);
    EXPECT_EQ(result["pieces"], 1);
    const double each = 0.001 * 0.06, other = 0.001 * std::hypot(0.006, 0.06);
    EXPECT_NEAR(result["area_removed_m2"].get<double>(), each + other - 1e-6, 2e-7);
    // Four quarters: a second pair of cuts along the border of a square separates them.
    const Json across =
        run({{"strokes", {{{-0.01, 0.05, 0}, {0.11, 0.05, 0}}, {{0.0533, -0.01, 0}, {0.0467, 0.11, 0}}}}});
    expect_whole(across);
    EXPECT_EQ(across["pieces"], 4);
}

TEST_F(CutStudy, CutsAlongEdgesAndThroughVerticesLeaveNoEmptyTriangle) {
    const Json strokes[] = {
        {{{0.02, 0.05, 0}, {0.08, 0.05, 0}}},      // along edges, ends in vertices
        {{{0.02, 0.0505, 0}, {0.08, 0.0505, 0}}},  // a border on the edges
        {{{0.02, 0.02, 0}, {0.08, 0.08, 0}}},      // along diagonals and through vertices
        {{{0.0, 0.0, 0}, {0.1, 0.1, 0}}},          // from corner to corner
        {{{0.0, 0.05, 0}, {0.0, 0.08, 0}}},        // along the rim
        {{{0.05, 0.05, 0}, {0.07, 0.05, 0}, {0.05, 0.05, 0}, {0.03, 0.05, 0}, {0.07, 0.05, 0}}},  // back and
                                                                                                  // forth
    };
    for (const Json& stroke : strokes) {
        SCOPED_TRACE(stroke.dump());
        const Json result = run({{"strokes", stroke}});
        expect_whole(result);
        EXPECT_GT(result["area_removed_m2"].get<double>(), 0);
    }
}

TEST_F(CutStudy, StrokeWithoutLengthCutsNothing) {
    const Json result =
        run({{"strokes", {{{0.05, 0.05, 0}, {0.05, 0.05, 0}}, Json::array({{0.02, 0.02, 0}})}}});
    expect_whole(result);
    EXPECT_EQ(result["area_removed_m2"], 0);
    EXPECT_EQ(result["visible_triangles"].size(), 200U);
}

TEST_F(CutStudy, FollowsACurvedSurface) {
    // Straight through the tube's middle height: the near wall alone is cut, from cap to cap.
    const Json result = run({{"mesh", "tube.obj"}, {"strokes", {{{0.01, 0.0, 0.02}, {0.09, 0.0, 0.02}}}}});
    expect_whole(result);
    EXPECT_NEAR(result["area_removed_m2"].get<double>(), 0.001 * 0.08, 0.02 * 0.001 * 0.08);
    EXPECT_EQ(result["pieces"], 1);
}

TEST_F(CutStudy, EverythingCanBeCutAway) {
    Json strokes = Json::array();
    for (int i = 0; i <= 10; ++i) strokes.push_back({{-0.02, 0.01 * i, 0}, {0.12, 0.01 * i, 0}});
    const Json result = run({{"strokes", strokes}, {"width_m", 0.012}});
    EXPECT_TRUE(result["violation"].is_null());
    EXPECT_NEAR(result["area_removed_m2"].get<double>(), 0.01, 1e-11);
    EXPECT_EQ(result["visible_triangles"].size(), 0U);
    EXPECT_EQ(result["pieces"], 0);
    EXPECT_TRUE(result["min_angle_deg"].is_null());
}

TEST_F(CutStudy, RefusesBadInputWithFilePlaceAndHint) {
    const std::string start = R"({"model": "cut", "mesh": "sheet.obj", "width_m": 0.001, "strokes": )";
    const struct {
        std::string text;
        const char* place;
    } cases[] = {
        {start + "[[[0, 0, NaN]]]}", ""},
        {start + "[[[0, 0, null], [1, 0, 0]]]}", "/strokes/0/0"},
        {start + "[[[0, 0, 1e300], [1, 0, 0]]]}", "/strokes/0/0"},
        {start + "[[[0, 0], [1, 0]]]}", "/strokes/0/0"},
        {start + "[[]]}", "/strokes/0"},
        {start + "7}", "/strokes"},
        {start + "[], \"fixed\": [121]}", "/fixed/0"},
        {start + "[], \"ends\": \"blunt\"}", "/ends"},
        {R"({"model": "cut", "mesh": "sheet.obj", "width_m": 0.001})", "strokes"},
        {R"({"model": "cut", "mesh": "sheet.obj", "width_m": 0, "strokes": []})", "/width_m"},
        {R"({"model": "cut", "mesh": "none.obj", "width_m": 0.001, "strokes": []})", "none.obj"},
    };
    for (const auto& bad : cases) {
        try {
            run_text(bad.text);
            ADD_FAILURE() << bad.text;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(bad.place), std::string::npos) << error.what();
            EXPECT_FALSE(error.hint().empty());
        }
    }
    TriangleMesh book = test::cut_sheet(1, 1, 0.01);
    book.vertices.emplace_back(0.0, 0.0, 0.01);
    book.triangles.push_back({book.triangles[0][0], book.triangles[0][2], 4});
    write("book.obj", book);
    EXPECT_THROW(run({{"mesh", "book.obj"}, {"strokes", Json::array()}}), InputError);
}

}  // namespace
}  // namespace fulcrum
