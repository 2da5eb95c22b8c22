// SPDX-License-Identifier: GPL-3.0-or-later
// Drafts of the curriculum: they are published, saved and opened again, put together with what others
// published in between, and kept for their authors.
#include <gtest/gtest.h>

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <algorithm>

#include "assessment/assets/assets.h"
#include "database/store/accepted_assets.h"
#include "tests/ui/dashboards/curriculum_view.h"

namespace fulcrum::ui::window_test {
namespace {

std::string rule_in(const Curriculum& curriculum, const char* task) {
    return pass_rule_text(curriculum.find(task)->rule);
}

std::function<void(Curriculum&)> new_rule(const char* task, const char* rule) {
    return [=](Curriculum& next) {
        for (CurriculumTask& one : next.tasks)
            if (one.task == task) one.rule = parse_pass_rule(rule);
    };
}

void write_file(const QString& path, const std::string& content) {
    QFile file(path);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray::fromStdString(content));
}

std::string content_of(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return file.readAll().toStdString();
}

bool is_enabled(QWidget& window, const char* button) {
    return find<QAbstractButton>(window, button)->isEnabled();
}

TEST_F(CurriculumView, ADraftStaysWithAnotherTextSizeAndLanguageAndIsNotOfTheNextPerson) {
    window.resize(1280, 800);
    const std::string in_force = pass_rule_text(rule_of("C4"));
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    type(window, "curriculum_reason", "Three of five are enough");
    const auto rule_of_draft = [&] {
        click(window, "rail_curriculum");
        tasks = find<QListWidget>(window, "curriculum_tasks");
        return pass_rule_text(static_cast<CurriculumPage*>(window.current_page())->draft().find("C4")->rule);
    };
    ASSERT_EQ(rule_of_draft(), "of:3,5");
    window.set_text_size(200);
    EXPECT_EQ(rule_of_draft(), "of:3,5");
    EXPECT_EQ(tasks->currentItem()->data(Qt::UserRole).toString(), "C4");
    EXPECT_EQ(find<QLineEdit>(window, "curriculum_reason")->text(), "Three of five are enough");
    EXPECT_TRUE(find<QAbstractButton>(window, "curriculum_save")->isEnabled());
    window.set_language(Language::german);
    window.set_text_size(100);  // the page was not looked at in between
    EXPECT_EQ(rule_of_draft(), "of:3,5");
    window.set_language(Language::english);
    be_educator();
    EXPECT_EQ(rule_of_draft(), in_force) << "not of the next person";
}

TEST_F(CurriculumView, PublishesANewVersionWithAReasonAndKeepsPeopleOnTheirs) {
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    type(window, "curriculum_reason", "Three of five are enough");
    EXPECT_FALSE(find<QAbstractButton>(window, "curriculum_publish")->isEnabled()) << "a director looks";
    be_educator();
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    EXPECT_FALSE(find<QAbstractButton>(window, "curriculum_publish")->isEnabled()) << "no reason yet";
    type(window, "curriculum_reason", "Three of five are enough");
    const std::string before = services.curriculum().name();
    click(window, "curriculum_publish");
    EXPECT_EQ(services.curriculum().name(), "rectal@1001");
    EXPECT_EQ(pass_rule_text(services.curriculum().find("C4")->rule), "of:3,5");
    ASSERT_NE(services.curriculum().version_named(before), nullptr)
        << "the one before is there for its people";
    EXPECT_EQ(pass_rule_text(services.curriculum().version_named(before)->find("C4")->rule), "of:4,5");
    const auto accepted = database::AcceptedAssets(*services.store()).list();
    ASSERT_EQ(accepted.size(), 1U);
    EXPECT_EQ(accepted[0].file.name, "curricula/rectal-1001.json");
    EXPECT_EQ(accepted[0].reason, "Three of five are enough");
    EXPECT_TRUE(find<QLabel>(window, "message_text")->text().startsWith("Version 1001 is in force."));
    EXPECT_EQ(find<QAbstractButton>(window, "curriculum_publish")->text(), "Publish version 1002");
    EXPECT_FALSE(find<QAbstractButton>(window, "curriculum_publish")->isEnabled());
    EXPECT_FALSE(tasks->item(6)->text().contains("tried"));
}

TEST_F(CurriculumView, WritesTheFileOfANewVersion) {
    QTemporaryDir folder;
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    auto* path = find<QLineEdit>(window, "curriculum_path");
    EXPECT_TRUE(path->text().endsWith("rectal-1001.json")) << path->text().toStdString();
    path->setText(folder.filePath("rectal-1001.json"));
    click(window, "curriculum_save");
    ASSERT_TRUE(wait_for([&] { return QFileInfo::exists(folder.filePath("rectal-1001.json")); }));
    const Curriculum written = load_curriculum(folder.filePath("rectal-1001.json").toStdString(), task_ids());
    EXPECT_EQ(written.version, services.curriculum().next_own_version());
    EXPECT_EQ(pass_rule_text(written.find("C4")->rule), "of:3,5");
    EXPECT_EQ(pass_rule_text(written.find("A2")->rule), pass_rule_text(rule_of("A2")));
    EXPECT_EQ(find<QAbstractButton>(window, "curriculum_save")->text(), "Replace");

    path->setText(folder.filePath("nowhere/rectal-1001.json"));
    click(window, "curriculum_save");
    EXPECT_FALSE(QFileInfo::exists(folder.filePath("nowhere")));
    EXPECT_TRUE(find<QLabel>(window, "message_text")->text().contains("nowhere"))
        << find<QLabel>(window, "message_text")->text().toStdString();
}

TEST_F(CurriculumView, ASavedDraftKeepsWhatAnotherEducatorPublishedSince) {
    be_educator();
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    const QTemporaryDir folder;
    const QString file = folder.filePath("mine.json");
    type(window, "curriculum_path", file);
    click(window, "curriculum_save");
    click(window, "curriculum_discard");
    publish_elsewhere(new_rule("A2", "row:3"));
    page().read_draft(file);
    EXPECT_EQ(rule_in(page().draft(), "C4"), "of:3,5");
    EXPECT_EQ(rule_in(page().draft(), "A2"), "row:3") << "not taken back";
    const QString note = find<QLabel>(window, "merge_note")->text();
    EXPECT_TRUE(note.contains("begun from version 3; version 1001 is in force now") &&
                note.contains("A2, Pass rule"))
        << note.toStdString();
    EXPECT_FALSE(sees(window, "merge_list")) << "nothing collides";
    keep("curriculum-merged");
    type(window, "curriculum_reason", "Three of five are enough");
    click(window, "curriculum_publish");
    EXPECT_EQ(services.curriculum().name(), "rectal@1002");
    EXPECT_EQ(rule_in(services.curriculum(), "A2"), "row:3");
    EXPECT_EQ(rule_in(services.curriculum(), "C4"), "of:3,5");
    EXPECT_FALSE(sees(window, "merge_note"));
}

TEST_F(CurriculumView, OfTwoEducatorsAtOnceTheSecondHasTheChangesOfBothBeforePublishing) {
    be_educator();
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    type(window, "curriculum_reason", "Three of five are enough");
    publish_elsewhere(new_rule("A2", "row:3"));
    click(window, "curriculum_publish");
    EXPECT_EQ(services.curriculum().name(), "rectal@1001") << "the draft is looked at first";
    EXPECT_TRUE(message().startsWith("Version 1001 is in force. Its changes and yours"))
        << message().toStdString();
    EXPECT_EQ(rule_in(page().draft(), "A2"), "row:3");
    EXPECT_EQ(find<QAbstractButton>(window, "curriculum_publish")->text(), "Publish version 1002");
    click(window, "curriculum_publish");
    EXPECT_EQ(services.curriculum().name(), "rectal@1002");
    EXPECT_EQ(rule_in(services.curriculum(), "A2"), "row:3");
    EXPECT_EQ(rule_in(services.curriculum(), "C4"), "of:3,5");
}

TEST_F(CurriculumView, WhatBothChangedIsDecidedBeforeItIsPublished) {
    be_educator();
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    type(window, "curriculum_reason", "Three of five are enough");
    publish_elsewhere(new_rule("C4", "of:5,6"));
    open_page();
    auto* list = find<QListWidget>(window, "merge_list");
    ASSERT_EQ(list->count(), 1);
    EXPECT_EQ(
        list->item(0)->text().toStdString(),
        "C4, Pass rule\nDraft: 3 passes among the last 5 attempts\nVersion 1001: 5 passes among the last "
        "6 attempts");
    bring(*list);
    keep("curriculum-collision");
    EXPECT_EQ(rule_in(page().draft(), "C4"), "of:3,5") << "until it is decided";
    choose("C4");
    EXPECT_TRUE(tasks->currentItem()->text().contains("✕ 1 problem"));
    EXPECT_FALSE(is_enabled(window, "curriculum_publish"));
    window.set_text_size(200);  // the page is made again
    window.set_text_size(100);
    open_page();
    EXPECT_FALSE(is_enabled(window, "curriculum_publish"));
    click(window, "merge_take");
    EXPECT_EQ(rule_in(page().draft(), "C4"), "of:5,6");
    EXPECT_FALSE(sees(window, "merge_list"));
    EXPECT_FALSE(is_enabled(window, "curriculum_publish")) << "nothing is left of the draft";
    publish_elsewhere(new_rule("C4", "of:6,7"));
    open_page();
    EXPECT_EQ(rule_in(page().draft(), "C4"), "of:6,7") << "an unchanged draft is the version in force";
}

TEST_F(CurriculumView, AnAuthorMayKeepTheDraftsOwnValueAndASavedCollisionStaysOne) {
    be_educator();
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    publish_elsewhere(new_rule("C4", "of:5,6"));
    open_page();
    const QTemporaryDir folder;
    const QString file = folder.filePath("open.json");
    type(window, "curriculum_path", file);
    click(window, "curriculum_save");
    click(window, "curriculum_discard");
    EXPECT_FALSE(sees(window, "merge_note"));
    page().read_draft(file);
    ASSERT_TRUE(sees(window, "merge_list")) << "saved before it was decided";
    type(window, "curriculum_reason", "Three of five are enough");
    EXPECT_FALSE(is_enabled(window, "curriculum_publish"));
    click(window, "merge_keep");
    click(window, "curriculum_publish");
    EXPECT_EQ(services.curriculum().name(), "rectal@1002");
    EXPECT_EQ(rule_in(services.curriculum(), "C4"), "of:3,5");
}

TEST_F(CurriculumView, ADraftOfAnOlderProgramIsComparedWithTheVersionInForce) {
    be_educator();
    Curriculum draft = page().draft();
    new_rule("C4", "of:3,5")(draft);
    const QTemporaryDir folder;
    const QString file = folder.filePath("old.json");
    write_file(file, curriculum_text(draft));
    publish_elsewhere(new_rule("A2", "row:3"));
    page().read_draft(file);
    EXPECT_TRUE(find<QLabel>(window, "merge_note")->text().startsWith("This draft does not say"));
    auto* list = find<QListWidget>(window, "merge_list");
    ASSERT_EQ(list->count(), 2) << "who changed what cannot be known";
    EXPECT_TRUE(list->item(0)->text().startsWith("A2, Pass rule"));
    EXPECT_TRUE(list->item(1)->text().startsWith("C4, Pass rule"));
    bring(*list);
    keep("curriculum-without-base");
    type(window, "curriculum_reason", "Three of five are enough");
    click(window, "merge_take");
    EXPECT_FALSE(is_enabled(window, "curriculum_publish"));
    click(window, "merge_keep");
    click(window, "curriculum_publish");
    EXPECT_EQ(rule_in(services.curriculum(), "A2"), "row:3");
    EXPECT_EQ(rule_in(services.curriculum(), "C4"), "of:3,5");
    // Begun from a version of another station.
    draft = page().draft();
    new_rule("B1", "row:3")(draft);
    draft.based_on = DraftOrigin{1001, std::string(64, '0')};
    write_file(file, curriculum_text(draft));
    page().read_draft(file);
    EXPECT_TRUE(find<QLabel>(window, "merge_note")->text().contains("a version 1001 that this station"));
    EXPECT_FALSE(is_enabled(window, "curriculum_publish"));
}

TEST_F(CurriculumView, ADraftIsKeptForItsAuthorAfterSigningOut) {
    const database::Session ed = make_educator("ed", "Ed Educator");
    open_as(ed);
    const std::string in_force = rule_in(services.curriculum(), "C4");
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    type(window, "curriculum_reason", "Three of five are enough");
    const database::Session ann = make_educator("ann", "Ann Educator");
    open_as(ann);
    EXPECT_EQ(rule_in(page().draft(), "C4"), in_force) << "not of the next person";
    EXPECT_TRUE(find<QLineEdit>(window, "curriculum_reason")->text().isEmpty());
    choose("A2");
    click(window, "task_remove");
    type(window, "curriculum_reason", "Not needed");
    open_as(ed);
    EXPECT_EQ(rule_in(page().draft(), "C4"), "of:3,5");
    EXPECT_NE(page().draft().find("A2"), nullptr);
    EXPECT_EQ(find<QLineEdit>(window, "curriculum_reason")->text(), "Three of five are enough");
    click(window, "curriculum_publish");
    open_as(ann);
    EXPECT_EQ(page().draft().find("A2"), nullptr);
    EXPECT_EQ(rule_in(page().draft(), "C4"), "of:3,5") << "what was published in between stays";
    EXPECT_TRUE(sees(window, "merge_note"));
    open_as(ed);
    EXPECT_FALSE(is_enabled(window, "curriculum_discard")) << "it was published";
}

TEST_F(CurriculumView, AWithdrawnRoleKeepsTheDraftAndAnotherRoleIsSeenAtOnce) {
    const database::People people(*services.store());
    const database::Session administrator = people.sign_in("administrator", "correct horse battery");
    const database::Session ed = make_educator("ed", "Ed Educator");
    people.set_roles(administrator, ed.person_id(), {database::Role::educator, database::Role::director});
    const database::Session both = people.sign_in("ed", "a long password");
    open_as(people.act_as(both, database::Role::director));
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    type(window, "curriculum_reason", "Three of five are enough");
    EXPECT_FALSE(is_enabled(window, "curriculum_publish"));
    window.context().set_session(people.act_as(both, database::Role::educator));
    open_page();
    EXPECT_TRUE(is_enabled(window, "curriculum_publish"));
    people.set_roles(administrator, ed.person_id(), {database::Role::director});
    click(window, "curriculum_publish");
    EXPECT_TRUE(message().contains("The role was withdrawn")) << message().toStdString();
    EXPECT_EQ(services.curriculum().name(), "rectal@3");
    EXPECT_EQ(rule_in(page().draft(), "C4"), "of:3,5");
    EXPECT_FALSE(is_enabled(window, "curriculum_publish"));
}

TEST_F(CurriculumView, ADraftWithFewerTasksIsOpenedAndAnAddedTaskDiscarded) {
    const int usual = tasks->count();
    type(window, "curriculum_reason", "because");
    click(window, "task_add");
    ASSERT_EQ(tasks->count(), usual + 1);
    click(window, "curriculum_discard");
    click(window, "curriculum_discard_sure");
    EXPECT_EQ(tasks->count(), usual);
    EXPECT_TRUE(find<QLineEdit>(window, "curriculum_reason")->text().isEmpty());
    Curriculum draft = page().draft();
    draft.tasks.resize(2);
    draft.tasks[1].task = "Z9";
    const QTemporaryDir folder;
    const QString file = folder.filePath("short.json");
    write_file(file, curriculum_text(draft));
    page().read_draft(file);
    ASSERT_EQ(tasks->count(), 2);
    EXPECT_TRUE(tasks->item(1)->text().startsWith("Z9"));
    const QString problems = find<QLabel>(window, "merge_note")->text();
    EXPECT_FALSE(problems.isEmpty());
    choose("Z9");
    choose_tab(window, "curriculum_tabs", "Prerequisites");
    EXPECT_TRUE(find<QLabel>(window, "needs_problems")->text().contains("no task Z9 is installed"));
}

TEST_F(CurriculumView, AFileThatIsCutOffOrEditedByHandIsRefusedWithItsPlace) {
    const QTemporaryDir folder;
    const std::string before = curriculum_text(page().draft()), good = before;
    const auto with = [&](const std::string& text, const std::string& in_place) {
        std::string bad = good;
        const std::size_t at = bad.find(text);
        EXPECT_NE(at, std::string::npos) << text;
        return bad.replace(at, text.size(), in_place);
    };
    const std::pair<std::string, const char*> files[] = {
        {good.substr(0, good.size() / 2), "not valid JSON"},
        {"", "not valid JSON"},
        {with("\"of:4,5\"", "\"of:6,5\""), "K is larger than N"},
        {with("\"version\": 1001", "\"version\": \"new\""), "/version"},
        {with("\"version\": 1001", "\"based_on\": 3, \"version\": 1001"), "/based_on"},
        {with("\"haptic\"", "\"hand\""), "device_classes"},
        {with("\"rectal\"", "\"colon\""), "is another curriculum: colon"}};
    int number = 0;
    for (const auto& [content, words] : files) {
        const QString file = folder.filePath(QStringLiteral("bad%1.json").arg(++number));
        write_file(file, content);
        page().read_draft(file);
        EXPECT_TRUE(message().contains(QFileInfo(file).fileName() + ":") && message().contains(words))
            << words << ": " << message().toStdString();
        EXPECT_EQ(curriculum_text(page().draft()), before);
    }
    page().read_draft(folder.path());
    EXPECT_EQ(curriculum_text(page().draft()), before);
}

TEST_F(CurriculumView, AFileThatSomebodyElseChangedIsNotReplaced) {
    const QTemporaryDir folder;
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    type(window, "curriculum_path", folder.filePath("mine"));
    click(window, "curriculum_save");
    const QString file = folder.filePath("mine.json");
    EXPECT_EQ(find<QLineEdit>(window, "curriculum_path")->text(), file);
    EXPECT_NE(content_of(file).find("\"based_on\""), std::string::npos);
    step("rule_passes", 1, Qt::Key_Left);
    click(window, "curriculum_save");
    EXPECT_NE(content_of(file).find("of:2,5"), std::string::npos) << "its own file is replaced";
    write_file(file, "of a colleague");
    step("rule_passes", 1, Qt::Key_Left);
    click(window, "curriculum_save");
    EXPECT_EQ(content_of(file), "of a colleague");
    EXPECT_TRUE(message().contains("somebody has changed this file since you opened it"))
        << message().toStdString();
}

TEST_F(CurriculumView, OffersANameThatIsFreeInTheFolderOfDocuments) {
    const QByteArray home = qgetenv("HOME");
    const QTemporaryDir folder;
    qputenv("HOME", folder.path().toLocal8Bit());
    write_file(folder.filePath("rectal-1001.json"), "of a colleague");
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    click(window, "curriculum_discard");
    click(window, "curriculum_discard_sure");
    EXPECT_EQ(find<QLineEdit>(window, "curriculum_path")->text(), folder.filePath("rectal-1001 (2).json"));
    choose("C4");
    step("rule_passes", 1, Qt::Key_Left);
    type(window, "curriculum_path", "mine");
    click(window, "curriculum_save");
    EXPECT_TRUE(QFileInfo::exists(folder.filePath("mine.json"))) << message().toStdString();
    qputenv("HOME", home);
}

}  // namespace
}  // namespace fulcrum::ui::window_test
