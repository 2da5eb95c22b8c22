// SPDX-License-Identifier: GPL-3.0-or-later
// What is around every chart: its table one click away, copies as picture and as data, and what is behind a
// part of it.
#include "ui/charts/chart_frame.h"

#include <gtest/gtest.h>

#include <QClipboard>
#include <QImage>
#include <QKeyEvent>
#include <QTableWidget>
#include <QToolTip>

#include "tests/ui/hands.h"
#include "tests/ui/heard.h"
#include "ui/charts/figure_chart.h"
#include "ui/charts/time_charts.h"
#include "ui/language/language.h"

namespace fulcrum::ui::window_test {
namespace {

ChartTable two_rows(const QString& name) {
    return {{{"Person"}, {"force", "N"}},
            {{{ChartCell::words(name), ChartCell::value(1.0 / 3)}, "p1 A2"},
             {{ChartCell::words("Ben"), ChartCell::value({})}, {}}}};
}

Figure three_steps() {
    FunnelFigure figure;
    figure.all = 4;
    figure.steps = {{"0", "A begun", 4, false, "4 (100 %)"},
                    {"1", "A done", 2, true, "2 (50 %)"},
                    {"2", "B begun", 0, false, "0 (0 %)"}};
    return figure;
}

class FramedChart : public ::testing::Test {
  protected:
    FramedChart() {
        chart = new FigureChart("stages_chart");
        frame = new ChartFrame(chart, "How far people are", "stages");
        chart->show_figure(three_steps(), two_rows("=Ann"), "4 people", "nobody");
        auto* layout = new QVBoxLayout(&window);
        layout->addWidget(frame);
        window.resize(640, 420);
        window.show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&window));
        EXPECT_TRUE(wait_for([&] { return !chart->place_of("0").isEmpty(); }));
    }
    QString clipboard() const { return QGuiApplication::clipboard()->text(); }

    QWidget window;
    FigureChart* chart;
    ChartFrame* frame;
};

TEST(ChartTable, IsCopiedWithUnitsAllDigitsAndNoFormula) {
    const ChartTable table{
        {{"=Person"}, {"force, left hand", "N"}, {"day"}, {"n"}},
        {{{ChartCell::words("-2+3\tx\ny"), ChartCell::value(1.0 / 3), ChartCell::day(20788),
           ChartCell::count(1200)},
          {}},
         {{ChartCell::words("Ann; =1+1"), ChartCell::value({}), ChartCell::day(0), ChartCell::count(-1)},
          {}}}};
    EXPECT_EQ(copied_table(table),
              "'=Person\tforce, left hand (N)\tday\tn\n"
              "'-2+3 x y\t0.3333333333333333\t2026-12-01\t1200\n"
              "Ann;' =1+1\t\t1970-01-01\t-1\n");
    EXPECT_EQ(copied_table({}), "\n");
}

TEST_F(FramedChart, TableIsOneClickAwayAndBack) {
    click(window, "stages_as_table");
    auto* table = find<QTableWidget>(window, "stages_table");
    EXPECT_FALSE(chart->isVisible());
    ASSERT_EQ(table->rowCount(), 2);
    EXPECT_EQ(table->accessibleName(), "How far people are");
    EXPECT_EQ(table->horizontalHeaderItem(1)->text(), "force (N)");
    EXPECT_EQ(table->item(0, 1)->text(), "0.333");
    EXPECT_EQ(table->item(1, 1)->text(), "–");
    // New values reach a table that is shown.
    chart->show_figure(three_steps(), two_rows("Amy"), "4 people", "nobody");
    EXPECT_EQ(table->item(0, 0)->text(), "Amy");
    QSignalSpy chosen(frame, &ChartFrame::row_chosen);
    table->setCurrentCell(0, 0);
    QTest::keyClick(table, Qt::Key_Return);
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen[0][0].toString(), "p1 A2");
    table->setCurrentCell(1, 0);
    QTest::keyClick(table, Qt::Key_Return);
    EXPECT_EQ(chosen.count(), 1) << "the second row leads nowhere";
    click(window, "stages_as_table");
    EXPECT_TRUE(chart->isVisible());
    EXPECT_FALSE(table->isVisible());
}

TEST_F(FramedChart, CopiesItsDataByButtonAndByKeys) {
    click(window, "stages_copy_data");
    const QString copied = "Person\tforce (N)\n'=Ann\t0.3333333333333333\nBen\t\n";
    EXPECT_EQ(clipboard(), copied);
    QGuiApplication::clipboard()->clear();
    QApplication::setActiveWindow(&window);
    chart->setFocus();
    QTest::keyClick(chart, Qt::Key_C, Qt::ControlModifier);
    EXPECT_EQ(clipboard(), copied);
    for (const char* part : {"stages_as_table", "stages_copy_data", "stages_copy_picture"})
        EXPECT_TRUE(find<QAbstractButton>(window, part)->accessibleName().startsWith("How far people are: "));
}

TEST(ChartCells, ADayIsShownAsTheLanguageWritesItAndCopiedAsIso) {
    constexpr int fourth_of_october = 20000;  // days after 1970-01-01
    EXPECT_EQ(ChartCell::day(fourth_of_october).shown, "4 Oct 2024");
    use_language(Language::german);
    const ChartCell german = ChartCell::day(fourth_of_october);
    use_language(Language::english);
    EXPECT_TRUE(german.shown.startsWith("4. Okt")) << german.shown.toStdString();
    EXPECT_EQ(german.copied, "2024-10-04");
}

TEST_F(FramedChart, CopiesItsPictureAlsoWhileTheTableIsShown) {
    const auto colours_in = [](const QImage& picture) {
        std::set<QRgb> colours;
        for (int y = 0; y < picture.height(); y += 2)
            for (int x = 0; x < picture.width(); x += 2) colours.insert(picture.pixel(x, y));
        return colours.size();
    };
    click(window, "stages_copy_picture");
    const QImage chart_shown = QGuiApplication::clipboard()->image();
    ASSERT_FALSE(chart_shown.isNull());
    EXPECT_GE(chart_shown.width(), chart->width());
    EXPECT_GT(chart_shown.height(), chart->height()) << "with its title";
    EXPECT_GT(colours_in(chart_shown), 8U);
    click(window, "stages_as_table");
    QGuiApplication::clipboard()->clear();
    click(window, "stages_copy_picture");
    const QImage table_shown = QGuiApplication::clipboard()->image();
    EXPECT_EQ(table_shown.size(), chart_shown.size());
    EXPECT_GT(colours_in(table_shown), 8U);
    EXPECT_TRUE(frame->shows_table());
}

TEST_F(FramedChart, PartIsChosenByClickAndByKeys) {
    QSignalSpy chosen(chart, &FigureChart::part_chosen);
    QTest::mouseClick(chart, Qt::LeftButton, {}, chart->place_of("1").center().toPoint());
    ASSERT_EQ(chosen.count(), 1);
    EXPECT_EQ(chosen[0][0].toString(), "1");
    chart->setFocus();
    QTest::keyClick(chart, Qt::Key_Down);
    EXPECT_EQ(chart->accessibleDescription(), "B begun: 0 (0 %)");
    QTest::keyClick(chart, Qt::Key_Down);
    QTest::keyClick(chart, Qt::Key_Return);
    ASSERT_EQ(chosen.count(), 2);
    EXPECT_EQ(chosen[1][0].toString(), "2");
    // Who is behind it takes the chart's place, is what is copied, and leads back to the chart.
    frame->show_behind("A done: 1 person", {{{"Person"}}, {{{ChartCell::words("Cyd")}, "p3 "}}});
    EXPECT_EQ(find<QLabel>(window, "stages_caption")->text(), "A done: 1 person");
    click(window, "stages_copy_data");
    EXPECT_EQ(clipboard(), "Person\nCyd\n");
    // The chart's own values change below it: what is behind the part stays.
    chart->show_figure(three_steps(), two_rows("Amy"), "4 people", "nobody");
    EXPECT_EQ(find<QTableWidget>(window, "stages_table")->item(0, 0)->text(), "Cyd");
    click(window, "stages_as_table");
    EXPECT_FALSE(sees(window, "stages_caption"));
    click(window, "stages_as_table");
    EXPECT_EQ(find<QTableWidget>(window, "stages_table")->item(0, 0)->text(), "Amy");
}

TEST_F(FramedChart, KeysAreNamedAndAPartThatTheyChooseIsHeardAndShown) {
    EXPECT_TRUE(chart->toolTip().contains("Arrow keys"));
    EXPECT_EQ(chart->accessibleDescription(), "4 people " + chart->toolTip());
    const Heard heard;
    chart->setFocus();
    QTest::keyClick(chart, Qt::Key_Down);
    EXPECT_EQ(Heard::lines(), QStringList{"A begun: 4 (100 %)"});
    EXPECT_EQ(QToolTip::text(), "A begun: 4 (100 %)");
    // Held, Enter does not open what it has just shown.
    QSignalSpy chosen(chart, &FigureChart::part_chosen);
    for (int i = 0; i < 3; ++i) {
        QKeyEvent enter(QEvent::KeyPress, Qt::Key_Return, Qt::NoModifier, QString(), i > 0);
        QApplication::sendEvent(chart, &enter);
    }
    EXPECT_EQ(chosen.count(), 1);
}

TEST_F(FramedChart, AnEmptyFigureSaysSoAndHasNothingToChoose) {
    chart->show_figure(FunnelFigure(), {}, "4 people", "nobody");
    EXPECT_EQ(chart->accessibleDescription(), "nobody");
    chart->setFocus();
    for (const auto key : {Qt::Key_Down, Qt::Key_Return, Qt::Key_Up}) QTest::keyClick(chart, key);
    click(window, "stages_as_table");
    click(window, "stages_copy_data");
    click(window, "stages_copy_picture");
    EXPECT_EQ(find<QTableWidget>(window, "stages_table")->rowCount(), 0);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
