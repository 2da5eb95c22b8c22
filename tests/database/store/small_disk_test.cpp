// SPDX-License-Identifier: GPL-3.0-or-later
// A store on a real disk of a few MB (a tmpfs) that becomes full while an attempt is recorded, and on one
// that is mounted read-only. The disk is mounted by a child in a mount namespace of its own, and ends with
// it.
#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <functional>

#include "database/store/store_restore.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

namespace files = std::filesystem;

constexpr int cannot_mount = 77;

bool mount_small_disk(const std::string& folder) {
    return ::unshare(CLONE_NEWNS) == 0 && ::mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
           ::mount("fulcrum-test", folder.c_str(), "tmpfs", 0, "size=6m") == 0;
}

/// Runs `deed` in a child, in which `folder` is a disk of 6 MB. Its exit status: 1 if an expectation failed.
int on_small_disk(const std::string& folder, const std::function<void()>& deed) {
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child == 0) {
        if (!mount_small_disk(folder)) ::_exit(cannot_mount);
        qputenv("TMPDIR", QByteArray::fromStdString(folder));
        try {
            deed();
        } catch (const std::exception& error) {
            ADD_FAILURE() << "thrown: " << error.what();
        }
        std::fflush(nullptr);
        ::_exit(::testing::Test::HasFailure() ? 1 : 0);
    }
    int status = 0;
    if (child < 0 || ::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status);
}

/// A file that takes what is left of the disk but for `left` bytes.
class Ballast {
  public:
    explicit Ballast(const std::string& folder) : path_(folder + "/ballast") {}
    void leave(std::uintmax_t left) const {
        const int file = ::open(path_.c_str(), O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, 0600);
        const std::uintmax_t free = files::space(path_).available;
        const std::string bytes(free > left ? free - left : 0, 'x');
        std::size_t written = 0;
        while (written < bytes.size()) {
            const ssize_t now = ::write(file, bytes.data() + written, bytes.size() - written);
            if (now <= 0) break;
            written += static_cast<std::size_t>(now);
        }
        ::close(file);
    }
    void remove() const { files::remove(path_); }

  private:
    std::string path_;
};

/// The error says that the disk is full, where, and what to do.
template <typename Call>
void expect_full(const std::string& folder, Call&& call) {
    try {
        call();
        ADD_FAILURE() << "nothing was thrown";
    } catch (const StoreError& error) {
        EXPECT_EQ(error.kind(), StoreErrorKind::disk_full) << error.what();
        EXPECT_NE(error.problem().find(folder), std::string::npos) << error.problem();
        EXPECT_NE(error.hint().find("free some space"), std::string::npos) << error.hint();
    }
}

void expect_whole(const Programme& programme) {
    const CheckReport report = programme.store->check(programme.session("station"));
    for (const CheckItem& item : report.items)
        for (const Sentence& problem : item.problems) ADD_FAILURE() << item.name << ": " << problem.words();
}

class SmallDisk : public ::testing::Test {
  protected:
    void SetUp() override { const Programme made_before_the_fork; }
    void run(const std::function<void()>& deed) {
        const int status = on_small_disk(folder, deed);
        if (status == cannot_mount) GTEST_SKIP() << "only root may mount a disk of its own";
        EXPECT_EQ(status, 0);
    }
    QTemporaryDir place;
    const std::string folder = place.path().toStdString();
};

TEST_F(SmallDisk, ThatIsFullWhileAnAttemptIsRecordedLosesNothingAcknowledged) {
    run([this] {
        Programme programme;
        ASSERT_EQ(programme.path.rfind(folder, 0), 0U) << "not on the small disk";
        const std::string first = programme.record("ann", true, 81);
        const Ballast ballast(folder);
        Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                          programme.clock.options());
        ballast.leave(400'000);
        std::uint32_t seconds = 0;
        expect_full(folder, [&] {
            for (; seconds < 2000; ++seconds) Programme::append_second(recorder, seconds * 1000);
        });
        EXPECT_GT(seconds, 2U);
        EXPECT_GT(recorder.records_waiting(), 0U) << "what was not written is kept";
        ballast.leave(0);
        expect_full(folder, [&] { recorder.flush(); });
        expect_full(folder, [&] { recorder.finish(example_result(true, 62)); });
        EXPECT_FALSE(recorder.finished());
        expect_full(folder, [&] {
            programme.store->backup(programme.session("administrator"), folder + "/backup.db");
        });
        EXPECT_FALSE(files::exists(folder + "/backup.db"));
        EXPECT_EQ(programme.attempts().score(programme.session("ann"), first)->points, 81) << "still read";

        ballast.remove();
        recorder.finish(example_result(true, 62));
        expect_whole(programme);
        const Session& ann = programme.session("ann");
        const Trace trace = programme.attempts().read_trace(ann, recorder.attempt_id());
        EXPECT_GE(trace.samples.size(), (seconds + 1) * 1000U);
        EXPECT_EQ(trace.samples.size(), trace.inputs.size());
        EXPECT_EQ(programme.attempts().score(ann, recorder.attempt_id())->points, 62);
        EXPECT_EQ(programme.attempts().score(ann, first)->points, 81);
    });
}

TEST_F(SmallDisk, ThatStaysFullUntilTheProgramEndsKeepsEverySecondThatWasWritten) {
    run([this] {
        Programme programme;
        const std::string first = programme.record("ann", true, 81);
        const Ballast ballast(folder);
        std::string attempt;
        std::uint32_t written = 0;
        {
            Recorder recorder(programme.path, programme.session("ann"), example_meta(programme.id("ann")),
                              programme.clock.options());
            attempt = recorder.attempt_id();
            ballast.leave(300'000);
            expect_full(folder, [&] {
                for (;; ++written) {
                    Programme::append_second(recorder, written * 1000);
                    recorder.flush();
                }
            });
        }
        ballast.leave(0);
        programme.store.reset();
        // What is on a full disk can be opened, or the error says why not; it is not taken for damaged.
        try {
            StoreOptions reading = programme.clock.options();
            reading.read_only = true;
            const Store store = Store::open(programme.path, reading);
            EXPECT_EQ(Attempts(store).score(programme.session("ann"), first)->points, 81);
        } catch (const StoreError& error) {
            EXPECT_EQ(error.kind(), StoreErrorKind::disk_full) << error.what();
        }
        try {
            programme.open();
        } catch (const StoreError& error) {
            EXPECT_EQ(error.kind(), StoreErrorKind::disk_full) << error.what();
        }
        ballast.remove();
        programme.open();
        expect_whole(programme);
        const Session& ann = programme.session("ann");
        EXPECT_EQ(programme.attempts().read(ann, attempt).state, AttemptState::interrupted);
        EXPECT_GE(programme.attempts().read_trace(ann, attempt).samples.size(), written * 1000U);
        EXPECT_EQ(programme.attempts().score(ann, first)->points, 81);
    });
}

TEST_F(SmallDisk, ThatIsMountedReadOnlyIsReadAndRefusesToBeWritten) {
    run([this] {
        Programme programme;
        const std::string attempt = programme.record("ann", true, 81);
        const std::string backup = folder + "/backup.db";
        programme.store->backup(programme.session("administrator"), backup);
        programme.store.reset();
        ASSERT_EQ(::mount("none", folder.c_str(), nullptr, MS_REMOUNT | MS_RDONLY, nullptr), 0);
        EXPECT_EQ(error_kind([&] { Store::open(programme.path); }), StoreErrorKind::read_only);
        EXPECT_EQ(error_kind([&] { Store::create(folder + "/new.db"); }), StoreErrorKind::read_only);
        EXPECT_EQ(error_kind([&] { migrate_store(programme.path); }), StoreErrorKind::read_only);
        EXPECT_EQ(error_kind([&] {
                      restore_store(backup, programme.path, [](const Store& copy) {
                          return People(copy).sign_in("administrator", password);
                      });
                  }),
                  StoreErrorKind::read_only);
        StoreOptions reading = programme.clock.options();
        reading.read_only = true;
        {
            const Store store = Store::open(programme.path, reading);
            const Session& ann = programme.session("ann");
            EXPECT_EQ(Attempts(store).score(ann, attempt)->points, 81);
            EXPECT_EQ(Attempts(store).read_trace(ann, attempt).samples.size(), 1000U);
            const CheckReport report = store.check(store.station_session());
            EXPECT_TRUE(report.ok);
            EXPECT_EQ(error_kind([&] { Attempts(store).request_correction(ann, attempt, "not me"); }),
                      StoreErrorKind::read_only);
            EXPECT_EQ(error_kind(
                          [&] { Recorder(programme.path, ann, example_meta(programme.id("ann")), reading); }),
                      StoreErrorKind::read_only);
            EXPECT_EQ(error_kind([&] { store.backup(programme.session("administrator"), folder + "/b"); }),
                      StoreErrorKind::read_only);
        }
        ASSERT_EQ(::mount("none", folder.c_str(), nullptr, MS_REMOUNT, nullptr), 0);
        programme.open();
        programme.record("ann", true, 82);
        expect_whole(programme);
    });
}

}  // namespace
}  // namespace fulcrum::database::test
