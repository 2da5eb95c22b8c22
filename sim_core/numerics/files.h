// SPDX-License-Identifier: Apache-2.0
// Files that users name. Reading: anything but a regular file is refused before it is opened, because opening
// a named pipe waits for a writer that may never come. Writing: output_file.h, with errors for users.
#pragma once

#include <string>

namespace fulcrum {

/// Throws InputError when `path` does not exist or is a folder, a pipe, a socket or a device.
void require_regular_file(const std::string& path);

enum class FileAccess { as_usual, owner_only };

/// write_output_file() for a file that the user named: throws InputError when it cannot be written.
void write_whole_file(const std::string& path, const std::string& bytes,
                      FileAccess access = FileAccess::as_usual);

/// Throws InputError where write_whole_file(path) would, as far as that can be known before; called before
/// long work.
void require_writable_file(const std::string& path);

}  // namespace fulcrum
