// SPDX-License-Identifier: GPL-3.0-or-later
// The script that gives a store to a service account: what it would do, what it refuses, and what it leaves.
#include <grp.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QProcessEnvironment>
#include <QStandardPaths>
#include <QTemporaryDir>

#include "database/store/store_owner.h"
#include "tests/app/program_path.h"
#include "tests/support/support.h"

namespace fulcrum {
namespace {

struct Script {
    Script() {
        EXPECT_TRUE(QDir(folder.path()).mkpath("keys"));
        write("a store.db");
        write("keys/station.key");
        write("fulcrum");
        QFile(path("fulcrum")).setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
        const group* first = ::getgrgid(::getgid());
        if (first != nullptr) group_name = QString::fromLocal8Bit(first->gr_name);
    }
    QString path(const char* name) const { return folder.filePath(QLatin1String(name)); }
    void write(const char* name) const {
        QFile file(path(name));
        EXPECT_TRUE(file.open(QIODevice::WriteOnly)) << name;
        file.write("x");
    }
    /// Exit status; what it printed is in `output`, what it refused with in `error`.
    int run(const QString& group, const QString& store, const QString& keys, const QString& program) {
        QProcess process;
        process.start("bash", {QString::fromStdString(test::source_path("assets/service/service_account.sh")),
                               "--print", group, store, keys, program});
        EXPECT_TRUE(process.waitForFinished(300'000));
        output = QString::fromUtf8(process.readAllStandardOutput());
        error = QString::fromUtf8(process.readAllStandardError());
        return process.exitCode();
    }
    QTemporaryDir folder;
    QString group_name, output, error;
};

TEST(ServiceAccountScript, MovesStoreAndKeysAndAllowsTheWindowAlone) {
    Script script;
    ASSERT_FALSE(script.group_name.isEmpty());
    script.write("a store.db-wal");
    EXPECT_TRUE(QDir(script.folder.path()).mkpath("a store.db.frames"));
    ASSERT_EQ(
        script.run(script.group_name, script.path("a store.db"), script.path("keys"), script.path("fulcrum")),
        0)
        << script.error.toStdString();
    const QStringList lines = script.output.split('\n');
    const auto line_with = [&](const QString& words) { return lines.indexOf(lines.filter(words).value(0)); };
    const int account = line_with("adduser --system"), key = line_with("station.key"),
              log = line_with("fulcrum.db-wal"), owner = line_with("chown -R fulcrum:fulcrum"),
              rule = line_with("NOPASSWD");
    for (const int line : {account, key, log, owner, rule}) EXPECT_GE(line, 0) << script.output.toStdString();
    EXPECT_LT(account, key);
    EXPECT_TRUE(lines.value(log + 1).endsWith("/fulcrum.db.frames")) << script.output.toStdString();
    EXPECT_TRUE(lines.value(log + 2).endsWith("/fulcrum.db")) << script.output.toStdString();
    EXPECT_LT(log + 2, owner) << "the log and the store, then their owner";
    EXPECT_TRUE(lines.value(rule).contains(script.path("fulcrum") + " \"\"")) << "no command with arguments";
    EXPECT_TRUE(QFile::exists(script.path("a store.db"))) << "printing changes nothing";
}

TEST(ServiceAccountScript, RefusesWhatItCannotDoWhole) {
    Script script;
    const QString store = script.path("a store.db"), keys = script.path("keys"),
                  program = script.path("fulcrum"), group = script.group_name;
    const auto refused = [&](const QString& words) {
        return script.output.isEmpty() && script.error.contains(words);
    };
    EXPECT_EQ(script.run("no-such-group-here", store, keys, program), 2);
    EXPECT_TRUE(refused("there is no group")) << script.error.toStdString();
    EXPECT_EQ(script.run("users ALL", store, keys, program), 2);
    EXPECT_TRUE(refused("is no name of a group")) << script.error.toStdString();
    EXPECT_EQ(script.run(group, script.path("none.db"), keys, program), 2);
    EXPECT_TRUE(refused("there is no store")) << script.error.toStdString();
    EXPECT_EQ(script.run(group, store, script.path("none"), program), 2);
    EXPECT_TRUE(refused("no folder of keys")) << script.error.toStdString();
    EXPECT_EQ(script.run(group, store, keys, "fulcrum"), 2);
    EXPECT_TRUE(refused("its whole path")) << script.error.toStdString();
    EXPECT_EQ(script.run(group, store, keys, "/usr/bin/env, ALL"), 2);
    EXPECT_TRUE(refused("letters, digits")) << script.error.toStdString();
    ASSERT_TRUE(QFile::link(store, script.path("linked.db")));
    EXPECT_EQ(script.run(group, script.path("linked.db"), keys, program), 2);
    EXPECT_TRUE(refused("is a link")) << script.error.toStdString();
    QFile open(store);
    ASSERT_TRUE(open.open(QIODevice::ReadOnly));
    EXPECT_EQ(script.run(group, store, keys, program), 2);
    EXPECT_TRUE(refused("has the store open")) << script.error.toStdString();
}

/// Why the script cannot be carried out here; empty where it can.
QString obstacle() {
    if (::geteuid() != 0) return QStringLiteral("only root makes accounts");
    for (const char* program : {"adduser", "sudo", "visudo", "setpriv", "unshare"})
        if (QStandardPaths::findExecutable(QLatin1String(program), {"/usr/local/sbin", "/usr/local/bin",
                                                                    "/usr/sbin", "/usr/bin", "/sbin", "/bin"})
                .isEmpty())
            return QLatin1String(program) + QStringLiteral(" is missing");
    if (QProcess::execute("unshare", {"--mount", "--propagation", "private", "true"}) != 0)
        return QStringLiteral("this machine lets nobody make a mount namespace");
    return {};
}

/// A folder with a store, its key, the program and the script, as service_account_trial.sh wants it.
struct Trial {
    Trial() {
        const QDir opt(folder.filePath("opt"));
        EXPECT_TRUE(opt.mkpath("home/keys"));
        EXPECT_TRUE(QFile::copy(QString::fromLocal8Bit(app::program_path()), opt.filePath("fulcrum")));
        EXPECT_TRUE(QFile::setPermissions(opt.filePath("fulcrum"), QFile::ReadOwner | QFile::WriteOwner |
                                                                       QFile::ExeOwner | QFile::ReadGroup |
                                                                       QFile::ExeGroup | QFile::ReadOther |
                                                                       QFile::ExeOther));
        EXPECT_TRUE(
            QFile::copy(QString::fromStdString(test::source_path("assets/service/service_account.sh")),
                        opt.filePath("service_account.sh")));
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert("FULCRUM_STATION_KEYS", opt.filePath("home/keys"));
        EXPECT_TRUE(ended(opt.filePath("fulcrum"), {"db", "create", "--db", opt.filePath("home/fulcrum.db")},
                          environment));
        EXPECT_EQ(QDir(opt.filePath("home/keys")).entryList({"*.key"}).size(), 1);
    }
    /// Whether it ended with 0; what it printed is in `output`.
    bool ended(const QString& program, const QStringList& arguments, const QProcessEnvironment& environment) {
        QProcess process;
        process.setProcessEnvironment(environment);
        process.setProcessChannelMode(QProcess::MergedChannels);
        process.start(program, arguments);
        EXPECT_TRUE(process.waitForFinished(300'000));
        output = QString::fromUtf8(process.readAll());
        return process.exitStatus() == QProcess::NormalExit && process.exitCode() == 0;
    }
    /// Who has a file that the script left, and how.
    struct stat status(const QString& path) const {
        struct stat found {};
        EXPECT_EQ(::stat(folder.filePath(path).toLocal8Bit().constData(), &found), 0) << path.toStdString();
        return found;
    }
    QTemporaryDir folder;
    QString output;
};

QByteArray accounts() {
    QFile file(QStringLiteral("/etc/passwd"));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    return file.readAll();
}

TEST(ServiceAccountScript, CarriedOutLeavesStoreAndKeysToTheAccountAlone) {
    const QString missing = obstacle();
    if (!missing.isEmpty()) GTEST_SKIP() << missing.toStdString();
    const QByteArray before = accounts();
    Trial trial;
    ASSERT_TRUE(
        trial.ended("unshare",
                    {"--mount", "--propagation", "private", "bash",
                     QString::fromStdString(test::source_path("tests/app/services/service_account_trial.sh")),
                     trial.folder.path()},
                    QProcessEnvironment::systemEnvironment()))
        << trial.output.toStdString();
    const QStringList lines = trial.output.split('\n');
    EXPECT_EQ(lines.filter("quick check: ok").size(), 2) << "each run ends with one, as the account";
    for (const char* line :
         {"trainee starts programs: yes", "trainee reads the store: no", "trainee opens the store: no",
          "trainee lists the folder: no", "trainee moves the folder: no", "trainee has keys: no",
          "trainee finds the old store: no", "trainee starts the window: yes", "trainee runs a command: no",
          "trainee runs a shell: no", "others start the window: no", "account signs in: no",
          "account opens the store: yes"})
        EXPECT_TRUE(lines.contains(QLatin1String(line))) << line << "\n" << trial.output.toStdString();

    const QString data = "lib/fulcrum/.local/share/fulcrum", keys = "lib/fulcrum/.config/fulcrum/keys";
    const struct stat store = trial.status(data + "/fulcrum.db"), holder = trial.status(data);
    EXPECT_TRUE(database::is_service_account({store.st_uid, holder.st_uid, store.st_mode, holder.st_mode}));
    EXPECT_EQ(store.st_mode & 07777U, 0600U);
    for (const QString& place : {QStringLiteral("lib/fulcrum"), data, keys}) {
        EXPECT_EQ(trial.status(place).st_uid, store.st_uid) << place.toStdString();
        EXPECT_EQ(trial.status(place).st_mode & 07777U, 0700U) << place.toStdString();
    }
    const QStringList key = QDir(trial.folder.filePath(keys)).entryList(QDir::Files);
    ASSERT_EQ(key.size(), 1);
    EXPECT_EQ(trial.status(keys + '/' + key[0]).st_uid, store.st_uid);
    EXPECT_EQ(trial.status(keys + '/' + key[0]).st_mode & 07777U, 0600U);
    const struct stat rule = trial.status("etc/sudoers.d/fulcrum");
    EXPECT_EQ(rule.st_uid, 0U);
    EXPECT_EQ(rule.st_mode & 07777U, 0440U);
    EXPECT_EQ(accounts(), before) << "this machine keeps its accounts";
}

}  // namespace
}  // namespace fulcrum
