// SPDX-License-Identifier: GPL-3.0-or-later
// The scope's picture with the HUD over it; serves the running attempt and the replay. Geometry is prepared
// on a worker thread. OpenGL draws offscreen, the widget paints the pixels: where a processor does both, a
// window that OpenGL composes costs as much again.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "sim_core/scene/scene.h"
#include "sim_core/world/part/snapshot.h"
#include "ui/services/attempt_session.h"
#include "ui/theatre/hud.h"
#include "ui/theatre/renderer/drawing_pace.h"
#include "ui/theatre/renderer/scope_picture.h"

namespace fulcrum::ui {

class BackgroundJob;
class OffscreenStage;
class SceneAssembler;
class SceneRenderer;
struct SceneFrame;

class TheatreView : public QWidget {
    Q_OBJECT
  public:
    explicit TheatreView(QWidget* parent = nullptr);
    ~TheatreView() override;
    /// Prepares the geometry of a scene; loaded() follows.
    void load(const Scene& scene, const WorldSnapshot& first);
    /// Nothing is shown any more.
    void unload();
    bool is_loaded() const { return assembler_ != nullptr; }
    /// The world to show next; copied.
    void show_world(const WorldSnapshot& world);
    void set_hud(const HudState& hud);
    const HudState& hud() const { return hud_; }
    /// px at the foot of the view that something else covers: texts and bars are painted above.
    void set_covered_foot(int height);
    int covered_foot() const { return covered_foot_; }
    /// Which targets are done (by index) and which is asked for now (-1 none).
    void set_targets(const std::vector<bool>& done, int active, bool touched);
    /// Not empty: the scene is hidden behind black and these words.
    void set_notice(const QString& notice);
    /// A device is back after a loss: the instruments wait as ghosts, the devices are drawn where they are,
    /// and a line says how far they are. Empty: not so.
    void set_realignment(const std::optional<Realignment>& realignment);
    const std::optional<Realignment>& realignment() const { return realignment_; }
    /// Instruments of an expert to be drawn translucent; null: none. Copied.
    void set_ghost(const GhostPoint* ghost);
    /// Lines over the dimmed picture; none hides them.
    void set_cover(const QString& heading, const QStringList& lines);
    const QStringList& cover() const { return cover_lines_; }
    /// Why nothing can be drawn here, "" if it can.
    const QString& drawing_error() const { return error_; }
    /// Live: where pictures take too long the scene is drawn coarser, words never (DrawingPace). Else the
    /// resolution is the renderer's own, as at first.
    void set_paced(bool paced);
    DrawingPace& pace() { return pace_; }
    /// Of the view's own pixels along each side: what the last picture of the scene was drawn in.
    double resolution() const { return resolution_; }
    /// Pictures of the scene that were drawn since load().
    int pictures() const { return pictures_; }
    /// When the newest picture was on the window in which tissue is pale under a tip, or is dented, and was
    /// not in the one before; ns of the steady clock, 0: none since load().
    std::int64_t pale_at() const { return pale_.at; }
    std::int64_t dented_at() const { return dented_.at; }
    /// The last picture has it.
    bool is_pale() const { return pale_.shown; }
    bool is_dented() const { return dented_.shown; }
    /// Duration of the last picture, ms: all of it, on this thread.
    double last_frame_ms() const { return frame_ms_; }

  signals:
    void loaded();
    void load_failed(const QString& why);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    /// Something that comes and goes in the pictures.
    struct Appearance {
        bool shown = false;
        std::int64_t at = 0;
        void see(bool now_shown, std::int64_t now) {
            if (now_shown && !shown) at = now;
            shown = now_shown;
        }
    };
    /// Notes what the picture shows that was just drawn.
    void note_appearances();
    /// The frame for the world to show, as the attempt stands.
    SceneFrame& assemble();
    /// Paints the scene; false where there is none to paint.
    bool paint_scene(QPainter& painter);
    void paint_words(QPainter& painter);
    Scene scene_;
    WorldSnapshot world_;
    HudState hud_;
    std::vector<bool> done_;
    int active_ = -1, covered_foot_ = 0;
    bool touched_ = false, has_world_ = false, has_hud_ = false, installed_ = false, strained_ = false;
    QString notice_, cover_heading_, error_;
    QStringList cover_lines_;
    std::optional<Realignment> realignment_;
    std::optional<GhostPoint> ghost_;
    double frame_ms_ = 0, resolution_ = 0;
    DrawingPace pace_;
    bool paced_ = false;
    int pictures_ = 0;
    Appearance pale_, dented_;
    std::unique_ptr<SceneAssembler> assembler_;
    std::unique_ptr<OffscreenStage> stage_;  // made at the first picture
    std::unique_ptr<SceneRenderer> renderer_;
    ScopePicture scope_;
    BackgroundJob* job_ = nullptr;
};

}  // namespace fulcrum::ui
