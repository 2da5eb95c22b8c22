// SPDX-License-Identifier: GPL-3.0-or-later
// What was chosen and built on the page *Build limits* and is neither in force nor in a file.
#include "tests/ui/dashboards/building_limits.h"

namespace fulcrum::ui::window_test {
namespace {

class LeavingLimits : public BuildingLimits {
  protected:
    /// Of A2, at the end of the question.
    QString being_built(DeviceClass devices) {
        return QStringLiteral(": a set of limits that is being built (%1 · %2).")
            .arg(window->context().task_title("A2"), device_class_text(devices));
    }
    void choose_devices(DeviceClass wanted) {
        auto* devices = find<QComboBox>(*window, "benchmark_device");
        devices->setFocus();
        QTest::keyClick(devices, Qt::Key_Home);
        for (int i = 0; i < devices->count() && devices->currentData().toInt() != static_cast<int>(wanted);
             ++i)
            QTest::keyClick(devices, Qt::Key_Down);
        ASSERT_EQ(devices->currentData().toInt(), static_cast<int>(wanted));
        ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    }
    const OutlivesItsWindows outlives;
};

TEST_F(LeavingLimits, WhatWasBegunStaysAndIsNamedBeforeItIsLost) {
    choose_experts(3);
    auto* tasks = find<QComboBox>(*window, "benchmark_task");
    tasks->setFocus();
    QTest::keyClick(tasks, Qt::Key_Down);
    ASSERT_NE(tasks->currentData().toString(), "A2");
    ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    const auto expect_chosen = [&](const char* after) {
        ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
        ASSERT_EQ(people()->rowCount(), expert_people) << after;
        for (int row = 0; row < expert_people; ++row)
            EXPECT_EQ(people()->item(row, 0)->checkState() == Qt::Checked, row < 3) << after << row;
    };
    QTest::keyClick(tasks, Qt::Key_Up);
    expect_chosen("another task and back");
    choose_page(*window, "rail_limits");
    choose_page(*window, "rail_benchmark");
    expect_chosen("another page and back");
    EXPECT_FALSE(window->close());
    EXPECT_TRUE(label("question_words").endsWith(being_built(DeviceClass::haptic)))
        << label("question_words").toStdString();
    click(*window, "question_no");
    emit window->context().switch_user_wanted();
    EXPECT_TRUE(window->context().signed_in());
    click(*window, "question_no");
    for (int row = 3; row < expert_people; ++row) {
        people()->setCurrentCell(row, 0);
        QTest::keyClick(people(), Qt::Key_Space);
    }
    build();
    choose_page(*window, "rail_limits");
    choose_page(*window, "rail_benchmark");
    EXPECT_TRUE(sees(*window, "benchmark_verdict")) << "the set is still there";
    bring(*find<QLineEdit>(*window, "benchmark_path"));
    type(*window, "benchmark_path", QString::fromStdString((folder / "A2-new.json").string()));
    click(*window, "benchmark_save");
    EXPECT_TRUE(window->close()) << "a file has it: " << label("message_text").toStdString();
}

TEST_F(LeavingLimits, AChoiceStaysUnsavedWhenTheSetOfAnotherOneIsSaved) {
    services->store()->connection().execute(
        "INSERT INTO attempt (id, person_id, station_id, task_id, task_version, mode, device_class, device, "
        "operator_name, variant, seed, fidelity, scene, scene_digest, curriculum, limits, program_version, "
        "cpu_features, started, utc_offset_min, state, duration_s) SELECT id || '-mouse', person_id, "
        "station_id, task_id, task_version, mode, 'mouse-keyboard', device, operator_name, variant, seed, "
        "fidelity, scene, scene_digest, curriculum, limits, program_version, cpu_features, started, "
        "utc_offset_min, state, duration_s FROM attempt WHERE person_id IN ('trainee-1003', 'trainee-1004')");
    choose_devices(DeviceClass::mouse_keyboard);
    ASSERT_EQ(people()->rowCount(), 2);
    choose_experts(2);
    choose_devices(DeviceClass::haptic);
    choose_experts(expert_people);
    build();
    EXPECT_FALSE(window->close());
    EXPECT_EQ(label("question_words").count("a set of limits that is being built"), 2);
    click(*window, "question_no");
    bring(*find<QLineEdit>(*window, "benchmark_path"));
    type(*window, "benchmark_path", QString::fromStdString((folder / "A2-new.json").string()));
    click(*window, "benchmark_save");
    EXPECT_FALSE(window->close()) << "no file has the other choice";
    EXPECT_TRUE(label("question_words").endsWith(being_built(DeviceClass::mouse_keyboard)))
        << label("question_words").toStdString();
    click(*window, "question_no");
    bring(*find<QLineEdit>(*window, "benchmark_note"));
    type(*window, "benchmark_note", "Limits of ours");
    click(*window, "benchmark_put");
    ASSERT_TRUE(wait_for([&] { return page->is_ready(); }));
    EXPECT_FALSE(window->close()) << "the other choice is not in force";
    EXPECT_TRUE(label("question_words").endsWith(being_built(DeviceClass::mouse_keyboard)));
    click(*window, "question_no");
    choose_devices(DeviceClass::mouse_keyboard);
    for (int row = 0; row < 2; ++row) {
        people()->setCurrentCell(row, 0);
        QTest::keyClick(people(), Qt::Key_Space);
    }
    EXPECT_TRUE(window->close()) << "nobody is chosen any longer: " << label("question_words").toStdString();
}

}  // namespace
}  // namespace fulcrum::ui::window_test
