// SPDX-License-Identifier: GPL-3.0-or-later
// A stored attempt seen again: the scope's picture, a scrubber by time, ×0.1 to ×10, single steps.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <memory>

#include "ui/review/attempt_model.h"
#include "ui/services/replay_source.h"

class QComboBox;
class QLabel;
class QPushButton;
class QSlider;

namespace fulcrum::ui {

class TheatreView;

class ReplayPanel : public QWidget {
    Q_OBJECT
  public:
    explicit ReplayPanel(QWidget* parent = nullptr);
    ~ReplayPanel() override;
    /// From here on the scrubber moves the charts; the picture comes with set_record().
    void open(std::shared_ptr<const AttemptModel> model, const TaskDefinition* task);
    /// `model` with its trace. `source` null: there is no picture, and why.
    void set_record(std::shared_ptr<const AttemptModel> model, std::unique_ptr<ReplaySource> source,
                    const QString& why_no_picture);
    void close();
    double time() const { return time_; }
    /// s that the picture shows; behind time() until the re-simulation has come there. < 0: there is no
    /// picture.
    double shown_time() const { return source_ && loaded_ ? source_->shown_s() : -1; }
    bool is_playing() const { return playing_; }
    /// Without telling time_changed's listeners twice.
    void seek(double time);
    void play(bool on);
    void set_speed(double factor);
    void step(int steps);

    /// The picture alone, smaller and without clock and forces: what steers it and says more is elsewhere.
    void show_picture_alone();
    /// Offers practice from the moment shown.
    void offer_practice(bool offered);

  signals:
    void time_changed(double time);
    void practice_wanted(std::shared_ptr<const fulcrum::ui::ReplayMoment> from);

  private:
    void tick();
    void show_time();
    void show_state();
    void fill_hud();
    void practise();

    std::shared_ptr<const AttemptModel> model_;
    std::unique_ptr<TickReader> ticks_;  ///< of the model's trace
    std::unique_ptr<ReplaySource> source_;
    const TaskDefinition* task_ = nullptr;
    TheatreView* view_;
    QSlider* slider_;
    QLabel *clock_, *state_;
    QPushButton *play_, *back_, *forward_, *practise_;
    QComboBox* speed_;
    QTimer timer_;
    QElapsedTimer since_;
    double time_ = 0, factor_ = 1;
    QString notice_;      ///< why practice could not begin, until another moment is chosen
    bool waits_ = false;  ///< that was because the moment was not prepared
    bool playing_ = false, loaded_ = false, alone_ = false;
};

}  // namespace fulcrum::ui
