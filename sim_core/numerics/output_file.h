// SPDX-License-Identifier: Apache-2.0
// Writes a file so that its name never holds an empty or partial file: the content goes to a temporary file
// in the same folder, which is written through to the disk and then renamed. A program that is killed leaves
// at most the temporary file; the next writer of the same file removes it.
#pragma once

#include <string>
#include <string_view>
#include <system_error>

namespace fulcrum {

class OutputFile {
  public:
    enum class Existing {
        keep,     ///< an existing file of that name is an error (EEXIST)
        replace,  ///< it is replaced, a link included (the file that the link points to is left alone)
    };
    enum class Access { as_usual, owner_only };

    /// Makes the temporary file, so that a folder that cannot be written is found before the work is done.
    /// Throws std::system_error: EEXIST, also for a folder, device or pipe of that name; EACCES, ENOENT, ...
    explicit OutputFile(std::string path, Existing existing = Existing::replace,
                        Access access = Access::as_usual);
    /// Removes the temporary file unless commit() was called.
    ~OutputFile();
    OutputFile(const OutputFile&) = delete;
    OutputFile& operator=(const OutputFile&) = delete;

    const std::string& path() const noexcept { return path_; }
    /// For writers that open a file by its name: an existing, empty file. They must have closed it before
    /// commit().
    const std::string& temporary_path() const noexcept { return temporary_; }
    /// Appends. Throws std::system_error (ENOSPC, ...).
    void write(std::string_view bytes);
    /// The file has its name and will keep its content in a power cut. Throws std::system_error; nothing has
    /// changed under the final name then.
    void commit();

  private:
    std::string path_, temporary_;
    Existing existing_;
    int descriptor_ = -1;
};

/// One call for content that is in memory. Throws std::system_error.
void write_output_file(const std::string& path, std::string_view content,
                       OutputFile::Existing existing = OutputFile::Existing::replace,
                       OutputFile::Access access = OutputFile::Access::as_usual);

/// Renames within one folder and makes it last. False if `to` exists, which is left alone. Throws
/// std::system_error.
bool rename_without_replacing(const std::string& from, const std::string& to);
/// As above, replacing `to`. Throws std::system_error.
void rename_replacing(const std::string& from, const std::string& to);

}  // namespace fulcrum
