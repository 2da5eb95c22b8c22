// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/scene_renderer.h"

#include <QMatrix4x4>
#include <QOpenGLFramebufferObject>
#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/theatre/renderer/scene_renderer_parts.h"
#include "ui/theatre/renderer/scene_views.h"

namespace fulcrum::ui {
namespace {

// A processor draws a scene of 500 x 500 within its budget and scales it up; what is lost is less than a lens
// loses.
constexpr double software_resolution = 0.7;
// In a hollow no pixel is left to a plain room: every one of them is tissue.
constexpr double software_hollow_resolution = 0.58;
// A processor shades blocks of 4 x 4 pixels: of triangles much smaller than that most of the work is lost.
constexpr double software_coarse_pixels = 24;

}  // namespace

PictureQuality picture_quality(const RendererOptions& options) {
    QOpenGLFunctions& gl = *QOpenGLContext::currentContext()->functions();
    const QByteArray device(reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER)));
    PictureQuality quality;
    quality.device = QString::fromLatin1(device);
    quality.software = device.contains("llvmpipe") || device.contains("softpipe") || device.contains("SWR");
    quality.smoothing = options.multisample || !quality.software ? Smoothing::multisample : Smoothing::edges;
    quality.share = options.resolution > 0 ? options.resolution : quality.software ? software_resolution : 1;
    quality.share_in_hollow = options.resolution > 0 ? options.resolution
                              : quality.software     ? software_hollow_resolution
                                                     : 1;
    return quality;
}

SceneRenderer::SceneRenderer(const RendererOptions& options) : impl_(std::make_unique<Impl>()) {
    impl_->options = options;
}
SceneRenderer::~SceneRenderer() = default;

void SceneRenderer::set_textures(std::shared_ptr<const AnatomyTextures> textures) {
    impl_->textures = std::move(textures);
    impl_->textures_changed = true;
}

void SceneRenderer::set_cavity(const CavityShape& cavity, std::shared_ptr<const TissueTexture> wall) {
    impl_->given_wall = std::move(wall);
    impl_->wall_shape = cavity;
    impl_->cavity = {
        make_surface(cavity.mesh), float_positions(cavity.mesh), float_normals(cavity.mesh), {}, true, true};
    // Seen from inside: the normals look in.
    for (float& value : impl_->cavity.normals) value = -value;
}

void SceneRenderer::set_bowel(const TriangleMesh& rest_surface, const std::vector<float>& taenia,
                              bool domes) {
    impl_->bowel = {make_bowel_surface(rest_surface, domes), {}, {}, taenia, true, true};
}

void SceneRenderer::set_mesentery(const MesenteryShape& mesentery) {
    std::vector<float> fraction;
    for (const MesenteryVertex& vertex : mesentery.vertices)
        fraction.push_back(static_cast<float>(vertex.fraction));
    TriangleMesh whole = mesentery.mesh, rim = mesentery.mesh;
    whole.triangles.clear();
    rim.triangles.clear();
    for (const Triangle& triangle : mesentery.mesh.triangles) {
        const bool fades = std::any_of(triangle.begin(), triangle.end(), [&fraction](std::int32_t vertex) {
            return fraction[static_cast<std::size_t>(vertex)] > 1 - mesentery_fade;
        });
        (fades ? rim : whole).triangles.push_back(triangle);
    }
    impl_->mesentery = {make_surface(whole), {}, {}, fraction, true, true};
    impl_->mesentery_rim = {make_surface(rim), {}, {}, std::move(fraction), true, true};
}

void SceneRenderer::set_reflection(const ReflectionShape& reflection) {
    impl_->reflection = {make_surface(reflection.mesh),
                         float_positions(reflection.mesh),
                         float_normals(reflection.mesh),
                         reflection.thinness,
                         true,
                         true};
}

void SceneRenderer::set_sheet_texture(std::shared_ptr<const TissueTexture> texture) {
    impl_->sheet_texture = std::move(texture);
    impl_->textures_changed = true;
}

void SceneRenderer::set_meshes(const std::vector<DrawnMesh>& meshes) {
    impl_->studies.clear();
    for (const DrawnMesh& mesh : meshes) {
        Impl::Study study;
        study.look = mesh;
        if (!mesh.smooth) {
            // Each triangle gets corners, and so a normal, of its own.
            study.look.mesh = {};
            study.look.accent.clear();
            for (const Triangle& triangle : mesh.mesh.triangles) {
                const auto first = static_cast<std::int32_t>(study.look.mesh.vertices.size());
                study.look.mesh.triangles.push_back({first, first + 1, first + 2});
                for (const std::int32_t vertex : triangle) {
                    study.look.mesh.vertices.push_back(mesh.mesh.vertices[static_cast<std::size_t>(vertex)]);
                    if (!mesh.accent.empty())
                        study.look.accent.push_back(mesh.accent[static_cast<std::size_t>(vertex)]);
                }
            }
        }
        impl_->studies.push_back(std::move(study));
    }
}

void SceneRenderer::clear_scene() {
    impl_->studies.clear();
    impl_->sheet_texture.reset();
    for (Impl::Geometry* geometry :
         {&impl_->cavity, &impl_->bowel, &impl_->mesentery, &impl_->mesentery_rim, &impl_->reflection}) {
        *geometry = {};
        geometry->changed = true;
    }
}

bool SceneRenderer::initialise() {
    if (impl_->ready) return true;
    Impl& i = *impl_;
    if (QOpenGLContext::currentContext() == nullptr) {
        i.error = QStringLiteral("no OpenGL context is current");
        return false;
    }
    namespace s = shaders;
    struct Recipe {
        Impl::Program& program;
        std::initializer_list<const char*> vertex, fragment;
    };
    const Recipe recipes[] = {
        {i.tissue, {s::light, s::surface_vertex}, {s::wet, s::tissue_fragment}},
        {i.sheet, {s::light, s::surface_vertex}, {s::wet, s::sheet_fragment}},
        {i.marked_sheet, {s::light, s::surface_vertex}, {s::with_ink, s::wet, s::sheet_fragment}},
        {i.fibres, {s::light, s::surface_vertex}, {s::with_fibres, s::wet, s::sheet_fragment}},
        {i.bowel_wall, {s::light, s::surface_vertex}, {s::with_layers, s::wet, s::sheet_fragment}},
        {i.lumen, {s::within, s::light, s::surface_vertex}, {s::with_layers, s::wet, s::sheet_fragment}},
        {i.large_sheet,
         {s::light_each_fragment, s::light, s::surface_vertex},
         {s::light_each_fragment, s::light, s::wet, s::sheet_fragment}},
        {i.shaded_sheet,
         {s::light_each_fragment, s::light, s::surface_vertex},
         {s::light_each_fragment, s::shade_each_fragment, s::light, s::wet, s::sheet_fragment}},
        {i.wall, {s::light_each_fragment, s::light, s::surface_vertex}, {s::light, s::wet, s::wall_fragment}},
        {i.plain, {s::light, s::surface_vertex}, {s::wet, s::plain_fragment}},
        {i.box, {s::rigid_vertex}, {s::light, s::wet, s::box_fragment}},
        {i.steel, {s::rigid_vertex}, {s::light, s::wet, s::hard, s::steel_fragment}},
        {i.insulated, {s::rigid_vertex}, {s::light, s::wet, s::hard, s::insulated_fragment}},
        {i.ghost, {s::rigid_vertex}, {s::ghost_fragment}},
        {i.target, {s::rigid_vertex}, {s::light, s::wet, s::target_fragment}},
        {i.mask, {s::mask_vertex}, {s::mask_fragment}},
    };
    for (const Recipe& recipe : recipes) {
        recipe.program = compile(recipe.vertex, recipe.fragment, i.error);
        if (!recipe.program) return false;
    }
    i.quality = picture_quality(i.options);
    i.coarse_pixels = i.quality.software ? software_coarse_pixels : 0;
    i.shapes.clear();
    for (int shape = 0; shape < static_cast<int>(ToolShape::count); ++shape)
        i.shapes.push_back(std::make_unique<GlRigid>(make_shape(static_cast<ToolShape>(shape))));
    i.room = std::make_unique<GlRigid>(make_box(0.30F, 0.34F, 0.24F));
    i.frame_mask = std::make_unique<GlRigid>(make_frame_mask());
    i.textures_changed = true;
    for (Impl::Geometry* geometry : {&i.cavity, &i.bowel, &i.mesentery, &i.mesentery_rim, &i.reflection})
        geometry->changed = true;
    i.ready = true;
    return true;
}

void SceneRenderer::set_share(double share) {
    impl_->share = share;
}

const QString& SceneRenderer::error() const {
    return impl_->error;
}

const QImage& SceneRenderer::draw(const SceneFrame& frame, QSize size) {
    impl_->pixels = {};
    if (!frame.notice.isEmpty() || (!impl_->ready && !initialise())) return impl_->pixels;
    return impl_->draw(frame, size);
}

void SceneRenderer::release() {
    Impl& i = *impl_;
    for (Impl::Program* program :
         {&i.tissue, &i.sheet, &i.marked_sheet, &i.fibres, &i.bowel_wall, &i.lumen, &i.large_sheet,
          &i.shaded_sheet, &i.wall, &i.plain, &i.box, &i.steel, &i.insulated, &i.ghost, &i.target, &i.mask})
        program->reset();
    for (GlTissue* tissue : {&i.serosa, &i.fat, &i.peritoneum, &i.areolar, &i.wall_skin, &i.metal})
        *tissue = {};
    for (auto* surface : {&i.gl_cavity, &i.gl_bowel, &i.gl_mesentery, &i.gl_mesentery_rim, &i.gl_reflection})
        surface->reset();
    i.shapes.clear();
    i.room.reset();
    i.frame_mask.reset();
    for (Impl::Study& study : i.studies) {
        study.surface.reset();
        study.lines.reset();
    }
    i.gl_sheets.clear();
    i.image.reset();
    i.resolved.reset();
    i.ready = false;
}

}  // namespace fulcrum::ui
