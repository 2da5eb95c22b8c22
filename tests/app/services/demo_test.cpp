// SPDX-License-Identifier: GPL-3.0-or-later
// The delivered demonstration: *Look around* opens it at once, it is a good store with what the plan says,
// and every screen of each of its roles has something to show. FULCRUM_TEST_DEMONSTRATION=FILE tests another
// packed programme (`fulcrum lab demonstration -o FILE`) in its place; FULCRUM_PICTURES=FOLDER stores every
// screen, in the kinds of FULCRUM_PICTURES_AS.
#include "app/services/demo.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QLabel>
#include <QTemporaryDir>
#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "app/cli/installed_curriculum.h"
#include "app/lab/demonstration_plan.h"
#include "app/services/application.h"
#include "assessment/assets/assets.h"
#include "assessment/curriculum/concern.h"
#include "database/records/attempts.h"
#include "database/records/people.h"
#include "database/records/ratings.h"
#include "database/records/reviews.h"
#include "database/records/standings.h"
#include "sim_core/numerics/input_error.h"
#include "tests/support/processor_time.h"
#include "tests/ui/hands.h"
#include "tests/ui/picture_kinds.h"
#include "ui/page/background_job.h"
#include "ui/reports/certificate.h"
#include "ui/reports/report.h"
#include "ui/review/compare_page.h"
#include "ui/review/debrief_page.h"
#include "ui/review/replay_panel.h"
#include "ui/shell/main_window.h"
#include "ui/shell/page_table.h"
#include "ui/style/appearance.h"

namespace fulcrum::app {
namespace {

using database::Role;
using namespace ui::window_test;

/// There is nothing to test before the programme was made for the first time.
bool has_demonstration() {
    return !qEnvironmentVariableIsEmpty("FULCRUM_TEST_DEMONSTRATION") ||
           std::filesystem::exists(asset_path(demo_asset));
}

/// Unpacks the programme under test.
bool unpack_tested(const std::string& path, const ui::Progress& progress = {}) {
    const std::string other = qgetenv("FULCRUM_TEST_DEMONSTRATION").toStdString();
    return other.empty() ? unpack_demo(path, progress) : unpack_demo_file(other, path, progress);
}

/// The delivered demonstration as a store.
class DemonstrationStore : public ::testing::Test {
  protected:
    static void SetUpTestSuite() {
        folder_ = new QTemporaryDir;
        path_ = folder_->filePath("demo.db").toStdString();
        if (!has_demonstration()) {
            database::Store::create(path_, true);
            return;
        }
        const test::ProcessorTime timer;
        ASSERT_TRUE(unpack_tested(path_));
        unpacked_ms_ = timer.milliseconds();
    }
    static void TearDownTestSuite() { delete folder_; }
    void SetUp() override { ASSERT_TRUE(has_demonstration()) << demo_asset << " is missing"; }
    static QTemporaryDir* folder_;
    static std::string path_;
    static double unpacked_ms_;  // of processor time
    database::Store store{database::Store::open(path_)};
    database::Session station{store.station_session()};
    database::People people{store};
};
QTemporaryDir* DemonstrationStore::folder_ = nullptr;
std::string DemonstrationStore::path_;
double DemonstrationStore::unpacked_ms_ = 0;

TEST_F(DemonstrationStore, IsAtMostThirtyMegabytesAndOpensWithinThreeSeconds) {
    const std::string other = qgetenv("FULCRUM_TEST_DEMONSTRATION").toStdString();
    EXPECT_LE(std::filesystem::file_size(other.empty() ? asset_path(demo_asset) : other), 30'000'000U);
    EXPECT_LT(unpacked_ms_, 3000);
    EXPECT_EQ(store.found_schema(), database::Store::schema_version());
    for (const char* left : {".unpacking", ".unpacking-wal"})
        EXPECT_FALSE(std::filesystem::exists(path_ + left));
    const auto rights = std::filesystem::status(path_).permissions();
    EXPECT_EQ(rights & std::filesystem::perms::all,
              std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

TEST_F(DemonstrationStore, PassesTheCheck) {
    const database::CheckReport report = store.check(station);
    for (const database::CheckItem& item : report.items)
        EXPECT_TRUE(item.ok) << item.name << ": " << (item.problems.empty() ? "" : item.problems[0].words());
    EXPECT_TRUE(store.is_demo());
    EXPECT_FALSE(
        store.allowed(people.demo_session("demo-educator", Role::educator), database::Operation::comment));
}

TEST_F(DemonstrationStore, HasThePeopleAndTheWeeksOfThePlan) {
    std::map<Role, int> roles;
    for (const database::Person& person : people.list(station)) {
        EXPECT_EQ(person.kind, database::PersonKind::synthetic);
        for (const Role role : person.roles) ++roles[role];
    }
    EXPECT_EQ(roles[Role::trainee], 24);
    EXPECT_EQ(roles[Role::educator], 3);
    EXPECT_EQ(roles[Role::director], 1);
    database::AttemptFilter filter;
    filter.limit = -1;
    std::set<std::int64_t> weeks;
    std::set<std::string> trainees, tasks, with_trace;
    int without_trace = 0, voided = 0;
    const std::vector<database::AttemptSummary> all = database::Attempts(store).list(station, filter);
    EXPECT_GE(all.size(), 500U);
    EXPECT_LE(all.size(), 800U);
    for (const database::AttemptSummary& one : all) {
        EXPECT_GE(one.meta.started, demo_begin);
        weeks.insert((one.meta.started - demo_begin) / (7 * demo_day));
        trainees.insert(one.meta.person_id);
        tasks.insert(one.meta.task_id);
        voided += one.voided_at != 0 ? 1 : 0;
        if (one.meta.keep_trace) {
            with_trace.insert(one.meta.task_id);
            EXPECT_FALSE(database::Attempts(store).read_trace(station, one.meta.id).samples.empty());
        } else {
            ++without_trace;
        }
    }
    EXPECT_EQ(weeks.size(), 12U);
    EXPECT_EQ(*weeks.rbegin(), 11);
    EXPECT_EQ(trainees.size(), 24U);
    EXPECT_EQ(tasks.size(), 7U) << "every task of the curriculum was practised";
    EXPECT_GE(with_trace.size(), 6U);
    EXPECT_GT(without_trace, 400);
    EXPECT_GE(voided, 1);
    // Time resumes when the twelve weeks end, so that nobody has stopped because of the date of today.
    EXPECT_GT(store.now(), demo_begin + 83 * demo_day);
    EXPECT_LT(store.now(), demo_begin + 84 * demo_day);
}

TEST_F(DemonstrationStore, ShowsDifferentStandingsCurvesAndConcerns) {
    const Curriculum curriculum = installed_curriculum();
    std::map<Standing, int> standings;
    std::map<LearningKind, std::pair<double, int>> late;  // passes of the second half
    for (const DemoTrainee& trainee : demo_trainees()) {
        const database::Session session = people.demo_session(trainee.login, Role::trainee);
        const PersonRecord record =
            database::Standings(store).record(session, session.person_id(), curriculum);
        for (const TaskStanding& one : standing_of(record, store.now())) ++standings[one.standing];
        for (const CountedAttempt& one : record.attempts) {
            if (one.time < demo_begin + 42 * demo_day || one.time >= demo_begin + 70 * demo_day) continue;
            late[trainee.learning].first += one.passed ? 1 : 0;
            ++late[trainee.learning].second;
        }
    }
    // None is open: what is unlocked is recommended, and so attempted soon.
    for (const Standing one :
         {Standing::locked, Standing::attempted, Standing::passed, Standing::proficient, Standing::due})
        EXPECT_GT(standings[one], 0) << row_of(standing_names, one).name;
    const auto share = [&](LearningKind kind) { return late[kind].first / std::max(1, late[kind].second); };
    EXPECT_GT(share(LearningKind::fast), share(LearningKind::slow));
    EXPECT_GT(share(LearningKind::fast), share(LearningKind::plateau) + 0.2);
    EXPECT_EQ(late[LearningKind::stopped].second, 0);
}

TEST_F(DemonstrationStore, HasCommentsOfEachEducatorRatingsAndARequest) {
    std::map<std::string, int> comments;
    int ratings = 0;
    const database::Session director = people.demo_session(demo_director, Role::director);
    database::AttemptFilter filter;
    filter.limit = -1;
    for (const database::AttemptSummary& one : database::Attempts(store).list(director, filter)) {
        if (one.comments == 0) continue;
        for (const database::Comment& comment : database::Reviews(store).comments(director, one.meta.id))
            ++comments[comment.author_name];
        ratings += static_cast<int>(database::Ratings(store).of_attempt(director, one.meta.id).rows.size());
    }
    EXPECT_EQ(comments.size(), 3U);
    EXPECT_GE(ratings, 6);
    const auto requests = database::Attempts(store).correction_requests(director);
    EXPECT_TRUE(std::any_of(requests.begin(), requests.end(), [](const auto& one) { return !one.settled; }));
}

// With FULCRUM_REPORT_PAGE=FOLDER the reports are kept there, in both languages.
TEST_F(DemonstrationStore, PrintsItsReports) {
    const QTemporaryDir own;
    const QString kept = qEnvironmentVariable("FULCRUM_REPORT_PAGE");
    const QString folder = kept.isEmpty() ? own.path() : kept;
    const database::Session director = people.demo_session(demo_director, Role::director);
    std::vector<TaskDefinition> tasks;
    for (const std::string& id : task_ids()) tasks.push_back(load_task(task_file(id)));
    const Curriculum curriculum = installed_curriculum();
    database::AttemptFilter filter;
    filter.limit = -1;
    std::string cut, targets, cohort;
    for (const auto& one : database::Attempts(store).list(director, filter)) {
        if (one.meta.task_id == "C4" && one.meta.keep_trace) cut = one.meta.id;
        if (one.meta.task_id == "A2" && one.passed) targets = one.meta.id;
    }
    for (const database::Cohort& one : people.cohorts(director)) cohort = one.id;
    const std::string amara = people.demo_session("demo-amara", Role::trainee).person_id();
    const auto print = [&](const char* name, ui::ReportRequest request) {
        request.path = folder.toStdString() + "/" + name + "-" +
                       row_of(ui::languages, ui::language_in_use()).name + ".pdf";
        request.curriculum = &curriculum;
        EXPECT_EQ(ui::write_report(store, director, request, tasks, "1").size(), 1U) << name;
        EXPECT_GT(std::filesystem::file_size(request.path), 10'000U) << name;
    };
    for (const ui::Language language : {ui::Language::english, ui::Language::german}) {
        if (kept.isEmpty() && language != ui::Language::english) continue;
        ui::use_language(language);
        ui::ReportRequest request;
        request.person_id = amara;
        print("person", request);
        request = {};
        request.attempt_id = cut;
        print("attempt-c4", request);
        request.attempt_id = targets;
        print("attempt-a2", request);
        request = {};
        request.cohort_id = cohort;
        if (!kept.isEmpty()) print("cohort", request);  // a page of each person
        database::Certificate certificate;              // the demonstration awards none
        certificate.programme = "Department of Surgery, University Hospital";
        certificate.person_id = amara;
        certificate.person_name = "Amara Okafor";
        certificate.curriculum = "rectal@2";
        certificate.curriculum_title = curriculum.title;
        certificate.stage = "A";
        certificate.stage_title = "Instruments";
        for (const char* task : {"A1", "A2", "A3"}) certificate.tasks.push_back({task, demo_begin, false});
        certificate.completed_at = demo_begin;
        certificate.code = "7K2Q-9XWB-4TRM-0HJD";
        const std::string path =
            folder.toStdString() + "/certificate-" + row_of(ui::languages, language).name + ".pdf";
        ui::write_certificate(store, director, certificate, tasks, "1", path);
        EXPECT_GT(std::filesystem::file_size(path), 5'000U);
    }
    ui::use_language(ui::Language::english);
}

TEST(DemonstrationUnpacking, CanBeStoppedAndLeavesNothing) {
    ASSERT_TRUE(has_demonstration()) << demo_asset << " is missing";
    const QTemporaryDir folder;
    const std::string path = folder.filePath("new/demo.db").toStdString();
    for (const double at : {0.1, 0.4, 0.8}) {
        EXPECT_FALSE(unpack_tested(path, [&](double done, const std::string&) { return done < at; }));
        EXPECT_FALSE(std::filesystem::exists(path)) << at;
        EXPECT_FALSE(std::filesystem::exists(path + ".unpacking")) << at;
    }
    EXPECT_TRUE(unpack_tested(path));
    EXPECT_TRUE(unpack_tested(path)) << "replaces what is there";
}

/// The program's window on the demonstration.
class DemonstrationWindow : public ::testing::Test {
  protected:
    DemonstrationWindow() : services(make_services(folder.path().toStdString())) {
        if (!qEnvironmentVariableIsEmpty("FULCRUM_TEST_DEMONSTRATION"))
            unpack_tested(services->store_path(true));
    }
    void SetUp() override { ASSERT_TRUE(has_demonstration()) << demo_asset << " is missing"; }
    ~DemonstrationWindow() override { ui::apply_theme(*qApp, ui::Theme::light); }
    void open(QSize size) {
        window = std::make_unique<ui::MainWindow>(*services);
        window->resize(size);
        window->show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
    }
    void look_around() {
        click(*window, "look_around");
        ASSERT_TRUE(wait_for([&] { return sees(*window, "pick_demo_person"); }, 20000));
    }
    void settle() {
        EXPECT_TRUE(wait_for(
            [&] {
                QCoreApplication::processEvents();
                QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
                QCoreApplication::processEvents();
                return window->findChildren<ui::BackgroundJob*>().isEmpty();
            },
            60000));
    }
    void pick(const QString& name) {
        ASSERT_TRUE(wait_for([&] { return sees(*window, "pick_demo_person"); }));
        for (QAbstractButton* button : window->findChildren<QAbstractButton*>("pick_demo_person")) {
            if (!button->isVisible() || !button->text().startsWith(name)) continue;
            button->click();
            settle();
            return;
        }
        FAIL() << name.toStdString();
    }
    void expect_good(const QString& screen) {
        auto* line = window->findChild<QLabel*>("message_text");
        const bool error = line->isVisible() && line->parentWidget()->property("role").toString() == "error";
        EXPECT_FALSE(error) << screen.toStdString() << ": " << line->text().toStdString();
        const QString pictures = QString::fromLocal8Bit(qgetenv("FULCRUM_PICTURES"));
        if (pictures.isEmpty()) return;
        for (const auto* replay : window->findChildren<ui::ReplayPanel*>()) {
            if (!replay->isVisible()) continue;
            const bool drawn = wait_for([&] { return replay->shown_time() >= 0; }, 60000);
            EXPECT_TRUE(drawn) << screen.toStdString();
        }
        settle();
        QDir().mkpath(pictures);
        const PictureKind kind{window->size(), ui::current_theme(), ui::language_in_use(),
                               ui::text_percent()};
        window->grab().save(QStringLiteral("%1/demo-%2-%3.png").arg(pictures, screen, kind.name()));
    }
    void visit_rail(const QString& who) {
        for (const ui::PageEntry* entry : ui::pages_of(window->context())) {
            choose_page(*window, entry->name);
            settle();
            const QString screen = who + '-' + QString(entry->name).mid(5);
            expect_good(screen);
            auto* views = window->current_page()->findChild<QTabWidget*>("cohort_views");
            for (int i = 1; views != nullptr && i < views->count(); ++i) {
                views->setCurrentIndex(i);
                settle();
                expect_good(screen + '-' + QString::number(i));
            }
        }
    }
    void draw_briefings(const QString& who) {
        for (const char* task : {"A1", "A2", "A3", "B0", "B1", "B2", "B3", "C4"}) {
            emit window->context().briefing_wanted(QString::fromLatin1(task));
            settle();
            expect_good(who + "-briefing-" + task);
        }
    }
    /// An attempt of the session's people, with its trace or without.
    std::string attempt(bool with_trace) {
        database::AttemptFilter filter;
        filter.limit = -1;
        for (const auto& one :
             database::Attempts(window->context().store()).list(window->context().session(), filter))
            if (one.meta.keep_trace == with_trace && one.voided_at == 0) return one.meta.id;
        return {};
    }
    ui::DebriefPage& debrief(const std::string& id) {
        emit window->context().debrief_wanted(QString::fromStdString(id), -1);
        auto* page = static_cast<ui::DebriefPage*>(window->current_page());
        EXPECT_TRUE(wait_for([&] { return page->is_ready(); }, 60000));
        settle();
        return *page;
    }
    /// With its first choice, and the first step chosen as a part.
    void compare(const std::string& id) {
        emit window->context().compare_wanted(QString::fromStdString(id));
        auto* page = static_cast<ui::ComparePage*>(window->current_page());
        const auto ready = [&] { return page->is_ready(); };
        EXPECT_TRUE(wait_for(ready, 60000));
        auto* step = find<QComboBox>(*window, "compare_step");
        if (!step->isEnabled() || step->count() < 2) return;
        step->setFocus();
        QTest::keyClick(step, Qt::Key_Down);
        EXPECT_TRUE(wait_for(ready, 60000));
        settle();
    }
    QTemporaryDir folder;
    std::unique_ptr<ui::ApplicationServices> services;
    std::unique_ptr<ui::MainWindow> window;
};

TEST_F(DemonstrationWindow, LookAroundShowsItsPeopleWithinThreeSeconds) {
    open({1280, 800});
    const test::ProcessorTime timer;
    look_around();
    EXPECT_LT(timer.milliseconds(), 3000);
    expect_good("people");
    EXPECT_EQ(window->findChildren<QAbstractButton*>("pick_demo_person").size(), 6 + 3 + 1);
}

TEST_F(DemonstrationWindow, EveryScreenOfEachRoleOpens) {
    for (const PictureKind& kind :
         picture_kinds({{{1280, 800}, ui::Theme::light}, {{1280, 800}, ui::Theme::dark}})) {
        ui::use_language(kind.language);
        ui::apply_text_size(*qApp, kind.percent);
        ui::apply_theme(*qApp, kind.theme);
        open(kind.size);
        look_around();
        for (const char* name : {"Amara", "Dr Hanna", "Prof. Anna"}) {
            pick(name);
            const QString who = QString(name).section(' ', -1).toLower();
            visit_rail(who);
            const std::string kept = attempt(true), lost = attempt(false);
            ASSERT_FALSE(lost.empty());
            if (!kept.empty()) {
                debrief(kept);
                expect_good(who + "-debrief");
                compare(kept);
                expect_good(who + "-compare");
            }
            debrief(lost);
            expect_good(who + "-debrief-no-trace");
            if (who == "amara" && !qEnvironmentVariableIsEmpty("FULCRUM_PICTURES_AS")) draw_briefings(who);
            if (sees(*window, "menu"))
                choose_page(*window, "rail_switch_user");
            else
                click(*window, "switch_user");
        }
        window.reset();
    }
    ui::apply_text_size(*qApp, 100);
    ui::use_language(ui::Language::english);
}

TEST_F(DemonstrationWindow, DebriefSaysThatTheTraceWasNotKept) {
    open({1280, 800});
    look_around();
    pick("Dr Hanna");
    debrief(attempt(false));
    EXPECT_TRUE(sees(*window, "no_trace"));
    EXPECT_FALSE(sees(*window, "replay_block"));
    const std::string kept = attempt(true);
    ASSERT_FALSE(kept.empty());
    debrief(kept);
    EXPECT_FALSE(sees(*window, "no_trace"));
    EXPECT_TRUE(sees(*window, "replay_block"));
}

}  // namespace
}  // namespace fulcrum::app
