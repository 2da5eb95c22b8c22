// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/theatre_view.h"

#include <QElapsedTimer>
#include <QPainter>
#include <algorithm>
#include <chrono>
#include <stdexcept>

#include "ui/language/error_text.h"
#include "ui/page/background_job.h"
#include "ui/theatre/realignment.h"
#include "ui/theatre/renderer/offscreen.h"
#include "ui/theatre/renderer/scene_assembler.h"
#include "ui/theatre/renderer/scene_renderer.h"

namespace fulcrum::ui {
namespace {

constexpr float counted_share = 0.62F;  // of a ring's colour once it counts

}  // namespace

TheatreView::TheatreView(QWidget* parent) : QWidget(parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setMinimumSize(320, 240);
    setAccessibleName(tr("View through the laparoscope"));
}

TheatreView::~TheatreView() {
    if (stage_) {
        stage_->make_current();
        renderer_.reset();
    }
}

void TheatreView::load(const Scene& scene, const WorldSnapshot& first) {
    unload();
    scene_ = scene;
    world_ = first;
    has_world_ = true;
    auto made = std::make_shared<std::unique_ptr<SceneAssembler>>();
    auto source = std::make_shared<std::pair<Scene, WorldSnapshot>>(scene, first);
    job_ = BackgroundJob::run(
        this,
        [made, source](const Progress&) {
            *made = std::make_unique<SceneAssembler>(source->first, source->second);
        },
        [this, made] {
            job_ = nullptr;
            assembler_ = std::move(*made);
            installed_ = false;
            update();
            emit loaded();
        },
        [this](const QString& why) {
            job_ = nullptr;
            error_ = why;
            update();
            emit load_failed(why);
        });
}

void TheatreView::unload() {
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
    assembler_.reset();
    has_world_ = has_hud_ = installed_ = false;
    pictures_ = 0;
    pale_ = dented_ = {};
    pace_.restart();
    realignment_.reset();
    ghost_.reset();
    done_.clear();
    active_ = -1;
    notice_.clear();
    cover_lines_.clear();
    cover_heading_.clear();
    update();
}

void TheatreView::show_world(const WorldSnapshot& world) {
    world_ = world;
    has_world_ = true;
    update();
}

void TheatreView::set_hud(const HudState& hud) {
    hud_ = hud;
    has_hud_ = true;
}

void TheatreView::set_covered_foot(int height) {
    if (height == covered_foot_) return;
    covered_foot_ = height;
    update();
}

void TheatreView::set_targets(const std::vector<bool>& done, int active, bool touched) {
    done_ = done;
    active_ = active;
    touched_ = touched;
}

void TheatreView::set_notice(const QString& notice) {
    if (notice == notice_) return;
    notice_ = notice;
    update();
}

void TheatreView::set_realignment(const std::optional<Realignment>& realignment) {
    realignment_ = realignment;
    update();
}

void TheatreView::set_ghost(const GhostPoint* ghost) {
    ghost_ = ghost != nullptr ? std::optional<GhostPoint>(*ghost) : std::nullopt;
}

void TheatreView::set_cover(const QString& heading, const QStringList& lines) {
    cover_heading_ = heading;
    cover_lines_ = lines;
    update();
}

void TheatreView::set_paced(bool paced) {
    paced_ = paced;
    pace_.restart();
}

SceneFrame& TheatreView::assemble() {
    SceneFrame& frame = assembler_->assemble(world_);
    for (std::size_t i = 0; i < std::min(frame.targets.size(), world_.targets.size()); ++i) {
        TargetLook look = TargetLook::waiting;
        if (i < done_.size() && done_[i]) look = TargetLook::done;
        if (static_cast<int>(i) == active_) look = touched_ ? TargetLook::touched : TargetLook::current;
        frame.targets[i].look = look;
    }
    for (DrawnTube& tube : frame.tubes) {  // a ring that counts is darker
        if (tube.object >= 0 && (hud_.display.rings_placed >> static_cast<unsigned>(tube.object) & 1U) != 0)
            tube.hue *= counted_share;
    }
    for (std::size_t h = 0; h < frame.tools.size() && h < hand_count; ++h) {
        const double limit = hud_.display.force_limit[h];
        frame.tools[h].strain = limit > 0 ? std::clamp(hud_.display.force[h] / limit, 0.0, 1.0) : 0;
    }
    if (ghost_) add_ghost(frame, scene_, *ghost_);
    if (realignment_) add_ghosts(frame, scene_, *realignment_);
    return frame;
}

bool TheatreView::paint_scene(QPainter& painter) {
    if (!error_.isEmpty() || !assembler_ || !has_world_ || !notice_.isEmpty()) return false;
    try {
        if (!stage_) stage_ = std::make_unique<OffscreenStage>();
        stage_->make_current();
        if (!renderer_) renderer_ = std::make_unique<SceneRenderer>();
        if (!installed_) assembler_->install(*renderer_);
        installed_ = true;
        renderer_->set_share(paced_ ? pace_.share() : 1.0);
        const QSize pixels = size() * devicePixelRatioF();
        const SceneFrame& frame = assemble();
        const QImage& picture = stage_->draw(*renderer_, frame, pixels);
        if (picture.isNull()) return false;
        strained_ = std::any_of(frame.tools.begin(), frame.tools.end(),
                                [](const DrawnTool& tool) { return tool.strain > 0; });
        resolution_ = static_cast<double>(picture.height()) / std::min(pixels.width(), pixels.height());
        scope_.paint(painter, rect(), picture);
    } catch (const std::runtime_error& why) {
        error_ = error_text(why);
        return false;
    }
    ++pictures_;
    return true;
}

void TheatreView::paint_words(QPainter& painter) {
    const QString words = !error_.isEmpty()    ? tr("The picture cannot be drawn: %1").arg(error_)
                          : !notice_.isEmpty() ? notice_
                          : job_ != nullptr    ? tr("Preparing the scene …")
                                               : QString();
    painter.setPen(QColor(0xE8EDF3));
    QFont font = painter.font();
    font.setPointSizeF(0.14 * text_percent());
    painter.setFont(font);
    painter.drawText(rect().adjusted(40, 40, -40, -40), Qt::AlignCenter | Qt::TextWordWrap, words);
}

void TheatreView::note_appearances() {
    const std::int64_t now =
        std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
    pale_.see(strained_, now);
    dented_.see(world_.bowel.dent_count > 0, now);
}

void TheatreView::paintEvent(QPaintEvent*) {
    QElapsedTimer timer;
    timer.start();
    QPainter painter(this);
    const bool drawn = paint_scene(painter);
    if (!drawn) painter.fillRect(rect(), Qt::black);
    if (has_hud_ && notice_.isEmpty()) paint_hud(painter, rect(), hud_, covered_foot_);
    if (!drawn) paint_words(painter);
    if (drawn && realignment_) paint_realignment(painter, rect(), *realignment_);
    if (!cover_lines_.isEmpty()) paint_cover(painter, rect(), cover_heading_, cover_lines_);
    painter.end();
    if (drawn) note_appearances();
    frame_ms_ = static_cast<double>(timer.nsecsElapsed()) * 1e-6;
    if (drawn && paced_) pace_.drawn(frame_ms_);
}

}  // namespace fulcrum::ui

#include "moc_theatre_view.cpp"
