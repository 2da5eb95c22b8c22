// SPDX-License-Identifier: GPL-3.0-or-later
// The command that makes the demonstration: it can be stopped and resumed, and what it makes is a good store.
#include "app/lab/demonstration.h"

#include <gtest/gtest.h>

#include <QLockFile>
#include <QTemporaryDir>
#include <filesystem>
#include <fstream>
#include <future>
#include <iterator>
#include <map>
#include <set>

#include "app/lab/demonstration_plan.h"
#include "app/services/demo.h"
#include "database/records/attempts.h"
#include "database/rows/connection.h"
#include "database/rows/packed_bytes.h"
#include "database/schema/migration.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {
namespace {

namespace fs = std::filesystem;

struct Found {
    std::int64_t started;
    std::string task, variant;
    double points;
    std::string hash;
    bool operator==(const Found& other) const {
        return started == other.started && task == other.task && variant == other.variant &&
               points == other.points && hash == other.hash;
    }
};

std::vector<Found> attempts_in(const std::string& path) {
    const database::Store store = database::Store::open(path);
    EXPECT_TRUE(store.check(store.station_session()).ok);
    std::vector<Found> found;
    for (const database::AttemptSummary& one : database::Attempts(store).list(store.station_session())) {
        found.push_back(
            {one.meta.started, one.meta.task_id, one.meta.variant, one.points.value_or(-1), one.state_hash});
        EXPECT_TRUE(one.synthetic);
        EXPECT_GE(one.meta.started, demo_begin + 70 * demo_day);
        EXPECT_LT(one.meta.started, demo_begin + 84 * demo_day);
    }
    return found;
}

TEST(DemonstrationBuild, StoppedAndResumedMakesTheSameProgramme) {
    const QTemporaryDir folder;
    const auto path = [&](const char* name) { return folder.filePath(name).toStdString(); };
    DemonstrationRequest request;
    request.output = path("whole.zst");
    request.size.trainees = 2;
    request.size.weeks = 2;
    const DemonstrationResult whole = build_demonstration(request);
    ASSERT_TRUE(whole.complete);
    ASSERT_GE(whole.attempts, 6);
    EXPECT_FALSE(fs::exists(request.output + ".work"));

    request.output = path("parts.zst");
    int runs = 0;
    DemonstrationResult last;
    do {
        // Each run is stopped in the middle of the second attempt that it makes.
        std::string first, line;
        int begun = 0;
        request.progress = [&](double, const std::string& now) {
            if (now != line) ++begun;
            line = now;
            return begun < 4 || runs > 3;
        };
        last = build_demonstration(request);
        if (!last.complete) {
            EXPECT_FALSE(fs::exists(request.output));
            EXPECT_TRUE(fs::exists(request.output + ".work"));
        }
    } while (!last.complete && ++runs < 10);
    ASSERT_TRUE(last.complete);
    EXPECT_GE(runs, 1);
    ASSERT_TRUE(unpack_demo_file(path("whole.zst"), path("whole.db"), {}));
    ASSERT_TRUE(unpack_demo_file(path("parts.zst"), path("parts.db"), {}));
    const std::vector<Found> in_whole = attempts_in(path("whole.db"));
    EXPECT_EQ(in_whole.size(), static_cast<std::size_t>(whole.attempts));
    EXPECT_EQ(in_whole, attempts_in(path("parts.db")));
}

TEST(DemonstrationBuild, OfAnySizeGivesEachTraineeItsAttemptsAndAnotherSeedOtherOnes) {
    const QTemporaryDir folder;
    std::set<std::string> hashes;
    std::size_t made = 0;
    for (const DemoSize& size : {DemoSize{2, 1, 6, 0}, DemoSize{1, 1, 2, 1}}) {
        DemonstrationRequest request;
        request.output = folder.filePath("sized.zst").toStdString();
        request.size = size;
        const DemonstrationResult result = build_demonstration(request);
        ASSERT_TRUE(result.complete);
        const std::string path = folder.filePath(QString::number(size.seed)).toStdString();
        ASSERT_TRUE(unpack_demo_file(request.output, path, {}));
        std::map<std::string, int> of;
        const database::Store store = database::Store::open(path);
        for (const database::AttemptSummary& one : database::Attempts(store).list(store.station_session())) {
            ++of[one.person_login];
            hashes.insert(one.state_hash);
            ++made;
        }
        EXPECT_EQ(of.size(), size.trainees);
        for (const auto& [login, attempts] : of) EXPECT_EQ(attempts, size.attempts) << login;
    }
    EXPECT_EQ(hashes.size(), made) << "no attempt is made twice";
}

TEST(DemonstrationBuild, OfAnotherPlanOrBySomebodyElseIsRefused) {
    const QTemporaryDir folder;
    DemonstrationRequest request;
    request.output = folder.filePath("demo.zst").toStdString();
    request.size.trainees = 1;
    request.size.weeks = 1;
    // Stopped in the first attempt after a whole day.
    request.progress = [&](double, const std::string&) {
        for (const auto& file : fs::directory_iterator(request.output + ".work"))
            if (file.path().filename().string().rfind("day-", 0) == 0) return false;
        return true;
    };
    ASSERT_FALSE(build_demonstration(request).complete);
    DemonstrationRequest other = request;
    other.size.trainees = 2;
    EXPECT_THROW(build_demonstration(other), InputError);
    QLockFile lock(QString::fromStdString(request.output + ".work/lock"));
    ASSERT_TRUE(lock.tryLock(0));
    EXPECT_THROW(build_demonstration(request), InputError);
}

void pack(const std::string& content, const std::string& path) {
    const std::vector<std::uint8_t> packed = database::pack_bytes({content.begin(), content.end()}, 19);
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(packed.data()), static_cast<std::streamsize>(packed.size()));
}

TEST(DemonstrationUnpacking, BringsAnOlderStoreUpToDate) {
    const QTemporaryDir folder;
    const std::string old = folder.filePath("old.db").toStdString(),
                      packed = folder.filePath("old.zst").toStdString(),
                      path = folder.filePath("demo.db").toStdString();
    const int before = database::Store::schema_version() - 1;
    {
        database::Connection connection(old, false, true, 1000);
        connection.execute("PRAGMA application_id = " + QString::number(database::application_id));
        database::migrate(connection, before);
        connection.execute("INSERT INTO station (id, name, created) VALUES ('s', 'Demonstration', 0)");
        connection.execute(
            "INSERT INTO setting (key, value) VALUES ('this_station', 's'), ('demo', '1'), ('demo_sealed', "
            "'1')");
    }
    std::ifstream file(old, std::ios::binary);
    pack({(std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>()}, packed);
    ASSERT_TRUE(unpack_demo_file(packed, path, {}));
    database::StoreOptions options;
    options.read_only = true;
    const database::Store store = database::Store::open(path, options);
    EXPECT_EQ(store.found_schema(), database::Store::schema_version());
    EXPECT_TRUE(store.is_demo());
    for (const auto& left : fs::directory_iterator(folder.path().toStdString()))
        EXPECT_EQ(left.path().filename().string().find("before"), std::string::npos) << left.path();
}

TEST(DemonstrationUnpacking, ByTwoAtOnceGivesBothTheSameStore) {
    const QTemporaryDir folder;
    const auto file = [&](const char* name) { return folder.filePath(name).toStdString(); };
    database::Store::create(file("made.db"), true);
    std::ifstream made(file("made.db"), std::ios::binary);
    pack({(std::istreambuf_iterator<char>(made)), std::istreambuf_iterator<char>()}, file("made.zst"));
    std::vector<std::future<bool>> done;
    for (int i = 0; i < 4; ++i)
        done.push_back(std::async(std::launch::async, [&] {
            if (!unpack_demo_file(file("made.zst"), file("demo.db"), {})) return false;
            const database::Store store = database::Store::open(file("demo.db"));
            return store.check(store.station_session()).ok;
        }));
    for (std::future<bool>& one : done) EXPECT_TRUE(one.get());
    EXPECT_FALSE(fs::exists(file("demo.db.unpacking")));
    EXPECT_FALSE(fs::exists(file("demo.db.lock")));
}

TEST(DemonstrationUnpacking, RefusesWhatIsDamagedAndLeavesNothing) {
    const QTemporaryDir folder;
    const std::string packed = folder.filePath("demo.zst").toStdString(),
                      path = folder.filePath("demo.db").toStdString();
    std::ofstream(packed) << "not a packed store";
    EXPECT_THROW(unpack_demo_file(packed, path, {}), database::StoreError);
    EXPECT_THROW(unpack_demo_file(packed + "x", path, {}), InputError);
    const std::string other = folder.filePath("other.zst").toStdString();
    pack("no store at all", other);
    EXPECT_THROW(unpack_demo_file(other, path, {}), database::StoreError);
    EXPECT_FALSE(fs::exists(path));
    EXPECT_FALSE(fs::exists(path + ".unpacking"));
}

}  // namespace
}  // namespace fulcrum::app
