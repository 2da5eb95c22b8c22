// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/gl_objects.h"

#include <algorithm>
#include <cmath>

#include "ui/theatre/renderer/shaders.h"

namespace fulcrum::ui {
namespace {

int bytes(std::size_t count, std::size_t size) {
    return static_cast<int>(count * size);
}

void attribute(QOpenGLExtraFunctions& gl, unsigned location, int size, int stride, std::size_t offset) {
    gl.glEnableVertexAttribArray(location);
    gl.glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, stride,
                             reinterpret_cast<const void*>(offset));
}

std::unique_ptr<QOpenGLTexture> upload(const Image& image) {
    auto texture = std::make_unique<QOpenGLTexture>(QOpenGLTexture::Target2D);
    texture->setSize(image.width, image.height);
    texture->setFormat(QOpenGLTexture::RGBA8_UNorm);
    texture->setAutoMipMapGenerationEnabled(true);
    texture->setMipLevels(texture->maximumMipLevels());
    texture->allocateStorage(QOpenGLTexture::RGBA, QOpenGLTexture::UInt8);
    texture->setData(QOpenGLTexture::RGBA, QOpenGLTexture::UInt8, image.pixels.data());
    // The nearest level, filtered within: half of what trilinear costs a processor.
    texture->setMinificationFilter(QOpenGLTexture::LinearMipMapNearest);
    texture->setMagnificationFilter(QOpenGLTexture::Linear);
    texture->setWrapMode(QOpenGLTexture::Repeat);
    return texture;
}

}  // namespace

GlSurface::GlSurface(const SurfaceMesh& mesh, const float* positions, const float* normals,
                     const std::vector<float>& detail)
    : base_(mesh.base),
      source_(mesh.source),
      copies_(3 * mesh.source.size()),
      blended_from_(mesh.blended_from),
      index_count_(mesh.indices.size()) {
    QOpenGLExtraFunctions& gl = *QOpenGLContext::currentContext()->extraFunctions();
    array_.create();
    array_.bind();
    const std::vector<float> zeros(3 * static_cast<std::size_t>(base_), 0.0F);
    for (QOpenGLBuffer* buffer : {&positions_, &normals_}) {
        buffer->create();
        buffer->setUsagePattern(QOpenGLBuffer::DynamicDraw);
        buffer->bind();
        buffer->allocate(bytes(3 * mesh.vertices(), sizeof(float)));
        const float* given = buffer == &positions_ ? positions : normals;
        fill(*buffer, given != nullptr ? given : zeros.data());
        attribute(gl, buffer == &positions_ ? 0 : 1, 3, 0, 0);
    }
    coordinates_.create();
    coordinates_.bind();
    coordinates_.allocate(mesh.coordinates.data(), bytes(mesh.coordinates.size(), sizeof(float)));
    attribute(gl, 2, 2, 0, 0);
    std::vector<float> all = detail;
    all.resize(base_, 0.0F);
    for (const std::uint32_t vertex : source_) all.push_back(all[vertex]);
    detail_.create();
    detail_.bind();
    detail_.allocate(all.data(), bytes(all.size(), sizeof(float)));
    attribute(gl, 3, 1, 0, 0);
    indices_.create();
    indices_.bind();
    indices_.allocate(mesh.indices.data(), bytes(mesh.indices.size(), sizeof(std::uint32_t)));
    array_.release();

    constexpr std::size_t run_length = 3 * 400;
    for (const std::uint32_t index : mesh.indices)
        sources_of_indices_.push_back(index < base_ ? index : source_[index - base_]);
    const std::pair<std::size_t, std::size_t> parts[] = {{0, blended_from_}, {blended_from_, index_count_}};
    for (const auto& part : parts) {
        for (std::size_t first = part.first; first < part.second; first += run_length)
            runs_.push_back({first, std::min(first + run_length, part.second), Vector3::Zero(), 0.0});
    }
    bound(positions != nullptr ? positions : zeros.data());
}

void GlSurface::bound(const float* positions) {
    for (Run& run : runs_) {
        Eigen::Vector3f low = Eigen::Vector3f::Constant(1e9F), high = -low;
        // Neighbouring triangles share vertices: every seventh corner is dense enough for a box with a
        // margin.
        for (std::size_t i = run.first; i < run.last; i += 7) {
            const float* p = positions + 3 * sources_of_indices_[i];
            const Eigen::Vector3f point(p[0], p[1], p[2]);
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
        }
        constexpr double margin = 0.008;  // m
        run.centre = (0.5F * (low + high)).cast<double>();
        run.radius = 0.5 * static_cast<double>((high - low).norm()) + margin;
    }
}

void GlSurface::fill(QOpenGLBuffer& buffer, const float* values) {
    const int own = bytes(3 * static_cast<std::size_t>(base_), sizeof(float));
    buffer.write(0, values, own);
    if (source_.empty()) return;
    for (std::size_t i = 0; i < source_.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) copies_[3 * i + c] = values[3 * source_[i] + c];
    }
    buffer.write(own, copies_.data(), bytes(copies_.size(), sizeof(float)));
}

void GlSurface::update(const float* positions, const float* normals) {
    positions_.bind();
    fill(positions_, positions);
    normals_.bind();
    fill(normals_, normals);
    normals_.release();
    bound(positions);
}

void GlSurface::draw(QOpenGLExtraFunctions& gl, std::size_t first, std::size_t last, const Sight& sight) {
    const double sine = std::sin(sight.half_angle), cosine = std::cos(sight.half_angle);
    array_.bind();
    std::size_t from = 0, to = 0;
    const auto flush = [&]() {
        if (from < to) {
            gl.glDrawElements(GL_TRIANGLES, static_cast<int>(to - from), GL_UNSIGNED_INT,
                              reinterpret_cast<const void*>(from * sizeof(std::uint32_t)));
        }
    };
    for (const Run& run : runs_) {
        if (run.first < first || run.last > last) continue;
        // Distance of the ball's centre from the cone's surface, positive outside.
        const Vector3 to_centre = run.centre - sight.eye;
        const double ahead = to_centre.dot(sight.forward);
        const double aside = (to_centre - ahead * sight.forward).norm();
        if (aside * cosine - ahead * sine > run.radius || ahead < -run.radius) continue;
        if (run.first != to) {
            flush();
            from = run.first;
        }
        to = run.last;
    }
    flush();
    array_.release();
}

GlRigid::GlRigid(const RigidMesh& mesh) : index_count_(static_cast<int>(mesh.indices.size())) {
    QOpenGLExtraFunctions& gl = *QOpenGLContext::currentContext()->extraFunctions();
    array_.create();
    array_.bind();
    vertices_.create();
    vertices_.bind();
    vertices_.allocate(mesh.vertices.data(), bytes(mesh.vertices.size(), sizeof(float)));
    constexpr int stride = 8 * sizeof(float);
    attribute(gl, 0, 3, stride, 0);
    attribute(gl, 1, 3, stride, 3 * sizeof(float));
    attribute(gl, 2, 2, stride, 6 * sizeof(float));
    indices_.create();
    indices_.bind();
    indices_.allocate(mesh.indices.data(), bytes(mesh.indices.size(), sizeof(std::uint32_t)));
    array_.release();
}

void GlRigid::draw(QOpenGLExtraFunctions& gl) {
    array_.bind();
    gl.glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
    array_.release();
}

void GlTissue::bind() const {
    albedo->bind(0);
    relief->bind(1);
}

GlTissue upload(const TissueTexture& texture) {
    return {upload(texture.albedo), upload(texture.normal)};
}

std::unique_ptr<QOpenGLShaderProgram> compile(std::initializer_list<const char*> vertex,
                                              std::initializer_list<const char*> fragment, QString& error) {
    const auto joined = [](std::initializer_list<const char*> parts) {
        QByteArray source(shaders::head);
        for (const char* part : parts) source += part;
        return source;
    };
    auto program = std::make_unique<QOpenGLShaderProgram>();
    if (program->addShaderFromSourceCode(QOpenGLShader::Vertex, joined(vertex)) &&
        program->addShaderFromSourceCode(QOpenGLShader::Fragment, joined(fragment)) && program->link())
        return program;
    error = program->log();
    return nullptr;
}

}  // namespace fulcrum::ui
