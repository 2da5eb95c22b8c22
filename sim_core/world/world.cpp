// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/world.h"

#include <algorithm>

#include "sim_core/numerics/owned_bytes.h"
#include "sim_core/world/part/stopwatch.h"
#include "sim_core/world/registry.h"

namespace fulcrum {

World::World(const Scene& scene, std::uint64_t seed)
    : scene_(scene), parts_(build_parts(scene_, seed)), couplings_(build_couplings(scene_, parts_)) {
    for (const std::unique_ptr<Coupling>& coupling : couplings_) coupling->settle(scene_.step_period());
    order_solving();
    wall_ = wall_of(parts_);
    if (scene_.camera) scope_ = std::make_unique<ScopeModel>(make_scope(*scene_.camera));
    for (const std::unique_ptr<Part>& part : parts_) part->size_snapshot(snapshot_);

    // The world before the first tick: instruments where their devices are aligned at the start.
    TickOutput start;
    for (const InstrumentSpec& spec : scene_.instruments) {
        const auto hand = static_cast<std::size_t>(spec.hand);
        has_instrument_[hand] = true;
        start.input.hand[hand] = start_sample(spec.trocar, spec.start_insertion);
        start.contact[hand].tool =
            tool_pose(make_instrument(spec, scene_.tick_period()), start.input.hand[hand]);
    }
    if (scene_.camera)
        start.input.camera = start_sample(scene_.camera->trocar, scene_.camera->start_insertion);
    fill_models(start);
    fill_snapshot(start);
}

World::~World() = default;

// What hangs on a part is solved right before it; otherwise the parts' own order.
void World::order_solving() {
    for (const std::unique_ptr<Part>& part : parts_) {
        for (const std::unique_ptr<Coupling>& coupling : couplings_) {
            if (&coupling->carrier() != part.get()) continue;
            for (const std::unique_ptr<Part>& carried : parts_) {
                if (carried.get() == &coupling->carried())
                    solving_.push_back({carried.get(), coupling.get(), 0});
            }
        }
        const bool hangs = std::any_of(
            couplings_.begin(), couplings_.end(),
            [&](const std::unique_ptr<Coupling>& coupling) { return &coupling->carried() == part.get(); });
        if (!hangs) solving_.push_back({part.get(), nullptr, 0});
    }
}

StepRecord World::step(const TickOutput* outputs, std::size_t count) noexcept {
    StepRecord record;
    record.step = ++steps_;
    record.first_tick = outputs[0].sample.tick;
    record.last_tick = outputs[count - 1].sample.tick;
    const TickOutput& last = outputs[count - 1];

    for (const std::unique_ptr<Part>& part : parts_) part->begin_step();
    const bool paused = (last.sample.rig_flags & (rig_paused | rig_device_lost)) != 0U;
    if (!paused) {
        begin_input(outputs, count);
        decide_takers();
        record.outcome = advance();
        if (fails_ != nullptr && fails_->load(std::memory_order_relaxed)) record.outcome = 4;
    }
    {
        Stopwatch watch(measuring_, models_us_);
        fill_models(last);
    }
    {
        Stopwatch watch(measuring_, snapshot_us_);
        fill_snapshot(last);
    }
    snapshot_.outcome = record.outcome;
    if (record.last_tick >= next_hash_tick_) {
        record.state_hash = hash();
        next_hash_tick_ = (record.last_tick / hash_every_ticks + 1) * hash_every_ticks;
    }
    return record;
}

void World::begin_input(const TickOutput* outputs, std::size_t count) noexcept {
    input_ = StepInput();
    input_.outputs = outputs;
    input_.count = count;
    input_.dt = scene_.step_period();
    input_.models = &models_;
    for (int hand = 0; hand < hand_count; ++hand) {
        if (!has_instrument_[hand]) continue;
        HeldTool& held = input_.held[hand];
        held.instrument = scene_.instrument(static_cast<Hand>(hand));
        held.tool = input_.last().contact[hand].tool;
        for (const std::unique_ptr<Part>& part : parts_) {
            part->exchange(hand, input_, held);
            if (part->holds(hand)) input_.holder[hand] = part.get();
        }
    }
}

// Closing jaws take what is nearest; of equals the one that hangs on the other.
void World::decide_takers() noexcept {
    for (int hand = 0; hand < hand_count; ++hand) {
        if (input_.held[hand].instrument == nullptr) continue;
        double nearest = Part::no_offer;
        for (const Solved& solved : solving_) {
            const double distance = solved.part->offer(hand, input_.held[hand]);
            if (!(distance < nearest)) continue;
            nearest = distance;
            input_.taker[hand] = solved.part;
        }
    }
}

std::uint32_t World::advance() noexcept {
    for (Solved& solved : solving_) {
        Stopwatch watch(measuring_, solved.us);
        solved.part->apply(input_);
    }
    std::uint32_t outcome = 0;
    for (Solved& solved : solving_) {
        double us = 0;
        {
            Stopwatch watch(measuring_, us);
            if (solved.coupling != nullptr) solved.coupling->carry(input_.dt);
            outcome = std::max(outcome, solved.part->solve(input_));
            if (solved.coupling != nullptr) solved.coupling->pull();
        }
        solved.us += us;
    }
    for (const std::unique_ptr<Coupling>& coupling : couplings_) coupling->follow();
    return outcome;
}

void World::fill_models(const TickOutput& last) noexcept {
    for (int hand = 0; hand < hand_count; ++hand) {
        if (!has_instrument_[hand]) continue;
        LocalModel& model = models_.hand[hand];
        model.begin(steps_, last.sample.tick);
        for (const std::unique_ptr<Part>& part : parts_) part->publish_model(hand, last, model);
        model.cavity_seed =
            wall_ != nullptr ? wall_->closest(last.contact[hand].tool.tip, 0.05).triangle : -1;
    }
}

void World::fill_snapshot(const TickOutput& last) noexcept {
    snapshot_.step = steps_;
    snapshot_.tick = last.sample.tick;
    snapshot_.event_count = 0;
    for (int hand = 0; hand < hand_count; ++hand) {
        if (!has_instrument_[hand]) continue;
        snapshot_.tools[hand] = last.contact[hand].tool.pose();
    }
    if (scope_) snapshot_.camera = scope_pose(*scope_, last.input.camera);
    for (const std::unique_ptr<Part>& part : parts_) part->fill_snapshot(snapshot_);
    for (std::size_t hand = 0; hand < hand_count; ++hand) {
        show_grasp(hand);
        show_lift(hand, last.contact[hand].touches);
    }
}

void World::show_lift(std::size_t hand, TouchList touches) noexcept {
    for (std::int32_t i = 0; i < touches.count; ++i) {
        Touch& touch = touches.touch[static_cast<std::size_t>(i)];
        for (const std::unique_ptr<Part>& part : parts_) part->show_touch(touch);
    }
    snapshot_.lift[hand] = lift_out(touches);
}

void World::show_grasp(std::size_t hand) noexcept {
    GraspState& shown = snapshot_.grasps[hand];
    const int number = static_cast<int>(hand);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
        if (!parts_[i]->holds(number)) continue;
        last_holder_[hand] = i;
        shown = parts_[i]->grasp(number);
        shown.held = true;
        return;
    }
    if (!shown.held) return;
    shown.held = false;
    shown.slipped = parts_[last_holder_[hand]]->slipped(number);
    shown.reaction.setZero();
}

std::uint64_t World::hash() const noexcept {
    StateHash hash;
    hash.add(static_cast<std::int64_t>(steps_));
    for (const ToolPose& tool : snapshot_.tools) {
        hash.add(tool.tip);
        hash.add(tool.axis);
        hash.add(tool.jaw_angle);
    }
    for (const std::unique_ptr<Part>& part : parts_) part->hash(hash);
    return hash.value() == 0 ? 1 : hash.value();  // 0 means: no hash in this step
}

struct World::Saved {
    std::vector<StateList::Values> parts;
    LocalModels models;
    WorldSnapshot snapshot;
    std::size_t last_holder[hand_count] = {};
    std::uint32_t steps = 0, next_hash_tick = 0;
};

std::shared_ptr<const World::Saved> World::save() const {
    auto saved = std::make_shared<Saved>();
    for (const std::unique_ptr<Part>& part : parts_) saved->parts.push_back(part->save());
    saved->models = models_;
    saved->snapshot = snapshot_;
    std::copy_n(last_holder_, hand_count, saved->last_holder);
    saved->steps = steps_;
    saved->next_hash_tick = next_hash_tick_;
    return saved;
}

void World::restore(const Saved& saved) {
    for (std::size_t i = 0; i < parts_.size(); ++i) parts_[i]->restore(saved.parts.at(i));
    models_ = saved.models;
    snapshot_ = saved.snapshot;
    std::copy_n(saved.last_holder, hand_count, last_holder_);
    steps_ = saved.steps;
    next_hash_tick_ = saved.next_hash_tick;
}

void World::transfer(StateArchive& archive) {
    for (const std::unique_ptr<Part>& part : parts_) part->transfer(archive);
    archive(models_, snapshot_, last_holder_, steps_, next_hash_tick_);
    if (archive.reads()) point_to_wall(models_);
}

void World::point_to_wall(LocalModels& models) const noexcept {
    const LayeredWall* wall = nullptr;
    for (const std::unique_ptr<Part>& part : parts_) {
        if (part->layered_wall() != nullptr) wall = part->layered_wall();
    }
    for (LocalModel& model : models.hand) model.point_to(wall);
}

void World::measure(bool on) {
    measuring_ = on;
    for (const std::unique_ptr<Part>& part : parts_) part->measure(on);
}

std::vector<PartCost> World::costs() const {
    std::vector<PartCost> costs;
    for (const Solved& solved : solving_) solved.part->add_costs(solved.us, costs);
    costs.push_back({"contact_models", models_us_, sizeof(LocalModels)});
    costs.push_back({"snapshot", snapshot_us_, sizeof(WorldSnapshot) + owned_bytes(snapshot_)});
    return costs;
}

}  // namespace fulcrum
