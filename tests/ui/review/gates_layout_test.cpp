// SPDX-License-Identifier: GPL-3.0-or-later
// The table of gates shows the full source of each limit.
#include <gtest/gtest.h>

#include <QApplication>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>

#include "tests/ui/painted_words.h"
#include "ui/language/language.h"
#include "ui/review/attempt_model.h"
#include "ui/review/gates_card.h"
#include "ui/style/palette.h"

namespace fulcrum::ui::window_test {
namespace {

TEST(GatesLayout, ShowsTheFullSourceOfALimit) {
    apply_theme(*qApp, Theme::light);
    const std::vector<std::string> sources = {
        "Training limit of this task, provisional: half of the cut within half a millimetre of the plane",
        "Training limit of this task, provisional: tension in the band for half of the cutting time",
        "A circumferential margin of 1 mm or less is positive",
        "Training limit of this task, provisional: seven of ten activations in view, in the tissue to be "
        "divided and 2 mm clear of the nerves"};
    AttemptModel model;
    model.score.emplace();
    for (const std::string& source : sources) {
        database::GateRow gate;
        gate.metric = "duration";
        gate.value = 0.313;
        gate.unit = "mm";
        gate.limit = 0.5;
        gate.limit_source = source;
        gate.passed = true;
        model.score->gates.push_back(gate);
    }
    for (const int width : {760, 880, 940, 1005, 1120, 1400}) {
        GatesCard card;
        card.resize(width, 900);
        card.open(model);
        card.show();
        QCoreApplication::processEvents();
        auto* table = card.findChild<QTableWidget*>(QStringLiteral("gates_table"));
        ASSERT_NE(table, nullptr);
        WordsDevice device(table->viewport()->size());
        table->viewport()->render(&device, {}, {}, QWidget::DrawChildren);
        if (const QString folder = qEnvironmentVariable("FULCRUM_PICTURES"); !folder.isEmpty())
            card.grab().save(folder + QStringLiteral("/gates-%1.png").arg(width));
        QString painted;
        for (const PaintedWords& line : device.words()) painted += line.words.trimmed() + QLatin1Char(' ');
        EXPECT_FALSE(painted.contains(QStringLiteral("…"))) << width << ": " << painted.toStdString();
        // A narrow table has no column for them: they follow it.
        const auto* below = card.findChild<QLabel*>(QStringLiteral("gates_sources"));
        ASSERT_NE(below, nullptr);
        EXPECT_NE(below->isVisible(), !table->isColumnHidden(table->columnCount() - 1)) << width;
        EXPECT_LE(table->horizontalHeader()->length(), table->viewport()->width()) << width;
        if (below->isVisible()) painted = below->text();
        for (const std::string& source : sources)
            EXPECT_TRUE(painted.contains(QString::fromStdString(source)))
                << width << ": " << painted.toStdString();
    }
}

// The field decides, not a word of the source.
TEST(GatesLayout, MarksALimitAsProvisionalByItsField) {
    AttemptModel model;
    model.score.emplace();
    for (const bool provisional : {true, false}) {
        database::GateRow gate;
        gate.metric = "time";
        gate.value = 60;
        gate.unit = "s";
        gate.limit = 90;
        gate.limit_source = "Confirmed, no longer provisional";
        gate.passed = true;
        gate.provisional = provisional;
        model.score->gates.push_back(gate);
    }
    GatesCard card;
    card.open(model);
    const auto* table = card.findChild<QTableWidget*>(QStringLiteral("gates_table"));
    ASSERT_NE(table, nullptr);
    const int column = table->columnCount() - 1;
    EXPECT_EQ(table->item(0, column)->text(),
              QStringLiteral("provisional: Confirmed, no longer provisional"));
    EXPECT_EQ(table->item(1, column)->text(), QStringLiteral("Confirmed, no longer provisional"));
}

TEST(GatesLayout, ExplainsAGateInTheReadersLanguage) {
    AttemptModel model;
    model.score.emplace();
    database::GateRow gate;
    gate.metric = "path_len";
    model.score->gates.push_back(gate);
    use_language(Language::german);
    GatesCard card;
    card.open(model);
    use_language(Language::english);
    const auto* table = card.findChild<QTableWidget*>(QStringLiteral("gates_table"));
    ASSERT_NE(table, nullptr);
    EXPECT_EQ(table->item(0, 0)->toolTip().toStdString(), "Wie weit sich die Instrumentenspitze bewegt hat.");
}

}  // namespace
}  // namespace fulcrum::ui::window_test
