// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/backup_list.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>

#include "database/rows/connection.h"
#include "database/schema/migration.h"
#include "database/store/quick_check.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::database {
namespace {

namespace files = std::filesystem;

constexpr std::size_t most_noted = 10, most_listed = 50;

std::string list_path(const std::string& store_path) {
    return store_path + ".backups";
}

std::string folder_of(const std::string& path) {
    std::error_code ignored;
    const files::path whole = files::absolute(path, ignored);
    return (ignored ? files::path(path) : whole).parent_path().lexically_normal().string();
}

std::vector<std::string> noted_folders(const std::string& store_path) {
    std::vector<std::string> folders;
    std::ifstream file(list_path(store_path));
    std::string line;
    while (folders.size() < most_noted && std::getline(file, line))
        if (!line.empty() && line.front() == '/') folders.push_back(line);
    return folders;
}

bool has(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

/// A store without a log next to it, as copies are and stores in use are not. Looks at the file itself: of a
/// backup no program of ours holds a lock.
bool is_copy_of_store(const std::string& path) {
    const std::string name = files::path(path).filename().string();
    if (has(name, ".before-restore-") || has(name, ".damaged-") || has(name, unverified_ending) ||
        has(name, ".part-fulcrum-") || has(name, ".restoring-") || has(name, ".making-"))
        return false;
    char header[100] = {};
    std::ifstream file(path, std::ios::binary);
    if (!file.read(header, sizeof header)) return false;
    constexpr char magic[] = "SQLite format 3";
    constexpr int write_version = 18, read_version = 19, id_offset = 68;
    std::int64_t id = 0;
    for (int i = 0; i < 4; ++i) id = id << 8 | static_cast<unsigned char>(header[id_offset + i]);
    return std::memcmp(header, magic, sizeof magic) == 0 && header[write_version] == 1 &&
           header[read_version] == 1 && id == application_id;
}

FoundBackup look_into(FoundBackup found) {
    StoreOptions options;
    options.read_only = options.older_schema = true;
    constexpr int most_ms = 500;
    try {
        const Store store = Store::open(found.path, options);
        found.schema = store.found_schema();
        found.station_id = store.station_id();
        found.programme = store.programme_name();
        found.problems = quick_check(store, most_ms).problems;
        const auto number = [&](const char* sql) {
            Query row(store.connection(), sql);
            return row.next() ? row.integer(0) : 0;
        };
        found.people = number("SELECT COUNT(*) FROM person WHERE kind = 'real'");
        found.attempts = number("SELECT COUNT(*) FROM attempt");
        found.newest = number("SELECT MAX(time) FROM audit_entry");
    } catch (const StoreError& error) {
        found.problems.push_back(error.problem_sentence());
    }
    return found;
}

}  // namespace

std::vector<std::string> backup_folders(const std::string& store_path) {
    std::vector<std::string> folders = {folder_of(store_path)};
    for (const std::string& noted : noted_folders(store_path))
        if (std::find(folders.begin(), folders.end(), noted) == folders.end()) folders.push_back(noted);
    return folders;
}

void note_backup_folder(const std::string& store_path, const std::string& backup_path) noexcept {
    try {
        const std::string folder = folder_of(backup_path);
        std::vector<std::string> folders = noted_folders(store_path);
        if (has(folder, "\n") || (!folders.empty() && folders.front() == folder)) return;
        folders.erase(std::remove(folders.begin(), folders.end(), folder), folders.end());
        folders.insert(folders.begin(), folder);
        if (folders.size() > most_noted) folders.resize(most_noted);
        std::string text;
        for (const std::string& one : folders) text += one + "\n";
        write_output_file(list_path(store_path), text, OutputFile::Existing::replace,
                          OutputFile::Access::owner_only);
    } catch (const std::exception&) {
        // The person who looks for the backup names its folder then.
    }
}

std::vector<FoundBackup> find_backups(const std::string& store_path, const std::vector<std::string>& folders,
                                      const StoreProgress& progress) {
    std::vector<FoundBackup> found;
    std::set<std::string> seen;
    for (const std::string& folder : folders) {
        std::vector<FoundBackup> here;
        std::error_code failed;
        for (files::directory_iterator entry(folder, failed), end; !failed && entry != end;
             entry.increment(failed)) {
            struct stat status {};
            const std::string path = entry->path().string();
            std::error_code ignored;
            if (::lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode) ||
                ::access(path.c_str(), R_OK) != 0 || files::equivalent(path, store_path, ignored) ||
                !seen.insert(path).second || !is_copy_of_store(path))
                continue;
            FoundBackup one;
            one.path = path;
            one.bytes = status.st_size;
            one.written = std::int64_t{status.st_mtim.tv_sec} * 1000 + status.st_mtim.tv_nsec / 1000000;
            here.push_back(std::move(one));
        }
        std::sort(here.begin(), here.end(),
                  [](const FoundBackup& a, const FoundBackup& b) { return a.written > b.written; });
        if (here.size() > most_listed) here.resize(most_listed);
        found.insert(found.end(), here.begin(), here.end());
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (progress &&
            !progress(static_cast<double>(i) / static_cast<double>(found.size()), found[i].path)) {
            found.resize(i);
            break;
        }
        found[i] = look_into(std::move(found[i]));
    }
    std::sort(found.begin(), found.end(), [](const FoundBackup& a, const FoundBackup& b) {
        return a.newest != b.newest ? a.newest > b.newest : a.written > b.written;
    });
    return found;
}

}  // namespace fulcrum::database
