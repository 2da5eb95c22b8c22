// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/database/postgresql_server.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <grp.h>
#include <netinet/in.h>
#include <pwd.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QDir>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <system_error>
#include <thread>
#include <vector>

#include "database/rows/connection.h"
#include "database/sync/programme_server.h"

namespace fulcrum::database::test {
namespace {

namespace files = std::filesystem;

[[noreturn]] void give_up(const std::string& why) {
    std::fprintf(stderr, "the tests' PostgreSQL does not start: %s\n", why.c_str());
    std::exit(1);
}

/// The folder of initdb and postgres; the newest version of Debian's.
std::string programs_folder() {
    const QDir versions(QStringLiteral("/usr/lib/postgresql"));
    QString newest;
    for (const QString& version : versions.entryList(QDir::Dirs | QDir::NoDotAndDotDot))
        if (QFile::exists(versions.filePath(version) + "/bin/initdb") &&
            (newest.isEmpty() || version.toInt() > newest.toInt()))
            newest = version;
    if (!newest.isEmpty()) return (versions.filePath(newest) + "/bin").toStdString();
    const QString found = QStandardPaths::findExecutable(QStringLiteral("initdb"));
    return found.isEmpty() ? std::string() : QFileInfo(found).path().toStdString();
}

/// PostgreSQL does not run as root.
const passwd* other_account() {
    if (::geteuid() != 0) return nullptr;
    for (const char* name : {"postgres", "nobody"})
        if (const passwd* account = ::getpwnam(name)) return account;
    give_up("no account but root");
}

/// Starts a program whose output goes to `log`; it ends with this process. `language`: of its messages, where
/// it has a locale other than "C".
pid_t start(const std::vector<std::string>& words, const passwd* account, const std::string& log,
            const char* language = nullptr) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    const int output = ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666);
    const pid_t child = ::fork();
    if (child != 0) {
        ::close(output);
        return child;
    }
    ::dup2(output, STDOUT_FILENO);
    ::dup2(output, STDERR_FILENO);
    if (account != nullptr &&
        (::setgroups(0, nullptr) != 0 || ::setgid(account->pw_gid) != 0 || ::setuid(account->pw_uid) != 0))
        ::_exit(126);
    ::prctl(PR_SET_PDEATHSIG, SIGQUIT);
    if (::chdir("/") != 0) ::_exit(126);
    if (language != nullptr) ::setenv("LANGUAGE", language, 1);
    ::execv(arguments[0], arguments.data());
    ::_exit(127);
}

std::string contents(const std::string& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Where a new cluster of these programs is kept: in the folder of the executables of the tests.
files::path kept_cluster(const std::string& programs) {
    const auto installed = files::last_write_time(programs + "/initdb").time_since_epoch().count();
    return files::read_symlink("/proc/self/exe").parent_path() / ("postgresql-" + std::to_string(installed));
}

/// False where that is not possible.
bool copy_cluster(const files::path& from, const files::path& to, const passwd* account) {
    std::error_code trouble;
    files::copy(from, to, files::copy_options::recursive, trouble);
    if (!trouble) files::permissions(to, files::perms::owner_all, trouble);
    if (trouble || account == nullptr) return !trouble;
    if (::lchown(to.c_str(), account->pw_uid, account->pw_gid) != 0) return false;
    for (const auto& entry : files::recursive_directory_iterator(to))
        if (::lchown(entry.path().c_str(), account->pw_uid, account->pw_gid) != 0) return false;
    return true;
}

/// initdb takes longer than most tests: its outcome is copied, and made where there is none yet. Several
/// processes may begin at once; the first that is finished gives the copy its name.
void make_cluster(const std::string& programs, const std::string& data, const std::string& log,
                  const passwd* account) {
    const files::path kept = kept_cluster(programs);
    std::error_code trouble;
    if (files::exists(kept)) {
        if (copy_cluster(kept, data, account)) return;
        files::remove_all(data, trouble);  // of an account whose files this one may not read
    }
    const pid_t initdb = start({programs + "/initdb", "--no-sync", "-U", "owner", "--auth=trust",
                                "--locale=C.UTF-8", "--lc-messages=C", "-D", data},
                               account, log);
    int status = 0;
    ::waitpid(initdb, &status, 0);
    if (status != 0) give_up(contents(log));
    const files::path copy = kept.string() + ".new-" + std::to_string(::getpid());
    if (copy_cluster(data, copy, nullptr)) files::rename(copy, kept, trouble);
    files::remove_all(copy, trouble);
}

/// An address of the loopback that no other test's server has, so that all can have the usual port, and that
/// the program does not take for its own machine. Empty where something has it already.
std::string own_address() {
    const auto process = static_cast<unsigned>(::getpid());
    const std::string address = "127." + std::to_string(1 + (process >> 16U)) + "." +
                                std::to_string((process >> 8U) & 255U) + "." + std::to_string(process & 255U);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(5432);
    ::inet_pton(AF_INET, address.c_str(), &place.sin_addr);
    const int probe = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int on = 1;
    ::setsockopt(probe, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);  // as PostgreSQL does
    const bool is_free = ::bind(probe, reinterpret_cast<const sockaddr*>(&place), sizeof place) == 0;
    ::close(probe);
    return is_free ? address : std::string();
}

struct Running {
    QTemporaryDir folder{QDir::tempPath() + "/fulcrum-pg-XXXXXX"};
    pid_t process = -1;
    ~Running() {
        if (process <= 0) return;
        ::kill(process, SIGQUIT);
        ::waitpid(process, nullptr, 0);
    }
};

void wait_until_ready(const Running& running, const std::string& data, const std::string& log) {
    // Its own statement of how far it is, a word in a file.
    for (int tries = 0; tries < 3000; ++tries) {
        if (contents(data + "/postmaster.pid").find("ready") != std::string::npos) return;
        if (::waitpid(running.process, nullptr, WNOHANG) != 0) break;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    give_up(contents(log));
}

}  // namespace

PostgresqlServer* PostgresqlServer::of_this_process() {
    static Running running;
    static const std::unique_ptr<PostgresqlServer> server = []() -> std::unique_ptr<PostgresqlServer> {
        const std::string programs = programs_folder();
        if (programs.empty()) return nullptr;
        const passwd* account = other_account();
        const std::string folder = running.folder.path().toStdString(), data = folder + "/data",
                          log = folder + "/log";
        if (account != nullptr && ::chown(folder.c_str(), account->pw_uid, account->pw_gid) != 0)
            give_up("its folder");
        make_cluster(programs, data, log, account);
        std::ofstream(data + "/pg_hba.conf") << "local all +fulcrum_station scram-sha-256\n"
                                                "local all +fulcrum_enrol scram-sha-256\nlocal all all "
                                                "trust\nhost all +fulcrum_station 127.0.0.0/8 "
                                                "scram-sha-256\n";
        running.process = start(
            {programs + "/postgres", "-D", data, "-k", folder, "-c", "listen_addresses=" + own_address(),
             "-c", "fsync=off", "-c", "full_page_writes=off", "-c", "synchronous_commit=off"},
            account, log, "de");
        wait_until_ready(running, data, log);
        auto made = std::unique_ptr<PostgresqlServer>(new PostgresqlServer());
        made->socket_folder_ = folder;
        ServerAddress first;
        first.host = folder;
        first.user = "owner";
        first.database = "postgres";
        made->execute(first,
                      std::string("CREATE ROLE station LOGIN PASSWORD '") + "a station''s secret" + "'");
        made->execute(first, "CREATE DATABASE with_tables");
        first.database = "with_tables";
        create_programme_server(first);
        made->execute(first, "GRANT fulcrum_station TO station");
        return made;
    }();
    return server.get();
}

ServerAddress PostgresqlServer::new_database(bool with_tables) {
    ServerAddress address;
    address.host = socket_folder_;
    address.user = "owner";
    address.database = "postgres";
    const std::string name = "d" + std::to_string(++databases_);
    execute(address, "CREATE DATABASE " + name + (with_tables ? " TEMPLATE with_tables" : ""));
    address.database = name;
    return address;
}

ServerAddress PostgresqlServer::new_database_sorted_as(const std::string& language) {
    ServerAddress address;
    address.host = socket_folder_;
    address.user = "owner";
    address.database = "postgres";
    const std::string name = "d" + std::to_string(++databases_);
    try {
        execute(address, "CREATE DATABASE " + name + " TEMPLATE template0 LOCALE_PROVIDER icu ICU_LOCALE '" +
                             language + "'");
    } catch (const StoreError&) {
        return new_database();
    }
    address.database = name;
    create_programme_server(address);
    return address;
}

ServerAddress PostgresqlServer::as(ServerAddress address, const std::string& user) {
    address.user = user;
    return address;
}

void PostgresqlServer::execute(const ServerAddress& address, const std::string& sql) const {
    Connection(address).execute(QString::fromStdString(sql));
}

void PostgresqlServer::write_german(bool german) const {
    // The language is that of LANGUAGE (see above), for which every locale but "C" will do.
    const std::string locale = german ? "C.UTF-8" : "C";
    ServerAddress address;
    address.host = socket_folder_;
    address.user = "owner";
    address.database = "postgres";
    execute(address, "ALTER SYSTEM SET lc_messages = '" + locale + "'");
    execute(address, "SELECT pg_reload_conf()");
    // A connection has what the server had when the connection was made.
    for (int tries = 0; tries < 3000; ++tries) {
        Connection connection(address);
        Query now(connection, "SHOW lc_messages");
        if (now.next() && now.text(0) == locale) return;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    give_up("its language stays another one than " + locale);
}

}  // namespace fulcrum::database::test
