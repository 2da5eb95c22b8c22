// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/records/curriculum_publishing.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <set>

#include "database/rows/connection.h"
#include "database/rows/crypto.h"
#include "database/store/accepted_assets.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum::database {
namespace {

[[noreturn]] void published_already(const std::string& name) {
    throw StoreError(
        StoreErrorKind::conflict,
        {QT_TRANSLATE_NOOP("errors", "another version was published in the meantime: %1"), name},
        QT_TRANSLATE_NOOP("errors", "look at the draft with the changes of both, then publish it again"));
}

/// Its name in the folder, which says the version.
std::string file_of(const Curriculum& next) {
    return next.id + "-" + std::to_string(next.version) + ".json";
}

/// The version that an accepted text is of this curriculum; 0: it is none. By its name where this program
/// cannot read it.
int version_of(const AcceptedText& one, const std::string& id) {
    try {
        const Curriculum said = parse_draft(one.text, one.file.name);
        return said.id == id ? said.version : 0;
    } catch (const InputError&) {
        const std::string start = "curricula/" + id + "-";
        if (one.file.name.rfind(start, 0) != 0) return 0;
        const std::string rest = one.file.name.substr(start.size());
        const std::size_t digits = std::min(rest.find_first_not_of("0123456789"), rest.size());
        return digits > 0 && digits <= 7 && rest.substr(digits) == ".json" ? std::stoi(rest.substr(0, digits))
                                                                           : 0;
    }
}

/// Another text with this number, of another window or of a station whose contents have come with an
/// exchange: of two with one number the other stations would put the older one in force. `asset`: ours.
void require_free_number(const AcceptedAssets& accepted, const Curriculum& newest, const Curriculum& next,
                         const AssetFile& asset) {
    std::set<std::string> known = {asset.digest, sha256_hex(newest.text)};
    for (const Curriculum& one : newest.older) known.insert(sha256_hex(one.text));
    for (const AcceptedText& one : accepted.texts())
        if (known.count(one.file.digest) == 0 && version_of(one, next.id) >= next.version)
            throw StoreError(
                StoreErrorKind::conflict,
                {QT_TRANSLATE_NOOP("errors", "%1 was published before, and is not in force here yet"),
                 one.file.name},
                QT_TRANSLATE_NOOP("errors",
                                  "look at the draft again; where this is repeated, `fulcrum assets place` "
                                  "says what is in the way"));
}

}  // namespace

std::string publish_curriculum(const Store& store, const Session& educator, const CurriculumPublishing& place,
                               const Curriculum& follows, const std::string& text,
                               const std::string& reason) {
    store.require(educator, Operation::accept_assets);
    if (reason.find_first_not_of(" \t\r\n") == std::string::npos)
        throw StoreError(StoreErrorKind::bad_value,
                         QT_TRANSLATE_NOOP("errors", "a reason is missing or too long"),
                         QT_TRANSLATE_NOOP("errors", "give a reason of 1 to 4,000 characters"));
    std::vector<std::string> tasks;
    for (const InstalledTask& task : place.tasks) tasks.push_back(task.id);
    const Curriculum next = parse_curriculum(text, follows.id, tasks);
    check_rules(next);
    check_ratings(next, place.forms);
    check_remedies(next, place.tasks);
    const Curriculum newest = load_versions(place.folder, follows.id, tasks);
    // By its contents too: an update of the program brings a version after which a site's number is the same.
    if (newest.name() != follows.name() || newest.text != follows.text || next.id != follows.id ||
        next.version != newest.next_own_version())
        published_already(newest.name());
    const std::string path = (std::filesystem::path(place.folder) / file_of(next)).string();
    try {
        // The file first, under another name: a folder that cannot be written is found before anything else.
        OutputFile file(path, OutputFile::Existing::keep);
        file.write(text);
        const AssetFile asset{"curricula/" + file_of(next), sha256_hex(text)};
        const AcceptedAssets accepted(store);
        Transaction transaction(store.connection());
        require_free_number(accepted, newest, next, asset);
        // Already so where an earlier try was cut off after it: without the file it had no effect.
        if (accepted.is_to_accept(asset)) accepted.accept(educator, asset, reason, text);
        transaction.commit();
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
