// SPDX-License-Identifier: GPL-3.0-or-later
// The files of benchmark sets in the assets folder: which version is in force, and what is kept of one that
// is replaced.
#pragma once

#include <optional>
#include <string>

namespace fulcrum {

/// The `version` of a benchmark set or a curriculum, also of one that this program no longer reads (other
/// versions of metrics); 0: it has none. Throws InputError where the text is not JSON.
int version_in_text(const std::string& text, const std::string& file);
/// 0 also where there is no such file. Throws InputError.
int version_in_file(const std::string& path);

/// A copy of the set that is replaced, in the folder "superseded" next to it, so that what attempts were held
/// against can be looked up. Version 0: there is none. Throws std::system_error, InputError.
void keep_superseded(const std::string& path, int version);
/// What such a copy of the set at `path`, with this SHA-256, says of being provisional; empty: there is none.
std::optional<bool> superseded_is_provisional(const std::string& path, const std::string& sha256);

}  // namespace fulcrum
