// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/scene_assembler.h"

#include <algorithm>

#include "sim_core/anatomy/scene_anatomy.h"
#include "sim_core/bowel/display_skin.h"
#include "sim_core/instrument/proxy_pose.h"
#include "ui/theatre/renderer/all_drawings.h"  // made by the build: every *_drawing.h of this folder
#include "ui/theatre/renderer/shared_textures.h"

namespace fulcrum::ui {

namespace {

constexpr double parted = 0.002;  // m from which on the device's own pose is shown

// One mesentery after the other.
void append(MesenteryShape& all, const MesenteryShape& more) {
    const auto first = static_cast<std::int32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), more.vertices.begin(), more.vertices.end());
    TriangleMesh& mesh = all.mesh;
    mesh.vertices.insert(mesh.vertices.end(), more.mesh.vertices.begin(), more.mesh.vertices.end());
    mesh.texture_coordinates.insert(mesh.texture_coordinates.end(), more.mesh.texture_coordinates.begin(),
                                    more.mesh.texture_coordinates.end());
    for (const Triangle& triangle : more.mesh.triangles)
        mesh.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
}

// Membranes as the world has them; normals of the triangles' areas.
void follow(const std::vector<MembraneView>& membranes, const std::vector<Triangle>& triangles,
            std::vector<float>& positions, std::vector<float>& normals) {
    std::size_t k = 0;
    for (const MembraneView& membrane : membranes) {
        for (const Vector3& p : membrane.positions) {
            for (int c = 0; c < 3; ++c) positions[k++] = static_cast<float>(p[c]);
        }
    }
    using Floats = Eigen::Map<Eigen::Vector3f>;
    std::fill(normals.begin(), normals.end(), 0.0F);
    for (const Triangle& triangle : triangles) {
        float* corner[3];
        for (std::size_t c = 0; c < 3; ++c) corner[c] = positions.data() + 3 * triangle[c];
        const Eigen::Vector3f area =
            (Floats(corner[1]) - Floats(corner[0])).cross(Floats(corner[2]) - Floats(corner[0]));
        for (const std::int32_t vertex : triangle) Floats(normals.data() + 3 * vertex) += area;
    }
    for (std::size_t v = 0; v < normals.size(); v += 3) Floats(normals.data() + v).normalize();
}

}  // namespace

/// What draws each part whose picture needs no surface of the scene's own.
struct PartDrawings {
#define DRAWING(type, view) type view;
#include "ui/theatre/renderer/drawings.inc"
    void add(const WorldSnapshot& snapshot, SceneFrame& frame) {
#define DRAWING(type, view) view.add(snapshot.view, frame);
#include "ui/theatre/renderer/drawings.inc"
    }
};

struct SceneAssembler::Impl {
    Scene scene;
    std::shared_ptr<const AnatomyTextures> textures;
    std::unique_ptr<CavityShape> cavity;
    std::shared_ptr<const TissueTexture> wall, areolar;
    std::unique_ptr<BowelShape> bowel;
    std::unique_ptr<MesenteryShape> mesentery;
    std::unique_ptr<BowelSkin> skin;
    std::unique_ptr<DisplaySkin> display;
    std::unique_ptr<BowelCutDrawing> bowel_cut;  // where its tissue can be cut
    std::vector<float> ring_floats, positions, normals, sheet_positions, sheet_normals;
    FieldDrawing field;
    PartDrawings parts;
    std::unique_ptr<HollowDrawing> hollow;
    SceneFrame frame;
};

SceneAssembler::SceneAssembler(const Scene& scene, const WorldSnapshot& first)
    : impl_(std::make_unique<Impl>()) {
    Impl& i = *impl_;
    i.scene = scene;
    const std::uint64_t seed = scene.cavity ? scene.cavity->seed : 1;
    const int size = scene.bowel ? 1024 : 128;
    i.textures = shared_textures(seed, size);
    if (scene.cavity) i.cavity = std::make_unique<CavityShape>(make_cavity(pelvis_parameters(*scene.cavity)));
    if (i.cavity) i.wall = shared_wall_texture(*i.cavity, seed, size);
    const bool rectum = scene.bowel && scene.bowel->layout == BowelLayout::rectum && scene.presacral;
    if (rectum) i.hollow = std::make_unique<HollowDrawing>(scene, first);
    if (scene.sheet || scene.septa) i.areolar = shared_areolar_texture();
    if (!scene.bowel || !(i.cavity || rectum) || first.bowel.rings.size() < 3) return;
    i.bowel = std::make_unique<BowelShape>(rectum ? make_rectum(rectum_parameters(scene))
                                                  : make_bowel(bowel_parameters(*scene.bowel), *i.cavity));
    // The world's cage: a sphere at every second ring.
    SphereChain spheres;
    for (std::size_t ring = 0; ring < first.bowel.ring_arc_lengths.size(); ring += 2) {
        spheres.arc_lengths.push_back(first.bowel.ring_arc_lengths[ring]);
        spheres.radii.push_back(i.bowel->radius(first.bowel.ring_arc_lengths[ring]));
    }
    i.skin =
        std::make_unique<BowelSkin>(i.bowel->surface, build_cage(i.bowel->surface, i.bowel->length, spheres));
    i.display = std::make_unique<DisplaySkin>(*i.skin);
    if (!first.bowel.cut.hidden.empty()) i.bowel_cut = std::make_unique<BowelCutDrawing>(*i.skin, rectum);
    i.ring_floats.resize(12 * static_cast<std::size_t>(i.skin->rings()));
    i.positions.resize(3 * static_cast<std::size_t>(i.display->vertices()));
    i.normals.resize(i.positions.size());
    if (scene.tethers) {
        i.mesentery = std::make_unique<MesenteryShape>(
            make_mesentery(*i.bowel, *i.cavity, scene.tethers->first, scene.tethers->last));
    } else if (!scene.membranes.empty()) {
        // The world's sheets are these, vertex by vertex.
        i.mesentery = std::make_unique<MesenteryShape>();
        for (const MembraneSpec& spec : scene.membranes)
            append(*i.mesentery, make_mesentery(*i.bowel, *i.cavity, spec.first, spec.last));
    }
    if (i.mesentery) {
        i.sheet_positions.resize(3 * i.mesentery->vertices.size());
        i.sheet_normals.resize(i.sheet_positions.size());
    }
}

SceneAssembler::~SceneAssembler() = default;

void SceneAssembler::install(SceneRenderer& renderer) const {
    renderer.clear_scene();
    renderer.set_textures(impl_->textures);
    if (impl_->cavity) renderer.set_cavity(*impl_->cavity, impl_->wall);
    if (impl_->bowel) {
        renderer.set_bowel(impl_->bowel->surface, impl_->bowel->taenia, impl_->hollow != nullptr);
        if (!impl_->hollow) renderer.set_reflection(make_reflection(*impl_->bowel));
    }
    if (impl_->mesentery) renderer.set_mesentery(*impl_->mesentery);
    if (impl_->areolar) renderer.set_sheet_texture(impl_->areolar);
}

SceneFrame& SceneAssembler::assemble(const WorldSnapshot& snapshot) {
    Impl& i = *impl_;
    i.frame.camera = snapshot.camera;
    i.frame.targets.resize(snapshot.targets.size());
    for (std::size_t k = 0; k < snapshot.targets.size(); ++k) {
        const TargetSphere& sphere = snapshot.targets[k];
        i.frame.targets[k] = {sphere.centre, sphere.radius, TargetLook::waiting, sphere.hand};
    }
    i.frame.tools.clear();
    DrawnTool devices[hand_count];  // as ghosts, where their instruments stay behind at a surface
    int parted_count = 0;
    for (int hand = 0; hand < hand_count; ++hand) {
        const InstrumentSpec* spec = i.scene.instrument(static_cast<Hand>(hand));
        if (spec == nullptr) continue;
        DrawnTool tool;
        tool.pose = lifted(snapshot.tools[hand], snapshot.lift[hand]);
        tool.kind = snapshot.field.empty() ? spec->kind : snapshot.field[0].tools[hand].kind;
        tool.jaw_length = spec->jaw_length;
        tool.shaft_radius = spec->shaft_radius;
        i.frame.tools.push_back(tool);
        if ((tool.pose.tip - snapshot.tools[hand].tip).norm() < parted) continue;
        tool.pose = snapshot.tools[hand];
        tool.ghost = tool.through = true;
        devices[parted_count++] = tool;
    }
    i.frame.tools.insert(i.frame.tools.end(), devices, devices + parted_count);
    i.frame.sheets.clear();
    if (const SheetView& view = snapshot.sheet; view.triangle_count > 0) {
        DrawnSheet sheet;
        sheet.surface = {view.positions.data(),
                         view.rest.data(),
                         static_cast<std::size_t>(view.vertex_count),
                         view.triangles.data(),
                         static_cast<std::size_t>(view.triangle_count),
                         view.thickness};
        if (!view.line_positions.empty()) {
            sheet.mark_from = Vector3(view.line_positions.front(), 0, 0);
            sheet.mark_to = Vector3(view.line_positions.back(), 0, 0);
        }
        i.frame.sheets.push_back(sheet);
    }
    i.frame.enclosed = false;
    if (i.hollow) i.hollow->add(snapshot, i.frame);
    if (!snapshot.field.empty()) i.field.add(snapshot.field[0], i.frame);
    i.parts.add(snapshot, i.frame);
    i.frame.bowel_positions = i.frame.bowel_normals = nullptr;
    i.frame.bowel_hidden = nullptr;
    i.frame.mesentery_positions = i.frame.mesentery_normals = nullptr;
    if (!i.display || static_cast<int>(snapshot.bowel.rings.size()) != i.skin->rings()) return i.frame;
    i.display->evaluate(snapshot.bowel.rings.data(), i.ring_floats.data(), i.positions.data(),
                        i.normals.data());
    if (snapshot.bowel.dent_count > 0)
        i.display->add_dents(snapshot.bowel.dents.data(), snapshot.bowel.dent_count, i.positions.data(),
                             i.normals.data());
    i.frame.bowel_positions = i.positions.data();
    i.frame.bowel_normals = i.normals.data();
    if (i.bowel_cut) i.bowel_cut->add(snapshot.bowel.cut, i.frame);
    if (i.mesentery) {
        if (i.scene.tethers) {
            evaluate_mesentery(*i.mesentery, snapshot.bowel.rings.data(),
                               snapshot.bowel.ring_arc_lengths.data(),
                               static_cast<int>(snapshot.bowel.rings.size()), i.sheet_positions.data(),
                               i.sheet_normals.data());
        } else {
            follow(snapshot.membranes, i.mesentery->mesh.triangles, i.sheet_positions, i.sheet_normals);
        }
        i.frame.mesentery_positions = i.sheet_positions.data();
        i.frame.mesentery_normals = i.sheet_normals.data();
    }
    return i.frame;
}

}  // namespace fulcrum::ui
