// SPDX-License-Identifier: GPL-3.0-or-later
// A window with attempts at B2 to compare: of Tara, and of five other people of the cohort Spring, whose
// educator is Ed.
#pragma once

#include <gtest/gtest.h>

#include <QComboBox>
#include <QLabel>
#include <QTableWidget>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "database/records/people.h"
#include "database/records/recorder.h"
#include "database/rows/packed_bytes.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/review/compare_page.h"
#include "ui/review/debrief_page.h"
#include "ui/shell/main_window.h"
#include "ui/style/text.h"

namespace fulcrum::ui::window_test {

/// What a recorded attempt of B2 is like: three steps, which take 2, 3 and 1 s times `pace`.
struct ComparedRecord {
    double pace = 1;
    double force = 1;  // N, of the left hand
    std::string variant = "standard";
    bool keep_trace = true;
    double points = 50;
    std::string task = "B2";
    int version = 1;        // of the metric
    bool practice = false;  // from the second step of a demonstration, never scored
};

class Comparing : public ::testing::Test {
  protected:
    Comparing() {
        apply_theme(*qApp, Theme::light);
        services.open_store(false);
        const database::People people(*services.store());
        const database::Session alma =
            people.create_programme("Surgery", "alma", "Alma Admin", "correct horse").administrator;
        const auto add = [&](const std::string& login, const std::string& name, database::Role role) {
            const auto made = people.create(alma, login, name, {role});
            sessions.emplace(login, people.change_password(people.sign_in(login, made.one_time_password),
                                                           made.one_time_password, "a long password"));
        };
        add("tara", "Tara Trainee", database::Role::trainee);
        add("ed", "Ed Educator", database::Role::educator);
        add("dora", "Dora Director", database::Role::director);
        std::vector<std::string> members{sessions.at("tara").person_id()};
        for (int i = 0; i < 5; ++i) {
            add("other" + std::to_string(i), "Other " + std::to_string(i), database::Role::trainee);
            members.push_back(sessions.at("other" + std::to_string(i)).person_id());
        }
        const std::string cohort = people.create_cohort(sessions.at("dora"), "Spring");
        people.set_members(sessions.at("dora"), cohort, members);
        people.set_educators(sessions.at("dora"), cohort, {sessions.at("ed").person_id()});
    }
    ~Comparing() override {
        window.reset();
        apply_theme(*qApp, Theme::light);
    }

    std::string record(const std::string& login, const ComparedRecord& like) {
        const database::Session& person = sessions.at(login);
        database::AttemptMeta meta;
        meta.person_id = person.person_id();
        meta.task_id = like.task;
        meta.mode = AttemptMode::assessed;
        meta.device_class = DeviceClass::haptic;
        meta.device = "test";
        meta.variant = like.variant;
        meta.fidelity = "standard";
        meta.scene = "b2_plane.json";
        meta.limits = "B2-operators@1";
        meta.program_version = "0.1.0-test";
        meta.keep_trace = like.keep_trace;
        meta.started = 1'700'000'000'000 + 60'000 * recorded++;
        const auto begin = static_cast<std::uint32_t>(like.practice ? 2000 * like.pace : 0);
        if (like.practice) {
            meta.mode = AttemptMode::practice;
            meta.origin.emplace();
            meta.origin->tick = begin;
            meta.origin->goal = 1;
            meta.origin->build = "test";
            meta.origin->state = database::pack_bytes({1, 2, 3});
        }
        database::Recorder recorder(services.store()->path(), person, meta, {});
        const auto end = static_cast<std::uint32_t>(6000 * like.pace);
        std::map<std::uint32_t, std::pair<EventKind, int>> events{
            {begin + 1, {EventKind::first_movement, 0}},
            {static_cast<std::uint32_t>(2000 * like.pace), {EventKind::phase_end, 0}},
            {static_cast<std::uint32_t>(5000 * like.pace), {EventKind::phase_end, 1}},
            {end - 1, {EventKind::phase_end, 2}},
            {end, {EventKind::completed, 0}}};
        for (std::uint32_t tick = begin + 1; like.keep_trace && tick <= end; ++tick) {
            RigSample input;
            TickSample sample;
            input.tick = sample.tick = tick;
            recorder.append(input);
            const double x = 0.02 * std::sin(tick * 2e-3 / like.pace);
            for (HandSample& hand : sample.hand) {
                hand.tip[0] = static_cast<std::int32_t>(std::lround(x / sample_length_unit));
                hand.flags = hand_inside | hand_in_view;
            }
            const bool second = tick > 2000 * like.pace && tick <= 5000 * like.pace;
            sample.hand[0].force[2] =
                static_cast<std::int32_t>(std::lround((second ? 2 : 1) * like.force / sample_force_unit));
            recorder.append(sample);
            if (const auto found = events.find(tick); found != events.end()) {
                Event event;
                event.tick = tick;
                event.kind = found->second.first;
                event.detail = found->second.second;
                recorder.append(event);
            }
        }
        database::AttemptResult result;
        result.state = AttemptState::completed;
        result.duration_s = result.wall_s = 6 * like.pace;
        result.state_hash = "00ff";
        database::ScoreRow score;
        score.program_version = "0.1.0-test";
        score.limits = "B2-operators@1";
        database::MetricRow time;
        time.id = "time";
        time.version = like.version;
        time.value = 6 * like.pace;
        time.unit = "s";
        time.direction = Direction::lower;
        score.metrics = {time};
        score.passed = true;
        score.points = like.points;
        score.advice = Statement(StatementId::gates_met);
        if (!like.practice) result.score = score;
        recorder.finish(result);
        return recorder.attempt_id();
    }
    ComparePage& open(const std::string& login, const std::string& id, QSize size = {1012, 726}) {
        window = std::make_unique<MainWindow>(services);
        window->resize(size);
        window->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
        window->context().set_session(sessions.at(login));
        emit window->context().debrief_wanted(text(id), -1);
        auto* debrief = static_cast<DebriefPage*>(window->current_page());
        EXPECT_TRUE(wait_for([&] { return debrief->is_ready(); }));
        click(*window, "debrief_compare");
        auto* page = static_cast<ComparePage*>(window->current_page());
        EXPECT_EQ(page->objectName(), "compare_page");
        EXPECT_TRUE(wait_for([&] { return page->is_ready(); }));
        return *page;
    }
    void choose(ComparePage& page, const QString& begins) {
        auto* box = find<QComboBox>(*window, "compare_with");
        const int row = box->findText(begins, Qt::MatchStartsWith);
        ASSERT_GE(row, 0) << begins.toStdString();
        box->setFocus();
        QTest::keyClick(box, Qt::Key_Home);
        for (int i = 0; i < row; ++i) QTest::keyClick(box, Qt::Key_Down);
        ASSERT_EQ(box->currentIndex(), row);
        ASSERT_TRUE(wait_for([&] { return page.is_ready(); }));
    }
    QString notes() { return find<QLabel>(*window, "compare_notes")->text(); }
    /// The cells of the line of a metric.
    QStringList line(const QString& metric, const QString& hand = {}) {
        choose_tab(*window, "compare_tabs", "Metrics");
        auto* table = find<QTableWidget>(*window, "comparison_table");
        for (int row = 0; row < table->rowCount(); ++row) {
            if (table->item(row, 0)->text() != metric || table->item(row, 1)->text() != hand) continue;
            QStringList cells;
            for (int column = 2; column < table->columnCount(); ++column)
                cells << table->item(row, column)->text().replace(QChar(0x202F), QLatin1Char(' '));
            return cells;
        }
        return {};
    }
    void keep(const QString& name) {
        if (qEnvironmentVariableIsEmpty("FULCRUM_PICTURES")) return;
        for (const Theme theme : {Theme::light, Theme::dark}) {
            window->set_theme(theme);
            QTest::qWait(300);
            keep_picture(*window, name + (theme == Theme::light ? "-light" : "-dark"));
            keep_body(*window, *window->current_page(),
                      name + "-whole" + (theme == Theme::light ? "-light" : "-dark"));
        }
        window->set_theme(Theme::light);
    }

    FakeServices services;
    std::map<std::string, database::Session> sessions;
    std::unique_ptr<MainWindow> window;
    int recorded = 0;
};

}  // namespace fulcrum::ui::window_test
