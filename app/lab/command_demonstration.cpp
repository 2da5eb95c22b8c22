// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum lab demonstration: makes the programme that *Look around* opens.
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/lab/demonstration.h"
#include "app/lab/demonstration_plan.h"
#include "sim_core/numerics/files.h"

namespace fulcrum::app {
namespace {

std::atomic<bool> stop_demonstration{false};

/// The first interrupt ends the run so that it can be resumed, the second one the program.
void note_stop(int number) {
    stop_demonstration = true;
    std::signal(number, SIG_DFL);
}

/// A line when another attempt begins, at most one a second.
class ProgressLines {
  public:
    bool operator()(double done, const std::string& line) {
        const auto now = std::chrono::steady_clock::now();
        if (line != last_ && now - printed_ >= std::chrono::seconds(1)) {
            last_ = line;
            printed_ = now;
            std::fprintf(stderr, "%5.1f %%  %s\n", 100 * done, line.c_str());
        }
        return !stop_demonstration;
    }

  private:
    std::string last_;
    std::chrono::steady_clock::time_point printed_;
};

}  // namespace

int run_demonstration(const Arguments& arguments) {
    DemonstrationRequest request;
    request.output = arguments.value_or("--output", "demonstration.db.zst");
    DemoSize& size = request.size;
    size.trainees = static_cast<std::size_t>(arguments.integer("--trainees", 24, 1, most_demo_trainees));
    size.weeks = static_cast<int>(arguments.integer("--weeks", size.weeks, 1, demo_days / 7));
    size.attempts = static_cast<int>(arguments.integer("--attempts", 0, 1, most_demo_attempts));
    size.seed = static_cast<int>(arguments.integer("--seed", 0, 0, most_demo_seed));
    require_writable_file(request.output);
    ProgressLines lines;
    request.progress = [&](double done, const std::string& line) { return lines(done, line); };
    const auto interrupt = std::signal(SIGINT, note_stop), terminate = std::signal(SIGTERM, note_stop);
    const DemonstrationResult result = build_demonstration(request);
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, terminate);
    if (arguments.has("--json")) {
        print_json({{"complete", result.complete},
                    {"attempts", result.attempts},
                    {"traces", result.traces},
                    {"bytes", result.bytes},
                    {"packed_bytes", result.packed_bytes}});
    } else if (result.complete) {
        std::cout << request.output << ": " << result.attempts << " attempts, " << result.traces
                  << " with their trace, " << result.bytes << " bytes, packed " << result.packed_bytes
                  << '\n';
    } else {
        std::cout << "stopped after " << result.attempts
                  << " attempts; the same command resumes with the day that was not finished\n";
    }
    return result.complete ? 0 : 1;
}

}  // namespace fulcrum::app
