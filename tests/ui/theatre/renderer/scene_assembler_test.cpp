// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/scene_assembler.h"

#include <gtest/gtest.h>

#include <QColor>
#include <QImage>
#include <algorithm>
#include <vector>

#include "sim_core/anatomy/scene_anatomy.h"
#include "sim_core/haptics/loop.h"
#include "sim_core/world/parts/bowel/bowel_anatomy.h"
#include "sim_core/world/parts/membranes/membrane_layout.h"
#include "sim_core/world/world.h"
#include "tests/support/support.h"
#include "ui/theatre/renderer/offscreen.h"

namespace fulcrum::ui {
namespace {

const std::string scenes = test::source_path("assets/scenes/");

TEST(SceneAssembler, DrawsTheBowelAtItsPositionInTheWorld) {
    const Scene scene = load_scene(scenes + "b1_bowel.json");
    const World world(scene, 1);
    WorldSnapshot snapshot = world.snapshot();
    SceneAssembler assembler(scene, snapshot);
    const SceneFrame& frame = assembler.assemble(snapshot);
    ASSERT_NE(frame.bowel_positions, nullptr);
    ASSERT_NE(frame.mesentery_positions, nullptr);
    ASSERT_EQ(frame.tools.size(), scene.instruments.size());
    const std::size_t vertices = bowel_anatomy(scene).surface.vertices.size();
    // Every ring is surrounded by the drawn surface.
    for (std::size_t r = 2; r + 2 < snapshot.bowel.rings.size(); r += 4) {
        double nearest = 1;
        for (std::size_t v = 0; v < vertices; ++v) {
            const float* p = frame.bowel_positions + 3 * v;
            nearest =
                std::min(nearest, (Vector3(p[0], p[1], p[2]) - snapshot.bowel.rings[r].position).norm());
        }
        EXPECT_GT(nearest, 0.4 * scene.bowel->outer_radius);
        EXPECT_LT(nearest, 1.2 * scene.bowel->outer_radius);
    }
    // A lifted ring is drawn lifted.
    const float before = frame.bowel_positions[3 * 5000 + 2];
    for (RingFrame& ring : snapshot.bowel.rings) ring.position.z() += 0.01;
    EXPECT_NEAR(assembler.assemble(snapshot).bowel_positions[3 * 5000 + 2], before + 0.01F, 1e-5F);
}

TEST(SceneAssembler, DrawsTheMesenteryAtThePositionOfTheMembrane) {
    const Scene scene = load_scene(scenes + "b1_mesentery.json");
    // The bowel without membranes.
    WorldSnapshot snapshot = World(load_scene(scenes + "b1_bowel.json"), 1).snapshot();
    const std::vector<MembraneSheet> sheets = lay_out_membranes(scene);
    ASSERT_EQ(sheets.size(), 1U);
    snapshot.membranes.resize(1);
    snapshot.membranes[0].positions = sheets[0].mesh.vertices;
    SceneAssembler assembler(scene, snapshot);
    for (Vector3& p : snapshot.membranes[0].positions) p.z() += 0.02;
    const SceneFrame& frame = assembler.assemble(snapshot);
    ASSERT_NE(frame.mesentery_positions, nullptr);
    for (std::size_t v = 0; v < snapshot.membranes[0].positions.size(); ++v) {
        const Vector3& p = snapshot.membranes[0].positions[v];
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(static_cast<double>(frame.mesentery_positions[3 * v + static_cast<std::size_t>(c)]),
                        p[c], 1e-6);
        const Eigen::Map<const Eigen::Vector3f> normal(frame.mesentery_normals + 3 * v);
        EXPECT_NEAR(normal.norm(), 1.0F, 1e-5F);
    }
}

/// A scene whose left hand a test puts somewhere, tick by tick; the others stay where they begin.
struct LeftHandInScene {
    explicit LeftHandInScene(const char* file)
        : scene(load_scene(scenes + file)),
          world(scene, 1),
          loop(scene, world),
          spec(*scene.instrument(Hand::left)),
          trocar(make_trocar(spec.trocar)),
          start(trocar.position + spec.start_insertion * trocar.rotation.col(2)),
          outputs(static_cast<std::size_t>(scene.ticks_per_step)),
          left(start_sample(spec.trocar, spec.start_insertion)) {}
    void put(const Vector3& tip) {
        RigSample input;
        input.tick = ++tick;
        for (const InstrumentSpec& other : scene.instruments)
            input.hand[static_cast<int>(other.hand)] = start_sample(other.trocar, other.start_insertion);
        if (scene.camera) input.camera = start_sample(scene.camera->trocar, scene.camera->start_insertion);
        DeviceReading reading;
        reading.handle = handle_for_tip(trocar, tip);
        input.hand[0] = left = quantise(reading, left);
        const TickOutput& output = outputs[(tick - 1) % outputs.size()] = loop.tick(input);
        const std::int32_t* counts = output.sample.hand[0].force;
        force = sample_force_unit * Vector3(counts[0], counts[1], counts[2]).norm();
        if (tick % outputs.size() != 0) return;
        world.step(outputs.data(), outputs.size());
        loop.adopt(world.local_models());
    }
    void put(const Vector3& tip, int ticks) {
        for (int i = 0; i < ticks; ++i) put(tip);
    }
    /// In a straight line.
    void move(const Vector3& from, const Vector3& to, int ticks) {
        for (int i = 1; i <= ticks; ++i) put(from + static_cast<double>(i) / ticks * (to - from));
    }
    const Scene scene;
    World world;
    HapticLoop loop;
    const InstrumentSpec& spec;
    const Trocar trocar;
    const Vector3 start;
    std::vector<TickOutput> outputs;
    DeviceSample left;
    std::uint32_t tick = 0;
    double force = 0;  ///< N, on the tissue
};

// A push of about 20 N: the device is 25 mm behind the wall, the instrument is drawn at it.
TEST(SceneAssembler, DrawsAnInstrumentAtTheWallThatItsDeviceIsBehind) {
    LeftHandInScene at("b1_bowel.json");
    const InstrumentSpec& spec = at.spec;
    const World& world = at.world;
    const CavityPoint wall = world.wall()->closest(at.start, 0.2);
    ASSERT_GE(wall.triangle, 0);
    const Vector3 behind = wall.position - 0.025 * wall.normal;
    at.move(at.start, behind, 800);
    at.put(behind, 200);
    EXPECT_GT(at.force, 5);
    const WorldSnapshot& snapshot = world.snapshot();
    const auto inside_wall = [&](const Vector3& tip) {
        return spec.tip_radius - world.wall()->closest(tip, 0.1).distance;
    };
    EXPECT_GT(inside_wall(snapshot.tools[0].tip), 0.015) << "the device is behind the wall";
    SceneAssembler assembler(at.scene, snapshot);
    const SceneFrame& frame = assembler.assemble(snapshot);
    ASSERT_EQ(frame.tools.size(), 3U);
    EXPECT_FALSE(frame.tools[0].ghost);
    EXPECT_LT(inside_wall(frame.tools[0].pose.tip), 0.0015) << "what is seen stops at the wall";
    EXPECT_TRUE(frame.tools[2].ghost) << "the device's own pose";
    EXPECT_EQ(frame.tools[2].pose.tip, snapshot.tools[0].tip);
    EXPECT_EQ(frame.tools[1].pose.tip, snapshot.tools[1].tip) << "the other touches nothing";

    // The ghost is seen although it is behind the wall.
    SceneFrame seen = frame;
    const Vector3 tip = frame.tools[0].pose.tip;
    const Vector3 eye = tip + 0.06 * wall.normal + 0.03 * frame.tools[0].pose.axis.unitOrthogonal();
    Matrix3 view;
    view.col(2) = (eye - tip).normalized();
    view.col(0) = view.col(2).unitOrthogonal();
    view.col(1) = view.col(2).cross(view.col(0));
    seen.camera.position = eye;
    seen.camera.orientation = Quaternion(view);
    RendererOptions options;
    options.texture_size = 128;
    SceneRenderer renderer(options);
    assembler.install(renderer);
    const QImage with = render_offscreen(renderer, seen, QSize(320, 320));
    seen.tools.pop_back();
    const QImage without = render_offscreen(renderer, seen, QSize(320, 320));
    int changed = 0;
    for (int y = 0; y < with.height(); ++y) {
        for (int x = 0; x < with.width(); ++x) {
            const QRgb a = with.pixel(x, y), b = without.pixel(x, y);
            const int apart =
                std::abs(qRed(a) - qRed(b)) + std::abs(qGreen(a) - qGreen(b)) + std::abs(qBlue(a) - qBlue(b));
            changed += apart > 12 ? 1 : 0;
        }
    }
    EXPECT_GT(changed, 100);
}

TEST(SceneAssembler, DrawsAnInstrumentAtTheSphereThatItsDeviceIsIn) {
    LeftHandInScene at("a2_targets.json");
    const std::vector<TargetSphere>& spheres = at.world.snapshot().targets;
    const auto own = std::find_if(spheres.begin(), spheres.end(),
                                  [](const TargetSphere& sphere) { return sphere.hand == Hand::left; });
    ASSERT_NE(own, spheres.end());
    const Vector3 centre = own->centre, out = (at.trocar.position - centre).normalized();
    const double touching = own->radius + at.spec.tip_radius;
    const auto inside = [&](const Vector3& tip) { return touching - (tip - centre).norm(); };
    constexpr double pushed = 0.004;  // m
    const Vector3 deep = centre + (touching - pushed) * out;
    const Vector3 before = centre + (touching + 0.02) * out;
    at.move(at.start, before, 400);
    at.move(before, deep, 400);
    at.put(deep, 200);
    EXPECT_NEAR(at.force, 600 * pushed, 0.3) << "it presses on the sphere";
    const WorldSnapshot& snapshot = at.world.snapshot();
    EXPECT_NEAR(inside(snapshot.tools[0].tip), pushed, 1e-4) << "the device is in the sphere";
    SceneAssembler assembler(at.scene, snapshot);
    const SceneFrame& frame = assembler.assemble(snapshot);
    ASSERT_EQ(frame.tools.size(), 3U);
    EXPECT_LT(inside(frame.tools[0].pose.tip), 1e-4) << "what is seen stops at its surface";
    EXPECT_GT(inside(frame.tools[0].pose.tip), -1e-4) << "and not before it";
    EXPECT_TRUE(frame.tools[2].ghost) << "the device's own pose";
    EXPECT_EQ(frame.tools[2].pose.tip, snapshot.tools[0].tip);
}

/// m, how deep a ball of this radius is in the drawn bowel, by the nearest point of its surface.
double depth_in_drawn_bowel(const SceneFrame& frame, std::size_t vertices, const Vector3& middle,
                            double radius) {
    double nearest = 1e9, inside = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
        const float *p = frame.bowel_positions + 3 * v, *n = frame.bowel_normals + 3 * v;
        const Vector3 apart = middle - Vector3(p[0], p[1], p[2]);
        if (apart.norm() >= nearest) continue;
        nearest = apart.norm();
        inside = radius - apart.dot(Vector3(n[0], n[1], n[2]));
    }
    return inside;
}

// Bowel gives way and is drawn dented: the tip is seen in the dent, and is not inside what is drawn.
TEST(SceneAssembler, DrawsAnInstrumentOnTheBowelThatItPresses) {
    LeftHandInScene at("b1_bowel.json");
    const std::vector<RingFrame>& rings = at.world.snapshot().bowel.rings;
    const Vector3 ring =
        std::min_element(rings.begin(), rings.end(), [&](const RingFrame& a, const RingFrame& b) {
            return (a.position - at.trocar.position).norm() < (b.position - at.trocar.position).norm();
        })->position;
    const Vector3 out = (at.trocar.position - ring).normalized();
    Vector3 tip = ring + 0.03 * out;
    at.move(at.start, tip, 400);
    while (at.force < 1.5 && (tip - ring).dot(out) > -0.03) at.put(tip -= 5e-5 * out);
    at.put(tip, 300);
    ASSERT_GT(at.force, 0.8) << "it presses, at " << (tip - ring).dot(out) << " m from where it was";
    WorldSnapshot snapshot = at.world.snapshot();
    const Vector3 device = snapshot.tools[0].tip;
    const std::size_t vertices = bowel_anatomy(at.scene).surface.vertices.size();
    SceneAssembler assembler(at.scene, snapshot);
    const SceneFrame& frame = assembler.assemble(snapshot);
    EXPECT_LT(depth_in_drawn_bowel(frame, vertices, frame.tools[0].pose.tip, at.spec.tip_radius), 0.0015);
    // Without what gives way in the picture it would be deep in it.
    snapshot.bowel.dent_count = 0;
    assembler.assemble(snapshot);
    EXPECT_GT(depth_in_drawn_bowel(frame, vertices, device, at.spec.tip_radius), 0.0015);
}

TEST(SceneAssembler, DrawsASceneWithTargetsOnly) {
    const Scene scene = load_scene(scenes + "a2_targets.json");
    const World world(scene, 3);
    SceneAssembler assembler(scene, world.snapshot());
    const SceneFrame& frame = assembler.assemble(world.snapshot());
    EXPECT_EQ(frame.bowel_positions, nullptr);
    EXPECT_EQ(frame.targets.size(), world.snapshot().targets.size());
    RendererOptions options;
    options.texture_size = 128;
    SceneRenderer renderer(options);
    assembler.install(renderer);
    const QImage image = render_offscreen(renderer, frame, QSize(320, 240));
    EXPECT_GT(qRed(image.pixel(160, 120)) + qGreen(image.pixel(160, 120)) + qBlue(image.pixel(160, 120)), 30);
}

TEST(SceneAssembler, DrawsASheetAsInTheWorldBetweenItsTools) {
    const Scene scene = load_scene(scenes + "b2_areolar.json");
    ASSERT_TRUE(scene.sheet);
    WorldSnapshot snapshot;
    snapshot.camera.position = Vector3(0, -0.02, 0.08);
    snapshot.camera.orientation = Quaternion::Identity();
    SheetView& view = snapshot.sheet;
    view.thickness = 0.0015;
    view.line_positions = {0, 0.05, 0.1};
    for (int j = 0; j <= 10; ++j) {
        for (int i = 0; i <= 24; ++i) {
            view.rest.emplace_back(-0.01 + 0.005 * i, -0.025 + 0.005 * j, 0);
            view.positions.emplace_back(-0.06 + 0.005 * i, -0.045 + 0.005 * j, -0.02);
        }
    }
    view.vertex_count = static_cast<std::int32_t>(view.positions.size());
    for (int j = 0; j < 10; ++j) {
        for (int i = 0; i < 24; ++i) {
            const int a = j * 25 + i;
            view.triangles.push_back({a, a + 1, a + 26});
            view.triangles.push_back({a, a + 26, a + 25});
        }
    }
    view.triangle_count = static_cast<std::int32_t>(view.triangles.size());
    SceneAssembler assembler(scene, snapshot);
    RendererOptions options;
    options.texture_size = 128;
    SceneRenderer renderer(options);
    assembler.install(renderer);
    const SceneFrame& frame = assembler.assemble(snapshot);
    ASSERT_EQ(frame.sheets.size(), 1U);
    ASSERT_EQ(frame.tools.size(), 2U);
    EXPECT_EQ(frame.tools[0].kind, InstrumentKind::grasper);
    EXPECT_EQ(frame.tools[1].kind, InstrumentKind::scissors);
    const QImage whole = render_offscreen(renderer, frame, QSize(320, 320));
    const QColor middle = whole.pixelColor(110, 130);
    EXPECT_GT(middle.red(), middle.blue() + 15);
    // Removed parts are not drawn: the box behind them is bluish.
    view.triangle_count = 0;
    const QImage gone = render_offscreen(renderer, assembler.assemble(snapshot), QSize(320, 320));
    const QColor behind = gone.pixelColor(110, 130);
    EXPECT_LT(behind.red(), behind.blue() + 5);
}

TEST(SceneAssembler, DrawsEachClipOfABandOnce) {
    const Scene scene = load_scene(scenes + "b3_bands.json");
    WorldSnapshot snapshot = World(scene, 5).snapshot();
    std::vector<OutletView>& outlets = snapshot.field.at(0).outlets;
    OutletView &trunk = outlets.at(0), &branch = outlets.at(1);
    BandView& band = snapshot.bands.bands.at(static_cast<std::size_t>(trunk.band));
    SceneAssembler assembler(scene, snapshot);
    const auto drawn = [&](TargetLook look) {
        const std::vector<DrawnTarget>& all = assembler.assemble(snapshot).targets;
        return std::count_if(all.begin(), all.end(),
                             [&](const DrawnTarget& one) { return one.look == look; });
    };
    EXPECT_EQ(drawn(TargetLook::clip), 0);
    band.parted = 1U << 8U;
    trunk.opened = true;
    trunk.flow = 1e-7;
    EXPECT_EQ(drawn(TargetLook::bleeding), 1);
    band.clips = 1U << 2U;  // on the stump
    trunk.flow = 0;
    trunk.clipped = true;
    EXPECT_EQ(drawn(TargetLook::clip), 1);
    EXPECT_EQ(drawn(TargetLook::bleeding), 0);
    band.clips |= 1U << 8U;  // on its end too
    EXPECT_EQ(drawn(TargetLook::clip), 2);
    branch.clipped = true;
    EXPECT_EQ(drawn(TargetLook::clip), 3);
}

TEST(SceneAssembler, EachKindOfInstrumentHasItsOwnTip) {
    SceneFrame frame;
    frame.camera.position = Vector3(0, 0, 0.05);
    SceneRenderer renderer;
    std::vector<QImage> seen;
    for (const InstrumentType& type : instrument_types) {
        DrawnTool tool;
        tool.kind = type.kind;
        tool.pose.inside = true;
        tool.pose.trocar = Vector3(0.1, 0, 0);
        tool.pose.axis = -Vector3::UnitX();
        tool.pose.orientation = Quaternion::FromTwoVectors(Vector3::UnitZ(), tool.pose.axis);
        tool.pose.jaw_angle = 0.4;
        frame.tools = {tool};
        seen.push_back(render_offscreen(renderer, frame, QSize(200, 200)));
    }
    for (std::size_t a = 0; a < seen.size(); ++a) {
        for (std::size_t b = a + 1; b < seen.size(); ++b) EXPECT_NE(seen[a], seen[b]);
    }
}

}  // namespace
}  // namespace fulcrum::ui
