// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/review/trace_panel.h"

#include <QCheckBox>
#include <QListWidget>
#include <QPainter>
#include <map>
#include <set>

#include "ui/charts/chart_frame.h"
#include "ui/charts/time_charts.h"
#include "ui/review/attempt_model.h"
#include "ui/review/error_review_bar.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr int index_role = Qt::UserRole + 1;  ///< of a line: in the model's events

/// The lines of the two hands and their names; follows the theme.
class HandsLegend : public QWidget {
  public:
    HandsLegend() {
        setFixedHeight(fontMetrics().height() + 4);
        setAccessibleName(TracePanel::tr("left hand") + QStringLiteral(", ") + TracePanel::tr("right hand"));
    }
    QSize sizeHint() const override { return {minimumSizeHint().width(), height()}; }
    QSize minimumSizeHint() const override {
        return {2 * 44 + fontMetrics().horizontalAdvance(TracePanel::tr("left hand") +
                                                         TracePanel::tr("right hand")),
                height()};
    }

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        const Palette& p = colours();
        const double middle = height() / 2.0;
        double x = 4;
        for (const bool left : {true, false}) {
            painter.setPen(QPen(left ? p.left_hand : p.right_hand, 2, left ? Qt::SolidLine : Qt::DashLine));
            painter.drawLine(QPointF(x, middle), QPointF(x + 22, middle));
            const QString words = left ? TracePanel::tr("left hand") : TracePanel::tr("right hand");
            painter.setPen(p.text);
            painter.drawText(QRectF(x + 28, 0, width() - x - 28, height()), Qt::AlignLeft | Qt::AlignVCenter,
                             words);
            x += 28 + fontMetrics().horizontalAdvance(words) + 16;
        }
    }
};

}  // namespace

TracePanel::TracePanel(QWidget* parent) : QWidget(parent) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    axis_ = new TimeCharts(tr("Force, speed, traction and energy"));
    build_charts();
    charts_ = new ChartFrame(axis_, tr("Force, speed, traction and energy"), "traces", new HandsLegend);
    layout->addWidget(charts_, 3);
    layout->addWidget(make_label(tr("What happened"), "heading"));
    penalties_only_ = new QCheckBox(tr("Penalties only"));
    penalties_only_->setObjectName(QStringLiteral("penalties_only"));
    layout->addWidget(penalties_only_);
    events_ = new QListWidget;
    events_->setObjectName(QStringLiteral("event_list"));
    events_->setAccessibleName(tr("What happened"));
    events_->setMinimumHeight(7 * fontMetrics().height());
    events_->setItemDelegate(new TintDelegate(events_));
    events_->setWordWrap(true);
    events_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    layout->addWidget(events_, 2);
    connect_parts();
}

void TracePanel::build_charts() {
    // `name`: before the names of the hands in the table.
    const auto add = [&](const char* object, const QString& title, const QString& accessible_name,
                         const QString& unit, const QString& name) {
        auto* chart = new TimeChart(title);
        chart->setObjectName(QLatin1String(object));
        chart->setAccessibleName(accessible_name);
        chart->set_unit(unit);
        chart->show_names(false);
        chart->offer_selection(true);
        chart->setToolTip(
            tr("Scroll to zoom, drag to move, click to jump to a moment, double-click to show everything; "
               "hold Shift and drag to choose a part.") +
            QLatin1Char('\n') + TimeChart::key_words());
        axis_->add(chart, name);
        return chart;
    };
    force_ = add("force_chart", tr("force (N)"), tr("force (N)"), QStringLiteral("N"), tr("force"));
    force_->show_peaks(true);
    speed_ = add("speed_chart", tr("speed (mm/s)"), tr("speed (mm/s)"), QStringLiteral("mm/s"), tr("speed"));
    traction_ = add("traction_chart", QString(), QString(), QString(), QString());
    energy_ = add("energy_chart", QString(), QString(), QStringLiteral("mm²"), QString());
    all_charts_ = {force_, speed_, traction_, energy_};
}

void TracePanel::connect_parts() {
    connect(penalties_only_, &QCheckBox::toggled, this, &TracePanel::fill_events);
    const auto jump = [this](QListWidgetItem* item) {
        const QVariant time = item->data(Qt::UserRole);
        if (time.isValid()) emit time_chosen(time.toDouble());
    };
    connect(events_, &QListWidget::itemActivated, this, jump);
    connect(events_, &QListWidget::itemClicked, this, jump);
    connect(events_, &QListWidget::itemActivated, this, &TracePanel::choose);
    connect(events_, &QListWidget::itemClicked, this, &TracePanel::choose);
    connect(events_, &QListWidget::currentItemChanged, this, &TracePanel::choose);
    for (TimeChart* chart : all_charts_) {
        connect(chart, &TimeChart::time_chosen, this, &TracePanel::time_chosen);
        connect(chart, &TimeChart::range_selected, this, &TracePanel::part_selected);
    }
}

void TracePanel::align_charts() {
    TimeChart* last = nullptr;
    for (TimeChart* chart : all_charts_)
        if (!chart->isHidden()) last = chart;
    const int line = fontMetrics().height();
    for (TimeChart* chart : all_charts_) {
        chart->show_time_axis(chart == last);
        chart->setMinimumHeight((chart == last ? 8 : 5) * line);
        chart->set_compact(fontMetrics().horizontalAdvance(QStringLiteral("00000")) + 10);
    }
}

void TracePanel::open(std::shared_ptr<const AttemptModel> model, const TaskDefinition* task) {
    model_ = std::move(model);
    reviews_.clear();
    time_ = 0;
    charts_->show_chart();
    charts_->setVisible(!model_->scope_alone);  // they are of the hands
    fill_charts(task);
    fill_events();
}

void TracePanel::set_part(double from, double to) {
    for (TimeChart* chart : all_charts_) chart->set_selection(from, to);
}

void TracePanel::zoom_to(double from, double to) {
    axis_->zoom_to(from, to);
}

void TracePanel::set_time(double time) {
    time_ = time;
    for (TimeChart* chart : all_charts_) chart->set_cursor(time);
    mark_event(time);
}

void TracePanel::mark_event(double time) {
    int latest = -1;
    for (int row = 0; row < events_->count(); ++row) {
        const QVariant at = events_->item(row)->data(Qt::UserRole);
        if (at.isValid() && at.toDouble() <= time + 1e-9) latest = row;
    }
    // Of several events at one time the one that a person chose stays.
    const int chosen = events_->currentRow();
    if (latest >= 0 && chosen >= 0 && chosen < latest &&
        events_->item(chosen)->data(Qt::UserRole) == events_->item(latest)->data(Qt::UserRole))
        return;
    const QSignalBlocker quiet(events_);
    events_->setCurrentRow(latest);
    if (latest >= 0) events_->scrollToItem(events_->item(latest));
}

void TracePanel::set_foot(QWidget* foot) {
    foot_ = foot;
    layout()->addWidget(foot);
}

void TracePanel::show_reviews(std::vector<database::ErrorReview> reviews) {
    reviews_ = std::move(reviews);
    // The foot takes its room from the list: the charts need theirs for the numbers of their axes.
    const bool crowded = foot_ != nullptr && !foot_->isHidden();
    static_cast<QBoxLayout*>(layout())->setStretchFactor(charts_, crowded ? 6 : 3);
    const int row = events_->currentRow();
    const QVariant chosen = row < 0 ? QVariant() : events_->item(row)->data(index_role);
    fill_events();
    fill_marks();
    // The line that was chosen stays chosen, wherever it is now.
    const QSignalBlocker quiet(events_);
    for (int i = 0; chosen.isValid() && i < events_->count(); ++i)
        if (events_->item(i)->data(index_role) == chosen) events_->setCurrentRow(i);
}

const database::ErrorReview* TracePanel::review_of(const Event& event) const {
    for (const database::ErrorReview& review : reviews_)
        if (review.is_of(event)) return &review;
    return nullptr;
}

void TracePanel::choose(QListWidgetItem* item) {
    const QVariant index = item == nullptr ? QVariant() : item->data(index_role);
    if (index.isValid()) emit event_chosen(index.toInt());
}

/// A line of its own below the struck or confirmed one, which says the same to a screen reader.
void TracePanel::add_note(const database::ErrorReview& review, QListWidgetItem* line) {
    const QString words = review_words(review);
    if (review.verdict == database::ErrorVerdict::struck) {
        QFont font = line->font();
        font.setStrikeOut(true);
        line->setFont(font);
        set_tint(line, Tint::muted);
    }
    line->setData(Qt::AccessibleTextRole, line->text() + QStringLiteral(". ") + words);
    auto* note =
        new QListWidgetItem((review.verdict == database::ErrorVerdict::struck ? QStringLiteral("      – ")
                                                                              : QStringLiteral("      ✓ ")) +
                                words,
                            events_);
    note->setFlags(Qt::NoItemFlags);  // the keyboard steps over it
    set_tint(note, Tint::muted);
}

void TracePanel::fill_events() {
    const QSignalBlocker quiet(events_);
    events_->clear();
    if (!model_) return;
    int index = -1;
    for (const EventLine& line : model_->events) {
        ++index;
        if (penalties_only_->isChecked() && !line.severe) continue;
        QString words = QStringLiteral("%1   %2%3")
                            .arg(clock_text(line.time),
                                 line.critical ? QStringLiteral("✕ ")
                                 : line.severe ? QStringLiteral("▲ ")
                                               : QString(),
                                 line.words);
        auto* item = new QListWidgetItem(words, events_);
        item->setData(Qt::UserRole, line.time);
        item->setData(index_role, index);
        if (line.severe) set_tint(item, Tint::bad);
        if (const database::ErrorReview* review = review_of(line.event)) add_note(*review, item);
    }
    if (events_->count() == 0) {
        auto* none = new QListWidgetItem(tr("nothing"), events_);
        none->setFlags(Qt::NoItemFlags);
    }
    mark_event(time_);
}

void TracePanel::fill_charts(const TaskDefinition* task) {
    for (TimeChart* chart : all_charts_) {
        chart->clear();
        chart->set_extent(model_->begin, model_->duration);
    }
    for (TimeChart* chart : {force_, speed_}) {
        const auto& hands = chart == force_ ? model_->force : model_->speed;
        chart->add_series(tr("left hand"), &Palette::left_hand, Qt::SolidLine, hands[0]);
        chart->add_series(tr("right hand"), &Palette::right_hand, Qt::DashLine, hands[1]);
    }
    // Tissues that bear the same share a line, and its name.
    std::map<double, QStringList> limits;
    for (const auto& [tissue, limit] : model_->force_limits) limits[limit] << asset_text(tissue);
    for (const auto& [limit, tissues] : limits)
        force_->add_limit(tr("limit, %1").arg(tissues.join(QStringLiteral(", "))), limit);
    fill_traction(task);
    fill_energy();
    fill_marks();
    zoom_to(0, 0);
    align_charts();
}

void TracePanel::fill_traction(const TaskDefinition* task) {
    const TractionCourse& course = model_->traction;
    traction_->setVisible(!course.steps.empty());
    if (course.steps.empty()) return;
    traction_->set_y_title(course.per_length ? tr("traction (N/m)") : tr("tension (N)"));
    traction_->setAccessibleName(course.per_length ? tr("traction across the cut (N/m)")
                                                   : tr("tension of a band as it was divided (N)"));
    traction_->set_unit(course.per_length ? QStringLiteral("N/m") : QStringLiteral("N"));
    traction_->set_steps(course.per_length ? tr("traction across the cut") : tr("tension of a band"),
                         &Palette::accent, course.steps);
    if (!course.per_length || task == nullptr) return;
    std::set<std::pair<double, double>> bands;
    for (const Goal& goal : task->goals)
        if (goal.traction_high_n_m > goal.traction_low_n_m)
            bands.emplace(goal.traction_low_n_m, goal.traction_high_n_m);
    for (const auto& [low, high] : bands) {
        traction_->add_limit(tr("traction, at least"), low);
        traction_->add_limit(tr("traction, at most"), high);
    }
}

void TracePanel::fill_energy() {
    const bool used = !model_->energy[0].empty() || !model_->energy[1].empty();
    energy_->setVisible(used || model_->heat != nullptr);
    if (energy_->isHidden()) return;
    energy_->add_lane(tr("energy, left hand"), &Palette::left_hand, model_->energy[0]);
    energy_->add_lane(tr("energy, right hand"), &Palette::right_hand, model_->energy[1]);
    energy_->set_y_title(model_->heat != nullptr ? tr("energy; heat (mm²)") : tr("energy"));
    energy_->setAccessibleName(
        model_->heat != nullptr
            ? tr("energy of each hand; tissue reached by heat that was not meant for it (mm²)")
            : tr("energy of each hand"));
    if (model_->heat != nullptr)
        energy_->add_series(tr("tissue reached by heat"), &Palette::warning, Qt::SolidLine, model_->heat);
}

/// A struck error differs from a confirmed one here too, and says why.
void TracePanel::fill_marks() {
    if (!model_) return;
    std::vector<ChartMark> marks;
    for (const EventLine& line : model_->events) {
        ChartMark mark{line.time, line.words,
                       line.critical ? &Palette::bad
                       : line.severe ? &Palette::warning
                                     : &Palette::neutral,
                       line.severe};
        if (const database::ErrorReview* review = review_of(line.event)) {
            mark.review = review->verdict == database::ErrorVerdict::struck ? MarkReview::struck
                                                                            : MarkReview::confirmed;
            mark.text += QStringLiteral(". ") + review_words(*review);
        }
        marks.push_back(std::move(mark));
    }
    for (TimeChart* chart : all_charts_) chart->set_marks(marks);
}

}  // namespace fulcrum::ui

#include "moc_trace_panel.cpp"
