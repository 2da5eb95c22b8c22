// SPDX-License-Identifier: GPL-3.0-or-later
// An educator makes limits from experts' attempts with real events: chooses, builds, reads what was left out
// and who would pass, puts the set in force. With FULCRUM_PICTURES=FOLDER pictures are stored there.
#include "ui/dashboards/benchmark_page.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "assessment/metrics/registry.h"
#include "assessment/scoring/judged_limits.h"
#include "assessment/scoring/taken_over.h"
#include "database/rows/crypto.h"
#include "database/scoring/scoring.h"
#include "database/store/accepted_assets.h"
#include "database/store/audit.h"
#include "sim_core/scene/json_document.h"
#include "tests/ui/dashboards/building_limits.h"
#include "tests/ui/heard.h"
#include "ui/dashboards/limit_rows.h"
#include "ui/dashboards/limits_chart.h"
#include "ui/language/language.h"
#include "ui/shell/main_window.h"
#include "ui/style/text.h"

namespace fulcrum::ui::window_test {
namespace {

TEST_F(BuildingLimits, ASetIsBuiltReadAndPutInForce) {
    ASSERT_EQ(people()->rowCount(), expert_people);
    EXPECT_EQ(people()->item(0, 1)->text(), "6");
    EXPECT_EQ(people()->item(0, 2)->text(), "3") << "the familiarisation does not count";
    EXPECT_FALSE(find<QAbstractButton>(*window, "benchmark_build")->isEnabled()) << "nobody is chosen";
    choose_experts(expert_people);
    build();
    EXPECT_TRUE(label("benchmark_verdict").startsWith("✓ Usable. With k = "))
        << label("benchmark_verdict").toStdString();
    EXPECT_TRUE(label("benchmark_explained").contains("trainee1000 is left out"))
        << label("benchmark_explained").toStdString();
    EXPECT_TRUE(label("benchmark_explained").contains("failed by 3 of the experts' own attempts"));
    auto* passes = find<QTableWidget>(*window, "benchmark_passes");
    ASSERT_EQ(passes->rowCount(), 2);
    EXPECT_TRUE(passes->item(0, 0)->text().startsWith("A · in force"));
    EXPECT_TRUE(passes->item(1, 0)->text().startsWith("B · the new set"));
    auto* chart = dynamic_cast<LimitsChart*>(page->findChild<QWidget*>("limits_chart"));
    ASSERT_NE(chart, nullptr);
    ASSERT_FALSE(chart->gates().empty());
    EXPECT_EQ(chart->gates().front().limits.size(), 2U);
    EXPECT_EQ(chart->gates().front().values.size(), 60U);
    keep("light");
    bring(*passes);
    keep("passes-light");
    window->set_theme(Theme::dark);
    keep("passes-dark");
    window->set_theme(Theme::light);

    EXPECT_FALSE(find<QAbstractButton>(*window, "benchmark_put")->isEnabled()) << "a reason is missing";
    auto* note = find<QLineEdit>(*window, "benchmark_note");
    bring(*note);
    note->setFocus();
    QTest::keyClicks(note, "Ten surgeons of this site, spring 2026");
    click(*window, "benchmark_put");
    ASSERT_TRUE(sees(*window, "message_text"));
    ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    const BenchmarkSet made = load_benchmark(file().string());
    EXPECT_EQ(made.version, set.version + 1);
    EXPECT_FALSE(made.provisional);
    EXPECT_EQ(made.note, "Ten surgeons of this site, spring 2026");
    ASSERT_EQ(made.experts.size(), 10U);
    EXPECT_EQ(made.experts[0].attempts, 3);
    EXPECT_EQ(made.experts[0].familiarisation, 3);
    ASSERT_FALSE(made.levels.empty());
    EXPECT_EQ(made.levels[0].left_out, std::vector<std::string>{"trainee1000"});
    EXPECT_EQ(
        load_benchmark(
            (assets / "benchmarks" / "superseded" / ("A2@" + std::to_string(set.version) + ".json")).string())
            .version,
        set.version)
        << "what was in force before is kept";
    const database::AssetFile asset{"benchmarks/A2.json",
                                    database::sha256_hex(read_text_file(file().string(), 1U << 20U))};
    const database::AcceptedAssets accepted(*services->store());
    EXPECT_TRUE(accepted.unknown({asset}).empty());
    ASSERT_EQ(accepted.list().size(), 1U);
    EXPECT_EQ(accepted.list()[0].reason, made.note);
    EXPECT_EQ(accepted.list()[0].person_name, "Ed Educator");
    EXPECT_EQ(benchmark_in_force(made.key()).name(), "A2-site@" + std::to_string(made.version));
    EXPECT_FALSE(sees(*window, "benchmark_verdict")) << "it is done";

    // What the command makes of the same attempts.
    const LoadedTask loaded = load_site_task(*services->store(), *ed, TaskRequest{"A2", "", ""});
    std::vector<ExpertCandidate> experts =
        expert_candidates(*services->store(), *ed, task, {"A2", "standard", DeviceClass::haptic, "standard"});
    BenchmarkBuild same = build_benchmark(
        task,
        expert_request(loaded, DeviceClass::haptic, made.version,
                       *expert_attempts(*services->store(), *ed, loaded, DeviceClass::haptic, experts)));
    ASSERT_TRUE(same.set);
    same.set->note = made.note;
    EXPECT_EQ(benchmark_to_json(*same.set), benchmark_to_json(made));
}

TEST_F(BuildingLimits, NameTheLimitsOfTheTaskThatTheSetTakesOver) {
    EXPECT_FALSE(sees(*window, "benchmark_left")) << "the set in force is provisional as a whole";
    choose_experts(expert_people);
    build();
    const std::vector<ProvisionalLimit> limits = limits_to_take_over(task);
    ASSERT_EQ(limits.size(), 4U);
    const auto named = [&](const QString& shown, const ProvisionalLimit& limit) {
        return shown.contains(QStringLiteral("%1: at most %2")
                                  .arg(gate_name(limit.metric, limit.hand, limit.tissue),
                                       figure_with_unit(limit.limit, find_metric(limit.metric)->unit)));
    };
    for (const ProvisionalLimit& limit : limits)
        EXPECT_TRUE(named(label("benchmark_site"), limit)) << label("benchmark_site").toStdString();
    bring(*find<QWidget>(*window, "benchmark_site"));
    keep("site");
    auto* note = find<QLineEdit>(*window, "benchmark_note");
    bring(*note);
    note->setFocus();
    QTest::keyClicks(note, "Limits of ours");
    click(*window, "benchmark_put");
    ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    BenchmarkSet made = load_benchmark(file().string());
    EXPECT_EQ(provisional_words(made.taken_over), provisional_words(limits));
    for (const JudgedLimit& limit : judged_limits(task, &made)) EXPECT_FALSE(limit.provisional);
    EXPECT_FALSE(sees(*window, "benchmark_left"));
    database::AuditFilter filter;
    filter.kind = "asset.accept";
    const std::vector<database::AuditEntry> entries =
        database::Audit(*services->store())
            .entries(database::People(*services->store()).sign_in("administrator", "correct horse battery"),
                     filter);
    ASSERT_EQ(entries.size(), 1U);
    EXPECT_NE(entries[0].payload.find("f_max left at most 4.0 N"), std::string::npos) << entries[0].payload;

    // A newer program has another limit; a set from before limits were taken over.
    made.taken_over[0].limit += 1;
    std::ofstream(file()) << benchmark_text(made);
    choose_page(*window, "rail_limits");
    open();
    ASSERT_TRUE(sees(*window, "benchmark_left"));
    EXPECT_TRUE(named(label("benchmark_left"), limits[0])) << label("benchmark_left").toStdString();
    EXPECT_TRUE(label("benchmark_left").contains("changed by an update"));
    EXPECT_FALSE(named(label("benchmark_left"), limits[1]));
    keep("left");
    made.taken_over.clear();
    std::ofstream(file()) << benchmark_text(made);
    choose_page(*window, "rail_limits");
    open();
    for (const ProvisionalLimit& limit : limits) EXPECT_TRUE(named(label("benchmark_left"), limit));
    EXPECT_FALSE(label("benchmark_left").contains("changed by an update"));
}

TEST_F(BuildingLimits, OfSimulatedPeopleAreProvisionalAndTakeOverNothing) {
    choose_experts(expert_people);
    services->store()->connection().execute(
        "UPDATE person SET kind = 'synthetic' WHERE login LIKE 'trainee%'");
    build();
    EXPECT_TRUE(label("benchmark_verdict").startsWith("✓ Usable"))
        << label("benchmark_verdict").toStdString();
    EXPECT_TRUE(label("benchmark_site").startsWith("Provisional: these attempts are simulated."))
        << label("benchmark_site").toStdString();
    auto* note = find<QLineEdit>(*window, "benchmark_note");
    bring(*note);
    note->setFocus();
    QTest::keyClicks(note, "To try it out");
    click(*window, "benchmark_put");
    ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    const BenchmarkSet made = load_benchmark(file().string());
    EXPECT_EQ(made.version, set.version + 1);
    EXPECT_TRUE(made.provisional);
    EXPECT_TRUE(made.taken_over.empty());
    EXPECT_EQ(made.source.rfind("synthetic operators", 0), 0U) << made.source;
}

TEST_F(BuildingLimits, ASetThatAnUpdateMadeUselessIsBuiltAgain) {
    nlohmann::json outdated = benchmark_to_json(set);
    outdated["levels"][0]["metric_version"] = set.levels[0].metric_version + 1;
    std::ofstream(file()) << outdated.dump(1);
    choose_experts(expert_people);
    build();
    EXPECT_FALSE(sees(*window, "message_text"));
    EXPECT_TRUE(label("benchmark_verdict").startsWith("✓ Usable"))
        << label("benchmark_verdict").toStdString();
    auto* passes = find<QTableWidget>(*window, "benchmark_passes");
    ASSERT_EQ(passes->rowCount(), 1) << "nothing can be judged by the set in force";
    EXPECT_TRUE(passes->item(0, 0)->text().startsWith("A · the new set"));
    auto* note = find<QLineEdit>(*window, "benchmark_note");
    bring(*note);
    note->setFocus();
    QTest::keyClicks(note, "After the update");
    click(*window, "benchmark_put");
    ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    EXPECT_EQ(load_benchmark(file().string()).version, set.version + 1);
}

TEST_F(BuildingLimits, TooFewAreRefusedWithTheReasonAndNothingIsSaved) {
    choose_experts(2);
    EXPECT_TRUE(label("benchmark_count").contains("Chosen: 2, of them with at least 3 counted attempts: 2"));
    build();
    EXPECT_EQ(label("benchmark_verdict"), "✕ Refused: 2 experts where 8 are needed.");
    EXPECT_FALSE(sees(*window, "benchmark_put"));
    EXPECT_FALSE(sees(*window, "benchmark_passes"));
    keep("refused");
    EXPECT_EQ(load_benchmark(file().string()).version, set.version);
    // Another key has nobody; the result is gone.
    auto* devices = find<QComboBox>(*window, "benchmark_device");
    devices->setFocus();
    QTest::keyClick(devices, Qt::Key_End);
    ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    EXPECT_EQ(people()->rowCount(), 0);
    EXPECT_TRUE(label("benchmark_count").startsWith("Nobody has"));
    EXPECT_FALSE(sees(*window, "benchmark_verdict"));
}

TEST_F(BuildingLimits, ASetThatAnotherOneOvertookIsNotPutInForce) {
    choose_experts(expert_people);
    build();
    BenchmarkSet other = set;
    other.version = set.version + 5;
    std::ofstream(file()) << benchmark_text(other);
    auto* note = find<QLineEdit>(*window, "benchmark_note");
    bring(*note);
    note->setFocus();
    QTest::keyClicks(note, "Too late");
    QTest::keyClick(note, Qt::Key_Return);
    EXPECT_FALSE(sees(*window, "message_text")) << "Enter in a field puts nothing in force";
    click(*window, "benchmark_put");
    EXPECT_TRUE(label("message_text").contains("cannot follow it")) << label("message_text").toStdString();
    EXPECT_EQ(load_benchmark(file().string()).version, other.version);
    EXPECT_TRUE(database::AcceptedAssets(*services->store()).list().empty());
    EXPECT_EQ(find<QLineEdit>(*window, "benchmark_note")->text(), "Too late") << "the words stay";
    // A folder that cannot be written.
    build();
    std::filesystem::rename(assets / "benchmarks", assets / "away");
    std::ofstream(assets / "benchmarks") << "a file";
    bring(*note);
    click(*window, "benchmark_put");
    EXPECT_TRUE(label("message_text").contains("cannot be written")) << label("message_text").toStdString();
    EXPECT_TRUE(database::AcceptedAssets(*services->store()).list().empty());
    // It can be saved as a file instead, once.
    auto* path = find<QLineEdit>(*window, "benchmark_path");
    bring(*path);
    path->setFocus();
    QTest::keyClicks(path, QString::fromStdString((folder / "A2-new.json").string()));
    click(*window, "benchmark_save");
    EXPECT_EQ(load_benchmark((folder / "A2-new.json").string()).version, other.version + 1);
    click(*window, "benchmark_save");
    EXPECT_TRUE(label("message_text").contains("A2-new.json")) << "nothing is replaced silently";
}

TEST_F(BuildingLimits, CanBeStoppedAndLeft) {
    choose_experts(expert_people);
    bring(*find<QAbstractButton>(*window, "benchmark_build"));
    click(*window, "benchmark_build");
    if (!page->is_ready()) {
        click(*window, "cancel_job");
        EXPECT_TRUE(page->is_ready());
        EXPECT_FALSE(sees(*window, "benchmark_verdict"));
        EXPECT_TRUE(find<QAbstractButton>(*window, "benchmark_build")->isEnabled());
    }
    click(*window, "benchmark_build");
    choose_page(*window, "rail_limits");
    QTest::qWait(300);
    EXPECT_FALSE(sees(*window, "message_text"));
    open();
    EXPECT_FALSE(sees(*window, "benchmark_verdict"));
    EXPECT_EQ(people()->item(0, 0)->checkState(), Qt::Checked) << "what was chosen stays";
}

TEST_F(BuildingLimits, ThatWereNotReadDoNotSayThatNobodyHasAttempts) {
    const auto choose_again = [&] {
        auto* devices = find<QComboBox>(*window, "benchmark_device");
        devices->setFocus();
        QTest::keyClick(devices, Qt::Key_End);
        QTest::keyClick(devices, Qt::Key_Home);
        ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    };
    services->store()->connection().execute("ALTER TABLE attempt_void RENAME TO attempt_void_away");
    choose_again();
    EXPECT_EQ(people()->rowCount(), 0);
    EXPECT_EQ(label("benchmark_count"), "The attempts were not read. Choose the task again to read them.");
    services->store()->connection().execute("ALTER TABLE attempt_void_away RENAME TO attempt_void");
    choose_again();
    EXPECT_EQ(people()->rowCount(), expert_people);
    EXPECT_TRUE(label("benchmark_count").startsWith("Chosen: 0")) << label("benchmark_count").toStdString();
}

TEST_F(BuildingLimits, AreForEducatorsOnly) {
    window->context().set_session(*director);
    EXPECT_TRUE(wait_for([&] { return sees(*window, "rail_limits"); }));
    EXPECT_FALSE(sees(*window, "rail_benchmark"));
    BenchmarkSet next = set;
    ++next.version;
    EXPECT_THROW(
        publish_benchmark(*services->store(), *director, (assets / "benchmarks").string(), next, "why"),
        database::AccessDenied);
    EXPECT_THROW(publish_benchmark(*services->store(), *ed, (assets / "benchmarks").string(), next, "  "),
                 database::StoreError);
    EXPECT_EQ(load_benchmark(file().string()).version, set.version);
    EXPECT_FALSE(std::filesystem::exists(assets / "benchmarks" / "superseded"));
}

TEST_F(BuildingLimits, FitTheSmallestWindowWithLargeTextInBothThemesAndLanguages) {
    struct Look {
        Theme theme;
        Language language;
        const char* name;
    };
    for (const Look& look : {Look{Theme::light, Language::english, "large-light"},
                             Look{Theme::dark, Language::german, "large-dark-german"}}) {
        emit window->context().theme_wanted(look.theme);
        window->set_language(look.language);
        window->set_text_size(200);
        open();
        choose_experts(expert_people);
        build();
        for (const char* name :
             {"benchmark_task", "benchmark_fidelity", "benchmark_people", "benchmark_build",
              "benchmark_passes", "benchmark_note", "benchmark_put", "benchmark_save"}) {
            auto* widget = find<QWidget>(*window, name);
            bring(*widget);
            const QRect place(widget->mapTo(window.get(), QPoint()), widget->size());
            EXPECT_TRUE(place.left() >= 0 && place.right() <= window->width()) << look.name << " " << name;
            EXPECT_FALSE(spoken_name(widget).isEmpty()) << name;
            EXPECT_FALSE(widget->visibleRegion().isEmpty()) << look.name << " " << name;
        }
        keep(look.name);
    }
}

}  // namespace
}  // namespace fulcrum::ui::window_test
