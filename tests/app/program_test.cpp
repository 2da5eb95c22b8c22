// SPDX-License-Identifier: GPL-3.0-or-later
// The interface to other programs: exit statuses, JSON, errors that name file, place and hint.
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QProcess>
#include <QProcessEnvironment>
#include <QTemporaryDir>
#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/app/program_path.h"
#include "tests/support/german_locale.h"
#include "tests/support/support.h"

namespace fulcrum::app {
namespace {

struct Outcome {
    int status = -1;
    std::string output, errors;
    nlohmann::json json() const { return nlohmann::json::parse(output); }
};

class Program : public ::testing::Test {
  protected:
    Outcome run(const QStringList& words,
                const QProcessEnvironment& environment = QProcessEnvironment::systemEnvironment()) const {
        QProcess process;
        process.setProcessEnvironment(environment);
        process.setWorkingDirectory(folder.path());
        process.start(program_path(), words);
        EXPECT_TRUE(process.waitForFinished(240000));
        return {process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -1,
                process.readAllStandardOutput().toStdString(), process.readAllStandardError().toStdString()};
    }
    QString path(const char* name) const { return folder.filePath(name); }
    void write(const char* name, const std::string& text) const {
        QFile file(path(name));
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(text.data(), static_cast<qint64>(text.size()));
    }
    QTemporaryDir folder;
};

#if defined(__x86_64__)
// The C library can be set to report fewer instructions than the processor has.
TEST_F(Program, EndsWithOneLineOnAProcessorWithoutItsInstructions) {
    const std::string own = program_path();
    const std::vector<std::pair<std::string, const char*>> programs = {
        {own, "AVX2"}, {own, "FMA"}, {own, "BMI2"}, {own + "-lab", "AVX2"}, {own + "-hapticd", "AVX2"}};
    for (const auto& [program, missing] : programs) {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("GLIBC_TUNABLES"),
                           QStringLiteral("glibc.cpu.hwcaps=-%1").arg(QLatin1String(missing)));
        process.setProcessEnvironment(environment);
        process.start(QString::fromStdString(program), {"tissues", "--json"});
        ASSERT_TRUE(process.waitForFinished()) << program;
        EXPECT_EQ(process.exitStatus(), QProcess::NormalExit) << program;
        EXPECT_EQ(process.exitCode(), 2) << program;
        EXPECT_EQ(process.readAllStandardOutput().size(), 0) << program;
        const std::string errors = process.readAllStandardError().toStdString();
        EXPECT_NE(errors.find(std::string("no ") + missing + " instructions"), std::string::npos) << errors;
        EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
    }
}
#endif

TEST_F(Program, EndsWithOneLineWhereNoDisplayCanBeOpened) {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM", "FULCRUM_LANGUAGE"})
        environment.remove(QLatin1String(name));
    const auto refused = [&](const QStringList& words, const std::string& text) {
        const Outcome outcome = run(words, environment);
        EXPECT_EQ(outcome.status, 2) << outcome.errors;
        EXPECT_EQ(outcome.output, "");
        EXPECT_EQ(outcome.errors.rfind("fulcrum: ", 0), 0U) << outcome.errors;
        EXPECT_NE(outcome.errors.find(text), std::string::npos) << outcome.errors;
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    };
    refused({}, "no display can be opened");
    refused({"--db", path("window.db")}, "start fulcrum on a desktop");
    EXPECT_FALSE(QFile::exists(path("window.db")));
    environment.insert("DISPLAY", ":6789");
    refused({}, "(DISPLAY=:6789)");
    refused({"report", "--person", "x", "--db", path("none.db"), "-o", path("x.pdf")},
            "unset DISPLAY and WAYLAND_DISPLAY");
    environment.insert("FULCRUM_LANGUAGE", "de");
    refused({}, "kein Bildschirm");
}

// Nor charts: only the program with the window has them. OpenGL comes with Qt GUI, with which the laboratory
// draws the figures of its experiments.
TEST_F(Program, TheLaboratoryLinksNoWidgets) {
    for (const std::string name : {"-lab", "-hapticd"}) {
        QProcess process;
        process.start("ldd", {QString::fromStdString(program_path() + name)});
        ASSERT_TRUE(process.waitForFinished());
        const std::string libraries = process.readAllStandardOutput().toStdString();
        ASSERT_NE(libraries.find("libstdc++"), std::string::npos) << libraries;
        EXPECT_EQ(libraries.find("Qt5Widgets"), std::string::npos) << libraries;
        EXPECT_EQ(libraries.find("Qt5Charts"), std::string::npos) << libraries;
        if (name == "-hapticd") {
            EXPECT_EQ(libraries.find("libQt5"), std::string::npos) << libraries;
        }
    }
}

TEST_F(Program, PerformsStoresAndReplaysA2) {
    const Outcome performed =
        run({"perform", "A2", "--operator", "expert", "--seed", "11", "--db", path("a.db"), "--json"});
    ASSERT_EQ(performed.status, 0) << performed.errors;
    const nlohmann::json attempt = performed.json();
    EXPECT_EQ(attempt["state"], "completed");
    EXPECT_EQ(attempt["synthetic"], true);
    EXPECT_EQ(attempt["device_class"], "synthetic");
    EXPECT_GT(attempt["metrics"].size(), 40U);
    for (const char* key : {"attempt", "task", "person", "person_id", "operator", "mode", "variant", "seed",
                            "fidelity", "duration_s", "wall_s", "passed", "not_scored_because", "points",
                            "gates", "critical_errors", "events", "missed_ticks", "state_hash"}) {
        EXPECT_TRUE(attempt.contains(key)) << key;
    }
    const std::string id = attempt["attempt"];
    // Key frames of a replay are never trusted for a score: these two do not even open them.
    ASSERT_TRUE(QFile::exists(path("a.db.frames/") + QString::fromStdString(id) + ".frames"))
        << "perform leaves them";
    write(qPrintable("a.db.frames/" + QString::fromStdString(id) + ".frames"), "frames of somebody");
    const int opened = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    ASSERT_GE(inotify_add_watch(opened, qPrintable(path("a.db.frames")), IN_OPEN | IN_MODIFY | IN_DELETE), 0);
    const Outcome replayed =
        run({"replay", QString::fromStdString(id), "--verify", "--db", path("a.db"), "--json"});
    EXPECT_EQ(replayed.status, 0) << replayed.errors << replayed.output;
    EXPECT_EQ(replayed.json()["identical"], true);
    EXPECT_EQ(replayed.json()["metrics_identical"], true);
    EXPECT_EQ(replayed.json()["state_hash"], attempt["state_hash"]);
    const Outcome checked = run({"db", "check", "--db", path("a.db"), "--json"});
    EXPECT_EQ(checked.status, 0) << checked.output;
    char event[4096];
    EXPECT_EQ(::read(opened, event, sizeof event), -1) << "the folder of key frames was looked at";
    ::close(opened);
    // The same seed gives the same attempt.
    const Outcome again =
        run({"perform", "A2", "--operator", "expert", "--seed", "11", "--db", path("b.db"), "--json"});
    EXPECT_EQ(again.json()["state_hash"], attempt["state_hash"]);
}

TEST_F(Program, RefusesBadCommandLinesWithTwo) {
    // A path below a file is not writable: reported before the work, so this test is quick.
    std::ofstream(path("file").toStdString()) << "a file";
    const QString below = path("file") + "/below";
    const QStringList lines[] = {
        {"demonstrate", "C4", "--output", below},
        {"lab", "strokes", "10000000", "--output", below},
        {"benchmark", "build", "C4", "--operators", "-o", below},
        {"dance"},
        {"perform"},
        {"perform", "A9"},
        {"perform", "A2", "--operator", "clown"},
        {"perform", "A2", "--seed", "many"},
        {"perform", "A2", "--seed"},
        {"perform", "A2", "--sed", "1"},
        {"perform", "A2", "--fidelity", "ultra", "--db", path("x.db")},
        {"perform", "A2", "--operator", "expert", "--input", "x.csv"},
        {"replay", "nothing", "--db", path("none.db")},
        {"metrics", path("none.csv")},
        {"lab", "bench", "--only", "nothing"},
        {"lab", "run"},
        {"db", "dance"},
        {"report", "--person", "x", "--as", "x"},
        {"certificate", "--as", "x"},
        {"certificate", "--verify", "x", "--person", "x", "--as", "x"},
        {"benchmark", "build", "A2"},
        {"check", path("none.json")},
    };
    for (const QStringList& line : lines) {
        const Outcome outcome = run(line);
        EXPECT_EQ(outcome.status, 2) << line.join(' ').toStdString() << ": " << outcome.errors;
        EXPECT_NE(outcome.errors.find("fulcrum: "), std::string::npos);
        EXPECT_EQ(outcome.errors.find("fulcrum: "), outcome.errors.rfind("fulcrum: "))
            << "one line: " << outcome.errors;
        EXPECT_NE(outcome.errors.find(';'), std::string::npos) << "no hint: " << outcome.errors;
    }
}

TEST_F(Program, OpensNoWindowForAStoreWithoutAName) {
    const Outcome outcome = run({"--db", ""});
    EXPECT_EQ(outcome.status, 2) << outcome.errors;
    EXPECT_EQ(outcome.errors.rfind("fulcrum: --db: its argument is empty; write --db FILE; see fulcrum", 0),
              0U)
        << outcome.errors;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
}

TEST_F(Program, RefusesATraceWhereNoFolderCanBe) {
    const Outcome performed = run({"perform", "A2", "--seed", "7", "--db", path("a.db"), "--json"});
    ASSERT_EQ(performed.status, 0) << performed.errors;
    const QString id = QString::fromStdString(performed.json()["attempt"].get<std::string>());
    write("file", "a file");
    for (const QString& output : {path("file"), path("file") + "/below"}) {
        const Outcome outcome =
            run({"report", "--attempt", id, "--format", "trace", "-o", output, "--db", path("a.db")});
        EXPECT_EQ(outcome.status, 2) << output.toStdString() << ": " << outcome.errors;
        // Qt may say something about the session before it.
        const std::size_t begin = outcome.errors.find("fulcrum: --output: cannot write to ");
        ASSERT_NE(begin, std::string::npos) << outcome.errors;
        EXPECT_NE(outcome.errors.find("; name a writable folder\n", begin), std::string::npos)
            << outcome.errors;
        EXPECT_EQ(outcome.errors.find('\n', begin) + 1, outcome.errors.size()) << "one line";
    }
}

TEST_F(Program, LeavesNoFolderForAWrongCommand) {
    const QString output = path("pages");
    const QStringList lines[] = {{"lab", "dance"},
                                 {"lab", "cut", "twice"},
                                 {"lab", "strokes", "none"},
                                 {"lab", "cost", "--sweep"},
                                 {"lab", "bench", "--sweep", "--only", "tick"},
                                 {"lab", "experiment", "--json"}};
    for (const QStringList& line : lines) {
        const Outcome outcome = run(line + QStringList{"--output", output});
        EXPECT_EQ(outcome.status, 2) << line.join(' ').toStdString() << ": " << outcome.errors;
        EXPECT_FALSE(QFileInfo::exists(output)) << line.join(' ').toStdString();
    }
}

TEST_F(Program, SaysHowToBuildTheLaboratoryWhereItIsMissing) {
    const QString copy = path("fulcrum");
    ASSERT_TRUE(QFile::copy(program_path(), copy));
    QProcess process;
    process.start(copy, {"lab", "validate"});
    ASSERT_TRUE(process.waitForFinished());
    EXPECT_EQ(process.exitCode(), 2);
    const std::string errors = process.readAllStandardError().toStdString();
    EXPECT_NE(errors.find("fulcrum-lab"), std::string::npos) << errors;
    EXPECT_NE(errors.find("./run laboratory"), std::string::npos) << errors;
}

TEST_F(Program, RefusesBrokenTraces) {
    // The fault, the file, and the row (and column) that the message must name.
    const std::array<const char*, 3> traces[] = {
        {"empty", "", ":1: t"},
        {"no t", "left.px\nm\n1\n", ":1: t"},
        {"no units", "t\n", ":2: t"},
        {"text", "t,left.px\ns,m\n0,a\n", ":3: left.px"},
        {"back", "t\ns\n1\n0\n", ":4: t"},
        {"rows", "t,left.px\ns,m\n0,1\n1\n", ":4"},
        {"nan", "t,left.px\ns,m\n0,nan\n", ":3: left.px"},
        {"unit", "t,left.px\ns,inch\n0,1\n", ":2: left.px"},
        {"twice", "t,t\ns,s\n0,0\n", ":1: 't'"},
        {"inf", "t\ns\ninf\n", ":3: t"},
        {"no samples", "t,left.px\ns,m\n", ":3: t"},
    };
    for (const auto& [name, text, place] : traces) {
        write("trace.csv", text);
        const Outcome outcome = run({"metrics", path("trace.csv")});
        EXPECT_EQ(outcome.status, 2) << name << ": " << outcome.errors;
        EXPECT_NE(outcome.errors.find(std::string("trace.csv") + place), std::string::npos)
            << name << ": " << outcome.errors;
        EXPECT_NE(outcome.errors.find(';'), std::string::npos)
            << name << " names no hint: " << outcome.errors;
    }
}

TEST_F(Program, MeasuresAnyTrace) {
    // 100 mm in 2 s: at constant speed, and as a minimum-jerk movement.
    for (const bool abrupt : {true, false}) {
        std::string text = "t,left.px,left.py,left.pz\ns,m,m,m\n";
        for (int i = 0; i <= 2000; ++i) {
            const double u = i / 2000.0, x = 0.1 * (abrupt ? u : u * u * u * (10 - 15 * u + 6 * u * u));
            char line[64];
            std::snprintf(line, sizeof line, "%.3f,%.9f,0,0\n", i * 0.001, x);
            text += line;
        }
        write("line.csv", text);
        const Outcome outcome = run({"metrics", path("line.csv"), "--json"});
        ASSERT_EQ(outcome.status, 0) << outcome.errors;
        bool found = false;
        const nlohmann::json document = outcome.json();
        for (const auto& row : document["metrics"]) {
            if (row["id"] != "path_len" || row["hand"] != "left") continue;
            found = true;
            EXPECT_NEAR(row["value"].get<double>(), 100.0, 0.1) << (abrupt ? "abrupt" : "smooth");
        }
        EXPECT_TRUE(found);
    }
}

TEST_F(Program, RefusesPipesFoldersAndDevicesWithoutWaiting) {
    ASSERT_EQ(mkfifo(path("pipe").toLocal8Bit().constData(), 0600), 0);
    for (const QString& file : {path("pipe"), folder.path(), QStringLiteral("/dev/null")}) {
        for (const QStringList& line : {QStringList{"check", file},
                                        {"metrics", file},
                                        {"lab", "run", file},
                                        {"perform", "A2", "--input", file}}) {
            const Outcome outcome = run(line);
            EXPECT_EQ(outcome.status, 2) << line.join(' ').toStdString();
            EXPECT_NE(outcome.errors.find("not a regular file"), std::string::npos) << outcome.errors;
        }
    }
}

TEST_F(Program, ReadsStandardInputForADash) {
    write("trace.csv", "t\ns\n0\n0.1\n");
    QProcess process;
    process.setStandardInputFile(path("trace.csv"));
    process.start(program_path(), {"check", "-"});
    ASSERT_TRUE(process.waitForFinished());
    EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    EXPECT_NE(process.readAllStandardOutput().indexOf("trace, 2 samples"), -1);
}

TEST_F(Program, JudgesATraceFromStandardInput) {
    const Outcome performed = run({"perform", "A2", "--seed", "7", "--db", path("a.db"), "--json"});
    ASSERT_EQ(performed.status, 0) << performed.errors;
    const QString id = QString::fromStdString(performed.json()["attempt"].get<std::string>());
    const Outcome exported =
        run({"report", "--attempt", id, "--format", "trace", "-o", path("out"), "--db", path("a.db")});
    ASSERT_EQ(exported.status, 0) << exported.errors;
    const auto line = [&](const QString& trace) {
        return QStringList{"metrics",        trace,       "--task", "A2", "--events", path("out/events.csv"),
                           "--device-class", "synthetic", "--json"};
    };
    const Outcome named = run(line(path("out/trace.csv")));
    ASSERT_EQ(named.status, 0) << named.errors;
    QProcess piped;
    piped.setWorkingDirectory(folder.path());
    piped.setStandardInputFile(path("out/trace.csv"));
    piped.start(program_path(), line("-"));
    ASSERT_TRUE(piped.waitForFinished(240000));
    EXPECT_EQ(piped.exitCode(), 0) << piped.readAllStandardError().toStdString();
    EXPECT_EQ(piped.readAllStandardOutput().toStdString(), named.output);
}

TEST_F(Program, PrintsTheSameNumbersInAGermanLocale) {
    const test::GermanLocale german;
    ASSERT_TRUE(german.in_force()) << "localedef cannot make de_DE: install the package locales";
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("LC_ALL", "C.UTF-8");
    const nlohmann::json plain =
        run({"perform", "A2", "--operator", "novice", "--seed", "3", "--db", path("a.db"), "--json"},
            environment)
            .json();
    environment.insert("LC_ALL", "de_DE.UTF-8");
    environment.insert("LOCPATH", QString::fromStdString(german.folder()));
    const nlohmann::json translated =
        run({"perform", "A2", "--operator", "novice", "--seed", "3", "--db", path("b.db"), "--json"},
            environment)
            .json();
    for (const char* key : {"advice", "metrics", "gates", "points", "state_hash", "duration_s"})
        EXPECT_EQ(plain[key], translated[key]) << key;
}

TEST_F(Program, ReportsOutputThatCannotBeWritten) {
    const std::string program = program_path();
    for (const char* target : {">/dev/full", ">&-", "| true"}) {
        QProcess process;
        process.start("bash",
                      {"-o", "pipefail", "-c", QString::fromStdString("'" + program + "' manual " + target)});
        ASSERT_TRUE(process.waitForFinished());
        if (std::string(target) == "| true" && process.exitCode() == 0)
            continue;  // the whole output fitted into the pipe
        EXPECT_EQ(process.exitCode(), 1) << target;
        const std::string errors = process.readAllStandardError().toStdString();
        EXPECT_NE(errors.find("fulcrum: standard output: "), std::string::npos) << target << ": " << errors;
        EXPECT_EQ(std::count(errors.begin(), errors.end(), '\n'), 1) << errors;
    }
}

TEST_F(Program, WritesStatementsOnlyWithAnAddress) {
    for (const QStringList& address : {QStringList(), QStringList{"--home-page", "training"}}) {
        const Outcome refused =
            run(QStringList{"report", "--person", "x", "--format", "xapi", "-o", path("x.json")} + address);
        EXPECT_EQ(refused.status, 2);
        EXPECT_NE(refused.errors.find("--home-page"), std::string::npos) << refused.errors;
        EXPECT_FALSE(QFile::exists(path("x.json")));
    }
}

TEST_F(Program, ChecksWhetherAKnownKeySignedTheNewestRow) {
    ASSERT_EQ(run({"perform", "A2", "--operator", "expert", "--seed", "5", "--db", path("a.db")}).status, 0);
    const auto checked = [&](const std::string& known) {
        return run({"db", "check", "--db", path("a.db"), "--key", QString::fromStdString(known)});
    };
    const Outcome other = checked("0123456789abcdef");
    EXPECT_EQ(other.status, 1);
    const std::string words = "signed by the key ";
    const std::size_t at = other.output.find(words);
    ASSERT_NE(at, std::string::npos) << other.output;
    const std::string key = other.output.substr(at + words.size(), 32);
    EXPECT_EQ(checked(key).status, 0);
    EXPECT_EQ(checked(key.substr(0, 16)).status, 0);
    EXPECT_EQ(checked("key").status, 2);
}

TEST_F(Program, RefusesToWriteForARealPersonWithoutOne) {
    EXPECT_EQ(run({"report", "--person", "x", "-o", path("x.pdf")}).status, 2);
}

TEST_F(Program, SaysErrorsAndHelpInTheLanguageOfTheStation) {
    QProcessEnvironment german = QProcessEnvironment::systemEnvironment();
    german.insert(QStringLiteral("FULCRUM_LANGUAGE"), QStringLiteral("de"));
    write("scene.json", "{\"id\": ");
    const struct {
        QStringList words;
        const char* said;
        int status;
    } cases[] = {
        {{"preform", "A2"},
         "fulcrum: preform: unbekannter Befehl; meinten Sie perform? siehe fulcrum --help",
         2},
        {{"perform"}, "perform: zu wenige Argumente; Aufruf: fulcrum perform AUFGABE [Optionen]", 2},
        {{"perform", "A9"}, "Befehlszeile:task: es gibt keine Aufgabe „A9“; nennen Sie eine von A1", 2},
        {{"db", "check", "--db", path("none.db")},
         "none.db: Dort ist kein Datenbestand; legen Sie einen mit",
         2},
        {{"check", path("scene.json")}, "scene.json:1: der Text ist kein gültiges JSON", 2},
    };
    for (const auto& one : cases) {
        const Outcome outcome = run(one.words, german);
        EXPECT_EQ(outcome.status, one.status) << outcome.errors;
        EXPECT_NE(outcome.errors.find(one.said), std::string::npos)
            << outcome.errors << "without: " << one.said;
    }
    const Outcome help = run({"perform", "--help"}, german);
    EXPECT_EQ(help.status, 0) << help.errors;
    EXPECT_EQ(
        help.output.rfind("Aufruf: fulcrum perform AUFGABE [Optionen]\n\nFührt einen Versuch ohne Fenster "
                          "durch, speichert und bewertet ihn.\n",
                          0),
        0U)
        << help.output;
    EXPECT_NE(help.output.find("\n  --json                    Ein JSON-Dokument auf der Standardausgabe"),
              std::string::npos)
        << help.output;
    EXPECT_NE(run({"--help"}, german).output.find("\nBefehle:\n  perform AUFGABE "), std::string::npos);
    EXPECT_NE(run({"manual"}, german).output.find("\n.SH BESCHREIBUNG\n"), std::string::npos);
    EXPECT_EQ(run({"perform", "--help"}).output.rfind("usage: fulcrum perform TASK [options]\n", 0), 0U);
    german.insert(QStringLiteral("FULCRUM_LANGUAGE"), QStringLiteral("deutsch"));
    EXPECT_NE(run({"preform"}, german).errors.find("\"deutsch\" is not the name of a language"),
              std::string::npos);
}

}  // namespace
}  // namespace fulcrum::app
