// SPDX-License-Identifier: Apache-2.0
// Fig. 12: each of the ten cases by the example that the page shows, and the page itself.
#include <gtest/gtest.h>

#include "sim_core/lab/cut_figures.h"
#include "tests/sim_core/cutting/surfaces.h"
#include "tests/support/own_folder.h"

namespace fulcrum {
namespace {

TEST(CutCases, EachExampleGivesItsCase) {
    const auto examples = lab::cut_examples();
    ASSERT_EQ(examples.size(), 10U);
    for (std::size_t i = 0; i < examples.size(); ++i) {
        SCOPED_TRACE(examples[i].letter);
        EXPECT_EQ(examples[i].letter, static_cast<char>('a' + i));
        lab::RestBlade::Tally tally;
        const lab::RestBlade blade = lab::run_example(examples[i], tally);
        for (std::size_t c = 0; c < 10; ++c)
            EXPECT_EQ(tally.cases.count[c], c == i ? 1 : 0) << "12" << char('a' + c);
        const CutCheck check = check_cut(blade.mesh(), nullptr);
        EXPECT_TRUE(check.passed()) << check.complaint();
        EXPECT_EQ(tally.roll_backs, 0);
        EXPECT_EQ(blade.mesh().visible_count() == 0, examples[i].letter == 'j');
        // The hierarchy: the triangle is kept, hidden, and its children are drawn.
        EXPECT_FALSE(blade.mesh().visible(0));
        for (std::int32_t t = 1; t < blade.mesh().triangle_count(); ++t) {
            if (!blade.mesh().visible(t)) continue;
            std::int32_t top = t;
            while (blade.mesh().triangle(top).parent >= 0) top = blade.mesh().triangle(top).parent;
            EXPECT_EQ(top, 0);
        }
    }
}

TEST(CutCases, ReversingTriangleOrBladeKeepsTheCase) {
    for (const lab::CutExample& example : lab::cut_examples())
        for (int turn = 0; turn < 3; ++turn) {
            TriangleMesh mesh = lab::figure_triangle();
            std::rotate(mesh.triangles[0].begin(), mesh.triangles[0].begin() + turn, mesh.triangles[0].end());
            lab::RestBlade blade(mesh, {}, CutMesh::capacity_for(mesh, 64));
            lab::RestBlade::Tally tally;
            // Start and end have the same name; left and right are exchanged.
            blade.stroke({example.to, example.from}, example.width, BladeEnd::square, tally);
            const std::string same = "abcedgfhij";
            const auto expected =
                static_cast<std::size_t>(same[static_cast<std::size_t>(example.letter - 'a')] - 'a');
            EXPECT_EQ(tally.cases.count[expected], 1) << example.letter << " turned by " << turn;
        }
}

TEST(CutCases, PageShowsTheCounts) {
    const test::OwnFolder folder;
    const lab::ResultPage page = lab::cut_figures_page();
    const auto files = page.write(folder.path().string(), lab::Machine());
    EXPECT_EQ(files.size(), 4U);
    const std::string text = page.text(lab::Machine());
    for (char c = 'a'; c <= 'j'; ++c)
        EXPECT_NE(text.find(std::string("12") + c + ": "), std::string::npos) << c;
    EXPECT_TRUE(std::filesystem::exists(folder / "fig12_cases.svg"));
    EXPECT_TRUE(std::filesystem::exists(folder / "fig12_cut_cases.json"));
}

}  // namespace
}  // namespace fulcrum
