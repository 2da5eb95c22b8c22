// SPDX-License-Identifier: Apache-2.0
#include "sim_core/instrument/instrument.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"

namespace fulcrum {
namespace {

constexpr double shortest_handle = 1e-3;  // m: nearer to the pivot the direction is undefined
constexpr double least_axis_z = 0.1;      // 84 degrees off the nominal direction: limit of any trocar

Vector3 sample_handle(const DeviceSample& sample) {
    return device_length_unit * Vector3(sample.handle[0], sample.handle[1], sample.handle[2]);
}

// Unit axis and insertion in the trocar frame.
struct ShaftLine {
    Vector3 axis = Vector3::UnitZ();
    double insertion = 0;
};

ShaftLine shaft_line(const Trocar& trocar, const Vector3& handle) {
    ShaftLine line;
    const double length = handle.norm();
    if (length > shortest_handle) line.axis = -handle / length;
    if (line.axis.z() < least_axis_z) {
        const double across = std::sqrt(line.axis.x() * line.axis.x() + line.axis.y() * line.axis.y());
        if (across < 1e-9) {
            line.axis = Vector3::UnitZ();
        } else {
            const double scale = std::sqrt(1.0 - least_axis_z * least_axis_z) / across;
            line.axis = Vector3(line.axis.x() * scale, line.axis.y() * scale, least_axis_z);
        }
    }
    const double most = std::max(trocar.shaft_length - handle_clearance, least_insertion);
    line.insertion = std::clamp(trocar.shaft_length - length, least_insertion, most);
    return line;
}

// Smallest rotation that takes z to the axis; axis.z > 0.
Matrix3 rotation_to(const Vector3& axis) {
    const Vector3 v = Vector3::UnitZ().cross(axis);
    Matrix3 cross;
    cross << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return Matrix3::Identity() + cross + cross * cross / (1.0 + axis.z());
}

Matrix3 rotation_about_z(double angle) {
    double sine = 0, cosine = 1;
    math::sin_cos(angle, sine, cosine);
    Matrix3 rotation;
    rotation << cosine, -sine, 0, sine, cosine, 0, 0, 0, 1;
    return rotation;
}

Matrix3 rotation_about_x(double angle) {
    double sine = 0, cosine = 1;
    math::sin_cos(angle, sine, cosine);
    Matrix3 rotation;
    rotation << 1, 0, 0, 0, cosine, -sine, 0, sine, cosine;
    return rotation;
}

}  // namespace

Trocar make_trocar(const TrocarSpec& spec) {
    Trocar trocar;
    trocar.position = spec.position;
    trocar.shaft_length = spec.shaft_length;
    const double length = spec.direction.norm();
    const Vector3 z = length > 1e-12 ? Vector3(spec.direction / length) : Vector3(0, 0, -1);
    Vector3 y = spec.up - spec.up.dot(z) * z;
    if (y.norm() < 1e-6) {
        int least = 0;
        z.cwiseAbs().minCoeff(&least);
        y = Vector3::Unit(least) - z[least] * z;
    }
    y.normalize();
    trocar.rotation.col(0) = y.cross(z);
    trocar.rotation.col(1) = y;
    trocar.rotation.col(2) = z;
    return trocar;
}

Vector3 handle_for_tip(const Trocar& trocar, const Vector3& target) {
    const Vector3 local = trocar.rotation.transpose() * (target - trocar.position);
    const double insertion = local.norm();
    const Vector3 axis = insertion > 1e-9 ? Vector3(local / insertion) : Vector3(Vector3::UnitZ());
    return -(trocar.shaft_length - insertion) * axis;
}

InstrumentModel make_instrument(const InstrumentSpec& spec, double tick_period) {
    InstrumentModel model;
    model.trocar = make_trocar(spec.trocar);
    model.shaft_radius = spec.shaft_radius;
    model.tip_radius = spec.tip_radius;
    model.tip_box = spec.tip_box;
    model.jaw_length = spec.jaw_length;
    model.jaw_opening = spec.jaw_opening;
    model.grip_limit = 2.0 * spec.grip_force;
    model.tick_period = tick_period;
    // A hand that exchanges its hook for an applier has jaws: what has none pays no heed to them.
    const auto jawed = [](InstrumentKind kind) { return type_of(kind).jaws; };
    model.has_jaws = jawed(spec.kind) || std::any_of(spec.exchange.begin(), spec.exchange.end(), jawed);
    return model;
}

ToolPose ToolKinematics::pose() const {
    ToolPose pose;
    pose.tip = tip;
    pose.axis = axis;
    pose.trocar = trocar;
    pose.orientation = Quaternion(rotation);
    pose.roll = roll;
    pose.jaw_angle = jaw_angle;
    pose.jaw_force = grip;
    pose.insertion = insertion;
    pose.inside = inside;
    return pose;
}

DeviceSample start_sample(const TrocarSpec& trocar, double insertion) {
    DeviceReading reading;
    reading.handle = Vector3(0, 0, -(trocar.shaft_length - insertion));
    return quantise(reading, DeviceSample{});
}

ToolKinematics tool_pose(const InstrumentModel& model, const DeviceSample& sample) {
    ToolKinematics tool;
    const ShaftLine line = shaft_line(model.trocar, sample_handle(sample));
    tool.trocar = model.trocar.position;
    tool.axis = model.trocar.rotation * line.axis;
    tool.insertion = line.insertion;
    tool.tip = tool.trocar + line.insertion * tool.axis;
    tool.roll = device_angle_unit * sample.roll;
    tool.rotation = model.trocar.rotation * rotation_to(line.axis) * rotation_about_z(tool.roll);
    tool.jaw_angle =
        model.has_jaws ? std::clamp(device_angle_unit * sample.jaw, 0.0, model.jaw_opening) : 0.0;
    tool.grip = model.has_jaws ? std::clamp(device_force_unit * sample.grip, 0.0, model.grip_limit) : 0.0;
    tool.buttons = sample.buttons;
    tool.inside = line.insertion > 0;
    tool.present = sample.present != 0;
    return tool;
}

Vector3 handle_of(const InstrumentModel& model, const ToolKinematics& tool) {
    return -(model.trocar.shaft_length - tool.insertion) * tool.axis;
}

ToolKinematics step_instrument(const InstrumentModel& model, const DeviceSample& sample,
                               InstrumentState& state) {
    ToolKinematics tool = tool_pose(model, sample);
    if (state.started && tool.present) {
        const ToolKinematics before = tool_pose(model, state.last);
        tool.tip_velocity = (tool.tip - before.tip) / model.tick_period;
        tool.angular_velocity =
            (before.axis.cross(tool.axis) + (tool.roll - before.roll) * tool.axis) / model.tick_period;
    }
    state.last = sample;
    state.started = tool.present;
    return tool;
}

ScopeModel make_scope(const CameraSpec& spec) {
    ScopeModel model;
    model.trocar = make_trocar(spec.trocar);
    model.angle = spec.angle;
    model.field_of_view = spec.field_of_view;
    return model;
}

CameraPose scope_pose(const ScopeModel& model, const DeviceSample& sample) {
    const ShaftLine line = shaft_line(model.trocar, sample_handle(sample));
    const double post = device_angle_unit * sample.roll;
    // Camera axes in the tool frame: the camera looks along -z, the tool points along +z.
    Matrix3 camera_to_tool = Matrix3::Zero();
    camera_to_tool.diagonal() = Vector3(-1, 1, -1);
    const Matrix3 rotation = model.trocar.rotation * rotation_to(line.axis) * rotation_about_z(post) *
                             rotation_about_x(model.angle) * rotation_about_z(-post) * camera_to_tool *
                             rotation_about_z(device_angle_unit * sample.jaw);
    CameraPose camera;
    camera.position = model.trocar.position + line.insertion * (model.trocar.rotation * line.axis);
    camera.orientation = Quaternion(rotation).normalized();
    camera.field_of_view = model.field_of_view;
    return camera;
}

Vector3 view_direction(const CameraPose& camera) {
    return camera.orientation * Vector3(0, 0, -1);
}

bool in_view(const CameraPose& camera, const Vector3& point, double near_limit) {
    const Vector3 local = camera.orientation.conjugate() * (point - camera.position);
    const double depth = -local.z();
    if (!(depth > near_limit)) return false;
    const double across = std::sqrt(local.x() * local.x() + local.y() * local.y());
    return across <= depth * math::tan(0.5 * camera.field_of_view);
}

}  // namespace fulcrum
