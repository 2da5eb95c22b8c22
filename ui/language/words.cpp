// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/language/words.h"

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

QString sentence_text(const Sentence& sentence) {
    return QString::fromStdString(sentence.words(words_in_use));
}

QString role_text(const std::string& role) {
    if (role == "trainee") return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "trainee"));
    if (role == "educator") return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "educator"));
    if (role == "director") return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "director"));
    if (role == "administrator") return words(QT_TRANSLATE_NOOP("fulcrum::ui::text", "administrator"));
    return QString::fromStdString(role);
}

}  // namespace fulcrum::ui
