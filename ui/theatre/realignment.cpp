// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/realignment.h"

#include <QCoreApplication>
#include <QPainter>
#include <algorithm>
#include <vector>

#include "ui/language/language.h"
#include "ui/style/palette.h"
#include "ui/theatre/hud.h"

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

void paint_realignment(QPainter& painter, const QRectF& whole, const Realignment& realignment) {
    struct Line {
        QString words;
        QFont font;
        QColor colour;
        double height;
    };
    constexpr int wrapped = static_cast<int>(Qt::AlignLeft) | static_cast<int>(Qt::AlignVCenter) |
                            static_cast<int>(Qt::TextWordWrap);
    const Palette& p = palette_of(Theme::dark);
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF area = scaled_to_text(painter, whole, {680, 420});
    // Where there is room, the forces at both sides stay visible.
    const double width = std::clamp(area.width() - 340, 400.0, 720.0), inner = width - 36;
    std::vector<Line> lines;
    double height = 24;
    const auto add = [&](const QString& words, const QFont& font, const QColor& colour) {
        painter.setFont(font);
        const QRectF needs = painter.boundingRect(QRectF(0, 0, inner, area.height()), wrapped, words);
        lines.push_back({words, font, colour, needs.height() + 6});
        height += lines.back().height;
    };
    add(realignment.in_place
            ? RealignmentTexts::tr("In place. Press Enter to continue as practice.")
            : RealignmentTexts::tr("The device is back. Bring each instrument onto its ghost."),
        hud_font(13, true), p.text);
    for (int hand = 0; hand < hand_count; ++hand)
        if (realignment.hand[hand].exists) add(line_of(hand, realignment.hand[hand]), hud_font(12), p.text);
    add(RealignmentTexts::tr("The timer is stopped. Esc: abandon the attempt."), hud_font(12), p.muted);

    const QRectF box(area.center().x() - width / 2, area.bottom() - 46 - height, width, height);
    painter.setPen(QPen(realignment.in_place ? p.good : p.warning, 2));
    painter.setBrush(QColor(16, 20, 26, 225));
    painter.drawRoundedRect(box, 10, 10);
    double y = box.top() + 12;
    for (const Line& line : lines) {
        painter.setFont(line.font);
        painter.setPen(line.colour);
        painter.drawText(QRectF(box.left() + 18, y, inner, line.height), wrapped, line.words);
        y += line.height;
    }
    painter.restore();
}

}  // namespace fulcrum::ui
