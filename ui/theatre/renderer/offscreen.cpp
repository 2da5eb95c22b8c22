// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/offscreen.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <stdexcept>

namespace fulcrum::ui {

struct OffscreenStage::Impl {
    QOffscreenSurface surface;
    QOpenGLContext context;
    std::unique_ptr<QOpenGLFramebufferObject> buffer;
};

OffscreenStage::OffscreenStage() : impl_(std::make_unique<Impl>()) {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    impl_->context.setFormat(format);
    if (!impl_->context.create())
        throw std::runtime_error("no OpenGL context can be made: run it on a display, or under xvfb-run");
    impl_->surface.setFormat(impl_->context.format());
    impl_->surface.create();
    if (!impl_->surface.isValid() || !impl_->context.makeCurrent(&impl_->surface))
        throw std::runtime_error(
            "no offscreen OpenGL surface can be made: run it on a display, or under xvfb-run");
}

OffscreenStage::~OffscreenStage() {
    impl_->context.makeCurrent(&impl_->surface);
    impl_->buffer.reset();
    impl_->context.doneCurrent();
}

void OffscreenStage::make_current() {
    impl_->context.makeCurrent(&impl_->surface);
}

void OffscreenStage::draw(SceneRenderer& renderer, const SceneFrame& frame, QSize size) {
    make_current();
    if (!renderer.initialise())
        throw std::runtime_error("the renderer cannot start: " + renderer.error().toStdString());
    if (!impl_->buffer || impl_->buffer->size() != size)
        impl_->buffer = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::Depth);
    impl_->buffer->bind();
    renderer.draw(frame, size);
    impl_->context.functions()->glFinish();
}

QImage OffscreenStage::picture(SceneRenderer& renderer, const SceneFrame& frame, QSize size) {
    draw(renderer, frame, size);
    return impl_->buffer->toImage().convertToFormat(QImage::Format_RGB32);
}

QImage render_offscreen(SceneRenderer& renderer, const SceneFrame& frame, QSize size) {
    OffscreenStage stage;
    const QImage image = stage.picture(renderer, frame, size);
    renderer.release();
    return image;
}

}  // namespace fulcrum::ui
