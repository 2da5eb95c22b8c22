// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <sstream>

#include "sim_core/geometry/mesh_file.h"
#include "sim_core/lab/reference_tube.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

TEST(MeshFile, ReadsBackExactlyWhatItWrote) {
    TriangleMesh mesh = lab::make_tube(0.1, 12, 8, lab::haustral_radius(0.01));
    for (const auto& v : mesh.vertices) mesh.texture_coordinates.emplace_back(v.x() / 0.1, 0.5 + v.y());
    std::ostringstream out;
    write_obj(out, mesh);
    const TriangleMesh again = parse_obj(out.str(), "memory");
    ASSERT_EQ(again.vertices.size(), mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        EXPECT_EQ(again.vertices[v], mesh.vertices[v]);
        EXPECT_LE((again.texture_coordinates[v] - mesh.texture_coordinates[v]).norm(), 1e-14);
    }
    EXPECT_EQ(again.triangles, mesh.triangles);
}

TEST(MeshFile, ReadsPolygonsRelativeNumbersAndGroups) {
    const TriangleMesh mesh = parse_obj(
        "# a square and a triangle\no one\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv +0 1e0 0\nf 1 2 3 4\ng two\nv 0 0 "
        "1\nf -1 1 2\n",
        "memory");
    ASSERT_EQ(mesh.vertices.size(), 5u);
    EXPECT_EQ(mesh.vertices[3], Vector3(0, 1, 0));
    const std::vector<Triangle> expected = {{0, 1, 2}, {0, 2, 3}, {4, 0, 1}};
    EXPECT_EQ(mesh.triangles, expected);
}

struct Broken {
    const char* text;
    const char* place;
    const char* part;
};

TEST(MeshFile, RefusesBrokenInputWithPlaceAndHint) {
    const Broken cases[] = {
        {"", "", "no vertices"},
        {"v 0 0\n", "1", "not a finite number"},
        {"v 0 0 0\nv 1 x 0\n", "2", "'x' is not a finite number"},
        {"v 0 0 nan\n", "1", "not a finite number"},
        {"v 0 0 inf\n", "1", "not a finite number"},
        {"v 0 0 1e999\n", "1", "not a finite number"},
        {"v 0 0 5000\n", "1", "exceeds 1000 m"},
        {"v 0 0 0\nv 1 0 0\nf 1 2\n", "3", "fewer than three"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n", "face 1", "does not exist"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "", ""},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf a b c\n", "", ""},
        {"v 0 0 0\nvt 0 q\n", "2", "not a finite number"},
        {"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n", "", ""},
    };
    for (const auto& broken : cases) {
        try {
            parse_obj(broken.text, "part.obj");
            ADD_FAILURE() << "accepted: " << broken.text;
        } catch (const InputError& error) {
            EXPECT_EQ(error.file(), "part.obj");
            EXPECT_EQ(error.place().rfind(broken.place, 0), 0u) << broken.text << error.what();
            EXPECT_NE(error.problem().find(broken.part), std::string::npos) << error.what();
            EXPECT_FALSE(error.hint().empty());
        }
    }
    std::string zero_byte = "v 0 0 0\n";
    zero_byte += '\0';
    EXPECT_THROW(parse_obj(zero_byte, "part.obj"), InputError);
}

TEST(MeshFile, EnforcesItsLimits) {
    MeshLimits limits;
    limits.vertices = 2;
    EXPECT_THROW(parse_obj("v 0 0 0\nv 0 0 0\nv 0 0 0\n", "big.obj", limits), InputError);
    limits = {};
    limits.triangles = 1;
    EXPECT_THROW(parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "big.obj", limits), InputError);
    limits = {};
    limits.bytes = 10;
    EXPECT_THROW(parse_obj("v 0 0 0\nv 1 0 0\n", "big.obj", limits), InputError);
    EXPECT_THROW(read_obj("no/such/file.obj"), InputError);
    EXPECT_THROW(read_obj("/"), InputError);
}

}  // namespace
}  // namespace fulcrum
