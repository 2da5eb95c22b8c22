// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/world.h"

#include <algorithm>

#include "sim_core/numerics/input_error.h"
#include "sim_core/rigid/targets.h"
#include "sim_core/scene/perforation.h"
#include "sim_core/world/parts/bowel/anatomy_binding.h"
#include "sim_core/world/stopwatch.h"

namespace fulcrum {
namespace {

constexpr double settle_time = 4.0;  // s at most in which rectum and septa come to rest together

}  // namespace

World::World(const Scene& scene, std::uint64_t seed) : scene_(scene) {
    for (const InstrumentSpec& spec : scene_.instruments) {
        const int hand = static_cast<int>(spec.hand);
        instruments_[hand] = make_instrument(spec, scene_.tick_period());
        has_instrument_[hand] = true;
    }
    if (scene_.camera) scope_ = std::make_unique<ScopeModel>(make_scope(*scene_.camera));
    if (scene_.targets) {
        const auto tissue = static_cast<std::int16_t>(scene_.tissue_index(scene_.targets->tissue));
        for (const TargetSphere& sphere : place_targets(*scene_.targets, seed)) {
            TargetModel target;
            target.centre = sphere.centre;
            target.radius = sphere.radius;
            target.stiffness = scene_.targets->stiffness;
            target.damping = scene_.targets->damping;
            target.id = static_cast<std::int32_t>(targets_.size());
            target.tissue = tissue;
            targets_.push_back(target);
            snapshot_.targets.push_back(sphere);
        }
        if (targets_.size() > target_capacity) {
            throw InputError(scene_.id, "/targets/per_hand", "more targets than the local model holds",
                             "use at most " + std::to_string(target_capacity / 2));
        }
    }
    build_anatomy(seed);

    if (scene_.sheet || scene_.septa) {
        sheet_ = std::make_unique<SheetPart>(scene_, scene_.step_period());
        sheet_->size_snapshot(snapshot_);
    }
    if (sheet_ && bowel_) hang_septa();
    if (scene_.structures) {
        const RectumParameters rectum = rectum_parameters(scene_);
        structures_ = std::make_unique<StructuresPart>(
            scene_, presacral_wall(rectum.curve, rectum.promontory), *cavity_, sheet_.get(), seed);
        structures_->size_snapshot(snapshot_);
    }

    // The world before the first tick: instruments where their devices are aligned at the start.
    TickOutput start;
    for (int hand = 0; hand < hand_count; ++hand) {
        const InstrumentSpec* spec = scene_.instrument(static_cast<Hand>(hand));
        if (spec == nullptr) continue;
        start.input.hand[hand] = start_sample(spec->trocar, spec->start_insertion);
        start.contact[hand].tool = tool_pose(instruments_[hand], start.input.hand[hand]);
    }
    if (scene_.camera)
        start.input.camera = start_sample(scene_.camera->trocar, scene_.camera->start_insertion);
    fill_models(start);
    fill_snapshot(start);
}

World::~World() = default;

void World::build_anatomy(std::uint64_t seed) {
    if (scene_.cavity) cavity_ = std::make_unique<CavityModel>(cavity_mesh(*scene_.cavity), FreeSide::behind);
    if (scene_.presacral)
        cavity_ =
            std::make_unique<CavityModel>(make_presacral_wall(rectum_parameters(scene_)), FreeSide::front);
    if (scene_.bands) {
        cavity_ = std::make_unique<CavityModel>(bed_mesh(*scene_.bands), FreeSide::front);
        bands_ = std::make_unique<BandsPart>(scene_, seed);
        bands_->size_snapshot(snapshot_);
    }
    if (scene_.bowel) {
        bowel_ = std::make_unique<BowelPart>(scene_, bowel_anatomy(scene_), cavity_.get());
        bowel_->size_snapshot(snapshot_);
        const double puncture = draw_perforation_forces(
            scene_, seed)[static_cast<std::size_t>(scene_.tissue_index(scene_.bowel->tissue))];
        if (puncture > 0) bowel_->set_puncture_force(puncture);
        contacts_ = std::make_unique<HandContacts>();
        for (int hand = 0; hand < hand_count; ++hand) {
            contacts_->model[hand] = make_tool_contact(scene_, instruments_[hand]);
            contacts_->model[hand].instrument.tick_period = scene_.step_period();  // one step is its tick
        }
    }
}

// From the shape in which the rectum lay without them to rest.
void World::hang_septa() {
    const double dt = scene_.step_period();
    sheet_->hang_on(scene_, bowel_->rod(), bowel_->state(), dt);
    const SheetAction no_tool[hand_count];
    const ToolAction nothing[hand_count];
    const int steps = static_cast<int>(settle_time / dt);
    for (int i = 0; i < steps; ++i) {
        sheet_->carry_edge(bowel_->rod(), bowel_->state(), dt);
        sheet_->step(no_tool, 0, dt);
        bowel_->step(nothing, dt, &sheet_->pulls());
        double fastest = 0;
        for (const Vector3& velocity : bowel_->state().velocities)
            fastest = std::max(fastest, velocity.norm());
        if (i > 100 && fastest < 2e-4) break;
    }
    sheet_->stop();
    bowel_->stop();
}

HeldTool World::held(int hand, const TickOutput& last) const noexcept {
    if (structures_) return structures_->held(hand, last.contact[hand].tool);
    return {scene_.instrument(static_cast<Hand>(hand)), last.contact[hand].tool, false};
}

StepRecord World::step(const TickOutput* outputs, std::size_t count) noexcept {
    StepRecord record;
    record.step = ++steps_;
    record.first_tick = outputs[0].sample.tick;
    record.last_tick = outputs[count - 1].sample.tick;
    const TickOutput& last = outputs[count - 1];

    const bool paused = (last.sample.rig_flags & (rig_paused | rig_device_lost)) != 0U;
    SheetAction on_sheet[hand_count];
    if (bowel_) bowel_->forget_events();
    if (sheet_) {
        Stopwatch watch(measuring_, sheet_us_);
        sheet_->forget_events();
        for (int hand = 0; hand < hand_count && !paused; ++hand) {
            if (!has_instrument_[hand]) continue;
            SheetAction& action = on_sheet[hand];
            const HeldTool now = held(hand, last);
            action.instrument = now.instrument;
            action.tool = now.tool;
            action.energised = now.energised;
            if (!bowel_) continue;
            // Jaws take what is nearer.
            action.busy = bowel_->grasp(static_cast<Hand>(hand)).held;
            if (action.busy || !sheet_->closing(hand, action)) continue;
            ToolAction jaws;
            jaws.instrument = action.instrument;
            jaws.tool = action.tool;
            action.other = bowel_->distance_to_jaws(jaws);
        }
        if (!paused) {
            if (bowel_) sheet_->carry_edge(bowel_->rod(), bowel_->state(), scene_.step_period());
            record.outcome = sheet_->step(on_sheet, record.last_tick, scene_.step_period());
        }
    }
    if (bowel_ && !paused) {
        ToolAction actions[hand_count];
        for (int hand = 0; hand < hand_count; ++hand) {
            if (!has_instrument_[hand]) continue;
            ToolAction& action = actions[hand];
            const HeldTool now = held(hand, last);
            action.instrument = now.instrument;
            action.tool = now.tool;
            action.busy = sheet_ && sheet_->holds(hand);
            for (std::size_t i = 0; i < count; ++i)
                action.slipping = action.slipping || outputs[i].contact[hand].slipping;
        }
        find_contacts(last, actions);
        const std::vector<RodLoad>* pulls = sheet_ ? &sheet_->pulls() : nullptr;
        record.outcome =
            std::max(record.outcome, bowel_->step(actions, scene_.step_period(), pulls, record.last_tick));
    }
    if (bands_ && !paused) {
        Stopwatch watch(measuring_, bands_us_);
        record.outcome = std::max(record.outcome, bands_->step(outputs, count, scene_.step_period()));
    }
    if (structures_ && !paused) {
        Stopwatch watch(measuring_, structures_us_);
        structures_->step(outputs, count, scene_.step_period());
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

void World::find_contacts(const TickOutput& last, ToolAction* actions) noexcept {
    for (int hand = 0; hand < hand_count; ++hand) {
        if (!has_instrument_[hand]) continue;
        ToolContactResult& result = contacts_->result[hand];
        const LocalModel& local = models_.hand[hand];
        step_tool_contact(contacts_->model[hand], local, last.contact[hand].tool, local.tick + 1,
                          contacts_->state[hand], contacts_->scratch[hand], result);
        if (result.touching_surface) actions[hand].contact = &result;
        if (local.mode == LocalMode::surface) actions[hand].near = &result;
    }
}

void World::fill_models(const TickOutput& last) noexcept {
    for (int hand = 0; hand < hand_count; ++hand) {
        if (!has_instrument_[hand]) continue;
        LocalModel& model = models_.hand[hand];
        model.step = steps_;
        model.tick = last.sample.tick;
        model.mode = LocalMode::none;
        if (bowel_) {
            PatchRequest request;
            request.tool = last.contact[hand].tool;
            request.shaft_radius = instruments_[hand].shaft_radius;
            request.contact_vertex = last.contact[hand].vertex;
            request.horizon =
                2 * scene_.step_period();  // until the next model is there, were it a whole step late
            bowel_->fill_local_model(static_cast<Hand>(hand), request, model);
        }
        if (sheet_) {
            sheet_->fill_local_model(hand, model);
        } else {
            model.sheet = SheetContactModel();
        }
        if (bowel_) bowel_->fill_blade(static_cast<Hand>(hand), model);
        if (bands_) bands_->fill_local_model(static_cast<Hand>(hand), model);
        if (structures_) structures_->fill_local_model(hand, model);
        model.target_count = static_cast<std::int32_t>(targets_.size());
        std::copy(targets_.begin(), targets_.end(), model.targets.begin());
        model.cavity_seed = cavity_ ? cavity_->closest(last.contact[hand].tool.tip, 0.05).triangle : -1;
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
    if (bowel_) bowel_->fill_snapshot(snapshot_);
    if (sheet_) sheet_->fill_snapshot(snapshot_);
    if (bands_) bands_->fill_snapshot(snapshot_);
    if (structures_) structures_->fill_snapshot(snapshot_);
}

std::uint64_t World::hash() const noexcept {
    StateHash hash;
    hash.add(static_cast<std::int64_t>(steps_));
    for (const ToolPose& tool : snapshot_.tools) {
        hash.add(tool.tip);
        hash.add(tool.axis);
        hash.add(tool.jaw_angle);
    }
    if (bowel_) bowel_->hash(hash);
    if (sheet_) sheet_->hash(hash);
    if (bands_) bands_->hash(hash);
    if (structures_) structures_->hash(hash);
    return hash.value() == 0 ? 1 : hash.value();  // 0 means: no hash in this step
}

void World::measure(bool on) {
    measuring_ = on;
    if (bowel_) bowel_->measure(on);
}

std::vector<PartCost> World::costs() const {
    std::vector<PartCost> costs;
    if (cavity_) costs.push_back({"cavity", 0, cavity_->bytes()});
    if (bowel_) {
        const BowelPart::Costs& cost = bowel_->costs();
        costs.push_back({"rod", cost.rod + cost.grasps + cost.loads, bowel_->bytes_rod()});
        costs.push_back({"collision", cost.collision, bowel_->bytes_collision()});
        costs.push_back({"cage_and_surface", cost.rings + cost.dents, bowel_->bytes_surface()});
        if (scene_.tethers)
            costs.push_back(
                {"tethers", 0, sizeof(RodTether) * static_cast<std::size_t>(scene_.tethers->count)});
        if (!scene_.membranes.empty())
            costs.push_back({"membranes", cost.membranes, bowel_->bytes_membranes()});
    }
    if (sheet_) costs.push_back({"sheet", sheet_us_, sheet_->bytes()});
    if (bands_) costs.push_back({"bands", bands_us_, bands_->bytes()});
    if (structures_) costs.push_back({"structures", structures_us_, structures_->bytes()});
    if (scene_.targets) costs.push_back({"targets", 0, targets_.capacity() * sizeof(TargetModel)});
    costs.push_back({"contact_models", models_us_, sizeof(LocalModels)});
    costs.push_back({"snapshot", snapshot_us_,
                     sizeof(WorldSnapshot) + snapshot_.rings.capacity() * sizeof(RingFrame) +
                         snapshot_.nodes.capacity() * sizeof(Vector3)});
    return costs;
}

}  // namespace fulcrum
