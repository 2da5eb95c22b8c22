// SPDX-License-Identifier: Apache-2.0
// Blades and lips as loads of the bowel's rod (bowel_cut.h says what they are).
#include <algorithm>

#include "sim_core/world/parts/bowel/bowel_part.h"

namespace fulcrum {
namespace {

constexpr double end_share = 0.01;     // of the length at either end, that hangs together with the body
constexpr double at_tether = 0.01;     // m along the bowel within which a tether has its place on the wall
constexpr std::size_t ring_loads = 8;  // of one blade

}  // namespace

// What is left of the surface must hang on something: both ends, and the wall under each tether of the
// mesentery.
void BowelPart::make_cut() {
    std::vector<std::int32_t> held;
    const auto& vertices = skin_->rest().vertices;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const double x = vertices[v].x();
        if (x < end_share * anatomy_.length || x > (1 - end_share) * anatomy_.length)
            held.push_back(static_cast<std::int32_t>(v));
    }
    for (const RodTether& tether : inputs_.tethers) {
        double least = 1e30;
        std::int32_t nearest = -1;
        for (std::size_t v = 0; v < vertices.size(); ++v) {
            if (std::abs(vertices[v].x() - tether.s) > at_tether) continue;
            const double distance =
                (skin_vertex(skin_->rows()[v], ring_frames_) - tether.anchor).squaredNorm();
            if (distance >= least) continue;
            least = distance;
            nearest = static_cast<std::int32_t>(v);
        }
        if (nearest >= 0) held.push_back(nearest);
    }
    cut_ = std::make_unique<BowelCut>(scene_, *skin_, held);
    inputs_.loads.reserve(inputs_.loads.capacity() + ring_loads * hand_count);
    good_inputs_.loads.reserve(inputs_.loads.capacity());
}

void BowelPart::press_blades(const ToolAction* actions, std::uint32_t tick, double dt) noexcept {
    for (int hand = 0; hand < hand_count; ++hand) {
        cut_->approach(hand, actions[hand], rings_.data(), tick, dt);
        const BowelCut::HandState& blade = cut_->hand(hand);
        if (!blade.linked || blade.free) continue;
        const Vector3 wanted = cut_->wanted(hand, ring_frames_.data());
        const SkinRow row = cut_->row(blade.place);
        const Vector3 place = skin_vertex(row, ring_frames_);
        const double s = std::clamp(cut_->rest_arc(blade.place), 0.0, rod_->length());
        const Matrix3 stiffness =
            rod_->stiffness_at(state_, s, rod_->wall_offset(state_, s, place), scratch_);
        const double size = wanted.norm();
        const Vector3 along = size > 0 ? Vector3(wanted / size) : blade.normal.unitOrthogonal();
        const double tissue = std::max(1e-3, along.dot(stiffness * along));
        // As every tool's force: taken at the step's end, to first order.
        Vector3 drag = relax_contact_force(blade.drag, wanted, blade.slope, tissue);
        drag -= drag.dot(blade.normal) * blade.normal;
        cut_->bear(hand, drag, tissue);
        RingWrench wrenches[skin_rings];
        for (int j = 0; j < skin_rings; ++j) {
            wrenches[j].force = row.weight[j] * drag;
            wrenches[j].moment =
                (ring_frames_[static_cast<std::size_t>(row.first_ring + j)].rotation * row.offset[j])
                    .cross(drag);
        }
        for (int j = 0; j < skin_rings && inputs_.loads.size() < inputs_.loads.capacity(); ++j) {
            const auto ring = static_cast<std::size_t>(row.first_ring + j);
            inputs_.loads.push_back({skin_->cage().arc_lengths[ring], wrenches[j].force, wrenches[j].moment});
        }
    }
}

}  // namespace fulcrum
