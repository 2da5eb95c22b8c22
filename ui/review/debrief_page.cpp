// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/debrief_page.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QHeaderView>
#include <QListWidget>
#include <QTableWidget>
#include <map>

#include "assessment/metrics/registry.h"
#include "ui/charts/time_chart.h"
#include "ui/page/background_job.h"
#include "ui/reports/report_export.h"
#include "ui/review/actions_card.h"
#include "ui/review/comments_card.h"
#include "ui/review/gates_card.h"
#include "ui/review/path_view.h"
#include "ui/review/pathology_card.h"
#include "ui/review/replay_panel.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {

DebriefPage::DebriefPage(Context& context) : Page(context, "debrief_page") {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(14);
    back_ = make_button(tr("← Back"), "debrief_back", "link");
    connect(back_, &QPushButton::clicked, this, [this] { emit this->context().home_wanted(); });
    layout->addWidget(back_, 0, Qt::AlignLeft);
    job_bar_ = new JobBar;
    connect(job_bar_, &JobBar::cancelled, this, [this] { emit this->context().home_wanted(); });
    layout->addWidget(job_bar_);
    content_ = new QWidget;
    auto* content = new QVBoxLayout(content_);
    content->setContentsMargins(0, 0, 0, 0);
    content->setSpacing(14);
    content->addWidget(build_head());

    gates_ = new GatesCard;
    content->addWidget(gates_);
    pathology_ = new PathologyCard;
    content->addWidget(pathology_);

    content->addLayout(build_replay());
    content->addLayout(build_charts());
    comments_ = new CommentsCard(context);
    content->addWidget(comments_);
    all_metrics_ = make_button(tr("All metrics"), "all_metrics");
    content->addWidget(all_metrics_, 0, Qt::AlignLeft);
    metrics_ =
        make_table({tr("Metric"), tr("Hand"), tr("Tissue"), tr("Value"), tr("Better"), tr("Why absent")},
                   "metrics_table");
    metrics_->setMinimumHeight(320);
    metrics_->hide();
    content->addWidget(metrics_);
    actions_ = new ActionsCard(context);
    content->addWidget(actions_);
    layout->addWidget(content_);
    layout->addStretch();
    content_->hide();
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 1240));

    connect_parts();
}

QLayout* DebriefPage::build_replay() {
    auto* middle = new QHBoxLayout;
    middle->setSpacing(14);
    QFrame* replay_card = make_card(8);
    replay_ = new ReplayPanel;
    card_layout(replay_card)->addWidget(replay_);
    middle->addWidget(replay_card, 3);
    QFrame* events_card = make_card(8);
    card_layout(events_card)->addWidget(make_label(tr("What happened"), "heading"));
    penalties_only_ = new QCheckBox(tr("penalties only"));
    penalties_only_->setObjectName(QStringLiteral("penalties_only"));
    card_layout(events_card)->addWidget(penalties_only_);
    events_ = new QListWidget;
    events_->setObjectName(QStringLiteral("event_list"));
    events_->setAccessibleName(tr("What happened"));
    events_->setMinimumHeight(260);
    events_->setItemDelegate(new TintDelegate(events_));
    events_->setWordWrap(true);
    events_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    card_layout(events_card)->addWidget(events_, 1);
    middle->addWidget(events_card, 2);
    return middle;
}

QLayout* DebriefPage::build_charts() {
    auto* charts = new QHBoxLayout;
    charts->setSpacing(14);
    QFrame* force_card = make_card(4);
    card_layout(force_card)->addWidget(make_label(tr("Force of both hands on tissue"), "heading"));
    force_ = new TimeChart(tr("force (N)"));
    force_->setObjectName(QStringLiteral("force_chart"));
    force_->setMinimumHeight(290);
    card_layout(force_card)->addWidget(force_);
    card_layout(force_card)
        ->addWidget(make_label(
            tr("Scroll to zoom, drag to move, click to jump to a moment, double-click to show everything."),
            "muted"));
    charts->addWidget(force_card, 3);
    QFrame* path_card = make_card(4);
    card_layout(path_card)->addWidget(make_label(tr("Path of both tips"), "heading"));
    path_ = new PathView;
    card_layout(path_card)->addWidget(path_, 1);
    charts->addWidget(path_card, 2);
    return charts;
}

void DebriefPage::connect_parts() {
    connect(all_metrics_, &QPushButton::clicked, this, [this] {
        metrics_->setVisible(metrics_->isHidden());
        all_metrics_->setText(metrics_->isHidden() ? tr("All metrics") : tr("Hide the metrics"));
    });
    connect(penalties_only_, &QCheckBox::toggled, this, &DebriefPage::fill_events);
    connect(events_, &QListWidget::itemActivated, this,
            [this](QListWidgetItem* item) { go_to(item->data(Qt::UserRole).toDouble()); });
    connect(events_, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { go_to(item->data(Qt::UserRole).toDouble()); });
    const auto jump = [this](QTableWidgetItem* item) {
        const QVariant time = metrics_->item(item->row(), 0)->data(Qt::UserRole);
        if (time.isValid()) go_to(time.toDouble());
    };
    connect(metrics_, &QTableWidget::itemActivated, this, jump);
    connect(metrics_, &QTableWidget::itemClicked, this, jump);
    connect(gates_, &GatesCard::time_chosen, this, &DebriefPage::go_to);
    connect(pathology_, &PathologyCard::time_chosen, this, &DebriefPage::go_to);
    connect(pathology_, &PathologyCard::save_wanted, this, &DebriefPage::save_report);
    connect(force_, &TimeChart::time_chosen, this, &DebriefPage::go_to);
    connect(path_, &PathView::time_chosen, this, &DebriefPage::go_to);
    connect(comments_, &CommentsCard::time_chosen, this, &DebriefPage::go_to);
    connect(replay_, &ReplayPanel::time_changed, this, &DebriefPage::time_changed);
    connect(replay_, &ReplayPanel::practice_wanted, this,
            [this](const std::shared_ptr<const ReplayMoment>& from) {
                emit this->context().take_over_wanted(from);
            });
    connect(actions_, &ActionsCard::changed, this, [this] {
        open(attempt_id_, moment());
        back_->setFocus();
    });
}

QWidget* DebriefPage::build_head() {
    auto* head = new QWidget;
    auto* layout = new QVBoxLayout(head);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    auto* row = new QHBoxLayout;
    title_ = make_label({}, "title");
    row->addWidget(title_, 1);
    verdict_ = make_label({}, "number");
    verdict_->setObjectName(QStringLiteral("verdict"));
    verdict_->setWordWrap(false);
    row->addWidget(verdict_);
    layout->addLayout(row);
    about_ = make_label({}, "muted");
    about_->setObjectName(QStringLiteral("debrief_about"));
    layout->addWidget(about_);
    notes_ = make_label({});
    notes_->setObjectName(QStringLiteral("debrief_notes"));
    layout->addWidget(notes_);
    auto* numbers = new QHBoxLayout;
    numbers->setSpacing(14);
    for (int i = 0; i < 4; ++i) {
        QFrame* card = make_card(2);
        number_title_[i] = make_label({}, "muted");
        number_[i] = make_label({}, "number");
        number_[i]->setObjectName(QStringLiteral("headline_%1").arg(i));
        number_why_[i] = make_label({}, "muted");
        for (QLabel* label : {number_title_[i], number_[i], number_why_[i]})
            card_layout(card)->addWidget(label);
        card_layout(card)->addStretch();
        numbers->addWidget(card, 1);
    }
    layout->addLayout(numbers);
    QFrame* advice_card = make_card(4);
    advice_ = make_label({}, "heading");
    advice_->setObjectName(QStringLiteral("advice"));
    card_layout(advice_card)->addWidget(advice_);
    layout->addWidget(advice_card);
    return head;
}

void DebriefPage::open(const std::string& attempt_id, double time_s) {
    leave();
    attempt_id_ = attempt_id;
    wanted_time_ = time_s;
    std::optional<Scene> scene;
    database::AttemptSummary attempt;
    if (!context().guarded(
            [&] { attempt = database::Attempts(context().store()).read(context().session(), attempt_id); })) {
        return;
    }
    if (context().task(attempt.meta.task_id) != nullptr) {
        context().guarded([&] { scene = context().services().scene_of(context().session(), attempt); });
    }
    auto loaded = std::make_shared<std::optional<AttemptModel>>();
    job_ = BackgroundJob::run(
        this,
        [loaded, scene, attempt_id, path = context().store().path(),
         session = context().session()](const Progress& progress) {
            database::StoreOptions options;
            options.read_only = true;
            const database::Store store = database::Store::open(path, options);
            *loaded = load_attempt(store, session, attempt_id, scene, progress);
        },
        [this, loaded] {
            job_ = nullptr;
            if (!*loaded) return;
            model_ = std::make_shared<const AttemptModel>(std::move(**loaded));
            show_model();
        },
        [this](const QString& why) {
            job_ = nullptr;
            context().complain(why);
        });
    job_bar_->watch(job_, tr("Reading the attempt …"));
}

void DebriefPage::enter() {
    back_->setFocus();
}

void DebriefPage::leave() {
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
    replay_->close();
    model_.reset();
    content_->hide();
}

double DebriefPage::moment() const {
    return replay_->time();
}

void DebriefPage::show_model() {
    content_->show();
    fill_head();
    gates_->open(*model_);
    show_pathology();
    fill_events();
    fill_metrics();
    fill_charts();
    actions_->open(model_->summary);
    comments_->open(attempt_id_, model_->summary.meta.person_id);
    replay_->open(model_, context().task(model_->summary.meta.task_id));
    go_to(std::max(0.0, wanted_time_));
    read_record();
}

void DebriefPage::read_record() {
    auto trace = std::make_shared<database::Trace>();
    job_ = BackgroundJob::run(
        this,
        [trace, id = attempt_id_, path = context().store().path(),
         session = context().session()](const Progress&) {
            database::StoreOptions options;
            options.read_only = true;
            const database::Store store = database::Store::open(path, options);
            *trace = database::Attempts(store).read_trace(session, id);
        },
        [this, trace] {
            job_ = nullptr;
            show_record(trace);
        },
        [this](const QString& why) {
            job_ = nullptr;
            replay_->set_record(model_, nullptr, tr("No picture: %1").arg(why));
            context().complain(why);
        });
}

void DebriefPage::show_record(std::shared_ptr<const database::Trace> trace) {
    auto model = std::make_shared<AttemptModel>(*model_);
    model->trace = std::move(trace);
    model_ = std::move(model);
    std::unique_ptr<ReplaySource> source;
    QString why;
    if (model_->trace->samples.empty()) {
        why = tr("Nothing was recorded.");
    } else {
        try {
            source = context().services().open_replay(context().session(), model_->summary, model_->trace);
        } catch (const std::exception& error) {
            why = tr("No picture: %1").arg(QString::fromUtf8(error.what()));
        }
    }
    replay_->offer_practice(source != nullptr &&
                            context().allowed(database::Operation::perform_attempt,
                                              database::Subject::person(context().session().person_id())));
    replay_->set_record(model_, std::move(source), why);
    emit ready();
}

void DebriefPage::fill_head() {
    const database::AttemptSummary& attempt = model_->summary;
    title_->setText(context().task_title(attempt.meta.task_id));
    const bool voided = attempt.state == AttemptState::voided;
    const std::optional<bool> passed = model_->score ? model_->score->passed : attempt.passed;
    QString verdict_words = verdict(passed, attempt.provisional);
    if (voided) verdict_words = tr("voided");
    verdict_->setText(
        (!voided && passed ? (*passed ? QStringLiteral("✓ ") : QStringLiteral("✕ ")) : QString()) +
        verdict_words);
    set_tint(verdict_, voided || !passed ? Tint::muted : *passed ? Tint::good : Tint::bad);
    const std::optional<double> points = model_->score ? model_->score->points : attempt.points;
    about_->setText(beside({text(attempt.person_name), local_time(attempt.meta.started),
                            mode_text(attempt.meta.mode), device_class_text(attempt.meta.device_class),
                            attempt_state(voided ? attempt.recorded_state : attempt.state),
                            points && passed ? points_text(*points) : QString()}));
    QStringList notes;
    if (voided) {
        notes << tr("Voided by %1 on %2: %3. It does not count.")
                     .arg(text(attempt.voided_by), local_time(attempt.voided_at), text(attempt.void_reason));
        if (!attempt.reassigned_to.empty()) notes << tr("A copy was stored for the person who performed it.");
    }
    if (!attempt.reassigned_from.empty()) {
        notes << tr("Reassigned: recorded under another name and copied to the person who performed it.");
    }
    if (attempt.meta.device_class == DeviceClass::synthetic)
        notes << tr("Performed by a simulated operator, not by a person.");
    else if (attempt.synthetic)
        notes << tr("Performed in the demonstration, on the account of a synthetic person.");
    if (attempt.meta.origin) {
        const double from_s = attempt.meta.origin->tick * model_->tick;
        notes
            << (attempt.meta.origin->source_id.empty()
                    ? tr("Practice from goal %1 of a demonstration: never scored.")
                          .arg(attempt.meta.origin->goal + 1)
                    : tr("Practice taken over from an attempt at %1: never scored.").arg(clock_text(from_s)));
    } else if (!passed && !voided) {
        const Statement why = model_->score ? model_->score->not_scored_because : attempt.not_scored_because;
        notes << tr("Not scored: %1").arg(why.empty() ? tr("the attempt has no score") : statement_text(why));
    }
    if (attempt.provisional) {
        notes << tr(
            "The limits are provisional (synthetic operators): they allow \"passed (provisional)\", never "
            "proficiency.");
    }
    if (model_->recomputed) {
        const database::ScoreRow& beside = *model_->recomputed;
        QString result = verdict(beside.passed, false);
        if (beside.passed && beside.points) result += tr(", %1").arg(points_text(*beside.points));
        if (!beside.passed) result += QStringLiteral(" (%1)").arg(statement_text(beside.not_scored_because));
        notes << tr("Recomputed on %1 with newer metrics or limits: %2. The score shown stays in force.")
                     .arg(local_time(beside.computed), result);
    }
    if (!model_->scope_alone && (attempt.meta.device_class == DeviceClass::mouse_keyboard ||
                                 attempt.meta.device_class == DeviceClass::controller)) {
        notes << tr("Force was not felt: this device cannot render it. It was shown as bars.");
    }
    if (attempt.lost_samples > 0) notes << tr("%1 samples were lost.").arg(attempt.lost_samples);
    notes_->setText(notes.join(QLatin1Char('\n')));
    notes_->setVisible(!notes.isEmpty());
    const std::array<Headline, 4> shown = headlines(*model_);
    for (std::size_t i = 0; i < 4; ++i) {
        number_title_[i]->setText(shown[i].title);
        number_[i]->setText(shown[i].value);
        number_why_[i]->setText(shown[i].why);
        number_why_[i]->setVisible(!shown[i].why.isEmpty());
    }
    for (QWidget* chart : {static_cast<QWidget*>(force_), static_cast<QWidget*>(path_)})  // of the hands
        chart->parentWidget()->setVisible(!model_->scope_alone);
    const Statement advice = model_->score ? model_->score->advice : Statement();
    advice_->setText(statement_text(advice));
    advice_->parentWidget()->setVisible(!advice.empty());
}

void DebriefPage::show_pathology() {
    const database::AttemptMeta& meta = model_->summary.meta;
    std::optional<QString> file;
    if (context().allowed(database::Operation::export_person, database::Subject::person(meta.person_id)))
        file = text(meta.task_id) + QStringLiteral(" ") + text(model_->summary.person_name);
    pathology_->open(model_->pathology, file);
}

void DebriefPage::save_report(const QString& path) {
    ReportRequest request;
    request.attempt_id = attempt_id_;
    request.format = report_format_of(path);
    request.path = plain(path);
    export_report(context(), this, job_bar_, request, [this](const QString&) { show_pathology(); });
}

void DebriefPage::fill_events() {
    events_->clear();
    if (!model_) return;
    for (const EventLine& line : model_->events) {
        if (penalties_only_->isChecked() && !line.severe) continue;
        QString words = QStringLiteral("%1   %2%3")
                            .arg(clock_text(line.time),
                                 line.critical ? QStringLiteral("✕ ")
                                 : line.severe ? QStringLiteral("▲ ")
                                               : QString(),
                                 line.words);
        auto* item = new QListWidgetItem(words, events_);
        item->setData(Qt::UserRole, line.time);
        if (line.severe) set_tint(item, Tint::bad);
    }
    if (events_->count() == 0) {
        auto* none = new QListWidgetItem(tr("nothing"), events_);
        none->setFlags(Qt::NoItemFlags);
    }
}

void DebriefPage::fill_metrics() {
    metrics_->setRowCount(0);
    all_metrics_->setVisible(model_->score.has_value());
    if (!model_->score) return;
    for (const database::MetricRow& value : model_->score->metrics) {
        const MetricDescriptor* metric = find_metric(value.id);
        const int row = metrics_->rowCount();
        metrics_->insertRow(row);
        auto* first = make_cell(metric_text(value.id));
        first->setToolTip(
            (metric == nullptr ? QString() : metric_words(metric->explanation) + QLatin1Char('\n')) +
            tr("%1, version %2").arg(text(value.id)).arg(value.version));
        if (!value.evidence.empty()) first->setData(Qt::UserRole, value.evidence.front().first);
        metrics_->setItem(row, 0, first);
        metrics_->setItem(row, 1,
                          make_cell(value.hand == "left"    ? tr("left")
                                    : value.hand == "right" ? tr("right")
                                                            : QString()));
        metrics_->setItem(row, 2, make_cell(text(value.tissue)));
        metrics_->setItem(
            row, 3, make_cell(figure_with_unit(value.value, value.unit), Qt::AlignRight | Qt::AlignVCenter));
        metrics_->setItem(row, 4,
                          make_cell(value.direction == Direction::lower    ? tr("↓ lower")
                                    : value.direction == Direction::higher ? tr("↑ higher")
                                                                           : tr("context")));
        metrics_->setItem(row, 5, make_cell(statement_text(value.absent_because)));
    }
    fit_columns(metrics_);
}

void DebriefPage::fill_charts() {
    force_->clear();
    force_->add_series(tr("left hand"), &Palette::left_hand, Qt::SolidLine, model_->force[0]);
    force_->add_series(tr("right hand"), &Palette::right_hand, Qt::DashLine, model_->force[1]);
    // Tissues that bear the same share a line, and its name.
    std::map<double, QStringList> limits;
    for (const auto& [tissue, limit] : model_->force_limits) limits[limit] << text(tissue);
    for (const auto& [limit, tissues] : limits)
        force_->add_limit(tr("limit, %1").arg(tissues.join(QStringLiteral(", "))), limit);
    std::vector<ChartMark> marks;
    for (const EventLine& line : model_->events) {
        marks.push_back({line.time, line.words,
                         line.critical ? &Palette::bad
                         : line.severe ? &Palette::warning
                                       : &Palette::neutral,
                         line.severe});
    }
    force_->set_marks(std::move(marks));
    force_->show_all();
    path_->set_attempt(*model_);
}

void DebriefPage::go_to(double time) {
    if (model_) replay_->seek(time);
}

void DebriefPage::time_changed(double time) {
    force_->set_cursor(time);
    path_->set_cursor(time);
    comments_->set_moment(time);
}

}  // namespace fulcrum::ui

#include "moc_debrief_page.cpp"
