// SPDX-License-Identifier: GPL-3.0-or-later
// Pages whose reading grows with the store: the window answers while they read, and shows what was read then.
#include <QComboBox>
#include <QFile>
#include <QTemporaryDir>

#include "database/records/recorder.h"
#include "tests/ui/held_work.h"
#include "tests/ui/screens.h"

namespace fulcrum::ui::window_test {
namespace {

class ReadingPages : public Screens {
  protected:
    void open_as(Role role) {
        open(QSize(1280, 800));
        sign_in(role);
    }
    void record_cut_off() {
        const database::Session& tara = sessions.at(Role::trainee);
        database::AttemptMeta meta;
        meta.person_id = tara.person_id();
        meta.task_id = "A2";
        meta.mode = AttemptMode::assessed;
        meta.device = "test";
        meta.variant = meta.fidelity = "standard";
        meta.scene = "a2_targets.json";
        meta.program_version = "0.1.0-test";
        database::Recorder recorder(services.store()->path(), tara, meta, {});
        database::AttemptResult result;
        result.state = AttemptState::interrupted;
        result.duration_s = result.wall_s = 1;
        result.state_hash = "00ff";
        recorder.finish(result);
    }
    void type_list(const QString& file) {
        auto* path = find<QLineEdit>(*window, "import_path");
        bring(*path);
        type(*window, "import_path", file);
        click(*window, "import_look");
    }
};

TEST_F(ReadingPages, AttemptsListWhoWasCutOffAgainAndAgainAfterTheTable) {
    for (int i = 0; i < 3; ++i) record_cut_off();
    open_as(Role::educator);
    HeldWork held;
    go_to_now("rail_attempts");
    EXPECT_EQ(find<QTableWidget>(*window, "attempts_table")->rowCount(), 3);
    EXPECT_FALSE(sees(*window, "cut_off_attempts")) << "every attempt is read for it";
    held.release();
    settle();
    EXPECT_TRUE(sees(*window, "cut_off_series"));
    {
        HeldWork again;
        go_to_now("rail_attempts");
        go_to_now("rail_cohort");
        window->context().sign_out();
    }
    settle();
    EXPECT_TRUE(error_shown().isEmpty()) << error_shown().toStdString();
}

TEST_F(ReadingPages, TheAuditLogIsShownBeforeItsKindsAreKnown) {
    open_as(Role::administrator);
    HeldWork held;
    go_to_now("rail_audit");
    auto* kinds = find<QComboBox>(*window, "audit_kind");
    EXPECT_EQ(kinds->count(), 1);
    EXPECT_GT(find<QTableWidget>(*window, "audit_table")->rowCount(), 3);
    held.release();
    settle();
    const int row = kinds->findData("person.create");
    ASSERT_GT(row, 0);
    kinds->setCurrentIndex(row);
    go_to("rail_people");
    go_to("rail_audit");
    EXPECT_EQ(kinds->currentData().toString(), "person.create") << "the choice stays";
}

TEST_F(ReadingPages, AListOfPeopleIsReadInTheBackgroundAndTheLastOneCounts) {
    open_as(Role::administrator);
    go_to("rail_people");
    const QTemporaryDir folder;
    const auto write = [&](const char* name, const QByteArray& rows) {
        QFile list(folder.filePath(QString::fromLatin1(name)));
        EXPECT_TRUE(list.open(QIODevice::WriteOnly));
        list.write("login,name,role\n" + rows);
        return list.fileName();
    };
    const QString one = write("one.csv", "anna,Anna Example,trainee\n"),
                  two = write("two.csv", "berta,Berta Example,trainee\ncleo,Cleo Example,trainee\n");
    {
        HeldWork held;
        type_list(one);
        EXPECT_FALSE(sees(*window, "import_table"));
        click(*window, "cancel_job");
        type_list(one);
        type_list(two);
        held.release();
        settle();
    }
    auto* table = find<QTableWidget>(*window, "import_table");
    ASSERT_EQ(table->rowCount(), 2);
    EXPECT_EQ(table->item(0, 1)->text(), "berta");
    HeldWork held;
    type_list(one);
    EXPECT_FALSE(sees(*window, "import_table")) << "of the list before";
    window->context().sign_out();
    held.release();
    settle();
    EXPECT_TRUE(error_shown().isEmpty()) << error_shown().toStdString();
}

}  // namespace
}  // namespace fulcrum::ui::window_test
