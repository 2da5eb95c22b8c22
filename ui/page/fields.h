// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of the forms before anybody has signed in.
#pragma once

#include <QFormLayout>
#include <QLineEdit>

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

}  // namespace fulcrum::ui
