// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing of the sacral hollow: walls, the rectum in its fat, tearing fibres, char, veins.
// FULCRUM_PICTURES=FOLDER stores the pictures.
#include "ui/theatre/renderer/hollow_drawing.h"

#include <gtest/gtest.h>

#include <QColor>
#include <QDir>

#include "sim_core/world/world.h"
#include "tests/support/support.h"
#include "ui/theatre/renderer/scene_assembler.h"

namespace fulcrum::ui {
namespace {

class Hollow : public ::testing::Test {
  protected:
    Hollow() : snapshot(World(scene, 1).snapshot()), assembler(scene, snapshot) {
        RendererOptions options;
        options.texture_size = 256;
        options.resolution = 1;
        renderer = std::make_unique<SceneRenderer>(options);
        assembler.install(*renderer);
    }
    QImage picture(const char* name) {
        const QImage image = render_offscreen(*renderer, assembler.assemble(snapshot), QSize(640, 640));
        const QString folder = qEnvironmentVariable("FULCRUM_PICTURES");
        if (!folder.isEmpty()) image.save(QDir(folder).filePath(QString::fromLatin1(name) + ".png"));
        return image;
    }
    /// The septa's own sheet in the frame.
    static const DrawnSheet* septa(const SceneFrame& frame) {
        for (const DrawnSheet& sheet : frame.sheets) {
            if (sheet.fibres) return &sheet;
        }
        return nullptr;
    }
    static int darker(const QImage& before, const QImage& after, int by) {
        int count = 0;
        for (int y = 0; y < before.height(); ++y) {
            for (int x = 0; x < before.width(); ++x)
                count += qGray(after.pixel(x, y)) + by < qGray(before.pixel(x, y)) ? 1 : 0;
        }
        return count;
    }
    Scene scene = load_scene(test::source_path("assets/scenes/c4_posterior.json"));
    WorldSnapshot snapshot;
    SceneAssembler assembler;
    std::unique_ptr<SceneRenderer> renderer;
};

TEST_F(Hollow, RectumIsSurroundedByFatAndWallsCloseTheCavity) {
    const SceneFrame& frame = assembler.assemble(snapshot);
    EXPECT_TRUE(frame.enclosed);
    ASSERT_NE(septa(frame), nullptr);
    EXPECT_EQ(septa(frame)->fat_from, snapshot.sheet.fat_from);
    const SacralCurve curve{scene.presacral->centre, scene.presacral->curve_radius,
                            scene.presacral->caudal_angle, scene.bowel->outer_radius, scene.presacral->gap};
    int fat = 0, still = 0;
    for (const DrawnSheet& sheet : frame.sheets) {
        for (std::size_t v = 0; v < sheet.surface.vertices; ++v)
            ASSERT_TRUE(sheet.surface.positions[v].allFinite());
        for (std::size_t t = 0; t < sheet.surface.count; ++t) {
            for (const std::int32_t corner : sheet.surface.triangles[t])
                ASSERT_LT(static_cast<std::size_t>(corner), sheet.surface.vertices);
        }
        still += sheet.version != 0 ? 1 : 0;
        if (sheet.wear != SheetWear::fat) continue;
        ++fat;
        // Between bowel and fascia, at the depth of the septa's fat behind the bowel.
        double farthest = 0;
        for (std::size_t v = 0; v < sheet.surface.vertices; ++v) {
            const Vector3& p = sheet.surface.positions[v];
            const Vector3 from = p - curve.centre;
            const double off = std::hypot(p.x(), std::hypot(from.y(), from.z()) - curve.curve_radius);
            EXPECT_LT(off, curve.fascia_radius());
            farthest = std::max(farthest, off);
        }
        EXPECT_NEAR(farthest, scene.bowel->outer_radius + scene.presacral->gap - scene.septa->areolar_height,
                    0.0015);
    }
    EXPECT_EQ(fat, 1);
    EXPECT_EQ(still, 2) << "fascia and walls are uploaded once";

    const QImage image = picture("C4-at-rest");
    int lit = 0, bluish = 0, seen = 0;
    for (int y = 0; y < image.height(); y += 4) {
        for (int x = 0; x < image.width(); x += 4) {
            if (std::hypot(x - 320, y - 320) > 290) continue;
            const QColor c = image.pixelColor(x, y);
            ++seen;
            lit += c.red() + c.green() + c.blue() > 40 ? 1 : 0;
            bluish += c.blue() > c.red() + 5 ? 1 : 0;
        }
    }
    EXPECT_GT(lit, seen * 8 / 10) << "walls all round, no hole";
    EXPECT_LT(bluish, seen / 10) << "only the instruments are bluish: no training box";
}

TEST_F(Hollow, TissueDividedByEnergyIsBlack) {
    const QImage before = picture("C4-unburnt");
    StructuresView energy;
    energy.sheet_char.assign(static_cast<std::size_t>(snapshot.sheet.triangle_count), 0);
    for (std::size_t t = 0; t < energy.sheet_char.size() / 4; ++t)
        energy.sheet_char[t] = 0.8F;  // the first septum
    snapshot.structures = energy;
    const QImage after = picture("C4-burnt");
    const DrawnSheet* drawn = septa(assembler.assemble(snapshot));
    ASSERT_NE(drawn, nullptr);
    ASSERT_NE(drawn->surface.burnt, nullptr);
    int burnt = 0;
    for (std::size_t v = 0; v < drawn->surface.vertices; ++v) {
        const bool black = drawn->surface.burnt[v] > 0.5F;
        burnt += black ? 1 : 0;
        if (snapshot.sheet.rest[v].x() > 1.01 * snapshot.sheet.septum_length) {
            EXPECT_FALSE(black) << "of another septum";
        }
    }
    EXPECT_GT(burnt, 50);
    EXPECT_GT(darker(before, after, 40), 300);
}

TEST_F(Hollow, FibresTearWhereTheyAreStretched) {
    const QImage before = picture("C4-unstretched");
    // The rectum pulled forward: attached tissue follows, more so in its upper part.
    for (std::int32_t v = 0; v < snapshot.sheet.vertex_count; ++v) {
        const auto k = static_cast<std::size_t>(v);
        const double up =
            (snapshot.sheet.rest[k].y() + scene.septa->plane_height) / scene.septa->areolar_height;
        snapshot.sheet.positions[k].z() += 0.018 * std::min(1.0, up);
    }
    for (Vector3& p : snapshot.sheet.envelope) p.z() += 0.018;
    for (RingFrame& ring : snapshot.bowel.rings) ring.position.z() += 0.018;
    const QImage after = picture("C4-stretched");
    EXPECT_NE(before, after);
}

TEST_F(Hollow, VeinsAreVisibleAsBlueThroughTheFascia) {
    const QImage before = picture("C4-no-veins");
    const SacralCurve curve{scene.presacral->centre, scene.presacral->curve_radius,
                            scene.presacral->caudal_angle, scene.bowel->outer_radius, scene.presacral->gap};
    StructuresView view;
    VeinView vein;
    vein.radius = 0.0015;
    for (int i = 0; i <= 20; ++i) vein.line.push_back(curve.point(0.012 * i - 0.02, 0.9, 0.0003));
    view.veins = {vein};
    snapshot.structures = view;
    const QImage after = picture("C4-veins");
    int blue = 0;
    for (int y = 0; y < after.height(); ++y) {
        for (int x = 0; x < after.width(); ++x) {
            const QColor a = after.pixelColor(x, y), b = before.pixelColor(x, y);
            blue += a.blue() - a.red() > b.blue() - b.red() + 20 ? 1 : 0;
        }
    }
    EXPECT_GT(blue, 60);
}

}  // namespace
}  // namespace fulcrum::ui
