// SPDX-License-Identifier: GPL-3.0-or-later
// The specimen map: what is painted, in colours that everybody can tell apart; sectors chosen by mouse and
// keys; numbers one click behind. FULCRUM_PICTURES=FOLDER stores the cards.
#include <gtest/gtest.h>

#include <QApplication>
#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <array>
#include <cmath>

#include "tests/ui/colour_vision.h"
#include "tests/ui/cut_texts.h"
#include "tests/ui/hands.h"
#include "tests/ui/painted_words.h"
#include "tests/ui/specimens.h"
#include "ui/language/language.h"
#include "ui/reports/pathology_words.h"
#include "ui/reports/specimen_map.h"
#include "ui/review/pathology_card.h"
#include "ui/review/specimen_view.h"

namespace fulcrum::ui::window_test {
namespace {

class SpecimenMap : public ::testing::Test {
  protected:
    SpecimenMap() { apply_theme(*qApp, Theme::light); }
    ~SpecimenMap() override { apply_theme(*qApp, Theme::light); }
    void show(const PathologyReport& report, int width = 900) {
        card = std::make_unique<PathologyCard>();
        card->resize(width, 700);
        card->open(report, std::nullopt);
        card->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(card.get()));
        QCoreApplication::processEvents();
    }
    QString painted() {
        auto* map = find<QWidget>(*card, "specimen_map");
        WordsDevice device(map->size());
        map->render(&device, {}, {}, QWidget::DrawWindowBackground);
        QString words;
        for (const PaintedWords& line : device.words()) words += line.words.trimmed() + QLatin1Char(' ');
        return words;
    }
    QString label(const char* name) { return find<QLabel>(*card, name)->text(); }
    void keep(const QString& name) {
        const QString folder = qEnvironmentVariable("FULCRUM_PICTURES");
        if (!folder.isEmpty()) card->grab().save(folder + QLatin1Char('/') + name + QStringLiteral(".png"));
    }
    std::unique_ptr<PathologyCard> card;
};

TEST_F(SpecimenMap, NamesGradeMarginsAndDepthOfDefects) {
    show(varied_specimen());
    const QString words = painted();
    for (const char* part :
         {"Grade 2, nearly complete", "Circumferential margin", "Distal margin", "34.0 mm", "6.0", "tumour",
          "level 1", "level 4", "cranial", "caudal", "right", "midline", "left", "▼", "▲"})
        EXPECT_TRUE(words.contains(QString::fromUtf8(part))) << part << "\n" << words.toStdString();
}

TEST_F(SpecimenMap, SaysWhyASpecimenIsNotGradable) {
    show(varied_specimen(150));
    const QString words = painted();
    EXPECT_TRUE(words.contains("Not gradable")) << words.toStdString();
    EXPECT_TRUE(words.contains("62.5 % of the plane was divided; a grade needs 95 %")) << words.toStdString();
    EXPECT_TRUE(find<QWidget>(*card, "specimen_map")->accessibleDescription().contains("Not gradable"));
    keep("specimen-not-gradable");
    show(specimen([](int) { return 0.0; }, 0));
    EXPECT_TRUE(painted().contains("nothing was cut"));
    // A report without levels has labels, and nothing to click.
    PathologyReport none;
    show(none);
    EXPECT_TRUE(painted().contains("Not gradable"));
    EXPECT_TRUE(card->findChildren<SpecimenCell*>().isEmpty());
}

TEST_F(SpecimenMap, SectorsAreColouredByTheDistanceOfTheirCut) {
    const PathologyReport report = varied_specimen();
    const double tolerance = report.plan.tolerance;
    const auto step = [&](int level, Sector sector) {
        return deviation_of(
            report
                .findings[static_cast<std::size_t>(level * sector_count) + static_cast<std::size_t>(sector)],
            tolerance);
    };
    EXPECT_EQ(step(0, Sector::mid).step, DeviationStep::in_plane);
    EXPECT_EQ(step(1, Sector::right).step, DeviationStep::far_outside);
    EXPECT_TRUE(step(1, Sector::right).deep);
    EXPECT_EQ(step(1, Sector::mid).step, DeviationStep::outside);
    EXPECT_EQ(step(3, Sector::mid).step, DeviationStep::outside);
    EXPECT_FALSE(step(3, Sector::mid).deep);
    EXPECT_EQ(deviation_sign(step(1, Sector::right)), QString::fromUtf8("▼▼"));
    EXPECT_EQ(deviation_of(varied_specimen(60).findings.back(), tolerance).step, DeviationStep::none);
    for (const Theme theme : {Theme::light, Theme::dark}) {
        apply_theme(*qApp, theme);
        show(report);
        auto* map = find<QWidget>(*card, "specimen_map");
        const QImage picture = map->grab().toImage();
        for (const auto& [level, sector] : {std::pair(0, Sector::mid), std::pair(1, Sector::right),
                                            std::pair(1, Sector::left), std::pair(3, Sector::mid)}) {
            const auto* cell = map->findChild<SpecimenCell*>(
                QStringLiteral("specimen_cell_%1_%2").arg(level + 1).arg(sector_name(sector)));
            ASSERT_NE(cell, nullptr);
            EXPECT_EQ(picture.pixelColor(cell->geometry().bottomRight() - QPoint(8, 8)).name(),
                      deviation_colour(step(level, sector), colours()).name())
                << level << " " << sector_name(sector);
        }
    }
}

TEST_F(SpecimenMap, UndividedGroundIsHatchedAndDividedGroundIsNot) {
    const auto inks = [&](const char* name) {
        auto* map = find<QWidget>(*card, "specimen_map");
        const auto* cell = map->findChild<SpecimenCell*>(QString::fromLatin1(name));
        const QImage picture = map->grab().toImage().copy(cell->geometry().adjusted(6, 6, -6, -6));
        int other = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x) other += picture.pixel(x, y) != picture.pixel(0, 0);
        return static_cast<double>(other) / (picture.width() * picture.height());
    };
    show(varied_specimen(150));
    EXPECT_GT(inks("specimen_cell_4_left"), 0.2);
    EXPECT_LT(inks("specimen_cell_1_mid"), 0.02);
    show(varied_specimen());
    EXPECT_LT(inks("specimen_cell_1_left"), 0.02);
}

TEST_F(SpecimenMap, TooDeepAndTooShallowDifferForPeopleWithAColourVisionDeficiency) {
    for (const Theme theme : {Theme::light, Theme::dark}) {
        const Palette& palette = palette_of(theme);
        for (const auto& sight : deficient_sights) {
            for (const DeviationStep step : {DeviationStep::outside, DeviationStep::far_outside}) {
                const QColor deep = deviation_colour({step, true}, palette);
                const QColor shallow = deviation_colour({step, false}, palette);
                const QColor plane = deviation_colour({DeviationStep::in_plane, false}, palette);
                EXPECT_GT(apart(sight, deep, shallow), 0.2);
                EXPECT_GT(apart(sight, deep, plane), 0.15);
                EXPECT_GT(apart(sight, shallow, plane), 0.15);
            }
        }
    }
}

TEST_F(SpecimenMap, AClickOnASectorShowsItsNumbersAndItsDefect) {
    show(varied_specimen());
    EXPECT_FALSE(sees(*card, "pathology_table")) << "numbers are one click behind";
    EXPECT_FALSE(sees(*card, "specimen_show"));
    std::vector<double> times;
    QObject::connect(card.get(), &PathologyCard::time_chosen, [&](double time) { times.push_back(time); });
    click(*card, "specimen_cell_3_left");
    EXPECT_TRUE(label("specimen_sector").startsWith("Level 3, left: 100 % divided."))
        << label("specimen_sector").toStdString();
    EXPECT_TRUE(label("specimen_sector").contains("Deepest defect 6.0 mm"));
    click(*card, "specimen_show");
    EXPECT_EQ(times, std::vector<double>({16.5}));
    click(*card, "specimen_cell_1_mid");
    EXPECT_FALSE(sees(*card, "specimen_show")) << "no defect there";
    click(*card, "pathology_numbers");
    EXPECT_TRUE(sees(*card, "pathology_table"));
    keep("specimen-numbers");
    click(*card, "pathology_numbers");
    EXPECT_FALSE(sees(*card, "pathology_table"));
}

TEST_F(SpecimenMap, HeadsOfTheNumbersAreWholeWithLargeText) {
    for (const Language language : {Language::english, Language::german}) {
        use_language(language);
        apply_text_size(*qApp, 200);
        show(varied_specimen());
        click(*card, "pathology_numbers");
        QCoreApplication::processEvents();
        EXPECT_EQ(cut_texts(*card).join('\n').toStdString(), "");
        const auto* table = find<QTableWidget>(*card, "pathology_table");
        EXPECT_GT(table->horizontalHeader()->length(), table->viewport()->width()) << "it scrolls sideways";
        keep(QStringLiteral("specimen-numbers-large-") + row_of(languages, language).name);
    }
    card.reset();
    apply_text_size(*qApp, 100);
    use_language(Language::english);
}

TEST_F(SpecimenMap, KeysMoveFromSectorToSectorAndEverySectorHasAName) {
    show(varied_specimen(150));
    card->activateWindow();
    auto* first = find<QAbstractButton>(*card, "specimen_cell_1_right");
    first->setFocus();
    QTest::keyClick(first, Qt::Key_Return);
    EXPECT_TRUE(label("specimen_sector").startsWith("Level 1, right:"));
    QTest::keyClick(first, Qt::Key_Down);
    QTest::keyClick(find<QAbstractButton>(*card, "specimen_cell_2_right"), Qt::Key_Right);
    EXPECT_TRUE(label("specimen_sector").startsWith("Level 2, midline:"))
        << label("specimen_sector").toStdString();
    // Beyond the rim nothing changes.
    QTest::keyClick(first, Qt::Key_Up);
    QTest::keyClick(first, Qt::Key_Left);
    EXPECT_TRUE(label("specimen_sector").startsWith("Level 2, midline:"));
    const auto cells = card->findChildren<SpecimenCell*>();
    ASSERT_EQ(cells.size(), 12);
    for (const SpecimenCell* cell : cells) EXPECT_FALSE(cell->accessibleName().isEmpty());
    EXPECT_EQ(cells.back()->accessibleName(), "Level 4, left: not divided.");
    int stops = 0;
    for (const SpecimenCell* cell : cells) stops += (cell->focusPolicy() & Qt::TabFocus) != 0 ? 1 : 0;
    EXPECT_EQ(stops, 1);
}

TEST_F(SpecimenMap, FitsItsCardAtEveryWidthAndFontSize) {
    for (const double points : {10.5, 21.0}) {
        for (const int width : {640, 760, 940, 1240}) {
            for (const Theme theme : {Theme::light, Theme::dark}) {
                apply_theme(*qApp, theme);
                QFont font = qApp->font();
                font.setPointSizeF(points);
                qApp->setFont(font);
                show(varied_specimen(), width);
                auto* map = find<QWidget>(*card, "specimen_map");
                const SpecimenMapLayout layout =
                    specimen_map_layout(varied_specimen(), map->width(), QFontMetricsF(map->font()), 1);
                EXPECT_LE(layout.height, map->height() + 1);
                for (const QRectF& part : {layout.grid, layout.labels, layout.legend}) {
                    EXPECT_GE(part.left(), 0);
                    EXPECT_LE(part.right(), map->width() + 1) << width << " at " << points;
                }
                EXPECT_FALSE(layout.labels.intersects(layout.grid));
                EXPECT_FALSE(layout.labels.intersects(layout.legend));
                keep(QStringLiteral("specimen-%1-%2-%3")
                         .arg(width)
                         .arg(points)
                         .arg(theme == Theme::light ? "light" : "dark"));
            }
        }
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
