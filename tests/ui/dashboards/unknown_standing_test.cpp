// SPDX-License-Identifier: GPL-3.0-or-later
// People whose version of the curriculum is not at this station: their standing is not known, and nothing
// shows it as locked.
#include <QComboBox>
#include <QPainter>
#include <QTableView>
#include <QTableWidget>

#include "database/records/recorder.h"
#include "tests/ui/screens.h"
#include "ui/dashboards/cohort_grid.h"

namespace fulcrum::ui::window_test {
namespace {

database::PersonStandings with_a_locked_task(const char* id, const char* name, bool not_here) {
    database::PersonStandings person;
    person.person_id = person.login = id;
    person.name = name;
    person.curriculum = not_here ? "rectal@77" : "rectal@3";
    person.not_here = not_here;
    person.tasks.resize(1);
    person.tasks[0].standing.task = "A2";
    return person;
}

QImage picture_of_cell(const QTableView& view, const QModelIndex& index) {
    QImage image(120, 32, QImage::Format_ARGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    QStyleOptionViewItem option;
    option.initFrom(&view);
    option.rect = image.rect();
    option.state = QStyle::State_Enabled;
    view.itemDelegate()->paint(&painter, option, index);
    painter.end();
    return image;
}

TEST(UnknownStandings, AreNoPadlocksInTheGridAndHaveTheirWords) {
    apply_theme(*qApp, Theme::light);
    database::CohortTable table;
    table.standings = {with_a_locked_task("1", "Abe", true), with_a_locked_task("2", "Zoe", false)};
    CohortGrid grid;
    grid.show_table(table, {"A2 · Targeting"});
    const QAbstractItemModel& model = *grid.view()->model();
    ASSERT_EQ(model.rowCount(), 2);
    const QModelIndex unknown = model.index(0, 1), locked = model.index(1, 1);
    const QString words =
        "Abe, A2 · Targeting: not known here. The curriculum rectal@77 is not at this station.";
    EXPECT_EQ(unknown.data(Qt::ToolTipRole).toString(), words);
    EXPECT_EQ(unknown.data(Qt::AccessibleTextRole).toString(), words);
    EXPECT_EQ(locked.data(Qt::ToolTipRole).toString(), "Zoe, A2 · Targeting: locked.");
    EXPECT_NE(picture_of_cell(*grid.view(), unknown), picture_of_cell(*grid.view(), locked));
    bool explained = false;
    for (const QWidget* part : grid.findChildren<QWidget*>())
        explained = explained || part->accessibleDescription().endsWith(", not known here");
    EXPECT_TRUE(explained) << "the sign is among those that are explained";
    const auto choose = [&](const char* name, int index) {
        auto* box = grid.findChild<QComboBox*>(name);
        box->setCurrentIndex(index);
        emit box->activated(index);
    };
    choose("grid_order", 1);
    EXPECT_EQ(model.index(0, 0).data().toString(), "Zoe") << "how much Abe has done is not known";
    choose("grid_standing", 1 + static_cast<int>(Standing::locked));
    ASSERT_EQ(model.rowCount(), 1);
    EXPECT_EQ(model.index(0, 0).data().toString(), "Zoe");
}

class UnknownInTheTable : public Screens {};

TEST_F(UnknownInTheTable, CellsSayIt) {
    database::AttemptMeta meta;
    meta.person_id = sessions.at(Role::trainee).person_id();
    meta.task_id = "A2";
    meta.mode = AttemptMode::practice;
    meta.device_class = DeviceClass::mouse_keyboard;
    meta.device = "mouse and keyboard";
    meta.variant = "standard";
    meta.fidelity = "standard";
    meta.scene = "a2_targets.json";
    meta.program_version = "test";
    meta.curriculum = "rectal@77";
    database::AttemptResult result;
    result.state = AttemptState::completed;
    database::Recorder(services.store()->path(), sessions.at(Role::trainee), meta).finish(result);
    open(QSize(1280, 800));
    sign_in(Role::director);
    go_to("rail_cohort");
    auto* views = find<QTabWidget>(*window, "cohort_views");
    views->setCurrentIndex(views->count() - 1);
    auto* table = find<QTableWidget>(*window, "cohort_table");
    ASSERT_EQ(table->rowCount(), 1);
    const QTableWidgetItem* cell = table->item(0, 1);
    ASSERT_NE(cell, nullptr);
    EXPECT_TRUE(cell->text().startsWith("? ")) << cell->text().toStdString();
    EXPECT_TRUE(cell->toolTip().contains("not known here. The curriculum rectal@77 is not at this station."))
        << cell->toolTip().toStdString();
    EXPECT_EQ(cell->data(Qt::AccessibleTextRole).toString(), cell->toolTip());
    EXPECT_TRUE(sees(*window, "unknown_note"));
}

}  // namespace
}  // namespace fulcrum::ui::window_test
