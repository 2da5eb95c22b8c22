// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/igtl/wire_frame.h"

#include <cmath>
#include <sstream>

#include "assessment/trace/events_csv.h"
#include "sim_core/instrument/instrument.h"

namespace fulcrum::app {
namespace {

constexpr const char* force_names[hand_count] = {"LeftForce", "RightForce"};
constexpr const char* state_names[hand_count] = {"LeftState", "RightState"};
constexpr const char* attempt_name = "Attempt";
constexpr const char* tissues_name = "Tissues";
constexpr const char* event_device = "Event";
constexpr std::uint16_t status_good = 1;
constexpr std::size_t force_count = 3;

/// Slicer's axes (right, anterior, superior) from the patient frame (left, cranial, anterior).
Vector3 to_ras(const Vector3& v) {
    return {-v.x(), v.z(), v.y()};
}
Matrix3 to_ras(const Matrix3& m) {
    Matrix3 turned;
    for (int i = 0; i < 3; ++i) turned.col(i) = to_ras(Vector3(m.col(i)));
    return turned;
}

/// The tool frame as the instrument has it: z along the shaft, x by its roll.
Matrix3 tool_rotation(const Matrix3& trocar, const Vector3& axis, double roll) {
    const Vector3 local = trocar.transpose() * axis;
    const Quaternion lean = Quaternion::FromTwoVectors(Vector3::UnitZ(), local);
    return trocar * (lean * Quaternion(Eigen::AngleAxisd(roll, Vector3::UnitZ()))).toRotationMatrix();
}

enum StateValue : std::size_t {
    value_roll,
    value_jaw_force,
    value_jaw_area,
    value_tissue,
    value_patch,
    value_inside,
    value_in_view,
    value_energy,
    value_cutting,
    state_count
};

const char* word_of(WireState state) {
    switch (state) {
        case WireState::begin:
            return "begin";
        case WireState::pause:
            return "pause";
        case WireState::resume:
            return "resume";
        case WireState::end:
            return "end";
    }
    return "";
}

Vector3 vector_of(const std::int32_t (&counts)[3], double per_unit) {
    return {counts[0] / per_unit, counts[1] / per_unit, counts[2] / per_unit};
}

}  // namespace

WireScene wire_scene(const Scene& scene) {
    WireScene wire;
    for (int h = 0; h < hand_count; ++h)
        if (const InstrumentSpec* const spec = scene.instrument(static_cast<Hand>(h)))
            wire.trocar[h] = make_trocar(spec->trocar).rotation;
    wire.camera = scene.camera.has_value();
    for (const TissueSpec& tissue : scene.tissues) wire.tissues.push_back(tissue.label);
    return wire;
}

WireFrame frame_of(const TickSample& sample) {
    WireFrame frame;
    for (int h = 0; h < hand_count; ++h) {
        const HandSample& from = sample.hand[h];
        WireHand& hand = frame.hand[h];
        hand.tip = vector_of(from.tip, 1e7);
        hand.axis = vector_of(from.axis, 1e8);
        hand.force = vector_of(from.force, 1e3);
        hand.roll = from.roll / 1e6;
        hand.jaw_force = from.jaw_force / 1e3;
        hand.jaw_area = from.jaw_area / 1e9;
        hand.tissue = from.tissue;
        hand.patch = from.patch;
        hand.inside = (from.flags & hand_inside) != 0;
        hand.in_view = (from.flags & hand_in_view) != 0;
        hand.energy = (from.flags & hand_energy) != 0;
        hand.cutting = (from.flags & hand_cutting) != 0;
    }
    frame.scope = vector_of(sample.camera.tip, 1e7);
    const auto& q = sample.camera.orientation;
    frame.view = Quaternion(q[0] / 1e8, q[1] / 1e8, q[2] / 1e8, q[3] / 1e8);
    return frame;
}

WireFrame frame_of(const Trace& trace, std::size_t row, const WireScene& scene) {
    WireFrame frame;
    for (std::size_t h = 0; h < hand_count; ++h) {
        if (!scene.trocar[h]) continue;
        const HandTrace& from = trace.hand[h];
        WireHand& hand = frame.hand[h];
        hand.tip = Vector3(from.px[row], from.py[row], from.pz[row]);
        hand.axis = Vector3(from.ax[row], from.ay[row], from.az[row]);
        hand.force = Vector3(from.fx[row], from.fy[row], from.fz[row]);
        hand.roll = from.roll[row];
        hand.jaw_force = from.jaw_force[row];
        hand.jaw_area = from.jaw_area[row];
        hand.tissue = from.tissue[row];
        hand.patch = from.patch[row];
        hand.inside = from.inside[row] != 0;
        hand.in_view = from.in_view[row] != 0;
        hand.energy = from.energy[row] != 0;
        hand.cutting = from.cutting[row] != 0;
    }
    const CameraTrace& camera = trace.camera;
    if (camera.recorded()) {
        frame.scope = Vector3(camera.px[row], camera.py[row], camera.pz[row]);
        frame.view = Quaternion(camera.qw[row], camera.qx[row], camera.qy[row], camera.qz[row]);
    }
    return frame;
}

igtl::ServedFrame messages_of(const WireFrame& frame, const WireScene& scene, std::int64_t ns) {
    igtl::ServedFrame messages;
    const std::uint64_t time = igtl::timestamp_of(ns);
    std::array<igtl::Tracked, hand_count + 1> tools;
    std::size_t count = 0;
    const auto add = [&](std::size_t tool, const Matrix3& rotation, const Vector3& place) {
        tools[count].name = tool_names[tool];
        tools[count].transform = igtl::transform_of({to_ras(rotation), to_ras(place)});
        igtl::append_transform(messages.transforms, tool_names[tool], time, tools[count].transform);
        ++count;
    };
    for (std::size_t h = 0; h < hand_count; ++h) {
        if (!scene.trocar[h]) continue;
        const WireHand& hand = frame.hand[h];
        add(h, tool_rotation(*scene.trocar[h], hand.axis, hand.roll), hand.tip);
        const Vector3 force = to_ras(hand.force);
        igtl::append_sensor(messages.others, force_names[h], time, force.data(), force_count,
                            igtl::unit_newton);
        std::array<double, state_count> state{};
        state[value_roll] = hand.roll;
        state[value_jaw_force] = hand.jaw_force;
        state[value_jaw_area] = hand.jaw_area;
        state[value_tissue] = hand.tissue;
        state[value_patch] = hand.patch;
        state[value_inside] = hand.inside ? 1 : 0;
        state[value_in_view] = hand.in_view ? 1 : 0;
        state[value_energy] = hand.energy ? 1 : 0;
        state[value_cutting] = hand.cutting ? 1 : 0;
        igtl::append_sensor(messages.others, state_names[h], time, state.data(), state_count,
                            igtl::unit_none);
    }
    if (scene.camera) add(hand_count, frame.view.normalized().toRotationMatrix(), frame.scope);
    igtl::append_tdata(messages.tdata, "Fulcrum", time, tools.data(), count);
    return messages;
}

igtl::Bytes greeting_of(const WireScene& scene, std::int64_t ns) {
    std::string labels;
    for (const std::string& label : scene.tissues) labels += (labels.empty() ? "" : "\n") + label;
    igtl::Bytes bytes;
    igtl::append_string(bytes, tissues_name, igtl::timestamp_of(ns), labels);
    return bytes;
}

igtl::Bytes state_message(WireState state, std::int64_t ns, bool part) {
    igtl::Bytes bytes;
    igtl::append_status(bytes, attempt_name, igtl::timestamp_of(ns),
                        {status_good, static_cast<std::int64_t>(state), word_of(state), part ? "part" : ""});
    return bytes;
}

igtl::Bytes begin_of(const WireScene& scene, std::int64_t ns, bool part) {
    igtl::Bytes bytes = greeting_of(scene, ns);
    const igtl::Bytes begin = state_message(WireState::begin, ns, part);
    bytes.insert(bytes.end(), begin.begin(), begin.end());
    return bytes;
}

igtl::Bytes event_message(const Event& event, const WireScene& scene, double tick_period, std::int64_t ns) {
    Event sent = event;
    if (sent.tissue >= static_cast<int>(scene.tissues.size())) sent.tissue = -1;
    std::ostringstream file;
    write_events_csv({sent}, scene.tissues, tick_period, file);
    std::string text = file.str();
    text.pop_back();  // the end of its last line, which is the event
    igtl::Bytes bytes;
    igtl::append_string(bytes, event_device, igtl::timestamp_of(ns), text.substr(text.rfind('\n') + 1));
    return bytes;
}

}  // namespace fulcrum::app
