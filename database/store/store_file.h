// SPDX-License-Identifier: GPL-3.0-or-later
// The store's file: whether there is one, whether its making was finished, and how a new one gets its name.
//
// Only SQLite may hold a descriptor of a store's file. POSIX drops every lock that a process holds on a file
// when the process closes any descriptor of it: a second descriptor, opened for a look at the header, would
// take SQLite's locks away, and another program could then delete the log that this one is writing. So the
// header is read through the connection, and the file system is only asked for names and modes. Internal to
// this floor.
#pragma once

#include <string>

#include "database/rows/connection.h"

namespace fulcrum::database {

/// Throws StoreError missing, not_a_store (a folder, device or pipe), read_only. Opens nothing.
void require_readable_file(const std::string& path, bool read_only);
/// Throws StoreError missing if the connection's file is a store whose making was interrupted: it is empty,
/// or it has no station yet, and so nothing that anybody entered.
void require_finished(Connection& connection);
/// Same question about a file. False for a file that is missing or cannot be read.
bool is_unfinished(const std::string& path);
/// Throws StoreError bad_value: this is the address of a server.
[[noreturn]] void fail_as_not_a_file(const std::string& address);
/// Throws the StoreError that an error of the file system means.
[[noreturn]] void fail_file(const std::string& path, int error);

/// The making of a store: under a temporary name, which is exchanged for the final one when the store is
/// complete. One program at a time makes a store in a folder.
class NewStoreFile {
  public:
    /// Makes missing folders (0700) and an empty file (0600); removes what a killed program left: temporary
    /// files, and an unfinished store of that name. Throws StoreError exists, read_only, disk_full.
    explicit NewStoreFile(const std::string& path);
    /// Removes the temporary file unless commit() was called.
    ~NewStoreFile();
    NewStoreFile(const NewStoreFile&) = delete;
    NewStoreFile& operator=(const NewStoreFile&) = delete;
    const std::string& temporary_path() const noexcept { return temporary_; }
    /// The store has its name, and keeps it in a power cut. Every connection must be closed. Throws
    /// StoreError.
    void commit();

  private:
    std::string path_, temporary_;
    int folder_ = -1;  ///< its lock keeps other programs from making a store in the folder
    bool done_ = false;
};

}  // namespace fulcrum::database
