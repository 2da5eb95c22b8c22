// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/overseer.h"

#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <deque>
#include <nlohmann/json.hpp>
#include <system_error>

#include "sim_core/devices/packets.h"
#include "sim_core/devices/sentence_packet.h"
#include "sim_core/hapticd/device_process.h"
#include "sim_core/hapticd/rights.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::hapticd {
namespace {

constexpr int beat_ms = 5;
constexpr int overseer_priority = 86;  // above the device process, which it must be able to stop
constexpr std::int64_t restart_pause = 200'000'000;           // ns
constexpr std::int64_t restart_window = 60000LL * 1'000'000;  // ns
constexpr std::size_t most_restarts = 5;                      // in that time
constexpr std::int64_t time_to_end = 600'000'000;             // ns, for the device process
constexpr std::int64_t reopen_pause = 3000LL * 1'000'000;     // ns, after it did not open again

class Overseer {
  public:
    Overseer(int control, Backend& backend)
        : control_(control),
          backend_(backend),
          state_(SharedPage<StatePage>::create("fulcrum-device-state", true)),
          command_(SharedPage<CommandPage>::create("fulcrum-device-command", false)) {
        sigset_t watched;
        sigemptyset(&watched);
        for (const int number : {SIGCHLD, SIGTERM, SIGINT, SIGHUP}) sigaddset(&watched, number);
        sigprocmask(SIG_BLOCK, &watched, nullptr);
        signals_ = signalfd(-1, &watched, SFD_CLOEXEC | SFD_NONBLOCK);
        if (signals_ < 0) throw std::system_error(errno, std::generic_category(), "signals");
    }
    ~Overseer() {
        end_device();
        close(signals_);
    }
    Overseer(const Overseer&) = delete;
    Overseer& operator=(const Overseer&) = delete;

    int run() {
        become_real_time(overseer_priority);
        if (!start_device()) return 2;
        while (!ended_) {
            pollfd waits[2] = {{control_, POLLIN, 0}, {signals_, POLLIN, 0}};
            state_->overseer_time.store(monotonic_ns(), std::memory_order_relaxed);
            if (poll(waits, 2, beat_ms) < 0 && errno != EINTR) return 1;
            state_->overseer_time.store(monotonic_ns(), std::memory_order_relaxed);
            if (waits[1].revents != 0) take_signals();
            if (waits[0].revents != 0) take_packets();
            if (device_ == 0 && restart_at_ != 0 && monotonic_ns() >= restart_at_) {
                restart_at_ = 0;
                if (!start_device() && restart_allowed()) restart_at_ = monotonic_ns() + reopen_pause;
            }
        }
        return 0;
    }

  private:
    /// False where the device does not open; the program gets the reason in either case.
    bool start_device() {
        int ends[2];
        make_socket_pair(ends);
        state_->stopping.store(0);
        const pid_t own = getpid();
        state_->overseer_time.store(monotonic_ns());
        state_->connection.store(connections_);
        const pid_t child = fork();
        if (child < 0) {
            close(ends[0]);
            close(ends[1]);
            refuse({{"error", sentence_packet(QT_TRANSLATE_NOOP("errors", "no new process can be started"))},
                    {"hint", sentence_packet(QT_TRANSLATE_NOOP("errors", "close other programs"))}});
            return false;
        }
        if (child == 0) {
            prctl(PR_SET_PDEATHSIG, 0);
            sigset_t none;
            sigemptyset(&none);
            sigprocmask(SIG_SETMASK, &none, nullptr);
            for (const int number : {SIGTERM, SIGINT, SIGHUP})
                signal(number, SIG_IGN);  // the overseer decides
            close(control_);
            close(ends[0]);
            _exit(run_device(backend_, *state_.get(), *command_.get(), own, ends[1]));
        }
        device_ = child;
        close(ends[1]);
        const bool opened = greet(ends[0]);
        close(ends[0]);
        if (!opened) end_device();
        return opened;
    }

    /// Waits for the line of the device process and passes it on with the pages.
    bool greet(int socket) {
        const std::int64_t until = monotonic_ns() + 5000LL * 1'000'000;
        while (monotonic_ns() < until) {
            state_->overseer_time.store(monotonic_ns());
            const std::optional<Packet> packet = receive_packet(socket, beat_ms);
            if (!packet) continue;
            if (packet->ended) {
                refuse({{"error", sentence_packet(QT_TRANSLATE_NOOP(
                                      "errors", "the program that opens the device ended"))},
                        {"hint", sentence_packet(QT_TRANSLATE_NOOP(
                                     "errors", "install the newest version of the maker's driver"))}});
                return false;
            }
            nlohmann::json line = nlohmann::json::parse(packet->text, nullptr, false);
            if (!line.is_object() || line.contains("error")) {
                refuse(line);
                return false;
            }
            line["process"] = device_;
            line["format"] = 1;
            line["event"] = "started";
            if (greeted_) return send_packet(control_, line);
            greeted_ = true;
            return send_packet(control_, line, {state_.descriptor(), command_.descriptor()});
        }
        refuse({{"error", sentence_packet(QT_TRANSLATE_NOOP("errors", "the device did not open within 5 s"))},
                {"hint", sentence_packet(QT_TRANSLATE_NOOP("errors", "unplug it, connect it again"))}});
        return false;
    }

    /// The device does not open. The program gives up, unless it had been open: then it is tried again.
    void refuse(nlohmann::json why) {
        why["again"] = greeted_ && restarts_.size() < most_restarts;
        send_packet(control_, why);
    }

    void take_signals() {
        signalfd_siginfo info;
        while (read(signals_, &info, sizeof info) == static_cast<ssize_t>(sizeof info)) {
            if (info.ssi_signo != SIGCHLD) ended_ = true;
        }
        if (device_ == 0) return;
        int status = 0;
        if (waitpid(device_, &status, WNOHANG | WUNTRACED) != device_) return;
        if (WIFSTOPPED(status)) {  // its motors hold the last force: closing the device frees them
            kill(device_, SIGKILL);
            int killed = 0;
            while (waitpid(device_, &killed, 0) < 0 && errno == EINTR) {
            }
        } else if (!WIFEXITED(status) && !WIFSIGNALED(status)) {
            return;
        }
        device_ = 0;
        switch_off();
        const bool again = restart_allowed();
        if (again) restart_at_ = monotonic_ns() + restart_pause;
        const bool lost = WIFEXITED(status) && WEXITSTATUS(status) == status_lost;
        const Sentence what =
            lost                 ? Sentence(QT_TRANSLATE_NOOP("errors", "lost the device"))
            : WIFSTOPPED(status) ? Sentence(QT_TRANSLATE_NOOP("errors", "was stopped"))
            : WIFSIGNALED(status)
                ? Sentence(QT_TRANSLATE_NOOP("errors", "was ended by signal %1"), WTERMSIG(status))
                : Sentence(QT_TRANSLATE_NOOP("errors", "ended with status %1"), WEXITSTATUS(status));
        send_packet(control_, {{"event", "ended"}, {"what", sentence_packet(what)}, {"again", again}});
    }

    /// Counts one more where it is.
    bool restart_allowed() {
        const std::int64_t now = monotonic_ns();
        while (!restarts_.empty() && now - restarts_.front() > restart_window) restarts_.pop_front();
        if (restarts_.size() >= most_restarts) return false;
        restarts_.push_back(now);
        return true;
    }

    void take_packets() {
        while (const std::optional<Packet> packet = receive_packet(control_, 0)) {
            for (const int descriptor : packet->descriptors) close(descriptor);
            if (packet->ended) {
                ended_ = true;
                return;
            }
        }
    }

    /// After the end of the device process: its device was closed by the system.
    void switch_off() {
        const std::int64_t now = monotonic_ns();
        for (int h = 0; h < 2; ++h) {
            backend_.render(h, Vector3::Zero(), 0);
            ForceReport report;
            report.time = now;
            report.off = static_cast<std::uint64_t>(ForceOff::device_stopped);
            state_->report[h].write(report);
        }
        state_->fault.write({});
    }

    void end_device() {
        state_->connection.store(0);  // the force is 0 from the next tick on
        state_->stopping.store(1);
        if (device_ == 0) return;
        const std::int64_t until = monotonic_ns() + time_to_end;
        int status = 0;
        while (waitpid(device_, &status, WNOHANG) == 0) {
            if (monotonic_ns() > until) {
                kill(device_, SIGKILL);
                while (waitpid(device_, &status, 0) < 0 && errno == EINTR) {
                }
                break;
            }
            state_->overseer_time.store(monotonic_ns());
            poll(nullptr, 0, 1);
        }
        device_ = 0;
        switch_off();
    }

    int control_;
    Backend& backend_;
    SharedPage<StatePage> state_;
    SharedPage<CommandPage> command_;
    int signals_ = -1;
    pid_t device_ = 0;
    std::uint64_t connections_ = 1;
    std::int64_t restart_at_ = 0;
    std::deque<std::int64_t> restarts_;
    bool greeted_ = false, ended_ = false;
};

}  // namespace

int oversee(int control, const std::string& specification) {
    try {
        const std::unique_ptr<Backend> backend = make_backend(specification);
        return Overseer(control, *backend).run();
    } catch (const InputError& error) {
        send_packet(control, {{"error", sentence_packet(error.problem_sentence())},
                              {"file", error.file()},
                              {"place", error.place()},
                              {"hint", sentence_packet(error.hint_sentence())}});
        return 2;
    } catch (const std::exception& error) {
        send_packet(control, {{"error", error.what()}});
        return 1;
    }
}

}  // namespace fulcrum::hapticd
