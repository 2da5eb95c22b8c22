// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/database/processes.h"

#include <fcntl.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <system_error>

#include "database/store/store_state.h"
#include "database/sync/sync.h"
#include "database/xapi/record_store.h"
#include "tests/database/deeds_journal.h"
#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {

ChildCounters& counters_in(const std::string& folder) {
    const int file = ::open((folder + "/counters").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    void* memory = MAP_FAILED;
    if (file >= 0 && ::ftruncate(file, sizeof(ChildCounters)) == 0)
        memory = ::mmap(nullptr, sizeof(ChildCounters), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (memory == MAP_FAILED) std::abort();
    ::close(file);
    return *static_cast<ChildCounters*>(memory);
}

pid_t start_child(const std::string& name, const std::string& folder, int number) {
    const pid_t child = ::fork();
    if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (child == 0) {
        ::execl("/proc/self/exe", "test_database", "--child", name.c_str(), folder.c_str(),
                std::to_string(number).c_str(), static_cast<char*>(nullptr));
        ::_exit(127);
    }
    return child;
}

int wait_for_child(pid_t child) {
    int status = 0;
    if (::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
    return WEXITSTATUS(status);
}

bool kill_child(pid_t child) {
    int status = 0;
    ::kill(child, SIGKILL);
    return ::waitpid(child, &status, 0) == child && WIFSIGNALED(status);
}

bool is_running(pid_t child) {
    return ::waitpid(child, nullptr, WNOHANG) == 0;
}

namespace {

/// One operation on the store: counts how it ended and how long it took. Only `locked` may be tried again.
template <typename Action>
bool counted(ChildCounters& counters, Action&& action) {
    const auto start = std::chrono::steady_clock::now();
    bool done = false;
    try {
        action();
        done = true;
    } catch (const StoreError& error) {
        (error.kind() == StoreErrorKind::locked ? counters.refused : counters.failed).fetch_add(1);
        std::fprintf(stderr, "child %d: %s\n", static_cast<int>(::getpid()), error.what());
    }
    const auto took = static_cast<std::uint32_t>(
        std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start)
            .count());
    std::uint32_t longest = counters.longest_ms.load();
    while (took > longest && !counters.longest_ms.compare_exchange_weak(longest, took)) {
    }
    return done;
}

std::string store_in(const std::string& folder) {
    return folder + "/fulcrum.db";
}

AttemptMeta synthetic_meta(const std::string& person_id) {
    AttemptMeta meta = example_meta(person_id);
    meta.device_class = DeviceClass::synthetic;
    return meta;
}

/// A short attempt and its score; counted as acknowledged when finish() has returned.
void store_a_score(const std::string& path, const Session& session, const std::string& person_id,
                   ChildCounters& counters) {
    Recorder recorder(path, session, synthetic_meta(person_id));
    Programme::append_second(recorder);
    recorder.finish(example_result(true, 50));
    counters.acknowledged.fetch_add(1);
}

/// The window: signed in, an attempt is recorded, and every page opens the store for itself and closes it.
int window(const std::string& folder, int) {
    ChildCounters& counters = counters_in(folder);
    const std::string path = store_in(folder);
    const Store store = Store::open(path);
    const Session station = store.station_session();
    const std::string person = People(store).ensure_synthetic(station, "synthetic-1", "Synthetic").id;
    Recorder running(path, station, synthetic_meta(person));
    counters.begun.fetch_add(1);
    StoreOptions reading;
    reading.read_only = true;
    for (std::uint32_t second = 0;; ++second) {
        counted(counters, [&] { Programme::append_second(running, second * 1000); });
        counted(counters, [&] {
            const Store page = Store::open(path, reading);
            Attempts(page).list(station);
        });
        counted(counters, [&] { store_a_score(path, station, person, counters); });
    }
}

/// One command of the program in a terminal.
int command(const std::string& folder, int) {
    const Store store = Store::open(store_in(folder));
    return Attempts(store).list(store.station_session()).empty() ? 3 : 0;
}

/// The same with somebody else's program.
int foreign_program(const std::string& folder, int) {
    sqlite3* handle = nullptr;
    int code = sqlite3_open(store_in(folder).c_str(), &handle);
    if (code == SQLITE_OK) {
        sqlite3_busy_timeout(handle, 5000);
        code = sqlite3_exec(handle, "SELECT COUNT(*) FROM attempt", nullptr, nullptr, nullptr);
    }
    sqlite3_close(handle);
    return code;
}

/// `rounds` times: open the store, read, write a score, close it.
int rounds(const std::string& folder, int count) {
    ChildCounters& counters = counters_in(folder);
    const std::string path = store_in(folder);
    counters.begun.fetch_add(1);
    for (int round = 0; round < count; ++round) {
        counted(counters, [&] {
            const Store store = Store::open(path);
            const Session station = store.station_session();
            const std::string person = People(store).ensure_synthetic(station, "synthetic-1", "Synthetic").id;
            AttemptFilter newest;
            newest.limit = 5;
            Attempts(store).list(station, newest);
            store_a_score(path, station, person, counters);
        });
    }
    return 0;
}

int create(const std::string& folder, int) {
    counters_in(folder).begun.fetch_add(1);
    const Store store = Store::open_or_create(store_in(folder));
    return 0;
}

int backup(const std::string& folder, int) {
    const Store store = Store::open(store_in(folder));
    counters_in(folder).begun.fetch_add(1);
    return copy_database(store.connection(), folder + "/copy.db") ? 0 : 3;
}

int open_older(const std::string& folder, int) {
    counters_in(folder).begun.fetch_add(1);
    const Store store = Store::open(store_in(folder));
    return 0;
}

/// Exchanges with the server whose address is in the file `server`; killed before its statement `number` to
/// it.
int sync(const std::string& folder, int number) {
    std::string address;
    std::getline(std::ifstream(folder + "/server"), address);
    const ManualClock clock;
    const Store store = Store::open(folder + "/fulcrum.db", clock.options());
    const Session session = People(store).sign_in("administrator", password);
    SyncOptions options;
    options.stop = [&number] {
        if (--number == 0) ::raise(SIGKILL);
        return false;
    };
    return sync_with_server(store, session, ServerAddress::parse(address), options).complete ? 0 : 1;
}

/// Sends what waits to the record store of the tests at this port.
int xapi(const std::string& folder, int port) {
    const ManualClock clock;
    const Store store = Store::open(folder + "/fulcrum.db", clock.options());
    const Session session = People(store).sign_in("director", password);
    const std::string address = "http://127.0.0.1:" + std::to_string(port) + "/xapi";
    RecordStore record_store(address, "key:secret", 5000);
    return send_waiting(XapiOutbox(store, session, address), record_store).complete ? 0 : 1;
}

}  // namespace

int run_child(const std::string& name, const std::string& folder, int number) {
    const std::map<std::string, int (*)(const std::string&, int)> children = {
        {"window", window},
        {"command", command},
        {"foreign", foreign_program},
        {"rounds", rounds},
        {"create", create},
        {"backup", backup},
        {"migrate", open_older},
        {"sync", sync},
        {"xapi", xapi},
        {"review", review_until_killed},
        {"exchange", exchange_until_killed}};
    try {
        return children.at(name)(folder, number);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "child %s: %s\n", name.c_str(), error.what());
        return 4;
    }
}

}  // namespace fulcrum::database::test
