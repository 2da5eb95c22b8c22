// SPDX-License-Identifier: GPL-3.0-or-later
// Every text of the screens and of the delivered tasks has its German translation, and screens show it. With
// FULCRUM_PICTURES=FOLDER the German screens are stored there.
#include "ui/language/language.h"

#include <gtest/gtest.h>

#include <QDirIterator>
#include <QFile>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QXmlStreamReader>
#include <nlohmann/json.hpp>

#include "database/records/people.h"
#include "sim_core/numerics/sentence.h"
#include "tests/support/support.h"
#include "tests/ui/fake_services.h"
#include "tests/ui/hands.h"
#include "ui/language/words.h"
#include "ui/shell/main_window.h"
#include "ui/style/palette.h"
#include "ui/style/text.h"

namespace fulcrum::ui::window_test {
namespace {

struct Translation {
    QString source;
    QStringList forms;
    bool finished = true;
};

QString read(const QString& path) {
    QFile file(path);
    EXPECT_TRUE(file.open(QIODevice::ReadOnly)) << path.toStdString();
    return QString::fromUtf8(file.readAll());
}

std::vector<Translation> translations(const char* name) {
    std::vector<Translation> all;
    QXmlStreamReader xml(read(QString::fromStdString(test::source_path("ui/style/translations/")) + name));
    while (!xml.atEnd()) {
        xml.readNext();
        if (!xml.isStartElement()) continue;
        if (xml.name() == QLatin1String("source")) {
            all.push_back({xml.readElementText(), {}, true});
        } else if (xml.name() == QLatin1String("numerusform")) {
            all.back().forms << xml.readElementText();
        } else if (xml.name() == QLatin1String("translation")) {
            all.back().finished = !xml.attributes().hasAttribute(QLatin1String("type"));
            QString text;
            while (xml.readNext() != QXmlStreamReader::EndElement) {
                if (xml.isCharacters()) text += xml.text();
                if (xml.isStartElement()) all.back().forms << xml.readElementText();
            }
            if (all.back().forms.isEmpty()) all.back().forms << text;
        }
    }
    EXPECT_FALSE(xml.hasError()) << xml.errorString().toStdString();
    return all;
}

QStringList placeholders(const QString& text) {
    static const QRegularExpression pattern(QStringLiteral("%L?[0-9]|%n|\\{[a-z_]+\\}|<[^>]+>"));
    QStringList found;
    for (auto at = pattern.globalMatch(text); at.hasNext();) found << at.next().captured();
    found.sort();
    return found;
}

/// The texts of tr("..."), translate("...", "...") and QT_TRANSLATE_NOOP("...", "...") in one source.
QStringList marked_texts(QString code) {
    static const QRegularExpression comment(QStringLiteral("(?:^|\\n)\\s*//[^\\n]*"));
    code.remove(comment);
    static const QRegularExpression mark(
        QStringLiteral("(?:\\btr\\(|\\btranslate\\(\\s*\"[^\"]*\",|QT_TRANSLATE_NOOP\\(\\s*\"[^\"]*\",)\\s*(("
                       "?:\"(?:[^\"\\\\]|\\\\.)*\"\\s*)+)"));
    static const QRegularExpression literal(QStringLiteral("\"((?:[^\"\\\\]|\\\\.)*)\""));
    QStringList texts;
    for (auto at = mark.globalMatch(code); at.hasNext();) {
        QString text;
        for (auto part = literal.globalMatch(at.next().captured(1)); part.hasNext();)
            text += part.next().captured(1);
        texts << text.replace(QLatin1String("\\n"), QLatin1String("\n"))
                     .replace(QLatin1String("\\t"), QLatin1String("\t"))
                     .replace(QLatin1String("\\u00a0"), QString(QChar(0x00a0)))
                     .replace(QLatin1String("\\\""), QLatin1String("\""));
    }
    return texts;
}

TEST(German, EveryTranslationIsFinishedAndHasThePlaceholdersOfItsSource) {
    for (const char* file : {"fulcrum_de.ts", "assets_de.ts"}) {
        const std::vector<Translation> all = translations(file);
        EXPECT_GT(all.size(), 150U) << file;
        for (const Translation& one : all) {
            EXPECT_TRUE(one.finished) << one.source.toStdString();
            for (const QString& form : one.forms) {
                EXPECT_FALSE(form.trimmed().isEmpty()) << one.source.toStdString();
                EXPECT_EQ(placeholders(form), placeholders(one.source)) << one.source.toStdString() << "\n"
                                                                        << form.toStdString();
            }
        }
    }
}

TEST(German, AMetricHasOneName) {
    for (const char* file : {"fulcrum_de.ts", "assets_de.ts"})
        for (const Translation& one : translations(file))
            for (const QString& form : one.forms)
                EXPECT_FALSE(form.contains(QStringLiteral("Messgr"))) << form.toStdString() << ": Kennzahl";
}

TEST(German, EveryMarkedTextOfTheSourcesIsInTheFile) {
    QSet<QString> known;
    for (const Translation& one : translations("fulcrum_de.ts")) known.insert(one.source);
    int found = 0;
    for (const char* floor : {"sim_core", "assessment", "database", "ui", "app"}) {
        QDirIterator files(QString::fromStdString(test::source_path(floor)), {"*.cpp", "*.h"}, QDir::Files,
                           QDirIterator::Subdirectories);
        while (files.hasNext()) {
            const QString path = files.next();
            for (const QString& text : marked_texts(read(path))) {
                ++found;
                EXPECT_TRUE(known.contains(text))
                    << path.toStdString() << " has a text without translation: \"" << text.toStdString()
                    << "\"; see docs/HOWTO.md, A translation";
            }
        }
    }
    EXPECT_GT(found, 1000);
}

/// Texts that a function of the file translates, but that are not marked: lupdate does not see them.
QStringList unmarked_texts(const QString& code) {
    static const QRegularExpression helper(
        QStringLiteral("QString (\\w+)\\(const char\\* (\\w+)[^)]*\\) \\{\\s*return "
                       "QCoreApplication::translate\\(\"[^\"]+\", (\\w+)"));
    QStringList texts;
    for (auto at = helper.globalMatch(code); at.hasNext();) {
        const QRegularExpressionMatch found = at.next();
        if (found.captured(2) != found.captured(3)) continue;
        const QRegularExpression call(
            QStringLiteral("[^.>\\w]%1\\(\\s*\"((?:[^\"\\\\]|\\\\.)*)\"").arg(found.captured(1)));
        for (auto use = call.globalMatch(code); use.hasNext();) texts << use.next().captured(1);
    }
    return texts;
}

TEST(German, EveryTextThatAFunctionTranslatesIsMarked) {
    EXPECT_EQ(
        unmarked_texts("QString say(const char* source) {\n    return "
                       "QCoreApplication::translate(\"a\", source);\n}\nint f() { g(say(\"Not marked\")); }"),
        QStringList{"Not marked"});
    for (const char* floor : {"sim_core", "assessment", "database", "ui", "app"}) {
        QDirIterator files(QString::fromStdString(test::source_path(floor)), {"*.cpp", "*.h"}, QDir::Files,
                           QDirIterator::Subdirectories);
        while (files.hasNext()) {
            const QString path = files.next();
            EXPECT_EQ(unmarked_texts(read(path)), QStringList()) << path.toStdString();
        }
    }
}

TEST(German, EveryTextOfTasksCurriculaAndScenesIsInTheFile) {
    QSet<QString> known;
    for (const Translation& one : translations("assets_de.ts")) known.insert(one.source);
    const std::set<std::string> shown = {"title", "text",   "briefing", "product",
                                         "steps", "safety", "advice",   "limit_source"};
    int found = 0;
    const std::function<void(const nlohmann::json&, const std::string&, const QString&)> walk =
        [&](const nlohmann::json& node, const std::string& name, const QString& file) {
            if (node.is_object())
                for (const auto& [key, value] : node.items()) walk(value, key, file);
            if (node.is_array())
                for (const auto& value : node) walk(value, name, file);
            if (!node.is_string()) return;
            const bool label = name == "label" && file.contains(QLatin1String("/scenes/"));
            if (!label && (file.contains(QLatin1String("/scenes/")) || shown.count(name) == 0)) return;
            ++found;
            EXPECT_TRUE(known.contains(text(node.get<std::string>())))
                << file.toStdString() << ", " << name << ": \"" << node.get<std::string>() << '"';
        };
    for (const char* folder : {"assets/tasks", "assets/curricula", "assets/scenes", "assets/forms"}) {
        QDirIterator files(QString::fromStdString(test::source_path(folder)), {"*.json"}, QDir::Files);
        while (files.hasNext()) {
            const QString path = files.next();
            walk(nlohmann::json::parse(read(path).toStdString()), "", path);
        }
    }
    EXPECT_GT(found, 150);
}

TEST(German, AnUnknownLanguageIsNotGuessed) {
    const QByteArray before = qgetenv("FULCRUM_LANGUAGE");
    qputenv("FULCRUM_LANGUAGE", "deutsch");
    EXPECT_FALSE(chosen_language().has_value());
    qputenv("FULCRUM_LANGUAGE", "de");
    EXPECT_EQ(chosen_language(), Language::german);
    qunsetenv("FULCRUM_LANGUAGE");
    EXPECT_EQ(chosen_language(), Language::english);
    if (!before.isNull()) qputenv("FULCRUM_LANGUAGE", before);
}

class GermanWindow : public ::testing::Test {
  protected:
    GermanWindow() {
        apply_theme(*qApp, Theme::light);
        use_language(Language::german);
        for (const char* file : {"fulcrum_de.ts", "assets_de.ts"})
            for (const Translation& one : translations(file))
                if (!one.forms.contains(one.source)) english.insert(one.source);
        services.open_store(false);
        const database::People people(*services.store());
        const database::Session alma =
            people.create_programme("Surgery", "alma", "Alma Admin", "correct horse").administrator;
        const auto made = people.create(alma, "tara", "Tara Trainee", {database::Role::trainee});
        tara = std::make_unique<database::Session>(people.change_password(
            people.sign_in("tara", made.one_time_password), made.one_time_password, "a long password"));
        window = std::make_unique<MainWindow>(services);
        window->resize(1012, 726);
        window->show();
        EXPECT_TRUE(QTest::qWaitForWindowExposed(window.get()));
        window->start();
    }
    ~GermanWindow() override { use_language(Language::english); }
    /// No visible label or button has an English text that has another one in German.
    void expect_german(const char* page) {
        wait_until_read(*window);
        int seen = 0;
        const auto look = [&](const QString& shown, const QObject& where) {
            if (shown.isEmpty()) return;
            ++seen;
            EXPECT_FALSE(english.contains(shown))
                << page << ", " << where.objectName().toStdString() << ": " << shown.toStdString();
        };
        for (const QLabel* label : window->findChildren<QLabel*>())
            if (label->isVisible()) look(label->text(), *label);
        for (const QPushButton* button : window->findChildren<QPushButton*>())
            if (button->isVisible()) look(button->text(), *button);
        EXPECT_GT(seen, 5) << page;
        keep_picture(*window, page);
    }
    FakeServices services;
    QSet<QString> english;
    std::unique_ptr<database::Session> tara;
    std::unique_ptr<MainWindow> window;
};

TEST_F(GermanWindow, ShowsSignInHomeBriefingsAndProgressInGerman) {
    expect_german("german-sign-in");
    window->context().set_session(*tara);
    expect_german("german-home");
    for (const char* task : {"A2", "B1", "C4"}) {
        emit window->context().briefing_wanted(QString::fromLatin1(task));
        expect_german((std::string("german-briefing-") + task).c_str());
    }
    click(*window, "rail_progress");
    wait_until_read(*window);
    expect_german("german-progress");
}

TEST_F(GermanWindow, PutsCommandsInTheQuotationMarksOfTheLanguage) {
    const Sentence trouble("run `fulcrum db check`, then `fulcrum db restore`");
    EXPECT_EQ(sentence_text(trouble), "run „fulcrum db check“, then „fulcrum db restore“");
    use_language(Language::english);
    EXPECT_EQ(sentence_text(trouble), "run “fulcrum db check”, then “fulcrum db restore”");
    for (const char* kept : {"", "a single ` mark", "``", "no marks"})
        EXPECT_EQ(with_quotation_marks(kept), kept);
}

TEST_F(GermanWindow, WritesNumbersWithACommaAndNothingElseChangesThem) {
    EXPECT_EQ(figure(2.5), "2,5");
    EXPECT_EQ(asset_text("a text that no task has"), "a text that no task has");
    use_language(Language::english);
    EXPECT_EQ(figure(2.5), "2.5");
}

}  // namespace
}  // namespace fulcrum::ui::window_test
