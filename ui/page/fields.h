// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of the forms before anybody has signed in, and codes that people write down.
#pragma once

#include <QFormLayout>
#include <QLineEdit>
#include <vector>

#include "ui/style/widgets.h"

namespace fulcrum::ui {

/// A field in a row of its own, found by its name, read out by its label; what is secret is not shown.
inline QLineEdit* make_field(QFormLayout* form, const QString& label, const char* name, bool secret) {
    auto* edit = new QLineEdit;
    edit->setObjectName(QString::fromLatin1(name));
    edit->setAccessibleName(label);
    if (secret) edit->setEchoMode(QLineEdit::Password);
    form->addRow(label, edit);
    return edit;
}

/// Enter in a field leads to the next one, and in the last to the button: it performs nothing itself.
inline void enter_leads_on(const std::vector<QLineEdit*>& fields, QPushButton* button) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
        QWidget* next = i + 1 < fields.size() ? static_cast<QWidget*>(fields[i + 1]) : button;
        QObject::connect(fields[i], &QLineEdit::returnPressed, next, [next] { next->setFocus(); });
    }
}

/// Each character as wide as the others; can be selected.
inline QLabel* make_code_label(const char* name) {
    QLabel* label = make_label({}, "number");
    label->setObjectName(QString::fromLatin1(name));
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    label->setFocusPolicy(Qt::StrongFocus);  // to be read and copied without a mouse
    QFont mono(QStringLiteral("monospace"));
    mono.setStyleHint(QFont::Monospace);
    label->setFont(mono);
    return label;
}

}  // namespace fulcrum::ui
