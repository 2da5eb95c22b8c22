// SPDX-License-Identifier: GPL-3.0-or-later
// Observer forms through the window with real events: two educators rate one attempt without seeing each
// other's ratings, one of them without name and score, and the trainee sees what was released.
#include <gtest/gtest.h>

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <memory>

#include "assessment/assets/assets.h"
#include "database/records/attempts.h"
#include "database/records/people.h"
#include "database/records/ratings.h"
#include "database/records/recorder.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/language/language.h"
#include "ui/reports/report.h"
#include "ui/review/debrief_page.h"
#include "ui/review/item_choice.h"
#include "ui/shell/main_window.h"

namespace fulcrum::ui::window_test {
namespace {

using database::Role;
using database::Session;

class RatingPages : public ::testing::Test {
  protected:
    RatingPages() {
        services.open_store(false);
        const database::People people(*services.store());
        const Session administrator =
            people.create_programme("Surgery", "alma", "Alma Admin", password).administrator;
        const auto add = [&](const char* login, const char* name, Role role) {
            const auto created = people.create(administrator, login, name, {role});
            return people.change_password(people.sign_in(login, created.one_time_password),
                                          created.one_time_password, password);
        };
        const Session director = add("dora", "Dora Director", Role::director);
        ed = std::make_unique<Session>(add("ed", "Ed Educator", Role::educator));
        ida = std::make_unique<Session>(add("ida", "Ida Instructor", Role::educator));
        tara = std::make_unique<Session>(add("tara", "Tara Trainee", Role::trainee));
        const std::string cohort = people.create_cohort(director, "Spring");
        people.set_members(director, cohort, {tara->person_id()});
        people.set_educators(director, cohort, {ed->person_id(), ida->person_id()});
        window = std::make_unique<MainWindow>(services);
        window->resize(1012, 726);
        window->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        QApplication::setActiveWindow(window.get());  // there is no window manager that would do it
    }
    ~RatingPages() override {
        use_language(Language::english);
        apply_theme(*qApp, Theme::light);
    }

    /// A finished attempt of one second.
    std::string record(std::int64_t started = 0) {
        database::AttemptMeta meta;
        meta.started = started;
        meta.curriculum = services.curriculum().name();
        meta.person_id = tara->person_id();
        meta.task_id = "A2";
        meta.mode = AttemptMode::assessed;
        meta.device_class = DeviceClass::mouse_keyboard;
        meta.device = "mouse and keyboard";
        meta.variant = meta.fidelity = "standard";
        meta.scene = "a2_targets.json";
        meta.program_version = "0.1.0";
        database::Recorder recorder(services.store()->path(), *tara, meta);
        for (std::uint32_t tick = 1; tick <= 1000; ++tick) {
            RigSample input;
            input.tick = tick;
            recorder.append(input);
            TickSample sample;
            sample.tick = tick;
            recorder.append(sample);
        }
        database::AttemptResult result;
        result.state = AttemptState::completed;
        result.duration_s = result.wall_s = 1;
        result.score.emplace();
        result.score->program_version = "0.1.0";
        result.score->passed = true;
        result.score->points = 71;
        result.score->advice = Statement(StatementId::gates_met);
        recorder.finish(result);
        return recorder.attempt_id();
    }
    database::Ratings ratings() const { return database::Ratings(*services_store()); }
    database::Store* services_store() const { return const_cast<FakeServices&>(services).store(); }
    void rate(const Session& rater, const std::string& attempt, const FormAnswers& answers,
              const char* form = "goals") const {
        rate(rater, attempt, answers, load_form(asset_path("forms/" + std::string(form) + ".json")));
    }
    void rate(const Session& rater, const std::string& attempt, const FormAnswers& answers,
              const ObserverForm& used) const {
        const std::string id = ratings().begin(rater, attempt, used);
        ratings().answer(rater, id, answers, std::vector<bool>(answers.size(), true), "");
        ratings().hand_in(rater, id);
    }
    void act_as(const Session& session) { window->context().set_session(session); }
    void ready() {
        ASSERT_EQ(window->current_page()->objectName(), "debrief_page");
        auto* debrief = static_cast<DebriefPage*>(window->current_page());
        ASSERT_TRUE(wait_for([&] { return debrief->is_ready(); }));
        QCoreApplication::processEvents();
    }
    void open_debrief(const std::string& id) {
        emit window->context().debrief_wanted(QString::fromStdString(id), -1);
        ready();
    }
    /// A choice of the form on the screen, by mouse.
    void choose(const QString& name) {
        auto* point = find<QRadioButton>(*window, name.toLatin1().constData());
        ASSERT_NE(point, nullptr);
        ASSERT_TRUE(wait_for([&] { return point->size() == point->sizeHint(); })) << "laid out";
        bring(*point);
        QTest::mouseClick(point, Qt::LeftButton);
        EXPECT_TRUE(point->isChecked()) << name.toStdString();
    }
    QStringList shown(const char* name) const {
        QCoreApplication::processEvents();  // new widgets appear in the next turn of the event loop
        QStringList words;
        for (const QLabel* label : window->findChildren<QLabel*>(QString::fromLatin1(name)))
            if (label->isVisible()) words << label->text();
        return words;
    }
    QString complaint() { return find<QLabel>(*window, "message_text")->text(); }
    /// Every text of the page that is visible.
    QString page_text() const {
        QStringList words;
        for (const QLabel* label : window->current_page()->findChildren<QLabel*>())
            if (label->isVisible()) words << label->text();
        for (const QTableWidget* table : window->current_page()->findChildren<QTableWidget*>())
            for (int i = 0; table->isVisible() && i < table->rowCount() * table->columnCount(); ++i)
                words << table->item(i / table->columnCount(), i % table->columnCount())->text();
        return words.join('\n');
    }
    void keep(const QString& name) {
        if (qEnvironmentVariableIsEmpty("FULCRUM_PICTURES")) return;
        for (const Theme theme : {Theme::dark, Theme::light}) {
            window->set_theme(theme);
            const QString shown = name + (theme == Theme::dark ? "-dark" : "-light");
            keep_picture(*window, shown);
            keep_body(*window, *window->current_page(), shown + "-whole");
        }
    }

    static constexpr const char* password = "correct horse battery";
    FakeServices services;
    std::unique_ptr<Session> ed, ida, tara;
    std::unique_ptr<MainWindow> window;
};

TEST_F(RatingPages, FromTheListAnAttemptIsRatedWithoutNameAndScore) {
    const std::string id = record();
    act_as(*ed);
    click(*window, "rail_rate");
    wait_until_read(*window);
    auto* table = find<QTableWidget>(*window, "to_rate_table");
    ASSERT_EQ(table->rowCount(), 1);
    EXPECT_EQ(table->item(0, 7)->text(), "yes");
    EXPECT_FALSE(page_text().contains("Tara"));
    EXPECT_FALSE(page_text().contains("71"));
    keep("to-rate");
    click(*window, "to_rate_open");
    ready();
    EXPECT_TRUE(sees(*window, "rating_blind_notice"));
    EXPECT_TRUE(sees(*window, "replay_block"));
    for (const char* part : {"verdict", "advice", "comment_text", "debrief_tabs"})
        EXPECT_FALSE(sees(*window, part)) << part;
    EXPECT_EQ(find<QComboBox>(*window, "rating_form")->count(), 3);
    click(*window, "rating_begin");
    EXPECT_EQ(shown("rating_total"), QStringList("Total so far: – · items left: 5"));
    for (const char* point : {"rate_depth_perception_4", "rate_bimanual_dexterity_3", "rate_efficiency_2",
                              "rate_tissue_handling_5"})
        choose(point);
    EXPECT_EQ(shown("rating_total"), QStringList("Total so far: 14 of 20 · items left: 1"));
    EXPECT_FALSE(page_text().contains("Tara"));
    EXPECT_FALSE(page_text().contains("71 of 100"));
    keep("rating-blind");
    click(*window, "rating_hand_in");
    EXPECT_EQ(complaint(), "Not rated yet: Autonomy.");
    // A click on what a rating means chooses it.
    for (QLabel* label : find<ItemChoice>(*window, "rating_item_autonomy")->findChildren<QLabel*>())
        if (label->property("rating").toInt() == 3) QTest::mouseClick(label, Qt::LeftButton);
    EXPECT_TRUE(find<QRadioButton>(*window, "rate_autonomy_3")->isChecked());
    EXPECT_EQ(shown("rating_total"), QStringList("Total: 17 of 25"));
    click(*window, "rating_hand_in");
    EXPECT_TRUE(sees(*window, "verdict")) << "no secret any longer";
    EXPECT_FALSE(sees(*window, "rating_blind_notice"));
    ASSERT_EQ(shown("rating_shown").size(), 1);
    EXPECT_TRUE(shown("rating_shown")[0].startsWith("Ed Educator · 17 of 25"));
    EXPECT_TRUE(shown("rating_shown")[0].endsWith(" · blind · not shown to the trainee"));
    EXPECT_EQ(find<QComboBox>(*window, "rating_form")->count(), 2) << "each form once";
    const auto stored = ratings().of_attempt(*ed, id).rows;
    ASSERT_EQ(stored.size(), 1U);
    EXPECT_EQ(stored[0].blinding, database::Blinding::kept);
    EXPECT_EQ(stored[0].answers, (FormAnswers{4, 3, 2, 5, 3}));
    // The list leaves it out, until it is asked for; now it is not blind.
    click(*window, "rail_rate");
    wait_until_read(*window);
    EXPECT_EQ(find<QTableWidget>(*window, "to_rate_table")->rowCount(), 0);
    check(*window, "to_rate_rated");
    ASSERT_EQ(find<QTableWidget>(*window, "to_rate_table")->rowCount(), 1);
    EXPECT_EQ(find<QTableWidget>(*window, "to_rate_table")->item(0, 7)->text(), "no");
    EXPECT_EQ(find<QTableWidget>(*window, "to_rate_table")->item(0, 6)->text(), "1");
}

TEST_F(RatingPages, TheSecondRaterSeesTheFirstOnlyAfterwardsAndTheTraineeOnceReleased) {
    const std::string id = record();
    rate(*ed, id, {4, 3, 2, 5, 3});
    act_as(*ida);
    open_debrief(id);
    EXPECT_TRUE(sees(*window, "verdict"));
    EXPECT_EQ(shown("ratings_hidden"),
              QStringList("Ratings by others: 1. You will see them when you have handed in yours."));
    EXPECT_FALSE(sees(*window, "rating_shown"));
    EXPECT_FALSE(sees(*window, "rating_profile"));
    EXPECT_FALSE(sees(*window, "ratings_reveal")) << "not even the trainee sees it";
    // By keyboard: digits along the form, the arrow keys along a scale.
    find<QPushButton>(*window, "rating_begin")->setFocus();
    QTest::keyClick(window->focusWidget(), Qt::Key_Return);
    QCoreApplication::processEvents();  // the form appears
    EXPECT_EQ(window->focusWidget()->objectName(), "rate_depth_perception_1");
    const Qt::Key digits[] = {Qt::Key_5, Qt::Key_4, Qt::Key_4, Qt::Key_4, Qt::Key_3};
    for (const Qt::Key digit : digits) {
        QTest::keyClick(window->focusWidget(), digit);
        QTest::keyClick(window->focusWidget(), Qt::Key_Tab);
    }
    EXPECT_EQ(window->focusWidget()->objectName(), "rating_remark");
    QTest::keyClicks(window->focusWidget(), "Calm hands.");
    find<QRadioButton>(*window, "rate_autonomy_3")->setFocus();
    QTest::keyClick(window->focusWidget(), Qt::Key_Right);
    EXPECT_TRUE(find<QRadioButton>(*window, "rate_autonomy_4")->isChecked());
    EXPECT_EQ(shown("rating_total"), QStringList("Total: 21 of 25"));
    EXPECT_FALSE(sees(*window, "rating_shown"));
    keep("rating-keyboard");
    find<QPushButton>(*window, "rating_hand_in")->setFocus();
    QTest::keyClick(window->focusWidget(), Qt::Key_Return);
    const QStringList rows = shown("rating_shown");
    ASSERT_EQ(rows.size(), 2);
    EXPECT_TRUE(rows[0].startsWith("Ed Educator · 17 of 25"));
    EXPECT_TRUE(rows[1].startsWith("Ida Instructor · 21 of 25"));
    EXPECT_TRUE(rows[1].contains(" · not blind · ")) << "name and score were on the page";
    EXPECT_EQ(shown("rating_shown_remark"), QStringList("Calm hands."));
    EXPECT_EQ(shown("rating_spread"), QStringList("The raters differ most in \"Efficiency\": 2 to 4."));
    ASSERT_TRUE(wait_for([&] { return sees(*window, "rating_agreement"); }));
    EXPECT_TRUE(shown("rating_agreement")[0].contains("not known yet"));

    const auto in_report = [&] {
        return gather_attempt(*services.store(), *tara, id, services.tasks(), "0.1.0").ratings.size();
    };
    EXPECT_EQ(in_report(), 0U);
    act_as(*tara);
    open_debrief(id);
    EXPECT_FALSE(sees(*window, "ratings_card")) << "nothing is released";
    act_as(*ida);
    open_debrief(id);
    click(*window, "ratings_release");
    EXPECT_EQ(complaint(), "Ratings that the trainee sees from now on: 2.");
    EXPECT_EQ(in_report(), 2U);
    EXPECT_FALSE(sees(*window, "ratings_release"));
    EXPECT_TRUE(shown("rating_shown")[0].endsWith(" · shown to the trainee"));
    bring(*find<QWidget>(*window, "rating_profile"));
    keep("ratings-of-two");
    act_as(*tara);
    open_debrief(id);
    EXPECT_EQ(shown("rating_shown").size(), 2);
    EXPECT_TRUE(sees(*window, "rating_profile"));
    for (const char* part : {"rating_begin", "ratings_release", "ratings_hidden", "rating_agreement"})
        EXPECT_FALSE(sees(*window, part)) << part;
    bring(*find<QWidget>(*window, "rating_profile"));
    keep("ratings-trainee");
}

TEST_F(RatingPages, WhatAnEducatorReleasesMakesTheTraineeProficient) {
    Curriculum curriculum = services.curriculum();
    for (CurriculumTask& task : curriculum.tasks)
        if (task.task == "A2") {
            task.rule = parse_pass_rule("row:2");
            task.ratings = RatingRule{"goals", 2, 3, {}, false, false};
        }
    services.set_curriculum(curriculum);
    constexpr std::int64_t day = 86'400'000;
    record(services.store()->now() - 2 * day);
    const std::string id = record();
    const auto at_home = [&] {
        act_as(*tara);
        wait_until_read(*window);
        EXPECT_EQ(window->current_page()->objectName(), "home_page");
        return page_text();
    };
    QString home = at_home();
    EXPECT_TRUE(home.contains("Passed, awaiting rating"));
    EXPECT_TRUE(home.contains("0 of 2 ratings are released"));
    EXPECT_TRUE(home.contains("Locked until proficient in A2"));
    keep("home-awaiting-rating");
    use_language(Language::german);
    EXPECT_TRUE(at_home().contains(QString::fromUtf8("Bestanden, Beurteilung steht aus")));
    use_language(Language::english);
    act_as(*ed);
    click(*window, "rail_rate");
    wait_until_read(*window);
    auto* list = find<QTableWidget>(*window, "to_rate_table");
    ASSERT_EQ(list->rowCount(), 2);
    EXPECT_EQ(list->item(0, 1)->text(), QString::fromUtf8("● yes"));
    EXPECT_FALSE(list->item(0, 1)->toolTip().isEmpty());
    EXPECT_EQ(list->item(1, 1)->text(), QString::fromUtf8("–"));
    keep("rate-awaiting");
    for (const Session* rater : {ed.get(), ida.get()}) {
        act_as(*rater);
        emit window->context().rating_wanted(QString::fromStdString(id));
        ready();
        click(*window, "rating_begin");
        for (const char* item :
             {"depth_perception", "bimanual_dexterity", "efficiency", "tissue_handling", "autonomy"})
            choose(QStringLiteral("rate_%1_%2").arg(QLatin1String(item)).arg(rater == ed.get() ? 2 : 4));
        click(*window, "rating_hand_in");
    }
    EXPECT_TRUE(at_home().contains("0 of 2 ratings are released")) << "handed in, not released";
    act_as(*ed);
    click(*window, "rail_cohort");
    wait_until_read(*window);
    keep("grid-awaiting-rating");
    open_debrief(id);
    click(*window, "ratings_release");
    home = at_home();
    EXPECT_FALSE(home.contains("awaiting rating"));
    EXPECT_TRUE(home.contains("Proficient since"));
    EXPECT_FALSE(home.contains("Locked until proficient in A2"));
    keep("home-rated");
}

TEST_F(RatingPages, ADraftSurvivesLeavingThePageAndSigningOut) {
    const std::string id = record();
    act_as(*ed);
    emit window->context().rating_wanted(QString::fromStdString(id));
    ready();
    click(*window, "rating_begin");
    choose("rate_efficiency_4");
    auto* remark = find<QPlainTextEdit>(*window, "rating_remark");
    QTest::keyClicks(remark, "Slow start");
    window->context().sign_out();
    act_as(*ed);
    // A draft that is blind stays blind, wherever the attempt is opened from.
    open_debrief(id);
    EXPECT_TRUE(sees(*window, "rating_blind_notice"));
    EXPECT_FALSE(sees(*window, "verdict"));
    EXPECT_TRUE(find<QRadioButton>(*window, "rate_efficiency_4")->isChecked());
    EXPECT_EQ(find<QPlainTextEdit>(*window, "rating_remark")->toPlainText(), "Slow start");
    QTest::keyClicks(find<QPlainTextEdit>(*window, "rating_remark"), "Then ");
    click(*window, "debrief_back");
    EXPECT_EQ(ratings().of_attempt(*ed, id).rows.at(0).remark, "Then Slow start");
    open_debrief(id);
    click(*window, "lift_blinding");
    EXPECT_TRUE(sees(*window, "verdict"));
    EXPECT_EQ(ratings().of_attempt(*ed, id).rows.at(0).blinding, database::Blinding::lifted);
    EXPECT_TRUE(find<QRadioButton>(*window, "rate_efficiency_4")->isChecked());
    click(*window, "rating_discard");
    ASSERT_EQ(ratings().of_attempt(*ed, id).rows.size(), 1U) << "it asks first";
    click(*window, "rating_discard_sure");
    EXPECT_FALSE(sees(*window, "rating_total"));
    EXPECT_TRUE(sees(*window, "rating_begin"));
    EXPECT_TRUE(ratings().of_attempt(*ed, id).rows.empty());
}

TEST_F(RatingPages, WhatTheTraineeSeesIsHeldBackFromARaterUntilAsked) {
    const std::string id = record();
    rate(*ed, id, {4, 3, 2, 5, 3});
    ratings().release(*ed, id);
    act_as(*ida);
    open_debrief(id);
    EXPECT_FALSE(sees(*window, "rating_shown"));
    click(*window, "ratings_reveal");
    EXPECT_EQ(shown("rating_shown").size(), 1);
    EXPECT_FALSE(sees(*window, "ratings_reveal"));
    click(*window, "rating_begin");
    EXPECT_FALSE(sees(*window, "rating_shown")) << "not while rating";
}

TEST_F(RatingPages, TheBlindPageShowsNothingThatOthersGave) {
    std::string open_form = load_form(asset_path("forms/osats.json")).text;
    const std::string blind = "\"blind\": true";
    ASSERT_NE(open_form.find(blind), std::string::npos);
    open_form.replace(open_form.find(blind), blind.size(), "\"blind\": false");
    const std::string id = record();
    rate(*ed, id, {4, 3, 2, 5, 3});
    rate(*ed, id, {4, 4, 4, 4, 4, 3, 3}, parse_form(open_form, "open form"));
    ratings().release(*ed, id);
    act_as(*ida);
    click(*window, "rail_rate");
    wait_until_read(*window);
    click(*window, "to_rate_open");
    ready();
    ASSERT_TRUE(sees(*window, "rating_blind_notice"));
    EXPECT_EQ(shown("ratings_hidden"),
              QStringList("Ratings by others: 2. You will see them when you have handed in yours."));
    EXPECT_FALSE(sees(*window, "rating_shown"));
    EXPECT_FALSE(sees(*window, "ratings_reveal"));
    click(*window, "lift_blinding");
    EXPECT_EQ(shown("rating_shown").size(), 1) << "the form that does not ask for blinding";
    click(*window, "ratings_reveal");
    EXPECT_EQ(shown("rating_shown").size(), 2);
    click(*window, "rating_begin");
    const auto own = ratings().of_attempt(*ida, id).rows;
    ASSERT_EQ(own.size(), 1U);
    EXPECT_EQ(own[0].blinding, database::Blinding::lifted);
}

TEST_F(RatingPages, OptionalItemsCanBeNotSeenAndOneLegendServesEqualScales) {
    const std::string id = record();
    act_as(*ed);
    open_debrief(id);
    auto* forms = find<QComboBox>(*window, "rating_form");
    forms->setCurrentIndex(forms->findData("gas"));
    click(*window, "rating_begin");
    EXPECT_EQ(shown("rating_legend")[0].count('\n'), 5);
    const ObserverForm gas = load_form(asset_path("forms/gas.json"));
    for (const FormItem& item : gas.items)
        choose(QStringLiteral("rate_%1_%2")
                   .arg(QString::fromStdString(item.id), item.id == "exposure" ? "5" : "unseen"));
    EXPECT_EQ(shown("rating_total"), QStringList("Total: 5 of 6"));
    keep("rating-gas");
    click(*window, "rating_hand_in");
    EXPECT_EQ(ratings().of_attempt(*ed, id).rows.at(0).answers[1], 5);
    EXPECT_FALSE(ratings().of_attempt(*ed, id).rows.at(0).answers[0].has_value());
    EXPECT_TRUE(find<QWidget>(*window, "rating_profile")
                    ->accessibleDescription()
                    .startsWith("Theatre set-up: Ed Educator not seen; Exposure of the operating field: Ed "
                                "Educator 5 of 6"));
}

TEST_F(RatingPages, FormsAreInGerman) {
    use_language(Language::german);
    const std::string id = record();
    act_as(*ed);
    open_debrief(id);
    click(*window, "rating_begin");
    EXPECT_EQ(shown("rating_total"), QStringList("Summe bisher: – · offene Punkte: 5"));
    EXPECT_EQ(find<ItemChoice>(*window, "rating_item_efficiency")->accessibleName(), "Effizienz");
    EXPECT_EQ(find<QRadioButton>(*window, "rate_efficiency_3")->accessibleName(),
              "Effizienz: 3 von 5. Braucht Zeit, aber jeder Schritt folgt einem Plan");
    bring(*find<QPushButton>(*window, "rating_hand_in"));
    keep_picture(*window, "rating-german");
}

TEST_F(RatingPages, AgreementIsShownWithItsIntervalAndInWords) {
    std::string last;
    for (int i = 1; i <= 4; ++i) {
        last = record();
        const int other = i == 4 ? 4 : i + 1;
        rate(*ed, last, {i, i, i, i, i});
        rate(*ida, last, {i, i, i, other, other});
    }
    rate(*ed, last, {4, 4, 4, std::nullopt, std::nullopt, 3, 3}, "osats");
    act_as(*ed);
    open_debrief(last);
    ASSERT_TRUE(wait_for([&] { return sees(*window, "rating_agreement"); }));
    const QStringList lines = shown("rating_agreement")[0].split('\n');
    ASSERT_EQ(lines.size(), 2);
    EXPECT_TRUE(lines[0].startsWith("Agreement of raters with GOALS, laparoscopic skills: "))
        << lines[0].toStdString();
    EXPECT_TRUE(lines[0].contains("(2 raters, 4 attempts)"));
    EXPECT_TRUE(lines[1].contains("not known yet"));
    const auto icc = ratings().agreement(*ed).at(0).icc;
    ASSERT_TRUE(icc);
    EXPECT_TRUE(lines[0].contains(QStringLiteral("ICC(2,1) %1, 95 % interval %2 to %3")
                                      .arg(icc->value, 0, 'f', 2)
                                      .arg(icc->low, 0, 'f', 2)
                                      .arg(icc->high, 0, 'f', 2)))
        << lines[0].toStdString();
    bring(*find<QWidget>(*window, "rating_agreement"));
    keep("ratings-agreement");
}

TEST_F(RatingPages, AVoidedAttemptShowsItsRatingsAndTakesNoMore) {
    const std::string id = record();
    rate(*ed, id, {4, 3, 2, 5, 3});
    database::Attempts(*services.store()).void_attempt(*ed, id, "the wrong scene");
    act_as(*ed);
    open_debrief(id);
    EXPECT_EQ(shown("rating_shown").size(), 1);
    EXPECT_FALSE(sees(*window, "rating_begin"));
    click(*window, "rail_rate");
    wait_until_read(*window);
    check(*window, "to_rate_rated");
    EXPECT_EQ(find<QTableWidget>(*window, "to_rate_table")->rowCount(), 0);
    EXPECT_FALSE(find<QPushButton>(*window, "to_rate_open")->isEnabled());
}

}  // namespace
}  // namespace fulcrum::ui::window_test
