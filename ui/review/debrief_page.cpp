// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/debrief_page.h"

#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTabWidget>

#include "database/records/ratings.h"
#include "ui/page/background_job.h"
#include "ui/reports/report_export.h"
#include "ui/review/actions_card.h"
#include "ui/review/comments_card.h"
#include "ui/review/error_review_bar.h"
#include "ui/review/gates_card.h"
#include "ui/review/metrics_table.h"
#include "ui/review/part_card.h"
#include "ui/review/path_view.h"
#include "ui/review/pathology_card.h"
#include "ui/review/ratings_card.h"
#include "ui/review/replay_panel.h"
#include "ui/review/trace_panel.h"
#include "ui/style/flow_row.h"
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
    // Without the attempt there is nothing to stay for; a report is stopped where one is.
    connect(job_bar_, &JobBar::cancelled, this, [this] {
        if (!has_charts()) emit this->context().home_wanted();
    });
    layout->addWidget(job_bar_);
    content_ = new QWidget;
    auto* content = new QVBoxLayout(content_);
    content->setContentsMargins(0, 0, 0, 0);
    content->setSpacing(14);
    blind_head_ = build_blind_head();
    content->addWidget(blind_head_);
    head_ = build_head();
    content->addWidget(head_);

    replay_block_ = build_replay();
    content->addWidget(replay_block_);
    no_trace_ = make_card(4);
    no_trace_->setObjectName(QStringLiteral("no_trace"));
    no_trace_words_ = make_label({});
    card_layout(no_trace_)->addWidget(no_trace_words_);
    fetch_again_ = make_button(tr("Fetch the recording"), "fetch_recording");
    connect(fetch_again_, &QPushButton::clicked, this, [this] {
        leave();
        load();
    });
    card_layout(no_trace_)->addWidget(fetch_again_, 0, Qt::AlignLeft);
    content->addWidget(no_trace_);
    part_ = new PartCard;
    content->addWidget(part_);
    ratings_ = new RatingsCard(context);
    content->addWidget(ratings_);
    comments_ = new CommentsCard(context);
    content->addWidget(comments_);
    content->addWidget(build_tabs());
    layout->addWidget(content_);
    layout->addStretch(1);
    content_->hide();
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body));

    connect_parts();
    show_begun_reports(context, this, job_bar_);
}

QWidget* DebriefPage::build_blind_head() {
    QFrame* card = make_card(6);
    blind_title_ = make_label({}, "title");
    card_layout(card)->addWidget(blind_title_);
    QLabel* why = make_label(
        tr("To be rated blind: the person's name, the score and the ratings of others stay hidden until you "
           "have handed in your rating."));
    why->setObjectName(QStringLiteral("rating_blind_notice"));
    card_layout(card)->addWidget(why);
    QPushButton* lift =
        make_button(tr("Show name and score (my rating is then not blind)"), "lift_blinding", "link");
    connect(lift, &QPushButton::clicked, this, &DebriefPage::lift_blinding);
    card_layout(card)->addWidget(lift, 0, Qt::AlignLeft);
    return card;
}

QWidget* DebriefPage::build_replay() {
    auto* block = new QWidget;
    block->setObjectName(QStringLiteral("replay_block"));
    // With large text the traces are below the replay.
    auto* middle =
        new QBoxLayout(text_percent() > 150 ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight, block);
    middle->setContentsMargins(0, 0, 0, 0);
    middle->setSpacing(14);
    QFrame* replay_card = make_card(8);
    replay_ = new ReplayPanel;
    card_layout(replay_card)->addWidget(replay_);
    middle->addWidget(replay_card, 1);
    QFrame* traces_card = make_card(4);
    traces_ = new TracePanel;
    error_bar_ = new ErrorReviewBar(context());
    traces_->set_foot(error_bar_);
    card_layout(traces_card)->addWidget(traces_);
    middle->addWidget(traces_card, 1);
    return block;
}

QWidget* DebriefPage::build_tabs() {
    tabs_ = new QTabWidget;
    tabs_->setObjectName(QStringLiteral("debrief_tabs"));
    gates_ = new GatesCard;
    metrics_ = new MetricsTable;
    path_ = new PathView;
    path_->setMinimumHeight(340);
    actions_ = new ActionsCard(context());
    const auto add = [this](QWidget* shown, const QString& title, int stretch) {
        auto* page = new QWidget;  // a card may hide itself; the tab stays
        auto* layout = new QVBoxLayout(page);
        layout->addWidget(shown, stretch);
        if (stretch == 0) layout->addStretch();
        tabs_->addTab(page, title);
    };
    add(gates_, tr("Gates"), 0);
    add(metrics_, tr("All metrics"), 1);
    add(path_, tr("Path of both tips"), 1);
    add(actions_, tr("Corrections"), 0);
    return tabs_;
}

void DebriefPage::connect_parts() {
    connect(gates_, &GatesCard::time_chosen, this, &DebriefPage::show_moment);
    connect(gates_, &GatesCard::metric_chosen, this, &DebriefPage::explain);
    connect(metrics_, &MetricsTable::time_chosen, this, &DebriefPage::show_moment);
    connect(metrics_, &MetricsTable::metric_chosen, this, &DebriefPage::explain);
    connect(pathology_, &PathologyCard::time_chosen, this, &DebriefPage::show_moment);
    connect(pathology_, &PathologyCard::save_wanted, this, &DebriefPage::save_report);
    connect(traces_, &TracePanel::time_chosen, this, &DebriefPage::go_to);
    connect(traces_, &TracePanel::event_chosen, this, [this](int index) {
        if (model_ && index >= 0 && static_cast<std::size_t>(index) < model_->events.size())
            error_bar_->choose(model_->events[static_cast<std::size_t>(index)]);
    });
    connect(error_bar_, &ErrorReviewBar::reviewed, this, [this] {
        read_reviews();
        show_notes();
        comments_->refresh();  // the draft of the reason was one of them
    });
    connect(comments_, &CommentsCard::draft_deleted, error_bar_, &ErrorReviewBar::forget);
    connect(traces_, &TracePanel::part_selected, part_, &PartCard::choose);
    connect(part_, &PartCard::part_changed, traces_, &TracePanel::set_part);
    connect(part_, &PartCard::part_changed, this, [this](double from, double to) {
        if (to <= from) traces_->zoom_to(0, 0);
    });
    connect(part_, &PartCard::zoom_wanted, traces_, &TracePanel::zoom_to);
    connect(part_, &PartCard::time_chosen, this, &DebriefPage::go_to);
    connect(part_, &PartCard::failed, this, [this](const QString& why) { this->context().complain(why); });
    connect(path_, &PathView::time_chosen, this, &DebriefPage::show_moment);
    connect(comments_, &CommentsCard::time_chosen, this, &DebriefPage::show_moment);
    connect(ratings_, &RatingsCard::handed_in, this, &DebriefPage::lift_blinding);
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

void DebriefPage::resizeEvent(QResizeEvent* event) {
    Page::resizeEvent(event);
    fit_replay();
}

void DebriefPage::fit_replay() {
    constexpr int margin = 28, highest = 860;
    const QLayout* layout = replay_block_->layout();
    const int needed = layout->hasHeightForWidth() ? layout->minimumHeightForWidth(replay_block_->width())
                                                   : layout->minimumSize().height();
    replay_block_->setFixedHeight(std::max(needed, std::min(height() - margin, highest)));
}

void DebriefPage::explain(const QString& metric_id) {
    emit context().metric_wanted(metric_id, text(attempt_id_), moment());
}

QWidget* DebriefPage::build_head() {
    auto* head = new QWidget;
    auto* layout = new QVBoxLayout(head);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    auto* row = new FlowRow;
    title_ = make_label({}, "title");
    row->add(title_, 1, with_text(330));
    verdict_ = make_label({}, "number");
    verdict_->setObjectName(QStringLiteral("verdict"));
    verdict_->setWordWrap(false);
    row->add(verdict_);
    layout->addLayout(row);
    about_ = make_label({}, "muted");
    about_->setObjectName(QStringLiteral("debrief_about"));
    layout->addWidget(about_);
    notes_ = make_label({});
    notes_->setObjectName(QStringLiteral("debrief_notes"));
    layout->addWidget(notes_);
    QFrame* advice_card = make_card(4);
    advice_ = make_label({}, "heading");
    advice_->setObjectName(QStringLiteral("advice"));
    card_layout(advice_card)->addWidget(advice_);
    layout->addWidget(advice_card);
    layout->addLayout(build_numbers());
    compare_ = make_button(tr("Compare with another attempt"), "debrief_compare");
    connect(compare_, &QPushButton::clicked, this,
            [this] { emit context().compare_wanted(text(attempt_id_)); });
    product_ = make_label({});
    product_->setObjectName(QStringLiteral("product"));
    layout->addWidget(product_);
    layout->addWidget(compare_, 0, Qt::AlignLeft);
    pathology_ = new PathologyCard;
    layout->addWidget(pathology_);
    return head;
}

QLayout* DebriefPage::build_numbers() {
    auto* numbers = new FlowRow;
    numbers->setSpacing(14);
    for (int i = 0; i < 4; ++i) {
        QFrame* card = make_card(2);
        number_title_[i] = make_label({}, "muted");
        number_[i] = make_label({}, "number");
        number_[i]->setObjectName(QStringLiteral("headline_%1").arg(i));
        number_[i]->setWordWrap(false);
        number_why_[i] = make_label({}, "muted");
        number_explain_[i] = make_button(tr("Explain"), "explain_headline", "link");
        connect(number_explain_[i], &QPushButton::clicked, this, [this, i] {
            if (model_) explain(text(headlines(*model_)[static_cast<std::size_t>(i)].metric));
        });
        auto* top = new QHBoxLayout;
        top->addWidget(number_title_[i], 1);
        top->addWidget(number_explain_[i], 0, Qt::AlignTop);
        card_layout(card)->addLayout(top);
        for (QLabel* label : {number_[i], number_why_[i]}) card_layout(card)->addWidget(label);
        card_layout(card)->addStretch();
        numbers->add(card, 1, with_text(170));
    }
    return numbers;
}

void DebriefPage::open(const std::string& attempt_id, double time_s) {
    leave();
    attempt_id_ = attempt_id;
    wanted_time_ = time_s;
    blind_ = false;
    load();
}

void DebriefPage::open_to_rate(const std::string& attempt_id) {
    leave();
    attempt_id_ = attempt_id;
    wanted_time_ = -1;
    blind_ = true;
    load();
}

void DebriefPage::lift_blinding() {
    blind_ = false;
    context().guarded(
        [&] { database::Ratings(context().store()).note_seen(context().session(), attempt_id_); });
    show_parts();
    read_reviews();
    show_notes();
    ratings_->open(model_->summary, blind_);
}

void DebriefPage::show_parts() {
    blind_head_->setVisible(blind_);
    for (QWidget* part : {head_, static_cast<QWidget*>(comments_), static_cast<QWidget*>(tabs_)})
        part->setVisible(!blind_);
    part_->setVisible(!blind_ && model_->summary.meta.keep_trace);  // its metrics are those of the score
}

void DebriefPage::enter() {
    back_->setFocus();
}

void DebriefPage::keep_comment() {
    if (!model_) return;
    comments_->keep_unsent();
    error_bar_->keep_unsent();
    ratings_->keep();
}

void DebriefPage::leave() {
    keep_comment();
    if (job_ != nullptr) job_->cancel();
    job_ = nullptr;
    ratings_->leave();
    replay_->close();
    part_->close();
    model_.reset();
    content_->hide();
}

double DebriefPage::moment() const {
    return replay_->time();
}

void DebriefPage::show_model() {
    content_->show();
    replay_block_->setVisible(model_->summary.meta.keep_trace);
    no_trace_->setVisible(!model_->summary.meta.keep_trace);
    fetch_again_->setVisible(elsewhere_.on_server);
    no_trace_words_->setText(!elsewhere_.why.isEmpty() ? capital(elsewhere_.why)
                             : database::is_external_task(model_->summary.meta.task_id)
                                 ? external_trace_text(model_->summary.meta.device)
                                 : trace_not_kept_text());
    const TaskDefinition* task = context().task(model_->summary.meta.task_id);
    traces_->open(model_, task);
    part_->open(model_, task);
    error_bar_->open(attempt_id_, model_->summary.meta.person_id, model_->events);
    read_reviews();
    fit_replay();
    fill_head();
    gates_->open(*model_);
    show_pathology();
    metrics_->open(*model_);
    path_->set_attempt(*model_);
    actions_->open(model_->summary);
    comments_->open(attempt_id_, model_->summary.meta.person_id);
    ratings_->open(model_->summary, blind_);
    show_parts();
    replay_->open(model_, task);
    go_to(std::max(0.0, wanted_time_));
    read_record();
}

void DebriefPage::fill_head() {
    const database::AttemptSummary& attempt = model_->summary;
    title_->setText(context().task_title(attempt.meta.task_id));
    blind_title_->setText(title_->text());
    const bool voided = attempt.state == AttemptState::voided;
    const std::optional<bool> passed = model_->score ? model_->score->passed : attempt.passed;
    QString verdict_words = verdict(passed, attempt.provisional);
    if (voided) verdict_words = tr("voided");
    verdict_words = capital(verdict_words);
    verdict_->setText(
        (!voided && passed ? (*passed ? QStringLiteral("✓ ") : QStringLiteral("✕ ")) : QString()) +
        verdict_words);
    set_tint(verdict_, voided || !passed ? Tint::muted : *passed ? Tint::good : Tint::bad);
    const std::optional<double> points = model_->score ? model_->score->points : attempt.points;
    about_->setText(
        join_with_dots({text(attempt.person_name), local_time(attempt.meta.started),
                        mode_text(attempt.meta.mode), device_class_text(attempt.meta.device_class),
                        attempt_state(voided ? attempt.recorded_state : attempt.state),
                        points && passed ? points_text(*points) : QString()}));
    show_notes();
    fill_numbers();
    const Statement advice = model_->score ? model_->score->advice : Statement();
    advice_->setText(statement_text(advice));
    advice_->parentWidget()->setVisible(!advice.empty());
    const TaskDefinition* task = context().task(attempt.meta.task_id);
    const QString product = task == nullptr ? QString() : product_text(*model_, *task);
    product_->setText(product);
    product_->setVisible(!product.isEmpty());
    // It is of the hands, and of the trace.
    tabs_->setTabEnabled(tabs_->indexOf(path_->parentWidget()),
                         !model_->scope_alone && attempt.meta.keep_trace);
}

void DebriefPage::fill_numbers() {
    const std::array<Headline, 4> shown = headlines(*model_);
    for (std::size_t i = 0; i < 4; ++i) {
        number_title_[i]->setText(shown[i].title);
        number_[i]->setText(shown[i].value);
        number_why_[i]->setText(shown[i].why);
        number_why_[i]->setVisible(!shown[i].why.isEmpty());
        number_explain_[i]->setAccessibleName(tr("Explain: %1").arg(shown[i].title));
    }
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
    export_report(context(), this, job_bar_, request, [this](const QString&) {
        if (model_) show_pathology();  // the attempt may have been left since
    });
}

void DebriefPage::go_to(double time) {
    if (model_) replay_->seek(time);
}

void DebriefPage::show_moment(double time) {
    go_to(time);
    for (QWidget* above = replay_block_->parentWidget(); above != nullptr; above = above->parentWidget()) {
        auto* area = qobject_cast<QScrollArea*>(above);
        if (area == nullptr) continue;
        const int top = replay_block_->mapTo(area->widget(), QPoint(0, 0)).y();
        area->verticalScrollBar()->setValue(top - 8);
    }
}

void DebriefPage::time_changed(double time) {
    traces_->set_time(time);
    path_->set_cursor(time);
    part_->set_moment(time);
    comments_->set_moment(time);
}

}  // namespace fulcrum::ui

#include "moc_debrief_page.cpp"
