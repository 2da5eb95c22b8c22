// SPDX-License-Identifier: GPL-3.0-or-later
// The file of key frames: what is read is what was written, or nothing; nothing that happens to the file or
// its folder is an error.
#include "app/live/frame_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <random>

#include "sim_core/numerics/state_archive.h"
#include "tests/support/own_folder.h"

namespace fulcrum::app {
namespace {

namespace files = std::filesystem;

std::vector<PackedFrame> some_frames(int count, std::size_t bytes, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::vector<PackedFrame> frames;
    for (int i = 0; i < count; ++i) {
        std::vector<std::uint8_t> packed(bytes + random() % 8);
        for (std::uint8_t& byte : packed) byte = static_cast<std::uint8_t>(random());
        frames.push_back({static_cast<std::uint32_t>(100 * i),
                          std::make_shared<const std::vector<std::uint8_t>>(std::move(packed))});
    }
    return frames;
}

class FrameFiles : public ::testing::Test {
  protected:
    FrameFiles() : keeping{(folder / "a.db.frames").string(), "one.frames", frames_belong_to("record")} {}
    files::path file(const std::string& name = "one.frames") const {
        return files::path(keeping.folder) / name;
    }
    void keep(const FrameKeeping& where, const std::vector<PackedFrame>& frames) const {
        FrameFileWriter writer(where, frames, last);
        while (writer.write_more()) {
        }
    }
    FrameKeeping named(const std::string& name) const {
        FrameKeeping other = keeping;
        other.name = name;
        return other;
    }
    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : files::directory_iterator(keeping.folder))
            found.push_back(entry.path().filename().string());
        std::sort(found.begin(), found.end());
        return found;
    }
    std::string bytes() const {
        std::ifstream in(file(), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void put(const std::string& bytes) const { std::ofstream(file(), std::ios::binary) << bytes; }
    /// The file gives no frame that was not written.
    void expect_nothing_wrong(const std::vector<PackedFrame>& frames, const std::string& what) const {
        const auto opened = FrameFile::open(keeping);
        if (opened == nullptr) {
            EXPECT_FALSE(files::exists(file())) << what;
            return;
        }
        bool refused = false;
        for (std::size_t i = 0; i < opened->count(); ++i) {
            try {
                EXPECT_EQ(opened->packed(i), *frames.at(i).packed) << what;
            } catch (const StateArchiveError&) {
                refused = true;
            }
        }
        EXPECT_TRUE(refused) << what;
    }

    const test::OwnFolder folder;
    FrameKeeping keeping;
    static constexpr std::uint32_t last = 5000;
};

TEST_F(FrameFiles, GiveBackWhatWasWrittenToTheirOwnRecordAlone) {
    const std::vector<PackedFrame> frames = some_frames(40, 300'000);  // several pieces
    keep(keeping, frames);
    const auto opened = FrameFile::open(keeping);
    ASSERT_NE(opened, nullptr);
    ASSERT_EQ(opened->count(), frames.size());
    EXPECT_EQ(opened->last_tick(), last);
    EXPECT_EQ(opened->bytes(), files::file_size(file()));
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(opened->tick(i), frames[i].tick);
        EXPECT_EQ(opened->packed(i), *frames[i].packed);
    }
    EXPECT_EQ(names(), std::vector<std::string>{"one.frames"});
    EXPECT_EQ(files::status(file()).permissions(), files::perms(0600));
    EXPECT_EQ(files::status(keeping.folder).permissions(), files::perms(0700));

    FrameKeeping changed = keeping;
    changed.belongs = frames_belong_to("another record");
    EXPECT_EQ(FrameFile::open(changed), nullptr);
    EXPECT_TRUE(names().empty()) << "frames of another record are removed";
    EXPECT_EQ(opened->packed(7), *frames[7].packed) << "who has it open keeps it";
    EXPECT_EQ(FrameFile::open(keeping), nullptr);
}

TEST_F(FrameFiles, CutOffOrAlteredTheyAreRemovedOrRefuseTheFrame) {
    const std::vector<PackedFrame> frames = some_frames(3, 40);
    keep(keeping, frames);
    const std::string good = bytes();
    for (std::size_t cut = 0; cut < good.size(); ++cut) {
        put(good.substr(0, cut));
        EXPECT_EQ(FrameFile::open(keeping), nullptr) << cut;
        EXPECT_FALSE(files::exists(file())) << cut;
    }
    for (std::size_t i = 0; i < good.size(); ++i) {
        std::string bad = good;
        bad[i] = static_cast<char>(bad[i] ^ (1 << (i % 8)));
        put(bad);
        expect_nothing_wrong(frames, "byte " + std::to_string(i));
    }
    put(good + '\0');
    EXPECT_EQ(FrameFile::open(keeping), nullptr) << "longer";
    // A number of frames for which there is no memory.
    std::string many = good;
    for (std::size_t i = 8; i < 12; ++i) many[i] = '\xff';
    put(many);
    EXPECT_EQ(FrameFile::open(keeping), nullptr);
    put(good);
    const auto opened = FrameFile::open(keeping);
    ASSERT_NE(opened, nullptr);
    ::truncate(file().c_str(), static_cast<off_t>(good.size() - 5));  // while it is open
    EXPECT_THROW(opened->packed(2), StateArchiveError);
}

TEST_F(FrameFiles, LinksPipesAndFoldersAreNotFollowed) {
    const std::vector<PackedFrame> frames = some_frames(3, 40);
    keep(keeping, frames);
    const files::path elsewhere = folder / "elsewhere";
    files::rename(file(), elsewhere);
    files::create_symlink(elsewhere, file());
    EXPECT_EQ(FrameFile::open(keeping), nullptr);
    EXPECT_TRUE(names().empty());
    EXPECT_TRUE(files::exists(elsewhere));
    ASSERT_EQ(::mkfifo(file().c_str(), 0600), 0);
    EXPECT_EQ(FrameFile::open(keeping), nullptr) << "and nobody waits for a writer";
    files::create_directory(file());
    EXPECT_EQ(FrameFile::open(keeping), nullptr);
    keep(keeping, frames);  // cannot take the folder's name
    EXPECT_EQ(names(), std::vector<std::string>{"one.frames"}) << "nothing unfinished is left";
    files::remove(file());
    // A folder that others can write.
    keep(keeping, frames);
    files::permissions(keeping.folder, files::perms(0770));
    EXPECT_EQ(FrameFile::open(keeping), nullptr);
    keep(named("two.frames"), frames);
    EXPECT_EQ(names(), std::vector<std::string>{"one.frames"});
    files::rename(keeping.folder, folder / "moved");
    files::permissions(folder / "moved", files::perms(0700));
    files::create_directory_symlink(folder / "moved", keeping.folder);
    EXPECT_EQ(FrameFile::open(keeping), nullptr) << "a linked folder";
}

TEST_F(FrameFiles, StayWithinTheBoundAndThoseOpenedLongestAgoGo) {
    const std::vector<PackedFrame> frames = some_frames(3, 1000);
    for (const char* name : {"a.frames", "b.frames", "c.frames"}) keep(named(name), frames);
    keeping.most_bytes = 4 * files::file_size(file("a.frames")) - 1;  // room for three
    // Opening makes `a` the newest; the times of files may be coarse.
    for (const char* name : {"b.frames", "c.frames"})
        files::last_write_time(file(name), files::file_time_type::clock::now() - std::chrono::hours(2));
    ASSERT_NE(FrameFile::open(named("a.frames")), nullptr);
    files::last_write_time(file("c.frames"), files::file_time_type::clock::now() - std::chrono::hours(1));
    std::ofstream(file("d.frames.new-1-1")) << "of a program that was killed";
    files::last_write_time(file("d.frames.new-1-1"),
                           files::file_time_type::clock::now() - std::chrono::hours(2));
    keep(keeping, frames);
    EXPECT_EQ(names(), (std::vector<std::string>{"a.frames", "c.frames", "one.frames"}));
    keep(keeping, frames);  // replaces itself
    EXPECT_EQ(names(), (std::vector<std::string>{"a.frames", "c.frames", "one.frames"}));
    keeping.most_bytes = 2000;
    keep(named("two.frames"), frames);
    EXPECT_EQ(names().size(), 3U) << "one that is larger than the bound drives no other out";
}

TEST_F(FrameFiles, AFullDiskAReadOnlyFolderAndAnEarlyEndLeaveNothing) {
    const std::vector<PackedFrame> frames = some_frames(40, 300'000);
    {
        FrameFileWriter writer(keeping, frames, last);
        EXPECT_TRUE(writer.write_more());
        EXPECT_TRUE(writer.write_more());
        EXPECT_EQ(names().size(), 1U);
        EXPECT_EQ(FrameFile::open(keeping), nullptr) << "it has no name yet";
    }
    EXPECT_TRUE(names().empty()) << "the replay was closed";

    const auto before = std::signal(SIGXFSZ, SIG_IGN);
    rlimit usual = {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &usual), 0);
    rlimit small = usual;
    small.rlim_cur = 6'000'000;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    keep(keeping, frames);
    ::setrlimit(RLIMIT_FSIZE, &usual);
    std::signal(SIGXFSZ, before);
    EXPECT_TRUE(names().empty()) << "no room";

    keep({(folder / "missing" / "a.db.frames").string(), "one.frames", keeping.belongs}, frames);
    EXPECT_FALSE(files::exists(folder / "missing"));
    keep({}, frames);
    EXPECT_EQ(FrameFile::open({}), nullptr);
    if (::geteuid() == 0) return;  // may write everywhere
    files::permissions(keeping.folder, files::perms(0500));
    keep(keeping, frames);
    EXPECT_TRUE(names().empty());
    files::permissions(keeping.folder, files::perms(0700));
}

TEST_F(FrameFiles, OfTwoThatWriteAtOnceOneIsThereAndWhole) {
    const std::vector<PackedFrame> frames = some_frames(40, 300'000), others = some_frames(40, 300'000, 2);
    FrameFileWriter one(keeping, frames, last), other(keeping, others, last);
    bool more = true;
    while (more) {
        const bool first = one.write_more(), second = other.write_more();
        more = first || second;
    }
    EXPECT_EQ(names(), std::vector<std::string>{"one.frames"});
    const auto opened = FrameFile::open(keeping);
    ASSERT_NE(opened, nullptr);
    const bool is_first = opened->packed(0) == *frames[0].packed;
    for (std::size_t i = 0; i < opened->count(); ++i)
        EXPECT_EQ(opened->packed(i), is_first ? *frames[i].packed : *others[i].packed);
}

}  // namespace
}  // namespace fulcrum::app
