// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/compare_page.h"

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QTabWidget>
#include <QTimer>
#include <algorithm>
#include <cmath>

#include "ui/charts/chart_frame.h"
#include "ui/charts/time_charts.h"
#include "ui/page/background_job.h"
#include "ui/reports/void_words.h"
#include "ui/review/comparison_table.h"
#include "ui/review/part_choice.h"
#include "ui/review/replay_panel.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr double play_speeds[] = {0.1, 0.25, 0.5, 1, 2, 5, 10};

QString compared_words(const ComparedSide& side) {
    const database::AttemptSummary& attempt = side.model.summary;
    const bool voided = attempt.state == AttemptState::voided;  // then this is said in place of its result
    const std::optional<bool> passed = side.model.score ? side.model.score->passed : attempt.passed;
    const std::optional<double> points = side.model.score ? side.model.score->points : attempt.points;
    return join_with_dots(
        {attempt.meta.id.empty() ? ComparePage::tr("Expert of the benchmark (simulated)")
                                 : text(attempt.person_name),
         attempt.meta.id.empty() ? QString() : local_time(attempt.meta.started),
         voided ? attempt_state(attempt.state) : verdict(passed, attempt.provisional),
         !voided && points && passed ? points_text(*points) : QString(),
         ComparePage::tr("duration %1").arg(clock_text(side.model.duration - side.model.begin))});
}

}  // namespace

ComparePage::ComparePage(Context& context) : Page(context, "compare_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(10);
    back_ = make_button(tr("← Back to the attempt"), "compare_back", "link");
    layout->addWidget(back_, 0, Qt::AlignLeft);
    title_ = make_label({}, "title");
    layout->addWidget(title_);
    job_bar_ = new JobBar;
    layout->addWidget(job_bar_);
    content_ = new QWidget;
    auto* content = new QVBoxLayout(content_);
    content->setContentsMargins(0, 0, 0, 0);
    content->setSpacing(10);
    auto* row = new FlowRow;
    QLabel* with = make_label(tr("Compare with"));
    with->setWordWrap(false);
    row->add(with);
    with_ = make_narrow_choice("compare_with", tr("Compare with"), 18);
    row->add(with_, 1, with_text(400));  // with large text on a line of its own
    content->addLayout(row);
    notes_ = make_label({}, "muted");
    notes_->setObjectName(QStringLiteral("compare_notes"));
    content->addWidget(notes_);
    content->addWidget(build_sides());
    steering_ = new QWidget;
    steering_->setLayout(build_steering());
    content->addWidget(steering_);
    part_ = new PartChoice(QStringLiteral("compare"));
    measure_ = new PartMeasure(this);
    content->addWidget(part_);
    content->addWidget(build_tabs(), 1);
    layout->addWidget(content_, 1);
    layout->addStretch(1);
    content_->hide();
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));
    connect_parts();
}

QWidget* ComparePage::build_sides() {
    sides_ = new QWidget;
    auto* row =
        new QBoxLayout(text_percent() > 150 ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight, sides_);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(12);
    const auto add = [row](QLabel*& words, ReplayPanel*& replay, const char* name) {
        QFrame* card = make_card(4);
        words = make_label({});
        words->setObjectName(QLatin1String(name) + QStringLiteral("_words"));
        replay = new ReplayPanel;
        replay->setObjectName(QLatin1String(name) + QStringLiteral("_replay"));
        replay->show_picture_alone();
        card_layout(card)->addWidget(words);
        card_layout(card)->addWidget(replay, 1);
        row->addWidget(card, 1);
        return card;
    };
    add(own_words_, own_replay_, "compare_own");
    other_side_ = add(other_words_, other_replay_, "compare_other");
    return sides_;
}

QLayout* ComparePage::build_steering() {
    auto* column = new QVBoxLayout;
    column->setContentsMargins(0, 0, 0, 0);
    slider_ = new QSlider(Qt::Horizontal);
    slider_->setObjectName(QStringLiteral("compare_slider"));
    slider_->setAccessibleName(tr("Moment of both attempts"));
    column->addWidget(slider_);
    auto* row = new FlowRow;
    play_ = make_button(tr("Play"), "compare_play", "primary");
    QPushButton* back = make_button(tr("◀ Step"), "compare_step_back");
    QPushButton* forward = make_button(tr("Step ▶"), "compare_step_forward");
    speed_ = make_narrow_choice("compare_speed", tr("Speed"), 5);
    for (const double speed : play_speeds) speed_->addItem(QStringLiteral("×%1").arg(speed), speed);
    speed_->setCurrentIndex(3);
    clock_ = make_label({});
    clock_->setObjectName(QStringLiteral("compare_clock"));
    for (QWidget* control : std::initializer_list<QWidget*>{play_, back, forward, speed_}) row->add(control);
    row->add(clock_, 1, with_text(200));
    column->addLayout(row);
    connect(slider_, &QSlider::valueChanged, this, [this](int value) { seek(value * 1e-2); });
    connect(play_, &QPushButton::clicked, this, [this] {
        own_replay_->play(!own_replay_->is_playing());
        play_->setText(own_replay_->is_playing() ? tr("Pause") : tr("Play"));
    });
    connect(back, &QPushButton::clicked, this, [this] { own_replay_->step(-1); });
    connect(forward, &QPushButton::clicked, this, [this] { own_replay_->step(1); });
    connect(speed_, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
            [this] { own_replay_->set_speed(speed_->currentData().toDouble()); });
    return column;
}

QWidget* ComparePage::build_tabs() {
    tabs_ = new QTabWidget;
    tabs_->setObjectName(QStringLiteral("compare_tabs"));
    auto* traces = new QWidget;
    auto* layout = new QVBoxLayout(traces);
    layout->setSpacing(4);
    auto* tools = new QWidget;
    auto* row = new FlowRow(tools);
    quantity_ = make_narrow_choice("compare_quantity", tr("What is drawn"), 8);
    quantity_->addItems({tr("Force"), tr("Speed")});
    row->add(quantity_);
    row->add(make_label(tr("Hold Shift and drag to choose a part."), "muted"), 1, with_text(200));
    for (std::size_t h = 0; h < hand_count; ++h) {
        charts_[h] = new TimeChart(h == 0 ? tr("left hand") : tr("right hand"));
        charts_[h]->setObjectName(h == 0 ? QStringLiteral("compare_left") : QStringLiteral("compare_right"));
        charts_[h]->setMinimumHeight(11 * fontMetrics().height());
        charts_[h]->offer_selection(true);
        charts_[h]->show_time_title(h == 1);
    }
    auto* drawn = new TimeCharts(tr("Force and speed"));
    drawn->add(charts_[0], tr("left hand"));
    drawn->add(charts_[1], tr("right hand"));
    frame_ = new ChartFrame(drawn, tr("Force and speed"), "compared_traces", tools);
    layout->addWidget(frame_, 1);
    layout->addWidget(make_label(TimeChart::key_words(), "muted"));
    tabs_->addTab(traces, tr("Force and speed"));
    table_ = new ComparisonTable;
    auto* metrics = new QWidget;
    auto* holder = new QVBoxLayout(metrics);
    holder->addWidget(table_);
    tabs_->addTab(metrics, tr("Metrics"));
    return tabs_;
}

void ComparePage::connect_parts() {
    connect(back_, &QPushButton::clicked, this,
            [this] { emit context().debrief_wanted(text(attempt_id_), own_ ? moment() : -1); });
    connect(job_bar_, &JobBar::cancelled, this, [this] {
        job_ = nullptr;
        if (own_ == nullptr) return context().debrief_wanted(text(attempt_id_), -1);
        notes_->setText(tr("Stopped. Choose again what to compare with."));
    });
    connect(with_, QOverload<int>::of(&QComboBox::activated), this, &ComparePage::choose);
    connect(quantity_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ComparePage::show_charts);
    connect(own_replay_, &ReplayPanel::time_changed, this, &ComparePage::time_changed);
    for (TimeChart* chart : charts_) {
        connect(chart, &TimeChart::time_chosen, this, &ComparePage::seek);
        connect(chart, &TimeChart::range_selected, part_, &PartChoice::choose);
    }
    connect(part_, &PartChoice::part_changed, this, &ComparePage::show_part);
    connect(part_, &PartChoice::step_begins, this, &ComparePage::seek);
    connect(measure_, &PartMeasure::failed, this, [this](const QString& why) { context().complain(why); });
    connect(measure_, &PartMeasure::measured, this, [this](const auto& of) {
        table_->show_pair(of[0], of.size() > 1 ? of[1] : std::vector<ComparedMetric>());
    });
}

bool ComparePage::is_ready() const {
    return own_ != nullptr && job_ == nullptr && !measure_->is_running() && !begins_next_;
}

void ComparePage::open(const std::string& attempt_id) {
    leave();
    attempt_id_ = attempt_id;
    database::AttemptSummary attempt;
    std::optional<Scene> scene;
    if (!context().guarded([&] {
            attempt = database::Attempts(context().store()).read(context().session(), attempt_id);
            choices_ = comparison_choices(context().store(), context().session(), attempt,
                                          context().task(attempt.meta.task_id));
            if (context().task(attempt.meta.task_id) != nullptr)
                scene = context().services().scene_of(context().session(), attempt);
        }))
        return;
    title_->setText(tr("Compare: %1").arg(context().task_title(attempt.meta.task_id)));
    const QSignalBlocker quiet(with_);
    with_->clear();
    for (const ComparisonChoice& one : choices_) with_->addItem(one.title);
    auto loaded = std::make_shared<std::optional<ComparedSide>>();
    run([loaded, attempt_id, scene, session = context().session()](
            const database::Store& store,
            const Progress& progress) { *loaded = load_side(store, session, attempt_id, scene, progress); },
        [this, loaded] {
            if (!*loaded) return;
            own_ = std::make_shared<const ComparedSide>(std::move(**loaded));
            own_loaded();
        },
        tr("Reading the attempt …"));
}

void ComparePage::enter() {
    back_->setFocus();
}

void ComparePage::leave() {
    stop();
    measure_->cancel();
    own_replay_->close();
    other_replay_->close();
    for (TimeChart* chart : charts_) chart->clear();
    frame_->show_chart();
    own_.reset();
    other_.reset();
    expert_.reset();
    pair_.reset();
    cohort_.reset();
    begins_next_ = false;
    content_->hide();
}

double ComparePage::moment() const {
    return own_replay_->time();
}

void ComparePage::own_loaded() {
    content_->show();
    own_words_->setText(tr("This attempt: %1").arg(compared_words(*own_)));
    sides_->setVisible(own_->has_trace());
    steering_->setVisible(own_->has_trace());
    tabs_->setTabEnabled(0, own_->has_trace() && !own_->model.scope_alone);
    const QSignalBlocker quiet(slider_);
    const int first = static_cast<int>(std::floor(own_->model.begin * 100));
    const int last = std::max(first + 1, static_cast<int>(std::ceil(own_->model.duration * 100)));
    slider_->setRange(first, last);
    slider_->setPageStep(std::max(1, (last - first) / 20));
    part_->open(own_->moments, context().task(own_->model.summary.meta.task_id), own_->model.begin,
                own_->model.duration, own_->has_trace());
    if (own_->has_trace()) {
        const auto model = std::make_shared<const AttemptModel>(own_->model);
        own_replay_->open(model, context().task(own_->model.summary.meta.task_id));
        QString why;
        std::unique_ptr<ReplaySource> picture = picture_of(*own_, why);
        own_replay_->set_record(model, std::move(picture), why);
    }
    if (choices_.empty()) {
        notes_->setText(tr("There is nothing to compare this attempt with."));
        other_side_->hide();
        show_charts();
        show_part();
        return;
    }
    with_->setCurrentIndex(0);
    // This job ends after this, and with it the bar: it has to be free for the next one.
    begins_next_ = true;
    QTimer::singleShot(0, own_words_, [this, shown = own_] {
        begins_next_ = false;
        if (shown == own_) choose(0);
    });
}

void ComparePage::other_loaded() {
    other_side_->setVisible(other_ != nullptr && own_->has_trace());
    if (other_ != nullptr) {
        other_words_->setText(tr("Other attempt: %1").arg(compared_words(*other_)));
        const auto model = std::make_shared<const AttemptModel>(other_->model);
        other_replay_->open(model, context().task(other_->model.summary.meta.task_id));
        QString why;
        std::unique_ptr<ReplaySource> picture = picture_of(*other_, why);
        other_replay_->set_record(model, std::move(picture), why);
    }
    QStringList notes = void_notes(own_->model.summary);
    if (other_ != nullptr)
        notes += comparison_notes(*own_, *other_, *pair_, context().task(own_->model.summary.meta.task_id));
    if (cohort_) notes += comparison_notes(*own_, *cohort_);
    notes_->setText(notes.join(QLatin1Char('\n')));
    show_charts();
    show_part();
    time_changed(moment());
}

void ComparePage::show_charts() {
    if (own_ == nullptr || !own_->has_trace()) return;
    const bool force = quantity_->currentIndex() == 0;
    std::vector<ChartMark> marks;
    const TaskDefinition* task = context().task(own_->model.summary.meta.task_id);
    for (const auto& [goal, time] : own_->moments.met) {
        const bool known =
            task != nullptr && goal >= 0 && static_cast<std::size_t>(goal) < task->goals.size();
        marks.push_back({time,
                         known ? asset_text(task->goals[static_cast<std::size_t>(goal)].text) : QString(),
                         &Palette::accent, false});
    }
    for (std::size_t h = 0; h < hand_count; ++h) {
        TimeChart& chart = *charts_[h];
        chart.clear();
        chart.setAccessibleName(
            h == 0 ? (force ? tr("Force of the left hand (N)") : tr("Speed of the left hand (mm/s)"))
                   : (force ? tr("Force of the right hand (N)") : tr("Speed of the right hand (mm/s)")));
        chart.set_unit(force ? QStringLiteral("N") : QStringLiteral("mm/s"));
        chart.show_peaks(force);
        chart.set_y_title(h == 0 ? (force ? tr("left (N)") : tr("left (mm/s)"))
                                 : (force ? tr("right (N)") : tr("right (mm/s)")));
        if (cohort_) {
            std::vector<ChartBand> band;
            for (const BandPoint& point : force ? cohort_->force[h] : cohort_->speed[h])
                band.push_back({point.time, point.spread.low, point.spread.middle, point.spread.high});
            if (!band.empty()) chart.add_band(tr("cohort"), &Palette::limit, band);
        }
        if (pair_ && other_->has_trace())
            chart.add_series(tr("other attempt"), &Palette::right_hand, Qt::DashLine,
                             force ? pair_->force[h] : pair_->speed[h]);
        chart.add_series(tr("this attempt"), &Palette::left_hand, Qt::SolidLine,
                         force ? own_->model.force[h] : own_->model.speed[h]);
        chart.set_marks(marks);
        chart.set_extent(own_->model.begin, own_->model.duration);
        chart.set_selection(part_->from(), part_->to());
        chart.show_all();
        chart.set_cursor(moment());
    }
}

void ComparePage::show_part() {
    if (own_ == nullptr) return;
    for (TimeChart* chart : charts_) chart->set_selection(part_->from(), part_->to());
    measure_->cancel();
    if (!part_->is_part()) return show_metrics();
    QString note;
    if (pair_ && other_->has_trace())
        note += tr("; other attempt %1 to %2")
                    .arg(clock_text(pair_->map.to_second(part_->from())),
                         clock_text(pair_->map.to_second(part_->to())));
    const bool measurable =
        context().task(own_->model.summary.meta.task_id) != nullptr && own_->scene.has_value();
    if (!measurable)
        note += tr("; no metrics of a part, because this program does not have the task");
    else if (cohort_)
        note += tr("; metrics of this attempt alone");
    part_->set_note(note);
    measure_part();
}

void ComparePage::show_metrics() {
    const TaskDefinition* task = context().task(own_->model.summary.meta.task_id);
    const std::vector<std::string> wanted = task == nullptr ? std::vector<std::string>() : task->metrics;
    const auto of = [&](const AttemptModel& model) {
        return model.score ? compared_metrics(model.score->metrics, wanted) : std::vector<ComparedMetric>();
    };
    if (cohort_)
        table_->show_cohort(of(own_->model), cohort_->metrics);
    else
        table_->show_pair(of(own_->model), other_ ? of(other_->model) : std::vector<ComparedMetric>());
}

void ComparePage::seek(double time) {
    if (own_ != nullptr && own_->has_trace()) own_replay_->seek(time);
}

void ComparePage::time_changed(double time) {
    if (own_ == nullptr) return;
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(std::lround(time * 100)));
    part_->set_moment(time);
    for (TimeChart* chart : charts_) chart->set_cursor(time);
    QString words = QStringLiteral("%1 / %2").arg(clock_text(time), clock_text(own_->model.duration));
    if (pair_ && other_->has_trace()) {
        const double there = std::max(pair_->map.to_second(time), other_->model.begin);
        other_replay_->seek(there);
        words += tr("; other attempt %1 / %2").arg(clock_text(there), clock_text(other_->model.duration));
    }
    clock_->setText(words);
    if (own_replay_->is_playing()) return;
    slider_->setAccessibleDescription(words);  // it counts hundredths of a second
    play_->setText(tr("Play"));
}

}  // namespace fulcrum::ui

#include "moc_compare_page.cpp"
