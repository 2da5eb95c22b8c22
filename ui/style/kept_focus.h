// SPDX-License-Identifier: GPL-3.0-or-later
// The keyboard stays where it was when a page, or a part of one, is filled again. UI thread.
#pragma once

#include <QList>
#include <QString>

class QWidget;

namespace fulcrum::ui {

/// Scrolls the areas around the widget, once they are laid out, until it is seen.
void bring_into_view(QWidget* widget);
/// Where the keyboard was in a part of a page that is filled again while this is there: then it is on the
/// control with the same name, counted among those that share it, else on `otherwise`. Not elsewhere.
class KeptFocus {
  public:
    explicit KeptFocus(QWidget* part, QWidget* otherwise = nullptr);
    ~KeptFocus();
    KeptFocus(const KeptFocus&) = delete;
    KeptFocus& operator=(const KeptFocus&) = delete;

  private:
    QList<QWidget*> named() const;
    QWidget *part_, *otherwise_;
    bool held_ = false;
    QString name_;
    int number_ = 0;  ///< of those with this name
};

}  // namespace fulcrum::ui
