// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "app/igtl/wire_frame.h"
#include "assessment/trace/events_csv.h"
#include "assessment/trace/trace_csv.h"

namespace fulcrum::app {
namespace {

// Parts of a row: the pose, the force and the state of each hand, then the camera.
constexpr std::size_t force_part = 2, state_part = 4, camera_part = 6;
constexpr const char* sensor_names[] = {"LeftForce", "RightForce", "LeftState", "RightState"};
constexpr std::size_t sensor_sizes[] = {3, 3, 9, 9};
constexpr std::size_t most_unknown = 32, longest_label_list = 120;
constexpr double event_time_unit = 1e-5;  // s, orders the events of every tick rate
constexpr double resolution = 1e7;  // of a place in the record, per m: takes the rounding of the floats away

Vector3 patient_of(const Vector3& v) {  // from Slicer's axes
    return {-v.x(), v.z(), v.y()};
}

Vector3 rounded_place(const Vector3& place) {
    const Vector3 mine = patient_of(place);
    return {std::round(mine.x() * resolution) / resolution, std::round(mine.y() * resolution) / resolution,
            std::round(mine.z() * resolution) / resolution};
}

std::size_t part_bit(std::size_t part) {
    return std::size_t{1} << part;
}

std::int16_t index_of(double value) {
    return value >= 0 && value <= std::numeric_limits<std::int16_t>::max() ? static_cast<std::int16_t>(value)
                                                                           : std::int16_t{-1};
}

/// A label that a cell of a CSV file can hold.
std::string label_of(std::string_view text) {
    std::string label(text);
    for (char& c : label)
        if (c <= ' ' || c > '~' || c == ',' || c == '"') c = '_';
    return label.empty() ? std::string("_") : label;
}

/// The rows of names and units of an events file.
std::string events_header() {
    std::ostringstream text;
    write_events_csv({}, {}, 1, text);
    return text.str();
}

/// Keeps the rows from `first` on.
template <typename T>
void drop_front(std::vector<T>& column, std::size_t first) {
    if (!column.empty()) column.erase(column.begin(), column.begin() + static_cast<std::ptrdiff_t>(first));
}

template <typename Visit>
void visit_columns(HandTrace& hand, Visit&& visit) {
    visit(hand.px), visit(hand.py), visit(hand.pz), visit(hand.ax), visit(hand.ay), visit(hand.az);
    visit(hand.roll), visit(hand.fx), visit(hand.fy), visit(hand.fz), visit(hand.jaw_force);
    visit(hand.jaw_area), visit(hand.tissue), visit(hand.patch), visit(hand.inside), visit(hand.in_view);
    visit(hand.energy), visit(hand.cutting);
}
template <typename Visit>
void visit_columns(CameraTrace& camera, Visit&& visit) {
    visit(camera.px), visit(camera.py), visit(camera.pz);
    visit(camera.qw), visit(camera.qx), visit(camera.qy), visit(camera.qz);
}

void append_hand(HandTrace& to, const WireHand& hand) {
    to.px.push_back(hand.tip.x()), to.py.push_back(hand.tip.y()), to.pz.push_back(hand.tip.z());
    to.ax.push_back(hand.axis.x()), to.ay.push_back(hand.axis.y()), to.az.push_back(hand.axis.z());
    to.fx.push_back(hand.force.x()), to.fy.push_back(hand.force.y()), to.fz.push_back(hand.force.z());
    to.roll.push_back(hand.roll), to.jaw_force.push_back(hand.jaw_force);
    to.jaw_area.push_back(hand.jaw_area);
    to.tissue.push_back(static_cast<std::int16_t>(hand.tissue));
    to.patch.push_back(static_cast<std::int16_t>(hand.patch));
    to.inside.push_back(hand.inside ? 1 : 0), to.in_view.push_back(hand.in_view ? 1 : 0);
    to.energy.push_back(hand.energy ? 1 : 0), to.cutting.push_back(hand.cutting ? 1 : 0);
}

}  // namespace

TraceRecording::Took TraceRecording::take(const igtl::Message& message, std::int64_t arrived) {
    const std::size_t before = rows_made_;
    const std::uint64_t time = message.time != 0 ? message.time : igtl::timestamp_of(arrived);
    igtl::Transform transform;
    igtl::Position position;
    igtl::Sensor sensor;
    igtl::Status status;
    std::string_view text;
    std::uint16_t encoding = 0;
    if (message.type == "TRANSFORM" && igtl::read_transform(message.content, transform)) {
        take_pose(message.device, time, igtl::pose_of(transform));
    } else if (message.type == "POSITION" && igtl::read_position(message.content, position)) {
        take_pose(message.device, time, igtl::pose_of(position));
    } else if (message.type == "TDATA") {
        const std::size_t count = igtl::count_of_tdata(message.content).value_or(0);
        for (std::size_t i = 0; i < count; ++i) {
            const igtl::Tracked tracked = igtl::element_of_tdata(message.content, i);
            take_pose(tracked.name, time, igtl::pose_of(tracked.transform));
        }
    } else if (message.type == "SENSOR" && igtl::read_sensor(message.content, sensor)) {
        take_sensor(message.device, time, sensor);
    } else if (message.type == "STRING" && igtl::read_string(message.content, text, encoding)) {
        if (message.device == "Tissues") take_tissues(text);
        if (message.device == "Event") take_event(text);
    } else if (message.type == "STATUS" && message.device == "Attempt" &&
               igtl::read_status(message.content, status)) {
        if (take_state(time, status) == Took::end) return Took::end;
    }
    return rows_made_ > before ? Took::row : Took::nothing;
}

TraceRecording::Took TraceRecording::take_state(std::uint64_t time, const igtl::Status& status) {
    if (status.name == "begin" && rows_made_ == 0 && in_row_ == 0) {
        begin_ns_ = igtl::ns_of(time);
        begin_seen_ = status.text.empty();
    }
    if (status.name != "end") return Took::nothing;
    close_row();
    end_seen_ = status.text.empty();
    return Took::end;
}

void TraceRecording::take_tissues(std::string_view text) {
    if (!trace_.tissues.empty()) return;
    while (!text.empty() && trace_.tissues.size() < longest_label_list) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        trace_.tissues.push_back(label_of(text.substr(0, end)));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
}

void TraceRecording::take_event(std::string_view row) {
    std::istringstream file(events_header() + std::string(row) + '\n');
    std::vector<Event> read;
    try {
        read = read_events_csv(file, "Event", trace_.tissues, event_time_unit);
    } catch (const std::exception&) {
        // It is no event.
    }
    if (read.size() == 1 && events_.size() < events_csv_row_limit) {
        events_.push_back({read[0].tick, read[0].kind == EventKind::attempt_begin, std::string(row)});
        return;
    }
    ++left_out_;
    event_missing_ = true;
}

std::optional<std::string> TraceRecording::events_csv() const {
    if (events_.empty() || event_missing_ || !begin_seen_ || !end_seen_) return std::nullopt;
    // An event can be recorded after later ones (write_events_csv()).
    std::vector<EventRow> rows = events_;
    std::stable_sort(rows.begin(), rows.end(), [](const EventRow& a, const EventRow& b) {
        return a.time != b.time ? a.time < b.time : a.begins && !b.begins;
    });
    std::string text = events_header();
    for (const EventRow& row : rows) text += row.text + '\n';
    return text;
}

void TraceRecording::begin_part(std::size_t part, std::uint64_t time) {
    const std::int64_t ns = igtl::ns_of(time);
    if (in_row_ != 0 && (in_row_ & part_bit(part)) != 0) close_row();
    if (in_row_ == 0) row_ns_ = ns;
    in_row_ = static_cast<std::uint8_t>(in_row_ | part_bit(part));
    ever_ = static_cast<std::uint8_t>(ever_ | in_row_);
}

void TraceRecording::take_pose(std::string_view device, std::uint64_t time,
                               const std::optional<igtl::Pose>& pose) {
    std::size_t tool = 0;
    while (tool <= hand_count && device != names_[tool]) ++tool;
    if (tool > hand_count) {
        const std::string name(device);
        if (unknown_.size() < most_unknown &&
            std::find(unknown_.begin(), unknown_.end(), name) == unknown_.end())
            unknown_.push_back(name);
        return;
    }
    if (!pose) {
        ++left_out_;
        return;
    }
    begin_part(tool < hand_count ? tool : camera_part, time);
    const Vector3 place = rounded_place(pose->place);
    if (tool < hand_count) {
        frame_.hand[tool].tip = place;
        frame_.hand[tool].axis = patient_of(pose->rotation.col(2));
        return;
    }
    frame_.scope = place;
    Matrix3 rotation;
    for (int i = 0; i < 3; ++i) rotation.col(i) = patient_of(pose->rotation.col(i));
    frame_.view = Quaternion(rotation).normalized();
}

void TraceRecording::take_sensor(std::string_view device, std::uint64_t time, const igtl::Sensor& sensor) {
    std::size_t which = 0;
    while (which < std::size(sensor_names) && device != sensor_names[which]) ++which;
    if (which == std::size(sensor_names)) return;
    const bool finite = std::all_of(sensor.values.begin(), sensor.values.begin() + sensor.count,
                                    [](double value) { return std::isfinite(value); });
    if (sensor.count != sensor_sizes[which] || !finite) {
        ++left_out_;
        return;
    }
    WireHand& hand = frame_.hand[which % hand_count];
    const auto& values = sensor.values;
    if (which < hand_count) {
        begin_part(force_part + which, time);
        hand.force = patient_of(Vector3(values[0], values[1], values[2]));
        return;
    }
    begin_part(state_part + which - hand_count, time);
    hand.roll = values[0];
    hand.jaw_force = values[1];
    hand.jaw_area = values[2];
    hand.tissue = values[3] < static_cast<double>(trace_.tissues.size()) ? index_of(values[3]) : -1;
    hand.patch = index_of(values[4]);
    hand.inside = values[5] != 0;
    hand.in_view = values[6] != 0;
    hand.energy = values[7] != 0;
    hand.cutting = values[8] != 0;
}

void TraceRecording::close_row() {
    if (in_row_ == 0) return;
    const std::uint8_t had = in_row_;
    in_row_ = 0;
    if (!begin_ns_) begin_ns_ = row_ns_;
    const double t = static_cast<double>(row_ns_ - *begin_ns_) / 1e9;
    const bool has_pose = (had & (part_bit(0) | part_bit(1) | part_bit(camera_part))) != 0;
    if (!has_pose || t < 0 || t > trace_csv_time_limit || (!trace_.t.empty() && t <= trace_.t.back()) ||
        trace_.t.size() >= trace_csv_row_limit) {
        ++left_out_;
        return;
    }
    trace_.t.push_back(t);
    known_.push_back(ever_);
    for (std::size_t h = 0; h < hand_count; ++h) append_hand(trace_.hand[h], frame_.hand[h]);
    CameraTrace& camera = trace_.camera;
    camera.px.push_back(frame_.scope.x()), camera.py.push_back(frame_.scope.y());
    camera.pz.push_back(frame_.scope.z()), camera.qw.push_back(frame_.view.w());
    camera.qx.push_back(frame_.view.x()), camera.qy.push_back(frame_.view.y());
    camera.qz.push_back(frame_.view.z());
    ++rows_made_;
}

void TraceRecording::drop_early_rows() {
    const auto whole = std::find(known_.begin(), known_.end(), ever_);
    const auto first = static_cast<std::size_t>(whole - known_.begin());
    left_out_ += first;
    drop_front(trace_.t, first);
    const auto drop = [first](auto& column) { drop_front(column, first); };
    for (HandTrace& hand : trace_.hand) visit_columns(hand, drop);
    visit_columns(trace_.camera, drop);
}

Trace TraceRecording::finish() {
    close_row();
    drop_early_rows();
    const auto clear = [](auto& column) { column.clear(); };
    for (std::size_t h = 0; h < hand_count; ++h) {
        HandTrace& hand = trace_.hand[h];
        HandTrace kept;
        if ((ever_ & part_bit(h)) != 0) {
            kept.px = hand.px, kept.py = hand.py, kept.pz = hand.pz;
            kept.ax = hand.ax, kept.ay = hand.ay, kept.az = hand.az;
        }
        if ((ever_ & part_bit(force_part + h)) != 0) kept.fx = hand.fx, kept.fy = hand.fy, kept.fz = hand.fz;
        if ((ever_ & part_bit(state_part + h)) != 0) {
            kept.roll = hand.roll, kept.jaw_force = hand.jaw_force, kept.jaw_area = hand.jaw_area;
            kept.tissue = hand.tissue, kept.patch = hand.patch, kept.inside = hand.inside;
            kept.in_view = hand.in_view, kept.energy = hand.energy, kept.cutting = hand.cutting;
        }
        hand = std::move(kept);
    }
    if ((ever_ & part_bit(camera_part)) == 0) visit_columns(trace_.camera, clear);
    return std::move(trace_);
}

}  // namespace fulcrum::app
