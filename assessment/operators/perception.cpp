// SPDX-License-Identifier: Apache-2.0
#include "assessment/operators/perception.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr std::size_t most_line_points = 512;  // of a sheet's line or flap that are looked at

/// Never beyond the room that was made.
void copy_within(const std::vector<Vector3>& from, std::vector<Vector3>& to) noexcept {
    const std::size_t count = std::min(from.size(), to.capacity());
    to.assign(from.begin(), from.begin() + static_cast<std::ptrdiff_t>(count));
}
constexpr std::size_t most_nerve_points = 64;

}  // namespace

DelayLine::DelayLine(const Scene& scene, double longest_delay_s) {
    const auto looks = static_cast<std::size_t>(std::ceil(longest_delay_s / scene.step_period())) + 4;
    looks_.resize(looks);
    if (scene.bowel) {
        const auto nodes = static_cast<std::size_t>(scene.bowel->segments) + 1;
        for (Perception& look : looks_) look.nodes.assign(nodes, Vector3::Zero());
        arc_lengths_.assign(nodes, 0.0);
    }
    if (scene.sheet || scene.septa) {
        for (Perception& look : looks_) {
            look.line.reserve(most_line_points);
            look.flap.reserve(most_line_points);
        }
        line_positions_.reserve(most_line_points);
    }
    if (scene.field() != nullptr) {
        for (Perception& look : looks_) {
            if (scene.bands) look.bands.resize(static_cast<std::size_t>(scene.bands->count));
            look.outlets.resize(scene.bands ? 2 * static_cast<std::size_t>(scene.bands->vessels)
                                            : field_outlet_capacity);
            look.nerve.reserve(most_nerve_points);
        }
    }
    if (scene.objects) {
        const auto rings = static_cast<std::size_t>(scene.objects->count);
        for (Perception& look : looks_) look.objects.resize(rings);
        tray_.objects.resize(rings);
        tray_.pegs.resize(2 * rings);
        tray_.corners.resize(static_cast<std::size_t>(scene.objects->sides));
    }
    if (scene.camera_targets)
        camera_targets_.targets.resize(static_cast<std::size_t>(scene.camera_targets->count));
    if (scene.targets) targets_.reserve(2 * static_cast<std::size_t>(scene.targets->per_hand));
}

void DelayLine::push(std::uint32_t tick, const WorldSnapshot& world, const TaskDisplay& display) noexcept {
    Perception& look = looks_[next_];
    look.tick = tick;
    look.valid = true;
    for (int h = 0; h < hand_count; ++h) {
        look.tip[h] = world.tools[h].tip;
        look.grasps[h] = world.grasps[h];
    }
    look.display = display;
    look.lens = world.camera.position;
    look.moving_tip = world.camera_targets.tip;
    look.moving_tip_velocity = world.camera_targets.tip_velocity;
    std::copy_n(world.bowel.nodes.begin(), std::min(look.nodes.size(), world.bowel.nodes.size()),
                look.nodes.begin());
    std::copy_n(world.objects.objects.begin(), std::min(look.objects.size(), world.objects.objects.size()),
                look.objects.begin());
    copy_within(world.sheet.line, look.line);
    copy_within(world.sheet.flap, look.flap);
    const std::vector<BandView>& bands = world.bands.bands;
    std::copy_n(bands.begin(), std::min(look.bands.size(), bands.size()), look.bands.begin());
    if (!world.field.empty()) {
        const FieldView& view = world.field[0];
        std::copy_n(view.outlets.begin(), std::min(look.outlets.size(), view.outlets.size()),
                    look.outlets.begin());
        look.nerve.clear();
        for (const NerveView& nerve : view.nerves) {
            for (const Vector3& point : nerve.line)
                if (look.nerve.size() < look.nerve.capacity()) look.nerve.push_back(point);
        }
        for (int h = 0; h < hand_count; ++h) look.tools[h] = view.tools[h];
        look.smoke = view.smoke;
    }
    if (count_ == 0) {
        if (!tray_.pegs.empty()) tray_ = world.objects;  // of the same sizes
        if (!camera_targets_.targets.empty()) camera_targets_ = world.camera_targets;
        const std::size_t places = std::min(line_positions_.capacity(), world.sheet.line_positions.size());
        line_positions_.assign(world.sheet.line_positions.begin(),
                               world.sheet.line_positions.begin() + static_cast<std::ptrdiff_t>(places));
        std::copy_n(world.bowel.node_arc_lengths.begin(),
                    std::min(arc_lengths_.size(), world.bowel.node_arc_lengths.size()), arc_lengths_.begin());
        const std::size_t targets = std::min(targets_.capacity(), world.targets.size());
        targets_.assign(world.targets.begin(), world.targets.begin() + static_cast<std::ptrdiff_t>(targets));
    }
    next_ = (next_ + 1) % looks_.size();
    count_ = std::min(count_ + 1, looks_.size());
}

const Perception& DelayLine::seen(std::uint32_t now, std::uint32_t delay) const noexcept {
    const std::size_t size = looks_.size();
    std::size_t at = (next_ + size - 1) % size;
    for (std::size_t i = 0; i + 1 < count_; ++i) {
        if (looks_[at].tick + delay <= now) break;
        at = (at + size - 1) % size;
    }
    return looks_[at];
}

}  // namespace fulcrum
