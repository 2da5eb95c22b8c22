// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/sending_card.h"

#include <QCheckBox>

#include "ui/language/language.h"
#include "ui/style/announce.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

constexpr int show_every_ms = 500;

}  // namespace

SendingCard::SendingCard(Context& context)
    : context_(context), wanted_(new QCheckBox(tr("Send attempts to other programs"))) {
    setProperty("role", "card");
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(18, 16, 18, 16);
    layout->setSpacing(8);
    layout->addWidget(make_label(tr("OpenIGTLink"), "heading"));
    wanted_->setObjectName(QStringLiteral("send_attempts"));
    wanted_->setAccessibleName(tr("Send attempts to other programs"));
    layout->addWidget(wanted_, 0, Qt::AlignLeft);
    state_ = make_label({}, "muted");
    state_->setObjectName(QStringLiteral("sending_state"));
    trouble_ = make_label({}, "bad");
    trouble_->setObjectName(QStringLiteral("sending_trouble"));
    layout->addWidget(state_);
    layout->addWidget(trouble_);
    layout->addWidget(make_label(tr("For example to 3D Slicer: positions of the instruments and the camera, "
                                    "and forces, 60 times a second. No names are sent."),
                                 "muted"));
    connect(wanted_, &QCheckBox::clicked, this, [this](bool wanted) {
        context_.services().choose_sending(wanted);
        show_state();
    });
    timer_.setInterval(show_every_ms);
    connect(&timer_, &QTimer::timeout, this, &SendingCard::show_state);
    show_state();
}

void SendingCard::showEvent(QShowEvent* event) {
    QFrame::showEvent(event);
    show_state();
    timer_.start();
}

void SendingCard::hideEvent(QHideEvent* event) {
    QFrame::hideEvent(event);
    timer_.stop();
}

void SendingCard::show_state() {
    const SendingState now = context_.services().sending();
    wanted_->setChecked(now.wanted);
    wanted_->setEnabled(!now.fixed);
    QStringList lines;
    if (!now.address.empty()) {
        lines << tr("At %1; programs connected: %2").arg(text(now.address)).arg(now.clients);
        lines << (now.other_computers ? tr("Programs on other computers can connect, without a password.")
                                      : tr("Only programs on this computer can connect."));
    }
    if (now.dropped > 0)
        lines << tr("Connections closed because the program read too slowly or sent something else: %1")
                     .arg(now.dropped);
    if (now.fixed)
        lines << tr("The environment variable FULCRUM_OPENIGTLINK names the address when Fulcrum starts.");
    state_->setText(lines.join(QLatin1Char('\n')));
    state_->setVisible(!lines.isEmpty());
    trouble_->setVisible(!now.trouble.empty());
    announce_change(trouble_, sentence_text(now.trouble));
}

}  // namespace fulcrum::ui

#include "moc_sending_card.cpp"
