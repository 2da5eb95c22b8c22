// SPDX-License-Identifier: Apache-2.0
#include "sim_core/numerics/output_file.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <random>

#include "tests/support/own_folder.h"

namespace fulcrum::test {
namespace {

namespace files = std::filesystem;

std::string content_of(const files::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::size_t entries_of(const files::path& folder) {
    return static_cast<std::size_t>(
        std::distance(files::directory_iterator(folder), files::directory_iterator()));
}

int error_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::system_error& error) {
        return error.code().value();
    }
    return 0;
}

TEST(OutputFile, HasItsNameOnlyAfterCommit) {
    const OwnFolder folder;
    const std::string path = folder / "page.md";
    {
        OutputFile file(path);
        file.write("half");
        EXPECT_FALSE(files::exists(path));
    }
    EXPECT_EQ(entries_of(folder.path()), 0U) << "an abandoned output leaves nothing";
    write_output_file(path, "whole");
    EXPECT_EQ(content_of(path), "whole");
    EXPECT_EQ(entries_of(folder.path()), 1U);
}

TEST(OutputFile, KeepsAnExistingFileUnlessItMayReplaceIt) {
    const OwnFolder folder;
    const std::string path = folder / "set.json";
    write_output_file(path, "first", OutputFile::Existing::keep);
    EXPECT_EQ(error_of([&] { write_output_file(path, "second", OutputFile::Existing::keep); }), EEXIST);
    EXPECT_EQ(content_of(path), "first");
    OutputFile late(folder / "late.json", OutputFile::Existing::keep);
    late.write("late");
    write_output_file(folder / "late.json", "early");
    EXPECT_EQ(error_of([&] { late.commit(); }), EEXIST) << "the name was taken in between";
    EXPECT_EQ(content_of(folder / "late.json"), "early");
    write_output_file(path, "second");
    EXPECT_EQ(content_of(path), "second");
}

TEST(OutputFile, ReplacesALinkAndNotTheFileThatItPointsTo) {
    const OwnFolder folder;
    write_output_file(folder / "precious.txt", "precious");
    files::create_symlink(folder / "precious.txt", folder / "page.md");
    write_output_file(folder / "page.md", "page");
    EXPECT_EQ(content_of(folder / "precious.txt"), "precious");
    EXPECT_EQ(content_of(folder / "page.md"), "page");
}

TEST(OutputFile, RefusesFoldersPipesAndMissingFolders) {
    const OwnFolder folder;
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_EQ(error_of([&] { OutputFile file(folder / "pipe"); }), EEXIST);
    EXPECT_EQ(error_of([&] { OutputFile file(folder.path()); }), EEXIST);
    EXPECT_EQ(error_of([&] { OutputFile file(folder / "none" / "file"); }), ENOENT);
}

TEST(OutputFile, KilledWriterLeavesTheOldFileOrTheNewOneNeverAPart) {
    const OwnFolder folder;
    const std::string path = folder / "table.csv";
    constexpr std::size_t size = 4U << 20U;
    constexpr int kills = 30;
    std::mt19937 random(20261122);
    for (int kill = 0; kill < kills; ++kill) {
        const pid_t child = ::fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            for (char letter = 'a';; letter = letter == 'z' ? 'a' : static_cast<char>(letter + 1))
                write_output_file(path, std::string(size, letter));
        }
        ::usleep(static_cast<useconds_t>(random() % 40000));
        ::kill(child, SIGKILL);
        int status = 0;
        ASSERT_EQ(::waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status));
        if (!files::exists(path)) continue;
        const std::string content = content_of(path);
        ASSERT_EQ(content.size(), size);
        ASSERT_EQ(content.find_first_not_of(content.front()), std::string::npos);
    }
    write_output_file(path, "last");
    EXPECT_EQ(entries_of(folder.path()), 1U) << "what killed writers left is removed by the next one";
}

TEST(OutputFile, RenameWithoutReplacingSaysWhetherTheNameWasFree) {
    const OwnFolder folder;
    write_output_file(folder / "a", "a");
    write_output_file(folder / "b", "b");
    EXPECT_FALSE(rename_without_replacing(folder / "a", folder / "b"));
    EXPECT_EQ(content_of(folder / "b"), "b");
    EXPECT_TRUE(rename_without_replacing(folder / "a", folder / "c"));
    EXPECT_EQ(content_of(folder / "c"), "a");
    EXPECT_FALSE(files::exists(folder / "a"));
}

}  // namespace
}  // namespace fulcrum::test
