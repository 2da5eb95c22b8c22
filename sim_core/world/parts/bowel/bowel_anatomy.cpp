// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/bowel/bowel_anatomy.h"

#include "sim_core/anatomy/scene_anatomy.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

// Three ties at the cranial end, as an assistant holds it: to either side and in front, and back to the
// promontory.
std::vector<RodTether> cranial_holds(const PresacralSpec& presacral, const SacralCurve& curve,
                                     double length) {
    constexpr double tie = 0.05, taut = 0.96;  // m long; at rest drawn by this share
    const Vector3 front = -curve.posterior(length), cranial = curve.cranial(length), left = Vector3::UnitX();
    std::vector<RodTether> holds;
    for (const Vector3& way : {Vector3(cranial + front + 1.5 * left), Vector3(cranial + front - 1.5 * left),
                               Vector3(cranial - front)}) {
        RodTether hold;
        hold.s = length;
        hold.anchor = curve.centre_line(length) + tie * way.normalized();
        hold.stiffness = presacral.hold_stiffness;
        hold.rest_length = taut * tie;
        hold.damping = 0.02 * presacral.hold_stiffness;
        holds.push_back(hold);
    }
    return holds;
}

}  // namespace

BowelAnatomy bowel_anatomy(const Scene& scene) {
    if (scene.bowel && scene.bowel->layout == BowelLayout::rectum && scene.presacral) {
        const RectumParameters parameters = rectum_parameters(scene);
        BowelShape shape = make_rectum(parameters);
        BowelAnatomy anatomy;
        anatomy.surface = std::move(shape.surface);
        anatomy.length = shape.length;
        anatomy.radius = std::move(shape.radius);
        anatomy.centre_line = std::move(shape.centre_line);
        anatomy.cranial_holds = cranial_holds(*scene.presacral, parameters.curve, shape.length);
        return anatomy;
    }
    if (!scene.bowel || !scene.cavity)
        throw InputError(scene.id, "/bowel", QT_TRANSLATE_NOOP("errors", "needs a cavity to lie in"),
                         QT_TRANSLATE_NOOP("errors", "add a cavity to the scene"));
    BowelShape shape = make_bowel(bowel_parameters(*scene.bowel), pelvis_parameters(*scene.cavity));
    BowelAnatomy anatomy;
    anatomy.surface = std::move(shape.surface);
    anatomy.length = shape.length;
    anatomy.radius = std::move(shape.radius);
    anatomy.centre_line = std::move(shape.centre_line);
    anatomy.root_line = std::move(shape.root_line);
    return anatomy;
}

}  // namespace fulcrum
