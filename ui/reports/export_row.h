// SPDX-License-Identifier: GPL-3.0-or-later
// Where a report goes: format, file and what writes it, on the page itself. A file that is there already is
// replaced only by a button that says so.
#pragma once

#include <QWidget>

class QComboBox;
class QLineEdit;
class QPushButton;

namespace fulcrum::ui {

/// Of `name` the characters that no file system minds; never empty.
QString file_name(const QString& name);

class ExportRow : public QWidget {
    Q_OBJECT
  public:
    /// `save_name`: object name of the button that writes.
    explicit ExportRow(const char* save_name, QWidget* parent = nullptr);
    /// Proposes a file of this name, in the folder that was chosen last or else among the documents.
    void propose(const QString& name);
    /// The chosen file; its ending says the format.
    QString path() const;
    /// What stands at `path` now: the button says whether it would be replaced.
    void look();

  signals:
    void save_wanted(const QString& path);

  private:
    void choose();
    void format_chosen();
    QString proposed_;
    QComboBox* format_;
    QLineEdit* path_;
    QPushButton* save_;
};

}  // namespace fulcrum::ui
