// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the owner of a store is a service account that nobody practises with.
#include "database/store/store_owner.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/database/programme_fixture.h"

namespace fulcrum::database::test {
namespace {

constexpr StoreOwner service{120, 120, 0100600, 0040700};

TEST(StoreOwner, IsAServiceAccountOnlyWhereNobodyElseMayWrite) {
    EXPECT_TRUE(is_service_account(service));
    StoreOwner owner = service;
    owner.folder = 0;
    EXPECT_TRUE(is_service_account(owner)) << "a folder of the superuser";
    for (const uid_t person : {1000U, 1001U, 65534U}) {
        owner = service;
        owner.file = owner.folder = person;
        EXPECT_FALSE(is_service_account(owner)) << person;
    }
    owner = service;
    owner.file = owner.folder = 0;
    EXPECT_FALSE(is_service_account(owner)) << "whoever runs the window as superuser can do all";
    owner = service;
    owner.folder = 1000;
    EXPECT_FALSE(is_service_account(owner)) << "its owner can put another file there";
    for (const mode_t mode : {0100660U, 0100602U}) {
        owner = service;
        owner.file_mode = mode;
        EXPECT_FALSE(is_service_account(owner));
    }
    owner = service;
    owner.folder_mode = 0040770;
    EXPECT_FALSE(is_service_account(owner));
}

TEST(StoreOwner, IsLookedUpWhereTheStoreIs) {
    const Programme programme;
    EXPECT_FALSE(owned_by_service_account(*programme.store)) << "of the account that runs the tests";
    if (::geteuid() != 0) GTEST_SKIP() << "only the superuser gives files away";
    const std::string folder = programme.folder.path().toStdString();
    ASSERT_EQ(::chmod(folder.c_str(), 0700), 0);
    ASSERT_EQ(::chmod(programme.path.c_str(), 0600), 0);
    ASSERT_EQ(::chown(folder.c_str(), 120, 120), 0);
    EXPECT_FALSE(owned_by_service_account(*programme.store)) << "the file is still another's";
    ASSERT_EQ(::chown(programme.path.c_str(), 120, 120), 0);
    EXPECT_TRUE(owned_by_service_account(*programme.store));
}

}  // namespace
}  // namespace fulcrum::database::test
