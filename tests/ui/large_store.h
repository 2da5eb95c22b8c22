// SPDX-License-Identifier: GPL-3.0-or-later
// The store of a large programme, made once in a process: each test has a copy of it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/database/large_programme.h"
#include "tests/support/own_folder.h"
#include "tests/ui/fake_services.h"

namespace fulcrum::ui::window_test {

inline constexpr int large_store_people = 40, large_store_attempts_each = 18;

/// Opens it in place of what was open; the session of its director.
inline const database::Session& open_large_store(FakeServices& services) {
    static const fulcrum::test::OwnFolder folder;
    static const std::string made = (folder / "made.db").string();
    static const database::Session director = [] {
        const database::Store store = database::Store::create(made);
        database::Session session =
            database::test::make_large_programme(store, large_store_people, large_store_attempts_each, 2, 7)
                .director;
        store.connection().execute("PRAGMA wal_checkpoint(TRUNCATE)");  // one file, to be copied
        return session;
    }();
    services.close_store();
    const std::string path = services.store_path(false);
    for (const char* part : {"", "-wal", "-shm"}) std::filesystem::remove(path + part);
    EXPECT_TRUE(std::filesystem::copy_file(made, path));
    services.open_store(false);
    return director;
}

}  // namespace fulcrum::ui::window_test
