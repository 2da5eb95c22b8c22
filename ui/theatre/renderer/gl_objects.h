// SPDX-License-Identifier: GPL-3.0-or-later
// What lives in the OpenGL context. Every function needs it current.
#pragma once

#include <QOpenGLBuffer>
#include <QOpenGLExtraFunctions>
#include <QOpenGLShaderProgram>
#include <QOpenGLTexture>
#include <QOpenGLVertexArrayObject>
#include <memory>

#include "sim_core/anatomy/anatomy.h"
#include "ui/theatre/renderer/surface_mesh.h"
#include "ui/theatre/renderer/tool_mesh.h"

namespace fulcrum::ui {

/// A tissue surface: positions and normals change every picture, or never.
class GlSurface {
  public:
    /// positions, normals: of the mesh's own vertices; null: zeros until update(). detail: one a vertex, may
    /// be empty.
    GlSurface(const SurfaceMesh& mesh, const float* positions, const float* normals,
              const std::vector<float>& detail);
    void update(const float* positions, const float* normals);
    /// What of the surface may be seen: a cone from the eye, patient frame. Whole runs of triangles outside
    /// are left out.
    struct Sight {
        Vector3 eye = Vector3::Zero(), forward = -Vector3::UnitZ();
        double half_angle = 0.6;  ///< rad
    };
    /// Triangles whose indices lie in [first, last).
    void draw(QOpenGLExtraFunctions& gl, std::size_t first, std::size_t last, const Sight& sight);
    std::size_t blended_from() const { return blended_from_; }
    std::size_t index_count() const { return index_count_; }

  private:
    // A run of triangles and a ball around it.
    struct Run {
        std::size_t first, last;
        Vector3 centre;
        double radius;
    };
    void fill(QOpenGLBuffer& buffer, const float* values);
    void bound(const float* positions);
    std::vector<Run> runs_;
    std::vector<std::uint32_t> sources_of_indices_;
    std::uint32_t base_;
    std::vector<std::uint32_t> source_;
    std::vector<float> copies_;
    std::size_t blended_from_, index_count_;
    QOpenGLVertexArrayObject array_;
    QOpenGLBuffer positions_{QOpenGLBuffer::VertexBuffer}, normals_{QOpenGLBuffer::VertexBuffer},
        coordinates_{QOpenGLBuffer::VertexBuffer}, detail_{QOpenGLBuffer::VertexBuffer},
        indices_{QOpenGLBuffer::IndexBuffer};
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

GlTissue upload(const TissueTexture& texture);

/// Null with a message in `error` where it does not compile.
std::unique_ptr<QOpenGLShaderProgram> compile(std::initializer_list<const char*> vertex,
                                              std::initializer_list<const char*> fragment, QString& error);

}  // namespace fulcrum::ui
