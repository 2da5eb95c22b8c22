// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/picture_card.h"

#include <cmath>
#include <stdexcept>

#include "ui/language/error_text.h"
#include "ui/language/language.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/theatre/renderer/drawing_pace.h"
#include "ui/theatre/renderer/offscreen.h"
#include "ui/theatre/renderer/scene_renderer.h"

namespace fulcrum::ui {

PictureCard::PictureCard(QWidget* parent) : QFrame(parent), picture_(make_label({})) {
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 16);
    layout->setSpacing(8);
    layout->addWidget(make_label(tr("Picture"), "heading"));
    picture_->setObjectName(QStringLiteral("picture_quality"));
    layout->addWidget(picture_);
}

void PictureCard::showEvent(QShowEvent* event) {
    QFrame::showEvent(event);
    if (!picture_->text().isEmpty()) return;
    try {
        OffscreenStage stage;
        stage.make_current();
        picture_->setText(picture_text(picture_quality()));
    } catch (const std::runtime_error& why) {
        picture_->setText(tr("The scene cannot be drawn on this machine: %1").arg(error_text(why)));
    }
}

QString PictureCard::picture_text(const PictureQuality& quality) {
    const auto percent = [](double share) { return std::lround(100 * share); };
    QStringList lines;
    lines << tr("Drawn by: %1").arg(quality.device);
    if (quality.software) {
        lines << tr("The processor draws the picture, because OpenGL offers no graphics card here.");
        lines << tr("Resolution: %1 % of the window's, %2 % inside the pelvis, so that drawing takes less "
                    "than %3 ms. If it takes longer, the resolution is reduced, to %4 % of that at the "
                    "least, and raised again when there is time.")
                     .arg(percent(quality.share))
                     .arg(percent(quality.share_in_hollow))
                     .arg(decimal(DrawingPace::goal_ms, 0))
                     .arg(percent(DrawingPace::share_at(DrawingPace::levels - 1)));
    } else {
        lines << tr("Resolution: that of the window. If drawing takes longer than %1 ms, it is reduced, to "
                    "%2 % at the least, and raised again when there is time.")
                     .arg(decimal(DrawingPace::goal_ms, 0))
                     .arg(percent(DrawingPace::share_at(DrawingPace::levels - 1)));
    }
    lines << (quality.smoothing == Smoothing::multisample
                  ? tr("Anti-aliasing: 4 samples per pixel.")
                  : tr("Anti-aliasing: edges of instruments and targets, after drawing. Several samples per "
                       "pixel would take too long on a processor."));
    return lines.join(QLatin1Char('\n'));
}

}  // namespace fulcrum::ui

#include "moc_picture_card.cpp"
