// SPDX-License-Identifier: GPL-3.0-or-later
// The script that gives a store to a service account: what it would do, and what it refuses. That the result
// counts as a service account is StoreOwner's part.
#include <grp.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

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
        EXPECT_TRUE(process.waitForFinished());
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

}  // namespace
}  // namespace fulcrum
