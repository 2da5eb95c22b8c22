// SPDX-License-Identifier: Apache-2.0
// Kinematics of instruments and scope through their trocars: from the handle that a device reports to a tip
// in the body.
//
// Handle h in the trocar frame (origin at the pivot, z into the body along the nominal shaft, y up, x = y x
// z):
//     axis = -h / |h|,   insertion = shaft_length - |h|,   tip = trocar + R0 (axis * insertion).
// Hand motion is therefore mirrored and scaled by the lever arm (the fulcrum effect) without a separate rule.
// Tool frame: z along the axis, x and y transported from the trocar frame by the smallest rotation, then
// turned by the roll about z. All functions are pure functions of quantised samples: any thread, no
// allocation, no exception, always finite.
#pragma once

#include "sim_core/instrument/device.h"
#include "sim_core/instrument/poses.h"
#include "sim_core/numerics/types.h"
#include "sim_core/scene/scene.h"

namespace fulcrum {

/// The pivot. Columns of rotation are the trocar frame's x, y, z in the patient frame.
struct Trocar {
    Vector3 position = Vector3::Zero();  ///< m
    Matrix3 rotation = Matrix3::Identity();
    double shaft_length = 0.34;  ///< m, handle to tip
};

/// Orthonormal trocar frame: z = direction, y = up made perpendicular to it. A zero or parallel `up` is
/// replaced by the patient axis least along the direction; a zero direction by -z of the patient.
Trocar make_trocar(const TrocarSpec& spec);

/// Handle position that puts the tip at `target` (patient frame, m); the inverse of the kinematics. A target
/// at the pivot gives the nominal direction.
Vector3 handle_for_tip(const Trocar& trocar, const Vector3& target);

/// Constant properties of an instrument.
struct InstrumentModel {
    Trocar trocar;
    double shaft_radius = 0.0025;                    ///< m
    double tip_radius = 0.0025;                      ///< m, of the proxy
    Vector3 tip_box = Vector3(0.020, 0.005, 0.005);  ///< m, edges a (along the shaft), b (tool x), c (tool y)
    double jaw_length = 0.020;                       ///< m
    double jaw_opening = 1.0;                        ///< rad
    double grip_limit = 16.0;                        ///< N, requested jaw forces above it are limited
    double tick_period = 1e-3;                       ///< s
    bool has_jaws = true;                            ///< false for a probe
};

InstrumentModel make_instrument(const InstrumentSpec& spec, double tick_period);

/// An instrument at one tick, patient frame.
struct ToolKinematics {
    Vector3 tip = Vector3::Zero();               ///< m
    Vector3 axis = Vector3(0, 0, -1);            ///< unit, trocar to tip
    Vector3 trocar = Vector3::Zero();            ///< m
    Matrix3 rotation = Matrix3::Identity();      ///< columns: tool x, y, z = axis
    double roll = 0;                             ///< rad
    double jaw_angle = 0;                        ///< rad, requested opening, 0 .. jaw_opening
    double grip = 0;                             ///< N, requested jaw force
    double insertion = 0;                        ///< m, > 0 inside
    Vector3 tip_velocity = Vector3::Zero();      ///< m/s
    Vector3 angular_velocity = Vector3::Zero();  ///< rad/s, of the shaft about the pivot (roll included)
    std::uint16_t buttons = 0;                   ///< DeviceButton mask
    bool inside = false;                         ///< insertion > 0
    bool present = false;                        ///< the device answered with a usable pose

    /// Point of the shaft at fraction s, 0 at the trocar, 1 at the tip (outside the body: both at the
    /// trocar).
    Vector3 shaft_point(double s) const { return trocar + s * (tip - trocar); }
    Vector3 shaft_velocity(double s) const { return s * tip_velocity; }
    /// Velocity of the shaft itself at fraction s: along the axis it slides as the tip does.
    Vector3 sliding_velocity(double s) const {
        const double sliding = tip_velocity.dot(axis);
        const Vector3 across = tip_velocity - sliding * axis;
        return sliding * axis + s * across;
    }
    ToolPose pose() const;
};

/// State of an instrument between ticks.
struct InstrumentState {
    DeviceSample last;  ///< last sample used
    bool started = false;
};

/// The sample of a device whose instrument is at the given insertion along its nominal direction.
DeviceSample start_sample(const TrocarSpec& trocar, double insertion);

/// Pose of a single sample, velocities zero.
ToolKinematics tool_pose(const InstrumentModel& model, const DeviceSample& sample);

/// The handle from the trocar, m, patient frame, as the instrument follows it: never nearer than
/// handle_clearance, and within the reach of the trocar.
Vector3 handle_of(const InstrumentModel& model, const ToolKinematics& tool);

/// One tick: pose, and velocities from the difference to the last quantised sample (zero in the first tick
/// and in the tick after an absence, so that a device that comes back causes no jump).
ToolKinematics step_instrument(const InstrumentModel& model, const DeviceSample& sample,
                               InstrumentState& state);

/// Length range of the insertion: 0.10 m out of the body to 2 cm short of the handle.
inline constexpr double least_insertion = -0.10, handle_clearance = 0.02;

// ---- the scope ----

struct ScopeModel {
    Trocar trocar;
    double angle = 0.5235987755982988;          ///< rad, shaft to view direction
    double field_of_view = 1.2217304763960306;  ///< rad, full angle of the round image
    double near_limit = 0.002;                  ///< m, nearer objects are not seen
};

ScopeModel make_scope(const CameraSpec& spec);

/// The camera head stays as it is while the light post turns with the sample's roll: the roll moves the
/// direction of view around the shaft (model of Yamaguchi et al. 2004). At roll 0 a 30 degree scope looks
/// down, away from the light post. The camera head, turned by the sample's jaw angle, turns the image alone:
/// with it the horizon is kept.
CameraPose scope_pose(const ScopeModel& model, const DeviceSample& sample);

/// Unit direction of view, patient frame.
Vector3 view_direction(const CameraPose& camera);

/// True if the point is in front of the lens and inside the round image.
bool in_view(const CameraPose& camera, const Vector3& point, double near_limit = 0.002);

}  // namespace fulcrum
