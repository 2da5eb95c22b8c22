// SPDX-License-Identifier: GPL-3.0-or-later
// Names that are stored or used inside the program, and what errors say, in the reader's language.
#pragma once

#include <QCoreApplication>
#include <QString>
#include <string>

namespace fulcrum {
class Sentence;
}

namespace fulcrum::ui {

/// The words for one name that is stored or used inside the program.
struct WordsOf {
    const char* name;
    const char* shown;  ///< marked with QT_TRANSLATE_NOOP
};
/// The words of the row with this name in the reader's language; empty if there is none.
template <std::size_t N>
QString words_in(const WordsOf (&table)[N], const std::string& name, const char* context) {
    for (const WordsOf& row : table) {
        if (name == row.name) return QCoreApplication::translate(context, row.shown);
    }
    return {};
}

/// As Sentence::words() takes it.
std::string words_in_use(const char* context, const char* source);
/// Sentences mark commands as a terminal's reader knows it, `fulcrum db check`; a window shows them in the
/// quotation marks of its language.
QString with_quotation_marks(QString text);
/// What an error says, in the reader's language.
QString sentence_text(const Sentence& sentence);
QString role_text(const std::string& role);

}  // namespace fulcrum::ui
