// SPDX-License-Identifier: GPL-3.0-or-later
// Before an attempt: the picture of the scene, what to do, what is judged as bars; assessed or practice;
// *Start as NAME*.
#pragma once

#include "ui/page/context.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QLayout;
class QPushButton;
class QRadioButton;
class QVBoxLayout;

namespace fulcrum::ui {

class JudgedCard;
class ScenePicture;
class StoreReading;

class BriefingPage : public Page {
    Q_OBJECT
  public:
    explicit BriefingPage(Context& context);
    /// `variant` empty: the one practised least. `goal`, `ghost`: where practice begins, and with a ghost.
    void set_task(const std::string& task_id, const std::string& variant = {}, int goal = 0,
                  bool ghost = false);
    void enter() override;
    void leave() override;

  private:
    QLayout* make_beginning();
    QLayout* make_variants();
    void fill();
    void fill_variants(const TaskDefinition& task);
    /// What depends on the variant: whether it can count, picture, limits, notes.
    void show_variant(const TaskDefinition& task);
    /// Whether an attempt can count, and why it cannot; sets device_class_.
    void show_modes(const TaskDefinition& task);
    std::string variant() const;
    /// What the curriculum that the signed-in person follows says of an assessed attempt now.
    struct InCurriculum {
        QString refusal;  ///< why it does not count (yet); empty where it does
        QString remark;   ///< it can be assessed, but counts for no standing; else empty
    };
    InCurriculum in_curriculum(DeviceClass used);
    /// Why the installed files make it practice only; empty where they do not.
    QString why_files();
    /// What an attempt at this task and variant would be made with.
    DeviceInUse device();
    std::vector<JudgedLimit> limits();
    /// Of the last attempt of who is signed in, in the background: the limits are shown without them first.
    void read_own_values();
    void show_notes();
    void show_fidelity_note();
    void fill_beginnings(const TaskDefinition& task);
    std::string task_id_, wanted_variant_;
    int wanted_goal_ = 0;
    DeviceClass device_class_ = window_device;  ///< of device(), for the variant that is shown
    QLabel *title_, *briefing_, *mode_note_, *tissue_note_, *fidelity_note_;
    QVBoxLayout* steps_;
    ScenePicture* picture_;
    JudgedCard* judged_;
    StoreReading* reading_;
    QRadioButton *assessed_, *practice_;
    QLabel* begin_words_;
    QLabel *variant_words_, *variant_note_;
    QComboBox* variants_;  ///< data: id
    QComboBox* begin_at_;  ///< data: goal
    QCheckBox* ghost_;
    QPushButton *start_, *watch_;
};

}  // namespace fulcrum::ui
