// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/settings_page.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QRadioButton>

#include "ui/shell/devices_card.h"
#include "ui/shell/keys_card.h"
#include "ui/shell/picture_card.h"
#include "ui/shell/sending_card.h"
#include "ui/shell/sound_card.h"
#include "ui/style/appearance.h"
#include "ui/style/text.h"
#include "ui/style/widgets.h"

namespace fulcrum::ui {
namespace {

QRadioButton* make_choice(QButtonGroup* group, int id, const QString& shown, const QString& name) {
    auto* choice = new QRadioButton(shown);
    choice->setObjectName(name);
    choice->setAccessibleName(shown);
    group->addButton(choice, id);
    return choice;
}

/// The name of what a row chooses, which assistive technology reads with each of its controls.
QLabel* make_row_title(const QString& shown, QWidget* control) {
    auto* title = new QLabel(shown);
    title->setBuddy(control);
    return title;
}

}  // namespace

SettingsPage::SettingsPage(Context& context)
    : Page(context, "settings_page"),
      theme_(new QButtonGroup(this)),
      language_(new QButtonGroup(this)),
      text_size_(new QComboBox) {
    auto* body = new QWidget;
    auto* layout = new QVBoxLayout(body);
    layout->setSpacing(14);
    layout->addWidget(make_label(tr("Settings"), "title"));
    layout->addWidget(make_label(tr("Settings are saved on this computer. All except the keys apply to "
                                    "everyone who uses this account of the operating system."),
                                 "muted"));
    layout->addWidget(build_appearance());
    layout->addWidget(build_language());
    layout->addWidget(new PictureCard);
    layout->addWidget(new KeysCard(context));
    layout->addWidget(new DevicesCard(context));
    layout->addWidget(new SoundCard(context));
    layout->addWidget(new SendingCard(context));
    layout->addStretch(1);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scrolled(body, 1000));
    connect(&context, &Context::appearance_changed, this, &SettingsPage::show_choices);
    show_choices();
}

QFrame* SettingsPage::build_appearance() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(make_label(tr("Appearance"), "heading"));
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(24);
    grid->setVerticalSpacing(10);
    grid->setColumnStretch(1, 1);
    auto* row = new QHBoxLayout;
    row->setSpacing(18);
    for (const auto& one : themes)
        row->addWidget(make_choice(theme_, static_cast<int>(one.kind), theme_title(one.kind),
                                   QStringLiteral("theme_") + QLatin1String(one.name)));
    row->addStretch();
    grid->addWidget(make_row_title(tr("Theme"), theme_->buttons().first()), 0, 0);
    grid->addLayout(row, 0, 1);
    connect(theme_, &QButtonGroup::idClicked, this,
            [this](int id) { emit this->context().theme_wanted(static_cast<Theme>(id)); });

    text_size_->setObjectName(QStringLiteral("text_size"));
    text_size_->setAccessibleName(tr("Text size"));
    text_size_->setMinimumContentsLength(7);
    for (const int percent : text_percents) text_size_->addItem(tr("%1 %").arg(percent), percent);
    grid->addWidget(make_row_title(tr("Text size"), text_size_), 1, 0);
    grid->addWidget(text_size_, 1, 1, Qt::AlignLeft);
    connect(text_size_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
        emit this->context().text_size_wanted(text_size_->itemData(index).toInt());
    });
    card_layout(card)->addLayout(grid);
    card_layout(card)->addWidget(make_label(
        tr("During an attempt, the text over the picture grows only as far as there is room."), "muted"));
    return card;
}

QFrame* SettingsPage::build_language() {
    QFrame* card = make_card(8);
    card_layout(card)->addWidget(make_label(tr("Language"), "heading"));
    for (const auto& one : languages) {
        // A language's name is in that language, so it is not translated.
        auto* choice = make_choice(language_, static_cast<int>(one.kind), QString::fromUtf8(one.title),
                                   QStringLiteral("language_") + QLatin1String(one.name));
        choice->setEnabled(!language_is_fixed());
        card_layout(card)->addWidget(choice);
    }
    if (language_is_fixed())
        card_layout(card)->addWidget(
            make_label(tr("The environment variable FULCRUM_LANGUAGE chooses the language of this station. "
                          "Start Fulcrum without it to choose here."),
                       "muted"));
    connect(language_, &QButtonGroup::idClicked, this,
            [this](int id) { emit this->context().language_wanted(static_cast<Language>(id)); });
    return card;
}

void SettingsPage::enter() {
    show_choices();
    theme_->checkedButton()->setFocus();
}

void SettingsPage::show_choices() {
    theme_->button(static_cast<int>(current_theme()))->setChecked(true);
    const Context::Look& asked = context().asked_look();
    text_size_->setCurrentIndex(text_size_->findData(asked.text_percent.value_or(text_percent())));
    language_->button(static_cast<int>(asked.language.value_or(language_in_use())))->setChecked(true);
}

}  // namespace fulcrum::ui

#include "moc_settings_page.cpp"
