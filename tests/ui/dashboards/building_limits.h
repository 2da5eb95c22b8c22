// SPDX-License-Identifier: GPL-3.0-or-later
// The page *Build limits* of an educator on a programme with experts' attempts at A2, over a copy of the
// program's benchmark sets.
#pragma once

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QTableWidget>
#include <filesystem>
#include <memory>
#include <optional>

#include "assessment/scoring/benchmark.h"
#include "assessment/task/task.h"
#include "database/records/people.h"
#include "tests/database/expert_values.h"
#include "tests/database/large_programme.h"
#include "tests/support/own_folder.h"
#include "tests/support/support.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/dashboards/benchmark_page.h"
#include "ui/language/language.h"
#include "ui/shell/main_window.h"
#include "ui/style/text.h"

namespace fulcrum::ui::window_test {

inline constexpr int expert_people = 10, attempts_of_expert = 6;

class BuildingLimits : public ::testing::Test {
  protected:
    BuildingLimits() {
        apply_theme(*qApp, Theme::light);
        const std::filesystem::path source = test::source_path("assets");
        std::filesystem::create_directories(assets);
        for (const char* part : {"benchmarks", "tasks", "scenes", "curricula", "forms", "schemas"})
            std::filesystem::copy(source / part, assets / part, std::filesystem::copy_options::recursive);
        qputenv("FULCRUM_ASSETS", QByteArray::fromStdString(assets.string()));
        set = load_benchmark((assets / "benchmarks" / "A2.json").string());
        services = std::make_unique<FakeServices>();
        services->open_store(false);
        int written = 0;
        const auto programme = database::test::make_large_programme(
            *services->store(), expert_people, attempts_of_expert, 1, 7, {"A2"},
            [&](database::ScoreRow& score, Random& random) {
                // The first one is far from the others.
                const bool outlier = written++ / attempts_of_expert == 0;
                database::test::write_expert_values(task, set, (outlier ? 9 : 0) + random.uniform(-0.7, 0.7),
                                                    score);
            },
            task.version);
        director = programme.director;
        const database::People people(*services->store());
        const auto alma = people.sign_in("administrator", "correct horse battery");
        const auto made = people.create(alma, "ed", "Ed Educator", {database::Role::educator});
        ed = people.change_password(people.sign_in("ed", made.one_time_password), made.one_time_password,
                                    "a long password");
        people.set_educators(*director, programme.cohort, {ed->person_id()});
        window = std::make_unique<MainWindow>(*services);
        window->resize(1024, 740);
        window->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        QApplication::setActiveWindow(window.get());
        open();
    }
    ~BuildingLimits() override {
        window.reset();
        before.isNull() ? qunsetenv("FULCRUM_ASSETS") : qputenv("FULCRUM_ASSETS", before);
        use_language(Language::english);
        apply_theme(*qApp, Theme::light);
        apply_text_size(*qApp, 100);
    }
    void open() {
        window->context().set_session(*ed);
        // With large text the list of pages is behind a menu.
        ASSERT_TRUE(wait_for([&] { return sees(*window, "menu") || sees(*window, "rail_benchmark"); }));
        choose_page(*window, "rail_benchmark");
        page = static_cast<BenchmarkPage*>(window->current_page());
        auto* tasks = find<QComboBox>(*window, "benchmark_task");
        tasks->setFocus();
        QTest::keyClick(tasks, Qt::Key_Home);
        while (tasks->currentData().toString() != "A2") QTest::keyClick(tasks, Qt::Key_Down);
        ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    }
    QTableWidget* people() { return find<QTableWidget>(*window, "benchmark_people"); }
    /// The check marks of the first `count` lines, by keyboard.
    void choose_experts(int count) {
        QTableWidget* table = people();
        bring(*table);
        table->setFocus();
        for (int row = 0; row < count; ++row) {
            table->setCurrentCell(row, 0);
            QTest::keyClick(table, Qt::Key_Space);
            ASSERT_EQ(table->item(row, 0)->checkState(), Qt::Checked);
        }
    }
    void build() {
        bring(*find<QAbstractButton>(*window, "benchmark_build"));
        click(*window, "benchmark_build");
        ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    }
    QString label(const char* name) { return find<QLabel>(*window, name)->text(); }
    std::filesystem::path file() const { return assets / "benchmarks" / "A2.json"; }
    void keep(const QString& name) { keep_picture(*window, "benchmark-" + name); }

    test::OwnFolder folder;
    std::filesystem::path assets = folder / "assets";
    QByteArray before = qgetenv("FULCRUM_ASSETS");
    TaskDefinition task = load_task(test::source_path("assets/tasks/A2.json"));
    BenchmarkSet set;
    std::unique_ptr<FakeServices> services;
    std::optional<database::Session> director, ed;
    std::unique_ptr<MainWindow> window;
    BenchmarkPage* page = nullptr;
};

}  // namespace fulcrum::ui::window_test
