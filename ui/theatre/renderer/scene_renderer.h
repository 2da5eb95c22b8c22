// SPDX-License-Identifier: GPL-3.0-or-later
// Draws what the laparoscope sees: a round image in a black frame, lit from the scope alone (product, Look).
//
// OpenGL 3.3 core. Every call but the constructor needs the same current context; one thread. Draws into a
// framebuffer of its own and hands the pixels out, which scope_picture.h puts into the round frame. Lengths
// in m, patient frame; angles in rad; colours are sRGB.
#pragma once

#include <QImage>
#include <QSize>
#include <QString>
#include <QVector3D>
#include <memory>
#include <vector>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/world/part/snapshot.h"
#include "ui/theatre/renderer/sheet_mesh.h"

namespace fulcrum::ui {

/// How a target sphere is shown. Colours are from a colour-blind-safe palette.
/// The first four are spheres to touch; the others are what lies among bands.
enum class TargetLook { waiting, current, touched, done, bleeding, clip };

struct DrawnTarget {
    Vector3 centre = Vector3::Zero();
    double radius = 0.006;
    TargetLook look = TargetLook::waiting;
    Hand hand = Hand::left;  ///< left: blue, right: orange
};

/// A straight tube with a round end at `to`.
struct DrawnTube {
    Vector3 from = Vector3::Zero(), to = Vector3::Zero();  ///< m
    double radius = 0;                                     ///< m
    QVector3D hue;                                         ///< sRGB
    int object = -1;                                       ///< ring that it belongs to
};

struct DrawnTool {
    ToolPose pose;  ///< shaft from the trocar to the jaws; tip = end of the jaws
    InstrumentKind kind = InstrumentKind::grasper;
    bool jaws() const { return type_of(kind).jaws; }
    double jaw_length = 0.020;     ///< m
    double shaft_radius = 0.0025;  ///< m
    double strain = 0;             ///< 0 .. 1: share of the force limit; colours the tip's contact
    bool ghost = false;            ///< translucent, casts no shadow
    bool through = false;          ///< a ghost that is seen through what is in front of it
};

/// A mesh outside of any scene, as studies leave it: an even, slightly wet surface.
struct DrawnMesh {
    TriangleMesh mesh;                         ///< m, patient frame
    QVector3D colour = {0.80F, 0.42F, 0.38F};  ///< linear RGB
    bool wireframe = false;                    ///< its edges only
    bool smooth = true;                        ///< vertex normals; false: facets show
    std::vector<float> accent;  ///< empty, or one a vertex, 0 .. 1: how much of accent_colour is mixed in
    QVector3D accent_colour = {0.10F, 0.20F, 0.75F};
};

/// What a sheet looks like: what set_sheet_texture gave, mesorectal fat, peritoneum, the bowel's serosa with
/// its coordinates and within it the wall's layers.
enum class SheetWear { own, fat, peritoneum, bowel };

/// A sheet that may be cut: its triangles change with its version.
struct DrawnSheet {
    SheetSurface surface;
    Vector3 mark_from = Vector3::Zero(),
            mark_to = Vector3::Zero();  ///< m at rest: ends of the ink line; equal: none
    std::uint64_t version = 0;          ///< as SceneFrame::version
    QVector3D tint;                     ///< linear RGB of what is not areolar tissue
    float tint_share = 0;               ///< 0 .. 1: how much of it
    SheetWear wear = SheetWear::own;
    float relief = 1;     ///< of the texture: less on a film that is drawn tight
    bool fibres = false;  ///< angel hair along y at rest: white, thinner and parting where it is stretched
    double fat_from = 0;  ///< m, y at rest above which a sheet of fibres is fat
    bool large = false;   ///< its triangles are larger than shadows: light for each fragment
    int order = 0;        ///< lower ones are drawn first: what mostly hides others
};

/// Everything one picture needs. Pointers are only read during draw().
struct SceneFrame {
    CameraPose camera;
    const float* bowel_positions = nullptr;  ///< three floats a vertex of set_bowel's mesh; null: not drawn
    const float* bowel_normals = nullptr;
    const std::uint8_t* bowel_hidden =
        nullptr;                 ///< one a triangle of set_bowel's mesh, 1: not drawn; null: it is whole
    double bowel_thickness = 0;  ///< m, of its wall, where it is not whole: one sees in
    const float* mesentery_positions = nullptr;  ///< as evaluate_mesentery gives them; null: not drawn
    const float* mesentery_normals = nullptr;
    std::uint64_t version =
        0;  ///< of the positions and normals: equal and not 0, they have not changed since the last picture
    std::vector<DrawnSheet> sheets;
    std::vector<DrawnTarget> targets;
    std::vector<DrawnTube> tubes;
    std::vector<DrawnTool> tools;
    double brightness = 1.0;            ///< of the light
    Vector3 lamp = {0, 0.0035, 0.001};  ///< m, camera space: next to the lens
    /// The round image of a scope in its black frame; false: the whole square on `background`, as a figure
    /// is.
    bool round = true;
    QVector3D background = {0.93F, 0.94F, 0.95F};  ///< sRGB
    bool enclosed = false;                         ///< the sheets close the room: no training box around them
    QString notice;  ///< not empty: the scene is hidden (pause) behind a black image
};

struct RendererOptions {
    int texture_size = 1024;  ///< width of the serosa's tile; others follow
    /// Share of the framebuffer's resolution that the scene is drawn in, 0.25 .. 1; 0: 1 on a GPU, less on a
    /// processor.
    double resolution = 0;
    bool multisample = false;  ///< 4 samples on a processor too (a GPU always takes them)
};

/// How edges are made smooth.
enum class Smoothing {
    multisample,  ///< 4 samples a pixel, everywhere
    edges,        ///< edges of instruments and targets, after drawing (edge_smoothing.h)
};

/// What a machine's picture is drawn with, and how fine.
struct PictureQuality {
    QString device;              ///< as OpenGL names it
    bool software = false;       ///< a processor draws: there is no graphics card, or none that is offered
    double share = 1;            ///< of the resolution, along each side
    double share_in_hollow = 1;  ///< the same in scenes that tissue encloses
    Smoothing smoothing = Smoothing::multisample;
};
/// With a current context.
PictureQuality picture_quality(const RendererOptions& options = {});

class SceneRenderer {
  public:
    explicit SceneRenderer(const RendererOptions& options = {});
    /// With a current context, or after release().
    ~SceneRenderer();

    // What the scene is made of. May be called before there is a context; each replaces what was set before.
    void set_textures(std::shared_ptr<const AnatomyTextures> textures);
    /// wall: what make_wall_texture gives for it; without it the renderer makes its own at the next picture.
    void set_cavity(const CavityShape& cavity, std::shared_ptr<const TissueTexture> wall = nullptr);
    /// domes: its rounded ends are seen (make_bowel_surface).
    void set_bowel(const TriangleMesh& rest_surface, const std::vector<float>& taenia, bool domes = false);
    void set_mesentery(const MesenteryShape& mesentery);
    void set_reflection(const ReflectionShape& reflection);
    /// What the frame's sheets wear; without it they wear the peritoneum.
    void set_sheet_texture(std::shared_ptr<const TissueTexture> texture);
    /// Meshes of a study, drawn together with whatever else is set and without the training box.
    void set_meshes(const std::vector<DrawnMesh>& meshes);
    /// Nothing but tools and targets (and a plain training box around them).
    void clear_scene();

    /// Compiles the shaders. False where the context cannot: error() says why.
    bool initialise();
    const QString& error() const;

    /// Share of the resolution that the options say, from the next picture on; 1 at first.
    void set_share(double share);

    /// Draws for a rectangle of that size in device pixels and waits until it is done. The pixels as drawn,
    /// at the share of the resolution that the options and set_share say: of the round image the square
    /// around it, which is as high as the rectangle; else the whole rectangle. Null where the notice hides
    /// the scene or nothing can be drawn. Valid until the next call.
    const QImage& draw(const SceneFrame& frame, QSize size);
    /// Where a point of the patient frame appears, in pixels from the top left; z < 0: behind the camera.
    static QVector3D project(const CameraPose& camera, const Vector3& point, QSize size);

    /// Frees what lives in the context; call it while the context is current, before it goes.
    void release();

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// One picture without a window: makes its own context (software rendering will do), draws, reads back. The
/// platform must offer OpenGL (a display, or xvfb-run). Throws std::runtime_error where there is none.
QImage render_offscreen(SceneRenderer& renderer, const SceneFrame& frame, QSize size);

}  // namespace fulcrum::ui
