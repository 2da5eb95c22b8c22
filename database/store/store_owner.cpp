// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/store/store_owner.h"

#include <sys/stat.h>

#include <filesystem>

namespace fulcrum::database {
namespace {

constexpr uid_t last_system_account = 999;  // SYS_UID_MAX
constexpr mode_t others_write = 022;

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

}  // namespace fulcrum::database
