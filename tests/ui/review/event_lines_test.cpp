// SPDX-License-Identifier: GPL-3.0-or-later
// Which events of an attempt have a line in its debrief, and its words.
#include <gtest/gtest.h>

#include <QTemporaryDir>

#include "database/records/people.h"
#include "database/records/recorder.h"
#include "sim_core/telemetry/event_types.h"
#include "ui/review/attempt_model.h"
#include "ui/review/event_words.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

// Fibres tear many times a second: one line at the beginning, and another after a pause.
TEST(EventLines, FibresThatTearInASeriesAreOneLine) {
    const QTemporaryDir folder;
    const database::Store store = database::Store::create(folder.filePath("fibres.db").toStdString());
    const database::Session station = store.station_session();
    database::AttemptMeta meta;
    meta.person_id = database::People(store).ensure_synthetic(station, "fibres", "Fibres (synthetic)").id;
    meta.task_id = "B2";
    meta.device_class = DeviceClass::synthetic;
    database::Recorder recorder(store.path(), station, meta);
    const auto happen = [&](std::uint32_t tick, EventKind kind, float value) {
        Event event;
        event.tick = tick;
        event.kind = kind;
        event.value = value;
        recorder.append(event);
    };
    for (std::uint32_t tick = 1; tick <= 6000; ++tick) {
        RigSample input;
        TickSample sample;
        input.tick = sample.tick = tick;
        recorder.append(input);
        recorder.append(sample);
        const bool parts = (tick >= 1000 && tick <= 2500) || (tick >= 4000 && tick < 4100);
        if (!parts || tick % 20 != 0) continue;
        happen(tick, EventKind::fibres_parted, 0.02F);
        happen(tick, EventKind::cut_advance, 0.0205F);
        happen(tick, EventKind::cut_traction, 26.0F);
    }
    database::AttemptResult result;
    result.state = AttemptState::completed;
    result.duration_s = 6;
    recorder.finish(result);
    const auto model = load_attempt(store, station, recorder.attempt_id(), std::nullopt, {});
    ASSERT_TRUE(model.has_value());
    ASSERT_EQ(model->events.size(), 2U);
    EXPECT_DOUBLE_EQ(model->events[0].time, 1.0);
    EXPECT_DOUBLE_EQ(model->events[1].time, 4.0);
    for (const EventLine& line : model->events) {
        EXPECT_TRUE(line.severe);
        EXPECT_FALSE(line.critical);
        EXPECT_EQ(line.words, "Fibres tore under too much tension");
    }
}

TEST(EventLines, ANerveUnderABladeIsNotInjuredByHeat) {
    Event event;
    event.kind = EventKind::nerve_injury;
    event.detail = detail_of(NerveInjury{1, InjuryCause::blade});
    EXPECT_EQ(event_words(event, {}), "Nerve divided by a blade");
    event.detail = detail_of(NerveInjury{1, InjuryCause::heat});
    EXPECT_EQ(event_words(event, {}), "Nerve injured by heat");
}

TEST(EventLines, SayNumbersInTheUnitsOfTheClinic) {
    Event event;
    event.kind = EventKind::over_force_begin;
    event.hand = 0;
    event.tissue = 0;
    event.value = 6.0F;
    EXPECT_EQ(event_words(event, {"bowel"}), "Too much force: 6 N, left hand, bowel");
    event.detail = 4000;
    EXPECT_EQ(event_words(event, {"bowel"}), "Too much force: 6 N (limit 4 N), left hand, bowel");
    event = {};
    event.kind = EventKind::activation_begin;
    event.value = 1.5e-3F;
    EXPECT_EQ(event_words(event, {}), "Energy on 1.5 mm from the nerve");
    event.detail = detail_of(Activation{true, true, true});
    EXPECT_EQ(event_words(event, {}), "Energy on");
    event = {};
    event.kind = EventKind::band_divided;
    event.detail = 1;
    event.value = 2.5F;
    EXPECT_EQ(event_words(event, {}), "Band 2 divided at 2.5 N");
}

TEST(EventLines, ArePenaltiesAndCriticalByTheirTable) {
    EXPECT_TRUE(is_critical(EventKind::perforation));
    EXPECT_TRUE(is_penalty(EventKind::perforation));
    EXPECT_TRUE(is_penalty(EventKind::drop));
    EXPECT_FALSE(is_critical(EventKind::drop));
    EXPECT_FALSE(is_penalty(EventKind::grasp));
    EXPECT_FALSE(is_penalty(EventKind::goal_progress));
}

TEST(EventLines, EveryTypeHasTheLineOfItsRow) {
    for (const EventType& type : event_kinds) {
        Event event;
        event.kind = type.kind;
        event.value = 1;
        const QString words = event_words(event, {});
        EXPECT_EQ(words.isEmpty(), type.line == LineContent::none) << type.name;
        EXPECT_FALSE(words.contains('%')) << type.name << ": " << words.toStdString();
        if (type.line != LineContent::name) continue;
        QString name = event_text(type.name);
        name[0] = name[0].toUpper();
        EXPECT_EQ(words.toStdString(), name.toStdString());
    }
    Event newer;
    newer.kind = static_cast<EventKind>(std::size(event_kinds));
    EXPECT_TRUE(event_words(newer, {}).isEmpty());
    EXPECT_FALSE(is_penalty(newer.kind));
}

TEST(EventLines, TinyPiecesHaveNoLine) {
    Event event;
    event.kind = EventKind::piece_fallen;
    event.value = 5e-9F;
    EXPECT_TRUE(event_words(event, {}).isEmpty());
    event.value = 3e-6F;
    EXPECT_EQ(event_words(event, {}), "A piece of 3 mm² came free");
}

}  // namespace
}  // namespace fulcrum::ui
