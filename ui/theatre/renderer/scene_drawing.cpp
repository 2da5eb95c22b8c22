// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "ui/theatre/renderer/edge_smoothing.h"
#include "ui/theatre/renderer/scene_renderer_parts.h"
#include "ui/theatre/renderer/scene_views.h"
#include "ui/theatre/renderer/shared_textures.h"

namespace fulcrum::ui {
namespace {

const QVector4D ghost_tint(0.55F, 0.80F, 1.0F, 0.55F);  // sRGB and opacity at the rim

// m that the mucosa's folds stand off the wall: they hide where the mesentery reaches into it.
constexpr double folds = 0.0015;
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
    if (!textures) textures = shared_textures(1, options.texture_size);
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
    program.setUniformValueArray("shadow_from", shadows.from, ToolShadows::most);
    program.setUniformValueArray("shadow_to", shadows.to, ToolShadows::most);
    program.setUniformValue("strain", shadows.strain);
}

void SceneRenderer::Impl::draw_tools(QOpenGLExtraFunctions& gl, const SceneFrame& frame, Tools which) {
    tool_parts.clear();
    for (const DrawnTool& tool : frame.tools) {
        const Tools own = !tool.ghost ? Tools::solid : tool.through ? Tools::seen_through : Tools::ghosts;
        if (own == which) add_tool_parts(tool, tool_parts);
    }
    if (tool_parts.empty()) return;
    if (which == Tools::seen_through) gl.glDisable(GL_DEPTH_TEST);
    gl.glEnable(GL_CULL_FACE);
    gl.glCullFace(GL_BACK);
    const auto draw_with = [&](QOpenGLShaderProgram& program, const auto& chosen) {
        start(program, frame);
        if (&program == ghost.get()) program.setUniformValue("tint", ghost_tint);
        for (const ToolPart& part : tool_parts) {
            if (!chosen(part)) continue;
            program.setUniformValue("to_camera", to_camera * part.pose);
            if (&program == steel.get()) program.setUniformValue("hue", part.hue);
            shapes[static_cast<std::size_t>(part.shape)]->draw(gl);
        }
    };
    if (which != Tools::solid) {
        draw_with(*ghost, [](const ToolPart&) { return true; });
    } else {
        draw_with(*insulated, [](const ToolPart& part) { return part.insulated; });
        metal.bind();
        draw_with(*steel, [](const ToolPart& part) { return !part.insulated; });
    }
    gl.glEnable(GL_DEPTH_TEST);
    gl.glDisable(GL_CULL_FACE);
}

void SceneRenderer::Impl::draw_targets(QOpenGLExtraFunctions& gl, const SceneFrame& frame,
                                       bool translucent) const {
    if (frame.targets.empty()) return;
    start(*target, frame);
    gl.glEnable(GL_CULL_FACE);
    gl.glCullFace(GL_BACK);
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
        shapes[static_cast<std::size_t>(ToolShape::ball)]->draw(gl);
    }
    gl.glDisable(GL_CULL_FACE);
}

void SceneRenderer::Impl::draw_tubes(QOpenGLExtraFunctions& gl, const SceneFrame& frame) const {
    if (frame.tubes.empty()) return;
    start(*target, frame);
    target->setUniformValue("glow", 0.0F);
    target->setUniformValue("opacity", 1.0F);
    target->setUniformValue("bands", 0.0F);
    gl.glEnable(GL_CULL_FACE);
    gl.glCullFace(GL_BACK);
    for (const DrawnTube& tube : frame.tubes) {
        const Vector3 way = tube.to - tube.from;
        const auto radius = static_cast<float>(tube.radius);
        QMatrix4x4 end, pose;
        end.translate(vector(tube.to));
        end.scale(radius);
        pose.translate(vector(tube.from));
        pose.rotate(quaternion(Quaternion::FromTwoVectors(Vector3::UnitZ(), way)));
        pose.scale(radius, radius, static_cast<float>(way.norm()));
        target->setUniformValue("hue", tube.hue);
        target->setUniformValue("to_camera", to_camera * pose);
        shapes[static_cast<std::size_t>(ToolShape::shaft)]->draw(gl);
        target->setUniformValue("to_camera", to_camera * end);
        shapes[static_cast<std::size_t>(ToolShape::ball)]->draw(gl);
    }
    gl.glDisable(GL_CULL_FACE);
}

QOpenGLShaderProgram& SceneRenderer::Impl::program_of(const DrawnSheet& drawn, bool shaded) const {
    if (shaded) return *shaded_sheet;
    if (drawn.fibres) return *fibres;
    if (drawn.wear == SheetWear::bowel) return *bowel_wall;
    if (drawn.large) return *large_sheet;
    return drawn.mark_from == drawn.mark_to ? *sheet : *marked_sheet;
}

void SceneRenderer::Impl::wear_tissue(QOpenGLShaderProgram& program, SheetWear wear) const {
    switch (wear) {
        case SheetWear::own:
            areolar.bind();
            program.setUniformValue("tile", areolar_tile);
            break;
        case SheetWear::fat:
            fat.bind();
            program.setUniformValue("tile", fat_tile);
            break;
        case SheetWear::peritoneum:
            peritoneum.bind();
            program.setUniformValue("tile", peritoneum_tile);
            break;
        case SheetWear::bowel:
            serosa.bind();
            program.setUniformValue("tile", 1.0F);
            break;
    }
}

void SceneRenderer::Impl::draw_bowel(QOpenGLExtraFunctions& gl, const SceneFrame& frame,
                                     const GlSurface::Sight& sight) {
    gl_bowel->update(frame.bowel_positions, frame.bowel_normals, frame.version);
    gl_bowel->hide(frame.bowel_hidden);
    start(*tissue, frame);
    tissue->setUniformValue("bump", 1.0F);
    tissue->setUniformValue("rim_fade", 0.0F);
    tissue->setUniformValue("two_sided", 0);
    serosa.bind();
    gl.glCullFace(GL_BACK);
    gl_bowel->draw(gl, sight);
    if (frame.bowel_hidden == nullptr) return;
    // Through an opening its inner face is seen.
    start(*lumen, frame);
    lumen->setUniformValue("bump", 1.0F);
    lumen->setUniformValue("thickness", static_cast<float>(frame.bowel_thickness + folds));
    wear_tissue(*lumen, SheetWear::bowel);
    gl.glCullFace(GL_FRONT);
    gl_bowel->draw(gl, sight);
}

void SceneRenderer::Impl::draw_sheets(QOpenGLExtraFunctions& gl, const SceneFrame& frame) {
    const SheetWear own = areolar.albedo ? SheetWear::own : SheetWear::peritoneum;
    const QOpenGLShaderProgram* used = nullptr;
    std::optional<SheetWear> worn;
    while (gl_sheets.size() < frame.sheets.size()) gl_sheets.push_back(std::make_unique<GlSheet>());
    // What lies nearest is drawn first: of what it hides nothing is shaded.
    sheet_order.clear();
    for (std::size_t k = 0; k < frame.sheets.size(); ++k) {
        gl_sheets[k]->update(frame.sheets[k].surface, frame.sheets[k].version);
        if (frame.sheets[k].large) {
            gl_sheets[k]->set_apart([this](const QVector3D& centre, float radius) {
                return shadows.may_vary_in(centre, radius);
            });
            sheet_order.push_back({k, true});
        }
        sheet_order.push_back({k, false});
    }
    std::stable_sort(sheet_order.begin(), sheet_order.end(), [&](const SheetPart& a, const SheetPart& b) {
        return frame.sheets[a.sheet].order < frame.sheets[b.sheet].order;
    });
    for (const auto& [k, shaded] : sheet_order) {
        const DrawnSheet& drawn = frame.sheets[k];
        QOpenGLShaderProgram& program = program_of(drawn, shaded);
        if (used != &program) {
            start(program, frame);
            program.setUniformValue("cut_hue", QVector3D(0.86F, 0.66F, 0.50F));
            used = &program;
            worn.reset();
        }
        const SheetWear wear = drawn.wear == SheetWear::own ? own : drawn.wear;
        if (worn != wear) {
            wear_tissue(program, wear);
            worn = wear;
        }
        if (drawn.fibres) {
            fat.albedo->bind(2);
            program.setUniformValue("fat", 2);
            program.setUniformValue("fat_tile", fat_tile);
            program.setUniformValue("fat_from", static_cast<float>(drawn.fat_from));
        }
        program.setUniformValue("bump", drawn.relief);
        if (&program == marked_sheet.get()) {
            const QVector3D from = vector(drawn.mark_from), to = vector(drawn.mark_to);
            program.setUniformValue("mark_from_to", QVector4D(from.x(), from.y(), to.x(), to.y()));
        }
        program.setUniformValue("tint", QVector4D(drawn.tint, drawn.tint_share));
        gl_sheets[k]->draw(gl, shaded);
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
        mask->bind();
        frame_mask->draw(gl);
    }
    gl.glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);

    draw_tools(gl, frame, Tools::solid);
    draw_targets(gl, frame, false);
    draw_tubes(gl, frame);
    draw_studies(gl, frame, sight);
    draw_sheets(gl, frame);
    gl.glEnable(GL_CULL_FACE);
    if (gl_bowel && frame.bowel_positions != nullptr && frame.bowel_normals != nullptr)
        draw_bowel(gl, frame, sight);
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
    draw_translucent(gl, frame, sight);
}

void SceneRenderer::Impl::draw_translucent(QOpenGLExtraFunctions& gl, const SceneFrame& frame,
                                           const GlSurface::Sight& sight) {
    gl.glDisable(GL_CULL_FACE);
    gl.glEnable(GL_BLEND);
    // What is drawn opaque keeps its mark (edge_smoothing.h).
    gl.glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
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
    draw_tools(gl, frame, Tools::ghosts);
    draw_tools(gl, frame, Tools::seen_through);
    gl.glDisable(GL_BLEND);
}

void SceneRenderer::Impl::prepare_image(QSize extent) {
    if (image && image->size() == extent) return;
    QOpenGLFramebufferObjectFormat format;
    format.setAttachment(QOpenGLFramebufferObject::Depth);
    const bool multisample = quality.smoothing == Smoothing::multisample;
    format.setSamples(multisample ? 4 : 0);
    image = std::make_unique<QOpenGLFramebufferObject>(extent, format);
    resolved.reset();
    if (multisample) resolved = std::make_unique<QOpenGLFramebufferObject>(extent);
}

const QImage& SceneRenderer::Impl::draw(const SceneFrame& frame, QSize size) {
    QOpenGLExtraFunctions& gl = *QOpenGLContext::currentContext()->extraFunctions();
    upload_changes();
    const int shorter = std::max(16, std::min(size.width(), size.height()));
    const double full = frame.enclosed ? quality.share_in_hollow : quality.share;
    const double drawn = std::clamp(share * full, 0.25, 1.0);
    const auto scaled = [drawn](int length) {
        return std::max(16, static_cast<int>(std::lround(length * drawn)));
    };
    const QSize shown = frame.round ? QSize(shorter, shorter) : size;
    prepare_image(QSize(scaled(shown.width()), scaled(shown.height())));
    to_camera = camera_matrix(frame.camera);
    shadows = tool_shadows(frame, to_camera);
    projection = projection_matrix(frame, shown);
    image->bind();
    gl.glViewport(0, 0, image->width(), image->height());
    draw_scene(gl, frame);
    if (resolved) QOpenGLFramebufferObject::blitFramebuffer(resolved.get(), image.get());
    read_pixels(gl);
    return pixels;
}

void SceneRenderer::Impl::read_pixels(QOpenGLExtraFunctions& gl) {
    const QSize extent = image->size();
    if (upside_down.size() != extent) upside_down = QImage(extent, QImage::Format_RGB32);
    pixels = QImage(extent, QImage::Format_RGB32);
    gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved ? resolved->handle() : image->handle());
    gl.glReadPixels(0, 0, extent.width(), extent.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
                    upside_down.bits());
    if (quality.smoothing == Smoothing::edges) {
        copy_with_smooth_edges(upside_down, pixels);
    } else {
        copy_upright(upside_down, pixels);
    }
}

}  // namespace fulcrum::ui
