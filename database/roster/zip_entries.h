// SPDX-License-Identifier: GPL-3.0-or-later
// Chosen files of a ZIP archive, in memory: nothing is written to disk. Stored and deflated entries, which is
// what other systems write; bounded in size whatever the archive says of itself.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace fulcrum::database {

inline constexpr std::size_t largest_zip = std::size_t{64} << 20U;        // bytes of the archive
inline constexpr std::size_t largest_zip_entry = std::size_t{16} << 20U;  // bytes of a file in it, unpacked
inline constexpr std::size_t most_zip_entries = 1000;

/// Whether the file begins as a ZIP archive does. False where it cannot be read.
bool is_zip(const std::string& path);
/// The files of these names at the top of the archive, or of one folder at its top; those that are not there
/// are left out. Throws InputError with the file's name and a hint: cannot be read, too large, damaged, cut
/// off, encrypted, another compression, a file twice, more entries than most_zip_entries.
std::map<std::string, std::string> zip_entries(const std::string& path,
                                               const std::vector<std::string>& names);
/// The same of bytes. `file`: for messages.
std::map<std::string, std::string> parse_zip(const std::string& bytes, const std::string& file,
                                             const std::vector<std::string>& names);

}  // namespace fulcrum::database
