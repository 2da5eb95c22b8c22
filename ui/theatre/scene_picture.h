// SPDX-License-Identifier: GPL-3.0-or-later
// What the scope sees when a task begins, drawn from the scene itself. World and geometry are made on a
// worker thread, the one picture is drawn on the UI thread, as the theatre draws its own. Finished pictures
// are kept in files next to the store, by task, text of the scene and version of the program, so that each is
// drawn once. UI thread.
#pragma once

#include <QImage>
#include <QWidget>
#include <string>

#include "ui/page/context.h"

namespace fulcrum::ui {

class BackgroundJob;
class SceneAssembler;

class ScenePicture : public QWidget {
    Q_OBJECT
  public:
    explicit ScenePicture(Context& context, QWidget* parent = nullptr);
    /// Shows the picture if it is kept, else draws it; an older request is dropped.
    void show_task(const TaskDefinition& task, const std::string& variant = {});
    /// Null until there is one.
    const QImage& picture() const { return picture_; }
    /// Why there is none; "" while it is made.
    const QString& trouble() const { return trouble_; }
    /// Where the picture of a task is kept. Throws InputError where its scene cannot be read.
    static QString file_of(ApplicationServices& services, const TaskDefinition& task,
                           const std::string& variant = {});
    QSize sizeHint() const override { return {400, 300}; }

  signals:
    /// A picture is there, or why there is none.
    void finished();

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    void draw(const TaskDefinition& task, const std::string& variant, const QString& file);
    void take(const QImage& picture, const QString& trouble);

    Context& context_;
    QImage picture_;
    QString trouble_;
    BackgroundJob* job_ = nullptr;
};

}  // namespace fulcrum::ui
