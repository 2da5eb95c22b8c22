// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lab/hapticd.h"

#include <atomic>
#include <filesystem>
#include <thread>

#include "app/live/device_trial.h"
#include "sim_core/lab/chart.h"
#include "sim_core/numerics/files.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::app {
namespace {

constexpr const char* script = R"({"format": "fulcrum-device-script", "title": "simulated hand of 0.2 kg",
 "force": {"damping": 0.5, "peak": 3.3, "continuous": 0.88}, "repeat": true,
 "left": {"path": [{"t": 0, "position": [0, 0, 0]}, {"t": 1, "position": [0.02, 0.01, -0.02]},
                   {"t": 2, "position": [0, 0, 0]}], "hand": {"mass": 0.2}}}
)";

/// A folder of this process, removed with its contents.
class ScriptFile {
  public:
    ScriptFile() {
        std::string pattern = (std::filesystem::temp_directory_path() / "fulcrum-hapticd-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr)
            throw InputError(pattern, "", "cannot be made",
                             "free some space, or set TMPDIR to a folder that you may write");
        folder_ = pattern;
        write_whole_file(path(), script);
    }
    ~ScriptFile() {
        std::error_code ignored;
        std::filesystem::remove_all(folder_, ignored);
    }
    ScriptFile(const ScriptFile&) = delete;
    ScriptFile& operator=(const ScriptFile&) = delete;
    std::string path() const { return folder_ + "/hand.json"; }

  private:
    std::string folder_;
};

/// Threads that always have something to do.
class BusyThreads {
  public:
    explicit BusyThreads(unsigned count) {
        for (unsigned i = 0; i < count; ++i)
            threads_.emplace_back([this] {
                while (!stop_.load(std::memory_order_relaxed)) work_.fetch_add(1, std::memory_order_relaxed);
            });
    }
    ~BusyThreads() {
        stop_.store(true);
        for (std::thread& thread : threads_) thread.join();
    }

  private:
    std::atomic<bool> stop_{false};
    std::atomic<std::uint64_t> work_{0};
    std::vector<std::thread> threads_;
};

nlohmann::json to_json(const Durations& durations) {
    return {{"p50", durations.p50_us},
            {"p99", durations.p99_us},
            {"p99_9", durations.p999_us},
            {"worst", durations.worst_us}};
}

}  // namespace

Measured measure_hapticd(double seconds) {
    Measured measured{lab::ResultPage("hapticd", "Delay and jitter of fulcrum-hapticd",
                                      "fulcrum lab hapticd --output docs/results"),
                      {}};
    const ScriptFile file;
    lab::ResultTable table;
    table.name = "hapticd";
    table.columns = {"load", "what", "median (us)", "99 % (us)", "99.9 % (us)", "worst (us)"};
    nlohmann::json runs = nlohmann::json::array();
    std::string counts;
    std::vector<std::string> notes;
    const unsigned processors = std::max(1U, std::thread::hardware_concurrency());
    for (const unsigned busy : {0U, processors}) {
        DaemonClient client(hapticd_program(), "virtual:" + file.path());
        notes = client.notes();
        const BusyThreads load(busy);
        const DeviceTrial trial = try_device(client, seconds, 0.3);
        const std::string name = busy == 0 ? "none" : std::to_string(busy) + " busy threads";
        const auto row = [&](const char* what, const Durations& durations) {
            const auto number = [](double us) { return lab::short_number(us, 4); };
            table.rows.push_back({name, what, number(durations.p50_us), number(durations.p99_us),
                                  number(durations.p999_us), number(durations.worst_us)});
        };
        row("wake-up of the program's own tick, without the daemon", trial.reader_wake);
        row("time between two readings, less the period", trial.device_wake);
        row("pose: from the device to the program's tick", trial.pose_age);
        row("force: from the program to the motors", trial.force_delay);
        counts +=
            "Load " + name + ": " + std::to_string(trial.device_late) + " of " +
            std::to_string(trial.device_ticks) + " ticks of the device process (" +
            std::to_string(trial.device_late_own) + " by its own doing) and " +
            std::to_string(trial.reader_late) + " of " + std::to_string(trial.reader_ticks) +
            " ticks of the program began a period late or more; " + lab::short_number(trial.rate, 5) +
            " readings a second; real-time priority of the program: " + (trial.real_time ? "yes" : "no") +
            ". ";
        runs.push_back({{"busy_threads", busy},
                        {"seconds", trial.seconds},
                        {"rate_hz", trial.rate},
                        {"device_ticks", trial.device_ticks},
                        {"device_late", trial.device_late},
                        {"device_late_own", trial.device_late_own},
                        {"reader_ticks", trial.reader_ticks},
                        {"reader_late", trial.reader_late},
                        {"reader_real_time", trial.real_time},
                        {"reader_wake_us", to_json(trial.reader_wake)},
                        {"jitter_us", to_json(trial.device_wake)},
                        {"pose_age_us", to_json(trial.pose_age)},
                        {"force_delay_us", to_json(trial.force_delay)}});
    }
    measured.page.paragraph(
        "A virtual device with a simulated hand, read at 1 kHz through shared memory by a thread as that of "
        "a "
        "live attempt, which also sends a force of up to 0.3 N; " +
        lab::short_number(seconds, 4) +
        " s for each load. The two processes run on clocks of their own, so a pose and a force are up to one "
        "period old when they are used.");
    measured.page.table(table);
    measured.page.paragraph(counts);
    for (const std::string& note : notes) measured.page.paragraph("Device process: " + note + ".");
    measured.document = {{"hapticd", runs}};
    measured.page.document(measured.document);
    return measured;
}

}  // namespace fulcrum::app
