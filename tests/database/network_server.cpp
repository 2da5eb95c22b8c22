// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/database/network_server.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <QProcess>
#include <QStandardPaths>
#include <chrono>
#include <filesystem>
#include <thread>
#include <utility>

#include "database/rows/connection.h"

namespace fulcrum::database::test {

std::optional<Certificate> make_certificate(const std::string& folder, const std::string& name) {
    const QString openssl = QStandardPaths::findExecutable(QStringLiteral("openssl"));
    if (openssl.isEmpty()) return std::nullopt;
    const Certificate made{folder + "/" + name + ".crt", folder + "/" + name + ".key"};
    QProcess process;
    process.start(openssl, {"req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1",
                            "-nodes", "-days", "2", "-subj", QString::fromStdString("/CN=" + name), "-keyout",
                            QString::fromStdString(made.key), "-out", QString::fromStdString(made.file)});
    EXPECT_TRUE(process.waitForFinished());
    EXPECT_EQ(process.exitCode(), 0) << process.readAllStandardError().toStdString();
    return made;
}

NetworkServer::NetworkServer(ServerAddress database) : database_(std::move(database)) {}

NetworkServer::~NetworkServer() {
    if (is_encrypted_) turn_tls(false);
}

std::optional<ServerAddress> NetworkServer::as(const std::string& user) const {
    ServerAddress address = database_;
    address.host = setting("listen_addresses");
    address.user = user;
    if (address.host.empty()) return std::nullopt;
    return address;
}

void NetworkServer::encrypt_with(const Certificate& certificate) {
    const std::filesystem::path data = setting("data_directory");
    struct stat owner {};
    ASSERT_EQ(::stat(data.c_str(), &owner), 0);
    for (const auto& [from, name] :
         {std::pair(certificate.file, "server.crt"),  // as PostgreSQL looks for them
          std::pair(certificate.key, "server.key")}) {
        const std::filesystem::path to = data / name;
        std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing);
        ASSERT_EQ(::chmod(to.c_str(), 0600), 0);
        ASSERT_EQ(::chown(to.c_str(), owner.st_uid, owner.st_gid), 0);
    }
    is_encrypted_ = true;
    turn_tls(true);
}

void NetworkServer::turn_tls(bool on) {
    {
        Connection connection(database_);
        connection.execute(on ? "ALTER SYSTEM SET ssl = on" : "ALTER SYSTEM RESET ssl");
        connection.execute("SELECT pg_reload_conf()");
    }
    // It reads its settings when it comes to it; later connections have them.
    const std::string wanted = on ? "on" : "off";
    for (int tries = 0; tries < 3000 && setting("ssl") != wanted; ++tries)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    EXPECT_EQ(setting("ssl"), wanted);
}

std::string NetworkServer::setting(const char* name) const {
    Connection connection(database_);
    Query row(connection, QStringLiteral("SELECT current_setting(?)"));
    row.bind(name);
    return row.next() ? row.text(0) : std::string();
}

}  // namespace fulcrum::database::test
