// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/realignment.h"

#include <QCoreApplication>
#include <QPainter>
#include <cmath>

#include "ui/language/language.h"
#include "ui/style/palette.h"

namespace fulcrum::ui {
namespace {

constexpr double degrees = 57.29577951308232;

struct RealignmentTexts {
    Q_DECLARE_TR_FUNCTIONS(fulcrum::ui::RealignmentTexts)
};

QString line_of(int hand, const Realignment::OneHand& one) {
    const QString name = hand == 0 ? RealignmentTexts::tr("Left") : RealignmentTexts::tr("Right");
    if (one.in_place) return RealignmentTexts::tr("✓ %1: in place").arg(name);
    return RealignmentTexts::tr("→ %1: %2 mm and %3° away from its ghost")
        .arg(name)
        .arg(decimal(one.distance * 1e3, 0))
        .arg(decimal(one.angle * degrees, 0));
}

}  // namespace

namespace {

DrawnTool drawn(const InstrumentSpec& spec, const ToolPose& pose) {
    DrawnTool tool;
    tool.pose = pose;
    tool.kind = spec.kind;
    tool.jaw_length = spec.jaw_length;
    tool.shaft_radius = spec.shaft_radius;
    return tool;
}

}  // namespace

void add_ghost(SceneFrame& frame, const Scene& scene, const GhostPoint& ghost) {
    for (int hand = 0; hand < hand_count; ++hand) {
        const InstrumentSpec* spec = scene.instrument(static_cast<Hand>(hand));
        if (spec == nullptr || !ghost.tools[hand].inside) continue;
        frame.tools.push_back(drawn(*spec, ghost.tools[hand]));
        frame.tools.back().ghost = true;
    }
}

void add_ghosts(SceneFrame& frame, const Scene& scene, const Realignment& realignment) {
    for (DrawnTool& tool : frame.tools) tool.ghost = true;
    for (int hand = 0; hand < hand_count; ++hand) {
        const InstrumentSpec* spec = scene.instrument(static_cast<Hand>(hand));
        if (spec == nullptr || !realignment.hand[hand].exists) continue;
        frame.tools.push_back(drawn(*spec, realignment.hand[hand].device));
    }
}

void paint_realignment(QPainter& painter, const QRectF& area, const Realignment& realignment) {
    const Palette& p = palette_of(Theme::dark);
    QStringList lines;
    for (int hand = 0; hand < hand_count; ++hand) {
        if (realignment.hand[hand].exists) lines << line_of(hand, realignment.hand[hand]);
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double width = std::min(area.width() - 40, 720.0), row = 26;
    const QRectF box(area.center().x() - width / 2, area.bottom() - 70 - row * (lines.size() + 2), width,
                     row * (lines.size() + 2) + 24);
    painter.setPen(QPen(realignment.in_place ? p.good : p.warning, 2));
    painter.setBrush(QColor(16, 20, 26, 225));
    painter.drawRoundedRect(box, 10, 10);
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPointSizeF(13);
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(p.text);
    double y = box.top() + 12;
    const auto draw = [&](const QString& line) {
        painter.drawText(QRectF(box.left() + 18, y, box.width() - 36, row), Qt::AlignLeft | Qt::AlignVCenter,
                         line);
        y += row;
    };
    draw(realignment.in_place
             ? RealignmentTexts::tr("In place. Press Enter to continue as practice.")
             : RealignmentTexts::tr("The device is back. Bring each instrument onto its ghost."));
    font.setBold(false);
    font.setPointSizeF(12);
    painter.setFont(font);
    for (const QString& line : lines) draw(line);
    painter.setPen(p.muted);
    draw(RealignmentTexts::tr("The timer is stopped. Esc: abandon the attempt."));
    painter.restore();
}

}  // namespace fulcrum::ui
