// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/bowel/bowel_part.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"
#include "sim_core/scene/perforation.h"

namespace fulcrum {
namespace {

constexpr int planes_remembered = 6;         // a sphere, as SphereCollisionOptions::planes_per_sphere
constexpr double pattern_time = 0.05;        // s, dents and grasp corrections settle in this time
constexpr double settle_time = 4.0;          // s of simulated rest before an attempt begins
constexpr double backing_stiffness = 2.5e7;  // N/m3, contents and fat behind the wall

// Points at equal distances along a polyline, ends included.
std::vector<Vector3> resample(const std::vector<Vector3>& line, int points) {
    std::vector<double> along(line.size(), 0.0);
    for (std::size_t i = 1; i < line.size(); ++i) along[i] = along[i - 1] + (line[i] - line[i - 1]).norm();
    std::vector<Vector3> result;
    std::size_t k = 0;
    for (int i = 0; i < points; ++i) {
        const double s = along.back() * i / (points - 1);
        while (k + 2 < line.size() && along[k + 1] < s) ++k;
        const double span = along[k + 1] - along[k];
        const double u = span > 0 ? (s - along[k]) / span : 0.0;
        result.push_back((1 - u) * line[k] + u * line[k + 1]);
    }
    return result;
}

constexpr double unsolved_residual =
    0.05;  // share of the largest force: beyond it a step's reactions mean nothing

RodSolve rod_solve(const Fidelity& fidelity) {
    RodSolve solve;
    if (fidelity.rod == RodLevel::linearised) {
        solve.level = RodSolve::Level::linearised;
        solve.iterations = 1;
    } else if (fidelity.rod == RodLevel::newton_k) {
        solve.level = RodSolve::Level::newton_k;
        solve.iterations = fidelity.rod_iterations;
    }
    return solve;
}

RodSpec rod_spec(const Scene& scene, const std::vector<Vector3>& centre_line, bool held_free) {
    const BowelSpec& bowel = *scene.bowel;
    RodSpec spec;
    spec.segments = bowel.segments;
    spec.length = bowel.length;
    spec.outer_radius = bowel.outer_radius;
    spec.inner_radius = bowel.outer_radius - bowel.wall_thickness;
    spec.young_modulus = bowel.young_modulus;
    spec.poisson_ratio = bowel.poisson_ratio;
    spec.layers = bowel.layers;
    if (scene.fidelity.material == MaterialLaw::exp2) {
        // The same tissue: the scene's moduli are those of the line that fits EXP2 best.
        spec.law = MaterialLaw::exp2;
        spec.young_modulus *= exp2_rest_share;
        for (WallLayer& layer : spec.layers) layer.young *= exp2_rest_share;
    }
    spec.linear_density = bowel.linear_density;
    spec.mass_damping = bowel.damping;
    spec.ends[0] = RodEnd::clamped;
    spec.ends[1] = held_free ? RodEnd::free : RodEnd::clamped;
    // The bowel has grown in its place: its in-situ shape is its natural one, and only gravity bends it away.
    spec.rest_nodes = resample(centre_line, bowel.segments + 1);
    return spec;
}

TissueContact tissue_contact(const Scene& scene, const WinklerBed& bed) {
    const int index = scene.tissue_index(scene.bowel->tissue);
    const TissueSpec& tissue = scene.tissues[static_cast<std::size_t>(index)];
    TissueContact contact;
    contact.tissue = static_cast<std::int16_t>(index);
    contact.stiffness_per_area = bed.stiffness_per_area;
    contact.most_stiffness = 2.0 * tissue.stiffness;
    contact.least_stiffness = 0.25 * tissue.stiffness;
    contact.damping = tissue.damping;
    return contact;
}

}  // namespace

BowelPart::BowelPart(const Scene& scene, BowelAnatomy anatomy, const CavityModel* cavity)
    : scene_(scene), anatomy_(std::move(anatomy)) {
    const BowelSpec& spec = *scene.bowel;
    rod_ = std::make_unique<Rod>(rod_spec(scene, anatomy_.centre_line, !anatomy_.cranial_holds.empty()));
    // The skin is bound along the rod's own arc length, whatever the polyline's exact length is.
    spheres_ = sample_spheres(rod_->length(), spec.sphere_spacing, anatomy_.radius);
    skin_ = std::make_unique<BowelSkin>(anatomy_.surface,
                                        build_cage(anatomy_.surface, anatomy_.length, spheres_));
    SphereCollisionOptions options;
    options.projection_iterations = scene.fidelity.projection_iterations;
    if (scene.fidelity.collision == CollisionSearch::brute) options.list_margin = 0.0;
    collision_ = std::make_unique<SphereCollision>(
        cavity, SphereChainShape{spheres_.arc_lengths, spheres_.radii}, options);
    bed_ = winkler_bed(spec.young_modulus, spec.poisson_ratio, spec.wall_thickness, backing_stiffness,
                       pattern_time);
    PatchOptions patch;
    patch.contact = tissue_contact(scene, bed_);
    patches_ = std::make_unique<PatchBuilder>(*skin_, patch, divide_into_patches(*skin_, 2, 4));
    build_wall();
    solve_ = rod_solve(scene.fidelity);
    filter_ = filter_mode(scene.fidelity.filter);

    state_ = rod_->make_state();
    good_ = state_;
    size_lists(scene);
    hang_tethers(scene);
    update_rings(0.0);
    if (scene.membranes.empty()) lay_down([] {});
    if (scene.tissues[static_cast<std::size_t>(scene.tissue_index(spec.tissue))].cutting) make_cut();
}

void BowelPart::size_lists(const Scene& scene) {
    const int spheres = static_cast<int>(spheres_.arc_lengths.size());
    const int tethers =
        static_cast<int>(anatomy_.cranial_holds.size()) + (scene.tethers ? scene.tethers->count : 0);
    scratch_ = rod_->make_scratch(std::max(1, tethers), hand_count, spheres * planes_remembered, 512);
    lists_ = collision_->make_lists();
    contacts_ = collision_->make_contacts();
    centres_.assign(static_cast<std::size_t>(spheres), Vector3::Zero());
    const auto ring_count = static_cast<std::size_t>(skin_->rings());
    rings_.resize(ring_count);
    ring_stretch_.assign(ring_count, 1.0);
    ring_frames_.resize(ring_count);
    wrenches_.resize(ring_count);
    surface_.assign(static_cast<std::size_t>(skin_->vertices()), Vector3::Zero());
    patch_scratch_ = patches_->make_scratch();
    patch_damage_.assign(static_cast<std::size_t>(patch_count(*skin_, 2, 4)), 0.0F);
    remembered_lambda_.assign(static_cast<std::size_t>(spheres * planes_remembered), 0.0);
    remembered_normal_.assign(remembered_lambda_.size(), Vector3::Zero());
    inputs_.gravity = scene.bowel->weight * scene.gravity;
    std::size_t hung = 0;
    with_jaws_ = scene.fidelity.tool_contact == ToolContactLevel::jaws;
    touches_.resize(hand_count);
    for (const InstrumentSpec& spec : scene.instruments) {
        const auto hand = static_cast<std::size_t>(spec.hand);
        const InstrumentModel instrument =
            make_instrument(spec, scene.step_period());  // one step is its tick
        touches_[hand].has_instrument = true;
        touches_[hand].model = make_tool_contact(scene, instrument);
        if (!with_jaws_) continue;
        jaw_models_[hand] = instrument;
        jaw_pushes_[hand].assign(centres_.size(), Vector3::Zero());
        hung += centres_.size();
    }
    inputs_.loads.reserve(2 * 16 + extra_loads + hung);
    inputs_.grasps.reserve(hand_count);
    inputs_.contacts.reserve(static_cast<std::size_t>(spheres * planes_remembered));
    inputs_.self_contacts.reserve(512);
    inputs_.ends[0] = state_.ends[0];
    inputs_.ends[1] = state_.ends[1];
    good_inputs_.grasps.reserve(hand_count);
    good_inputs_.contacts.reserve(inputs_.contacts.capacity());
    good_inputs_.self_contacts.reserve(inputs_.self_contacts.capacity());
    good_inputs_.loads.reserve(inputs_.loads.capacity());
    good_inputs_.tethers.reserve(static_cast<std::size_t>(std::max(1, tethers)));
}

void BowelPart::hang_tethers(const Scene& scene) {
    inputs_.tethers = anatomy_.cranial_holds;
    for (RodTether& hold : inputs_.tethers) hold.s = std::min(hold.s, rod_->length());
    if (!scene.tethers) return;
    const TetherSpec& tether = *scene.tethers;
    for (int i = 0; i < tether.count; ++i) {
        const double share = tether.first + (tether.last - tether.first) * (i + 0.5) / tether.count;
        RodTether spring;
        spring.s = share * rod_->length();
        const auto root = resample(anatomy_.root_line, 2 * tether.count + 1);
        spring.anchor = root[static_cast<std::size_t>(std::lround(share * 2.0 * tether.count))];
        spring.stiffness = tether.stiffness;
        spring.damping = tether.damping;
        spring.rest_length =
            tether.slack * (rod_->frame_at(state_, spring.s).frame.position - spring.anchor).norm();
        inputs_.tethers.push_back(spring);
    }
}

void BowelPart::lay_down(const std::function<void()>& meanwhile) {
    const double dt = scene_.step_period();
    const ToolAction nothing[hand_count];
    const int steps = static_cast<int>(settle_time / dt);
    for (int i = 0; i < steps; ++i) {
        apply(nothing, 0, dt);
        meanwhile();
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

// What the scene asks for beyond one constant stiffness and the local scope.
void BowelPart::build_wall() {
    const BowelSpec& spec = *scene_.bowel;
    if (scene_.fidelity.skinning != SkinScope::local) {
        wide_skin_ = std::make_unique<WideSkin>(*skin_, scene_.fidelity.skinning);
        patches_->set_scope(wide_skin_.get());
    }
    if (spec.luminal_bulk_modulus > 0) {
        LuminalSpec lumen;
        lumen.bulk_modulus = spec.luminal_bulk_modulus;
        lumen.young_modulus = spec.young_modulus;
        lumen.wall_thickness = spec.wall_thickness;
        lumen_ = std::make_unique<LuminalVolume>(skin_->cage(), lumen);
    }
    if (spec.layers.empty()) return;
    LayeredWallSpec wall;
    wall.layers = spec.layers;
    wall.poisson_ratio = spec.poisson_ratio;
    wall.backing = backing_stiffness;
    std::vector<double> nodule;
    if (spec.nodule) wall.nodule = spec.nodule->shape;
    wall_ = std::make_unique<LayeredWall>(wall);
    if (spec.nodule) {
        constexpr double pi = 3.14159265358979323846;
        for (const Vector3& vertex : skin_->rest().vertices) {
            // The rest pose lies along +x with d1 = +y, d2 = +z.
            double turn = math::atan2(vertex.z(), vertex.y()) - spec.nodule->angle;
            if (turn > pi) turn -= 2 * pi;
            if (turn < -pi) turn += 2 * pi;
            const double around = turn * std::sqrt(vertex.y() * vertex.y() + vertex.z() * vertex.z());
            const double along = vertex.x() - spec.nodule->at * rod_->length();
            nodule.push_back(wall_->nodule_height(std::sqrt(around * around + along * along)));
        }
    }
    patches_->set_wall(wall_.get(), std::move(nodule));
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

std::unique_ptr<Part> build_bowel_part(const Scene& scene, std::uint64_t seed, const PartList& parts) {
    if (!scene.bowel) return nullptr;
    auto bowel = std::make_unique<BowelPart>(scene, bowel_anatomy(scene), wall_of(parts));
    const double puncture = draw_perforation_forces(
        scene, seed)[static_cast<std::size_t>(scene.tissue_index(scene.bowel->tissue))];
    if (puncture > 0) bowel->set_puncture_force(puncture);
    return bowel;
}

}  // namespace fulcrum
