// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/trainee/briefing_page.h"

#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QRadioButton>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "assessment/assets/fidelity_cost.h"
#include "database/records/assessed_attempts.h"
#include "database/records/attempts.h"
#include "database/records/curricula.h"
#include "database/records/report_data.h"
#include "database/records/standings.h"
#include "database/scoring/fidelity_now.h"
#include "sim_core/scene/fidelity.h"
#include "ui/page/store_reading.h"
#include "ui/services/device_in_scene.h"
#include "ui/style/flow_row.h"
#include "ui/style/palette.h"
#include "ui/style/standing_badge.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"
#include "ui/theatre/scene_picture.h"
#include "ui/trainee/judged_card.h"

namespace fulcrum::ui {
namespace {

/// What the hands are moved with, where that is not mouse and keyboard.
QString device_words(const DeviceInUse& device) {
    const QString title = QCoreApplication::translate("fulcrum::device_list", device.title.c_str());
    if (device.two_mice)
        return BriefingPage::tr(
            "One mouse for each hand: practice only. No limits exist for two mice; your score is compared "
            "with those of mouse and keyboard, where the task has them. F1 shows what the buttons do.");
    if (device.practice_only == PracticeOnly::scripted)
        return BriefingPage::tr(
                   "A script moves the hands (%1): practice only. What it does not have is moved "
                   "with mouse and keyboard; F1 shows the keys.")
            .arg(title);
    if (device.device_class != window_device)
        return BriefingPage::tr(
                   "You work with: %1. What it does not have is moved with mouse and keyboard; "
                   "F1 shows the keys.")
            .arg(title);
    return {};
}

/// Why the task cannot be assessed here.
QString practice_only(const TaskDefinition& task, DeviceClass used) {
    QStringList named;
    for (const DeviceClass one : task.device_classes) named << device_class_text(one);
    return BriefingPage::tr("With %1 this task is practice only; it is assessed with: %2.")
        .arg(device_class_text(used), named.join(QStringLiteral(", ")));
}

}  // namespace

BriefingPage::BriefingPage(Context& context) : Page(context, "briefing_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(14);
    QPushButton* back = make_button(tr("← Home"), "briefing_back", "link");
    connect(back, &QPushButton::clicked, this, [this] { emit this->context().home_wanted(); });
    layout->addWidget(back, 0, Qt::AlignLeft);
    title_ = make_label({}, "title");
    layout->addWidget(title_);
    briefing_ = make_label({});
    layout->addWidget(briefing_);

    layout->addLayout(make_variants());
    auto* row = new QHBoxLayout;
    row->setSpacing(14);
    picture_ = new ScenePicture(context);
    row->addWidget(picture_, 1);
    QFrame* steps_card = make_card(8);
    steps_ = card_layout(steps_card);
    row->addWidget(steps_card, 1);
    layout->addLayout(row);
    judged_ = new JudgedCard;
    connect(judged_, &JudgedCard::metric_chosen, this,
            [this](const QString& id) { emit this->context().metric_wanted(id, {}, -1); });
    layout->addWidget(judged_);

    QFrame* start_card = make_card(8);
    card_layout(start_card)->addWidget(make_label(tr("Does it count?"), "heading"));
    assessed_ =
        new QRadioButton(in_lines(tr("Assessed: it counts from the first movement, even if you abandon it."),
                                  fontMetrics(), widest_line));
    assessed_->setObjectName(QStringLiteral("mode_assessed"));
    practice_ = new QRadioButton(
        in_lines(tr("Practice: it is scored and kept, but does not count."), fontMetrics(), widest_line));
    practice_->setObjectName(QStringLiteral("mode_practice"));
    card_layout(start_card)->addWidget(assessed_);
    card_layout(start_card)->addWidget(practice_);
    card_layout(start_card)->addLayout(make_beginning());
    mode_note_ = make_label({}, "muted");
    mode_note_->setObjectName(QStringLiteral("mode_note"));
    card_layout(start_card)->addWidget(mode_note_);
    tissue_note_ = make_label({});
    tissue_note_->setObjectName(QStringLiteral("tissue_note"));
    card_layout(start_card)->addWidget(tissue_note_);
    fidelity_note_ = make_label({}, "muted");
    fidelity_note_->setObjectName(QStringLiteral("fidelity_note"));
    card_layout(start_card)->addWidget(fidelity_note_);
    start_ = make_button({}, "start_attempt", "primary");
    watch_ = make_button(tr("Watch an expert do it"), "watch_demonstration");
    watch_->setToolTip(tr("A simulated expert performs the task. Nothing is stored. Press Esc to stop."));
    QPushButton* history = make_button(tr("My attempts and learning curve"), "briefing_progress");
    connect(history, &QPushButton::clicked, this, [this] {
        emit this->context().progress_wanted(text(this->context().session().person_id()), text(task_id_));
    });
    auto* buttons = new FlowRow;
    for (QPushButton* button : {start_, watch_, history}) buttons->add(button);
    card_layout(start_card)->addLayout(buttons);
    layout->addWidget(start_card);
    layout->addStretch(1);
    connect(start_, &QPushButton::clicked, this, [this] {
        const bool assessed = assessed_->isChecked();
        emit this->context().attempt_wanted(
            text(task_id_), assessed, assessed ? 0 : begin_at_->currentData().toInt(),
            !assessed && !ghost_->isHidden() && ghost_->isChecked(), text(variant()));
    });
    connect(watch_, &QPushButton::clicked, this,
            [this] { emit this->context().demonstration_wanted(text(task_id_), text(variant())); });
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 1000));
    reading_ = new StoreReading(context, this);
}

/// The scene in which the task is performed.
QLayout* BriefingPage::make_variants() {
    auto* row = new FlowRow;
    variant_words_ = make_label(tr("Variant"));
    variant_words_->setWordWrap(false);
    variants_ = new QComboBox;
    variants_->setObjectName(QStringLiteral("variants"));
    variants_->setAccessibleName(tr("Variant"));
    variants_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    variant_note_ = make_label({}, "muted");
    variant_note_->setObjectName(QStringLiteral("variant_note"));
    row->add(variant_words_);
    row->add(variants_);
    row->add(variant_note_, 1, with_text(160));
    connect(variants_, QOverload<int>::of(&QComboBox::activated), this, [this] {
        wanted_variant_ = variant();
        if (const TaskDefinition* task = context().task(task_id_)) show_variant(*task);
    });
    return row;
}

std::string BriefingPage::variant() const {
    return plain(variants_->currentData().toString());
}

/// Each with how often it was practised; chosen is the one asked for, else the one practised least.
void BriefingPage::fill_variants(const TaskDefinition& task) {
    std::map<std::string, database::VariantPractice> practised;
    const database::Session& session = context().session();
    if (context().allowed(database::Operation::read_attempt, database::Subject::person(session.person_id())))
        context().guarded([&] {
            practised =
                database::Attempts(context().store()).practised(session, session.person_id(), task_id_);
        });
    std::map<std::string, int> attempts;
    for (const auto& [id, practice] : practised) attempts[id] = practice.attempts;
    const std::string least = next_variant(task, attempts);
    variants_->clear();
    for (const TaskVariant& one : task.variants) {
        const int count = attempts.count(one.id) > 0 ? attempts.at(one.id) : 0;
        variants_->addItem(count == 0 ? tr("%1 (not practised yet)").arg(asset_text(one.title))
                                      : tr("%1 (attempts: %2)").arg(asset_text(one.title)).arg(count),
                           text(one.id));
    }
    const int asked = variants_->findData(text(wanted_variant_));
    variants_->setCurrentIndex(asked >= 0 ? asked : variants_->findData(text(least)));
    const bool several = task.variants.size() > 1;
    variant_words_->setVisible(several);
    variants_->setVisible(several);
    variant_note_->setVisible(several);
}

/// Where practice begins, and with a ghost or without.
QLayout* BriefingPage::make_beginning() {
    auto* beginning = new FlowRow;
    begin_words_ = make_label(tr("Begin at"));
    begin_words_->setWordWrap(false);
    begin_at_ = new QComboBox;
    begin_at_->setObjectName(QStringLiteral("begin_at"));
    begin_at_->setAccessibleName(tr("Begin practice at"));
    begin_at_->setToolTip(
        tr("From a later goal on, a simulated expert does what comes before. Such a practice run is "
           "never scored."));
    // As long as a goal's sentence is: it takes what is left of its line.
    begin_at_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    begin_at_->setMinimumContentsLength(18);
    beginning->add(begin_words_);
    beginning->add(begin_at_, 1);
    ghost_ = new QCheckBox(tr("Show an expert's instruments"));
    ghost_->setObjectName(QStringLiteral("with_ghost"));
    ghost_->setToolTip(
        tr("Translucent instruments show an expert's next movement and wait for you. The scene is the one in "
           "which the expert was simulated."));
    beginning->add(ghost_);
    connect(practice_, &QRadioButton::toggled, begin_at_, &QWidget::setEnabled);
    connect(practice_, &QRadioButton::toggled, ghost_, &QWidget::setEnabled);
    return beginning;
}

void BriefingPage::set_task(const std::string& task_id, const std::string& variant, int goal, bool ghost) {
    task_id_ = task_id;
    wanted_variant_ = variant;
    wanted_goal_ = goal;
    begin_at_->clear();
    ghost_->setChecked(ghost);
    practice_->setChecked(true);
}

void BriefingPage::enter() {
    fill();
    start_->setFocus();
}

void BriefingPage::leave() {
    reading_->stop();
}

/// The goals that practice can begin at; the choice made for this task stays.
void BriefingPage::fill_beginnings(const TaskDefinition& task) {
    const bool parts = task.goals.size() > 1;
    begin_words_->setVisible(parts);
    begin_at_->setVisible(parts);
    const bool scope_alone =
        !task.goals.empty() && type_of(task.goals.front().kind).site == GoalSite::camera_targets;
    ghost_->setVisible(!scope_alone);  // a scope has no instrument to show
    if (begin_at_->count() > 0) return;
    begin_at_->addItem(tr("the beginning"), 0);
    for (std::size_t goal = 1; goal < task.goals.size(); ++goal) {
        begin_at_->addItem(QStringLiteral("%1.  %2").arg(goal + 1).arg(asset_text(task.goals[goal].text)),
                           static_cast<int>(goal));
    }
    begin_at_->setCurrentIndex(std::max(0, begin_at_->findData(wanted_goal_)));
}

BriefingPage::InCurriculum BriefingPage::in_curriculum(DeviceClass used) {
    const Curriculum* followed = nullptr;
    std::string missing;
    std::vector<TaskStanding> standings;
    context().guarded([&] {
        const database::Session& session = context().session();
        if (!context().allowed(database::Operation::read_progress,
                               database::Subject::person(session.person_id())))
            return;
        const PersonRecord record =
            database::Standings(context().store())
                .record(session, session.person_id(), context().services().curriculum());
        const std::int64_t now = context().store().now();
        standings = standing_of(record, now);
        followed = curriculum_at(record.assignments, now);
        missing = database::missing_in(record.assignments, now);
    });
    if (followed == nullptr) return {};
    if (!missing.empty())
        return {tr("You follow the curriculum %1, which is not at this station. Until it is, you can only "
                   "practise this task.")
                    .arg(text(missing)),
                {}};
    const CurriculumTask* counted = followed->find(task_id_);
    if (counted == nullptr)
        return {{},
                tr("This task is not part of your curriculum (%1): assessed attempts are scored, but lead to "
                   "no proficiency.")
                    .arg(text(followed->name()))};
    for (const TaskStanding& one : standings)
        if (one.task == task_id_ && one.standing == Standing::locked)
            return {tr("This task is %1. Until then, you can only practise it.").arg(standing_text(one)), {}};
    if (counts(*counted, used)) return {};
    QStringList named;
    for (const DeviceClass one : counted->device_classes) named << device_class_text(one);
    if (database::builds_limits(context().session()))
        return {{},
                tr("With %1 your curriculum (%2) does not count this task, but with: %3. Because you may "
                   "build limits, the attempt can be assessed: for a benchmark set, not for your standing.")
                    .arg(device_class_text(used), text(followed->name()), named.join(QStringLiteral(", ")))};
    return {tr("With %1 this task is practice only: your curriculum (%2) counts it with: %3.")
                .arg(device_class_text(used), text(followed->name()), named.join(QStringLiteral(", "))),
            {}};
}

DeviceInUse BriefingPage::device() {
    DeviceInUse device = context().services().device_in_use();
    const TaskDefinition* task = context().task(task_id_);
    const bool is_open =
        std::any_of(std::begin(device.drives), std::end(device.drives), [](bool drives) { return drives; });
    if (task != nullptr && is_open)
        context().guarded(
            [&] { device = device_in_scene(device, context().services().scene_for(*task, variant())); });
    return device;
}

QString BriefingPage::why_files() {
    std::vector<database::AssetFile> unknown;
    context().guarded([&] {
        unknown =
            context().services().unknown_assets(context().session(), task_id_, device_class_, variant());
    });
    if (unknown.empty()) return {};
    QStringList files;
    for (const database::AssetFile& file : unknown)
        files << tr("%1 (sha256 %2)").arg(text(file.name), text(file.digest));
    return tr("Here this task is practice only: it uses files that are neither part of this program nor "
              "accepted by the programme: %1. An educator can accept them.")
        .arg(files.join(QStringLiteral(", ")));
}

void BriefingPage::fill() {
    clear_layout(steps_);
    title_->setText(context().task_title(task_id_));
    const TaskDefinition* task = context().task(task_id_);
    variants_->clear();
    start_->setEnabled(task != nullptr);
    watch_->setEnabled(task != nullptr);
    start_->setText(button_text(tr("Start as %1").arg(text(context().session().display_name()))));
    if (task == nullptr) {
        assessed_->setEnabled(false);
        practice_->setChecked(true);
        return;
    }
    fill_variants(*task);
    fill_beginnings(*task);
    briefing_->setText(asset_text(task->briefing));
    steps_->addWidget(make_label(tr("What to do"), "heading"));
    int number = 0;
    for (const std::string& step : task->steps) {
        steps_->addWidget(make_label(QStringLiteral("%1.  %2").arg(++number).arg(asset_text(step))));
    }
    steps_->addWidget(make_label(
        tr("Time limit %1 · Outcome: %2").arg(minutes_text(task->time_limit_s), asset_text(task->product)),
        "muted"));
    steps_->addStretch();
    show_variant(*task);
    show_fidelity_note();
}

void BriefingPage::show_modes(const TaskDefinition& task) {
    const bool demo = context().store().is_demo();
    const DeviceInUse device = this->device();
    device_class_ = device.device_class;
    const bool assessable =
        can_be_assessed(task, device.device_class) && device.practice_only == PracticeOnly::no;
    const InCurriculum curriculum = in_curriculum(device.device_class);
    const QString own_files = assessable ? why_files() : QString();
    assessed_->setEnabled(!demo && assessable && curriculum.refusal.isEmpty() && own_files.isEmpty());
    if (!assessed_->isEnabled()) practice_->setChecked(true);
    begin_at_->setEnabled(practice_->isChecked());
    ghost_->setEnabled(practice_->isChecked());
    const bool scope_alone =
        !task.goals.empty() && type_of(task.goals.front().kind).site == GoalSite::camera_targets;
    const QString hands =
        scope_alone
            ? tr("You hold the scope with mouse and keyboard. F1 shows the keys.")
            : tr("You work with mouse and keyboard: force is shown as bars, not felt. F1 shows the keys.");
    const QString with_device = device_words(device).isEmpty() ? hands : device_words(device);
    mode_note_->setText(
        demo                                       ? tr("The demonstration accepts practice attempts only.")
        : device.practice_only != PracticeOnly::no ? with_device
        : !assessable          ? with_device + QStringLiteral(" ") + practice_only(task, device.device_class)
        : !own_files.isEmpty() ? with_device + QStringLiteral(" ") + own_files
        : !curriculum.refusal.isEmpty() ? with_device + QStringLiteral(" ") + curriculum.refusal
        : !curriculum.remark.isEmpty()  ? with_device + QStringLiteral(" ") + curriculum.remark
                                        : with_device);
}

void BriefingPage::show_variant(const TaskDefinition& task) {
    variant_note_->setText(variant() == wanted_variant_
                               ? tr("The variant practised least comes next unless you choose one.")
                               : tr("Chosen because you have practised it least."));
    show_modes(task);
    picture_->show_task(task, variant());
    judged_->open(task, limits(), {});
    read_own_values();
    show_notes();
}

std::vector<JudgedLimit> BriefingPage::limits() {
    std::vector<JudgedLimit> judged;
    context().guarded([&] {
        judged = context().services().judged_limits(context().session(), task_id_, device_class_, variant());
    });
    return judged;
}

void BriefingPage::read_own_values() {
    reading_->stop();
    if (!context().allowed(database::Operation::read_progress,
                           database::Subject::person(context().session().person_id())))
        return;
    reading_->begin(
        [of = task_id_, device = device_class_](const database::Store& store,
                                                const database::Session& session) {
            return last_values(database::Reports(store).person_progress(session, session.person_id(), of),
                               device);
        },
        [this](const std::vector<database::MetricRow>& values) {
            if (!values.empty()) judged_->show_own(limits(), values);
        },
        [](const QString&) {});
}

namespace {

QString level_text(const std::string& fidelity) {
    const NameRow<FidelityLevel>* row = find_row(fidelity_levels, fidelity);
    return row == nullptr ? text(fidelity) : QCoreApplication::translate("fulcrum::fidelity", row->title);
}

}  // namespace

/// What the fidelities cost in score; the window runs the scene's own.
void BriefingPage::show_fidelity_note() {
    std::optional<TaskFidelityCost> costs;
    bool now = true;
    context().guarded([&] {
        costs = fidelity_cost(task_id_);
        now = !costs || measured_as_now(*costs, task_id_);
    });
    if (!costs) {
        fidelity_note_->setText(
            tr("The effect of the simulation's level of detail on the score has not been measured for this "
               "task."));
        return;
    }
    QStringList lines;
    for (const FidelityCost& cost : costs->levels) {
        if (cost.fidelity == finest_fidelity()) continue;
        QStringList parts;
        if (!cost.metric.empty()) {
            QString metric = metric_text(cost.metric);
            if (!cost.hand.empty()) metric += QStringLiteral(", ") + hand_text(cost.hand);
            parts << tr("%1 differs by %2 %").arg(metric, figure(std::fabs(cost.shift_percent)));
        }
        if (cost.verdicts > 0) parts << tr("%1 of %2 verdicts differ").arg(cost.verdicts).arg(cost.attempts);
        lines << tr("%1: %2").arg(level_text(cost.fidelity),
                                  parts.isEmpty() ? tr("the same score") : parts.join(QStringLiteral("; ")));
    }
    QString note =
        tr("Effect of the simulation's level of detail on the score, compared with the level \"%1\": %2.")
            .arg(level_text(finest_fidelity()), lines.join(QStringLiteral(". ")));
    if (!now)
        note += QStringLiteral(" ") +
                tr("Measured with an earlier version of the simulation, the metrics or the limits.");
    fidelity_note_->setText(note);
}

void BriefingPage::show_notes() {
    SiteTissues site;
    Statement limits;
    context().guarded([&] {
        site = context().services().site_tissues(context().session(), task_id_);
        limits =
            context().services().why_not_comparable(context().session(), task_id_, device_class_, variant());
    });
    QString note;
    if (site.differ)
        note = tr("This site uses its own tissue values (version %1); its cutting parameters differ from "
                  "those of the scene.")
                   .arg(site.version);
    const QString gap = note.isEmpty() ? QString() : QStringLiteral(" ");
    if (!limits.empty())
        note += gap + tr("Gates based on the experts' range are not scored: %1.").arg(statement_text(limits));
    tissue_note_->setText(note);
    tissue_note_->setVisible(!note.isEmpty());
}

}  // namespace fulcrum::ui

#include "moc_briefing_page.cpp"
