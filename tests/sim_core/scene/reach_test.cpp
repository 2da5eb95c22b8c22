// SPDX-License-Identifier: Apache-2.0
// Ergonomics of the scenes: the objects of a task can be reached through the trocars and seen by the scope.
#include <gtest/gtest.h>

#include "sim_core/anatomy/scene_anatomy.h"
#include "sim_core/instrument/instrument.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/scene/scene.h"
#include "sim_core/world/parts/bowel/bowel_anatomy.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

Scene scene_of(const std::string& name) {
    return load_scene(test::source_path("assets/scenes/" + name));
}

// Reachable: the tip gets there with at least 4 cm of shaft inside and room for a hand outside, the shaft
// within 65 degrees of its nominal direction; and the kinematics agree with their inverse.
void expect_reachable(const InstrumentSpec& spec, const Vector3& target) {
    const InstrumentModel model = make_instrument(spec, 1e-3);
    const Vector3 shaft = target - model.trocar.position;
    EXPECT_GT(shaft.norm(), 0.04) << target.transpose();
    EXPECT_LT(shaft.norm(), spec.trocar.shaft_length - 0.05) << target.transpose();
    const double angle = math::acos(shaft.normalized().dot(spec.trocar.direction));
    EXPECT_LT(angle, 65 * degree) << hand_name(spec.hand) << " to " << target.transpose();
    DeviceReading reading;
    reading.handle = handle_for_tip(model.trocar, target);
    EXPECT_LT((tool_pose(model, quantise(reading, DeviceSample{})).tip - target).norm(), 1e-6);
}

CameraPose camera_of(const Scene& scene) {
    const ScopeModel scope = make_scope(*scene.camera);
    DeviceReading reading;
    reading.handle = handle_for_tip(
        scope.trocar, scope.trocar.position + scene.camera->start_insertion * scope.trocar.rotation.col(2));
    return scope_pose(scope, quantise(reading, DeviceSample{}));
}

TEST(Reach, EveryTargetCornerIsReachedByBothHandsAndVisible) {
    const Scene scene = scene_of("a2_targets.json");
    const CameraPose camera = camera_of(scene);
    for (int corner = 0; corner < 8; ++corner) {
        Vector3 place = scene.targets->centre;
        for (int i = 0; i < 3; ++i)
            place[i] += ((corner >> i & 1) != 0 ? 1 : -1) * scene.targets->half_extent[i];
        EXPECT_TRUE(in_view(camera, place)) << place.transpose();
        for (const InstrumentSpec& spec : scene.instruments) expect_reachable(spec, place);
    }
}

TEST(Reach, BowelSegmentOfTheTaskIsReachedByBothHandsAndVisible) {
    const Scene scene = scene_of("b1_bowel.json");
    const CameraPose camera = camera_of(scene);
    const BowelAnatomy anatomy = bowel_anatomy(scene);
    const std::size_t points = anatomy.centre_line.size();
    int asked = 0, seen = 0;
    for (std::size_t i = 0; i < points; ++i) {
        const double s = anatomy.length * static_cast<double>(i) / static_cast<double>(points - 1);
        if (s < 0.13 || s > 0.74) continue;  // B1 runs from 0.13 m to 0.73 m
        ++asked;
        seen += in_view(camera, anatomy.centre_line[i]) ? 1 : 0;
        const double away =
            math::acos((anatomy.centre_line[i] - camera.position).normalized().dot(view_direction(camera)));
        EXPECT_LT(away, 0.5 * scene.camera->field_of_view + 15 * degree)
            << "a small turn of the scope shows the rest";
        for (const InstrumentSpec& spec : scene.instruments) expect_reachable(spec, anatomy.centre_line[i]);
    }
    ASSERT_GT(asked, 50);
    EXPECT_GT(seen, 0.8 * asked) << "the scope shows most of the stretch where it starts";
}

TEST(Reach, HandsEnterFromTheirOwnSideOfTheImage) {
    for (const char* name : {"a2_targets.json", "b1_bowel.json"}) {
        const Scene scene = scene_of(name);
        const CameraPose camera = camera_of(scene);
        const Vector3 right_of_image = camera.orientation * Vector3::UnitX();
        const Vector3 middle = camera.position;
        EXPECT_GT((scene.instrument(Hand::right)->trocar.position - middle).dot(right_of_image), 0.05)
            << name;
        EXPECT_LT((scene.instrument(Hand::left)->trocar.position - middle).dot(right_of_image), -0.05)
            << name;
    }
}

}  // namespace
}  // namespace fulcrum
