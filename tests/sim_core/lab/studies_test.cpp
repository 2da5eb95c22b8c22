// SPDX-License-Identifier: Apache-2.0
// The skin and filter studies as `fulcrum lab run` calls them: files in, JSON out, clear errors.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "sim_core/geometry/mesh_file.h"
#include "sim_core/lab/filter_study.h"
#include "sim_core/lab/skin_study.h"
#include "sim_core/lab/studies.h"
#include "tests/support/own_folder.h"
#include "tests/support/tube.h"

namespace fulcrum {
namespace {

class Studies : public ::testing::Test {
  protected:
    void write(const std::string& name, const TriangleMesh& mesh) const {
        std::ofstream out(folder_ / name);
        write_obj(out, mesh);
    }
    JsonDocument study(const nlohmann::json& keys) const {
        return JsonDocument::parse(keys.dump(), (folder_ / "study.json").string());
    }

    test::OwnFolder folder_;
};

struct SkinCase {
    BowelSkin skin = test::make_skin(0.16, 0.016, 0.016, 30, 16, test::haustral_radius(0.016));
    TriangleMesh mesh_under(const std::vector<RingFrame>& frames) const {
        TriangleMesh mesh;
        mesh.vertices = cage_vertices(skin.cage(), frames.data());
        mesh.triangles = cage_triangles(skin.rings());
        return mesh;
    }
};

TEST_F(Studies, SkinFollowsTheCageInBothScopes) {
    const SkinCase made;
    const auto frames = test::bent_frames(made.skin.cage(), 0.060);
    write("cage.obj", made.mesh_under(test::rest_frames(made.skin.cage())));
    write("deformed.obj", made.mesh_under(frames));
    write("rest.obj", made.skin.rest());
    nlohmann::json keys = {
        {"model", "skin"}, {"cage", "cage.obj"}, {"rest", "rest.obj"}, {"deformed_cage", "deformed.obj"}};
    nlohmann::json results[2];
    const char* scopes[] = {"local", "global"};
    for (int i = 0; i < 2; ++i) {
        keys["scope"] = scopes[i];
        results[i] = lab::run_skin_study(study(keys));
        EXPECT_LE(results[i]["weights_sum_error"].get<double>(), 1e-12);
        EXPECT_LE(results[i]["linear_error_m"].get<double>(), 1e-12);
        ASSERT_EQ(results[i]["vertices"].size(), made.skin.rest().vertices.size());
    }
    double apart = 0.0;
    for (std::size_t v = 0; v < made.skin.rows().size(); ++v) {
        const auto position = [&](int i) {
            const auto& p = results[i]["vertices"][v];
            return Vector3(p[0].get<double>(), p[1].get<double>(), p[2].get<double>());
        };
        EXPECT_LE((position(0) - skin_vertex(made.skin.rows()[v], frames)).norm(), 1e-14)
            << "the study is the product";
        apart = std::max(apart, (position(0) - position(1)).norm());
    }
    EXPECT_GT(apart, 1e-6);
    EXPECT_LE(apart, 0.002);
}

TEST_F(Studies, SkinFindsRingsInAnyVertexOrder) {
    const SkinCase made;
    TriangleMesh cage = made.mesh_under(test::rest_frames(made.skin.cage()));
    const auto layout = lab::find_rings(cage);
    ASSERT_TRUE(layout.has_value());
    EXPECT_EQ(layout->per_ring, ring_size);
    EXPECT_EQ(layout->ring_vertices.size(), cage.vertices.size() - 2);
    std::swap(cage.vertices[3], cage.vertices[40]);
    for (auto& t : cage.triangles) {
        for (auto& v : t) v = v == 3 ? 40 : (v == 40 ? 3 : v);
    }
    EXPECT_FALSE(lab::find_rings(cage).has_value()) << "two vertices in each other's ring";
}

TEST_F(Studies, FilterDistributesTheForce) {
    const TriangleMesh tube = lab::make_tube(0.1, 40, 32, lab::plain_radius(0.016));
    write("tube.obj", tube);
    nlohmann::json keys = {{"model", "filter"},
                           {"mesh", "tube.obj"},
                           {"vertex", 32 * 20 + 5},
                           {"force_n", {0.1, -0.2, 0.3}},
                           {"tip_box_m", {0.010, 0.005, 0.003}},
                           {"tip_rotation", {0.9, 0.1, 0.3, -0.2}}};
    for (const char* grade : {"auto", "0", "1", "2"}) {
        keys["grade"] = grade;
        const auto result = lab::run_filter_study(study(keys));
        Vector3 sum = Vector3::Zero();
        for (const auto& part : result["forces"]) {
            const auto& f = part["force_n"];
            sum += Vector3(f[0].get<double>(), f[1].get<double>(), f[2].get<double>());
        }
        EXPECT_LE((sum - Vector3(0.1, -0.2, 0.3)).norm(), 1e-12);
        if (std::string(grade) != "auto") {
            const std::size_t sizes[] = {1, 7, 19};
            EXPECT_EQ(result["forces"].size(), sizes[grade[0] - '0']);
            EXPECT_EQ(result["grade"], grade[0] - '0');
        }
        EXPECT_GT(result["contact_area_m2"].get<double>(), 0.0);
        EXPECT_GT(result["local_triangle_area_m2"].get<double>(), 0.0);
    }
}

TEST_F(Studies, AreFoundByModelName) {
    write("tube.obj", lab::make_tube(0.1, 40, 32, lab::plain_radius(0.016)));
    const auto run = [&](const char* text) {
        std::ofstream(folder_ / "study.json") << text;
        return lab::run_study((folder_ / "study.json").string());
    };
    const auto result =
        run(R"({"model": "filter", "mesh": "tube.obj", "vertex": 50, "force_n": [0, 0, 1], "grade": 1})");
    EXPECT_EQ(result["grade"], 1);
    for (const char* broken :
         {"{}", "[]", "{", R"({"model": "soup"})", R"({"model": 5})", R"({"model": "filter"})"}) {
        EXPECT_THROW(run(broken), InputError) << broken;
    }
    EXPECT_THROW(lab::run_study((folder_ / "none.json").string()), InputError);
}

TEST_F(Studies, RefuseUnknownKeys) {
    write("tube.obj", lab::make_tube(0.1, 40, 32, lab::plain_radius(0.016)));
    nlohmann::json keys = {{"$comment", "free"},
                           {"model", "cut"},
                           {"mesh", "tube.obj"},
                           {"width_m", 0.001},
                           {"strokes", {{{0, 0, 0}, {0.01, 0, 0}}}}};
    const auto run = [&] {
        std::ofstream(folder_ / "cut.json") << keys.dump(1);
        return lab::run_study((folder_ / "cut.json").string());
    };
    EXPECT_NO_THROW(run());
    keys["fixd"] = {1};
    try {
        run();
        FAIL() << "a misspelt key";
    } catch (const InputError& error) {
        const std::string said = error.what();
        for (const char* part : {"cut.json:", "/fixd", "unknown key", "fixed"})
            EXPECT_NE(said.find(part), std::string::npos) << said;
    }
}

TEST_F(Studies, RefuseInvalidKeysWithPlaceAndHint) {
    const TriangleMesh tube = lab::make_tube(0.1, 40, 32, lab::plain_radius(0.016));
    write("tube.obj", tube);
    TriangleMesh open = tube;
    open.triangles.pop_back();
    write("open.obj", open);
    const nlohmann::json filter = {
        {"model", "filter"}, {"mesh", "tube.obj"}, {"vertex", 5}, {"force_n", {0, 0, 1}}};
    const nlohmann::json skin = {
        {"model", "skin"}, {"cage", "tube.obj"}, {"rest", "tube.obj"}, {"deformed_cage", "tube.obj"}};
    const auto with = [](nlohmann::json keys, const char* key, const nlohmann::json& value) {
        keys[key] = value;
        return keys;
    };
    for (const auto& keys :
         {with(filter, "vertex", -1), with(filter, "vertex", 1e9), with(filter, "vertex", 1.5),
          with(filter, "force_n", {1, 2}), with(filter, "force_n", "much"), with(filter, "grade", "3"),
          with(filter, "mesh", "none.obj"), with(filter, "tip_rotation", {0, 0, 0, 0}),
          with(filter, "tip_box_m", {-1, 1, 1}), with(filter, "mesh", nullptr)}) {
        EXPECT_THROW(lab::run_filter_study(study(keys)), InputError) << keys.dump();
    }
    for (const auto& keys : {with(skin, "cage", "open.obj"), with(skin, "scope", "wide"),
                             with(skin, "rest", 5), with(skin, "deformed_cage", "study.json")}) {
        EXPECT_THROW(lab::run_skin_study(study(keys)), InputError) << keys.dump();
    }
    EXPECT_NO_THROW(lab::run_filter_study(study(filter)));
    EXPECT_NO_THROW(lab::run_skin_study(study(skin)));
}

}  // namespace
}  // namespace fulcrum
