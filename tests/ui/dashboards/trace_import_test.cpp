// SPDX-License-Identifier: GPL-3.0-or-later
// An educator imports a trace in the window: what was understood is shown before it is stored, what is wrong
// is said with its row, and nobody else is offered it. FULCRUM_PICTURES=FOLDER stores the card.
#include <QTableWidget>

#include "database/records/external_attempts.h"
#include "tests/ui/trace_files.h"
#include "ui/language/language.h"
#include "ui/page/background_job.h"

namespace fulcrum::ui::window_test {
namespace {

class TraceImport : public Screens {
  protected:
    TraceImport() {
        use_language(Language::english);  // with its plurals
        write_jigsaws(file("suturing.txt").toStdString());
        write_perktutor(file("needle.xml").toStdString());
    }
    QString file(const char* name) const { return folder.filePath(QString::fromLatin1(name)); }
    void open_card() {
        sign_in(Role::educator);
        go_to("rail_attempts");
        click(*window, "show_trace_import");
        settle();
        ASSERT_TRUE(sees(*window, "trace_import_card"));
    }
    void read(const char* name, const char* mapping) {
        read_trace_in(*window, file(name), mapping);
        settle();
    }
    QString words(const char* label) {
        for (QLabel* one : window->findChildren<QLabel*>(QString::fromLatin1(label)))
            if (one->isVisible()) return one->text();
        return {};
    }
    int attempts() {
        database::AttemptFilter filter;
        filter.task_id = "external-suturing";
        return static_cast<int>(
            database::Attempts(*services.store()).list(sessions.at(Role::educator), filter).size());
    }
    void choose_person() {
        auto* people = find<QComboBox>(*window, "trace_person");
        ASSERT_EQ(people->count(), 2) << "the trainee of the cohort";
        people->setCurrentIndex(1);
    }
    QTemporaryDir folder;
};

TEST_F(TraceImport, ShowsWhatWasUnderstoodThenStoresIt) {
    open({1280, 800});
    for (const Theme theme : {Theme::light, Theme::dark}) {
        window->set_theme(theme);
        open_card();
        keep("trace-import-empty");
        read("needle.xml", "perktutor.json");
        EXPECT_EQ(words("trace_problem"), "");
        const QString summary = words("trace_summary"), notes = words("trace_notes");
        for (const char* part : {"230 samples", "50 Hz", "0:05.0", "metrics have a value"})
            EXPECT_TRUE(summary.contains(QLatin1String(part))) << summary.toStdString();
        EXPECT_TRUE(notes.contains("Not read: ReferenceToRAS.")) << notes.toStdString();
        EXPECT_TRUE(notes.contains("1 stretch of more than 0.1 s has no sample")) << notes.toStdString();
        auto* columns = find<QTableWidget>(*window, "trace_columns");
        ASSERT_EQ(columns->rowCount(), 6);
        EXPECT_EQ(columns->item(0, 0)->text(), "left.px");
        EXPECT_EQ(columns->item(0, 1)->text(), "m");
        EXPECT_EQ(columns->item(0, 2)->text(), "ProbeToRAS.x");
        EXPECT_EQ(columns->item(0, 3)->text(), "mm");
        bring(*find<QPushButton>(*window, "trace_import"));
        keep("trace-import-preview");
        expect_fits("trace-import-preview");
        click(*window, "show_trace_import");  // away again
    }
    EXPECT_EQ(attempts(), 0) << "looking stores nothing";

    open_card();
    read("suturing.txt", "jigsaws.json");
    EXPECT_TRUE(words("trace_summary").contains("300 samples · 30 Hz"))
        << words("trace_summary").toStdString();
    click(*window, "trace_import");
    EXPECT_EQ(words("trace_problem"), "Choose the person who performed it.");
    choose_person();
    click(*window, "trace_import");
    settle();
    EXPECT_TRUE(words("trace_problem").contains("is not the name of an exercise"));
    find<QLineEdit>(*window, "trace_exercise")->setText("suturing");
    auto* performed = find<QLineEdit>(*window, "trace_performed");
    const QString written = performed->text();
    performed->setText("yesterday");
    click(*window, "trace_import");
    EXPECT_TRUE(words("trace_problem").contains("2026-11-20 14:05")) << words("trace_problem").toStdString();
    performed->setText(written);
    click(*window, "trace_import");
    settle();
    EXPECT_EQ(error_shown(), "");
    EXPECT_FALSE(sees(*window, "trace_import_card"));
    EXPECT_EQ(attempts(), 1);
    EXPECT_EQ(find<QTableWidget>(*window, "attempts_table")->item(0, 1)->text(), "External: suturing");

    // The same file again.
    click(*window, "show_trace_import");
    read("suturing.txt", "jigsaws.json");
    choose_person();
    find<QLineEdit>(*window, "trace_exercise")->setText("suturing");
    click(*window, "trace_import");
    settle();
    EXPECT_TRUE(words("trace_problem").contains("was imported for this person already"))
        << words("trace_problem").toStdString();
    EXPECT_EQ(attempts(), 1);
}

TEST_F(TraceImport, SaysWhatIsWrongWhereAndWhatToDo) {
    open({1024, 768});
    open_card();
    click(*window, "trace_look");
    EXPECT_EQ(words("trace_problem"), "Choose the file that was recorded.");
    const auto expect_problem = [&](const char* name, const char* mapping,
                                    std::initializer_list<const char*> parts) {
        read(name, mapping);
        for (const char* part : parts)
            EXPECT_TRUE(words("trace_problem").contains(QLatin1String(part)))
                << part << " in " << words("trace_problem").toStdString();
        EXPECT_FALSE(sees(*window, "trace_columns")) << "no preview of what could not be read";
    };
    expect_problem("nowhere.csv", "jigsaws.json", {"nowhere.csv"});
    expect_problem("suturing.txt", "rosma.json", {"1", "PSM1_position_x", "correct its name in the mapping"});
    expect_problem("suturing.txt", "perktutor.json",
                   {"does not begin with <TransformRecorderLog>", "PerkTutor"});
    expect_problem("needle.xml", "jigsaws.json", {":1", "check separator and columns"});
    std::ofstream(file("cut.txt").toStdString()) << "0.1 0.2\n";
    expect_problem("cut.txt", "jigsaws.json", {"2 cells, but column"});
    keep("trace-import-problem");
    std::ofstream(file("bad.json").toStdString()) << "{\"title\": \"x\"}";
    auto* formats = find<QComboBox>(*window, "trace_mapping");
    formats->addItem("bad.json", file("bad.json"));
    expect_problem("suturing.txt", "bad.json", {"bad.json", "columns"});
    // A changed path takes the message with it.
    find<QLineEdit>(*window, "trace_path")->setText(file("needle.xml"));
    EXPECT_EQ(words("trace_problem"), "");
}

TEST_F(TraceImport, CanBeStoppedAndLeftWhileItReads) {
    write_jigsaws(file("long.txt").toStdString(), 6000);
    open({1280, 800});
    open_card();
    read_trace_in(*window, file("long.txt"), "jigsaws.json");
    EXPECT_FALSE(find<QPushButton>(*window, "trace_look")->isEnabled());
    go_to("rail_limits");  // another page while it reads
    settle();
    go_to("rail_attempts");
    EXPECT_EQ(words("trace_summary"), "");
    EXPECT_TRUE(find<QPushButton>(*window, "trace_look")->isEnabled());
    EXPECT_EQ(error_shown(), "");
    read_trace_in(*window, file("long.txt"), "jigsaws.json");
    for (BackgroundJob* job : window->findChildren<BackgroundJob*>()) job->cancel();
    settle();
    EXPECT_EQ(words("trace_summary"), "");
    EXPECT_TRUE(find<QPushButton>(*window, "trace_look")->isEnabled());
    read("suturing.txt", "jigsaws.json");
    EXPECT_NE(words("trace_summary"), "");
}

TEST_F(TraceImport, IsOfferedToEducatorsAlone) {
    open({1280, 800});
    for (const Role role : {Role::trainee, Role::director, Role::educator}) {
        sign_in(role);
        go_to("rail_attempts");
        EXPECT_EQ(sees(*window, "show_trace_import"), role == Role::educator) << database::role_name(role);
        EXPECT_FALSE(sees(*window, "trace_import_card"));
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
