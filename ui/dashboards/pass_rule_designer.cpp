// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dashboards/pass_rule_designer.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPainter>
#include <QSlider>
#include <QTableWidget>
#include <algorithm>

#include "ui/charts/chart_frame.h"
#include "ui/dashboards/pass_rule_chart.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr int within[] = {10, 20, 30};  // attempts, columns of the table
constexpr int most_passes = 10, most_among = 16;
constexpr double limit_step = 0.1;

QString chance_text(double share) {
    const double value = 100 * share;
    // Nearly certain is not certain.
    if (value > 99.9 && value < 100) return QStringLiteral("> ") + figure(99.9) + QStringLiteral(" %");
    const bool at_the_end = value > 0 && value < 100 && (value < 10 || value > 99);
    return QLocale().toString(value, 'f', at_the_end ? 1 : 0) + QStringLiteral(" %");
}

bool same(const PassRule& a, const PassRule& b) {
    return pass_rule_text(a) == pass_rule_text(b);
}

QString after_words(const std::vector<double>& curve) {
    const auto half = std::find_if(curve.begin(), curve.end(), [](double chance) { return chance >= 0.5; });
    if (half == curve.end()) return QStringLiteral("> %1").arg(designer_attempts);
    return QString::number(half - curve.begin() + 1);
}

QString with_before(const QString& now, const QString& before, bool changed) {
    return changed && now != before ? PassRuleDesigner::tr("%1 (%2)").arg(now, before) : now;
}

}  // namespace

QString pass_rule_words(const PassRule& rule) {
    switch (rule.kind) {
        case PassRuleKind::in_a_row:
            return PassRuleDesigner::tr("%n passes in a row", nullptr, rule.k);
        case PassRuleKind::k_of_n:
            return PassRuleDesigner::tr("%1 passes among the last %2 attempts").arg(rule.k).arg(rule.n);
        case PassRuleKind::lc_cusum:
            break;
    }
    return PassRuleDesigner::tr("LC-CUSUM %1/%2 %, limit %3")
        .arg(figure(100 * rule.p0), figure(100 * rule.p1), figure(rule.h));
}

PassRuleDesigner::PassRuleDesigner(QWidget* parent)
    : QWidget(parent), kind_(new QComboBox), chart_(new PassRuleChart) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    kind_->setObjectName(QStringLiteral("rule_kind"));
    kind_->setAccessibleName(tr("Kind of rule"));
    kind_->addItems({tr("Passes in a row"), tr("Passes among the last attempts"), tr("LC-CUSUM")});
    layout->addWidget(kind_, 0, Qt::AlignLeft);
    passes_ = make_dial(tr("Passes"), "rule_passes");
    among_ = make_dial(tr("Among the last"), "rule_among");
    acceptable_ = make_dial(tr("Acceptable failures"), "rule_acceptable");
    unacceptable_ = make_dial(tr("Unacceptable failures"), "rule_unacceptable");
    limit_ = make_dial(tr("Limit of the sum"), "rule_limit");
    for (const Dial* dial : {&passes_, &among_, &acceptable_, &unacceptable_, &limit_})
        layout->addWidget(dial->row);
    words_ = make_label({}, "muted");
    words_->setObjectName(QStringLiteral("rule_words"));
    layout->addWidget(new ChartFrame(chart_, tr("Chance of being declared proficient"), "rule_chances"), 1);
    layout->addWidget(words_);
    QStringList heads{tr("Passes")};
    for (const int attempts : within) heads << tr("%1 attempts").arg(attempts);
    heads << tr("Half are proficient after");
    table_ = make_table(heads, "rule_table");
    table_->setRowCount(static_cast<int>(designer_trainees.size()));
    table_->setAccessibleName(tr("Chance of being declared proficient"));
    layout->addWidget(table_);
    connect(kind_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &PassRuleDesigner::read_dials);
    for (const Dial* dial : {&passes_, &among_, &acceptable_, &unacceptable_, &limit_})
        connect(dial->slider, &QSlider::valueChanged, this, &PassRuleDesigner::read_dials);
}

PassRuleDesigner::Dial PassRuleDesigner::make_dial(const QString& name, const char* object) {
    Dial dial;
    dial.row = new QWidget;
    auto* row = new QHBoxLayout(dial.row);
    row->setContentsMargins(0, 0, 0, 0);
    dial.name = make_label(name);
    dial.name->setWordWrap(false);
    dial.name->setMinimumWidth(fontMetrics().horizontalAdvance(tr("Unacceptable failures")) + 8);
    dial.slider = new QSlider(Qt::Horizontal);
    dial.slider->setObjectName(QLatin1String(object));
    dial.slider->setAccessibleName(name);
    dial.slider->setMinimumHeight(24);
    dial.value = make_label({});
    dial.value->setWordWrap(false);
    dial.value->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("100 % ")));
    row->addWidget(dial.name);
    row->addWidget(dial.slider, 1);
    row->addWidget(dial.value);
    return dial;
}

void PassRuleDesigner::show_rule(const PassRule& in_force, const PassRule& tried, int variants) {
    in_force_ = in_force;
    tried_ = tried;
    variants_ = variants;
    set_dials();
    refresh();
}

// The ranges follow the rule: K stays at most N, the unacceptable share above the acceptable one, and the
// rule looks at enough attempts for passes on two days and on the variants of the task.
void PassRuleDesigner::set_dials() {
    setting_ = true;
    kind_->setCurrentIndex(static_cast<int>(tried_.kind));
    const bool of = tried_.kind == PassRuleKind::k_of_n, sum = tried_.kind == PassRuleKind::lc_cusum;
    const auto set = [](Dial& dial, bool shown, int low, int high, int value) {
        dial.row->setVisible(shown);
        dial.slider->setRange(std::min(low, value), std::max(high, value));
        dial.slider->setValue(value);
        dial.given = value;
    };
    const int low_share = qRound(100 * tried_.p0), high_share = qRound(100 * tried_.p1);
    const int least = least_window(variants_);
    set(passes_, !sum, of ? 1 : least, of ? tried_.n : std::max(most_passes, least), tried_.k);
    set(among_, of, least, most_among, tried_.n);
    set(acceptable_, sum, 1, 50, low_share);
    set(unacceptable_, sum, low_share + 1, 90, high_share);
    set(limit_, sum, 5, 80, qRound(tried_.h / limit_step));
    passes_.value->setText(QString::number(tried_.k));
    among_.value->setText(QString::number(tried_.n));
    acceptable_.value->setText(figure(100 * tried_.p0) + QStringLiteral(" %"));
    unacceptable_.value->setText(figure(100 * tried_.p1) + QStringLiteral(" %"));
    limit_.value->setText(figure(tried_.h));
    // A screen reader reads steps of the slider otherwise.
    for (const Dial* dial : {&passes_, &among_, &acceptable_, &unacceptable_, &limit_})
        dial->slider->setAccessibleDescription(dial->value->text());
    setting_ = false;
}

bool PassRuleDesigner::Dial::is_moved() const {
    return slider->value() != given;
}

/// A dial that was not moved leaves the rule's own value, of which it shows a rounded one.
void PassRuleDesigner::read_dials() {
    if (setting_) return;
    const PassRule before = tried_;
    tried_.kind = static_cast<PassRuleKind>(kind_->currentIndex());
    tried_.k = passes_.slider->value();
    tried_.n = among_.slider->value();
    if (tried_.kind == PassRuleKind::in_a_row)
        tried_.n = tried_.k = std::max(tried_.k, least_window(variants_));
    if (tried_.kind == PassRuleKind::k_of_n && before.kind != PassRuleKind::k_of_n)
        tried_.n = std::clamp(tried_.k + 1, 1, most_among);
    if (tried_.kind == PassRuleKind::k_of_n) tried_.n = std::max(tried_.n, least_window(variants_));
    tried_.k = std::min(tried_.k, tried_.n);
    if (acceptable_.is_moved()) tried_.p0 = acceptable_.slider->value() / 100.0;
    if (unacceptable_.is_moved()) tried_.p1 = unacceptable_.slider->value() / 100.0;
    if (tried_.p1 <= tried_.p0) tried_.p1 = (acceptable_.slider->value() + 1) / 100.0;
    if (limit_.is_moved()) tried_.h = limit_.slider->value() * limit_step;
    set_dials();
    refresh();
    emit changed();
}

void PassRuleDesigner::refresh() {
    PassRuleCurves curves;
    curves.changed = !same(tried_, in_force_);
    for (std::size_t k = 0; k < designer_trainees.size(); ++k) {
        curves.tried[k] = operating_curve(tried_, designer_trainees[k], designer_attempts);
        curves.in_force[k] = curves.changed
                                 ? operating_curve(in_force_, designer_trainees[k], designer_attempts)
                                 : curves.tried[k];
    }
    for (std::size_t k = 0; k < designer_trainees.size(); ++k) {
        const int row = static_cast<int>(k);
        table_->setItem(row, 0, make_cell(QStringLiteral("%1 %").arg(qRound(100 * designer_trainees[k]))));
        int column = 1;
        for (const int attempts : within) {
            const auto t = static_cast<std::size_t>(attempts - 1);
            table_->setItem(row, column++,
                            make_cell(with_before(chance_text(curves.tried[k][t]),
                                                  chance_text(curves.in_force[k][t]), curves.changed)));
        }
        table_->setItem(row, column,
                        make_cell(with_before(after_words(curves.tried[k]), after_words(curves.in_force[k]),
                                              curves.changed)));
    }
    fit_columns(table_, {0});
    table_->setFixedHeight(table_->horizontalHeader()->sizeHint().height() +
                           table_->rowCount() * table_->rowHeight(0) + 4);
    QString words = pass_rule_words(tried_) + QStringLiteral(". ");
    if (tried_.kind == PassRuleKind::lc_cusum)
        words += tr("LC-CUSUM is a running sum: a pass raises it, a failure lowers it by more, never below "
                    "0. A trainee whose sum reaches the limit is proficient.") +
                 QLatin1Char(' ');
    words_->setText(
        words + (curves.changed
                     ? tr("Dashed, and in brackets: the rule in force, %1.").arg(pass_rule_words(in_force_))
                     : tr("This is the rule in force.")));
    chart_->show_curves(std::move(curves));
}

}  // namespace fulcrum::ui

#include "moc_pass_rule_designer.cpp"
