// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/curriculum_publishing.h"

#include <cerrno>
#include <filesystem>

#include "database/rows/crypto.h"
#include "database/store/accepted_assets.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::database {
namespace {

[[noreturn]] void published_already(const std::string& name) {
    throw StoreError(
        StoreErrorKind::conflict,
        {QT_TRANSLATE_NOOP("errors", "another version was published in the meantime: %1"), name},
        QT_TRANSLATE_NOOP("errors", "save your draft, start the program again and open the draft"));
}

/// Its name in the folder, which tells the version.
std::string file_of(const Curriculum& next) {
    return next.id + "-" + std::to_string(next.version) + ".json";
}

}  // namespace

std::string publish_curriculum(const Store& store, const Session& educator, const CurriculumPublishing& place,
                               const std::string& id, const std::string& text, const std::string& reason) {
    store.require(educator, Operation::accept_assets);
    if (reason.find_first_not_of(" \t\r\n") == std::string::npos)
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "a reason is missing or too long"),
                         QT_TRANSLATE_NOOP("errors", "give a reason of 1 to 4,000 characters"));
    std::vector<std::string> tasks;
    for (const InstalledTask& task : place.tasks) tasks.push_back(task.id);
    const Curriculum next = parse_curriculum(text, id, tasks);
    check_ratings(next, place.forms);
    check_remedies(next, place.tasks);
    const Curriculum newest = load_versions(place.folder, id, tasks);
    if (next.id != id || next.version != newest.next_own_version()) published_already(newest.name());
    const std::string path = (std::filesystem::path(place.folder) / file_of(next)).string();
    try {
        // The file first, under another name: a folder that cannot be written is found before anything else.
        OutputFile file(path, OutputFile::Existing::keep);
        file.write(text);
        const AssetFile asset{"curricula/" + file_of(next), sha256_hex(text)};
        const AcceptedAssets accepted(store);
        // Already so where an earlier try was cut off after it: without the file it had no effect.
        if (accepted.is_to_accept(asset)) accepted.accept(educator, asset, reason, text);
        file.commit();
    } catch (const std::system_error& error) {
        if (error.code().value() == EEXIST) published_already(file_of(next));
        throw StoreError(
            error.code().value() == ENOSPC ? StoreErrorKind::disk_full : StoreErrorKind::read_only,
            {QT_TRANSLATE_NOOP("errors", "%1: cannot be written (%2)"), path, error.code().message()},
            QT_TRANSLATE_NOOP(
                "errors",
                "save the draft; the administrator puts the file there, and an educator accepts "
                "it with `fulcrum assets accept`"));
    }
    return path;
}

}  // namespace fulcrum::database
