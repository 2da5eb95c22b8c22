// SPDX-License-Identifier: Apache-2.0
#include "sim_core/numerics/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

namespace fs = std::filesystem;

class Files : public ::testing::Test {
  protected:
    Files() {
        std::string pattern = (fs::temp_directory_path() / "files-XXXXXX").string();
        folder = mkdtemp(pattern.data());
    }
    ~Files() override { fs::remove_all(folder); }
    static std::string read(const fs::path& path) {
        std::stringstream text;
        text << std::ifstream(path).rdbuf();
        return text.str();
    }
    static void write(const fs::path& path, const std::string& text) { std::ofstream(path) << text; }
    std::size_t entries() const {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
    }
    fs::path folder;
};

TEST_F(Files, OnlyRegularFilesAreRead) {
    write(folder / "file", "text");
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    fs::create_symlink(folder / "file", folder / "link");
    EXPECT_NO_THROW(require_regular_file((folder / "file").string()));
    EXPECT_NO_THROW(require_regular_file((folder / "link").string()));
    for (const fs::path& path : {folder / "pipe", folder, folder / "none", fs::path("/dev/null")})
        EXPECT_THROW(require_regular_file(path.string()), InputError) << path;
}

TEST_F(Files, ALinkIsReplacedAndItsTargetKept) {
    write(folder / "target", "precious");
    fs::create_symlink(folder / "target", folder / "page.md");
    write_whole_file((folder / "page.md").string(), "page");
    EXPECT_EQ(read(folder / "target"), "precious");
    EXPECT_FALSE(fs::is_symlink(folder / "page.md"));
    EXPECT_EQ(read(folder / "page.md"), "page");
    EXPECT_EQ(entries(), 2U) << "no temporary file may remain";
}

TEST_F(Files, AnOldFileStaysWhereTheNewOneCannotBeWritten) {
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    fs::create_directory(folder / "folder");
    for (const fs::path& path :
         {folder / "pipe", folder / "folder", fs::path("/dev/full"), folder / "none" / "file", fs::path()}) {
        EXPECT_THROW(write_whole_file(path.string(), "text"), InputError) << path;
        EXPECT_THROW(require_writable_file(path.string()), InputError) << path;
    }
    EXPECT_EQ(entries(), 2U);
    write(folder / "file", "old");
    EXPECT_NO_THROW(require_writable_file((folder / "file").string()));
    EXPECT_EQ(read(folder / "file"), "old");
    EXPECT_NO_THROW(require_writable_file((folder / "new").string()));
    EXPECT_FALSE(fs::exists(folder / "new"));
}

}  // namespace
}  // namespace fulcrum
