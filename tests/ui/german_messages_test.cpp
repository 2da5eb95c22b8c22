// SPDX-License-Identifier: GPL-3.0-or-later
// Messages of errors in a German window: from the store, from readers, from attempts.
#include <sqlite3.h>

#include <QDateEdit>
#include <QFile>

#include "database/records/people.h"
#include "database/roster/roster.h"
#include "sim_core/scene/scene.h"
#include "tests/ui/screens.h"
#include "ui/language/error_text.h"
#include "ui/language/language.h"
#include "ui/style/palette.h"
#include "ui/theatre/scene_picture.h"

namespace fulcrum::ui::window_test {
namespace {

class GermanMessages : public Screens {
  protected:
    GermanMessages() { use_language(Language::german); }
    ~GermanMessages() override { use_language(Language::english); }
};

/// What the work throws, as a person reads it.
std::string message_of(const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& error) {
        return error_text(error).toStdString();
    }
    return "nothing was thrown";
}

void expect_words(const std::string& message, const std::vector<std::string>& words) {
    for (const std::string& one : words)
        EXPECT_NE(message.find(one), std::string::npos) << message << "\nwithout: " << one;
}

TEST_F(GermanMessages, WrongPassword) {
    open(QSize(1012, 726));
    type(*window, "login", "tara");
    type(*window, "password", "not hers at all");
    click(*window, "sign_in");
    auto* problem = find<QLabel>(*window, "sign_in_problem");
    ASSERT_TRUE(wait_for([&] { return !problem->text().isEmpty(); }));
    expect_words(problem->text().toStdString(),
                 {"Anmeldename oder Passwort falsch; in ", " s können Sie es noch einmal versuchen"});
    keep("german-wrong-password");
}

TEST_F(GermanMessages, StoreThatIsNotOneAndStoreThatIsLocked) {
    FakeServices elsewhere;
    QFile file(QString::fromStdString(elsewhere.store_path(false)));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(QByteArray(9000, 'x'));
    file.close();
    MainWindow broken(elsewhere);
    broken.resize(1012, 726);
    broken.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&broken));
    broken.start();
    QString shown;
    for (const QLabel* label : broken.findChildren<QLabel*>())
        if (label->isVisible()) shown += label->text() + QLatin1Char('\n');
    expect_words(shown.toStdString(), {"ist kein Datenbestand von Fulcrum", "nennen Sie die richtige Datei"});
    keep_picture(broken, "german-broken-store");

    expect_words(
        message_of([&] { services.store()->connection().fail(QStringLiteral("locked"), SQLITE_BUSY); }),
        {"Ein anderes Programm schreibt gerade in den Datenbestand; warten Sie, bis es fertig ist"});
}

TEST_F(GermanMessages, BrokenSceneFile) {
    expect_words(message_of([] { parse_scene("{\"id\": \"x\",\n \"gravty\": 1}", "broken.json"); }),
                 {"broken.json:2 (/gravty): unbekannter Schlüssel \"gravty\"; meinten Sie \"gravity\"?"});
    expect_words(message_of([] { parse_scene("{\"id\": ", "cut.json"); }),
                 {"cut.json:1: der Text ist kein gültiges JSON", "berichtigen Sie den Text in dieser Zeile"});
    expect_words(message_of([] { parse_scene(std::string(100, '['), "deep.json"); }),
                 {"der Text ist tiefer als 32 Ebenen verschachtelt"});
}

TEST_F(GermanMessages, AttemptThatCannotStart) {
    open(QSize(1012, 726));
    sign_in(Role::director);
    emit window->context().attempt_wanted("A2", true, 0, false);
    settle();
    expect_words(error_shown().toStdString(),
                 {"Als Programmleitung dürfen Sie das nicht: einen Versuch durchführen"});
    keep("german-attempt-refused");
    // Another program removed the store while this one ran.
    sign_in(Role::trainee);
    ASSERT_TRUE(QFile::remove(QString::fromStdString(services.store_path(false))));
    emit window->context().attempt_wanted("A2", true, 0, false);
    settle();
    expect_words(error_shown().toStdString(), {"Dort ist kein Datenbestand; legen Sie einen mit"});
}

TEST_F(GermanMessages, ListWithAWrongLine) {
    open(QSize(1012, 726));
    sign_in(Role::administrator);
    go_to("rail_people");
    QTemporaryDir folder;
    QFile list(folder.filePath("list.csv"));
    ASSERT_TRUE(list.open(QIODevice::WriteOnly));
    list.write("login,name,role\nanna,Anna Example,trainee\nberta,Berta Example\n");
    list.close();
    auto* path = find<QLineEdit>(*window, "import_path");
    ASSERT_NE(path, nullptr);
    bring(*path);
    type(*window, "import_path", list.fileName());
    click(*window, "import_look");
    settle();
    expect_words(
        error_shown().toStdString(),
        {"list.csv:3: hat 2 Zellen, die erste Zeile hat 3; geben Sie jeder Zeile gleich viele Zellen"});
    keep("german-import");
}

TEST_F(GermanMessages, SceneWhosePictureCannotBeMade) {
    open(QSize(1012, 726));
    const std::string attempt = perform();
    try {
        parse_scene("{\"id\": ", "cut.json");
    } catch (const InputError& error) {
        services.broken_scene = error;
    }
    emit window->context().debrief_wanted(text(attempt), -1);
    wait_for_debrief();
    QString shown;
    for (const QLabel* label : window->current_page()->findChildren<QLabel*>())
        if (label->isVisible()) shown += label->text() + QLatin1Char('\n');
    expect_words(shown.toStdString(), {"cut.json:1: der Text ist kein gültiges JSON"});
    emit window->context().briefing_wanted("A2");
    settle();
    expect_words(find<ScenePicture>(*window, "scene_picture")->trouble().toStdString(),
                 {"cut.json:1: der Text ist kein gültiges JSON"});
}

TEST_F(GermanMessages, DaysOfTheAuditLogAreChosenAsTheLanguageWritesThem) {
    open(QSize(1012, 726));
    sign_in(Role::administrator);
    go_to("rail_audit");
    for (const char* name : {"audit_from", "audit_until"})
        EXPECT_EQ(window->findChild<QDateEdit*>(name)->displayFormat(), "d. MMM yyyy") << name;
}

/// What a part says is put in as it is, also where it looks like a place; marked parts are translated.
TEST_F(GermanMessages, PartsArePutIntoTheirPlacesOnce) {
    EXPECT_EQ(sentence_text({"%1 und %2", std::string("%2"), std::string("b")}).toStdString(), "%2 und b");
    const Sentence role("this account does not hold the role %1", "director");
    EXPECT_EQ(sentence_text(role).toStdString(), "dieses Konto hat die Rolle Programmleitung nicht");
    EXPECT_EQ(role.words(), "this account does not hold the role director");
    EXPECT_EQ(sentence_text(std::string("director")).toStdString(), "director") << "a name stays a name";
}

}  // namespace
}  // namespace fulcrum::ui::window_test
