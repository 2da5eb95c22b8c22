// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/language/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QTranslator>
#include <memory>
#include <vector>

#include "ui/language/linguist_file.h"

/// Resources of a static library are linked in only where somebody asks for them, outside any namespace.
static void load_translations() {
    Q_INIT_RESOURCE(language);
}

namespace fulcrum::ui {
namespace {

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

}  // namespace

std::optional<Language> chosen_language(Language otherwise) {
    const std::string name = qgetenv("FULCRUM_LANGUAGE").toStdString();
    if (name.empty()) return otherwise;
    if (const auto* row = find_row(languages, name)) return row->kind;
    return std::nullopt;
}

bool language_is_fixed() {
    return !qEnvironmentVariableIsEmpty("FULCRUM_LANGUAGE");
}

void use_language(Language language) {
    load_translations();
    InUse& now = in_use();
    for (const auto& old : now.translators) QCoreApplication::removeTranslator(old.get());
    now.translators.clear();
    now.language = language;
    const bool german = now.language == Language::german;
    if (german) {
        // Qt's own dialogs; in English where the system has no such file.
        auto dialogs = std::make_unique<QTranslator>();
        if (dialogs->load(QStringLiteral("qtbase_de"),
                          QLibraryInfo::location(QLibraryInfo::TranslationsPath)))
            install(std::move(dialogs));
    }
    const QStringList files = german ? QStringList{QStringLiteral("fulcrum_de"), QStringLiteral("assets_de")}
                                     : QStringList{QStringLiteral("fulcrum_en")};
    for (const QString& file : files)
        install(std::make_unique<LinguistFile>(QStringLiteral(":/language/%1.ts").arg(file)));
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
