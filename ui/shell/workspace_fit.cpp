// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/workspace_fit.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <cmath>

#include "ui/language/language.h"
#include "ui/page/background_job.h"
#include "ui/shell/workspace_view.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/theatre/begin_place.h"

namespace fulcrum::ui {
namespace {
constexpr double room_to_spare = 1.05;
constexpr double close_m = 0.01;  // to the place to begin at
}  // namespace

int fitting_percent(double scale_to_fit) {
    for (const int percent : motion_percents)
        if (percent >= 100 && 0.01 * percent >= room_to_spare * scale_to_fit) return percent;
    return motion_percents[std::size(motion_percents) - 1];
}

WorkspaceFit::WorkspaceFit(Context& context, std::function<void()> changed)
    : context_(context), changed_(std::move(changed)), task_(new QComboBox) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(make_label(tr("Reach"), "neutral"));
    column->addWidget(make_label(
        tr("The frame is where the device can be moved, the dashed box what the task needs of it. Hold the "
           "handle at the ring when an attempt begins. Seen from the side you are on the right."),
        "muted"));
    auto* row_holder = new QWidget;
    auto* row = new FlowRow(row_holder);
    task_->setObjectName(QStringLiteral("reach_task"));
    task_->setAccessibleName(tr("Task"));
    task_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    task_->setMinimumContentsLength(6);
    auto* title = new QLabel(tr("Task"));
    title->setBuddy(task_);
    row->add(title);
    row->add(task_);
    fit_ = make_button(tr("Fit the movement to the task"), "fit_motion");
    row->add(fit_);
    ring_ = new QCheckBox(tr("An attempt begins when the handle is at the ring"));
    ring_->setObjectName(QStringLiteral("begin_at_ring"));
    ring_->setAccessibleName(ring_->text());
    row->add(ring_);
    column->addWidget(row_holder);
    auto* views = new QWidget;
    auto* both = new FlowRow(views);
    const char* const names[] = {"workspace_left", "workspace_right"};
    for (int h = 0; h < hand_count; ++h) {
        view_[h] = new WorkspaceView;
        view_[h]->setObjectName(QLatin1String(names[h]));
        both->add(view_[h]);
    }
    column->addWidget(views);
    lines_ = make_label({});
    lines_->setObjectName(QStringLiteral("reach_lines"));
    column->addWidget(lines_);
    connect(task_, QOverload<int>::of(&QComboBox::activated), this, [this] { look(); });
    connect(fit_, &QPushButton::clicked, this, [this] { fit(); });
    connect(ring_, &QCheckBox::toggled, this, [this](bool wanted) {
        DeviceService& devices = context_.services();
        devices.set_begins_at_ring(devices.device_in_use().kind, wanted);
    });
}

const DeviceReadings::Slot* WorkspaceFit::slot_of(int hand) const {
    DeviceService& devices = context_.services();
    return slot_of_hand(readings_, devices.slot_choice(devices.device_in_use().kind), hand);
}

void WorkspaceFit::show_readings(const DeviceReadings& readings) {
    readings_ = readings;
    const bool known = slot_of(0) != nullptr || slot_of(1) != nullptr;
    setVisible(known);
    if (!known) return;
    if (task_->count() == 0) {
        for (const TaskDefinition& task : context_.services().tasks()) {
            task_->addItem(text(task.id), text(task.id));
            task_->setItemData(task_->count() - 1, context_.task_title(task.id), Qt::ToolTipRole);
        }
        // The first with instruments.
        task_->setCurrentIndex(std::max(0, task_->findData(QStringLiteral("A2"))));
    }
    look();
    draw();
}

void WorkspaceFit::look() {
    const std::string task = task_->currentData().toString().toStdString();
    if (job_ != nullptr || task.empty() || task == known_) return;
    auto found = std::make_shared<SceneReach>();
    job_ = BackgroundJob::run(
        this, [found, reach = context_.services().scene_reach(task)](const Progress&) { *found = reach(); },
        [this, found, task] {
            job_ = nullptr;
            known_ = task;
            reach_ = *found;
            look();  // another one may have been chosen
            draw();
        },
        [this, task](const QString& why) {
            job_ = nullptr;
            known_ = task;
            reach_ = {};
            context_.complain(why);
        });
}

void WorkspaceFit::fit() {
    double needed_scale = 0;
    for (int h = 0; h < hand_count; ++h) {
        const auto& scene = reach_[static_cast<std::size_t>(h)];
        const DeviceReadings::Slot* const slot = slot_of(h);
        if (scene && slot != nullptr)
            needed_scale = std::max(needed_scale, scale_to_fit(*slot->workspace, *scene));
    }
    if (needed_scale == 0) return;
    DeviceService& devices = context_.services();
    devices.set_motion_scale(devices.device_in_use().kind, 0.01 * fitting_percent(needed_scale));
    changed_();
    draw();
}

QString WorkspaceFit::line_of(int hand, const DeviceReadings::Slot& slot, double motion) {
    const auto& scene = reach_[static_cast<std::size_t>(hand)];
    const QString name = hand == 0 ? tr("Left hand") : tr("Right hand");
    const Vector3 size = 1e3 * slot.workspace->size();
    QString line = tr("%1: workspace %2 × %3 × %4 mm (across, up, deep).")
                       .arg(name, decimal(size.x(), 0), decimal(size.y(), 0), decimal(size.z(), 0));
    if (!scene) return line + QLatin1Char(' ') + tr("This task has nothing for this hand.");
    const Vector3 begin = place_to_begin(*slot.workspace, *scene, motion);
    const double best = reached_share(*slot.workspace, *scene, motion, begin);
    const auto percent = [](double share) { return decimal(std::floor(100 * share + 1e-9), 0); };
    line += QLatin1Char(' ') + (best >= 1 - 1e-9
                                    ? tr("All of the scene is reached from the ring.")
                                    : tr("%1 % of the scene is reached from the ring.").arg(percent(best)));
    if (!slot.present || !slot.position.allFinite()) return line;
    const double now = reached_share(*slot.workspace, *scene, motion, slot.position);
    const Vector3 step = begin - slot.position;
    if (step.norm() <= close_m) return line + QLatin1Char(' ') + tr("The handle is at the ring.");
    return line + QLatin1Char(' ') +
           tr("From where the handle is now: %1 %. The ring is %2.").arg(percent(now), step_words(step));
}

void WorkspaceFit::draw() {
    DeviceService& devices = context_.services();
    const std::string kind = devices.device_in_use().kind;
    const double motion = devices.motion_scale(kind);
    const QSignalBlocker silent(ring_);
    ring_->setChecked(devices.begins_at_ring(kind));
    QStringList lines;
    bool any = false;
    for (int h = 0; h < hand_count; ++h) {
        const DeviceReadings::Slot* const slot = slot_of(h);
        view_[h]->setVisible(slot != nullptr);
        if (slot == nullptr) continue;
        WorkspacePicture picture;
        picture.workspace = *slot->workspace;
        const auto& scene = reach_[static_cast<std::size_t>(h)];
        if (scene) {
            any = true;
            picture.begin = place_to_begin(picture.workspace, *scene, motion);
            picture.scene = needed(*scene, motion, picture.begin);
        }
        if (slot->present && slot->position.allFinite()) picture.hand = slot->position;
        view_[h]->show_picture(h == 0 ? tr("Left hand") : tr("Right hand"), picture);
        lines << line_of(h, *slot, motion);
    }
    fit_->setEnabled(any);
    lines_->setText(lines.join(QLatin1Char('\n')));
}

}  // namespace fulcrum::ui

#include "moc_workspace_fit.cpp"
