// SPDX-License-Identifier: GPL-3.0-or-later
// The editor of the curriculum by keyboard: values that it shows rounded stay as they are in the file until
// somebody changes them, and no key that is pressed once too often publishes or takes a step back.
#include <gtest/gtest.h>

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListWidget>
#include <QSlider>
#include <optional>

#include "database/records/people.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/four_people.h"
#include "tests/ui/hands.h"
#include "ui/dashboards/curriculum_page.h"
#include "ui/shell/main_window.h"

namespace fulcrum::ui::window_test {
namespace {

constexpr double fine_bound = 0.000253, third = 1.0 / 3;

class CurriculumValues : public ::testing::Test {
  protected:
    CurriculumValues() {
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
        educator.emplace(make_four_people(*services.store()).at(database::Role::educator));
    }
    ~CurriculumValues() override { apply_theme(*qApp, Theme::light); }
    /// Those that no field shows whole.
    void use_fine_values() {
        Curriculum curriculum = services.curriculum();
        for (CurriculumTask& task : curriculum.tasks) {
            if (task.task == "A2") {
                task.rule.kind = PassRuleKind::lc_cusum;
                task.rule.p0 = 0.075;
                task.rule.p1 = 0.225;
                task.rule.h = 2.125;
            }
            if (task.task != "C4") continue;
            task.remedies.at(0).bound = fine_bound;
            task.remedies.at(1).bound = third;
            RatingRule rating = task.ratings.value_or(RatingRule());
            if (rating.form.empty()) rating.form = "gas";
            rating.lowest_mean = third;
            task.ratings = rating;
        }
        services.set_curriculum(curriculum);
    }
    void open() {
        window.resize(1280, 900);
        window.show();
        ASSERT_TRUE(QTest::qWaitForWindowExposed(&window));
        window.start();
        window.context().set_session(*educator);
        click(window, "rail_curriculum");
        page = static_cast<CurriculumPage*>(window.current_page());
        tasks = find<QListWidget>(window, "curriculum_tasks");
    }
    void choose(const char* task) {
        for (int row = 0; row < tasks->count(); ++row)
            if (tasks->item(row)->data(Qt::UserRole).toString() == task) tasks->setCurrentRow(row);
    }
    const CurriculumTask& drafted(const char* task) { return *page->draft().find(task); }
    void pick(const char* name, int row) {
        auto* box = find<QComboBox>(window, name);
        box->setCurrentIndex(row);
        emit box->activated(row);
    }

    FakeServices services;
    std::optional<database::Session> educator;
    MainWindow window{services};
    CurriculumPage* page = nullptr;
    QListWidget* tasks = nullptr;
};

TEST_F(CurriculumValues, ABoundThatIsOnlyLookedAtKeepsAllItsDigits) {
    use_fine_values();
    open();
    choose("C4");
    choose_tab(window, "curriculum_tabs", "Remedies");
    auto* list = find<QListWidget>(window, "remedies_list");
    auto* bound = find<QDoubleSpinBox>(window, "remedy_bound");
    list->setCurrentRow(0);
    EXPECT_EQ(bound->value(), fine_bound) << "it is shown whole";
    // Another field of the same remedy is changed.
    auto* kind = find<QComboBox>(window, "remedy_kind");
    for (int row = 0; row < list->count() && row < 2; ++row) {
        list->setCurrentRow(row);
        pick("remedy_kind", kind->findData(static_cast<int>(RemedyKind::replay)));
    }
    EXPECT_EQ(drafted("C4").remedies[0].kind, RemedyKind::replay);
    EXPECT_EQ(drafted("C4").remedies[0].bound, fine_bound);
    EXPECT_EQ(drafted("C4").remedies[1].bound, third);
    // What is typed counts.
    list->setCurrentRow(1);
    bound->setFocus();
    bound->selectAll();
    QTest::keyClicks(bound, "0.25");
    EXPECT_EQ(drafted("C4").remedies[1].bound, 0.25);
    list->setCurrentRow(0);
    EXPECT_EQ(bound->value(), fine_bound);
}

TEST_F(CurriculumValues, AMeanAndTheNumbersOfARuleStayUntilTheyAreMoved) {
    use_fine_values();
    open();
    choose("C4");
    choose_tab(window, "curriculum_tabs", "Ratings");
    const bool blind = drafted("C4").ratings->blind;
    auto* box = find<QAbstractButton>(window, "ratings_blind");
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Space);
    EXPECT_NE(drafted("C4").ratings->blind, blind);
    EXPECT_EQ(drafted("C4").ratings->lowest_mean, third);

    choose("A2");
    choose_tab(window, "curriculum_tabs", "Pass rule");
    auto* limit = find<QSlider>(window, "rule_limit");
    limit->setFocus();
    QTest::keyClick(limit, Qt::Key_Right);
    EXPECT_NEAR(drafted("A2").rule.h, 2.2, 1e-9);
    EXPECT_EQ(drafted("A2").rule.p0, 0.075);
    EXPECT_EQ(drafted("A2").rule.p1, 0.225);
    EXPECT_EQ(limit->accessibleDescription(), "2.2") << "not its steps";
    auto* acceptable = find<QSlider>(window, "rule_acceptable");
    acceptable->setFocus();
    QTest::keyClick(acceptable, Qt::Key_Right);
    EXPECT_NEAR(drafted("A2").rule.p0, 0.09, 1e-9);
    EXPECT_EQ(drafted("A2").rule.p1, 0.225);
    EXPECT_NEAR(drafted("A2").rule.h, 2.2, 1e-9);
}

TEST_F(CurriculumValues, EnterInAFieldNeitherPublishesNorSaves) {
    open();
    QTemporaryDir folder;
    choose("A2");
    auto* limit = find<QSlider>(window, "rule_limit");
    limit->setFocus();
    QTest::keyClick(limit, Qt::Key_Right);
    EXPECT_EQ(find<QLabel>(window, "curriculum_why_not")->text(), "Give a reason.")
        << "seen, not a tip alone";
    const std::string before = services.curriculum().name();
    type(window, "curriculum_path", folder.filePath("draft.json"));
    QTest::keyClick(find<QLineEdit>(window, "curriculum_path"), Qt::Key_Return);
    EXPECT_FALSE(QFileInfo::exists(folder.filePath("draft.json")));
    type(window, "curriculum_reason", "Easier to reach");
    EXPECT_FALSE(sees(window, "curriculum_why_not"));
    for (int i = 0; i < 3; ++i) QTest::keyClick(find<QLineEdit>(window, "curriculum_reason"), Qt::Key_Return);
    EXPECT_EQ(services.curriculum().name(), before);
    auto* publish = find<QAbstractButton>(window, "curriculum_publish");
    ASSERT_TRUE(publish->isEnabled());
    publish->setFocus();
    QTest::keyClick(publish, Qt::Key_Return);
    EXPECT_NE(services.curriculum().name(), before) << "the button itself has the focus";
}

TEST_F(CurriculumValues, AtTheTopUpDoesNotHandTheKeyboardToDown) {
    open();
    tasks->setCurrentRow(1);
    const std::string moved = page->draft().tasks[1].task;
    auto* up = find<QAbstractButton>(window, "task_up");
    up->setFocus();
    QTest::keyClick(up, Qt::Key_Return);
    EXPECT_EQ(page->draft().tasks[0].task, moved);
    EXPECT_EQ(window.focusWidget(), tasks);
    QTest::keyClick(window.focusWidget(), Qt::Key_Return);
    EXPECT_EQ(page->draft().tasks[0].task, moved);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
