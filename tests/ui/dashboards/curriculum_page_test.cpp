// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the curriculum: its tasks and rules, what another rule would do, problems at their places. With
// FULCRUM_PICTURES=FOLDER pictures are stored there.
#include <QDoubleSpinBox>
#include <QFile>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTemporaryDir>

#include "assessment/curriculum/curriculum.h"
#include "tests/support/processor_time.h"
#include "tests/ui/dashboards/curriculum_view.h"
#include "ui/dashboards/pass_rule_designer.h"

namespace fulcrum::ui::window_test {
namespace {

TEST_F(CurriculumView, ShowsWhatTheRuleInForceDoes) {
    ASSERT_EQ(tasks->count(), static_cast<int>(services.curriculum().tasks.size()));
    choose("A2");
    EXPECT_FALSE(chart->curves().changed);
    for (std::size_t k = 0; k < designer_trainees.size(); ++k) {
        const OperatingPoint point = operating_point(rule_of("A2"), designer_trainees[k], designer_attempts);
        EXPECT_EQ(chart->curves().tried[k].back(), point.declared);
        const QString half = table->item(static_cast<int>(k), 4)->text();
        if (point.median_attempts) {
            EXPECT_EQ(half, QString::number(*point.median_attempts));
        } else {
            EXPECT_EQ(half, "> 60");
        }
    }
    keep("curriculum-light");
    window.set_theme(Theme::dark);
    keep("curriculum-dark");
    EXPECT_FALSE(find<QAbstractButton>(window, "curriculum_save")->isEnabled()) << "nothing to write";
}

TEST_F(CurriculumView, ARuleThatIsTriedIsDrawnWithTheOneInForceAndTakenBack) {
    choose("A2");
    const PassRule before = rule_of("A2");
    auto* kind = find<QComboBox>(window, "rule_kind");
    kind->setFocus();
    QTest::keyClick(kind, Qt::Key_Home);
    EXPECT_TRUE(chart->curves().changed);
    step("rule_passes", 10, Qt::Key_Left);
    // Two in a row, as one pass is never on two days: whoever passes every other attempt is nearly sure to be
    // declared within 30.
    EXPECT_NEAR(chart->curves().tried[2][29], 0.9979, 1e-4);
    EXPECT_TRUE(table->item(2, 3)->text().startsWith("99.8 %")) << table->item(2, 3)->text().toStdString();
    EXPECT_EQ(chart->curves().in_force[2].back(), operating_point(before, 0.5, designer_attempts).declared);
    EXPECT_TRUE(tasks->currentItem()->text().contains("tried: 2 passes in a row"));
    keep("curriculum-tried-light");
    window.set_theme(Theme::dark);
    keep("curriculum-tried-dark");
    window.set_theme(Theme::light);
    window.resize(1280, 1000);
    keep("curriculum-tried-large");
    window.resize(1024, 740);

    choose("B1");
    EXPECT_FALSE(chart->curves().changed) << "another task has its own rule";
    choose("A2");
    EXPECT_TRUE(chart->curves().changed) << "what was tried is still there";
    click(window, "rule_restore");
    EXPECT_FALSE(chart->curves().changed);
    EXPECT_FALSE(tasks->currentItem()->text().contains("tried"));
}

TEST_F(CurriculumView, CurvesFollowASliderAtOnce) {
    choose("A2");
    auto* limit = find<QSlider>(window, "rule_limit");
    limit->setFocus();
    const test::ProcessorTime timer;
    step("rule_limit", 10, Qt::Key_Right);
    const double each = timer.milliseconds() / 10;
    RecordProperty("milliseconds_a_step", std::to_string(each));
    EXPECT_LT(each, 100);
    EXPECT_NEAR(window.findChild<PassRuleDesigner*>()->tried().h, rule_of("A2").h + 1, 1e-9);
}

TEST_F(CurriculumView, ShowsEachProblemAtItsPlaceAndWhatBlocksCannotBePublished) {
    auto* page = static_cast<CurriculumPage*>(window.current_page());
    const auto blocks = [&](CurriculumField field, std::size_t index) {
        return std::any_of(page->problems().begin(), page->problems().end(),
                           [&](const CurriculumProblem& one) {
                               return one.blocks && one.field == field && one.index == index;
                           });
    };
    EXPECT_FALSE(std::any_of(page->problems().begin(), page->problems().end(),
                             [](const CurriculumProblem& one) { return one.blocks; }))
        << "the curriculum in force";
    choose("A2");
    choose_tab(window, "curriculum_tabs", "Prerequisites");
    auto* after = find<QListWidget>(window, "task_after");
    QListWidgetItem* a3 = nullptr;
    for (int row = 0; row < after->count(); ++row)
        if (after->item(row)->data(Qt::UserRole).toString() == "A3") a3 = after->item(row);
    ASSERT_NE(a3, nullptr);
    after->setCurrentItem(a3);
    QTest::keyClick(after, Qt::Key_Space);  // A3 comes after A2: a cycle
    EXPECT_TRUE(blocks(CurriculumField::after, 1));
    EXPECT_TRUE(find<QLabel>(window, "needs_problems")->text().contains("A2 would unlock only after itself"));
    EXPECT_TRUE(tasks->currentItem()->text().contains("✕ 1 problem"));
    type(window, "curriculum_reason", "because");
    EXPECT_FALSE(find<QAbstractButton>(window, "curriculum_publish")->isEnabled());
    keep("curriculum-problems-light");
    window.set_theme(Theme::dark);
    keep("curriculum-problems-dark");
    window.set_theme(Theme::light);
    // The problem in the list leads to its place.
    choose("C4");
    auto* list = find<QListWidget>(window, "curriculum_problems");
    bring(*list);
    for (int row = 0; row < list->count(); ++row) {
        if (!list->item(row)->text().startsWith("A2, Prerequisites: ✕")) continue;
        list->setCurrentRow(row);
        QTest::keyClick(list, Qt::Key_Return);
    }
    EXPECT_EQ(tasks->currentItem()->data(Qt::UserRole).toString(), "A2");
    EXPECT_EQ(find<QTabWidget>(window, "curriculum_tabs")->currentIndex(), 1);
    auto* haptic = find<QAbstractButton>(window, "task_device_haptic");
    for (const char* name : {"task_device_haptic", "task_device_tracked", "task_device_mouse-keyboard"}) {
        auto* box = find<QAbstractButton>(window, name);
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Space);
    }
    EXPECT_FALSE(haptic->isChecked());
    EXPECT_TRUE(blocks(CurriculumField::devices, 1));
    auto* controller = find<QAbstractButton>(window, "task_device_controller");
    controller->setFocus();
    QTest::keyClick(controller, Qt::Key_Space);
    EXPECT_TRUE(find<QLabel>(window, "needs_problems")
                    ->text()
                    .contains("A2 has no benchmark for the class of devices controller"));
    EXPECT_TRUE(blocks(CurriculumField::devices, 1)) << "no class is left that is judged";
    click(window, "curriculum_discard");
    EXPECT_TRUE(blocks(CurriculumField::devices, 1)) << "nothing is discarded yet";
    click(window, "curriculum_discard_sure");
    EXPECT_FALSE(blocks(CurriculumField::after, 1));
    EXPECT_FALSE(find<QAbstractButton>(window, "curriculum_discard")->isEnabled());
}

TEST_F(CurriculumView, StagesAndRatingsAreEditedWithTheKeyboard) {
    auto* page = static_cast<CurriculumPage*>(window.current_page());
    choose_tab(window, "curriculum_tabs", "Stages");
    auto* stages = find<QTableWidget>(window, "stages_table");
    stages->setFocus();
    stages->setCurrentCell(0, 0);
    QTest::keyClick(stages, Qt::Key_F2);
    auto* editor = stages->viewport()->findChild<QLineEdit*>();
    ASSERT_NE(editor, nullptr);
    editor->selectAll();
    QTest::keyClicks(editor, "G");
    QTest::keyClick(editor, Qt::Key_Return);
    ASSERT_TRUE(wait_for([&] { return page->draft().stages[0].id == "G"; }, 5000));
    type(window, "curriculum_title", "Rectal surgery");
    EXPECT_EQ(page->draft().title, "Rectal surgery");
    EXPECT_EQ(page->draft().find("A2")->stage, "G") << "a stage that is renamed keeps its tasks";
    keep("curriculum-stages-light");
    choose("C4");
    choose_tab(window, "curriculum_tabs", "Ratings");
    auto* wanted = find<QAbstractButton>(window, "ratings_wanted");
    wanted->setFocus();
    QTest::keyClick(wanted, Qt::Key_Space);
    ASSERT_TRUE(page->draft().find("C4")->ratings.has_value());
    keep("curriculum-ratings-light");
    EXPECT_EQ(page->draft().find("C4")->ratings->lowest_mean, 3);
    const int before = tasks->count();
    choose("B2");
    click(window, "task_remove");
    EXPECT_EQ(tasks->count(), before - 1);
    EXPECT_TRUE(find<QAbstractButton>(window, "task_add")->isEnabled());
    EXPECT_TRUE(
        std::any_of(page->problems().begin(), page->problems().end(), [](const CurriculumProblem& one) {
            return one.field == CurriculumField::after && one.blocks;  // C4 opens after B2
        }));
}

TEST_F(CurriculumView, RemediesAreEditedAndAWrongOneOfADraftIsShownAtItsPlace) {
    auto* page = static_cast<CurriculumPage*>(window.current_page());
    choose("C4");
    choose_tab(window, "curriculum_tabs", "Remedies");
    auto* list = find<QListWidget>(window, "remedies_list");
    ASSERT_EQ(list->count(), 3);
    EXPECT_EQ(list->item(0)->text().replace(QChar(0x202f), QLatin1Char(' ')).toStdString(),
              "1.  Typical distance from the plane above 0.5 mm: practise B2 Traction and plane cutting");
    keep("curriculum-remedies-light");
    window.set_theme(Theme::dark);
    window.resize(1280, 1000);
    keep("curriculum-remedies-dark");
    window.resize(1024, 740);
    window.set_theme(Theme::light);
    const auto remedies = [&]() -> const std::vector<Remedy>& { return page->draft().find("C4")->remedies; };
    click(window, "remedy_add");
    ASSERT_EQ(remedies().size(), 4U);
    const auto pick = [&](const char* name, const QVariant& data) {
        auto* box = find<QComboBox>(window, name);
        const int row = box->findData(data);
        ASSERT_GE(row, 0) << name;
        box->setCurrentIndex(row);
        emit box->activated(row);
    };
    pick("remedy_metric", "bleed_ml");
    find<QDoubleSpinBox>(window, "remedy_bound")->setValue(20);
    pick("remedy_kind", static_cast<int>(RemedyKind::other_task));
    pick("remedy_target", "B3");
    pick("remedy_variant", "deep");
    EXPECT_EQ(remedies()[3], (Remedy{"bleed_ml", true, 20, "mL", RemedyKind::other_task, "", "B3", "deep"}));
    pick("remedy_kind", static_cast<int>(RemedyKind::practise_from));
    EXPECT_EQ(remedies()[3].goal, "divide") << "the second goal is offered first";
    EXPECT_TRUE(remedies()[3].variant.empty());
    click(window, "remedy_up");
    EXPECT_EQ(remedies()[2].metric, "bleed_ml");
    click(window, "remedy_remove");
    EXPECT_EQ(remedies().size(), 3U);
    EXPECT_FALSE(std::any_of(page->problems().begin(), page->problems().end(),
                             [](const CurriculumProblem& one) { return one.blocks; }));
    // A draft of another hand: an unknown metric and a wrong unit, each in its task.
    QTemporaryDir folder;
    Curriculum wrong = page->draft();
    wrong.tasks[1].remedies[0].metric = "path_length";
    wrong.tasks.back().remedies[0].unit = "cm";
    QFile file(folder.filePath("draft.json"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(curriculum_text(wrong)));
    file.close();
    page->read_draft(file.fileName());
    choose("C4");
    EXPECT_TRUE(
        find<QLabel>(window, "remedies_problems")->text().contains("plane_dev is not measured in 'cm'"));
    keep("curriculum-remedies-problem");
    choose("A2");
    EXPECT_TRUE(find<QLabel>(window, "remedies_problems")->text().contains("did you mean path_len?"));
    type(window, "curriculum_reason", "because");
    EXPECT_FALSE(find<QAbstractButton>(window, "curriculum_publish")->isEnabled());
}

TEST_F(CurriculumView, RemediesFitThePageAtTheLargestText) {
    window.resize(1280, 800);
    window.set_text_size(200);  // the pages are made again
    click(window, "rail_curriculum");
    tasks = find<QListWidget>(window, "curriculum_tasks");
    choose("C4");
    find<QTabWidget>(window, "curriculum_tabs")->setCurrentIndex(3);
    QCoreApplication::processEvents();
    ASSERT_TRUE(sees(window, "remedies_list"));
    bring(*find<QWidget>(window, "remedy_variant"));
    keep("curriculum-remedies-200");
    for (QScrollArea* area : window.current_page()->findChildren<QScrollArea*>()) {
        if (area->widget()->objectName() != "page_body") continue;
        EXPECT_EQ(area->horizontalScrollBar()->maximum(), 0)
            << area->widget()->minimumSizeHint().width() << " px wide";
    }
    window.set_text_size(100);
}

/// A draft written elsewhere, with values that the fields of the page cannot show whole.
class FineDraft : public CurriculumView {
  protected:
    FineDraft() {
        Curriculum fine = page().draft();
        for (CurriculumTask& task : fine.tasks) {
            if (task.task == "A2") task.rule = parse_pass_rule("lc-cusum:0.125,0.3,2.52");
            if (task.task != "C4") continue;
            task.remedies[0].bound = 0.12345;
            task.ratings = RatingRule{"gas", 2, 4.3333, {}, false, false};
        }
        QFile file(folder.filePath("fine.json"));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(QByteArray::fromStdString(curriculum_text(fine)));
        file.close();
        page().read_draft(file.fileName());
    }
    /// Every curve is that of the rule as it would be published.
    void expect_curves_of(const char* task) {
        const PassRule published = parse_pass_rule(pass_rule_text(page().draft().find(task)->rule));
        for (std::size_t k = 0; k < designer_trainees.size(); ++k)
            EXPECT_EQ(chart->curves().tried[k],
                      operating_curve(published, designer_trainees[k], designer_attempts));
    }
    QTemporaryDir folder;
};

TEST_F(FineDraft, AValueBetweenTwoStepsOfADialStaysUntilThatDialIsMoved) {
    choose("A2");
    EXPECT_EQ(find<QSlider>(window, "rule_limit")->value(), 25);
    step("rule_limit", 1, Qt::Key_Right);
    EXPECT_EQ(pass_rule_text(page().draft().find("A2")->rule), "lc-cusum:0.125,0.3,2.6");
    expect_curves_of("A2");
    step("rule_acceptable", 1, Qt::Key_Right);
    EXPECT_EQ(pass_rule_text(page().draft().find("A2")->rule), "lc-cusum:0.14,0.3,2.6");
    step("rule_acceptable", 30, Qt::Key_Right);
    EXPECT_EQ(pass_rule_text(page().draft().find("A2")->rule), "lc-cusum:0.44,0.45,2.6");
    expect_curves_of("A2");
    choose("C4");
    step("rule_passes", 2, Qt::Key_Left);
    step("rule_among", 20, Qt::Key_Right);
    EXPECT_EQ(pass_rule_text(page().draft().find("C4")->rule), "of:2,16");
    expect_curves_of("C4");
}

TEST_F(CurriculumView, OffersNoRuleThatNobodyCanMeet) {
    const auto tried = [&](const char* task) { return pass_rule_text(page().draft().find(task)->rule); };
    choose("C4");  // passes on two variants
    step("rule_among", 20, Qt::Key_Left);
    EXPECT_EQ(tried("C4"), "of:2,2");
    choose_tab(window, "curriculum_tabs", "Prerequisites");
    find<QSpinBox>(window, "task_variants")->setValue(3);
    const auto& problems = page().problems();
    EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), [](const CurriculumProblem& one) {
        return one.blocks && one.field == CurriculumField::rule;
    })) << "two passes on three variants";
    choose_tab(window, "curriculum_tabs", "Pass rule");
    step("rule_among", 1, Qt::Key_Right);
    step("rule_among", 20, Qt::Key_Left);
    EXPECT_EQ(tried("C4"), "of:2,3");
    auto* kind = find<QComboBox>(window, "rule_kind");
    kind->setFocus();
    QTest::keyClick(kind, Qt::Key_Home);
    EXPECT_EQ(tried("C4"), "row:3");
    step("rule_passes", 20, Qt::Key_Left);
    EXPECT_EQ(tried("C4"), "row:3");
    EXPECT_FALSE(std::any_of(problems.begin(), problems.end(),
                             [](const CurriculumProblem& one) { return one.blocks; }));
}

TEST_F(FineDraft, ABoundAndAMeanWithMoreDigitsStayUntilTheyAreChanged) {
    choose("C4");
    choose_tab(window, "curriculum_tabs", "Remedies");
    auto* kind = find<QComboBox>(window, "remedy_kind");
    const int replay = kind->findData(static_cast<int>(RemedyKind::replay));
    kind->setCurrentIndex(replay);
    emit kind->activated(replay);
    const auto task = [&] { return page().draft().find("C4"); };
    EXPECT_EQ(task()->remedies[0].kind, RemedyKind::replay);
    EXPECT_EQ(task()->remedies[0].bound, 0.12345);
    find<QDoubleSpinBox>(window, "remedy_bound")->setValue(0.2);
    EXPECT_EQ(task()->remedies[0].bound, 0.2);
    choose_tab(window, "curriculum_tabs", "Ratings");
    check(window, "ratings_blind");
    ASSERT_TRUE(task()->ratings.has_value());
    EXPECT_TRUE(task()->ratings->blind);
    EXPECT_EQ(task()->ratings->lowest_mean, 4.3333);
    find<QDoubleSpinBox>(window, "ratings_lowest")->setValue(5);
    EXPECT_EQ(task()->ratings->lowest_mean, 5);
}

TEST_F(CurriculumView, TheLineOfATaskFollowsItsFields) {
    choose("A3");
    EXPECT_TRUE(find<QLabel>(window, "task_facts")->text().contains("opens after A2"));
    choose_tab(window, "curriculum_tabs", "Prerequisites");
    auto* after = find<QListWidget>(window, "task_after");
    for (int row = 0; row < after->count(); ++row) {
        if (after->item(row)->data(Qt::UserRole).toString() != "A2") continue;
        after->setCurrentRow(row);
        QTest::keyClick(after, Qt::Key_Space);
    }
    EXPECT_TRUE(find<QLabel>(window, "task_facts")->text().contains("open from the start"));
}

}  // namespace
}  // namespace fulcrum::ui::window_test
