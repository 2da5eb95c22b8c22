// SPDX-License-Identifier: GPL-3.0-or-later
// A site's tissue values, set on the educator's page or by command: later attempts are performed, replayed
// and scored with them.
#include <gtest/gtest.h>

#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/live/performance.h"
#include "app/services/application.h"
#include "app/services/program.h"
#include "assessment/assets/assets.h"
#include "assessment/metrics/statement_words.h"
#include "assessment/scoring/benchmark.h"
#include "database/records/tissues.h"
#include "database/scoring/site_tissues.h"
#include "sim_core/numerics/input_error.h"
#include "tests/app/access_programme.h"
#include "tests/support/german_locale.h"
#include "tests/support/own_folder.h"
#include "tests/support/support.h"
#include "tests/ui/hands.h"
#include "ui/language/language.h"
#include "ui/shell/main_window.h"

namespace fulcrum::app::program_test {
namespace {

using namespace fulcrum::ui;
using namespace fulcrum::ui::window_test;

constexpr Role asking_roles[] = {Role::trainee, Role::educator, Role::director, Role::administrator};
/// The table is not cut off at its right edge.
bool shown_whole(const QTableWidget& table) {
    const QAbstractItemView& view = table;
    const int last = table.columnCount() - 1;
    return table.horizontalHeader()->length() <= table.viewport()->width() &&
           view.sizeHintForColumn(last) <= table.columnWidth(last);
}

const TissueValues tough{{"areolar", {{"penetrate_n", 0.11}}}};

class SiteTissue : public ::testing::Test {
  protected:
    SiteTissue() : store(*programme.store) {}
    void set(const TissueValues& values, const std::string& why) {
        const int seen = Tissues(store).in_force(*programme.educator, "B2").version;
        set_site_tissues(store, *programme.educator, "B2", seen, values, why);
    }
    AccessProgramme programme;
    const Store& store;
};

TEST_F(SiteTissue, AnAttemptIsPerformedAndReplayedInTheTissueItBeganIn) {
    set(tough, "as in our patients");
    const Session& station = programme.session("station");
    PerformRequest request;
    request.loaded = load_site_task(store, station, {"B2"});
    EXPECT_EQ(request.loaded.scene.tissues[0].cutting->penetrate, 0.11);
    request.operator_level = OperatorLevel::expert;
    request.seed = 7;
    request.keep_going = [](double time) { return time < 14; };
    AttemptMeta meta = attempt_meta(request.loaded, request.seed, AttemptMode::practice,
                                    DeviceClass::synthetic, "synthetic operator", {});
    meta.person_id = programme.synthetic.person;
    Recorder recorder(programme.path, station, meta);
    const Performed performed = perform(request, &recorder, {});
    ASSERT_TRUE(std::any_of(performed.record.events.begin(), performed.record.events.end(),
                            [](const Event& event) { return event.kind == EventKind::cut_advance; }))
        << "the values affect cutting only";

    set({{"areolar", {{"penetrate_n", 0.2}, {"static_friction_n", 0.2}}}}, "tougher still");
    const Attempts attempts(store);
    const AttemptSummary summary = attempts.read(station, recorder.attempt_id());
    const LoadedTask recorded = load_recorded(attempts, station, summary);
    EXPECT_EQ(recorded.scene.tissues[0].cutting->penetrate, 0.11);
    AttemptEngine engine(recorded.scene, recorded.task, summary.meta.seed);
    const ReplayOutcome replayed = replay_record(engine, performed.record);
    EXPECT_TRUE(replayed.identical) << "from " << replayed.first_divergence_s;
    EXPECT_EQ(replayed.state_hash, performed.outcome.state_hash);

    const LoadedTask shipped = load_task_and_scene("B2");
    AttemptEngine other(shipped.scene, shipped.task, summary.meta.seed);
    EXPECT_FALSE(replay_record(other, performed.record).identical) << "the values change the forces";
    EXPECT_EQ(load_site_task(store, station, {"B2"}).scene.tissues[0].cutting->penetrate, 0.2);
}

TEST_F(SiteTissue, LimitsMadeInOtherTissueDoNotScoreAnAttempt) {
    const LoadedTask own = load_task_and_scene("B2");
    const Limits shipped = limits_for(own.task, own.scene, DeviceClass::haptic);
    ASSERT_TRUE(shipped.set);
    EXPECT_EQ(shipped.comparable(), &*shipped.set);
    EXPECT_TRUE(site_tissues(store, *programme.educator, "B2").limits_notes.empty());
    set(tough, "as in our patients");
    const LoadedTask here = load_site_task(store, *programme.educator, {"B2"});
    const Limits other = limits_for(here.task, here.scene, DeviceClass::haptic);
    const Statement why = other.not_comparable;
    EXPECT_EQ(other.comparable(), nullptr);
    EXPECT_EQ(other.name(), shipped.name());
    EXPECT_NE(words_of(why).find("areolar: penetrate_n 0.11, there 0.04"), std::string::npos)
        << words_of(why);
    EXPECT_EQ(site_tissues(store, *programme.educator, "B2").limits_notes.at(0).why, why);
    BenchmarkSet built_here = *shipped.set;
    built_here.cutting = cutting_values(here.scene);
    EXPECT_EQ(parse_benchmark(benchmark_to_json(built_here).dump(), "set").cutting, built_here.cutting);

    TaskDefinition task = own.task;
    task.gates.resize(1);
    ASSERT_EQ(task.gates[0].kind, GateKind::benchmark);
    ScoreInput input{task, {}};
    input.why_no_benchmark = why;
    const Score score = score_attempt(input);
    EXPECT_FALSE(score.passed);
    EXPECT_NE(words_of(score.not_scored_because).find("cutting parameters differ"), std::string::npos)
        << words_of(score.not_scored_because);
}

/// A copy of the assets that a test may change, as long as it lives.
class OwnAssets {
  public:
    OwnAssets() {
        std::filesystem::copy(fulcrum::test::source_path("assets"), folder_.path(),
                              std::filesystem::copy_options::recursive);
        qputenv("FULCRUM_ASSETS", QByteArray::fromStdString(folder_.path().string()));
    }
    ~OwnAssets() { before_.isNull() ? qunsetenv("FULCRUM_ASSETS") : qputenv("FULCRUM_ASSETS", before_); }
    OwnAssets(const OwnAssets&) = delete;
    OwnAssets& operator=(const OwnAssets&) = delete;

  private:
    QByteArray before_ = qgetenv("FULCRUM_ASSETS");
    fulcrum::test::OwnFolder folder_;
};

TEST_F(SiteTissue, TheClassesOfDevicesWhoseLimitsAreFromOtherTissueAreNamed) {
    const OwnAssets assets;
    set(tough, "as in our patients");
    const CuttingValues here = cutting_values(load_site_task(store, *programme.educator, {"B2"}).scene);
    const auto make_in = [](const char* name, const CuttingValues& tissue) {
        const std::string file = asset_path("benchmarks/" + std::string(name) + ".json");
        BenchmarkSet made = load_benchmark(file);
        made.cutting = tissue;
        std::ofstream(file) << benchmark_to_json(made).dump(2);
    };
    const auto named = [&] {
        std::vector<DeviceClass> classes;
        const SiteTissues site = site_tissues(store, *programme.educator, "B2");
        for (const LimitsNote& one : site.limits_notes) classes.push_back(one.device_class);
        return classes;
    };
    EXPECT_EQ(named(), (std::vector<DeviceClass>{DeviceClass::haptic, DeviceClass::tracked}));
    make_in("B2-tracked", here);
    EXPECT_EQ(named(), std::vector<DeviceClass>{DeviceClass::haptic});
    make_in("B2-tracked", {});
    make_in("B2", here);
    EXPECT_EQ(named(), std::vector<DeviceClass>{DeviceClass::tracked});
    make_in("B2-tracked", here);
    EXPECT_TRUE(named().empty());
    std::filesystem::remove(asset_path("benchmarks/B2-tracked.json"));
    EXPECT_TRUE(named().empty()) << "a set that is not there fits no other tissue either";
}

TEST_F(SiteTissue, EducatorsSetValuesOnTheirPageAndTheBriefingStatesIt) {
    programme.store.reset();
    const auto services = make_services(programme.folder.path().toStdString());
    MainWindow window(*services);
    window.resize(1280, 800);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    window.start();
    window.context().set_session(*programme.educator);
    click(window, "rail_tissues");
    auto* state = find<QLabel>(window, "tissue_state");
    EXPECT_TRUE(state->text().contains("scene's values"));
    auto* table = find<QTableWidget>(window, "tissue_table");
    ASSERT_GE(table->rowCount(), 3);
    const auto* tasks = find<QListWidget>(window, "tissue_tasks");
    EXPECT_LE(tasks->sizeHintForColumn(0), tasks->viewport()->width()) << "titles are shown whole";
    EXPECT_TRUE(shown_whole(*table));

    type(window, "value_areolar_penetrate_n", "much");
    click(window, "save_tissues");
    EXPECT_TRUE(
        find<QLabel>(window, "message_text")->text().contains("is not a number. Enter a number above 0"));
    type(window, "value_areolar_penetrate_n", "50");
    type(window, "tissue_reason", "as in our patients");
    click(window, "save_tissues");
    const QString refusal = find<QLabel>(window, "message_text")->text();
    EXPECT_TRUE(refusal.contains("/tissues/areolar/cutting/penetrate_n")) << refusal.toStdString();
    EXPECT_TRUE(refusal.contains("at most 20")) << refusal.toStdString();
    type(window, "value_areolar_penetrate_n", "0.11");
    type(window, "tissue_reason", " ");
    click(window, "save_tissues");
    EXPECT_TRUE(find<QLabel>(window, "message_text")->text().contains("no reason was given"));
    EXPECT_FALSE(sees(window, "tissue_versions")) << "a sentence says that there is none";

    type(window, "tissue_reason", "as in our patients");
    QTest::keyClick(find<QLineEdit>(window, "tissue_reason"), Qt::Key_Return);
    EXPECT_FALSE(state->text().contains("version 1")) << "Enter in a field saves nothing";
    click(window, "save_tissues");
    EXPECT_TRUE(state->text().contains("version 1")) << state->text().toStdString();
    const QString limits = find<QLabel>(window, "tissue_limits")->text();
    EXPECT_TRUE(limits.contains("there 0.04") && limits.contains("--device-class haptic") &&
                limits.contains("--device-class tracked"))
        << limits.toStdString();
    EXPECT_EQ(find<QTableWidget>(window, "tissue_versions")->rowCount(), 1);
    EXPECT_TRUE(shown_whole(*find<QTableWidget>(window, "tissue_versions")));
    keep_picture(window, "tissues");
    EXPECT_EQ(Tissues(*services->store()).in_force(*programme.educator, "B2").values, tough)
        << "values equal to the scene's are not stored";

    window.context().set_session(programme.session("ann"));
    EXPECT_FALSE(sees(window, "rail_tissues"));
    emit window.context().briefing_wanted("B2");
    const QString note = find<QLabel>(window, "tissue_note")->text();
    EXPECT_TRUE(note.contains("version 1") && note.contains("not scored")) << note.toStdString();
    keep_picture(window, "tissues_briefing");
    emit window.context().briefing_wanted("A2");
    EXPECT_FALSE(sees(window, "tissue_note"));

    window.context().set_session(programme.session("director"));
    click(window, "rail_tissues");
    EXPECT_TRUE(find<QLineEdit>(window, "value_areolar_penetrate_n")->isReadOnly());
    EXPECT_FALSE(sees(window, "save_tissues"));

    window.context().set_session(*programme.educator);
    click(window, "rail_tissues");
    type(window, "tissue_reason", "back");
    click(window, "scene_tissues");
    EXPECT_TRUE(find<QLabel>(window, "tissue_state")->text().contains("scene's values"));
    EXPECT_EQ(find<QTableWidget>(window, "tissue_versions")->rowCount(), 2);
    EXPECT_FALSE(sees(window, "tissue_limits"));
    window.context().sign_out();
}

TEST_F(SiteTissue, VersionsNameTheirParametersInTheLanguageInUse) {
    set(tough, "as in our patients");
    // The second key as after an update that took it out of the scenes; the store does not check that.
    Tissues(store).set(*programme.educator, "B2", 1,
                       {{"areolar", {{"energy_factor", 0.5}, {"old_key", 2.0}}}}, "measured again");
    programme.store.reset();
    const auto services = make_services(programme.folder.path().toStdString());
    MainWindow window(*services);
    window.resize(1280, 800);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    window.start();
    window.context().set_session(*programme.educator);
    constexpr int values_column = 3;
    const auto values = [&](int row) {
        auto* versions = find<QTableWidget>(window, "tissue_versions");
        return versions->rowCount() > row ? versions->item(row, values_column)->text().toStdString() : "none";
    };
    click(window, "rail_tissues");
    EXPECT_EQ(values(0), "areolar, Fraction of these forces with energy on: 0.5; areolar, old_key: 2");
    EXPECT_EQ(values(1), "areolar, Force across the tissue to break through: 0.11 N");
    EXPECT_TRUE(shown_whole(*find<QTableWidget>(window, "tissue_versions")));
    window.set_language(Language::german);
    click(window, "rail_tissues");
    EXPECT_EQ(values(1), "lockeres Bindegewebe, Kraft quer zum Gewebe bis zum Durchbruch: 0,11 N");
    window.set_language(Language::english);
    window.context().sign_out();
}

TEST_F(SiteTissue, ValuesThatNoLongerFitTheSceneAreShownAndReset) {
    // Below the scene's dynamic_friction_n, as after an update that raised it; the store does not check that.
    Tissues(store).set(*programme.educator, "B2", 0, {{"areolar", {{"static_friction_n", 0.01}}}},
                       "before the update");
    EXPECT_THROW(load_site_task(store, *programme.educator, {"B2"}), InputError);
    const SiteTissues site = site_tissues(store, *programme.educator, "B2");
    EXPECT_EQ(site.version, 1);
    EXPECT_TRUE(site.differ);
    EXPECT_NE(site.unusable.words().find("dynamic_friction_n is above static_friction_n"), std::string::npos)
        << site.unusable.words();
    ASSERT_GE(site.values.size(), 2U);
    EXPECT_EQ(site.values[1].key, "static_friction_n");
    EXPECT_EQ(site.values[1].value, 0.01);
    EXPECT_EQ(site.values[1].scene, 0.02);

    programme.store.reset();
    const auto services = make_services(programme.folder.path().toStdString());
    MainWindow window(*services);
    window.resize(1024, 740);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    window.start();
    window.context().set_session(*programme.educator);
    click(window, "rail_tissues");
    EXPECT_TRUE(find<QLabel>(window, "tissue_trouble")
                    ->text()
                    .contains("dynamic_friction_n is above static_friction_n"));
    EXPECT_FALSE(sees(window, "message_text"));
    keep_picture(window, "tissues_unusable");
    type(window, "tissue_reason", "back");
    click(window, "scene_tissues");
    EXPECT_FALSE(sees(window, "tissue_trouble"));
    EXPECT_NO_THROW(load_site_task(*services->store(), *programme.educator, {"B2"}));
    window.context().sign_out();
}

TEST_F(SiteTissue, ATaskThatLostAllTissueToCutIsListedUntilItsValuesAreReset) {
    // A2 has nothing to cut, as after an update that took it out.
    Tissues(store).set(*programme.educator, "A2", 0, {{"areolar", {{"penetrate_n", 0.1}}}},
                       "before the update");
    EXPECT_THROW(load_site_task(store, *programme.educator, {"A2"}), InputError);
    programme.store.reset();
    const auto services = make_services(programme.folder.path().toStdString());
    MainWindow window(*services);
    window.resize(1280, 800);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    window.start();
    window.context().set_session(*programme.educator);
    click(window, "rail_tissues");
    auto* tasks = find<QListWidget>(window, "tissue_tasks");
    ASSERT_NE(tasks, nullptr);
    const auto listed = [&] { return tasks->findItems("A2", Qt::MatchStartsWith); };
    ASSERT_EQ(listed().size(), 1);
    tasks->setCurrentItem(listed().front());
    EXPECT_TRUE(find<QLabel>(window, "tissue_trouble")->text().contains("No attempt at this task can begin"));
    EXPECT_FALSE(sees(window, "tissue_table")) << "there is no value to set";
    EXPECT_FALSE(find<QPushButton>(window, "save_tissues")->isEnabled());
    keep_picture(window, "tissues-lost");
    type(window, "tissue_reason", "back");
    QTest::keyClick(find<QLineEdit>(window, "tissue_reason"), Qt::Key_Return);
    EXPECT_TRUE(sees(window, "tissue_trouble")) << "nothing was saved";
    click(window, "scene_tissues");
    EXPECT_FALSE(sees(window, "tissue_trouble"));
    EXPECT_NO_THROW(load_site_task(*services->store(), *programme.educator, {"A2"}));
    window.current_page()->enter();
    EXPECT_TRUE(listed().empty());
    window.context().sign_out();
}

TEST_F(SiteTissue, TheHeadOfTheSitesColumnIsWholeInLargeGermanText) {
    programme.store.reset();
    const auto services = make_services(programme.folder.path().toStdString());
    MainWindow window(*services);
    window.resize(1024, 768);
    window.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
    window.start();
    window.set_language(Language::german);
    window.set_text_size(200);
    window.context().set_session(*programme.educator);
    QCoreApplication::processEvents();
    choose_page(window, "rail_tissues");
    constexpr int site_column = 3;
    auto* table = find<QTableWidget>(window, "tissue_table");
    ASSERT_NE(table, nullptr);
    const QTableWidgetItem* head = table->horizontalHeaderItem(site_column);
    ASSERT_EQ(head->text().toStdString(), "An diesem Standort");
    QFont bold = table->horizontalHeader()->font();
    bold.setBold(true);
    EXPECT_GT(table->columnWidth(site_column), QFontMetrics(bold).horizontalAdvance(head->text()));
    keep_picture(window, "tissues-german");
    window.set_text_size(100);
    use_language(Language::english);
    window.context().sign_out();
}

TEST_F(SiteTissue, TheCommandLineReadsAndSetsAsTheTableSays) {
    // In a locale with decimal commas numbers still have a decimal point.
    const fulcrum::test::GermanLocale german;
    ASSERT_TRUE(german.in_force()) << "localedef cannot make de_DE: install the package locales";
    programme.store.reset();
    const std::string password_file = programme.folder.filePath("password.txt").toStdString();
    QFile out(QString::fromStdString(password_file));
    ASSERT_TRUE(out.open(QIODevice::WriteOnly));
    out.write(database::test::password);
    out.close();
    const auto run = [&](std::vector<std::string> words, Role role) {
        if (role != Role::station)
            words.insert(words.end(), {"--as", AccessProgramme::login_of(role), "--role", role_name(role),
                                       "--password-file", password_file});
        words.insert(words.end(), {"--db", programme.path, "--json"});
        std::ostringstream output;
        std::streambuf* const before = std::cout.rdbuf(output.rdbuf());
        std::string refused;
        try {
            EXPECT_EQ(run_command(words), 0);
        } catch (const std::exception& error) {
            refused = error.what();
        }
        std::cout.rdbuf(before);
        return std::pair(refused, output.str());
    };
    for (const Role role : all_roles) {
        const auto [no_read, read] = run({"tissues", "B2"}, role);
        EXPECT_EQ(no_read.empty(), expected_scope(Operation::read_tissues, role) != Scope::none)
            << role_name(role);
        const auto [no_set, after] = run(
            {"tissues", "B2", "--set", "areolar.penetrate_n=0.11", "--reason", "as in our patients"}, role);
        EXPECT_EQ(no_set.empty(), expected_scope(Operation::set_tissues, role) != Scope::none)
            << role_name(role);
        if (!no_set.empty()) continue;
        const nlohmann::json document = nlohmann::json::parse(after);
        EXPECT_EQ(document["version"], 1);
        EXPECT_EQ(document["comparable"], false);
        EXPECT_EQ(document["not_comparable_classes"][1]["device_class"], "tracked");
        EXPECT_EQ(document["history"][0]["reason"], "as in our patients");
        EXPECT_EQ(document["values"][0]["value"], 0.11);
    }
    const std::pair<std::vector<std::string>, const char*> bad[] = {
        {{"tissues", "B2", "--set", "areolar.penetrate_n=50", "--reason", "x"}, "at most 20"},
        {{"tissues", "B2", "--set", "bone.penetrate_n=1", "--reason", "x"}, "use one of areolar"},
        {{"tissues", "B2", "--set", "areolar.penetrate_n=0.2"}, "no reason"},
        {{"tissues", "B2", "--set", "areolar.penetrate_n", "--reason", "x"}, "write TISSUE.KEY=NUMBER"},
        {{"tissues", "B2", "--set", "areolar.penetrate_n=nan", "--reason", "x"}, "write TISSUE.KEY=NUMBER"},
        {{"tissues", "B2", "--set", "areolar.penetrate_n=0.11", "--reason", "x"}, "in force already"},
        {{"tissues", "Z9"}, "no task"},
    };
    for (const auto& [words, hint] : bad) {
        const std::string refused = run(words, Role::educator).first;
        EXPECT_NE(refused.find(hint), std::string::npos) << refused;
        EXPECT_NE(refused.find(';'), std::string::npos) << refused;
    }
    EXPECT_EQ(run({"tissues", "B2", "--scene-values", "--reason", "back"}, Role::educator).first, "");
}

}  // namespace
}  // namespace fulcrum::app::program_test
