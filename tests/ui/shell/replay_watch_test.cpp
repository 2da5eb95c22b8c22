// SPDX-License-Identifier: GPL-3.0-or-later
// Replays are made ready while somebody is signed in and no attempt runs.
#include "ui/shell/replay_watch.h"

#include <gtest/gtest.h>

#include <QTest>

#include "tests/ui/fake_services.h"
#include "tests/ui/four_people.h"

namespace fulcrum::ui::window_test {
namespace {

TEST(ReplayWatch, LooksWhileSomebodyIsSignedInAndNoAttemptRuns) {
    FakeServices services;
    services.open_store(false);
    const auto people = make_four_people(*services.store());
    const database::Session& tara = people.at(database::Role::trainee);
    Context context(services);
    bool runs = true;
    int asked = 0;
    const ReplayWatch watch(
        context,
        [&] {
            ++asked;
            return runs;
        },
        nullptr, 1, 2);
    QTest::qWait(20);
    EXPECT_EQ(asked, 0) << "nobody is signed in";
    context.set_session(tara);
    EXPECT_TRUE(QTest::qWaitFor([&] { return asked > 2; }));
    EXPECT_TRUE(services.prepared.empty()) << "an attempt runs";
    runs = false;
    EXPECT_TRUE(QTest::qWaitFor([&] { return services.prepared.size() > 2; })) << "again and again";
    EXPECT_EQ(services.prepared.front(), tara.person_id());
    const int stopped = services.stopped_preparing;
    context.sign_out();
    EXPECT_EQ(services.stopped_preparing, stopped + 1);
    services.prepared.clear();
    QTest::qWait(20);
    EXPECT_TRUE(services.prepared.empty());
}

}  // namespace
}  // namespace fulcrum::ui::window_test
