// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing of a bowel whose wall is cut: an opening shows the lumen, a detached piece falls out of the
// picture, there is no seam next to a cut, and an uncut bowel looks like one that cannot be cut.
// FULCRUM_PICTURES=FOLDER stores the pictures.
#include "ui/theatre/renderer/bowel_cut_drawing.h"

#include <gtest/gtest.h>

#include <QColor>
#include <QDir>

#include "tests/sim_core/world/parts/bowel/bowel_cut_rig.h"
#include "ui/theatre/renderer/offscreen.h"
#include "ui/theatre/renderer/picture.h"
#include "ui/theatre/renderer/scene_assembler.h"

namespace fulcrum::ui {
namespace {

constexpr int side = 480;

class BowelCutPicture : public ::testing::Test {
  protected:
    BowelCutPicture() : assembler(rig.scene, rig.world.snapshot()) {
        RendererOptions options;
        options.texture_size = 256;
        options.resolution = 1;
        renderer = std::make_unique<SceneRenderer>(options);
        assembler.install(*renderer);
        const Vector3 top = rig.top_now();
        camera = camera_towards(top + Vector3(0.004, 0.036, 0.048), top, Vector3::UnitZ(), 0.7);
    }
    ~BowelCutPicture() override {
        stage.make_current();
        renderer->release();
    }
    WorldSnapshot seen() const {
        WorldSnapshot snapshot = rig.world.snapshot();
        snapshot.camera = camera;
        for (ToolPose& tool : snapshot.tools) tool.inside = false;
        return snapshot;
    }
    QImage draw(const WorldSnapshot& snapshot, const char* name) {
        const QImage image = stage.draw(*renderer, assembler.assemble(snapshot), QSize(side, side));
        const QString folder = qEnvironmentVariable("FULCRUM_PICTURES");
        if (!folder.isEmpty()) image.save(QDir(folder).filePath(QString::fromLatin1(name) + ".png"));
        return image;
    }
    /// Pixels whose brightest difference is larger than `by`.
    static int differing(const QImage& a, const QImage& b, int by) {
        int count = 0;
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
                const int most = std::max({std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)),
                                           std::abs(qBlue(p) - qBlue(q))});
                count += most > by ? 1 : 0;
            }
        }
        return count;
    }
    /// The same moment with a bowel that cannot be cut.
    static WorldSnapshot healed(WorldSnapshot snapshot) {
        snapshot.bowel.cut = {};
        return snapshot;
    }
    test::BowelCutRig rig;
    SceneAssembler assembler;
    OffscreenStage stage;
    std::unique_ptr<SceneRenderer> renderer;
    CameraPose camera;
};

TEST_F(BowelCutPicture, SlitIsVisibleAndUncutBowelLooksLikeOneThatCannotBeCut) {
    const WorldSnapshot whole = seen();
    const QImage before = draw(whole, "bowel-whole");
    EXPECT_EQ(assembler.assemble(whole).bowel_hidden, nullptr);
    EXPECT_TRUE(assembler.assemble(whole).sheets.empty());
    EXPECT_EQ(draw(healed(whole), "bowel-uncuttable"), before);
    rig.cut_slit(rig.top, 0.02);
    rig.step();
    const QImage slit = draw(seen(), "bowel-slit");
    EXPECT_GT(differing(slit, draw(healed(seen()), "bowel-without-slit"), 24), 400);
}

TEST_F(BowelCutPicture, ADiscFallsAndLeavesAnOpeningIntoTheLumen) {
    ASSERT_EQ(rig.cut_round(rig.top, 0.007).parted, 1);
    rig.step();
    const WorldSnapshot parted = seen();
    const QImage cut = draw(parted, "bowel-disc");
    WorldSnapshot lower = parted;
    lower.bowel.cut.fallen[0].z() -= 0.009;
    const QImage falling = draw(lower, "bowel-disc-falls");
    EXPECT_GT(differing(cut, falling, 24), 2000);
    for (int i = 0; i < 220; ++i) rig.step();
    ASSERT_GT(rig.world.snapshot().bowel.cut.removed_area, 1e-4) << "the disc has fallen and was removed";
    const QImage open = draw(seen(), "bowel-open"), whole = draw(healed(seen()), "bowel-healed");
    // Inside the rim it is dark and red, because little light enters; the rim itself is lit and paler.
    int dark = 0, lit = 0, redder = 0;
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const QColor now = open.pixelColor(x, y), before = whole.pixelColor(x, y);
            if (now == before) continue;
            const bool in = now.green() + 60 < before.green();
            dark += in ? 1 : 0;
            redder += in && now.red() - now.green() > before.red() - before.green() ? 1 : 0;
            lit += !in && now.green() > 120 ? 1 : 0;
        }
    }
    EXPECT_GT(dark, 6000);
    EXPECT_GT(redder, dark / 2);
    EXPECT_GT(lit, 1500);
}

TEST_F(BowelCutPicture, RemainingPartOfATriangleLooksUnchanged) {
    const WorldSnapshot whole = seen();
    const QImage before = draw(whole, "bowel-unhidden");
    // Every nearby triangle is drawn as a remaining part that is the whole triangle.
    WorldSnapshot parted = whole;
    BowelCutView& view = parted.bowel.cut;
    const TriangleMesh& mesh = rig.bowel().skin().rest();
    for (std::size_t r = 0; r < mesh.triangles.size(); ++r) {
        const Vector3 place = rig.now(mesh.triangles[r][0]);
        if ((place - rig.top_now()).norm() > 0.012) continue;
        view.hidden[r] = 1;
        const auto k = static_cast<std::size_t>(view.triangle_count++);
        view.triangles[k] = mesh.triangles[r];
        view.triangle_roots[k] = static_cast<std::int32_t>(r);
        view.triangle_loose[k] = 0;
    }
    ASSERT_GT(view.triangle_count, 100);
    const QImage after = draw(parted, "bowel-divided");
    const SceneFrame& frame = assembler.assemble(parted);
    ASSERT_EQ(frame.sheets.size(), 1U);
    SheetMesh sheet;
    sheet.build(frame.sheets[0].surface);
    EXPECT_EQ(sheet.rim_edges(), 0U) << "nothing was taken away";
    EXPECT_LT(differing(before, after, 4), 20) << "rounding at the edges of triangles";
    // After restoring, the picture is the original one.
    EXPECT_EQ(draw(whole, "bowel-again"), before);
}

}  // namespace
}  // namespace fulcrum::ui
