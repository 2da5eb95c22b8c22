// SPDX-License-Identifier: Apache-2.0
// Instruments as solids: capsule and boxes against spheres and against each other, by FCL.
#include "sim_core/instrument/tool_shapes.h"

#include <fcl/fcl.h>
#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

struct Tool {
    InstrumentModel model;
    ToolKinematics kinematics;
    ToolShape shape() const { return tool_shape(model, kinematics); }
};

Tool tool(const Vector3& trocar, const Vector3& tip, double roll, double jaw) {
    InstrumentSpec spec;
    spec.trocar.position = trocar;
    spec.trocar.direction = (tip - trocar).normalized();
    spec.trocar.up = Vector3(0, 1, 0.1);
    Tool made;
    made.model = make_instrument(spec, 1e-3);
    DeviceReading reading;
    reading.handle = handle_for_tip(made.model.trocar, tip);
    reading.roll = roll;
    reading.jaw = jaw;
    made.kinematics = tool_pose(made.model, quantise(reading, DeviceSample{}));
    return made;
}

using FclObject = fcl::CollisionObject<double>;

std::vector<FclObject> solids(const ToolShape& shape) {
    std::vector<FclObject> made;
    const Vector3 along = shape.tip - shape.trocar;
    fcl::Transform3<double> pose = fcl::Transform3<double>::Identity();
    pose.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3::UnitZ(), along).toRotationMatrix();
    pose.translation() = shape.trocar + 0.5 * along;
    made.emplace_back(std::make_shared<fcl::Capsule<double>>(shape.radius, along.norm()), pose);
    for (int k = 0; k < shape.jaws; ++k) {
        pose.linear() = shape.jaw[k].axes;
        pose.translation() = shape.jaw[k].centre;
        made.emplace_back(std::make_shared<fcl::Box<double>>(2 * shape.jaw[k].half), pose);
    }
    return made;
}

bool meet(const std::vector<FclObject>& first, const std::vector<FclObject>& second) {
    for (const FclObject& a : first) {
        for (const FclObject& b : second) {
            fcl::CollisionRequest<double> request;
            fcl::CollisionResult<double> result;
            request.gjk_solver_type = fcl::GST_INDEP;
            fcl::collide(&a, &b, request, result);
            if (result.isCollision()) return true;
        }
    }
    return false;
}

Vector3 random_tip(Random& random) {
    return Vector3(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02));
}

TEST(ToolShapes, ClosedJawsAreTheTipBoxAndOpenOnesSpread) {
    const ToolShape closed = tool(Vector3(0, 0, 0.2), Vector3(0, 0, 0), 0.0, 0.0).shape();
    ASSERT_EQ(closed.jaws, 2);
    for (const OrientedBox& jaw : closed.jaw) EXPECT_NEAR((jaw.centre - closed.tip).norm(), 0.010, 4e-4);
    EXPECT_NEAR((closed.jaw[0].centre - closed.jaw[1].centre).norm(), 0.0025, 1e-6);
    const ToolShape open = tool(Vector3(0, 0, 0.2), Vector3(0, 0, 0), 0.0, 1.0).shape();
    EXPECT_GT((open.jaw[0].centre - open.jaw[1].centre).norm(), 0.009);
}

TEST(ToolShapes, AgreeWithFcl) {
    Random random(4);
    int met = 0, by_jaw = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const ToolShape left =
            tool(Vector3(-0.1, 0.02, 0.15), random_tip(random), random.uniform(-2, 2), random.uniform(0, 1))
                .shape();
        const ToolShape right =
            tool(Vector3(0.1, -0.02, 0.15), random_tip(random), random.uniform(-2, 2), random.uniform(0, 1))
                .shape();
        const SolidContact contact = collide_shapes(left, right), mirrored = collide_shapes(right, left);
        EXPECT_NEAR(contact.depth, mirrored.depth, 1e-12) << trial;
        EXPECT_NEAR(contact.normal.norm(), 1.0, 1e-12);
        if (std::abs(contact.depth) < 1e-6) continue;
        EXPECT_EQ(contact.depth > 0, meet(solids(left), solids(right))) << trial << " " << contact.depth;
        met += contact.depth > 0 ? 1 : 0;
        by_jaw += contact.depth > 0 && contact.by_jaw ? 1 : 0;
    }
    EXPECT_GT(met, 40);
    EXPECT_GT(by_jaw, 20);
}

TEST(ToolShapes, AgreeWithFclOnSpheresAndTriangles) {
    Random random(5);
    int met = 0, cut = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const ToolShape shape =
            tool(Vector3(0, 0.02, 0.15), random_tip(random), random.uniform(-2, 2), random.uniform(0, 1))
                .shape();
        const Vector3 centre = shape.tip + random_tip(random);
        const double radius = random.uniform(0.002, 0.016);
        const SolidContact sphere = collide_sphere(shape, centre, radius);
        fcl::Transform3<double> pose = fcl::Transform3<double>::Identity();
        pose.translation() = centre;
        const std::vector<FclObject> ball{FclObject(std::make_shared<fcl::Sphere<double>>(radius), pose)};
        if (std::abs(sphere.depth) > 1e-6) {
            EXPECT_EQ(sphere.depth > 0, meet(solids(shape), ball)) << trial;
            met += sphere.depth > 0 ? 1 : 0;
        }
        const Vector3 a = centre, b = centre + 0.3 * random_tip(random),
                      c = centre + 0.3 * random_tip(random);
        const auto mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSS<double>>>();
        mesh->beginModel();
        mesh->addTriangle(a, b, c);
        mesh->endModel();
        std::vector<FclObject> jaws = solids(shape);
        jaws.erase(jaws.begin());
        const SolidContact triangle = collide_triangle(shape, a, b, c);
        if (std::abs(triangle.depth) > 1e-6) {
            EXPECT_EQ(triangle.depth > 0, meet({FclObject(mesh)}, jaws)) << trial;
            cut += triangle.depth > 0 ? 1 : 0;
        }
    }
    EXPECT_GT(met, 40);
    EXPECT_GT(cut, 10);
}

}  // namespace
}  // namespace fulcrum
