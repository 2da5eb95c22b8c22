// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/sound_card.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <cmath>

#include "ui/language/language.h"
#include "ui/style/announce.h"
#include "ui/style/flow_row.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr int look_every_ms = 500;
constexpr int volume_percents[] = {25, 50, 75, 100};

}  // namespace

SoundCard::SoundCard(Context& context)
    : context_(context),
      wanted_(new QCheckBox(tr("Sound during tasks"))),
      volume_(new QComboBox),
      test_(make_button(tr("Play the sounds"), "test_sound")),
      trouble_(make_label({}, "bad")) {
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 16);
    layout->setSpacing(8);
    layout->addWidget(make_label(tr("Sound"), "heading"));
    wanted_->setObjectName(QStringLiteral("sound_wanted"));
    wanted_->setAccessibleName(wanted_->text());
    layout->addWidget(wanted_, 0, Qt::AlignLeft);
    auto* holder = new QWidget;
    auto* row = new FlowRow(holder);
    auto* both = new QWidget;
    auto* pair = new QHBoxLayout(both);
    pair->setContentsMargins(0, 0, 0, 0);
    auto* title = new QLabel(tr("Volume"));
    title->setBuddy(volume_);
    volume_->setObjectName(QStringLiteral("sound_volume"));
    volume_->setAccessibleName(title->text());
    volume_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    volume_->setMinimumContentsLength(7);
    for (const int percent : volume_percents) volume_->addItem(tr("%1 %").arg(percent), percent);
    pair->addWidget(title);
    pair->addWidget(volume_);
    row->add(both);
    row->add(test_);
    layout->addWidget(holder);
    trouble_->setObjectName(QStringLiteral("sound_trouble"));
    layout->addWidget(trouble_);
    layout->addWidget(make_label(
        tr("A click for each contact, a tone that rises with force beyond a tissue's limit, a hum while "
           "energy is on, and two tones once a second while tissue bleeds faster than 10 mL/min. The left "
           "hand is louder on the left."),
        "muted"));
    connect(wanted_, &QCheckBox::clicked, this, &SoundCard::choose);
    connect(volume_, QOverload<int>::of(&QComboBox::activated), this, &SoundCard::choose);
    connect(test_, &QPushButton::clicked, this, [this] {
        context_.services().test_sound();
        show_state();
    });
    timer_.setInterval(look_every_ms);
    connect(&timer_, &QTimer::timeout, this, &SoundCard::show_state);
}

void SoundCard::showEvent(QShowEvent* event) {
    QFrame::showEvent(event);
    show_state();
    timer_.start();
}

void SoundCard::hideEvent(QHideEvent* event) {
    QFrame::hideEvent(event);
    timer_.stop();
}

void SoundCard::choose() {
    context_.services().choose_sound({wanted_->isChecked(), 0.01 * volume_->currentData().toInt()});
    show_state();
}

void SoundCard::show_state() {
    const SoundChoice now = context_.services().sound_choice();
    wanted_->setChecked(now.wanted);
    // The nearest of the list, whatever the file of settings says.
    int nearest = 0;
    for (int i = 1; i < volume_->count(); ++i)
        if (std::abs(volume_->itemData(i).toInt() - 100 * now.volume) <
            std::abs(volume_->itemData(nearest).toInt() - 100 * now.volume))
            nearest = i;
    // Not while its list is open.
    if (!volume_->view()->isVisible()) volume_->setCurrentIndex(nearest);
    const Sentence trouble = context_.services().sound_trouble();
    volume_->setEnabled(now.wanted);
    test_->setEnabled(now.wanted && trouble.empty());
    trouble_->setVisible(!trouble.empty());
    announce_change(trouble_, sentence_text(trouble));
}

}  // namespace fulcrum::ui

#include "moc_sound_card.cpp"
