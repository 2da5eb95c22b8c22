// SPDX-License-Identifier: GPL-3.0-or-later
// What lives in the OpenGL context. Every function needs it current.
#pragma once

#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLTexture>
#include <QOpenGLVertexArrayObject>
#include <functional>
#include <memory>

#include "sim_core/anatomy/anatomy.h"
#include "ui/theatre/renderer/sheet_mesh.h"
#include "ui/theatre/renderer/surface_mesh.h"
#include "ui/theatre/renderer/tool_mesh.h"

namespace fulcrum::ui {

/// A tissue surface: positions and normals change every picture, or never.
class GlSurface {
  public:
    /// positions, normals: of the mesh's own vertices; null: zeros until update(). detail: one a vertex, may
    /// be empty.
    GlSurface(SurfaceMesh mesh, const float* positions, const float* normals,
              const std::vector<float>& detail);
    /// version: of the positions; the same number as last time, not 0: nothing is to be done.
    void update(const float* positions, const float* normals, std::uint64_t version);
    /// Leaves out the mesh's triangles that have a 1 here; null: none.
    void hide(const std::uint8_t* hidden);
    /// What of the surface may be seen, a cone from the eye, and how finely it is worth drawing. Patient
    /// frame.
    struct Sight {
        Vector3 eye = Vector3::Zero(), forward = -Vector3::UnitZ();
        double half_angle = 0.6;  ///< rad
        /// Coarse triangles with edges up to this long at a distance of 1 m may be drawn, m; 0: none.
        double coarse_edge_at_1m = 0;
        std::vector<Vector3>
            touched;  ///< places around which the surface has dents and small shadows: fine there
        bool round =
            false;  ///< the eye is inside of the surface and far from it: coarse but for what is touched
    };
    /// Nearest first. Whole bands outside the cone are left out.
    void draw(QOpenGLExtraFunctions& gl, const Sight& sight);
    std::size_t drawn_triangles() const { return chosen_.size() / 3; }

  private:
    // A ball around a band.
    struct Ball {
        Vector3 centre;
        double radius;
    };
    void fill(QOpenGLBuffer& buffer, const float* values);
    void bound(const float* positions);
    bool is_touched(std::size_t band, const Sight& sight) const;
    SurfaceMesh mesh_;
    std::vector<Eigen::Vector3f> samples_;   // every so many corners of the fine bands, in their order
    std::vector<std::size_t> first_sample_;  // of each band, and the end
    std::vector<Ball> balls_;
    std::vector<double> distances_;
    std::vector<std::size_t> order_;
    std::vector<std::uint8_t> hidden_;  // empty: nothing was ever hidden
    std::vector<std::uint32_t> whole_;  // the mesh's indices with nothing hidden
    std::vector<char> divided_;         // by band: some of it is hidden; as fine as it is made
    std::vector<char> fine_;
    std::vector<std::uint32_t> chosen_;
    std::vector<float> copies_;
    std::uint64_t version_ = 0;
    QOpenGLVertexArrayObject array_;
    QOpenGLBuffer positions_{QOpenGLBuffer::VertexBuffer}, normals_{QOpenGLBuffer::VertexBuffer},
        coordinates_{QOpenGLBuffer::VertexBuffer}, detail_{QOpenGLBuffer::VertexBuffer},
        indices_{QOpenGLBuffer::IndexBuffer};
};

/// A sheet whose vertices and triangles may be others in every picture.
class GlSheet {
  public:
    GlSheet();
    /// version: as GlSurface::update.
    void update(const SheetSurface& surface, std::uint64_t version);
    /// Triangles whose ball (m, patient frame) is chosen are drawn apart, until the next update or call.
    void set_apart(const std::function<bool(const QVector3D& centre, float radius)>& chosen);
    void draw(QOpenGLExtraFunctions& gl, bool apart = false);

  private:
    SheetMesh mesh_;
    struct Ball {
        QVector3D centre;
        float radius;  // m
    };
    std::vector<Ball> balls_;  // one a triangle; empty: not asked for since the last update
    std::vector<std::uint32_t> ordered_, apart_;  // indices, those set apart last
    std::size_t first_apart_ = 0;
    std::uint64_t version_ = 0;
    QOpenGLVertexArrayObject array_;
    QOpenGLBuffer vertices_{QOpenGLBuffer::VertexBuffer}, indices_{QOpenGLBuffer::IndexBuffer};
};

/// The edges of a mesh.
class GlLines {
  public:
    explicit GlLines(const TriangleMesh& mesh);
    void draw(QOpenGLExtraFunctions& gl);

  private:
    QOpenGLVertexArrayObject array_;
    QOpenGLBuffer vertices_{QOpenGLBuffer::VertexBuffer};
    int corner_count_;
};

class GlRigid {
  public:
    explicit GlRigid(const RigidMesh& mesh);
    void draw(QOpenGLExtraFunctions& gl);

  private:
    QOpenGLVertexArrayObject array_;
    QOpenGLBuffer vertices_{QOpenGLBuffer::VertexBuffer}, indices_{QOpenGLBuffer::IndexBuffer};
    int index_count_;
};

struct GlTissue {
    std::unique_ptr<QOpenGLTexture> albedo, relief;
    /// Albedo on unit 0, relief on unit 1.
    void bind() const;
};

/// RGBA images, which repeat.
GlTissue upload(const TissueTexture& texture);

/// Null with a message in `error` where it does not compile.
std::unique_ptr<QOpenGLShaderProgram> compile(std::initializer_list<const char*> vertex,
                                              std::initializer_list<const char*> fragment, QString& error);

}  // namespace fulcrum::ui
