// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/scene_picture.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QPainter>
#include <QSaveFile>
#include <future>
#include <stdexcept>

#include "ui/language/error_text.h"
#include "ui/page/background_job.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/theatre/renderer/offscreen.h"
#include "ui/theatre/renderer/scene_assembler.h"

namespace fulcrum::ui {
namespace {

constexpr QSize picture_size(480, 360);

/// What the worker makes.
struct Prepared {
    Scene scene;
    WorldSnapshot first;
    std::unique_ptr<SceneAssembler> assembler;
};

/// Throws std::runtime_error where there is no OpenGL.
QImage draw_start(Prepared& prepared) {
    RendererOptions options;
    options.multisample = true;
    SceneRenderer renderer(options);
    prepared.assembler->install(renderer);
    return render_offscreen(renderer, prepared.assembler->assemble(prepared.first), picture_size);
}

/// A picture that cannot be kept is drawn again the next time.
void keep(const QImage& picture, const QString& path) {
    if (!QDir().mkpath(QFileInfo(path).absolutePath())) return;
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && picture.save(&file, "PNG")) file.commit();
}

}  // namespace

ScenePicture::ScenePicture(Context& context, QWidget* parent) : QWidget(parent), context_(context) {
    setObjectName(QStringLiteral("scene_picture"));
    setMinimumSize(280, 210);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
}

QString ScenePicture::file_of(ApplicationServices& services, const TaskDefinition& task,
                              const std::string& variant) {
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(QByteArray::fromStdString(services.scene_text(task, variant)));
    hash.addData(QByteArray::fromStdString(services.program_version()));
    return QFileInfo(text(services.store_path(true))).absolutePath() +
           QStringLiteral("/pictures/%1-%2.png")
               .arg(text(task.id), QString::fromLatin1(hash.result().toHex().left(16)));
}

void ScenePicture::show_task(const TaskDefinition& task, const std::string& variant) {
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
    picture_ = QImage();
    trouble_.clear();
    setAccessibleName(tr("What the scope sees when %1 begins").arg(context_.task_title(task.id)));
    update();
    QString file;
    try {
        file = file_of(context_.services(), task, variant);
    } catch (const std::exception& error) {
        take({}, error_text(error));
        return;
    }
    const QImage kept(file);
    if (!kept.isNull()) {
        take(kept, {});
    } else {
        draw(task, variant, file);
    }
}

void ScenePicture::draw(const TaskDefinition& task, const std::string& variant, const QString& file) {
    auto prepared = std::make_shared<Prepared>();
    // The work uses the services, which end after this widget: the widget's end waits for it.
    auto working = std::make_shared<std::promise<void>>();
    connect(this, &QObject::destroyed, [done = working->get_future().share()] { done.wait(); });
    job_ = BackgroundJob::run(
        this,
        [prepared, task, variant, working, &services = context_.services()](const Progress&) {
            const std::shared_ptr<void> ends(nullptr, [working](void*) { working->set_value(); });
            prepared->scene = services.scene_for(task, variant);
            prepared->first = services.world_at_start(task, variant);
            prepared->assembler = std::make_unique<SceneAssembler>(prepared->scene, prepared->first);
        },
        [this, prepared, file] {
            job_ = nullptr;
            try {
                const QImage drawn = draw_start(*prepared);
                keep(drawn, file);
                take(drawn, {});
            } catch (const std::runtime_error& error) {
                take({}, error_text(error));
            }
        },
        [this](const QString& why) {
            job_ = nullptr;
            take({}, why);
        });
}

void ScenePicture::take(const QImage& picture, const QString& trouble) {
    picture_ = picture;
    trouble_ = trouble;
    update();
    emit finished();
}

void ScenePicture::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    painter.setPen(Qt::NoPen);
    painter.setBrush(Qt::black);
    painter.drawRoundedRect(rect(), 8, 8);
    if (!picture_.isNull()) {
        const QSize fitted = picture_.size().scaled(size(), Qt::KeepAspectRatio);
        painter.drawImage(
            QRect(QPoint((width() - fitted.width()) / 2, (height() - fitted.height()) / 2), fitted),
            picture_);
        return;
    }
    painter.setPen(QColor(0xC8, 0xD0, 0xDA));
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap,
                     trouble_.isEmpty() ? tr("drawing the scene …") : tr("No picture: %1").arg(trouble_));
}

}  // namespace fulcrum::ui

#include "moc_scene_picture.cpp"
