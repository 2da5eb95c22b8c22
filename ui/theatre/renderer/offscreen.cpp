// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/offscreen.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QPainter>
#include <stdexcept>

#include "sim_core/numerics/worded_error.h"
#include "ui/theatre/renderer/scope_picture.h"

namespace fulcrum::ui {

struct OffscreenStage::Impl {
    QOffscreenSurface surface;
    QOpenGLContext context;
    ScopePicture scope;
};

OffscreenStage::OffscreenStage() : impl_(std::make_unique<Impl>()) {
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    impl_->context.setFormat(format);
    if (!impl_->context.create())
        throw WordedError(QT_TRANSLATE_NOOP(
            "errors", "no OpenGL context can be made: run it on a display, or under xvfb-run"));
    impl_->surface.setFormat(impl_->context.format());
    impl_->surface.create();
    if (!impl_->surface.isValid() || !impl_->context.makeCurrent(&impl_->surface))
        throw WordedError(QT_TRANSLATE_NOOP(
            "errors", "no offscreen OpenGL surface can be made: run it on a display, or under xvfb-run"));
}

OffscreenStage::~OffscreenStage() = default;

void OffscreenStage::make_current() {
    impl_->context.makeCurrent(&impl_->surface);
}

const QImage& OffscreenStage::draw(SceneRenderer& renderer, const SceneFrame& frame, QSize size) {
    make_current();
    if (!renderer.initialise())
        throw WordedError(
            {QT_TRANSLATE_NOOP("errors", "the renderer cannot start: %1"), renderer.error().toStdString()});
    return renderer.draw(frame, size);
}

QImage OffscreenStage::picture(SceneRenderer& renderer, const SceneFrame& frame, QSize size) {
    const QImage& drawn = draw(renderer, frame, size);
    QImage picture(size, QImage::Format_RGB32);
    QPainter painter(&picture);
    if (drawn.isNull()) {
        painter.fillRect(picture.rect(), Qt::black);
    } else if (frame.round) {
        impl_->scope.paint(painter, picture.rect(), drawn);
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(picture.rect(), drawn);
    }
    return picture;
}

QImage render_offscreen(SceneRenderer& renderer, const SceneFrame& frame, QSize size) {
    OffscreenStage stage;
    const QImage image = stage.picture(renderer, frame, size);
    renderer.release();
    return image;
}

}  // namespace fulcrum::ui
