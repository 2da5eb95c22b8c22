// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/bowel/bowel_part.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

constexpr double settle_time = 4.0;  // s of simulated rest before an attempt begins
constexpr double unsolved_residual =
    0.05;  // share of the largest force: beyond it a step's reactions mean nothing

}  // namespace

void BowelPart::lay_down(const std::function<void()>& between_halves) {
    const double dt = scene_.step_period();
    const ToolAction nothing[hand_count];
    const int steps = static_cast<int>(settle_time / dt);
    for (int i = 0; i < steps; ++i) {
        apply(nothing, 0, dt);
        between_halves();
        solve(nothing, 0, dt);
        double fastest = 0;
        for (const Vector3& velocity : state_.velocities) fastest = std::max(fastest, velocity.norm());
        if (i > 100 && fastest < 2e-4) break;
    }
    stop();
}

void BowelPart::stop() noexcept {
    Rod::stop(state_);
}

void BowelPart::make_room_for_loads(std::size_t count) {
    inputs_.loads.reserve(inputs_.loads.capacity() + count);
    good_inputs_.loads.reserve(inputs_.loads.capacity());
}

double BowelPart::weight() const {
    return scene_.gravity.norm() * scene_.bowel->linear_density * rod_->length();
}

void BowelPart::begin_step() noexcept {
    if (cut_) cut_->forget_events();
}

void BowelPart::apply(const StepInput& input) noexcept {
    for (int hand = 0; hand < hand_count; ++hand) {
        ToolAction& action = actions_[hand];
        action = ToolAction();
        if (!touches_[static_cast<std::size_t>(hand)].has_instrument) continue;
        action.instrument = input.held[hand].instrument;
        action.tool = input.held[hand].tool;
        action.busy = input.busy(hand, this);
        action.takes = input.taker[hand] == this;
    }
    touch_tools(input);
    apply(actions_, input.tick(), input.dt);
}

std::uint32_t BowelPart::solve(const StepInput& input) noexcept {
    return solve(actions_, input.tick(), input.dt);
}

void BowelPart::touch_tools(const StepInput& input) noexcept {
    const TickOutput& last = input.last();
    for (int hand = 0; hand < hand_count; ++hand) {
        Touch& touch = touches_[static_cast<std::size_t>(hand)];
        if (!touch.has_instrument) continue;
        const LocalModel& local = input.models->hand[hand];
        step_tool_contact(touch.model, local, last.contact[hand].tool, local.tick + 1, touch.state,
                          touch.scratch, touch.result);
        if (touch.result.touching_surface) actions_[hand].contact = &touch.result;
        if (local.mode == LocalMode::surface) actions_[hand].near = &touch.result;
    }
}

void BowelPart::apply(const ToolAction* actions, std::uint32_t tick, double dt) noexcept {
    {
        Stopwatch watch(measuring_, costs_.grasps);
        update_grasps(actions, dt);
    }
    Stopwatch watch(measuring_, costs_.loads);
    gather_loads(actions, dt);
    if (with_jaws_) press_jaws(actions);
    if (cut_) press_blades(actions, tick, dt);
}

std::uint32_t BowelPart::solve(const ToolAction* actions, std::uint32_t tick, double dt) noexcept {
    {
        Stopwatch watch(measuring_, costs_.collision);
        find_contacts();
    }
    {
        Stopwatch watch(measuring_, costs_.rod);
        solve_rod(dt);
    }
    const std::uint32_t outcome = outcome_of();
    remember_forces();
    read_grasps();
    {
        Stopwatch watch(measuring_, costs_.rings);
        update_rings(dt);
    }
    {
        Stopwatch watch(measuring_, costs_.dents);
        update_dents(actions, dt);
    }
    if (cut_ && cut_->follow(actions, ring_frames_.data(), tick, dt)) keep_hold(actions);
    return outcome;
}

void BowelPart::solve_rod(double dt) noexcept {
    good_ = state_;
    good_inputs_ = inputs_;
    report_ = rod_->step(state_, inputs_, dt, scratch_, solve_);
    if (solve_.level != RodSolve::Level::newton_k || !report_.finite || report_.converged ||
        !(report_.residual > unsolved_residual))
        return;
    // A fixed number of iterations ended far from balance, as when contacts change hands: one step of
    // reactions that nobody exerted would be felt and scored. This step is worth the full solve, in parts if
    // need be.
    state_ = good_;
    inputs_ = good_inputs_;
    RodSolve full = solve_;
    full.level = RodSolve::Level::newton;
    full.iterations = 0;
    report_ = rod_->step(state_, inputs_, dt, scratch_, full);
}

std::uint32_t BowelPart::outcome_of() noexcept {
    std::uint32_t outcome = 0;
    took_back_ = !report_.finite || !Rod::finite(state_);
    if (took_back_) {
        state_ = good_;
        Rod::stop(state_);
        outcome = 3;
    } else if (report_.fault == RodFault::frozen) {
        outcome = 2;
    } else if (report_.fault == RodFault::substepped) {
        outcome = 1;
    }
    frozen_steps_ = outcome >= 2 ? frozen_steps_ + 1 : 0;
    if (frozen_steps_ > 40) outcome = 4;  // 0.2 s without a solution: report it
    return outcome;
}

void BowelPart::remember_forces() noexcept {
    for (std::size_t i = 0; i < inputs_.contacts.size(); ++i) {
        const auto slot = static_cast<std::size_t>(contacts_.cavity[i].sphere) * planes_remembered;
        for (std::size_t k = slot; k < slot + planes_remembered; ++k) {
            if (remembered_normal_[k].isZero()) {
                remembered_normal_[k] = inputs_.contacts[i].normal;
                remembered_lambda_[k] = inputs_.contacts[i].lambda;
                break;
            }
        }
    }
}

void BowelPart::read_grasps() noexcept {
    for (int hand = 0, k = 0; hand < hand_count; ++hand) {
        HandGrasp& grasp = grasps_[hand];
        if (!grasp.state.held) continue;
        const RodGrasp& solved = inputs_.grasps[static_cast<std::size_t>(k++)];
        grasp.state.reaction = solved.reaction;
        grasp.state.point = rod_->wall_point(state_, solved.s, solved.offset);
        // The factor of a solve that ended short of balance says nothing about the tissue: the last good one
        // stays.
        if (report_.converged)
            grasp.stiffness = rod_->stiffness_at(state_, solved.s, solved.offset, scratch_);
    }
}

void BowelPart::find_contacts() noexcept {
    for (std::size_t i = 0; i < centres_.size(); ++i)
        centres_[i] = rod_->frame_at(state_, spheres_.arc_lengths[i]).frame.position;
    collision_->collide(centres_.data(), lists_, contacts_);
    inputs_.contacts.clear();
    for (int i = 0; i < contacts_.cavity_count; ++i) {
        const CavityContact& found = contacts_.cavity[static_cast<std::size_t>(i)];
        RodContact contact;
        contact.s = spheres_.arc_lengths[static_cast<std::size_t>(found.sphere)];
        contact.normal = found.normal;
        contact.point = found.point;
        contact.radius = spheres_.radii[static_cast<std::size_t>(found.sphere)];
        contact.friction = scene_.bowel->floor_friction;
        const auto slot = static_cast<std::size_t>(found.sphere) * planes_remembered;
        for (std::size_t k = slot; k < slot + planes_remembered; ++k) {
            if (remembered_normal_[k].dot(found.normal) > 0.95) {
                contact.lambda = remembered_lambda_[k];
                break;
            }
        }
        inputs_.contacts.push_back(contact);
    }
    std::fill(remembered_normal_.begin(), remembered_normal_.end(), Vector3::Zero());
    std::fill(remembered_lambda_.begin(), remembered_lambda_.end(), 0.0);
    inputs_.self_contacts.clear();
    for (int i = 0;
         i < contacts_.pair_count && inputs_.self_contacts.size() < inputs_.self_contacts.capacity(); ++i) {
        const SphereContact& found = contacts_.pairs[static_cast<std::size_t>(i)];
        RodSelfContact contact;
        contact.s = spheres_.arc_lengths[static_cast<std::size_t>(found.first)];
        contact.other_s = spheres_.arc_lengths[static_cast<std::size_t>(found.second)];
        contact.normal = found.normal;
        contact.distance = spheres_.radii[static_cast<std::size_t>(found.first)] +
                           spheres_.radii[static_cast<std::size_t>(found.second)];
        inputs_.self_contacts.push_back(contact);
    }
}

void BowelPart::gather_loads(const ToolAction* actions, double dt) noexcept {
    inputs_.loads.clear();
    for (int hand = 0; hand < hand_count; ++hand) {
        const ToolContactResult* contact = actions[hand].contact;
        if (contact == nullptr || !contact->touching_surface || contact->filtered.count == 0 ||
            !contact->surface_force.allFinite()) {
            applied_push_[hand].setZero();
            continue;
        }
        // A stiff wall on a light rod: the force is taken at this step's end, to first order, not at its
        // beginning.
        const double s =
            std::clamp(skin_->rest().vertices[static_cast<std::size_t>(std::max(0, contact->vertex))].x(),
                       0.0, rod_->length());
        const Matrix3 stiffness =
            rod_->stiffness_at(state_, s, rod_->wall_offset(state_, s, contact->point), scratch_);
        const double tissue = std::max(1e-3, contact->normal.dot(stiffness * contact->normal));
        const double tool = contact->normal.dot(contact->stiffness * contact->normal) + contact->damping / dt;
        applied_push_[hand] = relax_contact_force(applied_push_[hand], contact->surface_force, tool, tissue);
        const FilteredForce& filtered = contact->filtered;
        int first = skin_->rings(), last = -1;
        for (int i = 0; i < filtered.count; ++i) {
            const SkinRow& row =
                skin_->rows()[static_cast<std::size_t>(filtered.vertex[static_cast<std::size_t>(i)])];
            first = std::min(first, row.first_ring);
            last = std::max(last, row.first_ring + skin_rings - 1);
        }
        for (int r = first; r <= last; ++r) wrenches_[static_cast<std::size_t>(r)] = RingWrench{};
        for (int i = 0; i < filtered.count; ++i) {
            const auto k = static_cast<std::size_t>(i);
            const SkinRow& row = skin_->rows()[static_cast<std::size_t>(filtered.vertex[k])];
            add_ring_wrenches(row, ring_frames_.data(), filtered.weight[k] * applied_push_[hand],
                              wrenches_.data());
        }
        for (int r = first; r <= last && inputs_.loads.size() < inputs_.loads.capacity(); ++r) {
            const auto k = static_cast<std::size_t>(r);
            inputs_.loads.push_back({skin_->cage().arc_lengths[k], wrenches_[k].force, wrenches_[k].moment});
        }
    }
}

void BowelPart::update_rings(double /*dt*/) noexcept {
    const auto& arcs = rod_->node_arc_lengths();
    std::size_t edge = 0;
    for (std::size_t r = 0; r < rings_.size(); ++r) {
        const double s = skin_->cage().arc_lengths[r];
        const RodMotion motion = rod_->frame_at(state_, s);
        rings_[r].frame = {motion.frame.position, motion.frame.rotation};
        rings_[r].velocity = motion.velocity;
        rings_[r].angular_velocity = motion.angular_velocity;
        while (edge + 2 < arcs.size() && arcs[edge + 1] < s) ++edge;
        ring_stretch_[r] =
            (state_.nodes[edge + 1] - state_.nodes[edge]).norm() / (arcs[edge + 1] - arcs[edge]);
    }
    if (lumen_) {
        lumen_->solve(ring_stretch_.data());
        for (std::size_t r = 0; r < rings_.size(); ++r) {
            const double scale = lumen_->scale(static_cast<int>(r));
            rings_[r].frame.rotation.leftCols<2>() *= scale;
        }
    }
    for (std::size_t r = 0; r < rings_.size(); ++r) ring_frames_[r] = rings_[r].frame;
}

void BowelPart::update_dents(const ToolAction* actions, double dt) noexcept {
    SurfaceLoad loads[2 * hand_count];
    int count = 0;
    for (int hand = 0; hand < hand_count; ++hand) {
        const ToolAction& action = actions[hand];
        if (action.contact != nullptr && action.contact->touching_surface)
            loads[count++] = {&action.contact->filtered, nullptr, applied_push_[hand]};
        const HandGrasp& grasp = grasps_[hand];
        if (grasp.state.held && grasp.filtered.count > 0)
            loads[count++] = {&grasp.filtered, nullptr, grasp.state.reaction};
    }
    step_dents(bed_, skin_->vertex_areas().data(), loads, count, dt, dents_);
}

}  // namespace fulcrum
