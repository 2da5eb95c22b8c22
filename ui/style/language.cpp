// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QSettings>
#include <QTranslator>
#include <memory>
#include <vector>

#include "ui/style/linguist_file.h"

namespace fulcrum::ui {
namespace {

constexpr const char* setting = "language";

struct InUse {
    Language language = Language::english;
    std::vector<std::unique_ptr<QTranslator>> translators;
};
InUse& in_use() {
    static InUse one;
    return one;
}

void install(std::unique_ptr<QTranslator> translator) {
    QCoreApplication::installTranslator(translator.get());
    in_use().translators.push_back(std::move(translator));
}

Language known(Language language) {
    if (language != Language::system) return language;
    return QLocale::system().language() == QLocale::German ? Language::german : Language::english;
}

}  // namespace

QString language_title(Language language) {
    const char* title = row_of(languages, language).title;
    return language == Language::system ? QCoreApplication::translate("fulcrum::ui::languages", title)
                                        : QString::fromUtf8(title);
}

Language chosen_language() {
    const auto* row = find_row(languages, qgetenv("FULCRUM_LANGUAGE").toStdString());
    if (row == nullptr)
        row = find_row(languages, QSettings().value(QLatin1String(setting)).toString().toStdString());
    return row == nullptr ? Language::system : row->kind;
}

void keep_language(Language language) {
    QSettings().setValue(QLatin1String(setting), QLatin1String(row_of(languages, language).name));
}

void use_language(Language language) {
    InUse& now = in_use();
    for (const auto& old : now.translators) QCoreApplication::removeTranslator(old.get());
    now.translators.clear();
    now.language = known(language);
    const bool german = now.language == Language::german;
    if (german) {
        // Qt's own dialogs; in English where the system has no such file.
        auto dialogs = std::make_unique<QTranslator>();
        if (dialogs->load(QStringLiteral("qtbase_de"),
                          QLibraryInfo::location(QLibraryInfo::TranslationsPath)))
            install(std::move(dialogs));
    }
    install(std::make_unique<LinguistFile>(german ? QStringLiteral(":/style/translations/fulcrum_de.ts")
                                                  : QStringLiteral(":/style/translations/fulcrum_en.ts")));
    QLocale locale = german ? QLocale(QLocale::German, QLocale::Germany)
                            : QLocale(QLocale::English, QLocale::UnitedKingdom);
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    QLocale::setDefault(locale);
}

Language language_in_use() {
    return in_use().language;
}

QString decimal(double value, int decimals) {
    return with_decimal_sign(QString::number(value, 'f', decimals));
}

QString with_decimal_sign(QString number) {
    return language_in_use() == Language::german ? number.replace(QLatin1Char('.'), QLatin1Char(','))
                                                 : number;
}

}  // namespace fulcrum::ui
