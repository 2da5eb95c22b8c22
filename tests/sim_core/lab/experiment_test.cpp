// SPDX-License-Identifier: Apache-2.0
// The experiments of Pan et al. 2011 as `fulcrum lab experiment` runs them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>

#include "sim_core/lab/experiment.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/own_folder.h"
#include "tests/support/support.h"

namespace fulcrum::lab {
namespace {

ExperimentResult run(const char* name) {
    return run_experiment(test::source_path(std::string("assets/experiments/") + name + ".json"));
}

double figure(const ExperimentResult& result, const std::string& name) {
    for (const ExperimentFigure& f : result.figures) {
        if (f.name == name) return f.value;
    }
    ADD_FAILURE() << "no figure \"" << name << "\"";
    return std::nan("");
}

// Figs. 3 and 5: a spike and two dents, broader and shallower, pushed and pulled by the same force.
TEST(Experiment, FilterGradesAreASpikeAndTwoDents) {
    const ExperimentResult result = run("fig03_05_filter");
    ASSERT_EQ(result.panels.size(), 6u);
    for (const std::string direction : {"pushed", "pulled"}) {
        double deeper = 1e9, fewer = 0;
        for (const std::string grade : {"0", "1", "2"}) {
            const double reached =
                figure(result, direction + ", grade " + grade + ": vertices that the force reaches");
            const double depth = figure(result, direction + ", grade " + grade + ": largest displacement");
            EXPECT_GT(reached, fewer);
            EXPECT_LT(depth, deeper);
            fewer = reached;
            deeper = depth;
        }
        EXPECT_EQ(fewer, 19);
    }
    EXPECT_EQ(figure(result, "pulled, grade 0: vertices that the force reaches"), 1);
}

TEST(Experiment, LawsDivergeWhereTheClosedFormPredicts) {
    const ExperimentResult result = run("fig07_laws");
    EXPECT_LT(figure(result, "stress of the two laws apart at 22 % strain"), 10);
    EXPECT_NEAR(figure(result, "strain from which they are 20 % apart"), 29.2, 0.1);
    // The rods, not only the formulas: 10 % of stretch in each direction, then diverging.
    EXPECT_NEAR(result.figures[2].value / result.figures[3].value, 1, 0.05);
    EXPECT_GT(result.figures[6].value / result.figures[7].value, 1.3);
}

// Figs. 13 and 15: children in place of parents, area accounted for, and a bent bowel that is open along the
// cut.
TEST(Experiment, CutsSubdivideTrianglesAndConserveArea) {
    for (const char* name : {"fig13_subdivision", "fig15_cut_bowel"}) {
        const ExperimentResult result = run(name);
        ASSERT_EQ(result.panels.size(), 4u) << name;
        EXPECT_GT(figure(result, "triangles after"), figure(result, "triangles before")) << name;
        EXPECT_LT(figure(result, "before less after and removed, share of before"), 1e-9) << name;
        EXPECT_GT(figure(result, "area removed"), 0) << name;
        EXPECT_EQ(figure(result, "steps rolled back"), 0) << name;
    }
    // Edges with only one triangle: none on the closed tube, a loop around the cut.
    const ExperimentResult bowel = run("fig15_cut_bowel");
    const auto rim = [](const TriangleMesh& mesh) {
        std::map<std::pair<std::int32_t, std::int32_t>, int> uses;
        for (const Triangle& t : mesh.triangles) {
            for (std::size_t c = 0; c < 3; ++c) ++uses[std::minmax({t[c], t[(c + 1) % 3]})];
        }
        return std::count_if(uses.begin(), uses.end(), [](const auto& use) { return use.second == 1; });
    };
    const auto before = rim(bowel.panels[0].meshes[0].mesh), after = rim(bowel.panels[2].meshes[0].mesh);
    EXPECT_GT(after, before + 100);
}

TEST(Experiment, BendConservesTheVolume) {
    EXPECT_LT(std::fabs(figure(run("fig08d_bend"), "volume change of the surface")), 2);
}

TEST(Experiment, IntestineFallsToTheGroundAndOntoItself) {
    const ExperimentResult result = run("fig14_fall");
    EXPECT_EQ(result.panels.size(), 12u);
    EXPECT_EQ(result.panels.back().title, "frame 44");
    EXPECT_LT(figure(result, "deepest overlap of two spheres at the end of a frame"), 1.5e-3);
    EXPECT_LT(figure(result, "deepest overlap with the ground at the end of a frame"), 1.5e-3);
    EXPECT_GT(figure(result, "most pairs in contact at once"), 0);
    EXPECT_LT(figure(result, "fastest point in the last frame"), 0.1);
    double lowest = 1, highest = -1;
    for (const Vector3& v : result.panels.back().meshes.back().mesh.vertices) {
        lowest = std::min(lowest, v.z());
        highest = std::max(highest, v.z());
    }
    EXPECT_GT(lowest, -0.003);
    EXPECT_LT(highest, 0.08) << "everything lies";
}

TEST(Experiment, ReportsWhatIsWrongWithAFile) {
    const test::OwnFolder folder;
    const auto path = folder / "experiment.json";
    const auto complaint = [&](const std::string& text) -> std::string {
        std::ofstream(path) << text;
        try {
            run_experiment(path.string());
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(complaint(R"({"id": "a", "figure": "b", "caption": "c", "kind": "dance"})")
                  .find("use one of: filter, laws, bend, fall"),
              std::string::npos);
    EXPECT_NE(complaint(R"({"id": "../a", "figure": "b", "caption": "c", "kind": "bend"})").find("/id"),
              std::string::npos);
    EXPECT_NE(complaint(R"({"id": "a", "figure": "b", "caption": "c", "kind": "bend", "bend_deg": 1000})")
                  .find("bend_deg"),
              std::string::npos);
}

}  // namespace
}  // namespace fulcrum::lab
