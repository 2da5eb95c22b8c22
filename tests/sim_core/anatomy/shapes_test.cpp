// SPDX-License-Identifier: Apache-2.0
// Generated shapes: valid meshes, plausible positions, reproducible bytes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/bowel/cage.h"
#include "sim_core/collision/cavity.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

void expect_sound(const TriangleMesh& mesh) {
    const MeshReport report = check_mesh(mesh);
    EXPECT_TRUE(report.watertight()) << report.complaint();
    EXPECT_TRUE(report.no_stray_vertex);
    EXPECT_EQ(report.components, 1);
    EXPECT_EQ(report.euler_characteristic, 2);
    EXPECT_GT(report.volume, 0.0);
    ASSERT_EQ(mesh.texture_coordinates.size(), mesh.vertices.size());
    for (const auto& uv : mesh.texture_coordinates) EXPECT_TRUE(uv.allFinite());
}

struct Case {
    double width, depth, abdomen, length, radius;
    std::uint64_t seed;
};

class Anatomy : public testing::TestWithParam<Case> {
  protected:
    PelvisParameters pelvis() const {
        PelvisParameters p;
        p.width = GetParam().width;
        p.depth = GetParam().depth;
        p.abdomen_width = GetParam().abdomen;
        p.seed = GetParam().seed;
        return p;
    }
    BowelParameters bowel() const {
        BowelParameters p;
        p.length = GetParam().length;
        p.radius = GetParam().radius;
        p.seed = GetParam().seed;
        return p;
    }
};

TEST_P(Anatomy, CavityIsWatertightAndHasTheRequestedWidth) {
    const CavityShape cavity = make_cavity(pelvis());
    expect_sound(cavity.mesh);
    EXPECT_NEAR(static_cast<double>(cavity.mesh.triangles.size()), 20000, 1000);
    ASSERT_EQ(cavity.fat.size(), cavity.mesh.vertices.size());
    for (const float fat : cavity.fat) EXPECT_TRUE(fat >= 0 && fat <= 1);
    double inlet = 0;
    for (const Vector3& v : cavity.mesh.vertices) {
        if (std::abs(v.y()) < 0.004 && std::abs(v.z()) < 0.012) inlet = std::max(inlet, 2 * std::abs(v.x()));
    }
    EXPECT_NEAR(inlet, pelvis().width, 0.16 * pelvis().width);
}

TEST_P(Anatomy, BowelIsATubeThatCarriesACage) {
    const BowelShape shape = make_bowel(bowel(), pelvis());
    expect_sound(shape.surface);
    EXPECT_NEAR(static_cast<double>(shape.surface.vertices.size()), 20000, 1000);
    for (const Vector3& v : shape.surface.vertices) EXPECT_TRUE(v.x() >= 0 && v.x() <= shape.length);
    const Cage cage =
        build_cage(shape.surface, shape.length, sample_spheres(shape.length, 0.016, shape.radius));
    EXPECT_GE(cage.clearance, 0.0005);
}

TEST_P(Anatomy, BowelIsInsideAndRestsOnThePosteriorWall) {
    const CavityShape cavity = make_cavity(pelvis());
    const BowelShape shape = make_bowel(bowel(), cavity);
    const CavityModel model(cavity.mesh, FreeSide::behind);
    ASSERT_EQ(shape.centre_line.size(), shape.root_line.size());
    double arc = 0, resting = 0;
    for (std::size_t i = 0; i < shape.centre_line.size(); ++i) {
        const double s =
            shape.length * static_cast<double>(i) / static_cast<double>(shape.centre_line.size() - 1);
        if (i > 0) arc += (shape.centre_line[i] - shape.centre_line[i - 1]).norm();
        const CavityPoint wall = model.closest(shape.centre_line[i], 0.2);
        ASSERT_GE(wall.triangle, 0);
        EXPECT_GT(wall.distance, shape.radius(s) - 0.003) << "at s = " << s;
        resting += wall.distance < shape.radius(s) + 0.008 ? 1 : 0;
        const CavityPoint root = model.closest(shape.root_line[i], 0.2);
        EXPECT_LT(std::abs(root.distance), 0.006) << "at s = " << s;
    }
    EXPECT_NEAR(arc, shape.length, 1e-3 * shape.length);
    EXPECT_GT(resting / static_cast<double>(shape.centre_line.size()), 0.4);
    // From deep in the pelvis to the patient's left.
    EXPECT_LT(shape.centre_line.front().y(), -0.05);
    EXPECT_GT(shape.centre_line.back().x(), 0.07);
    // No bend sharper than the tube's own radius, no two parts of the path inside each other.
    const double step = shape.length / static_cast<double>(shape.centre_line.size() - 1);
    for (std::size_t i = 4; i + 4 < shape.centre_line.size(); ++i) {
        const double curvature =
            ((shape.centre_line[i + 4] - 2 * shape.centre_line[i] + shape.centre_line[i - 4]) /
             (16 * step * step))
                .norm();
        EXPECT_LT(curvature, 1 / shape.radius(0.5 * shape.length));
        for (std::size_t j = i + 40; j < shape.centre_line.size(); ++j)
            EXPECT_GT((shape.centre_line[i] - shape.centre_line[j]).norm(), 1.9 * bowel().radius);
    }
}

TEST_P(Anatomy, SameParametersGiveTheSameBytes) {
    const CavityShape cavity = make_cavity(pelvis()), again = make_cavity(pelvis());
    EXPECT_TRUE(same_bytes(cavity.mesh.vertices, again.mesh.vertices));
    EXPECT_TRUE(same_bytes(cavity.fat, again.fat));
    const BowelShape one = make_bowel(bowel(), cavity), two = make_bowel(bowel(), pelvis());
    EXPECT_TRUE(same_bytes(one.surface.vertices, two.surface.vertices));
    EXPECT_TRUE(same_bytes(one.centre_line, two.centre_line));
    EXPECT_TRUE(same_bytes(one.root_line, two.root_line));
    PelvisParameters other = pelvis();
    other.seed += 1;
    EXPECT_FALSE(same_bytes(cavity.mesh.vertices, make_cavity(other).mesh.vertices));
    BowelParameters other_bowel = bowel();
    other_bowel.seed += 1;
    EXPECT_FALSE(same_bytes(one.surface.vertices, make_bowel(other_bowel, cavity).surface.vertices));
}

TEST_P(Anatomy, MesenteryExtendsFromBowelToRootAndFollowsTheRings) {
    const CavityShape cavity = make_cavity(pelvis());
    const BowelShape shape = make_bowel(bowel(), cavity);
    const MesenteryShape sheet = make_mesentery(shape, cavity);
    const MeshReport report = check_mesh(sheet.mesh);
    EXPECT_TRUE(report.indices_valid && report.finite && report.manifold_edges && report.oriented &&
                report.no_zero_area)
        << report.complaint();
    ASSERT_EQ(sheet.vertices.size(),
              static_cast<std::size_t>(sheet.rows) * static_cast<std::size_t>(sheet.columns));
    // Ring frames of the in situ line itself.
    std::vector<RingFrame> rings;
    std::vector<double> arcs;
    for (std::size_t i = 0; i < shape.centre_line.size(); i += 3) {
        const std::size_t a = i > 0 ? i - 1 : 0, b = std::min(i + 1, shape.centre_line.size() - 1);
        RingFrame frame;
        frame.position = shape.centre_line[i];
        frame.rotation.col(2) = (shape.centre_line[b] - shape.centre_line[a]).normalized();
        frame.rotation.col(0) = frame.rotation.col(2).unitOrthogonal();
        frame.rotation.col(1) = frame.rotation.col(2).cross(frame.rotation.col(0));
        rings.push_back(frame);
        arcs.push_back(shape.length * static_cast<double>(i) /
                       static_cast<double>(shape.centre_line.size() - 1));
    }
    std::vector<float> positions(3 * sheet.vertices.size()), normals(positions.size());
    evaluate_mesentery(sheet, rings.data(), arcs.data(), static_cast<int>(rings.size()), positions.data(),
                       normals.data());
    for (std::size_t k = 0; k < sheet.vertices.size(); ++k) {
        const Vector3 p(positions[3 * k], positions[3 * k + 1], positions[3 * k + 2]);
        EXPECT_LT((p - sheet.mesh.vertices[k]).norm(), 2e-3);
        EXPECT_NEAR(Eigen::Vector3f(normals[3 * k], normals[3 * k + 1], normals[3 * k + 2]).norm(), 1.0F,
                    1e-4F);
    }
    // The bowel lifted by 50 mm takes the edge along, the root stays.
    for (RingFrame& ring : rings) ring.position.z() += 0.05;
    std::vector<float> lifted(positions.size());
    evaluate_mesentery(sheet, rings.data(), arcs.data(), static_cast<int>(rings.size()), lifted.data(),
                       normals.data());
    const auto columns = static_cast<std::size_t>(sheet.columns);
    for (std::size_t row = 0; row < static_cast<std::size_t>(sheet.rows); ++row) {
        const std::size_t edge = 3 * row * columns + 2, root = 3 * (row * columns + columns - 1) + 2;
        EXPECT_GT(lifted[edge] - positions[edge], 0.02F);
        EXPECT_NEAR(lifted[root], positions[root], 1e-6F);
    }
}

INSTANTIATE_TEST_SUITE_P(Patients, Anatomy,
                         testing::Values(Case{0.125, 0.115, 0.30, 0.9, 0.016, 1},
                                         Case{0.125, 0.115, 0.30, 0.9, 0.016, 7},
                                         Case{0.110, 0.125, 0.28, 0.85, 0.015, 2},
                                         Case{0.140, 0.105, 0.33, 0.95, 0.017, 3}));

TEST(AnatomyParameters, OutOfRangeParametersAreRefusedByName) {
    PelvisParameters pelvis;
    pelvis.width = 0.5;
    EXPECT_THROW(make_cavity(pelvis), InputError);
    pelvis = {};
    pelvis.triangles = 10;
    EXPECT_THROW(make_cavity(pelvis), InputError);
    BowelParameters bowel;
    bowel.length = 3;
    EXPECT_THROW(make_bowel(bowel, PelvisParameters{}), InputError);
    bowel = {};
    bowel.haustra_depth = 0.9;
    EXPECT_THROW(make_bowel(bowel, PelvisParameters{}), InputError);
    const CavityShape cavity = make_cavity({});
    EXPECT_THROW(make_mesentery(make_bowel({}, cavity), cavity, 0.9, 0.2), InputError);
}

}  // namespace
}  // namespace fulcrum
