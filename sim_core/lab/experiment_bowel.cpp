// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/experiment_bowel.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::lab {

TriangleMesh make_ball(const Vector3& centre, double radius, int bands) {
    constexpr double pi = 3.14159265358979323846;
    TriangleMesh mesh;
    const int around = 2 * bands;
    for (int i = 0; i <= bands; ++i) {
        for (int k = 0; k < around; ++k) {
            const double a = pi * i / bands, b = 2 * pi * k / around;
            mesh.vertices.push_back(
                centre + radius * Vector3(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)));
        }
    }
    for (int i = 0; i < bands; ++i) {
        for (int k = 0; k < around; ++k) {
            const int a = i * around + k, b = i * around + (k + 1) % around;
            mesh.triangles.push_back({a, a + around, b + around});
            mesh.triangles.push_back({a, b + around, b});
        }
    }
    return mesh;
}

TriangleMesh make_bar(const Vector3& from, const Vector3& to, double width) {
    const Vector3 axis = (to - from).normalized();
    const Vector3 side = axis.cross(std::fabs(axis.x()) < 0.9 ? Vector3(Vector3::UnitX())
                                                              : Vector3(Vector3::UnitY()))
                             .normalized(),
                  other = axis.cross(side);
    TriangleMesh mesh;
    for (const Vector3& end : {from, to}) {
        for (const auto& [a, b] : {std::pair<double, double>{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
            mesh.vertices.push_back(end + 0.5 * width * (a * side + b * other));
        }
    }
    for (int k = 0; k < 4; ++k) {
        const int n = (k + 1) % 4;
        mesh.triangles.push_back({k, n, n + 4});
        mesh.triangles.push_back({k, n + 4, k + 4});
    }
    mesh.triangles.insert(mesh.triangles.end(), {{0, 3, 2}, {0, 2, 1}, {4, 5, 6}, {4, 6, 7}});
    return mesh;
}

TriangleMesh make_floor(double half) {
    TriangleMesh mesh;
    mesh.vertices = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

ExperimentBowel::ExperimentBowel(const ExperimentBowelSpec& spec) : spec_(spec) {
    RodSpec rod;
    rod.segments = spec.segments;
    rod.length = spec.length;
    rod.outer_radius = spec.radius;
    rod.inner_radius = 0.8 * spec.radius;
    rod.ends[0] = spec.ends[0];
    rod.ends[1] = spec.ends[1];
    rod_ = std::make_unique<Rod>(rod);
    chain_ = sample_spheres(spec.length, spec.sphere_spacing, [&](double) { return spec.radius; });
    TriangleMesh surface = make_tube(spec.length, spec.sections, spec.around, haustral_radius(spec.radius));
    Cage cage = build_cage(surface, spec.length, chain_);
    skin_ = std::make_unique<BowelSkin>(std::move(surface), std::move(cage));
    if (spec.floor) floor_ = std::make_unique<CavityModel>(make_floor(3), FreeSide::front);
    collision_ =
        std::make_unique<SphereCollision>(floor_.get(), SphereChainShape{chain_.arc_lengths, chain_.radii});
    lists_ = collision_->make_lists();
    contacts_ = collision_->make_contacts();
    centres_.resize(chain_.radii.size());
    state_ = rod_->make_state();
    scratch_ = rod_->make_scratch(1, 4, 1024, 512);
    inputs_.gravity = Vector3(0, 0, -9.81);
    inputs_.ends[0] = state_.ends[0];
    inputs_.ends[1] = state_.ends[1];
}

void ExperimentBowel::find_contacts() {
    for (std::size_t i = 0; i < centres_.size(); ++i)
        centres_[i] = rod_->frame_at(state_, chain_.arc_lengths[i]).frame.position;
    collision_->collide(centres_.data(), lists_, contacts_);
    const std::vector<RodContact> before = inputs_.contacts;
    inputs_.contacts.clear();
    for (int i = 0; i < contacts_.cavity_count; ++i) {
        const CavityContact& found = contacts_.cavity[static_cast<std::size_t>(i)];
        RodContact contact;
        contact.s = chain_.arc_lengths[static_cast<std::size_t>(found.sphere)];
        contact.normal = found.normal;
        contact.point = found.point;
        contact.radius = chain_.radii[static_cast<std::size_t>(found.sphere)];
        contact.friction = 0.4;
        for (const RodContact& old : before) {
            if (old.s == contact.s) contact.lambda = old.lambda;
        }
        inputs_.contacts.push_back(contact);
    }
    inputs_.self_contacts.clear();
    for (int i = 0; i < contacts_.pair_count && i < 512; ++i) {
        const SphereContact& found = contacts_.pairs[static_cast<std::size_t>(i)];
        RodSelfContact contact;
        contact.s = chain_.arc_lengths[static_cast<std::size_t>(found.first)];
        contact.other_s = chain_.arc_lengths[static_cast<std::size_t>(found.second)];
        contact.normal = found.normal;
        contact.distance = chain_.radii[static_cast<std::size_t>(found.first)] +
                           chain_.radii[static_cast<std::size_t>(found.second)];
        inputs_.self_contacts.push_back(contact);
    }
}

RodReport ExperimentBowel::step(double dt) {
    find_contacts();
    return rod_->step(state_, inputs_, dt, scratch_);
}

double ExperimentBowel::self_overlap() {
    find_contacts();
    return contacts_.deepest_pair;
}

double ExperimentBowel::floor_overlap() {
    find_contacts();
    return contacts_.deepest_cavity;
}

std::vector<RingFrame> ExperimentBowel::frames() const {
    std::vector<RingFrame> frames(static_cast<std::size_t>(skin_->rings()));
    ring_frames(
        skin_->cage(),
        [&](double s) {
            const RodMotion motion = rod_->frame_at(state_, s);
            return RingFrame{motion.frame.position, motion.frame.rotation};
        },
        frames.data());
    return frames;
}

ExperimentMesh ExperimentBowel::surface() const {
    ExperimentMesh shown;
    shown.name = "bowel";
    shown.mesh.triangles = skin_->rest().triangles;
    shown.mesh.vertices.resize(static_cast<std::size_t>(skin_->vertices()));
    skin_all(*skin_, frames().data(), shown.mesh.vertices.data());
    shown.colour = {0.72F, 0.30F, 0.26F};
    return shown;
}

ExperimentMesh ExperimentBowel::cage() const {
    ExperimentMesh shown;
    shown.name = "cage";
    shown.mesh.vertices = cage_vertices(skin_->cage(), frames().data());
    shown.mesh.triangles = cage_triangles(skin_->rings());
    shown.wireframe = true;
    shown.colour = {0.05F, 0.20F, 0.55F};
    return shown;
}

std::vector<ExperimentMesh> ExperimentBowel::spheres() const {
    std::vector<ExperimentMesh> shown;
    for (std::size_t i = 0; i < chain_.radii.size(); ++i) {
        ExperimentMesh ball;
        ball.name = "sphere";
        ball.mesh = make_ball(rod_->frame_at(state_, chain_.arc_lengths[i]).frame.position, chain_.radii[i]);
        ball.colour = {0.20F, 0.45F, 0.65F};
        shown.push_back(ball);
    }
    return shown;
}

}  // namespace fulcrum::lab
