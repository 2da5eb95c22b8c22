// SPDX-License-Identifier: Apache-2.0
#include "assessment/operators/operator.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "assessment/operators/behaviour.h"
#include "assessment/operators/camera_hand.h"
#include "assessment/operators/scope_limb.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr std::uint64_t attempt_stream = 0x61747470;
constexpr std::uint64_t lens_stream = 0x6c656e73;
constexpr double decision_period = 0.01;  // s

/// The one site that all goals of a task are at. Throws InputError where there are several.
GoalSite site_of(const TaskDefinition& task) {
    const GoalSite site = task.goals.empty() ? GoalSite::targets : type_of(task.goals.front().kind).site;
    for (const Goal& goal : task.goals)
        if (type_of(goal.kind).site != site)
            throw InputError(
                QT_TRANSLATE_NOOP("errors", "operator"), task.id,
                QT_TRANSLATE_NOOP(
                    "errors", "an operator does not perform goals of different parts of a scene in one task"),
                QT_TRANSLATE_NOOP("errors", "choose a task whose goals are all of one site"));
    return site;
}

std::unique_ptr<Behaviour> make_behaviour(const TaskDefinition& task, const Scene& scene, const Skill& skill,
                                          std::uint64_t attempt) {
    switch (site_of(task)) {
        case GoalSite::targets:
            return make_targeting(task, scene, skill);
        case GoalSite::bowel:
            return make_bowel_handling(task, scene, skill);
        case GoalSite::sheet:
            return make_sheet_division(task, scene, skill, attempt);
        case GoalSite::bands:
            return make_band_handling(task, scene, skill);
        case GoalSite::objects:
            return make_object_handling(task, scene, skill);
        case GoalSite::camera_targets:
            return make_scope_handling(task, scene, skill);
    }
    throw std::logic_error("a site without a behaviour");
}

class SyntheticOperator : public ObservingRig {
  public:
    SyntheticOperator(const Skill& skill, const TaskDefinition& task, const Scene& scene,
                      std::uint64_t attempt)
        : eyes_(scene, skill.reaction_s + 0.05),
          delay_(static_cast<std::uint32_t>(std::lround(skill.reaction_s * scene.tick_rate))),
          ticks_per_decision_(
              static_cast<std::uint32_t>(std::max(1L, std::lround(decision_period * scene.tick_rate)))),
          camera_(skill, scene) {
        for (const InstrumentSpec& spec : scene.instruments) {
            const auto hand = static_cast<std::size_t>(spec.hand);
            limbs_[hand].emplace(skill, spec, scene.tick_period(), Random(attempt, attempt_stream + hand));
            body_.limb[hand] = &*limbs_[hand];
        }
        if (scene.camera && scene.instruments.empty()) {
            scope_.emplace(skill, *scene.camera, scene.tick_period(), Random(attempt, lens_stream));
            body_.scope = &*scope_;
        }
        body_.eyes = &eyes_;
        body_.view = camera_.view();
        behaviour_ = make_behaviour(task, scene, skill, attempt);
    }

    void observe(const WorldSnapshot& world, const TaskDisplay& display) noexcept override {
        eyes_.push(now_, world, display);
    }

    void read(std::uint32_t tick, RigSample& sample) override {
        now_ = tick;
        if (!eyes_.empty() && tick % ticks_per_decision_ == 0) {
            body_.view = camera_.view();
            behaviour_->decide(eyes_.seen(tick, delay_), body_);
            if (!body_.gaze.isZero()) camera_.look_at(body_.gaze);
        }
        for (std::size_t hand = 0; hand < hand_count; ++hand) {
            if (!limbs_[hand]) continue;
            limbs_[hand]->tick();
            sample.hand[hand] = limbs_[hand]->sample();
        }
        sample.camera = scope_ ? scope_->tick() : camera_.tick();
    }

    // A position-driven arm: it feels through what it sees of the force (TaskDisplay::force), so that the
    // delay is one.
    void write_force(Hand /*hand*/, const Vector3& /*force*/) override {}
    bool has_force(Hand hand) const override { return limbs_[static_cast<std::size_t>(hand)].has_value(); }
    double damping(Hand /*hand*/) const override { return -1; }

  private:
    DelayLine eyes_;
    std::uint32_t delay_, ticks_per_decision_, now_ = 0;
    std::array<std::optional<Limb>, hand_count> limbs_;
    CameraHand camera_;
    std::optional<ScopeLimb> scope_;
    Body body_;
    std::unique_ptr<Behaviour> behaviour_;
};

}  // namespace

OperatorLevel operator_level(const std::string& name) {
    const auto* row = find_row(operator_levels, name);
    if (row == nullptr)
        throw InputError(QT_TRANSLATE_NOOP("errors", "operator"), name,
                         QT_TRANSLATE_NOOP("errors", "no operator of this name"),
                         {QT_TRANSLATE_NOOP("errors", "give one of: %1"), names_of(operator_levels)});
    return row->kind;
}

std::unique_ptr<ObservingRig> make_operator(OperatorLevel level, const TaskDefinition& task,
                                            const Scene& scene, std::uint64_t individual,
                                            std::uint64_t attempt) {
    Skill skill;
    draw_individual(level, individual, skill);
    draw_form(level, attempt, skill);
    return make_operator(skill, task, scene, attempt);
}

std::unique_ptr<ObservingRig> make_operator(const Skill& skill, const TaskDefinition& task,
                                            const Scene& scene, std::uint64_t attempt) {
    const GoalSite site = site_of(task);
    if (site == GoalSite::sheet) {
        int grasper = 0, blade = 0;
        for (const InstrumentSpec& spec : scene.instruments) {
            grasper += type_of(spec.kind).grasps ? 1 : 0;
            blade += spec.cuts() ? 1 : 0;
        }
        if (grasper != 1 || blade != 1) {
            throw InputError(
                QT_TRANSLATE_NOOP("errors", "operator"), task.id,
                QT_TRANSLATE_NOOP("errors", "a sheet is divided with a grasper and a blade"),
                QT_TRANSLATE_NOOP("errors", "give one hand a grasper and the other scissors or a hook"));
        }
    }
    if (site == GoalSite::camera_targets && !scene.instruments.empty())
        throw InputError(
            QT_TRANSLATE_NOOP("errors", "operator"), task.id,
            QT_TRANSLATE_NOOP("errors", "an operator does not hold the scope and instruments at once"),
            QT_TRANSLATE_NOOP("errors", "choose a task without instruments"));
    for (const Hand hand : {Hand::left, Hand::right}) {
        if ((site == GoalSite::bowel || site == GoalSite::bands || site == GoalSite::objects) &&
            scene.instrument(hand) == nullptr) {
            throw InputError(
                QT_TRANSLATE_NOOP("errors", "operator"), task.id,
                {QT_TRANSLATE_NOOP("errors", "the scene gives the %1 hand no instrument"), hand_name(hand)},
                QT_TRANSLATE_NOOP("errors", "add a grasper to the scene"));
        }
    }
    return std::make_unique<SyntheticOperator>(site == GoalSite::objects ? with_objects(skill) : skill, task,
                                               scene, attempt);
}

std::unique_ptr<ObservingRig> make_operator(OperatorLevel level, const TaskDefinition& task,
                                            const Scene& scene, std::uint64_t seed) {
    return make_operator(level, task, scene, seed, seed);
}

}  // namespace fulcrum
