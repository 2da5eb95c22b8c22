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

GlSurface::GlSurface(SurfaceMesh mesh, const float* positions, const float* normals,
                     const std::vector<float>& detail)
    : mesh_(std::move(mesh)), copies_(3 * mesh_.source.size()) {
    QOpenGLExtraFunctions& gl = *QOpenGLContext::currentContext()->extraFunctions();
    array_.create();
    array_.bind();
    const std::vector<float> zeros(3 * static_cast<std::size_t>(mesh_.base), 0.0F);
    for (QOpenGLBuffer* buffer : {&positions_, &normals_}) {
        buffer->create();
        buffer->setUsagePattern(QOpenGLBuffer::DynamicDraw);
        buffer->bind();
        buffer->allocate(bytes(3 * mesh_.vertices(), sizeof(float)));
        const float* given = buffer == &positions_ ? positions : normals;
        fill(*buffer, given != nullptr ? given : zeros.data());
        attribute(gl, buffer == &positions_ ? 0 : 1, 3, 0, 0);
    }
    coordinates_.create();
    coordinates_.bind();
    coordinates_.allocate(mesh_.coordinates.data(), bytes(mesh_.coordinates.size(), sizeof(float)));
    attribute(gl, 2, 2, 0, 0);
    std::vector<float> all = detail;
    all.resize(mesh_.base, 0.0F);
    for (const std::uint32_t vertex : mesh_.source) all.push_back(all[vertex]);
    detail_.create();
    detail_.bind();
    detail_.allocate(all.data(), bytes(all.size(), sizeof(float)));
    attribute(gl, 3, 1, 0, 0);
    indices_.create();
    indices_.setUsagePattern(QOpenGLBuffer::StreamDraw);
    indices_.bind();
    array_.release();
    balls_.resize(mesh_.bands.size());
    first_sample_.resize(mesh_.bands.size() + 1);
    samples_.reserve(mesh_.indices.size() / 7 + mesh_.bands.size());
    distances_.resize(mesh_.bands.size());
    fine_.resize(mesh_.bands.size());
    order_.reserve(mesh_.bands.size());
    chosen_.reserve(mesh_.indices.size());
    bound(positions != nullptr ? positions : zeros.data());
}

bool GlSurface::is_touched(std::size_t band, const Sight& sight) const {
    constexpr double reach = 0.02;  // m: a dent, or the shadow of jaws
    for (const Vector3& place : sight.touched) {
        if ((place - balls_[band].centre).norm() > balls_[band].radius + reach) continue;
        const Eigen::Vector3f point = place.cast<float>();
        for (std::size_t s = first_sample_[band]; s < first_sample_[band + 1]; ++s) {
            if ((samples_[s] - point).squaredNorm() < static_cast<float>(reach * reach)) return true;
        }
    }
    return false;
}

void GlSurface::bound(const float* positions) {
    samples_.clear();
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        first_sample_[b] = samples_.size();
        Eigen::Vector3f low = Eigen::Vector3f::Constant(1e9F), high = -low;
        // Neighbouring triangles share vertices: every seventh corner is dense enough for a box with a
        // margin.
        for (std::size_t i = mesh_.bands[b].fine.first; i < mesh_.bands[b].fine.last; i += 7) {
            const std::uint32_t index = mesh_.indices[i];
            const float* p = positions + 3 * (index < mesh_.base ? index : mesh_.source[index - mesh_.base]);
            const Eigen::Vector3f point(p[0], p[1], p[2]);
            low = low.cwiseMin(point);
            high = high.cwiseMax(point);
            samples_.push_back(point);
        }
        constexpr double margin = 0.008;  // m
        balls_[b] = {(0.5F * (low + high)).cast<double>(),
                     0.5 * static_cast<double>((high - low).norm()) + margin};
    }
    first_sample_.back() = samples_.size();
}

void GlSurface::fill(QOpenGLBuffer& buffer, const float* values) {
    const int own = bytes(3 * static_cast<std::size_t>(mesh_.base), sizeof(float));
    buffer.write(0, values, own);
    if (mesh_.source.empty()) return;
    for (std::size_t i = 0; i < mesh_.source.size(); ++i) {
        for (std::size_t c = 0; c < 3; ++c) copies_[3 * i + c] = values[3 * mesh_.source[i] + c];
    }
    buffer.write(own, copies_.data(), bytes(copies_.size(), sizeof(float)));
}

void GlSurface::update(const float* positions, const float* normals, std::uint64_t version) {
    if (version != 0 && version == version_) return;
    version_ = version;
    positions_.bind();
    fill(positions_, positions);
    normals_.bind();
    fill(normals_, normals);
    normals_.release();
    bound(positions);
}

void GlSurface::hide(const std::uint8_t* hidden) {
    const std::size_t last = mesh_.bands.empty() ? 0 : mesh_.bands.back().fine.last / 3;
    if (hidden_.empty()) {
        if (hidden == nullptr) return;
        whole_ = mesh_.indices;
        hidden_.assign(last, 0);
        divided_.resize(mesh_.bands.size());
    }
    if (hidden != nullptr && std::equal(hidden_.begin(), hidden_.end(), hidden)) return;
    for (std::size_t b = 0; b < mesh_.bands.size(); ++b) {
        divided_[b] = 0;
        for (std::size_t t = mesh_.bands[b].fine.first / 3; t < mesh_.bands[b].fine.last / 3; ++t) {
            hidden_[t] = hidden == nullptr ? 0 : hidden[t];
            if (hidden_[t] != 0) divided_[b] = 1;
            // One corner three times is nothing to draw.
            for (std::size_t c = 0; c < 3; ++c)
                mesh_.indices[3 * t + c] = whole_[3 * t + (hidden_[t] != 0 ? 0 : c)];
        }
    }
}

void GlSurface::draw(QOpenGLExtraFunctions& gl, const Sight& sight) {
    const double sine = std::sin(sight.half_angle), cosine = std::cos(sight.half_angle);
    order_.clear();
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        const Ball& ball = balls_[b];
        // Distance of the ball's centre from the cone's surface, positive outside.
        const Vector3 to_centre = ball.centre - sight.eye;
        const double ahead = to_centre.dot(sight.forward);
        const double aside = (to_centre - ahead * sight.forward).norm();
        distances_[b] = std::max(0.0, to_centre.norm() - ball.radius);
        const bool near = mesh_.coarse_edge > sight.coarse_edge_at_1m * distances_[b] && !sight.round;
        const bool divided = !divided_.empty() && divided_[b] != 0;
        fine_[b] = near || divided || is_touched(b, sight) ? 1 : 0;
        if (aside * cosine - ahead * sine <= ball.radius && ahead >= -ball.radius) order_.push_back(b);
    }
    std::sort(order_.begin(), order_.end(), [this](std::size_t a, std::size_t b) {
        return distances_[a] != distances_[b] ? distances_[a] < distances_[b] : a < b;
    });
    chosen_.clear();
    choose_triangles(mesh_, order_, fine_, chosen_);
    if (chosen_.empty()) return;
    array_.bind();
    indices_.bind();
    indices_.allocate(chosen_.data(), bytes(chosen_.size(), sizeof(std::uint32_t)));
    gl.glDrawElements(GL_TRIANGLES, static_cast<int>(chosen_.size()), GL_UNSIGNED_INT, nullptr);
    array_.release();
}

GlSheet::GlSheet() {
    QOpenGLExtraFunctions& gl = *QOpenGLContext::currentContext()->extraFunctions();
    array_.create();
    array_.bind();
    vertices_.create();
    vertices_.setUsagePattern(QOpenGLBuffer::StreamDraw);
    vertices_.bind();
    constexpr int stride = SheetMesh::floats * sizeof(float);
    attribute(gl, 0, 3, stride, 0);
    attribute(gl, 1, 3, stride, 3 * sizeof(float));
    attribute(gl, 2, 2, stride, 6 * sizeof(float));
    attribute(gl, 3, 1, stride, 8 * sizeof(float));
    indices_.create();
    indices_.setUsagePattern(QOpenGLBuffer::StreamDraw);
    indices_.bind();
    array_.release();
}

void GlSheet::update(const SheetSurface& surface, std::uint64_t version) {
    if (version != 0 && version == version_) return;
    version_ = version;
    mesh_.build(surface);
    first_apart_ = mesh_.indices().size();
    balls_.clear();
    vertices_.bind();
    vertices_.allocate(mesh_.vertices().data(), bytes(mesh_.vertices().size(), sizeof(float)));
    vertices_.release();
    array_.bind();
    indices_.bind();
    indices_.allocate(mesh_.indices().data(), bytes(mesh_.indices().size(), sizeof(std::uint32_t)));
    array_.release();
}

void GlSheet::set_apart(const std::function<bool(const QVector3D&, float)>& chosen) {
    const std::vector<std::uint32_t>& indices = mesh_.indices();
    if (balls_.empty()) {
        const auto place = [this](std::uint32_t vertex) {
            const float* p = mesh_.vertices().data() + vertex * SheetMesh::floats;
            return QVector3D(p[0], p[1], p[2]);
        };
        for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
            const QVector3D a = place(indices[t]), b = place(indices[t + 1]), c = place(indices[t + 2]);
            const QVector3D centre = (a + b + c) / 3;
            balls_.push_back({centre, std::max({a.distanceToPoint(centre), b.distanceToPoint(centre),
                                                c.distanceToPoint(centre)})});
        }
    }
    apart_.clear();
    ordered_.clear();
    for (std::size_t t = 0; t < balls_.size(); ++t) {
        std::vector<std::uint32_t>& kept = chosen(balls_[t].centre, balls_[t].radius) ? apart_ : ordered_;
        for (std::size_t corner = 3 * t; corner < 3 * t + 3; ++corner) kept.push_back(indices[corner]);
    }
    first_apart_ = ordered_.size();
    ordered_.insert(ordered_.end(), apart_.begin(), apart_.end());
    array_.bind();
    indices_.bind();
    indices_.allocate(ordered_.data(), bytes(ordered_.size(), sizeof(std::uint32_t)));
    array_.release();
}

void GlSheet::draw(QOpenGLExtraFunctions& gl, bool apart) {
    const std::size_t first = apart ? first_apart_ : 0;
    const std::size_t last = apart ? mesh_.indices().size() : first_apart_;
    if (first == last) return;
    array_.bind();
    gl.glDrawElements(GL_TRIANGLES, static_cast<int>(last - first), GL_UNSIGNED_INT,
                      reinterpret_cast<const void*>(first * sizeof(std::uint32_t)));
    array_.release();
}

GlLines::GlLines(const TriangleMesh& mesh) {
    QOpenGLExtraFunctions& gl = *QOpenGLContext::currentContext()->extraFunctions();
    std::vector<float> corners;
    for (const Triangle& triangle : mesh.triangles) {
        for (std::size_t c = 0; c < 3; ++c) {
            const std::int32_t a = triangle[c], b = triangle[(c + 1) % 3];
            // The triangle on the other side of the edge has it the other way round.
            if (a > b) continue;
            for (const std::int32_t vertex : {a, b}) {
                const Vector3& p = mesh.vertices[static_cast<std::size_t>(vertex)];
                for (int k = 0; k < 3; ++k) corners.push_back(static_cast<float>(p[k]));
            }
        }
    }
    corner_count_ = static_cast<int>(corners.size() / 3);
    array_.create();
    array_.bind();
    vertices_.create();
    vertices_.bind();
    vertices_.allocate(corners.data(), bytes(corners.size(), sizeof(float)));
    attribute(gl, 0, 3, 0, 0);
    array_.release();
}

void GlLines::draw(QOpenGLExtraFunctions& gl) {
    array_.bind();
    gl.glDrawArrays(GL_LINES, 0, corner_count_);
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
