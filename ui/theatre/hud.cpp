// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/hud.h"

#include <QCoreApplication>
#include <QPainter>
#include <cmath>

#include "sim_core/scene/scene.h"
#include "ui/language/language.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"

namespace fulcrum::ui {
namespace {

struct HudTexts {
    Q_DECLARE_TR_FUNCTIONS(fulcrum::ui::HudTexts)
};

/// The theatre is dark whatever the theme.
const Palette& dark() {
    return palette_of(Theme::dark);
}

void draw_goal_bar(QPainter& painter, const QRectF& bar, double share, const QColor& colour) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(255, 255, 255, 40));
    painter.drawRoundedRect(bar, bar.height() / 2, bar.height() / 2);
    painter.setBrush(colour);
    QRectF filled = bar;
    filled.setWidth(bar.width() * std::clamp(share, 0.0, 1.0));
    if (filled.width() > 1) painter.drawRoundedRect(filled, bar.height() / 2, bar.height() / 2);
}

void draw_force(QPainter& painter, const QRectF& box, const HudState& state, int h, bool compact) {
    const Palette& p = dark();
    const double force = state.display.force[h], limit = state.display.force_limit[h];
    const bool warn = state.display.warning[h];
    const QColor colour = h == 0 ? p.left_hand : p.right_hand;
    // Full scale: a third above the limit, or 6 N when nothing limited is touched.
    const double scale = limit > 0 ? limit * 1.35 : 6.0;
    const QRectF bar(box.left(), box.top() + 54, compact ? 18 : 26, box.height() - 130);
    painter.setPen(QPen(QColor(255, 255, 255, 90), 1));
    painter.setBrush(QColor(255, 255, 255, 22));
    painter.drawRoundedRect(bar, 5, 5);
    const double share = std::clamp(force / scale, 0.0, 1.0);
    QRectF filled = bar.adjusted(2, 2, -2, -2);
    filled.setTop(filled.bottom() - filled.height() * share);
    const bool over = limit > 0 && force > limit;
    painter.setPen(Qt::NoPen);
    painter.setBrush(over ? p.bad : colour);
    painter.drawRoundedRect(filled, 4, 4);
    if (over) {
        // Hatched as well: what is over the limit shows without colour.
        painter.setBrush(QBrush(QColor(0, 0, 0, 120), Qt::BDiagPattern));
        painter.drawRoundedRect(filled, 4, 4);
    }
    if (limit > 0) {
        const double y = bar.bottom() - bar.height() * (limit / scale);
        painter.setPen(QPen(p.warning, 2));
        painter.drawLine(QPointF(bar.left() - 5, y), QPointF(bar.right() + 5, y));
        painter.setFont(hud_font(12));
        painter.drawText(QRectF(bar.right() + 8, y - 12, 60, 24), Qt::AlignVCenter,
                         HudTexts::tr("%1 N").arg(figure(limit)));
    }
    painter.setFont(hud_font(13, true));
    painter.setPen(colour);
    const bool active = state.shows_active_hand && static_cast<int>(state.active_hand) == h;
    painter.drawText(QRectF(box.left() - 4, box.top(), box.width(), 26), Qt::AlignLeft | Qt::AlignVCenter,
                     (active ? QStringLiteral("▶ ") : QString()) +
                         (h == 0 ? HudTexts::tr("Left") : HudTexts::tr("Right")));
    painter.setFont(hud_font(12));
    painter.setPen(p.text);
    if (state.has_jaws[h]) {
        painter.drawText(
            QRectF(box.left() - 4, box.top() + 25, box.width(), 26), Qt::AlignLeft | Qt::AlignVCenter,
            compact ? (state.jaws_closed[h] ? HudTexts::tr("closed") : HudTexts::tr("open"))
                    : (state.jaws_closed[h] ? HudTexts::tr("jaws closed") : HudTexts::tr("jaws open")));
    }
    if (!state.tool[h].isEmpty()) {
        // Above the hand's name; in a small view, where the goal and the mode reach down to it, under its
        // force.
        painter.setFont(hud_font(13, true));
        painter.setPen(state.tool_active[h] ? p.warning : p.text);
        const QRectF line(h == 0 ? box.left() - 4 : box.left() - (compact ? 150 : 100),
                          compact ? box.bottom() - 18 : box.top() - 50,
                          h == 0 ? 240 : box.width() + (compact ? 94 : 84), 24);
        const int side = (h == 0 ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter;
        painter.drawText(line, side,
                         (state.tool_active[h] ? QStringLiteral("⚡ ") : QString()) + state.tool[h]);
        if (state.shows_active_hand && !compact) {
            painter.setFont(hud_font(12));
            painter.setPen(p.muted);
            painter.drawText(line.translated(0, 22), side | Qt::TextDontClip,
                             HudTexts::tr("%1 next · %2 pedal").arg(state.next_key, state.pedal_key));
        }
    }
    painter.setFont(hud_font(14, true));
    painter.setPen(over ? p.bad : p.text);
    painter.drawText(QRectF(box.left() - 4, bar.bottom() + 6, box.width(), 26),
                     Qt::AlignLeft | Qt::AlignVCenter, HudTexts::tr("%1 N").arg(decimal(force, 1)));
    if (warn) {
        painter.setFont(hud_font(13, true));
        painter.setPen(p.warning);
        painter.drawText(QRectF(box.left() - 4, bar.bottom() + 32, box.width() + 30, 26),
                         Qt::AlignLeft | Qt::AlignVCenter,
                         compact ? HudTexts::tr("⚠ less") : HudTexts::tr("⚠ less force"));
    }
}

QString goal_detail(const HudState& state, const Goal& goal) {
    const TaskDisplay& display = state.display;
    switch (goal.kind) {
        case GoalKind::touch_targets:
            return HudTexts::tr("%1 of %2 targets")
                .arg(std::lround(display.goal_progress * goal.count))
                .arg(goal.count);
        case GoalKind::run_bowel:
            return HudTexts::tr("%1 of %2 cm")
                .arg(decimal(display.run_covered_m * 100, 0))
                .arg(decimal(goal.length_m * 100, 0));
        case GoalKind::lift_and_hold:
            if (!std::isfinite(display.lift_height_m)) {  // a replay knows how long, not how high
                return HudTexts::tr("%1 of %2 s held")
                    .arg(std::lround(display.goal_progress * goal.hold_s))
                    .arg(std::lround(goal.hold_s));
            }
            return HudTexts::tr("%1 of %2 mm high")
                .arg(decimal(display.lift_height_m * 1000, 0))
                .arg(decimal(goal.height_m * 1000, 0));
        case GoalKind::take_tension:
            return {};
        case GoalKind::divide_line:
            if (display.cut_torn_m >= 0.001)
                return HudTexts::tr("%1 of %2 mm, %3 mm torn")
                    .arg(decimal(display.cut_divided_m * 1000, 0))
                    .arg(decimal(goal.length_m * 1000, 0))
                    .arg(decimal(display.cut_torn_m * 1000, 0));
            return HudTexts::tr("%1 of %2 mm")
                .arg(decimal(display.cut_divided_m * 1000, 0))
                .arg(decimal(goal.length_m * 1000, 0));
        case GoalKind::divide_bands:
            if (display.bands_torn > 0)
                return HudTexts::tr("%1 of %2 bands, %3 torn · %4 mL lost")
                    .arg(display.bands_divided)
                    .arg(goal.count)
                    .arg(display.bands_torn)
                    .arg(decimal(static_cast<double>(display.blood_ml), 1));
            return HudTexts::tr("%1 of %2 bands · %3 mL lost")
                .arg(std::lround(display.goal_progress * goal.count))
                .arg(goal.count)
                .arg(decimal(static_cast<double>(display.blood_ml), 1));
        case GoalKind::stop_bleeding:
            return HudTexts::tr("%1 of %2 vessels controlled · %3 mL lost")
                .arg(std::lround(display.goal_progress * goal.count))
                .arg(goal.count)
                .arg(decimal(static_cast<double>(display.blood_ml), 1));
        case GoalKind::transfer_objects:
            return HudTexts::tr("%1 of %2 rings")
                .arg(std::lround(display.goal_progress * goal.count))
                .arg(goal.count);
        case GoalKind::frame_targets:
            return HudTexts::tr("%1 of %2 targets")
                .arg(std::lround(display.goal_progress * goal.count))
                .arg(goal.count);
        case GoalKind::follow_tip:
            return HudTexts::tr("%1 of %2 s framed")
                .arg(decimal(std::floor(display.goal_progress * goal.hold_s + 1e-6), 0))
                .arg(decimal(goal.hold_s, 0));
        case GoalKind::palpate:
            return HudTexts::tr("%1 of %2 s in contact")
                .arg(decimal(display.goal_progress * goal.hold_s, 1))
                .arg(decimal(goal.hold_s, 1));
        case GoalKind::let_go:
            return HudTexts::tr("%1 of %2 s free")
                .arg(decimal(display.goal_progress * goal.hold_s, 1))
                .arg(decimal(goal.hold_s, 1));
    }
    return {};
}

/// What keeps a target from being framed, the first thing to do first; "" nothing.
QString framing_warning(const TaskDisplay& display, double field_of_view) {
    const unsigned faults = display.framing_faults;
    if (faults != 0 && display.framing.off_centre > 0.5 * field_of_view)
        return HudTexts::tr("⚠ look for the lit ball");
    if ((faults & framing_hidden) != 0) return HudTexts::tr("⚠ look into the cup");
    if ((faults & framing_off_centre) != 0) return HudTexts::tr("⚠ to the middle");
    if ((faults & framing_too_far) != 0) return HudTexts::tr("⚠ nearer");
    if ((faults & framing_too_near) != 0) return HudTexts::tr("⚠ further away");
    if ((faults & framing_tilted) != 0) return HudTexts::tr("⚠ level the horizon");
    return {};
}

/// What is wrong with the cut now; "" nothing.
QString cut_warning(const TaskDisplay& display) {
    if (display.traction_warning > 0) return HudTexts::tr("⚠ less traction");
    if (display.traction_warning < 0) return HudTexts::tr("⚠ more traction");
    if (display.distance_warning)
        return HudTexts::tr("⚠ %1 mm off the line").arg(decimal(std::abs(display.cut_distance_m) * 1000, 1));
    return {};
}

/// Traction across the line: the band that is asked for is marked, so that it is hit without reading figures.
void draw_traction(QPainter& painter, const QRectF& bar, const TaskDisplay& display, const Goal& goal) {
    const Palette& p = dark();
    const double scale = 1.5 * goal.traction_high_n_m;
    const auto place = [&](double traction) {
        return bar.left() + bar.width() * std::clamp(traction / scale, 0.0, 1.0);
    };
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(255, 255, 255, 40));
    painter.drawRoundedRect(bar, 4, 4);
    painter.setBrush(QColor(p.good.red(), p.good.green(), p.good.blue(), 120));
    const double low = place(goal.traction_low_n_m), high = place(goal.traction_high_n_m);
    painter.drawRect(QRectF(low, bar.top(), high - low, bar.height()));
    const double now = place(display.traction_n_m);
    const bool within =
        display.traction_n_m >= goal.traction_low_n_m && display.traction_n_m <= goal.traction_high_n_m;
    painter.setBrush(within ? p.text : p.warning);
    painter.drawRect(QRectF(now - 2, bar.top() - 4, 4, bar.height() + 8));
}

}  // namespace

void set_scope(HudState& hud, const Scene& scene) {
    hud.hands = !scene.instruments.empty();
    if (!scene.camera_targets || !scene.camera) return;
    hud.wanted_size = std::asin(scene.camera_targets->ball_radius / scene.camera_targets->distance);
    hud.field_of_view = scene.camera->field_of_view;
}

QString tool_words(const HandToolView& tool) {
    const InstrumentType& type = type_of(tool.kind);
    QString words = QCoreApplication::translate("fulcrum::instruments", type.title);
    if (type.clips) words = HudTexts::tr("clips: %1").arg(tool.clips_left);
    if (tool.exchange_left > 0)
        words += HudTexts::tr(", in %1 s").arg(decimal(static_cast<double>(tool.exchange_left), 1));
    return words;
}

namespace {

/// What the round picture leaves free at its sides; a small view has room for the values alone.
struct Margins {
    bool compact = false;
    double margin = 18, column = 190;
};

/// Top left: the timer and the mode.
void paint_mode(QPainter& painter, const QRectF& area, const HudState& state, const Margins& room) {
    const Palette& p = dark();
    const auto [compact, margin, column] = room;
    painter.setPen(p.text);
    painter.setFont(hud_font(compact ? 18 : 26, true));
    painter.drawText(QRectF(area.left() + margin, area.top() + 10, column, 42),
                     Qt::AlignLeft | Qt::AlignVCenter, clock_text(state.display.elapsed_s));
    painter.setFont(hud_font(12));
    painter.setPen(p.muted);
    painter.drawText(QRectF(area.left() + margin, area.top() + 52, column, 24),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     HudTexts::tr("%1 left").arg(clock_text(state.display.remaining_s)));
    painter.setPen(p.text);
    const QString mode = !state.place.isEmpty()  ? state.place
                         : state.became_practice ? HudTexts::tr("practice: it was interrupted")
                         : state.assessed        ? HudTexts::tr("assessed")
                                                 : HudTexts::tr("practice");
    painter.drawText(QRectF(area.left() + margin, area.top() + 76, column, 48),
                     Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, mode);
}

/// Top right: the goal, line under line. Returns where the room that it may need ends, warnings shown or not.
double paint_goal(QPainter& painter, const QRectF& area, const HudState& state, const Margins& room) {
    const Palette& p = dark();
    const bool compact = room.compact;
    const double margin = room.margin;
    const auto index =
        std::min(static_cast<std::size_t>(std::max(state.display.goal, 0)), state.task->goals.size() - 1);
    const Goal& goal = state.task->goals[index];
    const GoalType& type = type_of(goal.kind);
    const QRectF box(area.right() - margin - 240, area.top() + 12, 240, 150);
    painter.setFont(hud_font(12));
    painter.setPen(p.muted);
    painter.drawText(QRectF(box.left(), box.top(), box.width(), 22), Qt::AlignRight | Qt::AlignVCenter,
                     HudTexts::tr("Step %1 of %2").arg(index + 1).arg(state.task->goals.size()));
    painter.setPen(p.text);
    double y = box.top() + 22;
    if (!compact) {
        painter.setFont(hud_font(13, true));
        QRectF used;
        painter.drawText(QRectF(box.left(), y, box.width(), 90), Qt::AlignRight | Qt::TextWordWrap,
                         asset_text(goal.text), &used);
        y = used.bottom() + 6;
    }
    painter.setFont(hud_font(12));
    const QString detail = goal_detail(state, goal);
    painter.drawText(QRectF(box.left(), y, box.width(), 22),
                     Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, detail);
    y += detail.isEmpty() ? 4 : 26;
    const double length = compact ? 110 : 180;
    draw_goal_bar(painter, QRectF(box.right() - length, y, length, 8), state.display.goal_progress, p.good);
    y += 12;
    if (state.display.hold_progress > 0) {
        painter.setPen(p.text);
        painter.drawText(QRectF(box.left(), y, box.width() - 110, 22), Qt::AlignRight | Qt::AlignVCenter,
                         HudTexts::tr("hold"));
        draw_goal_bar(painter, QRectF(box.right() - 100, y + 7, 100, 8), state.display.hold_progress,
                      p.warning);
    }
    if (state.display.hold_progress > 0 || (type.traction && type.measure == GoalMeasure::seconds)) y += 22;
    const bool pulls = type.traction && goal.traction_high_n_m > 0;
    if (pulls && std::isfinite(state.display.traction_n_m)) {
        painter.setPen(p.text);
        painter.drawText(QRectF(box.left(), y, box.width(), 22), Qt::AlignRight | Qt::AlignVCenter,
                         HudTexts::tr("traction %1 of %2–%3 N/m")
                             .arg(decimal(state.display.traction_n_m, 0))
                             .arg(decimal(goal.traction_low_n_m, 0))
                             .arg(decimal(goal.traction_high_n_m, 0)));
        draw_traction(painter, QRectF(box.right() - length, y + 26, length, 10), state.display, goal);
    }
    if (pulls) y += 42;
    const QString wrong = state.wanted_size > 0 ? framing_warning(state.display, state.field_of_view)
                                                : cut_warning(state.display);
    if (!wrong.isEmpty()) {
        painter.setFont(hud_font(13, true));
        painter.setPen(p.warning);
        painter.drawText(QRectF(box.left(), y, box.width(), 26), Qt::AlignRight | Qt::AlignVCenter, wrong);
    }
    if (pulls || !wrong.isEmpty()) y += 26;
    return y;
}

/// In the round image: the circle that a target is to fill, the level marks and the horizon as it is.
void paint_reticle(QPainter& painter, const QRectF& area, const HudState& state) {
    const Palette& p = dark();
    const double radius = 0.5 * std::min(area.width(), area.height());
    const double per_tangent = radius / std::tan(0.5 * state.field_of_view);
    const QPointF middle = area.center();
    const bool framed = state.display.framing.size > 0 && state.display.framing_faults == 0;
    const QColor colour = framed ? p.good : p.text;
    painter.setBrush(Qt::NoBrush);
    // Dark under bright: seen on any ground.
    for (const auto& [ink, width] : {std::pair<QColor, double>{QColor(0, 0, 0, 150), 4.0}, {colour, 2.0}}) {
        painter.setPen(QPen(ink, framed ? width + 1 : width));
        const double wanted = per_tangent * std::tan(state.wanted_size);
        painter.drawEllipse(middle, wanted, wanted);
        for (const double side : {-1.0, 1.0}) {
            painter.drawLine(middle + QPointF(side * 0.62 * radius, 0),
                             middle + QPointF(side * 0.74 * radius, 0));
        }
    }
    if (!(state.display.framing.size > 0)) return;  // a replay does not know how the image is turned
    const bool tilted = (state.display.framing_faults & framing_tilted) != 0;
    const double turn = state.display.framing.horizon;
    const QPointF along(std::cos(turn), std::sin(turn));
    painter.setPen(QPen(tilted ? p.warning : p.good, 3));
    for (const double side : {-1.0, 1.0})
        painter.drawLine(middle + side * 0.48 * radius * along, middle + side * 0.60 * radius * along);
}

}  // namespace

QFont hud_font(double points, bool bold) {
    QFont font(QStringLiteral("DejaVu Sans"));
    font.setPixelSize(static_cast<int>(std::lround(points * 96 / 72)));
    font.setBold(bold);
    return font;
}

QRectF scaled_to_text(QPainter& painter, const QRectF& area, QSizeF smallest) {
    const double asked = painter.device()->logicalDpiY() / 96.0 * text_percent() / 100.0;
    const double room = std::min(area.width() / smallest.width(), area.height() / smallest.height());
    const double scale = std::min(asked, std::max(room, 1.0));
    painter.translate(area.topLeft());
    painter.scale(scale, scale);
    return {QPointF(0, 0), area.size() / scale};
}

void paint_hud(QPainter& painter, const QRectF& whole, const HudState& state, double covered) {
    const Palette& p = dark();
    constexpr double least_width = 557, least_height = 360;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    if (state.wanted_size > 0)
        paint_reticle(painter, scaled_to_text(painter, whole, {least_width, least_height}), state);
    painter.restore();
    painter.save();
    const QRectF area = scaled_to_text(painter, whole.adjusted(0, 0, 0, -covered),
                                       {least_width, covered > 0 ? hud_height_above : least_height});
    painter.setRenderHint(QPainter::Antialiasing);
    const double picture = whole.height() * area.width() / whole.width();  // round, in the whole height
    const double side = 0.5 * (area.width() - std::min(area.width(), picture));
    const bool compact = side < 150 || area.height() < 560;
    const double margin = compact ? 10 : 18;
    const Margins room{compact, margin, compact ? 150.0 : 190.0};
    paint_mode(painter, area, state, room);
    // The forces begin below all that the goal may say, so that they do not jump when a warning comes.
    double goal_bottom = area.top() + 124;  // of the mode
    if (state.task != nullptr && !state.task->goals.empty())
        goal_bottom = std::max(goal_bottom, paint_goal(painter, area, state, room));

    // Both sides: force.
    const double foot_of_bars = area.bottom() - 40;
    const double bars_top =
        std::max(foot_of_bars - std::min(area.height() * 0.55, 360.0), goal_bottom + (compact ? 0 : 50));
    const double bars_height = foot_of_bars - bars_top;
    if (state.hands) {
        draw_force(painter, QRectF(area.left() + margin + 4, bars_top, 130, bars_height), state, 0, compact);
        draw_force(painter, QRectF(area.right() - margin - (compact ? 74 : 112), bars_top, 130, bars_height),
                   state, 1, compact);
    }

    painter.setFont(hud_font(12));
    painter.setPen(p.muted);
    QStringList foot;
    if (state.hands && !state.force_felt) foot << HudTexts::tr("force is shown, not felt");
    if (!state.health.isEmpty()) foot << state.health;
    painter.drawText(QRectF(area.left() + margin, area.bottom() - 34, area.width() - 2 * margin, 26),
                     Qt::AlignLeft | Qt::AlignVCenter, foot.join(QStringLiteral(" · ")));
    painter.drawText(QRectF(area.left() + margin, area.bottom() - 34, area.width() - 2 * margin, 26),
                     Qt::AlignRight | Qt::AlignVCenter,
                     state.place.isEmpty() ? HudTexts::tr("Esc pause · F1 help") : QString());

    if (state.display.critical) {
        painter.setFont(hud_font(15, true));
        painter.setPen(p.bad);
        painter.drawText(QRectF(area.left(), area.top() + (compact ? 4 : 12), area.width(), 30),
                         Qt::AlignCenter, HudTexts::tr("✕ critical error"));
    }
    painter.restore();
}

void paint_cover(QPainter& painter, const QRectF& whole, const QString& heading, const QStringList& lines) {
    const Palette& p = dark();
    painter.save();
    const QRectF area = scaled_to_text(painter, whole, {1000, 600});
    painter.setRenderHint(QPainter::Antialiasing);
    const double line_height = 30, width = std::min(area.width() - 60, 940.0);
    const double height = 90 + line_height * lines.size();
    const QRectF box(area.center().x() - width / 2, area.center().y() - height / 2 - 20, width, height);
    painter.setPen(QPen(p.line, 1));
    painter.setBrush(QColor(16, 20, 26, 236));
    painter.drawRoundedRect(box, 12, 12);
    painter.setPen(p.text);
    painter.setFont(hud_font(18, true));
    painter.drawText(QRectF(box.left() + 28, box.top() + 18, box.width() - 56, 40),
                     Qt::AlignLeft | Qt::AlignVCenter, heading);
    painter.setFont(hud_font(12));
    double y = box.top() + 66;
    for (const QString& line : lines) {
        const int tab = line.indexOf(QLatin1Char('\t'));
        if (tab >= 0) {
            painter.setPen(p.accent);
            painter.drawText(QRectF(box.left() + 28, y, 330, line_height), Qt::AlignLeft | Qt::AlignVCenter,
                             line.left(tab));
            painter.setPen(p.text);
            painter.drawText(QRectF(box.left() + 368, y, box.width() - 386, line_height),
                             Qt::AlignLeft | Qt::AlignVCenter, line.mid(tab + 1));
        } else {
            painter.setPen(p.text);
            painter.drawText(QRectF(box.left() + 28, y, box.width() - 56, line_height),
                             Qt::AlignLeft | Qt::AlignVCenter, line);
        }
        y += line_height;
    }
    painter.restore();
}

}  // namespace fulcrum::ui
