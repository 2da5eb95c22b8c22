// SPDX-License-Identifier: Apache-2.0
// Mean value coordinates: partition of unity, linear reproduction, difficult positions (docs/THEORY.md,
// section 1.4).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "sim_core/bowel/mean_value.h"
#include "sim_core/numerics/random.h"

namespace fulcrum {
namespace {

struct Solid {
    std::vector<Vector3> vertices;
    std::vector<Triangle> triangles;
};

Solid cube() {
    Solid solid;
    for (int i = 0; i < 8; ++i) solid.vertices.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
    solid.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                       {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return solid;
}

// A dented star: not convex, so that the planes of some triangles pass through its inside.
Solid star() {
    Solid solid;
    const double inner = 0.35;
    solid.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    const Triangle faces[8] = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                               {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    for (const auto& face : faces) {
        Vector3 centre = Vector3::Zero();
        for (const auto v : face) centre += solid.vertices[static_cast<std::size_t>(v)];
        const auto middle = static_cast<std::int32_t>(solid.vertices.size());
        solid.vertices.push_back(inner * centre);
        for (std::size_t e = 0; e < 3; ++e) solid.triangles.push_back({face[e], face[(e + 1) % 3], middle});
    }
    return solid;
}

struct Errors {
    double unity, linear;
};

Errors errors_at(const Solid& solid, const Vector3& point) {
    std::vector<double> weights(solid.vertices.size());
    MeanValueScratch scratch;
    mean_value_weights(solid.vertices, CageTopology(solid.triangles), point, scratch, weights.data());
    double sum = 0.0;
    Vector3 position = Vector3::Zero();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        sum += weights[i];
        position += weights[i] * solid.vertices[i];
    }
    return {std::abs(sum - 1.0), (position - point).norm()};
}

Vector3 deform(const Solid& solid, const Vector3& point) {
    std::vector<double> weights(solid.vertices.size());
    MeanValueScratch scratch;
    mean_value_weights(solid.vertices, CageTopology(solid.triangles), point, scratch, weights.data());
    Vector3 position = Vector3::Zero();
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const Vector3& v = solid.vertices[i];
        position += weights[i] *
                    Vector3(v.x() + 0.5 * v.y() * v.y(), v.y() - 0.3 * v.x() * v.z(), v.z() + v.x() * v.x());
    }
    return position;
}

TEST(MeanValue, ReproducesLinearFunctionsInside) {
    Random random(7);
    for (const Solid& solid : {cube(), star()}) {
        for (int i = 0; i < 2000; ++i) {
            const Vector3 point = 0.2 * Vector3(random.uniform(), random.uniform(), random.uniform()) +
                                  Vector3(0.05, 0.05, 0.05);
            const Errors errors = errors_at(solid, point);
            ASSERT_LE(errors.unity, 1e-12);
            ASSERT_LE(errors.linear, 1e-12);
        }
    }
}

// On, and at every small distance from, the planes, faces, edges and vertices of the cage.
TEST(MeanValue, IsRobustOnAndNearTheCage) {
    double worst_unity = 0.0, worst_linear = 0.0;
    const auto check = [&](const Solid& solid, const Vector3& point) {
        const Errors errors = errors_at(solid, point);
        worst_unity = std::max(worst_unity, errors.unity);
        worst_linear = std::max(worst_linear, errors.linear);
    };
    for (const Solid& solid : {cube(), star()}) {
        Vector3 centre = Vector3::Zero();
        for (const auto& v : solid.vertices) centre += v / static_cast<double>(solid.vertices.size());
        for (const auto& triangle : solid.triangles) {
            const Vector3 &a = solid.vertices[static_cast<std::size_t>(triangle[0])],
                          &b = solid.vertices[static_cast<std::size_t>(triangle[1])],
                          &c = solid.vertices[static_cast<std::size_t>(triangle[2])];
            const Vector3 targets[] = {a,
                                       0.5 * (a + b),
                                       0.3 * a + 0.7 * c,
                                       (a + b + c) / 3.0,
                                       0.6 * a + 0.1 * b + 0.3 * c,
                                       0.5 * a + 0.5 * b + 1e-9 * (c - a)};
            for (const auto& target : targets) {
                check(solid, target);
                for (double distance = 1e-16; distance < 0.2; distance *= 4.0) {
                    check(solid, target + distance * (centre - target).normalized());
                }
            }
        }
        // The star's symmetry planes hold edges of many triangles, seen from outside of them.
        for (double height = 1e-17; height < 0.1; height *= 4.0) {
            check(solid, Vector3(0.2, 0.1, height));
            check(solid, Vector3(0.1, 0.1 + height, 0.1));
            check(solid, centre + height * Vector3(0.3, -0.5, 0.7));
        }
    }
    std::printf("partition of unity %.3g, linear reproduction %.3g\n", worst_unity, worst_linear);
    EXPECT_LE(worst_unity, 1e-12);
    EXPECT_LE(worst_linear, 1e-12);
}

TEST(MeanValue, IsContinuousThroughThePlanesOfItsTriangles) {
    const Solid solid = star();
    double worst = 0.0;
    for (double x = -0.2; x < 0.2; x += 0.031) {
        for (double height = 1e-14; height < 1e-4; height *= 3.0) {
            const Vector3 on_plane = deform(solid, Vector3(x, 0.11, 0.0));
            const Vector3 beside = deform(solid, Vector3(x, 0.11, height));
            worst = std::max(worst, (beside - on_plane).norm() - 10.0 * height);
        }
    }
    EXPECT_LE(worst, 1e-8);
}

TEST(MeanValue, IsSmoothOnTheSurfaceSide) {
    const Solid solid = cube();
    const Vector3 face(0.3, 0.4, 0.0);
    for (double height = 1e-3; height > 1e-15; height *= 0.1) {
        const double away = (deform(solid, face + Vector3(0, 0, height)) - deform(solid, face)).norm();
        EXPECT_LE(away, 20.0 * height + 1e-12) << height;
    }
}

TEST(MeanValue, IsTheKroneckerDeltaAtVertices) {
    const Solid solid = star();
    MeanValueScratch scratch;
    std::vector<double> weights(solid.vertices.size());
    for (std::size_t v = 0; v < solid.vertices.size(); ++v) {
        mean_value_weights(solid.vertices, CageTopology(solid.triangles), solid.vertices[v], scratch,
                           weights.data());
        for (std::size_t i = 0; i < weights.size(); ++i) EXPECT_EQ(weights[i], i == v ? 1.0 : 0.0);
    }
}

// Closed form: at the centre of a regular octahedron all weights are equal; along an axis they follow the
// definition by quadrature over the sphere (w_i = integral of phi_i / distance), evaluated here
// independently.
TEST(MeanValue, AgreesWithQuadratureOfItsDefinition) {
    Solid solid;
    solid.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    solid.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                       {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
    const Vector3 point(0.1, 0.2, 0.15);
    std::vector<double> expected(6, 0.0), weights(6);
    std::vector<Matrix3> inverses;
    for (const auto& triangle : solid.triangles) {
        Matrix3 corners;
        for (int k = 0; k < 3; ++k) {
            corners.col(k) =
                solid.vertices[static_cast<std::size_t>(triangle[static_cast<std::size_t>(k)])] - point;
        }
        inverses.push_back(corners.inverse());
    }
    const int bands = 500;
    for (int i = 0; i < bands; ++i) {
        const double z = -1.0 + 2.0 * (i + 0.5) / bands, ring = std::sqrt(1.0 - z * z);
        for (int j = 0; j < 2 * bands; ++j) {
            const double angle = 3.14159265358979323846 * (j + 0.5) / bands;
            const Vector3 ray(ring * std::cos(angle), ring * std::sin(angle), z);
            for (std::size_t t = 0; t < inverses.size(); ++t) {
                // ray = sum of part_k corner_k: the hit's barycentric coordinates over its distance.
                const Vector3 part = inverses[t] * ray;
                if (part.minCoeff() < 0.0) continue;
                for (std::size_t k = 0; k < 3; ++k) {
                    expected[static_cast<std::size_t>(solid.triangles[t][k])] += part[static_cast<int>(k)];
                }
                break;
            }
        }
    }
    double sum = 0.0;
    for (const double w : expected) sum += w;
    MeanValueScratch scratch;
    mean_value_weights(solid.vertices, CageTopology(solid.triangles), point, scratch, weights.data());
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(weights[i], expected[i] / sum, 1e-5) << i;
}

}  // namespace
}  // namespace fulcrum
