// SPDX-License-Identifier: Apache-2.0
// The bowel as the scene describes it: rod, skin, wall, tethers, and room for what a step needs.
#include "sim_core/world/parts/bowel/bowel_part.h"

#include <algorithm>
#include <cmath>

#include "sim_core/numerics/functions.h"
#include "sim_core/scene/perforation.h"

namespace fulcrum {
namespace {

constexpr double pattern_time = 0.05;        // s, dents and grasp corrections settle in this time
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

std::unique_ptr<Part> build_bowel_part(const Scene& scene, std::uint64_t seed, const PartList& parts) {
    if (!scene.bowel) return nullptr;
    auto bowel = std::make_unique<BowelPart>(scene, bowel_anatomy(scene), wall_of(parts));
    const double puncture = draw_perforation_forces(
        scene, seed)[static_cast<std::size_t>(scene.tissue_index(scene.bowel->tissue))];
    if (puncture > 0) bowel->set_puncture_force(puncture);
    return bowel;
}

}  // namespace fulcrum
