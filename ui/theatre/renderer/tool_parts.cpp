// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/tool_parts.h"

#include <algorithm>

#include "ui/theatre/renderer/scene_views.h"

namespace fulcrum::ui {
namespace {

const QVector3D steel(1, 1, 1), ceramic(1.9F, 1.85F, 1.7F), brass(1.35F, 1.0F, 0.50F),
    dark(0.05F, 0.05F, 0.05F);

/// Puts parts of one instrument together; lengths in m from its hinge, z towards the tip.
class Bench {
  public:
    Bench(const DrawnTool& tool, std::vector<ToolPart>& parts) : parts_(parts) {
        radius_ = static_cast<float>(tool.shaft_radius);
        jaws_ = static_cast<float>(tool.jaws() ? tool.jaw_length : 0);
        whole_ = static_cast<float>((tool.pose.tip - tool.pose.trocar).norm());
        opening_ = static_cast<float>(tool.pose.jaw_angle * 180 / 3.14159265358979);
        hinge_.translate(vector(tool.pose.tip));
        hinge_.rotate(quaternion(tool.pose.orientation));
        hinge_.translate(0, 0, -jaws_);
    }

    /// Insulated to `bare` before the hinge, then steel as thick as `share` of it, to `end`.
    void shaft(float bare, float share, float end) {
        tube(-whole_ - 0.05F, -bare, radius_, true, steel);
        tube(-bare - 0.001F, end, share * radius_, false, steel);
    }
    void tube(float from, float to, float radius, bool insulated, const QVector3D& hue) {
        QMatrix4x4 pose = hinge_;
        pose.translate(0, 0, from);
        pose.scale(radius, radius, std::max(0.001F, to - from));
        parts_.push_back({ToolShape::shaft, pose, insulated, hue});
    }
    /// A shape in units of the shaft's radius.
    void turned(ToolShape shape, float share, const QVector3D& hue) {
        QMatrix4x4 pose = hinge_;
        pose.scale(share * radius_);
        parts_.push_back({shape, pose, false, hue});
    }
    /// A shape as long as the jaws, opened by `degrees`; the other side's lies across the shaft.
    void arm(ToolShape shape, bool other, float degrees, float wide, float thick, const QVector3D& hue) {
        QMatrix4x4 pose = hinge_;
        if (other) pose.rotate(180, 0, 0, 1);
        pose.rotate(-degrees, 1, 0, 0);
        pose.scale(wide * jaws_, thick * jaws_, jaws_);
        parts_.push_back({shape, pose, false, hue});
    }
    void pair(ToolShape shape, float wide, float thick, const QVector3D& hue) {
        for (const bool other : {false, true}) arm(shape, other, 0.5F * opening_, wide, thick, hue);
    }
    /// A hole in the tube's wall.
    void hole(float at, float turn) {
        QMatrix4x4 pose = hinge_;
        pose.rotate(turn, 0, 0, 1);
        pose.translate(0.86F * radius_, 0, at);
        pose.scale(0.12F * radius_, 0.30F * radius_, 0.42F * radius_);
        parts_.push_back({ToolShape::ball, pose, true, dark});
    }
    float radius() const { return radius_; }
    float opening() const { return opening_; }

  private:
    std::vector<ToolPart>& parts_;
    QMatrix4x4 hinge_;
    float radius_, jaws_, whole_, opening_;
};

}  // namespace

RigidMesh make_shape(ToolShape shape) {
    switch (shape) {
        case ToolShape::shaft:
            return make_shaft();
        case ToolShape::clevis:
            return make_clevis();
        case ToolShape::jaw:
            return make_jaw();
        case ToolShape::blade:
            return make_blade();
        case ToolShape::rod:
            return make_rod();
        case ToolShape::probe_end:
            return make_probe_end();
        case ToolShape::hook:
            return make_hook();
        case ToolShape::tube_end:
            return make_tube_end();
        case ToolShape::ball:
        case ToolShape::count:
            break;
    }
    return make_sphere();
}

void add_tool_parts(const DrawnTool& tool, std::vector<ToolPart>& parts) {
    if (!tool.pose.inside) return;
    Bench bench(tool, parts);
    const float r = bench.radius();
    switch (tool.kind) {
        case InstrumentKind::grasper:
            bench.shaft(0.012F, 0.86F, -r);
            bench.turned(ToolShape::clevis, 0.9F, steel);
            bench.pair(ToolShape::jaw, 1, 1, steel);
            break;
        case InstrumentKind::bowel_grasper:
            // Long slender jaws with a window along each, so that the wall bulges into it instead of being
            // crushed.
            bench.shaft(0.012F, 0.86F, -r);
            bench.turned(ToolShape::clevis, 0.9F, steel);
            bench.pair(ToolShape::jaw, 0.6F, 0.5F, steel);
            bench.pair(ToolShape::rod, 0.25F, 0.55F, dark);
            break;
        case InstrumentKind::scissors:
            bench.shaft(0.012F, 0.86F, -r);
            bench.turned(ToolShape::clevis, 0.9F, steel);
            bench.pair(ToolShape::blade, 1, 1, steel);
            break;
        case InstrumentKind::harmonic:
            // One arm with its pad closes on the bar that vibrates.
            bench.shaft(0.006F, 0.92F, -r);
            bench.turned(ToolShape::clevis, 0.9F, steel);
            bench.arm(ToolShape::rod, true, 0, 1, 1, steel);
            bench.arm(ToolShape::jaw, false, bench.opening(), 0.85F, 0.75F, 0.55F * steel);
            bench.arm(ToolShape::rod, false, bench.opening(), 0.9F, 0.45F, ceramic);
            break;
        case InstrumentKind::clip_applier:
            bench.shaft(0.030F, 0.95F, -r);
            bench.turned(ToolShape::clevis, 1.0F, brass);
            bench.pair(ToolShape::jaw, 1.35F, 0.75F, brass);
            break;
        case InstrumentKind::hook:
            bench.shaft(0.0115F, 0.55F, -3.0F * r);
            bench.tube(-0.0125F, -0.0095F, 0.80F * r, false, ceramic);
            bench.turned(ToolShape::hook, 0.86F, steel);
            break;
        case InstrumentKind::suction:
            bench.shaft(0.060F, 0.86F, -2.9F * r);
            bench.turned(ToolShape::tube_end, 0.86F, steel);
            for (int k = 0; k < 4; ++k)
                bench.hole(-(4.5F + 2.2F * static_cast<float>(k % 2)) * r, 90.0F * static_cast<float>(k));
            break;
        case InstrumentKind::probe:
            bench.shaft(0.020F, 0.86F, -3.0F * r);
            bench.turned(ToolShape::probe_end, 0.86F, steel);
            break;
    }
}

}  // namespace fulcrum::ui
