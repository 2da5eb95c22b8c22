// SPDX-License-Identifier: Apache-2.0
#include "sim_core/numerics/files.h"

#include <sys/stat.h>

#include <cerrno>
#include <system_error>

#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/output_file.h"

namespace fulcrum {
namespace {

InputError unwritable(const std::string& path, const std::system_error& error) {
    return InputError(
        path.empty() ? "''" : path, "",
        {QT_TRANSLATE_NOOP("errors", "cannot be written (%1)"), error.code().message()},
        QT_TRANSLATE_NOOP("errors", "name a regular file in a folder that can be written and has space"));
}

const char* kind_of(const struct stat& status) {
    return S_ISDIR(status.st_mode)    ? QT_TRANSLATE_NOOP("errors", "a folder")
           : S_ISFIFO(status.st_mode) ? QT_TRANSLATE_NOOP("errors", "a pipe")
           : S_ISSOCK(status.st_mode) ? QT_TRANSLATE_NOOP("errors", "a socket")
                                      : QT_TRANSLATE_NOOP("errors", "a device");
}

}  // namespace

void require_regular_file(const std::string& path) {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0)
        throw InputError(
            path, "",
            {QT_TRANSLATE_NOOP("errors", "cannot be read (%1)"), std::generic_category().message(errno)},
            QT_TRANSLATE_NOOP("errors", "check the path and the permission to read it"));
    if (!S_ISREG(status.st_mode))
        throw InputError(path, "",
                         {QT_TRANSLATE_NOOP("errors", "is %1, not a regular file"), kind_of(status)},
                         QT_TRANSLATE_NOOP("errors", "name a regular file"));
}

void require_writable_file(const std::string& path) {
    try {
        if (path.empty()) throw std::system_error(ENOENT, std::generic_category());
        const OutputFile file(path);
    } catch (const std::system_error& error) {
        throw unwritable(path, error);
    }
}

void write_whole_file(const std::string& path, const std::string& bytes, FileAccess access) {
    require_writable_file(path);
    try {
        write_output_file(
            path, bytes, OutputFile::Existing::replace,
            access == FileAccess::owner_only ? OutputFile::Access::owner_only : OutputFile::Access::as_usual);
    } catch (const std::system_error& error) {
        throw unwritable(path, error);
    }
}

}  // namespace fulcrum
