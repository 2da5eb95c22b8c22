// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "ui/theatre/renderer/scene_renderer_parts.h"
#include "ui/theatre/renderer/scene_views.h"

namespace fulcrum::ui {
namespace {

constexpr int most_tools = 4;
constexpr float areolar_tile = 0.040F, peritoneum_tile = 0.120F, fat_tile = 0.060F;  // m

}  // namespace

void SceneRenderer::Impl::take(Geometry& geometry, std::unique_ptr<GlSurface>& surface) const {
    if (!geometry.changed) return;
    geometry.changed = false;
    surface.reset();
    if (!geometry.present) return;
    surface = std::make_unique<GlSurface>(
        geometry.mesh, geometry.positions.empty() ? nullptr : geometry.positions.data(),
        geometry.normals.empty() ? nullptr : geometry.normals.data(), geometry.detail);
}

void SceneRenderer::Impl::upload_changes() {
    if (!textures) textures = make_textures(1, options.texture_size);
    if (textures_changed) {
        serosa = upload(textures->serosa);
        fat = upload(textures->fat);
        peritoneum = upload(textures->peritoneum);
        metal = upload(textures->steel);
        areolar = {};
        if (sheet_texture) areolar = upload(*sheet_texture);
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

void SceneRenderer::Impl::start(QOpenGLShaderProgram& program, const SceneFrame& frame) const {
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
        const double length = tool.jaws() ? tool.jaw_length : 4 * tool.shaft_radius;
        const QVector3D tip = to_camera.map(vector(tool.pose.tip));
        const QVector3D heel = to_camera.map(vector(tool.pose.tip - 1.6 * length * tool.pose.axis));
        // Open jaws shade less of what lies between them.
        from[count] = QVector4D(heel, 1.0F);
        to[count] = QVector4D(
            tip, static_cast<float>(2.1 * tool.shaft_radius + 0.15 * tool.jaw_length * tool.pose.jaw_angle));
        strains[count] = static_cast<float>(std::clamp(tool.strain, 0.0, 1.0));
        ++count;
    }
    program.setUniformValueArray("shadow_from", from, most_tools);
    program.setUniformValueArray("shadow_to", to, most_tools);
    program.setUniformValue("strain", QVector4D(strains[0], strains[1], strains[2], strains[3]));
    program.setUniformValue("shadows", count);
}

void SceneRenderer::Impl::draw_part(QOpenGLExtraFunctions& gl, GlRigid& part, const QMatrix4x4& pose) const {
    steel->setUniformValue("to_camera", to_camera * pose);
    part.draw(gl);
}

void SceneRenderer::Impl::draw_tool(QOpenGLExtraFunctions& gl, const DrawnTool& tool) const {
    if (!tool.pose.inside) return;
    const QVector4D tint = tool.ghost ? QVector4D(0.55F, 0.85F, 1.0F, 0.55F) : QVector4D(1, 1, 1, 1);
    steel->setUniformValue("tint", tint);
    const auto radius = static_cast<float>(tool.shaft_radius);
    const auto jaw_length = static_cast<float>(tool.jaws() ? tool.jaw_length : 0);
    const auto whole = static_cast<float>((tool.pose.tip - tool.pose.trocar).norm());
    QMatrix4x4 hinge;
    hinge.translate(vector(tool.pose.tip));
    hinge.rotate(quaternion(tool.pose.orientation));
    hinge.translate(0, 0, -jaw_length);
    // The insulation ends a little before the jaws; the steel shows there.
    const float bare = tool.jaws() ? 0.012F : 0.020F;
    QMatrix4x4 black = hinge;
    black.translate(0, 0, -whole - 0.05F);
    black.scale(radius, radius, std::max(0.001F, whole + 0.05F - bare));
    steel->setUniformValue("insulated", 1.0F);
    draw_part(gl, *shaft, black);
    steel->setUniformValue("insulated", 0.0F);
    QMatrix4x4 steel_end = hinge;
    steel_end.translate(0, 0, -bare - 0.001F);
    steel_end.scale(0.86F * radius, 0.86F * radius, bare - (tool.jaws() ? radius : 3 * radius) + 0.001F);
    draw_part(gl, *shaft, steel_end);
    if (!tool.jaws()) {
        QMatrix4x4 end = hinge;
        end.scale(0.86F * radius);
        draw_part(gl, tool.end == ToolEnd::hook ? *hook : *probe_end, end);
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
        // Scissors' blades are slimmer than jaws.
        const float slim = tool.end == ToolEnd::scissors ? 0.55F : 1.0F;
        blade.scale(slim * jaw_length, slim * jaw_length, jaw_length);
        draw_part(gl, *jaw, blade);
    }
}

void SceneRenderer::Impl::draw_tools(QOpenGLExtraFunctions& gl, const SceneFrame& frame, bool ghosts) const {
    start(*steel, frame);
    metal.bind();
    for (const DrawnTool& tool : frame.tools) {
        if (tool.ghost == ghosts) draw_tool(gl, tool);
    }
}

void SceneRenderer::Impl::draw_targets(QOpenGLExtraFunctions& gl, const SceneFrame& frame,
                                       bool translucent) const {
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
        const float stripes = item.look > TargetLook::done ? 0.0F : item.hand == Hand::left ? 1.0F : 2.0F;
        target->setUniformValue("bands", stripes);
        sphere->draw(gl);
    }
}

void SceneRenderer::Impl::draw_sheets(QOpenGLExtraFunctions& gl, const SceneFrame& frame) {
    if (frame.sheets.empty()) return;
    start(*sheet, frame);
    sheet->setUniformValue("cut_hue", QVector3D(0.86F, 0.66F, 0.50F));
    sheet->setUniformValue("fat", 2);
    sheet->setUniformValue("fat_tile", fat_tile);
    const SheetWear own = areolar.albedo ? SheetWear::own : SheetWear::peritoneum;
    std::optional<SheetWear> worn;
    while (gl_sheets.size() < frame.sheets.size()) gl_sheets.push_back(std::make_unique<GlSheet>());
    for (std::size_t k = 0; k < frame.sheets.size(); ++k) {
        const DrawnSheet& drawn = frame.sheets[k];
        const SheetWear wear = drawn.wear == SheetWear::own ? own : drawn.wear;
        if (worn != wear) {
            gl.glActiveTexture(GL_TEXTURE2);
            fat.albedo->bind();
            (wear == SheetWear::own ? areolar : wear == SheetWear::fat ? fat : peritoneum).bind();
            sheet->setUniformValue("tile", wear == SheetWear::own   ? areolar_tile
                                           : wear == SheetWear::fat ? fat_tile
                                                                    : peritoneum_tile);
            worn = wear;
        }
        sheet->setUniformValue("bump", drawn.relief);
        sheet->setUniformValue("fibres", drawn.fibres ? 1.0F : 0.0F);
        sheet->setUniformValue("fat_from", static_cast<float>(drawn.fat_from));
        const QVector3D from = vector(drawn.mark_from), to = vector(drawn.mark_to);
        sheet->setUniformValue("mark_from_to", QVector4D(from.x(), from.y(), to.x(), to.y()));
        sheet->setUniformValue("tint", QVector4D(drawn.tint, drawn.tint_share));
        gl_sheets[k]->update(drawn.surface, drawn.version);
        gl_sheets[k]->draw(gl);
    }
}

void SceneRenderer::Impl::draw_studies(QOpenGLExtraFunctions& gl, const SceneFrame& frame,
                                       const GlSurface::Sight& sight) {
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

void SceneRenderer::Impl::draw_scene(QOpenGLExtraFunctions& gl, const SceneFrame& frame) {
    GlSurface::Sight sight;
    sight.eye = frame.camera.position;
    sight.forward = -(frame.camera.orientation * Vector3::UnitZ());
    sight.half_angle = 0.5 * frame.camera.field_of_view;
    if (coarse_pixels > 0)
        sight.coarse_edge_at_1m = coarse_pixels * 2 * std::tan(sight.half_angle) / image->height();
    for (const DrawnTool& tool : frame.tools) {
        if (tool.pose.inside) sight.touched.push_back(tool.pose.tip - 0.5 * tool.jaw_length * tool.pose.axis);
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
    draw_sheets(gl, frame);
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
    } else if (studies.empty() && !frame.enclosed) {
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

void SceneRenderer::Impl::prepare_image(QSize pixels) {
    if (image && image->size() == pixels) return;
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::Depth);
    format.setSamples(smooth ? 4 : 0);
    image = std::make_unique<QOpenGLFramebufferObject>(pixels, format);
    resolved.reset();
    if (smooth) resolved = std::make_unique<QOpenGLFramebufferObject>(pixels);
}

void SceneRenderer::Impl::draw(const SceneFrame& frame, QSize size) {
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

}  // namespace fulcrum::ui
