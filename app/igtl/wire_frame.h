// SPDX-License-Identifier: GPL-3.0-or-later
// What Fulcrum sends over OpenIGTLink at one moment of an attempt, and how it is read back
// (docs/FORMATS.md, OpenIGTLink). In the messages lengths are mm and vectors are in the axes of 3D Slicer:
// to the patient's right, anterior, superior.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "assessment/trace/trace.h"
#include "sim_core/igtl/server.h"
#include "sim_core/scene/scene.h"
#include "sim_core/telemetry/event.h"
#include "sim_core/telemetry/sample.h"

namespace fulcrum::app {

/// What the messages need of a scene. Constant during an attempt.
struct WireScene {
    std::optional<Matrix3> trocar[hand_count];  ///< rotation; none: no instrument in this hand
    bool camera = false;
    std::vector<std::string> tissues;
};
WireScene wire_scene(const Scene& scene);

/// One hand, SI, patient frame.
struct WireHand {
    Vector3 tip = Vector3::Zero(), axis = Vector3::UnitZ(), force = Vector3::Zero();
    double roll = 0, jaw_force = 0, jaw_area = 0;
    int tissue = -1, patch = -1;
    bool inside = false, in_view = false, energy = false, cutting = false;
};
struct WireFrame {
    WireHand hand[hand_count];
    Vector3 scope = Vector3::Zero();
    Quaternion view = Quaternion::Identity();
};
WireFrame frame_of(const TickSample& sample);
/// Of a row of a trace that has every channel.
WireFrame frame_of(const Trace& trace, std::size_t row, const WireScene& scene);

/// `ns`: since 1970.
igtl::ServedFrame messages_of(const WireFrame& frame, const WireScene& scene, std::int64_t ns);
/// What a client gets first: the labels of the tissues, one a line.
igtl::Bytes greeting_of(const WireScene& scene, std::int64_t ns);
enum class WireState { begin, pause, resume, end };
/// `part`: begins or ends what is not the whole attempt.
igtl::Bytes state_message(WireState state, std::int64_t ns, bool part = false);
/// What every client gets when an attempt begins, and with `part` one that connects later.
igtl::Bytes begin_of(const WireScene& scene, std::int64_t ns, bool part);
/// A row of an events file.
igtl::Bytes event_message(const Event& event, const WireScene& scene, double tick_period, std::int64_t ns);

/// Names of the tools: the instruments of the hands, then the camera.
inline constexpr const char* tool_names[hand_count + 1] = {"LeftTipToPatient", "RightTipToPatient",
                                                           "CameraToPatient"};

/// Makes a trace of what a server sends. A row begins with the first message of a tool that the row before
/// has already; its time is that message's.
class TraceRecording {
  public:
    using Names = std::array<std::string, hand_count + 1>;
    /// Names of the tools of the left and the right hand and of the camera.
    explicit TraceRecording(Names names = {tool_names[0], tool_names[1], tool_names[2]})
        : names_(std::move(names)) {}

    enum class Took { nothing, row, end };
    /// Any message. Where it has no time of its own it gets that of its arrival (ns).
    Took take(const igtl::Message& message, std::int64_t arrived = 0);
    std::size_t rows() const { return trace_.t.size(); }
    /// Rows that were left out because a tool that comes later was still missing, and messages whose time or
    /// content was not usable.
    std::size_t left_out() const { return left_out_; }
    std::size_t events() const { return events_.size(); }
    /// The file of the events. Nothing where none came, or not those of the whole attempt from its begin to
    /// its end: of a part, what counts events would be wrong.
    std::optional<std::string> events_csv() const;
    /// Names of tools that are not those that Fulcrum reads.
    const std::vector<std::string>& unknown_tools() const { return unknown_; }
    /// The trace, with the channels that were sent. Once, at the end.
    Trace finish();

  private:
    void take_pose(std::string_view device, std::uint64_t time, const std::optional<igtl::Pose>& pose);
    void take_sensor(std::string_view device, std::uint64_t time, const igtl::Sensor& sensor);
    void take_tissues(std::string_view text);
    void take_event(std::string_view row);
    Took take_state(std::uint64_t time, const igtl::Status& status);
    /// Which of the parts of a row this message is; closes the row where it has the part already.
    void begin_part(std::size_t part, std::uint64_t time);
    void close_row();
    void drop_early_rows();

    static constexpr std::size_t part_count = 3 * hand_count + 1;
    struct EventRow {
        std::uint32_t time = 0;  // in units of 10 us
        bool begins = false;     // the attempt; LiveSender sends it last
        std::string text;
    };
    Names names_;
    Trace trace_;
    WireFrame frame_;
    std::vector<std::uint8_t> known_;  // of each row: the parts that had been sent by then
    std::uint8_t ever_ = 0, in_row_ = 0;
    std::int64_t row_ns_ = 0;
    std::optional<std::int64_t> begin_ns_;
    std::vector<std::string> unknown_;
    std::vector<EventRow> events_;
    bool begin_seen_ = false, end_seen_ = false, event_missing_ = false;
    std::size_t left_out_ = 0, rows_made_ = 0;
};

}  // namespace fulcrum::app
