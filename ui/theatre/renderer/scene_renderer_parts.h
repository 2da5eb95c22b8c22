// SPDX-License-Identifier: GPL-3.0-or-later
// What the renderer keeps between pictures, and the steps of one picture. Thread of the graphics context.
// Private to the renderer.
#pragma once

#include <QMatrix4x4>
#include <QOpenGLFramebufferObject>
#include <QOpenGLShaderProgram>
#include <memory>
#include <optional>
#include <vector>

#include "ui/theatre/renderer/gl_objects.h"
#include "ui/theatre/renderer/scene_renderer.h"
#include "ui/theatre/renderer/shaders.h"
#include "ui/theatre/renderer/tool_parts.h"
#include "ui/theatre/renderer/tool_shadows.h"

namespace fulcrum::ui {

/// Share of the mesentery's width over which its root lets the wall through.
constexpr float mesentery_fade = 0.3F;

struct SceneRenderer::Impl {
    RendererOptions options;
    QString error;

    // What was set; uploaded at the next picture.
    std::shared_ptr<const AnatomyTextures> textures;
    bool textures_changed = false;
    std::shared_ptr<const TissueTexture> given_wall;
    std::shared_ptr<const TissueTexture> sheet_texture;
    CavityShape wall_shape;  // kept until its texture is made
    struct Geometry {
        SurfaceMesh mesh;
        std::vector<float> positions, normals, detail;
        bool present = false, changed = false;
    };
    Geometry cavity, bowel, mesentery, mesentery_rim, reflection;

    bool ready = false;
    PictureQuality quality;
    double share = 1;          // of its resolution
    double coarse_pixels = 0;  // coarse triangles with shorter edges than that are good enough; 0: none are
    using Program = std::unique_ptr<QOpenGLShaderProgram>;
    Program tissue, sheet, marked_sheet, fibres, bowel_wall, lumen, large_sheet, shaded_sheet, wall, plain,
        box, steel, insulated, ghost, target, mask;
    struct Study {
        DrawnMesh look;
        std::unique_ptr<GlSurface> surface;  // null: to be uploaded
        std::unique_ptr<GlLines> lines;
    };
    std::vector<Study> studies;
    GlTissue serosa, fat, peritoneum, areolar, wall_skin, metal;
    std::unique_ptr<GlSurface> gl_cavity, gl_bowel, gl_mesentery, gl_mesentery_rim, gl_reflection;
    std::vector<std::unique_ptr<GlSheet>> gl_sheets;
    std::vector<std::unique_ptr<GlRigid>> shapes;  // one a ToolShape
    std::unique_ptr<GlRigid> room, frame_mask;
    std::vector<ToolPart> tool_parts;
    struct SheetPart {
        std::size_t sheet;
        bool shaded;  // of a large one the part where instruments throw shadows
    };
    std::vector<SheetPart> sheet_order;
    std::unique_ptr<QOpenGLFramebufferObject> image, resolved;
    QImage upside_down, pixels;

    QMatrix4x4 to_camera, projection;
    ToolShadows shadows;

    void take(Geometry& geometry, std::unique_ptr<GlSurface>& surface) const;

    void upload_changes();

    void start(QOpenGLShaderProgram& program, const SceneFrame& frame) const;

    enum class Tools { solid, ghosts, seen_through };
    void draw_tools(QOpenGLExtraFunctions& gl, const SceneFrame& frame, Tools which);

    void draw_tubes(QOpenGLExtraFunctions& gl, const SceneFrame& frame) const;
    void draw_targets(QOpenGLExtraFunctions& gl, const SceneFrame& frame, bool translucent) const;

    QOpenGLShaderProgram& program_of(const DrawnSheet& drawn, bool shaded) const;

    void wear_tissue(QOpenGLShaderProgram& program, SheetWear wear) const;

    void draw_bowel(QOpenGLExtraFunctions& gl, const SceneFrame& frame, const GlSurface::Sight& sight);

    void draw_sheets(QOpenGLExtraFunctions& gl, const SceneFrame& frame);

    void draw_studies(QOpenGLExtraFunctions& gl, const SceneFrame& frame, const GlSurface::Sight& sight);

    void draw_scene(QOpenGLExtraFunctions& gl, const SceneFrame& frame);
    void draw_translucent(QOpenGLExtraFunctions& gl, const SceneFrame& frame, const GlSurface::Sight& sight);

    void prepare_image(QSize extent);

    const QImage& draw(const SceneFrame& frame, QSize size);

    /// OpenGL's first row is the lowest.
    void read_pixels(QOpenGLExtraFunctions& gl);
};

}  // namespace fulcrum::ui
