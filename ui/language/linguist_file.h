// SPDX-License-Identifier: GPL-3.0-or-later
// Translations read from a file of Qt Linguist (.ts) as it is: the build needs none of Qt's translation
// tools.
#pragma once

#include <QHash>
#include <QStringList>
#include <QTranslator>

namespace fulcrum::ui {

/// The finished translations of one file. An English text and a German one have two forms: for 1 and for
/// every other number.
class LinguistFile : public QTranslator {
  public:
    /// Throws std::runtime_error for a file that cannot be read.
    explicit LinguistFile(const QString& file);
    QString translate(const char* context, const char* source, const char* disambiguation,
                      int n) const override;
    bool isEmpty() const override { return texts_.isEmpty(); }

  private:
    QHash<QByteArray, QStringList> texts_;  ///< by context and source
};

}  // namespace fulcrum::ui
