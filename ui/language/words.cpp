// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/language/words.h"

#include <QLocale>
#include <QRegularExpression>

#include "sim_core/numerics/sentence.h"

namespace fulcrum::ui {
namespace {

QString words(const char* source) {
    return QCoreApplication::translate("fulcrum::ui::text", source);
}

}  // namespace

std::string words_in_use(const char* context, const char* source) {
    return QCoreApplication::translate(context, source).toStdString();
}

QString with_quotation_marks(QString text) {
    static const QRegularExpression command(QStringLiteral("`([^`\n]+)`"));
    for (auto found = command.match(text); found.hasMatch();) {
        const QString quoted = QLocale().quoteString(found.captured(1));
        text.replace(found.capturedStart(), found.capturedLength(), quoted);
        found = command.match(text, found.capturedStart() + quoted.size());
    }
    return text;
}

QString sentence_text(const Sentence& sentence) {
    return with_quotation_marks(QString::fromStdString(sentence.words(words_in_use)));
}

QString role_text(const std::string& role) {
    if (role == "trainee") return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "trainee"));
    if (role == "educator") return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "educator"));
    if (role == "director") return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "director"));
    if (role == "administrator") return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "administrator"));
    if (role == "station") return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "station"));
    return QString::fromStdString(role);
}

}  // namespace fulcrum::ui
