// SPDX-License-Identifier: Apache-2.0
// Boxes with points, segments, triangles and boxes: compared with FCL on generated cases, and with dense
// sampling.
#include "sim_core/geometry/oriented_box.h"

#include <fcl/fcl.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

Vector3 random_point(Random& random, double size) {
    return Vector3(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
}

OrientedBox random_box(Random& random) {
    OrientedBox box;
    box.centre = random_point(random, 0.006);
    const Vector3 axis = random_point(random, 1.0).normalized();
    box.axes = Eigen::AngleAxisd(random.uniform(0, 3.0), axis).toRotationMatrix();
    box.half =
        Vector3(random.uniform(0.001, 0.012), random.uniform(0.001, 0.006), random.uniform(0.001, 0.006));
    return box;
}

fcl::Transform3<double> pose(const OrientedBox& box) {
    fcl::Transform3<double> result = fcl::Transform3<double>::Identity();
    result.linear() = box.axes;
    result.translation() = box.centre;
    return result;
}

struct FclAnswer {
    bool meet = false;
    double distance = 0;
};

template <class Shape>
FclAnswer ask_fcl(const OrientedBox& box, const std::shared_ptr<Shape>& shape,
                  const fcl::Transform3<double>& at) {
    const fcl::CollisionObject<double> first(std::make_shared<fcl::Box<double>>(2 * box.half), pose(box));
    const fcl::CollisionObject<double> second(shape, at);
    fcl::CollisionRequest<double> collide;
    fcl::CollisionResult<double> collided;
    fcl::collide(&first, &second, collide, collided);
    FclAnswer answer;
    answer.meet = collided.isCollision();
    fcl::DistanceRequest<double> request;
    request.gjk_solver_type = fcl::GST_INDEP;
    request.distance_tolerance = 1e-9;
    fcl::DistanceResult<double> result;
    if (!answer.meet) answer.distance = fcl::distance(&first, &second, request, result);
    return answer;
}

void expect_sound(const Separation& found) {
    EXPECT_NEAR(found.normal.norm(), 1.0, 1e-9);
    EXPECT_TRUE(found.distance == 0 || found.overlap == 0);
    EXPECT_GE(found.distance, 0);
    EXPECT_GE(found.overlap, 0);
    if (found.distance > 0) {
        EXPECT_NEAR((found.on_other - found.on_box).norm(), found.distance, 1e-12);
    }
}

TEST(OrientedBox, AgreesWithFclOnSpheres) {
    Random random(1);
    int met = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const OrientedBox box = random_box(random);
        const Vector3 centre = random_point(random, 0.02);
        const double radius = random.uniform(0.001, 0.016);
        const Separation found = separate_point(box, centre);
        expect_sound(found);
        fcl::Transform3<double> at = fcl::Transform3<double>::Identity();
        at.translation() = centre;
        const FclAnswer answer = ask_fcl(box, std::make_shared<fcl::Sphere<double>>(radius), at);
        if (std::abs(found.distance - radius) < 1e-7) continue;
        EXPECT_EQ(found.distance < radius, answer.meet) << trial;
        met += answer.meet ? 1 : 0;
        if (!answer.meet) {
            EXPECT_NEAR(found.distance - radius, answer.distance, 1e-6) << trial;
        }
    }
    EXPECT_GT(met, 100);
}

TEST(OrientedBox, AgreesWithFclOnTriangles) {
    Random random(2);
    int met = 0, apart = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const OrientedBox box = random_box(random);
        const Vector3 near = random_point(random, 0.012);
        const double size = trial % 5 == 0 ? 0.05 : 0.004;  // some are pierced in their middle
        const Vector3 a = near + random_point(random, size), b = near + random_point(random, size),
                      c = near + random_point(random, size);
        const Separation found = separate_triangle(box, a, b, c);
        expect_sound(found);
        const auto triangle = std::make_shared<fcl::TriangleP<double>>(a, b, c);
        const fcl::CollisionObject<double> first(std::make_shared<fcl::Box<double>>(2 * box.half), pose(box));
        // FCL's own exact pair: a mesh of one triangle.
        const auto mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSS<double>>>();
        mesh->beginModel();
        mesh->addTriangle(a, b, c);
        mesh->endModel();
        const fcl::CollisionObject<double> second(mesh);
        fcl::CollisionRequest<double> request;
        fcl::CollisionResult<double> result;
        fcl::collide(&second, &first, request, result);
        if (found.distance < 1e-7 && found.overlap < 1e-7) continue;  // they only just touch
        EXPECT_EQ(found.distance == 0, result.isCollision()) << trial;
        (result.isCollision() ? met : apart) += 1;
        // The distance against dense sampling of the triangle, which is never nearer.
        double sampled = 1e9;
        for (int i = 0; i <= 40; ++i) {
            for (int j = 0; j + i <= 40; ++j) {
                const Vector3 point = a + (b - a) * i / 40.0 + (c - a) * j / 40.0;
                sampled = std::min(sampled, separate_point(box, point).distance);
            }
        }
        EXPECT_LE(found.distance, sampled + 1e-15) << trial;
        EXPECT_GE(found.distance, sampled - 2 * size / 20) << trial;
        if (found.distance > 0) {
            // Each of the two points is the other's nearest.
            EXPECT_NEAR(separate_point(box, found.on_other).distance, found.distance, 1e-12);
            EXPECT_NEAR((closest_point_on_triangle(found.on_box, a, b, c).position - found.on_box).norm(),
                        found.distance, 1e-12);
        }
    }
    EXPECT_GT(met, 50);
    EXPECT_GT(apart, 50);
}

TEST(OrientedBox, AgreesWithFclOnCapsulesAndBoxes) {
    Random random(3);
    int met = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const OrientedBox box = random_box(random), other = random_box(random);
        Separation boxes;
        const bool overlap = boxes_overlap(box, other, boxes);
        const FclAnswer answer =
            ask_fcl(box, std::make_shared<fcl::Box<double>>(2 * other.half), pose(other));
        if (overlap) {
            expect_sound(boxes);
            EXPECT_GE(boxes.overlap, 0) << trial;
        }
        if (overlap ? boxes.overlap > 1e-7 : answer.meet || answer.distance > 1e-7) {
            EXPECT_EQ(overlap, answer.meet) << trial;
            met += answer.meet ? 1 : 0;
        }
        if (boxes.overlap > 0) {
            // Moved apart by the overlap they no longer touch.
            OrientedBox moved = other;
            moved.centre += (boxes.overlap + 1e-9) * boxes.normal;
            Separation none;
            EXPECT_FALSE(boxes_overlap(box, moved, none)) << trial;
        }
        const Vector3 p = random_point(random, 0.03), q = p + random_point(random, 0.03);
        const Separation segment = separate_segment(box, p, q);
        expect_sound(segment);
        double sampled = 1e9;
        for (int i = 0; i <= 2000; ++i)
            sampled = std::min(sampled, separate_point(box, p + (q - p) * i / 2000.0).distance);
        EXPECT_LE(segment.distance, sampled + 1e-15);
        EXPECT_GE(segment.distance, sampled - (q - p).norm() / 2000);
    }
    EXPECT_GT(met, 50);
}

TEST(OrientedBox, HandlesFlatAndEmptyShapes) {
    OrientedBox plate;
    plate.half = Vector3(0.01, 0.01, 0.0);
    EXPECT_NEAR(separate_point(plate, Vector3(0.0, 0.0, 0.003)).distance, 0.003, 1e-15);
    EXPECT_NEAR(separate_segment(plate, Vector3(0.02, 0, 0), Vector3(0.02, 0, 0)).distance, 0.01, 1e-15);
    const Vector3 at(0.0, 0.03, 0.0);
    EXPECT_NEAR(separate_triangle(plate, at, at, at).distance, 0.02, 1e-15);
    EXPECT_EQ(separate_triangle(plate, Vector3(-1, 0, 0), Vector3(1, 0, 0), Vector3(0, 1e-9, 0)).distance, 0);
    Separation same;
    EXPECT_TRUE(boxes_overlap(plate, plate, same));
    EXPECT_EQ(same.distance, 0);
    EXPECT_TRUE(same.normal.allFinite());
}

}  // namespace
}  // namespace fulcrum
