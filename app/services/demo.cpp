// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/demo.h"

#include <QCoreApplication>
#include <QLockFile>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "assessment/assets/assets.h"
#include "database/rows/crypto.h"
#include "database/rows/packed_bytes.h"
#include "database/store/accepted_assets.h"
#include "database/store/kept_frames.h"
#include "sim_core/numerics/files.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::app {
namespace {

void remove_store(const std::string& path) {
    std::error_code ignored;
    for (const char* suffix : {"", "-wal", "-shm"}) std::filesystem::remove(path + suffix, ignored);
}

/// Removes an unfinished store when it ends, however it ends.
class Unfinished {
  public:
    explicit Unfinished(std::string path) : path_(std::move(path)) { remove_store(path_); }
    ~Unfinished() {
        remove_store(path_);
        remove_store(path_ + ".before-v" + std::to_string(database::Store::schema_version()));
    }
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

  private:
    std::string path_;
};

std::string read_packed(const std::string& file) {
    require_regular_file(file);
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Throws InputError where the program was delivered with another one, or with none.
void require_delivered(const std::string& file, const std::string& bytes) {
    const std::string digest = database::sha256_hex(bytes);
    for (const database::AssetFile& delivered : database::delivered_assets())
        if (delivered.name == demo_asset && delivered.digest == digest) return;
    throw InputError(
        file, "",
        QT_TRANSLATE_NOOP("errors", "is not the demonstration that this program was delivered with"),
        QT_TRANSLATE_NOOP("errors", "install the program again"));
}

/// Writes the store under a name of its own first, so that a kill leaves no half of one.
bool write_store(const std::vector<std::uint8_t>& bytes, const std::string& path,
                 const ui::Progress& progress) {
    const std::string unfinished = path + ".unpacking";
    std::filesystem::create_directories(std::filesystem::path(path).parent_path());
    // Of two windows that do this at once the second one takes what the first has made.
    QLockFile lock(QString::fromStdString(path + ".lock"));
    constexpr int longest_wait_ms = 30000;
    if (!lock.tryLock(0) && lock.tryLock(longest_wait_ms) && database::Store::exists(path)) return true;
    const Unfinished remove_at_end(unfinished);
    write_output_file(unfinished, {reinterpret_cast<const char*>(bytes.data()), bytes.size()},
                      OutputFile::Existing::replace, OutputFile::Access::owner_only);
    {
        // Brings an older one up to date; there is nobody's data in it, so the copy from before is not kept.
        const database::Store store = database::Store::open(unfinished);
    }
    if (progress && !progress(0.9, {})) return false;
    remove_store(path);
    database::remove_all_kept_frames(path);
    rename_replacing(unfinished, path);
    return true;
}

bool unpack_bytes_of(const std::string& packed, const std::string& path, const ui::Progress& progress) {
    const std::string line =
        QCoreApplication::translate("fulcrum::app::demo", "Unpacking the demonstration").toStdString();
    if (progress && !progress(0.2, line)) return false;
    const std::vector<std::uint8_t> bytes = database::unpack_bytes({packed.begin(), packed.end()});
    if (progress && !progress(0.5, line)) return false;
    return write_store(bytes, path, progress);
}

}  // namespace

bool unpack_demo(const std::string& path, const ui::Progress& progress) {
    const std::string file = asset_path(demo_asset), packed = read_packed(file);
    require_delivered(file, packed);
    return unpack_bytes_of(packed, path, progress);
}

bool unpack_demo_file(const std::string& packed, const std::string& path, const ui::Progress& progress) {
    return unpack_bytes_of(read_packed(packed), path, progress);
}

}  // namespace fulcrum::app
