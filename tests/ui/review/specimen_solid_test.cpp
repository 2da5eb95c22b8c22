// SPDX-License-Identifier: GPL-3.0-or-later
// The specimen in three dimensions: turned by mouse and keys, in the colours of its map, with the same choice
// of sectors. FULCRUM_PICTURES=FOLDER stores the cards.
#include "ui/review/specimen_solid.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QRadioButton>
#include <QScrollArea>
#include <QScrollBar>
#include <set>

#include "tests/ui/hands.h"
#include "tests/ui/specimens.h"
#include "ui/reports/specimen_map.h"
#include "ui/review/pathology_card.h"
#include "ui/review/specimen_view.h"
#include "ui/style/palette.h"

namespace fulcrum::ui::window_test {
namespace {

class Solid : public ::testing::Test {
  protected:
    Solid() { apply_theme(*qApp, Theme::light); }
    ~Solid() override { apply_theme(*qApp, Theme::light); }
    void show(const PathologyReport& report, int width = 900) {
        area = std::make_unique<QScrollArea>();
        area->setWidgetResizable(true);
        card = new PathologyCard;
        card->open(report, std::nullopt);
        area->setWidget(card);
        area->resize(width, 760);
        area->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(area.get()));
        area->activateWindow();
        if (card->findChildren<SpecimenCell*>().isEmpty()) return;
        click(*card, "specimen_as_solid");
        QCoreApplication::processEvents();
    }
    SpecimenSolid& solid() { return *card->findChild<SpecimenSolid*>(); }
    QImage picture() { return solid().grab().toImage().convertToFormat(QImage::Format_RGB32); }
    void press(int key) { QTest::keyClick(&solid(), static_cast<Qt::Key>(key)); }
    void keep(const QString& name) {
        const QString folder = qEnvironmentVariable("FULCRUM_PICTURES");
        if (!folder.isEmpty()) card->grab().save(folder + QLatin1Char('/') + name + QStringLiteral(".png"));
    }
    std::unique_ptr<QScrollArea> area;
    PathologyCard* card = nullptr;  ///< of the area
};

TEST_F(Solid, TakesThePlaceOfTheMapAndBack) {
    show(varied_specimen());
    EXPECT_TRUE(sees(*card, "specimen_solid"));
    EXPECT_FALSE(sees(*card, "specimen_cell_1_mid"));
    EXPECT_FALSE(solid().accessibleName().isEmpty());
    click(*card, "specimen_as_map");
    EXPECT_FALSE(sees(*card, "specimen_solid"));
    EXPECT_TRUE(sees(*card, "specimen_cell_1_mid"));
    // Another report begins with its map; one without levels has no choice.
    click(*card, "specimen_as_solid");
    card->open(varied_specimen(150), std::nullopt);
    EXPECT_FALSE(sees(*card, "specimen_solid"));
    EXPECT_TRUE(find<QRadioButton>(*card, "specimen_as_map")->isChecked());
    show(PathologyReport());
    EXPECT_FALSE(sees(*card, "specimen_as_solid"));
    EXPECT_FALSE(sees(*card, "specimen_solid"));
}

TEST_F(Solid, MouseAndKeysTurnItAndHomeTurnsItBack) {
    show(varied_specimen());
    solid().setFocus();
    const QImage begin = picture();
    std::set<QString> said;
    for (int i = 0; i < 24; ++i) {  // once round, 15 degrees a key
        const QImage before = picture();
        press(Qt::Key_Right);
        EXPECT_NE(picture(), before) << i;
        said.insert(solid().accessibleDescription());
    }
    EXPECT_EQ(said.size(), 4U) << "behind, left, front, right";
    EXPECT_EQ(picture(), begin) << "once round";
    for (int i = 0; i < 30; ++i) press(Qt::Key_Down);
    const QImage steep = picture();
    press(Qt::Key_Down);
    EXPECT_EQ(picture(), steep) << "it does not turn over";
    press(Qt::Key_Home);
    EXPECT_EQ(picture(), begin);

    const QPoint middle = solid().rect().center();
    QTest::mousePress(&solid(), Qt::LeftButton, {}, middle);
    QTest::mouseMove(&solid(), middle + QPoint(60, -30));
    QMouseEvent drag(QEvent::MouseMove, middle + QPoint(60, -30), Qt::LeftButton, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&solid(), &drag);
    QTest::mouseRelease(&solid(), Qt::LeftButton, {}, middle + QPoint(60, -30));
    EXPECT_NE(picture(), begin);
    EXPECT_LT(solid().pose().pitch, 0.35);
    EXPECT_TRUE(find<QLabel>(*card, "specimen_sector")->text().startsWith("Select"))
        << "a drag chooses nothing";
}

TEST_F(Solid, SectorsHaveTheColoursOfTheMapInBothThemes) {
    const PathologyReport report = varied_specimen();
    for (const Theme theme : {Theme::light, Theme::dark}) {
        apply_theme(*qApp, theme);
        show(report);
        std::set<int> looked_at;
        for (int turn = 0; turn < 24; ++turn) {
            const QImage seen = picture();
            for (const SolidFace& face : facing_sectors(report, solid().pose(), solid().area())) {
                const SectorFinding& finding = report.findings[static_cast<std::size_t>(face.finding)];
                const QRectF box = face.outline.boundingRect();
                if (box.width() < 30 || finding.defect > 0) continue;
                // Right of the middle and below it there is neither sign nor outline.
                const QPointF place = box.center() + QPointF(0.2 * box.width(), 0.1 * box.height());
                if (!face.outline.containsPoint(place, Qt::OddEvenFill)) continue;
                EXPECT_EQ(seen.pixelColor(place.toPoint()).name(),
                          deviation_colour(deviation_of(finding, report.plan.tolerance), colours()).name())
                    << face.finding << " turned " << turn;
                looked_at.insert(face.finding);
            }
            press(Qt::Key_Right);
        }
        EXPECT_GE(looked_at.size(), 10U);
        keep(theme == Theme::light ? "specimen-solid-light" : "specimen-solid-dark");
    }
}

TEST_F(Solid, UndividedGroundIsHatchedAndAClickChoosesASector) {
    show(varied_specimen(150));
    keep("specimen-solid-undivided");
    const auto faces = facing_sectors(varied_specimen(150), solid().pose(), solid().area());
    ASSERT_FALSE(faces.empty());
    const auto colours_in = [&](const QRectF& box) {
        std::set<QRgb> found;
        const QImage seen = picture();
        for (int y = int(box.top()) + 4; y < box.bottom() - 4; ++y)
            found.insert(seen.pixel(int(box.center().x() + 0.2 * box.width()), y));
        return found.size();
    };
    const SolidFace* undivided = nullptr;
    for (const SolidFace& face : faces)
        if (face.finding == 10) undivided = &face;  // the lowest level, midline
    ASSERT_NE(undivided, nullptr);
    EXPECT_GT(colours_in(undivided->outline.boundingRect()), 4U);
    QTest::mouseClick(&solid(), Qt::LeftButton, {}, undivided->outline.boundingRect().center().toPoint());
    EXPECT_TRUE(find<QLabel>(*card, "specimen_sector")->text().startsWith("Level 4, midline: not divided"))
        << find<QLabel>(*card, "specimen_sector")->text().toStdString();
    click(*card, "specimen_as_map");
    EXPECT_TRUE(find<QAbstractButton>(*card, "specimen_cell_4_mid")->isChecked());
}

TEST_F(Solid, FitsItsCardAtEveryWidthAndSizeOfText) {
    for (const int percent : {100, 200}) {
        apply_text_size(*qApp, percent);
        for (const int width : {640, 940}) {
            show(varied_specimen(), width);
            auto* map = find<QWidget>(*card, "specimen_map");
            EXPECT_TRUE(map->rect().contains(solid().geometry())) << width << " at " << percent;
            const auto* below = find<QLabel>(*card, "specimen_sector");
            EXPECT_TRUE(wait_for([&] {  // the card lays out what changed in its own time
                return map->mapTo(card, map->rect().bottomLeft()).y() <= below->mapTo(card, QPoint(0, 0)).y();
            })) << width
                << " at " << percent;
            EXPECT_LE(area->horizontalScrollBar()->maximum(), 0);
            for (const SolidFace& face : facing_sectors(varied_specimen(), solid().pose(), solid().area()))
                EXPECT_TRUE(QRectF(solid().rect()).contains(face.outline.boundingRect()));
            keep(QStringLiteral("specimen-solid-%1-%2").arg(width).arg(percent));
        }
    }
    apply_text_size(*qApp, 100);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
