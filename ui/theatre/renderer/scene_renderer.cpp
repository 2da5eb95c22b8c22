// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/scene_renderer.h"

#include <QMatrix4x4>
#include <QOpenGLFramebufferObject>
#include <algorithm>
#include <cmath>
#include <optional>

#include "ui/theatre/renderer/gl_objects.h"
#include "ui/theatre/renderer/shaders.h"

namespace fulcrum::ui {
namespace {

constexpr float near_plane = 0.003F, far_plane = 0.8F;                // m
constexpr float figure_near_plane = 0.01F, figure_far_plane = 20.0F;  // m
constexpr int most_tools = 4;
// A processor draws a scene of 500 x 500 within its budget and scales it up; what is lost is less than a lens
// loses.
constexpr double software_resolution = 0.7;
// A processor shades blocks of 4 x 4 pixels: of triangles much smaller than that most of the work is lost.
constexpr double software_coarse_pixels = 24;
constexpr float mesentery_fade = 0.3F;  // share of its width over which the root lets the wall through

QVector3D vector(const Vector3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

QQuaternion quaternion(const Quaternion& q) {
    return {static_cast<float>(q.w()), static_cast<float>(q.x()), static_cast<float>(q.y()),
            static_cast<float>(q.z())};
}

QMatrix4x4 camera_matrix(const CameraPose& camera) {
    QMatrix4x4 matrix;
    matrix.rotate(quaternion(camera.orientation).conjugated());
    matrix.translate(-vector(camera.position));
    return matrix;
}

QMatrix4x4 projection_matrix(const SceneFrame& frame, QSize size) {
    QMatrix4x4 matrix;
    const float aspect = static_cast<float>(size.width()) / static_cast<float>(size.height());
    matrix.perspective(static_cast<float>(frame.camera.field_of_view * 180 / 3.14159265358979), aspect,
                       frame.round ? near_plane : figure_near_plane,
                       frame.round ? far_plane : figure_far_plane);
    return matrix;
}

struct TargetPaint {
    QVector3D hue;
    float glow, opacity;
};

// Blue and orange of Okabe and Ito's palette: told apart by every kind of colour vision.
TargetPaint paint_of(const DrawnTarget& target) {
    const QVector3D hue =
        target.hand == Hand::left ? QVector3D(0.00F, 0.45F, 0.80F) : QVector3D(0.95F, 0.58F, 0.05F);
    switch (target.look) {
        case TargetLook::current:
            return {hue, 1.0F, 1.0F};
        case TargetLook::touched:
            return {QVector3D(0.98F, 0.95F, 0.75F), 0.8F, 1.0F};
        case TargetLook::done:
            return {QVector3D(0.35F, 0.36F, 0.38F), 0.0F, 0.35F};
        case TargetLook::waiting:
            break;
    }
    return {0.62F * hue, 0.0F, 1.0F};
}

}  // namespace

struct SceneRenderer::Impl {
    RendererOptions options;
    QString error;

    // What was set; uploaded at the next picture.
    std::optional<AnatomyTextures> textures;
    bool textures_changed = false;
    std::shared_ptr<const TissueTexture> given_wall;
    CavityShape wall_shape;  // kept until its texture is made
    struct Geometry {
        SurfaceMesh mesh;
        std::vector<float> positions, normals, detail;
        bool present = false, changed = false;
    };
    Geometry cavity, bowel, mesentery, mesentery_rim, reflection;

    bool ready = false;
    double share_of_resolution = 1;
    bool smooth = false;       // four samples a pixel
    double coarse_pixels = 0;  // coarse triangles with shorter edges than that are good enough; 0: none are
    using Program = std::unique_ptr<QOpenGLShaderProgram>;
    Program tissue, wall, plain, box, steel, target, screen;
    struct Study {
        DrawnMesh look;
        std::unique_ptr<GlSurface> surface;  // null: to be uploaded
        std::unique_ptr<GlLines> lines;
    };
    std::vector<Study> studies;
    GlTissue serosa, fat, peritoneum, wall_skin, metal;
    std::unique_ptr<GlSurface> gl_cavity, gl_bowel, gl_mesentery, gl_mesentery_rim, gl_reflection;
    std::unique_ptr<GlRigid> shaft, clevis, jaw, probe_end, sphere, room, frame_mask, disc;
    std::unique_ptr<QOpenGLFramebufferObject> image, resolved;

    QMatrix4x4 to_camera, projection;

    void take(Geometry& geometry, std::unique_ptr<GlSurface>& surface) const {
        if (!geometry.changed) return;
        geometry.changed = false;
        surface.reset();
        if (!geometry.present) return;
        surface = std::make_unique<GlSurface>(
            geometry.mesh, geometry.positions.empty() ? nullptr : geometry.positions.data(),
            geometry.normals.empty() ? nullptr : geometry.normals.data(), geometry.detail);
    }

    void upload_changes() {
        if (!textures) textures = make_textures(1, options.texture_size);
        if (textures_changed) {
            serosa = upload(textures->serosa);
            fat = upload(textures->fat);
            peritoneum = upload(textures->peritoneum);
            metal = upload(textures->steel);
            textures_changed = false;
        }
        if (cavity.changed && cavity.present) {
            wall_skin = upload(
                given_wall ? *given_wall
                           : make_wall_texture(wall_shape, textures->peritoneum, 2 * options.texture_size));
        }
        take(cavity, gl_cavity);
        take(bowel, gl_bowel);
        take(mesentery, gl_mesentery);
        take(mesentery_rim, gl_mesentery_rim);
        take(reflection, gl_reflection);
    }

    void start(QOpenGLShaderProgram& program, const SceneFrame& frame) const {
        program.bind();
        program.setUniformValue("to_camera", to_camera);
        program.setUniformValue("projection", projection);
        program.setUniformValue("lamp", vector(frame.lamp));
        program.setUniformValue("brightness", static_cast<float>(frame.brightness));
        program.setUniformValue("albedo", 0);
        program.setUniformValue("relief", 1);
        QVector4D from[most_tools], to[most_tools];
        float strains[most_tools] = {0, 0, 0, 0};
        int count = 0;
        for (const DrawnTool& tool : frame.tools) {
            if (tool.ghost || !tool.pose.inside || count == most_tools) continue;
            const double length = tool.jaws ? tool.jaw_length : 4 * tool.shaft_radius;
            const QVector3D tip = to_camera.map(vector(tool.pose.tip));
            const QVector3D heel = to_camera.map(vector(tool.pose.tip - 1.6 * length * tool.pose.axis));
            // Open jaws shade less of what lies between them.
            from[count] = QVector4D(heel, 1.0F);
            to[count] = QVector4D(tip, static_cast<float>(2.1 * tool.shaft_radius +
                                                          0.15 * tool.jaw_length * tool.pose.jaw_angle));
            strains[count] = static_cast<float>(std::clamp(tool.strain, 0.0, 1.0));
            ++count;
        }
        program.setUniformValueArray("shadow_from", from, most_tools);
        program.setUniformValueArray("shadow_to", to, most_tools);
        program.setUniformValue("strain", QVector4D(strains[0], strains[1], strains[2], strains[3]));
        program.setUniformValue("shadows", count);
    }

    void draw_part(QOpenGLExtraFunctions& gl, GlRigid& part, const QMatrix4x4& pose) const {
        steel->setUniformValue("to_camera", to_camera * pose);
        part.draw(gl);
    }

    void draw_tool(QOpenGLExtraFunctions& gl, const DrawnTool& tool) const {
        if (!tool.pose.inside) return;
        const QVector4D tint = tool.ghost ? QVector4D(0.55F, 0.85F, 1.0F, 0.55F) : QVector4D(1, 1, 1, 1);
        steel->setUniformValue("tint", tint);
        const auto radius = static_cast<float>(tool.shaft_radius);
        const auto jaw_length = static_cast<float>(tool.jaws ? tool.jaw_length : 0);
        const auto whole = static_cast<float>((tool.pose.tip - tool.pose.trocar).norm());
        QMatrix4x4 hinge;
        hinge.translate(vector(tool.pose.tip));
        hinge.rotate(quaternion(tool.pose.orientation));
        hinge.translate(0, 0, -jaw_length);
        // The insulation ends a little before the jaws; the steel shows there.
        const float bare = tool.jaws ? 0.012F : 0.020F;
        QMatrix4x4 black = hinge;
        black.translate(0, 0, -whole - 0.05F);
        black.scale(radius, radius, std::max(0.001F, whole + 0.05F - bare));
        steel->setUniformValue("insulated", 1.0F);
        draw_part(gl, *shaft, black);
        steel->setUniformValue("insulated", 0.0F);
        QMatrix4x4 steel_end = hinge;
        steel_end.translate(0, 0, -bare - 0.001F);
        steel_end.scale(0.86F * radius, 0.86F * radius, bare - (tool.jaws ? radius : 3 * radius) + 0.001F);
        draw_part(gl, *shaft, steel_end);
        if (!tool.jaws) {
            QMatrix4x4 end = hinge;
            end.scale(0.86F * radius);
            draw_part(gl, *probe_end, end);
            return;
        }
        QMatrix4x4 fork = hinge;
        fork.scale(0.9F * radius);
        draw_part(gl, *clevis, fork);
        const auto half = static_cast<float>(0.5 * tool.pose.jaw_angle * 180 / 3.14159265358979);
        for (const float side : {0.0F, 180.0F}) {
            QMatrix4x4 blade = hinge;
            blade.rotate(side, 0, 0, 1);
            blade.rotate(-half, 1, 0, 0);
            blade.scale(jaw_length);
            draw_part(gl, *jaw, blade);
        }
    }

    void draw_tools(QOpenGLExtraFunctions& gl, const SceneFrame& frame, bool ghosts) const {
        start(*steel, frame);
        metal.bind();
        for (const DrawnTool& tool : frame.tools) {
            if (tool.ghost == ghosts) draw_tool(gl, tool);
        }
    }

    void draw_targets(QOpenGLExtraFunctions& gl, const SceneFrame& frame, bool translucent) const {
        if (frame.targets.empty()) return;
        start(*target, frame);
        for (const DrawnTarget& item : frame.targets) {
            const TargetPaint paint = paint_of(item);
            if ((paint.opacity < 1) != translucent) continue;
            QMatrix4x4 pose;
            pose.translate(vector(item.centre));
            pose.scale(static_cast<float>(item.radius));
            target->setUniformValue("to_camera", to_camera * pose);
            target->setUniformValue("hue", paint.hue);
            target->setUniformValue("glow", paint.glow);
            target->setUniformValue("opacity", paint.opacity);
            target->setUniformValue("bands", item.hand == Hand::left ? 1.0F : 2.0F);
            sphere->draw(gl);
        }
    }

    void draw_studies(QOpenGLExtraFunctions& gl, const SceneFrame& frame, const GlSurface::Sight& sight) {
        if (studies.empty()) return;
        start(*plain, frame);
        // Edges that lie on a surface are seen whole.
        gl.glEnable(GL_POLYGON_OFFSET_FILL);
        gl.glPolygonOffset(1.0F, 2.0F);
        for (Study& study : studies) {
            const DrawnMesh& look = study.look;
            plain->setUniformValue("hue", look.colour);
            plain->setUniformValue("accent", look.accent_colour);
            plain->setUniformValue("lit", look.wireframe ? 0.0F : 1.0F);
            if (look.wireframe) {
                if (!study.lines) study.lines = std::make_unique<GlLines>(look.mesh);
                study.lines->draw(gl);
                continue;
            }
            if (!study.surface) {
                const std::vector<float> positions = float_positions(look.mesh),
                                         normals = float_normals(look.mesh);
                study.surface = std::make_unique<GlSurface>(make_surface(look.mesh), positions.data(),
                                                            normals.data(), look.accent);
            }
            GlSurface::Sight whole = sight;
            whole.coarse_edge_at_1m = 0;
            whole.half_angle = 1.5;
            study.surface->draw(gl, whole);
        }
        gl.glDisable(GL_POLYGON_OFFSET_FILL);
    }

    void draw_scene(QOpenGLExtraFunctions& gl, const SceneFrame& frame) {
        GlSurface::Sight sight;
        sight.eye = frame.camera.position;
        sight.forward = -(frame.camera.orientation * Vector3::UnitZ());
        sight.half_angle = 0.5 * frame.camera.field_of_view;
        if (coarse_pixels > 0)
            sight.coarse_edge_at_1m = coarse_pixels * 2 * std::tan(sight.half_angle) / image->height();
        for (const DrawnTool& tool : frame.tools) {
            if (tool.pose.inside)
                sight.touched.push_back(tool.pose.tip - 0.5 * tool.jaw_length * tool.pose.axis);
        }
        gl.glEnable(GL_DEPTH_TEST);
        gl.glDepthFunc(GL_LESS);
        gl.glDisable(GL_BLEND);
        gl.glDisable(GL_CULL_FACE);
        const QVector3D behind = frame.round ? QVector3D() : frame.background;
        gl.glClearColor(behind.x(), behind.y(), behind.z(), 1);
        gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        // Nothing outside the round image is worth a fragment.
        gl.glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        if (frame.round) {
            screen->bind();
            frame_mask->draw(gl);
        }
        gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

        draw_tools(gl, frame, false);
        draw_targets(gl, frame, false);
        draw_studies(gl, frame, sight);
        gl.glEnable(GL_CULL_FACE);
        if (gl_bowel && frame.bowel_positions != nullptr && frame.bowel_normals != nullptr) {
            gl_bowel->update(frame.bowel_positions, frame.bowel_normals, frame.version);
            start(*tissue, frame);
            tissue->setUniformValue("bump", 1.0F);
            tissue->setUniformValue("rim_fade", 0.0F);
            tissue->setUniformValue("two_sided", 0);
            serosa.bind();
            gl.glCullFace(GL_BACK);
            gl_bowel->draw(gl, sight);
        }
        if (gl_mesentery && frame.mesentery_positions != nullptr && frame.mesentery_normals != nullptr) {
            // What of it lets nothing through hides the wall behind it.
            gl.glDisable(GL_CULL_FACE);
            gl_mesentery->update(frame.mesentery_positions, frame.mesentery_normals, frame.version);
            start(*tissue, frame);
            tissue->setUniformValue("bump", 1.0F);
            tissue->setUniformValue("rim_fade", 0.0F);
            tissue->setUniformValue("two_sided", 1);
            fat.bind();
            gl_mesentery->draw(gl, sight);
            gl.glEnable(GL_CULL_FACE);
        }
        if (gl_cavity) {
            start(*wall, frame);
            wall->setUniformValue("bump", 1.0F);
            wall_skin.bind();
            gl.glCullFace(GL_FRONT);  // seen from inside
            GlSurface::Sight inside = sight;
            inside.round = coarse_pixels > 0;
            gl_cavity->draw(gl, inside);
        } else if (studies.empty()) {
            gl.glDisable(GL_CULL_FACE);
            start(*box, frame);
            QMatrix4x4 pose;
            pose.translate(-0.15F, -0.11F, -0.085F);
            box->setUniformValue("to_camera", to_camera * pose);
            room->draw(gl);
        }
        gl.glDisable(GL_CULL_FACE);
        gl.glEnable(GL_BLEND);
        gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        if (gl_reflection) {
            start(*tissue, frame);
            tissue->setUniformValue("bump", 1.0F);
            tissue->setUniformValue("rim_fade", 0.45F);
            tissue->setUniformValue("two_sided", 1);
            peritoneum.bind();
            gl_reflection->draw(gl, sight);
        }
        if (gl_mesentery_rim && frame.mesentery_positions != nullptr && frame.mesentery_normals != nullptr) {
            gl_mesentery_rim->update(frame.mesentery_positions, frame.mesentery_normals, frame.version);
            start(*tissue, frame);
            tissue->setUniformValue("bump", 1.0F);
            tissue->setUniformValue("rim_fade", mesentery_fade);
            tissue->setUniformValue("two_sided", 1);
            fat.bind();
            gl_mesentery_rim->draw(gl, sight);
        }
        draw_targets(gl, frame, true);
        draw_tools(gl, frame, true);
        gl.glDisable(GL_BLEND);
    }

    void prepare_image(QSize pixels) {
        if (image && image->size() == pixels) return;
        QOpenGLFramebufferObjectFormat format;
        format.setAttachment(QOpenGLFramebufferObject::Depth);
        format.setSamples(smooth ? 4 : 0);
        image = std::make_unique<QOpenGLFramebufferObject>(pixels, format);
        resolved.reset();
        if (smooth) resolved = std::make_unique<QOpenGLFramebufferObject>(pixels);
    }

    void draw(const SceneFrame& frame, QSize size) {
        QOpenGLExtraFunctions& gl = *QOpenGLContext::currentContext()->extraFunctions();
        GLint target_buffer = 0;
        gl.glGetIntegerv(GL_FRAMEBUFFER_BINDING, &target_buffer);
        const int shorter = std::max(16, std::min(size.width(), size.height()));
        const bool hidden = !frame.notice.isEmpty();
        if (!hidden) {
            upload_changes();
            const double share = std::clamp(share_of_resolution, 0.25, 1.0);
            const auto pixels = [share](int length) {
                return std::max(16, static_cast<int>(std::lround(length * share)));
            };
            const QSize shown = frame.round ? QSize(shorter, shorter) : size;
            prepare_image(QSize(pixels(shown.width()), pixels(shown.height())));
            to_camera = camera_matrix(frame.camera);
            projection = projection_matrix(frame, shown);
            image->bind();
            gl.glViewport(0, 0, image->width(), image->height());
            draw_scene(gl, frame);
            if (resolved) QOpenGLFramebufferObject::blitFramebuffer(resolved.get(), image.get());
        }
        gl.glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(target_buffer));
        gl.glViewport(0, 0, size.width(), size.height());
        gl.glDisable(GL_DEPTH_TEST);
        gl.glDisable(GL_CULL_FACE);
        gl.glClearColor(0, 0, 0, 1);
        gl.glClear(GL_COLOR_BUFFER_BIT);
        if (hidden) return;
        if (!frame.round) {
            gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved ? resolved->handle() : image->handle());
            gl.glBlitFramebuffer(0, 0, image->width(), image->height(), 0, 0, size.width(), size.height(),
                                 GL_COLOR_BUFFER_BIT, GL_LINEAR);
            gl.glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(target_buffer));
            return;
        }
        gl.glViewport((size.width() - shorter) / 2, (size.height() - shorter) / 2, shorter, shorter);
        screen->bind();
        screen->setUniformValue("pixel", 2.0F / static_cast<float>(shorter));
        screen->setUniformValue("image", 0);
        gl.glActiveTexture(GL_TEXTURE0);
        gl.glBindTexture(GL_TEXTURE_2D, resolved ? resolved->texture() : image->texture());
        gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
        gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
        disc->draw(gl);
        gl.glViewport(0, 0, size.width(), size.height());
        gl.glBindTexture(GL_TEXTURE_2D, 0);
        screen->release();
    }
};

SceneRenderer::SceneRenderer(const RendererOptions& options) : impl_(std::make_unique<Impl>()) {
    impl_->options = options;
}
SceneRenderer::~SceneRenderer() = default;

void SceneRenderer::set_textures(const AnatomyTextures& textures) {
    impl_->textures = textures;
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

void SceneRenderer::set_bowel(const TriangleMesh& rest_surface, const std::vector<float>& taenia) {
    impl_->bowel = {make_surface(rest_surface), {}, {}, taenia, true, true};
    // The serosa's tile is two circumferences long.
    std::vector<float>& coordinates = impl_->bowel.mesh.coordinates;
    for (std::size_t i = 1; i < coordinates.size(); i += 2) coordinates[i] *= 0.5F;
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
    i.tissue = compile({s::light, s::surface_vertex}, {s::wet, s::tissue_fragment}, i.error);
    if (i.tissue)
        i.wall = compile({s::light_each_fragment, s::light, s::surface_vertex},
                         {s::light, s::wet, s::wall_fragment}, i.error);
    if (i.wall) i.plain = compile({s::light, s::surface_vertex}, {s::wet, s::plain_fragment}, i.error);
    if (i.plain) i.box = compile({s::rigid_vertex}, {s::light, s::wet, s::box_fragment}, i.error);
    if (i.box) i.steel = compile({s::rigid_vertex}, {s::light, s::wet, s::steel_fragment}, i.error);
    if (i.steel) i.target = compile({s::rigid_vertex}, {s::light, s::wet, s::target_fragment}, i.error);
    if (i.target) i.screen = compile({s::screen_vertex}, {s::screen_fragment}, i.error);
    if (!i.screen) return false;
    QOpenGLFunctions& gl = *QOpenGLContext::currentContext()->functions();
    const QByteArray device(reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER)));
    const bool software =
        device.contains("llvmpipe") || device.contains("softpipe") || device.contains("SWR");
    i.smooth = i.options.multisample || !software;
    i.coarse_pixels = software ? software_coarse_pixels : 0;
    i.share_of_resolution =
        i.options.resolution > 0 ? i.options.resolution : (software ? software_resolution : 1.0);
    i.shaft = std::make_unique<GlRigid>(make_shaft());
    i.clevis = std::make_unique<GlRigid>(make_clevis());
    i.jaw = std::make_unique<GlRigid>(make_jaw());
    i.probe_end = std::make_unique<GlRigid>(make_probe_end());
    i.sphere = std::make_unique<GlRigid>(make_sphere());
    i.room = std::make_unique<GlRigid>(make_box(0.30F, 0.34F, 0.24F));
    i.disc = std::make_unique<GlRigid>(make_screen_disc());
    i.frame_mask = std::make_unique<GlRigid>(make_frame_mask());
    i.textures_changed = true;
    for (Impl::Geometry* geometry : {&i.cavity, &i.bowel, &i.mesentery, &i.mesentery_rim, &i.reflection})
        geometry->changed = true;
    i.ready = true;
    return true;
}

const QString& SceneRenderer::error() const {
    return impl_->error;
}

void SceneRenderer::draw(const SceneFrame& frame, QSize size) {
    if (!impl_->ready && !initialise()) return;
    impl_->draw(frame, size);
}

QVector3D SceneRenderer::project(const CameraPose& camera, const Vector3& point, QSize size) {
    const QVector3D local = camera_matrix(camera).map(vector(point));
    const float radius = 0.5F * static_cast<float>(std::min(size.width(), size.height()));
    const float depth = -local.z();
    const float scale =
        radius / (std::max(1e-6F, depth) * static_cast<float>(std::tan(0.5 * camera.field_of_view)));
    return {0.5F * static_cast<float>(size.width()) + scale * local.x(),
            0.5F * static_cast<float>(size.height()) - scale * local.y(), depth};
}

void SceneRenderer::release() {
    Impl& i = *impl_;
    for (Impl::Program* program : {&i.tissue, &i.wall, &i.plain, &i.box, &i.steel, &i.target, &i.screen})
        program->reset();
    for (GlTissue* tissue : {&i.serosa, &i.fat, &i.peritoneum, &i.wall_skin, &i.metal}) *tissue = {};
    for (auto* surface : {&i.gl_cavity, &i.gl_bowel, &i.gl_mesentery, &i.gl_mesentery_rim, &i.gl_reflection})
        surface->reset();
    for (auto* part : {&i.shaft, &i.clevis, &i.jaw, &i.probe_end, &i.sphere, &i.room, &i.frame_mask, &i.disc})
        part->reset();
    for (Impl::Study& study : i.studies) {
        study.surface.reset();
        study.lines.reset();
    }
    i.image.reset();
    i.resolved.reset();
    i.ready = false;
}

}  // namespace fulcrum::ui
