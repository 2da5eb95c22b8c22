// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum igtl: sends a stored attempt over OpenIGTLink, and records what a server sends as a trace.
#include <algorithm>
#include <cmath>
#include <csignal>
#include <iostream>
#include <limits>
#include <sstream>

#include "app/cli/commands.h"
#include "app/igtl/live_sender.h"
#include "app/live/performance.h"
#include "assessment/trace/events_csv.h"
#include "assessment/trace/trace_csv.h"
#include "database/records/attempts.h"
#include "database/scoring/scoring.h"
#include "sim_core/devices/device_page.h"
#include "sim_core/igtl/server.h"
#include "sim_core/numerics/files.h"
#include "sim_core/numerics/number_text.h"

namespace fulcrum::app {
namespace {

constexpr std::int64_t ms = 1'000'000, second = 1000 * ms;
constexpr std::int64_t patience = 2 * second;  // for a client that is behind; then it is dropped
constexpr int connect_wait_ms = 5000;
constexpr int look_ms = 50;

volatile std::sig_atomic_t igtl_stopped = 0;
void note_igtl_interrupt(int) {
    igtl_stopped = 1;
}

/// Ctrl-C ends the command with what it has.
class EndsOnInterrupt {
  public:
    EndsOnInterrupt() {
        igtl_stopped = 0;
        interrupt_ = std::signal(SIGINT, note_igtl_interrupt);
        terminate_ = std::signal(SIGTERM, note_igtl_interrupt);
    }
    ~EndsOnInterrupt() {
        std::signal(SIGINT, interrupt_);
        std::signal(SIGTERM, terminate_);
    }
    EndsOnInterrupt(const EndsOnInterrupt&) = delete;
    EndsOnInterrupt& operator=(const EndsOnInterrupt&) = delete;

  private:
    void (*interrupt_)(int);
    void (*terminate_)(int);
};

/// Sends the rows of a trace that are attempt, neither pause nor what follows the end, at their own pace, and
/// its events.
class Served {
  public:
    /// `events`: by time. `from`: the trace's time at which the attempt began, s.
    Served(igtl::Server& server, const Trace& trace, std::vector<Event> events, const WireScene& scene,
           double from, int rate, int speed)
        : server_(server),
          trace_(trace),
          events_(std::move(events)),
          scene_(scene),
          from_(from),
          rate_(rate),
          speed_(speed) {}

    void run() {
        start_ = wall_clock_ns() - std::llround(from_ * 1e9);
        begun_ = monotonic_ns() - static_cast<std::int64_t>(from_ * 1e9 / speed_);
        server_.send(begin_of(scene_, start_, false));
        server_.greet_with(begin_of(scene_, start_, true));
        for (std::size_t b = 0; b < trace_.blocks.size() && igtl_stopped == 0; ++b) {
            if (b > 0) server_.send(state_message(WireState::resume, at(trace_.blocks[b].first)));
            send_block(trace_.blocks[b]);
            if (b + 1 < trace_.blocks.size())
                server_.send(state_message(WireState::pause, at(trace_.blocks[b].last - 1)));
        }
        const bool part = igtl_stopped != 0;
        if (!part) send_events(std::numeric_limits<double>::infinity());
        server_.send(
            state_message(WireState::end, start_ + static_cast<std::int64_t>(trace_.end * 1e9), part));
        const std::int64_t until = monotonic_ns() + patience;
        while (server_.backlog() > 0 && monotonic_ns() < until) server_.step(look_ms);
        server_.step(0);
    }
    std::size_t frames() const { return frames_; }
    std::size_t events() const { return event_; }

  private:
    std::int64_t at(double t) const { return start_ + std::llround(t * 1e9); }
    std::int64_t at(std::size_t row) const { return at(trace_.t[row]); }
    /// Those until this time of the trace.
    void send_events(double until) {
        for (; event_ < events_.size() && trace_.time_of(events_[event_]) <= until; ++event_)
            server_.send(event_message(events_[event_], scene_, trace_.tick_period,
                                       at(trace_.time_of(events_[event_]))));
    }
    void wait_until(double t) {
        const std::int64_t due = begun_ + static_cast<std::int64_t>(t * 1e9 / speed_);
        for (std::int64_t now = monotonic_ns(); now < due && igtl_stopped == 0; now = monotonic_ns())
            server_.step(static_cast<int>(std::min<std::int64_t>((due - now) / ms + 1, look_ms)));
        server_.step(0);
        const std::int64_t until = monotonic_ns() + patience;
        while (server_.backlog() > igtl::longest_queue / 2 && monotonic_ns() < until) server_.step(1);
        server_.drop_behind(igtl::longest_queue / 2);
    }
    void send_block(const TraceBlock& block) {
        for (std::size_t row = block.first; row < block.last && igtl_stopped == 0; ++row) {
            const bool last = row + 1 == block.last;
            if (!last && trace_.t[row] < next_) continue;
            while (next_ <= trace_.t[row]) next_ = static_cast<double>(++slot_) / rate_;
            wait_until(trace_.t[row]);
            send_events(trace_.t[row]);
            server_.send(messages_of(frame_of(trace_, row, scene_), scene_, at(row)), monotonic_ns() / ms);
            ++frames_;
        }
    }

    igtl::Server& server_;
    const Trace& trace_;
    const std::vector<Event> events_;
    const WireScene& scene_;
    double from_;
    int rate_, speed_;
    std::int64_t start_ = 0, begun_ = 0, slot_ = 0;
    double next_ = 0;
    std::size_t frames_ = 0, event_ = 0;
};

/// Of a record, as a file of events has them.
std::vector<Event> served_events(std::vector<Event> events, std::uint64_t seed) {
    for (Event& event : events) put_seed(event, seed);
    std::stable_sort(events.begin(), events.end(),
                     [](const Event& a, const Event& b) { return a.tick < b.tick; });
    return events;
}

int run_serve(const Arguments& arguments) {
    const igtl::Address address = igtl::parse_address(arguments.value_or("--address", ""), "--address", 0);
    const auto rate = static_cast<int>(arguments.integer("--rate", 60, 1, 1000));
    const auto speed = static_cast<int>(arguments.integer("--speed", 1, 1, 1000));
    const std::string& id = arguments.words()[0];
    // A sign-in is recorded, so the store must be writable.
    const database::Store store = open_store(arguments, false, !arguments.has("--as"));
    const database::Session session = session_of(arguments, store);
    const database::Attempts attempts(store);
    const database::AttemptSummary summary = attempts.read(session, id);
    const database::Trace record = attempts.read_trace(session, id);
    const LoadedTask loaded = load_recorded(attempts, session, summary);
    const WireScene scene = wire_scene(loaded.scene);
    const Trace trace =
        trace_from_samples(record.samples, record.events, scene.tissues, loaded.scene.tick_rate,
                           {scene.trocar[0].has_value(), scene.trocar[1].has_value()});
    igtl::Server server(address);
    const EndsOnInterrupt ends;
    print_note(
        {QT_TRANSLATE_NOOP("commands",
                           "fulcrum: sends attempt %1 at %2 as soon as a program connects; Ctrl-C ends it"),
         id, igtl::Address{address.host, server.port()}.text()});
    while (server.clients() == 0 && igtl_stopped == 0) server.step(look_ms);
    // Ticks of practice from a moment continue those of the attempt that it began with.
    const double from = summary.meta.origin && !trace.t.empty() ? trace.t.front() : 0;
    Served served(server, trace, served_events(record.events, summary.meta.seed), scene, from, rate, speed);
    if (igtl_stopped == 0) served.run();
    const nlohmann::json document = {{"attempt", id},
                                     {"frames", served.frames()},
                                     {"events", served.events()},
                                     {"rate_hz", rate},
                                     {"duration_s", trace.end - from},
                                     {"clients_dropped", server.dropped()},
                                     {"interrupted", igtl_stopped != 0}};
    if (arguments.has("--json"))
        print_json(document);
    else
        std::cout << served.frames() << " frames of " << decimal_text(trace.end - from, 1) << " s and "
                  << served.events() << " events sent; " << server.dropped()
                  << " clients dropped because they read too slowly\n";
    return 0;
}

/// Why a recording ended.
enum class RecordEnd { attempt_ended, closed, time_over, by_signal, not_openigtlink };
constexpr const char* word_of(RecordEnd end) {
    switch (end) {
        case RecordEnd::attempt_ended:
            return "attempt ended";
        case RecordEnd::closed:
            return "the server closed the connection";
        case RecordEnd::time_over:
            return "time over";
        case RecordEnd::by_signal:
            return "interrupted";
        case RecordEnd::not_openigtlink:
            return "what the server sends is not OpenIGTLink";
    }
    return "";
}

struct Received {
    RecordEnd end = RecordEnd::closed;
    std::size_t wrong = 0;  ///< messages with a wrong checksum
};

/// Takes out what the decoder has; the reason where that is the end.
std::optional<RecordEnd> take_all(igtl::Decoder& decoder, TraceRecording& recording, Received& received) {
    using Found = igtl::Decoder::Found;
    igtl::Message message;
    for (Found found = decoder.next(message); found != Found::nothing; found = decoder.next(message)) {
        if (found == Found::broken) return RecordEnd::not_openigtlink;
        if (found == Found::wrong_checksum || found == Found::wrong_content) ++received.wrong;
        if (found == Found::message && recording.take(message, wall_clock_ns()) == TraceRecording::Took::end)
            return RecordEnd::attempt_ended;
    }
    return std::nullopt;
}

Received receive_all(igtl::Connection& connection, TraceRecording& recording, std::int64_t until) {
    Received received;
    igtl::Decoder decoder;
    for (;;) {
        if (igtl_stopped != 0)
            received.end = RecordEnd::by_signal;
        else if (monotonic_ns() >= until)
            received.end = RecordEnd::time_over;
        else {
            connection.wait(look_ms);
            const bool open = connection.read_into(decoder);
            const std::optional<RecordEnd> end = take_all(decoder, recording, received);
            if (open && !end) continue;
            received.end = end.value_or(RecordEnd::closed);
        }
        return received;
    }
}

[[noreturn]] void refuse_empty(const igtl::Address& address, const TraceRecording& recording,
                               const Received& received, const TraceRecording::Names& names) {
    if (received.end == RecordEnd::not_openigtlink)
        throw InputError(
            address.text(), "", QT_TRANSLATE_NOOP("errors", "what it sends is not OpenIGTLink"),
            QT_TRANSLATE_NOOP("errors", "check that this is the port of the OpenIGTLink server"));
    std::string others;
    for (const std::string& name : recording.unknown_tools()) others += (others.empty() ? "" : ", ") + name;
    const std::string wanted = names[0] + ", " + names[1] + ", " + names[2];
    if (others.empty())
        throw InputError(address.text(), "", {QT_TRANSLATE_NOOP("errors", "sent no pose of %1"), wanted},
                         QT_TRANSLATE_NOOP("errors", "start sending there, then record again"));
    throw InputError(address.text(), "",
                     {QT_TRANSLATE_NOOP("errors", "sent no pose of %1, only of %2"), wanted, others},
                     QT_TRANSLATE_NOOP("errors", "name its tools with --left, --right and --camera"));
}

/// Writes the events where they are wanted and whole; their number.
std::optional<std::size_t> write_events(const TraceRecording& recording, const Received& received,
                                        const std::optional<std::string>& file) {
    const std::optional<std::string> events =
        received.wrong == 0 ? recording.events_csv() : std::nullopt;  // one of them may be an event
    if (file && events) write_whole_file(*file, *events, FileAccess::owner_only);
    if (file && !events)
        print_note({QT_TRANSLATE_NOOP("commands",
                                      "note: %1 was not written: the recording has not all events of an "
                                      "attempt, from its begin to its end"),
                    *file});
    return events ? std::optional(recording.events()) : std::nullopt;
}

int run_record(const Arguments& arguments) {
    const std::string where = arguments.words().empty() ? std::string() : arguments.words()[0];
    const igtl::Address address = igtl::parse_address(where, "HOST:PORT");
    const auto file = arguments.value("--output");
    if (!file)
        throw UsageError("--output", QT_TRANSLATE_NOOP("errors", "is missing"),
                         QT_TRANSLATE_NOOP("errors", "name the file of the trace: -o TRACE.csv"));
    require_writable_file(*file);
    const auto events_file = arguments.value("--events");
    if (events_file == file)
        throw UsageError("--events", QT_TRANSLATE_NOOP("errors", "is the file of the trace"),
                         QT_TRANSLATE_NOOP("errors", "name another file"));
    if (events_file) require_writable_file(*events_file);
    const TraceRecording::Names names = {arguments.value_or("--left", tool_names[0]),
                                         arguments.value_or("--right", tool_names[1]),
                                         arguments.value_or("--camera", tool_names[2])};
    const std::int64_t until = monotonic_ns() + second * arguments.integer("--seconds", 7200, 1, 7200);
    const EndsOnInterrupt ends;
    igtl::Connection connection(address, connect_wait_ms);
    TraceRecording recording(names);
    const Received received = receive_all(connection, recording, until);
    const Trace trace = recording.finish();
    if (trace.t.empty()) refuse_empty(address, recording, received, names);
    std::ostringstream text;
    write_trace_csv(trace, text);
    write_whole_file(*file, text.str(), FileAccess::owner_only);
    const std::optional<std::size_t> events = write_events(recording, received, events_file);
    const double length = trace.t.back() - trace.t.front();
    if (arguments.has("--json"))
        print_json({{"file", *file},
                    {"samples", trace.t.size()},
                    {"events", events ? nlohmann::json(*events) : nlohmann::json()},
                    {"duration_s", length},
                    {"ended_because", word_of(received.end)},
                    {"left_out", recording.left_out()},
                    {"wrong_checksums", received.wrong},
                    {"unknown_tools", recording.unknown_tools()}});
    else
        std::cout << *file << ": " << trace.t.size() << " samples in " << decimal_text(length, 1) << " s; "
                  << (events ? std::to_string(*events) : std::string("not all")) << " events; "
                  << recording.left_out() << " left out, " << received.wrong
                  << " with a wrong checksum; ended: " << word_of(received.end) << '\n';
    return received.end == RecordEnd::not_openigtlink ? 1 : 0;
}

}  // namespace

std::vector<Command> igtl_commands() {
    return {
        {"igtl serve", "ATTEMPT", 1, 1,
         QT_TRANSLATE_NOOP("commands",
                           "Sends a stored attempt over OpenIGTLink, for example to 3D Slicer, as soon as a "
                           "program connects."),
         joined(
             {{"--address", "ADDRESS:PORT",
               QT_TRANSLATE_NOOP("commands", "Where to listen. Without it other computers cannot connect."),
               "127.0.0.1:18944"},
              {"--rate", "HZ", QT_TRANSLATE_NOOP("commands", "Frames a second, 1 to 1000."), "60"},
              {"--speed", "N",
               QT_TRANSLATE_NOOP("commands", "How many times as fast as it was performed, 1 to 1000."), "1"}},
             session_options()),
         run_serve, false,
         QT_TRANSLATE_NOOP("commands",
                           "Each frame has a TRANSFORM for each tool (LeftTipToPatient, RightTipToPatient, "
                           "CameraToPatient; mm, axes of 3D Slicer), the force of each instrument on tissue "
                           "(SENSOR LeftForce, RightForce; N) and its state (LeftState, RightState). "
                           "Events are STRINGs. docs/FORMATS.md has the details.")},
        {"igtl record",
         "[HOST:PORT]",
         0,
         1,
         QT_TRANSLATE_NOOP(
             "commands",
             "Records what an OpenIGTLink server sends as a trace in the CSV format of docs/FORMATS.md."),
         {{"--output", "TRACE.csv", QT_TRANSLATE_NOOP("commands", "The file to write."), "", {}, "-o"},
          {"--events", "EVENTS.csv",
           QT_TRANSLATE_NOOP("commands", "Also write the events, where Fulcrum sends a whole attempt.")},
          {"--left", "NAME", QT_TRANSLATE_NOOP("commands", "The tool of the left hand."), tool_names[0]},
          {"--right", "NAME", QT_TRANSLATE_NOOP("commands", "The tool of the right hand."), tool_names[1]},
          {"--camera", "NAME", QT_TRANSLATE_NOOP("commands", "The tool of the scope."), tool_names[2]},
          {"--seconds", "S", QT_TRANSLATE_NOOP("commands", "Stop after this time, 1 to 7200."),
           QT_TRANSLATE_NOOP("commands", "until the attempt ends, or Ctrl-C")},
          json_option()},
         run_record}};
}

}  // namespace fulcrum::app
