// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/store_owner.h"

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <filesystem>

namespace fulcrum::database {
namespace {

constexpr uid_t last_system_account = 999;  // SYS_UID_MAX
constexpr mode_t others_write = 022;

/// Its name, or its number as sudo takes it where it has none.
std::string name_of_account(uid_t account) {
    constexpr std::size_t longest_entry = 4096;
    std::array<char, longest_entry> space{};
    passwd entry{};
    passwd* found = nullptr;
    if (::getpwuid_r(account, &entry, space.data(), space.size(), &found) == 0 && found != nullptr)
        return found->pw_name;
    return "#" + std::to_string(account);
}

}  // namespace

bool is_service_account(const StoreOwner& owner) {
    return owner.file > 0 && owner.file <= last_system_account &&
           (owner.folder == owner.file || owner.folder == 0) && (owner.file_mode & others_write) == 0 &&
           (owner.folder_mode & others_write) == 0;
}

bool owned_by_service_account(const Store& store) {
    if (store.is_server()) return true;
    const std::filesystem::path path = std::filesystem::absolute(store.path());
    struct stat file {
    }, folder{};
    if (::stat(path.c_str(), &file) != 0 || ::stat(path.parent_path().c_str(), &folder) != 0) return false;
    return is_service_account({file.st_uid, folder.st_uid, file.st_mode, folder.st_mode});
}

bool belongs_to_another_account(const std::string& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && status.st_uid != ::geteuid();
}

void fail_as_of_another_account(const std::string& path) {
    struct stat status {};
    const std::string account = name_of_account(::stat(path.c_str(), &status) == 0 ? status.st_uid : 0);
    throw StoreError(
        StoreErrorKind::failed,
        {QT_TRANSLATE_NOOP("errors",
                           "%1: this store belongs to the account %2, whose key signs its audit log"),
         path, account},
        {QT_TRANSLATE_NOOP("errors",
                           "run the command as that account (`sudo -u %1 -H fulcrum …`), or name the folder "
                           "of its keys in FULCRUM_STATION_KEYS"),
         account});
}

}  // namespace fulcrum::database
